#include <array>

#include "layoutbox/export/formats.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/serve/call_parts.h"

namespace layoutbox::serve {
namespace {

Result<std::string> script(const Layout& layout, const Catalog& catalog, const ExportOptions& options) {
  LAYOUTBOX_ASSIGN(const Model model, furnish(layout, catalog, options.furnish));
  return write_blender_script(model, layout, catalog, {});
}

Result<std::string> json(const Layout& layout, const Catalog&, const ExportOptions&) { return write_layout(layout); }

// What the service has beside the table of formats.
constexpr std::array kOwn{ExportFormat{"json", "the layout", "application/json", json},
                          ExportFormat{"blender.py", "the script of the picture", "text/x-python; charset=utf-8", script}};

const ExportFormat* format_of(std::string_view name) {
  for (const ExportFormat& own : kOwn) {
    if (own.name == name) return &own;
  }
  return find_export_format(name);
}

}  // namespace

Result<Answer> export_call(const Json& request, const Surroundings& around) {
  LAYOUTBOX_ASSIGN(const Layout layout, layout_of(request));
  const auto format = request.at("format").get<std::string>();
  ExportOptions options;
  if (const auto detail = detail_from_name(request.value("detail", "usual"))) options.furnish.detail = *detail;
  const ExportFormat* writer = format_of(format);
  if (writer == nullptr) return fail(ErrorCode::kUsage, "there is no such format", "/format");
  LAYOUTBOX_ASSIGN(std::string bytes, writer->write(layout, around.catalog, options));
  return Answer{200, std::string(writer->media_type), std::move(bytes)};
}

}  // namespace layoutbox::serve
