// The small form that every relation is compiled to, and from which the search, the CP-SAT model and the conflict's assumptions are
// all derived: a conjunction of formulas; a formula is a disjunction of cases; a case is a conjunction of linear inequalities over
// the edges of boxes, under conditions on the states (turn and size) of items. See docs/solve.md.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "layoutbox/solve/model/geometry.h"
#include "layoutbox/solve/model/ids.h"

namespace layoutbox::placement {

// What of an item a term counts: its position (the low corner of its box), the extents of its box in its state, and from
// kFirstConstant on further lengths that depend on its state only (the floor of a space, the middle of a seat).
enum Quantity : std::int16_t { kPositionX, kPositionY, kPositionZ, kExtentX, kExtentY, kExtentZ, kFirstConstant };

struct Term {
  std::int32_t coefficient = 0;
  ItemId item;
  std::int16_t quantity = kPositionX;
};

// Σ coefficient · quantity + constant.
struct Linear {
  std::vector<Term> terms;
  std::int64_t constant = 0;
  std::int32_t scale = 1;  // of a requirement: so much is a millimetre, where somebody asks how far it is from holding

  Linear() = default;
  Linear(std::int64_t value) : constant(value) {}  // NOLINT: a number is a linear form
};

Linear operator+(Linear a, const Linear& b);
Linear operator-(Linear a, const Linear& b);
Linear operator*(std::int32_t factor, Linear a);

// Edges of an item's box along an axis; `mid2` is twice its middle, so that halves stay whole numbers.
Linear lo(ItemId item, int axis);
Linear hi(ItemId item, int axis);
Linear extent(ItemId item, int axis);
Linear mid2(ItemId item, int axis);
Linear constant_of(ItemId item, int quantity);
// The edge towards a direction, and how far towards it the item reaches: sign · edge.
Linear reach(ItemId item, Direction towards);

// How many millimetres a requirement of that scale is from holding, whose form has that value; 0 or less: it holds.
inline std::int64_t missing(std::int64_t value, std::int32_t scale) { return scale == 1 ? -value : (scale - 1 - value) / scale; }

// The item's state is one of those in the mask.
struct StateLiteral {
  ItemId item;
  std::uint64_t states = 0;
};

// A wish within a case: |form| should be small. Costs weight points per 1000 · scale of it.
struct Preference {
  Linear form;
  std::int32_t weight = 1;
  std::int32_t scale = 1;  // 2 for forms made of mid2
};

struct Case {
  std::vector<StateLiteral> states;
  std::vector<Linear> at_least_zero;
  std::vector<Preference> wishes;
  bool turned = false;     // right for things at odd angles too, whatever its relation
  std::int32_t price = 0;  // points for choosing this case rather than another

  Case& when(ItemId item, std::uint64_t mask) { return states.push_back({item, mask}), *this; }
  Case& require(Linear form, std::int32_t scale = 1) {
    form.scale = scale;
    return at_least_zero.push_back(std::move(form)), *this;
  }
  // |form| <= tolerance
  Case& require_small(const Linear& form, Mm tolerance);
  Case& wish(Linear form, int weight, int scale = 1) { return wishes.push_back({std::move(form), weight, scale}), *this; }
};

// What a formula is read for: what is enough (placing) or what is needed (proving).
enum class Purpose { kPlacing, kProving };

// One of the cases holds. No case at all: it can never hold.
//
// Some meanings are not linear (distances), or have too many ways to write down (orders of many things). Then the cases are sufficient:
// what they allow is right, but they do not allow all that is; and `outer` is necessary: it is met wherever the meaning is. The search
// and `held` go by the cases, a proof that something cannot be by `outer`.
struct Formula {
  std::vector<Case> cases;
  bool exact = true;          // the cases are the meaning itself
  std::vector<Case> outer;    // where not exact; none: nothing is known to be necessary
  std::vector<ItemId> items;  // all that it speaks of; filled by build_model
  Case& add() { return cases.emplace_back(); }
  Case& add_outer() {
    exact = false;
    return outer.emplace_back();
  }
};

enum class Firmness {
  kAlways,   // mounts, supports: what makes it a layout at all
  kHard,     // asked for
  kImplied,  // hard by implication: given up before anything that was asked for
  kSoft,     // wished for
};

// All formulas that one relation (or one rule of ours) stands for.
struct Constraint {
  std::string name;     // the relation's id, or what it is: "habit: sofa_1 back to wall"
  RelationId relation;  // in the scene; none where it is a rule of ours
  Firmness firmness = Firmness::kHard;
  std::int32_t weight = 100;  // soft: points per metre missed; hard: the price of giving it up
  std::vector<Formula> formulas;
  std::vector<std::pair<ItemId, Mm>> reach;  // items to which somebody so wide must find a way; checked on layouts, not linear
  std::vector<ItemId> hosts;                 // habits: the items that are to be placed first
  std::string words;                         // what it says, where it is no relation of the scene: "the bed stays where it was"
  bool stay = false;                         // how far something is from its earlier place: no part of the score
  ItemId formation, member;  // the place of that item in the formation that the first of them leads; its cases are in one order
};

}  // namespace layoutbox::placement
