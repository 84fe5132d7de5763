// Which of the things that were named a noun phrase may mean.
#include <algorithm>
#include <limits>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/references.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

std::string last_word(const std::string& name) {
  const std::string plain = name.substr(0, name.find(" of "));
  return singular_of(plain.substr(plain.rfind(' ') + 1));  // npos + 1: all of it
}

// "a lower shelf of the bookshelf", "one of the bookshelf shelves": the words for whose shelf it is, or nothing.
std::string owner_of_shelf(const NounPhrase& noun) {
  if (noun.head != "shelf") return {};
  if (const std::size_t of = noun.name.find("shelf of "); of != std::string::npos) {
    const std::string owner = noun.name.substr(of + std::string_view("shelf of ").size());
    return owner.starts_with("the ") ? owner.substr(4) : owner;
  }
  return noun.name.ends_with(" shelf") ? noun.name.substr(0, noun.name.size() - std::string_view(" shelf").size()) : std::string{};
}

// "the counter" is rather a base cabinet than the sink or the island: how far a kind of it is what such things mostly are.
int likeness(const NounPhrase& wanted, const NounPhrase& item) {
  if (wanted.entry == nullptr || item.entry == nullptr) return 0;
  return (wanted.entry->top_carries == item.entry->top_carries ? 1 : 0) +
         (wanted.entry->is(Trait::kKitchenRun) == item.entry->is(Trait::kKitchenRun) ? 1 : 0);
}

// "the desk … the table", where the desk was named for the first time as if known: two things, though a desk is a kind of table.
bool is_contrasted(const NounPhrase& wanted, const NounPhrase& item) {
  if (wanted.determiner != Determiner::kDefinite || item.determiner != Determiner::kDefinite || wanted.is_plural()) return false;
  if (!wanted.exact || !item.exact || wanted.entry == item.entry || wanted.name.find(' ') != std::string::npos) return false;
  return wanted.entry->is(Trait::kTable) && !item.name.ends_with(wanted.head) && !item.entry->name.ends_with(wanted.head);
}

// What is said of it and what was said of the other.
int qualities_shared(const NounPhrase& wanted, const NounPhrase& item) {
  int score = 0;
  for (const std::string& attribute : wanted.attributes) {
    const auto same = [&](const std::string& own) { return same_quality(own, attribute); };
    score += std::ranges::any_of(item.attributes, same) ? 3 : -1;
  }
  return score;
}

bool says_any(const NounPhrase& noun, WordSet set) {
  return std::ranges::any_of(noun.attributes, [&](const std::string& word) { return one_of(word, set); });
}

// What is said of its color, and none of it of the other's.
bool has_other_color(const NounPhrase& wanted, const NounPhrase& item) {
  const auto colors = [](const NounPhrase& noun) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < noun.attributes.size(); ++i) {
      if (noun.attribute_classes[i] == WordClass::kColor) words.push_back(noun.attributes[i]);
    }
    return words;
  };
  const std::vector<std::string> one = colors(wanted), other = colors(item);
  return !one.empty() && !other.empty() && std::ranges::none_of(one, [&](const std::string& color) {
    return std::ranges::any_of(
        other, [&](const std::string& own) { return color.find(own) != std::string::npos || own.find(color) != std::string::npos; });
  });
}

// "the red chair … the blue chair", "the small table … the large table": two things.
bool is_contrary(const NounPhrase& wanted, const NounPhrase& item) {
  if (wanted.is_plural() || item.count > 1 || wanted.attributes.empty() || item.attributes.empty()) return false;
  static constexpr std::pair<WordSet, WordSet> kContraries[] = {{WordSet::kGreat, WordSet::kSlight}, {WordSet::kAged, WordSet::kRecent}};
  return has_other_color(wanted, item) || std::ranges::any_of(kContraries, [&](const auto& pair) {
           return (says_any(wanted, pair.first) && says_any(item, pair.second) && !says_any(item, pair.first)) ||
                  (says_any(wanted, pair.second) && says_any(item, pair.first) && !says_any(item, pair.second));
         });
}

// "an office chair … behind that chair": the one that was named last, whatever its whole name.
bool points(const Document& document, const NounPhrase& noun) {
  return noun.first < document.tokens.size() && one_of(document.tokens[noun.first].text, {"that", "this"});
}

// Said of somebody's, and the item is not his.
bool is_anothers(const NounPhrase& wanted, const NounPhrase& item) {
  if (wanted.owner_word.empty()) return false;
  if (!item.owner_word.empty()) return wanted.owner_word != item.owner_word;  // "the dentist's stool … the assistant's stool": two
  if (item.count > 1 && !wanted.is_plural()) return true;                     // "twelve mats … the instructor's mat": none of the twelve
  // "the judge's bench … the clerk's desk": another one
  return item.name.find("'s ") != std::string::npos && item.name.find(wanted.owner_word) == std::string::npos;
}

// "a piano … beside the instrument", "a fireplace … at the hearth".
bool is_general_for(const Catalog& catalog, const NounPhrase& wanted, const NounPhrase& item) {
  static const WordList kWords = word_list("words_kinds").at("general");
  if (wanted.determiner != Determiner::kDefinite || wanted.is_plural() || wanted.name != wanted.head || item.entry == nullptr) return false;
  if (!kWords.contains(wanted.head)) return false;
  for (const WordList::Member kind : kWords.at(wanted.head)) {
    if (catalog.is_a(item.entry->id, kind.value.text())) return true;
  }
  return false;
}

// "a bar table … on the bar": short for it, where both have a top.
bool is_short_for(const NounPhrase& wanted, const NounPhrase& item) {
  return wanted.determiner == Determiner::kDefinite && wanted.exact && item.entry != nullptr && wanted.entry->is(Trait::kCounter) &&
         item.name == wanted.name + " table" && item.entry->top_carries;
}

}  // namespace

bool References::same_kind(const NounPhrase& wanted, const NounPhrase& item) const { return fit(wanted, item) > 0; }

// 4: the same words, 3: the same kind, 2: a kind of it, 1: a word for something more general or the same head noun.
int References::fit(const NounPhrase& wanted, const NounPhrase& item) const {
  const Catalog& catalog = lexicon_.catalog();
  if (is_anothers(wanted, item) || is_contrary(wanted, item)) return 0;
  if (wanted.name == item.name) return 4;
  // "the captain's chair" is no pilot seat.
  const std::size_t owner = wanted.name.find("'s ");
  if (owner != std::string::npos && wanted.head != item.head && item.name.find(wanted.name.substr(0, owner)) == std::string::npos) return 0;
  if (wanted.name.starts_with(item.name + " ") && one_of(wanted.name.substr(item.name.size() + 1), WordSet::kPartsCalledAfter)) return 3;
  if (wanted.exact && item.exact && wanted.entry == item.entry) return 3;
  if (is_short_for(wanted, item)) return 3;
  if (is_contrasted(wanted, item)) return 0;
  // "a console table … on the console": what no list has is short for what was named.
  if (!wanted.exact && wanted.determiner == Determiner::kDefinite && item.name.starts_with(wanted.name + " ")) return 2;
  if (last_word(wanted.name) == last_word(item.name) &&
      (wanted.name.find(' ') == std::string::npos || item.name.find(' ') == std::string::npos)) {
    // "the table" is any table; "the coffee table" is not a plain table that was named before it.
    // A table for a trade of its own is not the plain one either: "the cutting table".
    const std::string trade = wanted.name.substr(0, wanted.name.find(' '));
    const bool apart = item.is_plural() || (trade.ends_with("ing") && trade != "dining");
    const bool kind_apart = wanted.exact && wanted.entry != item.entry && apart && !wanted.is_plural();
    if (wanted.name.find(' ') == std::string::npos) return 2;
    return kind_apart ? 0 : 1;  // "the teacher's desk" is none of the desks
  }
  // "the seat" is any chair; "the violin case", which is only like an instrument, is no cello.
  const bool is_its_name = wanted.name.find(' ') == std::string::npos || catalog.find_by_words(wanted.name) == wanted.entry;
  if (wanted.exact && is_its_name && item.entry != nullptr && wanted.entry != nullptr && wanted.entry != item.entry &&
      catalog.is_a(item.entry->id, wanted.entry->id))
    return 2;
  if (wanted.entry != nullptr && item.entry == wanted.entry && (wanted.exact || item.exact) && wanted.name.find(' ') == std::string::npos &&
      (item.exact || wanted.owner_word.empty()))
    return 2;
  // "the bench" is the workbench, "the table" no turntable.
  constexpr std::size_t kShortest = 5;
  const bool other_mount = wanted.entry != nullptr && item.entry != nullptr && wanted.entry->mount != item.entry->mount;
  if (!other_mount && wanted.name.size() >= kShortest && item.head.size() > wanted.name.size() && item.head.ends_with(wanted.name))
    return 1;
  // "twelve student desks … the teacher's desk": each has a name of its own.
  const bool own_names = wanted.name.find(' ') != std::string::npos && item.name.find(' ') != std::string::npos &&
                         wanted.entry != item.entry && !wanted.is_plural() && item.is_plural();
  const bool same_head = !own_names && (wanted.head.ends_with(item.head) || item.head.ends_with(wanted.head));
  if (same_head && wanted.exact && item.exact && catalog.is_a(wanted.entry->id, item.entry->id) &&
      wanted.determiner == Determiner::kDefinite)
    return 1;
  return is_general_for(catalog, wanted, item) ? 1 : 0;
}

std::vector<int> References::known(const NounPhrase& noun) const {
  // The best fitting kind; of equals the latest mention. Attributes that were said of it count.
  int best_score = std::numeric_limits<int>::min();
  std::vector<int> found;
  const bool pointed = !noun.is_plural() && points(document_, noun);
  for (std::size_t i = document_.items.size(), looked = 0; i-- > 0 && looked < kReach; ++looked) {
    const NounPhrase& item = document_.items[i].noun;
    const int kind = fit(noun, item);
    if (kind == 0) continue;
    const int score = (pointed ? 0 : kind * 10) + likeness(noun, item) + (noun.head == item.head ? 1 : 0) + qualities_shared(noun, item);
    const bool all = noun.is_plural() || noun.determiner == Determiner::kEach || noun.ordinal != 0;
    if (!all && score == best_score) continue;
    if (score < best_score) continue;
    if (score > best_score) found.clear();
    best_score = score;
    found.push_back(static_cast<int>(i));
  }
  std::reverse(found.begin(), found.end());
  if (!found.empty() && noun.ordinal != 0) {
    const std::size_t at = noun.ordinal < 0 ? found.size() : static_cast<std::size_t>(noun.ordinal);
    return at > found.size() ? std::vector<int>{} : singled_out(found, noun);
  }
  if (!found.empty() && !noun.is_plural() && noun.determiner != Determiner::kEach) {
    // A singular names one thing; which member of a group, "left" and "other" say.
    const int group = document_.items[static_cast<std::size_t>(found.front())].group;
    std::vector<int> members;
    for (std::size_t i = 0; i < document_.items.size(); ++i) {
      if (document_.items[i].group == group) members.push_back(static_cast<int>(i));
    }
    return members;
  }
  if (noun.determiner == Determiner::kEach && !found.empty()) {
    // "each table": those that were brought in together last, if several were.
    std::map<int, std::vector<int>> groups;
    for (const int item : found) groups[document_.items[static_cast<std::size_t>(item)].group].push_back(item);
    for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
      if (group->second.size() > 1) return group->second;
    }
  }
  return found;
}

// What was named and has the shelf, or nothing.
std::vector<int> References::whose_shelf(const NounPhrase& noun) const {
  const std::string owner = owner_of_shelf(noun);
  for (std::size_t i = document_.items.size(), looked = 0; !owner.empty() && i-- > 0 && looked < kReach; ++looked) {
    const NounPhrase& item = document_.items[i].noun;
    const bool shelves = item.entry != nullptr &&
                         std::any_of(item.entry->spaces.begin(), item.entry->spaces.end(), [](const SpaceFormula& s) { return s.carries; });
    if (shelves && (item.name == owner || item.head == owner)) return {static_cast<int>(i)};
  }
  return {};
}

}  // namespace layoutbox::offline
