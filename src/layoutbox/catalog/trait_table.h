// The traits there are (trait_list.inc).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "layoutbox/catalog/traits.h"

namespace layoutbox {

enum class Trait : std::uint8_t {
#define LAYOUTBOX_TRAIT(name, json_name, meaning) k##name,
#include "layoutbox/catalog/trait_list.inc"
#undef LAYOUTBOX_TRAIT
};

struct TraitRow {
  Trait trait;
  std::string_view name;     // as in the catalogue's JSON: "tableSeat"
  std::string_view meaning;  // in English
};

// All rows, in the order of the enum.
std::span<const TraitRow> trait_table();

std::optional<Trait> trait_from_name(std::string_view name);

}  // namespace layoutbox
