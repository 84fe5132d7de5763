// Sides and ends of the room in whatever words, and whether they are the room's or those of a thing.
#include <algorithm>
#include <span>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

namespace {

const PhraseSenses& at_wall_senses() { return direct_senses<RelationType::kAgainstWall, RelationType::kOnWall>(); }

// "the left", "the right side", and no "of" after it, ending at `last`; empty: no side.
std::string side_said(std::span<const Token> tokens, std::size_t last) {
  if (last < 2 || last > tokens.size() || (last < tokens.size() && tokens[last].text == "of")) return {};
  const std::size_t word = last - (tokens[last - 1].text == "side" ? 2 : 1);
  const bool side = tokens[word].text == "left" || tokens[word].text == "right";
  return side && word > 0 && tokens[word - 1].text == "the" ? tokens[word].text : std::string{};
}

}  // namespace

// "along one side of the room", "on each side of the hall": at its side walls.
void UnitReader::mean_side_of_room(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  // "by the window of the classroom": which room it is
  if (is_opening(noun) && noun.of && noun.of->room != nullptr && document_.rooms.empty()) document_.rooms.push_back(*noun.of);
  if (!after_place() || noun.kind != NounKind::kRoom || says(units_.back().direct, RelationType::kInRegion)) return;
  const Chunk& place = chunk(units_.back().chunk);
  const bool side = says(units_.back().direct, RelationType::kAlongSide), each = units_.back().each;
  const std::string words = words_between(document_, place.first, place.last);
  if ((!side && !each) || words.find("side") == std::string::npos) return;
  if (noun.room != nullptr && document_.rooms.empty()) document_.rooms.push_back(noun);
  noun.kind = NounKind::kWall;
  noun.room = nullptr;
  noun.name = words.find(" long") != std::string::npos || words.find(" short") != std::string::npos ? "wall" : "side wall";
  noun.head = "wall";
  for (const std::string_view hand : {"left", "right"}) {  // "along the right side of the hall"
    if (words.find(" " + std::string(hand)) == std::string::npos || each) continue;
    noun.wall_word = hand;
    noun.name = "wall";
  }
  noun.count = place.phrase.one ? 1 : 0;
  noun.determiner = each ? Determiner::kEach : Determiner::kDefinite;
  units_.back().direct = at_wall_senses();
  units_.back().senses = &at_wall_senses();
  units_.back().each = false;
}

// "the entire end of the hall", "the edge of the room", "down the far end", "at the eastern end": at the room's wall. An end of no said
// thing is the room's where what is placed stands on the floor and no table has been named for a seat.
void UnitReader::mean_end_of_room(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  const bool owned = owner_ < document_.chunks.size();  // "the bed's far side"
  if (owned || !after_place() || (noun.kind != NounKind::kPart && noun.kind != NounKind::kAbstract) ||
      !one_of(noun.head, WordSet::kRoomEnds))
    return;
  const bool of_room = noun.of && noun.of->kind == NounKind::kRoom;
  const bool behind = (noun.head == "back" || noun.head == "front") && noun.determiner == Determiner::kDefinite &&
                      says(units_.back().direct, RelationType::kAgainstWall);  // "along the back"
  // "along one long side", "in the middle of the short end"
  const bool of_length = std::ranges::any_of(noun.attributes, [](const std::string& word) { return one_of(word, WordSet::kLongOrShort); });
  if (!of_room && (noun.of || noun.determiner == Determiner::kPossessive || (noun.wall_word.empty() && !behind && !of_length) ||
                   noun.head == "edge" || !stands_in_room(k)))
    return;
  if (of_room && noun.of->room != nullptr && document_.rooms.empty()) document_.rooms.push_back(*noun.of);
  if (noun.wall_word.empty() && (noun.head == "back" || noun.head == "front")) noun.wall_word = noun.head;
  const bool sides = noun.head == "side" && noun.wall_word.empty();
  noun.kind = NounKind::kWall;
  noun.head = "wall";
  noun.name = sides ? "side wall" : "wall";
  noun.of.reset();
  // "in the middle of the left side"
  const Chunk& place = chunk(units_.back().chunk);
  const std::string said = words_between(document_, place.first, place.last);
  const bool middle = said.find("middle") != std::string::npos || said.find("center") != std::string::npos;
  const PhraseSenses& senses = middle ? direct_senses<RelationType::kCenteredOnWall>() : at_wall_senses();
  units_.back().direct = senses;
  units_.back().senses = &senses;
}

// "a table, a screen at one end, a sideboard at the other end": of the room, where what has a place there stands by itself.
const PhraseSenses* UnitReader::end_of_room(std::size_t k) const {
  static const PhraseSenses kOne = {{RelationType::kInRegion, PhraseSense::Direction::kAlone, {}, RoomRegion::kLeft, {}}},
                            kOther = {{RelationType::kInRegion, PhraseSense::Direction::kAlone, {}, RoomRegion::kRight, {}}},
                            kFar = {{RelationType::kInRegion, PhraseSense::Direction::kAlone, {}, RoomRegion::kBack, {}}},
                            kNear = {{RelationType::kInRegion, PhraseSense::Direction::kAlone, {}, RoomRegion::kFront, {}}};
  const Chunk& place = chunk(k);
  const auto& tokens = document_.tokens;
  if (is_side_of_room(k)) return &kOne;
  if (const std::string side = run_side_of_room(k); !side.empty()) return side == "left" ? &kOne : &kOther;
  if (tokens[place.last - 1].text != "end" || (place.last < tokens.size() && tokens[place.last].text == "of")) return nullptr;
  const bool other = place.last >= 2 && tokens[place.last - 2].text == "other";
  const bool end = place.last == place.first + 3 && tokens[place.first].text == "at" && tokens[place.first + 1].text == "the";
  if ((!other && !end && !place.phrase.one) || tokens[place.last - 2].text == "each") return nullptr;
  if (other && tells_of_end_of_room(k)) return &kNear;
  std::size_t thing = previous(k);
  // "the kitchen is at one end …, and at the other end a sofa"
  const bool fronted = is(thing, ChunkKind::kComma) || is(thing, ChunkKind::kAnd) || is(thing, ChunkKind::kStop);
  if (other && fronted && tells_of_room_end(k)) return &kOther;
  if (is(thing, ChunkKind::kNoun) && is(previous(thing), ChunkKind::kPurpose)) thing = previous(previous(thing));  // "a table for six at …"
  if (!is(thing, ChunkKind::kNoun) || chunk(thing).noun.kind != NounKind::kObject) return nullptr;
  thing = carrier_of(thing);
  // "a counter with a fridge at one end", but "a hall with a bench at one end"
  const std::size_t has = previous(thing);
  const bool of_room =
      is(has, ChunkKind::kHave) && is(previous(has), ChunkKind::kNoun) && chunk(previous(has)).noun.kind == NounKind::kRoom;
  if (is(has, ChunkKind::kHave) && !of_room) return nullptr;
  const CatalogEntry* entry = chunk(thing).noun.entry;
  constexpr Mm kDoor = 1500;  // an airlock is in a wall of the room
  const bool board = entry != nullptr && ((entry->is(Trait::kScreen) && (entry->mount == Mount::kWall || entry->is(Trait::kElseOnWall))) ||
                                          (entry->mount == Mount::kWall && entry->size.usual.height > kDoor));
  const bool stands = mount_of(chunk(thing).noun) == Mount::kFloor && (of_room || !is_seat(lexicon_.catalog(), chunk(thing).noun));
  return !board && !stands ? nullptr : other ? &kOther : end ? &kFar : &kOne;
}

// Is a part of the room told to be at one end before?
bool UnitReader::tells_of_room_end(std::size_t k) const {
  for (std::size_t c = k > kFarthestBack ? k - kFarthestBack : 0; c < k; ++c) {
    if (!is(c, ChunkKind::kRelation) || !chunk(c).phrase.one || document_.tokens[chunk(c).last - 1].text != "end") continue;
    std::size_t part = previous(c);
    if (is(part, ChunkKind::kVerb)) part = previous(part);
    if (is(part, ChunkKind::kNoun) && chunk(part).noun.kind == NounKind::kRoom) return true;
  }
  return false;
}

// "At one end of the room is a stage, at the other end a bar": the far end, and so the near one.
bool UnitReader::tells_of_end_of_room(std::size_t k) const {
  for (std::size_t c = k > kFarthestBack ? k - kFarthestBack : 0; c < k; ++c) {
    const bool of_end = is(c, ChunkKind::kRelation) && chunk(c).phrase.one && chunk(c).last - chunk(c).first >= 2 &&
                        document_.tokens[chunk(c).last - 2].text == "end" && document_.tokens[chunk(c).last - 1].text == "of";
    if (of_end && is(next(c), ChunkKind::kNoun) && chunk(next(c)).noun.kind == NounKind::kRoom) return true;
    // "One end of the room is given over to a bar; at the other end …"
    const NounPhrase* end = is(c, ChunkKind::kNoun) && chunk(c).noun.head == "end" ? &chunk(c).noun : nullptr;
    if (end != nullptr && end->of && end->of->kind == NounKind::kRoom) return true;
  }
  return false;
}

// "…, and shoji screens on one side": of the room, where what is listed stands by itself and goes with nothing, and no other side follows.
bool UnitReader::is_side_of_room(std::size_t k) const {
  const Chunk& place = chunk(k);
  const auto& tokens = document_.tokens;
  const std::size_t thing = previous(k);
  if (place.last < 2 || tokens[place.last - 1].text != "side" || tokens[place.last - 2].text != "one" || !is(thing, ChunkKind::kNoun))
    return false;
  const bool over = place.last >= tokens.size() || tokens[place.last].kind == Token::Kind::kPunctuation || tokens[place.last].ends_sentence;
  for (std::size_t i = place.last; i < tokens.size() && !tokens[i - 1].ends_sentence; ++i) {
    if (tokens[i].text == "other") return false;
  }
  const NounPhrase& noun = chunk(thing).noun;
  const bool listed = is(previous(thing), ChunkKind::kComma) || is(previous(thing), ChunkKind::kAnd);
  return over && listed && noun.kind == NounKind::kObject && noun.entry != nullptr && noun.entry->beside.empty() &&
         noun.entry->mount == Mount::kFloor && !noun.entry->thin && !is_seat(lexicon_.catalog(), noun);
}

// "Sink and dishwasher on the left side, hob on the right": units of a kitchen, and what stands at walls, are at the sides of the room
// where the text tells of both; which side, or empty.
std::string UnitReader::run_side_of_room(std::size_t k) const {
  const std::string side = side_said(document_.tokens, chunk(k).last);
  if (side.empty()) return {};
  std::size_t thing = previous(k);
  if (is(thing, ChunkKind::kNoun) && is(previous(thing), ChunkKind::kPurpose)) thing = previous(previous(thing));  // "a table for six on …"
  const std::size_t last = thing;
  const bool large = is_large_by_itself(last);
  while (!large && is(thing, ChunkKind::kNoun) && (is(previous(thing), ChunkKind::kAnd) || is(previous(thing), ChunkKind::kHave)))
    thing = previous(previous(thing));
  const bool unit = is(thing, ChunkKind::kNoun) && chunk(thing).noun.entry != nullptr && chunk(thing).noun.entry->is(Trait::kKitchenRun);
  // "kitchen on the left, sofa and TV on the right", "…, a dining table for six on the right"
  const bool great = !large && (is_large_by_itself(thing) || is_great_table(last));
  if (!unit && !large && !great) return {};
  // "a wall of filing cabinets on the left"
  if (large && chunk(thing).noun.is_plural()) return side;
  // "Bunk bed on the left, …": of nothing that was named before
  const bool first =
      std::none_of(document_.chunks.begin(), document_.chunks.begin() + static_cast<std::ptrdiff_t>(thing),
                   [](const Chunk& c) { return c.kind == ChunkKind::kNoun && (c.noun.kind == NounKind::kObject || is_opening(c.noun)); });
  if (large && first) return side;
  const std::size_t end = std::min(document_.chunks.size(), k + kFarthestBack);
  bool at_wall = false;  // "a bar on the back wall, a fireplace on the left and stairs on the right"
  for (std::size_t c = k > kFarthestBack ? k - kFarthestBack : 0; c < end; ++c) {
    // "bikes on the left wall, freezer on the right"
    const bool wall =
        is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kWall && one_of(chunk(c).noun.wall_word, {"left", "right"});
    at_wall |= is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kWall && one_of(chunk(c).noun.wall_word, {"back", "front"});
    if (wall && chunk(c).noun.wall_word != side && (large || great)) return side;
    if (c == k || !is(c, ChunkKind::kRelation)) continue;
    const std::string other = side_said(document_.tokens, chunk(c).last);
    if (other.empty() || other == side) continue;
    const bool part = is(previous(c), ChunkKind::kNoun) && chunk(previous(c)).noun.kind == NounKind::kRoom;
    if (unit || part || is_large_by_itself(previous(c)) || (at_wall && !great)) return side;
  }
  // "a workbench at the back wall, shelving on the left side": where such lists go along the walls
  const bool listed = is(previous(thing), ChunkKind::kComma) || is(previous(thing), ChunkKind::kAnd);
  if (large && listed && at_wall && !is(next(k), ChunkKind::kRelation)) return side;
  return {};
}

// "Bed on the left, wardrobe on the right": what stands at a wall, and that no other thing is said to have.
bool UnitReader::is_large_by_itself(std::size_t thing) const {
  if (!is(thing, ChunkKind::kNoun) || chunk(thing).noun.kind != NounKind::kObject || is(previous(thing), ChunkKind::kHave)) return false;
  const CatalogEntry* entry = chunk(thing).noun.entry;
  constexpr Mm kLarge = 700;  // wider than a nightstand
  const bool wide = entry != nullptr && entry->size.usual.width * std::max(chunk(thing).noun.count, 1) >= kLarge;
  return wide && entry->mount == Mount::kFloor && entry->back_to_wall;
}

// A table that a group sits at, of its own place in the room.
bool UnitReader::is_great_table(std::size_t thing) const {
  constexpr Mm kGreat = 1500;
  if (!is(thing, ChunkKind::kNoun) || is(previous(thing), ChunkKind::kHave)) return false;
  const CatalogEntry* entry = chunk(thing).noun.entry;
  return entry != nullptr && entry->is(Trait::kTable) && entry->mount == Mount::kFloor && entry->size.usual.width >= kGreat;
}

// "a sideboard with a coffee machine": the sideboard, of the machine.
std::size_t UnitReader::carrier_of(std::size_t thing) const {
  if (thing >= document_.chunks.size() || mount_of(chunk(thing).noun) != Mount::kSurface || !is(previous(thing), ChunkKind::kHave))
    return thing;
  const std::size_t host = previous(previous(thing));
  return is(host, ChunkKind::kNoun) && chunk(host).noun.kind == NounKind::kObject ? host : thing;
}

// Whether what the place before chunk k is said of stands on the floor by itself: no seat where a table was named.
bool UnitReader::stands_in_room(std::size_t k) const {
  const std::size_t place = units_.back().chunk;
  std::size_t thing = document_.chunks.size();
  constexpr std::size_t kBack = 60;
  for (std::size_t c = place; c-- > 0 && c + kBack > place && !is(c, ChunkKind::kStop) && thing >= document_.chunks.size();) {
    if (is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kObject) thing = c;
  }
  const std::size_t before = previous(place);
  const bool fronted = before >= place || is(before, ChunkKind::kStop) || is(before, ChunkKind::kComma) || is(before, ChunkKind::kAnd);
  if (fronted) {
    std::size_t after = next(k);
    while (is(after, ChunkKind::kComma) || is(after, ChunkKind::kVerb) || is(after, ChunkKind::kThere)) after = next(after);
    if (is(after, ChunkKind::kNoun)) thing = after;
  }
  if (thing >= document_.chunks.size() || chunk(thing).noun.kind != NounKind::kObject || mount_of(chunk(thing).noun) != Mount::kFloor)
    return false;
  if (!is_seat(lexicon_.catalog(), chunk(thing).noun)) return true;
  return std::none_of(units_.begin(), units_.end(), [&](const Unit& unit) {
    return unit.kind == UnitKind::kNoun && is_table(lexicon_.catalog(), chunk(unit.chunk).noun);
  });
}

}  // namespace layoutbox::offline
