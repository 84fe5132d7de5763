// Which list a noun phrase goes on with: what the clause is about, what something has, or what a place is by.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

// "stand", "are": of several.
bool is_plural_verb(std::string_view word) { return !word.ends_with("s") && !word.ends_with("ed") && !word.ends_with("ing"); }

}  // namespace

bool Decoder::is_subject(int u) const { return verb_like(u + 1) && unit(u + 1).joiner == Joiner::kNone && !unit(u + 1).clause; }

// "…, and a basket and a paper lie on the table", "…, and a shelf beside the bed holds a clock": a clause of its own begins there.
bool Decoder::heads_subject(int u) const {
  if (unit(u).joiner != Joiner::kCommaAnd || !is_new_thing(chunk(u).noun)) return false;
  if (follows(u, UnitKind::kPlace) && follows(u + 1, UnitKind::kNoun))
    return follows(u + 2, UnitKind::kHave) && is_finite(word(u + 3)) && !chunk(u).noun.is_plural();
  return is(u + 1, UnitKind::kNoun) && unit(u + 1).joiner == Joiner::kAnd && !chunk(u).noun.is_plural() && is_subject(u + 1) &&
         !is_finite(word(u + 2)) && !chunk(u + 1).noun.is_plural();
}

// "On the rug stands a table carrying two books, a vase and a candle", "along the wall runs a counter that holds a sink, a cup and a jar":
// small things are on what carries such things there.
bool Decoder::strewn_past_host(const State& state, int place, int u) const {
  if (read_as(state, place).alone || !is(place + 1, UnitKind::kNoun) || mount_of(chunk(u).noun) != Mount::kSurface) return false;
  const NounPhrase& by = noun_of(state, place + 1);
  const bool rug = by.entry != nullptr && by.entry->thin;
  if (!rug && by.kind != NounKind::kWall && by.kind != NounKind::kCorner && by.kind != NounKind::kWindow) return false;
  for (int v = place + 2; v < u; ++v) {
    const Referent host = is(v, UnitKind::kNoun) && read_as(state, v).role == NounRole::kContent ? host_of(state, v) : kNobody;
    if (is_thing(state, host) && sense_.carries(noun_of(state, host), chunk(u).noun)) return true;
  }
  return false;
}

bool Decoder::has_place(int u) const {
  return follows(u, UnitKind::kPlace) || (follows(u, UnitKind::kParticiple) && follows(u + 1, UnitKind::kPlace));
}

void Decoder::list_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const bool unjoined = unit(u).joiner == Joiner::kNone && (is(u - 1, UnitKind::kNoun) || is(u - 1, UnitKind::kPlace));
  const double beside = unjoined ? weight::kNoJoiner : 0;
  const std::size_t n = state.frontier.size();
  for (std::size_t level = 0; level < n; ++level) {
    const int member = state.frontier[level];
    const UnitReading& reading = read_as(state, member);
    double gain = beside + weight::kTreeList * tree_.for_noun(u, member);
    if (level == 0) {
      root_list_actions(s, u, gain);
      continue;
    }
    if (reading.role == NounRole::kMember) continue;
    const bool content = reading.role == NounRole::kContent;
    for (std::size_t f = level + 1; f < n; ++f)
      gain += read_as(state, state.frontier[f]).role == NounRole::kContent ? weight::kNearerList : 0;
    gain += content ? content_list_score(state, member, u) : reference_list_score(state, member, u);
    if (is_subject(u) && content && unit(u).joiner == Joiner::kAnd && is_finite(word(u + 1)) != chunk(u).noun.is_plural()) gain -= 2;
    if (gain > -5) add(s, kSameList, gain, member);
  }
}

// "Opposite the door a glass case, a lamp above the case": what stands by a thing of the clause is not itself opposite the door.
bool Decoder::placed_by_clause(const State& state, int u) const {
  const int by = follows(u, UnitKind::kParticiple) ? u + 3 : u + 2;
  const bool carried = std::any_of(state.fronted.begin(), state.fronted.end(), [&](int place) {
    if (!is_thing(state, read_as(state, place).alone ? read_as(state, place).implied : place + 1)) return false;
    const PhraseSenses& senses = read_as(state, place).alone ? alone_senses(place) : unit(place).direct;
    return says(senses, &RelationTraits::rests);
  });
  if (state.fronted.empty() || carried || !is(by, UnitKind::kNoun) || state.frontier.empty()) return false;
  const NounPhrase& noun = chunk(by).noun;
  if (noun.kind == NounKind::kPronoun && !noun.reciprocal) return true;
  if (noun.of && noun.of->kind == NounKind::kPronoun) return true;  // "at its center"
  for (int m = state.frontier.front(); m >= 0; m = read_as(state, m).former) {
    if (same(state, by, m)) return true;
  }
  return false;
}

// The list of the clause's own things, none of which "and" has joined yet: how many they are; 0 where it is over.
int Decoder::open_list(const State& state) const {
  int length = 0;
  for (int m = state.frontier.front(); m >= 0; m = read_as(state, m).former) {
    if (read_as(state, m).former >= 0 && unit(m).joiner != Joiner::kComma) return 0;
    length += is_thing(state, m) ? 1 : 0;  // "Coffee shop, 50 m2: counter with …"
  }
  return length;
}

// "a bed, a table with two chairs and a wardrobe": "and" ends the clause's list, which nothing has ended yet. "bed, table with four chairs,
// wardrobe": after seats a comma goes on with it.
bool Decoder::goes_on_with_clause(const State& state, int u) const {
  const int content = state.frontier.back();
  const Referent host = host_of(state, content);
  if (state.frontier.size() < 2 || state.verb || !is_thing(state, host) || open_list(state) < 2) return false;
  const NounPhrase &noun = chunk(u).noun, &former = noun_of(state, content), &owner = noun_of(state, host);
  if (noun.kind != NounKind::kObject || mount_of(owner) != Mount::kFloor || is_seat(lexicon_.catalog(), noun)) return false;
  const bool seats = one_sits_at(lexicon_.catalog(), owner) && is_seat(lexicon_.catalog(), former);
  if (unit(u).joiner == Joiner::kComma) return seats;
  if (unit(u).joiner != Joiner::kAnd) return false;
  for (int v = u + 1; v < static_cast<int>(sentence_.size()) && !unit(v).clause; ++v) {
    if (is(v, UnitKind::kNoun) && unit(v).joiner != Joiner::kNone) return false;  // it is not the last
  }
  const auto known = [](const NounPhrase& n) { return n.determiner == Determiner::kDefinite || n.determiner == Determiner::kPossessive; };
  int first = state.frontier.front();
  while (read_as(state, first).former >= 0) first = read_as(state, first).former;
  return mount_of(noun) == Mount::kFloor || (known(noun) && known(noun_of(state, first)));
}

// "chairs, a counter, a table with magazines, fish tank, coat rack": no "and" ends what the table has, so the tank is of the clause's list.
bool Decoder::never_closes(const State& state, int u) const {
  constexpr Mm kGreat = 450;  // what is smaller may well be one more of what lies there
  const NounPhrase& noun = chunk(u).noun;
  if (unit(u).joiner != Joiner::kComma || open_list(state) < 2 || noun.entry == nullptr || noun.entry->size.usual.width < kGreat)
    return false;
  for (int v = u + 1; v < static_cast<int>(sentence_.size()) && !unit(v).clause; ++v) {
    if (is(v, UnitKind::kNoun) && unit(v).joiner != Joiner::kNone && unit(v).joiner != Joiner::kComma) return false;
  }
  return true;
}

// "On the desk a lamp at the left side, a clock in the middle": parts of the top that the clause begins with.
bool Decoder::on_part_of_top(const State& state, int u) const {
  const int place = state.fronted.empty() ? -1 : state.fronted.front();
  if (place < 0 || read_as(state, place).alone || !says(unit(place).direct, RelationType::kOn) || !is_thing(state, place + 1)) return false;
  if (!follows(u, UnitKind::kPlace) || follows(u + 1, UnitKind::kNoun)) return false;
  const PhraseSenses& senses = alone_senses(u + 1);
  return says(senses, RelationType::kCenterOfRoom) || says(senses, RelationType::kLeftOf) || says(senses, RelationType::kRightOf);
}

// "sits under the window and holds a monitor and a tower": nothing is said of the tower by itself.
double Decoder::told_nothing(int u) const {
  const bool more = u + 1 < static_cast<int>(sentence_.size()) && !is(u + 1, UnitKind::kNoun);
  return unit(u).joiner != Joiner::kAnd || more ? 0 : weight::kNothingTold;
}

// How well the noun at u suits the places that the clause begins with.
double Decoder::fronted_score(const State& state, int u) const {
  double score = 0;
  for (const int place : state.fronted)
    score += reference_score(state, place, u) + (strewn_past_host(state, place, u) ? weight::kSmallByPlace : 0);
  return score;
}

// What speaks against sharing a place that came first, for a noun that has one of its own.
double Decoder::own_place_score(int u) const {
  const bool says_whose = chunk(u).noun.determiner == Determiner::kPossessive && word(u) == "its";  // "…, its stool in front"
  return weight::kOwnPlace * (unit(u).joiner == Joiner::kComma || says_whose ? 2 : 1) + (says_whose ? weight::kItsOwnPlace : 0);
}

// With what the clause is about, or a clause of its own; `gain`: what speaks for either.
void Decoder::root_list_actions(std::size_t s, int u, double gain) {
  const State& state = states_[s];
  const NounPhrase& noun = chunk(u).noun;
  const bool subject = is_subject(u) || heads_subject(u), placed = has_place(u);
  const bool of_clause = !state.verb || state.imperative;
  // "books and newspapers lines the wall": not the newspapers.
  const bool disagrees = subject && noun.is_plural() && (is_finite(word(u + 1)) || word(u + 1) == "is" || word(u + 1) == "was");
  gain += disagrees ? weight::kDisagrees : subject ? weight::kSubjectFollows : placed ? weight::kPlaceFollows : 0;
  const double share = fronted_score(state, u);
  // "On the table a mug and a pad lie beside a clock": a plural verb of one thing speaks of the list.
  // "on which a vase and two cups stand": what came first has no other verb.
  const bool agrees =
      is_subject(u) && unit(u).joiner == Joiner::kAnd && is_plural_verb(word(u + 1)) && (!noun.is_plural() || !state.fronted.empty());
  // "on it tongs, three daggers and a horseshoe": what ends the list of a place that came first and has none of its own.
  const bool ends = !state.fronted.empty() && unit(u).joiner == Joiner::kAnd && !subject && !placed && is_new_thing(noun) &&
                    (u + 1 >= static_cast<int>(sentence_.size()) || (!is(u + 1, UnitKind::kHave) && unit(u + 1).joiner != Joiner::kNone));
  if (of_clause && (state.fronted.empty() || !subject || agrees)) {
    const double elsewhere = placed && placed_by_clause(state, u) ? weight::kPlacedByList : 0;
    const bool own_place =
        placed && !state.fronted.empty() && !(share > 0 && mount_of(noun) == Mount::kSurface) && !(share >= 0 && on_part_of_top(state, u));
    add(s, kNextRoot,
        gain + (agrees && !state.fronted.empty() ? weight::kAgrees : 0) + std::max(share, ends ? weight::kEndsList : -2.5) +
            (own_place ? own_place_score(u) : 0) + elsewhere,
        state.frontier.front());
  }
  const double untold = of_clause || subject || placed ? 0 : told_nothing(u);
  if (!of_clause || !state.fronted.empty())
    add(s, kNewRoot, gain + untold - (state.fronted.empty() ? 0 : 0.4) + (ends ? weight::kEndsList : 0));
}

// "… and a lamp beside the bed": the place is its own.
bool Decoder::has_own_place(int u) const {
  return follows(u, UnitKind::kPlace) && !unit(u + 1).direct.empty() && follows(u + 1, UnitKind::kNoun) && !chunk(u + 2).noun.reciprocal;
}

// "next to the bed and the desk"
double Decoder::reference_list_score(const State& state, int member, int u) const {
  const UnitReading& reading = read_as(state, member);
  const NounPhrase &noun = chunk(u).noun, &former = chunk(member).noun;
  const int place = reading.predicate;
  const Joiner joiner = unit(u).joiner;
  const bool next_to_it = member + 1 == u;
  const bool between = place >= 0 && says(unit(place).direct, RelationType::kBetween);
  const std::size_t first = chunk(u).first;
  const bool from = first > 0 && document_.tokens[first - 1].text == "from";  // "parts the lockers from the showers"
  if (between && (from || chunk(place).gap || !former.is_plural()) && reading.former < 0 && next_to_it && joiner == Joiner::kAnd) return 8;
  if (joiner != Joiner::kAnd || between || !next_to_it) return -6;
  const auto definite = [](const NounPhrase& n) {
    return n.determiner == Determiner::kDefinite || n.determiner == Determiner::kEach || n.determiner == Determiner::kBoth ||
           n.determiner == Determiner::kPossessive;
  };
  // "along the left and right walls"
  const bool walls = noun.kind == NounKind::kWall && !noun.wall_word.empty() && noun.wall_word != former.wall_word;
  if (walls && former.kind == NounKind::kWall && !former.wall_word.empty()) return 5;
  const bool acts = noun.kind == NounKind::kMember && follows(u, UnitKind::kPlace) && finite_place(u + 1);  // "… and another faces it"
  if (acts) return -6;
  if (former.kind != NounKind::kObject || noun.kind != NounKind::kObject)
    return noun.kind == former.kind && noun.kind != NounKind::kRoom ? 1.5 : -6;
  double score = definite(former) == definite(noun) ? 0.5 : -3;
  if (definite(former) && definite(noun)) score += 1.2;
  if (!definite(noun)) score += 0.4;
  if (follows(u, UnitKind::kPlace) || follows(u, UnitKind::kHave) || follows(u, UnitKind::kParticiple) || follows(u, UnitKind::kVerb))
    score -= 2;
  const UnitReading& of = read_as(state, place);
  if (of.fronted) score += 2;
  if (!of.fronted && is_thing(state, of.subject))
    score += std::min(0.3, sense_.of_place(unit(place).direct, noun_of(state, of.subject), noun));
  return score;
}

}  // namespace layoutbox::offline
