// Layout to model: every object a recognisable piece of parametric furniture at exactly the size the solver chose.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/furnish/model.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

// How finely things are made: under half, all, or about twice the triangles. Sizes, spaces and materials are the same.
enum class Detail { kLow, kUsual, kHigh };
std::string_view name_of(Detail detail);  // "low", "usual", "high"
std::optional<Detail> detail_from_name(std::string_view name);

struct FurnishOptions {
  // Variation of details (colours, book spines); the same object always looks the same. DEFAULT: 1.
  std::uint64_t seed = 1;
  // Books in shelves, food in bowls: what a piece shows in spaces where nothing of the layout stands. DEFAULT: true.
  bool contents = true;
  // DEFAULT: kUsual. kLow is for batches that are looked at from afar.
  Detail detail = Detail::kUsual;
  // Where meshes and images of the user's own are looked for, in this order (the scene file's folder, that of --assets). Empty: none is
  // read, and what names one is drawn as its kind.
  std::vector<std::filesystem::path> asset_folders;
};

// Errors: those of read_mesh_file(), with the object's id, for meshes of the user's own.
// The furnished room: floor, one node per wall with its real openings, ceiling, one node per opening, one per object.
Result<Model> furnish(const Layout& layout, const Catalog& catalog, const FurnishOptions& options = {});

// One object alone at the origin, rotation 0 (tests, contact sheets).
Result<Model> furnish_object(const PlacedObject& object, const Catalog& catalog, const FurnishOptions& options = {});

}  // namespace layoutbox
