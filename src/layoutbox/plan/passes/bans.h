// What a wish wants of all of the room's things: that nothing stands somewhere, that a place or a side stays free, that nobody sits with
// the back to the door.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "Nothing in front of the window", "keep the middle free", "a metre all round it", "nobody with the back to the door": read before
// phrases are looked for, the words are marked in `skip`.
void read_bans(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

// … as relations of the things that are there.
void add_bans(const Lexicon& lexicon, Document& document, SceneGraph& scene);

}  // namespace layoutbox::offline
