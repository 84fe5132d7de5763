// Noun phrases of a sentence: what is a part, a room, an opening; which wall or corner is meant where the words leave it out.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/english.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/word_sets.h"
#include "layoutbox/plan/reading/unit_reader.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

std::size_t UnitReader::last_noun() const {
  for (std::size_t u = units_.size(); u-- > 0;) {
    if (units_[u].kind == UnitKind::kNoun) return units_[u].chunk;
  }
  return document_.chunks.size();
}

// Whom a verb at the next chunk speaks of: of "a rack next to the door takes …" the rack. Past the end if there is none.
std::size_t UnitReader::subject_before() const {
  std::size_t u = units_.size();
  while (u > 0 && (units_[u - 1].kind == UnitKind::kNoun || units_[u - 1].kind == UnitKind::kPlace)) {
    --u;
    const bool reference = u > 0 && units_[u - 1].kind == UnitKind::kPlace && units_[u].joiner == Joiner::kNone;
    if (units_[u].kind == UnitKind::kNoun && !reference) return units_[u].chunk;
  }
  return last_noun();
}

// What comes next is something that a thing has, not the room: right after "with", or in a list that began so.
bool UnitReader::is_content_of_thing() const {
  for (std::size_t u = units_.size(); u-- > 0;) {
    const Unit& unit = units_[u];
    const bool opens = unit.kind == UnitKind::kHave || (unit.kind == UnitKind::kPlace && unit.direct.empty() && !unit.inverse.empty());
    if (opens) {
      if (u + 1 < units_.size() && joiner_ == Joiner::kNone) return false;
      for (std::size_t h = u; h-- > 0;) {
        if (units_[h].kind == UnitKind::kNoun) return chunk(units_[h].chunk).noun.kind == NounKind::kObject;
      }
      return false;
    }
    if (unit.kind != UnitKind::kNoun || unit.clause) return false;
  }
  return false;
}

// "a mirror with a gilded frame", "a photo in a frame": the thing's own.
bool UnitReader::is_own_frame(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  if (noun.name != "frame" || noun.determiner == Determiner::kDefinite || noun.count > 0 || units_.size() < 2 || joiner_ != Joiner::kNone)
    return false;
  const Unit &with = units_.back(), &host = units_[units_.size() - 2];
  if (host.kind != UnitKind::kNoun || chunk(host.chunk).noun.kind != NounKind::kObject) return false;
  if (with.kind == UnitKind::kPlace) return says(with.direct, RelationType::kIn) && mount_of(chunk(host.chunk).noun) != Mount::kFloor;
  const bool placed = is(next(k), ChunkKind::kRelation) && !is(next(next(k)), ChunkKind::kNoun);  // "with a frame on top"
  const bool on_it = is(next(k), ChunkKind::kRelation) && !placed && chunk(next(next(k))).noun.kind == NounKind::kPronoun;
  return with.kind == UnitKind::kHave && !noun.attributes.empty() && !placed && !on_it;
}

// "a restaurant with 20 seats": for how many it is; its tables bring the chairs.
bool UnitReader::says_room_seats(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  if (noun.count < 2 || !noun.attributes.empty() || noun.category.find(noun.head) != 0 || !one_of(noun.head, {"seat", "cover", "place"}))
    return false;
  // "a sofa (3 seats)": how long it is
  const bool own = !units_.empty() && units_.back().kind == UnitKind::kNoun && previous(previous(k)) == units_.back().chunk &&
                   one_of(chunk(units_.back().chunk).noun.head, WordSet::kSeatsForSeveral) && k > 0 && is(k - 1, ChunkKind::kComma) &&
                   document_.tokens[chunk(k - 1).first].text != ",";
  if (own) {
    mark(k, Use::kUsed, "size");
    return true;
  }
  const bool listed = units_.size() == 1 && joiner_ == Joiner::kComma;  // "Restaurant, 40 seats, …"
  if (!listed && (units_.size() != 2 || units_.back().kind != UnitKind::kHave)) return false;
  if (units_.front().kind != UnitKind::kNoun) return false;
  const NounPhrase& room = chunk(units_.front().chunk).noun;
  const Lexicon::Set* needs = room.kind == NounKind::kRoom && room.room != nullptr ? lexicon_.needs_in(room.room->id) : nullptr;
  if (needs == nullptr || needs->size() < 2 || !needs->front().first->is(Trait::kTable) || is(next(k), ChunkKind::kRelation)) return false;
  document_.people = noun.count;
  mark(k, Use::kUsed, "for how many");
  if (!listed) leave_out_part(k, is(next(k), ChunkKind::kAnd) || is(next(k), ChunkKind::kComma));
  return true;
}

// The noun at k is no thing of its own; what had it has what is listed next, if the list goes on.
void UnitReader::leave_out_part(std::size_t k, bool goes_on) {
  if (goes_on && units_.back().kind == UnitKind::kHave) {
    passed_over_ = next(k);
    return;
  }
  joiner_ = units_.back().joiner;
  clause_ = units_.back().clause;
  units_.pop_back();
  // "a bunk with drawers beneath": where the part is
  const std::size_t place = next(k);
  const bool alone = is(place, ChunkKind::kRelation) && !is(next(place), ChunkKind::kNoun) && chunk(k).noun.kind == NounKind::kPart;
  if (!alone || chunk(place).phrase.senses == nullptr) return;
  if (!says(*chunk(place).phrase.senses, RelationType::kUnder) && !says(*chunk(place).phrase.senses, RelationType::kAbove)) return;
  mark(place, Use::kUsed, "part");
  passed_over_ = place;
}

bool UnitReader::is_part(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  if (is_own_frame(k)) return true;
  if (units_.empty() || units_.back().kind != UnitKind::kHave || joiner_ != Joiner::kNone || !is_content_of_thing()) return false;
  if (is_opening(noun)) return true;
  // "a changing table with drawers, a rocking chair": the chair is another thing of the list.
  if (noun.kind == NounKind::kPart && !noun.as_object && !noun.of && is(next(k), ChunkKind::kComma)) return true;
  const bool built_in = std::find(noun.attributes.begin(), noun.attributes.end(), "built-in") != noun.attributes.end();
  if (noun.kind == NounKind::kObject && built_in) return true;
  if (noun.kind != NounKind::kObject || noun.head != "mattress") return false;
  const std::size_t host = last_noun();
  return host < document_.chunks.size() && chunk(host).noun.name.find("bed") != std::string::npos;
}

// "a bench along the left", "a teepee in the other", "the desk against the right one".
void UnitReader::settle_place_words(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  const bool placed = after_place();
  const PhraseSenses none;
  const PhraseSenses& senses = placed ? units_.back().direct : none;
  const auto take = [&](const NounPhrase& from) {
    const NounPhrase said = noun;
    noun = from;
    noun.first = said.first;
    noun.last = said.last;
    return said;
  };
  const bool side = noun.kind == NounKind::kPart && (noun.head == "left" || noun.head == "right");
  // "a counter along the left side": of the room, where nothing else was named.
  const bool of_room = (noun.kind == NounKind::kPart || noun.kind == NounKind::kAbstract) && noun.head == "side" &&
                       !noun.wall_word.empty() && units_.size() == 2;
  if (of_room && says(senses, RelationType::kAgainstWall) && !noun.of) noun.kind = NounKind::kWall;
  if (side && says(senses, RelationType::kAgainstWall) && !noun.of && !noun.plural && noun.determiner != Determiner::kPossessive) {
    const bool both = noun.wall_word == "back" || noun.wall_word == "front";  // "at the back right"
    noun.kind = both ? NounKind::kCorner : NounKind::kWall;
    noun.wall_word = both ? noun.wall_word + " " + noun.head : noun.head;
    if (both) {
      units_.back().direct = direct_senses<RelationType::kCorner>();
      units_.back().senses = &direct_senses<RelationType::kCorner>();
    }
  }
  const bool opposite = std::find(noun.attributes.begin(), noun.attributes.end(), "opposite") != noun.attributes.end();
  const bool other = noun.kind == NounKind::kMember && !noun.of &&
                     (noun.determiner == Determiner::kOther || noun.determiner == Determiner::kAnother || noun.ordinal != 0 || opposite ||
                      !noun.wall_relation.empty());
  if (other && one_corner_ >= 0 && (says(senses, RelationType::kIn) || says(senses, RelationType::kCorner))) {
    take(chunk(static_cast<std::size_t>(one_corner_)).noun);
    noun.count = 1;
    noun.plural = false;
  }
  if (noun.kind == NounKind::kMember && !noun.wall_word.empty() && wall_ >= 0 && says(senses, RelationType::kAgainstWall)) {
    const NounPhrase said = take(chunk(static_cast<std::size_t>(wall_)).noun);
    noun.wall_word = said.wall_word;
  }
  // "along one wall a bed, along the other a desk"
  const bool across = opposite || noun.wall_relation == "opposite";  // "along the opposite one"
  if (other && (across || noun.determiner == Determiner::kOther) && wall_ >= 0 && says(senses, RelationType::kAgainstWall) &&
      chunk(static_cast<std::size_t>(wall_)).noun.count == 1) {
    take(chunk(static_cast<std::size_t>(wall_)).noun);
    if (across) noun.wall_relation = "opposite";
  }
  if (placed && noun.kind == NounKind::kCorner && noun.count > 0) one_corner_ = static_cast<int>(k);
  if (noun.kind == NounKind::kWall) wall_ = static_cast<int>(k);
}

// "a table with six swivel seats around it": no part of the table.
bool UnitReader::is_placed_itself(std::size_t k) const {
  const std::size_t r = next(k);
  if (is(r, ChunkKind::kRelation) && !is(next(r), ChunkKind::kNoun) && chunk(r).last - chunk(r).first > 2)
    return document_.tokens[chunk(r).last - 1].text.starts_with("end");  // "sinks at the ends"
  if (!is(r, ChunkKind::kRelation) || !is(next(r), ChunkKind::kNoun)) return false;
  const PhraseSenses& senses = *chunk(r).phrase.senses;
  const bool on_it = says(senses, RelationType::kOn) && chunk(next(r)).noun.kind == NounKind::kPronoun;  // "five prints clipped to it"
  const bool at_end = chunk(next(r)).noun.kind == NounKind::kPart && one_of(chunk(next(r)).noun.head, {"end", "side"});
  return on_it || at_end || says(senses, RelationType::kAround) || says(senses, RelationType::kNextTo) ||
         says(senses, RelationType::kInFrontOf) || says(senses, RelationType::kFacing);
}

// "two counters with sinks": let into their tops; a vanity has its own.
bool UnitReader::is_let_in(const NounPhrase& object) const {
  const Catalog& catalog = lexicon_.catalog();
  const std::size_t host = last_noun();
  const CatalogEntry* form = object.entry == nullptr ? nullptr : kind_at(catalog, object.entry->id, Place::kSetIn);
  if (form == nullptr || host >= document_.chunks.size() || chunk(host).noun.entry == nullptr) return false;
  return std::ranges::any_of(form->stands_on, [&](const std::string& id) { return catalog.is_a(chunk(host).noun.entry->id, id); });
}

// "a table with four seats": they are no part of it.
bool UnitReader::is_at_table(const NounPhrase& object) const {
  const std::size_t host = last_noun();
  return object.count > 1 && is_seat(lexicon_.catalog(), object) && host < document_.chunks.size() &&
         is_table(lexicon_.catalog(), chunk(host).noun);
}

// "five tables, four stools to a table": to every one of those.
void UnitReader::shares_out(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  if (!after_place() || units_.size() < 3 || noun.kind != NounKind::kObject || noun.determiner != Determiner::kIndefinite) return;
  Unit& place = units_.back();
  const Unit& shared = units_[units_.size() - 2];
  const bool to = chunk(place.chunk).last - chunk(place.chunk).first == 1 && document_.tokens[chunk(place.chunk).first].text == "to";
  if (!to || shared.kind != UnitKind::kNoun || chunk(shared.chunk).noun.count == 0) return;
  const bool named = std::any_of(units_.begin(), units_.end() - 2, [&](const Unit& unit) {
    return unit.kind == UnitKind::kNoun && chunk(unit.chunk).noun.is_plural() && chunk(unit.chunk).noun.head == noun.head;
  });
  if (!named) return;
  noun.determiner = Determiner::kEach;
  place.senses = &direct_senses<RelationType::kNextTo>();
  place.direct = direct_senses<RelationType::kNextTo>();
  place.inverse.clear();
}

void UnitReader::settle_noun(std::size_t k) {
  shares_out(k);
  NounPhrase& noun = document_.chunks[k].noun;
  const bool content = is_content_of_thing();
  // A part that has a thing's name is one where no host is there: "two sinks".
  if (const auto object = noun.as_object;
      object != nullptr &&
      (content ? is_placed_itself(k) || is_let_in(*object) || is_at_table(*object) ||
                     (object->entry == nullptr && object->name.find(' ') != std::string::npos && stands_among_things(k))
               : !after_place() || noun.determiner == Determiner::kIndefinite || is_named_before(k, object->head)))
    noun = NounPhrase(*object);
  // "a dining set by the window": what is said of the set is said of what it is about.
  if (const Lexicon::Set* set =
          noun.kind == NounKind::kObject || noun.kind == NounKind::kAbstract ? lexicon_.set_called(noun.name) : nullptr) {
    noun.kind = NounKind::kObject;
    noun.entry = set->front().first;
  }
  if (names_known(k) || is_thing_in_company(k)) {
    noun.kind = NounKind::kObject;
    if (noun.entry == nullptr && noun.determiner == Determiner::kEach) noun.name = noun.head;
  }
  // "above either sink"
  if (noun.determiner == Determiner::kBoth && !noun.plural && noun.count == 0 && document_.tokens[noun.first].text == "either" &&
      noun.kind == NounKind::kObject)
    noun.determiner = Determiner::kEach;
  if (noun.name == "thing" && noun.determiner == Determiner::kDefinite && !noun.plural) noun.kind = NounKind::kAbstract;
  if (is_figure(k)) {
    noun.kind = NounKind::kObject;
    if (noun.entry == nullptr) noun.entry = lexicon_.catalog().find("figurine");
  }
  if (is_within_room(k)) noun.of->kind = NounKind::kRoom;
  if (noun.kind == NounKind::kRoom && noun.of && noun.of->kind == NounKind::kObject) noun.of.reset();  // "the lobby of a seaside hotel"
  if (takes_new_share(k)) {
    const NounPhrase share = noun;
    noun = NounPhrase(*share.of);
    noun.determiner = Determiner::kNone;
    noun.count = share.count;
    noun.at_least = share.at_least;
    noun.first = share.first;
    noun.last = share.last;
  }
  if (speaks_again(k)) noun.determiner = Determiner::kDefinite;
  if (named_ || skipping_ || negated_) return;
  // "Notes for chapter three: the bridge of the freighter": a heading says nothing yet
  if (is_title(k)) noun.kind = NounKind::kRoom;
  named_ = noun.kind != NounKind::kAbstract;
  // "A craft brewery taproom has a bar": what nobody knows and has things, at the very beginning, is the room.
  const bool has = is(next(k), ChunkKind::kHave);
  // "I want a two-bed recovery bay."
  const bool alone = noun.determiner == Determiner::kIndefinite && is(k + 1, ChunkKind::kStop);
  if (noun.kind == NounKind::kObject && noun.entry == nullptr && !noun.is_plural() && (has || alone)) noun.kind = NounKind::kRoom;
  // "A reading corner with an armchair": so is the corner that it is all about.
  const bool zone = noun.wall_word.empty() && noun.determiner != Determiner::kEach && noun.count == 0;
  if (noun.kind == NounKind::kCorner && zone && !after_place() && has) noun.kind = NounKind::kRoom;
}

// "On the left wall it is a desk": as "there is".
bool UnitReader::says_nothing_but_there(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t verb = next(k), thing = next(verb);
  if (noun.kind != NounKind::kPronoun || noun.head != "it" || joiner_ != Joiner::kNone || units_.size() < 2) return false;
  if (units_.front().kind != UnitKind::kPlace || units_.back().kind != UnitKind::kNoun || units_.size() > 2) return false;
  if (!is(verb, ChunkKind::kVerb) || chunk(verb).last - chunk(verb).first != 1 || !is(thing, ChunkKind::kNoun)) return false;
  const std::string& be = document_.tokens[chunk(verb).first].text;
  if ((be != "is" && be != "are") || chunk(thing).noun.kind != NounKind::kObject) return false;
  mark(k, Use::kIgnored, "opens a statement");
  mark(verb, Use::kIgnored, "opens a statement");
  add(UnitKind::kOpen, k);
  passed_over_ = verb;
  return true;
}

// "a desk from my old office", "what used to be a garage": not this room.
bool UnitReader::is_past(const NounPhrase& noun) const {
  const auto before = [&](std::size_t back, std::string_view word) {
    return noun.first >= back && document_.tokens[noun.first - back].text == word;
  };
  return before(1, "from") || (before(1, "be") && before(2, "to") && before(3, "used"));
}

// "A study in an old tower", "on the third floor of a bank": what the room is in or on is no thing in it.
bool UnitReader::says_where_room_is(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  if (units_.size() != 2 || !after_place() || units_.front().kind != UnitKind::kNoun) return false;
  if (chunk(units_.front().chunk).noun.kind != NounKind::kRoom || units_.front().chunk + 2 != k) return false;
  const NounPhrase& whole = noun.kind != NounKind::kObject && noun.of ? *noun.of : noun;
  const PhraseSenses& where = units_.back().direct;
  const bool in = says(where, &RelationTraits::rests) || says(where, RelationType::kAbove) || says(where, RelationType::kUnder);
  if (!in || whole.kind != NounKind::kObject || whole.determiner != Determiner::kIndefinite || whole.count > 0) return false;
  mark(k, Use::kIgnored, "where the room is");
  mark(units_.back().chunk, Use::kIgnored, "where the room is");
  units_.pop_back();
  return true;
}

// "king bed north wall", "- desk: left wall": against it.
void UnitReader::place_at_named_wall(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t after = next(k);
  const bool ends = after >= document_.chunks.size() || is(after, ChunkKind::kStop) || is(after, ChunkKind::kComma) ||
                    (is(after, ChunkKind::kRelation) && is(previous(k), ChunkKind::kComma) &&
                     document_.tokens[chunk(previous(k)).first].text == ":");  // "Plant: corner by window"
  const bool listed = ends && joiner_ == Joiner::kComma && noun.determiner == Determiner::kNone && is(previous(k), ChunkKind::kComma);
  const std::size_t before = listed ? previous(previous(k)) : previous(k);
  const bool center = noun.kind == NounKind::kCenter;
  const bool corner = listed && (center || noun.kind == NounKind::kCorner) && !noun.is_plural();  // "lamp - corner", "table (middle)"
  if ((noun.kind == NounKind::kWall || noun.kind == NounKind::kCorner || center) && (!noun.wall_word.empty() || corner) &&
      (joiner_ == Joiner::kNone || listed) && is(before, ChunkKind::kNoun) && chunk(before).noun.kind == NounKind::kObject &&
      !units_.empty() && units_.back().chunk == before)
    add_place(k, direct_senses<RelationType::kAgainstWall, RelationType::kCenterOfRoom>());
}

// What brings nothing in, and says nothing of where something is.
bool UnitReader::is_told_by_the_way(std::size_t k) {
  if (opens_command(k) || says_nothing_but_there(k) || says_where_room_is(k) || says_room_seats(k)) return true;
  if (counts_before(k)) return true;
  if (is_addressed(k)) {
    mark(k, Use::kIgnored, "opens a statement");
    return true;
  }
  if (is_said_of_subject(k) || announces_things(k) || is_address(k)) {
    mark(k, Use::kIgnored, "no object");
    return true;
  }
  if (is_done_here(k)) {
    passed_until_ = clause_end(k);
    for (std::size_t c = k; c < passed_until_; ++c) mark(c, Use::kIgnored, "told by the way");
    return true;
  }
  return false;
}

void UnitReader::read_noun(std::size_t k) {
  if (stresses(k)) return;
  mean_desktop(k);
  settle_noun(k);
  if (shares_by_subject(k) || opens_topic(k)) return;
  settle_place_words(k);
  if (!negated_ && (passes_spot(k) || passes_patch(k))) return;
  if (!skipping_ && !negated_ && repeats_place(k)) return;
  repeat_owner(k);
  mean_group(k);
  mean_twin(k);
  mean_side_of_room(k);
  mean_end_of_room(k);
  mean_fabric(k);
  mean_fire(k);
  mean_thing_of_zone(k);
  place_at_spot(k);
  place_by_verb(k);
  if (!skipping_ && !negated_ && passes_light_noun(k)) return;
  NounPhrase& noun = document_.chunks[k].noun;
  if (skipping_ && ((doing_ && is_used_in_place(k)) || follows_purpose(k))) skipping_ = false;
  if (sums_up(k) && counts_before(k)) {
    skipping_ = false;
    return;
  }
  if (skipping_) {
    if (noun.kind == NounKind::kObject && noun.determiner == Determiner::kDefinite && noun.count == 0) told_ = k;
    mark(k, Use::kIgnored, "purpose");
    if (noun.kind == NounKind::kRoom) name_room(noun);
    return;
  }
  take_told(k);
  if (is_told_by_the_way(k)) return;
  // "instead of a bathtub a shower": what stands beside what is not wanted.
  if (negated_ && k > 0 && is(previous(k), ChunkKind::kNoun) && noun.determiner == Determiner::kIndefinite) negated_ = false;
  if (negated_) {
    mark(k, Use::kUsed, "not wanted");
    if (noun.kind == NounKind::kObject || noun.kind == NounKind::kWindow || denies_doors(k)) document_.excluded.push_back(noun);
    return;
  }
  if (noun.kind == NounKind::kOutsideRoom) {
    mark(k, Use::kIgnored, "another room");
    document_.notes.push_back(
        {"ignored",
         "\"" + words_between(document_, chunk(k).first, chunk(k).last) + "\" is another room: what is said to be in it goes into this one",
         "prompt:" + std::to_string(document_.tokens[chunk(k).first].begin) + "-" +
             std::to_string(document_.tokens[chunk(k).last - 1].end)});
  }
  if (noun.kind == NounKind::kRoom && (!after_place() || noun.room != nullptr)) name_room(noun);
  if (is_part(k)) {
    mark(k, Use::kUsed, "part");
    leave_out_part(k, is(next(k), ChunkKind::kAnd));  // "with a soft mattress and two pillows": the having goes on
    return;
  }
  if (is_opening(noun)) document_.openings.push_back(noun);
  place_at_named_wall(k);
  // "the desk's left corner" is the left corner of the desk.
  if (owner_ < document_.chunks.size() && !noun.of) {
    noun.of = std::make_shared<NounPhrase>(chunk(owner_).noun);
    noun.of->determiner = Determiner::kDefinite;
  }
  owner_ = document_.chunks.size();
  mean_owner_of_spot(k);
  mean_own_part(k);
  mean_hand_of_owner(k);
  if (noun.owner) {
    owner_ = k;
    mark(k, Use::kUsed, "owner");
    return;
  }
  has_its_own(k);
  add(UnitKind::kNoun, k);
  has_unsaid(k);
}

}  // namespace layoutbox::offline
