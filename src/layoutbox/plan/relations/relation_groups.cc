// Relations of groups: around, in rows, in clusters, in corners.
#include <algorithm>
#include <iterator>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
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
        add(link, user_side(references.front(), targets.size() == references.size()), {id(targets[t])}, {host});
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

// So small that a second one is in the corner as well.
constexpr Mm kInCorner = 800;

bool RelationBuilder::fits_beside_in_corner(const NounPhrase& noun) {
  return noun.entry != nullptr && std::max(noun.entry->size.usual.width, noun.entry->size.usual.depth) <= kInCorner;
}

// The thing stands on another one of its own.
bool RelationBuilder::stands_on_fellow(const Mention& things, std::size_t which) const {
  const std::vector<std::string> all = ids(things.items);
  return std::ranges::any_of(relations_of(all[which]), [&](std::size_t r) {
    const Relation& relation = scene_.relations[r];
    return relation.type == R::kOn && relation.targets.front() == all[which] && !relation.references.empty() &&
           std::ranges::find(all, relation.references.front()) != all.end();
  });
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
    if (with_first && stands_on_fellow(target, t)) continue;  // "two bales stacked in the corner"
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
