// What a reader takes for granted; soft, and marked as ours.
#include <algorithm>
#include <cmath>
#include <map>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

std::size_t columns_of(const Relation& grid) {
  const int even = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(grid.targets.size()))));
  return static_cast<std::size_t>(grid.parameters.columns.value_or(even));
}

bool at_wall(R type) { return says_too(type, R::kAgainstWall) || type == R::kSideAgainstWall; }

}  // namespace

// Nobody else is told to face the same.
bool RelationBuilder::alone_faces(const Relation& facing) const {
  const auto same = [&](const Relation& r) { return r.type == R::kFacing && r.references == facing.references; };
  return std::ranges::count_if(scene_.relations, same) == 1;
}

void RelationBuilder::face_as_group() {
  for (Relation& grid : scene_.relations) {
    const std::size_t n = grid.targets.size();
    const SceneObject* first = n == 0 ? nullptr : object_of(grid.targets.front());
    const CatalogEntry* kind = first == nullptr ? nullptr : noun_of_object(*first).entry;
    const auto as_wide = [&](Mm width) { return kind != nullptr && kind->size.usual.width >= width; };
    constexpr Mm kForOne = 1000, kForSeveral = 1500;  // three chairs have it ahead, of three desks only the middle one
    const bool row = grid.type == R::kRow && (n > 3 || (n == 3 && as_wide(kForOne)));
    if (!row && (grid.type != R::kGrid || n < 2)) continue;
    const std::size_t columns = row ? n : columns_of(grid);
    // Pews in an even number of columns stand beside the axis: from the last row it is straight ahead, from the first it is not.
    const bool wide = as_wide(kForSeveral) && columns % 2 == 0 && n > columns;
    const std::size_t leader = (wide ? (n - 1) / columns * columns : 0) + (columns - 1) / 2;
    const std::string& middle = grid.targets[std::min(leader, n - 1)];
    for (Relation& facing : scene_.relations) {
      const bool told = facing.type == R::kFacing && facing.targets.size() == 1;
      if (!told || std::ranges::find(grid.targets, facing.references.front()) != grid.targets.end()) continue;  // not: each other
      if (row && alone_faces(facing)) {  // "each facing a mirror" of its own: the mirrors hang in a row
        grid.hard = false;
        continue;
      }
      const auto at = std::find(grid.targets.begin(), grid.targets.end(), facing.targets[0]) - grid.targets.begin();
      const std::size_t column = static_cast<std::size_t>(at) % columns;
      if (static_cast<std::size_t>(at) == n || grid.targets[static_cast<std::size_t>(at)] == middle) continue;
      // How many columns suit the room is seen later: one of them leads.
      const bool known = row || grid.parameters.columns.has_value();
      if (known && !wide && (column == (columns - 1) / 2 || column == columns / 2)) continue;
      facing.type = R::kSameOrientation;
      facing.references = {middle};
    }
  }
}

// So do the many that stand before one thing without being called a grid: not all of them can have it straight ahead.
bool RelationBuilder::sits_at(const std::string& seat) const {
  const std::vector<std::size_t>& all = relations_of(seat);
  return std::any_of(all.begin(), all.end(), [&](std::size_t r) { return scene_.relations[r].type == R::kAlongSide; });
}

void RelationBuilder::face_as_crowd() {
  constexpr std::ptrdiff_t kCrowd = 7;
  const auto category_of = [&](const Relation& r) {
    return scene_.find_object(r.targets[0]) ? scene_.find_object(r.targets[0])->category : "";
  };
  for (std::size_t i = 0; i < scene_.relations.size(); ++i) {
    const Relation first = scene_.relations[i];
    if (first.type != R::kFacing || first.targets.size() != 1 || sits_at(first.targets[0])) continue;
    const auto alike = [&](const Relation& r) {
      return r.type == R::kFacing && r.targets.size() == 1 && r.references == first.references && category_of(r) == category_of(first);
    };
    if (std::count_if(scene_.relations.begin(), scene_.relations.end(), alike) < kCrowd) continue;
    for (std::size_t j = i + 1; j < scene_.relations.size(); ++j) {
      Relation& other = scene_.relations[j];
      if (!alike(other)) continue;
      other.type = R::kSameOrientation;
      other.references = first.targets;
    }
  }
}

Relation& RelationBuilder::add_habit(R type, std::vector<std::string> targets, std::vector<std::string> references, int weight,
                                     std::string why) {
  Relation habit;
  habit.id = "c" + std::to_string(scene_.relations.size() + 1);
  habit.type = type;
  habit.targets = std::move(targets);
  habit.references = std::move(references);
  habit.hard = false;
  habit.origin = Origin::kAssumed;
  habit.weight = weight;
  habit.why = std::move(why);
  scene_.relations.push_back(std::move(habit));
  return scene_.relations.back();
}

Relation& RelationBuilder::conclude(R type, std::vector<std::string> targets, std::vector<std::string> references, std::string why) {
  Relation& relation = add_habit(type, std::move(targets), std::move(references), kTogether, std::move(why));
  relation.hard = true;
  relation.origin = Origin::kConcluded;
  return relation;
}

// "the desks face the whiteboard, a bookshelf stands at the back": the front is where the board is, if the words leave that open.
void RelationBuilder::add_front() {
  const auto says_front_or_back = [&](const Relation& r) {
    const bool wall = !r.references.empty() && (r.references.front() == "front" || r.references.front() == "back") &&
                      words_.have(r, WordSet::kFrontOrBack);
    return (r.type == R::kInRegion && (r.parameters.region == RoomRegion::kFront || r.parameters.region == RoomRegion::kBack)) || wall;
  };
  if (std::none_of(scene_.relations.begin(), scene_.relations.end(), says_front_or_back)) return;
  for (const SceneObject& object : scene_.objects) {
    const NounPhrase& noun = noun_of_object(object);
    if (!one_of(noun.head, WordSet::kLookedAtByClass)) continue;
    const auto looks = [&](const Relation& r) {
      return traits_of(r.type).looks && !r.references.empty() && r.references.front() == object.id;
    };
    const bool many = std::count_if(scene_.relations.begin(), scene_.relations.end(), looks) >= 2;
    const std::vector<std::size_t>& own = relations_of(object.id);
    const bool at_front = std::any_of(own.begin(), own.end(), [&](std::size_t i) {
      return scene_.relations[i].type == R::kInRegion && scene_.relations[i].parameters.region == RoomRegion::kFront;
    });
    const bool placed = std::any_of(own.begin(), own.end(), [&](std::size_t i) {
      const Relation& r = scene_.relations[i];
      return r.type == R::kCenterOfRoom || (r.type == R::kInRegion && !at_front) || r.type == R::kCorner || r.type == R::kOpposite ||
             r.type == R::kOn || (at_wall(r.type) && !r.references.empty());
    });
    if (placed || !(many || at_front)) continue;
    of_target_[object.id].push_back(scene_.relations.size());
    add_habit(mount_of(noun) == Mount::kWall ? R::kOnWall : R::kAgainstWall, {object.id}, {"front"}, 100,
              "what rows of seats face is at the front of the room");
    scene_.relations.back().hard = true;  // and gives way to what was asked
    return;
  }
}

// "a bookcase at the back", "a wardrobe on the left of the room": what stands at walls stands at that one.
void RelationBuilder::add_end_walls() {
  show_where_seated();
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation region = scene_.relations[r];
    if (region.type != R::kInRegion || region.targets.size() != 1 || region.origin != Origin::kAsked) continue;
    const std::string_view end = region.parameters.region ? name_of(*region.parameters.region) : std::string_view();
    if (!one_of(end, {"back", "front", "left", "right"})) continue;
    if (words_.have(region, "half")) continue;  // anywhere in it
    const SceneObject* object = object_of(region.targets.front());
    const CatalogEntry* entry = object == nullptr ? nullptr : catalog_.find(object->category);
    if (entry == nullptr) continue;
    // "sofa and TV on the right": the screen is at the wall, and the sofa looks at it.
    const bool watches = (entry->is(Trait::kEasySeat) || entry->is(Trait::kCenterPiece)) && shows_in(*region.parameters.region);
    if (watches) continue;
    serve_towards_room(*object, std::string(end));
    const bool hangs = object->mount.value_or(entry->mount) == Mount::kWall || (entry->is(Trait::kScreen) && entry->is(Trait::kElseOnWall));
    // A kitchen's units go on to that end, and do not turn the corner there.
    const bool stands =
        entry->mount == Mount::kFloor && entry->back_to_wall && !entry->is(Trait::kDeskLike) && !entry->is(Trait::kKitchenRun);
    const bool flat = entry->mount == Mount::kFloor && 4 * entry->size.usual.depth <= entry->size.usual.width;  // a folding screen
    // A bench for those who wait, where no table is.
    const bool waits = one_of(noun_of_object(*object).head, {"bench"}) && object->mount.value_or(entry->mount) == Mount::kFloor &&
                       std::ranges::none_of(scene_.objects, [&](const SceneObject& o) { return is_table(catalog_, noun_of_object(o)); });
    if (!hangs && !stands && !flat && !waits) continue;
    const std::vector<std::size_t>& own = relations_of(object->id);
    // Of shelves in rows at the back only the last row is at the wall.
    const auto elsewhere = [&](std::size_t i) { return at_wall(scene_.relations[i].type) || scene_.relations[i].type == R::kGrid; };
    if (std::ranges::any_of(own, elsewhere)) continue;
    add_habit(hangs ? R::kOnWall : R::kAgainstWall, region.targets, {std::string(end)}, 80,
              "what stands at walls and at that end stands at the wall there");
  }
}

// "a sofa facing a ceiling-mounted screen": what is looked at and hangs free looks back.
void RelationBuilder::turn_screens_to_viewers() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation look = scene_.relations[r];
    if (look.type != R::kFacing || look.targets.size() != 1 || look.references.size() != 1) continue;
    const SceneObject* screen = object_of(look.references.front());
    const CatalogEntry* entry = screen == nullptr ? nullptr : catalog_.find(screen->category);
    const bool hangs = screen != nullptr && std::ranges::any_of(relations_of(screen->id),
                                                                [&](std::size_t i) { return scene_.relations[i].type == R::kOnCeiling; });
    if (hangs && entry != nullptr && entry->is(Trait::kScreen))
      add_habit(R::kFacing, {screen->id}, look.targets, kTogether, "a screen on the ceiling looks at who watches it");
  }
}

// "two beds with a shared bedside cabinet": the only one stands between the only two, where it has no place of its own.
void RelationBuilder::share_nightstand() {
  std::vector<std::string> beds, stands;
  std::string kind;
  for (const SceneObject& object : scene_.objects) {
    const CatalogEntry* entry = catalog_.find(object.category);
    if (entry == nullptr) continue;
    if (entry->is(Trait::kBed)) {
      beds.push_back(object.id);
      kind = entry->is(Trait::kClimbedInto) ? "-" : kind.empty() ? object.category : kind == object.category ? kind : "-";
    }
    if (entry->is(Trait::kBedside)) stands.push_back(object.id);
  }
  if (beds.size() != 2 || stands.size() != 1 || kind == "-") return;
  const std::vector<std::size_t> own = relations_of(stands.front());
  const auto by_bed = [&](std::size_t r) {
    const Relation& relation = scene_.relations[r];
    return relation.type == R::kNextTo && relation.references.size() == 1 &&
           std::ranges::find(beds, relation.references.front()) != beds.end();
  };
  if (!std::ranges::all_of(own, by_bed)) return;
  if (own.empty()) {
    add_habit(R::kBetween, stands, beds, kTogether, "two beds share their nightstand");
    return;
  }
  scene_.relations[own.front()].type = R::kBetween;
  scene_.relations[own.front()].references = beds;
}

// "three beds in a row": their heads at one wall.
void RelationBuilder::head_row_of_beds() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation row = scene_.relations[r];
    const auto is_bed = [&](const std::string& id) {
      const SceneObject* object = object_of(id);
      return object != nullptr && catalog_.entry_or_nearest(object->category).is(Trait::kBed);
    };
    if (row.type != R::kRow || row.targets.size() < 2 || !std::ranges::all_of(row.targets, is_bed)) continue;
    const auto placed = [&](const Relation& other) {
      return traits_of(other.type).turns && !other.references.empty() && std::ranges::any_of(other.targets, [&](const std::string& id) {
               return std::ranges::find(row.targets, id) != row.targets.end();
             });
    };
    if (std::ranges::any_of(scene_.relations, placed)) continue;
    add_habit(R::kAgainstWall, row.targets, {}, kTogether, "beds in a row have their heads at the wall");
    add_habit(R::kSameOrientation, row.targets, {}, kTogether, "beds in a row have their heads at the wall");
  }
}

// "four booths along one wall", "five bookcases against a wall": all at the same one.
void RelationBuilder::keep_to_one_wall() {
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> along;  // by kind and by what was said
  for (const Relation& relation : scene_.relations) {
    const bool one = words_.have_phrase(relation, {"one", "wall"}) || words_.have_phrase(relation, {"a", "wall"}) ||
                     words_.have_phrase(relation, {"the", "wall"});
    const SceneObject* object = relation.targets.size() == 1 ? object_of(relation.targets[0]) : nullptr;
    if (relation.type == R::kAgainstWall && relation.references.empty() && one && object != nullptr)
      along[{object->category, relation.why}].push_back(object->id);
  }
  for (const auto& [said, things] : along) {
    if (things.size() > 1) add_habit(R::kRow, things, {}, kTogether, "several along a wall are all at that one");
  }
}

// "two rows of four desks back to back": an island of two rows, which is how such desks stand anyhow.
void RelationBuilder::make_islands() {
  const auto backs = [&](const Relation& r) { return words_.have_phrase(r, {"back", "to", "back"}); };
  const auto row = std::ranges::find_if(scene_.relations, [&](const Relation& r) { return r.type == R::kRow && backs(r); });
  if (row == scene_.relations.end()) return;
  const std::vector<std::string> desks = row->targets;
  const bool two_rows = std::ranges::any_of(scene_.relations, [&](const Relation& r) {
    return r.type == R::kGrid && r.targets == desks && static_cast<std::size_t>(2 * r.parameters.columns.value_or(0)) == desks.size();
  });
  if (!two_rows) return;
  std::erase_if(scene_.relations, [&](const Relation& r) { return (r.type == R::kGrid && r.targets == desks) || backs(r); });
}

void RelationBuilder::add_habits() {
  hang_bed_curtains();
  place_by_covered_windows();
  hang_within();
  stand_within();
  stand_before_sitters();
  sit_in_aids();
  touch_back_to_back();
  middle_what_is_surrounded();
  add_front();
  share_doors();
  seat_in_windows();
  sit_in_u();
  sit_across_table();
  leave_room_to_serve();
  leave_room_at_wall();
  turn_to_what_hangs_over();
  stand_abreast();
  stand_between_likes();
  stand_at_ends();
  stand_rows_in_halves();
  watch_from_afar();
  stand_under_wall_cabinets();
  sit_together();
  sit_at_windows();
  work_at_windows();
  park_cars();
  sit_before_mirrors();
  stand_under_counters();
  hang_hoods();
  add_end_walls();
  face_as_group();
  face_as_crowd();
  lay_beds_along();
  lie_along_walls();
  wait_at_walls();
  share_nightstand();
  head_row_of_beds();
  keep_to_one_wall();
  turn_two_sided_tables();
  turn_screens_to_viewers();
  seat_around_faced_tables();
  seat_those_who_wait();
  seat_at_placed_table();
  seat_at_only_table();
  seat_viewers();
  screen_from_door();
  hang_mirrors_over_counters();
  stand_before_middles();
  keep_sides_near();
  dine_at_plain_tables();
}

}  // namespace layoutbox::offline
