#include "layoutbox/plan/passes/side_subjects.h"

#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

class SideTurner {
 public:
  SideTurner(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : lexicon_(lexicon), document_(document), tokens_(document.tokens), skip_(skip) {}

  void run() {
    for (std::size_t i = 0; i + 4 < tokens_.size(); ++i) {
      if (i > 0 && !tokens_[i - 1].ends_sentence && !parts_clauses(i - 1) && tokens_[i - 1].text != "with") continue;
      if (!turn_of(i) && !leave_wall_out(i)) turn_possessive(i);
    }
  }

 private:
  static constexpr std::size_t kLongest = 5;  // tokens that name the thing

  bool is_determiner(std::size_t at) const {
    return at < tokens_.size() && (lexicon_.is(tokens_[at], WordClass::kDefinite) || lexicon_.is(tokens_[at], WordClass::kPossessive));
  }
  bool parts_clauses(std::size_t at) const { return tokens_[at].text == "," || lexicon_.is(tokens_[at], WordClass::kAnd); }

  // "long side", "head": how many words; 0: none.
  std::size_t side_at(std::size_t at) const {
    if (at + 1 >= tokens_.size()) return 0;
    if (one_of(tokens_[at].text, WordSet::kHeadEnds) || tokens_[at].text == "back") return 1;
    const bool which = one_of(tokens_[at].text, {"left", "right", "long", "longer", "short", "shorter"});
    return which && one_of(tokens_[at + 1].text, {"side", "end"}) ? 2 : 0;
  }

  bool leads_to_wall(std::size_t at) const {
    return at < tokens_.size() && one_of(tokens_[at].text, {"against", "to", "along", "at", "flush", "up", "pushed"});
  }

  // Where the sentence's "is" or "goes" stands that a place follows; 0: nowhere near.
  std::size_t verb_after(std::size_t at) const {
    for (std::size_t i = at; i < std::min(at + kLongest, tokens_.size() - 1); ++i) {
      if (tokens_[i].ends_sentence || tokens_[i].text == ",") return 0;
      if (!lexicon_.is(tokens_[i], WordClass::kBe) && !lexicon_.is(tokens_[i], WordClass::kPlaceVerb)) continue;
      return i > at && leads_to_wall(i + 1) ? i : 0;
    }
    return 0;
  }

  // "The long side of the bed is": the bed is long side.
  bool turn_of(std::size_t begin) {
    const std::size_t first = begin + (is_determiner(begin) ? 1 : 0), length = side_at(first), of = first + length;
    if (length == 0 || of + 2 >= tokens_.size() || tokens_[of].text != "of" || !is_determiner(of + 1)) return false;
    const std::size_t verb = verb_after(of + 2);
    if (verb == 0) return false;
    if (first > begin) skip_[begin] = true;
    skip_[of] = true;
    move_before(document_, skip_, begin, of + 1, verb + 1);
    return true;
  }

  bool is_on_wall(std::size_t at) const {
    return at + 3 < tokens_.size() && tokens_[at].text == "on" && tokens_[at + 1].text == "the" && tokens_[at + 2].text == "wall" &&
           !tokens_[at + 2].ends_sentence;
  }
  bool is_over(std::size_t at) const { return one_of(tokens_[at].text, {"above", "over"}); }

  // "…, above it on the wall a clock", "and on the wall above it hangs a print": above it; what hangs over things hangs on a wall.
  bool leave_wall_out(std::size_t begin) {
    if (begin == 0 || tokens_[begin - 1].ends_sentence) return false;
    std::size_t wall = begin;
    if (is_over(begin)) {
      for (++wall; wall <= begin + kLongest && wall < tokens_.size() && !is_on_wall(wall); ++wall) {
        if (tokens_[wall].kind != Token::Kind::kWord || tokens_[wall].ends_sentence) return false;
      }
    } else if (begin + 4 >= tokens_.size() || !is_over(begin + 3) || !one_of(tokens_[begin + 4].text, {"it", "them"})) {
      return false;
    }
    if (wall > begin + kLongest || !is_on_wall(wall)) return false;
    std::fill_n(skip_.begin() + static_cast<std::ptrdiff_t>(wall), 3, true);
    return true;
  }

  // "The bed's long side is", "its head is": the bed is long side, it is head. "With the bed's long side against": the bed long side.
  void turn_possessive(std::size_t begin) {
    const bool its = tokens_[begin].text == "its";
    std::size_t owned = begin;
    while (!its && owned < begin + kLongest && owned < tokens_.size() && tokens_[owned].text != "'s") ++owned;
    if (owned >= tokens_.size() || (!its && tokens_[owned].text != "'s")) return;
    const std::size_t length = side_at(owned + 1), side = owned + 1;
    if (length > 0 && !its && leads_to_wall(side + length)) skip_[owned] = true;
    const std::size_t verb = length == 0 ? 0 : verb_after(side + length - 1);
    if (verb != side + length) return;
    if (its)
      tokens_[begin].text = "it";
    else
      skip_[owned] = true;
    move_before(document_, skip_, side, verb, verb + 1);
  }

  const Lexicon& lexicon_;
  Document& document_;
  std::vector<Token>& tokens_;
  std::vector<bool>& skip_;
};

}  // namespace

void turn_side_subjects(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { SideTurner(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
