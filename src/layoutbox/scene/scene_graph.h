// The scene graph: a room, the objects in it and the relations between them, before anything has a place.
//
// Frame: right-handed, z up. The origin is the floor's front-left inner corner; x runs to the right (east), y away from the
// viewer (north). An object's front faces −y at rotation 0, its left is −x. Rotation is counter-clockwise about z, in degrees.
// A scene that comes from a file or a planner may lack sizes, walls and openings; `normalize_scene` (catalog/) fills them and
// lists what it filled. Every later stage REQUIRES a normalised scene.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/base/units.h"
#include "layoutbox/scene/relation_parameters.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox {

enum class Mount { kFloor, kWall, kCeiling, kSurface, kHung };
enum class OpeningType { kDoor, kWindow, kOpen };
// Where a door's hinge is and which way it turns, seen from inside the room looking at the wall.
enum class Swing { kInLeft, kInRight, kOutLeft, kOutRight, kSliding, kNone };
enum class SizeSource { kUnknown, kCatalog, kInferred, kUser };
// Whose wish it is: said in the text, the file or by the user's hand; what follows from the text; a companion that the use needs; a
// default of ours. In this order: what comes later gives way first, and only what was asked counts for "as asked".
enum class Origin { kAsked, kConcluded, kAdded, kAssumed };

struct Color {  // linear components are not meant here: sRGB, 0–1
  double r = 0, g = 0, b = 0;
  friend bool operator==(const Color&, const Color&) = default;
};

struct Material {
  std::string id;
  std::optional<Color> color;
  std::string texture;              // image file, relative to the scene file; empty = none
  std::optional<double> roughness;  // 0–1
  std::array<double, 2> uv_scale{1, 1};
};

// A free box within an object's box, in the object's own frame: origin under the centre of its footprint, z up from its
// underside; millimetres. Things stand on its floor unless `carries` is false (knee room, the room under a bed).
struct Space {
  std::string name;
  std::array<double, 3> min{};
  std::array<double, 3> max{};
  bool carries = true;
};

struct Wall {
  std::string id;
  Point start, end;  // along the inner face, counter-clockwise round the room once normalised
  Mm thickness = 100;
  std::string material;  // a material's id or name, or empty
  std::string mesh;
};

// Where a text has the middle of a thing, or a door or window along its wall. Not in files: normalize_scene sets an opening's offset by it.
struct SaidPlace {
  bool in_middle = false;           // of its wall
  std::string corner{};             // … or near the corner that is so called ("left", "back right")
  std::optional<Mm> from_corner{};  // … so far off it; empty: a hand's breadth
  std::optional<Mm> x{}, y{};       // its middle, from the room's left and from its front
};

struct Opening {
  std::string id;
  OpeningType type = OpeningType::kDoor;
  std::string wall;          // empty: any wall, the solver chooses
  std::optional<Mm> offset;  // from the wall's start to the nearer edge; empty: the solver chooses
  Mm width = 900, height = 2000, sill = 0;
  Mm sill_depth = 200;  // windows: how deep a thing may be that stands on the sill
  Swing swing = Swing::kInLeft;
  Origin origin = Origin::kAsked;         // else it is the first to be moved or narrowed
  std::vector<std::string> attributes{};  // what the text says of its look: "french", "round", "red" (catalog/words_openings.json)
  SaidPlace place{};
  std::string called{};  // what the text calls it ("front door"). Not in files.
  bool asked() const { return origin == Origin::kAsked; }
};

struct Room {
  std::string type;            // "bedroom", "living_room"…, or empty
  std::vector<Point> polygon;  // counter-clockwise, inner faces of the walls; empty before normalisation if unknown
  Mm height = 0;               // floor to ceiling; 0 before normalisation if unknown
  std::vector<Wall> walls;     // one per polygon edge, in its order, once normalised
  std::vector<Opening> openings;
  bool openings_given = false;  // the list is complete, even if empty: no default door and window are added
  std::string floor_material, wall_material, ceiling_material;
  // Single walls that the text gives a look: by id or word, and the material; normalize_scene hands it to the wall. Not in files.
  std::vector<std::pair<std::string, std::string>> wall_looks{};
  // What the text said where no exact size was given; read by normalize_scene.
  std::optional<double> area_m2;
  std::string size_word;  // "small", "large", "spacious"… or empty
  std::string shape;      // "L", "T", "U", "round" or empty (rectangle)
};

// Between which sizes the solver may choose; equal ends where the size is given. `usual` is preferred.
// Before normalisation a side of 0 is unknown ("120 cm wide": only the width is set) and is filled from the catalogue.
struct SizeRange {
  Size least, usual, greatest;
  friend bool operator==(const SizeRange&, const SizeRange&) = default;
};

// Where a model, a file or an earlier layout had an object. A hint, unless the object is fixed.
struct PoseHint {
  std::optional<std::array<double, 3>> position;  // mm; x, y: centre of the footprint, z: underside
  std::optional<double> rotation_deg;
  bool z_may_be_centre = false;  // files of others give either; normalize_scene decides, once heights are known
};

struct SceneObject {
  std::string id;
  std::string category;                 // a catalogue entry's id where there is one, else the head noun in snake_case
  std::string name;                     // the words of the prompt: "queen bed"
  std::string catalog_id;               // the user's own article number, or empty
  std::vector<std::string> attributes;  // "blue", "wooden", "large"
  std::optional<SizeRange> size;        // always set once normalised
  SizeSource size_source = SizeSource::kUnknown;
  std::optional<Mount> mount;                   // always set once normalised
  bool mount_assumed = false;                   // the habit of its kind: gives way to what is asked of it
  std::optional<std::vector<Side>> used_sides;  // normalised; empty vector: none
  std::vector<Space> spaces;                    // only where a file gave them; else the catalogue's formulas hold (catalog/spaces.h)
  bool spaces_given = false;
  // How it is built where something is to be under or in it and its kind is solid there (catalog/normalize_guests.cc); not in files.
  Mm raised = 0;        // so much is free below it, between legs
  bool hollow = false;  // open above, with an inside
  PoseHint hint;
  bool fixed = false;  // stays at `hint` exactly (columns, built-ins, locked parts of an earlier layout)
  std::array<double, 3> scale{1, 1, 1};
  std::string mesh, mesh_front, material;
  std::vector<std::string> tags;
  Origin origin = Origin::kAsked;  // kAssumed: the usual furniture of a room of which none was named
  bool asked() const { return origin == Origin::kAsked; }
};

struct Relation {
  std::string id;
  RelationType type = RelationType::kInside;
  std::vector<std::string> targets;     // object ids; targets[0] is who is placed
  std::vector<std::string> references;  // JSON relativeTo: ids of objects, walls, openings; "room", "floor", "ceiling"
  RelationParameters parameters;
  bool hard = true;
  int weight = 100;  // of a soft relation, or the price of giving up a hard one
  std::string why;   // the words of the prompt it came from, or the rule that assumed it
  Origin origin = Origin::kAsked;
  bool asked() const { return origin == Origin::kAsked; }
};

// A parameter in effect: as given, else the default of the type's row; in_effect() is empty where there is neither.
template <class T>
std::optional<T> in_effect(const Relation& relation, std::optional<T> RelationFigures::*parameter) {
  const std::optional<T>& given = relation.parameters.*parameter;
  return given ? given : relation_row(relation.type).defaults.*parameter;
}
// REQUIRES: the row has a default for it.
template <class T>
T or_default(const Relation& relation, std::optional<T> RelationFigures::*parameter) {
  return in_effect(relation, parameter).value_or(T{});
}

// Something that was read in another way than written, filled in, or not understood; for run.json and stderr.
struct Note {
  std::string code;     // "filled", "converted", "guessed", "ignored", "not-understood", "contradiction"…
  std::string message;  // one sentence
  std::string pointer;  // JSON pointer or "prompt:12-18" (character places), or empty
};

struct SceneGraph {
  std::string prompt, name, project_id;
  Room room;
  std::vector<SceneObject> objects;
  std::vector<Relation> relations;
  std::vector<Material> materials;
  std::vector<Note> notes;

  const SceneObject* find_object(std::string_view id) const;
  const Opening* find_opening(std::string_view id) const;
  // By id, or by the words front, right, back, left (also south, east, north, west); without regard to case and underscores.
  const Wall* find_wall(std::string_view id_or_word) const;
};

// Two ids or names are the same when only case, spaces, underscores and hyphens differ.
bool same_name(std::string_view a, std::string_view b);

// A side of the room that a word names: "front", "south", "the back wall", "Wall_Left"… Empty for any other word.
std::optional<Side> room_side_from_word(std::string_view word);

// The outermost wall on that side of the room (the longest of those); null where no wall lies there. In any order and direction.
const Wall* wall_on_side(const std::vector<Wall>& walls, Side side);

// Names as they stand in JSON ("floor", "in-left", "catalog"…), and back (empty where there is no such name).
std::string_view name_of(Mount mount);
std::string_view name_of(Side side);
std::string_view name_of(Axis axis);
std::string_view name_of(OpeningType type);
std::string_view name_of(Swing swing);
std::string_view name_of(SizeSource source);
std::string_view name_of(Origin origin);
std::optional<Mount> mount_from_name(std::string_view name);
std::optional<Side> side_from_name(std::string_view name);
std::optional<Axis> axis_from_name(std::string_view name);
std::optional<OpeningType> opening_type_from_name(std::string_view name);
std::optional<Swing> swing_from_name(std::string_view name);
std::optional<SizeSource> size_source_from_name(std::string_view name);
std::optional<Origin> origin_from_name(std::string_view name);

}  // namespace layoutbox
