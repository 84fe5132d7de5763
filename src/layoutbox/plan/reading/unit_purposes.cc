// Purposes, roles, for how many, and what is not wanted.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/english.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/offline/word_sets.h"
#include "layoutbox/plan/reading/unit_reader.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// "…, for seven stools stand before it": why, and what is there.
bool UnitReader::gives_reason(std::size_t k) {
  const std::size_t n = next(k), verb = next(n);
  if (document_.tokens[chunk(k).first].text != "for" || !is(previous(k), ChunkKind::kComma) || !is(n, ChunkKind::kNoun) ||
      !is(verb, ChunkKind::kVerb) || chunk(n).noun.kind != NounKind::kObject ||
      !(chunk(n).noun.is_plural() || is_finite(document_.tokens[chunk(verb).first].text)))
    return false;
  mark(k, Use::kIgnored, "joins clauses");
  clause_ = true;
  negated_ = skipping_ = false;
  joiner_ = Joiner::kNone;
  return true;
}

void UnitReader::read_purpose(std::size_t k) {
  if (gives_reason(k)) return;
  if (passes_keeper(k) || shares_by_purpose(k) || passes_like(k) || keeps_place_for(k) || wishes_to(k)) return;
  if (reads_as_verb(k) || inverts(k)) {
    mark(k, Use::kUsed, "placing");
    add(UnitKind::kVerb, k);
    return;
  }
  if (names_contents(k) || wall_has(k)) {
    mark(k, Use::kUsed, "has");
    add(UnitKind::kHave, k);
    return;
  }
  if (passes_count(k) || passes_role(k) || brings_for_each(k) || brings_each(k)) return;
  if (k > 0 && chunk(k).first > 0 && lexicon_.is(document_.tokens[chunk(k).first - 1], WordClass::kCommand) &&
      lexicon_.is(document_.tokens[chunk(k).first], WordClass::kCommand)) {
    mark(k, Use::kIgnored, "opens a statement");  // "for the bedroom I imagine a bed"
    return;
  }
  mark(k, Use::kIgnored, "purpose");
  doing_ = is_person(previous(k)) || is_person(k);
  skipping_ = true;
  joiner_ = Joiner::kNone;
}

// "for my brother, who fixes bikes": what somebody does, to no things in particular.
bool UnitReader::passes_trade(std::size_t k) {
  if (document_.tokens[chunk(k).first].text != "who") return false;
  const std::size_t verb = next(k);
  const bool filler = is(verb, ChunkKind::kNoun) && chunk(k).last < chunk(verb).first;
  if (!filler && !is(verb, ChunkKind::kUnknown) && !is(verb, ChunkKind::kVerb) && !is(verb, ChunkKind::kPurpose)) return false;
  const std::size_t thing = filler ? verb : next(verb);
  if (!is(thing, ChunkKind::kNoun)) return false;
  const NounPhrase& noun = chunk(thing).noun;
  if (noun.kind != NounKind::kObject || noun.determiner != Determiner::kNone || noun.count > 0) return false;
  for (std::size_t c = k; c <= thing; ++c) mark(c, Use::kIgnored, "purpose");
  document_.chunks[thing - 1].kind = ChunkKind::kPurpose;
  skipping_ = doing_ = true;
  passed_until_ = thing + 1;
  return true;
}

// "and then like a mirror over the sink" says nothing; "another just like it to the right", "a clock shaped like a cat" say which one.
bool UnitReader::passes_like(std::size_t k) {
  const std::size_t like = next(k), p = previous(k);
  if (skipping_ || document_.tokens[chunk(k).first].text != "like" || chunk(k).last - chunk(k).first != 1 || !is(like, ChunkKind::kNoun))
    return false;
  const NounPhrase& noun = chunk(like).noun;
  if (is(p, ChunkKind::kNoun) && (noun.kind == NounKind::kPronoun || noun.kind == NounKind::kMember)) {
    mark(k, Use::kIgnored, "filler");
    mark(like, Use::kIgnored, "filler");
    passed_over_ = like;
    return true;
  }
  const bool breaks = is(p, ChunkKind::kAnd) || is(p, ChunkKind::kComma) || is(p, ChunkKind::kStop) || is(p, ChunkKind::kClause) ||
                      is(p, ChunkKind::kThere) || is(p, ChunkKind::kHave);
  const bool anew = noun.kind == NounKind::kObject && (noun.determiner == Determiner::kIndefinite || noun.count > 0);
  if (!breaks || !anew) return false;
  mark(k, Use::kIgnored, "filler");
  return true;
}

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

// A verb that no list has, and then a place: "a lamp towers over the desk", "two stools huddle by the bar".
bool UnitReader::reads_as_verb(std::size_t k) const {
  const std::size_t p = previous(k);
  const bool would = is(p, ChunkKind::kVerb) && chunk(p).passive && is(previous(p), ChunkKind::kNoun);  // "would look good in the corner"
  if (skipping_ || chunk(k).last - chunk(k).first != 1 || !(is(p, ChunkKind::kNoun) || would)) return false;
  const std::size_t n = next(k);
  if (!is(n, ChunkKind::kRelation) || !is(next(n), ChunkKind::kNoun)) return false;
  const std::string& word = document_.tokens[chunk(k).first].text;
  return word_form(word) == WordForm::kVerb && !lexicon_.is(document_.tokens[chunk(k).first], WordClass::kPurpose);
}

// "a lamp provides light next to the table": where the thing is, after what its verb says of the room.
bool UnitReader::place_after_purpose(std::size_t k) const {
  const std::size_t n = next(k);
  const std::size_t p = previous(k);
  const bool place = is(n, ChunkKind::kNoun) && (chunk(n).noun.kind == NounKind::kObject || chunk(n).noun.kind == NounKind::kWindow ||
                                                 chunk(n).noun.kind == NounKind::kDoor || chunk(n).noun.kind == NounKind::kCorner);
  if (!place || chunk(n).noun.determiner != Determiner::kDefinite) return false;
  const bool light =
      is(p, ChunkKind::kNoun) && chunk(p).noun.determiner == Determiner::kDefinite && one_of(chunk(p).noun.head, WordSet::kFromOutside);
  if (!light && (!is(p, ChunkKind::kNoun) || chunk(p).noun.kind != NounKind::kAbstract)) return false;
  if (chunk(p).noun.determiner == Determiner::kIndefinite && !is_zone(chunk(p).noun.head))
    return false;  // "forms a sitting area on the rug"
  for (std::size_t c = k; c-- > 0 && !is(c, ChunkKind::kComma) && !is(c, ChunkKind::kStop);) {
    if (is(c, ChunkKind::kPurpose)) return is_finite(document_.tokens[chunk(c).first].text);
  }
  return false;
}

// "a recliner for my partner facing the TV", "a box for toys at the foot of the bed": for whom or what it is, and where it is.
bool UnitReader::follows_whom(std::size_t k) const {
  const std::size_t p = previous(k), n = next(k), host = last_noun();
  // "an armchair for me beside the bookcase"
  const bool for_us = is(p, ChunkKind::kPurpose) && document_.tokens[chunk(p).first].text == "for" && chunk(k).first > chunk(p).last &&
                      one_of(document_.tokens[chunk(k).first - 1].text, {"me", "us", "myself", "ourselves"});
  if (for_us && is(n, ChunkKind::kNoun)) return is_part_of_room(chunk(n).noun) || names_thing(n);
  if (!is(p, ChunkKind::kNoun) || !is(previous(p), ChunkKind::kPurpose) || !is(n, ChunkKind::kNoun)) return false;
  const std::string& word = document_.tokens[chunk(previous(p)).last - 1].text;
  const NounPhrase &whom = chunk(p).noun, &by = chunk(n).noun;
  // "a lamp shaped like a mushroom on a table": where the lamp is
  if (word == "like" && host < document_.chunks.size() && names_thing(host) && names_thing(n)) return true;
  if (word != "for") return false;
  const bool part_of_room =
      by.kind == NounKind::kWall || by.kind == NounKind::kWindow || by.kind == NounKind::kDoor || by.kind == NounKind::kCorner;
  if (lexicon_.is_person(whom.head) || word_form(whom.head) == WordForm::kPerson) return part_of_room || by.kind == NounKind::kObject;
  // "a rack for 12 coats by the door"
  if (host >= document_.chunks.size() || chunk(host).noun.kind != NounKind::kObject || whom.determiner == Determiner::kIndefinite ||
      (whom.count > 0 && !part_of_room))
    return false;
  const NounPhrase& known = by.kind == NounKind::kPart && by.of ? *by.of : by;
  const bool definite = known.determiner == Determiner::kDefinite || known.determiner == Determiner::kPossessive;
  const bool new_here = known.determiner == Determiner::kIndefinite && known.exact;  // "a shelf for glazes above a bench"
  return part_of_room || (known.kind == NounKind::kObject && (definite || new_here));
}

// "a sink for washing hair in the back, …": a part of the room that ends what a thing is for is where the thing stands.
bool UnitReader::closes_purpose(std::size_t k) const {
  const bool named =
      is(next(k), ChunkKind::kNoun) && (chunk(next(k)).noun.kind == NounKind::kCenter || !chunk(next(k)).noun.wall_word.empty());
  const std::size_t n = named ? next(next(k)) : next(k);
  const bool ends = n >= document_.chunks.size() || is(n, ChunkKind::kComma) || is(n, ChunkKind::kStop) || is(n, ChunkKind::kAnd);
  const PhraseSenses* senses = chunk(k).phrase.senses;
  const bool part = senses != nullptr && std::ranges::any_of(*senses, [](const PhraseSense& s) {
                      const bool there =
                          s.type == RelationType::kInRegion || s.type == RelationType::kCenterOfRoom || traits_of(s.type).sideways;
                      return s.direction == PhraseSense::Direction::kAlone && there;
                    });
  if (!ends || !(part || named)) return false;
  for (std::size_t c = previous(k); c < k && !is(c, ChunkKind::kComma) && !is(c, ChunkKind::kStop); c = previous(c)) {
    if (is(c, ChunkKind::kPurpose) && document_.tokens[chunk(c).first].text == "for") return is(previous(c), ChunkKind::kNoun);
    if (c == 0) break;
  }
  return false;
}

// "For the family a recliner by the window": after whom or what it is for, at the beginning of a clause.
bool UnitReader::follows_purpose(std::size_t k) const {
  const std::size_t whom = previous(k), purpose = is(whom, ChunkKind::kNoun) ? previous(whom) : whom, before = previous(purpose);
  if (!is(purpose, ChunkKind::kPurpose) || chunk(purpose).last == chunk(k).first || document_.tokens[chunk(purpose).first].text != "for")
    return false;
  const NounPhrase& noun = chunk(k).noun;
  const bool anew = noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || noun.count > 0;
  const bool opens = before >= document_.chunks.size() || is(before, ChunkKind::kStop) || is(before, ChunkKind::kComma) ||
                     is(before, ChunkKind::kAnd) || is(before, ChunkKind::kClause);
  return opens && anew && noun.kind == NounKind::kObject;
}

// "Plants I do not want": none of what was named before.
bool UnitReader::denies_before(std::size_t k) {
  if (units_.size() != 1 || units_.back().kind != UnitKind::kNoun || !(is(k + 1, ChunkKind::kStop) || is(k + 1, ChunkKind::kComma)))
    return false;
  const std::size_t n = units_.back().chunk;
  if (chunk(n).noun.kind != NounKind::kObject || chunk(n).noun.determiner != Determiner::kNone || chunk(n).noun.count > 0) return false;
  document_.excluded.push_back(chunk(n).noun);
  mark(n, Use::kUsed, "not wanted");
  units_.clear();
  return true;
}

// The clause's first thing, or its last one, has neither article nor number.
bool UnitReader::is_bare_list() const {
  const auto is_thing = [&](const Unit& unit) { return unit.kind == UnitKind::kNoun && chunk(unit.chunk).noun.kind == NounKind::kObject; };
  const auto is_bare = [&](const Unit& unit) {
    return chunk(unit.chunk).noun.determiner == Determiner::kNone && chunk(unit.chunk).noun.count == 0;
  };
  const auto first = std::find_if(units_.begin(), units_.end(), is_thing);
  const auto last = std::find_if(units_.rbegin(), units_.rend(), is_thing);
  return first != units_.end() && (is_bare(*first) || (is_bare(*last) && !chunk(last->chunk).noun.plural));
}

// The purpose that chunk k is in has named something that stands on the floor.
bool UnitReader::names_furniture_before(std::size_t k) const {
  while (k-- > 0 && !is(k, ChunkKind::kPurpose) && !is(k, ChunkKind::kStop)) {
    if (is(k, ChunkKind::kNoun) && chunk(k).noun.exact && mount_of(chunk(k).noun) == Mount::kFloor) return true;
  }
  return false;
}

// … where what follows is no noun.
bool UnitReader::purpose_ends_before_verb(bool comma, std::size_t n) const {
  if (comma && is(n, ChunkKind::kRelative) && document_.tokens[chunk(n).first].text == "who") return false;  // "for my aunt, who has a dog"
  if (!comma && is(n, ChunkKind::kRelation) && chunk(n).last - chunk(n).first > 1) return true;  // "… and at the right one for the guitar"
  if (!comma && doing_ && is(n, ChunkKind::kVerb)) return false;                                 // "guests come in and hang up their coats"
  // "it serves as a stand and carries a lamp"
  if (!comma && !doing_ && (is(n, ChunkKind::kRelation) || is(n, ChunkKind::kHave)) && is_finite(document_.tokens[chunk(n).first].text))
    return true;
  if (!comma) return is(n, ChunkKind::kVerb) || is(n, ChunkKind::kThere) || is(n, ChunkKind::kCommand);
  return is(n, ChunkKind::kRelation) || is(n, ChunkKind::kHave) || is(n, ChunkKind::kParticiple) || is(n, ChunkKind::kRelative) ||
         is(n, ChunkKind::kThere) || is(n, ChunkKind::kVerb);
}

// The break at chunk k, before chunk n, ends a purpose: what follows is said of the room again.
bool UnitReader::purpose_ends(std::size_t k, std::size_t n) const {
  const bool comma = is(k, ChunkKind::kComma);
  if (!is(n, ChunkKind::kNoun)) return purpose_ends_before_verb(comma, n);
  const NounPhrase& noun = chunk(n).noun;
  const bool verb_follows = is(next(n), ChunkKind::kVerb);
  const bool said = noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother ||
                    noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach || noun.count > 0;
  if ((said && noun.kind != NounKind::kAbstract) || verb_follows) return true;
  // "for keys and mirror over it"
  const bool thing = noun.kind == NounKind::kObject && noun.entry != nullptr && !noun.doubted;
  if (thing && (noun.exact || comma) && is(next(n), ChunkKind::kRelation)) return true;
  if (!comma) return false;
  // "a hall for a game, entrance south"
  if (is_opening(noun)) return true;
  // "a kitchen for my mum, red tiles"
  if ((noun.kind == NounKind::kWall || noun.kind == NounKind::kFloor) && !noun.attributes.empty()) return true;
  // "…, hooks for coats", "…, shelves with files": what has a purpose or things of its own
  const bool own =
      is(next(n), ChunkKind::kHave) || (is(next(n), ChunkKind::kPurpose) && document_.tokens[chunk(next(n)).first].text == "for");
  if (own && noun.kind == NounKind::kObject && noun.exact) return true;
  if (noun.determiner == Determiner::kDefinite || noun.kind == NounKind::kMember) return true;
  // In a list without articles the next bare thing goes on with it: "bed for guests, desk, lamp".
  if (is_bare_list() && thing) return true;
  // "for 24 children, tables in groups of four": furniture, after a purpose that names none
  if (thing && noun.exact && mount_of(noun) == Mount::kFloor && !names_furniture_before(k)) return true;
  // "to be used as an office: sofa bed, desk, …"
  // "a shed for garden stuff - long bench, tool rack"
  const Token& sign = document_.tokens[chunk(k).first];
  const bool dash = sign.begin < document_.prompt.size() && document_.prompt[sign.begin] != ',' && document_.prompt[sign.begin] != '(';
  return (sign.text == ":" || (sign.text == "," && dash)) && (noun.kind == NounKind::kObject || noun.kind == NounKind::kAbstract);
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
  const bool persons = noun.kind == NounKind::kMember || lexicon_.is_person(noun.head);
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

// "nothing else, except a lamp", "no chairs except one": it is there.
bool UnitReader::excepts_from_nothing(std::size_t k) const {
  const std::string& word = document_.tokens[chunk(k).first].text;
  if (word != "except" && word != "excepting") return false;
  for (std::size_t i = chunk(k).first; i-- > 0 && !document_.tokens[i].ends_sentence;) {
    const std::string& before = document_.tokens[i].text;
    if (before == "nothing" || before == "no" || before == "empty" || before == "without" || before == "nobody") return true;
  }
  return false;
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
