// At a desk with visitors the one who works there sits across from them: two on one side of a desk are colleagues.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {
namespace {

class Visitors {
 public:
  explicit Visitors(NormalizeContext& context) : context_(context), scene_(context.scene), kind_(context.catalog.find("visitor_chair")) {}

  void run() {
    if (kind_ == nullptr) return;
    std::vector<std::string> desks;
    for (const SceneObject& object : scene_.objects) {
      const CatalogEntry& entry = entry_of(object);
      const bool used_in_front = object.used_sides.value_or(entry.used_sides) == std::vector<Side>{Side::kFront};
      if (entry.is(Trait::kDesk) && entry.has_front && used_in_front && object.mount == Mount::kFloor) desks.push_back(object.id);
    }
    if (desks.empty()) return;
    const std::map<std::string, Sitters> told = told_sitters();
    for (const std::string& desk : desks) {
      const auto sitters = told.find(desk);
      settle(desk, sitters == told.end() ? Sitters{} : sitters->second, desks.size() == 1);
    }
  }

 private:
  const CatalogEntry& entry_of(const SceneObject& object) const { return context_.catalog.entry_or_nearest(object.category); }
  bool is_visitors(const SceneObject& seat) const { return entry_of(seat).is(Trait::kVisitorSeat); }

  // The seats that are said to be there, and at most to look at something or to be at the desk: on one side of it.
  std::vector<std::string> loose_seats(const std::string& desk) const {
    std::unordered_set<std::string_view> placed;
    for (const Relation& r : scene_.relations) {
      const bool at_it = r.type == RelationType::kNextTo && names(r.references, desk);
      if (r.type != RelationType::kFacing && !at_it) placed.insert(r.targets.begin(), r.targets.end());
    }
    std::vector<std::string> loose;
    for (const SceneObject& seat : scene_.objects) {
      if (entry_of(seat).is(Trait::kTableSeat) && !placed.contains(seat.id)) loose.push_back(seat.id);
    }
    return loose;
  }

  // Whom the text puts at a desk.
  struct Sitters {
    bool visited = false;
    std::string own;             // the seat behind it: of several the last
    bool worked_before = false;  // one works there at its front: "a desk with an executive chair"
  };

  std::map<std::string, Sitters> told_sitters() const {
    std::unordered_map<std::string_view, std::size_t> seats;  // by id: their place among the objects
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      if (entry_of(scene_.objects[i]).is(Trait::kTableSeat)) seats.emplace(scene_.objects[i].id, i);
    }
    std::map<std::string, Sitters> told;
    std::map<std::string_view, std::size_t> last_behind;
    for (const Relation& r : scene_.relations) {
      const bool behind = r.type == RelationType::kBehind;
      if (r.origin != Origin::kAsked || (!behind && r.type != RelationType::kInFrontOf)) continue;
      for (const std::string& target : r.targets) {
        const auto seat = seats.find(target);
        if (seat == seats.end()) continue;
        for (const std::string& desk : r.references) {
          Sitters& sitters = told[desk];
          const bool works = !behind && entry_of(scene_.objects[seat->second]).is(Trait::kWorkSeat);
          sitters.visited |= !behind && !works;
          sitters.worked_before |= works;
          if (!behind || (!sitters.own.empty() && seat->second < last_behind[desk])) continue;
          sitters.own = target, last_behind[desk] = seat->second;
        }
      }
    }
    return told;
  }

  // Somewhere else to sit at, where a chair may belong as well.
  bool has_other_table(const std::string& desk) const {
    return std::ranges::any_of(scene_.objects, [&](const SceneObject& object) {
      const CatalogEntry& entry = entry_of(object);
      return object.id != desk && entry.is(Trait::kTable) && !entry.is(Trait::kCoffeeTable) && object.mount == Mount::kFloor;
    });
  }

  void settle(const std::string& desk, const Sitters& told, bool only_desk) {
    std::vector<std::string> visitors;
    const bool receives = std::ranges::find(kind_->rooms, scene_.room.type) != kind_->rooms.end();
    const bool alone = only_desk && !has_other_table(desk);
    const std::vector<std::string> loose = alone ? loose_seats(desk) : std::vector<std::string>{};
    if (told.worked_before && told.own.empty() && !told.visited && !is_at_wall(desk))
      return settle_visitors(desk, loose, RelationType::kBehind);
    const bool visited = told.visited || told.worked_before, manned = !told.own.empty();
    std::string own = told.own;
    // Of chairs that nobody placed the best to work on is the worker's.
    const auto works = [&](const std::string& id) { return entry_of(*scene_.find_object(id)).is(Trait::kWorkSeat); };
    for (const bool office : {true, false}) {
      for (const std::string& id : loose) {
        const SceneObject& seat = *scene_.find_object(id);
        if (own.empty() && works(id) == office && !is_visitors(seat) && (office || visited || has_visitor(loose))) own = id;
      }
    }
    for (const std::string& id : loose) {
      const SceneObject& seat = *scene_.find_object(id);
      if (id != own && (is_visitors(seat) || (receives && !own.empty() && !works(id)))) visitors.push_back(id);
    }
    if (!visited && visitors.empty()) return;
    if (!own.empty() && !manned) relate(RelationType::kBehind, own, desk, "who works at a desk sits across from visitors");
    for (const std::string& id : visitors) {
      relate(RelationType::kInFrontOf, id, desk, "visitors sit before the desk");
      relate(RelationType::kFacing, id, desk, "visitors look at the desk");
    }
  }

  bool is_at_wall(const std::string& desk) const {
    constexpr RelationSet kAtWall(RelationType::kAgainstWall, RelationType::kCorner, RelationType::kUnderWindow,
                                  RelationType::kSideAgainstWall);
    return std::ranges::any_of(scene_.relations, [&](const Relation& r) { return kAtWall.has(r.type) && names(r.targets, desk); });
  }

  // Who comes sits across from the one who works there.
  void settle_visitors(const std::string& desk, const std::vector<std::string>& loose, RelationType across) {
    const bool receives = std::ranges::find(kind_->rooms, scene_.room.type) != kind_->rooms.end();
    for (const std::string& id : loose) {
      const CatalogEntry& seat = entry_of(*scene_.find_object(id));
      if (!seat.is(Trait::kVisitorSeat) && (!receives || seat.is(Trait::kWorkSeat))) continue;
      relate(across, id, desk, "who works at a desk sits across from visitors");
      relate(RelationType::kFacing, id, desk, "visitors look at the desk");
    }
  }

  bool has_visitor(const std::vector<std::string>& loose) const {
    return std::ranges::any_of(loose, [&](const std::string& id) { return is_visitors(*scene_.find_object(id)); });
  }

  void relate(RelationType type, const std::string& seat, const std::string& desk, std::string why) {
    Relation relation;
    relation.id = unused_id(scene_, fmt::format("{}_{}_{}", seat, relation_row(type).name, desk));
    relation.type = type;
    relation.targets = {seat};
    relation.references = {desk};
    relation.why = std::move(why);
    relation.origin = Origin::kAssumed;
    scene_.relations.push_back(std::move(relation));
  }

  NormalizeContext& context_;
  SceneGraph& scene_;
  const CatalogEntry* kind_;
};

}  // namespace

void normalize_visitors(NormalizeContext& context) { Visitors(context).run(); }

}  // namespace layoutbox
