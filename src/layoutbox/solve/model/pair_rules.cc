// Which two things keep apart by their boxes, which by their bodies, and which not at all.
#include <set>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/solve/model/items.h"

namespace layoutbox::placement {
namespace {

using Pairs = std::set<std::pair<ItemId, ItemId>>;

// Who is within the free space of whom: the desk under a loft bed, the box in a shelf.
std::vector<std::pair<ItemId, ItemId>> nested_pairs(const PlacementModel& model) {
  std::vector<std::pair<ItemId, ItemId>> nested;
  for (const Relation& relation : model.scene->relations) {
    if (relation.type != RelationType::kUnder && relation.type != RelationType::kIn) continue;
    for (const std::string& target : relation.targets) {
      for (const std::string& reference : relation.references) {
        const ItemId inner = model.find_item(target);
        const ItemId outer = model.find_item(reference);
        if (inner.exists() && outer.exists() && inner != outer) nested.emplace_back(inner, outer);
      }
    }
  }
  return nested;
}

// What is close to a nested thing (the lamp on that desk, the chair at it) comes as close to the outer one.
void add_company_of_the_nested(const PlacementModel& model, Pairs& pairs) {
  const auto nested = nested_pairs(model);
  for (bool grows = !nested.empty(); grows;) {
    const std::size_t before = pairs.size();
    for (const auto& [inner, outer] : nested) {
      for (const ItemId other : model.items.ids()) {
        if (other == inner || other == outer) continue;
        if (pairs.contains({std::min(inner, other), std::max(inner, other)}))
          pairs.insert({std::min(outer, other), std::max(outer, other)});
      }
    }
    grows = pairs.size() > before;
  }
}

// A screen on a desk reaches over the seat that is pushed under it.
void add_seats_by_riders(const PlacementModel& model, Pairs& pairs) {
  Pairs more;
  for (const ItemId rider : model.items.ids()) {
    for (const SupportOption& support : model.items[rider].supports) {
      if (support.kind != SupportOption::Kind::kItem || !model.items[rider].is(Trait::kScreen)) continue;
      for (const ItemId seat : model.items.ids()) {
        const auto at_host = std::pair{std::min(seat, support.item), std::max(seat, support.item)};
        if (model.items[seat].is(Trait::kTableSeat) && pairs.contains(at_host)) more.insert({std::min(seat, rider), std::max(seat, rider)});
      }
    }
  }
  pairs.insert(more.begin(), more.end());
}

// Which pairs are so close that their spaces count.
Pairs close_pairs(const PlacementModel& model) {
  Pairs pairs;
  const auto add = [&](ItemId a, ItemId b) {
    if (a.exists() && b.exists() && a != b) pairs.insert({std::min(a, b), std::max(a, b)});
  };
  for (const Relation& relation : model.scene->relations) {
    for (const std::string& target : relation.targets) {
      for (const std::string& reference : relation.references) add(model.find_item(target), model.find_item(reference));
    }
    for (std::size_t i = 1; i < relation.targets.size(); ++i) {
      if (relation.type == RelationType::kStacked) add(model.find_item(relation.targets[i - 1]), model.find_item(relation.targets[i]));
    }
  }
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (item.is_opening()) continue;
    for (const ItemId j : model.items.ids()) {
      if (item.is(Trait::kRoofSlope)) add(i, j);
    }
    for (const SupportOption& support : item.supports) {
      if (support.kind == SupportOption::Kind::kItem) add(i, support.item);
    }
    for (const ItemId j : model.items.ids()) {
      const auto goes_with = [&](const std::string& kind) { return model.is_a(j, kind); };
      if (j != i && std::any_of(item.entry->beside.begin(), item.entry->beside.end(), goes_with)) add(i, j);
    }
  }
  add_company_of_the_nested(model, pairs);
  add_seats_by_riders(model, pairs);
  return pairs;
}

// A rug lies under whatever there is; a mat that is used itself does not, unless a relation says so.
bool lies_under(const Item& item) { return item.thin && !item.entry->lain_on; }

// Is it asked to be at that window: under it, facing it, beside it?
bool asked_at_window(const PlacementModel& model, ItemId item, const Item& window) {
  return std::ranges::any_of(model.scene->relations, [&](const Relation& r) {
    const bool under = r.type == RelationType::kUnderWindow && r.references.empty();
    return r.origin == Origin::kAsked && (under || std::ranges::find(r.references, window.id) != r.references.end()) &&
           std::ranges::find(r.targets, model.items[item].id) != r.targets.end();
  });
}

// What stands on a sill may be before the window, and so may what stands on a desk that is asked to be there.
void let_before_windows(PlacementModel& model) {
  for (const ItemId item : model.items.ids()) {
    for (const SupportOption& support : model.items[item].supports) {
      if (support.kind == SupportOption::Kind::kSill) model.set_pair(item, support.item, PairRule::kFree);
      if (support.kind != SupportOption::Kind::kItem) continue;
      for (const ItemId w : model.items.ids()) {
        const Item& window = model.items[w];
        if (window.is_opening() && window.opening->type == OpeningType::kWindow && asked_at_window(model, support.item, window))
          model.set_pair(item, w, PairRule::kFree);
      }
    }
  }
}

// Both are where they are said to be, one beside the other in one wall: they may touch, which those that are placed do not.
bool are_said_apart(const Opening& a, const Opening& b) {
  if (a.wall.empty() || a.wall != b.wall || !a.offset || !b.offset) return false;
  return *a.offset + a.width <= *b.offset || *b.offset + b.width <= *a.offset;
}

}  // namespace

void set_pair_rules(PlacementModel& model) {
  const std::size_t n = model.items.size();
  model.pairs.assign(n * n, PairRule::kBoxes);
  const auto rule_of = [&](const Item& a, const Item& b) {
    if (lies_under(a) || lies_under(b)) return PairRule::kFree;
    if (a.is_opening() && b.is_opening()) return are_said_apart(*a.opening, *b.opening) ? PairRule::kFree : PairRule::kOpenings;
    const bool window =
        (a.is_opening() && a.opening->type == OpeningType::kWindow) || (b.is_opening() && b.opening->type == OpeningType::kWindow);
    if (window && (a.curtain || b.curtain)) return PairRule::kFree;
    return PairRule::kBoxes;
  };
  for (const ItemId i : model.items.ids()) {
    model.set_pair(i, i, PairRule::kFree);
    for (const ItemId j : model.items.ids_after(i)) model.set_pair(i, j, rule_of(model.items[i], model.items[j]));
  }
  for (const auto& [a, b] : close_pairs(model)) {
    if (model.pair(a, b) != PairRule::kBoxes || model.items[a].is_opening() || model.items[b].is_opening()) continue;
    model.set_pair(a, b, model.items[a].thin != model.items[b].thin ? PairRule::kFree : PairRule::kSolids);
  }
  let_before_windows(model);
}

}  // namespace layoutbox::placement
