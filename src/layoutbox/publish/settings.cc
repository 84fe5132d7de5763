#include "layoutbox/publish/settings.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>

#include "layoutbox/base/files.h"

namespace layoutbox::publish {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = 64 << 10;
constexpr std::size_t kShortestSecret = 4;

std::string variable(std::string_view name) {
  const char* value = std::getenv(std::string(name).c_str());
  return value == nullptr ? std::string() : value;
}

fs::path file_of_user() {
  if (const std::string named = variable("LAYOUTBOX_CREDENTIALS"); !named.empty()) return named;
  if (const std::string folder = variable("XDG_CONFIG_HOME"); !folder.empty()) return fs::path(folder) / "layoutbox/credentials";
  const std::string home = variable("HOME");
  return home.empty() ? fs::path{} : fs::path(home) / ".config/layoutbox/credentials";
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string_view::npos ? std::string_view{} : text.substr(begin, end - begin + 1);
}

std::map<std::string, std::string> lines_of(std::string_view text) {
  std::map<std::string, std::string> values;
  while (!text.empty()) {
    const std::string_view line = trimmed(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.size(), text.find('\n') == std::string_view::npos ? text.size() : text.find('\n') + 1));
    const std::size_t sign = line.find('=');
    if (line.starts_with('#') || sign == std::string_view::npos) continue;
    values[std::string(trimmed(line.substr(0, sign)))] = trimmed(line.substr(sign + 1));
  }
  return values;
}

}  // namespace

Result<Settings> Settings::of_user() {
  const fs::path file = file_of_user();
  struct stat facts {};
  if (file.empty() || ::stat(file.c_str(), &facts) != 0) return Settings();
  if ((facts.st_mode & 077) != 0) {
    return fail(ErrorCode::kIo, fmt::format("others than you may read {}, which holds credentials; it is not used", file.string()),
                file.string(), fmt::format("chmod 600 {}", file.string()));
  }
  LAYOUTBOX_ASSIGN(const std::string text, read_file(file, kLargestFile));
  return Settings(lines_of(text));
}

std::string Settings::get(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names) {
    if (std::string value = variable(name); !value.empty()) return value;
  }
  for (const std::string_view name : names) {
    if (const auto found = file_.find(std::string(name)); found != file_.end() && !found->second.empty()) return found->second;
  }
  return {};
}

std::string Settings::secret(std::initializer_list<std::string_view> names) {
  std::string value = get(names);
  hide(value);
  return value;
}

Result<std::string> Settings::need(std::string_view name, bool is_secret) {
  std::string value = is_secret ? secret({name}) : get({name});
  if (!value.empty()) return value;
  return fail(ErrorCode::kUsage, fmt::format("{} is not set", name), "--publish",
              "set it in the environment, or as a line NAME=value of ~/.config/layoutbox/credentials, a file of mode 600");
}

void Settings::hide(std::string value) {
  if (value.size() >= kShortestSecret) secrets_.push_back(std::move(value));
}

std::string Settings::without_secrets(std::string text) const {
  for (const std::string& secret : secrets_) {
    for (std::size_t at; (at = text.find(secret)) != std::string::npos;) text.replace(at, secret.size(), "[secret]");
  }
  return text;
}

}  // namespace layoutbox::publish
