// What a text tells besides what stands in the room: why, what somebody does, what the room is like. It brings in nothing.
#include <algorithm>
#include <string_view>
#include <utility>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// Where the clause that follows chunk k is over: at a stop, or at a break after which the room is spoken of again.
std::size_t UnitReader::clause_end(std::size_t k) const {
  std::size_t c = k + 1;
  while (is(c, ChunkKind::kClause)) ++c;  // "since nobody"
  for (; c < document_.chunks.size() && !is(c, ChunkKind::kStop) && !is(c, ChunkKind::kClause); ++c) {
    const bool over = is(c, ChunkKind::kComma) && is(next(c), ChunkKind::kCommand);
    if (over || ((is(c, ChunkKind::kComma) || is(c, ChunkKind::kAnd)) && purpose_ends(c, next(c)))) break;
  }
  return c;
}

bool UnitReader::is_person(std::size_t k) const {
  if (k >= document_.chunks.size()) return false;
  const Chunk& who = chunk(k);
  const Token& token = document_.tokens[who.first];
  if (who.kind == ChunkKind::kNoun)
    return (who.noun.kind == NounKind::kPronoun && one_of(token.text, {"they", "them", "him"})) ||
           (who.noun.entry == nullptr && (word_form(who.noun.head) == WordForm::kPerson || noun_form(who.noun.head) == WordForm::kPerson ||
                                          (lexicon_.is_person(who.noun.head) && !one_of(who.noun.head, {"seat", "place"}))));
  return lexicon_.is(token, WordClass::kDoer) || token.text == "no";
}

// Whether the chunks [first, last) say that something is somewhere, or that it is there.
bool UnitReader::says_what_is_there(std::size_t first, std::size_t last) const {
  bool told = false, thing = false;
  for (std::size_t c = first; c < last; ++c) {
    if (is(c, ChunkKind::kThere) || is(c, ChunkKind::kWithout)) return true;
    // "so a table for eight": whom it is for comes after the thing.
    told = told || is_person(c) || (is(c, ChunkKind::kPurpose) && !thing) || is(c, ChunkKind::kUnknown);
    const bool known = is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kObject && chunk(c).noun.entry != nullptr &&
                       !chunk(c).noun.entry->is(Trait::kPet);
    if (!known || (!chunk(c).noun.exact && c != first)) continue;
    const std::size_t n = next(c);
    const bool placed = n < last && (is(n, ChunkKind::kRelation) || is(n, ChunkKind::kParticiple) || is(n, ChunkKind::kVerb));
    const bool used = is_new_here(chunk(c).noun) && c > first && is(previous(c), ChunkKind::kRelation);  // "guests sit on two sofas"
    if ((placed && !told) || used) return true;
    thing = thing || is_new_here(chunk(c).noun);
  }
  return thing && !told;
}

// "so its front edge meets the foot of the bed", "so that it faces the window": where what was spoken of is.
bool UnitReader::says_where_known_is(std::size_t first, std::size_t last) const {
  if (!is(first, ChunkKind::kNoun) || is_person(first)) return false;
  const NounPhrase& who = chunk(first).noun;
  const std::string& opens = document_.tokens[chunk(first).first].text;
  const bool known = (who.kind == NounKind::kPronoun && who.head == "it") || opens == "its" ||
                     (who.determiner == Determiner::kDefinite && who.kind == NounKind::kObject && who.exact);
  std::size_t place = next(first);
  if (is(place, ChunkKind::kVerb) || is(place, ChunkKind::kParticiple)) place = next(place);
  const std::size_t by = next(place);
  if (!known || by >= last || !is(place, ChunkKind::kRelation) || !is(by, ChunkKind::kNoun)) return false;
  const NounPhrase& what = chunk(by).noun;
  return what.kind != NounKind::kRoom && what.kind != NounKind::kAbstract && what.determiner == Determiner::kDefinite;
}

// "because my knee gets stiff", "so that the postman can rest", "where grandpa tells his stories": the clause at k, told by the way.
bool UnitReader::passes_aside(std::size_t k) {
  static constexpr std::string_view kWhy[] = {"because",   "since", "so",       "that",   "if",    "unless",   "case", "hence",
                                              "otherwise", "why",   "although", "though", "until", "whenever", "when"};
  const std::size_t first = k + 1, end = clause_end(k);
  if (first >= end || is(first, ChunkKind::kComma) || sums_up(first)) return false;
  const bool why = std::ranges::find(kWhy, document_.tokens[chunk(k).last - 1].text) != std::end(kWhy);
  if (!why && !is_person(k) && !is_person(first)) return false;
  // "So make me a bedroom with …", "so give the desk a lamp": no reason.
  if (document_.tokens[chunk(k).last - 1].text == "so" && is(first, ChunkKind::kCommand)) return false;
  // "We keep kosher, so two sinks, two ovens": what is there is counted, and no reason.
  if (is(first, ChunkKind::kNoun) && names_thing(first) && chunk(first).noun.count > 0 && next(first) == end) return false;
  if (says_what_is_there(first, end) || (why && says_where_known_is(first, end))) return false;
  // "nobody touches the harp, which stands by the window"
  if (is(next(end), ChunkKind::kRelative) && is(previous(end), ChunkKind::kNoun) && chunk(previous(end)).noun.kind == NounKind::kObject)
    return false;
  mark(k, Use::kIgnored, "told by the way");
  for (std::size_t c = first; c < end; ++c) {
    mark(c, Use::kIgnored, "told by the way");
    if (is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kRoom && !is_past(chunk(c).noun)) name_room(chunk(c).noun);
  }
  passed_until_ = end;
  return true;
}

// "he repairs watches at a workbench": where it is done is there.
bool UnitReader::does_it_there(std::size_t k) const {
  const std::size_t n = next(k);
  if (!doing_ || !is(n, ChunkKind::kNoun) || chunk(k).phrase.length > 2) return false;
  const NounPhrase& noun = chunk(n).noun;
  if (noun.kind != NounKind::kObject || noun.entry == nullptr || (noun.determiner == Determiner::kNone && noun.count == 0)) return false;
  return noun.entry->mount == Mount::kFloor && !noun.entry->is(Trait::kPet) && has_direction(*chunk(k).phrase.senses, Direction::kDirect);
}

// A known kind of thing, not what is done to it or with it.
bool UnitReader::names_thing(std::size_t k) const {
  return is(k, ChunkKind::kNoun) && chunk(k).noun.kind == NounKind::kObject && chunk(k).noun.exact;
}

// "Portraits are taken in this studio", "Shoes are repaired here": what is done in the room, no thing in it.
bool UnitReader::is_done_here(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t be = noun.last;
  if (noun.kind != NounKind::kObject || noun.determiner != Determiner::kNone || noun.count > 0 || !noun.plural || !units_.empty() ||
      be + 2 >= document_.tokens.size() || !lexicon_.is(document_.tokens[be], WordClass::kBe))
    return false;
  const Token& done = document_.tokens[be + 1];
  if (lexicon_.is(done, WordClass::kParticiple) || lexicon_.is(done, WordClass::kHang) || lexicon_.is(done, WordClass::kHave)) return false;
  if (document_.tokens[be + 2].text == "here") return true;
  for (std::size_t c = k + 1; c < document_.chunks.size() && !is(c, ChunkKind::kStop) && !is(c, ChunkKind::kComma); ++c) {
    if (is(c, ChunkKind::kNoun)) return chunk(c).noun.kind == NounKind::kRoom && chunk(c).noun.determiner == Determiner::kDefinite;
  }
  return false;
}

// "the vet weighs every poodle on the scales by the door": where the scales are.
bool UnitReader::is_used_in_place(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t by = next(next(k));
  return noun.kind == NounKind::kObject && noun.exact && noun.determiner == Determiner::kDefinite && !lexicon_.is_person(noun.head) &&
         !noun.entry->is(Trait::kPet) && is(next(k), ChunkKind::kRelation) && is(by, ChunkKind::kNoun) &&
         (chunk(by).noun.determiner == Determiner::kDefinite || chunk(by).noun.kind == NounKind::kPronoun);
}

// "We see both from the nurses' station, so put that by the wall": what was told of is meant, and with it is there.
void UnitReader::take_told(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  if (skipping_ || noun.kind != NounKind::kPronoun || noun.plural || !one_of(noun.head, {"it", "that", "this"}) || told_ >= k) return;
  const std::size_t told = std::exchange(told_, static_cast<std::size_t>(-1));
  if (std::ranges::any_of(units_, [](const Unit& unit) { return unit.kind == UnitKind::kNoun; })) return;
  const NounPhrase said = noun;
  noun = chunk(told).noun;
  noun.first = said.first;
  noun.last = said.last;
}

// "beside the fire crouches a gargoyle": a verb that no list has, between a place and a thing.
bool UnitReader::inverts(std::size_t k) const {
  const std::size_t n = units_.size();
  if (skipping_ || chunk(k).last - chunk(k).first != 1 || n < 2 || units_[n - 1].kind != UnitKind::kNoun ||
      units_[n - 2].kind != UnitKind::kPlace || previous(k) != units_[n - 1].chunk || !is(next(k), ChunkKind::kNoun))
    return false;
  const bool fronted = n == 2 || units_[n - 2].joiner != Joiner::kNone || units_[n - 2].clause;
  const std::string& word = document_.tokens[chunk(k).first].text;
  return fronted && chunk(next(k)).noun.kind == NounKind::kObject && is_new_here(chunk(next(k)).noun) && word_form(word) == WordForm::kVerb;
}

// "on the plinth stands a centurion", "a homunculus in the jar": in or on what is for nobody, a figure.
bool UnitReader::is_figure(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  if (noun.kind != NounKind::kAbstract || !noun.doubted || !is_new_here(noun) || lexicon_.is_person(noun.head) ||
      word_form(noun.head) != WordForm::kPerson)
    return false;
  const auto holds = [&](std::size_t place, std::size_t host) {
    if (!is(place, ChunkKind::kRelation) || !is(host, ChunkKind::kNoun) || chunk(host).noun.entry == nullptr) return false;
    const PhraseSenses& senses = *chunk(place).phrase.senses;
    const NounPhrase& by = chunk(host).noun;
    return says(senses, &RelationTraits::rests) && by.kind == NounKind::kObject && !by.entry->thin && !is_seat(lexicon_.catalog(), by) &&
           !by.entry->is(Trait::kBed);
  };
  const std::size_t n = next(k);
  if (holds(is(n, ChunkKind::kVerb) ? next(n) : n, next(is(n, ChunkKind::kVerb) ? next(n) : n))) return true;
  std::size_t before = previous(k);
  if (is(before, ChunkKind::kVerb)) before = previous(before);
  return before < document_.chunks.size() && before > 0 && holds(previous(before), before);
}

}  // namespace layoutbox::offline
