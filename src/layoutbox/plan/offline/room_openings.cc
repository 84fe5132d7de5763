// What the text says of doors and windows: their sizes, their walls.
#include <algorithm>

#include "layoutbox/plan/offline/noun_phrase_parts.h"
#include "layoutbox/plan/offline/room_reader.h"

namespace layoutbox::offline {

namespace {
using Class = WordClass;

// Doors that slide, and doors of two leaves.
struct DoorKind {
  std::string_view word;
  bool slides, two_leaves;
};
constexpr DoorKind kDoorKinds[] = {{"patio", true, true},   {"garage", true, true},   {"roller", true, true},  {"automatic", true, true},
                                   {"french", false, true}, {"double", false, true},  {"saloon", false, true}, {"folding", false, true},
                                   {"bifold", false, true}, {"bi-fold", false, true}, {"pocket", true, false}, {"barn", true, false},
                                   {"sliding", true, false}};

const DoorKind* door_kind(const NounPhrase& noun) {
  if (noun.kind != NounKind::kDoor) return nullptr;
  const auto says = [&](const DoorKind& kind) {
    return (" " + noun.name + " ").find(" " + std::string(kind.word) + " ") != std::string::npos ||
           std::find(noun.attributes.begin(), noun.attributes.end(), kind.word) != noun.attributes.end();
  };
  const auto* kind = std::find_if(std::begin(kDoorKinds), std::end(kDoorKinds), says);
  return kind == std::end(kDoorKinds) ? nullptr : kind;
}
}  // namespace

bool is_kind_of_door(const NounPhrase& noun) { return door_kind(noun) != nullptr; }

// "French doors", "double doors": one opening, whose leaves they are.
int openings_said(const NounPhrase& noun) {
  const bool leaves = noun.plural && door_kind(noun) != nullptr && (noun.count == 0 || noun.name.find("double") != std::string::npos);
  if (leaves) return 1;
  return noun.count > 0 ? noun.count : noun.plural ? 2 : 1;
}

void settle_opening_sizes(Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    if (chunks[k].kind != ChunkKind::kNoun || (chunks[k].noun.kind != NounKind::kDoor && chunks[k].noun.kind != NounKind::kWindow))
      continue;
    bool placed = false;  // "two windows in the back wall, each 2 m wide"
    for (std::size_t n = k + 1; n < chunks.size(); ++n) {
      Chunk& next = chunks[n];
      if (next.kind == ChunkKind::kSize && !placed) {
        chunks[k].noun.size = next.size;
        next.kind = ChunkKind::kIgnored;
        for (std::size_t i = next.first; i < next.last; ++i) {
          document.readings[i].use = WordReading::Use::kUsed;
          document.readings[i].role = "size of the opening";
        }
        break;
      }
      const bool each = next.kind == ChunkKind::kNoun && next.noun.kind == NounKind::kMember;
      if (each && next.noun.size.any()) {  // "each 2 m wide"
        chunks[k].noun.size = next.noun.size;
        next.kind = ChunkKind::kIgnored;
        break;
      }
      placed |= next.kind == ChunkKind::kRelation;
      if (placed && next.kind == ChunkKind::kNoun && next.noun.kind == NounKind::kWall) continue;
      if (next.kind != ChunkKind::kIgnored && next.kind != ChunkKind::kRelation && next.kind != ChunkKind::kComma &&
          next.kind != ChunkKind::kVerb && !each)
        break;
    }
  }
}

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
    while (passed(n)) ++n;
    if (n >= chunks.size() || chunks[n].kind != ChunkKind::kRelation) continue;
    const std::size_t first = n++;
    while (n < chunks.size() && chunks[n].kind == ChunkKind::kIgnored) ++n;
    if (n < chunks.size() && chunks[n].kind == ChunkKind::kNoun) continue;
    for (std::size_t i = chunks[first].first; i < chunks[n - 1].last; ++i) {
      const Match side = lexicon.find(document.tokens, i, Class::kWallWord);
      if (side.length == 0) continue;
      noun.wall_word = meaning_of(side, Class::kWallWord)->word;
      for (std::size_t c = first; c < n; ++c) chunks[c].kind = ChunkKind::kIgnored;
      break;
    }
  }
}

Opening opening_said(OpeningType type, const NounPhrase& noun) {
  Opening opening;
  opening.type = type;
  const auto said = [&](std::string_view word) {
    return std::find(noun.attributes.begin(), noun.attributes.end(), word) != noun.attributes.end();
  };
  if (type == OpeningType::kWindow) {
    opening.width = said("large") || said("big") || said("wide") ? 1800 : said("small") ? 800 : 1200;
    opening.height = 1200;
    opening.sill = 900;
    opening.swing = Swing::kNone;
    if (noun.name.find("floor to ceiling") != std::string::npos || noun.name.find("floor-to-ceiling") != std::string::npos)
      opening.sill = 100, opening.height = 2200;
  } else {
    const DoorKind* kind = door_kind(noun);
    opening.width = kind != nullptr && (kind->two_leaves || noun.plural) ? 1600 : 900;
    opening.height = 2000;
    if (kind != nullptr && kind->slides) opening.swing = Swing::kSliding;
  }
  if (noun.size.span) opening.width = mm_from_m(*noun.size.span);
  if (noun.size.either && noun.size.depth) opening.height = mm_from_m(*noun.size.depth);
  if (noun.size.length) opening.width = mm_from_m(*noun.size.length);
  if (noun.size.width) opening.width = mm_from_m(*noun.size.width);
  if (noun.size.height) opening.height = mm_from_m(*noun.size.height);
  return opening;
}

}  // namespace layoutbox::offline
