#include "layoutbox/cli/config_file.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "layoutbox/scene/json_text.h"

namespace layoutbox::cli {
namespace {

using Items = std::vector<CLI::ConfigItem>;

// A value as it would stand on the command line. CLI11 wants errors of a configuration file thrown.
std::string text_of(const std::string& name, const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean() || value.is_number()) return value.dump();
  throw CLI::ConfigError(fmt::format("'{}' in the configuration file is neither text, a number, true, false nor a list of these", name));
}

void add_items(const nlohmann::json& object, const std::vector<std::string>& parents, Items& items) {
  for (const auto& [name, value] : object.items()) {
    if (value.is_null()) continue;
    if (value.is_object() && parents.empty()) {
      add_items(value, {name}, items);
      continue;
    }
    CLI::ConfigItem item;
    item.parents = parents;
    item.name = name;
    if (value.is_array()) {
      for (const nlohmann::json& one : value) item.inputs.push_back(text_of(name, one));
    } else {
      item.inputs.push_back(text_of(name, value));
    }
    items.push_back(std::move(item));
  }
}

Items read_json(const std::string& text) {
  const auto json = parse_json(text);
  if (!json) throw CLI::ConfigError("the configuration file: " + json.error().message);
  Items items;
  add_items(*json, {}, items);
  return items;
}

// Reads both forms, and hands every value to the command that is run.
class ConfigFile final : public CLI::ConfigTOML {
 public:
  explicit ConfigFile(const CLI::App& app) : app_(&app) {}

  Items from_config(std::istream& stream) const override {
    std::ostringstream buffer;
    buffer << stream.rdbuf();
    const std::string text = buffer.str();
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    Items read;
    if (first != std::string::npos && text[first] == '[' && parse_json(text)) {  // "[batch]" opens a section, "[1, 2]" is JSON
      throw CLI::ConfigError("the configuration file is a list, and not an object of options and their values");
    }
    if (first != std::string::npos && text[first] == '{') {
      read = read_json(text);
    } else {
      std::istringstream again(text);
      read = CLI::ConfigTOML::from_config(again);
    }
    const auto chosen = app_->get_subcommands();
    Items taken, general;  // what a section says comes first: the first word on an option holds
    for (CLI::ConfigItem& item : read) {
      if (item.name == "++" || item.name == "--") continue;  // where sections begin and end
      if (item.name.find('\n') != std::string::npos || item.name.empty())
        throw CLI::ConfigError("the configuration file is neither TOML nor JSON");
      if (chosen.empty()) continue;
      const CLI::App* command = chosen.front();
      const bool elsewhere = !item.parents.empty() && item.parents.front() != command->get_name();
      if (elsewhere && is_command(item.parents.front())) continue;
      if (elsewhere)
        throw CLI::ConfigError(
            fmt::format("the configuration file has a section '{}', and there is no such command", item.parents.front()));
      const bool in_section = !item.parents.empty();
      if (has_option(*app_, item.name)) {
        item.parents.clear();
      } else if (has_option(*command, item.name)) {
        item.parents = {command->get_name()};
      } else if (of_any_command(item.name) && item.parents.empty()) {
        continue;
      } else {
        throw CLI::ConfigError(fmt::format("there is no option '{}' as the configuration file has it", item.name));
      }
      (in_section ? taken : general).push_back(std::move(item));
    }
    taken.insert(taken.end(), general.begin(), general.end());
    return taken;
  }

 private:
  static bool has_option(const CLI::App& app, const std::string& name) { return app.get_option_no_throw("--" + name) != nullptr; }
  bool is_command(const std::string& name) const {
    for (const CLI::App* command : app_->get_subcommands(nullptr)) {
      if (command->get_name() == name) return true;
    }
    return false;
  }
  bool of_any_command(const std::string& name) const {
    for (const CLI::App* command : app_->get_subcommands(nullptr)) {
      if (has_option(*command, name)) return true;
    }
    return false;
  }

  const CLI::App* app_;
};

}  // namespace

void add_config_option(CLI::App& app) {
  app.config_formatter(std::make_shared<ConfigFile>(app));
  app.set_config("--config", "", "Options from a file, TOML or JSON, by the same names; what the command line says beats it");
}

}  // namespace layoutbox::cli
