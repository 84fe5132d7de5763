// What things are to each other: side by side, face to face, back to back, stacked.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

// "at each of the four tables two chairs face each other": those at one table, where two are at each; else as they come.
std::vector<int> RelationBuilder::by_tables(const std::vector<int>& targets) const {
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

void RelationBuilder::add_each_other(const Link& link, const std::vector<int>& said) {
  if (said.size() < 2 || link.senses.empty()) return;
  const std::vector<int> targets = by_tables(said);
  const NounPhrase& other = noun_of_item(targets.front());
  const auto sense = choose_sense(catalog_, link.senses, Direction::kDirect, noun_of_item(targets.back()), other);
  if (!sense) return;
  // Two benches at each of four tables face each other two by two.
  const bool in_pairs = targets.size() > 2 && other.count == 2;
  // "two rows of desks facing each other", "four armchairs face each other": each has one across; of an odd number they go round.
  if (sense->type == R::kFacing && targets.size() > 2 && !in_pairs) {
    for (std::size_t t = 0; t < targets.size(); ++t)
      add(link, sense->type, {id(targets[t])}, {id(targets[(t + targets.size() / 2) % targets.size()])}, *sense);
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
    const bool backs = sense->type == R::kNextTo && other.entry != nullptr && other.entry->has_front && mount_of(other) == Mount::kFloor &&
                       words_between(document_, link.first, link.last) == "back to back";
    if (backs) {
      add(link, R::kBehind, {one}, {next});
      add(link, R::kBehind, {next}, {one});
    }
    add(link, sense->type, {one}, {next}, *sense);
    if (sense->type == R::kOpposite) add_across(link, targets[t - 1], {next});
    if (sense->type == R::kFacing) add(link, sense->type, {next}, {one}, *sense);
    stand_in_line(link, next, one, other, noun_of_item(targets[t]));
    // Desks at which two look at each other stand back to back.
    const bool desks = sense->type == R::kFacing && targets.size() == 2 && other.entry != nullptr && other.entry->is(Trait::kDeskLike) &&
                       noun_of_item(targets.back()).entry == other.entry;
    if (desks) add_habit(R::kNextTo, {one}, {next}, 100, "desks at which two look at each other stand back to back");
  }
}

// "two recliners side by side": turned alike, their fronts in line.
void RelationBuilder::stand_in_line(const Link& link, const std::string& next, const std::string& one, const NounPhrase& other,
                                    const NounPhrase& neighbour) {
  const bool twins = other.entry != nullptr && other.entry == neighbour.entry && other.entry->has_front && mount_of(other) == Mount::kFloor;
  if (!twins || words_between(document_, link.first, link.last).find("side by side") == std::string::npos) return;
  Link concluded = link;
  concluded.concluded = true;
  add(concluded, R::kSameOrientation, {next}, {one});
  add(concluded, R::kEdgeAlign, {next}, {one});
}

}  // namespace layoutbox::offline
