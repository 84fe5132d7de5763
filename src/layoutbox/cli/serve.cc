#include "layoutbox/serve/server.h"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/model_flags.h"
#include "layoutbox/serve/page.h"

namespace layoutbox::cli {
namespace {

struct ServeArguments {
  serve::ServeOptions options;
  std::string folder, page, catalog_file;
  std::string planner = "offline";
  ModelFlags model;
  GenerateOptions generate;
};

// Where programs keep what they were given: XDG_DATA_HOME, else ~/.local/share, else here.
std::filesystem::path usual_folder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != 0) return std::filesystem::path(data) / "layoutbox";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != 0) return std::filesystem::path(home) / ".local/share/layoutbox";
  return "layoutbox-data";
}

// The page that was built beside the program: build/page of a checkout, share/layoutbox/page of an installed copy.
std::filesystem::path page_beside_program() {
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const char* place : {"../../../page", "../share/layoutbox/page"}) {
    if (std::filesystem::exists(program / place / "index.html", ignored)) return program / place;
  }
  return {};
}

int run_serve(ServeArguments& flags, const Console& console) {
  clear_up(console);
  const auto catalog = load_catalog(flags.catalog_file);
  if (!catalog) return console.fail(catalog.error());
  const auto planner = make_offline_planner(catalog->get());
  std::unique_ptr<Planner> by_model;
  if (flags.planner == "llm") {
    auto made = flags.model.make_planner("llm", catalog->get(), flags.generate, console);
    if (!made) return console.fail(made.error());
    by_model = *std::move(made);
  }
  serve::ServeOptions& options = flags.options;
  options.folder = flags.folder.empty() ? usual_folder() : std::filesystem::path(flags.folder);
  options.page = flags.page.empty() ? page_beside_program() : std::filesystem::path(flags.page);
  if (const char* token = std::getenv("LAYOUTBOX_TOKEN"); token != nullptr) options.token = token;
  options.on_ready = [&](const std::string& url) {
    if (options.page.empty() && !serve::page_is_embedded())
      console.warn("the page was left out of this build; the service runs without it");
    const std::string token = options.token.empty() ? "" : " (open it once with ?token= and the token)";
    console.say(fmt::format("Layout-in-a-Box listens at {}{}; Ctrl-C ends it", url, token));
  };
  const Status served = serve::serve({catalog->get(), *planner, &stop_flag(), {}, by_model.get()}, options);
  return served ? kDone : console.fail(served.error());
}

}  // namespace

void add_serve(CLI::App& app, Context& context) {
  auto flags = std::make_shared<ServeArguments>();
  CLI::App* command = app.add_subcommand("serve", "The studio in the browser, and the calls behind it over HTTP");
  command->add_option("--address", flags->options.address, "Where to listen; any but this machine's own needs a token in LAYOUTBOX_TOKEN")
      ->capture_default_str();
  command->add_option("--port", flags->options.port, "0: any that is free")->capture_default_str()->check(CLI::Range(0, 65535));
  command->add_option("--folder", flags->folder, "Where rooms and pictures are kept (default: the user's data folder)");
  command->add_option("--page", flags->page, "A folder with another page than the built one");
  command->add_option("--workers", flags->options.workers, "Calls that work at a time (default: one a core)")->check(CLI::Range(1, 256));
  add_catalog_option(*command, flags->catalog_file);
  command->add_option("--planner", flags->planner, "offline, or llm: who asks may choose a language model too (docs/llm.md)")
      ->capture_default_str()
      ->check(CLI::IsMember({"offline", "llm"}));
  flags->model.add_to(*command, flags->generate.repair);
  command->callback([flags, &context] { context.status = run_serve(*flags, context.console); });
}

}  // namespace layoutbox::cli
