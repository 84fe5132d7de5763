// Screens and those who watch them: who has a screen looks at it, where he sits.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// "TV on the left wall with a sofa and two armchairs": who watches it looks at that wall and has no back to it.
void RelationBuilder::seat_viewers() {
  for (Relation& at : scene_.relations) {
    if (at.type != R::kAgainstWall || at.targets.size() != 1 || at.references.size() != 1) continue;
    if (!at.asked() || words_.have(at, WordSet::kWalls)) continue;  // said of the seat itself, or that such things stand at walls
    const SceneObject* seat = object_of(at.targets[0]);
    const CatalogEntry* entry = seat == nullptr ? nullptr : noun_of_object(*seat).entry;
    if (entry == nullptr || !(entry->is(Trait::kEasySeat) || entry->is(Trait::kCenterPiece))) continue;
    const auto shows_there = [&](const Relation& r) {
      const SceneObject* screen = r.type == R::kOnWall && r.references == at.references ? object_of(r.targets[0]) : nullptr;
      const CatalogEntry* shown = screen == nullptr ? nullptr : noun_of_object(*screen).entry;
      return shown != nullptr && shown->is(Trait::kScreen);
    };
    const auto shown = std::ranges::find_if(scene_.relations, shows_there);
    if (shown == scene_.relations.end()) continue;
    at.type = entry->is(Trait::kCenterPiece) ? R::kOpposite : R::kFacing;
    at.references = {shown->targets[0]};
    at.hard = entry->is(Trait::kCenterPiece);  // the others may sit round the table
  }
}

// "a sofa looking at the TV": from as far off as one watches it, some one and a half to three widths of a usual screen (1.23 m).
void RelationBuilder::watch_from_afar() {
  constexpr Mm kNearest = 1700, kFarthest = 4200;
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation look = scene_.relations[r];
    const bool before = look.type == R::kInFrontOf;  // "two recliners in front of a TV"
    if ((look.type != R::kFacing && !before) || look.targets.size() != 1 || look.references.size() != 1) continue;
    const SceneObject *seat = object_of(look.targets[0]), *screen = object_of(look.references[0]);
    const CatalogEntry *sits = seat == nullptr ? nullptr : catalog_.find(seat->category),
                       *shown = screen == nullptr ? nullptr : catalog_.find(screen->category);
    const bool watches = sits != nullptr && shown != nullptr && is_seat(catalog_, noun_of_object(*seat)) &&
                         (sits->is(Trait::kCenterPiece) || (before && sits->is(Trait::kEasySeat))) && shown->is(Trait::kScreen) &&
                         shown->is(Trait::kElseOnWall);
    const auto told = [&](std::size_t i) {
      return scene_.relations[i].references == look.references && traits_of(scene_.relations[i].type).beside;
    };
    const std::vector<std::size_t>& all = relations_of(seat->id);
    if (!watches || std::ranges::any_of(all, [&](std::size_t i) { return i != r && told(i); })) continue;
    if (before) scene_.relations[r].parameters.max = kFarthest;
    if (!before && told(r)) continue;
    Relation& far = add_habit(R::kDistance, look.targets, look.references, kTogether, "one watches a screen from some way off");
    far.parameters.min = kNearest, far.parameters.max = kFarthest;
  }
}

// Is a screen told to be in that part of the room?
bool RelationBuilder::shows_in(RoomRegion region) const {
  return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
    const SceneObject* screen = r.type == R::kInRegion && r.targets.size() == 1 ? object_of(r.targets[0]) : nullptr;
    const CatalogEntry* entry = screen == nullptr ? nullptr : catalog_.find(screen->category);
    return entry != nullptr && entry->is(Trait::kScreen) && r.parameters.region == region;
  });
}

// "a corner sofa with a TV on the right": a screen of which nothing else is said is in the part of the room where the sofa is.
void RelationBuilder::show_where_seated() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation region = scene_.relations[r];
    const SceneObject* seat = region.type == R::kInRegion && region.targets.size() == 1 ? object_of(region.targets[0]) : nullptr;
    const CatalogEntry* entry = seat == nullptr ? nullptr : catalog_.find(seat->category);
    if (entry == nullptr || !entry->is(Trait::kCenterPiece) || entry->is(Trait::kBed) || !region.asked()) continue;
    const auto is_screen = [&](const SceneObject& object) {
      const CatalogEntry* shown = catalog_.find(object.category);
      return shown != nullptr && shown->is(Trait::kScreen) && shown->is(Trait::kElseOnWall);
    };
    const auto screen = std::ranges::find_if(scene_.objects, is_screen);
    if (std::ranges::count_if(scene_.objects, is_screen) != 1 || !relations_of(screen->id).empty()) return;
    const auto shown = region.parameters.region;
    Relation& where = add_habit(R::kInRegion, {screen->id}, {}, kTogether, "a screen is where it is watched");
    where.parameters.region = shown;
    where.origin = Origin::kConcluded;
    return;
  }
}

}  // namespace layoutbox::offline
