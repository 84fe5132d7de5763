// Places that follow from what is said: opposite one another, beside what was named last, on what carries them.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/scribe.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// "against the opposite wall", "in the opposite corner": opposite what the sentence, or the one before, spoke of first.
void Scribe::imply_opposite(int u, const NounPhrase& place, int link) {
  const bool said = place.wall_relation == "opposite" || contains_word(place.attributes, "opposite");
  if ((place.kind != NounKind::kWall && place.kind != NounKind::kCorner) || !said || place.is_plural() || place.of) return;
  const PhraseSenses& senses = link_at(link).senses;
  if (!says(senses, RelationType::kAgainstWall) && !says(senses, RelationType::kOnWall) && !says(senses, RelationType::kIn) &&
      !says(senses, RelationType::kCenterOfRoom))
    return;
  const std::vector<int> targets = link_at(link).targets;
  const auto stands = [&](int m) {
    return is_thing(m) && !contains(targets, m) && noun_of(m).kind == NounKind::kObject && mount_of(noun_of(m)) == Mount::kFloor &&
           (noun_of(m).entry == nullptr || !noun_of(m).entry->thin);
  };
  int other = -1;
  for (int before = 0; before < u && other < 0; ++before) {
    const int m = mention_[static_cast<std::size_t>(before)];
    if (is(before, UnitKind::kNoun) && reading(before).role == NounRole::kRoot && m >= 0 && stands(m)) other = m;
  }
  if (other < 0) other = last_at_wall(targets);
  if (other < 0) other = last_great_thing(targets);
  if (other < 0 || targets.empty()) return;
  Link opposite;
  opposite.senses = {{RelationType::kOpposite, Direction::kDirect, {}, {}, {}}};
  opposite.targets = targets;
  opposite.references = {other};
  opposite.soft = opposite.concluded = true;
  opposite.first = chunk(u).first;
  opposite.last = chunk(u).last;
  document_.links.push_back(std::move(opposite));
}

// The last thing that was said to be at a wall or a window, best one that stands on the floor; -1: none.
int Scribe::last_at_wall(const std::vector<int>& but) const {
  int hung = -1;
  for (std::size_t l = document_.links.size(), looked = 0; l-- > 0 && looked < kReach; ++looked) {
    const Link& link = document_.links[l];
    const bool at_wall = says(link.senses, RelationType::kAgainstWall) || says(link.senses, RelationType::kOnWall) ||
                         says(link.senses, RelationType::kUnderWindow);
    if (!at_wall || link.soft || link.targets.empty() || link.references.empty()) continue;
    const NounKind place = noun_of(link.references.front()).kind;
    const int m = link.targets.front();
    if ((place != NounKind::kWall && place != NounKind::kWindow) || !is_thing(m) || contains(but, m)) continue;
    if (mount_of(noun_of(m)) == Mount::kFloor) return m;
    if (hung < 0) hung = m;
  }
  return hung;
}

// The last thing that was named and stands on the floor and is no seat that stands free; first what earlier sentences spoke of.
int Scribe::last_great_thing(const std::vector<int>& but) const {
  const auto great = [&](int m) {
    if (!is_thing(m) || contains(but, m)) return false;
    const NounPhrase& noun = noun_of(m);
    if (noun.kind != NounKind::kObject || mount_of(noun) != Mount::kFloor || (noun.entry != nullptr && noun.entry->thin)) return false;
    return is_heavy(lexicon_.catalog(), noun) && (!is_seat(lexicon_.catalog(), noun) || one_of(noun.head, WordSet::kSofas));
  };
  if (great(so_far_.topic)) return so_far_.topic;
  for (const int root : so_far_.roots) {
    if (great(root)) return root;
  }
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (great(static_cast<int>(m))) return static_cast<int>(m);
  }
  return -1;
}

// "a nearby bench", "an adjacent bookshelf", "the opposite sofa".
void Scribe::imply_adjective(int u, int mention) {
  if (!mention_at(mention).introduces) return;
  const std::vector<std::string> attributes = noun_of(mention).attributes;
  for (const std::string& attribute : attributes) {
    const bool next_to = attribute == "adjacent", near = attribute == "nearby", opposite = attribute == "opposite";
    if (!next_to && !near && !opposite) continue;
    int reference = -1;
    if (reading(u).role == NounRole::kContent) {
      const std::vector<int> hosts = subjects_of(reading(u).predicate);
      if (!hosts.empty()) reference = hosts.front();
    }
    for (int before = u; reference < 0 && before-- > 0;) {
      if (is(before, UnitKind::kNoun) && reading(before).role == NounRole::kRoot && is_thing(mention_[static_cast<std::size_t>(before)]))
        reference = mention_[static_cast<std::size_t>(before)];
    }
    if (reference < 0) reference = so_far_.topic;
    if (!is_thing(reference)) continue;
    Link link;
    link.senses = {{next_to ? RelationType::kNextTo
                    : near  ? RelationType::kNear
                            : RelationType::kOpposite,
                    Direction::kDirect,
                    {},
                    {},
                    {}}};
    link.targets = {mention};
    link.references = {reference};
    link.first = chunk(u).first;
    link.last = chunk(u).last;
    document_.links.push_back(std::move(link));
  }
}

// "a sofa and an armchair opposite each other": two, or a group of several.
void Scribe::mean_each_other(Link& link) {
  if (link.targets.size() != 1 || mention_at(link.targets.front()).items.size() != 1) return;
  for (std::size_t u = 0; u < mention_.size(); ++u) {
    if (mention_[u] != link.targets.front()) continue;
    const int former = reading(static_cast<int>(u)).former;
    if (former >= 0 && is_thing(mention_[static_cast<std::size_t>(former)]))
      link.targets.insert(link.targets.begin(), mention_[static_cast<std::size_t>(former)]);
    return;
  }
}

// What that thing faces or stands opposite, by this sentence; -1: nothing, or its own members.
int Scribe::looked_at_by(int mention, const std::vector<int>& but) const {
  for (std::size_t l = document_.links.size(); l-- > sentence_links_;) {
    const Link& looks = document_.links[l];
    if (!contains(looks.targets, mention) || looks.references.empty()) continue;
    const int other = looks.references.front();
    const Mention& seen = document_.mentions[static_cast<std::size_t>(other)];
    const bool alone = document_.mentions[static_cast<std::size_t>(mention)].items.size() == 1;
    const bool across = says(looks.senses, RelationType::kFacing) || says(looks.senses, RelationType::kOpposite);
    if (is_thing(other) && !seen.reciprocal && !contains(but, other) && (alone || across)) return other;
    if (alone && is_thing(other)) break;
  }
  return -1;
}

// "a nightstand and a lamp on each side": both, where the first carries the second.
void Scribe::add_laden_stand(const PhraseSenses& senses, std::vector<int>& targets) const {
  if (targets.size() != 1 || targets.front() < 1 || !says(senses, RelationType::kEachSideOf)) return;
  const int stand = targets.front() - 1;
  const NounPhrase &load = noun_of(targets.front()), &carrier = noun_of(stand);
  const Mention& mention = document_.mentions[static_cast<std::size_t>(stand)];
  if (!mention.introduces || mention.items.size() != 1 || load.first != carrier.last + 1 || document_.tokens[carrier.last].text != "and")
    return;
  if (mount_of(load) != Mount::kSurface || mount_of(carrier) != Mount::kFloor || carrier.entry == nullptr || !carrier.entry->top_carries)
    return;
  if (may_carry(lexicon_.catalog(), carrier, load)) targets.insert(targets.begin(), stand);
}

}  // namespace layoutbox::offline
