// Words that change a room to steps that change it: "move the desk under the window and remove the rug".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

enum class EditKind {
  kAdd,      // `objects` come in, with `relations`; or `openings`
  kRemove,   // `targets` go
  kMove,     // `targets` get new `relations`; doors and windows an `opening_place`
  kShift,    // `targets` move by `shift`
  kSwap,     // targets[0] and targets[1] take each other's place
  kReplace,  // `objects` take the places of `targets`, one each
  kTurn,     // `targets` turn by `degrees`, or get new `relations` (facing)
  kResize,   // `targets` get another size
  kRecolor,  // `targets` get other `attributes`
  kRename,   // targets[0] is called `name`
  kKeep,     // `targets` stay exactly where they are
};
std::string_view name_of(EditKind kind);

// A move without a place: "30 cm to the left", "closer to the window".
struct EditShift {
  enum class Way { kLeft, kRight, kFront, kBack, kUp, kDown, kTowards, kAway };
  Way way = Way::kLeft;
  std::optional<Mm> distance;  // empty: a little
  std::string reference;       // of kTowards and kAway: the id of an object, a wall or an opening
};

// What becomes of width, depth and height (in this order): times `factor`, and more by `more`; or `exact`.
struct EditResize {
  struct Side {
    double factor = 1;
    Mm more = 0;
    std::optional<Mm> exact;
  };
  std::array<Side, 3> sides;
  bool longer_side = false;  // sides[0] speaks of the longer of width and depth
};

// Where a door or a window goes.
struct EditOpeningPlace {
  std::string wall;                           // a wall's id; empty: the one at hand, or any
  std::optional<std::array<double, 2>> near;  // mm; its centre as near to there as can be; empty: anywhere along the wall
};

// The room itself, among the targets of a step.
inline constexpr std::string_view kEditRoom = "room";
// … and what of it can be painted, besides single walls by their ids.
inline constexpr std::string_view kEditWalls = "walls", kEditFloor = "floor", kEditCeiling = "ceiling";

struct EditStep {
  EditKind kind = EditKind::kMove;
  // Ids of objects of the layout, or of those that an earlier step added; or of doors and windows; or kEditRoom.
  std::vector<std::string> targets;
  std::vector<SceneObject> objects;  // new ones, with ids of their own
  std::vector<Relation> relations;   // without ids
  std::vector<Opening> openings;     // new doors and windows, with ids of their own
  std::optional<EditOpeningPlace> opening_place;
  std::optional<EditShift> shift;
  double degrees = 0;  // counter-clockwise
  EditResize resize;
  std::vector<std::string> attributes;
  std::vector<std::string> attribute_class;     // "color", "material", "shape", "style", "size": of each attribute
  std::vector<std::string> dropped_attributes;  // what the targets were, and are no longer
  std::string name;
  std::string why;  // the words
};

struct EditPlan {
  std::vector<EditStep> steps;
  std::vector<Note> notes;  // what was decided where the words leave it open
};

// Reads a text of one or more commands. Noun phrases and places are read as the offline planner reads them; things are looked for in
// the layout by name, kind, attribute, size, place and what they stand by ("the larger table", "the chair next to the bed").
// Errors, naming the words: kEmpty, kParse (not understood), kReference (nothing here is called so, or several are).
Result<EditPlan> plan_edit(std::string_view text, const Layout& layout, const Catalog& catalog);

}  // namespace layoutbox
