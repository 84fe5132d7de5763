// Where a place begins, and which senses its phrase can have there.
#include <algorithm>
#include <string>
#include <string_view>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/reading/units.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

void UnitReader::read_place(std::size_t k) {
  if (skipping_ && (place_after_purpose(k) || follows_whom(k) || closes_purpose(k) || ends_contact_clause(k))) skipping_ = false;
  if (skipping_ && does_it_there(k)) {
    mark(k, Use::kIgnored, "told by the way");
    skipping_ = false;
    add(UnitKind::kOpen, k);
    return;
  }
  if (skipping_) {
    mark(k, Use::kIgnored, "purpose");
    return;
  }
  // "a bench rather than chairs at the table": where the bench is
  const bool thing = !units_.empty() && units_.back().kind == UnitKind::kNoun && chunk(units_.back().chunk).noun.kind == NounKind::kObject;
  if (negated_ && instead_ && thing && joiner_ == Joiner::kNone && is(next(k), ChunkKind::kNoun)) negated_ = false;
  // "no chairs in the room": where they are not.
  if (negated_ && joiner_ == Joiner::kNone && is(previous(k), ChunkKind::kNoun) && is(next(k), ChunkKind::kNoun)) {
    mark(k, Use::kIgnored, "not wanted");
    mark(next(k), Use::kIgnored, "not wanted");
    if (chunk(next(k)).noun.kind == NounKind::kRoom) document_.rooms.push_back(chunk(next(k)).noun);
    passed_until_ = next(k) + 1;
    return;
  }
  if (names_doer(k)) return;
  // "separates the bath from the door": the second of the two.
  const bool parted = units_.size() > 1 && units_.back().kind == UnitKind::kNoun && units_[units_.size() - 2].kind == UnitKind::kPlace &&
                      says(units_[units_.size() - 2].direct, RelationType::kBetween);
  if (parted && joiner_ == Joiner::kNone && document_.tokens[chunk(k).first].text == "from" && chunk(k).last - chunk(k).first == 1) {
    mark(k, Use::kUsed, "relation");
    joiner_ = Joiner::kAnd;
    return;
  }
  mark(k, Use::kUsed, "relation");
  if (takes_order(k)) return;
  if (tells_which(k) || tells_of_pot(k)) return;
  const PhraseSenses* end = end_of_room(k);
  add_place(k, end != nullptr ? *end : *chunk(k).phrase.senses);
}

// "three lemon trees in clay pots", "a fern in its pot": plants are drawn in one.
bool UnitReader::tells_of_pot(std::size_t k) {
  const std::size_t n = next(k), plant = previous(k);
  if (document_.tokens[chunk(k).first].text != "in" || chunk(k).last - chunk(k).first != 1 || !names_thing(plant) ||
      !is(n, ChunkKind::kNoun))
    return false;
  const NounPhrase& pot = chunk(n).noun;
  if (!chunk(plant).noun.entry->is(Trait::kPlant) || !one_of(pot.head, {"pot", "flowerpot", "planter"}) ||
      pot.determiner == Determiner::kDefinite || pot.determiner == Determiner::kEach || pot.count > 1)
    return false;
  mark(k, Use::kIgnored, "attribute");
  mark(n, Use::kIgnored, "attribute");
  passed_until_ = n + 1;
  return true;
}

// "a counter that carries, from left to right, a scale and a till": said of the list, wherever it stands.
bool UnitReader::takes_order(std::size_t k) {
  const PhraseSenses& senses = *chunk(k).phrase.senses;
  const bool order = std::ranges::all_of(
      senses, [](const PhraseSense& s) { return s.type == RelationType::kRow && s.order != PhraseSense::Order::kNone; });
  if (!order) return false;
  const bool before_list = units_.empty() || units_.back().kind != UnitKind::kNoun;
  (units_.empty() ? order_ : units_.back().order) = k;
  in_brackets_ = before_list;
  if (before_list) joiner_ = Joiner::kNone;
  return true;
}

// "is used by the gripper", "was painted by my aunt": who does it is no place. "Warmed by a stove" brings the stove in.
bool UnitReader::names_doer(std::size_t k) {
  const std::size_t first = chunk(k).first, n = next(k);
  if (chunk(k).last - first != 1 || first == 0 || document_.tokens[first].text != "by" || is(k - 1, ChunkKind::kNoun)) return false;
  const Token& verb = document_.tokens[first - 1];
  const bool done =
      verb.text.ends_with("ed") || verb.text == "made" || verb.text == "drawn" || verb.text == "driven" || verb.text == "worn";
  if (!done || lexicon_.is(verb, WordClass::kParticiple) || lexicon_.is(verb, WordClass::kHang) || !is(n, ChunkKind::kNoun)) return false;
  if (chunk(n).noun.determiner == Determiner::kIndefinite || chunk(n).noun.count > 0 || is_part_of_room(chunk(n).noun)) return false;
  mark(k, Use::kIgnored, "who does it");
  mark(n, Use::kIgnored, "who does it");
  passed_until_ = n + 1;
  return true;
}

// "against the wall to the right": which wall. "on the shelf below": which shelf. Not where the thing is.
bool UnitReader::tells_which(std::size_t k) {
  if (units_.size() < 2 || units_.back().kind != UnitKind::kNoun || joiner_ != Joiner::kNone || is(next(k), ChunkKind::kNoun)) return false;
  NounPhrase& noun = document_.chunks[units_.back().chunk].noun;
  if (previous(k) != units_.back().chunk || units_[units_.size() - 2].kind != UnitKind::kPlace) return false;
  const PhraseSenses& senses = *chunk(k).phrase.senses;
  const bool left = says(senses, RelationType::kLeftOf);
  if (noun.kind == NounKind::kWall && (left || says(senses, RelationType::kRightOf))) {
    noun.wall_word = left ? "left" : "right";
    return true;
  }
  if (noun.kind == NounKind::kWall && says(senses, RelationType::kOpposite) && noun.wall_word.empty() && !noun.of) {
    noun.wall_relation = "opposite";
    return true;
  }
  // "in the two corners at the front"
  if (noun.kind == NounKind::kCorner && noun.wall_word.empty() && !noun.of) {
    const auto region = std::ranges::find(senses, RelationType::kInRegion, &PhraseSense::type);
    const std::string_view side = left ? "left" : says(senses, RelationType::kRightOf) ? "right" : "";
    if (side.empty() && region == senses.end()) return false;
    const bool front = region != senses.end() && region->region == RoomRegion::kFront;
    noun.wall_word = !side.empty() ? side : front ? "front" : "back";
    return true;
  }
  if (noun.kind != NounKind::kObject && noun.kind != NounKind::kPart) return false;  // "on the wall above": above what was spoken of
  const bool up_or_down = says(senses, RelationType::kUnder) || says(senses, RelationType::kAbove);
  return up_or_down && noun.determiner == Determiner::kDefinite && document_.tokens[chunk(k).last - 1].text != "it";
}

void UnitReader::add_place(std::size_t k, const PhraseSenses& senses) {
  Unit& unit = add(UnitKind::kPlace, k);
  unit.senses = &senses;
  unit.each = chunk(k).phrase.each;
  for (const PhraseSense& sense : senses) {
    // "on opposite sides of the stove": one on each.
    if (chunk(k).phrase.plural && sense.type == RelationType::kOpposite && says(senses, RelationType::kEachSideOf)) continue;
    // … "on the opposite side" is one of them
    if (!chunk(k).phrase.plural && sense.type == RelationType::kEachSideOf && sense.direction == PhraseSense::Direction::kAlone &&
        !chunk(k).phrase.each && says(senses, RelationType::kOpposite))
      continue;
    PhraseSenses& side = sense.direction == PhraseSense::Direction::kDirect    ? unit.direct
                         : sense.direction == PhraseSense::Direction::kInverse ? unit.inverse
                                                                               : unit.alone;
    side.push_back(sense);
    side.back().direction = PhraseSense::Direction::kDirect;
  }
  add_shorter_senses(k);
  choose_way(k);
  // "From a rail over the stove hang two pans": on it.
  if (document_.tokens[chunk(k).first].text != "from" || chunk(k).last - chunk(k).first != 1) return;
  for (std::size_t c = k + 1; c < document_.chunks.size() && !is(c, ChunkKind::kStop) && !is(c, ChunkKind::kClause); ++c) {
    if (!chunk(c).hang || !is(c, ChunkKind::kVerb)) continue;
    units_.back().direct.push_back({RelationType::kOn, PhraseSense::Direction::kDirect, {}, {}, {}});
    return;
  }
}

// "with its back to the wall": against it; "… to the bookcase": that is behind.
void UnitReader::choose_way(std::size_t k) {
  Unit& unit = units_.back();
  const std::size_t n = next(k);
  if (unit.direct.empty() || unit.inverse.empty() || !is(n, ChunkKind::kNoun)) return;
  const bool walls = std::ranges::all_of(unit.direct, [](const PhraseSense& sense) {
    return (relation_row(sense.type).reference_kinds & kObject) == 0 || sense.type == RelationType::kAgainstWall;
  });
  if (walls && says(unit.inverse, RelationType::kBehind) && chunk(n).noun.kind == NounKind::kObject) unit.direct.clear();
}

// "resting against the piano": what "against" says as well, where the longer words are listed for walls alone.
void UnitReader::add_shorter_senses(std::size_t k) {
  const Chunk& place = chunk(k);
  const bool by_it = !units_.back().direct.empty() && units_.back().inverse.empty();  // not "flanked by"
  if (place.last - place.first < 2 || place.phrase.senses == nullptr || place.distance || !by_it) return;
  const Token& verb = document_.tokens[place.first];
  const bool verbal = verb.text.ends_with("ing") || verb.text.ends_with("ed") || lexicon_.is(verb, WordClass::kParticiple) ||
                      lexicon_.is(verb, WordClass::kHang) || lexicon_.is(verb, WordClass::kPlaceVerb);
  if (!verbal) return;
  const std::span<const Token> tokens(document_.tokens);
  const PhraseMatch rest = lexicon_.find_phrase(tokens.first(place.last), place.first + 1);
  if (rest.length != place.last - place.first - 1) return;
  for (const PhraseSense& sense : *rest.senses) {
    if (sense.direction == PhraseSense::Direction::kDirect && !says(units_.back().direct, sense.type))
      units_.back().direct.push_back(sense);
  }
}

// "The desk stands centered": in the middle of the room, where no place follows that says of what.
bool UnitReader::centers_in_room(std::size_t k) {
  static const PhraseSenses kMiddle = {{RelationType::kCenterOfRoom, PhraseSense::Direction::kAlone, {}, {}, {}}};
  if (document_.tokens[chunk(k).last - 1].text != "centered" || units_.empty() || units_.back().kind == UnitKind::kPlace) return false;
  const std::size_t n = next(k);
  if (is(n, ChunkKind::kRelation) || is(n, ChunkKind::kNoun) || is(n, ChunkKind::kParticiple) || is(n, ChunkKind::kVerb)) return false;
  add_place(k, kMiddle);
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

}  // namespace layoutbox::offline
