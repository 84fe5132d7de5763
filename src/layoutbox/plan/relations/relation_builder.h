// Links between mentions become relations between objects.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Adds the relations of `document` to `scene`, whose objects stand in the order of the document's items.
void build_relations(const Lexicon& lexicon, Document& document, SceneGraph& scene);

}  // namespace layoutbox::offline
