#include "layoutbox/plan/llm/evidence.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "layoutbox/base/words.h"

namespace layoutbox::llm {
namespace {

using Words = std::set<std::string, std::less<>>;

const Words& determiners() {
  static const Words words{"a", "an", "one", "single"};
  return words;
}

// 0: no number.
std::size_t number_of(const std::string& word) {
  static const std::map<std::string, std::size_t, std::less<>> numbers{{"two", 2},  {"pair", 2}, {"three", 3},   {"four", 4},
                                                                       {"five", 5}, {"six", 6},  {"seven", 7},   {"eight", 8},
                                                                       {"nine", 9}, {"ten", 10}, {"eleven", 11}, {"twelve", 12}};
  if (const auto found = numbers.find(word); found != numbers.end()) return found->second;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() ? number : 0;
}

const Words& vague() {
  static const Words words{"some", "several", "few",    "many",  "various", "multiple", "numerous", "least",   "more", "most",
                           "or",   "lots",    "couple", "about", "around",  "nearly",   "possibly", "perhaps", "maybe"};
  return words;
}

// Before a noun they make it a choice, a likeness, a purpose, a part or nothing.
const Words& before_others() {
  static const Words words{"of", "or", "for", "like", "as", "than", "no", "without", "not", "resembling", "instead", "into", "from"};
  return words;
}

const Words& by_the_piece() {
  static const Words words{"each",  "every",  "both",       "per",   "either", "another",
                           "other", "others", "additional", "extra", "second", "third"};
  return words;
}

const Words& pronouns() {
  static const Words words{"it", "they", "them", "its", "their", "these", "those", "this", "that", "which", "one", "other", "opposite"};
  return words;
}

bool ends_sentence(char c) { return c == '.' || c == '!' || c == '?' || c == ';' || c == '\n'; }

}  // namespace

Evidence::Evidence(const Plan& plan, const Catalog& catalog) : plan_(plan), catalog_(catalog) {}

std::string Evidence::word(std::size_t reading) const {
  const WordReading& at = plan_.readings[reading];
  const std::string_view prompt = plan_.scene.prompt;
  if (at.end > prompt.size() || at.begin >= at.end) return {};
  const std::vector<std::string> words = words_of(prompt.substr(at.begin, at.end - at.begin));
  return words.empty() ? std::string() : words.front();
}

// Of several that were brought in together the first is named in the readings.
std::string Evidence::role_of(const SceneObject& object) const {
  std::size_t at = object.id.find_last_not_of("0123456789");
  if (at == std::string::npos || at + 1 == object.id.size()) return {};
  const std::string stem = object.id.substr(0, at + 1);
  for (int number = std::atoi(object.id.c_str() + at + 1); number > 0; --number) {
    const std::string role = "object " + stem + std::to_string(number);
    if (std::ranges::any_of(plan_.readings, [&](const WordReading& reading) { return reading.role == role; })) return role;
  }
  return {};
}

std::vector<Evidence::Phrase> Evidence::phrases_of(std::string_view role) const {
  std::vector<Phrase> phrases;
  for (std::size_t i = 0; i < plan_.readings.size(); ++i) {
    if (plan_.readings[i].role != role) continue;
    if (!phrases.empty() && phrases.back().last == i)
      phrases.back().last = i + 1;
    else
      phrases.push_back({i, i + 1});
  }
  return phrases;
}

Evidence::Phrase Evidence::sentence_of(std::size_t reading) const {
  const std::string_view prompt = plan_.scene.prompt;
  const auto border = [&](std::size_t left) {  // between that reading and the next
    const std::size_t from = plan_.readings[left].end, to = plan_.readings[left + 1].begin;
    return from <= to && to <= prompt.size() && std::ranges::any_of(prompt.substr(from, to - from), ends_sentence);
  };
  Phrase sentence{reading, reading + 1};
  while (sentence.first > 0 && !border(sentence.first - 1)) --sentence.first;
  while (sentence.last < plan_.readings.size() && !border(sentence.last - 1)) ++sentence.last;
  return sentence;
}

bool Evidence::is_plain(const SceneObject& object) const {
  const CatalogEntry* entry = catalog_.find(object.category);
  return entry != nullptr && catalog_.find_by_words(object.name) == entry;
}

bool Evidence::stands_alone(const Phrase& phrase) const {
  if (phrase.first > 0 && before_others().contains(word(phrase.first - 1))) return false;
  if (phrase.last >= plan_.readings.size()) return true;
  const WordReading& next = plan_.readings[phrase.last];
  return next.use != WordReading::Use::kNotUnderstood && word(phrase.last) != "or";
}

bool Evidence::names(const SceneObject& object) const {
  if (!object.asked() || !is_plain(object)) return false;
  const std::vector<Phrase> phrases = phrases_of(role_of(object));
  if (phrases.empty() || !stands_alone(phrases.front())) return false;
  const Phrase& phrase = phrases.front();
  const auto is_counted = [&](std::size_t i) { return i < phrase.last && number_of(word(i)) > 0; };
  const bool counted = is_counted(phrase.first) || is_counted(phrase.first + 1);  // "two", "a pair of"
  const auto all = std::ranges::count(plan_.scene.objects, object.category, &SceneObject::category);
  if (!counted) return all == 1 && determiners().contains(word(phrase.first));
  return counts(object.category, static_cast<std::size_t>(all));
}

bool Evidence::counts(std::string_view category, std::size_t count) const {
  const auto first = std::ranges::find(plan_.scene.objects, category, &SceneObject::category);
  if (first == plan_.scene.objects.end() || !first->asked() || !is_plain(*first)) return false;
  const std::vector<Phrase> phrases = phrases_of(role_of(*first));
  if (phrases.size() != 1 || !stands_alone(phrases.front())) return false;
  const Phrase phrase = phrases.front();
  std::size_t said = 0;
  for (std::size_t i = phrase.first; i < phrase.last; ++i) {
    const std::string text = word(i);
    const std::size_t number = text == "one" || text == "single" ? 1 : number_of(text);
    if (vague().contains(text) || (number > 0 && said > 0)) return false;
    said = std::max(said, number);
  }
  if (said != count) return false;
  const Phrase sentence = sentence_of(phrase.first);
  for (std::size_t i = sentence.first; i < sentence.last; ++i) {
    if (by_the_piece().contains(word(i))) return false;
  }
  const std::vector<std::string> own = words_of(first->name);
  const std::string head = own.empty() ? std::string() : singular_of(own.back());
  for (std::size_t i = 0; i < plan_.readings.size(); ++i) {
    if ((i < phrase.first || i >= phrase.last) && singular_of(word(i)) == head) return false;
  }
  return true;
}

bool Evidence::relates(const Relation& relation) const {
  if (!relation.asked() || !relation.hard || relation.targets.size() != 1 || relation.references.size() > 1) return false;
  const std::string role = "relation " + relation.id;
  const auto at = std::ranges::find(plan_.readings, role, &WordReading::role);
  if (at == plan_.readings.end()) return false;
  const Phrase sentence = sentence_of(static_cast<std::size_t>(at - plan_.readings.begin()));
  Words things;
  std::vector<std::string> wanted;
  for (const auto* ids : {&relation.targets, &relation.references}) {
    for (const std::string& id : *ids) {
      const SceneObject* object = plan_.scene.find_object(id);
      if (object == nullptr) continue;
      if (!is_plain(*object) || std::ranges::count(plan_.scene.objects, object->category, &SceneObject::category) != 1) return false;
      wanted.push_back(object->name);
    }
  }
  for (std::size_t i = sentence.first; i < sentence.last; ++i) {
    const WordReading& reading = plan_.readings[i];
    const std::string text = word(i);
    if (reading.use == WordReading::Use::kNotUnderstood || pronouns().contains(text) || vague().contains(text)) return false;
    if (reading.role.starts_with("relation ") && reading.role != role) return false;
    for (const SceneObject& object : plan_.scene.objects) {
      if (reading.role == object.name || reading.role == "object " + object.id) things.insert(object.name);
    }
  }
  // Nothing else is spoken of there, and all that it relates is.
  return things.size() == wanted.size() && std::ranges::all_of(wanted, [&](const std::string& name) { return things.contains(name); });
}

}  // namespace layoutbox::llm
