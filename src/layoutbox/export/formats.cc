#include "layoutbox/export/formats.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace layoutbox {
namespace {

Result<std::string> glb(const Layout& layout, const Catalog& catalog, const ExportOptions& options) {
  LAYOUTBOX_ASSIGN(const Model model, furnish(layout, catalog, options.furnish));
  return write_glb(model, layout);
}

Result<std::string> pdf(const Layout& layout, const Catalog& catalog, const ExportOptions& options) {
  return write_floor_plan_pdf(layout, catalog, options.plan);
}

Result<std::string> png(const Layout& layout, const Catalog& catalog, const ExportOptions& options) {
  return write_floor_plan_png(layout, catalog, options.plan);
}

Result<std::string> svg(const Layout& layout, const Catalog& catalog, const ExportOptions& options) {
  return write_floor_plan_svg(layout, catalog, options.plan);
}

constexpr std::array kFormats{
    ExportFormat{"glb", "binary glTF 2.0 with meshes, materials and lights; y up, metres", "model/gltf-binary", glb},
    ExportFormat{"pdf", "the floor plan as PDF, to scale on A4", "application/pdf", pdf},
    ExportFormat{"png", "the floor plan as a picture, 2339 × 1654 at 200 dots per inch", "image/png", png},
    ExportFormat{"svg", "floor plan with names, sizes, door swings and a scale bar", "image/svg+xml", svg},
};

}  // namespace

std::span<const ExportFormat> export_formats() { return kFormats; }

const ExportFormat* find_export_format(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const ExportFormat& format) { return format.name == lower; });
  return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace layoutbox
