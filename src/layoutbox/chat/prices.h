// What tokens cost. The figures are data: models/prices.json, a user's own file, or one that is named, each over those before.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "layoutbox/base/result.h"
#include "layoutbox/chat/chat.h"

namespace layoutbox::chat {

struct Price {  // US dollars for a million tokens
  double request = 0, response = 0;
  std::string as_of;  // when it was looked up, "2025-08"; empty: not said
};

class Prices {
 public:
  static const Prices& builtin();
  // The built-in prices with those of prices_file(), where there is one. Errors: kIo, kParse, kSchema.
  static Result<Prices> of_user();
  // Adds to these, and replaces in them. Errors: kParse, kSchema.
  Status add(std::string_view json);

  // By the model's name, else by the longest name that it begins with ("gpt-4o-2024-08-06" → gpt-4o); empty where none fits.
  std::optional<Price> find(std::string_view model) const;

 private:
  std::map<std::string, Price, std::less<>> prices_;
};

// prices.json in $XDG_CONFIG_HOME/layoutbox, else in ~/.config/layoutbox. Empty where there is neither XDG_CONFIG_HOME nor HOME.
std::filesystem::path prices_file();

double cost_of(const Price& price, const Usage& usage);

}  // namespace layoutbox::chat
