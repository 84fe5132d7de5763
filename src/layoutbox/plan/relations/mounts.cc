// How a thing is held where the relations say otherwise than its kind.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

bool is_beside(R type) {
  return traits_of(type).beside || type == R::kNear || type == R::kCorner || type == R::kAgainstWall || type == R::kCenterOfRoom ||
         type == R::kAtFootOf || type == R::kDistance || type == R::kAround || type == R::kOpposite;
}

}  // namespace

// What it is on a wall, where that is another kind: a shelf is a board there, a rug or a quilt a tapestry. Else null.
const CatalogEntry* RelationBuilder::wall_kind(const NounPhrase& noun) const {
  if (!noun.exact || mount_of(noun) == Mount::kWall) return nullptr;
  const CatalogEntry* entry = kind_at(catalog_, noun.entry->id, KinPlace::kOnWall);
  const bool cloth = noun.entry->thin || catalog_.is_a(noun.entry->id, "blanket");
  return entry == nullptr && cloth ? catalog_.find("tapestry") : entry;
}

// A shelf that is above something is one for the wall.
bool RelationBuilder::has_wall_kind(const NounPhrase& noun) const { return mount_of(noun) == Mount::kFloor && wall_kind(noun) != nullptr; }

// A shelf under what hangs on the wall is a board there: its kind for the wall has nothing inside.
bool RelationBuilder::is_board_under(const Relation& relation, const NounPhrase& noun) const {
  if (relation.type != R::kUnder || !has_wall_kind(noun) || relation.references.empty()) return false;
  const SceneObject* above = object_of(relation.references.front());
  if (above == nullptr || mount_of(noun_of_object(*above)) != Mount::kWall) return false;
  const std::vector<SpaceFormula>& spaces = wall_kind(noun)->spaces;
  return std::none_of(spaces.begin(), spaces.end(), [](const SpaceFormula& s) { return s.carries; });
}

// Things that stand on others: what is beside them does so as well.
bool RelationBuilder::only_small(const std::vector<std::string>& ids) const {
  return !ids.empty() && std::all_of(ids.begin(), ids.end(), [&](const std::string& id) {
    const auto found = objects_.find(id);
    return found != objects_.end() && is_small(found->second);
  });
}

// "a drip tray beneath the scooter": on the floor below.
bool RelationBuilder::is_under_piece(const Relation& relation) const {
  if (relation.type != R::kUnder) return false;
  return std::ranges::all_of(relation.references, [&](const std::string& id) {
    const SceneObject* over = object_of(id);
    return over != nullptr && mount_of(noun_of_object(*over)) == Mount::kFloor;
  });
}

RelationBuilder::Held RelationBuilder::how_held(const SceneObject& object, const NounPhrase& noun) const {
  Held held;
  for (const std::size_t r : relations_of(object.id)) {
    const Relation& relation = scene_.relations[r];
    held.wall |= relation.type == R::kOnWall || (relation.type == R::kAbove && has_wall_kind(noun)) || is_board_under(relation, noun);
    held.ceiling |= relation.type == R::kOnCeiling;
    held.above |= relation.type == R::kAbove && !relation.references.empty();
    held.supported |= traits_of(relation.type).supports;
    held.beside |= (is_beside(relation.type) || is_under_piece(relation)) && !only_small(relation.references);
  }
  return held;
}

// It is the first of these kinds that there is, where its own was named.
void RelationBuilder::specialise(SceneObject& object, const NounPhrase& noun, std::initializer_list<const char*> kinds) const {
  for (const char* kind : kinds) {
    const CatalogEntry* entry = catalog_.find(kind);
    if (entry == nullptr || !noun.exact) continue;
    object.category = entry->id;
    return;
  }
}

// "A TV on a stand": what such a thing stands on first of all, where that is called so for short.
void RelationBuilder::settle_stands() {
  for (const Relation& on : scene_.relations) {
    if (on.type != R::kOn || on.targets.size() != 1 || on.references.size() != 1) continue;
    const SceneObject* target = object_of(on.targets[0]);
    const CatalogEntry* guest = target == nullptr ? nullptr : noun_of_object(*target).entry;
    const auto host = std::ranges::find(scene_.objects, on.references[0], &SceneObject::id);
    if (guest == nullptr || guest->stands_on.empty() || host == scene_.objects.end()) continue;
    const std::string& usual = guest->stands_on.front();
    if (std::ranges::find(guest->stands_on, host->category) != guest->stands_on.end()) continue;  // a microphone on a plain desk
    const bool for_short = usual.ends_with("_" + host->category) && !catalog_.is_a(usual, host->category);
    if (for_short && catalog_.find(usual) != nullptr) host->category = usual;
  }
}

// "Rows of shelves in the middle": the rows are about it, not each of them.
void RelationBuilder::leave_middle_to_rows() {
  constexpr std::size_t kMany = 3;
  for (Relation& middle : scene_.relations) {
    if (middle.type != R::kCenterOfRoom || middle.targets.size() < kMany) continue;
    const auto is_grid = [&](const Relation& r) { return r.type == R::kGrid && r.targets == middle.targets; };
    if (std::ranges::any_of(scene_.relations, is_grid)) middle.hard = false;
  }
}

void RelationBuilder::settle_on_wall(SceneObject& object, const NounPhrase& noun) {
  object.mount = Mount::kWall;
  const CatalogEntry* on_wall = wall_kind(noun);
  if (on_wall != nullptr) {
    object.category = on_wall->id;
    // A board has a top and no inside.
    const bool inside = std::any_of(on_wall->spaces.begin(), on_wall->spaces.end(), [](const SpaceFormula& s) { return s.carries; });
    for (Relation& relation : scene_.relations) {
      if (!inside && relation.type == R::kIn && !relation.references.empty() && relation.references.front() == object.id)
        relation.type = R::kOn;
    }
  }
  if (is_lamp(catalog_, noun) && mount_of(noun) != Mount::kWall) specialise(object, noun, {"wall_lamp", "sconce"});
}

// "four cushions around the low table", "a floor globe": they lie and stand on the floor, whatever such things mostly do.
bool RelationBuilder::settle_on_floor(SceneObject& object, const NounPhrase& noun) {
  const auto says = [&](std::string_view word) { return std::ranges::find(noun.attributes, word) != noun.attributes.end(); };
  const bool floor = noun.name.starts_with("floor ") || says("floor-standing") || says("freestanding") || says("free-standing");
  const CatalogEntry* form =
      noun.exact && noun.entry->is(Trait::kKeptLow) ? kind_at(catalog_, noun.entry->id, KinPlace::kOnFloor) : nullptr;
  const bool low = form != nullptr && std::ranges::any_of(relations_of(object.id), [&](std::size_t r) {
                     const Relation& relation = scene_.relations[r];
                     const bool below = relation.type == R::kUnder || relation.type == R::kTuckedUnder;  // in a den
                     return traits_of(relation.type).around || (below && relation.targets.front() == object.id);
                   });
  if (mount_of(noun) != Mount::kSurface || (!floor && !low)) return false;
  const auto is_on = [&](const Relation& r) { return r.type == R::kOn && std::ranges::find(r.targets, object.id) != r.targets.end(); };
  for (const std::size_t r : relations_of(object.id)) {
    if (is_on(scene_.relations[r]) && scene_.relations[r].origin == Origin::kAsked) return false;
  }
  for (Relation& relation : scene_.relations) {
    if (!is_on(relation)) continue;
    relation.type = R::kNear;
    relation.hard = false;
  }
  object.mount = Mount::kFloor;
  if (low) object.category = form->id;
  return true;
}

// "tall shelves on every wall": not boards on it; they stand along it.
bool RelationBuilder::settle_tall(SceneObject& object, const NounPhrase& noun) {
  if (!is_tall(noun) || mount_of(noun) != Mount::kFloor || wall_kind(noun) == nullptr || noun.entry->thin) return false;
  for (const std::size_t r : relations_of(object.id)) {
    if (scene_.relations[r].type == R::kOnWall) scene_.relations[r].type = R::kAgainstWall;
  }
  return !how_held(object, noun).wall;
}

void RelationBuilder::settle_mount(std::size_t index) {
  SceneObject& object = scene_.objects[index];
  const NounPhrase& noun = document_.items[index].noun;
  if (settle_on_floor(object, noun)) return;
  const auto like = std::count_if(document_.items.begin(), document_.items.begin() + static_cast<std::ptrdiff_t>(index),
                                  [&](const TextItem& item) { return item.noun.first == noun.first; });
  if (noun.everywhere && like % 2 == 1 && mount_of(noun) == Mount::kSurface && !how_held(object, noun).supported) {
    object.mount = Mount::kFloor;
    return;
  }
  if (settle_tall(object, noun)) return;
  const Held held = how_held(object, noun);
  // "a bench with a lamp above it": a lamp for tables stands on nothing there.
  const bool over = held.above && !held.supported && !held.wall && mount_of(noun) == Mount::kSurface && is_lamp(catalog_, noun);
  // "a bedroom with fairy lights", "… above the bed": at a wall, not in mid-air.
  const bool festoon = noun.entry != nullptr && noun.entry->mount == Mount::kCeiling && noun.entry->is(Trait::kElseOnWall);
  if (festoon && !held.ceiling && !over_table(object.id)) {
    object.mount = Mount::kWall;
    return;
  }
  if (held.ceiling || over) {
    object.mount = Mount::kCeiling;
    const CatalogEntry* form =
        noun.exact && noun.entry->mount != Mount::kCeiling ? kind_at(catalog_, noun.entry->id, KinPlace::kOnCeiling) : nullptr;
    if (form != nullptr) {
      object.category = form->id;
    } else if (is_lamp(catalog_, noun) && mount_of(noun) != Mount::kCeiling)
      specialise(object, noun, {"pendant_lamp", "pendant_light", "ceiling_lamp"});
    return;
  }
  if (held.wall) return settle_on_wall(object, noun);
  if (held.supported && (hangs_on_hooks(object.id) || is_said_to_hang(index))) {
    object.mount = Mount::kHung;
    return;
  }
  if (held.supported && lies_folded(object.id, noun)) {
    object.mount = Mount::kSurface;
    object.category = "clothing";
    return;
  }
  if (held.supported && mount_of(noun) == Mount::kFloor && is_carried(object.id)) {
    // A plant on a shelf is a small one.
    object.mount = Mount::kSurface;
    const CatalogEntry* form = noun.exact ? kind_at(catalog_, noun.entry->id, KinPlace::kOnThing) : nullptr;
    if (form != nullptr) object.category = form->id;
    return;
  }
  if (held.supported || mount_of(noun) != Mount::kSurface || !held.beside) return;
  if (noun.entry->is(Trait::kElseOnWall)) return;              // where nothing there carries it
  if (catalog_.is_a(noun.entry->id, "cash_register")) return;  // "a till by the door": on a counter, which comes with it
  object.mount = Mount::kFloor;
  object.mount_assumed = true;
  // "a lamp", "a reading lamp behind the armchair"
  const CatalogEntry* form = noun.exact && is_lamp(catalog_, noun) ? kind_at(catalog_, noun.entry->id, KinPlace::kOnFloor) : nullptr;
  if (form != nullptr) object.category = form->id;
}

bool RelationBuilder::over_table(const std::string& object) const {
  const std::vector<std::size_t>& all = relations_of(object);
  return std::any_of(all.begin(), all.end(), [&](std::size_t i) {
    const Relation& r = scene_.relations[i];
    const SceneObject* below = r.type == R::kAbove && !r.references.empty() ? object_of(r.references.front()) : nullptr;
    if (below == nullptr) return false;
    const NounPhrase& noun = noun_of_object(*below);
    return is_table(catalog_, noun) && !(noun.entry != nullptr && noun.entry->is(Trait::kDeskLike));
  });
}

bool RelationBuilder::hangs_on_hooks(const std::string& object) const {
  const std::vector<std::size_t>& all = relations_of(object);
  return std::any_of(all.begin(), all.end(), [&](std::size_t i) {
    const Relation& r = scene_.relations[i];
    if (!traits_of(r.type).rests || r.references.empty()) return false;
    const SceneObject* host = object_of(r.references.front());
    if (host == nullptr) return false;
    // A coat stand has no top and no inside: on it things hang.
    const CatalogEntry* entry = noun_of_object(*host).entry;
    const bool stand = entry != nullptr && entry->is(Trait::kCoatStand) && entry->spaces.empty() && !entry->top_carries;
    return stand || has_hooks(noun_of_object(*host));
  });
}

// "hand saws hang on a panel on the wall", "a slatted panel from which helmets hang": as is said, where what carries them is flat.
bool RelationBuilder::is_said_to_hang(std::size_t index) const {
  const bool said = std::ranges::any_of(document_.links, [&](const Link& link) {
    return link.kind == Link::Kind::kHang && std::ranges::any_of(link.targets, [&](int m) {
             return std::ranges::find(mention(m).items, static_cast<int>(index)) != mention(m).items.end();
           });
  });
  const std::vector<std::size_t>& all = relations_of(scene_.objects[index].id);
  return said && std::any_of(all.begin(), all.end(), [&](std::size_t i) {
           const Relation& r = scene_.relations[i];
           const SceneObject* host = traits_of(r.type).rests && !r.references.empty() && r.targets.front() == scene_.objects[index].id
                                         ? object_of(r.references.front())
                                         : nullptr;
           if (host == nullptr) return false;
           const NounPhrase& noun = noun_of_object(*host);
           const bool flat = noun.entry == nullptr || (noun.entry->spaces.empty() && !noun.entry->top_carries);
           return flat && (mount_of(noun) == Mount::kWall || mount_of(noun) == Mount::kCeiling || how_held(*host, noun).wall);
         });
}

// "a jacket draped over the chair", "a bathrobe lies on the stool": clothes on what has no hooks and is not made for them.
bool RelationBuilder::lies_folded(const std::string& object, const NounPhrase& noun) const {
  if (noun.entry == nullptr || !catalog_.is_a(noun.entry->id, "garment") || catalog_.find("clothing") == nullptr) return false;
  const std::vector<std::size_t>& all = relations_of(object);
  return std::any_of(all.begin(), all.end(), [&](std::size_t i) {
    const Relation& r = scene_.relations[i];
    const SceneObject* host = r.type != R::kOn || r.references.empty() ? nullptr : object_of(r.references.front());
    if (host == nullptr || noun_of_object(*host).entry == nullptr) return false;
    const NounPhrase& carrier = noun_of_object(*host);
    const auto hangs_there = [&](const std::string& kind) { return catalog_.is_a(carrier.entry->id, kind); };
    const bool flat = carrier.entry->top_carries || carrier.entry->thin || carrier.entry->is(Trait::kBed) || is_sat_on(carrier);
    return flat && std::ranges::none_of(noun.entry->stands_on, hangs_there);
  });
}

bool RelationBuilder::is_carried(const std::string& object) const {
  const std::vector<std::size_t>& all = relations_of(object);
  return std::any_of(all.begin(), all.end(), [&](std::size_t i) {
    const Relation& r = scene_.relations[i];
    if (!traits_of(r.type).rests || r.references.empty()) return false;
    if (r.references.front().starts_with("window")) return true;  // on its sill
    const SceneObject* host = object_of(r.references.front());
    if (host == nullptr) return false;
    const CatalogEntry* entry = noun_of_object(*host).entry;
    return entry == nullptr || !entry->thin;
  });
}

}  // namespace layoutbox::offline
