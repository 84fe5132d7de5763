// In which wall the text has a door or a window: "to the east", "at both ends", "man door back right corner".
#include <algorithm>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

// "the door to the bakehouse is at the back": where the door leads, in the two chunks from n on.
void leave_out_where_it_leads(Document& document, NounPhrase& door, std::size_t n) {
  std::vector<Chunk>& chunks = document.chunks;
  const bool leads = n + 1 < chunks.size() && chunks[n].first + 1 == chunks[n].last && document.tokens[chunks[n].first].text == "to" &&
                     chunks[n + 1].kind == ChunkKind::kNoun &&
                     (chunks[n + 1].noun.kind != NounKind::kObject || !chunks[n + 1].noun.exact) &&
                     chunks[n + 1].noun.kind != NounKind::kWall;
  if (!leads) return;
  if (opening_look(OpeningType::kDoor, {chunks[n + 1].noun.head}).outside) door.attributes.push_back(chunks[n + 1].noun.head);
  for (std::size_t c = n; c < n + 2; ++c) {
    chunks[c].kind = ChunkKind::kIgnored;
    for (std::size_t i = chunks[c].first; i < chunks[c].last; ++i) {
      document.readings[i].use = WordReading::Use::kIgnored;
      document.readings[i].role = "where the door leads";
    }
  }
}

// What is said of an opening's place where no wall is named: "entrance south", "window (east)", "the door is on the front", "man door
// back right corner".
struct SideSaid {
  std::string wall, corner;
  std::size_t last = 0;  // the token behind it; 0: nothing is said
};
SideSaid side_said_at(const Lexicon& lexicon, const Document& document, std::size_t i) {
  const std::vector<Token>& tokens = document.tokens;
  const auto is = [&](std::initializer_list<std::string_view> words) { return says_one_of(document, i, words); };
  const bool bracket = is({"("});
  if (bracket) ++i;
  // "the balcony door, which takes almost all the right wall"
  const bool relative = is({","}) && says_one_of(document, i + 1, {"which", "that"}) &&
                        says_one_of(document, i + 2, {"takes", "occupies", "fills", "covers", "spans", "is", "are"});
  if (relative) i += 3;
  while (relative && is({"up", "almost", "nearly", "all", "most", "of", "whole", "entire"})) ++i;
  while (is({"is", "are", "on", "at", "in", "to", "the", "located", "placed", "situated"})) ++i;
  const auto side_at = [&](std::size_t at) { return at < tokens.size() ? lexicon.find(tokens, at, WordClass::kWallWord) : Match{}; };
  const Match side = side_at(i);
  if (side.length == 0) return {};
  SideSaid said{std::string(meaning_of(side, WordClass::kWallWord)->word), {}, i + side.length};
  i = said.last;
  if (const Match second = side_at(i); second.length > 0) {
    said.corner = meaning_of(second, WordClass::kWallWord)->word;
    i += second.length;
    if (!is({"corner"})) return {};
    ++i;
  } else if (is({"side", "end"}) || (relative && is({"wall"}))) {
    ++i;
  }
  const bool ends = i >= tokens.size() || tokens[i].kind == Token::Kind::kPunctuation || lexicon.is(tokens[i], WordClass::kAnd);
  if (is({"and", "&"})) {  // "on the east and west walls": the walls say it
    std::size_t other = i + 1;
    while (says_one_of(document, other, {"the", "on", "in"})) ++other;
    const std::size_t length = side_at(other).length;
    if (length > 0 && says_one_of(document, other + length, {"wall", "walls", "side", "sides"})) return {};
  }
  if (!ends || (bracket && !is({")"}))) return {};
  said.last = i + (bracket ? 1 : 0);
  return said;
}

}  // namespace

namespace {

// One of several openings, or so many of them, and the wall that is theirs.
struct WallShare {
  std::size_t chunk = 0, last = 0;  // the word that says how many, and the token behind the wall
  int count = 1;
  std::string wall;
};

// "…, one on the left wall", "two on the back", "one front", in the chunk c.
std::optional<WallShare> wall_share_at(const Lexicon& lexicon, const Document& document, std::size_t c, int left) {
  const Chunk& chunk = document.chunks[c];
  const NounPhrase& noun = chunk.noun;
  if (chunk.kind != ChunkKind::kNoun || noun.kind != NounKind::kMember || noun.of) return {};
  std::size_t i = chunk.last;
  while (says_one_of(document, i, {"on", "in", "at", "to", "along", "the", "is", "are"})) ++i;
  const Match side = i < document.tokens.size() ? lexicon.find(document.tokens, i, WordClass::kWallWord) : Match{};
  if (side.length == 0) return {};
  WallShare share{c, i + side.length, noun.count > 0 ? noun.count : 1, std::string(meaning_of(side, WordClass::kWallWord)->word)};
  if (says_one_of(document, share.last, {"wall", "side", "end"})) ++share.last;
  if (noun.determiner == Determiner::kBoth || (noun.determiner == Determiner::kOther && noun.plural)) share.count = left;
  const bool ends = share.last >= document.tokens.size() || document.tokens[share.last].kind == Token::Kind::kPunctuation ||
                    document.tokens[share.last - 1].ends_sentence || lexicon.is(document.tokens[share.last], WordClass::kAnd);
  return ends ? std::optional(share) : std::nullopt;
}

}  // namespace

// "three doors, one on the left wall, two on the back": as many of them are named once more, each with its wall.
void share_out_openings(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    const NounPhrase all = chunks[k].noun;
    if (chunks[k].kind != ChunkKind::kNoun || !is_opening(all) || all.count < 2) continue;
    std::vector<WallShare> shares;
    int left = all.count;
    for (std::size_t c = k + 1; c < chunks.size() && left > 0; ++c) {
      if (chunks[c].kind == ChunkKind::kComma || chunks[c].kind == ChunkKind::kAnd || chunks[c].kind == ChunkKind::kIgnored) continue;
      const auto share = wall_share_at(lexicon, document, c, left);
      if (!share) break;
      shares.push_back(*share);
      left -= share->count;
      while (c + 1 < chunks.size() && chunks[c + 1].first < share->last) ++c;
    }
    if (left != 0) continue;
    for (const WallShare& share : shares) {
      NounPhrase& one = chunks[share.chunk].noun;
      NounPhrase own = all;
      own.first = one.first, own.last = one.last;
      own.count = share.count, own.plural = share.count > 1;
      own.wall_word = share.wall;
      one = std::move(own);
      take_chunks(document, chunks[share.chunk].last, share.last, "which wall");
    }
    take_chunks(document, chunks[k].first, chunks[k].last, "doors and windows");
  }
}

namespace {

// "the front window", "the back windows": which wall; empty: it does not say. The left window may be one of two.
std::string wall_in_name(const Lexicon& lexicon, const Document& document, const NounPhrase& noun) {
  for (std::size_t i = noun.first; i < noun.last; ++i) {
    const Match side = lexicon.find(document.tokens, i, WordClass::kWallWord);
    const std::string wall(side.length == 0 ? std::string_view{} : meaning_of(side, WordClass::kWallWord)->word);
    if (wall == "front" || wall == "back" || (noun.plural && (wall == "left" || wall == "right"))) return wall;
  }
  return {};
}

bool is_window(const Chunk& chunk) { return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kWindow; }

// The text puts that window into a wall, or brings in so many.
bool is_told(const Document& document, std::size_t k) {
  const NounPhrase& noun = document.chunks[k].noun;
  const std::vector<Chunk>& chunks = document.chunks;
  const bool put = k + 2 < chunks.size() && chunks[k + 1].kind == ChunkKind::kRelation && chunks[k + 2].kind == ChunkKind::kNoun &&
                   chunks[k + 2].noun.kind == NounKind::kWall;
  return put || !noun.wall_word.empty() || noun.count > 1 || (noun.plural && noun.determiner != Determiner::kDefinite);
}

// "plants in front of the shop window", "the north windows": in the wall where such a window is, where nothing else is told of windows.
void settle_walls_of_names(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    if (is_window(chunks[k]) && is_told(document, k)) return;
  }
  for (Chunk& chunk : chunks) {
    if (!is_window(chunk)) continue;
    const std::string named = wall_in_name(lexicon, document, chunk.noun);
    chunk.noun.wall_word =
        named.empty() ? opening_look(OpeningType::kWindow, {words_between(document, chunk.first, chunk.last)}).wall : named;
  }
}

}  // namespace

// "a window to the east", "the entrance is on the left", "the window faces south": which wall.
void settle_opening_walls(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  const auto passed = [&](std::size_t n) {
    return n < chunks.size() && (chunks[n].kind == ChunkKind::kIgnored || chunks[n].kind == ChunkKind::kVerb ||
                                 chunks[n].kind == ChunkKind::kParticiple || chunks[n].kind == ChunkKind::kSize);
  };
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    NounPhrase& noun = chunks[k].noun;
    if (chunks[k].kind != ChunkKind::kNoun || (noun.kind != NounKind::kDoor && noun.kind != NounKind::kWindow)) continue;
    std::size_t n = k + 1;
    if (noun.kind == NounKind::kDoor) leave_out_where_it_leads(document, noun, n);
    if (const SideSaid side = side_said_at(lexicon, document, chunks[k].last); side.last > 0) {
      noun.wall_word = side.wall;
      noun.near_corner = side.corner;
      take_chunks(document, chunks[k].last, side.last, "which wall");
      continue;
    }
    if (is_window(chunks[k]) && noun.wall_word.empty() && !noun.plural) noun.wall_word = wall_in_name(lexicon, document, noun);
    while (passed(n)) ++n;
    if (n >= chunks.size() || chunks[n].kind != ChunkKind::kRelation) continue;
    const std::size_t first = n++;
    while (n < chunks.size() && chunks[n].kind == ChunkKind::kIgnored) ++n;
    if (n < chunks.size() && chunks[n].kind == ChunkKind::kNoun) continue;
    const bool by_thing = std::any_of(document.tokens.begin() + static_cast<std::ptrdiff_t>(chunks[first].first),
                                      document.tokens.begin() + static_cast<std::ptrdiff_t>(chunks[n - 1].last),
                                      [](const Token& token) { return token.text == "its" || token.text == "it"; });
    if (by_thing) continue;  // "a desk with a window to its left"
    for (std::size_t i = chunks[first].first; i < chunks[n - 1].last; ++i) {
      const Match side = lexicon.find(document.tokens, i, WordClass::kWallWord);
      if (side.length == 0) continue;
      noun.wall_word = meaning_of(side, WordClass::kWallWord)->word;
      for (std::size_t c = first; c < n; ++c) chunks[c].kind = ChunkKind::kIgnored;
      break;
    }
  }
  settle_walls_of_names(lexicon, document);
}

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
    const auto middle = middle_said_at(lexicon, document, first);
    const auto& [word, last] = middle.first.empty() ? end_said_at(document, first) : middle;
    if (word.empty()) continue;
    const std::string across = word == "other" ? wall_across_from_named(document, k) : std::string{};
    chunk.noun.wall_word = across.empty() ? word : across;
    chunk.noun.in_middle = !middle.first.empty();
    // "two windows in each long wall"
    const bool each =
        (word == "ends" || word == "lengths") && (says_one_of(document, first, {"per"}) || says_one_of(document, first + 1, {"each"}));
    if (each && chunk.noun.count > 1) chunk.noun.count *= 2;
    take_chunks(document, first, last, "which wall");
  }
}

}  // namespace layoutbox::offline
