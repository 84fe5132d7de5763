#include "layoutbox/plan/reading/references.h"

#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

// "the shelf", "the top shelf": a part of what has shelves.
bool is_own_shelf(const NounPhrase& noun) {
  if (noun.determiner == Determiner::kPossessive && one_of(noun.head, WordSet::kShelfLevels)) return true;
  return one_of(noun.name, WordSet::kOneShelf);
}

// No bed, sink or seat, whose mattress, bowl or seat carries as well.
bool has_shelves(const CatalogEntry* entry) {
  static constexpr std::string_view kShelves[] = {"shelf", "compartment", "below", "tray", "niche", "floor"};
  return entry != nullptr && entry->mount == Mount::kFloor && std::ranges::any_of(entry->spaces, [](const SpaceFormula& s) {
           return s.carries && std::ranges::any_of(kShelves, [&](std::string_view part) { return s.name.find(part) != std::string::npos; });
         });
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
  const TextItem first = document_.items[static_cast<std::size_t>(grown.items.front())];
  while (grown.items.size() < std::min(count, kMost) && document_.items.size() < kMostItems) {
    grown.items.push_back(static_cast<int>(document_.items.size()));
    document_.items.push_back(first);
  }
}

void References::mean_one_for_each(int mention, std::size_t count) {
  std::vector<int>& items = document_.mentions[static_cast<std::size_t>(mention)].items;
  if (items.size() != 1) return;
  const int group = document_.items[static_cast<std::size_t>(items.front())].group;
  std::vector<int> all;
  for (std::size_t i = 0; i < document_.items.size(); ++i) {
    if (document_.items[i].group == group) all.push_back(static_cast<int>(i));
  }
  if (all.size() == count) items = std::move(all);
}

void References::join_group(int mention, int of) {
  const std::vector<int>& group = document_.mentions[static_cast<std::size_t>(of)].items;
  if (group.empty()) return;
  for (const int item : document_.mentions[static_cast<std::size_t>(mention)].items)
    document_.items[static_cast<std::size_t>(item)].group = document_.items[static_cast<std::size_t>(group.front())].group;
}

void References::mean_antecedent(Mention& mention, int antecedent) const {
  if (antecedent < 0) return;
  const NounPhrase noun = mention.noun;
  const Mention& meant = document_.mentions[static_cast<std::size_t>(antecedent)];
  mention.noun = meant.noun;
  mention.noun.first = noun.first;
  mention.noun.last = noun.last;
  mention.items = meant.items;
}

void References::mean_member(Mention& mention, int antecedent) {
  const NounPhrase noun = mention.noun;
  const int group = noun.of ? this->mention(*noun.of, -1, true) : antecedent;
  choose_members(mention, noun, group);
  if (mention.items.empty()) return;
  mention.noun = document_.items[static_cast<std::size_t>(mention.items.front())].noun;
  mention.noun.first = noun.first;
  mention.noun.last = noun.last;
  mention.noun.wall_word = noun.wall_word;
  if (noun.of && noun.of->head == "shelf") mention.noun.head = noun.of->head;  // "one of the bookshelf's shelves"
}

// "the corner of the desk", "its top": of the thing.
void References::mean_part(Mention& mention, int antecedent) {
  const NounPhrase noun = mention.noun;
  if (noun.of && (noun.of->kind == NounKind::kObject || noun.of->kind == NounKind::kPronoun || noun.of->kind == NounKind::kMember)) {
    const int base = this->mention(*noun.of, antecedent, true);
    mention.items = document_.mentions[static_cast<std::size_t>(base)].items;
    mention.distributes = document_.mentions[static_cast<std::size_t>(base)].distributes;  // "along the front of each bench"
    return;
  }
  const bool spot = noun.kind == NounKind::kCorner || noun.kind == NounKind::kCenter || noun.head == "edge";
  if (antecedent < 0 || (noun.determiner != Determiner::kPossessive && noun.kind != NounKind::kPart && !spot)) return;
  const Mention& meant = document_.mentions[static_cast<std::size_t>(antecedent)];
  if (spot) mention.noun.of = std::make_shared<NounPhrase>(meant.noun);
  mention.items = meant.items;
}

void References::mean_everything(Mention& mention) const {
  for (std::size_t i = 0; i < document_.items.size(); ++i) {
    const CatalogEntry* entry = document_.items[i].noun.entry;
    if (entry == nullptr || (entry->mount == Mount::kFloor && !entry->thin)) mention.items.push_back(static_cast<int>(i));
  }
  if (mention.items.empty()) mention.noun.kind = NounKind::kAbstract;
}

// "the bed", "each chair", "the other lamp": of those that were named.
void References::mean_known(Mention& mention) {
  const NounPhrase& noun = mention.noun;
  mention.items = known(noun);
  // "two wing chairs …; a desk, its chair tucked under": another one
  const bool its = noun.determiner == Determiner::kPossessive && document_.tokens[noun.first].text == "its";
  if (its && !mention.items.empty() && document_.items[static_cast<std::size_t>(mention.items.front())].noun.name != noun.name)
    mention.items.clear();
  if (noun.determiner == Determiner::kEach) mention.distributes = true;
  if (noun.every > 1) mention.items = singled_out(mention.items, noun);
  if (!mention.items.empty()) {
    auto& items = mention.items;
    const int group = document_.items[static_cast<std::size_t>(items.front())].group;
    if (noun.determiner == Determiner::kOther) {
      auto& picked = picked_[group];
      // "a bin at the left of the counter, the other bin at the right": of one that was named alone the other is new.
      if (items.size() == 1 && picked.empty()) {
        items.clear();
        return;
      }
      std::erase_if(items, [&](int item) { return contains(picked, item); });
      picked.insert(picked.end(), items.begin(), items.end());
    } else if (!noun.is_plural() && items.size() > 1 && !mention.distributes) {
      // "the left nightstand" of two; "the other chair"; else one that was spoken of as one.
      items =
          noun.rank != Rank::kAny ? singled_out(items, noun) : std::vector<int>{noun.wall_word == "right" ? items.back() : items.front()};
      auto& picked = picked_[group];
      if (picked.empty()) picked.push_back(items.front());
    } else if (noun.count > 1 && items.size() > static_cast<std::size_t>(noun.count)) {
      items.resize(static_cast<std::size_t>(noun.count));
    }
  }
  if (mention.items.empty() && noun.determiner == Determiner::kOther) mention.items = known(noun);
}

// "two lamps on stools … a vase on a stool": each of those came with what it carries.
bool References::carry_their_own(const std::vector<int>& items) const {
  return std::ranges::any_of(document_.links, [&](const Link& link) {
    if (link.kind != Link::Kind::kRelation || link.references.size() != 1 || !says(link.senses, &RelationTraits::rests)) return false;
    const Mention& host = document_.mentions[static_cast<std::size_t>(link.references.front())];
    return host.introduces && host.items.size() > 1 && host.items == items && host.noun.count == 0 && !link.targets.empty();
  });
}

// "two armchairs … near an armchair", "one armchair": one of them.
void References::mean_one_of_known(Mention& mention) {
  const NounPhrase& noun = mention.noun;
  const std::vector<int> before = known(noun);
  if (carry_their_own(before)) return;
  // "four server racks …; one battery cabinet": another thing, though it is drawn like those.
  const bool own_name = !before.empty() && noun.name.find(' ') != std::string::npos &&
                        noun.name != document_.items[static_cast<std::size_t>(before.front())].noun.name;
  const bool same = before.size() > 1 && !(noun.count == 1 && own_name) &&
                    fit(noun, document_.items[static_cast<std::size_t>(before.front())].noun) >= (noun.count == 1 ? 2 : 3);
  auto& picked = picked_[same ? document_.items[static_cast<std::size_t>(before.front())].group : -1];
  const bool left = std::any_of(before.begin(), before.end(), [&](int item) { return !contains(picked, item); });
  for (const int item : before) {
    if (!same || !mention.items.empty() || (noun.count == 1 && left && contains(picked, item))) continue;
    mention.items = {item};
    if (noun.count == 1) picked.push_back(item);
  }
}

// "the shelf below": of what was named and has one; "its shelves": of what else stands there and may have some.
void References::mean_own_shelf(Mention& mention) const {
  const auto last = [&](auto&& has_one) {
    for (std::size_t i = document_.items.size(), looked = 0; i-- > 0 && mention.items.empty() && looked < kReach; ++looked) {
      if (has_one(document_.items[i].noun)) mention.items = {static_cast<int>(i)};
    }
  };
  last([](const NounPhrase& host) { return has_shelves(host.entry); });
  if (mention.noun.determiner != Determiner::kPossessive) return;
  last([](const NounPhrase& host) { return is_storage(host) && mount_of(host) != Mount::kSurface; });
  last([&](const NounPhrase& host) { return is_table(lexicon_.catalog(), host); });
}

// "… and one computer, and computer is on the right": who writes no articles says more of it.
bool References::is_said_again(const NounPhrase& noun) const {
  const std::size_t next = noun.last;
  if (noun.determiner != Determiner::kNone || noun.count != 0 || noun.plural || !noun.attributes.empty()) return false;
  if (next >= document_.tokens.size() || !lexicon_.is(document_.tokens[next], WordClass::kBe)) return false;
  const std::vector<int> before = known(noun);
  return before.size() == 1 && document_.items[static_cast<std::size_t>(before.front())].noun.name == noun.name;
}

void References::mean_object(Mention& mention, bool as_reference, bool of_known) {
  const NounPhrase& noun = mention.noun;
  const bool bare = noun.determiner == Determiner::kNone;
  const bool definite = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive ||
                        noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach ||
                        noun.determiner == Determiner::kOther ||
                        // "lamp on nightstand", where articles are left out
                        (as_reference && bare && noun.count == 0 && !noun.plural) || is_said_again(noun);
  if (as_reference) mention.items = whose_shelf(noun);
  if (!mention.items.empty()) return;
  // "a washing machine and a dryer … above the two machines"
  if (noun.determiner == Determiner::kDefinite && noun.count > 1 && known(noun).size() < static_cast<std::size_t>(noun.count))
    general(noun, as_reference, mention);
  if (!mention.items.empty()) return;
  if (definite) {
    mean_known(mention);
  } else if (noun.attributes.empty() &&
             ((as_reference && noun.determiner == Determiner::kIndefinite) || (of_known && bare && noun.count == 1 && !noun.plural))) {
    mean_one_of_known(mention);
  }
  if (mention.items.empty() && as_reference && is_own_shelf(noun) &&
      (noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive))
    mean_own_shelf(mention);
  if (mention.items.empty() && (noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kBoth))
    general(noun, as_reference, mention);
  if (!mention.items.empty()) return;
  const bool either = noun.determiner == Determiner::kBoth && document_.tokens[noun.first].text == "either";  // "on either nightstand"
  const bool each = noun.determiner == Determiner::kEach;                                                     // "a lamp on each nightstand"
  const int unsaid = noun.plural || either || each ? 2 : 1;
  introduce(mention, noun, noun.count > 0 ? noun.count : unsaid);
}

int References::mention(const NounPhrase& noun, int antecedent, bool as_reference, bool of_known) {
  Mention mention;
  mention.noun = noun;
  if (!noun.items.empty()) {
    mention.items = noun.items;
    mention.distributes = noun.determiner == Determiner::kEach;
  } else if (noun.kind == NounKind::kPronoun)
    mean_antecedent(mention, antecedent);
  else if (noun.kind == NounKind::kMember)
    mean_member(mention, antecedent);
  else if (noun.kind != NounKind::kObject)
    mean_part(mention, antecedent);
  else if (noun.head == "furniture" || noun.head == "everything")
    mean_everything(mention);
  else
    mean_object(mention, as_reference, of_known);
  return add(std::move(mention));
}

}  // namespace layoutbox::offline
