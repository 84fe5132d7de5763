// Which of a list share a place: "a bed and a desk against the wall".
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {
namespace {

bool usually_at_wall(const NounPhrase& noun) {
  return noun.entry != nullptr && (noun.entry->back_to_wall || noun.entry->is(Trait::kKitchenRun)) && !noun.entry->is(Trait::kCenterPiece);
}

// A board, a picture; not a TV, which stands as well.
bool hangs_only(const NounPhrase& noun) {
  return noun.entry != nullptr && noun.entry->mount == Mount::kWall && !noun.entry->is(Trait::kElseOnWall);
}

}  // namespace

// "a bed and a desk against the wall": whether the former member is there as well; nothing speaks for it: below −5.
double Decoder::share_score(const State& state, int member, int u, Referent implied) const {
  const int former = read_as(state, member).former;
  if (former < 0 || read_as(state, former).placed || !is_thing(state, former)) return -10;
  const NounPhrase &noun = noun_of(state, member), &before = noun_of(state, former);
  const Joiner joiner = unit(member).joiner;
  // "a shelf for the toys and a carpet in the middle": shelves stand at walls.
  const bool middle = says(unit(u).direct, RelationType::kCenterOfRoom) || says(unit(u).alone, RelationType::kCenterOfRoom) ||
                      (follows(u, UnitKind::kNoun) && chunk(u + 1).noun.kind == NounKind::kCenter && !chunk(u + 1).noun.of);
  if (middle && usually_at_wall(before) && !usually_at_wall(noun)) return -10;
  if (joiner != Joiner::kComma && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural &&
      before.determiner != Determiner::kNone)
    return weight::kShareArticle;
  const Unit& place = unit(u);
  const PhraseSenses& senses = place.direct.empty() ? place.alone : place.direct;
  // "an altar and six pews in two columns": the pews
  if (says(senses, RelationType::kGrid) && noun.count > 2 && !before.is_plural()) return -10;
  if (says(senses, RelationType::kRow) || says(senses, RelationType::kGrid) || says(senses, RelationType::kEvenlySpaced)) return 2;
  // "a shoe cabinet and a mirror over it": what stands on the floor is above nothing.
  if (says(senses, RelationType::kAbove) && mount_of(before) == Mount::kFloor && mount_of(noun) != Mount::kFloor) return -10;
  // "a whiteboard and a coffee machine on a sideboard": what hangs on walls lies on nothing.
  if (says(senses, &RelationTraits::rests) && hangs_only(before) && mount_of(noun) == Mount::kSurface) return -10;
  const NounPhrase& by = implied != kNobody ? noun_of(state, implied) : follows(u, UnitKind::kNoun) ? chunk(u + 1).noun : nothing_;
  // "a chair and a lamp for each desk"
  if (by.determiner == Determiner::kEach && chunk(u).kind == ChunkKind::kPurpose && joiner != Joiner::kComma) return weight::kShareVerb;
  if (const double kind = share_kind_score(state, member, u, implied, by); kind > 0) return kind;
  if (says(senses, RelationType::kCenterOfRoom) && joiner == Joiner::kAnd && read_as(state, former).former < 0) return 1;
  if (by.reciprocal && several(state, member)) return -10;
  // "four chairs and a lantern hanging over it": the chairs do not hang.
  const bool hangs = chunk(u).hang || ((is(u - 1, UnitKind::kParticiple) || is(u - 1, UnitKind::kVerb)) && chunk(u - 1).hang);
  if (hangs && mount_of(before) == Mount::kFloor) return -10;
  const std::string& first = word(u);
  const bool participle = state.participle || chunk(u).placing || first.ends_with("ing") || first.ends_with("ed");
  if (joiner == Joiner::kAnd && participle) return weight::kShareVerb;
  if (joiner == Joiner::kAnd && follows(u, UnitKind::kNoun) && chunk(u + 1).noun.reciprocal) return weight::kShareVerb;
  return is_pair(state, member, u) ? weight::kSharePair : -10;
}

// "Bench and whiteboard at the front": two by themselves, or as one item of a list whose items have each a place of their own, and no end
// of a list.
bool Decoder::is_pair(const State& state, int member, int u) const {
  const int former = read_as(state, member).former;
  if (unit(member).joiner != Joiner::kAnd || read_as(state, member).role == NounRole::kContent) return false;
  for (int between = member + 1; between < u; ++between) {
    if (is(between, UnitKind::kNoun)) return false;
  }
  if (former == 0 && read_as(state, former).former < 0) return true;
  const int next = u + (follows(u, UnitKind::kNoun) ? 2 : 1);
  // "stove and sink on the left side, fridge and pantry on the right side."
  const NounPhrase &noun = noun_of(state, member), &before = noun_of(state, former);
  const bool bare = noun.determiner == Determiner::kNone && before.determiner == Determiner::kNone;
  const bool after_place = is(former - 1, UnitKind::kPlace) || (is(former - 1, UnitKind::kNoun) && is(former - 2, UnitKind::kPlace));
  // "… by the window, a desk and a chair in the corner and a plant next to them": what comes next has a place of its own as well
  const bool goes_on = is(next, UnitKind::kNoun) && unit(next).joiner == Joiner::kAnd && has_place(next);
  const bool ends = !is(next, UnitKind::kNoun) && !is(next, UnitKind::kPlace);
  if (after_place && unit(former).joiner == Joiner::kComma && ((bare && ends) || goes_on)) return true;
  return unit(former).joiner == Joiner::kComma && is(next, UnitKind::kNoun) &&
         (unit(next).joiner == Joiner::kComma || unit(next).joiner == Joiner::kCommaAnd);
}

// "stove and sink along the left wall": what stands at walls; with articles, where what the list began with has its place already.
bool Decoder::share_wall(const State& state, int member, int u) const {
  const int former = read_as(state, member).former;
  const NounPhrase &noun = noun_of(state, member), &before = noun_of(state, former);
  if (unit(member).joiner != Joiner::kAnd || !usually_at_wall(before)) return false;
  const PhraseSenses& senses = unit(u).direct.empty() ? unit(u).alone : unit(u).direct;
  if (!usually_at_wall(noun) && !(hangs_only(noun) && says(senses, RelationType::kAgainstWall))) return false;
  const int earlier = read_as(state, former).former;
  return before.determiner == Determiner::kNone || (earlier >= 0 && is_placed_apart(state, earlier));
}

// Things of a kind share what such things have: what lies on a table, the seats around one.
double Decoder::share_kind_score(const State& state, int member, int u, Referent implied, const NounPhrase& by) const {
  const NounPhrase &noun = noun_of(state, member), &before = noun_of(state, read_as(state, member).former);
  const PhraseSenses& senses = unit(u).direct.empty() ? unit(u).alone : unit(u).direct;
  const NounPhrase& host = by.kind == NounKind::kMember && by.of ? *by.of : by;  // "on each of the two nightstands"
  const bool lies = says(senses, &RelationTraits::rests);
  const bool listed = unit(member).joiner != Joiner::kComma || state.frontier.back() != member;
  if (listed && (implied != kNobody || follows(u, UnitKind::kNoun)) && host.kind == NounKind::kObject) {
    const bool around =
        says(senses, RelationType::kAround) || says(senses, RelationType::kSurround) || says(senses, RelationType::kAlongSide);
    const auto carried = [&](const NounPhrase& n) {
      return sense_.carries(host, n) && (host.entry != nullptr ? !host.entry->thin : mount_of(n) != Mount::kFloor);
    };
    const bool seats = is_seat(lexicon_.catalog(), noun) && is_seat(lexicon_.catalog(), before);
    if ((lies && carried(noun) && carried(before)) || ((around || lies) && seats)) return weight::kShareKind;
  }
  // "mugs, bowls and a jar on the countertop"
  const bool top = by.kind == NounKind::kPart && one_of(by.head, {"tabletop", "countertop", "worktop", "desktop", "surface", "top"});
  if (listed && lies && top && mount_of(noun) == Mount::kSurface && mount_of(before) == Mount::kSurface) return weight::kShareKind;
  // "a clock, a mirror and a painting on the back wall"
  const bool hung = by.kind == NounKind::kWall && says(senses, RelationType::kOnWall);
  if (listed && hung && mount_of(noun) == Mount::kWall && mount_of(before) == Mount::kWall) return weight::kShareKind;
  // "shoes, shirts and cans on the floor": small things that lie about
  const bool floor = by.kind == NounKind::kFloor || (host.kind == NounKind::kObject && host.entry != nullptr && host.entry->thin);
  const auto lies_about = [&](const NounPhrase& n) {
    return mount_of(n) == Mount::kSurface || mount_of(n) == Mount::kHung || stands_small(n);
  };
  if (listed && lies && floor && lies_about(noun) && lies_about(before)) return weight::kShareKind;
  // "a cabinet with a fridge and a coffee machine on top": all that it has.
  const bool content = read_as(state, member).role == NounRole::kContent;
  if (content && lists_on_it(u - 1) && !is_seat(lexicon_.catalog(), before)) return weight::kShareVerb;
  if (!content && by.kind == NounKind::kWall && share_wall(state, member, u)) return weight::kSharePair;
  return content && implied != kNobody && lies && !is_seat(lexicon_.catalog(), before) && !is_table(lexicon_.catalog(), before) ? 1 : 0;
}

}  // namespace layoutbox::offline
