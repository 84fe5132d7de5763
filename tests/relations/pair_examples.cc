// Two objects: scenes in which each can hold, and scenes in which it cannot.
#include "examples.h"

namespace layoutbox::placement {

std::vector<Example> pair_examples() {
  return {
      {"leftOf", [](SceneMaker& s) { s.add("bed").add("nightstand").relate("leftOf", {"nightstand_1"}, {"bed_1"}); },
       [](SceneMaker& s) {
         s.add("bed").add("nightstand").relate("leftOf", {"nightstand_1"}, {"bed_1"}).relate("rightOf", {"nightstand_1"}, {"bed_1"});
       }},
      {"rightOf", [](SceneMaker& s) { s.add("sofa").add("floor_lamp").relate("rightOf", {"floor_lamp_1"}, {"sofa_1"}); },
       [](SceneMaker& s) {
         s.add("bed").add("nightstand").relate("rightOf", {"nightstand_1"}, {"bed_1"}).relate("inFrontOf", {"nightstand_1"}, {"bed_1"});
       }},
      {"inFrontOf", [](SceneMaker& s) { s.add("sofa").add("coffee_table").relate("inFrontOf", {"coffee_table_1"}, {"sofa_1"}); },
       [](SceneMaker& s) {
         s.add("sofa").add("plant").relate("inFrontOf", {"plant_1"}, {"sofa_1"}).relate("behind", {"plant_1"}, {"sofa_1"});
       }},
      {"behind", [](SceneMaker& s) { s.add("sofa").add("console_table").relate("behind", {"console_table_1"}, {"sofa_1"}); },
       [](SceneMaker& s) {
         s.add("sofa").add("desk").relate("behind", {"desk_1"}, {"sofa_1"}).relate("againstWall", {"sofa_1"}, {"wall3"});
       }},
      {"nextTo", [](SceneMaker& s) { s.add("desk").add("chair").relate("nextTo", {"chair_1"}, {"desk_1"}); },
       [](SceneMaker& s) {
         s.add("desk").add("chair").relate("nextTo", {"chair_1"}, {"desk_1"}).relate("distance", {"chair_1"}, {"desk_1"}, with([](auto& p) {
                                                                                       p.min = 700;
                                                                                     }));
       }},
      {"near", [](SceneMaker& s) { s.add("sofa").add("armchair").relate("near", {"armchair_1"}, {"sofa_1"}); },
       [](SceneMaker& s) {
         s.add("desk").add("chair").relate("near", {"chair_1"}, {"desk_1"}).relate("nextTo", {"chair_1"}, {"desk_1"}, with([](auto& p) {
                                                                                     p.max = 300;
                                                                                   }));
       }},
      {"far",
       [](SceneMaker& s) { s.add("chair").add("plant").relate("far", {"plant_1"}, {"chair_1"}, with([](auto& p) { p.min = 3000; })); },
       [](SceneMaker& s) { s.add("desk").add("chair").relate("far", {"chair_1"}, {"desk_1"}, with([](auto& p) { p.min = 4000; })); }},
      {"distance",
       [](SceneMaker& s) {
         s.add("sofa").add("tv_stand").relate("distance", {"tv_stand_1"}, {"sofa_1"}, with([](auto& p) { p.min = 1800, p.max = 2200; }));
       },
       [](SceneMaker& s) { s.add("desk").add("chair").relate("distance", {"chair_1"}, {"desk_1"}, with([](auto& p) { p.min = 3500; })); }},
      {"touching", [](SceneMaker& s) { s.add("bed").add("bench").relate("touching", {"bench_1"}, {"bed_1"}); },
       [](SceneMaker& s) {
         s.add("bed").add("bench").relate("touching", {"bench_1"}, {"bed_1"}).relate("distance", {"bench_1"}, {"bed_1"}, with([](auto& p) {
                                                                                       p.min = 500;
                                                                                     }));
       }},
      {"edgeAlign",
       [](SceneMaker& s) {
         s.add("bed").add("nightstand").relate("edgeAlign", {"nightstand_1"}, {"bed_1"}, with([](auto& p) { p.edge = Edge::kBack; }));
       },
       [](SceneMaker& s) {
         s.add("bed")
             .add("nightstand")
             .relate("edgeAlign", {"nightstand_1"}, {"bed_1"}, with([](auto& p) { p.edge = Edge::kBack; }))
             .relate("inFrontOf", {"nightstand_1"}, {"bed_1"});
       }},
      {"facing", [](SceneMaker& s) { s.add("tv_stand").add("sofa").relate("facing", {"sofa_1"}, {"tv_stand_1"}); },
       [](SceneMaker& s) { s.add("sofa").relate("facing", {"sofa_1"}, {"wall1"}).relate("facing", {"sofa_1"}, {"wall3"}); }},
      {"opposite", [](SceneMaker& s) { s.add("sofa").add("armchair").relate("opposite", {"armchair_1"}, {"sofa_1"}); },
       [](SceneMaker& s) {
         s.add("sofa").add("armchair").relate("opposite", {"armchair_1"}, {"sofa_1"}).relate("nextTo", {"armchair_1"}, {"sofa_1"});
       }},
      {"parallel", [](SceneMaker& s) { s.add("desk").add("bed").relate("parallel", {"desk_1"}, {"bed_1"}); },
       [](SceneMaker& s) {
         s.add("desk")
             .add("bed")
             .relate("parallel", {"desk_1"}, {"bed_1"})
             .relate("againstWall", {"desk_1"}, {"wall1"})
             .relate("againstWall", {"bed_1"}, {"wall2"});
       }},
      {"perpendicular", [](SceneMaker& s) { s.add("desk").add("bed").relate("perpendicular", {"desk_1"}, {"bed_1"}); },
       [](SceneMaker& s) {
         s.add("desk").add("bed").relate("perpendicular", {"desk_1"}, {"bed_1"}).relate("parallel", {"desk_1"}, {"bed_1"});
       }},
      {"sameOrientation", [](SceneMaker& s) { s.add("chair", 2).relate("sameOrientation", {"chair_1"}, {"chair_2"}); },
       [](SceneMaker& s) {
         s.add("chair", 2)
             .relate("sameOrientation", {"chair_1"}, {"chair_2"})
             .relate("facing", {"chair_1"}, {"wall1"})
             .relate("facing", {"chair_2"}, {"wall3"});
       }},
      {"centeredOn", [](SceneMaker& s) { s.add("coffee_table").add("rug").relate("centeredOn", {"rug_1"}, {"coffee_table_1"}); },
       [](SceneMaker& s) {
         s.add("desk")
             .add("table_lamp")
             .relate("centeredOn", {"table_lamp_1"}, {"desk_1"})
             .relate("on", {"table_lamp_1"}, {"desk_1"}, with([](auto& p) {
                       p.part = {PartWord::kLeft, PartWord::kCorner};
                     }));
       }},
      {"atFootOf", [](SceneMaker& s) { s.add("bed").add("bench").relate("atFootOf", {"bench_1"}, {"bed_1"}); },
       [](SceneMaker& s) {
         s.add("bed").add("bench").relate("atFootOf", {"bench_1"}, {"bed_1"}).relate("atHeadOf", {"bench_1"}, {"bed_1"});
       }},
      {"atHeadOf", [](SceneMaker& s) { s.add("bed").add("nightstand").relate("atHeadOf", {"nightstand_1"}, {"bed_1"}); },
       [](SceneMaker& s) {
         s.add("bed")
             .add("nightstand")
             .relate("atHeadOf", {"nightstand_1"}, {"bed_1"})
             .relate("distance", {"nightstand_1"}, {"bed_1"}, with([](auto& p) { p.min = 700; }));
       }},
      {"alongSide", [](SceneMaker& s) { s.add("dining_table").add("bench").relate("alongSide", {"bench_1"}, {"dining_table_1"}); },
       [](SceneMaker& s) {
         s.add("dining_table").add("bench").relate("alongSide", {"bench_1"}, {"dining_table_1"});
         s.relate("distance", {"bench_1"}, {"dining_table_1"}, with([](auto& p) { p.min = 700; }));
       }},
      {"tuckedUnder", [](SceneMaker& s) { s.add("desk").add("chair").relate("tuckedUnder", {"chair_1"}, {"desk_1"}); },
       [](SceneMaker& s) { s.add("chest").add("chair").relate("tuckedUnder", {"chair_1"}, {"chest_1"}); }},
  };
}

}  // namespace layoutbox::placement
