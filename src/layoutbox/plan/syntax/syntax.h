// Parts of speech and clause structure of English sentences: a tagger and a dependency parser of our own (docs/syntax.md).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace layoutbox::syntax {

// The tags of the Penn Treebank; signs of punctuation are one.
enum class Tag : std::uint8_t {
  kCC,    // and, or, but
  kCD,    // two, 4
  kDT,    // a, the, this, each
  kEX,    // there, in "there is"
  kFW,    // foreign
  kIN,    // in, on, with; that, if
  kJJ,    // large
  kJJR,   // larger
  kJJS,   // largest
  kMD,    // can, should
  kNN,    // bed
  kNNP,   // names
  kNNPS,  // names, plural
  kNNS,   // beds
  kPDT,   // all (the), both (the), half (a)
  kPOS,   // 's
  kPRP,   // it, they
  kPRPS,  // its, my
  kRB,    // directly, next (to), not
  kRBR,   // closer
  kRBS,   // most
  kRP,    // up, in "lined up"
  kSYM,   // x, in "4 x 5"
  kTO,    // to, before a verb
  kUH,    // please, yes
  kVB,    // (to) place, place! (the imperative too)
  kVBD,   // placed the lamp
  kVBG,   // facing
  kVBN,   // (was, a lamp) placed
  kVBP,   // (they) stand
  kVBZ,   // (it) stands
  kWDT,   // which, that
  kWP,    // who, what
  kWPS,   // whose
  kWRB,   // where, how
  kPunct,
};
inline constexpr int kTags = 36;

// Labels of the CLEAR scheme, from the head to the word that hangs on it.
enum class Arc : std::uint8_t {
  kRoot,
  kAcl,        // a shelf → holding books, a lamp → placed on it
  kAcomp,      // is → large
  kAdvcl,      // sits → facing the door
  kAdvmod,     // sits → next (to …)
  kAgent,      // flanked → by
  kAmod,       // bed → large
  kAppos,      // name → its explanation
  kAttr,       // is → a bed (also what "there is" says)
  kAux,        // standing → is, place → should
  kAuxpass,    // placed → is
  kCase,       // bed → 's
  kCc,         // first member → and
  kCcomp,      // want → that …
  kCompound,   // lamp → floor
  kConj,       // member → next member
  kCsubj,      // a clause as subject
  kCsubjpass,  // the same in the passive
  kDative,     // give → me
  kDep,        // what fits nothing else
  kDet,        // bed → the
  kDobj,       // faces → the window
  kExpl,       // is → there
  kIntj,       // please
  kMark,       // clause → if, so that
  kMeta,
  kNeg,        // is → not
  kNmod,       // noun → what stands loosely before it
  kNpadvmod,   // wide → meters
  kNsubj,      // stands → the bed
  kNsubjpass,  // placed → the bed
  kNummod,     // chairs → four
  kOprd,       // leaves → the door open
  kParataxis,  // clause → a remark in it
  kPcomp,      // preposition → clause
  kPobj,       // preposition → noun
  kPoss,       // foot → the bed('s), its
  kPreconj,    // both (… and …)
  kPredet,     // all (the chairs)
  kPrep,       // what it belongs to → preposition
  kPrt,        // lined → up
  kPunct,      //
  kQuantmod,   // four → at least
  kRelcl,      // desk → that faces the door
  kXcomp,      // want → to have
};
inline constexpr int kArcs = 45;

struct TreeNode {
  Tag tag = Tag::kNN;
  Arc arc = Arc::kDep;
  int head = -1;     // place in the sentence, -1: none
  float margin = 0;  // how sure the head is: the least gap between the chosen step and the next best on the way; 0 is a toss-up, 1 usual
};

// The tree of one sentence: words as the planner's tokens have them (case does not matter), signs as words of their own. Several words may
// have no head (a list of fragments). Heads make no circle and no arcs cross. Time is linear; any bytes will do.
std::vector<TreeNode> parse(std::span<const std::string_view> words);

// "NN", "PRP$", "nsubj" … as the treebanks write them.
std::string_view name(Tag tag);
std::string_view name(Arc arc);

}  // namespace layoutbox::syntax
