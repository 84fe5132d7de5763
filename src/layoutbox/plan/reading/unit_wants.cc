// What is wanted in other words than that it is there: a place for it, one for each, and where something is not to be.
#include <algorithm>
#include <string_view>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// "a place for two bicycles", "room for a pram": they are to stand there.
bool UnitReader::keeps_place_for(std::size_t k) {
  const std::size_t p = previous(k), n = next(k);
  if (skipping_ || negated_ || document_.tokens[chunk(k).first].text != "for" || !names_thing(n) || p >= k || !is(p, ChunkKind::kNoun) ||
      units_.empty())
    return false;
  const NounPhrase &place = chunk(p).noun, &thing = chunk(n).noun;
  if (thing.name == thing.head && word_form(thing.head) == WordForm::kPerson) return false;  // "a room for a dragon"
  const bool plain = one_of(place.head, WordSet::kPlaceForThing) && place.room == nullptr;
  const bool anew =
      thing.determiner == Determiner::kIndefinite || thing.count > 0 ||
      ((thing.determiner == Determiner::kPossessive || thing.determiner == Determiner::kDefinite) && !is_named_before(n, thing.head));
  if (!plain || !anew || mount_of(thing) != Mount::kFloor || thing.entry->is(Trait::kPersonalAid)) return false;
  if (is(next(n), ChunkKind::kUnknown) || document_.tokens[std::min(chunk(n).last, document_.tokens.size() - 1)].text == "to") return false;
  mark(k, Use::kIgnored, "opens a statement");
  if (units_.back().kind == UnitKind::kNoun && units_.back().chunk == p) {
    joiner_ = units_.back().joiner;
    clause_ = units_.back().clause;
    mark(p, Use::kIgnored, "opens a statement");
    units_.pop_back();
  }
  return true;
}

// "I want to offer a bed", "we plan to provide two desks": what a wish wants done with them, they are there.
bool UnitReader::wishes_to(std::size_t k) {
  std::size_t first = chunk(k).first;
  const std::size_t n = next(k);
  if (document_.tokens[first].text == "to") ++first;
  const bool opens = std::ranges::all_of(units_, [&](const Unit& unit) {
    return unit.kind == UnitKind::kOpen || (unit.kind == UnitKind::kPlace && chunk(unit.chunk).first + 1 == first);  // "to"
  });
  if (skipping_ || !opens || first < 2 || document_.tokens[first - 1].text != "to" || !is(n, ChunkKind::kNoun)) return false;
  const NounPhrase& noun = chunk(n).noun;
  const bool anew = noun.kind == NounKind::kObject && (noun.determiner == Determiner::kIndefinite || noun.count > 0);
  const bool wish =
      one_of(document_.tokens[first - 2].text, {"want", "wants", "like", "need", "needs", "plan", "hope", "wish", "have", "love"});
  if (!anew || !wish) return false;
  if (!units_.empty() && units_.back().kind == UnitKind::kPlace) {
    mark(units_.back().chunk, Use::kIgnored, "opens a statement");
    units_.pop_back();
  }
  mark(k, Use::kIgnored, "opens a statement");
  add(UnitKind::kOpen, k);
  return true;
}

// What "not there" asks for, where it can be kept: an opening stays free, what it is not beside stands apart.
const PhraseSenses* UnitReader::kept_free(std::size_t r, std::size_t n) {
  const PhraseSenses& senses = *chunk(r).phrase.senses;
  const NounKind kind = chunk(n).noun.kind;
  const bool opening = kind == NounKind::kDoor || kind == NounKind::kWindow;
  if (!opening && kind != NounKind::kObject) return nullptr;
  const auto any_of = [&](std::initializer_list<RelationType> types) {
    return std::ranges::any_of(types, [&](RelationType type) { return says(senses, type); });
  };
  if (opening && any_of({RelationType::kUnder, RelationType::kUnderWindow, RelationType::kInFrontOf, RelationType::kBehind}))
    return &direct_senses<RelationType::kNotBlocking>();
  if (!any_of({RelationType::kNextTo, RelationType::kNear, RelationType::kAgainstWall})) return nullptr;
  constexpr double kApart = 1;  // metres
  document_.chunks[r].distance = kApart;
  document_.chunks[r].at_least = true;
  return &direct_senses<RelationType::kDistance>();
}

// "not under the window": a place where it is not says little of where it is.
bool UnitReader::denies_place(std::size_t k) {
  bool denies = false;
  for (std::size_t i = chunk(k).first; i < chunk(k).last; ++i) denies |= one_of(document_.tokens[i].text, {"not", "never"});
  std::size_t r = next(k);
  if (is(r, ChunkKind::kVerb) &&
      one_of(document_.tokens[chunk(r).first].text, {"be", "stand", "go", "stay"})) {  // "should not be by the TV"
    mark(r, Use::kIgnored, "not there");
    r = next(r);
  }
  const std::size_t n = next(r);
  if (!denies || !is(r, ChunkKind::kRelation) || !is(n, ChunkKind::kNoun)) return false;
  if (const PhraseSenses* senses = kept_free(r, n)) {
    document_.chunks[r].phrase.senses = senses;
    passed_until_ = r;
    return true;
  }
  if (chunk(n).noun.determiner != Determiner::kDefinite && chunk(n).noun.kind == NounKind::kObject) return false;
  mark(r, Use::kIgnored, "not there");
  mark(n, Use::kIgnored, "not there");
  passed_until_ = n + 1;
  return true;
}

// "two cots with a screen between, a crate and a stool for each": every single thing since the last break is there for each of those.
bool UnitReader::brings_each(std::size_t k) {
  const std::size_t n = next(k), after = next(n);
  if (skipping_ || document_.tokens[chunk(k).first].text != "for" || !is(n, ChunkKind::kNoun)) return false;
  const NounPhrase& each = chunk(n).noun;
  const bool ends =
      after >= document_.chunks.size() || is(after, ChunkKind::kComma) || is(after, ChunkKind::kStop) || is(after, ChunkKind::kAnd);
  if (each.determiner != Determiner::kEach || each.kind == NounKind::kObject || each.of || !ends) return false;
  const auto is_new_single = [&](const Unit& unit) {
    const NounPhrase& noun = chunk(unit.chunk).noun;
    return unit.kind == UnitKind::kNoun && noun.kind == NounKind::kObject && !noun.is_plural() && noun.determiner != Determiner::kDefinite;
  };
  int count = 0;
  for (const Unit& unit : units_) {
    const NounPhrase& noun = chunk(unit.chunk).noun;
    if (unit.kind == UnitKind::kNoun && noun.kind == NounKind::kObject && noun.count > 1) count = noun.count;
  }
  if (count < 2 || units_.empty() || !is_new_single(units_.back())) return false;
  for (std::size_t u = units_.size(); u-- > 0 && is_new_single(units_[u]);) {
    units_[u].share = count;
    if (units_[u].joiner != Joiner::kAnd) break;
  }
  mark(k, Use::kUsed, "for each");
  mark(n, Use::kUsed, "for each");
  passed_until_ = after;
  return true;
}

// "No doors", "a cell without a door"; not "a cabinet without doors".
bool UnitReader::denies_doors(std::size_t k) const {
  const std::size_t host = last_noun();
  return chunk(k).noun.kind == NounKind::kDoor && (host >= document_.chunks.size() || chunk(host).noun.kind == NounKind::kRoom);
}

// The list from n on has a place of its own in the room: "dog bed beside the radiator", "bed, desk in the corner".
bool UnitReader::lists_placed(std::size_t n) const {
  while (is(n, ChunkKind::kNoun) && chunk(n).noun.kind == NounKind::kObject &&
         (is(next(n), ChunkKind::kComma) || is(next(n), ChunkKind::kAnd)) && is(next(next(n)), ChunkKind::kNoun))
    n = next(next(n));
  if (!is(n, ChunkKind::kNoun) || chunk(n).noun.kind != NounKind::kObject || !is(next(n), ChunkKind::kRelation)) return false;
  const std::size_t by = next(next(n));  // "no toys, shoes in the room" are not wanted there
  return !is(by, ChunkKind::kNoun) || chunk(by).noun.kind != NounKind::kRoom;
}

// "no windows, bed, lamp", "nothing with sharp corners, bunk bed, …": furniture, after what is none, is there.
bool UnitReader::turns_to_furniture(std::size_t k, std::size_t n) const {
  const std::size_t p = previous(k);
  if (!is(p, ChunkKind::kNoun) || !is(n, ChunkKind::kNoun)) return false;
  const NounPhrase &denied = chunk(p).noun, &thing = chunk(n).noun;
  const bool none = is_opening(denied) || denied.kind == NounKind::kPart || denied.kind == NounKind::kAbstract;
  return none && thing.kind == NounKind::kObject && thing.exact && !thing.plural && mount_of(thing) == Mount::kFloor;
}

}  // namespace layoutbox::offline
