// What a text puts on a top before it names the thing: where it then says to be, it is there.
#include <algorithm>
#include <array>
#include <utility>

#include "layoutbox/plan/relations/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

// "in the left half", "in the back left corner": which part of a top that is; empty where it is none.
ThingPart part_of_top(const Relation& place) {
  static constexpr std::array kSides = {std::pair{Side::kBack, "back"}, std::pair{Side::kFront, "front"}, std::pair{Side::kLeft, "left"},
                                        std::pair{Side::kRight, "right"}};
  const bool corner = place.type == R::kCorner && place.references.size() == 2;
  const bool region = place.type == R::kInRegion && place.references.empty() && place.parameters.region;
  if (!corner && !region) return {};
  std::string text;
  for (const auto& [side, name] : kSides) {
    const bool says =
        corner ? std::ranges::find(place.references, name) != place.references.end() : lies_at(*place.parameters.region, side);
    if (says) text += (text.empty() ? "" : " ") + std::string(name);
  }
  if (corner && !text.empty()) text += " corner";
  return ThingPart(text);
}

}  // namespace

// "On the desk a lamp in the back left corner": of the desk's top.
void RelationBuilder::place_on_tops() {
  for (Relation& place : scene_.relations) {
    const ThingPart part = place.asked() && place.targets.size() == 1 ? part_of_top(place) : ThingPart{};
    const SceneObject* thing = part.empty() ? nullptr : object_of(place.targets.front());
    if (thing == nullptr || words_.have(place, WordSet::kWholeRoom)) continue;
    const std::size_t named = noun_of_object(*thing).first;
    for (const std::size_t r : relations_of(thing->id)) {
      const Relation& on = scene_.relations[r];
      if (on.type != R::kOn || !on.asked() || on.references.size() != 1 || object_of(on.references.front()) == nullptr) continue;
      if (!words_.are_before(on, named) || words_.are_before(place, named)) continue;
      place.type = R::kOn;
      place.references = on.references;
      place.parameters = {};
      place.parameters.part = part;
      break;
    }
  }
}

}  // namespace layoutbox::offline
