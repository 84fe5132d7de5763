// Relations of groups: around, between, on each side, in rows, in corners.
#include <algorithm>
#include <iterator>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/offline/relation_builder_parts.h"
#include "layoutbox/plan/offline/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

// What all of them stand on, or empty.
std::string RelationBuilder::carrier_of(const std::vector<std::string>& objects) const {
  std::string host;
  for (const std::string& object : objects) {
    const std::vector<std::size_t>& all = relations_of(object);
    const auto on = std::find_if(all.begin(), all.end(), [&](std::size_t r) { return scene_.relations[r].type == R::kOn; });
    if (on == all.end() || scene_.relations[*on].references.size() != 1) return {};
    const std::string& carrier = scene_.relations[*on].references.front();
    if (!host.empty() && host != carrier) return {};
    host = carrier;
  }
  return host;
}

// "between the sofa and the two armchairs": between the sofa and each of them.
std::vector<std::vector<std::string>> RelationBuilder::between_pairs(const Link& link, const std::vector<std::string>& all) const {
  constexpr std::size_t kMost = 3;
  if (link.references.size() == 2) {
    std::vector<std::string> one = ids(mention(link.references.front()).items), many = ids(mention(link.references.back()).items);
    if (one.size() > many.size()) std::swap(one, many);
    if (one.size() == 1 && many.size() > 1 && many.size() <= kMost) {
      std::vector<std::vector<std::string>> pairs;
      for (const std::string& member : many) pairs.push_back({one.front(), member});
      return pairs;
    }
  }
  return {all};
}

// "A bed between two nightstands": these are what stands at its sides, and their middles need not be on a line with its own.
bool RelationBuilder::are_flankers(const std::vector<std::string>& pair, int middle) const {
  if (pair.size() != 2 || mount_of(noun_of_item(middle)) != Mount::kFloor) return false;
  return std::ranges::all_of(pair, [&](const std::string& one) {
    const SceneObject* object = object_of(one);
    return object != nullptr && flanks(noun_of_object(*object), noun_of_item(middle));
  });
}

// "Two chairs face each other across a table": they sit at it.
void RelationBuilder::add_seats_near(const Link& link, const std::vector<std::string>& seats, int table) {
  if (!is_table(catalog_, noun_of_item(table))) return;
  Link near = link;
  near.soft = near.concluded = true;
  for (const std::string& seat : seats) {
    const SceneObject* object = object_of(seat);
    if (object != nullptr && is_seat(catalog_, noun_of_object(*object))) add(near, R::kNextTo, {seat}, {id(table)});
  }
}

// "a stove to the right of the sink with a counter between": between these two, not between several that the text has besides.
std::vector<int> RelationBuilder::parted_by(const Link& link) const {
  const std::string said = words_between(document_, link.first, link.last);
  if ((said != "between" && said != "in between") || link.references.size() != 1) return link.references;
  auto at = std::ranges::find_if(document_.links, [&](const Link& l) { return &l == &link; });
  if (at == document_.links.end()) return link.references;
  while (at != document_.links.begin() && (&*at == &link || at->kind == Link::Kind::kHave)) --at;
  const Link& before = *at;
  const auto is_thing = [&](const std::vector<int>& said_of) { return said_of.size() == 1 && mention(said_of[0]).items.size() == 1; };
  const bool pair = before.kind == Link::Kind::kRelation && is_thing(before.targets) && is_thing(before.references);
  if (!pair || before.targets[0] == link.targets[0] || before.references[0] == link.targets[0]) return link.references;
  const auto& tokens = document_.tokens;
  for (std::size_t i = before.last; i < link.first; ++i) {
    if (tokens[i].ends_sentence) return link.references;
  }
  const auto is_of = [&](int m) {
    const std::vector<int>& items = mention(link.references[0]).items;
    return items.size() > 1 && std::ranges::find(items, mention(m).items.front()) != items.end();
  };
  if (is_of(before.targets[0]) || is_of(before.references[0])) return link.references;
  return {before.targets[0], before.references[0]};
}

void RelationBuilder::add_between(const Link& link, const std::vector<int>& targets) {
  std::vector<std::string> references;
  for (const int m : parted_by(link)) {
    if (!mention(m).items.empty()) {
      const auto step = static_cast<std::size_t>(std::max(mention(m).noun.apart, 1));
      for (std::size_t i = 0; i < mention(m).items.size(); i += step) references.push_back(id(mention(m).items[i]));
    } else if (is_opening(mention(m).noun)) {
      for (const std::string& opening : opening_ids(mention(m).noun)) references.push_back(opening);
    } else if (mention(m).noun.kind == NounKind::kWall) {
      references.push_back(mention(m).noun.wall_word.empty() ? "back" : mention(m).noun.wall_word);
    }
  }
  if (references.size() < 2) return;
  const std::string host = carrier_of(references);
  for (const int target : targets) {
    // "two candlesticks on the mantel with a clock between them": there as well.
    const SceneObject* carrier = host.empty() ? nullptr : object_of(host);
    if (carrier != nullptr && may_carry(catalog_, noun_of_object(*carrier), noun_of_item(target))) add(link, R::kOn, {id(target)}, {host});
    if (link.first < link.last && document_.tokens[link.first].text == "across") add_seats_near(link, references, target);
    for (const auto& pair : between_pairs(link, references)) {
      if (are_flankers(pair, target))
        add(link, R::kEachSideOf, pair, {id(target)});
      else
        add(link, R::kBetween, {id(target)}, pair);
    }
  }
}

bool RelationBuilder::lie_on(const Link& link, const std::vector<int>& items, int host) const {
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
RelationType RelationBuilder::user_side(int host) const {
  const CatalogEntry* entry = noun_of_item(host).entry;
  return entry != nullptr && entry->used_sides == std::vector{Side::kBack} ? R::kBehind : R::kInFrontOf;
}

// What lies flat shares the middle with what stands there.
void RelationBuilder::add_in_middle(const Link& link, const PhraseSense& sense, const std::vector<int>& targets) {
  std::vector<int> flat, standing;
  for (const int target : targets)
    (noun_of_item(target).entry != nullptr && noun_of_item(target).entry->thin ? flat : standing).push_back(target);
  if (!flat.empty()) add(link, sense.type, ids(flat), {}, sense);
  if (!standing.empty()) add(link, sense.type, ids(standing), {}, sense);
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
  if (!is_seat(catalog_, noun_of_item(targets.front())) || !is_table(catalog_, noun_of_item(host))) return false;
  // "two chairs, one at each end" of a table
  if (targets.size() == 2 && words_between(document_, link.first, link.last).find("end") != std::string::npos) {
    const PhraseSense along{R::kAlongSide, Direction::kDirect, {}, {}, Side::kShort};
    for (const int seat : targets) {
      add(link, along.type, {id(seat)}, {id(host)}, along);
      add_look(link, along.type, seat, host);
    }
    return true;
  }
  // "a long table with benches on both sides": along it, not at its ends
  const CatalogEntry* seat = noun_of_item(targets.front()).entry;
  const bool wide = seat != nullptr && seat->size.usual.width >= 2 * seat->size.usual.depth;
  if (targets.size() == 2 && wide) add(link, R::kEachSideOf, ids(targets), {id(host)});
  if (targets.size() < 4 && link.sides <= 2 && !wide) return false;
  add_seats_at_sides(link, targets, host);
  return true;
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

void RelationBuilder::add_group(const Link& link, PhraseSense sense, const std::vector<int>& targets, const std::vector<int>& references,
                                const Mention* place) {
  if (sense.type == R::kCenterOfRoom) return add_in_middle(link, sense, targets);
  if (sense.type == R::kAround && !references.empty()) {
    // One curtain that is drawn round a couch hangs along it.
    const CatalogEntry* first = noun_of_item(targets.front()).entry;
    if (targets.size() == 1 && first != nullptr && first->is(Trait::kCurtain))
      return add(link, R::kNextTo, ids(targets), {id(references.front())});
    if (seats_one_side(link, targets.front(), references.front())) {
      for (std::size_t t = 0; t < targets.size(); ++t) {
        const bool even = targets.size() % references.size() == 0;  // … and then each has those that follow each other, as everywhere
        const std::string& host = id(references[even ? t * references.size() / targets.size() : t % references.size()]);
        add(link, user_side(references.front()), {id(targets[t])}, {host});
        add(link, R::kFacing, {id(targets[t])}, {host});
      }
      return;
    }
    if (in_ring(targets, references)) sense.type = R::kSurround;
  }
  if (sense.type == R::kEachSideOf && references.size() == 1 && hang_at_sides(link, targets, references)) {
    for (std::size_t t = 0; t < targets.size(); ++t) add(link, R::kOnWall, {id(targets[t])}, {t % 2 == 0 ? "left" : "right"});
    return;
  }
  if (sense.type == R::kEachSideOf && references.size() == 1 && add_at_sides(link, sense, targets, references.front())) return;
  if (sense.type == R::kRow && sense.order != PhraseSense::Order::kNone) {  // "from left to right": each left of the next
    const bool reverse = sense.order == PhraseSense::Order::kReversed;
    for (std::size_t t = 1; t < targets.size(); ++t)
      add(link, R::kLeftOf, {id(targets[reverse ? t : t - 1])}, {id(targets[reverse ? t - 1 : t])});
    return;
  }
  if (references.empty())
    return add(link, sense.type, ids(targets), place != nullptr ? room_reference(place->noun, sense.type) : std::vector<std::string>{},
               sense);
  add_shares(link, sense, targets, references);
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

// "two rows of four chairs".
void RelationBuilder::add_rows() {
  for (const Mention& mention : document_.mentions) {
    if (!mention.introduces || mention.noun.rows == 0 || mention.items.size() < 2) continue;
    Link link;
    link.first = mention.noun.first;
    link.last = mention.noun.last;
    link.rows = mention.noun.rows;
    add(link, mention.noun.rows > 1 ? R::kGrid : R::kRow, ids(mention.items), {});
  }
}

// "two clusters of four desks": each in two rows, close together.
// "desks in pairs facing the board": rows before it, and nobody back to back.
bool RelationBuilder::look_at_one_thing(const Mention& mention) const {
  return !mention.items.empty() && std::ranges::all_of(mention.items, [&](int item) {
    return std::ranges::any_of(relations_of(id(item)), [&](std::size_t r) {
      const R type = scene_.relations[r].type;
      return traits_of(type).looks || type == R::kGrid;
    });
  });
}

void RelationBuilder::add_clusters() {
  for (const Mention& mention : document_.mentions) {
    const auto together = static_cast<std::size_t>(mention.noun.together);
    const auto clusters = together > 1 ? mention.items.size() / together : static_cast<std::size_t>(std::max(mention.noun.clusters, 0));
    if (!mention.introduces || clusters == 0 || mount_of(mention.noun) != Mount::kFloor || mention.items.size() % clusters != 0) continue;
    if (contains_word(mention.noun.attributes, "stacked")) continue;
    const std::size_t share = mention.items.size() / clusters;
    if (share < 2 || look_at_one_thing(mention) || (clusters == 1 && (share < 4 || !are_desks(mention.items)))) continue;
    // "armchairs in groups of four around coffee tables": the tables make the groups.
    const bool around = std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      return traits_of(r.type).around && std::ranges::find(r.targets, id(mention.items.front())) != r.targets.end();
    });
    if (around) continue;
    Link link;
    link.first = mention.noun.first;
    link.last = mention.noun.last;
    for (std::size_t c = 0; c < clusters; ++c) {
      const std::vector<int> own(mention.items.begin() + static_cast<std::ptrdiff_t>(c * share),
                                 mention.items.begin() + static_cast<std::ptrdiff_t>((c + 1) * share));
      if (share > 3 && share % 2 == 0) {
        add_island_of_backs(link, own);
        continue;
      }
      link.rows = share % 2 == 0 ? 2 : 1;
      add(link, R::kRow, ids(own), {});
      scene_.relations.back().parameters.gap = 0;
    }
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

// So small that a second one is in the corner as well.
constexpr Mm kInCorner = 800;
bool RelationBuilder::fits_beside_in_corner(const NounPhrase& noun) {
  return noun.entry != nullptr && std::max(noun.entry->size.usual.width, noun.entry->size.usual.depth) <= kInCorner;
}

void RelationBuilder::add_corners(const Link& link, const Mention& target, const NounPhrase& corner) {
  static const std::vector<std::vector<std::string>> kCorners = {
      {"left", "back"}, {"right", "back"}, {"left", "front"}, {"right", "front"}};
  // "the two far corners": of those that the word names.
  const std::vector<std::string> side = room_reference(corner, R::kCorner);
  if ((corner.is_plural() || corner.determiner == Determiner::kEach) && target.items.size() > 1 && side.size() == 1) {
    std::vector<std::vector<std::string>> named;
    std::copy_if(kCorners.begin(), kCorners.end(), std::back_inserter(named),
                 [&](const auto& c) { return std::find(c.begin(), c.end(), side.front()) != c.end(); });
    for (std::size_t t = 0; t < target.items.size() && !named.empty(); ++t)
      add(link, R::kCorner, {id(target.items[t])}, named[t % named.size()]);
    if (!named.empty()) return;
  }
  bool several = corner.is_plural();  // "in the corners of the room"
  for (std::size_t i = link.first; i < link.last; ++i) several |= document_.tokens[i].text == "corners";
  const bool every = corner.determiner == Determiner::kEach || corner.determiner == Determiner::kBoth || corner.count == 4;
  for (std::size_t t = 0; t < target.items.size(); ++t) {
    const auto references = every && target.items.size() > 1 ? kCorners[t % kCorners.size()] : side;
    // "two fitting rooms at the back right", "three armchairs in a corner": one is in it, the others beside it; "boxes in the corner": all.
    const bool with_first = !every && !several && t > 0 && mount_of(target.noun) == Mount::kFloor;
    if (with_first && (side.size() == 2 || !fits_beside_in_corner(target.noun))) {
      add(link, R::kNextTo, {id(target.items[t])}, {id(target.items[t - 1])});
      continue;
    }
    add(link, R::kCorner, {id(target.items[t])}, references);
    if (!with_first) continue;
    if (scene_.relations.back().type == R::kCorner) scene_.relations.back().parameters.max = kInCorner;
    Link together = link;
    together.soft = together.concluded = true;
    add(together, R::kNextTo, {id(target.items[t])}, {id(target.items[0])});
  }
}

}  // namespace layoutbox::offline
