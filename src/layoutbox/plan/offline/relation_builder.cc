// Links between mentions become relations: who is placed by what, alone, in groups and at parts of the room.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/offline/relation_builder_parts.h"
#include "layoutbox/plan/offline/room_reader.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

namespace {

bool speaks_of_group(R type) {
  return type == R::kAround || type == R::kSurround || type == R::kEachSideOf || type == R::kRow || type == R::kGrid ||
         type == R::kColumn || type == R::kEvenlySpaced || type == R::kSymmetricAbout || type == R::kStacked || type == R::kCenterOfRoom ||
         type == R::kPairedWith || type == R::kGroupAlign;
}

}  // namespace

// "a table with four chairs in the middle": what is said there of the place of the chairs is said of the table that has them.
void RelationBuilder::place_hosts() {
  for (const Link& have : document_.links) {
    if (have.kind != Link::Kind::kHave || have.after_comma || have.references.size() != 1 || have.targets.empty()) continue;
    const Mention &host = mention(have.references.front()), &first = mention(have.targets.front());
    if (host.items.size() != 1 || first.items.empty()) continue;
    const NounPhrase &noun = noun_of_item(host.items.front()), &other = noun_of_item(first.items.front());
    const bool seats = is_table(catalog_, noun) && is_seat(catalog_, other);
    // "a table with four chairs in the middle, a mug and a bowl on it": the place follows the chairs.
    const int last = seats ? have.targets.front() : have.targets.back();
    const bool list = !seats && have.targets.size() > 1;
    const Mention& thing = mention(last);
    if (thing.items.empty() || !thing.introduces) continue;
    // "a cabinet with a TV opposite the sofa": the cabinet, with the TV on it.
    const bool carried = mount_of(noun) == Mount::kFloor && mount_of(other) == Mount::kSurface && may_carry(catalog_, noun, other);
    // "a dressing table with a mirror under the window"
    const bool hung = !list && mount_of(other) == Mount::kWall && mount_of(noun) == Mount::kFloor;
    // "a piano with its stool by the window"
    const bool own = !list && thing.noun.determiner == Determiner::kPossessive && mount_of(noun) == Mount::kFloor;
    if (list ? !carried : !seats && !flanks(other, noun) && !carried && !hung && !own) continue;
    const auto stands = [&](int r) {
      const Mention& by = mention(r);
      if (own && by.items != host.items) return true;
      if (hung && by.noun.kind != NounKind::kWindow) return false;
      return by.items.empty() || (carried && !list && by.items != host.items && mount_of(noun_of_item(by.items.front())) == Mount::kFloor);
    };
    const auto is_place = [&](const Link& link, int target) {
      const bool rests = carried && (says(link.senses, R::kOn) || says(link.senses, R::kIn) || says(link.senses, R::kCenterOfRoom));
      if (hung && !says(link.senses, R::kUnderWindow)) return false;
      return link.kind == Link::Kind::kRelation && link.targets == std::vector<int>{target} && !rests &&
             std::all_of(link.references.begin(), link.references.end(), stands);
    };
    const bool placed = std::any_of(document_.links.begin(), document_.links.end(),
                                    [&](const Link& link) { return is_place(link, have.references.front()); });
    for (Link& link : document_.links) {
      const bool follows = link.first >= thing.noun.last && link.first <= thing.noun.last + 1;
      if (!placed && follows && is_place(link, last)) link.targets = have.references;
    }
  }
}

// "a counter with the till, the grinder and a cake display along the back wall": all three are what the counter has.
void RelationBuilder::complete_counters() {
  for (Link& have : document_.links) {
    if (have.kind != Link::Kind::kHave || have.references.size() != 1 || have.targets.size() < 2) continue;
    const NounPhrase& host = mention(have.references.front()).noun;
    if (host.entry == nullptr || !host.entry->is(Trait::kCounter)) continue;
    const std::size_t end = mention(have.targets.back()).noun.last;
    const auto follows = [&](const Mention& m) {
      return m.introduces && !m.items.empty() && m.noun.first == end + 1 && says_one_of(document_, end, {"and"});
    };
    const auto next = std::ranges::find_if(document_.mentions, follows);
    if (next != document_.mentions.end()) have.targets.push_back(static_cast<int>(next - document_.mentions.begin()));
  }
}

// "an island with a sink", "a basin in the counter": what stands by itself elsewhere is let into a top.
void RelationBuilder::let_into_tops() {
  for (const Link& link : document_.links) {
    const bool place = link.kind == Link::Kind::kRelation && (says(link.senses, R::kOn) || says(link.senses, R::kIn));
    if ((!place && link.kind != Link::Kind::kHave) || link.references.empty() || mention(link.references.front()).items.empty()) continue;
    const NounPhrase& host = noun_of_item(mention(link.references.front()).items.front());
    if (host.entry == nullptr || mount_of(host) != Mount::kFloor) continue;
    for (const int m : link.targets) let_in(m, *host.entry);
  }
}

void RelationBuilder::let_in(int m, const CatalogEntry& host) {
  Mention& thing = document_.mentions[static_cast<std::size_t>(m)];
  const CatalogEntry* form = thing.noun.entry == nullptr ? nullptr : catalog_.find(set_in_entry(thing.noun.entry->id));
  if (form == nullptr || std::ranges::none_of(form->stands_on, [&](const std::string& id) { return catalog_.is_a(host.id, id); })) return;
  const auto become = [&](NounPhrase& noun) { noun.entry = form, noun.category = form->id; };
  become(thing.noun);
  for (const int item : thing.items) {
    become(document_.items[static_cast<std::size_t>(item)].noun);
    scene_.objects[static_cast<std::size_t>(item)].category = form->id;
  }
}

void RelationBuilder::run() {
  for (Link& link : document_.links) {
    // "a television on a low unit and a nest of tables": it stands on one of them, the other is by itself.
    const bool on = link.kind == Link::Kind::kRelation && says(link.senses, R::kOn) && !link.each && link.references.size() == 2;
    if (!on || link.targets.size() != 1 || mention(link.targets[0]).items.size() != 1 || mention(link.targets[0]).noun.is_plural())
      continue;
    const bool things = std::ranges::all_of(link.references, [&](int r) { return mention(r).introduces && mention(r).items.size() == 1; });
    if (things) link.references.resize(1);
  }
  complete_counters();
  place_hosts();
  place_before_walls();
  let_into_tops();
  for (const Link& link : document_.links) {
    if (is_set(document_.stop)) return;
    if (link.kind == Link::Kind::kRelation) add_relations(link);
  }
  add_rows();
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
  part_from_neighbours();
  leave_small_vessels();
  stand_carriers_at_walls();
  keep_zones();
  carry_support();
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) settle_mount(i);
  settle_stands();
  add_habits();
  note_contradictions();
  drop_implied_support();
  divide_groups();
  make_islands();
}

void RelationBuilder::add(const Link& link, R type, std::vector<std::string> targets, std::vector<std::string> references,
                          const PhraseSense& sense) {
  if (targets.empty()) return;
  // Nothing stands by itself.
  std::erase_if(references, [&](const std::string& r) { return std::find(targets.begin(), targets.end(), r) != targets.end(); });
  if (references.empty() && relation_row(type).arity != RelationArity::kNone && relation_row(type).arity != RelationArity::kOptional)
    return;
  if (type == R::kBetween && references.size() > 2) keep_two_that_stand(references);
  if (type == R::kBetween && references.size() < 2) type = R::kNextTo;  // "a sectional parted by a table": nobody says from what
  // "in Japanese style with a futon": that a thing is in the room says nothing.
  if ((type == R::kOn || type == R::kIn) && references.size() == 1 && references.front() == "room") return;
  std::string key(relation_row(type).name);
  for (const std::string& target : targets) key += " " + target;
  key += ">";
  for (const std::string& reference : references) key += " " + reference;
  if (const auto [known, fresh] = known_.try_emplace(key, scene_.relations.size()); !fresh) {
    if (type == R::kRow && link.distance) scene_.relations[known->second].parameters.gap = mm_from_m(*link.distance);
    return;
  }
  for (const std::string& target : targets) of_target_[target].push_back(scene_.relations.size());
  Relation relation;
  relation.id = "c" + std::to_string(scene_.relations.size() + 1);
  relation.type = type;
  relation.targets = std::move(targets);
  relation.references = std::move(references);
  relation.parameters.part = sense.part;
  relation.parameters.region = sense.region;
  relation.parameters.side = sense.side;
  relation.hard = !link.soft;
  relation.origin = link.assumed ? Origin::kAssumed : link.concluded ? Origin::kConcluded : Origin::kAsked;
  relation.why = words_between(document_, link.first, link.last);
  // "along a wall" is looser than "against" it.
  const std::string& first_word = document_.tokens[link.first].text;
  if (type == R::kAgainstWall && (first_word == "along" || first_word.starts_with("lin"))) relation.parameters.gap = 300;
  if (link.distance && type == R::kRow) relation.parameters.gap = mm_from_m(*link.distance);
  if (type == R::kGrid && link.columns + link.rows > 0) {
    const int count = static_cast<int>(relation.targets.size());
    relation.parameters.columns = link.columns > 0 ? link.columns : (count + link.rows - 1) / link.rows;
  }
  if (link.distance && type == R::kDistance) {
    const Mm distance = mm_from_m(*link.distance);
    if (!link.at_most) relation.parameters.min = distance;
    if (!link.at_least) relation.parameters.max = distance;
  }
  for (std::size_t i = link.first; i < link.last; ++i) {
    if (document_.readings[i].role == "relation" || document_.readings[i].role == "has")
      document_.readings[i].role = "relation " + relation.id;
  }
  scene_.relations.push_back(std::move(relation));
}

const std::vector<std::size_t>& RelationBuilder::relations_of(const std::string& object) const {
  static const std::vector<std::size_t> none;
  const auto found = of_target_.find(object);
  return found == of_target_.end() ? none : found->second;
}

const SceneObject* RelationBuilder::object_of(const std::string& object) const {
  const auto found = objects_.find(object);
  return found == objects_.end() ? nullptr : &scene_.objects[found->second];
}

std::vector<std::string> RelationBuilder::ids(const std::vector<int>& items) const {
  std::vector<std::string> all;
  for (const int item : items) {
    if (std::find(all.begin(), all.end(), id(item)) == all.end()) all.push_back(id(item));
  }
  return all;
}

std::vector<int> RelationBuilder::items_of(const std::vector<int>& mentions) const {
  std::vector<int> all;
  for (const int m : mentions) {
    for (const int item : mention(m).items) {
      if (std::find(all.begin(), all.end(), item) == all.end()) all.push_back(item);
    }
  }
  return all;
}

// Of two walls across from each other the one that fewer things were put at.
std::string RelationBuilder::freer_of(const std::string& one, const std::string& other) const {
  const auto said_of = [&](const std::string& wall) {
    return std::count_if(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      return std::find(r.references.begin(), r.references.end(), wall) != r.references.end();
    });
  };
  return said_of(one) < said_of(other) ? one : other;
}

std::vector<std::string> RelationBuilder::room_reference(const NounPhrase& noun, R type) const {
  const auto words = [&] {
    std::vector<std::string> all;
    std::string rest = noun.wall_word;
    while (!rest.empty()) {
      const std::size_t space = rest.find(' ');
      all.push_back(rest.substr(0, space));
      rest = space == std::string::npos ? "" : rest.substr(space + 1);
    }
    return all;
  };
  switch (noun.kind) {
    case NounKind::kWall: {
      auto all = words();
      if (all.size() > 1) all.resize(1);
      if (all.empty() && noun.name.ends_with("side wall")) all = {freer_of("left", "right")};
      if (const auto [one, other] = walls_by_length(noun, scene_.room); all.empty() && !one.empty() && noun.wall_relation != "opposite")
        all = {wall_of_.try_emplace(noun.first, freer_of(other, one)).first->second};  // all that is said to be at it
      if (all.empty() && noun.wall_relation.empty() && relation_row(type).arity != RelationArity::kOptional) all = {"back"};
      return all;
    }
    case NounKind::kCorner: {
      auto all = words();
      // "the far corner" is the viewer's word for a back corner, which one is free.
      return all;
    }
    case NounKind::kDoor:
    case NounKind::kWindow:
      if (type != R::kNotBlocking && relation_row(type).arity == RelationArity::kOptional) return {};
      return {opening_ids(noun).front()};
    case NounKind::kFloor: return {"floor"};
    default:
      return relation_row(type).arity == RelationArity::kNone || relation_row(type).arity == RelationArity::kOptional
                 ? std::vector<std::string>{}
                 : std::vector<std::string>{"room"};
  }
}

std::vector<std::string> RelationBuilder::opening_ids(const NounPhrase& noun) const {
  const std::string_view type = noun.kind == NounKind::kDoor ? "door" : "window";
  std::vector<std::string> ids;
  const std::size_t wanted = noun.count > 0 ? static_cast<std::size_t>(noun.count) : noun.plural ? 2 : 1;
  const std::vector<std::string> look =
      opening_said(noun.kind == NounKind::kDoor ? OpeningType::kDoor : OpeningType::kWindow, noun).attributes;
  // "by the balcony door" is by that one; "by the door" by the entrance.
  const auto is_meant = [&](const Opening& o) { return look.empty() ? !leads_outside(o) : o.attributes == look; };
  for (const bool meant : {true, false}) {
    if (!ids.empty()) break;
    for (const Opening& opening : scene_.room.openings) {
      if (name_of(opening.type) == type && ids.size() < wanted && (!meant || is_meant(opening))) ids.push_back(opening.id);
    }
  }
  if (ids.empty()) ids.push_back(std::string(type));
  return ids;
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

void RelationBuilder::add_relations(const Link& link) {
  if (link.gap && link.distance) {  // "80 cm between the sofa and the table"
    std::vector<std::string> ends = ids(items_of(link.references));
    for (const int m : link.references) {  // "a metre between the bed and the wall"
      const bool of_room =
          mention(m).items.empty() &&
          (mention(m).noun.kind == NounKind::kWall || mention(m).noun.kind == NounKind::kDoor || mention(m).noun.kind == NounKind::kWindow);
      if (of_room && ends.size() == 1) ends.push_back(room_reference(mention(m).noun, R::kDistance).front());
    }
    if (ends.size() == 2) add(link, R::kDistance, {ends[0]}, {ends[1]});
    return;
  }
  std::vector<int> targets = items_of(link.targets);
  if (link.references.empty() || mention(link.references.front()).reciprocal) keep_standing(targets);
  // "a window over the sink": the sink is under it.
  const bool window = link.targets.size() == 1 && mention(link.targets.front()).noun.kind == NounKind::kWindow;
  const bool over = std::ranges::any_of(link.senses, [](const PhraseSense& sense) { return sense.type == R::kAbove; });
  if (window && over) {
    for (const int item : items_of(link.references)) add(link, R::kUnderWindow, {id(item)}, {});
  }
  if (targets.empty()) return;
  if (link.references.empty()) {
    for (const PhraseSense& sense : link.senses) {
      const RelationArity arity = relation_row(sense.type).arity;
      if (arity == RelationArity::kNone ||
          (arity == RelationArity::kOptional && (sense.type == R::kOnCeiling || sense.type == R::kAgainstWall))) {
        if (speaks_of_group(sense.type))
          add_group(link, sense, targets, {}, nullptr);
        else
          for (const int target : targets) add(link, sense.type, {id(target)}, {}, sense);
        return;
      }
    }
    return;
  }
  if (std::any_of(link.senses.begin(), link.senses.end(), [](const PhraseSense& s) { return s.type == R::kBetween; }) &&
      (link.references.size() > 1 || mention(link.references.front()).items.size() > 1 ||
       mention(link.references.front()).noun.is_plural())) {
    add_between(link, targets);
    return;
  }
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

void RelationBuilder::keep_two_that_stand(std::vector<std::string>& objects) const {
  const auto lies = [&](const std::string& one) {
    const SceneObject* object = object_of(one);
    return object != nullptr && mount_of(noun_of_object(*object)) == Mount::kSurface;
  };
  if (objects.size() - static_cast<std::size_t>(std::ranges::count_if(objects, lies)) > 1) std::erase_if(objects, lies);
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
    if (sense && place == nullptr) name_shelf(*sense, reference, noun_of_item(reference_items.front()));
    if (!sense && reference.kind == NounKind::kFloor && link.distance) {  // "1.2 m above the floor"
      for (const int item : target.items) heights_.emplace_back(id(item), mm_from_m(*link.distance));
      continue;
    }
    if (!sense) {
      if (reference.kind != NounKind::kRoom && reference.kind != NounKind::kAbstract) note_no_place(link, target);
      continue;
    }
    if (speaks_of_group(sense->type)) {
      if (m == link.targets.front()) add_group(link, *sense, targets, reference_items, place);
    } else {
      add_single(link, *sense, target, reference_items, place);
    }
    // "a desk and bookshelf in the corner": in the same one, if that can be.
    if (sense->type == R::kCorner && m != link.targets.front() && !reference.is_plural() && target.items.size() == 1 &&
        mention(link.targets.front()).items.size() == 1) {
      Link together = link;
      together.soft = together.concluded = true;
      add(together, R::kNear, {id(target.items.front())}, {id(mention(link.targets.front()).items.front())});
    }
    if (link.distance && sense->type != R::kDistance && !reference_items.empty()) {
      for (const int item : target.items) add(link, R::kDistance, {id(item)}, {id(reference_items.front())});
    }
  }
}

// "on its top shelf": in what has the shelf, on that one.
void RelationBuilder::name_shelf(PhraseSense& sense, const NounPhrase& said, const NounPhrase& host) const {
  if (sense.type != R::kOn || !one_of(said.head, {"shelf", "tier", "level", "board", "plank", "rung", "deck"}) || host.head == "shelf" ||
      host.entry == nullptr)
    return;
  std::vector<std::string> shelves;
  bool inside = false;
  for (const SpaceFormula& space : host.entry->spaces) {
    inside |= space.carries;
    if (space.carries && space.name.starts_with("shelf ")) shelves.push_back(space.name);
  }
  if (!inside) return;
  sense.type = R::kIn;
  const auto which = [&](std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
      return said.name.starts_with(word) || std::find(said.attributes.begin(), said.attributes.end(), word) != said.attributes.end();
    });
  };
  if (shelves.size() < 2) return;
  if (which({"top", "upper", "highest"})) sense.part = shelves.back();
  if (which({"bottom", "lower", "lowest"})) sense.part = shelves.front();
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

// How high things hang that hang on a wall.
void RelationBuilder::set_heights() {
  for (const auto& [object, height] : heights_) {
    for (const std::size_t r : relations_of(object)) {
      Relation& relation = scene_.relations[r];
      if (relation.type == R::kOnWall && relation.targets.front() == object) relation.parameters.height = height;
    }
  }
}

void build_relations(const Lexicon& lexicon, Document& document, SceneGraph& scene) { RelationBuilder(lexicon, document, scene).run(); }

}  // namespace layoutbox::offline
