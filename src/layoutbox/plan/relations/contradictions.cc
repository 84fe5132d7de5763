// What the text says of a thing that cannot all be true; all of it goes to the solver, which gives up the weakest.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

bool backs_to_wall(R type) { return traits_of(type).back_to_wall; }

bool names_walls(const Relation& relation) { return !relation.references.empty() && relation.type != R::kUnderWindow; }

// Two neighbouring walls make a corner; left and right, front and back do not.
bool walls_meet(const Relation& a, const Relation& b) {
  const auto side = [](const std::string& w) { return w == "left" || w == "right"; };
  for (const std::string& one : a.references) {
    for (const std::string& two : b.references) {
      if (one == two || side(one) != side(two)) return true;
    }
  }
  return false;
}

bool contradict(const Relation& a, const Relation& b) {
  if (backs_to_wall(a.type) && backs_to_wall(b.type)) return names_walls(a) && names_walls(b) && !walls_meet(a, b);
  const bool middle = a.type == R::kCenterOfRoom || b.type == R::kCenterOfRoom;
  if (middle && (backs_to_wall(a.type) || backs_to_wall(b.type))) return true;
  if ((a.type == R::kOnWall && b.type == R::kOnCeiling) || (a.type == R::kOnCeiling && b.type == R::kOnWall)) return true;
  return !a.references.empty() && a.references == b.references && are_opposed(a.type, b.type);
}

}  // namespace

// "a room dominated by a bed against the wall", "centered on a fireplace in the back wall": so much of the room's middle is a manner of
// speaking.
void RelationBuilder::soften_middles() {
  for (Relation& middle : scene_.relations) {
    if (middle.type != R::kCenterOfRoom || !middle.asked() || middle.targets.size() != 1) continue;
    if (!words_.begin_with(middle, {WordSet::kAllAbout, WordSet::kAbout})) continue;
    const std::vector<std::size_t>& all = relations_of(middle.targets.front());
    if (std::none_of(all.begin(), all.end(),
                     [&](std::size_t r) { return backs_to_wall(scene_.relations[r].type) && scene_.relations[r].asked(); }))
      continue;
    middle.hard = false;
    middle.origin = Origin::kConcluded;
  }
}

// "Overhead, a chandelier hangs in the center of the room": over nothing else that was named.
void RelationBuilder::soften_overhead() {
  for (Relation& over : scene_.relations) {
    if (over.type != R::kAbove || !over.asked() || over.targets.size() != 1 || !words_.have(over, "overhead")) continue;
    const std::vector<std::size_t>& all = relations_of(over.targets.front());
    if (std::none_of(all.begin(), all.end(), [&](std::size_t r) { return scene_.relations[r].type == R::kCenterOfRoom; })) continue;
    over.hard = false;
    over.origin = Origin::kConcluded;
  }
}

// "Along the window" of glass down to the floor: before it.
void RelationBuilder::stand_before_glass() {
  constexpr Mm kBeforeGlass = 300;
  for (Relation& under : scene_.relations) {
    const SceneObject* thing = under.type == R::kUnderWindow && under.targets.size() == 1 ? object_of(under.targets[0]) : nullptr;
    const CatalogEntry* entry = thing == nullptr ? nullptr : noun_of_object(*thing).entry;
    if (entry == nullptr) continue;
    const auto is_below = [&](const Opening& window) {
      const bool meant = under.references.empty() || std::ranges::find(under.references, window.id) != under.references.end();
      return window.type == OpeningType::kWindow && meant && 2 * window.sill >= entry->size.usual.height;
    };
    const bool glass = std::ranges::any_of(scene_.room.openings, [](const Opening& o) { return o.type == OpeningType::kWindow; });
    if (!glass || std::ranges::any_of(scene_.room.openings, is_below)) continue;
    const bool low = std::ranges::all_of(scene_.room.openings,
                                         [](const Opening& o) { return o.type != OpeningType::kWindow || o.sill <= kBeforeGlass; });
    if (!low) continue;
    under.type = R::kNearWindow;
    under.parameters.max = kBeforeGlass;
  }
}

// "the bed in the middle with its head against the wall": in the middle of the wall.
void RelationBuilder::center_on_walls() {
  for (Relation& wall : scene_.relations) {
    if (wall.type != R::kAgainstWall || !wall.asked() || wall.targets.size() != 1) continue;
    const std::size_t first = static_cast<std::size_t>(&wall - scene_.relations.data());
    for (const std::size_t r : relations_of(wall.targets.front())) {
      Relation& middle = scene_.relations[r];
      const bool of_wall = words_.end_with(middle, WordSet::kMiddles);  // not "of the room"
      if (r == first || middle.type != R::kCenterOfRoom || middle.targets.size() != 1 || !of_wall) continue;
      wall.type = R::kCenteredOnWall;
      middle.hard = false;
      middle.origin = Origin::kConcluded;
    }
  }
}

void RelationBuilder::note_contradictions() {
  center_on_walls();
  soften_middles();
  soften_overhead();
  stand_before_glass();
  constexpr std::size_t kMost = 20;  // relations of one thing that are compared
  for (const SceneObject& object : scene_.objects) {
    const std::vector<std::size_t>& all = relations_of(object.id);
    for (std::size_t a = 0; a < std::min(all.size(), kMost); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Relation &one = scene_.relations[all[b]], &other = scene_.relations[all[a]];
        if (words_.are_one(one, other) || !one.asked() || !other.asked() || !contradict(one, other)) continue;
        scene_.notes.push_back(
            {"contradiction", "\"" + object.name + "\" cannot be \"" + one.why + "\" and \"" + other.why + "\"", "prompt"});
      }
    }
  }
}

}  // namespace layoutbox::offline
