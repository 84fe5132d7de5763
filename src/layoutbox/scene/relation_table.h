// The one table of relations: names, what they relate, their parameters and the sentence that says them.
#pragma once

#include <span>
#include <string_view>

#include "layoutbox/scene/relation_parameters.h"

namespace layoutbox {

enum class RelationType {
#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) k##name,
#include "layoutbox/scene/relation_list.inc"
#undef LAYOUTBOX_RELATION
};

enum class RelationGroup { kPaper, kRoomGroup, kOpeningGroup, kPairGroup, kHeightGroup, kGroupGroup, kSpaceGroup };

// How many references (relativeTo) a relation takes. kOptional with none given means "any" (any wall, any corner, any window).
enum class RelationArity { kNone, kOptional, kOne, kMany };

// What a reference may name; a set of flags.
enum ReferenceKind : unsigned { kObject = 1, kWall = 2, kOpening = 4, kRoom = 8 };

struct RelationRow {
  RelationType type;
  std::string_view name;  // as in JSON: "againstWall"
  RelationGroup group;
  RelationArity arity;
  unsigned reference_kinds;     // flags of ReferenceKind
  std::string_view parameters;  // "gap=0.02, side": the parameters it reads and their defaults (metres)
  RelationFigures defaults;     // the same, read when this is compiled
  std::string_view sentence;    // "{targets} stands with its back against {references}"

  bool reads(std::string_view parameter) const;
};

// All rows, in the order of the enum.
std::span<const RelationRow> relation_table();

const RelationRow& relation_row(RelationType type);

// The row of that JSON name; `in` and the paper's `inside` are two names, everything else has one.
const RelationRow* find_relation(std::string_view name);

}  // namespace layoutbox
