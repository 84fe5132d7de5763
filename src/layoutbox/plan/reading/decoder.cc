#include "layoutbox/plan/reading/decoder.h"

#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

namespace {

// "the box" is the toy box that was named.
bool names_same(const NounPhrase& one, const NounPhrase& other, bool one_definite, bool other_definite) {
  if (!one.items.empty() && !other.items.empty()) return one.items == other.items;
  if (one.kind != NounKind::kObject || other.kind != NounKind::kObject || one.wall_word != other.wall_word) return false;
  if (!one.owner_word.empty() && !other.owner_word.empty() && one.owner_word != other.owner_word) return false;
  const auto ends = [](const std::string& name, const std::string& word) { return name == word || name.ends_with(" " + word); };
  return (one_definite && ends(other.name, one.name)) || (other_definite && ends(one.name, other.name));
}

// "the lid of a chest": brings the chest in.
bool brings_owner(const NounPhrase& noun) {
  return noun.kind == NounKind::kPart && noun.of && noun.of->kind == NounKind::kObject && noun.of->determiner == Determiner::kIndefinite;
}

constexpr std::size_t kBeam = 12;
constexpr double kWorthKeeping = 9;  // behind the best

}  // namespace

SentenceReading Decoder::run() {
  State start;
  start.units.resize(sentence_.size());
  states_.assign(1, start);
  for (int u = 0; u < static_cast<int>(sentence_.size()); ++u) {
    actions_.clear();
    for (State& state : states_) {
      if (!unit(u).clause) continue;
      const int where = unit(u).where && !state.frontier.empty() ? state.frontier.back() : -1;
      begin_clause(state);
      state.room_list = false;
      state.where = where;
    }
    for (std::size_t s = 0; s < states_.size(); ++s) {
      switch (unit(u).kind) {
        case UnitKind::kNoun: noun_actions(s, u); break;
        case UnitKind::kPlace: place_actions(s, u); break;
        case UnitKind::kHave: have_actions(s, u); break;
        case UnitKind::kVerb: verb_actions(s, u); break;
        case UnitKind::kRelative: relative_actions(s, u); break;
        default: add(s, kPass, 0); break;
      }
    }
    std::stable_sort(actions_.begin(), actions_.end(), [](const Action& a, const Action& b) { return a.score > b.score; });
    std::vector<State> survivors;
    for (const Action& action : actions_) {
      if (survivors.size() >= kBeam || action.score < actions_.front().score - kWorthKeeping) break;
      State state = states_[action.state];
      state.score = action.score;
      apply(state, action, u);
      survivors.push_back(std::move(state));
    }
    states_ = std::move(survivors);
  }
  for (State& state : states_) state.score += end_score(state);
  std::stable_sort(states_.begin(), states_.end(), [](const State& a, const State& b) { return a.score > b.score; });
  SentenceReading reading;
  reading.units = states_.front().units;
  reading.score = states_.front().score;
  reading.roots = states_.front().roots;
  constexpr std::size_t kOthers = 4;
  constexpr double kClose = 1.0;
  for (std::size_t s = 1; s < states_.size() && s <= kOthers && states_[s].score > reading.score - kClose; ++s)
    reading.close.push_back(states_[s].units);
  return reading;
}

void Decoder::add(std::size_t s, Kind kind, double gain, int unit, int first, Referent meant, bool list) {
  actions_.push_back({s, states_[s].score + gain, kind, unit, first, meant, list});
}

void Decoder::begin_clause(State& state) const {
  state.frontier.clear();
  state.fronted.clear();
  state.waiting = state.relative = state.told = state.first_subject = state.inverted = state.where = -1;
  state.verb = state.imperative = state.participle = false;
}

void Decoder::cut_frontier(State& state, int unit) const {
  while (!state.frontier.empty() && state.frontier.back() != unit) state.frontier.pop_back();
}

const NounPhrase& Decoder::noun_of(const State& state, Referent referent) const {
  for (int steps = 0; steps < 4; ++steps) {
    if (is_mention(referent)) return document_.mentions[static_cast<std::size_t>(mention_of(referent))].noun;
    if (referent < 0) return nothing_;
    const UnitReading& reading = read_as(state, referent);
    const NounPhrase& own = chunk(referent).noun;
    if (own.kind == NounKind::kMember && own.of && own.of->kind == NounKind::kObject) return *own.of;  // "each of the beds"
    if (reading.meant == kNobody || own.kind == NounKind::kObject) return own;
    referent = reading.meant;
  }
  return nothing_;
}

bool Decoder::is_thing(const State& state, Referent referent) const {
  if (is_mention(referent)) return !document_.mentions[static_cast<std::size_t>(mention_of(referent))].items.empty();
  if (referent < 0 || !is(referent, UnitKind::kNoun)) return false;
  const NounPhrase& noun = noun_of(state, referent);
  return noun.kind == NounKind::kObject || brings_owner(noun);
}

bool Decoder::same(const State& state, Referent one, Referent other) const {
  const auto root_of = [&](Referent referent) {
    for (int steps = 0; referent >= 0 && steps < 4; ++steps) {
      const UnitReading& reading = read_as(state, referent);
      const NounPhrase& noun = chunk(referent).noun;
      if (reading.meant == kNobody || (noun.kind == NounKind::kMember && !speaks_of_others(noun)))
        break;  // "a second one" is none of those
      referent = reading.meant;
    }
    return referent;
  };
  one = root_of(one);
  other = root_of(other);
  if (one == kNobody || other == kNobody) return false;
  if (one == other) return true;
  const auto definite = [&](Referent referent) {
    const Determiner d = noun_of(state, referent).determiner;
    return d == Determiner::kDefinite || d == Determiner::kPossessive || d == Determiner::kEach || d == Determiner::kBoth;
  };
  if (is_mention(one) && is_mention(other))
    return document_.mentions[static_cast<std::size_t>(mention_of(one))].items ==
           document_.mentions[static_cast<std::size_t>(mention_of(other))].items;
  const NounPhrase &first = noun_of(state, one), &second = noun_of(state, other);
  return names_same(first, second, definite(one), definite(other));
}

bool Decoder::several(const State& state, Referent referent) const {
  if (is_mention(referent)) {
    const Mention& mention = document_.mentions[static_cast<std::size_t>(mention_of(referent))];
    return mention.items.size() > 1 && !mention.distributes;
  }
  if (referent < 0) return false;
  const NounPhrase& own = chunk(referent).noun;
  const bool each = own.determiner == Determiner::kEach;
  if (each || (own.kind == NounKind::kMember && own.determiner != Determiner::kBoth)) return own.kind == NounKind::kMember && own.count > 1;
  const UnitReading& reading = read_as(state, referent);
  if (reading.whole_list) return true;
  if (reading.meant != kNobody && own.kind != NounKind::kObject) return several(state, reading.meant);
  if (own.is_plural()) return true;
  return reading.many;  // "a nightstand on each side": two
}

bool Decoder::is_definite(const State& state, int u) const {
  const NounPhrase& noun = chunk(u).noun;
  if (brings_owner(noun)) return false;
  return read_as(state, u).role == NounRole::kReference &&
         (noun.kind != NounKind::kObject || noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kEach ||
          noun.determiner == Determiner::kPossessive || noun.determiner == Determiner::kBoth);
}

bool Decoder::is_known(const State& state, int u) const {
  if (brings_owner(chunk(u).noun)) return false;
  return read_as(state, u).role == NounRole::kReference && known_[static_cast<std::size_t>(u)];
}

// "the bed" that was named, not "the bed" that is brought in by the way.
void Decoder::find_known() {
  constexpr std::size_t kBack = 60;
  known_.assign(sentence_.size(), false);
  for (int u = 0; u < static_cast<int>(sentence_.size()); ++u) {
    if (!is(u, UnitKind::kNoun)) continue;
    const NounPhrase& noun = chunk(u).noun;
    const bool definite = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kEach ||
                          noun.determiner == Determiner::kPossessive || noun.determiner == Determiner::kBoth;
    bool known = noun.kind != NounKind::kObject;
    // "… and next to crib a rug": without articles as well.
    const bool bare = noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && is(u - 1, UnitKind::kPlace);
    for (int before = 0; bare && !known && before < u; ++before)
      known = is(before, UnitKind::kNoun) && names_same(noun, chunk(before).noun, true, false);
    for (int before = 0; definite && !known && before < u; ++before)
      known = is(before, UnitKind::kNoun) && names_same(noun, chunk(before).noun, true, false);
    for (std::size_t i = document_.items.size(), looked = 0; definite && !known && i-- > 0 && looked < kBack; ++looked)
      known = names_same(noun, document_.items[i].noun, true, false) || noun.entry == document_.items[i].noun.entry;
    known_[static_cast<std::size_t>(u)] = known;
  }
}

// "a dish rack and a cup next to the rack": what the sentence called by its full name.
const NounPhrase& Decoder::called_before(const State& state, int u) const {
  const NounPhrase& noun = noun_of(state, u);
  if (noun.kind != NounKind::kObject || noun.determiner != Determiner::kDefinite || noun.name != noun.head) return noun;
  for (int before = u; before-- > 0;) {
    const NounPhrase& full = chunk(before).noun;
    if (is(before, UnitKind::kNoun) && full.kind == NounKind::kObject && full.name != noun.name && names_same(noun, full, true, false))
      return full;
  }
  return noun;
}

// The members of a list from `first` to `last`, in order.
std::vector<int> Decoder::list_of(const State& state, int last, int first) const {
  std::vector<int> all;
  for (int u = last; u >= 0; u = read_as(state, u).former) {
    all.insert(all.begin(), u);
    if (u == first) break;
  }
  return all;
}

Referent Decoder::host_of(const State& state, int content) const {
  const UnitReading& reading = read_as(state, content);
  if (reading.role != NounRole::kContent || reading.predicate < 0) return kNobody;
  return read_as(state, reading.predicate).subject;
}

// A verb, whatever kind of unit it is.
bool Decoder::verb_like(int u) const {
  if (is(u, UnitKind::kVerb)) return true;
  return (is(u, UnitKind::kPlace) || is(u, UnitKind::kHave)) && is_finite(word(u));
}

double Decoder::end_score(const State& state) const {
  double score = 0;
  for (std::size_t u = 0; u < sentence_.size(); ++u) {
    const UnitReading& reading = state.units[u];
    if (unit(static_cast<int>(u)).kind != UnitKind::kNoun || chunk(static_cast<int>(u)).noun.kind != NounKind::kObject) continue;
    if (reading.role == NounRole::kRoot && !reading.placed && mount_of(chunk(static_cast<int>(u)).noun) == Mount::kSurface) score -= 0.6;
  }
  return score;
}

}  // namespace layoutbox::offline
