// What a thing may have: what comes with it, what lies or stands on it.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"

namespace layoutbox::offline {

// "six tables, each with four chairs, a bar and a sideboard": no table has a bar of its own. At desks and beds anything may stand.
bool Decoder::may_come_with(const NounPhrase& host, const NounPhrase& noun) const {
  // "a shelf with toys and a rug": a rug is under what one sits, lies or works at
  const bool rug = noun.entry != nullptr && noun.entry->thin && mount_of(noun) == Mount::kFloor;
  if (rug && is_storage(host)) return false;
  const bool works = host.entry != nullptr && (host.entry->is(Trait::kDesk) || host.entry->is(Trait::kDeskLike));
  if (!is_table(lexicon_.catalog(), host) || works || mount_of(noun) != Mount::kFloor) return true;
  return is_seat(lexicon_.catalog(), noun) || sense_.carries(host, noun) || (noun.entry != nullptr && noun.entry->thin);
}

// "a fireplace with a shelf on either side and a painting above": by the host as well.
bool Decoder::placed_by_unsaid(int u) const {
  return follows(u, UnitKind::kPlace) && !alone_senses(u + 1).empty() && !follows(u + 1, UnitKind::kNoun);
}

// "a piano with a candelabra on it", and nothing between.
bool Decoder::comes_with_it(const State& state, int u) const {
  const int predicate = read_as(state, u).predicate;
  const int former = read_as(state, u).former;
  if (!is(predicate, UnitKind::kHave) || word(predicate) != "with" || (former >= 0 && read_as(state, former).predicate == predicate))
    return false;
  return is(u + 1, UnitKind::kPlace) && unit(u + 1).joiner == Joiner::kNone && is(u + 2, UnitKind::kNoun) && chunk(u + 2).noun.head == "it";
}

// "with a cabinet under it", "with a lamp beside it": by the host, and not on it.
bool Decoder::placed_by_host(int u) const {
  return has_own_place(u) && chunk(u + 2).noun.head == "it" && !says(unit(u + 1).direct, &RelationTraits::rests);
}

// "each with a screen and a telephone on it and a chair behind it": by the host once more.
bool Decoder::placed_by_it(int u) const { return has_own_place(u) && chunk(u + 2).noun.head == "it" && unit(u).joiner == Joiner::kAnd; }

// A TV is on no coffee table.
bool Decoder::looked_at_elsewhere(const NounPhrase& host, const NounPhrase& noun) const {
  if (noun.entry == nullptr || !noun.exact || !noun.entry->is(Trait::kScreen) || host.entry == nullptr || !host.entry->is(Trait::kTable))
    return false;
  return std::ranges::none_of(noun.entry->stands_on,
                              [&](const std::string& kind) { return lexicon_.catalog().is_a(host.entry->id, kind); });
}

// "supporting", "carries", "holds": its things are on it. "With" and "has" leave that open.
bool Decoder::carries_list(int predicate) const {
  return shows_things(word(predicate)) || (is(predicate, UnitKind::kPlace) && says(unit(predicate).inverse, RelationType::kOn));
}

// Small enough for a top, though it may stand on the floor: a ring light, a basket.
bool Decoder::stands_small(const NounPhrase& noun) const {
  constexpr Mm kWide = 800;
  return noun.entry != nullptr && mount_of(noun) == Mount::kFloor && !is_seat(lexicon_.catalog(), noun) && !noun.entry->thin &&
         std::max(noun.entry->size.usual.width, noun.entry->size.usual.depth) <= kWide && !is_table(lexicon_.catalog(), noun);
}

// It may lie there, or stand there where it is small: "a chest with a plant on it".
bool Decoder::has_top_for(const NounPhrase& host, const NounPhrase& noun) const {
  return sense_.carries(host, noun) || (stands_small(noun) && mount_of(host) == Mount::kFloor && !is_lamp(lexicon_.catalog(), host));
}

// "with the press, the rack and the scale on it", "… on top": what such a list names, from the noun at u on, lies on its host, whatever it
// is.
bool Decoder::lists_on_it(int u) const {
  while (is(u + 1, UnitKind::kNoun) && unit(u + 1).joiner != Joiner::kNone && !unit(u + 1).clause) ++u;
  return follows(u, UnitKind::kPlace) && !follows(u + 1, UnitKind::kNoun) && says(unit(u + 1).alone, RelationType::kOn) &&
         one_of(document_.tokens[chunk(u + 1).last - 1].text, {"it", "top"});
}

// "A sofa with a TV opposite, a rug and a table between them": between those two, the rug as well.
bool Decoder::is_list_beside_pair(const State& state, Referent list, int subject) const {
  if (list < 0 || unit(subject).joiner != Joiner::kAnd || read_as(state, subject).former != list || read_as(state, list).placed)
    return false;
  for (int p = 0; p < list; ++p) {
    if (!is(p, UnitKind::kPlace)) continue;
    const UnitReading& place = read_as(state, p);
    const PhraseSenses& senses = place.alone ? alone_senses(p) : unit(p).direct;
    if (says(senses, RelationType::kOpposite) || says(senses, RelationType::kFacing)) return true;
  }
  return false;
}

// "On the left side two small tables.": what stands by itself, and goes with nothing.
bool Decoder::begins_with_side(int u) const {
  if (u > 0 || !follows(u, UnitKind::kNoun) || document_.tokens[chunk(u).last - 1].text != "side" || word(u) == "to") return false;
  const NounPhrase& noun = chunk(u + 1).noun;
  return noun.kind == NounKind::kObject && mount_of(noun) == Mount::kFloor && noun.entry != nullptr && noun.entry->beside.empty() &&
         !noun.entry->thin && !is_seat(lexicon_.catalog(), noun);
}

}  // namespace layoutbox::offline
