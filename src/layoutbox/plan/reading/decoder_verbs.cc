// What a having, a verb or a relative clause is said of.
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

namespace {

bool is_room_like(NounKind kind) {
  return kind == NounKind::kRoom || kind == NounKind::kOutsideRoom || kind == NounKind::kAbstract || kind == NounKind::kWindow ||
         kind == NounKind::kDoor;
}

}  // namespace

// "holds", "has": of what the clause, or the relative clause before it, is about.
void Decoder::finite_have_actions(std::size_t s, int u) {
  const State& state = states_[s];
  for (std::size_t level = 0; level < state.frontier.size(); ++level) {
    const int member = state.frontier[level];
    const NounKind kind = noun_of(state, member).kind;
    if (!is_thing(state, member) && kind != NounKind::kWall && kind != NounKind::kCorner && kind != NounKind::kPart) continue;
    const std::optional<double> again = member == state.told ? retold_score(state, u) : std::nullopt;
    add(s, kHaveThing, (level == 0 ? 0.5 : again ? 0.5 + *again : -2.5) + weight::kTree * tree_.for_noun(u, member), member, member);
  }
}

void Decoder::have_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const std::string& how = word(u);
  // "Flank the bed with two nightstands": the place's own things come now.
  if (how == "with" && state.frontier.empty() && state.fronted.size() == 1 && state.fronted.front() + 2 == u &&
      chunk(state.fronted.front()).last - chunk(state.fronted.front()).first == 1 && !unit(state.fronted.front()).direct.empty()) {
    add(s, kHaveThing, 1, state.fronted.front(), -2);
    return;
  }
  if (state.frontier.empty() && state.relative < 0) {
    add(s, kHaveRoom, 0);
    return;
  }
  const bool finite = is_finite(how);
  const std::size_t before = actions_.size();
  if (state.relative < 0) {
    const int root = state.frontier.front();
    const NounKind kind = noun_of(state, root).kind;
    if (is_room_like(kind) && !is_thing(state, root)) {
      double gain = 0;
      for (const int f : state.frontier) gain += is_thing(state, f) ? -1.5 : 0;
      add(s, kHaveRoom, gain);
    }
  }
  if (finite && state.relative < 0) {
    finite_have_actions(s, u);
  } else {
    attach_actions(s, u, kHaveThing);
    if (tops_clause(state, u)) {
      for (std::size_t a = before; a < actions_.size(); ++a)
        actions_[a].score += actions_[a].unit == state.frontier.front() ? weight::kTopOfClause : 0;
    }
  }
  if (actions_.size() == before) {
    add(s, kHaveRoom, -0.5);
  } else if (how == "with" && unit(u).joiner == Joiner::kComma && state.relative < 0) {
    add(s, kHaveRoom, weight::kBesides);
  }
}

// "a cabinet stands beside the desk with a printer on top": what tops something is told of what the clause is about.
bool Decoder::tops_clause(const State& state, int u) const {
  int place_of = u + 2;
  while (is(place_of, UnitKind::kNoun) && unit(place_of).joiner != Joiner::kNone && !unit(place_of).clause)
    ++place_of;  // "a kettle and a pan"
  if (state.frontier.size() < 2 || !is(u + 1, UnitKind::kNoun) || !is(place_of, UnitKind::kPlace) || follows(place_of, UnitKind::kNoun))
    return false;
  // "two armchairs stand by the fireplace with a lamp between them": the armchairs have it.
  const bool between = says(alone_senses(place_of), RelationType::kBetween);
  if (between) return several(state, state.frontier.front()) && !several(state, state.frontier.back());
  const int by = state.frontier.back();
  const int place = read_as(state, by).predicate;
  const bool beside = read_as(state, by).role == NounRole::kReference && place >= 0 && is(place, UnitKind::kPlace) &&
                      !says(unit(place).direct, RelationType::kOn) && !says(unit(place).direct, RelationType::kUnder);
  return beside && is_definite(state, by) && says(alone_senses(place_of), RelationType::kOn) &&
         sense_.carries(noun_of(state, state.frontier.front()), chunk(u + 1).noun);
}

void Decoder::verb_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const bool passive = chunk(u).passive;
  const bool joined = unit(u).joiner != Joiner::kNone;
  if (state.relative >= 0) {
    add(s, kFinite, 0, state.relative, state.relative);
    return;
  }
  if (state.outer >= 0 && unit(u).joiner == Joiner::kComma) {
    add(s, kFinite, 1, state.outer, state.outer);
    return;
  }
  if (!state.outer_fronted.empty() && unit(u).joiner == Joiner::kComma && is(u + 1, UnitKind::kNoun)) {
    add(s, kInvert, 1);
    return;
  }
  if (state.frontier.empty()) {
    add(s, state.fronted.empty() && !passive ? kCommand : kInvert, 0);
    return;
  }
  if (joined && !passive && is(u + 1, UnitKind::kNoun)) {
    add(s, kCommand, state.imperative ? 1 : 0.3);
    if (state.imperative) return;
  }
  // The subject: a plural verb takes all that is listed, a singular one the last.
  const int root = state.frontier.front();
  const std::string& verb = word(u);
  const bool plural = verb == "are" || verb == "were" || verb == "have" || (!verb.ends_with("s") && verb != "is" && verb != "was");
  if (const std::optional<double> again = retold_score(state, u)) add(s, kFinite, *again, state.told, state.told);
  // "a cart with two books, a vase and a bowl stands by the sofa": one thing stands there.
  const bool listed = !plural && !state.verb && read_as(state, root).former >= 0 && unit(root).joiner == Joiner::kAnd;
  add(s, kFinite, listed ? weight::kDisagrees : 0, root, plural ? first_of_plural(state, root) : root);
}

// "a table, which is round and is laid with plates", "chairs surround a table, which … and carries a vase": how well the verb at u goes on
// with the relative clause, by its number and that of the clause's own thing; nothing where there is none.
std::optional<double> Decoder::retold_score(const State& state, int u) const {
  const bool joined = unit(u).joiner == Joiner::kAnd && !unit(u).clause;
  if (!joined || state.told < 0 || state.frontier.size() < 2 || state.told == state.frontier.front()) return std::nullopt;
  if (std::ranges::find(state.frontier, state.told) == state.frontier.end()) return std::nullopt;
  const std::string& verb = word(u);
  const bool one = verb == "is" || verb == "was" || is_finite(verb), many = verb == "are" || verb == "were";
  const bool told_many = several(state, state.told), root_many = several(state, state.frontier.front());
  if (told_many == root_many) return weight::kToldOn;
  return (one && !told_many) || (many && told_many) ? -weight::kDisagrees : weight::kDisagrees;
}

// A place that comes after it speaks of it, and is complete.
bool Decoder::is_placed_apart(const State& state, int member) const {
  for (int p = member + 1; p < static_cast<int>(state.units.size()); ++p) {
    if (is(p, UnitKind::kNoun) && read_as(state, p).role == NounRole::kRoot) return false;  // the next of the list
    if (is(p, UnitKind::kPlace) && read_as(state, p).subject == member && !read_as(state, p).fronted) return true;
  }
  return false;
}

// It has a place or things of its own: "bench with hooks, washer and dryer stacked" are the washer and the dryer.
bool Decoder::is_told_by_itself(const State& state, int member) const {
  if (is_placed_apart(state, member)) return true;
  for (int u = member + 1; u < static_cast<int>(state.units.size()); ++u) {
    if (is(u, UnitKind::kHave) && read_as(state, u).subject == member) return true;
  }
  return false;
}

// The first of the list up to that thing that a plural verb speaks of.
int Decoder::first_of_plural(const State& state, int last) const {
  int first = last;
  while (first >= 0 && read_as(state, first).former >= 0) {
    const int former = read_as(state, first).former;
    const bool list_ends = (noun_of(state, last).is_plural() && (unit(first).joiner != Joiner::kAnd || read_as(state, former).placed)) ||
                           is_placed_apart(state, former);
    if (list_ends || (state.room_list && unit(first).joiner != Joiner::kAnd)) break;
    first = former;
  }
  return first;
}

void Decoder::relative_actions(std::size_t s, int u) {
  const State& state = states_[s];
  int nearer = 0;
  for (std::size_t f = state.frontier.size(); f-- > 0;) {
    const int member = state.frontier[f];
    const NounKind kind = noun_of(state, member).kind;
    if (!is_thing(state, member) && kind != NounKind::kWindow && kind != NounKind::kDoor && kind != NounKind::kRoom) continue;
    const bool several_here = several(state, member);
    double gain = -0.9 * nearer++ + weight::kTree * tree_.for_noun(u, member);
    if (verb_like(u + 1)) gain += is_finite(word(u + 1)) == several_here && word(u + 1) != "hold" ? -1 : 0;
    add(s, kRelate, gain, member);
  }
  if (actions_.empty() || actions_.back().state != s) add(s, kPass, 0);
}

}  // namespace layoutbox::offline
