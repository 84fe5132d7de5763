// Rooms of which no furniture is named: what they are for, and what is usual there.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Furnishes a scene without objects: with what is usual in the kinds of room that the text names; where it names none, in the one that
// its activities, people or things suggest ("somewhere to relax", "for a robot to practise picking up mugs"). What it names within a
// purpose is there as well. Marked as assumed, with a note; the scene stays as it is where the text hints at no room.
void furnish_by_wish(const Lexicon& lexicon, const Document& document, SceneGraph& scene);

}  // namespace layoutbox::offline
