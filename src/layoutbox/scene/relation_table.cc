#include "layoutbox/scene/relation_table.h"

#include <array>
#include <charconv>

namespace layoutbox {
namespace {

using enum RelationGroup;
using enum RelationArity;

constexpr std::array kRows{
#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) \
  RelationRow{RelationType::k##name, json_name, group, arity, kinds, parameters, sentence},
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
  std::string_view rest = parameters;
  for (std::size_t at = 0; at != std::string_view::npos; rest.remove_prefix(at + 2)) {
    at = rest.find(", ");
    const std::string_view item = rest.substr(0, at);
    if (item.substr(0, item.find('=')) == parameter) return true;
    if (at == std::string_view::npos) break;
  }
  return false;
}

std::optional<double> relation_default(RelationType type, std::string_view parameter) {
  std::string_view rest = relation_row(type).parameters;
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    std::string_view item = rest.substr(0, comma);
    rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
    while (item.starts_with(' ')) item.remove_prefix(1);
    if (!item.starts_with(parameter) || item.size() <= parameter.size() || item[parameter.size()] != '=') continue;
    item.remove_prefix(parameter.size() + 1);
    double value = 0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
    if (error == std::errc{} && end == item.data() + item.size()) return value;
  }
  return std::nullopt;
}

}  // namespace layoutbox
