#include "layoutbox/scene/scene_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "layoutbox/base/words.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

class IdChecker {
 public:
  explicit IdChecker(std::vector<Error>& errors) : errors_(errors) {}

  void add(const std::string& id, std::string pointer) {
    const auto [place, inserted] = pointers_.emplace(id, pointer);
    if (!inserted) {
      errors_.push_back({ErrorCode::kReference,
                         fmt::format("the id \"{}\" is used twice: here and at {}", id, place->second),
                         std::move(pointer),
                         "give each object, wall and opening an id of its own",
                         {}});
    }
  }
  bool has(const std::string& id) const { return pointers_.contains(id); }

  std::string suggestion(const std::string& id) const {
    std::vector<std::string> known;
    for (const auto& [name, pointer] : pointers_) known.push_back(name);
    const std::string near = nearest_word(id, known);
    if (!near.empty()) return fmt::format("did you mean \"{}\"?", near);
    std::string list;
    constexpr std::size_t kMost = 12;
    for (std::size_t i = 0; i < std::min(kMost, known.size()); ++i) list += (i == 0 ? "" : ", ") + known[i];
    return known.empty() ? "" : "there are: " + list + (known.size() > kMost ? ", …" : "");
  }

 private:
  std::vector<Error>& errors_;
  std::map<std::string, std::string> pointers_;
};

// How a relation's names are looked up; the same for scenes and layouts.
struct Names {
  const IdChecker& ids;
  const std::vector<Wall>& walls;
  std::vector<std::string> object_ids;
};

bool is_object(const Names& names, const std::string& id) {
  return std::ranges::any_of(names.object_ids, [&](const std::string& other) { return other == id; });
}

bool is_wall(const Names& names, const std::string& word) {
  if (std::ranges::any_of(names.walls, [&](const Wall& wall) { return same_name(wall.id, word); })) return true;
  if (room_side_from_word(word)) return names.walls.empty() || wall_on_side(names.walls, *room_side_from_word(word)) != nullptr;
  // Without walls in the file they will be wall1 to wall4.
  const std::string key = key_of(word);
  return names.walls.empty() && key.size() >= 5 && key.starts_with("wall") && key.find_first_not_of("0123456789", 4) == std::string::npos;
}

bool is_opening(const std::vector<Opening>& openings, const std::string& id) {
  return std::ranges::any_of(openings, [&](const Opening& o) { return same_name(o.id, id) || same_name(name_of(o.type), id); });
}

// Which edges there are depends on the type, which parts on the things: `spaces` has their names where the file says them.
template <class Add>
void check_places(const Relation& relation, const RelationRow& row, const Names& names, const Add& add) {
  const RelationParameters& given = relation.parameters;
  if (row.reads("edge") && given.edge) {
    const std::vector<Edge> edges = edges_of(relation.type);
    std::vector<std::string_view> known;
    for (const Edge edge : edges) known.push_back(name_of(edge));
    if (std::ranges::find(edges, *given.edge) == edges.end()) {
      add(ErrorCode::kSchema, fmt::format("{} has no edge \"{}\"", row.name, name_of(*given.edge)), "/edge",
          fmt::format("give one of: {}", fmt::join(known, ", ")));
    }
  }
  if (!row.reads("part") || given.part.empty() || given.part.is_words()) return;
  const bool may_be_space = std::ranges::any_of(relation.references, [&](const std::string& id) { return is_object(names, id); });
  if (!may_be_space && !relation.references.empty()) {
    add(ErrorCode::kSchema, fmt::format("\"{}\" is no part of {}", given.part.text(), relation.references.front()), "/part",
        fmt::format("give some of: {}", fmt::join(part_words(), ", ")));
  }
}

void check_relation(const Relation& relation, const std::string& pointer, const Names& names, const Room& room,
                    std::vector<Error>& errors) {
  const RelationRow& row = relation_row(relation.type);
  const auto add = [&](ErrorCode code, std::string message, std::string where, std::string hint) {
    errors.push_back({code, std::move(message), pointer + where, std::move(hint), {}});
  };
  for (std::size_t i = 0; i < relation.targets.size(); ++i) {
    if (is_object(names, relation.targets[i])) continue;
    add(ErrorCode::kReference, fmt::format("{} is about \"{}\", which is no object of this file", row.name, relation.targets[i]),
        fmt::format("/targets/{}", i), names.ids.suggestion(relation.targets[i]));
  }
  const bool needs_reference = row.arity == RelationArity::kOne || row.arity == RelationArity::kMany;
  // Several targets may name the reference too ("align: desk, bed").
  if (needs_reference && relation.references.empty() && relation.targets.size() < 2) {
    add(ErrorCode::kSchema, fmt::format("{} needs relativeTo", row.name), "", "say what it is relative to");
  }
  for (const std::string& reference : relation.references) {
    const bool known = is_object(names, reference) || names.ids.has(reference) || is_wall(names, reference) ||
                       is_opening(room.openings, reference) || reference == "room" || reference == "floor" || reference == "ceiling" ||
                       (!room.openings_given && (reference == "door" || reference == "window"));
    if (!known) {
      add(ErrorCode::kReference, fmt::format("{} is relative to \"{}\", which is nothing in this file", row.name, reference), "/relativeTo",
          names.ids.suggestion(reference));
    } else if (std::ranges::find(relation.targets, reference) != relation.targets.end()) {
      add(ErrorCode::kReference, fmt::format("{} relates \"{}\" to itself", row.name, reference), "/relativeTo", "name something else");
    }
  }
  if (relation.parameters.min && relation.parameters.max && *relation.parameters.min > *relation.parameters.max) {
    add(ErrorCode::kSchema, fmt::format("{} has a min above its max", row.name), "/min", "let min be at most max");
  }
  check_places(relation, row, names, add);
}

void check_walls(const Room& room, std::vector<Error>& errors) {
  if (room.walls.empty()) return;
  Room copy = room;
  complete_rectangle(copy);
  const auto ring = walls_in_ring(copy.walls, copy.openings);
  if (ring) return;
  if (ring.error().details.empty())
    errors.push_back(ring.error());
  else
    errors.insert(errors.end(), ring.error().details.begin(), ring.error().details.end());
}

void check_room(const Room& room, std::vector<Error>& errors) {
  const std::size_t before = errors.size();
  if (!room.polygon.empty()) {
    if (const auto polygon = tidy_polygon(room.polygon); !polygon) errors.push_back(polygon.error());
  }
  check_walls(room, errors);
  if (errors.size() != before) return;  // openings would only repeat it
  Room shell = room;
  if (shell.walls.empty() && !shell.polygon.empty()) {
    if (const auto polygon = tidy_polygon(shell.polygon)) shell.walls = walls_along(*polygon);
  }
  std::vector<Error> openings = check_openings(shell);
  std::ranges::move(openings, std::back_inserter(errors));
}

void add_room_ids(const Room& room, IdChecker& ids) {
  for (std::size_t i = 0; i < room.walls.size(); ++i) ids.add(room.walls[i].id, fmt::format("/room/walls/{}", i));
  for (std::size_t i = 0; i < room.openings.size(); ++i) ids.add(room.openings[i].id, fmt::format("/room/openings/{}", i));
}

}  // namespace

std::vector<Error> check_scene(const SceneGraph& scene) {
  std::vector<Error> errors;
  IdChecker ids(errors);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) ids.add(scene.objects[i].id, fmt::format("/furniture/{}", i));
  add_room_ids(scene.room, ids);
  std::map<std::string, std::size_t> relation_ids;
  for (std::size_t i = 0; i < scene.relations.size(); ++i) {
    const std::string& id = scene.relations[i].id;
    if (!id.empty() && !relation_ids.emplace(id, i).second) {
      errors.push_back({ErrorCode::kReference,
                        fmt::format("two constraints have the id \"{}\"", id),
                        fmt::format("/constraints/{}", i),
                        "give each an id of its own",
                        {}});
    }
  }
  check_room(scene.room, errors);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    if (object.fixed && !object.hint.position) {
      errors.push_back({ErrorCode::kSchema,
                        fmt::format("\"{}\" is fixed but has no place", object.id),
                        fmt::format("/furniture/{}/xform", i),
                        "give xform.pos",
                        {}});
    }
  }
  Names names{ids, scene.room.walls, {}};
  for (const SceneObject& object : scene.objects) names.object_ids.push_back(object.id);
  for (std::size_t i = 0; i < scene.relations.size(); ++i) {
    check_relation(scene.relations[i], fmt::format("/constraints/{}", i), names, scene.room, errors);
  }
  return errors;
}

std::vector<Error> check_layout(const Layout& layout) {
  std::vector<Error> errors;
  IdChecker ids(errors);
  for (std::size_t i = 0; i < layout.objects.size(); ++i) ids.add(layout.objects[i].id, fmt::format("/objects/{}", i));
  add_room_ids(layout.room, ids);
  check_room(layout.room, errors);
  for (std::size_t i = 0; i < layout.objects.size(); ++i) {
    const std::string& support = layout.objects[i].supported_by;
    if (support == layout.objects[i].id || (support != "floor" && support != "ceiling" && !ids.has(support))) {
      errors.push_back({ErrorCode::kReference,
                        fmt::format("\"{}\" is supported by \"{}\", which is nothing in this file", layout.objects[i].id, support),
                        fmt::format("/objects/{}/supportedBy", i),
                        ids.suggestion(support),
                        {}});
    }
  }
  Names names{ids, layout.room.walls, {}};
  for (const PlacedObject& object : layout.objects) names.object_ids.push_back(object.id);
  // What was left out is listed by its id; relations speak of it still.
  for (const auto* list : {&layout.relaxed, &layout.gave_way}) {
    for (const Relaxation& item : *list) names.object_ids.push_back(item.relation);
  }
  for (std::size_t i = 0; i < layout.relations.size(); ++i) {
    check_relation(layout.relations[i].relation, fmt::format("/relations/{}", i), names, layout.room, errors);
  }
  return errors;
}

Error combined(std::vector<Error> errors) {
  Error all = errors.front();
  if (errors.size() > 1) all.details = std::move(errors);
  return all;
}

}  // namespace layoutbox
