// Who is with somebody, and where somebody is otherwise: neither is of the room that is wished for.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// A person or a pet.
bool UnitReader::is_living(std::size_t k) const {
  if (!is(k, ChunkKind::kNoun)) return false;
  const NounPhrase& noun = chunk(k).noun;
  if (noun.entry != nullptr)
    return noun.kind == NounKind::kObject &&
           (noun.entry->is(Trait::kPet) || (noun.entry->is(Trait::kAnimal) && noun_form(noun.head) == WordForm::kBody));
  return is_person(k) || (noun.kind != NounKind::kRoom && lexicon_.is_young(noun.head));
}

// "for a family with a big dog and a toddler", "we live with two cats", "I have a parrot": who is with somebody is no thing of the room.
bool UnitReader::passes_company(std::size_t k) {
  const std::size_t with = chunk(k).first;
  if (with == 0) return false;
  const std::string& word = document_.tokens[with].text;
  const std::string before = singular_of(document_.tokens[with - 1].text);
  const bool owns = one_of(word, {"have", "has", "own", "owns"}) &&
                    (one_of(before, {"i", "we", "she", "he", "they", "who"}) || noun_form(before) == WordForm::kPerson);
  if (word != "with" && !owns) return false;
  const bool whom = owns || one_of(before, WordSet::kHouseholds) || lexicon_.is_person(before) || lexicon_.is_young(before) ||
                    word_form(before) == WordForm::kPerson || noun_form(before) == WordForm::kPerson;
  if (!whom && !one_of(before, {"live", "living", "share"})) return false;
  std::size_t n = next(k), end = k;
  while (is_living(n) && !is(next(n), ChunkKind::kRelation)) {
    end = n;
    n = next(n);
    if (is(n, ChunkKind::kComma) || is(n, ChunkKind::kAnd)) n = next(n);
  }
  if (end == k) return false;
  for (std::size_t c = k; c <= end; ++c) mark(c, Use::kUsed, "who is there");
  passed_until_ = end + 1;
  return true;
}

// "I work nights on a ward", "a nurse who works in a hospital": where somebody is when not in this room.
bool UnitReader::is_where_somebody_is(const NounPhrase& noun) const {
  constexpr std::size_t kBetween = 4;  // words of what and when: "work nights as a nurse on"
  const std::vector<Token>& tokens = document_.tokens;
  if (noun.determiner == Determiner::kDefinite || noun.first < 2 || !one_of(tokens[noun.first - 1].text, {"in", "on", "at", "for", "near"}))
    return false;
  for (std::size_t i = noun.first - 1; i-- > 1 && noun.first - i <= kBetween + 2 && tokens[i].kind != Token::Kind::kPunctuation;) {
    if (!one_of(tokens[i].text, WordSet::kOccupied)) continue;
    const std::string who = singular_of(tokens[i - 1].text);
    return lexicon_.is(tokens[i - 1], WordClass::kDoer) || lexicon_.is(tokens[i - 1], WordClass::kBe) || who == "and" ||
           lexicon_.is_young(who) || word_form(who) == WordForm::kPerson;
  }
  return false;
}

// "my room in the shared flat", "the kitchen of our house": says where the room is that was spoken of before it.
bool UnitReader::tells_where_room_is(const NounPhrase& noun) const {
  if (noun.first == 0) return false;
  const std::string& before = document_.tokens[noun.first - 1].text;
  if (before == "off" && noun.determiner == Determiner::kDefinite) return true;  // "off the main hall, the pantry …"
  return !document_.rooms.empty() && one_of(before, {"in", "of", "at"}) && one_of(noun.head, WordSet::kDwellings);
}

// A room that the text names: the one that is wished for, or, where no other is named, the one where somebody works.
void UnitReader::name_room(const NounPhrase& noun) {
  if (is_past(noun) || tells_where_room_is(noun)) return;
  (is_where_somebody_is(noun) ? document_.rooms_elsewhere : document_.rooms).push_back(noun);
}

}  // namespace layoutbox::offline
