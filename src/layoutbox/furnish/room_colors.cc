#include "layoutbox/furnish/room_colors.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "layoutbox/base/words.h"
#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/palette.h"
#include "layoutbox/furnish/prompt_words.h"

namespace layoutbox {
namespace {

bool is_color_word(const std::string& word) { return is_in_list("color_words", word); }

// "Sage green", "white oak": two words of one colour or stuff.
bool are_one_look(const std::string& two) {
  const std::vector<std::string> words = words_of(two);
  if (!is_look_word(words.front()) || !is_look_word(words.back()) || is_color_word(words.front())) return false;
  const SurfaceWish wish = read_wish(two);
  return !wish.second && wish.materials.size() + (wish.color ? 1U : 0U) == 1U;
}

// What words say that name nothing but colours, woods and metals ("pink and white"); nothing where another word is among them.
ColorScheme only_looks(std::string_view text) {
  ColorScheme scheme;
  std::string two;
  const std::vector<std::string> words = words_of(text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    if (is_color_word(word)) {
      two = word;
      continue;
    }
    if (i + 1 < words.size() && are_one_look(word + " " + words[i + 1])) word += " " + words[++i];
    const SurfaceWish wish = read_wish(two.empty() ? word : two + " " + word);
    const NamedSurface* stuff = wish.materials.empty() ? nullptr : wish.materials.front();
    if (wish.color && is_look_word(words[i])) {
      scheme.colors.push_back(*wish.color);
    } else if (stuff != nullptr && stuff->kind == "wood") {
      scheme.woods.push_back(stuff->surface.name);
    } else if (stuff != nullptr && stuff->kind == "metal") {
      scheme.metal = stuff->surface.name;
    } else {
      return {};
    }
    two.clear();
  }
  return scheme;
}

// "A palette of terracotta, sand and cream": what follows to the end of the clause.
ColorScheme scheme_named(std::string_view clause) {
  constexpr std::string_view kOf = " of ";
  for (std::size_t of = clause.find(kOf); of != std::string_view::npos; of = clause.find(kOf, of + 1)) {
    const std::vector<std::string> before = words_of(clause.substr(0, of));
    if (!before.empty() && is_in_list("shade_words", before.back())) return only_looks(clause.substr(of + kOf.size()));
  }
  return {};
}

// Those of a clause that names nothing but looks ("colours: sage and cream"), of an item of a list that says so of everything ("mostly
// black", "purple vibes"), of an item that is colours alone ("Sage and cream, blackout curtains", "…, a bean bag, pink and beige"; one
// colour is of what stands before it), and of the room's kind at once ("a nursery in soft yellow and white"): of the whole room.
ColorScheme scheme_of_clause(std::string_view clause, bool opens) {
  constexpr std::size_t kOpening = 40;  // characters
  ColorScheme said = scheme_named(clause);
  if (said.size() > 0) return said;
  said = only_looks(clause);
  if (said.colors.empty() && said.size() < 2) said = {};  // "Oak." is of what stands before it
  for (std::size_t at = 0; at < clause.size() && said.size() == 0;) {
    const std::size_t end = std::min(clause.find(',', at), clause.size());
    const std::string_view item = clause.substr(at, end - at);
    const std::vector<std::string> before = words_of(clause.substr(0, at));
    // "a rug in red, blue and white", "a checkered floor, black and white"
    const bool of_last = !before.empty() && (is_look_word(before.back()) || is_in_list("surface_words", before.back()));
    const bool own = (end != clause.size() || at > 0) && !of_last;
    const std::vector<std::string> words = words_of(item);
    const bool of_all = std::ranges::any_of(words, [](const std::string& word) { return is_in_list("color_markers", word); });
    if (ColorScheme looks = only_looks(item); of_all || (own && looks.size() > 1)) said = std::move(looks);
    at = end + 1;
  }
  const std::size_t in = clause.find(" in ");
  if (said.size() == 0 && opens && in < kOpening && clause.substr(0, in).find(" with ") == std::string_view::npos)
    said = only_looks(clause.substr(in + 4));
  return said;
}

// The looks that stand before the room's own name: "a blue and white bedroom", "my daughter wants a pink and grey room", "a black and gold
// dining room".
ColorScheme looks_before_room(const std::vector<std::string>& words) {
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (!is_room_word(words[at])) continue;
    std::size_t from = words[at] == "room" && at > 0 && !is_look_word(words[at - 1]) ? at - 1 : at;  // "dining room"
    const std::size_t name = from;
    while (from > 0 && (is_look_word(words[from - 1]) || is_color_word(words[from - 1]))) --from;
    std::string said;
    for (std::size_t i = from; i < name; ++i) said += words[i] + " ";
    ColorScheme scheme = only_looks(said);
    if (!scheme.colors.empty()) return scheme;
  }
  return {};
}

// Colours that are no thing's: "in soft greens", "earth tones", and those before the room's own name.
ColorScheme theme_of_clause(std::string_view clause, bool opens) {
  const nlohmann::json& themes = decor_data().at("color_themes");
  const std::vector<std::string> words = words_of(clause);
  ColorScheme theme;
  std::string before;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string pair = i + 1 < words.size() ? words[i] + " " + words[i + 1] : "";
    for (const std::string& said : {pair, words[i]}) {
      if (!themes.contains(said) || before == "of" || is_banned_at(words, i)) continue;
      for (const nlohmann::json& name : themes.at(said)) theme.colors.push_back(*read_wish(before + " " + name.get<std::string>()).color);
      break;
    }
    before = words[i];
  }
  return theme.colors.empty() && opens ? looks_before_room(words) : theme;
}

void append(ColorScheme& all, const ColorScheme& some) {
  all.colors.insert(all.colors.end(), some.colors.begin(), some.colors.end());
  all.woods.insert(all.woods.end(), some.woods.begin(), some.woods.end());
  if (all.metal.empty()) all.metal = some.metal;
}

}  // namespace

ColorScheme room_scheme(std::string_view prompt) {
  ColorScheme all;
  for (std::size_t at = 0; at < prompt.size();) {
    const std::size_t end = std::min(prompt.find_first_of(".;:!?\n", at), prompt.size());
    const std::string_view clause = prompt.substr(at, end - at);
    ColorScheme said = scheme_of_clause(clause, at == 0);
    if (said.size() == 0) said = theme_of_clause(clause, at == 0);
    append(all, said);
    at = end + 1;
  }
  return all;
}

}  // namespace layoutbox
