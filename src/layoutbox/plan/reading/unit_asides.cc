// What a text tells besides what stands in the room: why, what somebody does, what the room is like. It brings in nothing.
#include <algorithm>
#include <string_view>

#include "layoutbox/plan/offline/english.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

namespace {

bool is_new_here(const NounPhrase& noun) {
  return noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || noun.count > 0;
}

}  // namespace

// Where the clause that follows chunk k is over: at a stop, or at a break after which the room is spoken of again.
std::size_t UnitReader::clause_end(std::size_t k) const {
  std::size_t c = k + 1;
  while (is(c, ChunkKind::kClause)) ++c;  // "since nobody"
  for (; c < document_.chunks.size() && !is(c, ChunkKind::kStop) && !is(c, ChunkKind::kClause); ++c) {
    if ((is(c, ChunkKind::kComma) || is(c, ChunkKind::kAnd)) && purpose_ends(c, next(c))) break;
  }
  return c;
}

bool UnitReader::is_person(std::size_t k) const {
  if (k >= document_.chunks.size()) return false;
  const Chunk& who = chunk(k);
  const Token& token = document_.tokens[who.first];
  if (who.kind == ChunkKind::kNoun)
    return (who.noun.kind == NounKind::kPronoun && one_of(token.text, {"they", "them", "him"})) || lexicon_.is_person(who.noun.head) ||
           (!who.noun.exact && word_form(who.noun.head) == WordForm::kPerson);
  return lexicon_.is(token, WordClass::kOwnClause) || one_of(token.text, {"i", "we", "nobody", "no"});
}

// Whether the chunks [first, last) say that something is somewhere, or that it is there.
bool UnitReader::says_what_is_there(std::size_t first, std::size_t last) const {
  bool told = false, thing = false;
  for (std::size_t c = first; c < last; ++c) {
    if (is(c, ChunkKind::kThere) || is(c, ChunkKind::kWithout)) return true;
    told = told || is_person(c) || is(c, ChunkKind::kPurpose) || is(c, ChunkKind::kUnknown);
    if (!is(c, ChunkKind::kNoun) || chunk(c).noun.kind != NounKind::kObject || !chunk(c).noun.exact) continue;
    const std::size_t n = next(c);
    const bool placed = n < last && (is(n, ChunkKind::kRelation) || is(n, ChunkKind::kParticiple) || is(n, ChunkKind::kVerb));
    if (placed && !told) return true;
    thing = thing || is_new_here(chunk(c).noun);
  }
  return thing && !told;
}

// "because my knee gets stiff", "so that the postman can rest", "where grandpa tells his stories": the clause at k, told by the way.
bool UnitReader::passes_aside(std::size_t k) {
  static constexpr std::string_view kWhy[] = {"because", "since", "so", "that", "if", "unless", "case", "hence", "otherwise", "why",
                                              "although", "though", "until", "whenever", "when"};
  const std::size_t first = k + 1, end = clause_end(k);
  if (first >= end || is(first, ChunkKind::kComma)) return false;
  const bool why = std::ranges::find(kWhy, document_.tokens[chunk(k).last - 1].text) != std::end(kWhy);
  if (!why && !is_person(k) && !is_person(first)) return false;
  if (says_what_is_there(first, end)) return false;
  mark(k, Use::kIgnored, "told by the way");
  for (std::size_t c = first; c < end; ++c) {
    mark(c, Use::kIgnored, "told by the way");
    if (is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kRoom && !is_past(chunk(c).noun))
      document_.rooms.push_back(chunk(c).noun);
  }
  passed_until_ = end;
  return true;
}

// "my flat is a matchbox", "it's basically a shoebox", "the sofa is an antique": what something is called, no thing of its own.
bool UnitReader::is_said_of_subject(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  if (noun.kind != NounKind::kObject || units_.size() < 2 || joiner_ != Joiner::kNone || units_.back().kind != UnitKind::kVerb) return false;
  static constexpr std::string_view kBe[] = {"is", "are", "was", "were", "be", "been"};
  const Unit& subject = units_[units_.size() - 2];
  if (subject.kind != UnitKind::kNoun || std::ranges::find(kBe, document_.tokens[chunk(units_.back().chunk).last - 1].text) == std::end(kBe))
    return false;
  // "behind the desk is a chair"
  const bool first = units_.size() == 2 || subject.joiner != Joiner::kNone || subject.clause || units_[units_.size() - 3].kind == UnitKind::kOpen;
  if (!first) return false;
  for (std::size_t u = units_.size() - 2; u-- > 0 && !units_[u + 1].clause;) {
    if (units_[u].kind == UnitKind::kVerb) break;
    if (units_[u].kind == UnitKind::kPlace && (u == 0 || units_[u - 1].kind != UnitKind::kNoun)) return false;
  }
  const NounPhrase& what = chunk(subject.chunk).noun;
  const std::size_t n = next(k);
  const bool listed = is(n, ChunkKind::kComma) || is(n, ChunkKind::kAnd);
  if (what.kind == NounKind::kRoom || what.kind == NounKind::kOutsideRoom || (what.kind == NounKind::kPronoun && what.head == "it"))
    return !(noun.exact && listed && document_.rooms.empty());
  // "the centerpiece is a piano" names the piano.
  return what.kind == NounKind::kObject && what.exact;
}

// The first thing that a text names, alone in its sentence and of no kind that is known: its title, and so the room.
// "The bridge of the freighter Ostrava. …"
bool UnitReader::is_title(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t n = next(k);
  if (noun.kind != NounKind::kObject || noun.exact || noun.count > 0 || noun.plural || !units_.empty() || !is(n, ChunkKind::kStop) ||
      n + 1 >= document_.chunks.size())
    return false;
  return noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kNone || noun.entry == nullptr;
}

// "chairs around the table, eight of them", "lamps (three)": how many of what was named before.
bool UnitReader::counts_before(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const bool alone = noun.kind == NounKind::kMember && noun.attributes.empty() && noun.ordinal == 0 && !noun.of;
  const std::size_t n = next(k);
  if (!alone || noun.count < 2 || joiner_ != Joiner::kComma || !(is(n, ChunkKind::kStop) || is(n, ChunkKind::kComma))) return false;
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

// "Items on the shelf: a clock, a vase": no things, but what announces them.
bool UnitReader::announces_things(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  if (noun.kind != NounKind::kObject || !noun.plural || noun.count > 0 || noun.determiner != Determiner::kNone || !units_.empty() ||
      !(is_collective(noun.head) || noun.head == "thing") || noun.name != noun.head)
    return false;
  for (std::size_t c = k + 1; c < document_.chunks.size() && !is(c, ChunkKind::kStop); ++c) {
    if (document_.tokens[chunk(c).first].text == ":") return true;
  }
  return false;
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
    return (says(senses, RelationType::kOn) || says(senses, RelationType::kIn)) && by.kind == NounKind::kObject && !by.entry->thin &&
           !is_seat(lexicon_.catalog(), by) && !lexicon_.catalog().is_a(by.entry->id, "bed");
  };
  const std::size_t n = next(k);
  if (holds(is(n, ChunkKind::kVerb) ? next(n) : n, next(is(n, ChunkKind::kVerb) ? next(n) : n))) return true;
  std::size_t before = previous(k);
  if (is(before, ChunkKind::kVerb)) before = previous(before);
  return before < document_.chunks.size() && before > 0 && holds(previous(before), before);
}

// "the middle of the chamber", "a corner of the burrow": of the room, where nothing of that name is known or was named.
bool UnitReader::is_within_room(const NounPhrase& noun) const {
  const bool place = noun.kind == NounKind::kCenter || noun.kind == NounKind::kCorner || noun.kind == NounKind::kFloor ||
                     noun.kind == NounKind::kCeiling || noun.kind == NounKind::kWall;
  if (!place || !noun.of || noun.of->kind != NounKind::kObject || noun.of->exact || noun.of->entry != nullptr ||
      noun.of->determiner != Determiner::kDefinite)
    return false;
  return std::ranges::none_of(document_.chunks, [&](const Chunk& c) {
    return c.kind == ChunkKind::kNoun && c.first < noun.first && c.noun.kind == NounKind::kObject && c.noun.head == noun.of->head;
  });
}

}  // namespace layoutbox::offline
