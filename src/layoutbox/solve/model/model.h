// The scene as the solver sees it: items (objects, doors, windows) with the states they can take, the room in millimetres, which pairs
// may not share room, and every constraint in the small form.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"
#include "layoutbox/solve/model/formula.h"

namespace layoutbox::placement {

// A way an item can stand: turned so, this big.
struct State {
  int turn = 0;                     // degrees, counter-clockwise; the nearest whole one
  double angle = 0;                 // exactly
  int size_step = 0;                // 0: the usual size; more: farther from it
  Size size;                        // at turn 0
  Vec3 extent{};                    // of the box around the turned body
  std::vector<Mm> constants;        // by Quantity − kFirstConstant
  std::vector<GridBox> solids;      // what of the box is body, from its low corner; the box itself where nothing is free
  std::vector<GridBox> own_solids;  // at odd angles: the same in the object's own frame
  std::vector<GridBox> clear;       // boxes that no body may enter, from its low corner
  std::vector<GridBox> strips;      // free floor wanted at its used sides (0.2 m deep, 0.05 m off), from its low corner
  std::vector<GridBox> wanted;      // free floor the catalogue wants, from its low corner
  GridBox claims{};                 // around the last three, from the low corner; inside out where there are none
};

// A free box within an item that other things may be in; its sides are the six constants from `quantity` on (low x, y, z, high x, y, z).
struct ItemSpace {
  std::string name;
  bool carries = true;
  bool open_above = false;
  int quantity = kFirstConstant;
};

// Something an item can rest on or hang from; each is a case of its support constraint, in the same order.
struct SupportOption {
  enum class Kind { kFloor, kCeiling, kWall, kItem, kSill } kind = Kind::kFloor;
  ItemId item;  // or opening
  WallId wall;
  bool rests = false;  // on or in the item rather than hanging from it
};

struct Item {
  std::string id;
  const SceneObject* object = nullptr;  // an object…
  const CatalogEntry* entry = nullptr;  // with its kind
  const Opening* opening = nullptr;     // …or an opening
  Mount mount = Mount::kFloor;
  Mount usual_mount = Mount::kFloor;  // where no relation hangs it on a wall or from the ceiling
  bool has_front = true;
  bool thin = false;     // a rug: collides with nothing
  bool curtain = false;  // may hang before a window
  bool is_seat = false, takes_seats = false;
  bool stood_under = false;  // one stands or sits below it: a loft bed
  bool fixed = false;
  Vec3 fixed_at{};
  bool locked = false;  // stays where it was, unless that has to be given up
  std::vector<State> states;
  std::uint64_t all_states = 0;
  std::uint64_t odd_states = 0;  // those at other than quarter turns, in which the body is less than the box around it
  // Where there are such: in each state eight constants about the turned footprint, from the low corner of its box: an upright box within
  // (low x, low y, high x, high y), then its four corners (x and y each).
  int footprint = -1;
  int spans = -1;                  // in rooms with slanted walls: how far it reaches along each of the model's headings
  ConstraintId within_constraint;  // and the constraint that keeps it before them
  std::vector<ItemSpace> spaces;
  std::vector<SupportOption> supports;
  ConstraintId support_constraint;
  ConstraintId clearance_constraint;  // openings: the implied constraint whose giving up frees their clear box
  bool is_opening() const { return opening != nullptr; }
  bool toppled = false;  // lies on its side: it is of no use, and so nothing that its kind is
  bool is(Trait trait) const { return entry != nullptr && !toppled && entry->is(trait); }
  std::uint64_t states_at(int turn) const;
  // Bounds over all states.
  Mm least_extent(int axis) const;
};

struct RoomWall {
  std::string id;
  Point start, end;                          // counter-clockwise round the room
  bool straight = true;                      // along x or y; of the others `at`, `lo`, `hi` are about the box around them
  double angle = 0;                          // of an object with its back against it, degrees
  int normal_heading = -1, normal_sign = 1;  // slanted walls: the way into the room, as one of the model's headings
  int along_heading = -1, along_sign = 1;    // and the way from start to end
  int along = 0;                             // axis it runs along
  int inward = 1;                            // sign of its normal
  Mm at = 0;                                 // where it stands on the other axis
  Mm lo = 0, hi = 0;                         // from where to where it runs
  int turn = 0;                              // of an object with its back against it
  bool runs_up = true;                       // its start is at `lo`
  int normal() const { return 1 - along; }
};

// A direction in whole numbers (of length kHeading, slanted.h).
struct Heading {
  double angle = 0;  // 0 … 180 degrees
  std::int32_t x = 0, y = 0;
};

enum class PairRule : std::uint8_t {
  kFree,     // may share room
  kBoxes,    // their boxes may not overlap
  kSolids,   // their bodies may not: boxes less spaces
  kOpenings  // two openings: not in the same stretch of wall
};

// Where everything stands.
struct Placement {
  int state = -1;  // −1: not placed
  Vec3 at{};       // low corner
  friend bool operator==(const Placement&, const Placement&) = default;
};
using Placements = ById<ItemId, Placement>;

struct PlacementModel {
  const SceneGraph* scene = nullptr;
  const Catalog* catalog = nullptr;
  GridBox room;                     // the bounding box of the floor, floor to ceiling
  std::vector<GridBox> outside;     // what of it is not room; before slanted walls a little more, in steps
  std::vector<GridBox> off_limits;  // the same, where no body may be; what is behind slanted walls is said by within_walls (slanted.h)
  std::vector<Heading> headings;    // along and across the slanted walls
  ById<WallId, RoomWall> walls;
  ById<ItemId, Item> items;  // objects in the scene's order, then openings
  ById<ConstraintId, Constraint> constraints;
  ById<ItemId, std::vector<ConstraintId>> touching;  // the constraints that speak of it
  std::vector<PairRule> pairs;                       // items × items
  const Layout* from = nullptr;                      // the earlier layout that guides, if any
  Placements start;                                  // by item: where it had things; empty where there is none
  // By kind: which items are one (-1: nobody asked yet). The catalogue looks each up by its name.
  mutable std::map<std::string, ById<ItemId, signed char>, std::less<>> kinds;

  PairRule pair(ItemId a, ItemId b) const { return pairs[a.index() * items.size() + b.index()]; }
  void set_pair(ItemId a, ItemId b, PairRule rule);
  ItemId find_item(std::string_view id) const;
  WallId find_wall(std::string_view id) const;
  const Relation& relation(RelationId id) const { return scene->relations[id.index()]; }
  bool is_a(ItemId item, std::string_view kind) const;
};

// Whether sizes other than the usual ones are among the states, and how finely the room is cut.
struct ModelOptions {
  int size_steps = 3;                      // below the usual size, the last is the least
  const Layout* from = nullptr;            // an earlier layout: what it has stays near its place there
  std::vector<const Layout*> unlike;       // layouts that the new one is to differ from
  std::vector<std::string> locked, freed;  // ids: what stays exactly, and what looks for a new place (SolveOptions)
};

// REQUIRES: a normalised scene. Errors: kReference (a relation names what is not there), kTooLarge (more than 500 objects).
Result<PlacementModel> build_model(const SceneGraph& scene, const Catalog& catalog, const ModelOptions& options = {});

inline bool is_quarter(const State& state) { return state.angle == 90 * (state.turn / 90); }

inline GridBox box_of(const Item& item, const Placement& p) {
  const Vec3& e = item.states[p.state].extent;
  return {p.at, {p.at[0] + e[0], p.at[1] + e[1], p.at[2] + e[2]}};
}

// The value of one quantity of a placed item.
inline std::int64_t value_of(const Item& item, const Placement& p, int quantity) {
  if (quantity < kExtentX) return p.at[quantity];
  const State& state = item.states[p.state];
  return quantity < kFirstConstant ? state.extent[quantity - kExtentX] : state.constants[quantity - kFirstConstant];
}

// REQUIRES: every item the form speaks of is placed.
std::int64_t value_of(const PlacementModel& model, const Linear& form, const Placements& placements);

// How far a formula is from holding: millimetres, the least over its cases of the greatest violation; a wrong state counts kStateMiss.
// 0: it holds. REQUIRES: everything it speaks of is placed.
inline constexpr std::int64_t kStateMiss = 700;
std::int64_t miss_of(const PlacementModel& model, const Formula& formula, const Placements& placements);
std::int64_t miss_of(const PlacementModel& model, const Constraint& constraint, const Placements& placements);

bool all_placed(const Formula& formula, const Placements& placements);
bool all_placed(const Constraint& constraint, const Placements& placements);

// Do the two placed items collide? `clear_boxes` also counts the clear boxes of either.
bool collide(const PlacementModel& model, ItemId a, const Placement& pa, ItemId b, const Placement& pb, bool clear_boxes);

// The body of a placed item, taken as full, enters an upright box of the room.
bool overlaps_box(const PlacementModel& model, const Item& item, const Placement& body, const GridBox& box);

// The direction a side of the item points to at a turn (the nearest quarter turn); items without a front have the room's frame.
Direction side_direction(const Item& item, Side side, int turn);

}  // namespace layoutbox::placement
