// Far too much for the floor: what is too much goes in one step, and one sentence says what, how much is missing and what would help.
#include <fmt/format.h>

#include "layoutbox/solve/conflict/floor_sum.h"
#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/search/search.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {
namespace {

constexpr double kFilled = 0.85;  // of the floor, by bodies and the floor before the door: more is not worth a try

double surplus(const FloorSum& floor, double share) {
  return static_cast<double>(floor.covered + floor.before_door) - share * static_cast<double>(floor.room);
}

// How much is asked for and how much there is.
std::string need_in_words(const PlacementModel& model, const FloorSum& floor) {
  const auto m2 = [](std::int64_t area) { return static_cast<double>(area) / 1e6; };
  const std::string door = floor.door.exists() ? fmt::format(" besides {:.1f} m² before the door", m2(floor.before_door)) : "";
  const std::int64_t missing = floor.missing();
  const std::string short_of = missing > 0 ? fmt::format(", {:.1f} m² less", m2(std::max<std::int64_t>(missing, 50'000))) : "";
  return fmt::format("{} need at least {:.1f} m² of floor{}, and the room has {:.1f} m²{}", things_in_words(model, floor.items),
                     m2(floor.covered), door, m2(floor.room), short_of);
}

}  // namespace

// Of what is missed least first the fewest without which the rest may fit; empty where it is not too much by its sums.
std::vector<ItemId> Solver::surplus_items() const {
  const FloorSum floor = floor_sum(model_, scope_);
  if (floor.missing() <= 0) return {};
  double too_much = surplus(floor, kFilled);
  std::vector<ItemId> left = least_missed_first(model_, floor.items), gone;
  const auto as_dear = [&](ItemId a, ItemId b) {
    const Item &x = model_.items[a], &y = model_.items[b];
    const auto is_first = [&](ItemId i) {
      return std::none_of(floor.items.begin(), floor.items.end(),
                          [&](ItemId j) { return j < i && model_.items[j].entry == model_.items[i].entry; });
    };
    return x.object->origin == y.object->origin && is_first(a) == is_first(b);
  };
  while (too_much > 0 && !left.empty()) {
    // Of equally dear ones the smallest that is enough, else the largest.
    ItemId best = left.front();
    for (const ItemId item : left) {
      if (!as_dear(left.front(), item)) break;
      const auto area = static_cast<double>(least_area(model_.items[item])),
                 best_area = static_cast<double>(least_area(model_.items[best]));
      if (best_area < too_much ? area > best_area : area >= too_much && area < best_area) best = item;
    }
    too_much -= static_cast<double>(least_area(model_.items[best]));
    gone.push_back(best);
    std::erase(left, best);
  }
  return gone;
}

// The fewest things that are too many, by the first sum that speaks of things alone.
Status Solver::note_crowd(const std::vector<Clash>& sums) {
  const auto speaks_of_things = [&](const Clash& sum) { return objects_to_blame(model_, sum).size() > 1; };
  const auto sum = std::find_if(sums.begin(), sums.end(), speaks_of_things);
  if (crowd_ || sum == sums.end()) return {};
  // What is only to be said takes nothing from the search for a layout.
  const Budget finding = finding_;
  const double proof_time = proof_time_;
  LAYOUTBOX_ASSIGN(const Clash crowd, smallest_crowd(*sum));
  finding_ = finding, proof_time_ = proof_time;
  if (!crowd.minimal) return {};
  crowd_ = Conflict{{}, {}, describe_clash(model_, crowd), true};
  for (const Demand& demand : crowd.demands) {
    const bool item = demand.is_item();
    (item ? crowd_->objects : crowd_->relations)
        .push_back(item ? model_.items[demand.item].id : model_.constraints[demand.constraint].name);
  }
  return {};
}

// Where the least sizes of all together are more than the floor: how much, and without what the rest has a place.
std::optional<std::string> Solver::too_little_floor(const std::vector<ItemId>& without) const {
  const FloorSum floor = floor_sum(model_, scope_);
  if (floor.missing() <= 0 || without.empty()) return std::nullopt;
  return fmt::format("{}; without {} the rest has a place", need_in_words(model_, floor), things_in_words(model_, without));
}

// True: something was left out.
Result<bool> Solver::shed(const std::vector<Clash>& sums) {
  if (options_.on_conflict != OnConflict::kRelax) return false;
  const std::vector<ItemId> items = surplus_items();
  if (items.size() < 2) return false;  // one is found, and said, by itself
  LAYOUTBOX_ASSIGN(const bool made_way, companions_make_way_for(items));
  if (made_way) return true;
  LAYOUTBOX_CHECK(note_crowd(sums));
  Clash clash;
  clash.minimal = false;
  const FloorSum floor = floor_sum(model_, scope_);
  clash.sentence = need_in_words(model_, floor);
  for (const ItemId item : floor.items) clash.demands.push_back(Demand::of_item(item));
  const bool asked = std::any_of(items.begin(), items.end(), [&](ItemId i) { return is_asked(i); });
  LAYOUTBOX_CHECK(note_conflict(clash, asked));
  for (const ItemId item : items) note_left_out(item, clash.sentence);
  shed_ = true;
  LAYOUTBOX_CHECK(rebuild());
  return true;
}

// Where things were left out for want of floor, all reasons say the same: what is asked for, what there is, and without what all else fits.
void Solver::sum_up_shedding() {
  if (!shed_ || left_out_ids_.empty()) return;
  // Of companions that made way for it nobody needs to hear.
  std::vector<std::string> companions;
  for (const std::string& id : left_out_ids_) {
    if (made_way_ && asked_.find_object(id)->origin == Origin::kAdded) companions.push_back(id);
  }
  const LessScene less = without_objects(asked_, companions);
  const Result<PlacementModel> whole = build_model(less.scene, catalog_, guides());
  if (!whole) return;
  std::vector<ItemId> gone;
  for (const std::string& id : left_out_ids_) {
    if (const ItemId item = whole->find_item(id); item.exists()) gone.push_back(item);
  }
  std::sort(gone.begin(), gone.end());
  const bool all_else = std::all_of(relaxed_.begin(), relaxed_.end(), [&](const auto& relaxed) {
    return std::none_of(model_.constraints.begin(), model_.constraints.end(),
                        [&](const Constraint& c) { return c.name == relaxed.first && !is_assumption(model_, c); });
  });
  const FloorSum floor = floor_sum(*whole, {});
  const std::string sentence = fmt::format("{}; without {} {}", need_in_words(*whole, floor), things_in_words(*whole, gone),
                                           all_else ? "all else fits" : "the rest has a place");
  for (Relaxation& reason : reasons_) {
    if (const ItemId item = whole->find_item(reason.relation); item.exists())
      reason.why = object_in_words(*whole, item) + " is left out: " + sentence;
  }
  // One conflict in the place of all that speak of things alone.
  std::erase_if(conflicts_, [](const Noted& noted) { return noted.conflict.relations.empty(); });
  Noted noted{crowd_.value_or(Conflict{{}, {}, sentence, false}), false};
  if (!crowd_) {
    for (const ItemId item : floor.items) noted.conflict.objects.push_back(whole->items[item].id);
  } else if (crowd_->objects.size() == floor.items.size()) {
    noted.conflict.sentence = sentence;
  }
  for (const ItemId item : gone) noted.asked = noted.asked || whole->items[item].object->asked();
  conflicts_.insert(conflicts_.begin(), std::move(noted));
}

}  // namespace layoutbox::placement
