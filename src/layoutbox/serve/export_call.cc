#include <array>

#include "layoutbox/export/formats.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/serve/call_parts.h"

namespace layoutbox::serve {
namespace {

struct FileType {
  std::string_view format, type;
};

constexpr std::array kTypes{FileType{"glb", "model/gltf-binary"}, FileType{"svg", "image/svg+xml"},
                            FileType{"pdf", "application/pdf"},   FileType{"png", "image/png"},
                            FileType{"json", "application/json"}, FileType{"blender.py", "text/x-python; charset=utf-8"}};

Result<std::string> file_of(const Layout& layout, std::string_view format, const ExportOptions& options, const Catalog& catalog) {
  if (format == "json") return write_layout(layout);
  if (format == "blender.py") {
    LAYOUTBOX_ASSIGN(const Model model, furnish(layout, catalog, options.furnish));
    return write_blender_script(model, layout, {});
  }
  const ExportFormat* writer = find_export_format(format);
  if (writer == nullptr) return fail(ErrorCode::kUsage, "there is no such format", "/format");
  return writer->write(layout, catalog, options);
}

}  // namespace

Result<Answer> export_call(const Json& request, const Surroundings& around) {
  LAYOUTBOX_ASSIGN(const Layout layout, layout_of(request));
  const auto format = request.at("format").get<std::string>();
  ExportOptions options;
  if (const auto detail = detail_from_name(request.value("detail", "usual"))) options.furnish.detail = *detail;
  LAYOUTBOX_ASSIGN(std::string bytes, file_of(layout, format, options, around.catalog));
  Answer answer{200, "application/octet-stream", std::move(bytes)};
  for (const FileType& row : kTypes) {
    if (row.format == format) answer.type = row.type;
  }
  return answer;
}

}  // namespace layoutbox::serve
