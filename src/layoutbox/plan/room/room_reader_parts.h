// What the files behind build_room have in common.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {

// Where the text puts a door or a window: the wall, and the corner there that it is near ("right").
struct PlacedOpening {
  const Mention* mention = nullptr;
  std::string wall, corner;
};
using PlacedOpenings = std::vector<PlacedOpening>;
PlacedOpenings placed_openings(const Document& document);

// At that wall's word, or where it pleases.
void add_opening(SceneGraph& scene, OpeningType type, const NounPhrase& noun, const std::string& wall);

// Doors and windows that the text brings in; those it only refers to are the default ones.
void add_openings(const Document& document, SceneGraph& scene);
// One kind named, the other is still needed, where it is not said that there is none.
void add_needed_openings(const Document& document, SceneGraph& scene);
// A garage has a garage door, besides the one into the house where that is named.
void add_door_of_kind(const Catalog& catalog, SceneGraph& scene);

// The wall that a thing is said to be at; empty: none.
std::string wall_of_thing(const Document& document, int mention);

// Materials and colours that the text gives the walls, the floor and the ceiling.
void set_surfaces(const Lexicon& lexicon, const Document& document, Room& room);

}  // namespace layoutbox::offline
