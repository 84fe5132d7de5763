// A kitchen told by its units: what their middle, their ends and "above" mean where they stand in a run.
#include <algorithm>

#include "layoutbox/catalog/dressing.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/room/kitchen_wall.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/spoken.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// Does it stand in a kitchen's run? No island.
bool RelationBuilder::stands_in_run(const std::string& object) const {
  const SceneObject* unit = object_of(object);
  const CatalogEntry* entry = unit == nullptr ? nullptr : noun_of_object(*unit).entry;
  return entry != nullptr && entry->mount == Mount::kFloor && entry->back_to_wall && entry->is(Trait::kKitchenRun);
}

std::vector<std::string> RelationBuilder::units_of_run() const {
  std::vector<std::string> units;
  for (const SceneObject& object : scene_.objects) {
    if (stands_in_run(object.id)) units.push_back(object.id);
  }
  return units;
}

// Its top is that of the worktop beside it.
void RelationBuilder::build_in(std::size_t oven) {
  constexpr Mm kWorktop = 900;
  const NounPhrase& noun = noun_of_object(scene_.objects[oven]);
  if (noun.size.any() || scene_.objects[oven].size || noun.entry == nullptr) return;
  SizeRange size = noun.entry->size;
  size.least.height = size.usual.height = size.greatest.height = kWorktop;
  scene_.objects[oven].size = size;
}

// "an oven below the hob": it is built in there, as high as the worktop, and carries the hob.
void RelationBuilder::build_in_ovens() {
  for (std::size_t r = 0; r < scene_.relations.size(); ++r) {
    Relation& under = scene_.relations[r];
    if (under.type != R::kUnder || under.targets.size() != 1 || under.references.size() != 1 || !stands_in_run(under.targets[0])) continue;
    const SceneObject* hob = object_of(under.references[0]);
    const CatalogEntry* entry = hob == nullptr ? nullptr : noun_of_object(*hob).entry;
    if (entry == nullptr || !entry->is(Trait::kHob) || entry->mount != Mount::kSurface) continue;
    std::swap(under.targets, under.references);
    under.type = R::kOn;
    of_target_[hob->id].push_back(r);
    std::erase(of_target_[under.references[0]], r);
    build_in(objects_.at(under.references[0]));
  }
}

// The only worktop that the text names; empty: none.
std::string RelationBuilder::counter_of_run(const std::vector<std::string>& units) const {
  std::string counter;
  for (const std::string& unit : units) {
    const CatalogEntry& entry = *noun_of_object(*object_of(unit)).entry;
    if (!entry.is(Trait::kCounter) || entry.is(Trait::kWashUp) || !entry.spaces.empty() || !object_of(unit)->asked()) continue;
    if (!counter.empty()) return {};
    counter = unit;
  }
  return counter;
}

// "a counter with a sink at the left end and a stove at the right end": what can be is let into it, the rest stands right beside it.
void RelationBuilder::place_at_counter(Relation& relation, const std::string& counter, bool left) {
  constexpr Mm kBeside = 50;
  const CatalogEntry& host = *noun_of_object(*object_of(counter)).entry;
  const std::string target = relation.targets[0];
  for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
    const std::vector<int>& items = document_.mentions[m].items;
    if (items.size() == 1 && id(items.front()) == target) let_in(static_cast<int>(m), host);
  }
  const NounPhrase& noun = noun_of_object(*object_of(target));
  relation.references = {counter};
  if (mount_of(noun) == Mount::kSurface) {
    relation.type = R::kOn;
    relation.parameters.part = left ? PartWord::kLeft : PartWord::kRight;
    return;
  }
  relation.type = left ? R::kLeftOf : R::kRightOf;
  relation.parameters.max = kBeside;
}

// "fridge at the left end, sink in the middle, stove at the right end": of the run.
void RelationBuilder::place_in_run(Relation& relation, const std::vector<std::string>& units) {
  constexpr Mm kRun = 4000;  // how far off an end of it is
  if (relation.targets.size() != 1 || !relation.asked() || !stands_in_run(relation.targets[0])) return;
  if (relation.type == R::kCenterOfRoom && !words_.have(relation, WordSet::kWholeRoom)) relation.type = R::kCenteredOnWall;
  if (!words_.end_with(relation, "end")) return;
  const bool left = words_.have(relation, "left"), right = words_.have(relation, "right");
  if (left == right) return;
  if (const std::string counter = counter_of_run(units); !counter.empty() && counter != relation.targets[0])
    return place_at_counter(relation, counter, left);
  relation.references.clear();
  for (const std::string& unit : units) {
    const CatalogEntry& entry = *noun_of_object(*object_of(unit)).entry;
    if (unit != relation.targets[0] && entry.is(Trait::kWashUp)) relation.references = {unit};
  }
  relation.type = relation.references.empty() ? R::kInRegion : left ? R::kLeftOf : R::kRightOf;
  if (relation.references.empty())
    relation.parameters.region = left ? RoomRegion::kLeft : RoomRegion::kRight;
  else
    relation.parameters.max = kRun;
}

// "sink, stove and fridge, wall cabinets above": each over a low unit of its own.
void RelationBuilder::share_out_over_run(const std::vector<std::string>& units) {
  constexpr Mm kLow = 1150;
  std::vector<std::string> low;
  for (const bool worktop : {true, false}) {
    for (const std::string& unit : units) {
      const CatalogEntry& entry = *noun_of_object(*object_of(unit)).entry;
      const bool is_worktop = entry.is(Trait::kCounter) && entry.spaces.empty();
      if (entry.size.usual.height < kLow && !entry.is(Trait::kHob) && is_worktop == worktop) low.push_back(unit);
    }
  }
  std::size_t over = 0;
  for (Relation& above : scene_.relations) {
    const bool unsaid =
        above.type == R::kAbove && words_.are_without_reference(above) && above.targets.size() == 1 && above.references.size() == 1;
    const SceneObject* cabinet = unsaid ? object_of(above.targets[0]) : nullptr;
    if (cabinet == nullptr || !catalog_.is_a(cabinet->category, "wall_cabinet") || !stands_in_run(above.references[0])) continue;
    if (over < low.size()) above.references = {low[over++]};
  }
}

// A hob by itself ("the hob on the back wall") is a stove, as it has to stand on something; beside an oven of which nothing is said it is
// over that.
void RelationBuilder::stand_hobs() {
  const CatalogEntry* stove = catalog_.find("stove");
  for (std::size_t i = 0; i < scene_.objects.size() && stove != nullptr; ++i) {
    NounPhrase& noun = document_.items[i].noun;
    if (noun.entry == nullptr || !noun.entry->is(Trait::kHob) || noun.entry->mount != Mount::kSurface) continue;
    const std::vector<std::size_t> own = relations_of(id(static_cast<int>(i)));
    const auto rests = [&](std::size_t r) { return traits_of(scene_.relations[r].type).rests; };
    const auto at_wall = [&](std::size_t r) {
      return scene_.relations[r].type == R::kOnWall || traits_of(scene_.relations[r].type).back_to_wall;
    };
    const auto beside = [&](std::size_t r) {
      const Relation& relation = scene_.relations[r];
      return !relation.references.empty() && object_of(relation.references[0]) != nullptr;
    };
    if (std::ranges::any_of(own, rests)) continue;
    const bool has_top = std::ranges::any_of(scene_.objects, [&](const SceneObject& object) {
      const auto carries = [&](const std::string& kind) { return catalog_.is_a(object.category, kind); };
      return std::ranges::any_of(noun.entry->stands_on, carries) && catalog_.entry_or_nearest(object.category).spaces.empty();
    });
    const auto is_free_oven = [&](const SceneObject& object) {
      return catalog_.is_a(object.category, "oven") && !object.size && relations_of(object.id).empty() &&
             noun_of_object(object).attributes.empty();
    };
    const auto oven = std::ranges::find_if(scene_.objects, is_free_oven);
    if (own.empty() && oven != scene_.objects.end()) {
      build_in(objects_.at(oven->id));
      of_target_[scene_.objects[i].id].push_back(scene_.relations.size());
      add_habit(R::kOn, {scene_.objects[i].id}, {oven->id}, kTogether, "a hob is over its oven");
      scene_.relations.back().hard = true;
    } else if (std::ranges::any_of(own, at_wall) || (std::ranges::any_of(own, beside) && !has_top)) {
      for (const std::size_t r : own) {
        if (scene_.relations[r].type == R::kOnWall) scene_.relations[r].type = R::kAgainstWall;
      }
      noun.entry = stove;
      scene_.objects[i].category = noun.category = stove->id;
    }
  }
}

// "Kitchen along the back wall: sink, stove, fridge": they are at that wall.
void RelationBuilder::line_up_units(const std::vector<std::string>& units) {
  const std::string wall = wall_of_kitchen(document_);
  for (const std::string& unit : units) {
    const auto at_walls = [&](std::size_t r) { return traits_of(scene_.relations[r].type).back_to_wall; };
    if (!wall.empty() && std::ranges::none_of(relations_of(unit), at_walls))
      add_habit(R::kAgainstWall, {unit}, {wall}, kTogether, "the kitchen is at that wall");
  }
}

// "cabinets and a sink along the left wall under the window": the sink is under it, the others beside that.
void RelationBuilder::leave_window_to_sink() {
  const auto is_sink = [&](const Relation& r) {
    const SceneObject* unit = r.type == R::kUnderWindow && r.targets.size() == 1 ? object_of(r.targets[0]) : nullptr;
    return unit != nullptr && stands_in_run(unit->id) && noun_of_object(*unit).entry->is(Trait::kWashUp);
  };
  const auto sink = std::ranges::find_if(scene_.relations, is_sink);
  if (sink == scene_.relations.end()) return;
  const Relation of_sink = *sink;
  std::erase_if(scene_.relations, [&](const Relation& r) {
    return r.type == R::kUnderWindow && words_.are_one(r, of_sink) && r.targets.size() == 1 && stands_in_run(r.targets[0]) && !is_sink(r);
  });
}

// "L-shaped: sink under the window, stove on the other wall": at the wall that meets the sink's, and not far along it.
void RelationBuilder::turn_other_leg(const std::vector<std::string>& units) {
  constexpr Mm kFromCorner = 1200;
  const auto washes =
      std::ranges::find_if(units, [&](const std::string& unit) { return noun_of_object(*object_of(unit)).entry->is(Trait::kWashUp); });
  const std::string main = washes == units.end() ? units.front() : *washes;
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation relation = scene_.relations[r];
    const bool at_other =
        (relation.type == R::kAgainstWall || relation.type == R::kOnWall) && relation.references.empty() && words_.have(relation, "other");
    for (const std::string& unit : relation.targets) {
      if (!at_other || unit == main || std::ranges::find(units, unit) == units.end()) continue;
      add_habit(R::kPerpendicular, {unit}, {main}, kTogether, "the legs of an L meet at a corner");
      scene_.relations.back().hard = true;
      add_habit(R::kDistance, {unit}, {main}, kTogether, "the legs of an L meet at a corner");
      scene_.relations.back().parameters.max = kFromCorner;
    }
  }
}

// The wall that a unit is told to be at, as words name it, or empty.
std::string RelationBuilder::told_wall_of(const std::string& unit) const {
  for (const std::size_t r : relations_of(unit)) {
    const Relation& at = scene_.relations[r];
    const bool wall = at.type == R::kAgainstWall || at.type == R::kCenteredOnWall;
    if (wall && at.references.size() == 1 && at.targets == std::vector{unit}) return at.references[0];
  }
  return {};
}

// "A sink facing the range": at the wall across from it. And what is worked at is in the run that the text has a counter for.
void RelationBuilder::stand_at_walls_of_run(const std::vector<std::string>& units) {
  const auto conclude = [&](const std::string& unit, const std::string& wall, const char* why) {
    add_habit(R::kAgainstWall, {unit}, {wall}, kTogether, why).origin = Origin::kConcluded;
  };
  std::string of_counter;
  for (const std::string& unit : units) {
    const CatalogEntry* entry = noun_of_object(*object_of(unit)).entry;
    if (of_counter.empty() && entry->is(Trait::kCounter) && !entry->is(Trait::kWashUp)) of_counter = told_wall_of(unit);
  }
  for (const std::string& unit : units) {
    if (!told_wall_of(unit).empty()) continue;
    const std::vector<std::size_t> own = relations_of(unit);
    const auto looks = std::ranges::find_if(own, [&](std::size_t r) {
      const Relation& look = scene_.relations[r];
      return look.type == R::kFacing && look.targets == std::vector{unit} && look.references.size() == 1 &&
             stands_in_run(look.references[0]);
    });
    if (looks != own.end()) {
      const std::string across = wall_across(told_wall_of(scene_.relations[*looks].references[0]));
      if (!across.empty()) conclude(unit, across, "what faces a unit is at the wall across from it");
      continue;
    }
    const CatalogEntry* entry = noun_of_object(*object_of(unit)).entry;
    const bool placed = std::ranges::any_of(own, [&](std::size_t r) {
      const RelationTraits& traits = traits_of(scene_.relations[r].type);
      return scene_.relations[r].asked() && !traits.sideways && !traits.close_by;
    });
    if (!of_counter.empty() && !placed && (entry->is(Trait::kWashUp) || entry->is(Trait::kHob)))
      conclude(unit, of_counter, "what is worked at is in the run");
  }
}

void RelationBuilder::settle_kitchen() {
  build_in_ovens();
  stand_hobs();
  const std::vector<std::string> units = units_of_run();
  if (units.size() < 2) return;
  for (Relation& relation : scene_.relations) place_in_run(relation, units);
  share_out_over_run(units);
  line_up_units(units);
  stand_at_walls_of_run(units);
  for (const KitchenForm& form : Dressings::builtin().kitchen_forms) {
    if (!Spoken(scene_, {}, catalog_).says_any(form.words)) continue;
    if (form.form == "L") turn_other_leg(units);
    if (form.form != "one wall") continue;
    for (std::size_t i = 1; i < units.size(); ++i)
      add_habit(R::kSameOrientation, {units[i]}, {units[0]}, kTogether, "the units of the kitchen stand along one wall");
  }
}

}  // namespace layoutbox::offline
