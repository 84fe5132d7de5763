// What a noun phrase is for: a thing of the clause, a reference, or contents.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

void DocumentReader::place_root(std::size_t k, int mention) {
  const NounPhrase& noun = noun_of(mention);
  const bool thing = is_thing(mention);
  // A subject after a verb opens a clause of its own; a command's objects share it.
  if (!subject_.empty() && !imperative_ && joiner_ != Joiner::kNone) {
    const bool room_list = in_room_list_;
    begin_clause();
    in_room_list_ = room_list;
  }
  if (imperative_ && is(next(k), ChunkKind::kVerb)) imperative_ = false;
  while (!frames_.empty() && !frames_.back().room) frames_.pop_back();
  reference_link_ = relative_host_ = -1;
  after_participle_ = false;
  roots_.push_back(mention);
  root_joiners_.push_back(joiner_);
  root_modified_.push_back(false);
  chain_ = {mention};
  if (!thing) return;
  // ", and a rug under the bed": has a place of its own.
  if ((joiner_ == Joiner::kComma || joiner_ == Joiner::kCommaAnd) && !fronted_.empty() && roots_.size() > clause_start_ + 1 &&
      is(next(k), ChunkKind::kRelation))
    fronted_.clear();
  // "each", "one": speaks of things that are there already.
  for (const int link : fronted_) {
    Link& waiting = link_at(link);
    if (!waiting.targets.empty() && waiting.references.empty())
      waiting.references = {mention};
    else if (waiting.references.empty() || !contains(waiting.references, mention)) {
      waiting.targets.push_back(mention);
      if (!waiting.references.empty() && is_thing(waiting.references.front())) fronted_topic_ = waiting.references.front();
      if (waiting.each) grow_for_sides(waiting, mention, waiting.references.empty() ? -1 : waiting.references.front());
      for (const int reference : waiting.references) {
        const NounPhrase& place = noun_of(reference);
        if (place.kind == NounKind::kCorner && place.determiner == Determiner::kEach && noun_of(mention).count <= 1)
          references_.grow(mention, 4);
        if (mention_at(reference).distributes && mention_at(reference).items.size() > 1)
          references_.grow(mention, mention_at(mention).items.size() * mention_at(reference).items.size());
      }
    }
    root_modified_.back() = true;
  }
  if (!imperative_ && hang_ && !fronted_.empty()) hang({mention}, k);  // "above the bed hangs a painting"
  if (imperative_) {
    if (joiner_ == Joiner::kNone) subject_.clear();
    subject_.push_back(mention);
    if (hang_) hang({mention}, k);
  }
  (void)noun;
  imply_adjective(mention, k);
}

void DocumentReader::place_reference(std::size_t k, int mention) {
  expects_reference_ = false;
  Link& link = link_at(reference_link_);
  link.references.push_back(mention);
  link.last = chunk(k).last;
  last_reference_ = static_cast<int>(k);
  if (noun_of(mention).kind == NounKind::kWall) last_wall_ = mention;
  const bool is_fronted = contains(fronted_, reference_link_) || reference_link_ == held_for_with_ || link.gap;
  if (!is_fronted && link.references.size() == 1) {
    link.targets = targets_for(link.senses, Direction::kDirect, noun_of(mention), after_participle_, mention);
    for (const int target : link.targets) {
      for (std::size_t r = 0; r < roots_.size(); ++r) {
        if (roots_[r] == target) root_modified_[r] = true;
      }
    }
    // Several at each side, desk or corner: as many as the places ask for.
    if (link.each && is_thing(mention)) {
      for (const int target : link.targets) grow_for_sides(link, target, mention);
    }
    if (mention_at(mention).reciprocal) mean_each_other(link);
    if (noun_of(mention).kind == NounKind::kCorner && noun_of(mention).determiner == Determiner::kEach) {
      for (const int target : link.targets) {
        if (noun_of(target).count == 0 || noun_of(target).count == 1) references_.grow(target, 4);
      }
    }
    if (mention_at(mention).distributes) {
      for (const int target : link.targets) {
        const std::size_t places = std::max<std::size_t>(mention_at(mention).items.size(), 1);
        if (mention_at(mention).distributes && places > 1) references_.grow(target, mention_at(target).items.size() * places);
      }
    }
    // A screen on a stand looks where the stand looks.
    if (says(link.senses, RelationType::kFacing) && chain_.size() > 1 && link.targets.size() == 1 &&
        link.targets.front() == chain_.back() && is_thing(chain_[chain_.size() - 2])) {
      const NounPhrase& carried = noun_of(chain_[chain_.size() - 2]);
      if (carried.head == "tv" || carried.head == "television" || carried.head == "monitor" || carried.head == "screen")
        link.targets.push_back(chain_[chain_.size() - 2]);
    }
    if (hang_ && !link.targets.empty()) {
      const NounKind kind = noun_of(mention).kind;
      const std::vector<int> hung = link.targets;  // `link` does not outlive a new one
      if (kind != NounKind::kWall && kind != NounKind::kCeiling) hang(hung, k);
      hang_ = false;
    }
  }
  if (is_thing(mention) && !is_fronted) chain_.push_back(mention);
}

void DocumentReader::place_content(std::size_t k, int mention) {
  const bool first = expects_content_;
  expects_content_ = false;
  if (frames_.empty()) {
    place_root(k, mention);
    return;
  }
  if (frames_.back().room) {
    place_root(k, mention);
    return;
  }
  const Frame frame = frames_.back();
  chain_.erase(
      std::remove_if(chain_.begin(), chain_.end(), [&](int m) { return frame.link >= 0 && contains(link_at(frame.link).targets, m); }),
      chain_.end());
  for (const int host : frame.hosts) {
    if (!contains(chain_, host)) chain_.push_back(host);
  }
  if (is_thing(mention)) {
    if (frame.link >= 0) {
      Link& link = link_at(frame.link);
      link.targets.push_back(mention);
      link.last = chunk(k).last;
      for (const int host : frame.hosts) {
        if (mention_at(host).distributes)
          references_.grow(mention, mention_at(mention).items.size() * std::max<std::size_t>(mention_at(host).items.size(), 1));
      }
    }
    imply_adjective(mention, k);
  }
  chain_.push_back(mention);
  reference_link_ = -1;
  after_participle_ = false;
  (void)first;
}

bool DocumentReader::goes_on_with_reference(std::size_t k, const NounPhrase& noun) const {
  if (reference_link_ < 0 || last_reference_ < 0) return false;
  const Link& link = document_.links[static_cast<std::size_t>(reference_link_)];
  const bool adjacent = next(next(static_cast<std::size_t>(last_reference_))) == k;
  if (!adjacent || link.references.empty()) return false;
  if (says(link.senses, RelationType::kBetween)) {
    const NounPhrase& first = noun_of(link.references.back());
    return joiner_ == Joiner::kAnd && link.references.size() == 1 && !first.is_plural();
  }
  if (joiner_ != Joiner::kAnd) return false;
  const NounPhrase& former = noun_of(link.references.back());
  const auto definite = [](const NounPhrase& n) {
    return n.determiner == Determiner::kDefinite || n.determiner == Determiner::kEach || n.determiner == Determiner::kBoth ||
           n.determiner == Determiner::kPossessive;
  };
  const bool place = former.kind != NounKind::kObject;
  if (place || noun.kind != NounKind::kObject) return place && noun.kind == former.kind && noun.kind != NounKind::kRoom;
  if (definite(former) != definite(noun)) return false;
  const std::size_t n = next(k);
  if (contains(fronted_, reference_link_)) return true;
  return !is(n, ChunkKind::kRelation) && !verb_at(n) && !is(n, ChunkKind::kParticiple) && !is(n, ChunkKind::kHave);
}

bool DocumentReader::goes_on_with_contents(std::size_t k, const NounPhrase& noun) const {
  if (frames_.empty() || joiner_ == Joiner::kNone) return false;
  const Frame& frame = frames_.back();
  if (frame.room || frame.link < 0) return false;
  const Link& link = document_.links[static_cast<std::size_t>(frame.link)];
  if (noun.kind != NounKind::kObject && !noun.collective && noun.kind != NounKind::kAbstract) return false;
  if (noun.kind == NounKind::kMember || link.targets.empty()) return false;
  const std::size_t n = next(k);
  if (verb_at(n)) {
    // "a cart stocked with glasses and bottles stands": the verb's number tells that the cart is its subject.
    const std::string& verb = document_.tokens[chunk(n).first].text;
    const bool singular = verb == "is" || verb == "was" || (verb != "was" && verb.ends_with("s"));
    return joiner_ == Joiner::kAnd && singular && noun.is_plural();
  }
  if (frame.hosts.empty()) return true;
  // "its top displaying …": the thing's.
  const NounPhrase& host =
      noun_of(frame.hosts.front()).kind == NounKind::kPart && is_thing(frame.hosts.front())
          ? document_.items[static_cast<std::size_t>(document_.mentions[static_cast<std::size_t>(frame.hosts.front())].items.front())].noun
          : noun_of(frame.hosts.front());
  if (host.kind == NounKind::kWall || host.kind == NounKind::kCorner) return joiner_ == Joiner::kAnd || joiner_ == Joiner::kComma;
  const Catalog& catalog = lexicon_.catalog();
  if (noun.kind == NounKind::kAbstract) return !noun.collective || joiner_ != Joiner::kNone;
  if (host.entry != nullptr && host.entry->thin) return false;
  // "a desk with a lamp, and a chair": two would not be parted by a comma.
  if (joiner_ == Joiner::kCommaAnd && link.kind == Link::Kind::kHave && !link.holding && link.targets.size() == 1) return false;
  // "each with a lamp and a chair", "a desk with a lamp and a chair"
  const bool last_of_list = joiner_ == Joiner::kAnd || (joiner_ == Joiner::kCommaAnd && link.targets.size() > 1);
  const bool bare_and = last_of_list && !is(n, ChunkKind::kRelation) && !is(n, ChunkKind::kHave);
  if (bare_and && (document_.mentions[static_cast<std::size_t>(frame.hosts.front())].distributes ||
                   (is_table(catalog, host) && is_seat(catalog, noun))))
    return true;
  const bool shares_article = joiner_ == Joiner::kAnd && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural &&
                              noun_of(link.targets.back()).determiner != Determiner::kNone;
  if (shares_article) return true;
  if (frame.after_comma && mount_of(noun) == Mount::kFloor) return false;
  const NounPhrase& former = noun_of(link.targets.back());
  const bool carried = may_carry(catalog, host, noun);
  if (link.kind == Link::Kind::kHave) {
    if (link.holding && mount_of(noun) == Mount::kSurface) return true;
    if (carried && (link.holding || may_carry(catalog, host, former))) return true;
    const bool on_top = is(n, ChunkKind::kRelation) && says(*chunk(n).phrase.senses, RelationType::kOn) && !is(next(n), ChunkKind::kNoun);
    if (joiner_ == Joiner::kAnd && on_top) return true;
    if (joiner_ == Joiner::kAnd) return mount_of(former) == mount_of(noun) && !is(n, ChunkKind::kRelation) && !is(n, ChunkKind::kHave);
    return false;
  }
  // "surrounded by a sofa and two ottomans", "flanked by a lamp and a plant".
  if (joiner_ == Joiner::kAnd) return !is(n, ChunkKind::kRelation) || carried;
  return carried && mount_of(former) == Mount::kSurface;
}

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
    if (root_joiners_[r] != Joiner::kNone && alike(roots_[r - 1])) {
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
    if (room_place && !apart && step == 0 && count > 1 && is_content(mention) &&
        (is_seat(catalog, noun) || mount_of(noun) == Mount::kSurface) && !hang_)
      score -= 12;
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

bool DocumentReader::is_content(int mention) const {
  return std::any_of(frames_.begin(), frames_.end(), [&](const Frame& frame) {
    return frame.link >= 0 && contains(document_.links[static_cast<std::size_t>(frame.link)].targets, mention);
  });
}

bool DocumentReader::frames_are_room() const {
  return std::all_of(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.room; });
}

std::size_t DocumentReader::previous(std::size_t k) const {
  while (k-- > 0) {
    if (!is(k, ChunkKind::kIgnored) && !is(k, ChunkKind::kSoft)) return k;
  }
  return document_.chunks.size();
}

void DocumentReader::hang(const std::vector<int>& targets, std::size_t k) {
  Link link;
  link.kind = Link::Kind::kHang;
  link.targets = targets;
  link.first = chunk(k).first;
  link.last = chunk(k).last;
  add_link(std::move(link));
}

}  // namespace layoutbox::offline
