#include "layoutbox/furnish/room_colors.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "layoutbox/base/words.h"
#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/palette.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;

// The colours of words that name nothing but colours ("pink and white"); none where another word is among them.
std::vector<Color> only_colors(std::string_view words) {
  std::vector<Color> colors;
  std::string two;
  for (const std::string& word : words_of(words)) {
    if (const SurfaceWish wish = read_wish(two.empty() ? word : two + " " + word); wish.color) {
      colors.push_back(*wish.color);
      two.clear();
    } else if (lists(decor_data().at("color_words").get_ref<const std::string&>(), word)) {
      two = word;
    } else {
      return {};
    }
  }
  return colors;
}

// Those of a clause that names nothing but colours ("colours: sage and cream"), of an item of a list that says so of everything ("mostly
// black", "purple vibes"), of the end of a list ("…, a bean bag, pink and beige"; one colour alone is of what stands before it), and of the
// room's kind at once ("a nursery in soft yellow and white"): of the whole room.
std::vector<Color> colors_of_clause(std::string_view clause, bool opens) {
  constexpr std::size_t kOpening = 40;  // characters
  std::vector<Color> said = only_colors(clause);
  for (std::size_t at = 0; at < clause.size() && said.empty();) {
    const std::size_t end = std::min(clause.find(',', at), clause.size());
    const std::string_view item = clause.substr(at, end - at);
    const bool last = end == clause.size() && at > 0;
    const std::vector<std::string> words = words_of(item);
    const bool of_all = std::ranges::any_of(
        words, [](const std::string& word) { return lists(decor_data().at("color_markers").get_ref<const std::string&>(), word); });
    if (std::vector<Color> colors = only_colors(item); of_all || (last && colors.size() > 1)) said = std::move(colors);
    at = end + 1;
  }
  const std::size_t in = clause.find(" in ");
  if (said.empty() && opens && in < kOpening && clause.substr(0, in).find(" with ") == std::string_view::npos)
    said = only_colors(clause.substr(in + 4));
  return said;
}

// Colours that are no thing's: "in soft greens", "earth tones", and those before the room's own name ("a blue and white bedroom").
std::vector<Color> theme_of_clause(std::string_view clause, bool opens) {
  const Json& themes = decor_data().at("color_themes");
  const std::vector<std::string> words = words_of(clause);
  std::vector<Color> colors;
  std::string before, two;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string pair = i + 1 < words.size() ? words[i] + " " + words[i + 1] : "";
    for (const std::string& said : {pair, words[i]}) {
      if (!themes.contains(said) || before == "of") continue;
      for (const Json& name : themes.at(said)) colors.push_back(*read_wish(before + " " + name.get<std::string>()).color);
      break;
    }
    before = words[i];
  }
  if (!colors.empty() || !opens) return colors;
  for (const std::string& word : words) {
    if (const SurfaceWish wish = read_wish(two.empty() ? word : two + " " + word); wish.color && wish.materials.empty()) {
      colors.push_back(*wish.color);
      two.clear();
    } else if (word.ends_with("room") || lists(decor_data().at("room_words").get_ref<const std::string&>(), word)) {
      return colors;
    } else if (lists(decor_data().at("color_words").get_ref<const std::string&>(), word)) {
      two = word;
    } else {
      break;
    }
  }
  return {};
}

}  // namespace

std::vector<Color> room_colors(std::string_view prompt) {
  std::vector<Color> colors;
  for (std::size_t at = 0; at < prompt.size();) {
    const std::size_t end = std::min(prompt.find_first_of(".;:!?\n", at), prompt.size());
    std::vector<Color> said = colors_of_clause(prompt.substr(at, end - at), at == 0);
    if (said.empty()) said = theme_of_clause(prompt.substr(at, end - at), at == 0);
    colors.insert(colors.end(), said.begin(), said.end());
    at = end + 1;
  }
  return colors;
}

}  // namespace layoutbox
