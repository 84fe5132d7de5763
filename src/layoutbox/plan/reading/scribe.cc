#include "layoutbox/plan/reading/scribe.h"

#include <algorithm>

#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

void Scribe::write(const Sentence& sentence, const SentenceReading& reading) {
  sentence_ = &sentence;
  reading_ = &reading;
  mention_.assign(sentence.size(), -1);
  link_.assign(sentence.size(), -1);
  one_side_ = -1;
  sentence_links_ = document_.links.size();
  for (int u = 0; u < static_cast<int>(sentence.size()); ++u) {
    switch (unit(u).kind) {
      case UnitKind::kNoun: write_noun(u); break;
      case UnitKind::kPlace: write_place(u); break;
      case UnitKind::kHave: write_have(u); break;
      case UnitKind::kVerb: write_verb(u); break;
      case UnitKind::kParticiple: write_participle(u); break;
      case UnitKind::kSize: write_size(u); break;
      case UnitKind::kAttribute: write_attribute(u); break;
      default: break;
    }
  }
  end_sentence();
}

// What the next sentence's "it" and "opposite" may mean.
void Scribe::end_sentence() {
  std::vector<int> roots;
  int fronted = -1;
  for (int u = 0; u < static_cast<int>(sentence_->size()); ++u) {
    const UnitReading& own = reading(u);
    if (unit(u).kind == UnitKind::kNoun && (own.role == NounRole::kRoot || own.role == NounRole::kMember) &&
        is_thing(mention_[static_cast<std::size_t>(u)]))
      roots.push_back(mention_[static_cast<std::size_t>(u)]);
    if (unit(u).kind == UnitKind::kPlace && own.fronted && own.subject != kNobody && link_[static_cast<std::size_t>(u)] >= 0) {
      const std::vector<int>& references = link_at(link_[static_cast<std::size_t>(u)]).references;
      if (!references.empty() && is_thing(references.front()) && !own.inverse) fronted = references.front();
    }
  }
  so_far_.fronted = fronted;
  if (!roots.empty()) {
    so_far_.topic = roots.front();
    so_far_.roots = std::move(roots);
  }
}

void Scribe::mark(int u, Use use, const std::string& role) {
  for (std::size_t i = chunk(u).first; i < chunk(u).last; ++i) {
    document_.readings[i].use = use;
    document_.readings[i].role = role;
  }
}

std::vector<int> Scribe::mentions_of(Referent referent) const {
  if (is_mention(referent)) return {mention_of(referent)};
  if (referent < 0 || mention_[static_cast<std::size_t>(referent)] < 0) return {};
  return {mention_[static_cast<std::size_t>(referent)]};
}

// The mentions that the unit's place, having or verb is said of.
std::vector<int> Scribe::subjects_of(int u) const {
  const UnitReading& own = reading(u);
  if (own.subject < 0) return mentions_of(own.subject);
  std::vector<int> all;
  for (int m = own.subject; m >= 0; m = reading(m).former) {
    // "both", "all": every single one of the list.
    const UnitReading& member = reading(m);
    if (member.role == NounRole::kMember && member.whole_list && member.meant >= 0 && !is(u, UnitKind::kHave)) {
      for (int l = member.meant; l >= 0; l = reading(l).former) {
        if (mention_[static_cast<std::size_t>(l)] >= 0 && is_thing(mention_[static_cast<std::size_t>(l)]))
          all.insert(all.begin(), mention_[static_cast<std::size_t>(l)]);
      }
    } else if (mention_[static_cast<std::size_t>(m)] >= 0) {
      all.insert(all.begin(), mention_[static_cast<std::size_t>(m)]);
    }
    if (m == own.first_subject || own.first_subject < 0) break;
  }
  if (all.size() > 1) std::erase_if(all, [&](int m) { return !is_thing(m); });
  return all;
}

Link Scribe::link_at_unit(int u) const {
  Link link;
  const Chunk& said = chunk(u);
  link.first = said.first;
  link.last = said.last;
  link.each = said.phrase.each;
  link.distance = said.distance;
  link.rows = said.rows;
  link.columns = said.columns;
  link.gap = said.gap;
  link.at_least = said.at_least;
  link.at_most = said.at_most;
  link.soft = unit(u).soft;
  return link;
}

int Scribe::add_link(int u, Link link) {
  document_.links.push_back(std::move(link));
  link_[static_cast<std::size_t>(u)] = static_cast<int>(document_.links.size()) - 1;
  return link_[static_cast<std::size_t>(u)];
}

void Scribe::hang(const std::vector<int>& targets, int u) {
  std::vector<int> things = targets;
  std::erase_if(things, [&](int m) { return !is_thing(m); });
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

void Scribe::write_place(int u) {
  const UnitReading& own = reading(u);
  Link link = link_at_unit(u);
  if (own.alone) {
    if (chunk(u).phrase.other && one_side_ >= 0 && takes_other_side(u, subjects_of(u))) return;
    link.senses = unit(u).alone.empty() ? unit(u).direct : unit(u).alone;
    if (!own.fronted) link.targets = subjects_of(u);
    if (link.each && !own.fronted) add_laden_stand(link.senses, link.targets);
    const bool each_other = own.implied == kNobody && !link.targets.empty() &&
                            (says(link.senses, RelationType::kStacked) || (word(u) == "side" || word(u) == "back"));
    if (each_other) {
      Mention other;
      other.noun.kind = NounKind::kPronoun;
      other.reciprocal = true;
      document_.mentions.push_back(std::move(other));
      link.references = {static_cast<int>(document_.mentions.size()) - 1};
    } else if (says(link.senses, RelationType::kDistance) && document_.links.size() > sentence_links_) {
      // "in front of it, at a distance of 50 cm": of what was placed last.
      link.targets = document_.links.back().targets;
      link.references = document_.links.back().references;
    } else if (own.implied_list && own.implied >= 0) {
      std::vector<int> all;
      for (int m = own.implied; m >= 0; m = reading(m).former) all.insert(all.begin(), mention_[static_cast<std::size_t>(m)]);
      link.references = says(link.senses, RelationType::kBetween) && all.size() != 2 ? std::vector<int>{combined(all)} : all;
    } else {
      link.references = mentions_of(own.implied);
    }
    if (says(link.senses, RelationType::kCenterOfRoom) && !link.references.empty())
      link.senses = {{RelationType::kOn, Direction::kDirect, "center", {}, {}}};
    if (says(link.senses, RelationType::kInRegion) && !link.references.empty()) {
      const bool back = std::any_of(link.senses.begin(), link.senses.end(), [](const PhraseSense& s) { return s.region == "back"; });
      link.senses = {{back ? RelationType::kBehind : RelationType::kInFrontOf, Direction::kDirect, {}, {}, {}}};
    }
    if (says(link.senses, RelationType::kBetween) && link.references.size() == 1) {
      const bool several = mention_at(link.references.front()).items.size() > 1;
      const bool them = several && document_.tokens[chunk(u).last - 1].text == "them";
      const int other = them ? -1 : looked_at_by(link.references.front(), link.targets);
      if (other >= 0) link.references.push_back(other);
      if (const int pair = other < 0 && !several ? pair_just_related() : -1; pair >= 0) link.references = {pair};
    }
    link.implied = true;
    link.one_side = chunk(u).phrase.one && says(link.senses, RelationType::kNextTo);
    if (link.each && !own.fronted) {
      for (const int target : link.targets) grow_for_sides(link, target, link.references.empty() ? -1 : link.references.front());
    }
    const bool one_side = link.one_side;
    const std::vector<int> targets = link.targets;
    const int added = add_link(u, std::move(link));
    if (one_side) one_side_ = added;
    if (hangs(u) && !own.fronted) hang(targets, u);
    return;
  }
  if (own.role != NounRole::kUnread || (!own.fronted && own.subject == kNobody && !own.inverse && !chunk(u).gap)) {
    if (!is(u + 1, UnitKind::kNoun) || reading(u + 1).predicate != u) return;  // says nothing
  }
  link.senses = own.inverse && !unit(u).inverse.empty() ? unit(u).inverse : unit(u).direct;
  // "two sofas facing each other across a table": between them.
  if (own.inverse && unit(u).inverse.empty() && own.implied_list) link.senses = {{RelationType::kBetween, Direction::kDirect, {}, {}, {}}};
  if (own.inverse) {
    if (!own.fronted) link.references = own.subject == u + 1 ? std::vector<int>{} : subjects_of(u);
  } else if (!own.fronted) {
    link.targets = subjects_of(u);
  }
  const bool centers = u > 0 && is(u - 1, UnitKind::kVerb) && document_.tokens[chunk(u - 1).last - 1].text.starts_with("center");
  const bool centered_command = u > 1 && is(u - 2, UnitKind::kVerb) && document_.tokens[chunk(u - 2).last - 1].text.starts_with("center");
  if ((centers || centered_command) && is(u + 1, UnitKind::kNoun) && chunk(u + 1).noun.kind == NounKind::kWall)
    link.senses.insert(link.senses.begin(), {RelationType::kCenteredOnWall, Direction::kDirect, {}, {}, {}});
  link.one_side = chunk(u).phrase.one && says(link.senses, RelationType::kNextTo);
  const bool one_side = link.one_side;
  const int added = add_link(u, std::move(link));
  if (one_side) one_side_ = added;
}

void Scribe::write_have(int u) {
  const UnitReading& own = reading(u);
  if (own.of_room || own.subject == kNobody) return;
  const std::vector<int> hosts = subjects_of(u);
  if (hosts.empty()) return;
  const std::string& how = word(u);
  const bool plain = how == "with" || how == "featuring" || how == "features" || how == "feature" || how == "including" ||
                     how == "includes" || how == "include" || how == "has" || how == "have" || how == "having";
  Link link = link_at_unit(u);
  link.kind = Link::Kind::kHave;
  link.holding = !plain;
  link.weak = plain;
  link.after_comma = unit(u).joiner == Joiner::kComma || unit(u).joiner == Joiner::kCommaAnd;
  link.references = hosts;
  const NounKind kind = noun_of(hosts.front()).kind;
  if (!is_thing(hosts.front()) && kind != NounKind::kAbstract) {
    link.kind = Link::Kind::kRelation;
    link.weak = false;
    link.senses = {{RelationType::kOn, Direction::kDirect, {}, {}, {}},
                   {RelationType::kOnWall, Direction::kDirect, {}, {}, {}},
                   {RelationType::kAgainstWall, Direction::kDirect, {}, {}, {}},
                   {RelationType::kOnCeiling, Direction::kDirect, {}, {}, {}}};
  }
  add_link(u, std::move(link));
}

void Scribe::write_verb(int u) {
  const UnitReading& own = reading(u);
  if (own.implied != kNobody) {  // "a table where puzzles lie"
    Link link = link_at_unit(u);
    link.kind = Link::Kind::kHave;
    link.holding = true;
    link.targets = subjects_of(u);
    link.references = mentions_of(own.implied);
    if (!link.references.empty() && is_thing(link.references.front())) add_link(u, std::move(link));
  }
  const bool place_follows = is(u + 1, UnitKind::kPlace) && !reading(u + 1).alone;
  if (chunk(u).hang && own.subject >= 0 && own.subject < u && !place_follows) hang(subjects_of(u), u);
}

// "a bicycle hung": where no place follows that says where.
void Scribe::write_participle(int u) {
  const UnitReading& own = reading(u);
  if (!chunk(u).hang || (is(u + 1, UnitKind::kPlace) && unit(u + 1).joiner == Joiner::kNone)) return;
  if (own.subject >= 0) hang(subjects_of(u), u);
}

void Scribe::write_size(int u) {
  const SaidSize& said = chunk(u).size;
  for (const int mention : mentions_of(reading(u).subject)) {
    for (const int item : mention_at(mention).items) {
      SaidSize& size = document_.items[static_cast<std::size_t>(item)].noun.size;
      if (said.width) size.width = said.width;
      if (said.depth) size.depth = said.depth;
      if (said.height) size.height = said.height;
      if (said.length) size.length = said.length;
    }
  }
}

void Scribe::write_attribute(int u) {
  if (reading(u).subject == kNobody) return;
  mark(u, Use::kUsed, "attribute");
  const std::string said = words_between(document_, chunk(u).first, chunk(u).last);
  const WordClass word_class = lexicon_.find(document_.tokens, chunk(u).first).meanings.front().word_class;
  const auto add_to = [&](NounPhrase& noun) {
    noun.attributes.push_back(said);
    noun.attribute_classes.push_back(word_class);
  };
  for (const int subject : subjects_of(u)) {
    add_to(mention_at(subject).noun);
    for (const int item : mention_at(subject).items) add_to(document_.items[static_cast<std::size_t>(item)].noun);
  }
}

}  // namespace layoutbox::offline
