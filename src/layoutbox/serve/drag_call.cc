// A hand moves one thing: where may it stand, and what gives way?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/serve/call_parts.h"
#include "layoutbox/serve/snapping.h"
#include "layoutbox/verify/standing.h"

namespace layoutbox::serve {
namespace {

bool names(const std::vector<std::string>& ids, std::string_view id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

// What the hand holds, and what stands on it.
std::set<std::string> with_riders(const Layout& layout, const std::string& id) {
  std::set<std::string> held{id};
  for (bool grew = true; grew;) {
    grew = false;
    for (const PlacedObject& object : layout.objects) {
      if (held.count(object.supported_by) > 0) grew |= held.insert(object.id).second;
    }
  }
  return held;
}

void move_object(PlacedObject& object, const Json& request, const Room& room, const Catalog& catalog) {
  if (request.contains("size")) {
    const Json& size = request.at("size");
    object.size = {mm_from_m(size[0]), mm_from_m(size[1]), mm_from_m(size[2])};
    object.spaces = spaces_at(catalog.entry_or_nearest(object.catalog_id.empty() ? object.category : object.catalog_id), object.size);
  }
  if (request.contains("rotation")) object.rotation_deg = normalized_degrees(request.at("rotation").get<double>());
  if (!request.contains("pos")) return;
  const Json& position = request.at("pos");
  for (std::size_t axis = 0; axis < position.size(); ++axis) object.position[axis] = mm_from_m(position[axis].get<double>());
  if (request.value("snap", false)) snap_to_walls(object, room, catalog.entry_or_nearest(object.category));
}

// What stands on a thing goes and turns with it.
void carry_along(Layout& wished, const PlacedObject& before, const PlacedObject& after) {
  const double angle = radians_from_degrees(after.rotation_deg - before.rotation_deg), c = std::cos(angle), s = std::sin(angle);
  for (const std::string& id : with_riders(wished, after.id)) {
    if (id == after.id) continue;
    for (PlacedObject& rider : wished.objects) {
      if (rider.id != id) continue;
      const double x = rider.position[0] - before.position[0], y = rider.position[1] - before.position[1];
      rider.position[0] = after.position[0] + c * x - s * y;
      rider.position[1] = after.position[1] + s * x + c * y;
      rider.position[2] += after.position[2] - before.position[2];
      rider.rotation_deg = normalized_degrees(rider.rotation_deg + after.rotation_deg - before.rotation_deg);
    }
  }
}

// The layout as the hand would have it, legal or not.
Result<Layout> wished_layout(const Layout& layout, const Json& request, const Catalog& catalog) {
  Layout wished = layout;
  const auto id = request.at("id").get<std::string>();
  for (PlacedObject& object : wished.objects) {
    if (object.id != id) continue;
    move_object(object, request, wished.room, catalog);
    carry_along(wished, *layout.find_object(id), object);
    return wished;
  }
  for (Opening& opening : wished.room.openings) {
    if (opening.id != id) continue;
    if (request.contains("pos")) {
      snap_opening(opening, Room(wished.room), mm_from_m(request.at("pos")[0]), mm_from_m(request.at("pos")[1]));
    }
    return wished;
  }
  return fail(ErrorCode::kReference, fmt::format("the layout has no \"{}\"", id), "/id", "name an object, a door or a window");
}

// What the hand does counts before what was asked of the thing earlier; that, and what was given up before, is judged afterwards and binds
// no more.
bool is_set_aside(const PlacedRelation& placed, const Layout& layout, const std::string& id) {
  return names(placed.relation.targets, id) || names(placed.relation.references, id) || layout.lists_as_given_up(placed.relation.id);
}

// Takes them out of the layout.
std::vector<PlacedRelation> take_set_aside(Layout& layout, const std::string& id) {
  std::vector<PlacedRelation> found, kept;
  for (PlacedRelation& placed : layout.relations) (is_set_aside(placed, layout, id) ? found : kept).push_back(placed);
  layout.relations = std::move(kept);
  return found;
}

SolveOptions options_for(const Layout& wished, const Json& request, const Surroundings& around) {
  SolveOptions options;
  options.improve = false, options.prove = false, options.effort = 10, options.time_limit_s = 2;
  options.on_conflict = OnConflict::kFail;
  options.from = &wished;
  options.stop = around.stop;
  const auto id = request.at("id").get<std::string>();
  options.locked = request.value("locked", std::vector<std::string>{});
  if (wished.find_object(id) != nullptr && !names(options.locked, id)) options.locked.push_back(id);
  if (request.value("others", "giveWay") == "fixed") {
    const auto held = with_riders(wished, id);
    for (const PlacedObject& object : wished.objects) {
      if (held.count(object.id) == 0 && !names(options.locked, object.id)) options.locked.push_back(object.id);
    }
  }
  return options;
}

// Puts back the relations that bound nothing, each with the verifier's verdict; one that is broken now was given up by the hand.
void judge_relations(Layout& layout, const std::vector<PlacedRelation>& set_aside, const Layout& earlier, const Catalog& catalog) {
  for (PlacedRelation placed : set_aside) {
    placed.held = false;
    layout.relations.push_back(std::move(placed));
  }
  const Report report = verify_standing(layout, catalog);
  for (const Check& check : report.checks) {
    if (check.name != "relation") continue;
    for (PlacedRelation& placed : layout.relations) {
      if (placed.relation.id == check.subject && !placed.held) placed.held = check.passed;
    }
  }
  for (const PlacedRelation& placed : layout.relations) {
    if (placed.held || !placed.relation.hard || layout.lists_as_given_up(placed.relation.id)) continue;
    const auto before = std::find_if(earlier.relaxed.begin(), earlier.relaxed.end(),
                                     [&](const Relaxation& relaxation) { return relaxation.relation == placed.relation.id; });
    layout.relaxed.push_back(before == earlier.relaxed.end() ? Relaxation{placed.relation.id, 0, "", "moved by hand"} : *before);
  }
}

// What was left out before is so still, where a relation speaks of it.
void keep_left_out(Layout& layout, const Layout& earlier) {
  const auto is_spoken_of = [&](const std::string& id) {
    return std::any_of(layout.relations.begin(), layout.relations.end(), [&](const PlacedRelation& placed) {
      return names(placed.relation.targets, id) || names(placed.relation.references, id);
    });
  };
  const auto keep = [&](const std::vector<Relaxation>& before, std::vector<Relaxation>& now) {
    for (const Relaxation& item : before) {
      const bool gone = layout.find_object(item.relation) == nullptr && !layout.lists_as_given_up(item.relation);
      if (gone && is_spoken_of(item.relation)) now.push_back(item);
    }
  };
  keep(earlier.relaxed, layout.relaxed);
  keep(earlier.gave_way, layout.gave_way);
}

Json reasons_against(const Layout& wished, const Error& error, const Catalog& catalog) {
  Json reasons = Json::array();
  for (const Error& detail : error.details) reasons.push_back({{"text", detail.message}});
  if (!reasons.empty()) return reasons;
  for (const Check& check : verify_standing(wished, catalog).checks) {
    if (check.passed || !check.required || check.name == "relation") continue;
    reasons.push_back({{"text", check.message}, {"subject", check.subject}});
  }
  if (reasons.empty()) reasons.push_back({{"text", error.message}});
  return reasons;
}

bool stands_elsewhere(const PlacedObject& object, const Layout& earlier) {
  const PlacedObject* before = earlier.find_object(object.id);
  if (before == nullptr) return true;
  return std::abs(object.position[0] - before->position[0]) > 1 || std::abs(object.position[1] - before->position[1]) > 1 ||
         std::abs(object.position[2] - before->position[2]) > 1 || object.rotation_deg != before->rotation_deg;
}

}  // namespace

Result<Answer> drag_call(const Json& request, const Surroundings& around) {
  Stopwatch watch;
  LAYOUTBOX_ASSIGN(const Layout layout, layout_of(request));
  LAYOUTBOX_ASSIGN(Layout wished, wished_layout(layout, request, around.catalog));
  const auto id = request.at("id").get<std::string>();
  const std::vector<PlacedRelation> set_aside = take_set_aside(wished, id);
  LAYOUTBOX_ASSIGN(const SceneGraph scene, prepare_scene(scene_of(wished), around.catalog, {}));
  auto solved = solve(scene, around.catalog, options_for(wished, request, around));
  if (!solved && solved.error().code == ErrorCode::kInterrupted) return Failure(std::move(solved).error());
  Json moved = Json::array(), reasons = Json::array();
  std::string result;
  if (solved) {
    judge_relations(*solved, set_aside, layout, around.catalog);
    keep_left_out(*solved, layout);
    for (const PlacedObject& object : solved->objects) {
      if (object.id != id && stands_elsewhere(object, layout)) moved.push_back(object.id);
    }
    result = write_layout(*solved);
  } else {
    reasons = reasons_against(wished, solved.error(), around.catalog);
    result = request.at("layout").dump();
  }
  JsonText answer;
  answer.add("legal", solved.has_value()).add("moved", moved).add("reasons", reasons).add_written("layout", result);
  return answer.add("milliseconds", watch.lap()).answer();
}

}  // namespace layoutbox::serve
