#include "layoutbox/serve/mcp.h"

#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"

namespace layoutbox::cli {
namespace {

int run_mcp(const std::string& catalog_file, const Console& console) {
  const auto catalog = load_catalog(catalog_file);
  if (!catalog) return console.fail(catalog.error());
  const auto planner = make_offline_planner(catalog->get());
  const serve::McpSession session({catalog->get(), *planner, &stop_flag()});
  std::string line;
  while (!stop_flag() && std::getline(std::cin, line)) {
    if (line.empty()) continue;
    const auto answer = session.answer(line);
    if (!answer) continue;
    if (const Status written = write_output("-", *answer + "\n"); !written) return console.fail(written.error());
  }
  return kDone;
}

}  // namespace

void add_mcp(CLI::App& app, Context& context) {
  auto catalog_file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("mcp", "The calls for clients of language models: Model Context Protocol on stdin and stdout");
  add_catalog_option(*command, *catalog_file);
  command->callback([catalog_file, &context] { context.status = run_mcp(*catalog_file, context.console); });
}

}  // namespace layoutbox::cli
