#include <fmt/format.h>

#include <memory>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::cli {
namespace {

struct ValidateArguments {
  std::string file, units;
};

// What kind of document it is, once it has been read without error; the notes say what was read in another way than written.
Result<std::string> validate(const std::string& text, const ValidateArguments& flags, const Console& console) {
  LAYOUTBOX_ASSIGN(const std::string kind, kind_of_document(text));
  if (kind == "layout") {
    LAYOUTBOX_ASSIGN([[maybe_unused]] const Layout layout, read_layout(text));
    return kind;
  }
  LAYOUTBOX_ASSIGN(SceneGraph scene, read_scene(text, flags.units));
  LAYOUTBOX_ASSIGN(scene, normalize_scene(std::move(scene), Catalog::builtin()));
  console.notes(scene.notes);
  return kind;
}

int run_validate(const ValidateArguments& flags, const Console& console) {
  const auto text = read_input(flags.file);
  if (!text) return console.fail(text.error());
  const auto kind = validate(*text, flags, console);
  if (!kind) return console.fail(in_file(kind.error(), flags.file));
  console.result(fmt::format("{}: a good {} file", flags.file, *kind), fmt::format(R"({{"valid":true,"kind":"{}"}})", *kind));
  return kDone;
}

}  // namespace

void add_validate(CLI::App& app, Context& context) {
  auto flags = std::make_shared<ValidateArguments>();
  CLI::App* command = app.add_subcommand("validate", "Is this a good scene or layout file? All errors, each with its place");
  command->add_option("file", flags->file, "scene.json or layout.json; - reads stdin")->required();
  command->add_option("--units", flags->units, "Units of a file that names none: m, cm, mm, ft, in");
  command->callback([flags, &context] { context.status = run_validate(*flags, context.console); });
}

}  // namespace layoutbox::cli
