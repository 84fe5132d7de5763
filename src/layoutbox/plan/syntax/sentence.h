// A sentence as the tagger and the parser see it, and the parser's state.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "layoutbox/plan/syntax/syntax.h"
#include "layoutbox/plan/syntax/weights.h"

namespace layoutbox::syntax {

// What is known of a word, packed as scripts/train_syntax.sh writes it: bits 0–3 can be noun, verb, adjective, adverb; 4–5 which of them
// mostly; 6–10 the noun's sense (WordNet's files: artifact, person, …), 11–14 the verb's; 15–24 a class of words used alike (upper six
// bits: a coarser class).
struct WordInfo {
  std::uint32_t bits = 0;
  std::uint32_t parts() const { return bits & 0x3f; }
  std::uint32_t noun_sense() const { return bits >> 6 & 0x1f; }
  std::uint32_t verb_sense() const { return bits >> 11 & 0xf; }
  std::uint32_t group() const { return bits >> 15 & 0x3ff; }
  std::uint32_t coarse_group() const { return bits >> 19 & 0x3f; }
};

struct Word {
  std::uint64_t key = 0;  // its letters
  std::uint64_t suffix2 = 0, suffix3 = 0, suffix4 = 0, prefix = 0;
  std::uint32_t shape = 0;  // letters, digits, a sign; how long
  WordInfo info;
};

Word read_word(std::string_view text, const Weights& weights);

// What is before the first word, after the last, and nothing at all (no child, nothing on the stack).
inline constexpr std::uint64_t kBefore = 11, kAfter = 12, kNothing = 13;

struct TaggedSentence {
  std::vector<Word> words;
  std::vector<std::uint8_t> tags;
  std::vector<int> likely_verbs;  // how many words before each place (and the end) are mostly verbs, in a finite form
  // For each place (and the end): the next place from there on with a noun, with a finite verb, with a comma or "and"; the number of words
  // if none.
  std::vector<int> next_noun, next_verb, next_break;
  std::vector<int> after_noun;  // the first place after the next noun that is none itself

  int size() const { return static_cast<int>(words.size()); }
};

TaggedSentence read_sentence(std::span<const std::string_view> words, const Weights& weights);

// Fills next_noun … from the tags.
void look_ahead(TaggedSentence& sentence);

bool is_noun(std::uint8_t tag);
bool is_finite(std::uint8_t tag);

// Steps of the arc-hybrid system. The end of the sentence stands for the root.
enum class ParserStep : std::uint8_t { kShift, kLeft, kRight };  // push the next word; the top hangs on the next word; on the one below it
inline constexpr int kSteps = 3;

class ParserState {
 public:
  explicit ParserState(int words);

  bool done() const { return next_ == size() && stack_.empty(); }
  bool allows(ParserStep step) const;
  // The word that the step gives a head, and that head; -1 each for a shift.
  int dependent(ParserStep step) const { return step == ParserStep::kShift ? -1 : top(0); }
  int head(ParserStep step) const { return step == ParserStep::kLeft ? next_ : step == ParserStep::kRight ? top(1) : -1; }
  void apply(ParserStep step, Arc arc);

  int size() const { return static_cast<int>(heads_.size()) - 1; }
  int next() const { return next_; }  // the number of words at the end
  int top(int depth) const {          // -1: nothing so deep
    return depth < static_cast<int>(stack_.size()) ? stack_[stack_.size() - 1 - static_cast<std::size_t>(depth)] : -1;
  }
  int depth() const { return static_cast<int>(stack_.size()); }
  bool on_stack(int word) const { return on_stack_[static_cast<std::size_t>(word)]; }
  int head_of(int word) const { return heads_[static_cast<std::size_t>(word)]; }
  Arc arc_of(int word) const { return arcs_[static_cast<std::size_t>(word)]; }

  struct Children {
    int outer = -1, inner = -1;  // the last and the last but one that came
    int count = 0;
    std::uint64_t labels = 0;  // bits
  };
  const Children& left(int word) const { return left_[static_cast<std::size_t>(word)]; }
  const Children& right(int word) const { return right_[static_cast<std::size_t>(word)]; }

 private:
  int next_ = 0;
  std::vector<int> stack_;
  std::vector<bool> on_stack_;
  std::vector<int> heads_;
  std::vector<Arc> arcs_;
  std::vector<Children> left_, right_;
};

}  // namespace layoutbox::syntax
