// Whom a pronoun, a member of a group, or a reference that is not said may mean.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

namespace {

constexpr std::size_t kChoices = 6;

constexpr int kMentionsBack = 12;  // mentions of earlier sentences that are looked at

// "it" of several, "them" of one.
double number_score(const NounPhrase& noun, bool many) {
  const bool group = noun.kind == NounKind::kMember;
  const bool wanted = group || noun.plural || noun.determiner == Determiner::kBoth;
  if (group && noun.head == "twin") return many ? weight::kNumber : 0;
  if (wanted && !many) return group ? weight::kNumber - 1 : weight::kNumber;
  if (!wanted && many) return noun.head.empty() ? -0.8 : weight::kNumber;
  return 0;
}

// "the third" of three shelves, not of two vases; else of two chairs a third.
double rank_score(const NounPhrase& noun, int things) {
  if (noun.kind != NounKind::kMember || noun.ordinal <= things || things < 1) return 0;
  return noun.ordinal == things + 1 ? weight::kOneMore : weight::kUnlikely;
}

// "it"; "two windows, a radiator under each"
bool speaks_of_openings(const NounPhrase& noun) {
  const bool them = noun.kind == NounKind::kPronoun && noun.head == "them";
  return noun.head == "it" || them || noun.determiner == Determiner::kEach || noun.determiner == Determiner::kBoth;
}

// "both", "them", "each": a list may be meant as well.
bool is_list_wanted(const NounPhrase* noun) {
  const bool each_of_them =
      noun != nullptr && noun->determiner == Determiner::kEach && (noun->subset || noun->kind == NounKind::kMember) && !noun->of;
  return noun != nullptr && (noun->plural || each_of_them || noun->determiner == Determiner::kBoth || noun->count == 2);
}

}  // namespace

// "two crates, the blue one on the grey one": both are of the group.
bool Decoder::is_of_one_group(const State& state, Referent group, Referent subject, const NounPhrase* noun) const {
  return noun != nullptr && noun->kind == NounKind::kMember && !noun->plural && noun->count <= 1 && noun->determiner != Determiner::kEach &&
         subject >= 0 && chunk(subject).noun.kind == NounKind::kMember && several(state, group);
}

// The sentence put the one on the other.
bool Decoder::lies_on(const State& state, Referent one, Referent other) const {
  for (int p = 0; p < static_cast<int>(state.units.size()); ++p) {
    const UnitReading& place = read_as(state, p);
    if (!is(p, UnitKind::kPlace) || place.inverse || place.alone || place.subject != one || !is(p + 1, UnitKind::kNoun)) continue;
    if (says(unit(p).direct, &RelationTraits::rests) && read_as(state, p + 1).predicate == p && same(state, p + 1, other)) return true;
  }
  return false;
}

// How many things that is, with all that is listed before it where a list is meant.
int Decoder::things_of(const State& state, Referent referent, bool list) const {
  int things = list ? 0 : noun_of(state, referent).count;
  for (int m = list ? referent : -1; m >= 0; m = read_as(state, m).former)
    things += std::max(noun_of(state, m).count, several(state, m) ? 2 : 1);
  return things;
}

// A list of which only the last are several.
bool Decoder::several_last_of(const State& state, Referent list) const {
  if (list < 0 || chunk(list).noun.count < 2) return false;
  bool one = false;
  for (int m = read_as(state, list).former; m >= 0; m = read_as(state, m).former) {
    if (chunk(m).noun.is_plural()) return false;
    one = true;
  }
  return one;
}

// What lies on the subject, what it lies on, itself, what has it: nothing is placed by these.
bool Decoder::is_tied_to(const State& state, Referent referent, Referent subject, const PhraseSenses* senses, bool list) const {
  // Nothing is placed by what lies on it, nor between what it has.
  const bool between = senses != nullptr && says(*senses, RelationType::kBetween);
  if (subject >= 0 && referent >= 0 && (between || mount_of(noun_of(state, referent)) == Mount::kSurface) &&
      host_of(state, referent) == subject)
    return true;
  if (subject >= 0 && referent >= 0 && lies_on(state, referent, subject)) return true;  // "an apron is on a hook near it"
  // "a camera on a tripod faces it"
  if (subject >= 0 && referent >= 0 && senses != nullptr && !says(*senses, &RelationTraits::rests) && lies_on(state, subject, referent))
    return true;
  // Nothing stands between itself, or what has it, and something else.
  const Referent host = subject >= 0 ? host_of(state, subject) : kNobody;
  for (int m = list ? referent : -1; m >= 0; m = read_as(state, m).former) {
    if ((subject != kNobody && same(state, m, subject)) || (host != kNobody && same(state, m, host))) return true;
  }
  return false;
}

bool Decoder::consider(std::vector<Candidate>& all, const State& state, Referent referent, double order, Referent subject,
                       const PhraseSenses* senses, const NounPhrase* noun, bool list) const {
  if (referent == kNobody) return false;
  const NounPhrase& meant = noun_of(state, referent);
  const bool opening = is_opening(meant) &&
                       // "a desk and a bed in it": in the room; nothing lies on a door.
                       !(senses != nullptr && says(*senses, &RelationTraits::rests));
  if (!is_thing(state, referent) && !(opening && senses != nullptr && noun != nullptr && speaks_of_openings(*noun))) return false;
  const bool more = subject >= 0 && says_one_of(document_, chunk(subject).noun.last, {"more"});  // "two beds …, two more opposite them"
  if (subject != kNobody && !more && !is_of_one_group(state, referent, subject, noun) && same(state, referent, subject)) return false;
  if (is_tied_to(state, referent, subject, senses, list)) return false;
  // "a tub under the window, a stool next to it": seldom the window by which something else was placed.
  const bool by_opening = opening && referent >= 0 && read_as(state, referent).role == NounRole::kReference;
  const bool between = senses != nullptr && says(*senses, RelationType::kBetween);
  // "a stove, two armchairs, a rug between them": between two, not three.
  const bool crowd = between && things_of(state, referent, list) > 2;
  double score = (crowd ? weight::kBetweenMany : 0) + weight::kOrder * order + (by_opening ? weight::kItIsOpening : opening ? -0.3 : 0);
  const bool heap = noun != nullptr && noun->plural && meant.collective;  // "a stack of plates, a jug beside them"
  if (noun != nullptr)
    score += number_score(*noun, list || heap || several(state, referent)) + rank_score(*noun, things_of(state, referent, list));
  if (between && list && subject >= 0 && is_list_beside_pair(state, referent, subject)) score += weight::kUnlikely;
  // "a bed and two nightstands, a lamp on each": of the nightstands
  const bool each = list && noun != nullptr && noun->determiner == Determiner::kEach && several_last_of(state, referent);
  if (each) score += weight::kNotBeside;
  if (senses != nullptr && subject != kNobody && is_thing(state, subject))
    score += antecedent_place_score(state, referent, subject, *senses, noun);
  for (Candidate& before : all) {
    if (before.list != list || !same(state, before.referent, referent)) continue;
    if (score > before.score) before = {referent, score, list};
    return false;
  }
  all.push_back({referent, score, list});
  return true;
}

std::vector<Decoder::Candidate> Decoder::antecedents(const State& state, Referent subject, const PhraseSenses* senses,
                                                     const NounPhrase* noun, int first_subject) const {
  std::vector<Candidate> all;
  const std::vector<int> placed = subject >= 0 && first_subject >= 0 ? list_of(state, subject, first_subject) : std::vector<int>{};
  const Trial trial = [&](Referent referent, double order, bool list) {
    if (!is_of_one_group(state, referent, subject, noun) &&
        std::any_of(placed.begin(), placed.end(), [&](int member) { return same(state, referent, member); }))
      return false;
    return consider(all, state, referent, order, subject, senses, noun, list);
  };
  const bool plural = noun != nullptr && (noun->plural || noun->kind == NounKind::kMember || noun->determiner == Determiner::kBoth);
  const bool that = noun != nullptr && one_of(noun->head, {"that", "this", "those", "these"});  // what was named last
  // "two carts on its right, and a lamp over it", "on it are jars, and under it a bin": the same one both times.
  if (noun != nullptr && !noun->head.empty() && noun->kind == NounKind::kPronoun && state.it != kNobody && !plural && !that)
    trial(state.it, noun->head == "it" ? -weight::kNamedOnceMore : 0.6, false);
  if (that) named_last(state, trial);
  if (that && state.roots.empty() && !before_.roots.empty()) trial(referent_of_mention(before_.roots.back()), -weight::kNamedAgain, false);
  // "a mirror above the sink, a stool beside it, a mat in front": of what the place before was by.
  const bool unsaid = noun != nullptr && noun->head.empty() && noun->kind == NounKind::kPronoun && !plural;
  const bool upon = senses != nullptr && says(*senses, RelationType::kOn);  // "a freezer stands next to it, a box on top": on the freezer
  if (unsaid && state.by != kNobody && senses != nullptr && !upon && !says(*senses, RelationType::kIn) &&
      !says(*senses, RelationType::kOpposite))
    trial(state.by, -weight::kNamedOnceMore, false);
  // … "a freezer hums next to it, a cooler on top": on what was named right before.
  const int before_it = subject >= 0 ? read_as(state, subject).former : kNobody;
  const bool its = noun != nullptr && (noun->head == "it" || (noun->of && noun->of->kind == NounKind::kPronoun));
  const bool carries = before_it >= 0 && read_as(state, before_it).placed && !is_seat(lexicon_.catalog(), chunk(before_it).noun);
  // "lockers with a bench in front and cubbies underneath": under the bench
  const bool beneath = unsaid && senses != nullptr && says(*senses, RelationType::kUnder) && before_it >= 0 &&
                       read_as(state, before_it).placed && several(state, host_of(state, subject));
  if (beneath || ((unsaid || its) && upon && carries)) trial(before_it, -weight::kNamedOnceMore, false);
  double order = clause_antecedents(state, noun, trial);
  // What earlier sentences named is meant where this one has nothing of its own to mean; "a key and a radio, all on it": neither is.
  const std::vector<int> list = subject >= 0 ? list_of(state, subject, -1) : std::vector<int>{};
  if (std::any_of(all.begin(), all.end(), [&](const Candidate& own) { return std::ranges::find(list, own.referent) == list.end(); }))
    order += weight::kSentenceBefore;
  text_antecedents(state, senses, noun, trial, order);
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  if (all.size() > kChoices) all.resize(kChoices);
  return all;
}

// "carries a tray, and on that stand two cups": the tray; else what the clause is about.
void Decoder::named_last(const State& state, const Trial& trial) const {
  for (int u = static_cast<int>(state.units.size()); u-- > 0;) {
    const NounRole role = is(u, UnitKind::kNoun) ? read_as(state, u).role : NounRole::kUnread;
    if ((role == NounRole::kContent || role == NounRole::kRoot) && is_thing(state, u) && trial(u, -weight::kNamedAgain, false)) return;
  }
}

// What the host of the thing at u has besides it: "a bench with two bags on it and a box between them".
void Decoder::contents_of(const State& state, int u, const NounPhrase& noun, double order, const Trial& trial) const {
  constexpr int kNear = 12;
  const Referent host = host_of(state, u);
  if (noun.head != "it" && !noun.plural) return;
  for (int content = u; content-- > 0 && content + kNear > u;) {
    if (is(content, UnitKind::kNoun) && read_as(state, content).role == NounRole::kContent && host_of(state, content) == host)
      trial(content, noun.plural && several(state, content) ? order : order + 2, false);
  }
}

// The sentence's own: what has the clause's thing, then that thing, then what was named for their sake, then groups.
double Decoder::clause_antecedents(const State& state, const NounPhrase* noun, const Trial& trial) const {
  const bool listed = is_list_wanted(noun);
  const auto lists = [&](int u, double at) {
    if (listed && u >= 0 && read_as(state, u).former >= 0) trial(u, at, true);
  };
  double order = 0;
  for (std::size_t f = state.frontier.size(); f-- > 0;) {
    const Referent host = host_of(state, state.frontier[f]);
    if (host == kNobody) continue;
    lists(host, order);
    if (noun != nullptr) contents_of(state, state.frontier[f], *noun, order, trial);
    order += trial(host, order, false) ? 0.5 : 0;
  }
  if (!state.frontier.empty()) {
    lists(state.frontier.front(), order);
    // "a desk and a chair in the corner and a plant next to them": of the list without the plant.
    if (const int former = read_as(state, state.frontier.front()).former; former >= 0 && read_as(state, former).placed)
      lists(former, order);
    // "Two lanterns on the wall, one on each side": of these.
    const bool of_group = noun != nullptr && noun->kind == NounKind::kMember && !noun->of && several(state, state.frontier.front());
    trial(state.frontier.front(), order - (of_group ? weight::kNamedAgain : 0), false);
    for (std::size_t f = state.frontier.size(); noun != nullptr && noun->kind == NounKind::kMember && f-- > 1;)
      trial(state.frontier[f], order + 0.2, false);
  }
  order = references_before(state, noun, trial, topics_before(state, noun, trial, order + 1));
  for (std::size_t f = state.frontier.size(); f-- > 1;) {
    lists(state.frontier[f], order);
    order += trial(state.frontier[f], order, false) ? 0.4 : 0;
  }
  if (noun != nullptr && noun->determiner == Determiner::kOther) others_of(state, *noun, order, trial);
  // "one", "the other", "each": of any group that was named.
  const bool each = noun != nullptr && noun->determiner == Determiner::kEach && noun->head.empty();
  const bool member = noun != nullptr && noun->kind == NounKind::kMember && (!listed || each);
  for (int u = static_cast<int>(state.units.size()); member && u-- > 0;) {
    if (!is(u, UnitKind::kNoun) || read_as(state, u).role == NounRole::kUnread || !several(state, u)) continue;
    trial(u, order, false);
    order += 0.3;
  }
  for (const int place : state.fronted) {
    if (!read_as(state, place).alone) trial(place + 1, order, false);
  }
  return order;
}

// "one of these tables carries a tray, the other a vase": of those of which one was spoken of last.
void Decoder::others_of(const State& state, const NounPhrase& noun, double order, const Trial& trial) const {
  if (noun.kind != NounKind::kMember || noun.of) return;
  for (int u = static_cast<int>(state.units.size()); u-- > 0;) {
    if (!is(u, UnitKind::kNoun) || read_as(state, u).role == NounRole::kUnread || !chunk(u).noun.subset) continue;
    if (const Referent group = read_as(state, u).meant; group != kNobody && several(state, group))
      trial(group, order - weight::kNamedAgain, false);
    return;
  }
}

// What clauses were about.
double Decoder::topics_before(const State& state, const NounPhrase* noun, const Trial& trial, double order) const {
  const bool pronoun = noun != nullptr && !noun->head.empty(), listed = is_list_wanted(noun);
  const bool said = pronoun && noun->kind == NounKind::kPronoun;
  for (std::size_t r = state.roots.size(), looked = 0; r-- > 0 && looked < 6; ++looked) {
    const int root = state.roots[r];
    if (listed && root >= 0 && read_as(state, root).former >= 0) trial(root, order - 0.1, true);
    // What was named once more is what is spoken of.
    int again = 0;
    for (int u = root + 1; u < static_cast<int>(state.units.size()) && pronoun; ++u)
      again += read_as(state, u).role == NounRole::kReference && same(state, u, root) ? 1 : 0;
    order += trial(root, order - (again > 1 && said ? weight::kNamedAgain : again > 0 ? weight::kNamedOnceMore : 0), false) ? 0.6 : 0;
  }
  return order;
}

// What things were placed by.
double Decoder::references_before(const State& state, const NounPhrase* noun, const Trial& trial, double order) const {
  const bool pronoun = noun != nullptr && !noun->head.empty(), said = pronoun && noun->kind == NounKind::kPronoun;
  for (int u = static_cast<int>(state.units.size()), looked = 0; u-- > 0 && looked < 6;) {
    if (!is(u, UnitKind::kNoun) || read_as(state, u).role != NounRole::kReference) continue;
    if (said && carries_first(state, u)) trial(u, order - weight::kNamedOnceMore, false);
    // What was known before and is named once more is what things are placed by.
    const double known = is_known(state, u) ? pronoun ? 0.3 : 0.8 : 0;
    const double again = known > 0 && said && placed_by_before(state, u) ? weight::kNamedAgain : 0;
    order += trial(u, order - known - again, false) ? 0.4 : 0;
    ++looked;
  }
  return order;
}

// "On the counter are a till and a vase; in front of it …": the counter.
bool Decoder::carries_first(const State& state, int u) const {
  const int place = read_as(state, u).predicate;
  return place >= 0 && is(place, UnitKind::kPlace) && read_as(state, place).fronted && is_thing(state, u) &&
         says(unit(place).direct, &RelationTraits::rests);
}

// "a chair pulled up to the desk, a box next to the desk and a map above it": another place of the sentence is by the same thing.
bool Decoder::placed_by_before(const State& state, int u) const {
  for (int before = u; before-- > 0;) {
    if (is(before, UnitKind::kNoun) && read_as(state, before).role == NounRole::kReference && same(state, before, u)) return true;
  }
  return false;
}

// Of the sentences before.
void Decoder::text_antecedents(const State& state, const PhraseSenses* senses, const NounPhrase* noun, const Trial& trial,
                               double order) const {
  const bool lies = senses != nullptr && says(*senses, &RelationTraits::rests);
  const bool spoken_of = senses == nullptr && noun != nullptr && noun->kind == NounKind::kPronoun;
  // "Opposite the shower is a sink. Over it …", "… It holds …": the sink; but "in front of it" as the place before.
  const bool over = senses != nullptr && (says(*senses, RelationType::kAbove) || says(*senses, RelationType::kUnder));
  if (before_.fronted >= 0 && !spoken_of && !lies && !over && state.roots.empty() && state.frontier.empty())
    trial(referent_of_mention(before_.fronted), 0, false);
  // "On it lie a map and a pen; a lantern swings above": over what carries them
  if (before_.fronted >= 0 && over && state.roots.size() <= 1) trial(referent_of_mention(before_.fronted), order + 1, false);
  if (before_.opening >= 0 && state.roots.empty()) trial(referent_of_mention(before_.opening), 0, false);  // "The door is …; next to it"
  // "a table is opposite the stove, and sacks are under the table. On it …": the table
  if (before_.again >= 0 && state.roots.empty()) trial(referent_of_mention(before_.again), order - weight::kNamedOnceMore, false);
  if (before_.topic >= 0) trial(referent_of_mention(before_.topic), order, false);
  order += 0.8;
  for (std::size_t r = before_.roots.size(), looked = 0; r-- > 0 && looked < 6; ++looked, order += 0.6)
    trial(referent_of_mention(before_.roots[r]), order, false);
  int back = 0;
  for (int m = static_cast<int>(document_.mentions.size()); m-- > 0 && back < kMentionsBack; ++back, order += 0.4)
    trial(referent_of_mention(m), order + (m < before_.first ? weight::kLongAgo : 0), false);
}

}  // namespace layoutbox::offline
