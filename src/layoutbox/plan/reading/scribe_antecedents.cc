// Which of the mentions a noun speaks of again: one, a pair, a list, the thing of an area.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/scribe.h"

namespace layoutbox::offline {

int Scribe::combined(const std::vector<int>& mentions) {
  std::vector<int> things = mentions;
  std::erase_if(things, [&](int m) { return !is_thing(m); });
  if (things.empty()) return -1;
  Mention all = mention_at(things.front());
  all.introduces = all.distributes = false;
  for (const int mention : things) {
    for (const int item : mention_at(mention).items) {
      if (!contains(all.items, item)) all.items.push_back(item);
    }
  }
  document_.mentions.push_back(std::move(all));
  return static_cast<int>(document_.mentions.size()) - 1;
}

// Two single things of which one was placed by the other, as one mention, or -1.
int Scribe::pair_just_related() {
  for (std::size_t l = document_.links.size(), looked = 0; l-- > 0 && looked < 6; ++looked) {
    const Link& link = document_.links[l];
    if (link.kind != Link::Kind::kRelation || link.targets.size() != 1 || link.references.size() != 1) continue;
    const Mention &one = mention_at(link.targets.front()), &other = mention_at(link.references.front());
    if (one.items.size() != 1 || other.items.size() != 1 || one.items == other.items) continue;
    const Mount mount = mount_of(one.noun);
    if (mount != mount_of(other.noun) || (mount != Mount::kFloor && mount != Mount::kSurface)) continue;
    return combined({link.targets.front(), link.references.front()});
  }
  return pair_looking();
}

// "A sofa faces a TV; between the two is a table": the last two single things of which one looks at the other, or -1.
int Scribe::pair_looking() {
  for (std::size_t l = document_.links.size(), looked = 0; l-- > 0 && looked < 6; ++looked) {
    const Link& link = document_.links[l];
    if (!says(link.senses, RelationType::kFacing) && !says(link.senses, RelationType::kOpposite)) continue;
    if (link.targets.size() != 1 || link.references.size() != 1) continue;
    const Mention &one = mention_at(link.targets.front()), &other = mention_at(link.references.front());
    if (one.items.size() == 1 && other.items.size() == 1 && one.items != other.items)
      return combined({link.targets.front(), link.references.front()});
  }
  return -1;
}

// "a nightstand to its left; a second nightstand is on the right; each of them": what was brought in last and the one before of its name.
int Scribe::pair_of_a_name() {
  int last = -1;
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    const Mention& one = document_.mentions[m];
    if (!one.introduces || one.items.size() != 1 || one.noun.kind != NounKind::kObject) continue;
    if (last >= 0 && one.noun.name == noun_of(last).name) return combined({static_cast<int>(m), last});
    if (last < 0) last = static_cast<int>(m);
  }
  return -1;
}

int Scribe::antecedent_of(int u) {
  const UnitReading& own = reading(u);
  const NounPhrase& noun = chunk(u).noun;
  const bool both = noun.kind == NounKind::kMember && noun.determiner == Determiner::kBoth;
  const bool each_of_them = noun.kind == NounKind::kMember && noun.determiner == Determiner::kEach && noun.subset && !noun.of;
  // "There is a desk and a workbench. Each has a lamp."
  const bool each_has = noun.kind == NounKind::kMember && noun.determiner == Determiner::kEach && !noun.of && is(u + 1, UnitKind::kHave);
  const bool plural = noun.plural || both || each_of_them || each_has ||
                      (noun.kind == NounKind::kMember && noun.determiner == Determiner::kDefinite && noun.count == 2);
  // "the crib is between the wardrobe and the dresser; all three …"
  if (both && noun.count > 0) {
    if (const std::vector<int> last = last_introduced(static_cast<std::size_t>(noun.count)); !last.empty()) return combined(last);
  }
  if (own.whole_list && own.meant >= 0) {
    std::vector<int> all;
    for (const int m : list_meant(own.meant)) all.push_back(mention_[static_cast<std::size_t>(m)]);
    const bool one = all.size() == 1 && is_thing(all.front()) && mention_at(all.front()).items.size() == 1;
    if (!one) return combined(all);
  }
  const std::vector<int> meant = mentions_of(own.meant);
  const int antecedent = meant.empty() ? -1 : meant.front();
  if (const int listed = list_ranked(noun, antecedent); listed >= 0) return listed;
  if (plural && (antecedent < 0 || mention_at(antecedent).items.size() < 2)) {
    if (each_has && so_far_.listed.size() > 1) return combined(so_far_.listed);
    const std::vector<int> placed = own.predicate >= 0 ? subjects_of(own.predicate) : std::vector<int>{};
    if (const std::vector<int> two = pair_named_last(u, placed); two.size() == 2) return combined(two);
    if (const std::vector<int> two = two_alike(u, !each_of_them); two.size() == 2 && own.predicate < 0) return combined(two);
    if (const int pair = pair_of_a_name(); pair >= 0) return pair;
    if (const int pair = pair_just_related(); pair >= 0) return pair;
    // The last two things that were spoken of.
    if (so_far_.roots.size() > 1) return combined({so_far_.roots[so_far_.roots.size() - 2], so_far_.roots.back()});
  }
  return antecedent;
}

// The last mentions that brought in so many things together; empty where no such row of them does.
std::vector<int> Scribe::last_introduced(std::size_t count) const {
  constexpr std::size_t kLooked = 8;
  std::vector<int> last;
  std::size_t items = 0;
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kLooked && items < count; ++looked) {
    if (document_.mentions[m].items.empty() || !document_.mentions[m].introduces) continue;
    last.insert(last.begin(), static_cast<int>(m));
    items += document_.mentions[m].items.size();
  }
  return items == count ? last : std::vector<int>{};
}

// "a crib, a table and a chair. The first two …, the third …": of what the sentence before listed, where nothing named is as many.
int Scribe::list_ranked(const NounPhrase& noun, int antecedent) {
  const bool ranked =
      noun.kind == NounKind::kMember && !noun.of && (noun.ordinal != 0 || noun.rank != Rank::kAny) && noun.attributes.empty();
  if (!ranked) return -1;
  const std::size_t wanted =
      static_cast<std::size_t>(std::max({noun.ordinal, 0, 2})) + static_cast<std::size_t>(std::max(noun.count, 1)) - 1;
  const bool group = antecedent >= 0 && mention_at(references_.whole_group(antecedent)).items.size() > 1;
  if (group) return -1;
  if (so_far_.listed.size() < wanted || so_far_.listed.size() < 2) return -1;
  return combined(so_far_.listed);
}

// "for each guest a bed and a lamp beside the bed": the bed of every one.
int Scribe::shared_as(int u, const NounPhrase& noun) {
  const bool known = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive;
  if (unit(u).share < 2 || noun.kind != NounKind::kObject || !known || noun.is_plural()) return -1;
  for (int before = u; before-- > 0;) {
    const int m = mention_[static_cast<std::size_t>(before)];
    if (!is(before, UnitKind::kNoun) || !is_thing(m) || !mention_at(m).introduces || unit(before).share < 2) continue;
    const std::string& name = noun_of(m).name;
    if (name == noun.name || name.ends_with(" " + noun.name)) return combined({m});
  }
  return -1;
}

// "two windows, a radiator under each": each of the windows; −1: the words mean nothing of the kind.
int Scribe::each_of_openings(int u, const NounPhrase& noun) {
  const bool each = noun.determiner == Determiner::kEach || noun.determiner == Determiner::kBoth;
  const std::vector<int> meant = each && noun.kind != NounKind::kObject ? mentions_of(reading(u).meant) : std::vector<int>{};
  if (meant.empty()) return -1;
  const NounKind kind = noun_of(meant.front()).kind;
  if (kind != NounKind::kDoor && kind != NounKind::kWindow) return -1;
  Mention all = mention_at(meant.front());
  all.introduces = false;
  all.noun.determiner = Determiner::kEach;
  document_.mentions.push_back(std::move(all));
  return static_cast<int>(document_.mentions.size()) - 1;
}

// "in the free area": wherever that is.
bool Scribe::says_free(const NounPhrase& noun) const {
  const auto first = document_.tokens.begin();
  return std::any_of(first + static_cast<std::ptrdiff_t>(noun.first), first + static_cast<std::ptrdiff_t>(noun.last),
                     [](const Token& token) { return one_of(token.text, WordSet::kFree); });
}

// What stands for an area of the room: "the dining area" is where the dining table is, "the seating area" where one sits.
// A rug under a seating area lies under the low table in its middle.
int Scribe::thing_of_zone(int u, const NounPhrase& noun) const {
  if (!is_zone(noun.head) || noun.determiner != Determiner::kDefinite || says_free(noun)) return -1;
  const std::string words = words_between(document_, noun.first, noun.last);
  int seat = -1, sofa = -1, named = -1, low_table = -1;
  for (std::size_t m = document_.mentions.size(); m-- > 0;) {
    const Mention& mention = document_.mentions[m];
    if (mention.items.empty() || !mention.introduces || mention.noun.kind != NounKind::kObject) continue;
    const CatalogEntry* entry = mention.noun.entry;
    if (entry != nullptr && entry->is(Trait::kCenterPiece) && !entry->is(Trait::kBed)) sofa = static_cast<int>(m);
    if (entry != nullptr && entry->is(Trait::kCoffeeTable)) low_table = static_cast<int>(m);
    const std::string first = mention.noun.name.substr(0, mention.noun.name.find(' '));
    if (first != mention.noun.name && words.find(first) != std::string::npos) {
      if (!is_seat(lexicon_.catalog(), mention.noun)) return static_cast<int>(m);
      if (named < 0) named = static_cast<int>(m);
    }
    if (seat < 0 && is_seat(lexicon_.catalog(), mention.noun)) seat = static_cast<int>(m);
  }
  if (named >= 0) return named;
  if (words.find("seating") != std::string::npos || words.find("sitting") != std::string::npos || words.find("lounge") != std::string::npos)
    return low_table >= 0 && as_reference_of(u, RelationType::kUnder) ? low_table : sofa >= 0 ? sofa : seat;
  if (words.find("sleeping") != std::string::npos) {
    const auto bed = std::ranges::find_if(document_.mentions, [](const Mention& m) { return !m.items.empty() && m.noun.head == "bed"; });
    if (bed != document_.mentions.end()) return static_cast<int>(bed - document_.mentions.begin());
  }
  return so_far_.topic >= 0 && is_thing(so_far_.topic) ? so_far_.topic : -1;
}

// The things of the list that the unit is of, or else of the next one, or the one before: what an order said there is of.
std::vector<int> Scribe::list_ordered(int u) const {
  std::vector<bool> goes_on(sentence_->size(), false);
  for (std::size_t m = 0; m < sentence_->size(); ++m) {
    if (const int former = reading(static_cast<int>(m)).former; former >= 0) goes_on[static_cast<std::size_t>(former)] = true;
  }
  const auto ends_at = [&](int last) {
    std::vector<int> list;
    for (int m = is(last, UnitKind::kNoun) && !goes_on[static_cast<std::size_t>(last)] ? last : -1; m >= 0; m = reading(m).former) {
      if (const int mention = mention_[static_cast<std::size_t>(m)]; is_thing(mention)) list.insert(list.begin(), mention);
    }
    return list.size() > 1 ? list : std::vector<int>{};
  };
  for (int last = u; last < static_cast<int>(sentence_->size()); ++last) {
    if (std::vector<int> list = ends_at(last); !list.empty()) return list;
  }
  for (int last = u; last-- > 0;) {
    if (std::vector<int> list = ends_at(last); !list.empty()) return list;
  }
  return {};
}

// "from left to right"
void Scribe::write_orders() {
  for (int u = 0; u < static_cast<int>(sentence_->size()); ++u) {
    if (unit(u).order == kNoOrder) continue;
    const Chunk& said = document_.chunks[unit(u).order];
    Link link;
    link.senses = *said.phrase.senses;
    link.targets = list_ordered(u);
    link.first = said.first;
    link.last = said.last;
    link.soft = unit(u).soft;
    if (!link.targets.empty()) document_.links.push_back(std::move(link));
  }
}

}  // namespace layoutbox::offline
