// Object and opening: scenes in which each can hold, and scenes in which it cannot.
#include "examples.h"

namespace layoutbox::placement {

std::vector<Example> opening_examples() {
  return {
      {"underWindow",
       [](SceneMaker& s) { s.opening(OpeningType::kWindow, "wall3", 1500, 1200, 900, 1200).add("desk").relate("underWindow", {"desk_1"}); },
       [](SceneMaker& s) {
         s.opening(OpeningType::kWindow, "wall3", 900, 1200, 900, 1200)
             .add("wardrobe")
             .sized(1000, 600, 2000)
             .relate("underWindow", {"wardrobe_1"});
       }},
      {"nearDoor", [](SceneMaker& s) { s.opening(OpeningType::kDoor, "wall1", 300).add("coat_rack").relate("nearDoor", {"coat_rack_1"}); },
       [](SceneMaker& s) {
         s.opening(OpeningType::kDoor, "wall1", 300)
             .add("plant")
             .relate("nearDoor", {"plant_1"}, {}, with([](auto& p) { p.max = 500; }))
             .relate("farFromDoor", {"plant_1"}, {}, with([](auto& p) { p.min = 1500; }));
       }},
      {"nearWindow",
       [](SceneMaker& s) {
         s.opening(OpeningType::kWindow, "wall2", 900, 1200, 900, 1200).add("armchair").relate("nearWindow", {"armchair_1"});
       },
       [](SceneMaker& s) {
         s.opening(OpeningType::kWindow, "wall3", 900, 1200, 900, 1200)
             .add("plant")
             .relate("nearWindow", {"plant_1"}, {}, with([](auto& p) { p.max = 500; }));
         s.relate("farFromWindow", {"plant_1"}, {}, with([](auto& p) { p.min = 1500; }));
       }},
      {"farFromDoor", [](SceneMaker& s) { s.opening(OpeningType::kDoor, "wall1", 300).add("bed").relate("farFromDoor", {"bed_1"}); },
       [](SceneMaker& s) {
         s.opening(OpeningType::kDoor, "wall1", 300).add("bed").relate("farFromDoor", {"bed_1"}, {}, with([](auto& p) { p.min = 4000; }));
       }},
      {"farFromWindow",
       [](SceneMaker& s) {
         s.opening(OpeningType::kWindow, "wall3", 900, 1200, 900, 1200).add("tv_stand").relate("farFromWindow", {"tv_stand_1"});
       },
       [](SceneMaker& s) {
         s.opening(OpeningType::kWindow, "wall3", 900, 1200, 900, 1200).add("bed").relate("farFromWindow", {"bed_1"}, {}, with([](auto& p) {
                                                                                            p.min = 4000;
                                                                                          }));
       }},
      {"notBlocking",
       [](SceneMaker& s) { s.opening(OpeningType::kDoor, "wall1", 300).add("wardrobe").relate("notBlocking", {"wardrobe_1"}, {"door1"}); },
       [](SceneMaker& s) {
         s.opening(OpeningType::kDoor, "wall1", 300).add("chest").sized(500, 500, 500).relate("notBlocking", {"chest_1"}, {"door1"});
         s.relate("inFrontOf", {"chest_1"}, {"door1"}, with([](auto& p) { p.max = 300; }));
       }},
  };
}

}  // namespace layoutbox::placement
