// Parts of the room in whatever words: where the light comes in, zones, the fire, and verbs between a thing and a part of the room.
#include <algorithm>
#include <span>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/word_sets.h"

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

const PhraseSenses& at_spot_senses() {
  return direct_senses<RelationType::kCenterOfRoom, RelationType::kOn, RelationType::kIn, RelationType::kAgainstWall, RelationType::kOnWall,
                       RelationType::kNextTo>();
}

}  // namespace

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

// "It is not a bad room, only a tired one": in a sentence that says what the room is and names nothing else, "one" is the room.
bool UnitReader::is_one_of_rooms(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  if (noun.kind != NounKind::kMember || noun.determiner != Determiner::kIndefinite || noun.of || noun.last <= noun.first) return false;
  if (document_.tokens[noun.last - 1].text != "one") return false;
  bool room = false;
  for (std::size_t c = k; c-- > 0 && chunk(c).kind != ChunkKind::kStop;) {
    if (chunk(c).kind != ChunkKind::kNoun || chunk(c).noun.kind == NounKind::kPronoun) continue;
    if (chunk(c).noun.kind != NounKind::kRoom && chunk(c).noun.kind != NounKind::kOutsideRoom) return false;
    room = room || !is(previous(c), ChunkKind::kRelation);
  }
  return room;
}

}  // namespace layoutbox::offline
