#include "layoutbox/scene/relation_traits.h"

#include <algorithm>
#include <array>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {
namespace {

using R = RelationType;

// Distances are to what lies within a turned body; angles, middles and extents along the room's axes are what they are; what stands on
// others stays within their turned tops: those are right at odd angles.
constexpr std::array kTraits = std::to_array<RelationTraits>({
    {.type = R::kOffset, .targets_turned = true, .references_turned = true},
    {.type = R::kAlign, .targets_turned = true, .references_turned = true, .unnamed = "one another"},
    {.type = R::kInside},
    {.type = R::kGroupAlign, .targets_turned = true, .references_turned = true, .of_group = true},
    {.type = R::kAgainstWall,
     .targets_turned = true,
     .back_to_wall = true,
     .placing = Placing::kInRoom,
     .said_by = RelationSet(R::kCenteredOnWall, R::kSideAgainstWall, R::kCorner, R::kUnderWindow, R::kOnWall)},
    {.type = R::kSideAgainstWall, .targets_turned = true},
    {.type = R::kCorner, .back_to_wall = true, .placing = Placing::kInRoom, .unnamed = "the room"},
    {.type = R::kCenterOfRoom,
     .targets_turned = true,
     .references_turned = true,
     .of_group = true,
     .placing = Placing::kInRoom,
     .said_by = RelationSet(R::kInside)},
    {.type = R::kCenteredOnWall,
     .targets_turned = true,
     .back_to_wall = true,
     .placing = Placing::kInRoom,
     .weaker = RelationSet(R::kAgainstWall),
     .instead = R::kAgainstWall},
    {.type = R::kInRegion, .targets_turned = true, .references_turned = true},
    {.type = R::kOnWall, .targets_turned = true, .weaker = RelationSet(R::kAgainstWall)},
    {.type = R::kOnCeiling, .targets_turned = true, .references_turned = true},
    {.type = R::kAwayFromWall, .targets_turned = true, .references_turned = true, .unnamed = "the walls"},
    {.type = R::kUnderWindow, .back_to_wall = true, .unnamed = "a window"},
    {.type = R::kNearDoor, .targets_turned = true, .references_turned = true, .close_by = true, .unnamed = "a door"},
    {.type = R::kNearWindow, .targets_turned = true, .references_turned = true, .close_by = true, .unnamed = "a window"},
    {.type = R::kFarFromDoor, .targets_turned = true, .references_turned = true, .keeps_off = true, .unnamed = "the doors"},
    {.type = R::kFarFromWindow, .targets_turned = true, .references_turned = true, .keeps_off = true, .unnamed = "the windows"},
    {.type = R::kNotBlocking, .targets_turned = true, .unnamed = "the doors and windows"},
    {.type = R::kLeftOf,
     .targets_turned = true,
     .sideways = true,
     .beside = true,
     .of_any_two = true,
     .placing = Placing::kSide,
     .inverse = R::kRightOf,
     .instead = R::kRightOf},
    {.type = R::kRightOf,
     .targets_turned = true,
     .sideways = true,
     .beside = true,
     .of_any_two = true,
     .placing = Placing::kSide,
     .inverse = R::kLeftOf,
     .instead = R::kLeftOf},
    {.type = R::kInFrontOf,
     .targets_turned = true,
     .beside = true,
     .of_any_two = true,
     .placing = Placing::kSide,
     .inverse = R::kBehind,
     .said_by = RelationSet(R::kAtFootOf, R::kTuckedUnder, R::kOpposite, R::kFacing),
     .instead = R::kBehind},
    {.type = R::kBehind,
     .targets_turned = true,
     .beside = true,
     .of_any_two = true,
     .placing = Placing::kSide,
     .inverse = R::kInFrontOf,
     .instead = R::kInFrontOf},
    {.type = R::kNextTo,
     .symmetric = true,
     .targets_turned = true,
     .references_turned = true,
     .close_by = true,
     .beside = true,
     .of_any_two = true,
     .said_by =
         RelationSet(R::kLeftOf, R::kRightOf, R::kTouching, R::kEachSideOf, R::kAlongSide, R::kAtHeadOf, R::kAtFootOf, R::kPairedWith),
     .instead = R::kNear},
    {.type = R::kNear,
     .symmetric = true,
     .targets_turned = true,
     .references_turned = true,
     .close_by = true,
     .said_by = RelationSet(R::kNextTo, R::kLeftOf, R::kRightOf, R::kInFrontOf, R::kAlongSide, R::kTouching, R::kEachSideOf)},
    {.type = R::kFar,
     .symmetric = true,
     .targets_turned = true,
     .references_turned = true,
     .keeps_off = true,
     .of_any_two = true,
     .excludes = RelationSet(R::kNextTo, R::kNear),
     .instead = R::kNear},
    {.type = R::kDistance, .symmetric = true, .targets_turned = true, .references_turned = true, .keeps_off = true},
    {.type = R::kTouching, .symmetric = true, .weaker = RelationSet(R::kNextTo), .instead = R::kNextTo},
    {.type = R::kEdgeAlign, .targets_turned = true},
    {.type = R::kFacing,
     .targets_turned = true,
     .references_turned = true,
     .turns = true,
     .looks = true,
     .said_by = RelationSet(R::kOpposite, R::kInFrontOf)},
    {.type = R::kOpposite,
     .symmetric = true,
     .targets_turned = true,
     .keeps_off = true,
     .excludes = RelationSet(R::kNextTo),
     .said_by = RelationSet(R::kFacing)},
    {.type = R::kParallel, .symmetric = true, .targets_turned = true, .references_turned = true, .turns = true},
    {.type = R::kPerpendicular, .symmetric = true, .targets_turned = true, .references_turned = true, .turns = true},
    {.type = R::kSameOrientation, .symmetric = true, .targets_turned = true, .references_turned = true, .turns = true, .looks = true},
    {.type = R::kCenteredOn, .targets_turned = true},
    {.type = R::kAtFootOf, .targets_turned = true, .weaker = RelationSet(R::kInFrontOf, R::kNextTo), .instead = R::kNextTo},
    {.type = R::kAtHeadOf, .excludes = RelationSet(R::kAtFootOf), .weaker = RelationSet(R::kNextTo), .instead = R::kNextTo},
    {.type = R::kAlongSide, .weaker = RelationSet(R::kNextTo), .instead = R::kNextTo},
    {.type = R::kTuckedUnder, .brings = true},
    {.type = R::kOn,
     .supports = true,
     .rests = true,
     .targets_turned = true,
     .references_turned = true,
     .placing = Placing::kHeight,
     .excludes = RelationSet(R::kNextTo),
     .said_by = RelationSet(R::kIn, R::kStacked)},
    {.type = R::kUnder, .targets_turned = true, .placing = Placing::kHeight},
    {.type = R::kAbove,
     .targets_turned = true,
     .placing = Placing::kHeight,
     .excludes = RelationSet(R::kNextTo),
     .said_by = RelationSet(R::kOnCeiling)},
    {.type = R::kIn, .supports = true, .rests = true, .targets_turned = true, .references_turned = true, .said_by = RelationSet(R::kOn)},
    {.type = R::kStacked,
     .supports = true,
     .targets_turned = true,
     .references_turned = true,
     .of_group = true,
     .weaker = RelationSet(R::kOn),
     .unnamed = "one another"},
    {.type = R::kAround,
     .targets_turned = true,
     .of_group = true,
     .around = true,
     .brings = true,
     .weaker = RelationSet(R::kNextTo),
     .said_by = RelationSet(R::kSurround, R::kTuckedUnder, R::kInFrontOf, R::kAlongSide)},
    {.type = R::kEachSideOf,
     .of_group = true,
     .beside = true,
     .said_by = RelationSet(R::kLeftOf, R::kRightOf, R::kNextTo, R::kSymmetricAbout)},
    {.type = R::kBetween, .beside = true, .least_references = 2},
    {.type = R::kRow, .of_group = true, .order_only = true, .said_by = RelationSet(R::kGroupAlign, R::kEvenlySpaced, R::kGrid)},
    {.type = R::kGrid, .of_group = true, .order_only = true},
    {.type = R::kColumn, .of_group = true, .order_only = true},
    {.type = R::kEvenlySpaced, .of_group = true, .order_only = true},
    {.type = R::kSymmetricAbout, .of_group = true},
    {.type = R::kSurround,
     .targets_turned = true,
     .of_group = true,
     .around = true,
     .brings = true,
     .weaker = RelationSet(R::kNextTo, R::kFacing)},
    {.type = R::kPairedWith, .of_group = true, .brings = true, .in_pairs = true},
    {.type = R::kClearance},
    {.type = R::kReachable},
    {.type = R::kKeepClear, .targets_turned = true, .unnamed = "that part of the room"},
});

constexpr bool in_order() {
  for (std::size_t i = 0; i < kTraits.size(); ++i) {
    if (static_cast<std::size_t>(kTraits[i].type) != i) return false;
  }
  return true;
}
static_assert(in_order(), "a row for each relation, in the order of relation_list.inc");
static_assert(kTraits.size() == std::size_t{0}
#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) +1
#include "layoutbox/scene/relation_list.inc"
#undef LAYOUTBOX_RELATION
              && kTraits.size() <= 64);

}  // namespace

const RelationTraits& traits_of(RelationType type) { return kTraits[static_cast<std::size_t>(type)]; }

RelationSet relations_that(bool RelationTraits::*so) {
  RelationSet all;
  for (const RelationTraits& row : kTraits) {
    if (row.*so) all = all | RelationSet(row.type);
  }
  return all;
}

std::string_view unnamed_reference(RelationType type) {
  if (const std::string_view said = traits_of(type).unnamed; !said.empty()) return said;
  const auto kinds = relation_row(type).reference_kinds;
  return kinds & kWall ? "a wall" : kinds & kOpening ? "an opening" : "the room";
}

bool says_too(RelationType type, RelationType other) { return type == other || traits_of(type).weaker.has(other); }

bool are_opposed(RelationType a, RelationType b) {
  const Placing one = traits_of(a).placing, other = traits_of(b).placing;
  if (a == b) return one == Placing::kInRoom && (relation_row(a).reference_kinds & kWall) != 0;  // at two walls
  const bool excluded = traits_of(a).excludes.has(b) || traits_of(b).excludes.has(a);
  return excluded || (one != Placing::kAnywhere && one == other);
}

bool take_out(Relation& relation, const std::vector<std::string>& ids) {
  const auto is_out = [&](const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  const bool referred = !relation.references.empty();
  const std::size_t lost_targets = std::erase_if(relation.targets, is_out);
  const std::size_t lost_references = std::erase_if(relation.references, is_out);
  if (lost_targets + lost_references == 0) return true;
  const RelationTraits& traits = traits_of(relation.type);
  const bool too_few = lost_references > 0 && static_cast<int>(relation.references.size()) < traits.least_references;
  const bool no_pairs = traits.in_pairs && lost_targets > 0 && relation.targets.size() < relation.references.size();
  const RelationArity arity = relation_row(relation.type).arity;
  const bool among_themselves = !referred && (arity == RelationArity::kOne || arity == RelationArity::kMany);
  const bool alone = among_themselves && relation.targets.size() < 2;
  return !relation.targets.empty() && !(referred && relation.references.empty()) && !too_few && !no_pairs && !alone;
}

}  // namespace layoutbox
