#include "layoutbox/plan/relations/relation_writer.h"

#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// The same was said before: only what it adds to that is kept.
bool RelationWriter::repeats_known(const Link& link, R type, const std::vector<std::string>& targets,
                                   const std::vector<std::string>& references, const PhraseSense& sense) {
  std::string key(relation_row(type).name);
  for (const std::string& target : targets) key += " " + target;
  key += ">";
  for (const std::string& reference : references) key += " " + reference;
  if (sense.side && type == R::kClearance) key += " at " + std::string(name_of(*sense.side));
  if (const auto [known, fresh] = known_.try_emplace(key, scene_.relations.size()); !fresh) {
    RelationParameters& said = scene_.relations[known->second].parameters;
    if (type == R::kRow && link.distance) said.gap = mm_from_m(*link.distance);
    if (said.part.empty()) said.part = sense.part;  // "on the desk a lamp at the left side"
    return true;
  }
  return false;
}

// "a shower with a seat", "a seat in it"
bool RelationWriter::is_said_within(const Link& link, R type, const std::vector<std::string>& targets,
                                    const std::vector<std::string>& references) const {
  const bool within = type == R::kIn || (type == R::kAbove && link.kind == Link::Kind::kHave);
  if (!within || references.size() != 1) return false;
  const SceneObject *thing = scene_.find_object(targets.front()), *host = scene_.find_object(references.front());
  return thing != nullptr && host != nullptr && is_used_within(*thing, *host);
}

bool RelationWriter::are_pillars(const std::vector<std::string>& objects) const {
  constexpr std::size_t kFewest = 4;
  return objects.size() >= kFewest && std::ranges::all_of(objects, [&](const std::string& one) {
           const SceneObject* object = scene_.find_object(one);
           return object != nullptr && catalog_.entry_or_nearest(object->category).is(Trait::kBearsCeiling);
         });
}

void RelationWriter::add_two_rows(const Link& link, std::vector<std::string> targets) {
  Link rows = link;
  rows.columns = 2;
  add(rows, R::kGrid, std::move(targets), {});
}

void RelationWriter::add_at_end(const Link& link, R type, const std::vector<std::string>& targets,
                                const std::vector<std::string>& references, PhraseSense sense) {
  const Edge edge = sense.part.has(PartWord::kLeft) ? Edge::kLeft : Edge::kRight;
  sense.part = {};
  add(link, type, targets, references, sense);
  Link end = link;
  end.concluded = true;
  const std::size_t known = scene_.relations.size();
  add(end, R::kEdgeAlign, targets, references);
  if (scene_.relations.size() > known) scene_.relations.back().parameters.edge = edge;
}

void RelationWriter::keep_two_that_stand(std::vector<std::string>& objects) const {
  const auto lies = [&](const std::string& one) {
    const SceneObject* object = object_of(one);
    return object != nullptr && mount_of(noun_of_object(*object)) == Mount::kSurface;
  };
  if (objects.size() - static_cast<std::size_t>(std::ranges::count_if(objects, lies)) > 1) std::erase_if(objects, lies);
}

void RelationWriter::say_lengths(const Link& link, Relation& relation) const {
  // "along a wall" is looser than "against" it.
  const std::string& first_word = document_.tokens[link.first].text;
  if (relation.type == R::kAgainstWall && (first_word == "along" || first_word.starts_with("lin"))) relation.parameters.gap = 300;
  if (link.distance && relation.type == R::kRow) relation.parameters.gap = mm_from_m(*link.distance);
  if (relation.type == R::kGrid && link.columns + link.rows > 0) {
    const int count = static_cast<int>(relation.targets.size());
    relation.parameters.columns = link.columns > 0 ? link.columns : (count + link.rows - 1) / link.rows;
  }
  if (link.distance && relation.type == R::kAwayFromWall) relation.parameters.min = mm_from_m(*link.distance);
  if (link.distance && relation.type == R::kDistance) {
    const Mm distance = mm_from_m(*link.distance);
    if (!link.at_most) relation.parameters.min = distance;
    if (!link.at_least) relation.parameters.max = distance;
  }
}

void RelationWriter::add(const Link& link, R type, std::vector<std::string> targets, std::vector<std::string> references,
                         const PhraseSense& sense) {
  if (targets.empty()) return;
  // Nothing stands by itself.
  std::erase_if(references, [&](const std::string& r) { return std::find(targets.begin(), targets.end(), r) != targets.end(); });
  if (references.empty() && relation_row(type).arity != RelationArity::kNone && relation_row(type).arity != RelationArity::kOptional)
    return;
  if (type == R::kBetween && references.size() > 2) keep_two_that_stand(references);
  if (type == R::kBetween && references.size() < 2) type = R::kNextTo;  // "a sectional parted by a table": nobody says from what
  // "in Japanese style with a futon": that a thing is in the room says nothing.
  if (traits_of(type).rests && references.size() == 1 && references.front() == "room") return;
  if (is_said_within(link, type, targets, references)) type = R::kInside;
  if ((type == R::kBehind || type == R::kInFrontOf) && !sense.part.empty()) return add_at_end(link, type, targets, references, sense);
  // "four pillars along each side" of whatever are two rows through the room.
  if (type == R::kEachSideOf && are_pillars(targets)) return add_two_rows(link, std::move(targets));
  if (repeats_known(link, type, targets, references, sense)) return;
  Relation& relation = write(type, std::move(targets), std::move(references));
  relation.parameters.part = sense.part;
  relation.parameters.region = sense.region;
  relation.parameters.side = sense.side;
  relation.hard = !link.soft;
  relation.origin = link.assumed ? Origin::kAssumed : link.concluded ? Origin::kConcluded : Origin::kAsked;
  relation.why = words_between(document_, link.first, link.last);
  words_.keep(relation.id, link);
  say_lengths(link, relation);
  for (std::size_t i = link.first; i < link.last; ++i) {
    if (document_.readings[i].role == "relation" || document_.readings[i].role == "has")
      document_.readings[i].role = "relation " + relation.id;
  }
}

Relation& RelationWriter::write(R type, std::vector<std::string> targets, std::vector<std::string> references) {
  for (const std::string& target : targets) of_target_[target].push_back(scene_.relations.size());
  Relation& relation = scene_.relations.emplace_back();
  relation.id = "c" + std::to_string(scene_.relations.size());
  relation.type = type;
  relation.targets = std::move(targets);
  relation.references = std::move(references);
  return relation;
}

const std::vector<std::size_t>& RelationWriter::relations_of(const std::string& object) const {
  static const std::vector<std::size_t> none;
  const auto found = of_target_.find(object);
  return found == of_target_.end() ? none : found->second;
}

const SceneObject* RelationWriter::object_of(const std::string& object) const {
  const auto found = objects_.find(object);
  return found == objects_.end() ? nullptr : &scene_.objects[found->second];
}

std::vector<std::string> RelationWriter::ids(const std::vector<int>& items) const {
  std::vector<std::string> all;
  for (const int item : items) {
    if (std::find(all.begin(), all.end(), id(item)) == all.end()) all.push_back(id(item));
  }
  return all;
}

std::vector<int> RelationWriter::items_of(const std::vector<int>& mentions) const {
  std::vector<int> all;
  for (const int m : mentions) {
    for (const int item : mention(m).items) {
      if (std::find(all.begin(), all.end(), item) == all.end()) all.push_back(item);
    }
  }
  return all;
}

const NounPhrase& RelationWriter::noun_of_object(const SceneObject& object) const {
  return document_.items[static_cast<std::size_t>(&object - scene_.objects.data())].noun;
}

// Does it hang on a wall and is used there, in the room that the other leaves: a seat in a shower?
bool RelationWriter::is_used_within(const SceneObject& object, const SceneObject& other) const {
  const CatalogEntry *thing = catalog_.find(object.category), *host = catalog_.find(other.category);
  if (thing == nullptr || host == nullptr || thing->mount != Mount::kWall || thing->used_sides.empty()) return false;
  const Size& size = thing->size.usual;
  return std::ranges::any_of(spaces_at(*host, host->size.usual), [&](const Space& space) {
    return space.max[0] - space.min[0] >= size.width && space.max[1] - space.min[1] >= size.depth && space.min[2] <= thing->hang_height &&
           space.max[2] >= thing->hang_height + size.height;
  });
}

}  // namespace layoutbox::offline
