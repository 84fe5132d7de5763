#include "layoutbox/plan/offline/references.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {
namespace {

std::string last_word(const std::string& name) {
  const std::string plain = name.substr(0, name.find(" of "));
  return singular_of(plain.substr(plain.rfind(' ') + 1));  // npos + 1: all of it
}

// "the shelf", "the top shelf": a part of what has shelves.
bool is_own_shelf(const NounPhrase& noun) {
  static constexpr std::string_view kWhich[] = {"shelf",       "top shelf",   "bottom shelf", "middle shelf",
                                                "lower shelf", "upper shelf", "lowest shelf", "highest shelf"};
  return std::find(std::begin(kWhich), std::end(kWhich), noun.name) != std::end(kWhich);
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

}  // namespace

int References::add(Mention mention) {
  document_.mentions.push_back(std::move(mention));
  return static_cast<int>(document_.mentions.size()) - 1;
}

void References::introduce(Mention& mention, const NounPhrase& noun, int count) {
  constexpr int kMost = 400;
  if (document_.items.size() + static_cast<std::size_t>(count) > kMostItems) {
    if (document_.items.size() <= kMostItems && !full_) {
      document_.notes.push_back({"ignored", "more than " + std::to_string(kMostItems) + " objects: the rest is left out", "prompt"});
    }
    full_ = true;
    return;
  }
  const int group = document_.groups++;
  for (int i = 0; i < std::min(count, kMost); ++i) {
    mention.items.push_back(static_cast<int>(document_.items.size()));
    document_.items.push_back({noun, group});
  }
  mention.introduces = true;
}

void References::grow(int mention, std::size_t count) {
  constexpr std::size_t kMost = 400;
  Mention& grown = document_.mentions[static_cast<std::size_t>(mention)];
  if (grown.items.empty() || !grown.introduces) return;
  const Item first = document_.items[static_cast<std::size_t>(grown.items.front())];
  while (grown.items.size() < std::min(count, kMost) && document_.items.size() < kMostItems) {
    grown.items.push_back(static_cast<int>(document_.items.size()));
    document_.items.push_back(first);
  }
}

bool References::same_kind(const NounPhrase& wanted, const NounPhrase& item) const { return fit(wanted, item) > 0; }

// 4: the same words, 3: the same kind, 2: a kind of it, 1: a word for something more general or the same head noun.
int References::fit(const NounPhrase& wanted, const NounPhrase& item) const {
  const Catalog& catalog = lexicon_.catalog();
  // "the dentist's stool … the assistant's stool": two.
  if (!wanted.owner_word.empty() && !item.owner_word.empty() && wanted.owner_word != item.owner_word) return 0;
  // "twelve mats … the instructor's mat": none of the twelve.
  if (!wanted.owner_word.empty() && item.owner_word.empty() && item.count > 1 && !wanted.is_plural()) return 0;
  if (wanted.name == item.name) return 4;
  static constexpr std::string_view kOfIt[] = {"screen", "top", "surface", "area", "set"};
  if (wanted.name.starts_with(item.name + " ") &&
      std::find(std::begin(kOfIt), std::end(kOfIt), wanted.name.substr(item.name.size() + 1)) != std::end(kOfIt))
    return 3;
  if (wanted.exact && item.exact && wanted.entry == item.entry) return 3;
  if (last_word(wanted.name) == last_word(item.name) &&
      (wanted.name.find(' ') == std::string::npos || item.name.find(' ') == std::string::npos)) {
    // "the table" is any table; "the coffee table" is not a plain table that was named before it.
    const bool kind_apart = wanted.exact && wanted.entry != item.entry && item.is_plural() && !wanted.is_plural();
    if (wanted.name.find(' ') == std::string::npos) return 2;
    return kind_apart ? 0 : 1;  // "the teacher's desk" is none of the desks
  }
  if (wanted.exact && item.entry != nullptr && wanted.entry != nullptr && wanted.entry != item.entry &&
      catalog.is_a(item.entry->id, wanted.entry->id))
    return 2;
  if (wanted.entry != nullptr && item.entry == wanted.entry && (wanted.exact || item.exact) && wanted.name.find(' ') == std::string::npos)
    return 2;
  // "the bench" is the workbench.
  constexpr std::size_t kShortest = 5;
  if (wanted.name.size() >= kShortest && item.head.size() > wanted.name.size() && item.head.ends_with(wanted.name)) return 1;
  const bool same_head = wanted.head.ends_with(item.head) || item.head.ends_with(wanted.head);
  if (same_head && wanted.exact && item.exact && catalog.is_a(wanted.entry->id, item.entry->id) &&
      wanted.determiner == Determiner::kDefinite)
    return 1;
  return 0;
}

std::vector<int> References::known(const NounPhrase& noun) const {
  // The best fitting kind; of equals the latest mention. Attributes that were said of it count.
  int best_score = 0;
  std::vector<int> found;
  for (std::size_t i = document_.items.size(), looked = 0; i-- > 0 && looked < kReach; ++looked) {
    const NounPhrase& item = document_.items[i].noun;
    int score = fit(noun, item) * 10;
    if (score == 0) continue;
    for (const std::string& attribute : noun.attributes) {
      score +=
          std::any_of(item.attributes.begin(), item.attributes.end(), [&](const std::string& own) { return same_quality(own, attribute); })
              ? 3
              : -1;
    }
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
    return at > found.size() ? std::vector<int>{} : std::vector<int>{found[at - 1]};
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

int References::mention(const NounPhrase& noun, int antecedent, bool as_reference, bool of_known) {
  Mention mention;
  mention.noun = noun;
  switch (noun.kind) {
    case NounKind::kPronoun:
      if (antecedent >= 0) {
        const Mention& meant = document_.mentions[static_cast<std::size_t>(antecedent)];
        mention.noun = meant.noun;
        mention.noun.first = noun.first;
        mention.noun.last = noun.last;
        mention.items = meant.items;
      }
      return add(std::move(mention));
    case NounKind::kMember: {
      int group = antecedent;
      if (noun.of) group = this->mention(*noun.of, -1, true);
      choose_members(mention, noun, group);
      if (!mention.items.empty()) {
        mention.noun = document_.items[static_cast<std::size_t>(mention.items.front())].noun;
        mention.noun.first = noun.first;
        mention.noun.last = noun.last;
        mention.noun.wall_word = noun.wall_word;
        if (noun.of && noun.of->head == "shelf") mention.noun.head = noun.of->head;  // "one of the bookshelf's shelves"
      }
      return add(std::move(mention));
    }
    case NounKind::kObject: break;
    default:
      if (noun.of && (noun.of->kind == NounKind::kObject || noun.of->kind == NounKind::kPronoun || noun.of->kind == NounKind::kMember)) {
        const int base = this->mention(*noun.of, antecedent, true);
        mention.items = document_.mentions[static_cast<std::size_t>(base)].items;
      } else if (antecedent >= 0 && (noun.determiner == Determiner::kPossessive || noun.kind == NounKind::kPart ||
                                     noun.kind == NounKind::kCorner || noun.kind == NounKind::kCenter)) {
        if (noun.kind == NounKind::kCorner || noun.kind == NounKind::kCenter)
          mention.noun.of = std::make_shared<NounPhrase>(document_.mentions[static_cast<std::size_t>(antecedent)].noun);
        mention.items = document_.mentions[static_cast<std::size_t>(antecedent)].items;
      }
      return add(std::move(mention));
  }
  if (noun.head == "furniture" || noun.head == "everything") {
    for (std::size_t i = 0; i < document_.items.size(); ++i) {
      const CatalogEntry* entry = document_.items[i].noun.entry;
      if (entry == nullptr || (entry->mount == Mount::kFloor && !entry->thin)) mention.items.push_back(static_cast<int>(i));
    }
    if (mention.items.empty()) mention.noun.kind = NounKind::kAbstract;
    return add(std::move(mention));
  }
  const bool definite = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive ||
                        noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach ||
                        noun.determiner == Determiner::kOther ||
                        // "lamp on nightstand", where articles are left out
                        (as_reference && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural);
  if (as_reference) mention.items = whose_shelf(noun);
  if (!mention.items.empty()) return add(std::move(mention));
  if (definite) {
    mention.items = known(noun);
    if (noun.determiner == Determiner::kEach) mention.distributes = true;
    if (!mention.items.empty()) {
      const int group = document_.items[static_cast<std::size_t>(mention.items.front())].group;
      if (noun.determiner == Determiner::kOther) {
        auto& picked = picked_[group];
        std::vector<int> rest;
        for (const int item : mention.items) {
          if (!contains(picked, item)) rest.push_back(item);
        }
        mention.items = rest.empty() ? std::vector<int>{} : rest;
        picked.insert(picked.end(), mention.items.begin(), mention.items.end());
      } else if (!noun.is_plural() && mention.items.size() > 1 && !mention.distributes) {
        // "the left nightstand" of two; "the other chair"; else one that was spoken of as one.
        if (noun.wall_word == "right")
          mention.items = {mention.items.back()};
        else
          mention.items = {mention.items.front()};
        auto& picked = picked_[group];
        if (picked.empty()) picked.push_back(mention.items.front());
      } else if (noun.count > 1 && mention.items.size() > static_cast<std::size_t>(noun.count)) {
        mention.items.resize(static_cast<std::size_t>(noun.count));
      }
    }
    if (mention.items.empty() && noun.determiner == Determiner::kOther) mention.items = known(noun);
  } else if (noun.attributes.empty() && ((as_reference && noun.determiner == Determiner::kIndefinite) ||
                                         (of_known && noun.determiner == Determiner::kNone && noun.count == 1 && !noun.plural))) {
    // "two armchairs … near an armchair", "one armchair": one of them.
    const std::vector<int> before = known(noun);
    const bool same =
        before.size() > 1 && fit(noun, document_.items[static_cast<std::size_t>(before.front())].noun) >= (noun.count == 1 ? 2 : 3);
    auto& picked = picked_[same ? document_.items[static_cast<std::size_t>(before.front())].group : -1];
    const bool left = std::any_of(before.begin(), before.end(), [&](int item) { return !contains(picked, item); });
    for (const int item : before) {
      if (!same || !mention.items.empty() || (noun.count == 1 && left && contains(picked, item))) continue;
      mention.items = {item};
      if (noun.count == 1) picked.push_back(item);
    }
  }
  if (mention.items.empty() && as_reference && is_own_shelf(noun) &&
      (noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive)) {
    // "the shelf below": of what was named and has one.
    for (std::size_t i = document_.items.size(), looked = 0; i-- > 0 && mention.items.empty() && looked < kReach; ++looked) {
      const CatalogEntry* entry = document_.items[i].noun.entry;
      if (entry != nullptr && entry->mount == Mount::kFloor &&
          std::any_of(entry->spaces.begin(), entry->spaces.end(), [](const SpaceFormula& s) { return s.carries; }))
        mention.items = {static_cast<int>(i)};
    }
  }
  if (mention.items.empty() && (noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kBoth))
    general(noun, as_reference, mention);
  if (mention.items.empty()) {
    const int unsaid = noun.plural ? 2 : 1;
    introduce(mention, noun, noun.count > 0 ? noun.count : unsaid);
  }
  return add(std::move(mention));
}

}  // namespace layoutbox::offline
