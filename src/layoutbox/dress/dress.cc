#include "layoutbox/dress/dress.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "layoutbox/catalog/dressing.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/dress/places.h"
#include "layoutbox/dress/rehang.h"
#include "layoutbox/scene/shell.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {
namespace dressing {
namespace {

constexpr std::pair<std::string_view, PlaceFiller> kPlaces[] = {{"kitchen run", fill_kitchen_run},
                                                                {"over stove", hang_over_stove},
                                                                {"over run", hang_over_run},
                                                                {"window", hang_at_windows},
                                                                {"window top", hang_on_window_tops},
                                                                {"over", hang_over_things},
                                                                {"wall", hang_on_walls},
                                                                {"corner", stand_in_corners},
                                                                {"beside", stand_beside},
                                                                {"free wall", stand_at_free_wall},
                                                                {"under", lie_under},
                                                                {"before", lie_before},
                                                                {"middle", lie_in_middle},
                                                                {"below", hang_below},
                                                                {"on", stand_on},
                                                                {"at seats", lay_before_seats},
                                                                {"ceiling", hang_from_ceiling}};

double m2_of(const Room& room) { return double(doubled_area(room.polygon)) / 2e6; }

bool is_among(const std::vector<std::string>& list, const std::string& one) { return std::ranges::find(list, one) != list.end(); }

bool is_wanted(const Dresser& dresser, const Dressing& row) {
  const Room& room = dresser.layout().room;
  const CatalogEntry* kind = dresser.catalog().find(row.adds);
  if (kind == nullptr || dresser.spoken().keeps_off(row.adds, row.place, room.type) || !is_among(row.rooms, room.type) ||
      m2_of(room) < row.area_m2)
    return false;
  if ((!row.said.empty() && !dresser.spoken().says_any(row.said)) || dresser.spoken().says_any(row.unsaid)) return false;
  if (dresser.spoken().says_enough_for(row)) return false;
  if (std::ranges::any_of(row.unless, [&](const std::string& id) { return dresser.is_there(id); })) return false;
  if (row.unspoken.empty()) return !dresser.spoken().of(*kind);
  const bool lifted = dresser.spoken().says_any(row.lifted);  // "cabinets" of a kitchen are what is added
  return std::ranges::none_of(row.unspoken, [&](const std::string& id) {
    const CatalogEntry* other = dresser.catalog().find(id);
    return other != nullptr && dresser.spoken().of_just(*other) && !(lifted && id == row.adds);
  });
}

// What verify() found wrong, and how good what it measures is: by check and subject.
using Findings = std::map<std::pair<std::string, std::string>, double>;

struct DressVerdict {
  Findings failed, shares;

  // Nothing is wrong, and no share could be greater: no other room is better.
  bool flawless() const {
    return failed.empty() && std::ranges::all_of(shares, [](const auto& share) { return share.second >= 1; });
  }
};

// So much of its used side is enough: a worktop goes on round the corner, where nobody stands before it.
double share_needed(const Layout& layout, const Catalog& catalog, const std::string& id) {
  constexpr double kOfWorktop = 0.5;
  const PlacedObject* thing = layout.find_object(id);
  if (thing == nullptr) return 1;
  const CatalogEntry& entry = catalog.entry_or_nearest(thing->category);
  return entry.is(Trait::kKitchenRun) && entry.is(Trait::kCounter) ? kOfWorktop : 1;
}

DressVerdict judge(const Layout& layout, const Catalog& catalog) {
  DressVerdict verdict;
  for (const Check& check : verify(layout, catalog).checks) {
    const bool enough = check.name == "accessibility" && check.value >= share_needed(layout, catalog, check.subject);
    if (!check.passed && !enough) verdict.failed[{check.name, check.subject}] = check.value;
    if (check.name == "reachability") verdict.shares[{check.name, check.subject}] = check.value;
  }
  return verdict;
}

// Of what is worse than before the subjects, each as verify names it: "desk_1", "sofa_1 / plant_1", "room".
std::vector<std::string> worse(const DressVerdict& before, const DressVerdict& now) {
  std::vector<std::string> subjects;
  for (const auto& [what, value] : now.failed) {
    if (!before.failed.contains(what)) subjects.push_back(what.second);
  }
  for (const auto& [what, share] : now.shares) {
    const auto earlier = before.shares.find(what);
    if (earlier != before.shares.end() && share < earlier->second - 1e-9) subjects.push_back(what.second);
  }
  return subjects;
}

// The room as it was, judged only where that matters.
class Before {
 public:
  Before(Layout layout, const Catalog& catalog) : layout_(std::move(layout)), catalog_(catalog) {}

  // What is worse in the room as it is now.
  std::vector<std::string> worse_in(const Layout& now) {
    const DressVerdict verdict = judge(now, catalog_);
    if (verdict.flawless()) return {};
    if (!verdict_) verdict_ = judge(layout_, catalog_);
    return worse(*verdict_, verdict);
  }

 private:
  Layout layout_;
  const Catalog& catalog_;
  std::optional<DressVerdict> verdict_;
};

double gap_between(const RoomBox& a, const RoomBox& b) {
  return std::hypot(std::max({0.0, a.x0 - b.x1, b.x0 - a.x1}), std::max({0.0, a.y0 - b.y1, b.y0 - a.y1}));
}

// Who is to blame: what is named, else of what people walk round the nearest to the thing, else the last.
std::string to_blame(const Dresser& dresser, const std::string& subject) {
  const std::vector<std::string>& added = dresser.added();
  const std::size_t parted = subject.find(" / ");
  const std::string first = subject.substr(0, parted), second = parted == std::string::npos ? first : subject.substr(parted + 3);
  for (const std::string& id : {second, first}) {
    if (is_among(added, id)) return id;
  }
  const PlacedObject* thing = dresser.layout().find_object(subject);
  std::string nearest = added.back();
  double least = 1e9;
  for (const std::string& id : added) {
    const PlacedObject& object = *dresser.layout().find_object(id);
    const bool stands = object.mount == Mount::kFloor;
    if (!stands && (thing == nullptr || object.mount != Mount::kWall)) continue;
    const double gap = thing == nullptr ? 0 : gap_between(box_round(object), box_round(*thing));
    if (gap <= least) nearest = id, least = gap;
  }
  return nearest;
}

// Takes out again what makes the room worse, one after the other.
void mend(Dresser& dresser, Before& before) {
  while (!dresser.added().empty()) {
    const std::vector<std::string> subjects = before.worse_in(dresser.layout());
    if (subjects.empty()) return;
    dresser.remove({to_blame(dresser, subjects.front())});
  }
}

// What hides is hung where it is seen, unless something is worse for it.
std::size_t show_what_hides(Layout& layout, const Catalog& catalog, const Spoken& spoken) {
  const auto is_such = [&](const PlacedObject& object) {
    return std::ranges::any_of(Dressings::builtin().rehung, [&](const std::string& kind) { return catalog.is_a(object.category, kind); });
  };
  if (std::ranges::none_of(layout.objects, is_such)) return 0;
  const Layout as_it_was = layout;
  const std::size_t moved = rehang(Dresser(layout, catalog, spoken), layout);
  if (moved == 0 || Before(as_it_was, catalog).worse_in(layout).empty()) return moved;
  layout = as_it_was;
  return 0;
}

// The same in the scene: exactly that size, and the place as a hint.
void add_to_scene(SceneGraph& scene, const Layout& layout, const std::vector<std::string>& added) {
  for (const std::string& id : added) {
    const PlacedObject& placed = *layout.find_object(id);
    SceneObject object;
    object.id = placed.id, object.category = placed.category, object.name = placed.name;
    object.attributes = placed.attributes;
    object.size = SizeRange{placed.size, placed.size, placed.size};
    object.size_source = SizeSource::kCatalog;
    object.mount = placed.mount;
    object.used_sides = placed.used_sides;
    object.hint.position = placed.position;
    object.hint.rotation_deg = placed.rotation_deg;
    object.origin = placed.origin;
    scene.objects.push_back(std::move(object));
  }
  for (const PlacedRelation& placed : layout.relations) {
    if (std::ranges::any_of(placed.relation.targets, [&](const std::string& id) { return is_among(added, id); }))
      scene.relations.push_back(placed.relation);
  }
}

}  // namespace

PlaceFiller find_place(std::string_view name) {
  const auto found = std::ranges::find(kPlaces, name, &std::pair<std::string_view, PlaceFiller>::first);
  return found == std::end(kPlaces) ? nullptr : found->second;
}

}  // namespace dressing

std::size_t dress(SceneGraph& scene, Layout& layout, const Catalog& catalog, const Spoken& spoken) {
  using namespace dressing;
  const Groups& groups = Groups::builtin();
  if (catalog.only_articles() || spoken.wants_no_more(groups) || spoken.says_any(groups.none_to_fill)) return 0;
  const std::size_t moved = show_what_hides(layout, catalog, spoken);
  Dresser dresser(layout, catalog, spoken);
  std::optional<Before> before;
  for (const Dressing& row : Dressings::builtin().rows) {
    if (!is_wanted(dresser, row)) continue;
    if (!before) before.emplace(layout, catalog);
    find_place(row.place)(dresser, row);
  }
  if (before) mend(dresser, *before);
  add_to_scene(scene, layout, dresser.added());
  return dresser.added().size() + moved;
}

}  // namespace layoutbox
