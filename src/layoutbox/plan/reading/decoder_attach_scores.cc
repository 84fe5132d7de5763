// How well a place or a having suits the thing that it may be said of.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

// How likely it is that a place (having …) at u speaks of the thing at that level of the frontier.
double Decoder::attach_score(const State& state, int u, int level, bool inverse) const {
  const int member = state.frontier[static_cast<std::size_t>(level)];
  double score = weight::kTree * tree_.for_noun(u, member);
  int nearer = 0;
  for (std::size_t f = static_cast<std::size_t>(level) + 1; f < state.frontier.size(); ++f)
    nearer += is_thing(state, state.frontier[f]) ? 1 : 0;
  int steps = 0;
  for (int f = 0; f < level; ++f) steps += is_thing(state, state.frontier[static_cast<std::size_t>(f)]) ? 1 : 0;
  const bool again = state.place >= 0 && read_as(state, state.place).subject == member;
  switch (unit(u).joiner) {
    case Joiner::kNone: score += weight::kLevel * nearer; break;
    case Joiner::kAnd: score += weight::kLevelAfterComma * steps + (again ? weight::kSameSubject : 0); break;
    default: score += weight::kLevelAfterComma * steps + (again ? 0.3 : 0); break;
  }
  // "in the corner by the door": the second place is of the same thing.
  if (again && unit(u).joiner == Joiner::kNone && nearer == 0) score += weight::kSameSubject;
  score += parallel_score(state, u, member);
  if (steps > 0 && is_aside_of(state, u, member)) score += weight::kTopOfClause;
  // "turned towards a cello on its stand": the cello's
  if (nearer == 0 && unit(u).joiner == Joiner::kNone && names_own_carrier(u)) score += weight::kOwnCarrier;
  if (level > 0 && finite_place(u)) score += finite_score(state, u, member, steps);
  if (word(u) == "from" && level > 0) score += weight::kFromRoot;
  if (!inverse) score += likely_place_score(state, u, member);
  if (!is_definite(state, member)) return score;
  if (inverse) return score + (is_thing(state, member) ? weight::kKnownHost : weight::kPlaceAsHost);
  if (member + 1 == u && unit(u).joiner == Joiner::kNone && is_one_of_several(member)) return score + weight::kTellsWhich;
  score += is_known(state, member) ? weight::kKnownSubject : weight::kDefiniteSubject;
  return score;
}

// … by where such a thing can be: what hangs or lies somewhere already does not do so twice.
double Decoder::likely_place_score(const State& state, int u, int member) const {
  double score = 0;
  if (hangs_twice(state, u, member)) score += weight::kPlacedTwice;
  if (lies_twice(state, u, member)) score += weight::kLiesTwice;
  if (stands_otherwise(state, u, member) || stands_in_middle(state, u, member)) score += weight::kLiesTwice;
  if (lies_on_unplaced(state, u, member)) score += weight::kSmallByPlace;
  if (is_led_to_wall(state, u, member)) score += (read_as(state, member).former >= 0 ? 2 : 1) * weight::kSmallByPlace;
  return score;
}

// "flanked by a cart, stocked with a bucket, and (flanked) by a stand": told of the cart by the way, as the clause goes on in the same
// words.
bool Decoder::is_aside_of(const State& state, int u, int member) const {
  constexpr int kAhead = 8;  // units
  const int place = read_as(state, member).predicate;
  if (unit(u).joiner != Joiner::kComma || place < 0 || !is(place, UnitKind::kPlace)) return false;
  const auto preposition = [&](int p) { return std::string_view(document_.tokens[chunk(p).last - 1].text); };
  for (int v = u + 1; v <= u + kAhead && v < static_cast<int>(sentence_.size()) && !is(v, UnitKind::kVerb); ++v) {
    const bool joined = unit(v).joiner == Joiner::kAnd || unit(v).joiner == Joiner::kCommaAnd;
    if (joined && is(v, UnitKind::kPlace) && !unit(v).inverse.empty() && preposition(v) == preposition(place)) return true;
  }
  return false;
}

// A finite verb that is a place, of another thing than the clause's own, so many steps away from that.
double Decoder::finite_score(const State& state, int u, int member, int steps) const {
  const std::optional<double> retold = member == state.told ? retold_score(state, u) : std::nullopt;
  if (retold) return *retold - weight::kLevelAfterComma * steps;
  // "three chairs each face a mirror"
  const bool floats = member + 1 == u && chunk(member).noun.kind == NounKind::kMember && chunk(member).noun.determiner == Determiner::kEach;
  return floats ? -weight::kFiniteRoot : weight::kFiniteRoot;
}

// "on its stand"
bool Decoder::names_own_carrier(int u) const {
  if (!is(u, UnitKind::kPlace) || !follows(u, UnitKind::kNoun) || !says(unit(u).direct, &RelationTraits::rests)) return false;
  const NounPhrase& noun = chunk(u + 1).noun;
  return noun.kind == NounKind::kObject && noun.determiner == Determiner::kPossessive && word(u + 1) == "its";
}

// "two urns on its left half, a tray with six cups on its right half": of what is named as the first was, the tray and not its cups.
double Decoder::parallel_score(const State& state, int u, int member) const {
  const auto side_of = [&](int place) -> std::string {
    const PhraseSenses& senses = alone_senses(place);
    if (says(senses, RelationType::kLeftOf)) return "left";
    if (says(senses, RelationType::kRightOf)) return "right";
    if (chunk(place).phrase.one || chunk(place).phrase.other) return chunk(place).phrase.one ? "one" : "other";
    const bool part = follows(place, UnitKind::kNoun) && chunk(place + 1).noun.kind == NounKind::kPart;
    return part ? chunk(place + 1).noun.wall_word : std::string{};
  };
  const std::string side = side_of(u);
  // … where something that it has is nearer
  const bool has_nearer = !state.frontier.empty() && host_of(state, state.frontier.back()) == member;
  if (side.empty() || !is_thing(state, member) || !has_nearer) return 0;
  for (int p = u; p-- > 0 && !unit(p + 1).clause;) {
    const UnitReading& place = read_as(state, p);
    if (!is(p, UnitKind::kPlace) || place.fronted || place.subject < 0 || side_of(p).empty() || side_of(p) == side) continue;
    if (place.subject == member) return 0;
    return read_as(state, place.subject).role == read_as(state, member).role ? weight::kParallel : 0;
  }
  return 0;
}

// "a poster hangs on the wall, with a dispenser fixed to the wall": the poster hangs there already.
bool Decoder::hangs_twice(const State& state, int u, int member) const {
  const auto at_wall = [&](int place) {
    return is(place, UnitKind::kPlace) && says(unit(place).direct, RelationType::kOnWall) && is(place + 1, UnitKind::kNoun) &&
           chunk(place + 1).noun.kind == NounKind::kWall;
  };
  if (!at_wall(u)) return false;
  for (int before = member + 1; before < u; ++before) {
    if (at_wall(before) && read_as(state, before).subject == member) return true;
  }
  return false;
}

// "On the desk stands a bust, on the table an urn": the bust lies there already.
bool Decoder::lies_twice(const State& state, int u, int member) const {
  const auto on_thing = [&](int place) {
    return is(place, UnitKind::kPlace) && says(unit(place).direct, &RelationTraits::rests) && is(place + 1, UnitKind::kNoun) &&
           unit(place + 1).joiner == Joiner::kNone;
  };
  if (!on_thing(u) || unit(u).joiner == Joiner::kNone || chunk(u + 1).noun.kind == NounKind::kPronoun) return false;
  for (int before = 0; before < u; ++before) {
    const UnitReading& place = read_as(state, before);
    if (on_thing(before) && place.subject == member && !place.inverse && !place.alone && is_thing(state, before + 1)) return true;
  }
  return false;
}

// "with a stool holding a candle and a book beside it": the stool has no place yet, and the book has one.
bool Decoder::lies_on_unplaced(const State& state, int u, int member) const {
  const Referent host = host_of(state, member);
  if (!follows(u, UnitKind::kNoun) || chunk(u + 1).noun.head != "it" || unit(u).joiner != Joiner::kNone || !is_thing(state, host))
    return false;
  if (host < 0 || is_placed_apart(state, host) || read_as(state, host).role != NounRole::kContent) return false;
  return carries_list(read_as(state, member).predicate) && mount_of(noun_of(state, member)) == Mount::kSurface &&
         mount_of(noun_of(state, host)) == Mount::kFloor && !says(unit(u).direct, &RelationTraits::rests);
}

// "a fireplace with a cauldron on the east wall", "an armchair with a footstool near the window": what has the other stands there, unless
// that one hangs.
bool Decoder::is_led_to_wall(const State& state, int u, int member) const {
  const Referent host = host_of(state, member);
  if (unit(u).joiner != Joiner::kNone || !follows(u, UnitKind::kNoun)) return false;
  const NounKind where = chunk(u + 1).noun.kind;
  if (where != NounKind::kWall && where != NounKind::kCorner && where != NounKind::kWindow && where != NounKind::kDoor) return false;
  if (!is_thing(state, host) || is_placed_apart(state, host)) return false;
  if (where == NounKind::kCorner && several(state, host)) return false;  // "two armchairs with a table in the corner"
  return mount_of(noun_of(state, host)) == Mount::kFloor &&
         (where == NounKind::kCorner || mount_of(noun_of(state, member)) != Mount::kWall);
}

// "two bookshelves … the bookshelf nearest the door": what follows says which.
bool Decoder::is_one_of_several(int u) const {
  const NounPhrase& noun = chunk(u).noun;
  if (noun.kind != NounKind::kObject || noun.determiner != Determiner::kDefinite || noun.is_plural()) return false;
  for (int before = 0; before < u; ++before) {
    if (is(before, UnitKind::kNoun) && chunk(before).noun.kind == NounKind::kObject && chunk(before).noun.is_plural() &&
        chunk(before).noun.name == noun.name)
      return true;
  }
  return false;
}

// "Next to the sofa there is a rack, and opposite the sofa …": the rack stands beside it already.
bool Decoder::stands_otherwise(const State& state, int u, int member) const {
  const auto away = [](const PhraseSenses& senses) { return says(senses, RelationType::kOpposite) || says(senses, RelationType::kFar); };
  const auto close = [](const PhraseSenses& senses) { return says(senses, RelationType::kNextTo) || says(senses, RelationType::kNear); };
  if (!is(u, UnitKind::kPlace) || !follows(u, UnitKind::kNoun) || unit(u).joiner == Joiner::kNone) return false;
  const bool far = away(unit(u).direct);
  if (far == close(unit(u).direct)) return false;
  for (int before = 0; before < u; ++before) {
    const UnitReading& place = read_as(state, before);
    if (!is(before, UnitKind::kPlace) || place.inverse || place.alone || place.subject != member || !is(before + 1, UnitKind::kNoun))
      continue;
    if ((far ? close(unit(before).direct) : away(unit(before).direct)) && same(state, before + 1, u + 1)) return true;
  }
  return false;
}

// "An island in the middle with stools, an oven and a hob along the back wall": the island is no longer meant. "A bed in the middle, along
// the back wall" is one place.
bool Decoder::stands_in_middle(const State& state, int u, int member) const {
  if (!is(u, UnitKind::kPlace) || !says(unit(u).direct, RelationType::kAgainstWall) || !follows(u, UnitKind::kNoun) ||
      chunk(u + 1).noun.kind != NounKind::kWall)
    return false;
  int things = 0;
  for (int before = u - 1; before > member; --before) {
    if (is(before, UnitKind::kNoun) && is_thing(state, before)) ++things;
    const bool middle = is(before, UnitKind::kPlace) &&
                        (says(unit(before).direct, RelationType::kCenterOfRoom) || says(unit(before).alone, RelationType::kCenterOfRoom));
    if (middle && read_as(state, before).subject == member) return things > 0;
  }
  return false;
}

}  // namespace layoutbox::offline
