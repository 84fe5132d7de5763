// What walls and floors are covered with: "exposed brick on the back wall", "floral wallpaper", "herringbone parquet". Such words become
// the wall or the floor that they speak of, so that what is said of its place is read as of any other.
#include <algorithm>
#include <optional>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {
namespace {

bool is_finish_word(const Document& document, std::size_t i, std::string_view list) {
  if (i >= document.tokens.size()) return false;
  for (const WordList::Member word : word_list("words_room").at("finish_words").at(list)) {
    if (word.value.text() == document.tokens[i].text) return true;
  }
  return false;
}

// A finish of the table whose words begin at `i`: how many they are, and where it is by itself ("wall", "floor", "both"; "": it must be
// said).
struct Finish {
  std::size_t length = 0;
  std::string_view where;
};

Finish finish_at(const std::vector<Token>& tokens, std::size_t i) {
  static const std::vector<std::pair<std::vector<std::string>, std::string_view>> kFinishes = [] {
    std::vector<std::pair<std::vector<std::string>, std::string_view>> finishes;
    for (const WordList::Member finish : word_list("words_room").at("finishes"))
      finishes.emplace_back(words_of(finish.key), finish.value.text());
    return finishes;
  }();
  Finish best;
  for (const auto& [words, where] : kFinishes) {
    if (words.size() > best.length && stand_at(tokens, i, words)) best = {words.size(), where};
  }
  return best;
}

// Where it is said to be: "on the back wall", "up the walls", "on the floor".
struct Where {
  std::size_t last = 0;                          // tokens
  bool floor = false, all = false, one = false;  // one: "on one wall", whichever
  std::string wall_word;
};

std::optional<Where> where_said(const Lexicon& lexicon, const Document& document, std::size_t i) {
  if (!is_finish_word(document, i, "places")) return std::nullopt;
  while (is_finish_word(document, i, "places")) ++i;
  Where where;
  for (; is_finish_word(document, i, "articles"); ++i) where.one = where.one || is_finish_word(document, i, "single");
  if (const Match side = lexicon.find(document.tokens, i, WordClass::kWallWord); side.length > 0) {
    where.wall_word = meaning_of(side, WordClass::kWallWord)->word;
    i += side.length;
  }
  if (!says_one_of(document, i, {"wall", "walls", "floor"})) return std::nullopt;
  where.floor = document.tokens[i].text == "floor";
  where.all = document.tokens[i].text == "walls" && where.wall_word.empty();
  where.last = i + 1;
  return where;
}

// A word that tells more of the finish after it: "white", "dark", "striped".
bool describes_finish(const Lexicon& lexicon, const Token& token) {
  return token.kind == Token::Kind::kWord &&
         (lexicon.is(token, WordClass::kColor) || lexicon.is(token, WordClass::kMaterial) || lexicon.is(token, WordClass::kQuality) ||
          lexicon.is(token, WordClass::kShape) || lexicon.is(token, WordClass::kSizeWord) || lexicon.is(token, WordClass::kStyle));
}

class FinishReader {
 public:
  FinishReader(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), document_(document) {}

  void run() {
    for (std::size_t i = 0; i < document_.tokens.size();) {
      const Finish finish = finish_at(document_.tokens, i);
      const std::size_t end = finish.length > 0 ? take(i, finish) : 0;
      i = std::max(end, i + std::max<std::size_t>(1, finish.length));
    }
  }

 private:
  // The token after all that was taken; 0: nothing was.
  std::size_t take(std::size_t at, const Finish& finish) {
    std::size_t first = at;
    while (first > 0 && describes_finish(lexicon_, document_.tokens[first - 1]) && !document_.tokens[first - 1].ends_sentence) --first;
    if (first == at && is_finish_word(document_, at, "described")) return 0;  // "a tin of paint" is on no wall, "dark green paint" is
    // "walls white, floor red tiles": said of that floor
    if (first > 0 && first < at && says_one_of(document_, first - 1, {"floor", "floors", "flooring", "walls"})) return 0;
    // "six tatami mats", "the tiles of the table": things, or parts of one
    if (first > 0 &&
        (document_.tokens[first - 1].kind == Token::Kind::kNumber || lexicon_.is(document_.tokens[first - 1], WordClass::kNumber)))
      return 0;
    if (first > 0 && lexicon_.is(document_.tokens[first - 1], WordClass::kBe)) return 0;  // "one wall is exposed brick": said of that wall
    // "a table with green tiles on top": its own
    const bool of_thing = first > 1 && lexicon_.is(document_.tokens[first - 1], WordClass::kHave) &&
                          lexicon_.find(document_.tokens, first - 2, WordClass::kObject).length > 0;
    if (finish.where == "both" && of_thing) return 0;
    const bool indefinite = first > 0 && lexicon_.is(document_.tokens[first - 1], WordClass::kIndefinite);
    if (indefinite) --first;
    std::size_t last = at + finish.length;
    if (is_finish_word(document_, last, "with") && is_finish_word(document_, last + 1, "prints")) last += 2;
    std::string material;
    for (std::size_t i = indefinite ? first + 1 : first; i < last; ++i)
      material += (material.empty() ? "" : " ") + document_.tokens[i].text;
    const std::optional<Where> where = where_said(lexicon_, document_, last);
    const bool behind = last < document_.tokens.size() && document_.tokens[last].text == "behind";
    if (where) last = where->last;
    if (!where && (finish.where.empty() || !(ends_at(last) || behind))) return 0;
    NounPhrase noun;
    noun.kind = (where ? where->floor : finish.where == "floor") ? NounKind::kFloor : NounKind::kWall;
    noun.determiner = indefinite || (where && where->one && !where->floor) ? Determiner::kIndefinite : Determiner::kNone;
    noun.head = noun.kind == NounKind::kFloor ? "floor" : "wall";
    noun.name = where || behind || finish.where != "both" ? noun.head : std::string(kWallsAndFloor);
    noun.attributes = {material};
    noun.attribute_classes = {WordClass::kMaterial};
    noun.plural = where ? where->all : !behind;
    noun.wall_word = where ? where->wall_word : std::string{};
    noun.first = first;
    noun.last = last;
    put(std::move(noun));
    return last;
  }

  // No noun goes on there: "brick wall", "tile floor" are read as they are.
  bool ends_at(std::size_t i) const {
    return i >= document_.tokens.size() || document_.tokens[i].kind == Token::Kind::kPunctuation || document_.tokens[i - 1].ends_sentence ||
           is_finish_word(document_, i, "ends");
  }

  // In the place of the chunks that the words were.
  void put(NounPhrase noun) {
    std::vector<Chunk>& chunks = document_.chunks;
    const auto within = [&](const Chunk& chunk) {
      return chunk.first < noun.last && chunk.last > noun.first && chunk.kind != ChunkKind::kStop;
    };
    const auto at = std::ranges::find_if(chunks, within);
    if (at == chunks.end()) return;
    noun.first = std::min(noun.first, at->first);
    Chunk made;
    made.kind = ChunkKind::kNoun;
    made.first = noun.first;
    made.last = noun.last;
    made.noun = std::move(noun);
    const auto after = std::find_if_not(at, chunks.end(), within);
    made.last = made.noun.last = std::max(made.last, std::prev(after)->last);
    *at = std::move(made);
    chunks.erase(std::next(at), after);
  }

  const Lexicon& lexicon_;
  Document& document_;
};

}  // namespace

void settle_finishes(const Lexicon& lexicon, Document& document) { FinishReader(lexicon, document).run(); }

}  // namespace layoutbox::offline
