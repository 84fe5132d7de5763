// What a noun is for: a reference, contents, a thing of the clause; and how many of it there are for that.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/scribe.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// "every table has a candle": there for each of them.
bool Scribe::is_one_of_each(int mention) const {
  if (!is_thing(mention) || mention_at(mention).items.size() < 2 || noun_of(mention).determiner != Determiner::kIndefinite) return false;
  return std::any_of(document_.links.begin() + static_cast<std::ptrdiff_t>(sentence_links_), document_.links.end(), [&](const Link& link) {
    return contains(link.targets, mention) && link.references.size() == 1 && is_thing(link.references.front()) &&
           mention_at(link.references.front()).distributes;
  });
}

namespace {

// "mirrors in front of each chair", "pictures above each bed": one for each; but "pillows on each bed", "chairs around each table".
bool comes_singly(const NounPhrase& said, const PhraseSenses& senses) {
  return said.plural && said.count == 0 && said.determiner == Determiner::kNone && !says(senses, &RelationTraits::rests) &&
         !says(senses, RelationType::kAround) && !says(senses, RelationType::kSurround);
}

}  // namespace

// What is put by several things is as many: one at each of them, at each of their sides, in every corner. `both`: "on both nightstands".
void Scribe::grow_for_reference(int index, int mention, bool both) {
  Link& link = link_at(index);
  const NounPhrase noun = noun_of(mention);
  const std::vector<int> targets = link.targets;
  const bool has_sides = is_thing(mention) || noun.kind == NounKind::kWindow || noun.kind == NounKind::kDoor;
  const std::size_t hosts = mention_at(mention).distributes ? mention_at(mention).items.size() : 1;
  if (link.each && has_sides) {
    for (const int target : targets) {
      const std::size_t before = mention_at(target).items.size();
      grow_for_sides(link, target, mention);
      // "at either end of each sofa": two for every one.
      const std::size_t sided = mention_at(target).items.size();
      if (mention_at(target).introduces && hosts > 1 && sided > before) references_.grow(target, sided * hosts);
    }
  }
  if (mention_at(mention).reciprocal) mean_each_other(link);
  for (const int target : targets) grow_for_corners(noun, target);
  for (const int target : targets) grow_along_walls(link, target, noun);
  // "three chairs, each facing a mirror": a mirror for each.
  if (mention_at(mention).introduces && mention_at(mention).items.size() == 1 && noun.determiner == Determiner::kIndefinite &&
      targets.size() == 1 && mention_at(targets.front()).distributes && !mention_at(targets.front()).introduces)
    references_.grow(mention, mention_at(targets.front()).items.size());
  // "every table has a candle in a bottle": a bottle for each.
  if (mention_at(mention).introduces && mention_at(mention).items.size() == 1 && noun.determiner == Determiner::kIndefinite &&
      targets.size() == 1 && is_one_of_each(targets.front()))
    references_.grow(mention, mention_at(targets.front()).items.size());
  // "three chairs facing mirrors": as many.
  if (mention_at(mention).introduces && noun.plural && noun.count == 0 && noun.determiner == Determiner::kNone && targets.size() == 1 &&
      noun_of(targets.front()).count > 2 && says(link.senses, RelationType::kFacing))
    references_.grow(mention, mention_at(targets.front()).items.size());
  // "three mirrors and three chairs, each facing a mirror": every one its own.
  if (!mention_at(mention).introduces && noun.determiner == Determiner::kIndefinite && targets.size() == 1 &&
      mention_at(targets.front()).distributes)
    references_.mean_one_for_each(mention, mention_at(targets.front()).items.size());
  grow_for_every(index, mention);
  grow_on_some(link_at(index), mention);
  grow_on_all(link_at(index), mention, both);
}

// One at each of several.
void Scribe::grow_for_every(int index, int mention) {
  if (!mention_at(mention).distributes || mention_at(mention).items.size() < 2) return;
  const std::vector<int> targets = link_at(index).targets;
  for (const int target : targets) {
    // "five placemats lie around the bowl, one … each chair": as many as there are.
    // "Two lamps, one on each": those two
    const bool agree = mention_at(target).items.size() == mention_at(mention).items.size() &&
                       (is_placed_before(target, index) || !mention_at(target).introduces);
    if (comes_singly(noun_of(target), link_at(index).senses) && mention_at(target).items.size() <= 2)
      references_.grow(target, mention_at(mention).items.size());
    else if (!agree)
      grow_for_each(target, mention);
  }
}

// "candles and mugs on all the tables", "a lamp on both nightstands", "on either one": on each of them.
void Scribe::grow_on_all(const Link& link, int mention, bool both) {
  if (!says(link.senses, RelationType::kOn) || mention_at(mention).items.size() < 2) return;
  const NounPhrase noun = noun_of(mention);
  const std::size_t word = noun.first > 0 && document_.tokens[noun.first].text != "all" ? noun.first - 1 : noun.first;
  const bool all = noun.is_plural() && document_.tokens[word].text == "all";
  const std::vector<int> targets = link.targets;
  for (const int target : targets) {
    const NounPhrase& thing = noun_of(target);
    if (!mention_at(target).introduces) continue;
    if (both && thing.determiner == Determiner::kIndefinite) {
      grow_for_each(target, mention);
    } else if (all && thing.plural && thing.count == 0) {
      references_.grow(target, std::max(mention_at(target).items.size(), mention_at(mention).items.size()));
    }
  }
}

void Scribe::fill_reference(int u, int mention) {
  const UnitReading& own = reading(u);
  const int index = link_[static_cast<std::size_t>(own.predicate)];
  if (index < 0) return;
  // "a plant on the other": on the other side.
  if (chunk(u).noun.kind == NounKind::kMember && chunk(u).noun.determiner == Determiner::kOther && one_side_ >= 0 &&
      takes_other_side(link_at(index).targets)) {
    link_at(index).senses = {};
    return;
  }
  Link& link = link_at(index);
  const bool arranged = reading(own.predicate).inverse && own.predicate + 1 == u && is(own.predicate, UnitKind::kPlace) &&
                        !unit(own.predicate).direct.empty();
  link.references.push_back(mention);
  link.last = chunk(u).last;
  const UnitReading& place = reading(own.predicate);
  for (const int wall : link.targets) grow_along_walls(link, mention, noun_of(wall));  // "a wall covered in bookshelves"
  if (!place.fronted && !link.gap) grow_at_two_walls(link);
  if (place.fronted || link.gap || arranged || link.references.size() != 1) return;
  if (link.each) add_laden_stand(link.senses, link.targets);
  const NounPhrase noun = noun_of(mention);
  const std::vector<int> targets = link.targets;
  grow_for_reference(index, mention, chunk(u).noun.determiner == Determiner::kBoth);
  if (mention_at(mention).reciprocal) mean_between(own.predicate, Link(link_at(index)));
  if (word(own.predicate) == "across") lies_between(own.predicate, mention);
  follow_screen(link, own.predicate);
  const bool hung = hangs(own.predicate) || is_told_to_hang(own.predicate);
  if (hung && !targets.empty()) {
    // "a shelf mounted on the wall": not before it.
    if (noun.kind == NounKind::kWall && says(link.senses, RelationType::kOnWall))
      link.senses = {{RelationType::kOnWall, Direction::kDirect, {}, {}, {}}};
    if (noun.kind != NounKind::kWall && noun.kind != NounKind::kCeiling && noun.kind != NounKind::kFloor) hang(targets, own.predicate);
  }
  imply_opposite(u, noun, index);  // `link` does not outlive a new one
}

// "Mount the rack to the wall": the verb was a command.
bool Scribe::is_told_to_hang(int u) const {
  const int thing = reading(u).subject;
  for (int v = 0; v < thing; ++v) {
    if (is(v, UnitKind::kVerb) && chunk(v).hang && reading(v).subject == thing) return true;
  }
  return false;
}

// A screen on a stand looks where the stand looks.
void Scribe::follow_screen(Link& link, int u) const {
  if (!says(link.senses, RelationType::kFacing) || link.targets.size() != 1 || reading(u).subject < 0) return;
  const UnitReading& subject = reading(reading(u).subject);
  if (subject.role != NounRole::kReference || subject.predicate < 0) return;
  for (const int carried : subjects_of(subject.predicate)) {
    if (!is_thing(carried)) continue;
    const std::string& head = noun_of(carried).head;
    if (head == "tv" || head == "television" || head == "monitor" || head == "screen") link.targets.push_back(carried);
  }
}

// "lockers with a bench in front and cubbies underneath": by the bench, which they have as well; not one for each of them.
bool Scribe::is_put_by_fellow(int u) const {
  for (std::size_t p = static_cast<std::size_t>(u) + 1; p < sentence_->size(); ++p) {
    const int place = static_cast<int>(p);
    if (!is(place, UnitKind::kPlace) || !reading(place).alone || reading(place).subject != u) continue;
    const Referent by = reading(place).implied;
    return by >= 0 && by < u && reading(by).role == NounRole::kContent && reading(by).predicate == reading(u).predicate;
  }
  return false;
}

void Scribe::fill_content(int u, int mention) {
  int index = link_[static_cast<std::size_t>(reading(u).predicate)];
  if (!is_thing(mention) || index < 0) return;
  if (reading(u).subject != kNobody) {  // the having is not said again
    Link again = link_at(index);
    again.targets.clear();
    again.references = subjects_of(u);
    document_.links.push_back(std::move(again));
    index = static_cast<int>(document_.links.size()) - 1;
  }
  Link& link = link_at(index);
  link.targets.push_back(mention);
  link.last = chunk(u).last;
  // "Flank the bed with two lamps": the bed was named as the reference.
  const std::vector<int> hosts = link.references;
  if (link.kind == Link::Kind::kHave && !is_put_by_fellow(u)) grow_for_hosts(mention, hosts);
  // "On every table a candle with a mill beside it": one for each of the candles that one word brought in.
  const bool held = link.kind == Link::Kind::kHave || says(link.senses, &RelationTraits::rests);  // "a nightstand carrying a lamp"
  if (held && hosts.size() == 1 && mention_at(mention).introduces && !noun_of(hosts.front()).is_plural() &&
      mention_at(hosts.front()).introduces && !mention_at(hosts.front()).distributes && mention_at(hosts.front()).items.size() > 1 &&
      mention_at(mention).items.size() < mention_at(hosts.front()).items.size())
    references_.grow(mention, mention_at(mention).items.size() * mention_at(hosts.front()).items.size());
  for (const int host : hosts) {
    if (mention_at(host).distributes) grow_for_each(mention, host);
  }
  for (const int host : hosts) {
    grow_for_corners(noun_of(host), mention);
    grow_along_walls(link, mention, noun_of(host));
  }
  place_with_zone(hosts, index);
  imply_adjective(u, mention);
}

// "a reading corner by the window with an armchair": the armchair is by the window.
void Scribe::place_with_zone(const std::vector<int>& hosts, int index) {
  if (hosts.size() != 1 || is_thing(hosts.front())) return;
  const int added = link_at(index).targets.back();
  bool placed = false;
  for (std::size_t l = sentence_links_; l < static_cast<std::size_t>(index); ++l) {
    Link& place = document_.links[l];
    if (place.kind != Link::Kind::kRelation || !contains(place.targets, hosts.front())) continue;
    place.targets.push_back(added);
    placed = true;
  }
  const NounPhrase& zone = noun_of(hosts.front());
  const bool said = zone.kind == NounKind::kCorner && zone.determiner == Determiner::kDefinite;  // "the corner by the window has …"
  if (placed && zone.wall_word.empty() && !said) link_at(index).senses.clear();
}

// As many as the place at p, which comes first, has of them.
void Scribe::grow_fronted(int p, int mention) {
  const int at = link_[static_cast<std::size_t>(p)];
  Link& waiting = link_at(at);
  if (waiting.each) grow_for_sides(waiting, mention, waiting.references.empty() ? -1 : waiting.references.front());
  const std::vector<int> references = waiting.references;
  for (const int reference : references) {
    const NounPhrase wall = noun_of(reference);
    if (is(p + 1, UnitKind::kNoun)) imply_opposite(p + 1, wall, at);
    grow_for_corners(noun_of(reference), mention);
    grow_on(waiting, mention, reference);
    const bool on_all = chunk(p + 1).noun.determiner == Determiner::kBoth && says(link_at(at).senses, RelationType::kOn) &&
                        noun_of(mention).determiner == Determiner::kIndefinite;  // "on both tables stands a lamp"
    if (mention_at(reference).distributes || on_all) grow_for_each(mention, reference);
  }
}

void Scribe::fill_root(int u, int mention) {
  const NounKind kind = noun_of(mention).kind;
  const bool opening = kind == NounKind::kDoor || kind == NounKind::kWindow;  // "on the right wall is a window"
  if (!is_thing(mention) && !opening) return;
  for (int p = 0; p < u; ++p) {
    const UnitReading& place = reading(p);
    if (unit(p).kind != UnitKind::kPlace || !place.fronted || place.subject == kNobody || link_[static_cast<std::size_t>(p)] < 0) continue;
    bool mine = place.first_subject == u;
    for (int m = place.subject; m >= 0; m = reading(m).former) {
      mine |= m == u;
      if (m == place.first_subject) break;
    }
    if (!mine) continue;
    Link& waiting = link_at(link_[static_cast<std::size_t>(p)]);
    if (place.inverse) {
      waiting.references.push_back(mention);
      continue;
    }
    if (chunk(u).noun.subset && !waiting.targets.empty()) continue;  // "…, one of which holds a lamp"
    waiting.targets.push_back(mention);
    if (!opening) grow_fronted(p, mention);
  }
  for (int v = 0; v < u; ++v) {
    if (!is(v, UnitKind::kVerb) || !chunk(v).hang) continue;
    bool mine = false;
    for (int m = u; m >= 0; m = reading(m).former) mine |= reading(v).subject == m;
    // "Hang a picture over the bed": over it, and on the wall.
    if (mine) hang({mention}, v);
  }
  imply_adjective(u, mention);
}

// "a lamp on one side of the sofa and a plant on the other": one on either side. False when no first side waits.
bool Scribe::takes_other_side(const std::vector<int>& targets) {
  if (one_side_ < 0 || targets.empty()) return false;
  Link& link = link_at(one_side_);
  if (link.targets.empty()) return false;
  // "each bed has a locker on one side and a stand on the other": as many of either.
  const std::size_t first = mention_at(link.targets.front()).items.size();
  const std::size_t hosts = link.references.empty() ? 0 : mention_at(link.references.front()).items.size();
  if (hosts > 1 && first == hosts) {
    for (const int target : targets) {
      if (mention_at(target).introduces && mention_at(target).items.size() == 1) references_.grow(target, hosts);
    }
  }
  link.targets.insert(link.targets.end(), targets.begin(), targets.end());
  link.senses = {{RelationType::kEachSideOf, Direction::kDirect, {}, {}, {}}};
  link.one_side = false;
  one_side_ = -1;
  return true;
}

// "a rack of dumbbells": the dumbbells are on it; "a bench of plants": small ones.
void Scribe::add_named_contents(int u, int host) {
  const NounPhrase& noun = chunk(u).noun;
  if (noun.contents == nullptr || !is_thing(host) || !mention_at(host).introduces || !one_of(noun_of(host).head, WordSet::kStorageOf))
    return;
  NounPhrase things = *noun.contents;
  if (const CatalogEntry* small = kind_at(lexicon_.catalog(), things.category, KinPlace::kOnThing); small != nullptr)
    things.entry = small, things.category = small->id;
  if (!may_carry(lexicon_.catalog(), noun_of(host), things)) return;
  const int content = references_.mention(things, -1, false);
  references_.grow(content, mention_at(content).items.size() * mention_at(host).items.size());
  Link link;
  link.kind = Link::Kind::kHave;
  link.holding = true;
  link.targets = {content};
  link.references = {host};
  link.first = chunk(u).first;
  link.last = chunk(u).last;
  document_.links.push_back(std::move(link));
}

bool Scribe::is_placed_before(int mention, int link) const {
  for (std::size_t l = sentence_links_; l < static_cast<std::size_t>(link); ++l) {
    if (document_.links[l].kind == Link::Kind::kRelation && contains(document_.links[l].targets, mention)) return true;
  }
  return false;
}

}  // namespace layoutbox::offline
