// Links between mentions become relations: who is placed by what, alone, in groups and at parts of the room.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

void RelationBuilder::run() {
  for (Link& link : document_.links) {
    // "a television on a low unit and a nest of tables": it stands on one of them, the other is by itself.
    const bool on = link.kind == Link::Kind::kRelation && says(link.senses, R::kOn) && !link.each && link.references.size() == 2;
    if (!on || link.targets.size() != 1 || mention(link.targets[0]).items.size() != 1 || mention(link.targets[0]).noun.is_plural())
      continue;
    const bool things = std::ranges::all_of(link.references, [&](int r) { return mention(r).introduces && mention(r).items.size() == 1; });
    if (things) link.references.resize(1);
  }
  complete_contents();
  place_hosts();
  place_before_walls();
  let_into_tops();
  for (const Link& link : document_.links) {
    if (is_set(document_.stop)) return;
    if (link.kind == Link::Kind::kRelation) add_relations(link);
  }
  add_rows();
  add_stacks();
  add_clusters();
  complete_sides();
  for (const Link& link : document_.links) {
    if (is_set(document_.stop)) return;
    if (link.kind == Link::Kind::kHave) add_contents(link);
  }
  for (const Link& link : document_.links) {
    if (is_set(document_.stop)) return;
    if (link.kind == Link::Kind::kHang) add_hanging(link);
  }
  add_mounts_said();
  set_heights();
  set_coordinates();
  settle_kitchen();
  settle_seat_heights();
  stand_at_both_sides();
  part_groups();
  part_halves();
  share_like_sides();
  part_from_neighbours();
  leave_small_vessels();
  stand_carriers_at_walls();
  keep_zones();
  carry_support();
  seat_on_platforms();
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) settle_mount(i);
  settle_stands();
  fill_whole_walls();
  lengthen_counters();
  leave_middle_to_rows();
  make_room_between();
  place_on_tops();
  stand_in_corners();
  sit_off_the_fire();
  leave_corners_to_servers();
  add_habits();
  note_contradictions();
  drop_implied_support();
  leave_window_to_sink();
  stand_across_openings();
  divide_groups();
  stand_out_from_walls();
  make_islands();
}

// "a green wall behind the bed": the bed is at it.
void RelationBuilder::place_before_walls() {
  for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
    const int wall = static_cast<int>(m), thing = thing_before_wall(document_, wall);
    if (thing < 0 || mention(wall).noun.attributes.empty()) continue;  // "the fridge against the wall behind the bar": not the bar
    Link link;
    link.first = mention(wall).noun.first;
    link.last = mention(thing).noun.last;
    for (const int item : mention(thing).items) add(link, R::kAgainstWall, {id(item)}, {single_wall(document_, wall, scene_.room)});
  }
}

// "80 cm between the sofa and the table", "a metre between the bed and the wall"
void RelationBuilder::add_gap(const Link& link) {
  std::vector<std::string> ends = ids(items_of(link.references));
  for (const auto& [place, side] : {std::pair{R::kInFrontOf, Side::kFront}, std::pair{R::kBehind, Side::kBack}}) {
    if (!says(link.senses, place)) continue;
    for (const std::string& kept : ends) {
      PhraseSense free{R::kClearance, Direction::kDirect, {}, {}, {}};
      free.side = side;
      add(link, R::kClearance, {kept}, {}, free);
      scene_.relations.back().parameters.depth = mm_from_m(*link.distance);
    }
  }
  if (!says(link.senses, R::kBetween) && !says(link.senses, R::kDistance)) return;
  for (const int m : link.references) {
    const NounKind kind = mention(m).noun.kind;
    const bool of_room = mention(m).items.empty() && (kind == NounKind::kWall || kind == NounKind::kDoor || kind == NounKind::kWindow);
    if (of_room && ends.size() == 1) ends.push_back(room_reference(mention(m).noun, R::kDistance).front());
  }
  if (ends.size() == 2) add(link, R::kDistance, {ends[0]}, {ends[1]});
  // "80 cm between the desks and the wardrobe": of each of them.
  if (ends.size() < 3 || link.references.size() != 2 || mention(link.references.back()).items.empty()) return;
  for (const int one : mention(link.references.front()).items) {
    for (const int other : mention(link.references.back()).items) add(link, R::kDistance, {id(one)}, {id(other)});
  }
}

// "ten tables, each with a board and a clock, in two rows of five": what each has one of, and no more; else the things themselves.
std::vector<int> RelationBuilder::bearers_of(std::vector<int> things) const {
  constexpr int kDeepest = 3;
  // "tables with four chairs each, placed in two rows": the tables are
  const auto seats_them = [&](const Link& link) {
    if (link.kind != Link::Kind::kHave || !std::ranges::any_of(link.targets, [&](int m) { return mention(m).items == things; }))
      return false;
    const std::vector<int> hosts = items_of(link.references);
    return hosts.size() > 1 && std::ranges::all_of(hosts, [&](int host) { return is_table(catalog_, noun_of_item(host)); });
  };
  if (is_seat(catalog_, noun_of_item(things.front()))) {
    const auto seated = std::ranges::find_if(document_.links, seats_them);
    return seated == document_.links.end() ? things : items_of(seated->references);
  }
  for (int depth = 0; depth < kDeepest && mount_of(noun_of_item(things.front())) == Mount::kSurface; ++depth) {
    const auto has_them = [&](const Link& link) {
      return link.kind == Link::Kind::kHave && items_of(link.references).size() == things.size() &&
             std::ranges::any_of(link.targets, [&](int m) { return mention(m).items == things; });
    };
    const auto held = std::ranges::find_if(document_.links, has_them);
    if (held == document_.links.end()) break;
    things = items_of(held->references);
  }
  return things;
}

// "in a row", "on the ceiling": by nothing that is named.
void RelationBuilder::add_alone(const Link& link, const std::vector<int>& targets) {
  const auto stands_alone = [](const PhraseSense& sense) {
    const RelationArity arity = relation_row(sense.type).arity;
    return arity == RelationArity::kNone ||
           (arity == RelationArity::kOptional && (sense.type == R::kOnCeiling || sense.type == R::kAgainstWall));
  };
  const auto sense = std::ranges::find_if(link.senses, stands_alone);
  if (sense == link.senses.end()) return;
  if (traits_of(sense->type).of_group) return add_group(link, *sense, sense->type == R::kGrid ? bearers_of(targets) : targets, {}, nullptr);
  for (const int target : targets) add(link, sense->type, {id(target)}, {}, *sense);
}

void RelationBuilder::add_relations(const Link& link) {
  if (link.gap && link.distance) return add_gap(link);
  std::vector<int> targets = items_of(link.targets);
  if (link.references.empty() || mention(link.references.front()).reciprocal) keep_standing(targets);
  add_by_openings(link);
  if (targets.empty()) return;
  if (link.references.empty()) return add_alone(link, targets);
  const Mention& first = mention(link.references.front());
  const bool several = link.references.size() > 1 || first.items.size() > 1 || first.noun.is_plural();
  const bool between = says(link.senses, R::kBetween);
  if (between && (several || parted_by(link).size() > 1)) return add_between(link, targets);
  if (add_at_walls(link, targets)) return;
  for (const int reference : link.references) {
    if (mention(reference).reciprocal)
      add_each_other(link, targets);
    else
      add_relations_to(link, targets, mention(reference));
  }
}

// "desks and monitors, back to back": of a list the things that stand on the floor, where there are any.
void RelationBuilder::keep_standing(std::vector<int>& items) const {
  const auto stands = [&](int item) { return mount_of(noun_of_item(item)) == Mount::kFloor; };
  if (std::ranges::count_if(items, stands) > 1)
    std::erase_if(items, [&](int item) { return mount_of(noun_of_item(item)) == Mount::kSurface; });
}

// "two beds along the left and right walls": one at each.
bool RelationBuilder::add_at_walls(const Link& link, const std::vector<int>& targets) {
  const std::size_t walls = link.references.size();
  const bool all = std::all_of(link.references.begin(), link.references.end(), [&](int r) {
    return mention(r).items.empty() &&
           (mention(r).noun.kind == NounKind::kWall || (mention(r).noun.kind == NounKind::kPart && !mention(r).noun.wall_word.empty()));
  });
  if (walls < 2 || !all || targets.size() < 2 || mention(link.references.back()).noun.kind != NounKind::kWall) return false;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    NounPhrase wall = mention(link.references[t * walls / targets.size()]).noun;
    wall.kind = NounKind::kWall;
    const auto sense = choose_sense(catalog_, link.senses, Direction::kDirect, noun_of_item(targets[t]), wall);
    if (sense) add(link, sense->type, {id(targets[t])}, room_reference(wall, sense->type), *sense);
  }
  return true;
}

// "1.2 m above the floor" is how high it hangs; what else is no place is noted.
void RelationBuilder::take_height_or_note(const Link& link, const Mention& target, const NounPhrase& reference) {
  if (reference.kind == NounKind::kFloor && link.distance) {
    for (const int item : target.items) heights_.emplace_back(id(item), mm_from_m(*link.distance));
  } else if (reference.kind == NounKind::kCorner &&
             one_of(document_.tokens[link.first].text, {"with", "has"})) {  // "a reading corner with a rug": a zone
  } else if (reference.kind != NounKind::kRoom && reference.kind != NounKind::kAbstract && reference.kind != NounKind::kCeiling) {
    note_no_place(link, target);
  }
}

// "a desk and bookshelf in the corner": in the same one, if that can be.
void RelationBuilder::share_corner(const Link& link, const Mention& target) {
  const Mention& first = mention(link.targets.front());
  if (first.items.size() != 1) return;
  Link together = link;
  together.soft = together.concluded = true;
  add(together, R::kNear, {id(target.items.front())}, {id(first.items.front())});
}

// "a corner with a small table and two chairs": they are that table's.
bool RelationBuilder::sit_in_corner(const Link& link, const Mention& target) {
  const Mention& first = mention(link.targets.front());
  const bool seats = is_seat(catalog_, target.noun) && target.noun.entry != nullptr && target.noun.entry->is(Trait::kTableSeat);
  const bool table = first.items.size() == 1 && is_table(catalog_, first.noun) && first.noun.entry != nullptr &&
                     !first.noun.entry->is(Trait::kOccasional) && !first.noun.entry->is(Trait::kDeskLike);
  if (!seats || !table) return false;
  Link together = link;
  together.concluded = true;
  std::vector<std::string> all;
  for (const int item : target.items) all.push_back(id(item));
  add(together, R::kAround, all, {id(first.items.front())});
  return true;
}

void RelationBuilder::add_relations_to(const Link& link, const std::vector<int>& targets, const Mention& reference_mention) {
  const Mention* place = reference_mention.items.empty() ? &reference_mention : nullptr;
  const std::vector<int>& reference_items = reference_mention.items;
  const NounPhrase& reference = reference_mention.noun;
  // Targets of different kinds may read the phrase differently ("a rug and a lamp in the corner").
  for (const int m : link.targets) {
    const Mention& target = mention(m);
    if (target.items.empty()) continue;
    if (place != nullptr && reference.kind == NounKind::kPronoun) {  // "it", and nobody knows who
      note_no_place(link, target);
      continue;
    }
    auto sense = choose_sense(catalog_, link.senses, Direction::kDirect, target.noun, reference);
    if (sense && sense->type == R::kOn && is_told_to_hang(link)) sense->type = R::kAbove;
    if (sense && place == nullptr) name_shelf(*sense, reference, noun_of_item(reference_items.front()));
    if (reference.kind == NounKind::kFloor && !link.distance && says(link.senses, R::kOn)) on_floor_.insert(m);
    if (!sense) {
      take_height_or_note(link, target, reference);
      continue;
    }
    if (sense->type == R::kCorner && m != link.targets.front() && !reference.is_plural() && sit_in_corner(link, target)) continue;
    if (sense->type == R::kInRegion && reference.kind == NounKind::kPart && !sense->region) {
      add_in_leg(link, target, reference);
      continue;
    }
    if (traits_of(sense->type).of_group) {
      if (m == link.targets.front()) add_group(link, *sense, targets, reference_items, place);
    } else {
      add_single(link, *sense, target, reference_items, place);
    }
    if (sense->type == R::kCorner && m != link.targets.front() && !reference.is_plural()) share_corner(link, target);
    if (link.distance && sense->type != R::kDistance && !reference_items.empty()) {
      for (const int item : target.items) add(link, R::kDistance, {id(item)}, {id(reference_items.front())});
    }
  }
}

// "on its top shelf": in what has the shelf, on that one.
void RelationBuilder::name_shelf(PhraseSense& sense, const NounPhrase& said, const NounPhrase& host) const {
  const auto says = [&](auto&& words) {
    for (std::size_t i = said.first; i < said.last; ++i) {
      if (words(document_.tokens[i].text)) return true;
    }
    return false;
  };
  const bool level = one_of(said.head, WordSet::kShelfLevels) ||
                     says([](const std::string& word) { return one_of(singular_of(word), WordSet::kShelfLevels); });
  if (sense.type != R::kOn || !level || host.head == "shelf" || host.head == said.head || host.entry == nullptr) return;
  std::vector<std::string> shelves;
  bool inside = false;
  for (const SpaceFormula& space : host.entry->spaces) {
    inside |= space.carries;
    if (space.carries && space.name.starts_with("shelf ")) shelves.push_back(space.name);
  }
  if (!inside) return;
  sense.type = R::kIn;
  const auto which = [&](std::initializer_list<std::string_view> names) {
    return says([&](const std::string& word) { return one_of(word, names); });
  };
  if (shelves.size() < 2) return;
  if (which({"top", "upper", "highest", "topmost", "uppermost"})) sense.part = ThingPart(shelves.back());
  if (which({"bottom", "lower", "lowest"})) sense.part = ThingPart(shelves.front());
  if (which({"middle", "central"})) sense.part = ThingPart(shelves[shelves.size() / 2]);
}

void RelationBuilder::note_no_place(const Link& link, const Mention& target) {
  scene_.notes.push_back(
      {"not-understood",
       "\"" + words_between(document_, link.first, link.last) + "\" says nothing of where \"" + target.noun.name + "\" is",
       place_of(link)});
}

std::string RelationBuilder::place_of(const Link& link) const {
  if (link.first >= link.last) return "prompt";
  return "prompt:" + std::to_string(document_.tokens[link.first].begin) + "-" + std::to_string(document_.tokens[link.last - 1].end);
}

// How high things hang that hang on a wall; those of which nothing else is said hang there.
void RelationBuilder::set_heights() {
  for (std::size_t i = 0; i < document_.items.size() && i < scene_.objects.size(); ++i) {
    const NounPhrase& noun = document_.items[i].noun;
    if (noun.hangs_at) heights_.emplace_back(scene_.objects[i].id, mm_from_m(*noun.hangs_at));
  }
  for (const auto& [object, height] : heights_) {
    const auto hangs = [&](std::size_t r) {
      return scene_.relations[r].type == R::kOnWall && scene_.relations[r].targets.front() == object;
    };
    if (relations_of(object).empty()) {
      Link link;
      const NounPhrase& noun = noun_of_object(*object_of(object));
      link.first = noun.first;
      link.last = noun.last;
      add(link, R::kOnWall, {object}, {});
    }
    for (const std::size_t r : relations_of(object)) {
      if (hangs(r)) scene_.relations[r].parameters.height = height;
    }
  }
}

// "a lamp at (2, 1)": its middle is so far from the left and from the front wall.
void RelationBuilder::set_coordinates() {
  for (std::size_t i = 0; i < document_.items.size() && i < scene_.objects.size(); ++i) {
    const NounPhrase& noun = document_.items[i].noun;
    for (const auto& [off, wall] : {std::pair{noun.place.x, "left"}, {noun.place.y, "front"}}) {
      if (!off) continue;
      Link link;
      link.first = noun.first, link.last = noun.last;
      add(link, R::kOffset, {scene_.objects[i].id}, {wall});
      scene_.relations.back().parameters.distance = *off;
      scene_.relations.back().parameters.edge = Edge::kCenter;
    }
  }
}

void build_relations(const Lexicon& lexicon, Document& document, SceneGraph& scene) { RelationBuilder(lexicon, document, scene).run(); }

}  // namespace layoutbox::offline
