// The table of export formats: what `layoutbox export` offers. A new format is one writer and one row here (docs/add-an-export-format.md).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/export/export.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

struct ExportOptions {
  FurnishOptions furnish;  // of formats with meshes
  FloorPlanOptions plan;   // of floor plans
};

struct ExportFormat {
  std::string_view name;         // as in --format, and the file's ending without the dot: "glb"
  std::string_view description;  // "binary glTF 2.0, y up"
  std::string_view media_type;   // as the service answers: "model/gltf-binary"
  Result<std::string> (*write)(const Layout& layout, const Catalog& catalog, const ExportOptions& options);
};

// All formats, in alphabetical order.
std::span<const ExportFormat> export_formats();

// The format of that name, case apart, or null.
const ExportFormat* find_export_format(std::string_view name);

}  // namespace layoutbox
