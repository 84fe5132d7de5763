#include "layoutbox/plan/relations/seat_builder.h"

#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

// "six-seater", "8-person": how many; 0 where it says no such thing.
int seats_in(const Lexicon& lexicon, const std::string& attribute) {
  const std::size_t space = attribute.find_first_of("- ");
  if (space == std::string::npos) return 0;
  const std::string number = attribute.substr(0, space), rest = attribute.substr(space + 1);
  if (!one_of(rest, WordSet::kSeatCounts)) return 0;
  const std::vector<Token> tokens = tokenize(number);
  if (tokens.empty()) return 0;
  if (tokens.front().kind == Token::Kind::kNumber) return static_cast<int>(std::clamp(tokens.front().number, 0.0, 1.0 * kMostPeople));
  const Match match = lexicon.find(tokens, 0, WordClass::kNumber);
  return match.length > 0 ? static_cast<int>(meaning_of(match, WordClass::kNumber)->value) : 0;
}

}  // namespace

int SeatBuilder::seats_said(const Mention& table) const {
  if (table.items.empty()) return 0;
  const NounPhrase& noun = document_.items[static_cast<std::size_t>(table.items.front())].noun;
  const bool desk = noun.entry != nullptr && noun.entry->is(Trait::kDesk);
  // "12 double desks for 24 pupils", "five tables for 20 guests": all of them together.
  const int tables = static_cast<int>(table.items.size());
  constexpr int kMostAtOne = 10;
  if (tables > 1 && noun.seats % tables == 0 && noun.seats >= tables && (desk || noun.seats > kMostAtOne)) return noun.seats / tables;
  if (noun.seats > 0) return std::min(noun.seats, kMostPeople);
  if (desk && std::ranges::find(noun.attributes, "double") != noun.attributes.end()) return 2;
  for (const std::string& attribute : noun.attributes) {
    if (const int seats = seats_in(lexicon_, attribute); seats > 0) return seats;
  }
  return 0;
}

int SeatBuilder::add(const CatalogEntry& entry, int count, const NounPhrase& by) const {
  return bring_in(document_, entry, std::min(count, kMostPeople), by.first, by.last);
}

void SeatBuilder::relate(Link::Kind kind, PhraseSenses senses, int target, int reference) const {
  Link link;
  link.kind = kind;
  link.senses = std::move(senses);
  link.targets = {target};
  if (reference >= 0) link.references = {reference};
  link.concluded = true;
  link.first = mention(target).noun.first;
  link.last = mention(target).noun.last;
  document_.links.push_back(std::move(link));
}

void SeatBuilder::seat_at_table(int seats, int table, bool several) const {
  if (several)
    relate(Link::Kind::kRelation, {{RelationType::kAround, Direction::kDirect, {}, {}, {}}}, seats, table);
  else
    relate(Link::Kind::kHave, {}, seats, table);
}

void SeatBuilder::grow(int m, int count) const {
  const TextItem first = document_.items[static_cast<std::size_t>(mention(m).items.front())];
  while (static_cast<int>(mention(m).items.size()) < std::min(count, kMostPeople)) {
    mention(m).items.push_back(static_cast<int>(document_.items.size()));
    document_.items.push_back(first);
  }
}

bool SeatBuilder::excluded(const CatalogEntry& entry) const {
  const Catalog& catalog = lexicon_.catalog();
  return std::any_of(document_.excluded.begin(), document_.excluded.end(),
                     [&](const NounPhrase& n) { return n.entry != nullptr && catalog.is_a(entry.id, n.entry->id); });
}

}  // namespace layoutbox::offline
