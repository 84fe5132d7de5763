// Height: scenes in which each can hold, and scenes in which it cannot.
#include "examples.h"

namespace layoutbox::placement {

std::vector<Example> height_examples() {
  return {
      {"on", [](SceneMaker& s) { s.add("desk").add("table_lamp").relate("on", {"table_lamp_1"}, {"desk_1"}); },
       [](SceneMaker& s) {
         s.add("desk")
             .add("table_lamp")
             .relate("on", {"table_lamp_1"}, {"desk_1"})
             .relate("distance", {"table_lamp_1"}, {"desk_1"}, with([](auto& p) { p.min = 500; }));
       }},
      {"under", [](SceneMaker& s) { s.add("table").add("rug").relate("under", {"rug_1"}, {"table_1"}); },
       [](SceneMaker& s) { s.add("table").add("wardrobe").relate("under", {"wardrobe_1"}, {"table_1"}); }},
      {"above", [](SceneMaker& s) { s.add("sofa").add("painting").relate("above", {"painting_1"}, {"sofa_1"}); },
       [](SceneMaker& s) {
         s.add("wardrobe").sized(1000, 600, 2400).add("painting").sized(600, 40, 600).relate("above", {"painting_1"}, {"wardrobe_1"});
       }},
      {"in", [](SceneMaker& s) { s.add("bookshelf").add("book").relate("in", {"book_1"}, {"bookshelf_1"}); },
       [](SceneMaker& s) {
         s.add("chest").sized(600, 400, 400).add("wardrobe").sized(1000, 600, 2000).relate("in", {"wardrobe_1"}, {"chest_1"});
       }},
      {"stacked",
       [](SceneMaker& s) {
         s.add("box", 3).relate("stacked", {"box_1", "box_2", "box_3"});
       },
       [](SceneMaker& s) {
         s.add("crate", 3);
         for (SceneObject& o : s.raw().objects) o.size = SizeRange{{800, 800, 1000}, {800, 800, 1000}, {800, 800, 1000}};
         s.relate("stacked", {"crate_1", "crate_2", "crate_3"});
       }},
  };
}

}  // namespace layoutbox::placement
