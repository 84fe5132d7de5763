// Who is placed: the target of a relation, what shares its place, and what grows with the places.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

std::vector<int> DocumentReader::joined_with(int mention, bool after_participle, bool in_center, const NounPhrase* host) const {
  if (contains(subject_, mention)) return subject_;
  const auto at = std::find(roots_.begin(), roots_.end(), mention);
  std::vector<int> joined{mention};
  const auto shares = [&](int later, int former) {
    const NounPhrase& noun = noun_of(later);
    return noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && noun_of(former).determiner != Determiner::kNone;
  };
  if (!frames_.empty() && frames_.back().link >= 0) {  // "with a small desk and bookshelf in the corner"
    const std::vector<int>& contents = document_.links[static_cast<std::size_t>(frames_.back().link)].targets;
    const auto own = std::find(contents.begin(), contents.end(), mention);
    if (own != contents.end() && own != contents.begin() && shares(mention, *(own - 1))) joined.insert(joined.begin(), *(own - 1));
    if (own != contents.end()) return joined;
  }
  if (at == roots_.end()) return joined;
  const Catalog& catalog = lexicon_.catalog();
  const auto alike = [&](int former) {
    if (host == nullptr) return false;
    const auto lies = [&](int m) {
      return may_carry(catalog, *host, noun_of(m)) && mount_of(noun_of(m)) != Mount::kFloor &&
             (host->entry == nullptr || !host->entry->thin);
    };
    return (lies(mention) && lies(former)) || (is_seat(catalog, noun_of(mention)) && is_seat(catalog, noun_of(former)));
  };
  for (std::size_t r = static_cast<std::size_t>(at - roots_.begin()); r > clause_start_; --r) {
    const bool shares_article = shares(roots_[r], roots_[r - 1]);
    if (root_modified_[r - 1] || !is_thing(roots_[r - 1])) break;
    // "a monitor, a printer on a cabinet": only what an "and" ends is one list.
    const bool listed = roots_[r] != mention || root_joiners_[r] != Joiner::kComma;
    if (root_joiners_[r] != Joiner::kNone && listed && alike(roots_[r - 1])) {
      joined.insert(joined.begin(), roots_[r - 1]);
      continue;
    }
    if (root_joiners_[r] != Joiner::kAnd) break;
    const bool pair_in_center = in_center && r == clause_start_ + 1 && r + 1 == roots_.size();
    if (!shares_article && !after_participle && !pair_in_center) break;
    joined.insert(joined.begin(), roots_[r - 1]);
  }
  return joined;
}

std::vector<int> DocumentReader::targets_for(const PhraseSenses& senses, Direction direction, const NounPhrase& reference,
                                             bool after_participle, int reference_mention) const {
  const Catalog& catalog = lexicon_.catalog();
  const bool apart =
      joiner_before_relation_ == Joiner::kComma || joiner_before_relation_ == Joiner::kCommaAnd || joiner_before_relation_ == Joiner::kAnd;
  // "a table and two benches facing each other": the nearest that are several.
  if (document_.mentions[static_cast<std::size_t>(reference_mention)].reciprocal && !apart) {
    for (std::size_t c = chain_.size(); c-- > 0;) {
      const Mention& several = document_.mentions[static_cast<std::size_t>(chain_[c])];
      if (several.items.size() > 1 && several.introduces && is_content(chain_[c])) return {chain_[c]};
    }
  }
  // "pans on a rack mounted on the ceiling": what was named right before and is new.
  if (hang_ && after_participle && !apart && !chain_.empty() && reference.kind == NounKind::kCeiling && is_thing(chain_.back()) &&
      document_.mentions[static_cast<std::size_t>(chain_.back())].introduces &&
      noun_of(chain_.back()).determiner == Determiner::kIndefinite && chain_.size() > 1 && !is_lamp(catalog, noun_of(chain_.front())))
    return {chain_.back()};
  int best = -1, best_score = 0;
  bool together = false;  // what lies on it or sits around it lies and sits there together
  const std::size_t count = chain_.size();
  for (std::size_t step = 0; step < count; ++step) {
    const std::size_t c = apart ? step : count - 1 - step;  // after a comma the root comes first
    const int mention = chain_[c];
    if (!is_thing(mention) || document_.mentions[static_cast<std::size_t>(mention)].items ==
                                  document_.mentions[static_cast<std::size_t>(reference_mention)].items)
      continue;
    const NounPhrase& noun = noun_of(mention);
    const auto sense = choose_sense(catalog, senses, direction, noun, reference);
    if (!sense) continue;
    int score = 10 * suits(catalog, *sense, noun, reference);
    const bool root = is_root(mention);
    const bool room_place = reference.kind == NounKind::kCorner || reference.kind == NounKind::kWall ||
                            reference.kind == NounKind::kWindow || reference.kind == NounKind::kDoor || reference.kind == NounKind::kCenter;
    // "a table with two chairs by the sofa": the table stands there; a chair that looks somewhere is the chair itself.
    const bool at_it = is_table(catalog, reference) && reference_link_ >= 0 &&
                       document_.tokens[document_.links[static_cast<std::size_t>(reference_link_)].first].text == "at";
    const bool its_seat = count > 1 && sits_at(mention, chain_[count - 2]) && sense->type != RelationType::kFacing && !at_it;
    const bool small = is_seat(catalog, noun) ? sense->type != RelationType::kFacing : mount_of(noun) == Mount::kSurface;
    if (((room_place && small) || its_seat) && !apart && step == 0 && count > 1 && is_content(mention) && !hang_) score -= 12;
    // What was there before is seldom placed anew by the way.
    if (!document_.mentions[static_cast<std::size_t>(mention)].introduces && !root && !is_content(mention)) score -= 15;
    if (hang_ && !apart && c + 1 == count && score > 0) score += 12;  // "a bicycle hung on the wall"
    if (reference.kind == NounKind::kObject && noun.name == reference.name && noun.first == reference.first) continue;
    if (score <= best_score) continue;
    best = mention;
    best_score = score;
    using R = RelationType;
    together = reference.kind == NounKind::kObject &&
               (sense->type == R::kOn || sense->type == R::kIn || sense->type == R::kAround || sense->type == R::kSurround);
  }
  if (best < 0) {
    const auto introduced = std::find_if(chain_.rbegin(), chain_.rend(), [&](int m) {
      return is_thing(m) && document_.mentions[static_cast<std::size_t>(m)].introduces && is_content(m) && m != reference_mention;
    });
    if (introduced != chain_.rend()) best = *introduced;
    for (const int mention : chain_) {
      if (is_thing(mention) && best < 0 &&
          document_.mentions[static_cast<std::size_t>(mention)].items !=
              document_.mentions[static_cast<std::size_t>(reference_mention)].items)
        best = mention;
    }
  }
  // "a door in the left wall", "two windows on the back wall".
  if (best < 0 && reference.kind == NounKind::kWall && !chain_.empty()) {
    const NounKind kind = noun_of(chain_.front()).kind;
    if (kind == NounKind::kDoor || kind == NounKind::kWindow) return {chain_.front()};
  }
  if (best < 0) return {};
  return joined_with(best, after_participle, reference.kind == NounKind::kCenter, together ? &reference : nullptr);
}

// "a table with two chairs": what they have in common is the table's place.
bool DocumentReader::sits_at(int seat, int table) const {
  return is_thing(seat) && is_thing(table) && is_root(table) && is_seat(lexicon_.catalog(), noun_of(seat)) &&
         is_table(lexicon_.catalog(), noun_of(table));
}

void DocumentReader::imply_adjective(int mention, std::size_t k) {
  const NounPhrase noun = noun_of(mention);
  for (const std::string& attribute : noun.attributes) {
    const bool next_to = attribute == "adjacent", near = attribute == "nearby", opposite = attribute == "opposite";
    if (!next_to && !near && !opposite) continue;
    if (!mention_at(mention).introduces) continue;
    const int reference = implied_reference({mention});
    if (reference < 0) continue;
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
    link.first = chunk(k).first;
    link.last = chunk(k).last;
    add_link(std::move(link));
  }
}

// "a lamp on each side" is two lamps, "two chairs on each long side" four, a chair on each side of a square table as well.
void DocumentReader::grow_for_sides(const Link& link, int target, int reference) {
  const std::size_t count = mention_at(target).items.size();
  const auto is_square = [&] {
    const NounPhrase& host = noun_of(reference);
    const bool each = words_between(document_, link.first, link.last).find("each") != std::string::npos;
    return each && is_table(lexicon_.catalog(), host) && is_seat(lexicon_.catalog(), noun_of(target)) &&
           std::find(host.attributes.begin(), host.attributes.end(), "square") != host.attributes.end();
  };
  if (says(link.senses, RelationType::kAlongSide))
    references_.grow(target, count * 2);
  else if (says(link.senses, RelationType::kEachSideOf) && count == 1 && reference >= 0 && is_square())
    references_.grow(target, 4);
  else if (says(link.senses, RelationType::kEachSideOf) && count != 2)
    references_.grow(target, count * 2);
  grow_contents(target, count);
}

// "a nightstand and a lamp on each side": both, where the first carries the second.
void DocumentReader::add_laden_stand(const PhraseSenses& senses, std::vector<int>& targets) const {
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

// What each of the things has grows with them: "a nightstand with a lamp on each side".
void DocumentReader::grow_contents(int host, std::size_t before) {
  const std::size_t now = mention_at(host).items.size();
  if (before == 0 || now <= before) return;
  for (std::size_t l = sentence_links_; l < document_.links.size(); ++l) {
    const Link& link = document_.links[l];
    if (link.kind != Link::Kind::kHave || !contains(link.references, host)) continue;
    for (const int content : link.targets) references_.grow(content, mention_at(content).items.size() * now / before);
  }
}

// "a sofa and an armchair opposite each other": two, or a group of several.
void DocumentReader::mean_each_other(Link& link) {
  if (link.targets.size() == 1 && mention_at(link.targets.front()).items.size() == 1) {
    const auto at = std::find(roots_.begin(), roots_.end(), link.targets.front());
    if (at != roots_.end() && at != roots_.begin() && is_thing(*(at - 1))) link.targets.insert(link.targets.begin(), *(at - 1));
  }
}

// A thing that the clause itself speaks of, whatever words are used for it.
bool DocumentReader::is_root(int mention) const {
  const auto same = [&](int root) {
    return root == mention || (is_thing(root) && document_.mentions[static_cast<std::size_t>(root)].items ==
                                                     document_.mentions[static_cast<std::size_t>(mention)].items);
  };
  return std::any_of(roots_.begin(), roots_.end(), same) || std::any_of(subject_.begin(), subject_.end(), same);
}

// "a laptop on the right side of the desk and a wallet on the left side": of the desk as well; "on the short side": of a table.
int DocumentReader::implied_side_host(const PhraseSenses& senses, const std::vector<int>& targets) {
  const bool side = says(senses, RelationType::kLeftOf) || says(senses, RelationType::kRightOf);
  const bool table = says(senses, RelationType::kAlongSide);
  const auto own = [&](int mention) {
    for (const int target : targets) {
      for (const int item : document_.mentions[static_cast<std::size_t>(target)].items) {
        if (contains(document_.mentions[static_cast<std::size_t>(mention)].items, item)) return true;
      }
    }
    return false;
  };
  // "with a microwave on top": of what has it.
  if ((says(senses, RelationType::kOn) || says(senses, RelationType::kIn)) && !frames_.empty() && !frames_.back().room &&
      frames_.back().link >= 0 && frames_.back().hosts.size() == 1 && targets.size() == 1 && is_thing(frames_.back().hosts.front()) &&
      document_.links[static_cast<std::size_t>(frames_.back().link)].kind == Link::Kind::kHave && is_content(targets.front()))
    return frames_.back().hosts.front();
  if (const int host = side ? fronted_host() : -1; host >= 0 && !own(host)) return host;  // "on the desk: a lamp on the left side"
  if (side && (joiner_before_relation_ == Joiner::kNone)) {
    for (std::size_t l = document_.links.size(); l-- > sentence_links_;) {
      const Link& link = document_.links[l];
      if (!(says(link.senses, RelationType::kLeftOf) || says(link.senses, RelationType::kRightOf)) || link.references.empty()) continue;
      if (is_thing(link.references.front()) && !own(link.references.front()) && frames_are_room()) return link.references.front();
    }
  }
  if (table) {
    const auto fits = [&](int mention) {
      return mention >= 0 && is_thing(mention) && !own(mention) && is_table(lexicon_.catalog(), noun_of(mention));
    };
    for (std::size_t f = frames_.size(); f-- > 0;) {
      for (const int host : frames_[f].hosts) {
        if (fits(host)) return host;
      }
    }
    for (std::size_t r = roots_.size(); r-- > 0;) {
      if (fits(roots_[r])) return roots_[r];
    }
    for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
      if (fits(static_cast<int>(m))) return static_cast<int>(m);
    }
  }
  if (says(senses, RelationType::kBetween)) {
    const int one = implied_reference(targets, true, &senses);
    const bool looks =
        one >= 0 && std::any_of(document_.links.begin() + static_cast<std::ptrdiff_t>(sentence_links_), document_.links.end(),
                                [&](const Link& l) { return contains(l.targets, one) && says(l.senses, RelationType::kFacing); });
    return looks ? one : implied_group(targets);
  }
  const bool hosts = !frames_.empty() && !frames_.back().room;
  int meant = hosts ? -1 : implied_reference(targets, true, &senses);
  if (meant < 0) meant = implied_reference(targets, false, &senses);
  return meant >= 0 ? meant : implied_reference(targets);
}

// What the clause's things stand on where that was said first ("on the desk are a lamp and …"), or -1.
int DocumentReader::fronted_host() const {
  if (fronted_.empty()) return -1;
  const Link& link = document_.links[static_cast<std::size_t>(fronted_.front())];
  return says(link.senses, RelationType::kOn) && link.references.size() == 1 && is_thing(link.references.front()) ? link.references.front()
                                                                                                                  : -1;
}

bool DocumentReader::is_content(int mention) const {
  return std::any_of(frames_.begin(), frames_.end(), [&](const Frame& frame) {
    return frame.link >= 0 && contains(document_.links[static_cast<std::size_t>(frame.link)].targets, mention);
  });
}

bool DocumentReader::frames_are_room() const {
  return std::all_of(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.room; });
}

}  // namespace layoutbox::offline
