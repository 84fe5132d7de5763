#include "layoutbox/plan/passes/runs.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

class RunReader {
 public:
  RunReader(const Lexicon& lexicon, const Document& document, const std::vector<bool>& skip)
      : lexicon_(lexicon), tokens_(document.tokens), skip_(skip) {}

  // The tokens before which a comma is to stand.
  std::vector<std::size_t> run() const {
    std::vector<std::size_t> commas;
    if (const std::size_t room = end_of_room(); room > 0) commas.push_back(room);
    for (std::size_t i = 0; i < tokens_.size();) {
      if (is_subject_after_wall(i)) commas.push_back(i);
      const std::vector<std::size_t> begins = things_from(i);
      const std::size_t end = begins.empty() ? i + 1 : begins.back();
      const std::size_t things = begins.empty() ? 0 : begins.size() - 1;
      constexpr std::size_t kSurely = 3;
      if (things >= kSurely || (things > 1 && is_clause(i, end) && !joins(begins[things - 1], end)))
        commas.insert(commas.end(), begins.begin() + 1, begins.end() - 1);
      i = end;
    }
    return commas;
  }

 private:
  // A piece of furniture that stands at `at`, and how many tokens it is; 0: none.
  std::size_t thing_at(std::size_t at) const {
    if (at >= tokens_.size() || skip_[at] || tokens_[at].kind != Token::Kind::kWord) return 0;
    const Match match = lexicon_.find(tokens_, at);
    // "beside the desk stand bookshelves": the verb
    if (match.length == 1 && at > 0 && lexicon_.is(tokens_[at], WordClass::kPlaceVerb) &&
        lexicon_.find(tokens_, at - 1, WordClass::kObject).length > 0)
      return 0;
    for (const Meaning& meaning : match.meanings) {
      if (meaning.word_class == WordClass::kRoom || meaning.word_class == WordClass::kRoomNoun) return 0;
      if (meaning.word_class == WordClass::kObject && meaning.entry != nullptr && meaning.entry->mount == Mount::kFloor)
        return match.length;
    }
    return 0;
  }

  // "tiny laundry room washer, dryer, …": where the room that a text without an article begins with ends; 0: it begins with none such.
  std::size_t end_of_room() const {
    std::size_t at = 0;
    while (at < tokens_.size() && lexicon_.is(tokens_[at], WordClass::kSizeWord)) ++at;
    const Match match = at < tokens_.size() ? lexicon_.find(tokens_, at) : Match{};
    const bool room = std::ranges::any_of(match.meanings, [](const Meaning& m) { return m.word_class == WordClass::kRoom; });
    return room && match.length > 1 && thing_at(at + match.length) > 0 ? at + match.length : 0;
  }

  // Where each of the things in a row from `at` begins, and where the last one ends; empty where none is.
  std::vector<std::size_t> things_from(std::size_t at) const {
    std::vector<std::size_t> begins;
    for (std::size_t length = thing_at(at); length > 0; length = thing_at(at)) {
      begins.push_back(at);
      at += length;
    }
    if (!begins.empty()) begins.push_back(at);
    return begins;
  }

  // "On the left wall shelves hold books", "along the back wall pictures hang": several things after a wall, and a verb that brings in
  // nothing else there.
  bool is_subject_after_wall(std::size_t at) const {
    if (at < 4 || skip_[at - 1] || tokens_[at - 1].text != "wall" || lexicon_.find(tokens_, at - 2, WordClass::kWallWord).length != 1 ||
        tokens_[at - 3].text != "the" || lexicon_.find_phrase(tokens_, at - 4).length == 0)
      return false;
    const Match things = lexicon_.find(tokens_, at);
    const std::size_t verb = at + things.length;
    if (meaning_of(things, WordClass::kObject) == nullptr || !things.plural || verb + 1 >= tokens_.size()) return false;
    if (lexicon_.is(tokens_[verb], WordClass::kHave)) return true;
    const bool verbal = lexicon_.is(tokens_[verb], WordClass::kVerb) || lexicon_.is(tokens_[verb], WordClass::kHang) ||
                        lexicon_.is(tokens_[verb], WordClass::kPlaceVerb);
    return verbal && (tokens_[verb + 1].kind == Token::Kind::kPunctuation || lexicon_.find_phrase(tokens_, verb + 1).length > 0);
  }

  bool is_clause(std::size_t first, std::size_t end) const {
    const bool begins = first == 0 || skip_[first - 1] || tokens_[first - 1].kind == Token::Kind::kPunctuation;
    return begins && (end >= tokens_.size() || tokens_[end].kind == Token::Kind::kPunctuation);
  }

  // What other things have of their own: a wardrobe shelf, a shower bench.
  bool joins(std::size_t first, std::size_t end) const { return end != first + 1 || one_of(tokens_[first].text, WordSet::kMadeOfOthers); }

  const Lexicon& lexicon_;
  const std::vector<Token>& tokens_;
  const std::vector<bool>& skip_;
};

}  // namespace

void part_runs(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Splice> commas;
  for (const std::size_t at : RunReader(lexicon, document, skip).run()) commas.push_back({at, comma_token()});
  splice(document, skip, std::move(commas));
}

}  // namespace layoutbox::offline
