// In which wall the text has a door or a window: "to the east", "two on the back", "man door back right corner".
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
      noun.place.corner = side.corner;
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

}  // namespace layoutbox::offline
