// The paper's relations: scenes in which each can hold, and scenes in which it cannot.
#include "examples.h"

namespace layoutbox::placement {

std::vector<Example> paper_examples() {
  return {
      {"offset",
       [](SceneMaker& s) {
         s.add("desk").add("bed").relate("offset", {"desk_1"}, {"bed_1"}, with([](auto& p) { p.axis = Axis::kX, p.distance = 450; }));
       },
       [](SceneMaker& s) {
         s.add("desk").add("bed").relate("offset", {"desk_1"}, {"bed_1"}, with([](auto& p) { p.axis = Axis::kX, p.distance = 2500; }));
       }},
      {"align",
       [](SceneMaker& s) { s.add("desk").add("bed").relate("align", {"desk_1"}, {"bed_1"}, with([](auto& p) { p.axis = Axis::kY; })); },
       [](SceneMaker& s) {
         s.add("box").sized(600, 600, 600).add("crate").sized(600, 600, 600);
         s.relate("align", {"box_1"}, {"crate_1"}, with([](auto& p) { p.axis = Axis::kX; }));
         s.relate("offset", {"box_1"}, {"wall4"}, with([](auto& p) { p.axis = Axis::kX, p.distance = 0; }));
         s.relate("offset", {"crate_1"}, {"wall2"}, with([](auto& p) { p.axis = Axis::kX, p.distance = 0; }));
       }},
      {"inside", [](SceneMaker& s) { s.add("rug").sized(2000, 2000, 10).add("chair").relate("inside", {"chair_1"}, {"rug_1"}); },
       [](SceneMaker& s) { s.add("rug").sized(300, 300, 10).add("chair").sized(500, 500, 800).relate("inside", {"chair_1"}, {"rug_1"}); }},
      {"groupAlign",
       [](SceneMaker& s) {
         s.add("stool", 3).relate("groupAlign", {"stool_1", "stool_2", "stool_3"}, {}, with([](auto& p) { p.axis = Axis::kX; }));
       },
       [](SceneMaker& s) {
         s.add("stool", 2).relate("groupAlign", {"stool_1", "stool_2"}, {}, with([](auto& p) { p.axis = Axis::kY; }));
         s.relate("offset", {"stool_1"}, {"wall1"}).relate("offset", {"stool_2"}, {"wall3"});
       }},
  };
}

}  // namespace layoutbox::placement
