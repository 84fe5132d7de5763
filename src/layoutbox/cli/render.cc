#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "layoutbox/base/files.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"

namespace layoutbox::cli {
namespace {

struct RenderArguments {
  std::string layout, folder = ".", assets;
  bool no_render = false;
  RenderFlags render;
  FurnishFlags furnish;
  RenderOptions options;
};

int run_render(RenderArguments& flags, const Console& console) {
  clear_up(console);
  if (const Status ready = flags.render.apply(flags.options); !ready) return console.fail(ready.error());
  const auto layout = read_layout_file(flags.layout);
  if (!layout) return console.fail(layout.error());
  FurnishOptions furnish_options;
  if (const Status ready = flags.furnish.apply(furnish_options); !ready) return console.fail(ready.error());
  furnish_options.asset_folders = asset_folders(flags.layout, flags.assets);
  const auto model = furnish(*layout, Catalog::builtin(), furnish_options);
  if (!model) return console.fail(model.error());
  const std::filesystem::path folder = flags.folder;
  if (const Status made = make_folder(folder); !made) return console.fail(made.error());
  const std::filesystem::path script = folder / "blender.py";
  if (const Status written = write_file(script, write_blender_script(*model, *layout, Catalog::builtin(), flags.options)); !written) {
    return console.fail(written.error());
  }
  if (flags.no_render) {
    console.result(script.string(), fmt::format(R"({{"files":["blender.py"]}})"));
    return kDone;
  }
  const auto blender = find_blender();
  if (!blender) return console.fail(blender.error());
  flags.options.progress = [&console](double share) { console.progress("render", share); };
  const auto made = run_blender(*blender, script, folder, flags.options);
  if (!made) return console.fail(made.error());
  std::string files = R"("blender.py")", pictures;
  for (const std::filesystem::path& file : made->files()) files += fmt::format(R"(,"{}")", file.filename().string());
  for (const std::filesystem::path& file : made->pictures) pictures += (pictures.empty() ? "" : " ") + file.string();
  console.result(pictures, fmt::format(R"({{"files":[{}]}})", files));
  return kDone;
}

}  // namespace

void add_render(CLI::App& app, Context& context) {
  auto flags = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand("render", "Layout to blender.py, scene.blend and scene.png");
  command->add_option("layout", flags->layout, "layout.json; - reads stdin")->required();
  command->add_option("-o,--output", flags->folder, "Folder for the files (default: this folder)");
  command->add_flag("--no-render", flags->no_render, "Write blender.py only: no Blender is needed");
  command->add_option("--assets", flags->assets, "Folder that meshes and images are named from (default: the layout's)");
  flags->render.add_to(*command);
  flags->furnish.add_to(*command);
  command->callback([flags, &context] { context.status = run_render(*flags, context.console); });
}

}  // namespace layoutbox::cli
