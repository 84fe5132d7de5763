// What a thing has, before places are given out, and what carries or lights another: what is said of its chairs is said of a table.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// The last thing named before that one that stands on the floor, or -1.
int RelationBuilder::standing_before(int m) const {
  while (m-- > 0) {
    const Mention& thing = mention(m);
    if (thing.introduces && thing.items.size() == 1 && mount_of(thing.noun) == Mount::kFloor) return m;
  }
  return -1;
}

// How what a thing has belongs to it, so that places said behind it are the host's; nothing where they are not.
std::optional<RelationBuilder::HostBond> RelationBuilder::bond_of(const Link& have) const {
  if (have.kind != Link::Kind::kHave || have.after_comma || have.references.size() != 1 || have.targets.empty()) return std::nullopt;
  const Mention &host = mention(have.references.front()), &first = mention(have.targets.front()), &end = mention(have.targets.back());
  if (host.items.size() != 1 || first.items.empty()) return std::nullopt;
  const NounPhrase &noun = noun_of_item(host.items.front()), &other = noun_of_item(first.items.front());
  HostBond bond;
  // "a desk with a computer and a chair near the door"
  bond.ends_in_seat = !end.items.empty() && one_sits_at(catalog_, noun) && is_seat(catalog_, noun_of_item(end.items.front()));
  bond.seats = bond.ends_in_seat || (one_sits_at(catalog_, noun) && is_seat(catalog_, other));
  // "a table with four chairs in the middle, a mug and a bowl on it": the place follows the chairs.
  bond.last = bond.seats && !bond.ends_in_seat ? have.targets.front() : have.targets.back();
  bond.list = !bond.seats && have.targets.size() > 1;
  const Mention& thing = mention(bond.last);
  if (thing.items.empty() || !thing.introduces) return std::nullopt;
  const bool floor = mount_of(noun) == Mount::kFloor;
  // "an easel with a canvas near the window"
  const auto is_host = [&](const std::string& kind) { return noun.entry != nullptr && catalog_.is_a(noun.entry->id, kind); };
  const bool set_on = other.entry != nullptr && std::ranges::any_of(other.entry->stands_on, is_host);
  // "a cabinet with a TV opposite the sofa": the cabinet, with the TV on it.
  bond.carried = floor && (set_on || (mount_of(other) == Mount::kSurface && may_carry(catalog_, noun, other)));
  // "a piano with its stool by the window"
  const bool own = !bond.list && thing.noun.determiner == Determiner::kPossessive && floor;
  bond.own = own;
  const auto area = [](const NounPhrase& one) {
    return one.entry == nullptr ? 0 : std::int64_t{one.entry->size.usual.width} * one.entry->size.usual.depth;
  };
  const bool single = !bond.list && !bond.carried && floor;
  // "a bench with baskets under the window", "a dressing table with a mirror under the window"
  const bool kept = single && !bond.seats && mount_of(other) == Mount::kFloor && 2 * area(other) < area(noun);
  const bool hung = single && mount_of(other) == Mount::kWall;
  bond.under_window = hung || (kept && !own);
  if (bond.list ? !bond.carried : !bond.seats && !flanks(other, noun) && !bond.carried && !hung && !own && !kept) return std::nullopt;
  return bond;
}

// Does the link place that content, by what may place the host too?
bool RelationBuilder::places_host(const Link& link, const Link& have, const HostBond& bond, int target) const {
  const Mention& host = mention(have.references.front());
  const bool rests = bond.carried && (says(link.senses, &RelationTraits::rests) || says(link.senses, R::kCenterOfRoom));
  if (link.kind != Link::Kind::kRelation || rests || (bond.under_window && !says(link.senses, R::kUnderWindow))) return false;
  // "with a lamp and a chair next to the window": of both, or of the last one
  const bool of_list = bond.ends_in_seat && link.targets.size() > 1 && link.targets.back() == target &&
                       std::ranges::all_of(link.targets, [&](int t) { return std::ranges::find(have.targets, t) != have.targets.end(); });
  if (!of_list && link.targets != std::vector<int>{target}) return false;
  return std::ranges::all_of(link.references, [&](int r) {
    const Mention& by = mention(r);
    if (bond.own && by.items != host.items) return true;
    if (bond.under_window && by.noun.kind != NounKind::kWindow) return false;
    return by.items.empty() ||
           (bond.carried && !bond.list && by.items != host.items && mount_of(noun_of_item(by.items.front())) == Mount::kFloor);
  });
}

// "a table with four chairs in the middle": what is said there of the place of the chairs is said of the table that has them.
void RelationBuilder::place_host_of(const Link& have) {
  const std::optional<HostBond> bond = bond_of(have);
  if (!bond) return;
  const Mention &host = mention(have.references.front()), &thing = mention(bond->last);
  const bool placed =
      std::ranges::any_of(document_.links, [&](const Link& link) { return places_host(link, have, *bond, have.references.front()); });
  if (placed) return;
  for (Link& link : document_.links) {
    if (link.first < thing.noun.last || link.first > thing.noun.last + 1) continue;
    // "a sofa bed, a desk with a chair across from it": the desk, across from what was named before
    const bool from_it = bond->seats && link.targets == std::vector<int>{bond->last} && says(link.senses, R::kOpposite) &&
                         link.references.size() == 1 && mention(link.references[0]).items == host.items;
    const int before = from_it ? standing_before(have.references.front()) : -1;
    if (before >= 0) link.targets = have.references, link.references = {before};
    if (places_host(link, have, *bond, bond->last)) link.targets = have.references;
  }
}

// "two beds with a nightstand in the middle": between them.
void RelationBuilder::place_between_hosts(const Link& have) {
  if (have.kind != Link::Kind::kHave || have.references.size() != 1 || have.targets.empty()) return;
  const Mention &hosts = mention(have.references.front()), &thing = mention(have.targets.back());
  if (hosts.items.size() != 2 || thing.items.size() != 1 || !thing.introduces) return;
  if (mount_of(noun_of_item(hosts.items.front())) != Mount::kFloor || mount_of(thing.noun) != Mount::kFloor) return;
  for (Link& link : document_.links) {
    const bool of_either = link.targets == have.references || link.targets == std::vector<int>{have.targets.back()};
    if (!of_either || link.kind != Link::Kind::kRelation || link.first != thing.noun.last || !link.references.empty()) continue;
    if (!says(link.senses, R::kCenterOfRoom)) continue;
    link.targets = {have.targets.back()};
    link.references = have.references;
    link.senses = {{R::kBetween, PhraseSense::Direction::kDirect, {}, {}, {}}};
  }
}

void RelationBuilder::place_hosts() {
  for (const Link& have : document_.links) place_host_of(have);
  for (const Link& have : document_.links) place_between_hosts(have);
}

// "a counter with the till, the grinder and a cake display along the back wall": all three are what the counter has; "a desk with a lamp
// and a chair by the window": both.
void RelationBuilder::complete_contents() {
  for (Link& have : document_.links) {
    if (have.kind != Link::Kind::kHave || have.references.size() != 1 || have.targets.empty()) continue;
    const NounPhrase& host = mention(have.references.front()).noun;
    const bool counter = host.entry != nullptr && host.entry->is(Trait::kCounter) && have.targets.size() > 1;
    const bool desk = one_sits_at(catalog_, host);
    if (!counter && !desk) continue;
    const std::size_t end = mention(have.targets.back()).noun.last;
    const auto follows = [&](const Mention& m) {
      const bool last = m.introduces && !m.items.empty() && m.noun.first == end + 1 && says_one_of(document_, end, {"and"});
      return last && (counter || is_seat(catalog_, m.noun));
    };
    const auto next = std::ranges::find_if(document_.mentions, follows);
    if (next != document_.mentions.end()) have.targets.push_back(static_cast<int>(next - document_.mentions.begin()));
  }
}

// "an island with a sink", "a basin in the counter": what stands by itself elsewhere is let into a top.
void RelationBuilder::let_into_tops() {
  for (const Link& link : document_.links) {
    const bool place = link.kind == Link::Kind::kRelation && says(link.senses, &RelationTraits::rests);
    if ((!place && link.kind != Link::Kind::kHave) || link.references.empty() || mention(link.references.front()).items.empty()) continue;
    const NounPhrase& host = noun_of_item(mention(link.references.front()).items.front());
    if (host.entry == nullptr || mount_of(host) != Mount::kFloor) continue;
    for (const int m : link.targets) {
      // "cabinets on the back wall with a sink under the window": one of the units of that run.
      const auto says_where = [&](const Link& other) {
        return other.kind == Link::Kind::kRelation && std::ranges::find(other.targets, m) != other.targets.end();
      };
      const bool own_unit = !place && host.entry->is(Trait::kKitchenRun) && host.entry->back_to_wall;
      if (!own_unit || std::ranges::none_of(document_.links, says_where)) let_in(m, *host.entry);
    }
  }
}

void RelationBuilder::let_in(int m, const CatalogEntry& host) {
  Mention& thing = document_.mentions[static_cast<std::size_t>(m)];
  if (thing.noun.entry == nullptr) return;
  const CatalogEntry* form = kind_at(catalog_, thing.noun.entry->id, KinPlace::kSetIn);
  const auto fits = [&](const std::string& id) { return catalog_.is_a(host.id, id); };
  if (form != nullptr && std::ranges::none_of(form->stands_on, fits)) form = nullptr;
  // "a shelf with bins", "a desk with two screens"; "a sea chart on the table", which is none of the wall
  const bool off_wall = thing.noun.entry->mount == Mount::kWall && !thing.noun.name.starts_with("wall ");
  if (thing.introduces && (off_wall || thing.noun.name == thing.noun.head)) {
    const CatalogEntry* kept = catalog_.find(kept_in_entry(thing.noun.head, host));
    if (kept != nullptr) form = kept;
  }
  if (form == nullptr) return;
  const auto become = [&](NounPhrase& noun) { noun.entry = form, noun.category = form->id; };
  become(thing.noun);
  for (const int item : thing.items) {
    become(document_.items[static_cast<std::size_t>(item)].noun);
    scene_.objects[static_cast<std::size_t>(item)].category = form->id;
  }
}

// "over", "above"; "lights up" and "shines on" do not say that it is there.
bool RelationBuilder::says_over(const Link& link) const {
  const auto first = document_.tokens.begin() + static_cast<std::ptrdiff_t>(link.first),
             last = document_.tokens.begin() + static_cast<std::ptrdiff_t>(link.last);
  return std::any_of(first, last, [](const Token& token) {
    return token.text == "above" || token.text.find("over") != std::string::npos;  // "overhead"
  });
}

// "a floor lamp lights up the armchair", "a desk lamp lights the desk": what stands is beside it or on it.
void RelationBuilder::settle_lighting(PhraseSense& sense, const NounPhrase& lamp, const NounPhrase& lit) const {
  if (!is_lamp(catalog_, lamp) || !lamp.exact) return;
  const bool hung = kind_at(catalog_, lamp.entry->id, KinPlace::kOnCeiling) != nullptr;  // a lamp of any kind
  if (mount_of(lamp) == Mount::kFloor) {
    sense.type = mount_of(lit) == Mount::kFloor ? R::kNextTo : R::kNear;
  } else if (mount_of(lamp) == Mount::kSurface && !hung) {
    sense.type = may_carry(catalog_, lit, lamp) ? R::kOn : R::kNextTo;
  }
}

// "nearby", after a small thing that stands on something: by that.
bool RelationBuilder::add_by_carrier(const Link& link, const PhraseSense& sense, const Mention& target, int reference) {
  const bool by = sense.type == R::kNear || sense.type == R::kNextTo || sense.type == R::kOpposite;
  if (!link.implied || !by || mount_of(target.noun) != Mount::kFloor) return false;
  const std::string host = carrier_said(reference);
  if (host.empty()) return false;
  for (const int item : target.items) add(link, sense.type, {id(item)}, {host}, sense);
  return true;
}

// What a small thing was said to stand on, or is had by; empty: nothing.
std::string RelationBuilder::carrier_said(int item) const {
  if (mount_of(noun_of_item(item)) != Mount::kSurface) return {};
  for (const Relation& r : scene_.relations) {
    if (traits_of(r.type).rests && !r.targets.empty() && r.targets.front() == id(item) && !r.references.empty())
      return r.references.front();
  }
  for (const Link& link : document_.links) {
    if (link.kind != Link::Kind::kHave || !contains(items_of(link.targets), item)) continue;
    const std::vector<int> hosts = items_of(link.references);
    if (hosts.size() == 1 && mount_of(noun_of_item(hosts.front())) == Mount::kFloor) return id(hosts.front());
  }
  return {};
}

bool RelationBuilder::holds_inside(const NounPhrase& host) const {
  if (one_of(host.head, WordSet::kClosedFurniture)) return false;
  return is_storage(host) && has_inside(host);
}

bool RelationBuilder::has_inside(const NounPhrase& host) const {
  if (host.entry == nullptr) return is_storage(host);
  if (host.entry->is(Trait::kVessel)) return true;
  return std::any_of(host.entry->spaces.begin(), host.entry->spaces.end(),
                     [](const SpaceFormula& s) { return s.carries || s.name == "inside"; });
}

// A cabin, a booth, a tent: one goes into it, and what it has is in it, whatever the verb.
bool RelationBuilder::is_entered(const NounPhrase& host) const {
  constexpr Mm kHigh = 1100;  // a child's tent
  return host.entry != nullptr && host.entry->size.usual.height >= kHigh && mount_of(host) == Mount::kFloor &&
         std::ranges::any_of(host.entry->spaces, [](const SpaceFormula& s) { return s.name == "inside"; });
}

// "four croissants inside", said of what has no inside of its own, or of which nothing is known: it is hollow for them.
bool RelationBuilder::is_hollow_by(const Link& link, const NounPhrase& host) const {
  if (!one_of(document_.tokens[link.first].text, WordSet::kInside) || mount_of(host) == Mount::kWall) return false;
  return host.entry == nullptr || !host.exact || !(host.entry->thin || host.entry->top_carries || is_sat_on(host));
}

}  // namespace layoutbox::offline
