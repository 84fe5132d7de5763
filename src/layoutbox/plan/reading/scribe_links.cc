// Writes the places that a reading found as links between mentions.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/scribe.h"

namespace layoutbox::offline {

int Scribe::add_link(int u, Link link) {
  document_.links.push_back(std::move(link));
  link_[static_cast<std::size_t>(u)] = static_cast<int>(document_.links.size()) - 1;
  return link_[static_cast<std::size_t>(u)];
}

void Scribe::hang(const std::vector<int>& targets, int u) {
  std::vector<int> things = targets;
  // "benches bolted on both sides": what is heavy and fastened stands where it is; only what is said to hang does.
  const std::size_t said = chunk(u).hang || u == 0 ? chunk(u).first : chunk(u - 1).first;
  const bool fastened = says_one_of(document_, said, WordSet::kFastened);
  std::erase_if(things, [&](int m) { return !is_thing(m) || (fastened && is_heavy(lexicon_.catalog(), noun_of(m))); });
  if (things.empty()) return;
  Link link;
  link.kind = Link::Kind::kHang;
  link.targets = things;
  link.first = chunk(u).first;
  link.last = chunk(u).last;
  link.soft = unit(u).soft;
  document_.links.push_back(std::move(link));
}

// The place's words, or the verb right before them, say that something is hung.
bool Scribe::hangs(int u) const {
  if (chunk(u).hang) return true;
  return u > 0 && (is(u - 1, UnitKind::kParticiple) || is(u - 1, UnitKind::kVerb)) && chunk(u - 1).hang;
}

// "side by side", "elbow to elbow", "stacked": of the things by each other.
bool Scribe::is_mutual(int u, const Link& link) const {
  const bool twice = chunk(u).last > chunk(u).first + 2 && document_.tokens[chunk(u).last - 1].text == word(u);
  return reading(u).implied == kNobody && (!link.targets.empty() || reading(u).fronted) &&
         (says(link.senses, RelationType::kStacked) || twice || word(u) == "side" || word(u) == "back");
}

// "three jars at its right end, a crate beneath": beneath the thing, not its end.
int Scribe::whole_of(int mention) {
  if (mention < 0 || mention_at(mention).noun.kind != NounKind::kPart || mention_at(mention).items.empty()) return mention;
  Mention whole = mention_at(mention);
  whole.noun = document_.items[static_cast<std::size_t>(whole.items.front())].noun;
  whole.introduces = false;
  document_.mentions.push_back(std::move(whole));
  return static_cast<int>(document_.mentions.size()) - 1;
}

// The list up to that noun, or those of it that share its place: "a bed by the window, a desk and a chair in the corner, a plant by them".
std::vector<int> Scribe::list_meant(int last) const {
  int first = -1;
  for (int p = last + 1; p < static_cast<int>(sentence_->size()); ++p) {
    const UnitReading& place = reading(p);
    if (is(p, UnitKind::kPlace) && place.subject == last && place.first_subject >= 0 && place.first_subject != last)
      first = place.first_subject;
  }
  std::vector<int> all;
  for (int m = last; m >= 0; m = m == first ? -1 : reading(m).former) all.insert(all.begin(), m);
  return all;
}

// Whom a place without a reference is by.
std::vector<int> Scribe::references_alone(int u, const Link& link) {
  const UnitReading& own = reading(u);
  if (is_mutual(u, link)) {
    Mention other;
    other.noun.kind = NounKind::kPronoun;
    other.reciprocal = true;
    document_.mentions.push_back(std::move(other));
    return {static_cast<int>(document_.mentions.size()) - 1};
  }
  if (!own.implied_list || own.implied < 0) {
    std::vector<int> meant = mentions_of(own.implied);
    for (int& m : meant) m = whole_of(m);
    return meant;
  }
  std::vector<int> all;
  for (const int m : list_meant(own.implied)) all.push_back(mention_[static_cast<std::size_t>(m)]);
  return says(link.senses, RelationType::kBetween) && all.size() != 2 ? std::vector<int>{combined(all)} : all;
}

// "between them": the other of the two, if only one was named.
void Scribe::complete_pair(int u, Link& link) {
  if (!says(link.senses, RelationType::kBetween) || link.references.size() != 1) return;
  const bool several = mention_at(link.references.front()).items.size() > 1;
  // "a phone at one end, a vase at the other, a bell between them"
  if (const std::vector<int> two = pair_named_last(u, link.targets); !several && two.size() == 2) {
    link.references = two;
    return;
  }
  const bool them = several && document_.tokens[chunk(u).last - 1].text == "them";
  const int other = them ? -1 : looked_at_by(link.references.front(), link.targets);
  if (other >= 0) link.references.push_back(other);
  const int pair = other < 0 && !several ? pair_just_related() : -1;
  if (pair >= 0) link.references = {pair};
  // "A sofa at the back wall and a TV at the front wall. Between is a table."
  const bool of_before = other < 0 && pair < 0 && !several && link.references.front() < sentence_mentions_;
  if (of_before && so_far_.roots.size() > 1) link.references = {so_far_.roots[so_far_.roots.size() - 2], so_far_.roots.back()};
}

// "on the left" of nothing: of the room.
void Scribe::mean_side_of_room(Link& link) {
  const bool left = says(link.senses, RelationType::kLeftOf), right = says(link.senses, RelationType::kRightOf);
  if (left != right) link.senses = {{RelationType::kInRegion, Direction::kAlone, {}, left ? RoomRegion::kLeft : RoomRegion::kRight, {}}};
}

// "long tables down both sides", "benches on three sides" of nothing: along the room's walls.
void Scribe::mean_sides_of_room(Link& link) {
  const bool stand = !link.targets.empty() && std::ranges::all_of(link.targets, [&](int m) {
    return is_thing(m) && noun_of(m).is_plural() && mount_of(noun_of(m)) == Mount::kFloor;
  });
  if (!says(link.senses, RelationType::kEachSideOf) || !stand) return;
  Mention walls;
  walls.noun.kind = NounKind::kWall;
  walls.noun.head = "wall";
  walls.noun.name = link.sides > 2 ? "wall" : "side wall";
  walls.noun.plural = true;
  walls.noun.determiner = Determiner::kBoth;
  walls.noun.count = link.sides > 2 ? link.sides : 2;
  document_.mentions.push_back(std::move(walls));
  link.references = {static_cast<int>(document_.mentions.size()) - 1};
  link.senses = {{RelationType::kAgainstWall, Direction::kDirect, {}, {}, {}}};
  link.each = false;
  const std::vector<int> targets = link.targets;
  for (const int target : targets) grow_along_walls(link, target, noun_of(link.references.front()));
}

// How many there are of what stands at the sides of something, or by each of several.
void Scribe::grow_alone(const Link& link) {
  const int by = link.references.empty() ? -1 : link.references.front();
  const std::vector<int> targets = link.targets;
  for (const int target : targets) {
    if (link.each) grow_for_sides(link, target, by);
    // "each with a lamp at its left and a bin at its right": a bin for each.
    if (link.references.size() != 1 || target == by || !mention_at(by).distributes) continue;
    const bool anew = is_thing(target) && mention_at(target).introduces && noun_of(target).determiner == Determiner::kIndefinite;
    if (anew) grow_for_each(target, by);
  }
}

void Scribe::write_place_alone(int u) {
  const UnitReading& own = reading(u);
  Link link = link_at_unit(u);
  if ((chunk(u).phrase.other || unit(u).other) && one_side_ >= 0 && takes_other_side(subjects_of(u))) return;
  link.senses = unit(u).alone.empty() ? unit(u).direct : unit(u).alone;
  if (!own.fronted) link.targets = subjects_of(u);
  if (link.each && !own.fronted) add_laden_stand(link.senses, link.targets);
  if (!is_mutual(u, link) && says(link.senses, RelationType::kDistance) && document_.links.size() > sentence_links_) {
    // "in front of it, at a distance of 50 cm": of what was placed last.
    link.targets = document_.links.back().targets;
    link.references = document_.links.back().references;
  } else if (says(link.senses, RelationType::kDistance) && link.targets.size() == 1 && mention_at(link.targets.front()).items.size() > 1) {
    link.senses = {{RelationType::kRow, Direction::kDirect, {}, {}, {}}};  // "two desks with a gap of 80 cm"
  } else {
    link.references = references_alone(u, link);
  }
  // "against the wall opposite", where nobody says of what
  if (says(link.senses, RelationType::kOpposite) && link.references.empty() &&
      words_between(document_, chunk(u).first, chunk(u).last).find("wall") != std::string::npos)
    link.senses = {{RelationType::kAgainstWall, Direction::kDirect, {}, {}, {}}};
  if (says(link.senses, RelationType::kCenterOfRoom) && !link.references.empty())
    link.senses = {{RelationType::kOn, Direction::kDirect, PartWord::kCenter, {}, {}}};
  if (says(link.senses, RelationType::kInRegion) && !link.references.empty()) {
    const bool back =
        std::any_of(link.senses.begin(), link.senses.end(), [](const PhraseSense& s) { return s.region == RoomRegion::kBack; });
    link.senses = {{back ? RelationType::kBehind : RelationType::kInFrontOf, Direction::kDirect, {}, {}, {}}};
  }
  if (link.references.empty()) mean_side_of_room(link);
  if (link.references.empty() && !is_mutual(u, link)) mean_sides_of_room(link);
  complete_pair(u, link);
  link.implied = true;
  link.other_side = unit(u).other && says(link.senses, RelationType::kNextTo);
  link.one_side = chunk(u).phrase.one && says(link.senses, RelationType::kNextTo);
  if (!own.fronted) grow_alone(link);
  const bool one_side = link.one_side;
  const std::vector<int> targets = link.targets;
  const int added = add_link(u, std::move(link));
  if (one_side) one_side_ = added;
  if (hangs(u) && !own.fronted) hang(targets, u);
}

// "center the sofa on the wall", "is centered on …".
bool Scribe::centers(int u) const {
  const auto says_so = [&](int v) {
    return v >= 0 && is(v, UnitKind::kVerb) && document_.tokens[chunk(v).last - 1].text.starts_with("center");
  };
  return (says_so(u - 1) || says_so(u - 2)) && is(u + 1, UnitKind::kNoun) && chunk(u + 1).noun.kind == NounKind::kWall;
}

void Scribe::write_place(int u) {
  const UnitReading& own = reading(u);
  if (own.alone) {
    write_place_alone(u);
    return;
  }
  if (own.role != NounRole::kUnread || (!own.fronted && own.subject == kNobody && !own.inverse && !chunk(u).gap)) {
    if (!is(u + 1, UnitKind::kNoun) || reading(u + 1).predicate != u) return;  // says nothing
  }
  Link link = link_at_unit(u);
  link.senses = own.inverse && !unit(u).inverse.empty() ? unit(u).inverse : unit(u).direct;
  // "two sofas facing each other across a table": between them.
  if (own.inverse && unit(u).inverse.empty() && own.implied_list) link.senses = {{RelationType::kBetween, Direction::kDirect, {}, {}, {}}};
  if (own.inverse) {
    if (!own.fronted) link.references = own.subject == u + 1 ? std::vector<int>{} : subjects_of(u);
  } else if (!own.fronted) {
    link.targets = subjects_of(u);
  }
  if (!own.fronted && !own.inverse && own.implied != kNobody && verb_ends(u)) place_where(u, link.targets);
  if (centers(u)) link.senses.insert(link.senses.begin(), {RelationType::kCenteredOnWall, Direction::kDirect, {}, {}, {}});
  if (chunk(u).kind == ChunkKind::kPurpose) {  // "one lamp for each desk"
    link.kind = Link::Kind::kHave;
    link.weak = true;
  }
  link.one_side = chunk(u).phrase.one && says(link.senses, RelationType::kNextTo);
  link.other_side = unit(u).other && says(link.senses, RelationType::kNextTo);
  const bool one_side = link.one_side;
  const int added = add_link(u, std::move(link));
  if (one_side) one_side_ = added;
}

// A place that is a verb: "face", "lean on".
bool Scribe::verb_ends(int u) const { return is_finite(word(u)) || lexicon_.is_place_verb(word(u)); }

// "a table where two chairs face each other": the table has them.
void Scribe::place_where(int u, const std::vector<int>& targets) {
  Link link = link_at_unit(u);
  link.kind = Link::Kind::kHave;
  link.weak = true;
  link.targets = targets;
  link.references = mentions_of(reading(u).implied);
  if (!link.references.empty() && is_thing(link.references.front())) document_.links.push_back(std::move(link));
}

// "Across the table two chairs face each other": the table is between them.
void Scribe::mean_between(int u, const Link& looking) {
  for (int p = u; p-- > 0;) {
    const int index = is(p, UnitKind::kPlace) ? link_[static_cast<std::size_t>(p)] : -1;
    if (index < 0 || !reading(p).fronted || word(p) != "across") continue;
    Link& across = link_at(index);
    if (across.targets != looking.targets || across.references.size() != 1 || !is_thing(across.references.front())) return;
    across.senses = {{RelationType::kBetween, Direction::kDirect, {}, {}, {}}};
    std::swap(across.targets, across.references);
    return;
  }
}

// "Two armchairs facing two others across a table": the table at u is between them.
void Scribe::lies_between(int u, int mention) {
  Link& across = link_at(link_[static_cast<std::size_t>(u)]);
  for (int p = u; p-- > 0 && is_thing(mention);) {
    const int index = is(p, UnitKind::kPlace) ? link_[static_cast<std::size_t>(p)] : -1;
    if (index < 0 || link_at(index).targets != across.targets || !says(link_at(index).senses, RelationType::kFacing)) continue;
    const std::vector<int> seen = link_at(index).references;
    if (seen.size() != 1 || !is_thing(seen.front()) || mention_at(seen.front()).reciprocal || across.targets.size() != 1) return;
    if (noun_of(seen.front()).head != noun_of(across.targets.front()).head || chunk(u).last - chunk(u).first != 1) return;
    across.references = across.targets;
    across.references.push_back(seen.front());
    across.targets = {mention};
    across.senses = {{RelationType::kBetween, Direction::kDirect, {}, {}, {}}};
    return;
  }
}

// "On one side of the stage a speaker, on the other a drum": one on either side.
void Scribe::join_sides() {
  if (one_side_ < 0) return;
  for (std::size_t l = static_cast<std::size_t>(one_side_) + 1; l < document_.links.size(); ++l) {
    Link& other = document_.links[l];
    if (!other.other_side || link_at(one_side_).targets.empty() || other.targets.empty()) continue;
    takes_other_side(std::exchange(other.targets, {}));
    return;
  }
}

}  // namespace layoutbox::offline
