// What a thing has that is no thing of its own: a frame, seats of a room, parts let into it.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

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
  const CatalogEntry* form = object.entry == nullptr ? nullptr : kind_at(catalog, object.entry->id, KinPlace::kSetIn);
  if (form == nullptr || host >= document_.chunks.size() || chunk(host).noun.entry == nullptr) return false;
  return std::ranges::any_of(form->stands_on, [&](const std::string& id) { return catalog.is_a(chunk(host).noun.entry->id, id); });
}

// "a table with four seats": they are no part of it.
bool UnitReader::is_at_table(const NounPhrase& object) const {
  const std::size_t host = last_noun();
  return object.count > 1 && is_seat(lexicon_.catalog(), object) && host < document_.chunks.size() &&
         is_table(lexicon_.catalog(), chunk(host).noun);
}

}  // namespace layoutbox::offline
