// On each side, on both sides, one on this side and one on that.
#include <algorithm>
#include <set>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

using Direction = PhraseSense::Direction;

namespace {

// "two ferns on either side of the desk": in pots on the floor, unless they are small ones.
bool is_floor_plant(const NounPhrase& noun) {
  constexpr Mm kSmall = 400;  // of height
  const auto is_little = [](const std::string& a) { return one_of(a, {"small", "little", "tiny", "mini"}); };
  return noun.entry != nullptr && noun.entry->is(Trait::kPlant) && noun.entry->size.usual.height > kSmall &&
         std::ranges::none_of(noun.attributes, is_little);
}

}  // namespace

bool RelationBuilder::lie_on(const Link& link, const std::vector<int>& items, int host) const {
  constexpr Mm kEyes = 1400;
  const NounPhrase& carrier = noun_of_item(host);
  // At the sides of a stage, a throne or a piano things stand on the floor, at the ends of a mantel on it.
  const bool ends = words_between(document_, link.first, link.last).find("end") != std::string::npos;
  if (mount_of(carrier) != Mount::kFloor || carrier.entry == nullptr || !carrier.entry->top_carries ||
      !(is_table(catalog_, carrier) || is_storage(carrier) || ends || carrier.head == "mantel") || is_seat(catalog_, carrier) ||
      one_of(carrier.head, WordSet::kLainOn))
    return false;
  return std::all_of(items.begin(), items.end(), [&](int item) {
    const std::vector<std::string>& qualities = noun_of_item(item).attributes;
    if (std::find(qualities.begin(), qualities.end(), "tall") != qualities.end()) return false;  // beside it
    if (!ends && is_floor_plant(noun_of_item(item))) return false;
    // What flanks a bookcase stands beside it: nobody sees it up there.
    if (!ends && is_storage(carrier) && carrier.entry->size.usual.height > kEyes) return false;
    // Loudspeakers flank a sideboard on the floor.
    if (one_of(noun_of_item(item).head, {"speaker", "loudspeaker"}) && !ends && !is_table(catalog_, carrier)) return false;
    return mount_of(noun_of_item(item)) == Mount::kSurface && may_carry(catalog_, carrier, noun_of_item(item));
  });
}

// Stools at a bar, a counter or an island, and chairs at a desk, stand in a row before it, unless the words say that they go round it.
bool RelationBuilder::seats_one_side(const Link& link, int seat, int host) const {
  const CatalogEntry* entry = noun_of_item(host).entry;
  if (entry == nullptr || !entry->has_front || !is_seat(catalog_, noun_of_item(seat))) return false;
  if (is_worked_at(noun_of_item(host))) return one_of(document_.tokens[link.first].text, {"at", "before"});
  const bool bench = entry->is(Trait::kDeskLike) && entry->used_sides == std::vector{Side::kFront};
  const bool counter = entry->is(Trait::kCounter) || entry->is(Trait::kDesk) || bench;
  const std::string words = words_between(document_, link.first, link.last);
  return counter && words.find("around") == std::string::npos && words.find("surround") == std::string::npos;
}

// Where one sits at it: pupils and teachers behind their desks, which look at the class or the board.
RelationType RelationBuilder::user_side(int host, bool one) const {
  const CatalogEntry* entry = noun_of_item(host).entry;
  if (entry == nullptr) return R::kInFrontOf;
  const bool receives = entry->is(Trait::kDesk) && entry->is(Trait::kOpenToRoom);  // its only seat is not the visitor's
  return entry->used_sides == std::vector{Side::kBack} || (one && receives) ? R::kBehind : R::kInFrontOf;
}

// What lies flat shares the middle with what stands there.
void RelationBuilder::add_in_middle(const Link& link, const PhraseSense& sense, const std::vector<int>& targets) {
  std::vector<int> flat, standing;
  for (const int target : targets)
    (noun_of_item(target).entry != nullptr && noun_of_item(target).entry->thin ? flat : standing).push_back(target);
  if (!flat.empty()) add(link, sense.type, ids(flat), {}, sense);
  if (!standing.empty()) add(link, sense.type, ids(standing), {}, sense);
  constexpr std::size_t kRow = 3;
  if (standing.size() >= kRow && one_of(document_.tokens[link.first].text, {"down", "along"})) add(link, R::kRow, ids(standing), {});
  if (flat.size() == 1 && standing.size() == 1) add(link, R::kUnder, ids(flat), ids(standing));
}

// Banners on both sides of a carpet, a hatch "at each end" of nothing that is named: on the walls there.
bool RelationBuilder::hang_at_sides(const Link& link, const std::vector<int>& targets, const std::vector<int>& references) const {
  const CatalogEntry* host = noun_of_item(references.front()).entry;
  const bool lies = host != nullptr && host->thin;
  return mount_of(noun_of_item(targets.front())) == Mount::kWall && (lies || is_tall_end(link, targets.front()));
}

// "one hatch at each end": as tall as a door, so the ends are those of the room.
bool RelationBuilder::is_tall_end(const Link& link, int target) const {
  constexpr Mm kDoor = 1500;
  const CatalogEntry* entry = noun_of_item(target).entry;
  return link.implied && entry != nullptr && entry->size.usual.height > kDoor &&
         words_between(document_, link.first, link.last).find("end") != std::string::npos;
}

// In a ring where nothing has sides; spread over the sides of a table.
bool RelationBuilder::in_ring(const std::vector<int>& targets, const std::vector<int>& references) const {
  const NounPhrase& host = noun_of_item(references.front());
  const bool few = std::ssize(targets) <= Groups::builtin().oval;
  const auto is_round = [&](const std::string& a) { return one_of(a, WordSet::kAllRound) || (a == "oval" && few); };
  const bool round = std::any_of(host.attributes.begin(), host.attributes.end(), is_round);
  return (round || !is_table(catalog_, host)) && targets.size() >= 3 * references.size();
}

// At both sides of one thing; false where it is as of any other group.
bool RelationBuilder::add_at_sides(const Link& link, const PhraseSense& sense, const std::vector<int>& targets, int host) {
  if (add_laden_sides(link, sense, targets, host)) return true;
  // "a lamp at each end" of a console table: on it.
  if (lie_on(link, targets, host)) {
    for (std::size_t t = 0; t < targets.size(); ++t) {
      PhraseSense on{R::kOn, Direction::kDirect, t % 2 == 0 ? PartWord::kLeft : PartWord::kRight, {}, {}};
      if (targets.size() > 2) on.part = {};
      add(link, R::kOn, {id(targets[t])}, {id(host)}, on);
    }
    return true;
  }
  hang_beside(targets, host);
  if (!is_seat(catalog_, noun_of_item(targets.front())) || !is_table(catalog_, noun_of_item(host))) return false;
  // "two chairs, one at each end" of a table
  const std::string said = words_between(document_, link.first, link.last);
  if (targets.size() == 2 && (said.find("end") != std::string::npos || said.find("heads") != std::string::npos)) {
    const PhraseSense along{R::kAlongSide, Direction::kDirect, {}, {}, Side::kShort};
    for (const int seat : targets) {
      add(link, along.type, {id(seat)}, {id(host)}, along);
      add_look(link, along.type, seat, host);
    }
    return true;
  }
  // "a long table with benches on both sides": along it, not at its ends
  const bool wide = is_wide_seat(noun_of_item(targets.front()));
  if (targets.size() == 2 && wide) add(link, R::kEachSideOf, ids(targets), {id(host)});
  if (targets.size() < 4 && link.sides <= 2 && !wide) return false;
  add_seats_at_sides(link, targets, host);
  return true;
}

// "rails on both sides" of a toilet: of which only one could be on a wall beside it, so both come from the wall behind.
void RelationBuilder::hang_beside(const std::vector<int>& targets, int host) {
  const CatalogEntry* between = noun_of_item(host).entry;
  if (targets.size() != 2 || between == nullptr || !between->back_to_wall || between->size.usual.depth <= between->size.usual.width) return;
  for (const int target : targets) {
    SceneObject& object = scene_.objects[static_cast<std::size_t>(target)];
    const CatalogEntry* form = kind_at(catalog_, object.category, KinPlace::kAtSides);
    if (form != nullptr && !object.size) object.category = form->id;
  }
}

// Several hosts share the targets out.
void RelationBuilder::add_shares(const Link& link, const PhraseSense& sense, const std::vector<int>& targets,
                                 const std::vector<int>& references) {
  const bool alone = relation_row(sense.type).arity == RelationArity::kNone;
  const std::size_t hosts = alone ? 1 : references.size();
  for (std::size_t h = 0; h < hosts; ++h) {
    std::vector<int> share;
    for (std::size_t t = h; t < targets.size(); t += hosts) share.push_back(targets[t]);
    if (share.empty()) continue;
    const std::vector<std::string> host = alone ? std::vector<std::string>{} : std::vector<std::string>{id(references[h])};
    if (sense.type == R::kEachSideOf && hosts > 1 && share.size() > 1 && add_at_sides(link, sense, share, references[h])) continue;
    if (sense.type == R::kEachSideOf && share.size() == 1)
      add(link, R::kNextTo, ids(share), host);
    else
      add(link, sense.type, ids(share), host, sense);
  }
}

// "a nightstand and a lamp on either side": the lamps are on the nightstands. False: these are other things.
bool RelationBuilder::add_laden_sides(const Link& link, const PhraseSense& sense, const std::vector<int>& targets, int host) {
  std::vector<int> stands, loads;
  for (const int target : targets) {
    const NounPhrase& noun = noun_of_item(target);
    const bool stand = mount_of(noun) == Mount::kFloor && noun.entry != nullptr && noun.entry->top_carries;
    if (!stand && mount_of(noun) != Mount::kSurface) return false;
    (stand ? stands : loads).push_back(target);
  }
  if (stands.size() < 2 || loads.empty() || loads.size() % stands.size() != 0) return false;
  if (!std::all_of(loads.begin(), loads.end(),
                   [&](int load) { return may_carry(catalog_, noun_of_item(stands.front()), noun_of_item(load)); }))
    return false;
  add(link, sense.type, ids(stands), {id(host)}, sense);
  for (std::size_t l = 0; l < loads.size(); ++l) add(link, R::kOn, {id(loads[l])}, {id(stands[l % stands.size()])});
  return true;
}

void RelationBuilder::complete_sides() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation around = scene_.relations[r];
    if ((around.type != R::kAround && around.type != R::kSurround) || around.references.size() != 1) continue;
    std::vector<std::string> others;
    std::optional<Side> taken;
    for (const std::string& seat : around.targets) {
      const std::vector<std::size_t>& all = relations_of(seat);
      const auto along = std::find_if(all.begin(), all.end(), [&](std::size_t i) {
        return scene_.relations[i].type == R::kAlongSide && scene_.relations[i].references == around.references;
      });
      if (along == all.end())
        others.push_back(seat);
      else
        taken = scene_.relations[*along].parameters.side;
    }
    if (others.empty() || !taken || (*taken != Side::kLong && *taken != Side::kShort)) continue;
    Link link;
    link.concluded = true;
    for (const std::string& seat : others) {
      PhraseSense along{R::kAlongSide, Direction::kDirect, {}, {}, *taken == Side::kLong ? Side::kShort : Side::kLong};
      add(link, R::kAlongSide, {seat}, around.references, along);
      scene_.relations.back().hard = false;
    }
  }
}

// "one chair at each end", "two on each long side": as many at the one as at the other.
void RelationBuilder::share_like_sides() {
  const std::vector<Relation> said = scene_.relations;
  std::set<std::string> shared;  // targets
  for (const Relation& first : said) {
    const bool sided = first.type == R::kAlongSide && first.targets.size() == 1 && !shared.contains(first.targets[0]) &&
                       (words_.have(first, "each") || words_.have(first, "both") || words_.have(first, "either"));
    if (!sided) continue;
    std::vector<std::string> all;
    for (const Relation& other : said) {
      const bool like = other.type == R::kAlongSide && other.targets.size() == 1 && other.references == first.references &&
                        other.parameters.side == first.parameters.side && words_.are_one(first, other);
      if (like) all.push_back(other.targets[0]);
    }
    shared.insert(all.begin(), all.end());
    if (all.size() < 2 || all.size() % 2 != 0) continue;
    add_habit(R::kEachSideOf, all, first.references, kTogether, "as many at the one side as at the other");
    // Of more, seats change sides until they sit evenly.
    const auto at_it = [&](const Relation& r) { return r.type == R::kAlongSide && r.references == first.references; };
    scene_.relations.back().hard = std::ranges::count_if(said, at_it) == 2;
  }
}

// "four chairs on each side" of a table sit along its long sides; one on each side of a square table, or on three sides, is around it.
void RelationBuilder::add_seats_at_sides(const Link& link, const std::vector<int>& seats, int table) {
  if (link.sides == Link::kAllSides || link.sides > 2 || sides_by_shape(noun_of_item(table)) > 0) {
    add(link, R::kAround, ids(seats), {id(table)});
    return;
  }
  PhraseSense along{R::kAlongSide, Direction::kDirect, {}, {}, Side::kLong};
  for (const int seat : seats) {
    add(link, along.type, {id(seat)}, {id(table)}, along);
    add_look(link, along.type, seat, table);
  }
}

}  // namespace layoutbox::offline
