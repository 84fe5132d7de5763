// What a thing has, and what hangs.
#include <algorithm>

#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

namespace {

bool places(R type) { return type != R::kFacing && type != R::kParallel && type != R::kPerpendicular && type != R::kSameOrientation; }

}  // namespace

bool RelationBuilder::is_placed(int item) const {
  const std::vector<std::size_t>& all = relations_of(id(item));
  return std::any_of(all.begin(), all.end(), [&](std::size_t r) { return places(scene_.relations[r].type); });
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

// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
void RelationBuilder::add_contents(const Link& link) {
  const std::vector<int> all_hosts = items_of(link.references);
  if (all_hosts.empty()) return;
  for (const int m : link.targets) {
    const Mention& target = mention(m);
    if (target.items.empty()) continue;
    // "a desk and chair equipped with a monitor": the one that can carry it.
    std::vector<int> hosts = all_hosts;
    if (link.references.size() > 1 && std::any_of(hosts.begin(), hosts.end(), [&](int h) {
          return !is_seat(catalog_, noun_of_item(h)) && may_carry(catalog_, noun_of_item(h), target.noun);
        })) {
      std::erase_if(hosts, [&](int h) { return is_seat(catalog_, noun_of_item(h)) || !may_carry(catalog_, noun_of_item(h), target.noun); });
    }
    if (link.weak && is_placed(target.items.front())) continue;
    if (is_related(target.items.front(), hosts.front())) continue;
    const NounPhrase &host = noun_of_item(hosts.front()), &thing = target.noun;
    const auto each = [&](R type) {
      for (std::size_t t = 0; t < target.items.size(); ++t) {
        const std::size_t h = hosts.size() <= target.items.size() ? t * hosts.size() / target.items.size() : 0;
        add(link, type, {id(target.items[t])}, {id(hosts[h])});
      }
    };
    const bool table = is_table(catalog_, host), seat = is_seat(catalog_, thing);
    const Mount mount = mount_of(thing);
    if (thing.entry != nullptr && thing.entry->thin && mount == Mount::kFloor) {
      each(R::kUnder);
    } else if (table && seat) {
      if (target.items.size() > hosts.size()) {
        add_group(link, {R::kAround, Direction::kDirect, {}, {}, {}}, target.items, hosts, nullptr);
      } else {
        // A school desk looks away from who sits at it.
        const bool behind = host.entry != nullptr && host.entry->used_sides == std::vector<Side>{Side::kBack};
        for (std::size_t t = 0; t < target.items.size(); ++t) {
          const std::string& desk = id(hosts[std::min(t, hosts.size() - 1)]);
          add(link, behind ? R::kTuckedUnder : R::kInFrontOf, {id(target.items[t])}, {desk});
          if (!behind) add(link, R::kFacing, {id(target.items[t])}, {desk});
        }
      }
    } else if ((may_carry(catalog_, host, thing) || (link.holding && shows(link))) && !(mount == Mount::kWall && !link.holding)) {
      each(holds_inside(host) ? R::kIn : R::kOn);
    } else if (mount == Mount::kWall || mount == Mount::kCeiling) {
      if (!link.after_comma && mount_of(host) == Mount::kFloor) each(R::kAbove);
    } else if (mount == Mount::kSurface && link.holding) {
      each(R::kOn);
    } else if (mount_of(host) == Mount::kWall && mount == Mount::kFloor && target.items.size() == 1) {
      add(link, R::kAbove, {id(hosts.front())}, {id(target.items.front())});
    } else if (!is_placed(target.items.front()) &&
               (!link.after_comma ||
                one_of(document_.tokens[link.first].text, {"accompanied", "joined", "paired", "complemented", "coupled"}))) {
      const bool pair = target.items.size() == 2 && hosts.size() == 1 && mount == Mount::kFloor;
      if (pair)
        add(link, R::kEachSideOf, ids(target.items), {id(hosts.front())});
      else
        each(R::kNextTo);
    }
  }
}

bool RelationBuilder::shows(const Link& link) const {
  return one_of(document_.tokens[link.first].text,
                {"holding", "holds", "hold", "displaying", "displays", "display", "showcasing", "showcases"});
}

void RelationBuilder::add_hanging(const Link& link) {
  for (const int item : items_of(link.targets)) {
    const bool said = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      const bool hangs = r.type == R::kOnWall || r.type == R::kOnCeiling || r.type == R::kOn || r.type == R::kIn ||
                         r.type == R::kAgainstWall || r.type == R::kCenteredOnWall;
      return hangs && std::find(r.targets.begin(), r.targets.end(), id(item)) != r.targets.end();
    });
    if (said) continue;
    const NounPhrase& noun = noun_of_item(item);
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
