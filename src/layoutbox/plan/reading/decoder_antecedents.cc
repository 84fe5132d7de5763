// Whom a pronoun, a member of a group, or a reference that is not said may mean.
#include <algorithm>

#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

namespace {

constexpr std::size_t kChoices = 4;
constexpr int kBack = 12;  // mentions of earlier sentences that are looked at

}  // namespace

bool Decoder::consider(std::vector<Candidate>& all, const State& state, Referent referent, double order, Referent subject,
                       const PhraseSenses* senses, const NounPhrase* noun, bool list) const {
  if (referent == kNobody) return false;
  const NounPhrase& meant = noun_of(state, referent);
  const bool opening = meant.kind == NounKind::kDoor || meant.kind == NounKind::kWindow;
  if (!is_thing(state, referent) && !(opening && senses != nullptr && noun != nullptr && noun->head == "it")) return false;
  if (subject != kNobody && same(state, referent, subject)) return false;
  // Nothing stands between itself, or what has it, and something else.
  const Referent host = subject >= 0 ? host_of(state, subject) : kNobody;
  for (int m = list ? referent : -1; m >= 0; m = state.units[static_cast<std::size_t>(m)].former) {
    if ((subject != kNobody && same(state, m, subject)) || (host != kNobody && same(state, m, host))) return false;
  }
  double score = weight::kOrder * order - (opening ? 0.3 : 0);
  if (noun != nullptr) {
    const bool many = list || several(state, referent);
    const bool group = noun->kind == NounKind::kMember;
    const bool wanted = group || noun->plural || noun->determiner == Determiner::kBoth;
    if (wanted && !many) score += group ? weight::kNumber - 1 : weight::kNumber;
    if (!wanted && many) score += noun->head.empty() ? -0.8 : weight::kNumber;
  }
  if (senses != nullptr && subject != kNobody && is_thing(state, subject)) {
    const double sense = sense_.of_place(*senses, noun_of(state, subject), meant);
    score += sense;
    const bool side = says(*senses, RelationType::kLeftOf) || says(*senses, RelationType::kRightOf);
    const bool lies = says(*senses, RelationType::kOn) || says(*senses, RelationType::kIn);
    if (subject >= 0 && referent == host_of(state, subject) &&
        (side ? mount_of(noun_of(state, subject)) == Mount::kSurface : lies && noun != nullptr && noun->head == "it"))
      score += weight::kOwnHost;
    // "a keyboard in front": of the screen, not of the desk that carries both.
    const bool before = says(*senses, RelationType::kInFrontOf) || says(*senses, RelationType::kBehind);
    const Referent owner = subject >= 0 ? host_of(state, subject) : kNobody;
    const bool has_it = owner != kNobody && (referent == owner || (owner >= 0 && referent == host_of(state, owner)));
    if (before && has_it && mount_of(noun_of(state, subject)) == Mount::kSurface && is_table(lexicon_.catalog(), meant))
      score += weight::kBeforeHost;
    // What lies on the floor or on something else is seldom what one places things by.
    const auto stands = [&](const NounPhrase& n) {
      return n.kind != NounKind::kObject || (mount_of(n) == Mount::kFloor && (n.entry == nullptr || !n.entry->thin));
    };
    if (stands(noun_of(state, subject)) && !stands(meant)) score -= 0.8;
  }
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
  const auto try_one = [&](Referent referent, double order, bool list = false) {
    if (std::any_of(placed.begin(), placed.end(), [&](int member) { return same(state, referent, member); })) return false;
    return consider(all, state, referent, order, subject, senses, noun, list);
  };
  const bool pronoun = noun != nullptr && !noun->head.empty();
  const bool plural = noun != nullptr && (noun->plural || noun->kind == NounKind::kMember || noun->determiner == Determiner::kBoth);
  const bool listed = noun != nullptr && (noun->plural || noun->determiner == Determiner::kBoth || noun->count == 2);
  if (pronoun && noun->kind == NounKind::kPronoun && state.it != kNobody && !plural) try_one(state.it, 0.6);
  double order = 0;
  const auto lists = [&](int u, double at) {
    if (listed && u >= 0 && state.units[static_cast<std::size_t>(u)].former >= 0) try_one(u, at, true);
  };
  // What has it, then the clause's own thing, then what was named for their sake.
  for (std::size_t f = state.frontier.size(); f-- > 0;) {
    const Referent host = host_of(state, state.frontier[f]);
    if (host == kNobody) continue;
    lists(host, order);
    order += try_one(host, order) ? 0.5 : 0;
  }
  if (!state.frontier.empty()) {
    lists(state.frontier.front(), order);
    try_one(state.frontier.front(), order);
    if (noun != nullptr && noun->kind == NounKind::kMember) {
      for (std::size_t f = state.frontier.size(); f-- > 1;) try_one(state.frontier[f], order + 0.2);
    }
  }
  order += 1;
  for (std::size_t r = state.roots.size(), looked = 0; r-- > 0 && looked < 6; ++looked) {
    lists(state.roots[r], order - 0.1);
    // What was named once more is what is spoken of.
    bool again = false;
    for (int u = state.roots[r] + 1; u < static_cast<int>(state.units.size()) && pronoun; ++u)
      again |= state.units[static_cast<std::size_t>(u)].role == NounRole::kReference && same(state, u, state.roots[r]);
    order += try_one(state.roots[r], order - (again ? 1.4 : 0)) ? 0.6 : 0;
  }
  for (int u = static_cast<int>(state.units.size()), looked = 0; u-- > 0 && looked < 6;) {
    if (!is(u, UnitKind::kNoun) || state.units[static_cast<std::size_t>(u)].role != NounRole::kReference) continue;
    // What was known before and is named once more is what things are placed by.
    const double known = is_known(state, u) ? pronoun ? 0.3 : 0.8 : 0;
    order += try_one(u, order - known) ? 0.4 : 0;
    ++looked;
  }
  for (std::size_t f = state.frontier.size(); f-- > 1;) {
    lists(state.frontier[f], order);
    order += try_one(state.frontier[f], order) ? 0.4 : 0;
  }
  // "one", "the other": of any group that was named.
  if (noun != nullptr && noun->kind == NounKind::kMember && !listed) {
    for (int u = static_cast<int>(state.units.size()); u-- > 0;) {
      if (!is(u, UnitKind::kNoun) || state.units[static_cast<std::size_t>(u)].role == NounRole::kUnread || !several(state, u)) continue;
      try_one(u, order);
      order += 0.3;
    }
  }
  for (const int place : state.fronted) {
    if (!state.units[static_cast<std::size_t>(place)].alone) try_one(place + 1, order);
  }
  const bool lies = senses != nullptr && (says(*senses, RelationType::kOn) || says(*senses, RelationType::kIn));
  if (before_.fronted >= 0 && !lies && state.roots.empty() && state.frontier.empty()) try_one(referent_of_mention(before_.fronted), 0);
  if (before_.topic >= 0) try_one(referent_of_mention(before_.topic), order);
  order += 0.8;
  for (std::size_t r = before_.roots.size(), looked = 0; r-- > 0 && looked < 6; ++looked, order += 0.6)
    try_one(referent_of_mention(before_.roots[r]), order);
  int back = 0;
  for (std::size_t m = document_.mentions.size(); m-- > 0 && back < kBack; ++back, order += 0.4)
    try_one(referent_of_mention(static_cast<int>(m)), order);
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  if (all.size() > kChoices) all.resize(kChoices);
  return all;
}

}  // namespace layoutbox::offline
