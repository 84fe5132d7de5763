// Height: just held, and the move that breaks them.
#include "limits.h"

namespace layoutbox::checks {

std::vector<Limit> height_limits() {
  return {
      {"on",
       Type::kOn,
       [](TestRoom& r) {
         table(r).add("vase", "vase", {0.2, 0.2, 0.3}, {2.5, 2.4, 0.75}, "table").relation(Type::kOn, {"vase"}, {"table"});
       },
       {"vase", {0, 0, 0.02}},
       false},
      {"on the left part",
       Type::kOn,
       [](TestRoom& r) {
         r.add("desk", "desk", {1.2, 0.6, 0.75}, {2, 3.7}).add("lamp", "table_lamp", {0.2, 0.2, 0.4}, {2.0, 3.7, 0.75}, "desk");
         r.relation(Type::kOn, {"lamp"}, {"desk"}, with([](auto& p) { p.part = PartWord::kLeft; }));
       },
       {"lamp", {0.02, 0}}},
      {"on the left corner",
       Type::kOn,
       [](TestRoom& r) {
         r.add("desk", "desk", {1.2, 0.6, 0.75}, {2, 3.7}).add("lamp", "table_lamp", {0.2, 0.2, 0.4}, {1.8, 3.8, 0.75}, "desk");
         r.relation(Type::kOn, {"lamp"}, {"desk"}, with([](auto& p) { p.part = {PartWord::kLeft, PartWord::kCorner}; }));
       },
       {"lamp", {0.02, 0}}},
      {"on a rug",
       Type::kOn,  // half extents 1.0 and 0.5: middles at most 1.0 − 0.25 apart
       [](TestRoom& r) {
         r.add("rug", "rug", {2, 1.4, 0.01}, {2, 2})
             .add("table", "coffee_table", {1, 0.6, 0.4}, {2.75, 2})
             .relation(Type::kOn, {"table"}, {"rug"});
       },
       {"table", {0.02, 0}}},
      {"on the floor", Type::kOn, [](TestRoom& r) { bed(r).relation(Type::kOn, {"bed"}, {"floor"}); }, {"bed", {0, 0, 0.02}}},
      {"on a sill",
       Type::kOn,
       [](TestRoom& r) {
         r.window("window1", "wall3", 2)
             .add("pot", "plant", {0.2, 0.2, 0.3}, {2.4, 3.9, 0.9}, "window1")
             .relation(Type::kOn, {"pot"}, {"window1"});
       },
       {"pot", {0, 0, 0.02}}},
      {"under",
       Type::kUnder,
       [](TestRoom& r) {
         table(r).add("rug", "rug", {2.4, 1.6, 0.01}, {3.3, 2}).relation(Type::kUnder, {"rug"}, {"table"});
       },
       {"rug", {0.02, 0}}},
      {"above",
       Type::kAbove,
       [](TestRoom& r) {
         bed(r)
             .add("picture", "painting", {0.8, 0.04, 0.5}, {2.5, 3.98, 1.2}, "wall3")
             .relation(Type::kAbove, {"picture"}, {"bed"}, with([](auto& p) { p.gap = 700; }));
       },
       {"picture", {0, 0, 0.02}}},
      {"above, off to the side",
       Type::kAbove,  // half extents 0.9 and 0.4: middles at most 0.7 apart
       [](TestRoom& r) {
         bed(r).add("picture", "painting", {0.8, 0.04, 0.5}, {3.2, 3.98, 1.2}, "wall3").relation(Type::kAbove, {"picture"}, {"bed"});
       },
       {"picture", {0.02, 0}}},
      {"in",
       Type::kIn,
       [](TestRoom& r) {
         r.add("shelf", "bookshelf", {1.0, 0.3, 1.8}, {2, 3.85})
             .space("middle", {-0.48, -0.15, 0.8}, {0.48, 0.14, 1.2})
             .add("book", "book", {0.2, 0.2, 0.25}, {2, 3.8, 0.8}, "shelf");
         r.relation(Type::kIn, {"book"}, {"shelf"}, with([](auto& p) { p.part = ThingPart("middle"); }));
       },
       {"book", {0, -0.02}}},
      {"stacked",
       Type::kStacked,
       [](TestRoom& r) {
         r.add("a", "box", kStand, {2, 2})
             .add("b", "box", {0.3, 0.3, 0.3}, {2, 2, 0.5}, "a")
             .add("c", "box", {0.2, 0.2, 0.2}, {2, 2, 0.8}, "b");
         r.relation(Type::kStacked, {"a", "b", "c"});
       },
       {"c", {0, 0, 0.02}}},
  };
}

}  // namespace layoutbox::checks
