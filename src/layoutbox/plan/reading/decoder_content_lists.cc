// Lists of what something has: "a shelf with books, a lamp and a vase", and where such a list ends.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

bool shares_article(const NounPhrase& noun, const NounPhrase& former) {
  return noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && former.determiner != Determiner::kNone;
}

}  // namespace

// "a mirror, a shelf with blocks and blankets by the entrance": small things are on the shelf that is there.
bool Decoder::lies_on_placed(int u, const NounPhrase& host) const {
  const NounPhrase& noun = chunk(u).noun;
  const bool by_room = has_own_place(u) && follows(u, UnitKind::kPlace) && is(u + 2, UnitKind::kNoun) && is_part_of_room(chunk(u + 2).noun);
  const bool laid = is_storage(host) || is_table(lexicon_.catalog(), host);
  return by_room && laid && mount_of(noun) == Mount::kSurface && sense_.carries(host, noun);
}

// Whether what somebody has ends before the noun at u. "each desk with monitor, keyboard, chair": every one has all of them.
double Decoder::closing_score(const State& state, int u, Referent owner, const NounPhrase& host) const {
  if (goes_on_with_clause(state, u)) return weight::kClosesList;
  const bool of_each = owner >= 0 && chunk(owner).noun.determiner == Determiner::kEach;
  const bool seat = one_sits_at(lexicon_.catalog(), host) && is_seat(lexicon_.catalog(), chunk(u).noun);
  return !of_each && !seat && never_closes(state, u) ? weight::kNeverCloses : 0;
}

// "a sofa with a rug in front of it, TV and console on the right wall": not the sofa's
bool Decoder::goes_on_apart(const NounPhrase& host, const NounPhrase& noun, Joiner joiner) const {
  return mount_of(noun) == Mount::kFloor || (joiner == Joiner::kComma && is_seat(lexicon_.catalog(), host));
}

// "a fireplace flanked by bookcases and a sofa flanked by lamps": what has the same said of it is another thing of its kind.
bool Decoder::told_alike(int predicate, int u) const {
  const int place = follows(u, UnitKind::kParticiple) ? u + 2 : u + 1;
  return is(predicate, UnitKind::kPlace) && is(place, UnitKind::kPlace) && unit(place).joiner == Joiner::kNone &&
         !unit(place).inverse.empty() && word(place) == word(predicate);
}

// "a desk with a lamp and a clock": the clock is the desk's as well.
double Decoder::content_list_score(const State& state, int member, int u) const {
  const UnitReading& reading = read_as(state, member);
  const NounPhrase &noun = chunk(u).noun, &former = noun_of(state, member);
  const int predicate = reading.predicate;
  const Referent owner = read_as(state, predicate).subject;
  const NounPhrase& host = noun_of(state, owner);
  const Joiner joiner = unit(u).joiner;
  if (noun.kind != NounKind::kObject && noun.kind != NounKind::kAbstract && noun.kind != NounKind::kPart && noun.kind != NounKind::kMember)
    return -4;
  // "three desks, each with a chair, one printer for all": no desk's own
  const std::size_t end = chunk(u).last;
  if (end + 1 < document_.tokens.size() && document_.tokens[end].text == "for" &&
      one_of(document_.tokens[end + 1].text, {"all", "everyone", "everybody", "both"}))
    return -6;
  if (is_common(noun)) return -6;
  double score = closing_score(state, u, owner, host);
  bool ended = false;
  std::size_t length = 0;
  const bool apart = reading.placed && owner >= 0 && chunk(owner).noun.determiner == Determiner::kEach && placed_by_it(u);
  for (int m = member; m >= 0 && !apart; m = read_as(state, m).former, ++length) {
    ended |= unit(m).joiner == Joiner::kAnd || unit(m).joiner == Joiner::kCommaAnd;
  }
  if (ended) score += weight::kListEnded;
  if (joiner == Joiner::kAnd) score += weight::kBareAnd;
  if (joiner == Joiner::kCommaAnd) score += length > 1 ? 0.6 : -1.2;
  if (shares_article(noun, former)) score += joiner == Joiner::kAnd ? weight::kShareArticle : 0;
  const bool inverse = read_as(state, predicate).inverse;
  if (told_alike(predicate, u)) score += weight::kListEnded;
  if (reading.placed && !inverse && !apart && goes_on_apart(host, noun, joiner)) score -= 2;
  if (noun.determiner == Determiner::kDefinite) score -= 1.5;
  if (owner == kNobody || host.kind != NounKind::kObject) return score + (host.kind == NounKind::kWall ? 0.5 : 0);
  score += list_kind_score(state, member, u, length);
  const bool trails = unit(predicate).joiner != Joiner::kNone && !carries_list(predicate);
  if (trails && mount_of(noun) == Mount::kFloor && !inverse) score -= 2;  // ", with …"
  if (has_own_place(u) && !apart) score -= !sense_.carries(host, noun) ? 1.6 : joiner == Joiner::kAnd ? 0.6 : 1.4;
  if (joiner == Joiner::kAnd && lies_on_placed(u, host)) score -= weight::kSmallByPlace;
  score += each_has_score(state, member, u, owner);
  if (host.entry != nullptr && host.entry->thin) score -= 3;
  return score;
}

// "each with a bed, a chair and a lamp": every one has all of them; but "three bowls, each with a spoon next to it, and a bottle": one
// bottle.
double Decoder::each_has_score(const State& state, int member, int u, Referent owner) const {
  if (owner < 0 || chunk(owner).noun.determiner != Determiner::kEach) return 0;
  const bool goes_on = read_as(state, member).placed && unit(u).joiner == Joiner::kCommaAnd && unit(owner).joiner == Joiner::kComma;
  return may_come_with(noun_of(state, owner), chunk(u).noun) && !goes_on ? weight::kEachHas : weight::kNotWithEach;
}

// "armchair, side table with a lamp, waste basket": what has no article goes on with the list outside.
bool Decoder::is_outer_item(int u, const NounPhrase& former) const {
  const NounPhrase& noun = chunk(u).noun;
  return unit(u).joiner == Joiner::kComma && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural &&
         former.determiner == Determiner::kIndefinite && mount_of(noun) == Mount::kFloor;
}

// "bears a till, a jar and a mannequin": the last of the objects of such a verb.
bool Decoder::ends_objects(int predicate, int u) const {
  const Joiner joiner = unit(u).joiner;
  return carries_list(predicate) && is_finite(word(predicate)) && joiner != Joiner::kComma && !has_own_place(u) &&
         !follows(u, UnitKind::kVerb) && !follows(u, UnitKind::kHave) && !follows(u, UnitKind::kParticiple);
}

// How well it goes with the list, by what such things do: lie on the host, stand at it.
double Decoder::list_kind_score(const State& state, int member, int u, std::size_t length) const {
  const UnitReading& reading = read_as(state, member);
  const int predicate = reading.predicate;
  const NounPhrase &noun = chunk(u).noun, &former = noun_of(state, member), &host = noun_of(state, read_as(state, predicate).subject);
  const Joiner joiner = unit(u).joiner;
  if (lists_on_it(u) && !is_seat(lexicon_.catalog(), noun) && !is_seat(lexicon_.catalog(), former)) return weight::kCarriedToo;
  if (is_outer_item(u, former)) return weight::kStandsByItself;
  // What a table is surrounded by does not lie on it.
  const bool around =
      read_as(state, predicate).inverse && !carries_list(predicate) && mount_of(former) == Mount::kFloor && mount_of(noun) != Mount::kFloor;
  const bool carried = !around && sense_.carries(host, noun) && !looked_at_elsewhere(host, noun) &&
                       !(sense_.on_soft(host, noun) && has_own_place(u)),
             before = sense_.carries(host, former);
  if (carried && (before || mount_of(noun) == Mount::kSurface))
    return mount_of(noun) == Mount::kFloor && mount_of(former) != Mount::kFloor ? 0.2 : weight::kCarriedToo;
  if (one_sits_at(lexicon_.catalog(), host) && is_seat(lexicon_.catalog(), noun)) {
    if (one_of(noun.head, WordSet::kHeavySeats)) return weight::kNotCarried;
    return (joiner == Joiner::kAnd || (joiner == Joiner::kCommaAnd && length > 1)) && !has_own_place(u) ? 0.6 : -0.6;
  }
  if (is_new_thing(noun) && !may_come_with(host, noun) && !has_own_place(u)) return weight::kNotWithEach;
  if (joiner == Joiner::kAnd && reading.placed && placed_by_unsaid(u)) return weight::kPlacedByHost;
  const bool differ = mount_of(noun) != mount_of(former) || (before && !read_as(state, predicate).inverse);
  // "stores four cans and a coiled hose": what one verb says of both
  const bool one_verb = joiner == Joiner::kAnd && is(predicate, UnitKind::kHave) && is_finite(word(predicate)) && !has_own_place(u);
  if (differ && one_verb && is_storage(host)) return 0;
  // "supporting a monitor, a ring light, and a microphone": what one carrying word says of a list is said of what may stand on the floor
  // too.
  if (carries_list(predicate) && !has_own_place(u) && (carried || stands_small(noun))) return carried ? weight::kCarriedToo : 0.6;
  // "bears a till, a jar and a mannequin": what ends the objects of a verb is one of them, whatever such things stand on elsewhere.
  const bool object = ends_objects(predicate, u);
  if (object && before) return 0.6;
  if (differ && mount_of(noun) == Mount::kFloor && !carried) return weight::kStandsByItself;
  if (differ) return weight::kNotCarried;
  return joiner == Joiner::kComma ? -1.2 : 0;
}

}  // namespace layoutbox::offline
