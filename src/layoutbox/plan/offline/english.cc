#include "layoutbox/plan/offline/english.h"

#include <algorithm>
#include <array>
#include <string>

#include "layoutbox/base/words.h"
#include "layoutbox/embedded/plan_data.h"

namespace layoutbox::offline {
namespace {

// The rest of the line of `word` in the sorted table: "t sofa", "v"; empty where it is not there. Searched in place: nothing is read at
// start.
std::string_view line_of(std::string_view word) {
  const std::string_view table = embedded::words_english_txt;
  std::size_t low = 0, high = table.size();
  while (low < high) {
    std::size_t begin = low + (high - low) / 2;
    while (begin > low && table[begin - 1] != '\n') --begin;
    const std::size_t end = std::min(table.find('\n', begin), table.size());
    const std::string_view line = table.substr(begin, end - begin);
    const std::size_t space = line.find(' ');
    const int order = word.compare(line.substr(0, space));
    if (order == 0) return line.substr(space + 1);
    if (order < 0) {
      high = begin;
    } else {
      low = end + 1;
    }
  }
  return {};
}

WordForm form_of(std::string_view line) {
  if (line.empty()) return WordForm::kUnknown;
  switch (line[0]) {
    case 't': return WordForm::kThing;
    case 'n': return WordForm::kNoun;
    case 'v': return WordForm::kVerb;
    case 'a': return WordForm::kAdjective;
    default: return WordForm::kAdverb;
  }
}

}  // namespace

WordForm word_form(std::string_view word) {
  if (const WordForm form = form_of(line_of(word)); form != WordForm::kUnknown) return form;
  for (const std::string& singular : singular_forms(word)) {
    if (const WordForm form = form_of(line_of(singular)); form == WordForm::kThing || form == WordForm::kNoun || form == WordForm::kVerb)
      return form;
  }
  if (word.ends_with("ly")) return WordForm::kAdverb;
  for (const std::string_view ending : {"ing", "ed"}) {
    if (!word.ends_with(ending) || word.size() < ending.size() + 3) continue;
    const std::string base(word.substr(0, word.size() - ending.size()));
    const std::string undoubled = base[base.size() - 1] == base[base.size() - 2] ? base.substr(0, base.size() - 1) : base;
    for (const std::string& stem : {base, base + "e", undoubled}) {
      if (form_of(line_of(stem)) == WordForm::kVerb) return WordForm::kVerb;
    }
    return WordForm::kAdjective;
  }
  return WordForm::kUnknown;
}

const CatalogEntry* known_kind(const Catalog& catalog, std::string_view noun) {
  std::string word = key_of(noun);
  std::string_view line = line_of(word);
  if (line.empty()) {
    // The last word alone: "antique credenza" → credenza.
    const std::vector<std::string> words = words_of(noun);
    for (std::size_t from = words.empty() ? 0 : 1; from < words.size() && line.empty(); ++from) {
      word.clear();
      for (std::size_t i = from; i < words.size(); ++i) word += words[i];
      line = line_of(word);
      if (line.empty()) line = line_of(singular_forms(word).back());
    }
  }
  constexpr int kMostSteps = 12;
  for (int step = 0; step < kMostSteps && line.starts_with("t "); ++step) {
    const std::string_view general = line.substr(2);
    // Too general to say anything of size and place.
    static constexpr std::array<std::string_view, 14> kTooGeneral = {"device",  "object",    "artifact",  "instrumentality", "container",
                                                                     "machine", "equipment", "structure", "covering",        "product",
                                                                     "article", "commodity", "implement", "furniture"};
    if (std::find(kTooGeneral.begin(), kTooGeneral.end(), general) != kTooGeneral.end()) return nullptr;
    if (const CatalogEntry* entry = catalog.find_by_words(general)) return entry;
    line = line_of(general);
  }
  return nullptr;
}

bool is_collective(std::string_view singular) {
  static constexpr std::array<std::string_view, 18> kCollectives = {
      "item",     "essential", "product", "accessory", "supply",  "object", "trinket",  "knickknack", "decoration",
      "ornament", "toiletry",  "good",    "keepsake",  "utensil", "tool",   "valuable", "belonging",  "peripheral"};
  return std::find(kCollectives.begin(), kCollectives.end(), singular) != kCollectives.end();
}

}  // namespace layoutbox::offline
