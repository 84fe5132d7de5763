#include "layoutbox/cli/model_flags.h"

#include <fmt/format.h>

#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/provider_names.h"
#include "layoutbox/plan/llm/conversation.h"

namespace layoutbox::cli {

void ModelFlags::add_to(CLI::App& command, RepairOptions& repair) {
  const auto* const group = "With --planner llm";
  command.add_option("--model", model, "The model's name (else LAYOUTBOX_MODEL)")->group(group);
  command.add_option("--base-url", base_url, "The server's address up to /v1 (else OPENAI_BASE_URL); its key is read from OPENAI_API_KEY")
      ->group(group);
  command.add_option("--provider", provider, "The form it is asked in: " + provider_names() + " (else LAYOUTBOX_PROVIDER, else openai)")
      ->group(group);
  command.add_option("--trust", trust, "Whom to believe where the model's scene is not what the text says: text or model")
      ->capture_default_str()
      ->group(group);
  command.add_option("--max-attempts", repair.max_attempts, "Answers of the model in all")
      ->capture_default_str()
      ->check(CLI::Range(1, 100))
      ->group(group);
  command.add_option("--repair-attempts", repair.repair_attempts, "Of these after a scene that has no layout")
      ->capture_default_str()
      ->check(CLI::Range(0, 100))
      ->group(group);
  command.add_flag("--paper-retries", repair.paper_retries, "As the paper: a plain notice, one new scene, then its own positions")
      ->group(group);
  command.add_option("--attempt-pause", repair.pause_s, "Seconds between attempts")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 3600.0))
      ->group(group);
  command.add_option("--model-timeout", timeout_s, "Seconds for one answer")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0))
      ->group(group);
  command.add_option("--model-context", context_tokens, "Tokens that the model can hold, where its server does not say; 0: found out")
      ->check(CLI::Range(0, 100'000'000))
      ->group(group);
  command.add_option("--max-cost", max_cost, "US dollars that the answers may cost, in a batch those of all rooms")
      ->check(CLI::Range(0.0, 1e6))
      ->group(group);
  command.add_option("--max-tokens", max_tokens, "Tokens that questions and answers may take, in a batch those of all rooms")
      ->check(CLI::Range(1, 1'000'000'000))
      ->group(group);
  command
      .add_option("--prices", prices_file,
                  "Prices of models of your own, in the form of models/prices.json, over those of ~/.config/layoutbox/prices.json")
      ->group(group);
  command.add_flag("--no-cache", no_cache, "Ask although the same was asked before, and keep no answer")->group(group);
  command.add_flag("--stream", stream, "Have answers sent in pieces")->group(group);
  command.add_flag("--dry-run", dry_run, "Print the first request instead of sending it")->group(group);
}

Result<chat::ChatOptions> ModelFlags::chat_options(const Console& console) const {
  chat::ChatOptions chat;
  LAYOUTBOX_ASSIGN(chat.endpoint, chat::find_endpoint({base_url, model, provider}));
  LAYOUTBOX_ASSIGN(chat.prices, chat::Prices::of_user());
  if (!prices_file.empty()) {
    LAYOUTBOX_ASSIGN(const std::string text, read_input(prices_file));
    if (Status added = chat.prices.add(text); !added) {
      added.error().pointer = prices_file + (added.error().pointer.empty() ? "" : "#" + added.error().pointer);
      return Failure(added.error());
    }
  }
  chat.request_limit_s = timeout_s;
  chat.context_tokens = context_tokens;
  chat.retry.total_s = std::max(chat.retry.total_s, timeout_s);
  chat.spend_limit->max_cost = max_cost;
  chat.spend_limit->max_tokens = max_tokens;
  chat.use_cached_answers = !no_cache;
  chat.stream = stream;
  chat.stop = &stop_flag();
  chat.on_wait = [&console](const std::string& line) { console.say("model    " + line); };
  return chat;
}

Result<std::unique_ptr<Planner>> ModelFlags::make_planner(const std::string& name, const Catalog& catalog, GenerateOptions& options,
                                                          const Console& console, const chat::ChatOptions* given) const {
  if (name != "llm") {
    if (dry_run) return layoutbox::fail(ErrorCode::kUsage, "the offline planner sends no request", "--dry-run", "add --planner llm");
    return make_offline_planner(catalog);
  }
  llm::ConversationOptions conversation;
  if (trust != "text" && trust != "model") {
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("'{}' is nobody to trust", trust), "--trust", "use text or model");
  }
  conversation.trust = trust == "text" ? llm::Trust::kText : llm::Trust::kModel;
  conversation.max_attempts = options.repair.max_attempts;
  conversation.pause_s = options.repair.pause_s;
  LAYOUTBOX_ASSIGN(chat::ChatOptions chat, given != nullptr ? *given : chat_options(console));
  options.planner = fmt::format("llm {} at {}, trust {}", chat.endpoint.model, chat.endpoint.base_url, trust);
  return llm::make_model_planner(catalog, std::move(chat), std::move(conversation));
}

int print_first_request(const Planner& planner, const std::string& prompt, const GenerateOptions& options, const Console& console) {
  const auto planning = planner.begin(prompt, options.plan, {options.normalize.room_size, options.shell ? &*options.shell : nullptr});
  const auto request = planning->describe_first_request();
  if (!request) return console.fail(request.error());
  const Status written = write_output("-", *request);
  return written ? kDone : console.fail(written.error());
}

}  // namespace layoutbox::cli
