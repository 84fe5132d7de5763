// What is as long as the wall that it stands along.
#include <algorithm>

#include "layoutbox/plan/relations/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;

// "a counter along the back wall" of a shop: half the wall long, where its kind is made so long.
void RelationBuilder::lengthen_counters() {
  constexpr int kPartOfWall = 2;
  if (scene_.room.polygon.size() != 4) return;
  const Point far = scene_.room.polygon[2];
  for (const Relation& along : scene_.relations) {
    if (along.type != R::kAgainstWall || along.targets.size() != 1 || along.references.size() != 1 || !words_.have(along, "along"))
      continue;
    const auto object = std::ranges::find(scene_.objects, along.targets.front(), &SceneObject::id);
    const CatalogEntry* entry = object == scene_.objects.end() || object->size ? nullptr : noun_of_object(*object).entry;
    const std::optional<Side> side = room_side_from_word(along.references.front());
    if (entry == nullptr || !side || !entry->is(Trait::kCounter) || !entry->is(Trait::kOpenToRoom)) continue;
    const Mm length = (*side == Side::kLeft || *side == Side::kRight ? far.y : far.x) / kPartOfWall;
    SizeRange range = entry->size;
    range.usual.width = std::clamp(length, range.usual.width, std::max(range.usual.width, range.greatest.width));
    object->size = range;
    object->size_source = SizeSource::kInferred;
  }
}

// "a wardrobe along the whole left wall": as long as the wall, or as what else has to be there lets it be.
void RelationBuilder::fill_whole_walls() {
  Point far = scene_.room.polygon.size() == 4 ? scene_.room.polygon[2] : Point{};
  const bool sized = !scene_.room.polygon.empty() || scene_.room.area_m2 || !scene_.room.size_word.empty();
  const RoomKind* kind = sized ? nullptr : catalog_.find_room(scene_.room.type);
  if (kind != nullptr) far = {kind->usual_size.width, kind->usual_size.depth};
  if (far.x == 0) return;
  for (const Relation& along : scene_.relations) {
    if (along.type != R::kAgainstWall || along.targets.size() != 1 || !words_.have(along, WordSet::kWholeWalls)) continue;
    const auto object = std::ranges::find(scene_.objects, along.targets.front(), &SceneObject::id);
    const auto has_width = [](const SceneObject& o) { return o.size && o.size->least.width == o.size->greatest.width; };
    if (object == scene_.objects.end() || (object->size_source == SizeSource::kUser && has_width(*object))) continue;
    const CatalogEntry* entry = noun_of_object(*object).entry;
    if (entry == nullptr || !entry->back_to_wall || entry->mount != Mount::kFloor) continue;
    const std::optional<Side> side = along.references.empty() ? std::nullopt : room_side_from_word(along.references.front());
    const bool across = side == Side::kLeft || side == Side::kRight;
    const Mm length = !side ? std::max(far.x, far.y) : across ? far.y : far.x;
    constexpr Mm kAir = 20;
    constexpr int kLeastPart = 2;  // of the wall: the rest is a door's
    SizeRange range = object->size.value_or(entry->size);
    range.least.width = std::max(length / kLeastPart, std::min(range.least.width, length - kAir));
    range.usual.width = range.greatest.width = length - kAir;
    object->size = range;
    if (object->size_source != SizeSource::kUser) object->size_source = SizeSource::kInferred;
  }
}

// "three rows of benches behind a low rail": the rail goes along all of a row, and the last row is as much behind it as the first.
bool RelationBuilder::add_rows_behind(const Link& link, const PhraseSense& sense, const Mention& target, int barrier) {
  constexpr Mm kThin = 120, kFarthest = 8000, kBetween = 100;
  const int rows = target.noun.rows, count = static_cast<int>(target.items.size());
  const CatalogEntry *entry = noun_of_item(barrier).entry, *member = target.noun.entry;
  const auto object = std::ranges::find(scene_.objects, id(barrier), &SceneObject::id);
  const bool parts = entry != nullptr && entry->mount == Mount::kFloor && entry->size.usual.depth <= kThin;
  if (sense.type != R::kBehind || rows < 2 || !parts || member == nullptr || object == scene_.objects.end()) return false;
  if (object->size_source != SizeSource::kUser) {
    const Mm length = (count + rows - 1) / rows * (member->size.usual.width + kBetween);
    SizeRange range = object->size.value_or(entry->size);
    range.usual.width = range.greatest.width = std::max(range.usual.width, length);
    object->size = range;
    object->size_source = SizeSource::kInferred;
  }
  for (const int item : target.items) {
    add(link, R::kBehind, {id(item)}, {id(barrier)});
    scene_.relations.back().parameters.max = kFarthest;
  }
  Link along = link;
  along.concluded = true;
  add(along, R::kSameOrientation, {id(target.items.front())}, {id(barrier)});
  return true;
}

}  // namespace layoutbox::offline
