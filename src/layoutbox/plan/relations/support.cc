// Support that carries on: a small thing beside a small thing that stands on something stands there too, though nobody said so.
#include <algorithm>
#include <queue>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

bool carries(R type) { return traits_of(type).supports; }

// Side by side at one height.
bool joins(R type) {
  return traits_of(type).beside || traits_of(type).around || type == R::kNear || type == R::kDistance || type == R::kRow ||
         type == R::kEvenlySpaced || type == R::kPairedWith;
}

// A place of its own that is no tabletop.
bool stands_elsewhere(R type) { return traits_of(type).placing == Placing::kInRoom || type == R::kOnWall || type == R::kOnCeiling; }

constexpr double kSmallArea = 0.16e6;  // mm²

double area_of(const NounPhrase& noun) {
  return noun.entry == nullptr ? 0 : 1.0 * noun.entry->size.usual.width * noun.entry->size.usual.depth;
}

// "a bottle next to a box of dryer sheets": what stands on the floor by itself, and beside a small thing where that stands.
bool is_light_box(const NounPhrase& noun) {
  return mount_of(noun) == Mount::kFloor && noun.entry != nullptr && area_of(noun) <= kSmallArea && one_of(noun.head, WordSet::kLightBoxes);
}

}  // namespace

std::string RelationBuilder::said_support(const std::string& object) const {
  for (const std::size_t r : relations_of(object)) {
    const Relation& relation = scene_.relations[r];
    if (carries(relation.type) && !relation.references.empty()) return relation.references.front();
  }
  return {};
}

// "a sofa with a coffee table, a TV opposite the sofa, a vase beside the TV": nothing there carries TVs, and it is not on the coffee table.
bool RelationBuilder::hangs_opposite(std::size_t index) const {
  const NounPhrase& noun = document_.items[index].noun;
  if (noun.entry == nullptr || !noun.entry->is(Trait::kElseOnWall) || !noun.entry->is(Trait::kScreen)) return false;
  const auto carries_it = [&](const SceneObject& o) {
    return std::ranges::any_of(noun.entry->stands_on, [&](const std::string& kind) { return catalog_.is_a(o.category, kind); });
  };
  return !std::ranges::any_of(scene_.objects, carries_it) &&
         std::ranges::any_of(relations_of(scene_.objects[index].id), [&](std::size_t r) {
           const Relation& relation = scene_.relations[r];
           const SceneObject* by = relation.references.empty() ? nullptr : object_of(relation.references.front());
           return relation.type == R::kOpposite && by != nullptr && is_seat(catalog_, noun_of_object(*by));
         });
}

bool RelationBuilder::is_small(std::size_t index) const {
  const NounPhrase& noun = document_.items[index].noun;
  const std::vector<std::size_t>& all = relations_of(scene_.objects[index].id);
  // What no list has may be small, and so is what stands on another piece.
  const bool unknown = mount_of(noun) == Mount::kFloor && (noun.entry == nullptr || (!noun.exact && area_of(noun) <= kSmallArea));
  // A screen at one end of the room hangs there.
  const bool hangs = noun.entry != nullptr && noun.entry->is(Trait::kElseOnWall) &&
                     std::ranges::any_of(all, [&](std::size_t r) { return scene_.relations[r].type == R::kInRegion; });
  if (hangs || hangs_opposite(index)) return false;
  return (mount_of(noun) == Mount::kSurface || unknown || is_light_box(noun) ||
          object_of(said_support(scene_.objects[index].id)) != nullptr) &&
         std::none_of(all.begin(), all.end(), [&](std::size_t r) { return stands_elsewhere(scene_.relations[r].type); });
}

// "On the mantel a clock; beside the clock, a photo": what is flat and hangs by itself leans there beside what stands on something.
bool RelationBuilder::may_lean(std::size_t index) const {
  constexpr Mm kSmall = 400;
  const NounPhrase& noun = document_.items[index].noun;
  if (!lies_or_hangs(noun) || !one_of(noun.head, WordSet::kMayStand) || !noun.exact ||
      std::max(noun.entry->size.usual.width, noun.entry->size.usual.height) > kSmall)
    return false;
  return std::ranges::none_of(relations_of(scene_.objects[index].id),
                              [&](std::size_t r) { return stands_elsewhere(scene_.relations[r].type); });
}

// Who stands beside whom, of the small things; things beside furniture or walls are left out.
std::vector<std::vector<std::size_t>> RelationBuilder::small_neighbours() const {
  std::vector<std::vector<std::size_t>> beside(scene_.objects.size());
  const auto index_of = [&](const std::string& id) {
    const auto found = objects_.find(id);
    return found == objects_.end() ? scene_.objects.size() : found->second;
  };
  for (const Relation& relation : scene_.relations) {
    if (!joins(relation.type)) continue;
    std::vector<std::size_t> all;
    for (const std::vector<std::string>* ids : {&relation.targets, &relation.references}) {
      for (const std::string& id : *ids) all.push_back(index_of(id));
    }
    if (!std::all_of(all.begin(), all.end(), [&](std::size_t i) { return i < scene_.objects.size() && (is_small(i) || may_lean(i)); }))
      continue;
    for (std::size_t i = 1; i < all.size(); ++i) {
      beside[all[0]].push_back(all[i]);
      beside[all[i]].push_back(all[0]);
    }
  }
  return beside;
}

// Of a small host that has no room for the thing (a coaster, a saucer) what that one stands on.
std::string RelationBuilder::host_with_room(std::string host, const NounPhrase& thing) const {
  constexpr int kMostSteps = 3;
  constexpr double kRoomForBoth = 2.5;
  for (int step = 0; step < kMostSteps; ++step) {
    const SceneObject* object = object_of(host);
    if (object == nullptr) return {};
    const NounPhrase& noun = noun_of_object(*object);
    // What has one thing on it, as was said, has room for another: a grand piano.
    const bool has_one = step == 0 && mount_of(noun) == Mount::kFloor && mount_of(thing) == Mount::kSurface;
    if ((has_one || may_carry(catalog_, noun, thing)) &&
        (mount_of(noun) != Mount::kSurface || area_of(noun) > kRoomForBoth * area_of(thing)))
      return host;
    host = said_support(host);
  }
  return {};
}

std::size_t RelationBuilder::sentence_of(std::size_t token) {
  if (sentences_.empty()) {
    std::size_t sentence = 0;
    for (const Token& t : document_.tokens) {
      sentences_.push_back(sentence);
      sentence += t.ends_sentence ? 1 : 0;
    }
  }
  return token < sentences_.size() ? sentences_[token] : sentences_.empty() ? 0 : sentences_.back();
}

// What the text last named that small things stand on: in the thing's sentence, or in the one before. Where nothing is said to stand on
// anything, the last piece that may carry the thing.
std::string RelationBuilder::host_spoken_of(std::size_t index) {
  const NounPhrase& thing = document_.items[index].noun;
  const std::size_t sentence = sentence_of(thing.first);
  std::string said, named;
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    const NounPhrase& noun = document_.items[i].noun;
    if (i == index || noun.first > thing.first || sentence_of(noun.first) + 1 < sentence) continue;
    if (const std::string host = host_with_room(said_support(scene_.objects[i].id), thing); !host.empty()) said = host;
    const bool has_top = is_table(catalog_, noun) || (noun.entry != nullptr && noun.entry->is(Trait::kCounter)) ||
                         (noun.entry != nullptr && catalog_.is_a(noun.entry->id, "bathroom_vanity"));
    if (mount_of(noun) == Mount::kFloor && has_top && may_carry(catalog_, noun, thing) && !is_sat_round(scene_.objects[i].id, thing))
      named = scene_.objects[i].id;
  }
  return said.empty() ? named : said;
}

// "each with a desk and a monitor": of as many desks as there are monitors each has its own.
std::string RelationBuilder::own_of_several(std::size_t index, const std::string& host) const {
  const SceneObject* carrier = object_of(host);
  if (carrier == nullptr) return host;
  std::vector<std::string> hosts;
  std::size_t things = 0, rank = 0;
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    if (scene_.objects[i].category == carrier->category) hosts.push_back(scene_.objects[i].id);
    if (scene_.objects[i].category != scene_.objects[index].category) continue;
    rank += i < index ? 1 : 0;
    ++things;
  }
  return things > 1 && things == hosts.size() ? hosts[rank] : host;
}

// "A lamp hangs above the table, lighting a planter": what a lamp over a table is over as well stands on it.
std::vector<std::pair<std::size_t, std::string>> RelationBuilder::lit_on_tables() const {
  std::vector<std::pair<std::size_t, std::string>> lit;
  const auto reference_of = [](const Relation& r) {
    return r.type == R::kAbove && r.targets.size() == 1 && r.references.size() == 1 ? r.references.front() : std::string{};
  };
  for (const Relation& over : scene_.relations) {
    const auto small = objects_.find(reference_of(over));
    if (small == objects_.end() || !is_small(small->second) || !said_support(over.references.front()).empty()) continue;
    for (const std::size_t other : relations_of(over.targets.front())) {
      const SceneObject* host = object_of(reference_of(scene_.relations[other]));
      if (host == nullptr || !is_table(catalog_, noun_of_object(*host)) || mount_of(noun_of_object(*host)) != Mount::kFloor) continue;
      lit.emplace_back(small->second, host->id);
      break;
    }
  }
  return lit;
}

void RelationBuilder::carry_support() {
  const std::vector<std::vector<std::size_t>> beside = small_neighbours();
  std::vector<std::string> supports(scene_.objects.size());
  std::queue<std::size_t> reached;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    if (beside[i].empty()) continue;
    supports[i] = said_support(scene_.objects[i].id);
    if (!supports[i].empty()) reached.push(i);
  }
  const auto conclude = [&](std::size_t index, const std::string& host) {
    const NounPhrase& noun = document_.items[index].noun;
    Link link;
    link.first = noun.first;
    link.last = noun.last;
    link.concluded = true;
    add(link, R::kOn, {scene_.objects[index].id}, {host});
    supports[index] = host;
    reached.push(index);
  };
  const auto spread = [&] {
    for (; !reached.empty(); reached.pop()) {
      const std::size_t from = reached.front();
      for (const std::size_t other : beside[from]) {
        if (!supports[other].empty()) continue;
        const std::string host = host_with_room(supports[from], document_.items[other].noun);
        if (!host.empty() && host != scene_.objects[other].id) conclude(other, host);
      }
    }
  };
  spread();
  for (const auto& [thing, host] : lit_on_tables()) conclude(thing, host);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    if (beside[i].empty() || !supports[i].empty() || is_light_box(document_.items[i].noun) || !is_small(i)) continue;
    const std::string host = own_of_several(i, host_spoken_of(i));
    if (host.empty() || host == scene_.objects[i].id) continue;
    conclude(i, host);
    spread();
  }
}

// "A low table on a platform, four cushions around it": who sits at what stands on a platform sits up there.
void RelationBuilder::seat_on_platforms() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation by = scene_.relations[r];
    if (!by.hard || by.references.size() != 1 || by.type == R::kFacing) continue;
    const bool drawn_up = traits_of(by.type).around || by.type == R::kTuckedUnder || by.type == R::kInFrontOf || by.type == R::kBehind;
    const SceneObject* platform = object_of(said_support(by.references.front()));
    if (!drawn_up || platform == nullptr || noun_of_object(*platform).entry == nullptr || noun_of_object(*platform).entry->thin) continue;
    for (const std::string& seat : by.targets) {
      const SceneObject* object = object_of(seat);
      if (object == nullptr || !said_support(seat).empty()) continue;
      const NounPhrase& noun = noun_of_object(*object);
      if (!is_seat(catalog_, noun) || mount_of(noun) != Mount::kFloor || !may_carry(catalog_, noun_of_object(*platform), noun)) continue;
      Link link;
      link.first = noun.first;
      link.last = noun.last;
      link.concluded = true;
      add(link, R::kOn, {seat}, {platform->id});
    }
  }
}

// "Plates set with napkins to their right": what is said to be beside something is not on it as well.
void RelationBuilder::part_from_neighbours() {
  const auto is_beside = [&](const Relation& on) {
    const std::vector<std::size_t>& all = relations_of(on.targets.front());
    return std::any_of(all.begin(), all.end(), [&](std::size_t r) {
      const Relation& other = scene_.relations[r];
      return (traits_of(other.type).sideways || other.type == R::kNextTo) && other.references == on.references;
    });
  };
  for (Relation& relation : scene_.relations) {
    if (!carries(relation.type) || relation.targets.size() != 1 || !is_beside(relation)) continue;
    const SceneObject* host = object_of(relation.references.empty() ? "" : relation.references.front());
    if (host != nullptr && mount_of(noun_of_object(*host)) == Mount::kSurface) relation.type = R::kNextTo;
  }
}

// "A vase filled with flowers and a fruit bowl": what the vessel is too small for stands where that stands.
void RelationBuilder::leave_small_vessels() {
  for (Relation& relation : scene_.relations) {
    if (!carries(relation.type) || relation.targets.size() != 1 || relation.references.size() != 1) continue;
    const SceneObject *thing = object_of(relation.targets.front()), *vessel = object_of(relation.references.front());
    if (thing == nullptr || vessel == nullptr || goes_into(noun_of_object(*vessel), noun_of_object(*thing))) continue;
    const std::string host = said_support(relation.references.front());
    if (host.empty() || host == thing->id) continue;
    relation.type = R::kOn;
    relation.references = {host};
  }
}

// "On the far wall, a mixer rests on a cabinet", "a bowl on the table under the window, with a jug": the cabinet, the table stand there.
void RelationBuilder::stand_carriers_at_walls() {
  for (Relation& relation : scene_.relations) {
    const bool by_window = relation.type == R::kUnderWindow, in_room = relation.type == R::kCorner || relation.type == R::kCenterOfRoom;
    const bool at_wall = relation.type == R::kOnWall || relation.type == R::kAgainstWall;
    if ((!at_wall && !by_window && !in_room) || relation.targets.size() != 1) continue;
    const SceneObject* thing = object_of(relation.targets.front());
    // "In the middle of the room, on a lectern, rests a psalter"; but "on the desk a lamp in the left corner"
    if (thing != nullptr && in_room && !words_.are_before(relation, noun_of_object(*thing).first)) continue;
    const std::string carrier = said_support(relation.targets.front());
    const SceneObject* host = object_of(carrier);
    if (thing == nullptr || host == nullptr || mount_of(noun_of_object(*thing)) != Mount::kSurface || has_wall_kind(noun_of_object(*thing)))
      continue;
    const std::vector<std::size_t>& all = relations_of(carrier);
    const bool placed = std::any_of(all.begin(), all.end(), [&](std::size_t r) { return stands_elsewhere(scene_.relations[r].type); });
    if ((placed && !by_window) || mount_of(noun_of_object(*host)) != Mount::kFloor) continue;
    if (at_wall) relation.type = R::kAgainstWall;
    relation.targets = {carrier};
    of_target_[carrier].push_back(static_cast<std::size_t>(&relation - scene_.relations.data()));
  }
}

// "A cup on a coaster on the table": that it is on the table follows from where the coaster is.
void RelationBuilder::drop_implied_support() {
  const auto stands_on = [&](const std::string& object, const std::string& host) {
    const std::vector<std::size_t>& all = relations_of(object);
    return std::any_of(all.begin(), all.end(), [&](std::size_t r) {
      const Relation& relation = scene_.relations[r];
      return relation.type == R::kOn && relation.references.size() == 1 && relation.references.front() == host;
    });
  };
  const auto repeats = [&](const Relation& relation) {
    return std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& other) {
      const bool same = other.type == relation.type && other.targets == relation.targets && other.references == relation.references &&
                        other.parameters.side == relation.parameters.side;
      return same && other.id != relation.id && (!other.parameters.part.empty() || &other < &relation) && relation.parameters.part.empty();
    });
  };
  std::vector<std::string> implied;
  for (const Relation& relation : scene_.relations) {
    if (repeats(relation)) implied.push_back(relation.id);
    if (relation.type != R::kOn || relation.targets.size() != 1 || relation.references.size() != 1) continue;
    const std::vector<std::size_t>& all = relations_of(relation.targets.front());
    const bool through_another = std::any_of(all.begin(), all.end(), [&](std::size_t r) {
      const Relation& other = scene_.relations[r];
      return other.id != relation.id && carries(other.type) && other.references.size() == 1 &&
             other.references.front() != relation.references.front() && stands_on(other.references.front(), relation.references.front());
    });
    if (through_another) implied.push_back(relation.id);
  }
  std::erase_if(scene_.relations, [&](const Relation& r) { return std::find(implied.begin(), implied.end(), r.id) != implied.end(); });
}

}  // namespace layoutbox::offline
