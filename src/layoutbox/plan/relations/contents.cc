// What a thing has, and what hangs.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

namespace {

bool places(R type) { return !traits_of(type).turns; }

}  // namespace

bool RelationBuilder::is_placed(int item) const {
  const std::vector<std::size_t>& all = relations_of(id(item));
  return std::any_of(all.begin(), all.end(), [&](std::size_t r) { return places(scene_.relations[r].type); });
}

// … by something else than each other: "two chairs per table facing each other" are at the table still.
bool RelationBuilder::is_placed_apart(const std::vector<int>& items, bool of_table) const {
  const std::vector<std::string> own = ids(items);
  const std::vector<std::size_t>& all = relations_of(own.front());
  return std::any_of(all.begin(), all.end(), [&](std::size_t r) {
    const Relation& relation = scene_.relations[r];
    const bool mutual = !relation.references.empty() &&
                        std::all_of(relation.references.begin(), relation.references.end(),
                                    [&](const std::string& one) { return std::find(own.begin(), own.end(), one) != own.end(); });
    // Where it is not, says nothing of where it is.
    const bool denied = relation.type == R::kDistance && relation.parameters.min && !relation.parameters.max;
    // "a desk features a lamp to the right of a sketchbook": beside a small thing it is still on the desk.
    const bool by_small = of_table && !traits_of(relation.type).rests && only_small(own) && only_small(relation.references);
    return places(relation.type) && !mutual && !denied && !by_small;
  });
}

bool RelationBuilder::is_related(int item, int other) const {
  const auto by = [&](int one, int two) {
    const std::vector<std::size_t>& all = relations_of(id(one));
    return std::any_of(all.begin(), all.end(), [&](std::size_t r) {
      const Relation& relation = scene_.relations[r];
      return places(relation.type) &&
             std::find(relation.references.begin(), relation.references.end(), id(two)) != relation.references.end();
    });
  };
  return by(item, other) || by(other, item);
}

// Which of those that are said to have it do.
std::vector<int> RelationBuilder::hosts_of(const Link& link, int m) const {
  const Mention& target = mention(m);
  std::vector<int> hosts = items_of(link.references);
  // "a desk and chair equipped with a monitor": the one that can carry it.
  const auto carries = [&](int h) { return !is_seat(catalog_, noun_of_item(h)) && may_carry(catalog_, noun_of_item(h), target.noun); };
  if (link.references.size() > 1 && std::any_of(hosts.begin(), hosts.end(), carries))
    std::erase_if(hosts, [&](int h) { return !carries(h); });
  // "a kitchen run with an island and three stools": at what of the list one sits at.
  if (!is_seat(catalog_, target.noun) || one_sits_at(catalog_, noun_of_item(hosts.front()))) return hosts;
  const auto table = std::find_if(link.targets.begin(), link.targets.end(), [&](int t) {
    return t < m && !mention(t).items.empty() && is_table(catalog_, mention(t).noun) && mount_of(mention(t).noun) == Mount::kFloor;
  });
  return table != link.targets.end() ? mention(*table).items : hosts;
}

// "an armchair with a side table and a lamp", "a bed with a nightstand and a clock": on the table that comes with it.
std::vector<int> RelationBuilder::carriers_among(const Link& link, int m, std::vector<int> hosts) const {
  const NounPhrase &thing = mention(m).noun, &host = noun_of_item(hosts.front());
  const auto is_for_sitting = [&](const NounPhrase& noun) {
    return is_seat(catalog_, noun) || (noun.entry != nullptr && noun.entry->is(Trait::kBed));
  };
  if (thing.entry == nullptr || host.entry == nullptr || !is_for_sitting(host)) return hosts;
  if (mount_of(thing) != Mount::kSurface && thing.entry->stands_on.empty()) return hosts;
  const auto lies_there = [&](const std::string& kind) { return catalog_.is_a(host.entry->id, kind); };  // a pillow
  if (std::ranges::any_of(thing.entry->stands_on, lies_there)) return hosts;
  for (const int t : link.targets) {
    if (t >= m || mention(t).items.empty() || !mention(t).introduces) continue;
    const NounPhrase& table = mention(t).noun;
    if (mount_of(table) == Mount::kFloor && !is_for_sitting(table) && may_carry(catalog_, table, thing)) return mention(t).items;
  }
  return hosts;
}

// Each of the things at its share of the hosts.
void RelationBuilder::share_out(const Link& link, R type, const std::vector<int>& items, const std::vector<int>& hosts) {
  for (std::size_t t = 0; t < items.size(); ++t) {
    const std::size_t h = hosts.size() <= items.size() ? t * hosts.size() / items.size() : 0;
    add(link, type, {id(items[t])}, {id(hosts[h])});
  }
}

// "a table with four chairs", "desks with chairs".
void RelationBuilder::add_seats(const Link& link, const std::vector<int>& seats, const std::vector<int>& tables) {
  // "a long table with two benches": along it, not at its ends
  const bool wide = is_wide_seat(noun_of_item(seats.front()));
  Link along = link;
  along.concluded = true;
  if (wide && seats.size() == 2 && tables.size() == 1)
    add_at_sides(along, {R::kEachSideOf, Direction::kDirect, {}, {}, {}}, seats, tables.front());
  if (seats.size() > tables.size()) {
    add_group(link, {R::kAround, Direction::kDirect, {}, {}, {}}, seats, tables, nullptr);
    return;
  }
  // A school desk looks away from who sits at it.
  const CatalogEntry* table = noun_of_item(tables.front()).entry;
  const bool behind = table != nullptr && table->used_sides == std::vector<Side>{Side::kBack};
  for (std::size_t t = 0; t < seats.size(); ++t) {
    const std::string& desk = id(tables[std::min(t, tables.size() - 1)]);
    add(link, behind ? R::kTuckedUnder : user_side(tables.front(), true), {id(seats[t])}, {desk});
    if (!behind) add(link, R::kFacing, {id(seats[t])}, {desk});
  }
}

void RelationBuilder::add_contents(const Link& link) {
  if (items_of(link.references).empty()) return;
  for (const int m : link.targets) {
    const Mention& target = mention(m);
    if (target.items.empty() || on_floor_.contains(m)) continue;
    const std::vector<int> hosts = carriers_among(link, m, hosts_of(link, m));
    if (link.weak && is_placed_apart(target.items, is_table(catalog_, noun_of_item(hosts.front())))) {
      // "two armchairs with a low table in the corner": the table is there, and they are at it.
      const CatalogEntry* seat = noun_of_item(hosts.front()).entry;
      const bool at_it = seat != nullptr && seat->is(Trait::kEasySeat) && is_table(catalog_, target.noun) && target.items.size() == 1 &&
                         !link.after_comma && !is_placed(hosts.front()) && !is_related(target.items.front(), hosts.front());
      for (std::size_t h = 0; at_it && h < hosts.size(); ++h) add(link, R::kNextTo, {id(hosts[h])}, {id(target.items.front())});
      continue;
    }
    if (!is_related(target.items.front(), hosts.front())) add_content(link, target, hosts);
  }
}

// A curtain round a bed hangs beside it, and so does a rail that one holds on to; a scroll is in its alcove; what else hangs is over it.
void RelationBuilder::add_hung_content(const Link& link, const Mention& target, const std::vector<int>& hosts) {
  const NounPhrase &host = noun_of_item(hosts.front()), &thing = target.noun;
  const auto is_host = [&](const std::string& kind) { return host.entry != nullptr && catalog_.is_a(host.entry->id, kind); };
  if (thing.entry != nullptr && std::ranges::any_of(thing.entry->stands_on, is_host))
    return share_out(link, has_inside(host) ? R::kIn : R::kOn, target.items, hosts);  // "an easel with a canvas"
  // "a nightstand with a clock": such a thing has a kind that stands there
  const auto small_kind = [&](const CatalogEntry& kind) {
    return kind.mount == Mount::kSurface && catalog_.is_a(kind.id, thing.entry->id) && std::ranges::any_of(kind.stands_on, is_host);
  };
  const bool wall =
      thing.entry != nullptr && mount_of(thing) == Mount::kWall && thing.name == thing.head && !thing.entry->is(Trait::kMirror);
  if (wall && std::ranges::any_of(catalog_.entries(), small_kind)) return share_out(link, R::kOn, target.items, hosts);
  const bool beside = thing.entry != nullptr && (mount_of(thing) == Mount::kCeiling ? thing.entry->is(Trait::kCurtain)
                                                                                    : std::ranges::any_of(thing.entry->beside, is_host));
  if (!link.after_comma && mount_of(host) == Mount::kFloor) share_out(link, beside ? R::kNextTo : R::kAbove, target.items, hosts);
}

// "accompanied by": not carried.
bool RelationBuilder::is_joined_by(const Link& link) const { return one_of(document_.tokens[link.first].text, WordSet::kJoinedBy); }

bool RelationBuilder::is_sat_on(const NounPhrase& noun) const {
  return is_seat(catalog_, noun) || (noun.entry != nullptr && noun.entry->is(Trait::kEasySeat));
}

namespace {

// Furniture of the floor's and small things that have room in there.
bool goes_within(const NounPhrase& host, const NounPhrase& thing) {
  if (thing.entry == nullptr) return true;
  const Mount mount = mount_of(thing);
  const Size &outer = host.entry->size.usual, &inner = thing.entry->size.usual;
  return (mount == Mount::kFloor || mount == Mount::kSurface) && inner.width < outer.width && inner.depth < outer.depth &&
         inner.height < outer.height;
}

}  // namespace

// One kind of thing that the hosts have.
void RelationBuilder::add_content(const Link& link, const Mention& target, const std::vector<int>& hosts) {
  const NounPhrase &host = noun_of_item(hosts.front()), &thing = target.noun;
  const auto each = [&](R type) { share_out(link, type, target.items, hosts); };
  const Mount mount = mount_of(thing);
  if (thing.entry != nullptr && thing.entry->thin && mount == Mount::kFloor) return each(R::kUnder);
  if (one_sits_at(catalog_, host) && is_seat(catalog_, thing)) return add_seats(link, target.items, hosts);
  const bool joined = is_joined_by(link);
  const bool great = thing.entry != nullptr && thing.entry->back_to_wall;  // a wardrobe
  // "a table crowded with bottles and an alembic": whatever it is, a table's top has it.
  const bool on_table = is_table(catalog_, host) && !is_table(catalog_, thing) && mount == Mount::kFloor && !joined && !great;
  // "a big table with potted plants and vases"
  const bool small = is_table(catalog_, host) && target.items.size() > 1 && thing.entry != nullptr &&
                     kind_at(catalog_, thing.entry->id, KinPlace::kOnThing) != nullptr;
  const bool within = (says_inside(link) || link.holding) && is_entered(host) && goes_within(host, thing);
  const bool carried = small || may_carry(catalog_, host, thing) || (link.holding && (shows(link) || on_table)) ||
                       (says_inside(link) && has_inside(host) && !is_heavy(catalog_, thing)) || within;
  if (joined && mount == Mount::kSurface && mount_of(host) == Mount::kSurface) return each(R::kNextTo);
  // "an armchair with a lamp": beside it.
  const bool sat_on = is_sat_on(host);
  if (is_lamp(catalog_, thing) && sat_on && mount != Mount::kCeiling && !link.holding) return each(R::kNextTo);
  const bool looked_at = thing.entry != nullptr && thing.entry->is(Trait::kScreen);
  // "a corner sofa with a TV": it looks at it.
  if (looked_at && sat_on && mount != Mount::kFloor) return add(link, R::kFacing, {id(hosts.front())}, {id(target.items.front())});
  const bool inside = (holds_inside(host) && !looked_at) || (says_inside(link) && has_inside(host)) || within;
  // "a cork board with photographs": pinned to it.
  const bool pinned = has_hooks(host) && mount == Mount::kWall && thing.entry != nullptr && host.entry != nullptr &&
                      thing.entry->size.usual.width < host.entry->size.usual.width / 2;
  if (carried && (pinned || !(mount == Mount::kWall && !link.holding))) return each(inside ? R::kIn : R::kOn);
  if (mount == Mount::kWall || mount == Mount::kCeiling) return add_hung_content(link, target, hosts);
  if (mount == Mount::kSurface && link.holding) return each(R::kOn);
  if (mount_of(host) == Mount::kWall && mount == Mount::kFloor && target.items.size() == 1)
    return add(link, R::kAbove, {id(hosts.front())}, {id(target.items.front())});
  add_standing_content(link, target, hosts);
}

// … that stands on the floor by them.
void RelationBuilder::add_standing_content(const Link& link, const Mention& target, const std::vector<int>& hosts) {
  const NounPhrase &host = noun_of_item(hosts.front()), &thing = target.noun;
  const bool joined = is_joined_by(link), sat_on = is_sat_on(host);
  if (is_placed(target.items.front()) || (link.after_comma && !joined)) return;
  // "a kitchen run with an island": before it, with an aisle between, as islands stand anyhow.
  const bool island = thing.entry != nullptr && thing.entry->is(Trait::kOpenToRoom) && thing.entry->is(Trait::kCounter);
  if (island && host.entry != nullptr && host.entry->is(Trait::kKitchenRun)) return;
  // "a rocking chair with a footstool": before it.
  const bool before = sat_on && thing.entry != nullptr && thing.entry->is(Trait::kStandsBefore) && !is_table(catalog_, thing);
  if (before) return share_out(link, R::kInFrontOf, target.items, hosts);
  if (target.items.size() == 2 && hosts.size() == 1 && mount_of(thing) == Mount::kFloor)
    return add(link, R::kEachSideOf, ids(target.items), {id(hosts.front())});
  // "two chairs facing each other with a small table": between them
  if (hosts.size() == 2 && sat_on && is_table(catalog_, thing) && target.items.size() == 1)
    return add(link, R::kBetween, ids(target.items), ids(hosts));
  share_out(link, R::kNextTo, target.items, hosts);
}

// "a cabinet containing bandages"
bool RelationBuilder::says_inside(const Link& link) const { return one_of(document_.tokens[link.first].text, WordSet::kContaining); }

bool RelationBuilder::shows(const Link& link) const { return shows_things(document_.tokens[link.first].text); }

void RelationBuilder::add_hanging(const Link& link) {
  for (const int item : items_of(link.targets)) {
    const bool said = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      const bool hangs = r.type == R::kOnWall || r.type == R::kOnCeiling || traits_of(r.type).rests || r.type == R::kAgainstWall ||
                         r.type == R::kCenteredOnWall;
      return hangs && std::find(r.targets.begin(), r.targets.end(), id(item)) != r.targets.end();
    });
    const NounPhrase& noun = noun_of_item(item);
    // "a telescope is mounted in the center of the room": on its floor.
    const std::vector<std::size_t>& all = relations_of(id(item));
    const bool amid = mount_of(noun) == Mount::kFloor &&
                      std::ranges::any_of(all, [&](std::size_t r) { return scene_.relations[r].type == R::kCenterOfRoom; });
    if (said || amid) continue;
    const bool ceiling = mount_of(noun) == Mount::kCeiling || (is_lamp(catalog_, noun) && mount_of(noun) != Mount::kWall);
    add(link, ceiling ? R::kOnCeiling : R::kOnWall, {id(item)}, {});
  }
}

void RelationBuilder::add_mounts_said() {
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    const NounPhrase& noun = document_.items[i].noun;
    const std::string words = " " + noun.name + " ";
    const auto said = [&](std::string_view word) {
      return std::find(noun.attributes.begin(), noun.attributes.end(), word) != noun.attributes.end() ||
             words.find(" " + std::string(word) + " ") != std::string::npos;
    };
    const bool wall = said("wall-mounted") || said("wall mounted") || (said("floating") && !is_seat(catalog_, noun) && noun.head != "bed"),
               ceiling = said("ceiling-mounted") || (noun.name.starts_with("ceiling ") && mount_of(noun) == Mount::kFloor);
    if (!wall && !ceiling) continue;
    Link link;
    link.targets = {};
    link.first = noun.first;
    link.last = noun.last;
    const bool known = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      return (r.type == R::kOnWall || r.type == R::kOnCeiling) &&
             std::find(r.targets.begin(), r.targets.end(), scene_.objects[i].id) != r.targets.end();
    });
    if (!known) add(link, wall ? R::kOnWall : R::kOnCeiling, {scene_.objects[i].id}, {});
  }
}

}  // namespace layoutbox::offline
