#include "layoutbox/export/formats.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"

namespace layoutbox::cli {
namespace {

struct ExportArguments {
  std::string layout, output, format, assets;
  double dots_per_inch = FloorPlanOptions{}.dots_per_inch;
  FurnishFlags furnish;
};

std::string format_names() {
  std::string names;
  for (const ExportFormat& format : export_formats()) names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
  return names;
}

// By --format, else by the output's ending.
Result<const ExportFormat*> choose_format(const ExportArguments& flags) {
  std::string name = flags.format;
  if (name.empty()) name = std::filesystem::path(flags.output).extension().string();
  if (name.starts_with('.')) name.erase(0, 1);
  if (const ExportFormat* format = find_export_format(name)) return format;
  const std::string what = name.empty() ? "which format to write is not said" : fmt::format("there is no export format '{}'", name);
  return layoutbox::fail(ErrorCode::kUsage, what, "--format", "use one of: " + format_names());
}

Status export_file(const ExportArguments& flags) {
  LAYOUTBOX_ASSIGN(const ExportFormat* format, choose_format(flags));
  LAYOUTBOX_ASSIGN(const Layout layout, read_layout_file(flags.layout));
  ExportOptions options;
  options.plan.dots_per_inch = flags.dots_per_inch;
  options.furnish.asset_folders = asset_folders(flags.layout, flags.assets);
  LAYOUTBOX_CHECK(flags.furnish.apply(options.furnish));
  LAYOUTBOX_ASSIGN(const std::string bytes, format->write(layout, Catalog::builtin(), options));
  return write_output(flags.output, bytes);
}

int run_export(const ExportArguments& flags, const Console& console) {
  const Status done = export_file(flags);
  return done ? kDone : console.fail(done.error());
}

}  // namespace

void add_export(CLI::App& app, Context& context) {
  auto flags = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Layout to other tools' files: " + format_names());
  command->add_option("layout", flags->layout, "layout.json; - reads stdin")->required();
  command->add_option("--format", flags->format, "One of: " + format_names() + " (default: the output's ending)");
  command->add_option("-o,--output", flags->output, "The file to write; - writes to stdout")->required();
  command->add_option("--assets", flags->assets, "Folder that meshes and images are named from (default: the layout's)");
  command->add_option("--dpi", flags->dots_per_inch, "Dots per inch of a floor plan as PNG")
      ->capture_default_str()
      ->check(CLI::Range(10, 2000));
  flags->furnish.add_to(*command);
  command->callback([flags, &context] { context.status = run_export(*flags, context.console); });
}

}  // namespace layoutbox::cli
