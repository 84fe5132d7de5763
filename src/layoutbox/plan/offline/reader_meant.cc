// Who is meant: by "it", "them", an area of the room, or where nobody is named.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

int DocumentReader::implied_reference(const std::vector<int>& targets, bool single, const PhraseSenses* senses, bool pronoun) const {
  const auto usable = [&](int mention) {
    if (mention < 0 || !is_thing(mention)) return false;
    if (senses != nullptr && !targets.empty() && is_thing(targets.front()) &&
        !may_refer(lexicon_.catalog(), *senses, noun_of(targets.front()), noun_of(mention)))
      return false;
    const Mention& meant = document_.mentions[static_cast<std::size_t>(mention)];
    if (single && meant.items.size() > 1 && !meant.distributes) return false;
    for (const int target : targets) {
      for (const int item : document_.mentions[static_cast<std::size_t>(target)].items) {
        if (contains(document_.mentions[static_cast<std::size_t>(mention)].items, item)) return false;
      }
    }
    return true;
  };
  for (std::size_t f = frames_.size(); f-- > 0;) {
    for (const int host : frames_[f].hosts) {
      if (!frames_[f].room && usable(host)) return host;
    }
  }
  for (const int subject : subject_) {
    if (usable(subject)) return subject;
  }
  for (std::size_t r = roots_.size(); r-- > 0;) {
    if (usable(roots_[r])) return roots_[r];
  }
  // What lies on the floor or on something else is seldom what one places things by.
  const auto stands = [&](int mention) {
    const NounPhrase& noun = noun_of(mention);
    return noun.kind != NounKind::kObject || (mount_of(noun) == Mount::kFloor && (noun.entry == nullptr || !noun.entry->thin));
  };
  const bool to_floor = !targets.empty() && stands(targets.front());
  if (usable(last_topic_) && (pronoun || !to_floor || stands(last_topic_))) return last_topic_;
  for (std::size_t m = document_.mentions.size(), looked = 0; !pronoun && to_floor && m-- > 0 && looked < kReach; ++looked) {
    if (usable(static_cast<int>(m)) && stands(static_cast<int>(m))) return static_cast<int>(m);
  }
  if (usable(last_topic_)) return last_topic_;
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (usable(static_cast<int>(m))) return static_cast<int>(m);
  }
  return -1;
}

// "It" is one thing. Where the nearest was itself placed by an "it" ("a stool in front of it and a lamp behind it"), both mean the same.
int DocumentReader::meant_by_it(const std::vector<int>& targets) const {
  // "a nightstand with a lamp on each side of it": of what nightstands stand by.
  if (expects_reference_ && reference_link_ >= 0 &&
      says(document_.links[static_cast<std::size_t>(reference_link_)].senses, RelationType::kEachSideOf) && chain_.size() > 1 &&
      is_thing(chain_.front())) {
    const int front = chain_.front();
    const int former = roots_.size() > 1 && roots_.back() == front ? roots_[roots_.size() - 2] : -1;
    return former >= 0 && is_thing(former) && stands_by(lexicon_.catalog(), noun_of(front), noun_of(former)) ? former : front;
  }
  const bool placed = expects_reference_ && reference_link_ >= 0;
  const PhraseSenses* senses = placed ? &document_.links[static_cast<std::size_t>(reference_link_)].senses : nullptr;
  if (const int opening = meant_opening(targets); opening >= 0) return opening;
  // "To its left is a lamp. Opposite it …": what the lamp stood by.
  const bool lies = senses != nullptr && (says(*senses, RelationType::kOn) || says(*senses, RelationType::kIn));
  if (former_fronted_ >= 0 && !lies && roots_.empty() && frames_.empty()) return former_fronted_;
  int meant = implied_reference(targets, true, senses, true);
  if (meant < 0) meant = implied_reference(targets, true, nullptr, true);
  if (meant < 0) meant = implied_reference(targets);
  // "a stool in front of the armchair, a table to the left of it": of the armchair, which was named for the stool's sake.
  const bool beside = senses != nullptr && std::any_of(senses->begin(), senses->end(), [](const PhraseSense& s) {
                        return s.type == RelationType::kLeftOf || s.type == RelationType::kRightOf || s.type == RelationType::kBehind ||
                               s.type == RelationType::kInFrontOf || s.type == RelationType::kNextTo;
                      });
  for (std::size_t l = document_.links.size(); meant >= 0 && beside && joiner_before_relation_ == Joiner::kNone && l-- > sentence_links_;) {
    const Link& link = document_.links[l];
    if (!contains(link.targets, meant) || link.references.size() != 1) continue;
    const int named = link.references.front();
    const Mention& mention = document_.mentions[static_cast<std::size_t>(named)];
    const bool again = mention.noun.determiner == Determiner::kDefinite && !mention.introduces && mention.items.size() == 1;
    const auto at_side = [](const PhraseSenses& all) {
      return says(all, RelationType::kLeftOf) || says(all, RelationType::kRightOf) || says(all, RelationType::kInFrontOf) ||
             says(all, RelationType::kBehind);
    };
    if (again && at_side(link.senses) && at_side(*senses) && mention.noun.kind == NounKind::kObject && !contains(targets, named))
      return named;
    const bool seats_round = mention.noun.kind == NounKind::kObject && (is_root(named) || was_root(named)) && !contains(targets, named);
    if (again && seats_round && !roots_.empty() && roots_.back() != meant) return named;
    break;
  }
  if (meant < 0 || last_it_ < 0 || contains(targets, last_it_)) return meant;
  const std::vector<int>& same = document_.mentions[static_cast<std::size_t>(last_it_)].items;
  for (std::size_t l = document_.links.size(); l-- > sentence_links_;) {
    const Link& link = document_.links[l];
    if (!contains(link.targets, meant) || link.references.empty()) continue;
    if (document_.mentions[static_cast<std::size_t>(link.references.front())].items == same) return last_it_;
  }
  return meant;
}

// What the sentence before spoke of.
bool DocumentReader::was_root(int mention) const {
  const std::vector<int>& items = document_.mentions[static_cast<std::size_t>(mention)].items;
  return std::any_of(former_roots_.begin(), former_roots_.end(),
                     [&](int root) { return is_thing(root) && document_.mentions[static_cast<std::size_t>(root)].items == items; });
}

// "a window with a radiator below it", "to the right of the door … to the left of it": an opening that was just spoken of, or -1.
int DocumentReader::meant_opening(const std::vector<int>& targets) const {
  if (!expects_reference_ || reference_link_ < 0) return -1;
  const auto opening = [&](int mention) { return noun_of(mention).kind == NounKind::kWindow || noun_of(mention).kind == NounKind::kDoor; };
  const PhraseSenses& senses = document_.links[static_cast<std::size_t>(reference_link_)].senses;
  const bool side = says(senses, RelationType::kLeftOf) || says(senses, RelationType::kRightOf);
  for (std::size_t l = static_cast<std::size_t>(reference_link_); side && l-- > sentence_links_;) {
    const Link& before = document_.links[l];
    const bool sides = says(before.senses, RelationType::kLeftOf) || says(before.senses, RelationType::kRightOf);
    // "to the left of the dresser a mirror, to the right of it a wardrobe"
    if (sides && !before.references.empty() && contains(fronted_, reference_link_) && is_thing(before.references.front()))
      return before.references.front();
    if (sides && !before.references.empty()) return opening(before.references.front()) ? before.references.front() : -1;
  }
  if (!says(senses, RelationType::kUnder) && !says(senses, RelationType::kAbove) && !says(senses, RelationType::kNextTo)) return -1;
  for (std::size_t r = roots_.size(); r-- > 0;) {
    if (opening(roots_[r])) return roots_[r];
    const bool target = contains(targets, roots_[r]) || (!chain_.empty() && roots_[r] == chain_.front());
    const bool hangs_there = is_thing(roots_[r]) && noun_of(roots_[r]).entry != nullptr && mount_of(noun_of(roots_[r])) == Mount::kWall;
    if (!target && !hangs_there) return -1;
  }
  return -1;
}

// "the sofa and the armchair … between them": the last two things as one mention, or -1.
int DocumentReader::last_two(const std::vector<int>& targets) {
  const std::vector<int>& roots = roots_.size() > 1 ? roots_ : former_roots_;
  std::vector<int> things;
  for (std::size_t r = roots.size(); r-- > 0 && things.size() < 2;) {
    if (is_thing(roots[r]) && !contains(targets, roots[r]) && noun_of(roots[r]).kind == NounKind::kObject)
      things.insert(things.begin(), roots[r]);
  }
  if (things.size() < 2) return just_related();
  Mention both = mention_at(things.front());
  both.introduces = both.distributes = false;
  for (const int item : mention_at(things.back()).items) {
    if (!contains(both.items, item)) both.items.push_back(item);
  }
  document_.mentions.push_back(std::move(both));
  return static_cast<int>(document_.mentions.size()) - 1;
}

int DocumentReader::implied_group(const std::vector<int>& targets) {
  // "magazines on a table in front of them": not what lies there; "a table with two chairs between them": not its own chairs.
  const auto held = [&](int mention) {
    for (std::size_t l = sentence_links_; l < document_.links.size(); ++l) {
      const Link& lies = document_.links[l];
      if ((says(lies.senses, RelationType::kOn) || says(lies.senses, RelationType::kIn)) && contains(lies.targets, mention) &&
          std::any_of(lies.references.begin(), lies.references.end(), [&](int host) { return contains(targets, host); }))
        return true;
    }
    return std::any_of(frames_.begin(), frames_.end(), [&](const Frame& frame) {
      return frame.link >= 0 && contains(link_at(frame.link).targets, mention) &&
             std::any_of(frame.hosts.begin(), frame.hosts.end(), [&](int host) { return contains(targets, host); });
    });
  };
  const auto usable = [&](int mention) {
    return mention >= 0 && document_.mentions[static_cast<std::size_t>(mention)].items.size() > 1 && !contains(targets, mention) &&
           !held(mention);
  };
  for (std::size_t f = frames_.size(); f-- > 0;) {
    for (const int host : frames_[f].hosts) {
      if (usable(host)) return host;
    }
  }
  for (std::size_t c = chain_.size(); c-- > 0;) {
    if (usable(chain_[c])) return chain_[c];
  }
  for (std::size_t r = roots_.size(); r-- > 0;) {
    if (usable(roots_[r])) return roots_[r];
  }
  if (const int both = last_two(targets); both >= 0) return both;
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (usable(static_cast<int>(m))) return static_cast<int>(m);
  }
  return implied_reference(targets);
}

// What stands for an area of the room: "the dining area" is where the dining table is, "the seating area" where one sits.
int DocumentReader::thing_of_zone(const NounPhrase& noun) const {
  static constexpr std::string_view kZones[] = {"area",    "zone", "nook",    "setup",  "arrangement",
                                                "section", "spot", "station", "corner", "set-up"};
  if (std::find(std::begin(kZones), std::end(kZones), noun.head) == std::end(kZones) || noun.determiner != Determiner::kDefinite) return -1;
  const std::string words = words_between(document_, noun.first, noun.last);
  int seat = -1, named = -1;
  for (std::size_t m = document_.mentions.size(); m-- > 0;) {
    const Mention& mention = document_.mentions[m];
    if (mention.items.empty() || !mention.introduces || mention.noun.kind != NounKind::kObject) continue;
    const std::string first = mention.noun.name.substr(0, mention.noun.name.find(' '));
    if (first != mention.noun.name && words.find(first) != std::string::npos) {
      if (!is_seat(lexicon_.catalog(), mention.noun)) return static_cast<int>(m);
      if (named < 0) named = static_cast<int>(m);
    }
    if (seat < 0 && is_seat(lexicon_.catalog(), mention.noun)) seat = static_cast<int>(m);
  }
  if (named >= 0) return named;
  if (words.find("seating") != std::string::npos || words.find("sitting") != std::string::npos || words.find("lounge") != std::string::npos)
    return seat;
  if (words.find("sleeping") != std::string::npos) {
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      if (!document_.mentions[m].items.empty() && document_.mentions[m].noun.head == "bed") return static_cast<int>(m);
    }
  }
  return last_topic_ >= 0 && is_thing(last_topic_) ? last_topic_ : -1;
}

// What that thing or group faces or stands opposite, by this sentence; -1: nothing, or its own members.
int DocumentReader::looked_at_by(int mention, const std::vector<int>& but) const {
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

}  // namespace layoutbox::offline
