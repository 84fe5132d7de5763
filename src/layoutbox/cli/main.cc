#include <unistd.h>

#include <array>
#include <new>
#include <sstream>
#include <string>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/config_file.h"

namespace layoutbox::cli {
namespace {

void add_common_options(CLI::App& app, Console& console) {
  app.add_flag("--json", console.json, "Machine-readable result on stdout, nothing else there");
  app.add_flag("-q,--quiet", console.quiet, "Say only what went wrong");
  app.add_flag("-v,--verbose", console.verbosity, "Say more: what was filled in or assumed");
}

// --json must hold for errors of the command line itself, which end parsing before the flag is read.
bool asks_for_json(int count, char** arguments) {
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--") return false;
    if (argument == "--json") return true;
  }
  return false;
}

// CLI11 says only that a command is missing, also where one was given that does not exist.
std::string words_for(const CLI::App& app, const CLI::ParseError& error) {
  if (app.get_subcommands().empty()) {
    for (const std::string& word : app.remaining()) {
      if (!word.starts_with('-')) return "there is no command \"" + word + "\"";
    }
  }
  return error.what();
}

int run(int count, char** arguments) {
  CLI::App app{"Layout-in-a-Box: text in, furnished and checked 3D room out", "layoutbox"};
  app.set_version_flag("--version", std::string(program_version()));
  app.require_subcommand(1);
  app.fallthrough();
  Context context;
  add_common_options(app, context.console);
  add_config_option(app);
  for (const auto add : {add_generate, add_batch, add_edit, add_plan, add_solve, add_render, add_export, add_verify, add_judge,
                         add_experiment, add_serve, add_mcp, add_validate, add_catalog, add_cache, add_doctor}) {
    add(app, context);
  }
  try {
    app.parse(count, arguments);
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream text;
    app.exit(success, text, text);
    const std::string_view said = text.view().substr(0, text.view().find_last_not_of('\n') + 1);
    context.console.result(said, said);
    return kDone;
  } catch (const CLI::ParseError& error) {
    context.console.json = asks_for_json(count, arguments);
    return context.console.fail(
        {ErrorCode::kUsage, words_for(app, error), {}, "layoutbox --help lists the commands, layoutbox COMMAND --help its options", {}});
  }
  return context.status;
}

}  // namespace
}  // namespace layoutbox::cli

// Whatever thread wants more than there is: files are whole or not there, so that the end may come at any moment.
[[noreturn]] void end_without_memory() {
  constexpr std::string_view kWords = "layoutbox: there is not enough memory\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kWords.data(), kWords.size());
  ::_exit(layoutbox::cli::kWrongSurroundings);
}

int main(int count, char** arguments) {
  std::set_new_handler(end_without_memory);
  layoutbox::cli::install_signal_handlers();
  return layoutbox::cli::status_with_output(layoutbox::cli::run(count, arguments));
}
