// Nouns that bring in nothing: what a thing is called, titles, headings, addresses, who is spoken to.
#include <algorithm>
#include <string_view>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

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
    mark(k, Use::kUsed, "what it is");
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
  mark(k, Use::kUsed, "what it is");
  joiner_ = Joiner::kNone;
  passed_until_ = next(end);
  return true;
}

}  // namespace layoutbox::offline
