#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"

namespace layoutbox::cli {
namespace {

struct Flags {
  std::string layout, output, format;
};

Result<std::string> export_as(const std::string& format, const Layout& layout) {
  if (format == "svg") return write_floor_plan_svg(layout);
  if (format == "glb") {
    LAYOUTBOX_ASSIGN(const Model model, furnish(layout, Catalog::builtin()));
    return write_glb(model, layout);
  }
  return layoutbox::fail(ErrorCode::kUsage, fmt::format("there is no format '{}'", format), "--format", "use glb or svg");
}

int run(const Flags& flags, const Console& console) {
  std::string format = flags.format;
  if (format.empty() && flags.output != "-") {
    format = std::filesystem::path(flags.output).extension().string();
    if (!format.empty()) format.erase(0, 1);
  }
  const auto layout = read_layout_file(flags.layout);
  if (!layout) return console.fail(layout.error());
  const auto bytes = export_as(format, *layout);
  if (!bytes) return console.fail(bytes.error());
  const Status written = write_output(flags.output, *bytes);
  return written ? kDone : console.fail(written.error());
}

}  // namespace

void add_export(CLI::App& app, Context& context) {
  auto flags = std::make_shared<Flags>();
  CLI::App* command = app.add_subcommand("export", "Layout to other tools' files: glb (3D), svg (floor plan)");
  command->add_option("layout", flags->layout, "layout.json; - reads stdin")->required();
  command->add_option("--format", flags->format, "glb or svg (default: the output's ending)");
  command->add_option("-o,--output", flags->output, "The file to write; - writes to stdout")->required();
  command->callback([flags, &context] { context.status = run(*flags, context.console); });
}

}  // namespace layoutbox::cli
