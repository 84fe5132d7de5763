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

// The unit that the noun at k is said to be: "my flat is a …", "it's a …"; past the end if there is none.
std::size_t UnitReader::subject_of_being(std::size_t k) const {
  static constexpr std::string_view kBe[] = {"is", "are", "was", "were", "be", "been"};
  const std::size_t none = units_.size();
  if (units_.empty() || joiner_ != Joiner::kNone) return none;
  if (units_.back().kind == UnitKind::kNoun) {
    const std::size_t end = chunk(units_.back().chunk).last;
    return end < document_.tokens.size() && document_.tokens[end].text == "'s" && previous(k) == units_.back().chunk ? none - 1 : none;
  }
  if (none < 2 || units_.back().kind != UnitKind::kVerb || units_[none - 2].kind != UnitKind::kNoun) return none;
  const std::string& be = document_.tokens[chunk(units_.back().chunk).last - 1].text;
  return std::ranges::find(kBe, be) == std::end(kBe) ? none : none - 2;
}

// "my flat is a matchbox", "it's basically a shoebox", "the sofa is an antique": what something is called, no thing of its own.
bool UnitReader::is_said_of_subject(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  // "the case with the urn is the centerpiece and stands …"
  if (noun.head == "centerpiece" && noun.determiner == Determiner::kDefinite && !units_.empty() && units_.back().kind == UnitKind::kVerb &&
      units_.front().kind == UnitKind::kNoun && joiner_ == Joiner::kNone)
    return true;
  const std::size_t at = noun.kind == NounKind::kObject ? subject_of_being(k) : units_.size();
  if (at >= units_.size()) return false;
  const Unit& subject = units_[at];
  // "behind the desk is a chair"
  const bool first = at == 0 || subject.joiner != Joiner::kNone || subject.clause || units_[at - 1].kind == UnitKind::kOpen;
  if (!first) return false;
  for (std::size_t u = at; u-- > 0 && !units_[u + 1].clause;) {
    if (units_[u].kind == UnitKind::kVerb) break;
    if (units_[u].kind == UnitKind::kPlace && (u == 0 || units_[u - 1].kind != UnitKind::kNoun)) return false;
  }
  NounPhrase& what = document_.chunks[subject.chunk].noun;
  const std::size_t n = next(k);
  const bool listed = is(n, ChunkKind::kComma) || is(n, ChunkKind::kAnd);
  if (what.kind == NounKind::kRoom || what.kind == NounKind::kOutsideRoom || (what.kind == NounKind::kPronoun && what.head == "it"))
    return !(noun.exact && (noun.count > 1 || (listed && document_.rooms.empty())));  // "it's eight washers down one wall"
  // "the centerpiece is a piano" names the piano, and so does "the furniture is a piano".
  if (what.kind != NounKind::kObject || !what.exact || (noun.count > 1 && !what.plural)) return false;
  const bool generic = one_of(what.head, WordSet::kAnyFurniture);
  const bool of_kind = noun.exact && noun.entry != what.entry && lexicon_.catalog().is_a(noun.entry->id, what.entry->id);
  if ((generic || of_kind) && noun.exact && !is_named_before(subject.chunk, what.head)) {
    const NounPhrase said = what;
    what = noun;
    what.first = said.first;
    what.last = said.last;
    what.determiner = said.determiner;
  }
  return true;
}

// A thing so called stands in the text shortly before chunk k.
bool UnitReader::is_named_before(std::size_t k, std::string_view head) const {
  constexpr std::size_t kBack = 400;
  for (std::size_t c = k; c-- > 0 && c + kBack > k;) {
    if (is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kObject && chunk(c).noun.head == head) return true;
  }
  return false;
}

// The first thing that a text names, alone in its sentence and of no kind that is known: its title, and so the room.
// "The bridge of the freighter Ostrava. …"
bool UnitReader::is_title(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t n = next(k);
  if (noun.kind != NounKind::kObject || noun.exact || noun.count > 0 || noun.plural || !units_.empty() || n + 1 >= document_.chunks.size())
    return false;
  if (is(n, ChunkKind::kComma)) {
    const std::size_t after = next(n);
    const bool of_room = is(after, ChunkKind::kNoun) && chunk(after).noun.kind == NounKind::kRoom;  // "The Drowned Rat, common room"
    if (noun.entry != nullptr) return of_room && noun.determiner == Determiner::kNone;              // "Community radio, studio 1"
    return of_room || document_.tokens[chunk(n).first].text == ":" || is(after, ChunkKind::kWithout) || is(after, ChunkKind::kSize) ||
           is(after, ChunkKind::kComma);
  }
  if (!is(n, ChunkKind::kStop)) return false;
  return noun.determiner == Determiner::kDefinite || noun.entry == nullptr;
}

// "chairs around the table, eight of them", "lamps (three)": how many of what was named before.
// "(two per side, so four)", "three each, making six in all": the number that was not said with the things.
bool UnitReader::sums_up(std::size_t k) const {
  if (!is(k, ChunkKind::kNoun) || chunk(k).first == 0) return false;
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t n = next(k);
  const bool ends = n >= document_.chunks.size() || is(n, ChunkKind::kStop) || is(n, ChunkKind::kComma);
  return noun.kind == NounKind::kMember && noun.count > 1 && noun.attributes.empty() && !noun.of && ends &&
         one_of(document_.tokens[chunk(k).first - 1].text, {"so", "making", "makes", "totaling", "giving"});
}

bool UnitReader::counts_before(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const bool alone = noun.kind == NounKind::kMember && noun.attributes.empty() && noun.ordinal == 0 && !noun.of;
  const std::size_t n = next(k);
  const bool listed = joiner_ == Joiner::kComma && (is(n, ChunkKind::kStop) || is(n, ChunkKind::kComma));
  if (!alone || noun.count < 2 || !(listed || sums_up(k))) return false;
  for (std::size_t u = units_.size(); u-- > 0;) {
    if (units_[u].kind != UnitKind::kNoun) continue;
    NounPhrase& named = document_.chunks[units_[u].chunk].noun;
    if (named.kind != NounKind::kObject || !named.plural || named.count > 0) continue;
    named.count = noun.count;
    mark(k, Use::kUsed, "how many");
    return true;
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

// "Copy this layout: …": an unknown word before a determiner is what one is told to do.
bool UnitReader::opens_command(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  if (noun.kind != NounKind::kObject || noun.exact || noun.plural || noun.determiner != Determiner::kNone || noun.count > 0 ||
      !units_.empty() || noun.last != noun.first + 1 || !is(k + 1, ChunkKind::kNoun) ||
      (chunk(k + 1).noun.determiner != Determiner::kDefinite && chunk(k + 1).noun.determiner != Determiner::kIndefinite))
    return false;
  mark(k, Use::kIgnored, "opens a statement");
  return true;
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

// "Items on the shelf: a clock, a vase": no things, but what announces them.
bool UnitReader::announces_things(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const bool object = noun.kind == NounKind::kObject;
  // "The only decoration, a wall clock, …"
  const std::size_t n = next(k), named = next(n);
  if (object && is_collective(noun.head) && noun.determiner == Determiner::kDefinite && is(n, ChunkKind::kComma) &&
      is(named, ChunkKind::kNoun) && is_new_here(chunk(named).noun))
    return true;
  if (noun.count > 0 || noun.determiner != Determiner::kNone || !units_.empty() || noun.name != noun.head) return false;
  const bool alone = one_of(noun.head, WordSet::kHeadings);
  const bool ends = is(n, ChunkKind::kStop) || (is(n, ChunkKind::kComma) && document_.tokens[chunk(n).first].text == ":");
  if (object && alone && ends) return true;
  const bool things = object && noun.plural && (is_collective(noun.head) || noun.head == "thing");
  // "Dressing on the desk: typewriter, telephone"
  const bool heading =
      !noun.exact && !noun.plural && is(n, ChunkKind::kRelation) && (noun.kind == NounKind::kAbstract || (object && noun.entry == nullptr));
  if (!things && !heading) return false;
  for (std::size_t c = k + 1; c < document_.chunks.size() && !is(c, ChunkKind::kStop); ++c) {
    if (document_.tokens[chunk(c).first].text == ":") return true;
  }
  return false;
}

// "Multi-faith room, regional airport.": where the room is, at the very beginning.
bool UnitReader::is_address(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  return sentences_.empty() && units_.size() == 1 && units_.back().kind == UnitKind::kNoun &&
         chunk(units_.back().chunk).noun.kind == NounKind::kRoom && joiner_ == Joiner::kComma && is(next(k), ChunkKind::kStop) &&
         noun.kind == NounKind::kObject && !noun.exact && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural;
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

// "Dear computer, …", "Hello helper!": who is spoken to.
bool UnitReader::is_addressed(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const bool ends = is(next(k), ChunkKind::kComma) || is(next(k), ChunkKind::kStop);
  if (!ends || !units_.empty() || noun.count > 0) return false;
  const std::size_t first = chunk(k).first;
  const auto greets = [&](std::size_t i) { return one_of(document_.tokens[i].text, WordSet::kGreetings); };
  return (greets(first) && noun.last > first + 1) || (first > 0 && greets(first - 1));
}

// "the middle of the chamber", "a corner of the burrow": of the room, where nothing of that name is known or was named.
bool UnitReader::is_within_room(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const bool place = noun.kind == NounKind::kCenter || noun.kind == NounKind::kCorner || noun.kind == NounKind::kFloor ||
                     noun.kind == NounKind::kCeiling || noun.kind == NounKind::kWall;
  if (!place || !noun.of || noun.of->kind != NounKind::kObject || noun.of->exact || noun.of->entry != nullptr ||
      noun.of->determiner != Determiner::kDefinite)
    return false;
  return !is_named_before(k, noun.of->head);
}

// "The altar, a plain block of limestone, is raised on a platform": what the subject is, said between commas.
bool UnitReader::passes_apposition(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  // "next to it is the oven, a tall steel thing; …"
  const bool vague =
      noun.kind == NounKind::kObject && noun.determiner == Determiner::kIndefinite && one_of(noun.head, WordSet::kApposedThings);
  const std::size_t after = next(k);  // "a bed, a contraption and a clock" is a list
  const bool listed = is(after, ChunkKind::kAnd) || (is(after, ChunkKind::kComma) && is(next(after), ChunkKind::kAnd));
  if (vague && !listed && joiner_ == Joiner::kComma && !units_.empty() && units_.back().kind == UnitKind::kNoun) {
    mark(k, WordReading::Use::kUsed, "what it is");
    return true;
  }
  if (joiner_ != Joiner::kComma || units_.size() != 1 || units_.front().kind != UnitKind::kNoun) return false;
  std::size_t end = next(k);
  if (is(end, ChunkKind::kUnknown) || is(end, ChunkKind::kAttribute) ||
      (is(end, ChunkKind::kNoun) && chunk(end).noun.kind == NounKind::kAbstract))
    end = next(end);  // "of limestone"
  const bool between = noun.determiner == Determiner::kIndefinite && !noun.is_plural() && is(end, ChunkKind::kComma) &&
                       chunk(end).last < document_.tokens.size();
  if (!between) return false;
  const NounPhrase& subject = chunk(units_.front().chunk).noun;
  const std::string& verb = document_.tokens[chunk(end).last].text;
  const bool finite = (is(next(end), ChunkKind::kVerb) || is(next(end), ChunkKind::kRelation)) && is_finite(verb);
  const bool one = subject.kind == NounKind::kObject && !subject.is_plural() && (verb == "is" || verb == "was" || finite);
  const bool known = subject.determiner == Determiner::kDefinite || subject.determiner == Determiner::kPossessive;
  if (!one || !known) return false;
  mark(k, WordReading::Use::kUsed, "what it is");
  joiner_ = Joiner::kNone;
  passed_until_ = next(end);
  return true;
}

}  // namespace layoutbox::offline
