#include "layoutbox/base/words.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace layoutbox {
namespace {

bool is_word_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string joined(std::span<const std::string> words, std::string_view separator) {
  std::string out;
  for (const std::string& word : words) {
    if (!out.empty()) out += separator;
    out += word;
  }
  return out;
}

}  // namespace

std::vector<std::string> words_of(std::string_view phrase) {
  std::vector<std::string> words;
  bool open = false;
  for (const char c : phrase) {
    if (c == '\'') continue;  // women's
    if (!is_word_byte(c)) {
      open = false;
      continue;
    }
    if (!open) words.emplace_back();
    words.back() += lower(c);
    open = true;
  }
  return words;
}

std::string key_of(std::string_view phrase) {
  std::string key;
  key.reserve(phrase.size());
  for (const char c : phrase) {
    if (is_word_byte(c)) key += lower(c);
  }
  return key;
}

std::string snake_case(std::string_view phrase) { return joined(words_of(phrase), "_"); }

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  std::string text = std::to_string(count) + " ";
  if (count == 1) return text.append(one);
  return many.empty() ? text.append(one).append("s") : text.append(many);
}

std::string singular_of(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 36> kIrregular = {{
      {"shelves", "shelf"},    {"bookshelves", "bookshelf"},
      {"knives", "knife"},     {"loaves", "loaf"},
      {"leaves", "leaf"},      {"scarves", "scarf"},
      {"cookies", "cookie"},   {"movies", "movie"},
      {"mice", "mouse"},       {"children", "child"},
      {"childrens", "child"},  {"kiddos", "kid"},
      {"people", "person"},    {"feet", "foot"},
      {"men", "man"},          {"women", "woman"},
      {"halves", "half"},      {"wolves", "wolf"},
      {"wives", "wife"},       {"men's", "man"},
      {"chaises", "chaise"},   {"vases", "vase"},
      {"glasses", "glass"},    {"lenses", "lens"},
      {"canvases", "canvas"},  {"tomatoes", "tomato"},
      {"potatoes", "potato"},  {"buses", "bus"},
      {"cacti", "cactus"},     {"geese", "goose"},
      {"plushies", "plushie"}, {"hoodies", "hoodie"},
      {"brownies", "brownie"}, {"beanies", "beanie"},
      {"codices", "codex"},    {"appendices", "appendix"},
  }};
  for (const auto& [plural, singular] : kIrregular) {
    if (word == plural) return std::string(singular);
  }
  const auto ends = [&](std::string_view end) { return word.size() > end.size() && word.ends_with(end); };
  if (word.size() > 4 && ends("ies")) return std::string(word.substr(0, word.size() - 3)) + "y";
  if (ends("ches") || ends("shes") || ends("xes") || ends("sses") || ends("zzes")) return std::string(word.substr(0, word.size() - 2));
  if (word.size() > 3 && ends("s") && !ends("ss") && !ends("us") && !ends("is")) return std::string(word.substr(0, word.size() - 1));
  return std::string(word);
}

std::vector<std::string> singular_forms(std::string_view word) {
  std::vector<std::string> forms{std::string(word)};
  const auto add_form = [&](std::string form) {
    if (std::find(forms.begin(), forms.end(), form) == forms.end()) forms.push_back(std::move(form));
  };
  const auto add = [&](std::size_t drop, std::string_view ending) {
    if (word.size() > drop + 1) add_form(std::string(word.substr(0, word.size() - drop)) + std::string(ending));
  };
  add_form(singular_of(word));  // the likeliest first
  if (word.ends_with("men")) add(3, "man");
  if (word.ends_with("feet")) add(4, "foot");
  if (!word.ends_with('s') || word.ends_with("ss")) return forms;
  if (word.ends_with("ves")) {
    add(1, "");
    add(3, "f");
    add(3, "fe");
  } else if (word.ends_with("ies")) {
    add(3, "y");
    add(1, "");
  } else {
    add(1, "");
    // "tubes" are no tubs.
    const auto stem_ends = [&](std::string_view end) { return word.substr(0, word.size() - 2).ends_with(end); };
    if (word.ends_with("es") &&
        (stem_ends("s") || stem_ends("x") || stem_ends("z") || stem_ends("ch") || stem_ends("sh") || stem_ends("o")))
      add(2, "");
  }
  return forms;
}

std::vector<std::string> candidate_keys(std::span<const std::string> words) {
  std::vector<std::string> keys{joined(words, "")};
  if (words.empty()) return keys;
  const auto with_singular_at = [&](std::size_t place) {
    std::vector<std::string> changed(words.begin(), words.end());
    for (const std::string& form : singular_forms(words[place])) {
      changed[place] = form;
      keys.push_back(joined(changed, ""));
    }
  };
  const auto of = std::find(words.begin(), words.end(), "of");
  if (of != words.begin() && of != words.end()) with_singular_at(static_cast<std::size_t>(of - words.begin()) - 1);
  with_singular_at(words.size() - 1);
  return keys;
}

// Optimal string alignment: letters changed, added, left out or swapped with their neighbour.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string nearest_word(std::string_view word, std::span<const std::string> known) {
  constexpr std::size_t kLongest = 64;
  const std::string key = key_of(word.substr(0, kLongest));
  std::string best;
  std::size_t least = std::max<std::size_t>(1, key.size() / 3) + 1;
  for (const std::string& candidate : known) {
    const std::string other = key_of(candidate);
    if (other.size() > kLongest) continue;
    if (const std::size_t distance = edit_distance(key, other); distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace layoutbox
