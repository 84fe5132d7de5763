// Groups: just held, and the move that breaks them.
#include "limits.h"

namespace layoutbox::checks {

std::vector<Limit> group_limits() {
  return {
      {"around",
       Type::kAround,
       [](TestRoom& r) {
         table(r)
             .add("a", "chair", kChair, {2.5, 0.9, 0, 180})
             .add("b", "chair", kChair, {2.5, 2.7})
             .add("c", "chair", kChair, {1.4, 2, 0, 90});
         r.relation(Type::kAround, {"a", "b", "c"}, {"table"});
       },
       {"a", {0, -0.02}}},
      {"eachSideOf",
       Type::kEachSideOf,
       [](TestRoom& r) {
         bed(r).add("a", "nightstand", kStand, {1.5, 3.8}).add("b", "nightstand", kStand, {3.5, 3.8});
         r.relation(Type::kEachSideOf, {"a", "b"}, {"bed"});
       },
       {"a", {0.02, 0}}},
      {"between",
       Type::kBetween,
       [](TestRoom& r) {
         r.add("a", "armchair", kChair, {1, 2}).add("b", "armchair", kChair, {3, 2}).add("lamp", "floor_lamp", kStand, {1.4, 2});
         r.relation(Type::kBetween, {"lamp"}, {"a", "b"});
       },
       {"lamp", {-0.02, 0}}},
      {"between, off the way",
       Type::kBetween,
       [](TestRoom& r) {
         r.add("a", "armchair", kChair, {1, 2}).add("b", "armchair", kChair, {3, 2}).add("lamp", "floor_lamp", kStand, {2, 2.2});
         r.relation(Type::kBetween, {"lamp"}, {"a", "b"});
       },
       {"lamp", {0, 0.02}}},
      {"row",
       Type::kRow,
       [](TestRoom& r) {
         r.add("a", "stool", kStand, {1, 2}).add("b", "stool", kStand, {1.6, 2}).add("c", "stool", kStand, {2.2, 2});
         r.relation(Type::kRow, {"a", "b", "c"}, {}, with([](auto& p) { p.axis = Axis::kX, p.gap = 200; }));
       },
       {"c", {0.02, 0}}},
      {"row by its backs",
       Type::kRow,
       [](TestRoom& r) {
         r.add("a", "cabinet", {0.6, 0.6, 1}, {1, 3.7})
             .add("b", "cabinet", {0.6, 0.4, 1}, {1.6, 3.8})
             .add("c", "cabinet", {0.6, 0.3, 1}, {2.2, 3.85});
         r.relation(Type::kRow, {"a", "b", "c"});
       },
       {"b", {0, -0.02}}},
      {"grid",
       Type::kGrid,
       [](TestRoom& r) {
         for (int i = 0; i < 5; ++i) r.add("d" + std::to_string(i), "desk", {0.6, 0.6, 0.7}, {1 + 1.0 * (i % 3), 1 + 1.2 * (i / 3)});
         r.relation(Type::kGrid, {"d0", "d1", "d2", "d3", "d4"}, {}, with([](auto& p) { p.columns = 3; }));
       },
       {"d4", {0, 0.04}}},
      {"column",
       Type::kColumn,
       [](TestRoom& r) {
         r.add("a", "bench", {1, 0.4, 0.4}, {2, 1}).add("b", "bench", {1, 0.4, 0.4}, {2, 2}).relation(Type::kColumn, {"a", "b"});
       },
       {"b", {0.02, 0}}},
      {"evenlySpaced",
       Type::kEvenlySpaced,
       [](TestRoom& r) {
         r.add("a", "stool", kStand, {1, 2}).add("b", "bench", {0.8, 0.4, 0.4}, {2.0, 2.3}).add("c", "stool", kStand, {3.0, 1.5});
         r.relation(Type::kEvenlySpaced, {"a", "b", "c"});
       },
       {"b", {0.02, 0}}},
      {"evenlySpaced, spread as far along Y",
       Type::kEvenlySpaced,
       [](TestRoom& r) {
         r.add("a", "stool", kStand, {0.4, 1.81}).add("b", "stool", kStand, {1.1, 0.9}).add("c", "stool", kStand, {1.8, 0.41});
         r.relation(Type::kEvenlySpaced, {"a", "b", "c"});
       },
       {"b", {0.02, 0}}},
      {"symmetricAbout",
       Type::kSymmetricAbout,
       [](TestRoom& r) {
         bed(r)
             .add("a", "nightstand", kStand, {1.2, 3.8})
             .add("b", "nightstand", kStand, {3.8, 3.8})
             .relation(Type::kSymmetricAbout, {"a", "b"}, {"bed"});
       },
       {"b", {0.02, 0}}},
      {"surround",
       Type::kSurround,  // three: neighbours at most 180° apart
       [](TestRoom& r) {
         r.add("table", "table", {1, 1, 0.7}, {2.5, 2})
             .add("a", "chair", kChair, {3.3, 2, 0, 270})
             .add("b", "chair", kChair, {2.5, 2.8})
             .add("c", "chair", kChair, {1.7, 1.99, 0, 90});
         r.relation(Type::kSurround, {"a", "b", "c"}, {"table"});
       },
       {"c", {0, 0.1}},
       false},
      {"pairedWith",
       Type::kPairedWith,
       [](TestRoom& r) {
         r.add("d1", "desk", {1, 0.6, 0.7}, {1, 3})
             .add("d2", "desk", {1, 0.6, 0.7}, {3.5, 3})
             .add("c1", "chair", kChair, {1, 2.4})
             .add("c2", "chair", kChair, {3.5, 2.0});
         r.relation(Type::kPairedWith, {"c1", "c2"}, {"d1", "d2"});
       },
       {"c2", {0, -0.02}},
       false},
      {"surround, one too far",
       Type::kSurround,
       [](TestRoom& r) {
         r.add("table", "table", {1, 1, 0.7}, {2.5, 2}).add("a", "chair", kChair, {2.5, 1.2, 0, 180}).add("b", "chair", kChair, {2.5, 2.8});
         r.relation(Type::kSurround, {"a", "b"}, {"table"});
       },
       {"a", {0, -0.48}}},
      {"pairedWith, well within reach",
       Type::kPairedWith,
       [](TestRoom& r) {
         r.add("d1", "desk", {1, 0.6, 0.7}, {1, 3}).add("d2", "desk", {1, 0.6, 0.7}, {3.5, 3});
         r.add("c1", "chair", kChair, {1, 2.4}).add("c2", "chair", kChair, {3.5, 2.2});
         r.relation(Type::kPairedWith, {"c1", "c2"}, {"d1", "d2"});
       },
       {"c2", {0, -0.22}}},
  };
}

}  // namespace layoutbox::checks
