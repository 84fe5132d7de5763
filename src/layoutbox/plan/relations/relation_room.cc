// Parts of the room as references: its walls, the freer of two, and its openings.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using R = RelationType;

// Of two walls across from each other the one that fewer things were put at.
std::string RelationBuilder::freer_of(const std::string& one, const std::string& other) const {
  const auto said_of = [&](const std::string& wall) {
    return std::count_if(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      return std::find(r.references.begin(), r.references.end(), wall) != r.references.end();
    });
  };
  return said_of(one) < said_of(other) ? one : other;
}

// "a screen at one end, a board on the side wall": the ends of a wide room are on the left and the right, its sides are the others.
bool RelationBuilder::speaks_of_ends() const {
  const bool ends = std::ranges::any_of(document_.tokens, [](const Token& t) { return t.text == "end" || t.text == "short"; });
  const bool shows = std::ranges::any_of(
      document_.items, [](const TextItem& item) { return item.noun.entry != nullptr && item.noun.entry->is(Trait::kScreen); });
  if (!ends || !shows || scene_.room.polygon.empty()) return ends && shows;
  Mm width = 0, depth = 0;
  for (const Point& corner : scene_.room.polygon) width = std::max(width, corner.x), depth = std::max(depth, corner.y);
  return width >= depth;
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
      if (all.empty() && noun.name.ends_with("side wall")) {
        const bool across = speaks_of_ends();
        all = {wall_of_.try_emplace(noun.first, across ? freer_of("back", "front") : freer_of("left", "right")).first->second};
      }
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
  const auto is_meant = [&](const Opening& o) { return look.empty() ? !leads_elsewhere(o, scene_.room) : o.attributes == look; };
  // "the boss door": the one that was brought in by that name.
  const std::string name = bare_name(noun);
  if (wanted == 1 && name.find(' ') != std::string::npos) {
    for (const Opening& opening : scene_.room.openings) {
      if (name_of(opening.type) == type && opening.called == name) return {opening.id};
    }
  }
  for (const bool meant : {true, false}) {
    if (!ids.empty()) break;
    for (const Opening& opening : scene_.room.openings) {
      if (name_of(opening.type) == type && ids.size() < wanted && (!meant || is_meant(opening))) ids.push_back(opening.id);
    }
  }
  if (ids.empty()) ids.push_back(std::string(type));
  return ids;
}

// "A counter at the back left": who serves over it stands behind it, so it is not pushed into the corner.
void RelationBuilder::leave_corners_to_servers() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    Relation& relation = scene_.relations[r];
    if (relation.type != R::kCorner || relation.targets.size() != 1 || relation.references.size() != 2) continue;
    const SceneObject* object = object_of(relation.targets.front());
    const CatalogEntry* entry = object == nullptr ? nullptr : catalog_.find(object->category);
    const bool served =
        entry != nullptr && entry->is(Trait::kOpenToRoom) && std::ranges::find(entry->used_sides, Side::kBack) != entry->used_sides.end();
    if (!served || entry->used_sides.size() > 2) continue;
    const auto at = [&](std::string_view wall) { return std::ranges::find(relation.references, wall) != relation.references.end(); };
    if (at("back") == at("front") || at("left") == at("right")) continue;
    constexpr Mm kToServe = 1300, kToPass = 900;
    const std::vector<std::string> targets = relation.targets;
    const std::string behind = at("back") ? "back" : "front", beside = at("left") ? "left" : "right";
    relation.type = R::kInRegion;
    relation.parameters = {};
    relation.parameters.region = at("back") ? (at("left") ? RoomRegion::kBackLeft : RoomRegion::kBackRight)
                                            : (at("left") ? RoomRegion::kFrontLeft : RoomRegion::kFrontRight);
    relation.references.clear();
    add_habit(R::kAgainstWall, targets, {behind}, kTogether, "who serves has room behind").parameters.gap = kToServe;
    add_habit(R::kSideAgainstWall, targets, {beside}, kTogether, "who serves passes at the side").parameters.gap = kToPass;
  }
}

// "Two armchairs by the fire": before it, as near as one sits to a fire, and not at its side.
void RelationBuilder::sit_off_the_fire() {
  const auto is = [&](const std::string& id, Trait trait) {
    const SceneObject* object = object_of(id);
    const CatalogEntry* entry = object == nullptr ? nullptr : catalog_.find(object->category);
    return entry != nullptr && entry->is(trait);
  };
  for (Relation& relation : scene_.relations) {
    if (relation.type != R::kNextTo || relation.references.size() != 1 || !is(relation.references[0], Trait::kFire)) continue;
    const bool seats = std::ranges::all_of(relation.targets,
                                           [&](const std::string& id) { return is(id, Trait::kEasySeat) && !is(id, Trait::kCenterPiece); });
    const auto pair = std::ranges::count_if(scene_.relations, [&](const Relation& other) {
      return other.references == relation.references && other.why == relation.why && other.targets.size() == 1;
    });
    if (seats && pair > 1 && !relation.parameters.max && (words_.have(relation, "by") || words_.have(relation, "at")))
      relation.type = R::kNear;
  }
}

// "flush left on the back wall", "against the back and the left wall": its back at the one, a side at the other.
void RelationBuilder::stand_in_corners() {
  const auto is_at = [](const Relation& r, std::string_view one, std::string_view other) {
    return r.type == R::kAgainstWall && r.origin == Origin::kAsked && r.targets.size() == 1 && r.references.size() == 1 &&
           (r.references.front() == one || r.references.front() == other);
  };
  for (Relation& side : scene_.relations) {
    if (!is_at(side, "left", "right")) continue;
    const bool backed =
        std::ranges::any_of(relations_of(side.targets.front()), [&](std::size_t r) { return is_at(scene_.relations[r], "back", "front"); });
    if (backed) side.type = R::kSideAgainstWall;
  }
}

namespace {

// The parts of an L, the greater and the lesser: as far from the corner that is cut out as the room is long, and the rest of it. Where the
// room has no outline yet, that corner is the back right one, as room_outline has it.
std::pair<RoomRegion, RoomRegion> legs_of(const std::vector<Point>& polygon) {
  Mm width = 0, depth = 0;
  for (const Point& point : polygon) width = std::max(width, point.x), depth = std::max(depth, point.y);
  bool right = true, back = true;
  for (const Point& corner : {Point{0, 0}, Point{width, 0}, Point{width, depth}, Point{0, depth}}) {
    if (std::ranges::find(polygon, corner) == polygon.end())
      right = corner.x > 0 || polygon.empty(), back = corner.y > 0 || polygon.empty();
  }
  if (depth > width) return right ? std::pair{RoomRegion::kLeft, RoomRegion::kRight} : std::pair{RoomRegion::kRight, RoomRegion::kLeft};
  return back ? std::pair{RoomRegion::kFront, RoomRegion::kBack} : std::pair{RoomRegion::kBack, RoomRegion::kFront};
}

}  // namespace

// "in the long part"
void RelationBuilder::add_in_leg(const Link& link, const Mention& target, const NounPhrase& place) {
  constexpr std::size_t kCornersOfL = 6;
  const std::vector<Point>& polygon = scene_.room.polygon;
  if (polygon.empty() ? scene_.room.shape != "L" : polygon.size() != kCornersOfL) return note_no_place(link, target);
  const auto [greater, lesser] = legs_of(polygon);
  const bool small = std::ranges::any_of(place.attributes, [](const std::string& word) { return one_of(word, WordSet::kShortLegs); });
  PhraseSense sense{R::kInRegion, Direction::kDirect, {}, {}, {}};
  sense.region = small ? lesser : greater;
  for (const int item : target.items) {
    if (mount_of(noun_of_item(item)) == Mount::kFloor) add(link, R::kInRegion, {id(item)}, {}, sense);
  }
}

}  // namespace layoutbox::offline
