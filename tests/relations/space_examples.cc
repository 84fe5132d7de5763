// Space: scenes in which each can hold, and scenes in which it cannot.
#include "examples.h"

namespace layoutbox::placement {

std::vector<Example> space_examples() {
  return {
      {"clearance",
       [](SceneMaker& s) { s.add("wardrobe").add("bed").relate("clearance", {"wardrobe_1"}, {}, with([](auto& p) { p.depth = 900; })); },
       [](SceneMaker& s) { s.add("wardrobe").relate("clearance", {"wardrobe_1"}, {}, with([](auto& p) { p.depth = 2900; })); }},
      {"reachable", [](SceneMaker& s) { s.opening(OpeningType::kDoor, "wall1", 300).add("bed").relate("reachable", {"bed_1"}); },
       [](SceneMaker& s) {
         s.opening(OpeningType::kDoor, "wall1", 300)
             .add("bed")
             .sized(900, 1000, 500)
             .relate("reachable", {"bed_1"})
             .relate("corner", {"bed_1"}, {"wall2", "wall3"});
         s.add("cabinet").sized(2000, 400, 2000).at(2000, 1600, 0, 0, true).add("cabinet").sized(1000, 400, 2000).at(500, 1600, 0, 0, true);
       }},
      {"keepClear",
       [](SceneMaker& s) { s.add("sofa").relate("keepClear", {"sofa_1"}, {}, with([](auto& p) { p.region = RoomRegion::kMiddle; })); },
       [](SceneMaker& s) {
         s.add("table")
             .sized(800, 800, 750)
             .relate("keepClear", {"table_1"}, {}, with([](auto& p) { p.region = RoomRegion::kMiddle; }))
             .relate("centerOfRoom", {"table_1"});
       }},
  };
}

}  // namespace layoutbox::placement
