// Doors and windows placed by things: "to the right of the bed is a door" puts the bed by that door.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/offline/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

// What the thing is said to be by the opening, where the opening is said to be PHRASE the thing.
std::optional<R> turned_sense(const PhraseSenses& senses, const NounPhrase& opening) {
  const bool window = opening.kind == NounKind::kWindow;
  if (window && (says(senses, R::kAbove) || says(senses, R::kBehind))) return R::kUnderWindow;
  if (says(senses, R::kOpposite) || says(senses, R::kFacing)) return R::kOpposite;
  if (says(senses, R::kNear) && !says(senses, R::kNextTo)) return R::kNear;
  if (says(senses, R::kBehind) || says(senses, R::kInFrontOf)) return R::kNear;
  const bool beside = std::ranges::any_of(senses, [](const PhraseSense& sense) { return stands_beside(sense.type); });
  return beside ? std::optional(R::kNextTo) : std::nullopt;
}

}  // namespace

void RelationBuilder::add_by_openings(const Link& link) {
  const std::vector<int> items = items_of(link.references);
  if (link.implied && words_between(document_, link.first, link.last).find(" end") != std::string::npos) return;  // of the room
  if (items.empty() || link.kind != Link::Kind::kRelation) return;
  for (const int target : link.targets) {
    const NounPhrase& opening = mention(target).noun;
    if (!mention(target).items.empty() || !is_opening(opening)) continue;
    if (says(link.senses, R::kBetween) && items.size() == 2) {
      add(link, R::kEachSideOf, ids(items), room_reference(opening, R::kEachSideOf));
      continue;
    }
    const std::optional<R> sense = turned_sense(link.senses, opening);
    for (const int item : sense ? items : std::vector<int>{}) {
      const Mount mount = mount_of(noun_of_item(item));
      const bool under = *sense == R::kUnderWindow;
      if (mount == Mount::kFloor || (under && says(link.senses, R::kAbove)) || (*sense == R::kNextTo && mount == Mount::kWall))
        add(link, *sense, {id(item)}, under ? std::vector<std::string>{} : room_reference(opening, *sense));
    }
  }
}

}  // namespace layoutbox::offline
