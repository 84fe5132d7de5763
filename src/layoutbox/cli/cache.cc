#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "layoutbox/base/words.h"
#include "layoutbox/chat/cache_folder.h"
#include "layoutbox/cli/commands.h"

namespace layoutbox::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string size_text(std::uintmax_t bytes) {
  return bytes < 1'000'000 ? fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3)
                           : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

int list(const chat::ResponseCache& cache, bool only_size, const Console& console) {
  std::uintmax_t bytes = 0;
  std::string text;
  const std::filesystem::path folder = chat::cache_folder();
  Json json{{"folder", folder.string()}, {"bytes", 0}, {"answers", Json::array()}};
  for (const chat::CachedResponse& answer : cache.list()) {
    bytes += answer.bytes;
    if (!only_size) text += fmt::format("{:<24} {:>9}  {}\n", answer.model, size_text(answer.bytes), answer.begins);
    json["answers"].push_back(
        {{"file", answer.file.filename().string()}, {"model", answer.model}, {"bytes", answer.bytes}, {"begins", answer.begins}});
  }
  json["bytes"] = bytes;
  text += fmt::format("{}, {}, in {}", counted(json["answers"].size(), "answer"), size_text(bytes), folder.string());
  console.result(text, json.dump(-1, ' ', false, Json::error_handler_t::replace));
  return kDone;
}

int clear(const chat::ResponseCache& cache, const Console& console) {
  const auto count = cache.clear();
  if (!count) return console.fail(count.error());
  console.result(counted(*count, "answer") + " removed", Json{{"removed", *count}}.dump());
  return kDone;
}

}  // namespace

void add_cache(CLI::App& app, Context& context) {
  auto what = std::make_shared<std::string>("list");
  CLI::App* command = app.add_subcommand("cache", "What answers of language models are kept, and their removal");
  command->add_option("what", *what, "list, size or clear")->capture_default_str()->check(CLI::IsMember({"list", "size", "clear"}));
  command->callback([what, &context] {
    const chat::ResponseCache cache(chat::cache_folder());
    context.status = *what == "clear" ? clear(cache, context.console) : list(cache, *what == "size", context.console);
  });
}

}  // namespace layoutbox::cli
