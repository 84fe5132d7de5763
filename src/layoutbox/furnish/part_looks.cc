#include "layoutbox/furnish/part_looks.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "layoutbox/base/words.h"
#include "layoutbox/embedded/catalog_data.h"
#include "layoutbox/furnish/prompt_words.h"

namespace layoutbox {
namespace {

constexpr std::size_t kMostBefore = 7, kMostAfter = 6;  // words that say how a part looks

struct NamedPart {
  std::string name, of;  // of: the last word of whose name the thing has that it is of, where nothing else says so ("bed")
  std::vector<std::vector<std::string>> phrases;
};

struct PartWords {
  std::vector<NamedPart> parts;
  std::vector<NamedPart> of_things;
  std::vector<std::string> passed, joins;   // words among those of a look that say nothing of it; words between a part and its look
  std::vector<std::string> belongs, after;  // words between a thing and its part; between a thing's part and its look
};

std::vector<std::string> strings(const nlohmann::json& json) { return words_of(json.get<std::string>()); }

std::vector<NamedPart> named_parts(const nlohmann::json& list) {
  std::vector<NamedPart> parts;
  for (const nlohmann::json& json : list) {
    NamedPart part{json.at("part").get<std::string>(), json.value("of", ""), {}};
    for (const nlohmann::json& phrase : json.at("words")) part.phrases.push_back(strings(phrase));
    parts.push_back(std::move(part));
  }
  return parts;
}

PartWords read_part_words() {
  const nlohmann::json data = nlohmann::json::parse(embedded::decor_json).at("parts");
  return {named_parts(data.at("of")), named_parts(data.at("of_things")), strings(data.at("passed")),
          strings(data.at("joins")),  strings(data.at("belongs")),       strings(data.at("after"))};
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
  if (is_banned_at(text, from)) return std::nullopt;
  return look_of(std::span(text).subspan(from, at - from));
}

// After a word that joins the two ("fronts in white").
std::optional<PartLook> look_after(const Clause& text, std::size_t at, const std::vector<std::string>& joins) {
  if (at >= text.size() || !is_listed(joins, text[at])) return std::nullopt;
  while (at < text.size() && is_listed(joins, text[at])) ++at;
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

// The words of the names of the things of a room.
using ThingNames = std::vector<std::vector<std::string>>;

bool same_word(const std::string& said, const std::string& word) { return said == word || singular_of(said) == word; }

// The longest of the names whose last word is said at `at`, if its other words are said before it.
const std::vector<std::string>* name_ending_at(const ThingNames& names, const Clause& text, std::size_t at) {
  const std::vector<std::string>* longest = nullptr;
  for (const std::vector<std::string>& name : names) {
    if (name.empty() || name.size() > at + 1 || (longest != nullptr && longest->size() >= name.size())) continue;
    const std::size_t first = at + 1 - name.size();
    if (same_word(text[at], name.back()) && std::equal(name.begin(), name.end() - 1, text.begin() + std::ptrdiff_t(first))) longest = &name;
  }
  return longest;
}

// Whose part it is that is named from `at` to `end`: of the thing right behind it ("marble top coffee table"), else of the one before it
// that has it ("a coffee table with a marble top and brass legs").
const std::vector<std::string>* owner_of(const ThingNames& names, const Clause& text, std::size_t at, std::size_t end) {
  constexpr std::size_t kLongestName = 3;  // words
  for (std::size_t i = end; i < std::min(text.size(), end + kLongestName) && !is_listed(words_of_parts().belongs, text[i]); ++i) {
    if (const auto* name = name_ending_at(names, text, i)) return name;
  }
  const auto is_part_word = [&](std::size_t i) {
    return std::ranges::any_of(words_of_parts().of_things, [&](const NamedPart& part) {
      return std::ranges::any_of(part.phrases, [&](const auto& phrase) { return phrase.size() == 1 && phrase[0] == text[i]; });
    });
  };
  for (std::size_t i = at; i-- > 0;) {
    if (const auto* name = name_ending_at(names, text, i)) return name;
    if (!is_listed(words_of_parts().belongs, text[i]) && !says_look(text[i]) && !is_part_word(i)) return nullptr;
  }
  return nullptr;
}

// What is said of it before and after: "a velvet headboard in emerald".
std::optional<PartLook> look_around(const Clause& text, std::size_t at, std::size_t end) {
  std::optional<PartLook> look = look_before(text, at);
  const std::optional<PartLook> after = look_after(text, end, words_of_parts().after);
  if (!look) return after;
  if (!after) return look;
  if (look->colors.empty()) look->colors = after->colors;
  if (look->material == nullptr) look->material = after->material;
  return look;
}

void add_thing_parts(ThingParts& all, const NamedPart& part, const ThingNames& names, const Clause& text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t length = named_at(part, text, at);
    const std::optional<PartLook> look = length == 0 ? std::nullopt : look_around(text, at, at + length);
    if (!look) continue;
    const std::vector<std::string>* owner = owner_of(names, text, at, at + length);
    for (const std::vector<std::string>& name : names) {
      const bool usual = owner == nullptr && !part.of.empty() && !name.empty() && name.back() == part.of;
      if (!usual && owner != &name) continue;
      std::string thing;
      for (const std::string& word : name) thing += (thing.empty() ? "" : " ") + word;
      all[thing].emplace(part.name, *look);
    }
  }
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
        if (!look) look = look_after(text, at + length, words_of_parts().joins);
        if (look) looks.emplace(part.name, *std::move(look));
      }
    }
  }
  return looks;
}

ThingParts thing_parts(const Layout& layout) {
  ThingParts all;
  ThingNames names;
  for (const PlacedObject& object : layout.objects) {
    std::vector<std::string> name = words_of(object.name);
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  for (const Clause& text : clauses(layout.prompt)) {
    for (const NamedPart& part : words_of_parts().of_things) add_thing_parts(all, part, names, text);
  }
  return all;
}

}  // namespace layoutbox
