#include "layoutbox/judge/vocabulary.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox::scoring {
namespace {

using CheckWords = std::map<std::string, std::string, std::less<>>;  // word → check

struct Vocabulary {
  std::set<std::string, std::less<>> prepositions, general, shelf_like, hanger_like, ring;
  std::map<std::string, CheckWords, std::less<>> lists;
};

Vocabulary read_vocabulary() {
  const auto data = nlohmann::json::parse(embedded::annotation_words_json);
  Vocabulary vocabulary;
  const auto fill = [&](std::set<std::string, std::less<>>& set, const char* key) {
    for (const auto& word : data.at(key)) set.insert(word.get<std::string>());
  };
  fill(vocabulary.prepositions, "prepositions");
  fill(vocabulary.general, "general");
  fill(vocabulary.shelf_like, "shelf_like");
  fill(vocabulary.hanger_like, "hanger_like");
  fill(vocabulary.ring, "ring");
  for (const char* list : {"objects", "faces", "wall", "opening", "ceiling", "floor", "room"}) {
    for (const auto& [check, words] : data.at(list).items()) {
      for (const auto& word : words) vocabulary.lists[list].emplace(word.get<std::string>(), check);
    }
  }
  return vocabulary;
}

const Vocabulary& vocabulary() {
  static const Vocabulary words = read_vocabulary();
  return words;
}

std::string joined(const Phrase& phrase) {
  std::string text;
  for (const std::string& word : phrase) text += (text.empty() ? "" : " ") + word;
  return text;
}

bool names_exactly(const CatalogEntry& entry, const Phrase& phrase) {
  const auto is_it = [&](const std::string& name) { return phrase_of(name) == phrase; };
  return is_it(entry.id) || is_it(entry.name) || std::any_of(entry.synonyms.begin(), entry.synonyms.end(), is_it);
}

std::string_view last_word(const Phrase& phrase) { return phrase.empty() ? std::string_view{} : std::string_view(phrase.back()); }

}  // namespace

Phrase phrase_of(std::string_view text) {
  Phrase phrase = words_of(text);
  for (std::string& word : phrase) word = singular_of(word);
  return phrase;
}

Phrase head_of(Phrase phrase) {
  for (std::size_t i = 1; i < phrase.size(); ++i) {
    if (vocabulary().prepositions.contains(phrase[i])) {
      phrase.resize(i);
      break;
    }
  }
  return phrase;
}

std::string_view check_for(std::string_view word, std::string_view list) {
  const CheckWords& words = vocabulary().lists.find(list)->second;
  std::string key = snake_case(word);
  for (int round = 0; round < 2; ++round) {
    if (const auto found = words.find(key); found != words.end()) return found->second;
    const std::size_t cut = key.rfind('_');
    if (cut == std::string::npos) break;
    const std::string last = key.substr(cut + 1);
    if (last != "of" && last != "from" && last != "to" && last != "the") break;
    key.resize(cut);
  }
  return {};
}

bool is_ring_word(std::string_view word) { return vocabulary().ring.contains(snake_case(word)); }

bool is_part_of_room(std::string_view element) {
  return element == "wall" || element == "door" || element == "window" || element == "ceiling" || element == "floor" || element == "room";
}

bool ends_in(const Phrase& phrase, const Phrase& end) {
  return !end.empty() && end.size() <= phrase.size() && std::equal(end.rbegin(), end.rend(), phrase.rbegin());
}

bool is_shelf_like(std::string_view category) { return vocabulary().shelf_like.contains(last_word(head_of(phrase_of(category)))); }
bool is_hanger_like(std::string_view category) { return vocabulary().hanger_like.contains(last_word(head_of(phrase_of(category)))); }

const NounMatcher::Noun& NounMatcher::noun(const std::string& text) {
  const auto [place, is_new] = nouns_.try_emplace(text);
  Noun& found = place->second;
  if (!is_new) return found;
  found.words = phrase_of(text);
  found.head = head_of(found.words);
  for (const Phrase* phrase : {&found.words, &found.head}) {
    const CatalogEntry* entry = phrase->empty() ? nullptr : catalog_.find_by_words(joined(*phrase));
    if (entry == nullptr) continue;
    found.entry = entry;
    found.whole = names_exactly(*entry, *phrase);
    if (found.whole) break;
  }
  return found;
}

int NounMatcher::narrowness(const std::string& wanted) { return static_cast<int>(noun(wanted).words.size()); }

int NounMatcher::strength(const std::string& wanted, const std::string& text) {
  const auto [place, is_new] = strengths_.try_emplace({wanted, text}, 0);
  if (!is_new) return place->second;
  const Noun& want = noun(wanted);
  const Noun& have = noun(text);
  const auto rate = [&] {
    if (want.words.empty() || have.words.empty()) return 0;
    if (want.words == have.words) return 4;
    if (want.words == have.head || (want.whole && have.whole && want.entry == have.entry)) return 3;
    if (ends_in(have.head, want.words)) return 2;
    if (want.whole && have.entry != nullptr) {
      if (want.entry == have.entry) return 2;
      if (vocabulary().general.contains(want.entry->id) && catalog_.is_a(have.entry->id, want.entry->id)) return 2;
    }
    return ends_in(want.head, have.head) ? 1 : 0;
  };
  return place->second = rate();
}

}  // namespace layoutbox::scoring
