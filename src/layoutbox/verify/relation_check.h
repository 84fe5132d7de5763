// One check per row of the relation table: check_<PascalName>. What each relation means stands in docs/relations.md.
// A new row needs its function here, or the program does not link.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/verify/room_view.h"

namespace layoutbox::checks {

// What was measured, and the limit in words: "gap between bed_1 and wall3 0.12 m, at most 0.02 m".
struct Finding {
  bool held = true;
  double value = 0;
  std::string unit;  // "m", "degrees" or empty
  std::string message;
  double miss = 0;                   // by how much the limit is broken, in metres (degrees count as centimetres)
  std::optional<double> limit = {};  // in `unit`
};

// A reference of a relation: exactly one of body and face, or neither (the room, its floor or its ceiling).
struct RelationReference {
  std::string id;
  const Body* body = nullptr;
  const Face* face = nullptr;
  const Shape& shape() const { return body ? body->shape : face->shape; }
  bool is_place() const { return body == nullptr && face == nullptr; }
  bool is_wall() const { return face != nullptr && face->opening == nullptr; }
};

// One relation of a layout with everything it names looked up.
struct RelationCase {
  const RoomView& view;
  const Relation& relation;
  std::vector<const Body*> targets;
  std::vector<RelationReference> references;

  double slack() const { return view.options.relation_slack_m; }
  // A parameter in metres: as given, else the table's default, else empty.
  std::optional<double> metres(std::optional<Mm> RelationFigures::*parameter) const;
};

#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) Finding check_##name(const RelationCase& c);
#include "layoutbox/scene/relation_list.inc"
#undef LAYOUTBOX_RELATION

// ---- putting findings together
Finding all_of(std::vector<Finding> findings);                       // the worst that fails, else the first
Finding any_of(std::vector<Finding> findings, std::string nothing);  // the best; fails with `nothing` when there is none
Finding each_target(const RelationCase& c, const std::function<Finding(const Body&)>& check);
Finding each_pair(const RelationCase& c, const std::function<Finding(const Body&, const RelationReference&)>& check);
Finding any_wall(const RelationCase& c, const std::function<Finding(const Face&)>& check);  // of those named, else of all
Finding any_door(const RelationCase& c, const std::function<Finding(const Face&)>& check);
Finding any_window(const RelationCase& c, const std::function<Finding(const Face&)>& check);
std::vector<const Face*> named_or_all(const RelationCase& c, const std::vector<Face>& all, const std::function<bool(const Face&)>& wanted);

// ---- single figures; `what` begins the sentence
Finding at_most(const std::string& what, double value, double limit, double slack);
Finding at_least(const std::string& what, double value, double limit, double slack);
Finding in_band(const std::string& what, double value, std::optional<double> min, std::optional<double> max, double slack);
Finding equal_to(const std::string& what, double value, double wanted, double slack);
Finding condition(bool held, const std::string& message);
Finding degrees_at_most(const std::string& what, double value, double limit);

// ---- words of docs/relations.md
double max_of(const RelationCase& c);  // the greatest distance, in metres. REQUIRES: given, or a default in the row
std::string name_of_pair(const Body& body, const RelationReference& reference);
Finding gap_within(const RelationCase& c, const Body& t, const RelationReference& r, std::optional<double> min, std::optional<double> max);
Finding in_line(const RelationCase& c, const Body& t, const Shape& r, Vec2d along);
Finding beyond(const RelationCase& c, const Body& t, const RelationReference& r, Side side);
Finding at_side(const RelationCase& c, const Body& t, const RelationReference& r, Side side);
Finding at_any_side(const RelationCase& c, const Body& t, const RelationReference& r, const std::vector<Side>& sides);
Finding covers(const RelationCase& c, const Body& t, const Shape& r, double grow, const std::string& reference);
Finding looks_at(const Body& t, const RelationReference& r, const RoomView& view, Side eyes = Side::kFront);
// Where the user of a desk, a workbench, a piano looks: away from the used side (a seat behind it: away from that); of all else the front.
Side eyes_of(const Body& t, const RoomView& view);
// At least that share of the shorter of the two, along the face.
Finding shares_along(const RelationCase& c, const Body& t, const Face& face, double share);
Finding side_along_wall(const RelationCase& c, const Body& t, const Face& wall, const std::vector<Side>& sides, double max_gap);
Finding below_window(const RelationCase& c, const Body& t, const Face& window, double max);
Finding keeps_out_of_opening(const RelationCase& c, const Body& t, const Face& opening, std::optional<double> depth);

// Outward direction of a side in a frame: front is −y.
Vec2d direction_of(const Frame& frame, Side side);
// The two sides that "long" or "short" means for a body; the one side that any other word names.
std::vector<Side> sides_named(const Body& body, Side side);
// A wall's inner face, an opening or a body as an extent along an axis of the room.
Interval room_extent(const RelationCase& c, const RelationReference& reference, Axis axis);
Interval room_extent(const Body& body, Axis axis);
// Directions of rotations a and b, apart by 0–180 degrees.
double turn_between(double a_deg, double b_deg);
Vec2d front_of(const Body& body);

inline constexpr double kSpacing = 0.01;    // m: two places on the 1 cm grid may differ by one step
inline constexpr double kAngleSlack = 1.0;  // degrees
inline constexpr double kLookAngle = 15.0;  // degrees

}  // namespace layoutbox::checks
