// The size that the words give a thing.
#pragma once

#include "layoutbox/plan/phrases/noun_phrase.h"

namespace layoutbox::offline {

// Sets the sides of `object` that `noun` says; around them the catalogue's proportions hold.
void apply_size(const Catalog& catalog, const NounPhrase& noun, SceneObject& object);

// Of `count` things of all sizes the one of that rank: from small to large as such things come.
void apply_assorted_size(const NounPhrase& noun, int rank, int count, SceneObject& object);

}  // namespace layoutbox::offline
