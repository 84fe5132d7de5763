// The paper's relations: just held, and the move that breaks them.
#include "limits.h"

namespace layoutbox::checks {

std::vector<Limit> paper_limits() {
  return {
      {"offset",
       Type::kOffset,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.75}, {1.1, 0.8}).relation(Type::kOffset, {"desk"}, {"bed"}, with([](auto& p) {
                                                                           p.axis = Axis::kY, p.distance = 900;
                                                                         }));
       },
       {"desk", {0, 0.02}}},
      {"offset from a wall of the middle",
       Type::kOffset,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.75}, {0.8, 1}).relation(Type::kOffset, {"desk"}, {"wall4"}, with([](auto& p) {
                                                                    p.distance = 800, p.edge = Edge::kCenter;
                                                                  }));
       },
       {"desk", {0.02, 0}}},
      {"offset from a wall",
       Type::kOffset,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.75}, {0.8, 1}).relation(Type::kOffset, {"desk"}, {"wall4"}, with([](auto& p) {
                                                                    p.distance = 300;
                                                                  }));
       },
       {"desk", {0.02, 0}}},
      {"offset from the end of a wall",
       Type::kOffset,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.75}, {1, 1.6}).relation(Type::kOffset, {"desk"}, {"wall2"}, with([](auto& p) {
                                                                    p.axis = Axis::kY, p.distance = 1300;
                                                                  }));
       },
       {"desk", {0, 0.02}}},
      {"align",
       Type::kAlign,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.75}, {2.5, 1}).relation(Type::kAlign, {"desk"}, {"bed"}, with_axis(Axis::kX));
       },
       {"desk", {0.02, 0}}},
      {"align by edge",
       Type::kAlign,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.75}, {2.2, 1}).relation(Type::kAlign, {"desk", "bed"}, {}, with([](auto& p) {
                                                                         p.edge = Edge::kLeft;
                                                                       }));
       },
       {"desk", {0.02, 0}}},
      {"inside",
       Type::kInside,
       [](TestRoom& r) {
         r.add("rug", "rug", {2, 1.4, 0.01}, {2, 2}).add("chair", "chair", kChair, {2.8, 2}).relation(Type::kInside, {"chair"}, {"rug"});
       },
       {"chair", {0.02, 0}}},
      {"inside the room",
       Type::kInside,
       [](TestRoom& r) {
         r.add("chair", "chair", kChair, {0.203, 2}).relation(Type::kInside, {"chair"});
       },
       {"chair", {-0.02, 0}}},
      {"groupAlign",
       Type::kGroupAlign,
       [](TestRoom& r) {
         r.add("a", "chair", kChair, {1, 1}).add("b", "chair", kChair, {2, 1}).add("c", "chair", kChair, {3, 1});
         r.relation(Type::kGroupAlign, {"a", "b", "c"}, {}, with_axis(Axis::kY));
       },
       {"b", {0, 0.02}}},
  };
}

}  // namespace layoutbox::checks
