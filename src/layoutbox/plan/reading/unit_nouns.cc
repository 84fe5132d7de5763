// Noun phrases of a sentence: what is a part, a room, an opening; which wall or corner is meant where the words leave it out.
#include <algorithm>

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
    if (noun.entry == nullptr && (noun.determiner == Determiner::kEach || noun.determiner == Determiner::kDefinite)) noun.name = noun.head;
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

// What brings nothing in, and says nothing of where something is.
bool UnitReader::is_told_by_the_way(std::size_t k) {
  if (opens_command(k) || says_nothing_but_there(k) || says_where_room_is(k) || says_room_seats(k)) return true;
  if (counts_before(k)) return true;
  if (is_addressed(k)) {
    mark(k, Use::kIgnored, "opens a statement");
    return true;
  }
  if (is_said_of_subject(k) || announces_things(k) || is_address(k) || is_one_of_rooms(k)) {
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
    if (noun.kind == NounKind::kObject || noun.kind == NounKind::kWindow || denies_doors(k) || one_of(noun.head, WordSet::kAllFurniture))
      document_.excluded.push_back(noun);
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
