// What tokens cost. The figures are data: models/prices.json, or a file of one's own in the same form.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "layoutbox/base/result.h"
#include "layoutbox/chat/chat.h"

namespace layoutbox::chat {

struct Price {  // US dollars for a million tokens
  double question = 0, answer = 0;
};

class Prices {
 public:
  static const Prices& builtin();
  // Adds to, and replaces in, the built-in prices. Errors: kParse, kSchema.
  static Result<Prices> with(std::string_view json);

  // By the model's name, else by the longest name that it begins with ("gpt-4o-2024-08-06" → gpt-4o); empty where none fits.
  std::optional<Price> find(std::string_view model) const;

 private:
  std::map<std::string, Price, std::less<>> prices_;
};

double cost_of(const Price& price, const Usage& usage);

}  // namespace layoutbox::chat
