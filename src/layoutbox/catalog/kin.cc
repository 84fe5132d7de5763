#include "layoutbox/catalog/kin.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/embedded/english_data.h"

namespace layoutbox {
namespace {

using Words = std::map<std::string_view, std::string_view>;

Words words_of_list(std::string_view key) {
  Words words;
  for (const WordList::Member member : word_list("words_kinds").at(key)) words.emplace(member.key, member.value.text());
  return words;
}

std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (end > at) words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

// The lists of words_kinds.json, in the order of Place.
constexpr std::array<std::string_view, 9> kPlaceLists = {"on_wall",       "on_floor",   "on_ceiling", "on_thing", "between_seats",
                                                         "between_sofas", "around_bed", "set_in",     "at_sides"};

struct Kinds {
  Words kinds, modifiers, heads, portions, kept_in, own_parts, company, users;
  std::array<Words, kPlaceLists.size()> at_places;  // by KinPlace
  std::set<std::string_view> no_things, no_bodies;
  std::map<std::string, std::string_view, std::less<>> like_keys;  // by the key (words.h)
};

const Kinds& known_kinds() {
  static const Kinds kinds = [] {
    Kinds read{words_of_list("kinds"),
               words_of_list("modifiers"),
               words_of_list("heads"),
               words_of_list("portions"),
               words_of_list("kept_in"),
               words_of_list("own_parts"),
               words_of_list("company"),
               words_of_list("users"),
               {},
               {},
               {},
               {}};
    std::ranges::transform(kPlaceLists, read.at_places.begin(), words_of_list);
    for (const WordList::Member kind : word_list("words_kinds").at("no_things")) read.no_things.insert(kind.value.text());
    for (const WordList::Member kind : word_list("words_kinds").at("no_bodies")) read.no_bodies.insert(kind.value.text());
    for (const auto& [word, id] : like_words()) read.like_keys.emplace(key_of(word), id);
    return read;
  }();
  return kinds;
}

// The letters of a noun that is or may be a thing, or a body in nature: alone, or after those of the verb or adjective that it mostly is.
bool is_bodily(std::string_view letters) {
  return letters.ends_with('t') || letters.ends_with('c') || letters.ends_with('o') || letters.ends_with('k');
}

// What stands for a kind, or null.
const CatalogEntry* entry_of_kind(const Catalog& catalog, std::string_view kind) {
  const auto meant = known_kinds().kinds.find(kind);
  if (meant == known_kinds().kinds.end()) return catalog.find_by_words(kind);
  return meant->second.empty() ? nullptr : catalog.find(meant->second);
}

// The kinds of a line, the nearest first.
std::vector<std::string_view> kinds_of(std::string_view line) {
  std::vector<std::string_view> kinds;
  std::size_t at = line.find(' ');
  if (!is_bodily(line.substr(0, at))) return kinds;
  while (at != std::string_view::npos) {
    const std::size_t end = line.find(' ', at + 1);
    kinds.push_back(line.substr(at + 1, end == std::string_view::npos ? end : end - at - 1));
    at = end;
  }
  return kinds;
}

const CatalogEntry* kin_by_line(const Catalog& catalog, std::string_view line) {
  for (const std::string_view kind : kinds_of(line)) {
    if (const CatalogEntry* entry = entry_of_kind(catalog, kind); entry != nullptr) return entry;
  }
  return nullptr;
}

// "A stuffed heron": birds are stuffed to look alive, other animals as toys too.
const CatalogEntry* stuffed_kind(const Catalog& catalog, std::string_view modifier, const std::string& animal) {
  if (modifier != "stuffed") return nullptr;
  for (const std::string& form : singular_forms(animal)) {
    const CatalogEntry* kin = kin_by_line(catalog, english_line(form));
    if (kin != nullptr && kin->id == "bird") return kin;
  }
  return nullptr;
}

}  // namespace

std::string_view english_line(std::string_view word) {
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

std::string_view liked_entry(std::string_view words) {
  const auto found = known_kinds().like_keys.find(key_of(words));
  return found == known_kinds().like_keys.end() ? std::string_view{} : std::string_view(found->second);
}

std::vector<std::pair<std::string_view, std::string_view>> like_words() {
  std::vector<std::pair<std::string_view, std::string_view>> all;
  for (const WordList::Member entry : word_list("words_kinds").at("like")) {
    for (const WordList::Member word : entry.value) all.emplace_back(word.value.text(), entry.key);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first == b.first; }), all.end());
  return all;
}

bool is_no_thing(const Catalog& catalog, std::string_view word) {
  if (!liked_entry(word).empty() || catalog.find_by_words(word) != nullptr) return false;
  for (const std::string& form : singular_forms(std::string(word))) {
    const std::string_view line = english_line(form);
    const auto& none = line.starts_with("c ") ? known_kinds().no_bodies : known_kinds().no_things;
    for (const std::string_view kind : kinds_of(line)) {
      if (none.contains(kind)) return true;
      if (entry_of_kind(catalog, kind) != nullptr) return false;
    }
  }
  return false;
}

const CatalogEntry* kind_at(const Catalog& catalog, std::string_view id, KinPlace place) {
  const Words& kinds = known_kinds().at_places[static_cast<std::size_t>(place)];
  const auto found = kinds.find(id);
  return found == kinds.end() ? nullptr : catalog.find(found->second);
}

std::string_view kept_in_entry(std::string_view head, const CatalogEntry& host) {
  const auto found = known_kinds().kept_in.find(head);
  if (found == known_kinds().kept_in.end()) return {};
  for (const std::string_view row : split_words(found->second)) {
    const std::size_t mark = row.find('>');
    const std::string_view said = row.substr(0, mark);
    const std::optional<Trait> trait = trait_from_name(said);
    if (said == host.id || (trait && host.is(*trait))) return row.substr(mark + 1);
  }
  return {};
}

bool is_own_part(const Catalog& catalog, std::string_view owner, std::string_view part) {
  return std::ranges::any_of(known_kinds().own_parts, [&](const auto& row) {
    return catalog.is_a(owner, row.first) &&
           std::ranges::any_of(split_words(row.second), [&](std::string_view kind) { return catalog.is_a(part, kind); });
  });
}

std::vector<std::pair<std::string_view, std::string_view>> kinds_in_company(std::string_view id) {
  std::vector<std::pair<std::string_view, std::string_view>> kinds;
  const auto found = known_kinds().company.find(id);
  if (found == known_kinds().company.end()) return kinds;
  for (const std::string_view row : split_words(found->second)) {
    const std::size_t mark = row.find('>');
    kinds.emplace_back(row.substr(0, mark), row.substr(mark + 1));
  }
  return kinds;
}

std::string_view kinds_for(std::string_view user) {
  const auto found = known_kinds().users.find(user);
  return found == known_kinds().users.end() ? std::string_view{} : std::string_view(found->second);
}

std::string_view portion_entry(std::string_view container) {
  const auto found = known_kinds().portions.find(container);
  return found == known_kinds().portions.end() ? std::string_view{} : std::string_view(found->second);
}

bool is_kin_modifier(std::string_view word) { return known_kinds().modifiers.contains(word); }

bool is_kin_head(std::string_view word) { return known_kinds().heads.contains(word); }

const CatalogEntry* kin_of(const Catalog& catalog, std::string_view noun) {
  const std::vector<std::string> words = words_of(noun);
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const auto found = known_kinds().modifiers.find(words[i]);
    if (found == known_kinds().modifiers.end()) continue;
    const CatalogEntry* stuffed = stuffed_kind(catalog, words[i], words.back());
    return stuffed != nullptr ? stuffed : catalog.find(found->second);
  }
  // The longest ending that is a word: "antique credenza" → credenza.
  for (std::size_t from = 0; from < words.size(); ++from) {
    std::string word;
    for (std::size_t i = from; i < words.size(); ++i) word += words[i];
    for (const std::string& form : singular_forms(word)) {
      if (const auto like = known_kinds().like_keys.find(form); like != known_kinds().like_keys.end()) return catalog.find(like->second);
      if (const CatalogEntry* kin = kin_by_line(catalog, english_line(form)); kin != nullptr) return kin;
    }
  }
  if (words.size() < 2) return nullptr;
  for (const std::string& form : singular_forms(words.back())) {
    if (const auto head = known_kinds().heads.find(form); head != known_kinds().heads.end()) return catalog.find(head->second);
  }
  return nullptr;
}

}  // namespace layoutbox
