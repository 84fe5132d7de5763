// Groups: scenes in which each can hold, and scenes in which it cannot.
#include "examples.h"

namespace layoutbox::placement {

std::vector<Example> group_examples() {
  return {
      {"around",
       [](SceneMaker& s) {
         s.add("dining_table")
             .add("dining_chair", 4)
             .relate("around", {"dining_chair_1", "dining_chair_2", "dining_chair_3", "dining_chair_4"}, {"dining_table_1"});
       },
       [](SceneMaker& s) {
         s.add("table")
             .add("chair", 2)
             .relate("around", {"chair_1", "chair_2"}, {"table_1"})
             .relate("distance", {"chair_1"}, {"table_1"}, with([](auto& p) { p.min = 700; }));
       }},
      {"eachSideOf",
       [](SceneMaker& s) {
         s.add("bed").add("nightstand", 2).relate("eachSideOf", {"nightstand_1", "nightstand_2"}, {"bed_1"});
       },
       [](SceneMaker& s) {
         s.add("bed").add("nightstand", 2).relate("eachSideOf", {"nightstand_1", "nightstand_2"}, {"bed_1"});
         s.relate("sideAgainstWall", {"bed_1"}, {"wall4"}, with([](auto& p) { p.side = Side::kLeft; }));
       }},
      {"between",
       [](SceneMaker& s) {
         s.add("armchair", 2).add("side_table").relate("between", {"side_table_1"}, {"armchair_1", "armchair_2"});
       },
       [](SceneMaker& s) {
         s.add("armchair", 2)
             .add("side_table")
             .relate("between", {"side_table_1"}, {"armchair_1", "armchair_2"})
             .relate("touching", {"armchair_1"}, {"armchair_2"});
       }},
      {"row",
       [](SceneMaker& s) {
         s.add("stool", 3).relate("row", {"stool_1", "stool_2", "stool_3"});
       },
       [](SceneMaker& s) {
         s.add("table", 4);
         for (SceneObject& o : s.raw().objects) o.size = SizeRange{{900, 900, 700}, {900, 900, 700}, {900, 900, 700}};
         s.relate("row", {"table_1", "table_2", "table_3", "table_4"});
       }},
      {"grid",
       [](SceneMaker& s) {
         s.add("stool", 6).relate("grid", {"stool_1", "stool_2", "stool_3", "stool_4", "stool_5", "stool_6"}, {}, with([](auto& p) {
                                    p.columns = 3;
                                  }));
       },
       [](SceneMaker& s) {
         s.add("table", 3);
         for (SceneObject& o : s.raw().objects) o.size = SizeRange{{1050, 1050, 700}, {1050, 1050, 700}, {1050, 1050, 700}};
         s.relate("grid", {"table_1", "table_2", "table_3"}, {}, with([](auto& p) { p.columns = 3; }));
       }},
      {"column",
       [](SceneMaker& s) {
         s.add("stool", 3).relate("column", {"stool_1", "stool_2", "stool_3"});
       },
       [](SceneMaker& s) {
         s.add("stool", 2)
             .relate("column", {"stool_1", "stool_2"})
             .relate("offset", {"stool_1"}, {"wall4"})
             .relate("offset", {"stool_2"}, {"wall2"});
       }},
      {"evenlySpaced",
       [](SceneMaker& s) {
         s.add("plant", 3).relate("evenlySpaced", {"plant_1", "plant_2", "plant_3"});
       },
       [](SceneMaker& s) {
         s.add("stool", 3);
         for (SceneObject& o : s.raw().objects) o.size = SizeRange{{400, 400, 450}, {400, 400, 450}, {400, 400, 450}};
         s.relate("evenlySpaced", {"stool_1", "stool_2", "stool_3"}, {}, with([](auto& p) { p.axis = Axis::kX; }));
         s.relate("offset", {"stool_1"}, {"wall4"})
             .relate("offset", {"stool_2"}, {"wall4"}, with([](auto& p) { p.distance = 400; }))
             .relate("offset", {"stool_3"}, {"wall2"});
       }},
      {"symmetricAbout",
       [](SceneMaker& s) {
         s.add("bed").add("floor_lamp", 2).relate("symmetricAbout", {"floor_lamp_1", "floor_lamp_2"}, {"bed_1"});
       },
       [](SceneMaker& s) {
         s.add("bed")
             .add("plant", 2)
             .relate("symmetricAbout", {"plant_1", "plant_2"}, {"bed_1"})
             .relate("leftOf", {"plant_1"}, {"bed_1"})
             .relate("leftOf", {"plant_2"}, {"bed_1"});
       }},
      {"surround",
       [](SceneMaker& s) {
         s.add("table").add("chair", 3).relate("surround", {"chair_1", "chair_2", "chair_3"}, {"table_1"});
       },
       [](SceneMaker& s) {
         s.add("table")
             .add("chair", 4)  // three stand at odd angles, of which nothing is proven
             .relate("surround", {"chair_1", "chair_2", "chair_3", "chair_4"}, {"table_1"})
             .relate("distance", {"chair_1"}, {"table_1"}, with([](auto& p) { p.min = 700; }));
       }},
      {"pairedWith",
       [](SceneMaker& s) {
         s.add("desk", 2).add("chair", 2).relate("pairedWith", {"chair_1", "chair_2"}, {"desk_1", "desk_2"});
       },
       [](SceneMaker& s) {
         s.add("desk", 2).add("chair").relate("pairedWith", {"chair_1"}, {"desk_1", "desk_2"});
       }},
  };
}

}  // namespace layoutbox::placement
