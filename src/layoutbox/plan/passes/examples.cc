#include "layoutbox/plan/passes/examples.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/phrases/token_reader.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

class ExampleReader : public TokenReader {
 public:
  ExampleReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) : TokenReader(lexicon, document.tokens, skip) {}

  std::vector<Splice> run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!skip_[i] && is_any_things(i)) read(i);
    }
    return std::move(splices_);
  }

 private:
  bool is_any_things(std::size_t at) const {
    const std::string& word = tokens_[at].text;
    return tokens_[at].kind == Token::Kind::kWord && singular_of(word) != word &&
           (is_collective(singular_of(word)) || is(at, {"objects", "things", "props", "products"}));
  }

  // The tokens of a thing there, one or several; 0: none.
  std::size_t thing_at(std::size_t at) const {
    const Match match = lexicon_.find(tokens_, at);
    return meaning_of(match, WordClass::kObject) != nullptr ? match.length : 0;
  }

  // Where the list begins behind the word; 0: none does.
  std::size_t list_from(std::size_t at) const {
    if (is(at, {"(", ":"})) return at + (is(at + 1, {"e.g", "eg", "like"}) ? 2 : are(at + 1, {"such", "as"}) ? 3 : 1);
    if (are(at, {"such", "as"})) return at + 2;
    return is(at, {"like"}) ? at + 1 : 0;
  }

  // "at least five graspable": where what belongs to the word begins, and the number that stands there.
  std::pair<std::size_t, int> lead(std::size_t at) const {
    constexpr std::size_t kAdjectives = 2;
    for (std::size_t back = 1; back <= kAdjectives + 1 && back <= at; ++back) {
      const std::size_t k = at - back;
      const NumberRead number = read_number(lexicon_, tokens_, k);
      if (lexicon_.is(tokens_[k], WordClass::kIndefinite)) return {k, 0};  // "a few objects"
      if (number.length == 0 && (tokens_[k].kind == Token::Kind::kPunctuation || lexicon_.find_phrase(tokens_, k).length > 0))
        return {k + 1, 0};
      if (number.length == 0) continue;
      std::size_t first = k;
      if (first > 1 && is(first - 1, {"least", "most"}) && is(first - 2, {"at"})) first -= 2;
      return {first, static_cast<int>(number.value)};
    }
    return {at, 0};
  }

  // "fifteen objects on the table (plates, mugs)": the bracket behind where they are; 0: none.
  std::size_t bracket_behind_place(std::size_t at) const {
    constexpr std::size_t kMostWords = 7;
    if (lexicon_.find_phrase(tokens_, at).length == 0) return 0;
    for (std::size_t i = at + 1; i < at + kMostWords && i < tokens_.size() && !tokens_[i].ends_sentence; ++i) {
      if (is(i, {"("})) return i;
      if (tokens_[i].kind == Token::Kind::kPunctuation) return 0;
    }
    return 0;
  }

  // The places of the list's things, up to the sentence's end or the bracket's; nothing where it lists anything else.
  struct Listed {
    std::vector<std::size_t> bare;  // "plates"
    int told = 0;                   // "a mug": how many is said of it
    std::size_t end = 0;
  };
  std::optional<Listed> list_at(std::size_t from) const {
    Listed all;
    std::size_t i = from;
    for (; i < tokens_.size() && !tokens_[i].ends_sentence && !is(i, {")"}); ++i) {
      const std::size_t length = thing_at(i);
      const bool begins = i == from || is(i - 1, {",", "and", "or"});
      const bool counted = begins && is_article(i);
      if (begins && length == 0 && !counted) return {};
      all.told += counted ? 1 : 0;
      if (!begins || length == 0) continue;
      all.bare.push_back(i);
      i += length - 1;
    }
    all.end = i;
    return all;
  }

  void read(std::size_t at) {
    const std::size_t behind = bracket_behind_place(at + 1);
    const std::size_t from = behind > 0 ? list_from(behind) : list_from(at + 1);
    if (from == 0) return;
    const bool bracket = behind > 0 || is(at + 1, {"("});
    const std::optional<Listed> list = list_at(from);
    if (!list || (bracket && !is(list->end, {")"}))) return;
    const auto [first, number] = lead(at);
    const int listed = static_cast<int>(list->bare.size());
    if (listed < 1 && list->told == 0) return;
    const int shared = number - list->told;  // among those of which nobody says how many
    if (list->told == 0 && number < listed) return;
    leave_out(first, behind > 0 ? at + 1 : from);
    if (bracket) leave_out(list->end, list->end + 1);
    const auto count_of = [&](std::size_t k) { return shared / listed + (static_cast<int>(k) < shared % listed); };
    if (behind == 0) {
      for (std::size_t k = 0; shared >= listed && k < list->bare.size(); ++k)
        splices_.push_back({list->bare[k], number_token(count_of(k))});
      return;
    }
    // What the bracket lists comes before the place.
    for (std::size_t i = from; i < list->end; ++i) {
      const auto bare = std::ranges::find(list->bare, i);
      if (bare != list->bare.end() && shared >= listed)
        splices_.push_back({first, number_token(count_of(static_cast<std::size_t>(bare - list->bare.begin())))});
      splices_.push_back({first, tokens_[i]});
    }
    leave_out(behind, list->end + 1);
  }

  std::vector<Splice> splices_;
};

}  // namespace

void read_examples(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  splice(document, skip, ExampleReader(lexicon, document, skip).run());
}

}  // namespace layoutbox::offline
