// Doors and windows whose wall is told by its length, its middle or another opening: "at both ends", "opposite", "on either side of it".
#include <algorithm>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

// "(an entrance …) with a big window either side": one on each side of it, in its wall; where the words end, 0: that is not said.
std::size_t beside_door_at(const Document& document, std::size_t i) {
  const auto is = [&](std::size_t at, std::initializer_list<std::string_view> words) { return says_one_of(document, at, words); };
  const bool on = is(i, {"on", "at", "to"});
  if (on) ++i;
  if (!is(i, {"either", "each", "both"}) || !is(i + 1, {"side", "sides"})) return 0;
  i += 2;
  if (is(i, {"of"}) && is(i + 1, {"it"})) return i + 2;
  if (is(i, {"of"}) && is(i + 1, {"the"}) && is(i + 2, {"door", "entrance"})) return i + 3;
  return i >= document.tokens.size() || document.tokens[i].kind == Token::Kind::kPunctuation ? i : 0;
}

// The door that this sentence named last before the chunk k; null: none.
const NounPhrase* door_before(const Document& document, std::size_t k) {
  while (k-- > 0 && document.chunks[k].kind != ChunkKind::kStop) {
    if (document.chunks[k].kind == ChunkKind::kNoun && document.chunks[k].noun.kind == NounKind::kDoor) return &document.chunks[k].noun;
  }
  return nullptr;
}

// "the screen on the short wall, a door at the other end": across from the wall that this sentence named last, where no door or window
// came before.
std::string wall_across_from_named(const Document& document, std::size_t k) {
  while (k-- > 0 && document.chunks[k].kind != ChunkKind::kStop) {
    const NounPhrase& noun = document.chunks[k].noun;
    if (document.chunks[k].kind != ChunkKind::kNoun) continue;
    if (noun.kind == NounKind::kDoor || noun.kind == NounKind::kWindow) return {};
    if (noun.kind != NounKind::kWall) continue;
    const bool by_length =
        std::ranges::any_of(noun.attributes, [](const std::string& word) { return one_of(word, WordSet::kLongOrShort); }) ||
        one_of(noun.name.substr(0, noun.name.find(' ')), WordSet::kLongOrShort);
    return by_length ? noun.name.find("long") != std::string::npos ? "long" : "short" : wall_across(noun.wall_word);
  }
  return {};
}

using WallSaid = std::pair<std::string, std::size_t>;  // which wall, and where the words end; none: ""

// Several walls, or one by another opening: "at both ends", "in each of the long walls", "opposite it", "on the same wall".
WallSaid walls_said_at(const Document& document, std::size_t i) {
  const auto is = [&](std::size_t at, std::initializer_list<std::string_view> words) { return says_one_of(document, at, words); };
  if (is(i, {"opposite"}) && is(i + 1, {"it", "that"})) return {"other", i + 2};
  if (is(i, {"on", "in"}) && is(i + 1, {"the"}) && is(i + 2, {"same"}) && is(i + 3, {"wall", "side"})) return {"same", i + 4};
  if (is(i, {"at", "on"}) && is(i + 1, {"both", "each", "either"}) && is(i + 2, {"end", "ends"}))
    return {"ends", i + (is(i + 3, {"of"}) && is(i + 4, {"the", "it"}) ? is(i + 4, {"it"}) ? 5 : 6 : 3)};
  // "on both long walls", "one per long wall"
  const bool per = is(i, {"per"});
  if (per || (is(i, {"at", "on", "in", "along"}) && is(i + 1, {"both", "each"}))) {
    std::size_t wall = i + (per ? 1 : 2);
    while (is(wall, {"of", "the"})) ++wall;
    if (is(wall, {"long", "longer", "short", "shorter"}) && is(wall + 1, {"side", "sides", "wall", "walls", "end", "ends"}))
      return {document.tokens[wall].text.starts_with("long") ? "lengths" : "ends", wall + 2};
  }
  if (is(i, {"on", "in", "along"}) && is(i + 1, {"two", "three", "both"}) && is(i + 2, {"sides", "walls"})) return {"sides", i + 3};
  if (is(i, {"opposite", "facing"}) && is(i + 1, {"each"}) && is(i + 2, {"other"})) return {"across", i + 3};
  return {};
}

// "on the short side", "at one end", "opposite": which wall, by its length or by the other opening.
WallSaid end_said_at(const Document& document, std::size_t i) {
  const auto is = [&](std::size_t at, std::initializer_list<std::string_view> words) { return says_one_of(document, at, words); };
  if (is(i, {"directly", "right", "straight"}) && is(i + 1, {"opposite"})) ++i;
  if (WallSaid walls = walls_said_at(document, i); !walls.first.empty()) return walls;
  // "door on the short side, balcony door opposite."
  const bool across = is(i, {"opposite"}) && (i + 1 >= document.tokens.size() || document.tokens[i].ends_sentence ||
                                              document.tokens[i + 1].kind == Token::Kind::kPunctuation);
  if (!across && !is(i++, {"at", "on", "in"})) return {};
  while (is(i, {"the", "one", "a", "of", "its", "two"})) ++i;
  std::string word;
  for (; is(i, {"long", "longer", "short", "shorter", "narrow", "other", "opposite"}); ++i)
    word = is(i, {"other", "opposite"}) ? "other" : document.tokens[i].text.starts_with("long") ? "long" : "short";
  const bool end = is(i, {"end", "ends"}), side = is(i, {"side", "sides", "one"});
  if (end || (side && !word.empty())) ++i;
  if (end && word.empty()) word = "short";
  if (word.empty() || is(i, {"wall", "walls"}) || (!end && !side && word != "other")) return {};
  const bool of_wall = is(i, {"of"}) && is(i + 1, {"the"}) && is(i + 3, {"wall"});  // "at the end of the left wall"
  if (of_wall) return {};
  if (is(i, {"of"}) && is(i + 1, {"the", "it"})) i += is(i + 1, {"it"}) ? 2 : 3;  // "of the room"
  return {word, i};
}

// "in the middle of one short wall", "centered on the left wall": which wall, and where the words end; none: "".
std::pair<std::string, std::size_t> middle_said_at(const Lexicon& lexicon, const Document& document, std::size_t i) {
  const auto is = [&](std::size_t at, std::initializer_list<std::string_view> words) { return says_one_of(document, at, words); };
  const bool middle = is(i, {"in", "at"}) && is(i + 1, {"the"}) && is(i + 2, {"middle", "center"}) && is(i + 3, {"of"});
  if (!middle && !(is(i, {"centered"}) && is(i + 1, {"on", "in"}))) return {};
  i += middle ? 4 : 2;
  while (is(i, {"the", "one", "a", "of", "its"})) ++i;
  std::string word;
  if (const Match wall = lexicon.find(document.tokens, i, WordClass::kWallWord); wall.length > 0) {
    word = meaning_of(wall, WordClass::kWallWord)->word;
    i += wall.length;
  } else if (says_one_of(document, i, WordSet::kLongOrShort)) {
    word = document.tokens[i++].text.starts_with("long") ? "long" : "short";
  }
  const bool wall = is(i, {"wall", "side", "end"});
  const bool ends = i >= document.tokens.size() || document.tokens[i].kind == Token::Kind::kPunctuation ||
                    lexicon.is(document.tokens[i], WordClass::kAnd) || is(i, {"with"});  // "in the middle of the front"
  if (word.empty() || (!wall && !ends)) return {};
  return {word, i + (wall ? 1 : 0)};
}

}  // namespace

void settle_opening_ends(const Lexicon& lexicon, Document& document) {
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    Chunk& chunk = document.chunks[k];
    if (chunk.kind != ChunkKind::kNoun || (chunk.noun.kind != NounKind::kDoor && chunk.noun.kind != NounKind::kWindow)) continue;
    std::size_t first = chunk.last;
    for (std::size_t n = k + 1; n < document.chunks.size() && document.chunks[n].kind == ChunkKind::kIgnored; ++n)
      first = document.chunks[n].last;
    while (says_one_of(document, first, {"is", "are", "being", "located", "placed", "situated"})) ++first;
    const std::size_t beside = chunk.noun.kind == NounKind::kWindow ? beside_door_at(document, first) : 0;
    if (const NounPhrase* door = beside > 0 ? door_before(document, k) : nullptr; door != nullptr) {
      chunk.noun.wall_word = door->wall_word.empty() ? "front" : door->wall_word;
      chunk.noun.count = 2, chunk.noun.plural = true;
      take_chunks(document, first, beside, "which wall");
      continue;
    }
    const auto size = first < document.tokens.size() ? read_measure(lexicon, document.tokens, first) : std::nullopt;
    const std::size_t at = first + (size ? size->length : 0);  // "a door 1.6 m in the middle of the back wall"
    const auto middle = middle_said_at(lexicon, document, at);
    const auto& [word, last] = middle.first.empty() ? end_said_at(document, at) : middle;
    if (word.empty()) continue;
    const std::string across = word == "other" ? wall_across_from_named(document, k) : std::string{};
    chunk.noun.wall_word = across.empty() ? word : across;
    chunk.noun.place.in_middle = !middle.first.empty();
    // "two windows in each long wall"
    const bool each =
        (word == "ends" || word == "lengths") && (says_one_of(document, first, {"per"}) || says_one_of(document, first + 1, {"each"}));
    if (each && chunk.noun.count > 1) chunk.noun.count *= 2;
    take_chunks(document, first, last, "which wall");
  }
}

}  // namespace layoutbox::offline
