#include "layoutbox/furnish/decor_style.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "layoutbox/furnish/decor_data.h"

namespace layoutbox {

std::string lower_case(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

namespace {

using nlohmann::json;

constexpr std::size_t kLongestName = 24;  // characters that tell a thing's name from a style

// "Loft bed": words of a style that are of a thing's name.
bool names_a_thing(std::string_view text) {
  const std::string lower = lower_case(text);
  return std::ranges::any_of(decor_data().at("no_styles"), [&](const json& name) {
    const auto phrase = name.get<std::string>();
    const bool over = lower.size() <= phrase.size() || std::isalpha(static_cast<unsigned char>(lower[phrase.size()])) == 0;
    return over && lower.starts_with(phrase);
  });
}

// "make it dark": where no style is named, what the room is to feel like.
RoomStyle mood_of(std::string_view text) {
  const std::string lower = lower_case(text) + ".";  // phrases may end a sentence
  for (const auto& [name, mood] : decor_data().at("moods").items()) {
    const bool said = std::ranges::any_of(mood.at("says"),
                                          [&](const json& phrase) { return lower.find(phrase.get<std::string>()) != std::string::npos; });
    if (said) return {name, &mood};
  }
  return {};
}

}  // namespace

RoomStyle style_of(std::string_view text) {
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? static_cast<char>(std::tolower(static_cast<unsigned char>(text[i]))) : ' ';
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '-') {
      word += c;
      continue;
    }
    if (word.size() > 2 && !names_a_thing(text.substr(i - word.size(), kLongestName))) {
      for (const auto& [words, style] : decor_data().at("styles").items()) {
        if (lists(words, word)) return {words.substr(0, words.find(' ')), &style};
      }
    }
    word.clear();
  }
  return mood_of(text);
}

}  // namespace layoutbox
