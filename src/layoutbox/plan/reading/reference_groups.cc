// Which members of a group are meant: by place, by a quality, those that are left.
#include <algorithm>

#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/references.h"

namespace layoutbox::offline {

// "large", "larger", "largest" and "big", "bigger": one quality.
bool same_quality(std::string_view one, std::string_view other) {
  const auto stem = [](std::string_view word) {
    for (const std::string_view ending : {"est", "er"}) {
      if (word.size() > ending.size() + 2 && word.ends_with(ending)) word.remove_suffix(ending.size());
    }
    if (word.size() > 2 && word.back() == word[word.size() - 2]) word.remove_suffix(1);
    if (word.size() > 2 && (word.back() == 'e' || word.back() == 'i' || word.back() == 'y')) word.remove_suffix(1);
    return word;
  };
  return one == other || stem(one) == stem(other);
}

int References::described(const NounPhrase& noun) const {
  if (noun.attributes.empty()) return -1;
  for (std::size_t i = document_.items.size(), looked = 0; i-- > 0 && looked < kReach; ++looked) {
    const std::vector<std::string>& own = document_.items[i].noun.attributes;
    const bool all = std::all_of(noun.attributes.begin(), noun.attributes.end(), [&](const std::string& said) {
      return std::any_of(own.begin(), own.end(), [&](const std::string& word) { return same_quality(said, word); });
    });
    if (all) return static_cast<int>(i);
  }
  return -1;
}

std::vector<int> References::singled_out(const std::vector<int>& all, const NounPhrase& noun) {
  const std::size_t size = all.size();
  const std::size_t count = std::min(noun.count > 0 ? static_cast<std::size_t>(noun.count) : 1, size);
  const auto from = [&](std::size_t first, std::size_t many) {
    first = std::min(first, size - 1);
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<int>(begin, begin + static_cast<std::ptrdiff_t>(std::min(many, size - first)));
  };
  if (size < 2) return all;
  if (noun.every > 1) {
    std::vector<int> some;
    for (std::size_t i = 0; i < size; i += static_cast<std::size_t>(noun.every)) some.push_back(all[i]);
    return some;
  }
  if (noun.rank == Rank::kMiddle) return from((size - count) / 2, noun.plural && noun.count == 0 ? size - 2 : count);
  if (noun.rank == Rank::kEnds) return {all.front(), all.back()};
  if (noun.rank == Rank::kFirst || noun.ordinal > 0) return from(noun.ordinal > 0 ? static_cast<std::size_t>(noun.ordinal) - 1 : 0, count);
  if (noun.rank == Rank::kLast || noun.ordinal < 0) return from(size - count, count);
  return all;
}

// "four tables, each with two chairs, one in front of it": how many of the group each of the others has, while the sentence speaks of that;
// 0: they are not shared out.
std::size_t References::share_of_each(int group, const NounPhrase& member) const {
  const Mention& all = document_.mentions[static_cast<std::size_t>(group)];
  const std::size_t said = static_cast<std::size_t>(std::max(all.noun.count, 0));
  if (member.of || member.count > 1 || !all.introduces || said < 2 || all.items.size() <= said || all.items.size() % said != 0) return 0;
  for (std::size_t i = all.noun.last; i < member.first; ++i) {
    if (document_.tokens[i].ends_sentence) return 0;
  }
  return said;
}

namespace {

// So many of every `share` that follow one another, of those that are not picked yet.
void pick_of_each(const std::vector<int>& all, const std::vector<int>& picked, std::size_t share, std::size_t count, Mention& mention) {
  for (std::size_t first = 0; first < all.size(); first += share) {
    for (std::size_t i = first, left = count; i < first + share && left > 0; ++i) {
      if (!contains(picked, all[i])) mention.items.push_back(all[i]), --left;
    }
  }
}

}  // namespace

void References::choose_members(Mention& mention, const NounPhrase& noun, int antecedent) {
  if (noun.determiner == Determiner::kDefinite) {
    if (const int item = described(noun); item >= 0) {
      mention.items = {item};
      return;
    }
  }
  const std::vector<int> all = antecedent >= 0 ? document_.mentions[static_cast<std::size_t>(antecedent)].items : std::vector<int>{};
  if (all.empty()) return;
  const int group = document_.items[static_cast<std::size_t>(all.front())].group;
  std::vector<int>& picked = picked_[group];
  if (noun.determiner == Determiner::kEach || noun.determiner == Determiner::kBoth) {
    mention.items = noun.every > 1 ? singled_out(all, noun) : all;
    mention.distributes = noun.determiner == Determiner::kEach;
    return;
  }
  const std::size_t count = noun.share > 1   ? std::max<std::size_t>(all.size() / static_cast<std::size_t>(noun.share), 1)
                            : noun.count > 0 ? static_cast<std::size_t>(noun.count)
                                             : 1;
  const bool side = noun.wall_word == "left" || noun.wall_word == "right";
  if (noun.rank != Rank::kAny || noun.ordinal != 0) {
    mention.items = singled_out(all, noun);
    picked.insert(picked.end(), mention.items.begin(), mention.items.end());
    return;
  }
  if (side && noun.determiner == Determiner::kDefinite && noun.count == 0) {
    mention.items = {noun.wall_word == "right" ? all.back() : all.front()};
    picked.push_back(mention.items.front());
    return;
  }
  if (noun.determiner == Determiner::kOther && noun.count == 0) {
    for (const int item : all) {
      if (!contains(picked, item)) mention.items.push_back(item);
    }
  } else if (const std::size_t share = share_of_each(antecedent, noun); share > count) {
    pick_of_each(all, picked, share, count, mention);
  } else {
    for (const int item : all) {
      if (mention.items.size() < count && !contains(picked, item)) mention.items.push_back(item);
    }
    for (const int item : all) {
      if (mention.items.size() < std::min(count, all.size()) && !contains(mention.items, item)) mention.items.push_back(item);
    }
  }
  picked.insert(picked.end(), mention.items.begin(), mention.items.end());
}

// "both machines", "the appliances": the last things that were brought in, as many as there are words for.
void References::general(const NounPhrase& noun, bool as_reference, Mention& mention) const {
  if (!noun.is_plural() || noun.name.find(' ') != std::string::npos) return;
  const WordList words = word_list("words_kinds").at("general");
  if (!words.contains(noun.head)) return;
  const WordList kinds = words.at(noun.head);
  const auto is_such = [&](const CatalogEntry& entry) {
    for (const WordList::Member kind : kinds) {
      if (lexicon_.catalog().is_a(entry.id, kind.value.text())) return true;
    }
    return false;
  };
  const std::size_t wanted = noun.count > 0 ? static_cast<std::size_t>(noun.count) : 2;
  for (const bool strict : {true, false}) {  // of no such kind the last that stand
    for (std::size_t i = document_.items.size(), looked = 0; i-- > 0 && looked < kReach && mention.items.size() < wanted; ++looked) {
      // What is being placed by them came last.
      if (as_reference && document_.items[i].group == document_.items.back().group) continue;
      const CatalogEntry* entry = document_.items[i].noun.entry;
      const bool stands = entry == nullptr || (entry->mount == Mount::kFloor && !entry->thin);
      if (strict ? entry != nullptr && is_such(*entry) : stands) mention.items.push_back(static_cast<int>(i));
    }
    if (mention.items.size() >= std::max<std::size_t>(2, static_cast<std::size_t>(noun.count))) break;
    mention.items.clear();
  }
  std::reverse(mention.items.begin(), mention.items.end());
}

bool References::has_left(int mention, int count) const {
  if (mention < 0 || document_.mentions[static_cast<std::size_t>(mention)].items.empty()) return false;
  const std::vector<int>& items = document_.mentions[static_cast<std::size_t>(whole_group(mention))].items;
  const auto picked = picked_.find(document_.items[static_cast<std::size_t>(items.front())].group);
  if (picked == picked_.end() || picked->second.empty()) return false;
  const auto left = std::count_if(items.begin(), items.end(), [&](int item) { return !contains(picked->second, item); });
  return left >= count;
}

bool References::has_left_of(int mention) const {
  const std::vector<int>& items = document_.mentions[static_cast<std::size_t>(mention)].items;
  if (items.empty()) return false;
  const auto picked = picked_.find(document_.items[static_cast<std::size_t>(items.front())].group);
  return picked == picked_.end() || std::any_of(items.begin(), items.end(), [&](int item) { return !contains(picked->second, item); });
}

int References::whole_group(int mention) const {
  const auto group_of = [&](const Mention& m) {
    return m.items.empty() ? -1 : document_.items[static_cast<std::size_t>(m.items.front())].group;
  };
  const int group = group_of(document_.mentions[static_cast<std::size_t>(mention)]);
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (document_.mentions[m].introduces && group_of(document_.mentions[m]) == group) return static_cast<int>(m);
  }
  return mention;
}

int References::latest_group() const {
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (document_.mentions[m].items.size() > 1) return static_cast<int>(m);
  }
  return -1;
}

}  // namespace layoutbox::offline
