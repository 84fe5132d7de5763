// Clauses that seem to say what something is for, and bring things in: who put them there, what a thing keeps, offers or serves for.

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// "In the corner someone has put down a crate": it is there.
bool UnitReader::passes_placer(std::size_t k) {
  if (!one_of(document_.tokens[chunk(k).first].text, {"someone", "somebody"}) || chunk(k).last - chunk(k).first != 1) return false;
  std::size_t n = next(k);
  bool placing = false;
  const auto is_verb = [&](std::size_t c) {
    return is(c, ChunkKind::kHave) || is(c, ChunkKind::kVerb) || is(c, ChunkKind::kParticiple) || is_unread_verb(c);
  };
  for (; is_verb(n); n = next(n)) placing |= !is(n, ChunkKind::kHave);
  // "a cart that somebody has rolled up beside the door"
  if (placing && is(n, ChunkKind::kRelation) && is(previous(k), ChunkKind::kRelative)) {
    for (std::size_t c = k; c < n; ++c) mark(c, Use::kIgnored, "placing");
    skipping_ = false;
    passed_until_ = n;
    return true;
  }
  if (!placing || !is(n, ChunkKind::kNoun) || chunk(n).noun.kind != NounKind::kObject) return false;
  for (std::size_t c = k; c < n; ++c) mark(c, Use::kIgnored, "opens a statement");
  skipping_ = false;
  add(UnitKind::kOpen, k);
  passed_until_ = n;
  return true;
}

// "a shelf on which she keeps four jars": they are there.
bool UnitReader::passes_keeper(std::size_t k) {
  if (passes_placer(k)) return true;
  const std::size_t verb = next(k), thing = next(verb);
  if (skipping_ || units_.empty() || units_.back().kind != UnitKind::kNoun || chunk(units_.back().chunk).noun.head != "which") return false;
  if (joiner_ != Joiner::kNone || !(is(verb, ChunkKind::kHave) || is(verb, ChunkKind::kVerb)) || !is(thing, ChunkKind::kNoun)) return false;
  mark(k, Use::kIgnored, "opens a statement");
  mark(verb, Use::kIgnored, "opens a statement");
  add(UnitKind::kOpen, k);
  passed_over_ = verb;
  return true;
}

// "a shelf for controllers and headsets", "the room offers a fireplace and two sofas": what a verb of purpose names is there.
bool UnitReader::names_contents(std::size_t k) const {
  if (skipping_ || last_noun() >= document_.chunks.size() || joiner_ != Joiner::kNone || previous(k) != last_noun()) return false;
  const std::size_t n = next(k), before = subject_before();
  if (!is(n, ChunkKind::kNoun)) return false;
  const std::string& word = document_.tokens[chunk(k).first].text;
  const NounPhrase &host = chunk(before).noun, &thing = chunk(n).noun;
  if (word == "for") {
    return host.kind == NounKind::kObject && one_of(host.head, WordSet::kStorageFor) && !is(next(n), ChunkKind::kRelation) &&
           thing.kind == NounKind::kObject && thing.exact && thing.plural && thing.determiner == Determiner::kNone && thing.count == 0 &&
           mount_of(thing) == Mount::kSurface;
  }
  // "the left wall takes two bookcases"
  const bool takes = one_of(word, WordSet::kTaking);
  if (takes && (host.kind == NounKind::kWall || host.kind == NounKind::kCorner || host.kind == NounKind::kObject))
    return thing.kind == NounKind::kObject && (thing.determiner == Determiner::kIndefinite || thing.count > 0) && !is_person(before);
  const bool shows = one_of(word, WordSet::kOffering);
  // "the table offers five magazines", but no lamp "offers light"
  const bool lies =
      thing.kind == NounKind::kObject && (thing.exact || thing.count > 0) && mount_of(thing) == Mount::kSurface && is_new_here(thing);
  if (shows && lies && may_carry(lexicon_.catalog(), host, thing)) return true;
  const bool room = host.kind == NounKind::kRoom || host.kind == NounKind::kOutsideRoom;
  const bool there =
      thing.kind == NounKind::kObject || thing.as_object != nullptr || thing.kind == NounKind::kWindow || thing.kind == NounKind::kDoor;
  return room && there && shows;
}

// "one locker for each bed", "for every desk one chair": what those have.
bool UnitReader::brings_for_each(std::size_t k) {
  const std::size_t n = next(k);
  if (skipping_ || document_.tokens[chunk(k).first].text != "for" || !is(n, ChunkKind::kNoun)) return false;
  const NounPhrase& noun = chunk(n).noun;
  const bool things = noun.kind == NounKind::kObject || (noun.kind == NounKind::kMember && noun.of && noun.of->kind == NounKind::kObject);
  const std::size_t host = last_noun();
  // "a chair for the desk": at it.
  const bool seat = noun.kind == NounKind::kObject && noun.exact && noun.determiner == Determiner::kDefinite && host == previous(k) &&
                    is(host, ChunkKind::kNoun) && is_seat(lexicon_.catalog(), chunk(host).noun) && is_table(lexicon_.catalog(), noun);
  if ((noun.determiner != Determiner::kEach && !seat) || !things) return false;
  mark(k, Use::kUsed, "has");
  add_place(k, direct_senses<RelationType::kNextTo>());
  return true;
}

// "a trunk serves as a table for a thermos and two notepads": they are on it.
bool UnitReader::serves_for(std::size_t k, std::size_t role) {
  const std::size_t whom = next(role), thing = next(whom);
  if (units_.empty() || !is(whom, ChunkKind::kPurpose) || document_.tokens[chunk(whom).first].text != "for" || !is(thing, ChunkKind::kNoun))
    return false;
  const NounPhrase &noun = chunk(thing).noun, &as = chunk(role).noun;
  const bool anew = noun.kind == NounKind::kObject && (noun.determiner == Determiner::kIndefinite || noun.count > 0);
  if (!anew || is_person(thing) || !may_carry(lexicon_.catalog(), as, noun)) return false;
  for (std::size_t c = k; c <= role; ++c) mark(c, Use::kIgnored, "purpose");
  mark(whom, Use::kUsed, "has");
  skipping_ = false;
  // On it, though it has an inside, where what it serves as has none.
  static const PhraseSenses kTopped = {{RelationType::kOn, PhraseSense::Direction::kInverse, {}, {}, {}}};
  if (is_table(lexicon_.catalog(), as)) {
    document_.chunks[whom].kind = ChunkKind::kRelation;
    document_.chunks[whom].phrase.senses = &kTopped;
    add_place(whom, kTopped);
  } else {
    add(UnitKind::kHave, whom);
  }
  passed_until_ = thing;
  return true;
}

// Flat, and nothing is in it or on it.
bool UnitReader::is_picture(const NounPhrase& noun) const {
  const bool flat = noun.kind == NounKind::kObject && (mount_of(noun) == Mount::kWall || is_textile(lexicon_.catalog(), noun));
  return flat && (noun.entry == nullptr || (!noun.entry->top_carries && noun.entry->spaces.empty()));
}

// "a poster depicting a whale hangs above the bed", "a clock showing two time zones": what a flat thing shows is none of the room's.
bool UnitReader::passes_depicted(std::size_t k) {
  if (!one_of(document_.tokens[chunk(k).first].text, WordSet::kPicturing) || !is(next(k), ChunkKind::kNoun)) return false;
  const bool own = chunk(next(k)).noun.determiner == Determiner::kPossessive;  // "a piano, showing its strings"
  if (!own && (last_noun() != previous(k) || !is_picture(chunk(last_noun()).noun))) return false;
  std::size_t end = next(k);
  while (is(end, ChunkKind::kNoun) || (is(end, ChunkKind::kAnd) && is(next(end), ChunkKind::kNoun))) end = next(end);
  for (std::size_t c = k; c < end; ++c) mark(c, Use::kIgnored, "what it shows");
  passed_until_ = end;
  return true;
}

// "a dresser that doubles as a changing table next to it": what it is used as is no thing; what follows is said of it.
bool UnitReader::passes_role(std::size_t k) {
  const std::size_t n = next(k);
  if (document_.tokens[chunk(k).last - 1].text != "as" || !is(n, ChunkKind::kNoun) || chunk(n).noun.kind != NounKind::kObject) return false;
  if (skipping_ && (k == 0 || !is(k - 1, ChunkKind::kPurpose))) return false;
  const std::size_t then = next(next(n));
  const bool list =
      is(next(n), ChunkKind::kAnd) && !is(then, ChunkKind::kRelation) && !is(then, ChunkKind::kHave) && !is(then, ChunkKind::kVerb);
  if (serves_for(k, n)) return true;
  if (list || (chunk(k).first > 0 && document_.tokens[chunk(k).first - 1].text == "such")) return false;
  mark(k, Use::kIgnored, "purpose");
  mark(n, Use::kIgnored, "purpose");
  passed_over_ = n;
  skipping_ = false;
  return true;
}

}  // namespace layoutbox::offline
