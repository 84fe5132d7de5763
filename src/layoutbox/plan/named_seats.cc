#include "layoutbox/plan/named_seats.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {
namespace {

constexpr std::string_view kToRest[] = {"comfy ", "comfortable ", "easy ", "lounge ", "reading ", "wing ", "tub ", "club ", "accent "};

}  // namespace

NamedSeats::NamedSeats(const GrowingScene& scene, const Catalog& catalog) {
  const auto is_at = [&](const std::string& host, bool desk) {
    const SceneObject* object = scene.find(host);
    if (object == nullptr) return false;
    const CatalogEntry& kind = catalog.entry_or_nearest(object->category);
    return kind.is(Trait::kTable) && kind.is(Trait::kDesk) == desk && !kind.is(Trait::kOccasional);
  };
  const auto is_table = [&](const std::string& host) { return is_at(host, false); };
  const auto is_desk = [&](const std::string& host) { return is_at(host, true); };
  bool concluded = false, asked = false, easy = false, all_at_tables = true, all_at_desks = true;
  for (const SceneObject& object : scene.graph().objects) {
    concluded |= object.origin == Origin::kConcluded;
    const CatalogEntry& kind = catalog.entry_or_nearest(object.category);
    // "an armless chair" may be the desk's, "a comfy chair" is not
    const bool comfy = std::ranges::any_of(kToRest, [&](std::string_view word) { return object.name.starts_with(word); });
    const bool chair = object.name.ends_with(" chair") && !comfy;
    easy |= object.asked() && kind.is(Trait::kSeat) && !kind.is(Trait::kTableSeat) && !chair;
    if (!kind.is(Trait::kTableSeat)) continue;
    bool placed = false, at_table = false, at_desk = false;
    for (const std::size_t r : scene.relations_of(object.id)) {
      const Relation& relation = scene.graph().relations[r];
      placed |= !relation.references.empty() || relation.type == RelationType::kAgainstWall;
      at_table |= std::ranges::any_of(relation.references, is_table);
      at_desk |= std::ranges::any_of(relation.references, is_desk);
    }
    loose |= !placed && !kind.is(Trait::kVisitorSeat);
    asked |= object.asked();
    all_at_tables &= at_table || !object.asked();
    all_at_desks &= at_table || at_desk || !object.asked();
  }
  spoken_of = !concluded || asked;
  easy_only = easy && !asked;
  taken = asked && all_at_tables;
  at_desks = asked && all_at_desks;
}

}  // namespace layoutbox
