#include "layoutbox/pipeline/run_pictures.h"

#include <fmt/format.h>

#include "layoutbox/base/files.h"
#include "layoutbox/pipeline/variants.h"

namespace layoutbox {
namespace {

Result<RenderOutputs> draw(const std::filesystem::path& script, const std::filesystem::path& into, const GenerateOptions& options) {
  if (options.draw) return options.draw(script, into, options.render);
  LAYOUTBOX_ASSIGN(const Blender blender, find_blender());  // one that is started for this room alone
  return run_blender(blender, script, into, options.render);
}

Drawn told_of(const std::string& names, const RenderOutputs& made, const RenderOptions& options) {
  return {fmt::format("{}{}×{}, Blender {}", names, options.width, options.height, made.blender_version), made.blender_version};
}

}  // namespace

Result<Drawn> draw_pictures(RunFolder& folder, std::size_t variant, const GenerateOptions& options) {
  const std::filesystem::path script = folder.path() / variant_name("blender.py", variant);
  std::string names;
  if (variant == 0) {
    LAYOUTBOX_ASSIGN(const RenderOutputs made, draw(script, folder.path(), options));
    for (const auto& file : made.files()) folder.add(file.filename().string());
    for (const auto& file : made.pictures) names += file.filename().string() + " ";
    return told_of(names, made, options.render);
  }
  // Blender writes the same names each time, so each of the others is drawn elsewhere.
  LAYOUTBOX_ASSIGN(const TemporaryFolder place, TemporaryFolder::make("variant"));
  LAYOUTBOX_ASSIGN(const RenderOutputs made, draw(script, place.path(), options));
  for (const auto& file : made.files()) {
    LAYOUTBOX_ASSIGN(const std::string bytes, read_file(file));
    LAYOUTBOX_CHECK(folder.write(variant_name(file.filename().string(), variant), bytes));
  }
  for (const auto& file : made.pictures) names += variant_name(file.filename().string(), variant) + " ";
  return told_of(names, made, options.render);
}

}  // namespace layoutbox
