// How well what was named before bears what is placed by it.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

namespace {

bool stands(const NounPhrase& noun) {
  return noun.kind != NounKind::kObject || (mount_of(noun) == Mount::kFloor && (noun.entry == nullptr || !noun.entry->thin));
}

bool is_it(const NounPhrase* noun) { return noun != nullptr && noun->head == "it"; }
// "a bed with two nightstands, a lamp on each": of several.
double each_score(const NounPhrase* noun, bool several) {
  const bool each = noun != nullptr && noun->determiner == Determiner::kEach && noun->kind != NounKind::kObject;
  return each && !several ? weight::kUnlikely : 0;
}
bool is_unsaid(const NounPhrase* noun) { return noun != nullptr && noun->head.empty(); }

}  // namespace

// What stands on its own host: "a wardrobe with a suitcase on top", though suitcases mostly stand on the floor.
double Decoder::own_top_score(double so_far, const NounPhrase& noun, const NounPhrase& host, const NounPhrase& target) const {
  if (!noun.head.empty()) return so_far + weight::kOnOwnHost;
  return (has_top_for(host, target) ? std::max(so_far, 0.0) : so_far) + weight::kTopOfOwnHost;
}

// "a TV hangs opposite the sofa, a speaker below it": not below the sofa; a rug may be. "a sofa facing a TV with a cabinet under it"
double Decoder::below_seat_score(const State& state, const NounPhrase& target, Referent referent) const {
  constexpr Mm kKnee = 350;
  if (referent < 0 || !is_seat(lexicon_.catalog(), noun_of(state, referent)) || (target.entry != nullptr && target.entry->thin)) return 0;
  if (mount_of(target) == Mount::kFloor && target.entry != nullptr && target.entry->size.usual.height > kKnee) return weight::kUnlikely;
  return read_as(state, referent).role == NounRole::kReference ? weight::kNotBeside : 0;
}

// … by what is in front of what has it.
double Decoder::before_own_host_score(const State& state, Referent referent, Referent subject, const PhraseSenses& senses,
                                      const NounPhrase* noun) const {
  const NounPhrase &target = noun_of(state, subject), &meant = noun_of(state, referent);
  const Referent owner = subject >= 0 ? host_of(state, subject) : kNobody;
  const bool small = mount_of(target) == Mount::kSurface;
  double score = 0;
  // "a keyboard in front": of the screen, not of the desk that carries both.
  const bool before = says(senses, RelationType::kInFrontOf) || says(senses, RelationType::kBehind);
  const bool has_it = owner != kNobody && (referent == owner || (owner >= 0 && referent == host_of(state, owner)));
  // … but "a fireplace with two chairs in front": of the fireplace.
  if (before && is_unsaid(noun) && subject >= 0 && referent == owner && stands(target) && stands(meant)) score += weight::kOwnHost;
  if (before && has_it && small && is_table(lexicon_.catalog(), meant)) score += weight::kBeforeHost;
  return score;
}

// How well what the phrase says of the subject fits the one that may be meant.
double Decoder::antecedent_place_score(const State& state, Referent referent, Referent subject, const PhraseSenses& senses,
                                       const NounPhrase* noun) const {
  const NounPhrase &target = noun_of(state, subject), &meant = noun_of(state, referent);
  const bool small = mount_of(target) == Mount::kSurface;
  double score = sense_.of_place(senses, target, meant) + each_score(noun, several(state, referent));
  const bool side = says(senses, RelationType::kLeftOf) || says(senses, RelationType::kRightOf);
  const bool lies = says(senses, &RelationTraits::rests);
  const Referent owner = subject >= 0 ? host_of(state, subject) : kNobody;
  if (subject >= 0 && referent == owner && side) score += weight::kOwnHost;
  // "holds a laptop, with a mug to its left": of what stands on the same thing.
  const bool fellow = subject >= 0 && referent >= 0 && owner != kNobody && referent != owner && host_of(state, referent) == owner &&
                      read_as(state, referent).predicate != read_as(state, subject).predicate;
  if (fellow && side && small && mount_of(meant) == Mount::kSurface) score += weight::kSideOfFellow;
  const bool its_top = is_it(noun) || is_unsaid(noun);  // "a cabinet beside the desk with a printer on top"
  if (subject >= 0 && referent == owner && !side && lies && its_top) score = own_top_score(score, *noun, meant, target);
  const bool sat_on = is_seat(lexicon_.catalog(), meant) || (meant.entry != nullptr && meant.entry->is(Trait::kEasySeat));
  if (subject >= 0 && referent != owner && lies && is_unsaid(noun) && sat_on) score += weight::kTopOfOtherSeat;
  if (subject >= 0 && referent != owner && owner != kNobody && read_as(state, subject).former >= 0 && lies && lists_on_it(subject))
    score += weight::kNoReference;
  if (says(senses, RelationType::kUnder) && is_it(noun)) score += below_seat_score(state, target, referent);
  // "a mirror with a shelf below it"
  const bool over = says(senses, RelationType::kAbove) || says(senses, RelationType::kUnder);
  const bool first = subject >= 0 && read_as(state, subject).former < 0;  // … "with a sink, a mirror above": above the sink
  if (subject >= 0 && referent == owner && over && (is_it(noun) || (is_unsaid(noun) && first))) score += weight::kOwnHost;
  // "a piano in the corner with a candelabra on it": the piano, whatever else carries candelabras
  if (subject >= 0 && referent == owner && is_it(noun) && !says(senses, RelationType::kEachSideOf) && comes_with_it(state, subject))
    score += weight::kOfWhatHas;
  // "four armchairs before the fire, each with a lamp behind it"
  const bool of_each = owner >= 0 && chunk(owner).noun.determiner == Determiner::kEach &&
                       (chunk(owner).noun.kind == NounKind::kMember || !target.is_plural());
  if (of_each && referent == owner && is_it(noun)) score += weight::kOnOwnHost;
  // "a cage with a parrot inside": in the cage.
  const bool inside = says(senses, RelationType::kIn) && is_unsaid(noun);
  if (subject >= 0 && referent == owner && inside) score += weight::kInOwnHost;
  return score + before_own_host_score(state, referent, subject, senses, noun) + standing_score(state, referent, subject, senses) +
         apart_score(state, referent, subject, senses);
}

// "A clock hangs above the bed": neither is beside the other then.
bool Decoder::is_over_or_under(const State& state, Referent one, Referent other) const {
  for (int p = 0; p < static_cast<int>(state.units.size()); ++p) {
    const UnitReading& place = read_as(state, p);
    if (!is(p, UnitKind::kPlace) || place.inverse || place.subject == kNobody) continue;
    const PhraseSenses& senses = place.alone ? alone_senses(p) : unit(p).direct;
    if (!says(senses, RelationType::kAbove) && !says(senses, RelationType::kUnder)) continue;
    const Referent by = place.alone ? place.implied : p + 1;
    const auto are = [&](Referent a, Referent b) { return same(state, place.subject, a) && same(state, by, b); };
    if (by != kNobody && (are(one, other) || are(other, one))) return true;
  }
  return false;
}

// … and nothing is beside what lies on it.
double Decoder::apart_score(const State& state, Referent referent, Referent subject, const PhraseSenses& senses) const {
  const bool side = says(senses, RelationType::kLeftOf) || says(senses, RelationType::kRightOf) || says(senses, RelationType::kNextTo);
  if (!side || referent == kNobody || subject == kNobody || !is_thing(state, referent)) return 0;
  bool carried = false;
  for (int u = 0; u < static_cast<int>(state.units.size()) && !carried && sense_.carries(noun_of(state, subject), noun_of(state, referent));
       ++u)
    carried =
        is(u, UnitKind::kNoun) && is_thing(state, host_of(state, u)) && same(state, u, referent) && same(state, host_of(state, u), subject);
  return carried || is_over_or_under(state, referent, subject) ? weight::kUnlikely : 0;
}

// A basket, a bin: on the floor, and neither a table nor a seat.
bool Decoder::is_low_and_small(const NounPhrase& noun) const {
  constexpr Mm kHigh = 600, kWide = 600;
  const Catalog& catalog = lexicon_.catalog();
  if (noun.entry == nullptr || mount_of(noun) != Mount::kFloor || is_table(catalog, noun) || is_seat(catalog, noun)) return false;
  const Size& size = noun.entry->size.usual;
  return size.height <= kHigh && size.width <= kWide && size.depth <= kWide && !noun.entry->thin;
}

// … by whether the two stand, lie or hang.
double Decoder::standing_score(const State& state, Referent referent, Referent subject, const PhraseSenses& senses) const {
  const NounPhrase &target = noun_of(state, subject), &meant = noun_of(state, referent);
  double score = 0;
  // "a statue on the floor beside it": beside what stands there, not what lies on a counter.
  const bool small = mount_of(target) == Mount::kSurface, lies = says(senses, &RelationTraits::rests);
  const bool laid_down = small && !lies && subject >= 0 && is_told_on_floor(state, subject);
  if (laid_down && meant.kind == NounKind::kObject)
    score += mount_of(meant) == Mount::kSurface ? weight::kNotBeside - weight::kSmallTogether : -weight::kNotBeside;
  score += by_small_score(state, target, referent, senses);
  score += before_other_score(state, target, referent, senses);
  // What lies on the floor or on something else is seldom what one places things by.
  // … but "a whiteboard on the wall, a desk to the right of it"
  const bool board = meant.entry != nullptr && meant.entry->is(Trait::kScreen) && mount_of(meant) == Mount::kWall;
  if (mount_of(target) == Mount::kFloor && !stands(meant)) score += board ? weight::kUsual : -0.8;
  // "A bar lies on the rack, and weights lean against it": against the rack
  if (mount_of(target) == Mount::kFloor && !lies && mount_of(meant) == Mount::kSurface && is_carried(state, referent))
    score += weight::kNotBeside;
  // "a stove, a basket beside it, a sofa across from it": nobody sits to look at a basket
  const bool looks = says(senses, RelationType::kOpposite) || says(senses, RelationType::kFacing);
  if (looks && is_seat(lexicon_.catalog(), target) && is_low_and_small(meant)) score += weight::kNotBeside;
  // "a television in the corner, a sofa opposite": seats look at screens
  const bool screen = meant.entry != nullptr && meant.entry->is(Trait::kScreen);
  if (looks && is_seat(lexicon_.catalog(), target) && screen) score += weight::kUsual;
  // "a sofa, over which a map hangs, …; a table in front of it": of the sofa.
  const bool before = says(senses, RelationType::kInFrontOf) || says(senses, RelationType::kBehind);
  const bool looked_into = meant.entry != nullptr && meant.entry->is(Trait::kMirror);
  if (before && mount_of(target) == Mount::kFloor && mount_of(meant) == Mount::kWall && !looked_into) score += weight::kNotBeside;
  return score;
}

// "a vase and, left of it, a bowl; in front of it two stools": of what carries them.
double Decoder::by_small_score(const State& state, const NounPhrase& target, Referent referent, const PhraseSenses& senses) const {
  const Catalog& catalog = lexicon_.catalog();
  const NounPhrase& meant = noun_of(state, referent);
  const bool great = mount_of(target) == Mount::kFloor ? is_seat(catalog, target) || is_table(catalog, target) || is_heavy(catalog, target)
                                                       : mount_of(target) == Mount::kWall && says(senses, RelationType::kBehind);
  const bool small = meant.kind == NounKind::kObject && mount_of(meant) == Mount::kSurface;
  return great && small && !says(senses, &RelationTraits::rests) && is_carried(state, referent) ? 2 * weight::kNotBeside : 0;
}

// "An armchair stands in front of the table, and a map hangs above it": over the table, which stands at the wall; "a chair behind the desk,
// two more in front": of the desk.
double Decoder::before_other_score(const State& state, const NounPhrase& target, Referent referent, const PhraseSenses& senses) const {
  const bool along = says(senses, RelationType::kInFrontOf) || says(senses, RelationType::kBehind);
  const bool over = mount_of(target) == Mount::kWall && (says(senses, RelationType::kAbove) || says(senses, RelationType::kBehind));
  const bool seats = along && is_seat(lexicon_.catalog(), target) && is_seat(lexicon_.catalog(), noun_of(state, referent));
  if (!over && !seats) return 0;
  for (int p = 0; p < static_cast<int>(state.units.size()); ++p) {
    const UnitReading& place = read_as(state, p);
    if (!is(p, UnitKind::kPlace) || place.inverse || place.alone || !same(state, place.subject, referent)) continue;
    const bool before = says(unit(p).direct, RelationType::kInFrontOf) || (seats && says(unit(p).direct, RelationType::kBehind));
    if (before && is_thing(state, p + 1)) return weight::kNotBeside;
  }
  return 0;
}

// It was said to lie on something, here or before.
bool Decoder::is_carried(const State& state, Referent referent) const {
  if (is_mention(referent)) {
    const auto mention = [&](int m) -> const Mention& { return document_.mentions[static_cast<std::size_t>(m)]; };
    const std::vector<int>& items = mention(mention_of(referent)).items;
    const auto is_it = [&](int target) { return mention(target).items == items; };
    return std::ranges::any_of(document_.links, [&](const Link& link) {
      const bool on_thing =
          std::ranges::any_of(link.references, [&](int by) { return !mention(by).items.empty(); });  // not "in the corner"
      const bool lies = on_thing && (link.kind == Link::Kind::kHave || says(link.senses, &RelationTraits::rests));
      return lies && std::ranges::any_of(link.targets, is_it);
    });
  }
  if (referent >= 0 && is_thing(state, host_of(state, referent))) return true;
  for (int p = 0; p < static_cast<int>(state.units.size()); ++p) {
    const UnitReading& place = read_as(state, p);
    if (!is(p, UnitKind::kPlace) || place.inverse || place.subject < 0) continue;
    const std::vector<int> all = list_of(state, place.subject, place.first_subject);
    if (!is_thing(state, place.alone ? place.implied : p + 1)) continue;
    if (says(place.alone ? alone_senses(p) : unit(p).direct, &RelationTraits::rests) && std::ranges::find(all, referent) != all.end())
      return true;
  }
  // "On the desk lie a pen and …"
  return referent >= 0 && std::ranges::any_of(state.fronted, [&](int p) {
           return read_as(state, p).subject == referent && says(alone_senses(p), &RelationTraits::rests);
         });
}

// "a statue on the floor"
bool Decoder::is_told_on_floor(const State& state, int subject) const {
  for (int u = subject + 1; u < static_cast<int>(state.units.size()); ++u) {
    if (!is(u, UnitKind::kNoun) || chunk(u).noun.kind != NounKind::kFloor) continue;
    const UnitReading& floor = read_as(state, u);
    if (floor.role == NounRole::kReference && floor.predicate >= 0 && read_as(state, floor.predicate).subject == subject) return true;
  }
  return false;
}

}  // namespace layoutbox::offline
