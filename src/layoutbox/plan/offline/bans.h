// What a wish wants of all of the room's things: that nothing stands somewhere, that a place or a side stays free, that nobody sits with
// the back to the door.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "layoutbox/plan/offline/document.h"

namespace layoutbox::offline {

// One of them, as it was said.
struct Ban {
  enum class Kind { kBackTo, kFreeOpening, kFreeWall, kFreeRegion, kFreeSide };
  Kind kind = Kind::kFreeRegion;
  std::string of;  // the opening ("door"), the wall's word, the thing by its name; empty: what was named last
  RoomRegion region = RoomRegion::kMiddle;
  std::vector<Side> sides;  // kFreeSide
  double depth = 0;         // metres; kFreeSide
  std::size_t first = 0;    // where it is said: a place in the prompt
  std::string words;
};

// "Nothing in front of the window", "keep the middle free", "a metre all round it", "nobody with the back to the door": read before
// phrases are looked for, the words are marked in `skip`.
std::vector<Ban> read_bans(const Lexicon& lexicon, const Document& document, std::vector<bool>& skip);

// … as relations of the things that are there.
void add_bans(const Lexicon& lexicon, Document& document, const std::vector<Ban>& bans, SceneGraph& scene);

}  // namespace layoutbox::offline
