#include "layoutbox/scene/relation_table.h"

#include <array>

#include "layoutbox/scene/name_tables.h"

namespace layoutbox {
namespace {

using enum RelationGroup;
using enum RelationArity;

// "gap=0.02, side" → "gap=0.02" now, "side" later.
constexpr std::string_view next_item(std::string_view& rest) {
  const std::size_t comma = rest.find(", ");
  const std::string_view item = rest.substr(0, comma);
  rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 2);
  return item;
}
constexpr std::string_view key_in(std::string_view item) { return item.substr(0, item.find('=')); }

// "0.02" metres → 20. What it cannot read does not compile.
consteval Mm millimetres(std::string_view metres) {
  Mm length = 0, unit = 1000;
  bool whole = true;
  for (const char c : metres) {
    if (c == '.' && whole) {
      whole = false;
    } else if (c >= '0' && c <= '9' && (whole || unit > 1)) {
      if (!whole) unit /= 10;
      length = whole ? 10 * length + 1000 * (c - '0') : length + unit * (c - '0');
    } else {
      throw "no length of whole millimetres";
    }
  }
  return length;
}

template <class Enum, std::size_t N>
consteval Enum named(const std::string_view (&names)[N], std::string_view name) {
  for (std::size_t i = 0; i < N; ++i) {
    if (names[i] == name) return static_cast<Enum>(i);
  }
  throw "no such value";
}

consteval RelationFigures defaults_in(std::string_view parameters) {
  RelationFigures out;
  while (!parameters.empty()) {
    const std::string_view item = next_item(parameters), name = key_in(item);
    if (name == item) continue;  // it has none
    const std::string_view value = item.substr(name.size() + 1);
    if (name == "min") {
      out.min = millimetres(value);
    } else if (name == "max") {
      out.max = millimetres(value);
    } else if (name == "gap") {
      out.gap = millimetres(value);
    } else if (name == "width") {
      out.width = millimetres(value);
    } else if (name == "side") {
      out.side = named<Side>(kSideNames, value);
    } else if (name == "edge") {
      out.edge = named<Edge>(kEdgeNames, value);
    } else if (name == "axis" && value == "x") {
      out.axis = Axis::kX;
    } else {
      throw "no parameter that can have a default";
    }
  }
  return out;
}

constexpr std::array kRows{
#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) \
  RelationRow{RelationType::k##name, json_name, group, arity, kinds, parameters, defaults_in(parameters), sentence},
#include "layoutbox/scene/relation_list.inc"
#undef LAYOUTBOX_RELATION
};

}  // namespace

std::span<const RelationRow> relation_table() { return kRows; }

const RelationRow& relation_row(RelationType type) { return kRows[static_cast<std::size_t>(type)]; }

const RelationRow* find_relation(std::string_view name) {
  for (const RelationRow& row : kRows) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

bool RelationRow::reads(std::string_view parameter) const {
  for (std::string_view rest = parameters; !rest.empty();) {
    if (key_in(next_item(rest)) == parameter) return true;
  }
  return false;
}

}  // namespace layoutbox
