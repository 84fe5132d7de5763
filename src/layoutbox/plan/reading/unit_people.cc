// For how many people something is, and how many of it that makes.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// "a table for six": a size, after which the list goes on.
bool UnitReader::passes_count(std::size_t k) {
  const std::size_t n = next(k);
  const bool is_for = document_.tokens[chunk(k).first].text == "for";
  // "For the bedroom I imagine …": which room.
  if (!skipping_ && units_.empty() && is_for && is(n, ChunkKind::kNoun) && chunk(n).noun.kind == NounKind::kRoom) {
    mark(k, Use::kIgnored, "which room");
    mark(n, Use::kUsed, "room");
    document_.rooms.push_back(chunk(n).noun);
    passed_until_ = n + 1;
    return true;
  }
  if (skipping_ || !is(n, ChunkKind::kNoun) || chunk(n).noun.count == 0 || !is_for) return false;
  const NounPhrase& noun = chunk(n).noun;
  const bool somebody = noun.entry == nullptr && word_form(noun.head) == WordForm::kPerson;  // "four programmers"
  const bool persons = noun.kind == NounKind::kMember || lexicon_.is_person(noun.head) || somebody;
  const std::size_t before = last_noun();
  if (persons && (is_enough(before) || is_one_for_each(before))) {  // "enough chairs for six", "lockers for twelve"
    count_for(document_.chunks[before].noun, noun.count);
    mark(k, Use::kUsed, "for how many");
    mark(n, Use::kUsed, "for how many");
    passed_over_ = n;
    return true;
  }
  if (const std::size_t seats = seats_in_rows_before(k); persons && seats < k) {  // "rows of chairs facing the stage, for sixty people"
    count_for(document_.chunks[seats].noun, noun.count);
    mark(k, Use::kUsed, "for how many");
    mark(n, Use::kUsed, "for how many");
    passed_over_ = n;
    return true;
  }
  const bool room = before >= document_.chunks.size() || chunk(before).noun.kind == NounKind::kRoom;
  const bool bench = !room && is_for_several(chunk(before).noun);
  if (!persons || (!room && !bench && !is_table(lexicon_.catalog(), chunk(before).noun))) return false;
  if (room) {
    document_.people = noun.count;
    document_.young = lexicon_.is_young(noun.head);
  } else if (bench) {
    document_.chunks[before].noun.seats = noun.count;
  } else {
    seat_so_many(document_.chunks[before].noun, noun.count);
  }
  mark(k, Use::kUsed, "for how many");
  mark(n, Use::kUsed, "for how many");
  passed_over_ = n;
  return true;
}

// "enough chairs", not counted yet
bool UnitReader::is_enough(std::size_t k) const {
  if (k >= document_.chunks.size() || chunk(k).first == 0 || !names_thing(k)) return false;
  const NounPhrase& noun = chunk(k).noun;
  return noun.plural && noun.count == 0 && document_.tokens[chunk(k).first - 1].text == "enough";
}

// The seats of this sentence that stand in rows and are not counted; k: there are none.
std::size_t UnitReader::seats_in_rows_before(std::size_t k) const {
  for (std::size_t c = k; c-- > 0 && !is(c, ChunkKind::kStop);) {
    if (names_thing(c) && chunk(c).noun.rows > 0 && is_one_for_each(c)) return c;
  }
  return k;
}

// So many people, so many of them; of rows as many as there is room for.
void UnitReader::count_for(NounPhrase& things, int people) {
  constexpr int kInRow = 12;
  things.count = people;
  if (people > kInRow * things.rows) things.rows = 0;
}

// What everybody has of his own and is not counted yet: seats, beds, what is narrow.
bool UnitReader::is_one_for_each(std::size_t k) const {
  constexpr Mm kNarrow = 600;
  if (!names_thing(k)) return false;
  const NounPhrase& noun = chunk(k).noun;
  const bool rows = noun.rows > 0 && noun.vague;  // "rows of chairs for sixty"
  if (!noun.plural || (noun.count != 0 && !rows) || noun.determiner != Determiner::kNone || noun.entry == nullptr) return false;
  return is_seat(lexicon_.catalog(), noun) || noun.entry->is(Trait::kBed) ||
         (noun.entry->size.usual.width <= kNarrow && !is_table(lexicon_.catalog(), noun));
}

// "a table for six" has six seats; "desks for 24 students" are 24, "tables for forty guests" ten.
void UnitReader::seat_so_many(NounPhrase& tables, int people) const {
  constexpr int kAtATable = 4, kAtALargeOne = 6;
  tables.seats = people;
  if (tables.count > 0 || !tables.plural || tables.determiner == Determiner::kDefinite) return;
  const bool desks = tables.entry != nullptr && tables.entry->is(Trait::kDesk) && !(people == 2 && document_.people > 2);
  if (!desks && people <= kAtALargeOne) {  // "tables for two", for 24 pupils "desks for two": as many as the room's people need
    const auto are_tables = [&](const Chunk& c) {
      return c.kind == ChunkKind::kNoun && c.noun.kind == NounKind::kObject && c.noun.plural && is_table(lexicon_.catalog(), c.noun);
    };
    const bool only_these = std::ranges::count_if(document_.chunks, are_tables) == 1;
    if (people > 1 && document_.people > people && only_these) tables.count = (document_.people + people - 1) / people;
    return;
  }
  tables.seats = desks ? 1 : kAtATable;
  tables.count = (people + tables.seats - 1) / tables.seats;
}

}  // namespace layoutbox::offline
