#include "layoutbox/furnish/part_looks.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "layoutbox/base/words.h"
#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox {
namespace {

constexpr std::size_t kMostBefore = 7, kMostAfter = 6;  // words that say how a part looks

struct NamedPart {
  std::string name;
  std::vector<std::vector<std::string>> phrases;
};

struct PartWords {
  std::vector<NamedPart> parts;
  std::vector<std::string> passed, joins;  // words among those of a look that say nothing of it; words between a part and its look
};

std::vector<std::string> strings(const nlohmann::json& json) { return words_of(json.get<std::string>()); }

PartWords read_part_words() {
  const nlohmann::json data = nlohmann::json::parse(embedded::decor_json).at("parts");
  PartWords words{{}, strings(data.at("passed")), strings(data.at("joins"))};
  for (const nlohmann::json& json : data.at("of")) {
    NamedPart part{json.at("part").get<std::string>(), {}};
    for (const nlohmann::json& phrase : json.at("words")) part.phrases.push_back(strings(phrase));
    words.parts.push_back(std::move(part));
  }
  return words;
}

const PartWords& words_of_parts() {
  static const PartWords all = read_part_words();
  return all;
}

bool is_listed(const std::vector<std::string>& list, const std::string& word) { return std::ranges::find(list, word) != list.end(); }

using Clause = std::vector<std::string>;  // the words of a clause

std::vector<Clause> clauses(std::string_view prompt) {
  std::vector<Clause> all;
  for (std::size_t at = 0; at < prompt.size();) {
    const std::size_t end = std::min(prompt.find_first_of(",.;!?\n()", at), prompt.size());
    all.push_back(words_of(prompt.substr(at, end - at)));
    at = end + 1;
  }
  return all;
}

bool says_look(const std::string& word) { return is_look_word(word) || word == "and" || is_listed(words_of_parts().passed, word); }

// The look that these words say; nothing where they name neither a colour nor a material.
std::optional<PartLook> look_of(std::span<const std::string> said) {
  PartLook look;
  for (auto from = said.begin(); from != said.end();) {
    const auto to = std::find(from, said.end(), "and");
    std::string some;
    for (auto word = from; word != to; ++word) some += *word + " ";
    const SurfaceWish wish = read_wish(some);
    if (wish.color) look.colors.push_back(*wish.color);
    if (look.material == nullptr && !wish.materials.empty()) look.material = wish.materials.front();
    from = to == said.end() ? to : to + 1;
  }
  return look.colors.empty() && look.material == nullptr ? std::nullopt : std::optional(look);
}

std::optional<PartLook> look_before(const Clause& text, std::size_t at) {
  std::size_t from = at;
  while (from > 0 && at - from < kMostBefore && says_look(text[from - 1])) --from;
  return look_of(std::span(text).subspan(from, at - from));
}

// After a word that joins the two ("fronts in white").
std::optional<PartLook> look_after(const Clause& text, std::size_t at) {
  if (at >= text.size() || !is_listed(words_of_parts().joins, text[at])) return std::nullopt;
  while (at < text.size() && is_listed(words_of_parts().joins, text[at])) ++at;
  std::size_t to = at;
  while (to < text.size() && to - at < kMostAfter && says_look(text[to])) ++to;
  return look_of(std::span(text).subspan(at, to - at));
}

// Where a part is named; its words at `at`.
std::size_t named_at(const NamedPart& part, const Clause& text, std::size_t at) {
  std::size_t longest = 0;
  for (const auto& phrase : part.phrases) {
    const bool fits = at + phrase.size() <= text.size() && std::equal(phrase.begin(), phrase.end(), text.begin() + std::ptrdiff_t(at));
    if (fits) longest = std::max(longest, phrase.size());
  }
  return longest;
}

}  // namespace

PartLooks part_looks(std::string_view prompt) {
  PartLooks looks;
  const std::vector<Clause> all = clauses(prompt);
  for (const NamedPart& part : words_of_parts().parts) {
    for (const Clause& text : all) {
      for (std::size_t at = 0; at < text.size() && !looks.contains(part.name); ++at) {
        const std::size_t length = named_at(part, text, at);
        if (length == 0) continue;
        std::optional<PartLook> look = look_before(text, at);
        if (!look) look = look_after(text, at + length);
        if (look) looks.emplace(part.name, *std::move(look));
      }
    }
  }
  return looks;
}

}  // namespace layoutbox
