// Walls that are called after what is in them: "the window wall", "the wall with the door".
#include <algorithm>
#include <optional>
#include <string_view>

#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/room/room_reader_parts.h"

namespace layoutbox::offline {
namespace {

// The opening after which a wall is called; none: it is not called so.
std::optional<OpeningType> called_after(const Lexicon& lexicon, const Document& document, const NounPhrase& wall) {
  if (wall.kind != NounKind::kWall || !wall.wall_word.empty() || !wall.wall_relation.empty() || wall.plural) return {};
  for (std::size_t i = wall.first; i + 1 < wall.last; ++i) {
    if (lexicon.find(document.tokens, i, WordClass::kDoor).length > 0) return OpeningType::kDoor;
    if (lexicon.find(document.tokens, i, WordClass::kWindow).length > 0) return OpeningType::kWindow;
  }
  return {};
}

// The wall of the first of them; one that nobody put anywhere is put where such a one mostly is.
std::string wall_of(OpeningType type, const Document& document, SceneGraph& scene) {
  std::vector<Opening>& openings = scene.room.openings;
  const auto is_meant = [&](const Opening& o) { return o.type == type; };
  const auto placed = std::ranges::find_if(openings, [&](const Opening& o) { return is_meant(o) && !o.wall.empty(); });
  if (placed != openings.end()) return placed->wall;
  if (std::ranges::none_of(openings, is_meant)) add_assumed_opening(scene, type, {});
  // "a counter along the back wall, a bench against the window wall": another wall than those that are named
  const auto is_free = [&](std::string_view wall) {
    return std::ranges::none_of(openings, [&](const Opening& o) { return o.wall == wall; }) &&
           std::ranges::none_of(document.mentions,
                                [&](const Mention& m) { return m.noun.kind == NounKind::kWall && m.noun.wall_word == wall; });
  };
  std::string wall = "front";
  for (const std::string_view side : {"right", "left", "back"}) {
    if (type == OpeningType::kWindow && is_free(side)) wall = side;
  }
  std::ranges::find_if(openings, is_meant)->wall = wall;
  return wall;
}

}  // namespace

void name_walls_by_openings(const Lexicon& lexicon, Document& document, SceneGraph& scene) {
  const bool none = scene.room.openings.empty();
  for (Mention& mention : document.mentions) {
    if (const auto type = called_after(lexicon, document, mention.noun)) mention.noun.wall_word = wall_of(*type, document, scene);
  }
  if (none && !scene.room.openings.empty()) add_needed_openings(document, scene);  // of a room with a door wall nothing is said of windows
}

}  // namespace layoutbox::offline
