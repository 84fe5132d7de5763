// What stands between, and what the things on either side of it are.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;

using Direction = PhraseSense::Direction;

// "between the sofa and the two armchairs": between the sofa and each of them.
std::vector<std::vector<std::string>> RelationBuilder::between_pairs(const std::vector<int>& parted,
                                                                     const std::vector<std::string>& all) const {
  constexpr std::size_t kMost = 3;
  if (parted.size() == 2) {
    std::vector<std::string> one = ids(mention(parted.front()).items), many = ids(mention(parted.back()).items);
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
  const bool bare = link.last > 0 && says_one_of(document_, link.last - 1, {"between"});
  const bool them = link.last > 0 && says_one_of(document_, link.last - 1, {"them"});
  if ((!bare && !them) || link.references.size() != 1) return link.references;
  const Mention& one = mention(link.references.front());
  if (const int across = seen_across(link); across >= 0) return {across, link.references.front()};
  const bool lonely = one.noun.kind == NounKind::kObject && one.items.size() == 1 && one.noun.last <= link.first;
  const std::vector<int> two = lonely ? last_two_before(link) : std::vector<int>{};
  const std::vector<int>& others = two.size() == 2 ? two : link.references;
  if (!bare) return others;
  auto at = std::ranges::find_if(document_.links, [&](const Link& l) { return &l == &link; });
  if (at == document_.links.end()) return others;
  while (at != document_.links.begin() && (&*at == &link || at->kind == Link::Kind::kHave)) --at;
  const Link& before = *at;
  if (one.items.size() > 1 && one.noun.first >= before.last) return others;  // "a TV on a stand, two armchairs with a lamp between"
  const auto is_thing = [&](const std::vector<int>& said_of) { return said_of.size() == 1 && mention(said_of[0]).items.size() == 1; };
  const bool pair = before.kind == Link::Kind::kRelation && is_thing(before.targets) && is_thing(before.references);
  if (!pair || before.targets[0] == link.targets[0] || before.references[0] == link.targets[0]) return others;
  const auto& tokens = document_.tokens;
  for (std::size_t i = before.last; i < link.first; ++i) {
    if (tokens[i].ends_sentence) return others;
  }
  const auto is_of = [&](int m) {
    const std::vector<int>& items = mention(link.references[0]).items;
    return items.size() > 1 && std::ranges::find(items, mention(m).items.front()) != items.end();
  };
  if (is_of(before.targets[0]) || is_of(before.references[0])) return others;
  return {before.targets[0], before.references[0]};
}

// "a sofa, two armchairs opposite, a coffee table between them": between these and what they are across from; −1: nothing is.
int RelationBuilder::seen_across(const Link& link) const {
  const Mention& group = mention(link.references.front());
  const auto is_low = [&](int m) {
    const CatalogEntry* entry = mention(m).noun.entry;
    return entry != nullptr && (entry->is(Trait::kCoffeeTable) || entry->thin);
  };
  if (group.items.size() < 2 || !std::ranges::all_of(link.targets, is_low)) return -1;
  for (const Link& before : document_.links) {
    const bool looks = says(before.senses, R::kOpposite) || says(before.senses, R::kFacing);
    if (!looks || before.targets.size() != 1 || before.references.size() != 1 || mention(before.targets[0]).items != group.items) continue;
    const Mention& other = mention(before.references[0]);
    if (other.items.size() == 1 && other.items != group.items && mount_of(other.noun) == Mount::kFloor) return before.references[0];
  }
  return -1;
}

// "The sofa is at the back wall, the TV stand at the front wall, a table halfway between": of the last two things that stand on the floor.
std::vector<int> RelationBuilder::last_two_before(const Link& link) const {
  std::vector<int> two;
  for (std::size_t m = document_.mentions.size(); m-- > 0 && two.size() < 2;) {
    const Mention& thing = document_.mentions[m];
    const bool before = thing.noun.last <= link.first && thing.noun.kind == NounKind::kObject && thing.items.size() == 1;
    if (!before || std::ranges::find(link.targets, static_cast<int>(m)) != link.targets.end() || mount_of(thing.noun) != Mount::kFloor)
      continue;
    const auto is_same = [&](int other) { return mention(other).items == thing.items; };
    if (std::ranges::none_of(two, is_same) && std::ranges::none_of(link.targets, is_same)) two.push_back(static_cast<int>(m));
  }
  std::ranges::reverse(two);
  return two;
}

void RelationBuilder::add_between(const Link& link, const std::vector<int>& targets) {
  std::vector<std::string> references;
  const std::vector<int> parted = parted_by(link);
  for (const int m : parted) {
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
    for (const auto& pair : between_pairs(parted, references)) {
      if (are_flankers(pair, target))
        add(link, R::kEachSideOf, pair, {id(target)});
      else
        add(link, R::kBetween, {id(target)}, pair);
    }
  }
}

// "two recliners side by side, a little table between them": as near as the table lets them be; a plain table between easy seats is small.
void RelationBuilder::make_room_between() {
  std::vector<std::pair<std::string, std::string>> in_reach, at_sofas;  // seat and table
  for (const Relation& between : scene_.relations) {
    if (between.type != R::kBetween || between.references.size() != 2 || between.targets.size() != 1) continue;
    const auto middle = std::ranges::find(scene_.objects, between.targets[0], &SceneObject::id);
    if (middle == scene_.objects.end()) continue;
    const NounPhrase& thing = noun_of_object(*middle);
    if (thing.entry == nullptr || mount_of(thing) != Mount::kFloor) continue;
    const auto are_all = [&](Trait trait, Trait but) {
      return std::ranges::all_of(between.references, [&](const std::string& id) {
        const SceneObject* seat = object_of(id);
        const CatalogEntry* entry = seat == nullptr ? nullptr : noun_of_object(*seat).entry;
        return entry != nullptr && entry->is(trait) && !entry->is(but);
      });
    };
    const bool sofas = are_all(Trait::kCenterPiece, Trait::kBed), easy = sofas || are_all(Trait::kEasySeat, Trait::kBed);
    const CatalogEntry* small = kind_at(catalog_, thing.entry->id, sofas ? KinPlace::kBetweenSofas : KinPlace::kBetweenSeats);
    if (easy && small != nullptr && thing.exact && !thing.size.any()) middle->category = small->id;
    for (std::size_t s = 0; easy && s < 2; ++s) (sofas ? at_sofas : in_reach).emplace_back(between.references[s], between.targets[0]);
    const CatalogEntry* kind = catalog_.find(middle->category);
    const Mm width = (kind != nullptr ? kind : thing.entry)->size.usual.width;
    std::vector<std::size_t> of_both = relations_of(between.references[0]);
    of_both.insert(of_both.end(), relations_of(between.references[1]).begin(), relations_of(between.references[1]).end());
    for (const std::size_t r : of_both) {
      Relation& beside = scene_.relations[r];
      const bool of_pair = beside.type == R::kNextTo && beside.targets.size() == 1 && beside.references.size() == 1 &&
                           std::ranges::find(between.references, beside.targets[0]) != between.references.end() &&
                           std::ranges::find(between.references, beside.references[0]) != between.references.end();
      constexpr Mm kAir = 300, kUsualMost = 500;  // of what is next to something
      if (of_pair && !beside.parameters.max && width + kAir > kUsualMost) beside.parameters.max = width + kAir;
    }
  }
  seat_in_reach(in_reach);
  for (const auto& [sofa, table] : at_sofas) {
    conclude(R::kNextTo, {sofa}, {table}, "a table between two sofas is in reach of both");
  }
}

}  // namespace layoutbox::offline
