// Parts of the room in whatever words: its sides and ends, where the light comes in, and verbs between a thing and a part of the room.
#include <algorithm>
#include <span>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/english.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/word_sets.h"
#include "layoutbox/plan/reading/unit_reader.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

namespace {

// "a bedroom with a balcony …, an armchair near the balcony"
bool is_known_as_door(const Document& document, std::size_t k) {
  const auto earlier = std::span(document.chunks).first(k);
  return std::ranges::any_of(earlier, [&](const Chunk& chunk) {
    return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kDoor && chunk.noun.head == document.chunks[k].noun.head;
  });
}

const PhraseSenses& at_wall_senses() { return direct_senses<RelationType::kAgainstWall, RelationType::kOnWall>(); }

const PhraseSenses& at_spot_senses() {
  return direct_senses<RelationType::kCenterOfRoom, RelationType::kOn, RelationType::kIn, RelationType::kAgainstWall, RelationType::kOnWall,
                       RelationType::kNextTo>();
}

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
  if (is(previous(thing), ChunkKind::kHave)) return nullptr;  // "a counter with a fridge at one end"
  const CatalogEntry* entry = chunk(thing).noun.entry;
  constexpr Mm kDoor = 1500;  // an airlock is in a wall of the room
  const bool board = entry != nullptr && ((entry->is(Trait::kScreen) && (entry->mount == Mount::kWall || entry->is(Trait::kElseOnWall))) ||
                                          (entry->mount == Mount::kWall && entry->size.usual.height > kDoor));
  const bool stands = mount_of(chunk(thing).noun) == Mount::kFloor && !is_seat(lexicon_.catalog(), chunk(thing).noun);
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

// "in front of the glass" is before the window, "the nook under the stairs" is no staircase: what rooms have, where it was not named.
void UnitReader::mean_fabric(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  const bool shines = one_of(noun.head, WordSet::kDaylight) && noun.determiner == Determiner::kDefinite;
  // "Cold light enters through the window"
  const std::size_t verb = next(k);
  const bool falls = one_of(noun.head, WordSet::kDaylight) && noun.count == 0 && verb < document_.chunks.size() &&
                     chunk(verb).kind != ChunkKind::kNoun && one_of(document_.tokens[chunk(verb).first].text, WordSet::kLightComes);
  if (falls) noun.kind = NounKind::kAbstract;
  // "near the balcony": by its glass door
  const bool by = after_place() && (says(units_.back().direct, RelationType::kNear) || says(units_.back().direct, RelationType::kNextTo) ||
                                    says(units_.back().direct, RelationType::kFacing));
  if (by && noun.kind == NounKind::kOutsideRoom && one_of(noun.head, {"balcony", "terrace", "patio"}) &&
      noun.determiner == Determiner::kDefinite)
    noun.kind = is_known_as_door(document_, k) ? NounKind::kDoor : NounKind::kWindow;
  // "a bedroom with a balcony": what is seen of it in here is its door.
  if (noun.kind == NounKind::kOutsideRoom && !units_.empty() && units_.back().kind == UnitKind::kHave && !noun.of &&
      opening_look(OpeningType::kDoor, {noun.head}).outside)
    noun.kind = NounKind::kDoor;
  if (after_place() && shines && says(units_.back().direct, RelationType::kIn) && noun.name == noun.head && !is_named_before(k, noun.head))
    noun.kind = NounKind::kAbstract;  // "in the light"
  const bool pane =
      noun.head == "glass" && noun.name == noun.head && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural;
  if (pane && after_place()) noun.kind = NounKind::kAbstract;  // "a shower behind glass"
  if (!after_place() || noun.kind != NounKind::kObject || noun.determiner != Determiner::kDefinite || noun.count > 0 || noun.of ||
      !noun.attributes.empty())
    return;
  if (noun.head == "glass" && noun.name == "glass" && !noun.plural && !is_named_before(k, "glass") &&
      !says(units_.back().direct, &RelationTraits::rests))
    noun.kind = NounKind::kWindow;
  const bool told = is(next(k), ChunkKind::kRelative);  // "the stairs which are in the corner"
  if ((noun.name == "stairs" || (noun.name == "stair" && noun.plural)) && !told && !is_named_before(k, noun.head))
    noun.kind = NounKind::kAbstract;
}

// "a printer corner", "a small sofa area": the thing that such a place is for, where nothing else of its kind is named.
void UnitReader::mean_thing_of_zone(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  const bool zone = noun.kind == NounKind::kCorner || noun.kind == NounKind::kAbstract || noun.kind == NounKind::kRoom;
  const bool anew = noun.determiner == Determiner::kIndefinite || (noun.determiner == Determiner::kNone && joiner_ != Joiner::kNone);
  if (!zone || !anew || after_place() || noun.room != nullptr || noun.last < noun.first + 2 || !one_of(noun.head, WordSet::kNooks)) return;
  const Match match = lexicon_.find(document_.tokens, noun.last - 2, WordClass::kObject);
  const auto thing =
      std::ranges::find_if(match.meanings, [](const Meaning& m) { return m.word_class == WordClass::kObject && m.entry != nullptr; });
  if (match.length != 1 || thing == match.meanings.end()) return;
  const CatalogEntry& entry = *thing->entry;
  const std::string& word = document_.tokens[noun.last - 2].text;
  if (entry.mount != Mount::kFloor && !one_of(word, {"printer", "tv", "computer"})) return;
  const bool named = std::ranges::any_of(document_.chunks, [&](const Chunk& other) {
    return other.kind == ChunkKind::kNoun && other.noun.kind == NounKind::kObject && other.noun.entry == &entry;
  });
  if (named) return;
  noun.kind = NounKind::kObject;
  noun.entry = &entry;
  noun.exact = true;
  noun.category = entry.id;
  noun.name = noun.head = word;
  noun.doubted = false;
}

// "by the fire", "armchairs that face the fire": the fireplace or stove that was named.
void UnitReader::mean_fire(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  if (noun.head != "fire" || noun.name != "fire" || noun.determiner != Determiner::kDefinite || noun.plural || noun.of || !after_place())
    return;
  const NounPhrase said = noun;
  const auto burns = [&](const NounPhrase& named) {
    return named.kind == NounKind::kObject && named.entry != nullptr && named.entry->is(Trait::kFire);
  };
  for (std::size_t c = k; c-- > 0;) {
    if (!is(c, ChunkKind::kNoun) || !burns(chunk(c).noun)) continue;
    noun = chunk(c).noun;
    noun.determiner = Determiner::kDefinite;
    noun.count = 0;
    noun.attributes.clear();
    noun.attribute_classes.clear();
    noun.first = said.first;
    noun.last = said.last;
    return;
  }
}

// The chunk is one word that no list has for places, and may be a verb.
bool UnitReader::is_unread_verb(std::size_t k) const {
  if (k >= document_.chunks.size() || chunk(k).last - chunk(k).first != 1) return false;
  const std::string& word = document_.tokens[chunk(k).first].text;
  const bool to = chunk(k).first > 0 && document_.tokens[chunk(k).first - 1].text == "to";
  return (is(k, ChunkKind::kUnknown) || is(k, ChunkKind::kPurpose)) && !to && !one_of(word, {"for", "as", "like", "enough", "perfect"});
}

// "a bell marks the middle of the desk", "a wardrobe straddles the corner", "two sofas claim the far wall": a verb, and where.
void UnitReader::place_at_spot(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t verb = previous(k), thing = verb < k ? previous(verb) : k;
  if (!is_part_of_room(noun) || noun.kind == NounKind::kCeiling || noun.determiner == Determiner::kNone || verb >= k || thing >= k) return;
  if (!is_unread_verb(verb) || !is(thing, ChunkKind::kNoun) || chunk(thing).noun.kind != NounKind::kObject) return;
  if (units_.empty() || units_.back().chunk != thing) return;
  skipping_ = false;
  mark(verb, Use::kUsed, "placing");
  document_.chunks[verb].kind = ChunkKind::kRelation;
  document_.chunks[verb].phrase.senses = &at_spot_senses();
  add_place(verb, at_spot_senses());
}

// "a print brightens the wall above the bed", "a rug warms the floor beneath it": where of the wall or floor is where it is.
bool UnitReader::passes_patch(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t verb = previous(k), place = next(k);
  const bool patch = (noun.kind == NounKind::kFloor || noun.kind == NounKind::kWall) && noun.determiner == Determiner::kDefinite &&
                     noun.wall_word.empty() && noun.wall_relation.empty() && !noun.of;
  if (!patch || verb >= k || !is_unread_verb(verb) || !is(place, ChunkKind::kRelation) || units_.empty()) return false;
  const std::size_t thing = previous(verb);
  const bool subject = is(thing, ChunkKind::kNoun) && chunk(thing).noun.kind == NounKind::kObject && units_.back().chunk == thing;
  if (!subject || !is(next(place), ChunkKind::kNoun)) {
    const bool it = subject && !chunk(place).phrase.senses->empty() && document_.tokens[chunk(place).last - 1].text == "it";
    if (!it) return false;
  }
  skipping_ = doing_ = false;
  mark(verb, Use::kUsed, "placing");
  mark(k, Use::kIgnored, "no object");
  add(UnitKind::kVerb, verb);
  return true;
}

// "the wall facing the door carries a map", "the far corner shelters a stove": what a part of the room has.
bool UnitReader::wall_has(std::size_t k) const {
  const std::size_t n = next(k);
  const std::size_t p = previous(k);
  // "one corner is for the trolley"
  const bool is_for = document_.tokens[chunk(k).first].text == "for" && is(p, ChunkKind::kVerb);
  const bool verb = is_unread_verb(k) && is(p, ChunkKind::kNoun);
  if (skipping_ || !(verb || is_for) || !is(n, ChunkKind::kNoun) || joiner_ != Joiner::kNone) return false;
  if (chunk(n).noun.kind != NounKind::kObject || (chunk(n).noun.determiner == Determiner::kNone && chunk(n).noun.count == 0)) return false;
  for (std::size_t u = units_.size(); u-- > 0;) {
    if (units_[u].kind == UnitKind::kNoun && (u == 0 || units_[u].joiner != Joiner::kNone || units_[u].clause)) {
      const NounKind kind = chunk(units_[u].chunk).noun.kind;
      return kind == NounKind::kWall || kind == NounKind::kCorner || kind == NounKind::kCenter;
    }
    const bool be = is_for && u + 1 == units_.size() && units_[u].kind == UnitKind::kVerb;
    if (units_[u].kind != UnitKind::kNoun && units_[u].kind != UnitKind::kPlace && !be) return false;
  }
  return false;
}

// "has its place in the corner", "finds a home by the window", "holds court in the middle": it is there.
bool UnitReader::passes_spot(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t verb = previous(k), n = next(k);
  if (verb >= k || !is(n, ChunkKind::kRelation) || noun.count > 0 || noun.plural || chunk(verb).last != chunk(k).first) return false;
  const bool bare = noun.determiner == Determiner::kNone && one_of(noun.head, WordSet::kHeldThings);
  const bool own = one_of(noun.head, WordSet::kOwnSpots) &&
                   (noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kPossessive) &&
                   noun.last <= noun.first + 3;
  if (!bare && !own) return false;
  const bool subject = is(previous(verb), ChunkKind::kNoun) && chunk(previous(verb)).noun.kind == NounKind::kObject;
  const bool has = is(verb, ChunkKind::kHave) || is(verb, ChunkKind::kVerb) || is(verb, ChunkKind::kPurpose) ||
                   is(verb, ChunkKind::kThere) || is(verb, ChunkKind::kCommand);
  if (!subject || !has || chunk(verb).last - chunk(verb).first != 1) return false;
  if (!units_.empty() && units_.back().chunk == verb) {
    joiner_ = units_.back().joiner;
    units_.pop_back();
  }
  skipping_ = false;
  mark(verb, Use::kUsed, "placing");
  mark(k, Use::kIgnored, "no object");
  add(UnitKind::kVerb, verb);
  return true;
}

}  // namespace layoutbox::offline
