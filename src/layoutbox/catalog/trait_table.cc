#include "layoutbox/catalog/trait_table.h"

#include <array>

namespace layoutbox {
namespace {

constexpr std::array kRows{
#define LAYOUTBOX_TRAIT(name, json_name, meaning) TraitRow{Trait::k##name, json_name, meaning},
#include "layoutbox/catalog/trait_list.inc"
#undef LAYOUTBOX_TRAIT
};
static_assert(kRows.size() <= 64, "Traits holds them in 64 bits");

}  // namespace

std::span<const TraitRow> trait_table() { return kRows; }

std::optional<Trait> trait_from_name(std::string_view name) {
  for (const TraitRow& row : kRows) {
    if (row.name == name) return row.trait;
  }
  return std::nullopt;
}

}  // namespace layoutbox
