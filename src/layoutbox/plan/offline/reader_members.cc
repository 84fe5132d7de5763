// Which of several: another one, the right one, the latter, the second.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

// "a large bookcase and a smaller one", "a mat by the tub and another one by the shower": brought in anew. -1: it is not.
int DocumentReader::another_one(const NounPhrase& noun) {
  const bool another = noun.determiner == Determiner::kAnother;
  const bool described = noun.determiner == Determiner::kIndefinite && !noun.attributes.empty();
  if ((!another && !described) || noun.subset || noun.of) return -1;
  if (another && references_.has_left(references_.latest_group(), std::max(noun.count, 1))) return -1;
  int kind = roots_.empty() ? last_topic_ : roots_.back();
  const bool listed = !frames_.empty() && !frames_.back().room && frames_.back().link >= 0 && joiner_ != Joiner::kNone;
  if (listed && !link_at(frames_.back().link).targets.empty()) kind = link_at(frames_.back().link).targets.back();
  if (kind < 0 || !is_thing(kind) || noun_of(kind).kind != NounKind::kObject) return -1;
  NounPhrase copy = noun_of(kind);
  copy.determiner = Determiner::kIndefinite;
  copy.count = noun.count;
  copy.plural = noun.count > 1;
  copy.rows = 0;
  if (!noun.attributes.empty()) {
    copy.attributes = noun.attributes;
    copy.attribute_classes = noun.attribute_classes;
  }
  copy.first = noun.first;
  copy.last = noun.last;
  return references_.mention(copy, -1, false);
}

// The latest thing that was named by its place in a row ("the first wardrobe"), or -1.
int DocumentReader::last_ordinal() const {
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (document_.mentions[m].noun.ordinal != 0 && is_thing(static_cast<int>(m))) return static_cast<int>(m);
  }
  return -1;
}

// The group that "the right one", "the first", "the other" speak of: one whose members make sense there, the nearest first.
int DocumentReader::group_meant(std::size_t k, const NounPhrase& noun) const {
  const Catalog& catalog = lexicon_.catalog();
  std::vector<int> groups;
  const auto consider = [&](int mention) {
    if (mention >= 0 && document_.mentions[static_cast<std::size_t>(mention)].items.size() > 1 && !contains(groups, mention))
      groups.push_back(mention);
  };
  for (std::size_t c = chain_.size(); c-- > 0;) consider(chain_[c]);
  consider(last_topic_);
  for (std::size_t r = former_roots_.size(); r-- > 0 && roots_.empty();) consider(former_roots_[r]);
  consider(references_.latest_group());
  for (std::size_t m = document_.mentions.size(), looked = 0; expects_reference_ && m-- > 0 && looked < 20; ++looked)
    consider(static_cast<int>(m));
  if (groups.empty()) return -1;
  if (noun.determiner == Determiner::kOther) {  // of those that a "one" was taken from
    for (const int group : groups) {
      if (references_.has_left(group, 1)) return group;
    }
  }
  const std::size_t n = next(k);
  const bool has = (is(n, ChunkKind::kHave) || is(n, ChunkKind::kRelation)) && is(next(n), ChunkKind::kNoun) &&
                   chunk(next(n)).noun.kind == NounKind::kObject && mount_of(chunk(next(n)).noun) == Mount::kSurface &&
                   (is(n, ChunkKind::kHave) || has_direction(*chunk(n).phrase.senses, Direction::kInverse));
  const Link* waiting = expects_reference_ && reference_link_ >= 0 ? &document_.links[static_cast<std::size_t>(reference_link_)] : nullptr;
  const std::vector<int>& placed = waiting != nullptr && !waiting->targets.empty() ? waiting->targets : chain_;
  for (const int group : groups) {
    if (has && !may_carry(catalog, noun_of(group), chunk(next(n)).noun)) continue;
    if (waiting != nullptr && !placed.empty() &&
        (contains(placed, group) || !may_refer(catalog, waiting->senses, noun_of(placed.back()), noun_of(group))))
      continue;
    return group;
  }
  return groups.front();
}

// Two single things of this sentence of which one was placed by the other, as one mention, or -1.
int DocumentReader::just_related() {
  for (std::size_t l = document_.links.size(), looked = 0; l-- > 0 && looked < 6; ++looked) {
    const Link& link = document_.links[l];
    if (link.kind != Link::Kind::kRelation || link.targets.size() != 1 || link.references.size() != 1) continue;
    const Mention &one = mention_at(link.targets.front()), &other = mention_at(link.references.front());
    if (one.items.size() != 1 || other.items.size() != 1 || one.items == other.items) continue;
    if (mount_of(one.noun) != Mount::kFloor || mount_of(other.noun) != Mount::kFloor) continue;
    Mention both = one;
    both.introduces = both.distributes = false;
    both.items.push_back(other.items.front());
    document_.mentions.push_back(std::move(both));
    return static_cast<int>(document_.mentions.size()) - 1;
  }
  return -1;
}

// "a lamp and a table; the latter …": the last of the things that were named, or the one before it.
int DocumentReader::of_the_two(bool former, const std::vector<int>& busy) const {
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    const int mention = static_cast<int>(m);
    if (!is_thing(mention) || !document_.mentions[m].introduces || contains(busy, mention)) continue;
    if (!former) return mention;
    former = false;
  }
  return -1;
}

// "thirty desks with chairs": one for each of them.
void DocumentReader::grow_for_hosts(int content, const std::vector<int>& hosts) {
  const NounPhrase& noun = noun_of(content);
  if (!mention_at(content).introduces || !noun.plural || noun.count > 0 || noun.collective || hosts.size() != 1) return;
  const Mention& host = mention_at(hosts.front());
  if (!host.distributes && host.items.size() > mention_at(content).items.size()) references_.grow(content, host.items.size());
}

}  // namespace layoutbox::offline
