// One function per subcommand: adds it to the application; its callback runs it and leaves the exit status in the context.
#pragma once

#include <CLI/CLI.hpp>

#include "layoutbox/cli/console.h"

namespace layoutbox::cli {

struct Context {
  Console console;
  int status = kDone;
};

void add_generate(CLI::App& app, Context& context);
void add_batch(CLI::App& app, Context& context);
void add_edit(CLI::App& app, Context& context);
void add_plan(CLI::App& app, Context& context);
void add_solve(CLI::App& app, Context& context);
void add_render(CLI::App& app, Context& context);
void add_export(CLI::App& app, Context& context);
void add_verify(CLI::App& app, Context& context);
void add_judge(CLI::App& app, Context& context);
void add_experiment(CLI::App& app, Context& context);
void add_validate(CLI::App& app, Context& context);
void add_catalog(CLI::App& app, Context& context);
void add_serve(CLI::App& app, Context& context);
void add_mcp(CLI::App& app, Context& context);
void add_cache(CLI::App& app, Context& context);
void add_doctor(CLI::App& app, Context& context);

}  // namespace layoutbox::cli
