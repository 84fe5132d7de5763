// Options of asking a language model, and the planner that --planner names.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "layoutbox/chat/chat_client.h"
#include "layoutbox/cli/console.h"
#include "layoutbox/pipeline/generate.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox::cli {

struct ModelFlags {
  std::string model, base_url, provider, trust = "text", prices_file;
  double timeout_s = 300;
  int context_tokens = 0;
  std::optional<double> max_cost;
  std::optional<std::int64_t> max_tokens;
  bool no_cache = false, stream = false, dry_run = false;

  void add_to(CLI::App& command, RepairOptions& repair);
  // Errors: those of find_endpoint(), of the prices.
  Result<chat::ChatOptions> chat_options(const Console& console) const;
  // The offline planner, or the one by model, asked as `chat` says where that is given. Errors: kUsage, those of find_endpoint().
  Result<std::unique_ptr<Planner>> make_planner(const std::string& name, const Catalog& catalog, GenerateOptions& options,
                                                const Console& console, const chat::ChatOptions* chat = nullptr) const;
};

// What the planner would ask a model first, on stdout; returns the exit status.
int print_first_request(const Planner& planner, const std::string& prompt, const GenerateOptions& options, const Console& console);

}  // namespace layoutbox::cli
