#include "layoutbox/furnish/picture_subjects.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/prompt_words.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;

// The text as it opens, up to the first thing that stands in the room: its words are of the whole room.
std::string opening_of(const std::string& text) {
  constexpr std::size_t kLongest = 80;  // characters
  return text.substr(0, std::min({text.find_first_of(":;.\n"), text.find(" with "), text.find(" containing "), kLongest}));
}

// "Dinosaur themed", "loves dinosaurs": said anywhere, it is of the whole room as well.
bool is_said_of_room(std::string_view text, const std::string& word) {
  return std::ranges::any_of(decor_data().at("theme_phrases"), [&](const Json& phrase) {
    std::string whole = phrase.get<std::string>();
    return says_word(text, whole.replace(whole.find('*'), 1, word));
  });
}

}  // namespace

std::string picture_subject(const std::function<bool(std::string_view)>& says) {
  for (const Json& row : decor_data().at("picture_words")) {
    const bool said = std::ranges::any_of(row.at("says"), [&](const Json& phrase) {
      const std::string word = phrase.get<std::string>();
      return says(word) || says(word + "s");
    });
    if (said) return row.at("show").get<std::string>();
  }
  return "";
}

std::string picture_theme(std::string_view prompt, bool for_children) {
  std::string text;
  for (const char c : prompt) text += c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::string opening = opening_of(text);
  for (const Json& row : decor_data().at("picture_themes")) {
    const bool said = std::ranges::any_of(row.at("says"), [&](const Json& phrase) {
      const std::string word = phrase.get<std::string>();
      return says_word(opening, word) || is_said_of_room(text, word);
    });
    if (said) return row.at(for_children && row.contains("for_children") ? "for_children" : "show").get<std::string>();
  }
  return "";
}

std::vector<std::string> names_in(std::string_view names) {
  std::istringstream words{std::string(names)};
  return {std::istream_iterator<std::string>(words), {}};
}

}  // namespace layoutbox
