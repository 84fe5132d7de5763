#include "layoutbox/chat/cache_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "layoutbox/base/files.h"
#include "layoutbox/chat/endpoint.h"

namespace layoutbox::chat {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

constexpr const char* kFormat = "layoutbox/response@1";
constexpr const char* kCapabilitiesFile = "servers.json";
constexpr std::size_t kLargestFile = 32u << 20;

// FNV-1a over both parts. A clash is no harm: the file holds the request, and it is compared.
std::uint64_t hash_of(std::string_view a, std::string_view b, std::uint64_t basis) {
  std::uint64_t hash = basis;
  for (const std::string_view part : {a, std::string_view("\n"), b}) {
    for (const char c : part) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  return hash;
}

OrderedJson read_json_file(const fs::path& path) {
  const auto text = read_file(path, kLargestFile);
  return text ? OrderedJson::parse(*text, nullptr, false) : OrderedJson(OrderedJson::value_t::discarded);
}

void write_private(const fs::path& path, const OrderedJson& json) {
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  fs::permissions(path.parent_path(), fs::perms::owner_all, ignored);
  if (write_file(path, json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace))) {
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write, ignored);
  }
}

std::string text_member(const OrderedJson& json, const char* key) {
  return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string();
}

std::int64_t number_member(const OrderedJson& json, const char* key) {
  return json.contains(key) && json[key].is_number_unsigned() ? json[key].get<std::int64_t>() : 0;
}

std::string last_message(const std::string& request) {
  const OrderedJson body = OrderedJson::parse(request, nullptr, false);
  if (!body.is_object() || !body.contains("messages") || !body["messages"].is_array() || body["messages"].empty()) return {};
  const OrderedJson& content = body["messages"].back().value("content", OrderedJson());
  if (content.is_array() && !content.empty()) return one_line(text_member(content.back(), "text"), 60);
  return one_line(text_member(body["messages"].back(), "content"), 60);
}

std::string model_of(const std::string& request) { return text_member(OrderedJson::parse(request, nullptr, false), "model"); }

std::string capabilities_key(std::string_view base_url, std::string_view model) { return fmt::format("{} {}", base_url, model); }

}  // namespace

fs::path cache_folder() {
  const char* const named = std::getenv("XDG_CACHE_HOME");
  if (named != nullptr && fs::path(named).is_absolute()) return fs::path(named) / "layoutbox";
  const char* const home = std::getenv("HOME");
  return home != nullptr && *home != '\0' ? fs::path(home) / ".cache/layoutbox" : fs::path();
}

fs::path ResponseCache::file_of(std::string_view base_url, std::string_view request) const {
  return folder_ / "answers" /
         fmt::format("{:016x}{:016x}.json", hash_of(base_url, request, 0xcbf29ce484222325u),
                     hash_of(base_url, request, 0x9e3779b97f4a7c15u));
}

std::optional<std::string> ResponseCache::find(std::string_view base_url, std::string_view request) const {
  if (folder_.empty()) return std::nullopt;
  const OrderedJson json = read_json_file(file_of(base_url, request));
  if (text_member(json, "format") != kFormat || text_member(json, "address") != base_url || text_member(json, "request") != request) {
    return std::nullopt;
  }
  return text_member(json, "response");
}

void ResponseCache::store(std::string_view base_url, std::string_view request, std::string_view body) const {
  if (folder_.empty()) return;
  write_private(file_of(base_url, request), {{"format", kFormat}, {"address", base_url}, {"request", request}, {"response", body}});
}

std::vector<CachedResponse> ResponseCache::list() const {
  std::vector<std::pair<fs::file_time_type, CachedResponse>> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_ / "answers", ignored)) {
    if (entry.path().extension() != ".json") continue;
    const std::string request = text_member(read_json_file(entry.path()), "request");
    found.push_back({entry.last_write_time(ignored), {entry.path(), model_of(request), last_message(request), entry.file_size(ignored)}});
  }
  std::ranges::sort(found,
                    [](const auto& a, const auto& b) { return std::pair(b.first, a.second.file) < std::pair(a.first, b.second.file); });
  std::vector<CachedResponse> list;
  list.reserve(found.size());
  for (auto& [time, answer] : found) list.push_back(std::move(answer));
  return list;
}

Result<std::size_t> ResponseCache::clear() const {
  std::size_t count = 0;
  std::error_code error;
  for (const CachedResponse& answer : list()) count += fs::remove(answer.file, error) ? 1 : 0;
  fs::remove(folder_ / kCapabilitiesFile, error);
  if (!list().empty()) return fail(ErrorCode::kIo, "not every kept answer could be removed", folder_.string());
  return count;
}

Capabilities load_capabilities(const fs::path& folder, std::string_view base_url, std::string_view model, std::span<const Mode> modes) {
  Capabilities capabilities;
  capabilities.modes = modes;
  capabilities.mode = modes.front();
  if (folder.empty()) return capabilities;
  const OrderedJson json = read_json_file(folder / kCapabilitiesFile);
  const std::string key = capabilities_key(base_url, model);
  if (!json.is_object() || !json.contains(key) || !json[key].is_object()) return capabilities;
  const OrderedJson& kept = json[key];
  for (const Mode mode : modes) {
    if (text_member(kept, "mode") == name_of(mode)) capabilities.mode = mode, capabilities.known = true;
  }
  capabilities.capacity = {number_member(kept, "context"), number_member(kept, "response"), number_member(kept, "cuts") != 0};
  if (kept.contains("without") && kept["without"].is_array()) {
    for (const OrderedJson& name : kept["without"]) {
      if (name.is_string()) capabilities.without.insert(name.get<std::string>());
    }
  }
  return capabilities;
}

void save_capabilities(const fs::path& folder, std::string_view base_url, std::string_view model, const Capabilities& capabilities) {
  if (folder.empty()) return;
  OrderedJson json = read_json_file(folder / kCapabilitiesFile);
  if (!json.is_object()) json = OrderedJson::object();
  json[capabilities_key(base_url, model)] = {{"mode", name_of(capabilities.mode)},
                                             {"without", capabilities.without},
                                             {"context", capabilities.capacity.context},
                                             {"response", capabilities.capacity.response},
                                             {"cuts", capabilities.capacity.cuts ? 1 : 0}};
  write_private(folder / kCapabilitiesFile, json);
}

}  // namespace layoutbox::chat
