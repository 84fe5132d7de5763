// What a noun phrase is for: a thing of the clause, a reference, or contents.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {
namespace {

// "in every corner" four, "in each of the two far corners" two.
std::size_t corners_meant(const NounPhrase& corner) {
  if (corner.count > 0) return static_cast<std::size_t>(corner.count);
  return corner.wall_word.empty() ? 4 : 2;  // "in each back corner"
}

}  // namespace

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
      (is(next(k), ChunkKind::kRelation) || (is(next(k), ChunkKind::kParticiple) && is(next(next(k)), ChunkKind::kRelation))) &&
      chunk(k).noun.kind == NounKind::kObject && !lies_there(k))
    fronted_.clear();
  // "each", "one": speaks of things that are there already.
  for (const int link : fronted_) {
    Link& waiting = link_at(link);
    if (chunk(k).noun.subset && !waiting.targets.empty()) continue;  // "…, one of which holds a lamp"
    if (!waiting.targets.empty() && waiting.references.empty())
      waiting.references = {mention};
    else if (waiting.references.empty() || !contains(waiting.references, mention)) {
      waiting.targets.push_back(mention);
      if (!waiting.references.empty() && is_thing(waiting.references.front())) fronted_topic_ = waiting.references.front();
      if (waiting.each) grow_for_sides(waiting, mention, waiting.references.empty() ? -1 : waiting.references.front());
      for (const int reference : waiting.references) {
        const NounPhrase& place = noun_of(reference);
        if (place.kind == NounKind::kCorner && place.determiner == Determiner::kEach && noun_of(mention).count <= 1)
          references_.grow(mention, corners_meant(place));
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

// "on the altar two candles and a bible in the middle": in the middle of the altar.
bool DocumentReader::lies_there(std::size_t k) const {
  const std::size_t r = next(k);
  const bool small = mount_of(chunk(k).noun) == Mount::kSurface || chunk(k).noun.entry == nullptr;
  if (fronted_.empty() || !small || !is(r, ChunkKind::kRelation) || is(next(r), ChunkKind::kNoun)) return false;
  return says(document_.links[static_cast<std::size_t>(fronted_.front())].senses, RelationType::kOn) &&
         has_direction(*chunk(r).phrase.senses, Direction::kAlone);
}

void DocumentReader::place_reference(std::size_t k, int mention) {
  expects_reference_ = false;
  Link& link = link_at(reference_link_);
  link.references.push_back(mention);
  link.last = chunk(k).last;
  last_reference_ = static_cast<int>(k);
  if (noun_of(mention).kind == NounKind::kWall) last_wall_ = last_wall_said_ = mention;
  const NounKind place = noun_of(mention).kind;
  const bool of_room = place == NounKind::kWall || place == NounKind::kCorner || place == NounKind::kCeiling;
  const int chained = of_room ? reference_link_ : -1;
  const bool is_fronted = contains(fronted_, reference_link_) || reference_link_ == held_for_with_ || link.gap;
  if (!is_fronted && link.references.size() == 1) {
    link.targets = chained_targets(link, mention);
    if (link.targets.empty()) link.targets = targets_for(link.senses, Direction::kDirect, noun_of(mention), after_participle_, mention);
    if (link.each) add_laden_stand(link.senses, link.targets);
    for (const int target : link.targets) {
      for (std::size_t r = 0; r < roots_.size(); ++r) {
        if (roots_[r] == target) root_modified_[r] = true;
      }
    }
    // Several at each side, desk or corner: as many as the places ask for.
    const bool has_sides = is_thing(mention) || noun_of(mention).kind == NounKind::kWindow || noun_of(mention).kind == NounKind::kDoor;
    if (link.each && has_sides) {
      for (const int target : link.targets) grow_for_sides(link, target, mention);
    }
    if (mention_at(mention).reciprocal) mean_each_other(link);
    if (noun_of(mention).kind == NounKind::kCorner && noun_of(mention).determiner == Determiner::kEach) {
      for (const int target : link.targets) {
        if (noun_of(target).count <= 1) references_.grow(target, corners_meant(noun_of(mention)));
      }
    }
    // "three chairs, each facing a mirror": a mirror for each.
    if (mention_at(mention).introduces && mention_at(mention).items.size() == 1 && noun_of(mention).determiner == Determiner::kIndefinite &&
        link.targets.size() == 1 && mention_at(link.targets.front()).distributes && !mention_at(link.targets.front()).introduces)
      references_.grow(mention, mention_at(link.targets.front()).items.size());
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
      // "a shelf mounted on the wall": not before it.
      if (kind == NounKind::kWall && says(link.senses, RelationType::kOnWall))
        link.senses = {{RelationType::kOnWall, Direction::kDirect, {}, {}, {}}};
      hang_ = false;
    }
  }
  if (is_thing(mention) && !is_fronted) chain_.push_back(mention);
  place_link_ = chained;
  place_chunk_ = k;
}

// "a rack on the wall above the stove", "a lamp in the corner by the door": the second place is of the same thing.
std::vector<int> DocumentReader::chained_targets(const Link& link, int reference) const {
  if (place_link_ < 0 || joiner_before_relation_ != Joiner::kNone ||
      previous(previous(static_cast<std::size_t>(last_reference_))) != place_chunk_)
    return {};
  const std::vector<int>& targets = document_.links[static_cast<std::size_t>(place_link_)].targets;
  if (targets.empty() ||
      document_.mentions[static_cast<std::size_t>(targets.front())].items == document_.mentions[static_cast<std::size_t>(reference)].items)
    return {};
  return choose_sense(lexicon_.catalog(), link.senses, Direction::kDirect, noun_of(targets.front()), noun_of(reference))
             ? targets
             : std::vector<int>{};
}

void DocumentReader::place_content(std::size_t k, int mention) {
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
      grow_for_hosts(mention, frame.hosts);
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

// Did an "and" come before the last of several?
bool DocumentReader::ended_list(const Link& link) const {
  if (link.targets.size() < 2) return false;
  const NounPhrase &former = noun_of(link.targets[link.targets.size() - 2]), &last = noun_of(link.targets.back());
  return former.last <= last.first && last.first <= document_.tokens.size() &&
         std::any_of(document_.tokens.begin() + static_cast<std::ptrdiff_t>(former.last),
                     document_.tokens.begin() + static_cast<std::ptrdiff_t>(last.first), [&](const Token& t) { return t.text == "and"; });
}

bool DocumentReader::goes_on_with_contents(std::size_t k, const NounPhrase& noun) const {
  if (frames_.empty() || joiner_ == Joiner::kNone) return false;
  const Frame& frame = frames_.back();
  if (frame.room || frame.link < 0) return false;
  const Link& link = document_.links[static_cast<std::size_t>(frame.link)];
  if (noun.kind != NounKind::kObject && !noun.collective && noun.kind != NounKind::kAbstract) return false;
  if (noun.kind == NounKind::kMember || link.targets.empty()) return false;
  // "each with a chair and a monitor, a printer …": the list ended with its "and".
  if (joiner_ != Joiner::kAnd && ended_list(link)) return false;
  // "a cabinet with instruments along the wall, a lamp above the chair": it ended where the cabinet itself was placed.
  const auto places_host = [&](const Link& later) {
    return later.kind == Link::Kind::kRelation && !frame.hosts.empty() && contains(later.targets, frame.hosts.front());
  };
  if (joiner_ == Joiner::kComma && std::any_of(document_.links.begin() + frame.link + 1, document_.links.end(), places_host)) return false;
  const std::size_t n = next(k);
  if (verb_at(n)) {
    // "a cart stocked with glasses and bottles stands": the verb's number tells that the cart is its subject.
    const std::string& verb = document_.tokens[chunk(n).first].text;
    const bool singular = verb == "is" || verb == "was" || (verb != "was" && verb.ends_with("s"));
    // "a sink with a soap dispenser and a holder is next to it": the sink is.
    const bool host_waits = !frame.hosts.empty() && !roots_.empty() && frame.hosts.front() == roots_.back() && !frame.after_comma &&
                            link.kind == Link::Kind::kHave && subject_.empty() && !noun_of(roots_.back()).is_plural();
    if (joiner_ == Joiner::kAnd && singular && host_waits && mount_of(noun) != Mount::kFloor) return true;
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
  const bool each_other = is(n, ChunkKind::kRelation) && is(next(n), ChunkKind::kNoun) && chunk(next(n)).noun.reciprocal;
  const bool placed = last_reference_ >= 0 && chunk(static_cast<std::size_t>(last_reference_)).first >= noun_of(link.targets.back()).last;
  if (placed && link.kind == Link::Kind::kHave && mount_of(noun) == Mount::kFloor)
    return false;  // "with two chairs by the door and a sofa"
  const bool bare_and = last_of_list && (!is(n, ChunkKind::kRelation) || each_other) && !is(n, ChunkKind::kHave);
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
    if (carried && (link.holding || may_carry(catalog, host, former) || mount_of(noun) == Mount::kSurface)) return true;
    const bool on_top = is(n, ChunkKind::kRelation) && says(*chunk(n).phrase.senses, RelationType::kOn) && !is(next(n), ChunkKind::kNoun);
    if (joiner_ == Joiner::kAnd && on_top) return true;
    if (joiner_ == Joiner::kAnd) return mount_of(former) == mount_of(noun) && !is(n, ChunkKind::kRelation) && !is(n, ChunkKind::kHave);
    return false;
  }
  // "surrounded by a sofa and two ottomans", "flanked by a lamp and a plant".
  if (joiner_ == Joiner::kAnd) return !is(n, ChunkKind::kRelation) || carried;
  return carried && mount_of(former) == Mount::kSurface;
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
