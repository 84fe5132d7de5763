#include "layoutbox/plan/passes/shelf_subjects.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

class ShelfTurner {
 public:
  ShelfTurner(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : lexicon_(lexicon), document_(document), tokens_(document.tokens), skip_(skip) {}

  void run() {
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
      if (is_determiner(i) && tokens_[i + 1].text == "lower" && shelf_at(i + 1) > i + 1) tokens_[i + 1].text = "bottom";
    }
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) name_owner_last(i);
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
      if (i > 0 && tokens_[i - 1].ends_sentence) holding_ = false;
      place_on(i);
    }
    splice(document_, skip_, std::move(splices_));
  }

 private:
  static constexpr std::size_t kLongest = 5;  // tokens that name the thing

  bool is_determiner(std::size_t at) const {
    return lexicon_.is(tokens_[at], WordClass::kDefinite) || lexicon_.is(tokens_[at], WordClass::kPossessive);
  }

  // Where a phrase such as "top shelf", "two lower shelves" ends; `at`: nowhere. Of "the lower one" where shelves were spoken of.
  std::size_t shelf_at(std::size_t at) const {
    std::size_t end = at;
    while (end < std::min(at + 2, tokens_.size()) && one_of(tokens_[end].text, WordSet::kWhichShelf)) ++end;
    if (end == at || end >= tokens_.size()) return at;
    const bool one = holding_ && tokens_[end].text == "one";
    return one || one_of(singular_of(tokens_[end].text), WordSet::kShelfLevels) ? end + 1 : at;
  }

  // "the rack's middle shelf": the middle shelf of the rack.
  void name_owner_last(std::size_t owned) {
    if (tokens_[owned].text != "'s") return;
    const std::size_t end = shelf_at(owned + 1);
    if (end == owned + 1) return;
    std::size_t first = owned;
    while (first > 0 && owned - first < kLongest && !is_determiner(first) && !tokens_[first - 1].ends_sentence) --first;
    if (first == owned || !is_determiner(first)) return;
    tokens_[owned].text = "the";
    move_before(document_, skip_, first, owned, end);
    splices_.push_back({first + (end - owned), word_token("of")});
  }

  // Past "of the rack", where it stands there.
  std::size_t past_owner(std::size_t at) const {
    const bool moved = std::ranges::any_of(splices_, [&](const Splice& s) { return s.at == at; });
    if (!moved && (at >= tokens_.size() || tokens_[at].text != "of")) return at;
    std::size_t end = at + (moved ? 1 : 2);
    while (end < std::min(at + kLongest + 2, tokens_.size()) && !holds(end) && tokens_[end].text != ",") ++end;
    return end;
  }

  bool holds(std::size_t at) const { return at < tokens_.size() && one_of(tokens_[at].text, WordSet::kShelfHolds); }

  bool begins_clause(std::size_t at) const {
    return at == 0 || tokens_[at - 1].ends_sentence || tokens_[at - 1].kind == Token::Kind::kPunctuation ||
           lexicon_.is(tokens_[at - 1], WordClass::kAnd) || one_of(tokens_[at - 1].text, {"while", "whereas"});
  }

  // "its top shelf holds": on its top shelf is; "its bottom shelf two crocks", after another that holds something: on it.
  void place_on(std::size_t at) {
    const bool whose = tokens_[at].text == "whose";
    if (!whose && (!begins_clause(at) || !is_determiner(at))) return;
    const std::size_t shelf = shelf_at(at + 1);
    if (shelf == at + 1) return;
    const std::size_t verb = past_owner(shelf);
    const bool said = holds(verb);
    if (!said && !(holding_ && verb == shelf && begins_thing(verb))) return;
    if (whose) {
      splices_.push_back({at, comma_token()});
      tokens_[at].text = "its";
    }
    if (tokens_[shelf - 1].text == "one") tokens_[shelf - 1].text = "shelf", tokens_[at].text = "its";
    if (holding_ && at > 0 && tokens_[at - 1].text == ",") splices_.push_back({at, word_token("and")});
    splices_.push_back({at, word_token("on")});
    if (said)
      tokens_[verb].text = "is";
    else
      splices_.push_back({verb, word_token("is")});
    std::ranges::stable_sort(splices_, {}, &Splice::at);
    holding_ = true;
  }

  bool begins_thing(std::size_t at) const {
    return at < tokens_.size() && (lexicon_.is(tokens_[at], WordClass::kIndefinite) || lexicon_.is(tokens_[at], WordClass::kNumber) ||
                                   tokens_[at].kind == Token::Kind::kNumber);
  }

  const Lexicon& lexicon_;
  Document& document_;
  std::vector<Token>& tokens_;
  std::vector<bool>& skip_;
  std::vector<Splice> splices_;
  bool holding_ = false;  // a shelf of something was said to hold things, in this sentence
};

}  // namespace

void turn_shelf_subjects(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  ShelfTurner(lexicon, document, skip).run();
}

}  // namespace layoutbox::offline
