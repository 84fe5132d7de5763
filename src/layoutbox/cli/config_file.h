// --config FILE: options from a file, by their long names.
#pragma once

#include <CLI/CLI.hpp>

namespace layoutbox::cli {

// Adds --config to the program. The file is TOML (`seed = 3`) or a JSON object ({"seed": 3}); what stands in it holds where the command
// line does not say otherwise. Options of other commands are left alone, so that one file serves all; [section]s named after a command
// hold for that command only. A name that no command knows is an error.
void add_config_option(CLI::App& app);

}  // namespace layoutbox::cli
