// The layout: the same room with every object placed. It stands alone: who has it needs no other file to judge or draw the room.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

struct PlacedObject {
  std::string id, category, name, catalog_id;
  std::vector<std::string> attributes;
  Size size;                         // chosen within the scene's range
  std::array<double, 3> position{};  // mm; x, y: centre of the footprint (half millimetres occur), z: underside
  double rotation_deg = 0;           // [0, 360)
  Mount mount = Mount::kFloor;
  std::string supported_by = "floor";  // floor, ceiling, a wall's id, an object's id, or a window's id (its sill)
  std::vector<Side> used_sides;
  std::vector<Space> spaces;  // evaluated at `size`
  std::string mesh, mesh_front, material;
  bool fixed = false;
  Origin origin = Origin::kAsked;
};

struct PlacedRelation {
  Relation relation;
  bool held = false;  // what the solver claims; verify judges
};

// A relation that was given up or gave way, and by how much it is missed.
struct Relaxation {
  std::string relation;  // its id, or a name such as "door swing of door1"
  double by = 0;
  std::string unit;  // "m", "degrees" or empty
  std::string why;
};

// A smallest set of relations and sizes that cannot all hold.
struct Conflict {
  std::vector<std::string> relations;  // ids
  std::vector<std::string> objects;    // ids whose sizes take part
  std::string sentence;                // one English sentence with numbers
  bool minimal = true;
};

// kSolved: all that was asked for holds; kRelaxed: some of it was given up; kFallback: the scene's own positions.
enum class LayoutStatus { kSolved, kRelaxed, kFallback };
std::string_view name_of(LayoutStatus status);
std::optional<LayoutStatus> layout_status_from_name(std::string_view name);

struct LayoutStats {
  std::string solver;  // "search", "cp-sat", "search+cp-sat"
  std::uint64_t seed = 1;
  double seconds = 0;             // of solve itself, scene graph to layout
  bool proven = false;            // the score is proven best
  bool stopped_by_clock = false;  // a wall-clock limit stepped in: the bytes may differ next time
};

struct Layout {
  std::string prompt, name;
  LayoutStatus status = LayoutStatus::kSolved;
  Room room;  // normalised: polygon, walls and openings all with their places
  std::vector<PlacedObject> objects;
  std::vector<PlacedRelation> relations;
  std::vector<Relaxation> relaxed;   // what was asked for and given up, or left out
  std::vector<Relaxation> gave_way;  // what nobody asked for and gave way to what was
  std::vector<Conflict> conflicts;
  std::vector<Material> materials;
  double score = 0;  // 0–1, soft score
  std::map<std::string, double> score_terms;
  LayoutStats stats;

  const PlacedObject* find_object(std::string_view id) const;
  const Wall* find_wall(std::string_view id_or_word) const;
  const Opening* find_opening(std::string_view id) const;
  // Listed in `relaxed` or `gave_way`, a relation's id or such as "door swing of door1".
  bool lists_as_given_up(std::string_view relation) const;
};

}  // namespace layoutbox
