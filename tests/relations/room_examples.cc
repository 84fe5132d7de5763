// Object and room: scenes in which each can hold, and scenes in which it cannot.
#include "examples.h"

namespace layoutbox::placement {

std::vector<Example> room_examples() {
  return {
      {"againstWall", [](SceneMaker& s) { s.add("bed").relate("againstWall", {"bed_1"}, {"wall2"}); },
       [](SceneMaker& s) {
         s.add("wardrobe", 2).sized(1800, 600, 2000).relate("againstWall", {"wardrobe_1", "wardrobe_2"}, {"wall3"});
         s.raw().objects[0].size = s.raw().objects[1].size;
       }},
      {"sideAgainstWall",
       [](SceneMaker& s) { s.add("bed").relate("sideAgainstWall", {"bed_1"}, {"wall2"}, with([](auto& p) { p.side = Side::kLeft; })); },
       [](SceneMaker& s) {
         s.add("bed").sized(1400, 2000, 500).relate("sideAgainstWall", {"bed_1"}, {"wall4"}, with([](auto& p) { p.side = Side::kLeft; }));
         s.relate("sideAgainstWall", {"bed_1"}, {"wall2"}, with([](auto& p) { p.side = Side::kRight; }));
       }},
      {"corner",
       [](SceneMaker& s) {
         s.add("plant").relate("corner", {"plant_1"}, {"wall2", "wall3"});
       },
       [](SceneMaker& s) {
         s.add("plant").relate("corner", {"plant_1"}).relate("awayFromWall", {"plant_1"}, {}, with([](auto& p) { p.min = 800; }));
       }},
      {"centerOfRoom", [](SceneMaker& s) { s.add("table").relate("centerOfRoom", {"table_1"}); },
       [](SceneMaker& s) { s.add("table").sized(800, 800, 750).relate("centerOfRoom", {"table_1"}).relate("corner", {"table_1"}); }},
      {"centeredOnWall", [](SceneMaker& s) { s.add("wardrobe").relate("centeredOnWall", {"wardrobe_1"}, {"wall1"}); },
       [](SceneMaker& s) {
         s.add("wardrobe").add("desk").relate("centeredOnWall", {"wardrobe_1"}, {"wall3"}).relate("centeredOnWall", {"desk_1"}, {"wall3"});
       }},
      {"inRegion",
       [](SceneMaker& s) { s.add("desk").relate("inRegion", {"desk_1"}, {}, with([](auto& p) { p.region = RoomRegion::kLeft; })); },
       [](SceneMaker& s) {
         s.add("desk")
             .relate("inRegion", {"desk_1"}, {}, with([](auto& p) { p.region = RoomRegion::kLeft; }))
             .relate("againstWall", {"desk_1"}, {"wall2"});
       }},
      {"onWall", [](SceneMaker& s) { s.add("mirror").mounted(Mount::kWall).relate("onWall", {"mirror_1"}, {"wall4"}); },
       [](SceneMaker& s) {
         s.add("mirror").mounted(Mount::kWall).relate("onWall", {"mirror_1"}, {"wall4"}).relate("onWall", {"mirror_1"}, {"wall2"});
       }},
      {"onCeiling", [](SceneMaker& s) { s.add("pendant_lamp").relate("onCeiling", {"pendant_lamp_1"}); },
       [](SceneMaker& s) {
         s.add("mirror").mounted(Mount::kWall).relate("onCeiling", {"mirror_1"}).relate("onWall", {"mirror_1"}, {}, with([](auto& p) {
                                                                                          p.height = 900;
                                                                                        }));
       }},
      {"awayFromWall", [](SceneMaker& s) { s.add("sofa").relate("awayFromWall", {"sofa_1"}); },
       [](SceneMaker& s) { s.add("sofa").relate("awayFromWall", {"sofa_1"}, {}, with([](auto& p) { p.min = 1400; })); }},
  };
}

}  // namespace layoutbox::placement
