// What relations have to do with one another, and how they are meant; a typed row for each (relation_traits.cc).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/scene/relation_table.h"

namespace layoutbox {

struct Relation;

// A set of relations.
class RelationSet {
 public:
  constexpr RelationSet() = default;
  template <class... Types>
  explicit constexpr RelationSet(Types... types) : bits_((std::uint64_t{0} | ... | (std::uint64_t{1} << static_cast<unsigned>(types)))) {}
  constexpr bool has(RelationType type) const { return ((bits_ >> static_cast<unsigned>(type)) & 1) != 0; }
  friend constexpr RelationSet operator|(RelationSet a, RelationSet b) {
    a.bits_ |= b.bits_;
    return a;
  }

 private:
  std::uint64_t bits_ = 0;
};

// Where a relation puts its targets; of one kind only one can hold between the same two things.
enum class Placing : std::uint8_t { kAnywhere, kSide, kHeight, kInRoom };

struct RelationTraits {
  RelationType type;
  bool symmetric = false;          // t R r says the same as r R t
  bool supports = false;           // the reference carries the target
  bool rests = false;              // … by itself: on it or in it
  bool targets_turned = false;     // the solver's cases are right for targets at odd angles,
  bool references_turned = false;  // and for references; of the others it sees the box around them
  bool of_group = false;           // speaks of its targets together
  bool order_only = false;         // how its targets stand to each other, not where they are
  bool turns = false;              // which way its targets look, not where they are
  bool looks = false;              // … and that to the very side
  bool close_by = false;           // its targets are by its references, whichever way
  bool keeps_off = false;          // how far its targets are from its references, whichever way
  bool sideways = false;           // to the left or right of its reference
  bool beside = false;             // its targets stand beside its references, on one floor
  bool around = false;             // on all sides of its reference, looking at it
  bool brings = false;             // its targets belong to its reference: a chair to the table where it stands
  bool back_to_wall = false;       // its targets turn their backs to a wall
  bool of_any_two = false;         // may be asked of any two things, whatever they are
  bool in_pairs = false;           // as many targets as references at least
  int least_references = 0;        // fewer of those that were named say nothing
  Placing placing = Placing::kAnywhere;
  std::optional<RelationType> inverse = std::nullopt;  // t R r is r I t, where both look the same way
  RelationSet excludes = {};                           // none of these holds between the same two things
  RelationSet weaker = {};                             // these hold too, with their defaults (between things without other parameters)
  RelationSet said_by = {};                            // who says one of these may mean this one
  std::optional<RelationType> instead = std::nullopt;  // what to try where it cannot be
  std::string_view unnamed = {};                       // what is meant where no reference is named; empty: by the kind of its references
};

const RelationTraits& traits_of(RelationType type);

// All that are so.
RelationSet relations_that(bool RelationTraits::*so);
template <bool RelationTraits::*so>
RelationSet relations_that() {
  static const RelationSet all = relations_that(so);
  return all;
}

// Is that what it says, or does that follow from it?
bool says_too(RelationType type, RelationType other);

// What is meant where a relation names no reference: "a wall", "the windows".
std::string_view unnamed_reference(RelationType type);

// Can the two not hold between the same two things at once? Of one that names a wall: not with two walls.
bool are_opposed(RelationType a, RelationType b);

// Takes those that are not there out of a relation; false where it says nothing without them.
bool take_out(Relation& relation, const std::vector<std::string>& ids);

}  // namespace layoutbox
