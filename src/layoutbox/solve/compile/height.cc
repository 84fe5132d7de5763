// Relations of height: on, under, above, in, stacked.
#include <array>
#include <initializer_list>
#include <utility>

#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/compile/support.h"

namespace layoutbox::placement {
namespace {

// The cases of one turn of the reference in which a thing is at a part of it that words name: halves, the middle, corners, edges.
class PartOfTop {
 public:
  PartOfTop(const Item& ref, ItemId t, ItemId r, int turn, std::uint64_t states) : ref_(ref), t_(t), r_(r), turn_(turn), cases_(1) {
    cases_[0].when(r, states);
  }

  void read(const ThingPart& part) {
    if (part.has(PartWord::kCenter)) keep_to_middle();
    for (const auto& [word, side] : {std::pair{PartWord::kLeft, Side::kLeft},
                                     {PartWord::kRight, Side::kRight},
                                     {PartWord::kFront, Side::kFront},
                                     {PartWord::kBack, Side::kBack}}) {
      if (!part.has(word)) continue;
      for (Case& c : cases_) half(c, side);
    }
    if (part.has(PartWord::kCorner)) {
      branch({Side::kLeft, Side::kRight}, 0);
      branch({Side::kBack, Side::kFront}, 20);
    }
    if (part.has(PartWord::kEnd)) branch({Side::kLeft, Side::kRight}, 0);
    if (part.has(PartWord::kEdge)) branch_by_side({Side::kBack, Side::kLeft, Side::kRight, Side::kFront});
  }

  std::vector<Case> take() { return std::move(cases_); }

 private:
  // Twice how far its middle is beyond the reference's.
  Linear beyond2(Direction d) const { return d.sign * mid2(t_, d.axis) - d.sign * mid2(r_, d.axis); }

  void keep_to_middle() {
    for (int axis = 0; axis < 2; ++axis) {
      const Linear off = mid2(t_, axis) - mid2(r_, axis);
      for (Case& c : cases_) c.require(extent(r_, axis) - 3 * off).require(extent(r_, axis) + 3 * off).wish(off, 100, 2);
    }
  }

  void half(Case& c, Side side) const {
    const Direction d = side_direction(ref_, side, turn_);
    c.require(beyond2(d)).wish(2 * beyond2(d) - extent(r_, d.axis), 40, 4);
  }

  void outer_third(Case& c, Side side) const {
    const Direction d = side_direction(ref_, side, turn_);
    c.require(3 * beyond2(d) - extent(r_, d.axis)).wish(reach(t_, d) - reach(r_, d) + Linear(60), 60);
  }

  // Each case so far at either side; the second costs so much more.
  void branch(std::array<Side, 2> either, int second_price) {
    std::vector<Case> more;
    for (const Case& c : cases_) {
      outer_third(more.emplace_back(c), either[0]);
      outer_third(more.emplace_back(c), either[1]);
      more.back().price += second_price;
    }
    cases_ = std::move(more);
  }

  void branch_by_side(std::initializer_list<Side> sides) {
    std::vector<Case> more;
    for (const Side side : sides) {
      for (const Case& c : cases_) outer_third(more.emplace_back(c), side);
    }
    cases_ = std::move(more);
  }

  const Item& ref_;
  ItemId t_, r_;
  int turn_;
  std::vector<Case> cases_;
};

// Where on the reference, in its own frame.
void require_part(Formula& f, const PlacementModel& model, ItemId t, ItemId r, const ThingPart& part) {
  const Item& ref = model.items[r];
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    PartOfTop where(ref, t, r, turn, states);
    where.read(part);
    for (Case& c : where.take()) f.cases.push_back(std::move(c));
  });
}

bool names_space(const Item& item, const ThingPart& part) {
  return std::any_of(item.spaces.begin(), item.spaces.end(), [&](const ItemSpace& s) { return s.name == part.text(); });
}

// t rests on r, or in it, at the part that is named.
void add_at_part(Compilation& c, ItemId t, ItemId r, Resting how) {
  const ThingPart& part = c.relation.parameters.part;
  const Item& ref = c.item(r);
  const bool space = names_space(ref, part), top = part.has(PartWord::kTop) && !space;
  if (!part.empty() && !space && !part.is_words()) {
    c.never();  // it has no such part
    return;
  }
  add_resting(c.formula(), c.model, t, r, space ? part.text() : "", top && how == Resting::kOn ? Resting::kTop : how);
  if (!space && part.says_where()) require_part(c.formula(), c.model, t, r, part);
}

// "A cup on a coaster on the table": the coaster is on the table, and so the cup is; asked for is at most where on it.
bool rests_by_way(Compilation& c, ItemId t, const Reference& r) {
  if (r.kind != Reference::Kind::kItem || !rests_by_way_of_others(*c.model.scene, c.item(t).id, c.item(r.item).id)) return false;
  const ThingPart& part = c.relation.parameters.part;
  Formula& f = c.formula();
  if (part.says_where())
    require_part(f, c.model, t, r.item, part);
  else
    f.add();
  return true;
}

void stand_on(Compilation& c, ItemId t, const Reference& r, const std::string& id) {
  if (r.kind == Reference::Kind::kItem) {
    const Item& ref = c.item(r.item);
    if (ref.thin) {
      Case base;
      base.require_small(lo(t, 2) - Linear(c.model.room.lo[2]), 0);
      const auto& all = c.model.scene->relations;
      const auto on_it = std::ranges::count_if(
          all, [&](const Relation& other) { return other.type == RelationType::kOn && other.references == std::vector{id}; });
      for (int axis = 0; axis < 2 && on_it == 1 && c.targets.size() == 1; ++axis) base.wish(mid2(t, axis) - mid2(r.item, axis), 100, 2);
      Formula& f = c.formula();
      for (Case& one : cover(base, c.model, t, r.item, 0)) f.cases.push_back(std::move(one));
      if (const ThingPart& part = c.relation.parameters.part; part.says_where()) require_part(c.formula(), c.model, t, r.item, part);
    } else if (ref.is_opening()) {
      Formula& f = c.formula();
      if (ref.opening->type == OpeningType::kWindow) add_on_sill(f, c.model, t, r.item);
    } else {
      add_at_part(c, t, r.item, Resting::kOn);
    }
    return;
  }
  // The floor or the ceiling, where it can be held by them at all.
  const bool ceiling = id == "ceiling";
  const auto kind = ceiling ? SupportOption::Kind::kCeiling : SupportOption::Kind::kFloor;
  const Item& item = c.item(t);
  Formula& f = c.formula();
  const auto is_held = [&](const SupportOption& s) { return s.kind == kind; };
  if (r.kind == Reference::Kind::kWall || std::none_of(item.supports.begin(), item.supports.end(), is_held)) return;
  f.add().require_small(ceiling ? hi(t, 2) - Linear(c.model.room.hi[2]) : lo(t, 2) - Linear(c.model.room.lo[2]), 0);
}

}  // namespace

void compile_On(Compilation& c) {
  for (const ItemId t : c.targets) {
    for (std::size_t i = 0; i < c.references.size(); ++i) {
      if (rests_by_way(c, t, c.references[i])) continue;
      stand_on(c, t, c.references[i], c.relation.references[i]);
    }
  }
}

void compile_In(Compilation& c) {
  for (const ItemId t : c.targets) {
    for (const Reference& r : c.references) {
      if (r.kind == Reference::Kind::kItem && !c.item(r.item).is_opening()) {
        add_at_part(c, t, r.item, Resting::kIn);
      } else if (r.kind == Reference::Kind::kRoom) {
        c.formula().add().require(lo(t, 2) - Linear(c.model.room.lo[2]));  // everything is
      } else {
        c.never();
      }
    }
  }
}

void compile_Stacked(Compilation& c) {
  for (std::size_t i = 0; i < c.references.size(); ++i) stand_on(c, c.targets[0], c.references[i], c.relation.references[i]);
  for (std::size_t i = 1; i < c.targets.size(); ++i) add_resting(c.formula(), c.model, c.targets[i], c.targets[i - 1], "", Resting::kTop);
}

void compile_Under(Compilation& c) {
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
      Formula& f = c.formula();
      if (c.item(r).is_opening()) {
        add_under_window(f, c.model, t, r, 500);
        continue;
      }
      Case base;
      base.require(mid2(r, 2) - mid2(t, 2)).require(lo(r, 2) + Linear(50) - lo(t, 2));
      for (int axis = 0; axis < 2; ++axis) base.wish(mid2(t, axis) - mid2(r, axis), 60, 2);
      for (Case& one : cover(base, c.model, t, r, 0)) f.cases.push_back(std::move(one));
    }
  }
}

void compile_Above(Compilation& c) {
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
      Formula& f = c.formula();
      if (c.item(r).is_opening()) {
        for_each_turn(c.item(r), [&](int turn, std::uint64_t states) {
          const Direction in_dir = side_direction(c.item(r), Side::kFront, turn);
          Case in;
          in.when(r, states);
          in.require(lo(t, 2) - hi(r, 2)).require(gap_towards(t, r, in_dir)).require(Linear(100) - gap_towards(t, r, in_dir));
          in.wish(mid2(t, across(in_dir)) - mid2(r, across(in_dir)), 100, 2).wish(lo(t, 2) - hi(r, 2) - Linear(50), 50);
          for (Case& one : in_line(in, c.model, t, place_of(r), across(in_dir))) f.cases.push_back(std::move(one));
        });
        continue;
      }
      Case base;
      const Linear gap = lo(t, 2) - hi(r, 2);
      base.require(gap);
      if (c.relation.parameters.gap) base.require_small(gap - Linear(*c.relation.parameters.gap), 0);
      for (int axis = 0; axis < 2; ++axis) base.wish(mid2(t, axis) - mid2(r, axis), 150, 2);
      if (c.item(t).mount == Mount::kWall) base.wish(gap - Linear(250), 30);
      for (Case& one : cover(base, c.model, t, r, 100)) f.cases.push_back(std::move(one));
    }
  }
}

}  // namespace layoutbox::placement
