// At a desk with visitors the one who works there sits across from them: two on one side of a desk are colleagues.
#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"

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
    for (const std::string& desk : desks) settle(desk, desks.size() == 1);
  }

 private:
  const CatalogEntry& entry_of(const SceneObject& object) const { return context_.catalog.entry_or_nearest(object.category); }
  bool is_visitors(const SceneObject& seat) const { return entry_of(seat).is(Trait::kVisitorSeat); }

  // Said to be there, and at most to look at something or to be at the desk: on one side of it.
  bool is_loose(const SceneObject& seat, const std::string& desk) const {
    return entry_of(seat).is(Trait::kTableSeat) && std::ranges::none_of(scene_.relations, [&](const Relation& r) {
             const bool at_it = r.type == RelationType::kNextTo && names(r.references, desk);
             return r.type != RelationType::kFacing && !at_it && names(r.targets, seat.id);
           });
  }

  bool is_told(const SceneObject& seat, const std::string& desk, RelationType type) const {
    return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      return r.type == type && r.origin == Origin::kAsked && names(r.targets, seat.id) && names(r.references, desk);
    });
  }

  // Somewhere else to sit at, where a chair may belong as well.
  bool has_other_table(const std::string& desk) const {
    return std::ranges::any_of(scene_.objects, [&](const SceneObject& object) {
      const CatalogEntry& entry = entry_of(object);
      return object.id != desk && entry.is(Trait::kTable) && !entry.is(Trait::kCoffeeTable) && object.mount == Mount::kFloor;
    });
  }

  void settle(const std::string& desk, bool only_desk) {
    std::vector<std::string> visitors, loose;
    const bool receives = std::ranges::find(kind_->rooms, scene_.room.type) != kind_->rooms.end();
    const bool alone = only_desk && !has_other_table(desk);
    bool visited = false;
    std::string own;
    for (const SceneObject& seat : scene_.objects) {
      if (!entry_of(seat).is(Trait::kTableSeat)) continue;
      visited |= is_told(seat, desk, RelationType::kInFrontOf);
      if (is_told(seat, desk, RelationType::kBehind)) own = seat.id;
      if (alone && is_loose(seat, desk)) loose.push_back(seat.id);
    }
    const bool manned = !own.empty();
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
