// How many of a thing there are by where they are put: one at every side, in every corner, for each of the others, so many that a wall is
// full.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/scribe.h"

namespace layoutbox::offline {

namespace {

// "in every corner" four, "in each of the two far corners" two.
std::size_t corners_meant(const NounPhrase& corner) {
  if (corner.count > 0) return static_cast<std::size_t>(corner.count);
  return corner.wall_word.empty() ? 4 : 2;  // "in each back corner"
}

// "against each side wall" two, "on every wall" four.
std::size_t walls_meant(const NounPhrase& wall) {
  if (wall.count > 0) return static_cast<std::size_t>(wall.count);
  if (!wall.wall_word.empty()) return 1;
  const bool some =
      wall.name.find("side wall") != std::string::npos || contains_word(wall.attributes, "long") || contains_word(wall.attributes, "short");
  return some ? 2 : 4;
}

}  // namespace

// "a wall covered in bookshelves", "tall shelves on every wall": so many that they fill an ordinary wall, or stand at all but the front
// one.
std::size_t Scribe::row_along_walls(const Link& link, int target, const NounPhrase& wall) const {
  constexpr Mm kOrdinaryWall = 3600, kHalfOfIt = 1800;
  constexpr std::size_t kWalls = 3, kMostAtWall = 5;
  const CatalogEntry* entry = noun_of(target).entry;
  if (entry == nullptr || entry->mount != Mount::kFloor || !entry->back_to_wall) return 0;
  bool full = is_full_height(noun_of(target));
  for (std::size_t i = link.first; i < link.last; ++i) full |= lexicon_.is_in("full", document_.tokens[i].text);
  const bool boards = says(link.senses, RelationType::kOnWall) && kind_at(lexicon_.catalog(), entry->id, KinPlace::kOnWall) != nullptr;
  if (boards && !full && !is_tall(noun_of(target))) return 0;
  const bool all = wall.determiner == Determiner::kBoth && document_.tokens[wall.first].text == "all";
  const bool every = (wall.determiner == Determiner::kEach || all) && walls_meant(wall) > kWalls;
  const auto in_row = [&](Mm length) { return std::min(static_cast<std::size_t>(length / entry->size.usual.width), kMostAtWall); };
  if (every) return kWalls * std::max<std::size_t>(in_row(kHalfOfIt), 1);
  if (full && wall.count > 1) return static_cast<std::size_t>(wall.count) * std::max<std::size_t>(in_row(kHalfOfIt), 1);
  return full ? in_row(kOrdinaryWall) : 0;
}

// "bookshelves lining three walls": at least one at each.
void Scribe::grow_along_walls(const Link& link, int target, const NounPhrase& wall) {
  // "acoustic foam on two walls", "posters on all walls": something on each
  const NounPhrase& thing = noun_of(target);
  const bool hung = thing.entry != nullptr && thing.entry->mount == Mount::kWall && thing.determiner == Determiner::kNone;
  const bool several = hung || noun_of(target).plural ||
                       (is_uncounted_stuff(noun_of(target)) && is_storage(noun_of(target)) && (wall.plural || wall.count > 1));
  if (wall.kind != NounKind::kWall || !several || noun_of(target).count > 0) return;
  const bool both = wall.determiner == Determiner::kBoth && document_.tokens[wall.first].text == "both";
  const bool all = wall.determiner == Determiner::kBoth && document_.tokens[wall.first].text == "all";
  const auto walls = all && hung ? walls_meant(wall) : static_cast<std::size_t>(std::max(wall.count, both ? 2 : 0));
  references_.grow(target, std::max(walls, row_along_walls(link, target, wall)));
}

// "an L-shaped counter along the back and right walls", "cabinets along two named walls": one at each.
void Scribe::grow_at_two_walls(const Link& link) {
  if (link.references.size() < 2 || link.targets.size() != 1 || !is_thing(link.targets.front())) return;
  const auto is_wall = [&](int reference) {
    const NounPhrase& wall = noun_of(reference);
    return (wall.kind == NounKind::kWall || wall.kind == NounKind::kPart) && !wall.wall_word.empty();
  };
  const NounPhrase& thing = noun_of(link.targets.front());
  const bool fills = thing.entry != nullptr && thing.entry->mount == Mount::kFloor && thing.entry->back_to_wall &&
                     (thing.entry->is(Trait::kCounter) || is_storage(thing)) && thing.count == 0;
  if (!fills || !mention_at(link.targets.front()).introduces || !std::ranges::all_of(link.references, is_wall)) return;
  references_.grow(link.targets.front(), link.references.size());
}

// At how many sides of the thing the words put something: "on three sides", "at each side" of a square table; two where nobody says.
int Scribe::sides_meant(const Link& link, int target, int reference) const {
  if (link.sides > 2) return link.sides;
  if (reference < 0 || !is_table(lexicon_.catalog(), noun_of(reference)) || !is_seat(lexicon_.catalog(), noun_of(target))) return 2;
  const int shape = sides_by_shape(noun_of(reference));
  constexpr int kSidesOfTable = 4;
  return shape > 0 ? shape : link.sides == Link::kAllSides ? kSidesOfTable : 2;
}

// "a lamp on each side" is two lamps, "two chairs on each long side" four, a chair on each side of a square table as well.
void Scribe::grow_for_sides(const Link& link, int target, int reference) {
  // "the dentist's stool and the nurse's stool on either side": one each
  bool either = false;  // "a lamp and a plant on either side": one of them at each
  for (std::size_t at = link.first; at < link.last; ++at) either |= says_one_of(document_, at, {"either"});
  // … but a nightstand and a lamp, which stands on it, are two and two
  const auto carried = [&](int one) {
    return std::ranges::any_of(link.targets, [&](int other) {
      return mount_of(noun_of(other)) == Mount::kFloor && may_carry(lexicon_.catalog(), noun_of(other), noun_of(one));
    });
  };
  either = either && std::ranges::none_of(link.targets, carried);
  const bool told_apart = std::ranges::all_of(link.targets, [&](int one) {
    return (either || noun_of(one).determiner == Determiner::kDefinite) && mention_at(one).items.size() == 1;
  });
  if (link.targets.size() == 2 && told_apart) return;
  const std::size_t count = mention_at(target).items.size();
  const bool said = noun_of(target).count > 1, each_side = says(link.senses, RelationType::kEachSideOf);
  const int sides = each_side ? sides_meant(link, target, reference) : 2;
  constexpr Mm kLong = 1000;  // "benches on either long side": one at each
  const NounPhrase& noun = noun_of(target);
  const bool one_each = noun.plural && noun.count == 0 && noun.entry != nullptr && noun.entry->size.usual.width >= kLong;
  if (says(link.senses, RelationType::kAlongSide))
    references_.grow(target, one_each ? count : count * 2);
  else if (sides > 2 && !said)
    references_.grow(target, static_cast<std::size_t>(sides));
  else if (sides > 2 && link.sides > 0)  // "six chairs on three sides" are six; "two at each of four sides" eight
    references_.grow(target, link.sides_shared ? count * static_cast<std::size_t>(sides) : count);
  else if (each_side && count == 1 && reference >= 0 && is_table(lexicon_.catalog(), noun_of(reference)) &&
           is_seat(lexicon_.catalog(), noun_of(target)))  // "two tables with a chair on each side"
    references_.grow(target, 2 * std::max<std::size_t>(mention_at(reference).items.size(), 1));
  else if (each_side && count != 2)
    references_.grow(target, count * 2);
  grow_contents(target, count);
}

// As many of the thing as were said for each of the others, unless they were shared out before.
void Scribe::grow_for_each(int thing, int each) {
  const NounPhrase& noun = noun_of(thing);
  const std::size_t now = mention_at(thing).items.size(), unsaid = noun.plural ? 2 : 1;
  if (now > std::max(static_cast<std::size_t>(std::max(noun.count, 0)), unsaid)) return;
  // "six glasses in front of each chair" of six: one for each, as people mean it.
  constexpr std::size_t kMany = 4;
  if (now >= kMany && now == mention_at(each).items.size() && mount_of(noun) == Mount::kSurface) return;
  references_.grow(thing, now * std::max<std::size_t>(mention_at(each).items.size(), 1));
}

// "thirty desks with chairs": one for each of them.
void Scribe::grow_for_hosts(int content, const std::vector<int>& hosts) {
  const NounPhrase& noun = noun_of(content);
  if (!mention_at(content).introduces || noun.count > 0 || noun.collective || hosts.size() != 1) return;
  const Mention& host = mention_at(hosts.front());
  // "two desks with chair", as people write who leave out articles
  const bool bare = !noun.plural && noun.determiner == Determiner::kNone && noun_of(hosts.front()).is_plural() &&
                    is_seat(lexicon_.catalog(), noun) && is_table(lexicon_.catalog(), noun_of(hosts.front()));
  if (!noun.plural && !bare) return;
  if (!host.distributes && host.items.size() > mention_at(content).items.size()) references_.grow(content, host.items.size());
}

// "microscopes are set out on three of the desks": as many, where nobody says how many there are.
void Scribe::grow_on(const Link& link, int thing, int some) {
  const NounPhrase& noun = noun_of(thing);
  const bool uncounted = mention_at(thing).introduces && noun.plural && noun.count == 0 && noun.determiner == Determiner::kNone;
  if (!uncounted || !is_some_of_group(some) || !says(link.senses, &RelationTraits::rests)) return;
  references_.grow(thing, std::max(mention_at(thing).items.size(), mention_at(some).items.size()));
}

// "two of them": several, but not all.
bool Scribe::is_some_of_group(int mention) const {
  if (!is_thing(mention) || mention_at(mention).introduces || mention_at(mention).items.size() < 2) return false;
  const int whole = references_.whole_group(mention);
  return whole >= 0 && mention_at(whole).items.size() > mention_at(mention).items.size();
}

void Scribe::grow_on_some(const Link& link, int some) {
  for (const int target : link.targets) grow_on(link, target, some);
}

// "two windows in the back wall … a radiator under each window": as many as there are.
void Scribe::grow_for_openings(const NounPhrase& opening, int target) {
  const bool each = opening.determiner == Determiner::kEach || opening.determiner == Determiner::kBoth;
  if (!each || noun_of(target).determiner != Determiner::kIndefinite || mention_at(target).items.size() != 1) return;
  int named = opening.determiner == Determiner::kBoth ? 2 : 0;
  for (const NounPhrase& other : document_.openings) {
    if (other.kind == opening.kind) named = std::max(named, other.count > 0 ? other.count : other.plural ? 2 : 1);
  }
  references_.grow(target, static_cast<std::size_t>(named));
  grow_contents(target, 1);
}

void Scribe::grow_for_corners(const NounPhrase& corner, int target) {
  if (corner.kind == NounKind::kWindow || corner.kind == NounKind::kDoor) return grow_for_openings(corner, target);
  const bool wall = corner.kind == NounKind::kWall;
  if (corner.kind != NounKind::kCorner && !wall) return;
  // "in two of the corners a pedestal with a bust on it"
  const bool counted = !wall && corner.count > 1 && noun_of(target).determiner == Determiner::kIndefinite;
  const int said = noun_of(target).count;
  const bool both = !wall && corner.determiner == Determiner::kBoth && noun_of(target).determiner == Determiner::kIndefinite;
  // "palms in all four corners": as many
  const bool all = !wall && noun_of(target).plural && said == 0 && noun_of(target).determiner == Determiner::kNone &&
                   (corner.count > 2 || (corner.determiner == Determiner::kBoth && corner.count != 2));
  if (all) references_.grow(target, corners_meant(corner));
  if (corner.determiner != Determiner::kEach && !counted && !both) return;
  const std::size_t before = mention_at(target).items.size();
  if (said <= 1) references_.grow(target, wall ? walls_meant(corner) : both ? 2 : corners_meant(corner));
  // "on each of the side walls hang three portraits"; "four lamps, on every wall one" were counted before.
  if (said > 1 && wall && before == static_cast<std::size_t>(said) && corner.determiner == Determiner::kEach)
    references_.grow(target, before * walls_meant(corner));
  grow_contents(target, before);
}

// What each of the things has grows with them: "a nightstand with a lamp on each side".
void Scribe::grow_contents(int host, std::size_t before) {
  const std::size_t now = mention_at(host).items.size();
  if (before == 0 || now <= before) return;
  for (std::size_t l = sentence_links_; l < document_.links.size(); ++l) {
    const Link& link = document_.links[l];
    if (link.kind != Link::Kind::kHave || !contains(link.references, host)) continue;
    for (const int content : link.targets) references_.grow(content, mention_at(content).items.size() * now / before);
  }
  // "a lamp on a stand at either end of the desk": so do the lamp and the stand.
  for (std::size_t l = sentence_links_; l < document_.links.size(); ++l) {
    const Link& link = document_.links[l];
    if (link.kind != Link::Kind::kRelation || link.references.size() != 1 || link.targets.size() != 1) continue;
    if (!says(link.senses, &RelationTraits::rests)) continue;
    const int other = link.targets.front() == host ? link.references.front() : link.references.front() == host ? link.targets.front() : -1;
    if (other < 0 || !is_thing(other) || !mention_at(other).introduces || mention_at(other).items.size() != before) continue;
    if (noun_of(other).determiner == Determiner::kIndefinite && mount_of(noun_of(link.targets.front())) == Mount::kSurface)
      references_.grow(other, now);
  }
}

}  // namespace layoutbox::offline
