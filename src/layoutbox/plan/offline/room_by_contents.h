// What kind a room is that the text does not name, by what stands in it.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// A room of no named kind with a bed is a bedroom, with a stove a kitchen …: what the things that are named say for certain.
void name_room_by_contents(const Lexicon& lexicon, const Document& document, SceneGraph& scene);

// Whether the text speaks of children.
bool speaks_of_young(const Lexicon& lexicon, const Document& document);

}  // namespace layoutbox::offline
