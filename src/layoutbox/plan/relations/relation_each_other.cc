// What things are to each other: side by side, face to face, back to back, stacked.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

// "ten tables, each with two chairs opposite each other": as the tables will share them out; empty: they have no such tables.
std::vector<int> RelationBuilder::by_shares(const std::vector<int>& targets) const {
  for (const Link& link : document_.links) {
    if (link.kind != Link::Kind::kHave || items_of(link.targets).empty()) continue;
    const std::vector<int> tables = items_of(link.references);
    const bool of_all = std::ranges::any_of(link.targets, [&](int m) { return mention(m).items == targets; });
    if (!of_all || targets.size() != 2 * tables.size() || !is_table(catalog_, noun_of_item(tables.front()))) continue;
    std::vector<int> ordered;
    for (std::size_t t = 0; t < tables.size(); ++t) ordered.insert(ordered.end(), {targets[t], targets[t + tables.size()]});
    return ordered;
  }
  return {};
}

// "at each of the four tables two chairs face each other": those at one table, where two are at each; else as they come.
std::vector<int> RelationBuilder::by_tables(const std::vector<int>& targets) const {
  if (std::vector<int> shared = by_shares(targets); !shared.empty()) return shared;
  std::vector<std::pair<std::string, std::vector<int>>> tables;
  for (const int target : targets) {
    const std::vector<std::size_t>& all = relations_of(id(target));
    const auto at = std::ranges::find_if(all, [&](std::size_t r) {
      return (scene_.relations[r].type == R::kAround || scene_.relations[r].type == R::kNextTo) &&
             scene_.relations[r].references.size() == 1;
    });
    if (at == all.end()) return targets;
    const std::string& table = scene_.relations[*at].references.front();
    const auto known = std::ranges::find_if(tables, [&](const auto& one) { return one.first == table; });
    if (known == tables.end())
      tables.push_back({table, {target}});
    else
      known->second.push_back(target);
  }
  std::vector<int> ordered;
  for (const auto& [table, seats] : tables) {
    if (seats.size() != 2) return targets;
    ordered.insert(ordered.end(), seats.begin(), seats.end());
  }
  return ordered;
}

// An even number of desks of one kind.
bool RelationBuilder::are_desks(const std::vector<int>& items) const {
  const CatalogEntry* desk = noun_of_item(items.front()).entry;
  return items.size() % 2 == 0 && desk != nullptr && desk->is(Trait::kDeskLike) &&
         std::ranges::all_of(items, [&](int item) { return noun_of_item(item).entry == desk; });
}

// Two rows close together, the first half of them in one and the rest in the other.
void RelationBuilder::add_island(const Link& link, const std::vector<int>& members) {
  Link form = link;
  form.rows = 2;
  add(form, R::kGrid, ids(members), {});
  scene_.relations.back().parameters.gap = 0;
}

// What has a back stands back to back in its island; pupils sit behind their desks, whose fronts meet.
void RelationBuilder::add_island_of_backs(const Link& link, const std::vector<int>& members) {
  add_island(link, members);
  const CatalogEntry* entry = noun_of_item(members.front()).entry;
  const R meets = user_side(members.front()) == R::kBehind ? R::kInFrontOf : R::kBehind;
  for (std::size_t i = 0; entry != nullptr && entry->has_front && i < members.size() / 2; ++i) {
    const std::string &front = id(members[i]), &back = id(members[i + members.size() / 2]);
    add(link, meets, {front}, {back});
    add(link, meets, {back}, {front});
  }
}

// What the phrase means of things to one another; over a table that two share "opposite" is facing, however near.
std::optional<PhraseSense> RelationBuilder::sense_to_each_other(const Link& link, const std::vector<int>& said, const NounPhrase& target,
                                                                const NounPhrase& other) const {
  auto sense = choose_sense(catalog_, link.senses, Direction::kDirect, target, other);
  if (sense && sense->type == R::kOpposite && !by_shares(said).empty()) sense->type = R::kFacing;
  return sense;
}

// Between rows of seats that face each other one walks to one's own.
void RelationBuilder::leave_room_for_knees(const std::vector<int>& seats) {
  constexpr Mm kToPass = 1100;
  add_habit(R::kDistance, {id(seats.front())}, {id(seats[seats.size() / 2])}, kTogether, "between seats that face each other one can pass");
  scene_.relations.back().parameters.min = kToPass;
}

// Each has one of the other half across.
void RelationBuilder::face_across(const Link& link, const std::vector<int>& things, const PhraseSense& sense) {
  const NounPhrase& kind = noun_of_item(things.front());
  for (std::size_t t = 0; t < things.size(); ++t)
    add(link, sense.type, {id(things[t])}, {id(things[(t + things.size() / 2) % things.size()])}, sense);
  if (kind.rows == 0 && are_desks(things)) add_island(link, things);
  if (is_seat(catalog_, kind) && things.size() % 2 == 0) leave_room_for_knees(things);
}

void RelationBuilder::add_each_other(const Link& link, const std::vector<int>& said) {
  if (said.size() < 2 || link.senses.empty()) return;
  const std::vector<int> targets = by_tables(said);
  const NounPhrase& other = noun_of_item(targets.front());
  const auto sense = sense_to_each_other(link, said, noun_of_item(targets.back()), other);
  if (!sense) return;
  // Two benches at each of four tables face each other two by two.
  const bool in_pairs = targets.size() > 2 && other.count == 2;
  // "two rows of desks facing each other", "four armchairs face each other": each has one across; of an odd number they go round.
  if (sense->type == R::kFacing && targets.size() > 2 && !in_pairs) {
    face_across(link, targets, *sense);
    return;
  }
  const bool back_to_back =
      sense->type == R::kNextTo && other.entry != nullptr && words_between(document_, link.first, link.last) == "back to back";
  if (back_to_back && targets.size() > 2 && !in_pairs && other.rows == 0 && are_desks(targets)) {
    // "two blocks of three desks, back to back" are the rows of one; of four each has its own two.
    const std::size_t share = other.clusters > 0 ? targets.size() / static_cast<std::size_t>(other.clusters) : targets.size();
    if (share < 4 || share % 2 != 0 || other.clusters == 0) add_island_of_backs(link, targets);
    return;
  }
  // "three tables side by side" stand in a row.
  if (sense->type == R::kNextTo && targets.size() > 2 && !in_pairs && mount_of(other) == Mount::kFloor)
    add(link, R::kRow, ids(targets), {});
  for (std::size_t t = 1; t < targets.size(); t += in_pairs ? 2 : 1) {
    const std::string &one = id(targets[t - 1]), &next = id(targets[t]);
    if (sense->type == R::kStacked) {  // shelves on a wall are above each other, boxes stand on each other
      const std::vector<std::size_t>& all = relations_of(one);
      const bool hangs = mount_of(other) == Mount::kWall ||
                         std::any_of(all.begin(), all.end(), [&](std::size_t r) { return scene_.relations[r].type == R::kOnWall; });
      add(link, hangs ? R::kAbove : R::kOn, {next}, {one});
      continue;
    }
    // "two workbenches back to back": each has the other behind it.
    const bool backs = back_to_back && other.entry->has_front && mount_of(other) == Mount::kFloor;
    if (backs) {
      add(link, R::kBehind, {one}, {next});
      add(link, R::kBehind, {next}, {one});
    }
    add(link, sense->type, {one}, {next}, *sense);
    if (sense->type == R::kOpposite) add_across(link, targets[t - 1], {next});
    if (sense->type == R::kFacing) add(link, sense->type, {next}, {one}, *sense);
    stand_in_line(link, next, one, other, noun_of_item(targets[t]));
    // Desks at which two look at each other stand back to back.
    if (sense->type == R::kFacing && targets.size() == 2 && are_desks(targets))
      add_habit(R::kNextTo, {one}, {next}, 100, "desks at which two look at each other stand back to back");
  }
}

// "two recliners side by side": turned alike, their fronts in line; of two kinds ("a treadmill and a bike") as far as it goes.
void RelationBuilder::stand_in_line(const Link& link, const std::string& next, const std::string& one, const NounPhrase& other,
                                    const NounPhrase& neighbour) {
  const auto has_place = [&](const NounPhrase& noun) {
    return noun.entry != nullptr && noun.entry->has_front && mount_of(noun) == Mount::kFloor;
  };
  const std::string words = words_between(document_, link.first, link.last);
  bool abreast = words.find("side by side") != std::string::npos || words.find("next to each other") != std::string::npos;
  for (std::size_t i = link.first; i + 1 < link.last; ++i)
    abreast |= document_.tokens[i].text == "beside" && document_.tokens[i + 1].text == "each";
  if (!abreast || !has_place(other) || !has_place(neighbour)) return;
  if (other.entry != neighbour.entry) {
    for (const R type : {R::kSameOrientation, R::kEdgeAlign})
      add_habit(type, {next}, {one}, kTogether, "what is side by side stands abreast");
    return;
  }
  if (words.find("side by side") == std::string::npos) return;
  Link concluded = link;
  concluded.concluded = true;
  add(concluded, R::kSameOrientation, {next}, {one});
  add(concluded, R::kEdgeAlign, {next}, {one});
}

// "three stacked crates" stand on each other, "six dryers stacked in pairs" two by two in a row.
void RelationBuilder::add_stacks() {
  constexpr std::size_t kMostInStack = 5;
  for (const Mention& mention : document_.mentions) {
    const NounPhrase& noun = mention.noun;
    const bool stacked =
        contains_word(noun.attributes, "stacked") || contains_word(noun.attributes, "piled") || noun.name.starts_with("stacked ");
    const std::size_t height = noun.together > 1 ? static_cast<std::size_t>(noun.together) : mention.items.size();
    if (!mention.introduces || !stacked || mention.items.size() < 2 || height > kMostInStack || noun.entry == nullptr) continue;
    if (mount_of(noun) != Mount::kFloor || is_seat(catalog_, noun)) continue;
    Link link;
    link.first = noun.first;
    link.last = noun.last;
    std::vector<int> lowest;
    for (std::size_t i = 0; i < mention.items.size(); ++i) {
      if (i % height == 0)
        lowest.push_back(mention.items[i]);
      else
        add(link, R::kOn, {id(mention.items[i])}, {id(mention.items[i - 1])});
    }
    if (lowest.size() > 1) add(link, R::kRow, ids(lowest), {});
  }
}

}  // namespace layoutbox::offline
