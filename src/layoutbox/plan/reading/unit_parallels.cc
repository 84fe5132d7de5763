// What a text says once and means twice: "on one wall …, on the other …", "its twin", "the pair".
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

// "the other", "another", "the second": without saying of what.
bool is_other_one(const NounPhrase& noun) {
  return noun.kind == NounKind::kMember && !noun.of && !noun.subset && noun.attributes.empty() && noun.count <= 1 &&
         (noun.determiner == Determiner::kOther || noun.determiner == Determiner::kAnother || noun.ordinal > 1);
}

// Of the room's ends and sides.
RoomRegion across_from(RoomRegion region) {
  switch (region) {
    case RoomRegion::kLeft: return RoomRegion::kRight;
    case RoomRegion::kRight: return RoomRegion::kLeft;
    case RoomRegion::kFront: return RoomRegion::kBack;
    case RoomRegion::kBack: return RoomRegion::kFront;
    default: return region;
  }
}

bool is_one_of_its_kind(const NounPhrase& noun) {
  const bool place = noun.kind == NounKind::kWall || noun.kind == NounKind::kCorner || noun.kind == NounKind::kPart;
  return place && (noun.count == 1 || noun.ordinal == 1) && noun.wall_word.empty();
}

}  // namespace

// "On one wall two masks, on the other a banner"; "at one end of the bar a till, at the other a fridge": the same place once more, after
// the same preposition.
bool UnitReader::repeats_place(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  // "two baskets stacked one on top of the other"
  if (after_place() && is_other_one(noun) && chunk(units_.back().chunk).phrase.one && says(units_.back().direct, RelationType::kStacked)) {
    noun.kind = NounKind::kPronoun;
    noun.head = "other";
    noun.reciprocal = true;
    return false;
  }
  if (!after_place() || !is_other_one(noun) || chunk(units_.back().chunk).last - chunk(units_.back().chunk).first != 1) return false;
  const std::string& preposition = document_.tokens[chunk(units_.back().chunk).first].text;
  for (std::size_t u = units_.size() - 1; u-- > 0;) {
    const Unit& before = units_[u];
    if (before.kind != UnitKind::kPlace) continue;
    const bool noun_follows = units_[u + 1].kind == UnitKind::kNoun && units_[u + 1].joiner == Joiner::kNone && u + 2 < units_.size();
    const NounPhrase place = noun_follows ? chunk(units_[u + 1].chunk).noun : NounPhrase{};
    const std::string& first = document_.tokens[chunk(before.chunk).first].text;
    const bool at_wall = place.kind == NounKind::kWall && one_of(first, {"on", "against", "along", "down", "at"}) &&
                         one_of(preposition, {"on", "against", "along", "down", "at"});
    if (first != preposition && !at_wall) continue;
    // "a table with a jug at one end, a tray at the other"
    if (chunk(before.chunk).phrase.one && !before.alone.empty() &&
        !(noun_follows && !before.direct.empty() && place.kind == NounKind::kObject && place.determiner == Determiner::kDefinite)) {
      units_.back().direct.clear();
      units_.back().inverse.clear();
      units_.back().alone = before.alone;
      units_.back().senses = before.senses;
      units_.back().other = true;
      mark(k, WordReading::Use::kUsed, "relation");
      return true;
    }
    const bool of_thing = noun_follows && chunk(before.chunk).phrase.one && !before.direct.empty() && place.kind != NounKind::kWall;
    if (!noun_follows || (!of_thing && !is_one_of_its_kind(place))) continue;
    const NounPhrase said = noun;
    noun = place;
    noun.first = said.first;
    noun.last = said.last;
    if (!of_thing) {
      noun.count = 1;
      noun.ordinal = 0;
      return false;
    }
    noun.determiner = noun.kind == NounKind::kObject ? Determiner::kDefinite : noun.determiner;
    units_.back().direct = before.direct;
    for (PhraseSense& sense : units_.back().direct) {
      if (sense.type == RelationType::kInRegion && sense.region) sense.region = across_from(*sense.region);
    }
    units_.back().senses = before.senses;
    units_.back().other = true;
    return false;
  }
  return false;
}

// "a lamp on the left end of the sideboard, a vase on the right end": of the sideboard as well.
void UnitReader::repeat_owner(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  if (!after_place() || noun.kind != NounKind::kPart || noun.of || noun.determiner != Determiner::kDefinite || noun.wall_word.empty())
    return;
  for (std::size_t u = units_.size(); u-- > 0;) {
    if (units_[u].kind != UnitKind::kNoun) continue;
    const NounPhrase& before = chunk(units_[u].chunk).noun;
    if (before.kind != NounKind::kPart || before.head != noun.head || !before.of || before.of->kind != NounKind::kObject) continue;
    noun.of = std::make_shared<NounPhrase>(*before.of);
    noun.of->determiner = Determiner::kDefinite;
    return;
  }
}

// "the pair stands by the door", "a rug under the group": those that were named.
void UnitReader::mean_group(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  const bool group = one_of(noun.head, WordSet::kGroupNames);
  if (!group || noun.kind == NounKind::kPronoun || noun.of || noun.contents || !noun.attributes.empty() ||
      noun.name.find(" of ") != std::string::npos || noun.determiner != Determiner::kDefinite || noun.last - noun.first > 2)
    return;
  bool named = false;
  for (std::size_t c = k; c-- > 0 && !named;) named = is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kObject;
  if (!named) return;
  NounPhrase them;
  them.kind = NounKind::kPronoun;
  them.head = "them";
  them.plural = true;
  them.first = noun.first;
  them.last = noun.last;
  noun = them;
}

// "a sofa on the left and its twin on the right", "the same on the other side": another one.
void UnitReader::mean_twin(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  if (!is(previous(k), ChunkKind::kAnd) && !is(previous(k), ChunkKind::kComma) && !is(previous(k), ChunkKind::kRelation) &&
      !is(previous(k), ChunkKind::kStop))
    return;
  const std::string& last = document_.tokens[chunk(k).last - 1].text;
  const bool twin = noun.determiner == Determiner::kPossessive && noun.last - noun.first <= 3 && one_of(last, WordSet::kTwins);
  const std::size_t n = next(k);
  const bool same =
      last == "same" && noun.determiner == Determiner::kDefinite && noun.kind == NounKind::kAbstract && is(n, ChunkKind::kRelation);
  if ((!twin && !same) || units_.empty()) return;
  NounPhrase another;
  another.kind = NounKind::kMember;
  another.determiner = Determiner::kAnother;
  if (twin) another.head = "twin";
  another.first = noun.first;
  another.last = noun.last;
  noun = another;
}

// "Left wall: a wardrobe and a mirror", "Corner - a plant", "Desk: laptop, mug": where what is listed after it is.
const PhraseSenses* UnitReader::place_of_topic(std::size_t k) const {
  const std::size_t colon = k + 1, thing = k + 2;
  if (!units_.empty() || joiner_ != Joiner::kNone || skipping_ || negated_) return nullptr;
  if (!is(colon, ChunkKind::kComma) || !one_of(document_.tokens[chunk(colon).first].text, {":", "-"})) return nullptr;
  if (!is(thing, ChunkKind::kNoun) || chunk(thing).noun.kind != NounKind::kObject) return nullptr;
  const NounPhrase& noun = chunk(k).noun;
  switch (noun.kind) {
    case NounKind::kWall: return &direct_senses<RelationType::kAgainstWall, RelationType::kOnWall>();
    case NounKind::kCorner:
    case NounKind::kCenter: return noun.of ? nullptr : &direct_senses<RelationType::kCorner, RelationType::kCenterOfRoom>();
    case NounKind::kWindow:
    case NounKind::kDoor: return &direct_senses<RelationType::kNextTo>();
    case NounKind::kObject: {
      const NounPhrase& first = chunk(thing).noun;
      const bool carries = noun.exact && !noun.is_plural() && mount_of(noun) == Mount::kFloor && mount_of(first) == Mount::kSurface &&
                           may_carry(lexicon_.catalog(), noun, first);
      return carries ? &direct_senses<RelationType::kOn>() : nullptr;
    }
    default: return nullptr;
  }
}

bool UnitReader::opens_topic(std::size_t k) {
  const PhraseSenses* senses = place_of_topic(k);
  if (senses == nullptr) return false;
  const NounPhrase& noun = chunk(k).noun;
  if (is_opening(noun)) document_.openings.push_back(noun);
  add_place(k, *senses);
  add(UnitKind::kNoun, k);
  in_brackets_ = true;  // the colon joins nothing
  return true;
}

}  // namespace layoutbox::offline
