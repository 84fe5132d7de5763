#include "layoutbox/plan/reading/scribe.h"

#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

void Scribe::write(const Sentence& sentence, const SentenceReading& reading) {
  sentence_ = &sentence;
  reading_ = &reading;
  mention_.assign(sentence.size(), -1);
  link_.assign(sentence.size(), -1);
  one_side_ = -1;
  sentence_links_ = document_.links.size();
  sentence_mentions_ = static_cast<int>(document_.mentions.size());
  const auto waits = [&](int u) { return is(u, UnitKind::kPlace) && this->reading(u).alone && this->reading(u).implied > u; };
  for (int u = 0; u < static_cast<int>(sentence.size()); ++u) {
    if (waits(u)) continue;
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
  for (int u = 0; u < static_cast<int>(sentence.size()); ++u) {
    if (waits(u)) write_place(u);  // by what was named later
  }
  join_sides();
  write_orders();
  end_sentence();
}

// It is one thing, and one of those.
bool Scribe::names_one_of(const std::vector<int>& mentions, int mention) const {
  return is_thing(mention) && mention_at(mention).items.size() == 1 &&
         std::ranges::any_of(mentions, [&](int one) { return mention_at(one).items == mention_at(mention).items; });
}

// What the next sentence's "it" and "opposite" may mean.
void Scribe::end_sentence() {
  std::vector<int> roots;
  int fronted = -1;
  so_far_.opening = so_far_.again = -1;
  for (int u = 0; u < static_cast<int>(sentence_->size()); ++u) {
    const UnitReading& own = reading(u);
    if (unit(u).kind == UnitKind::kNoun && (own.role == NounRole::kRoot || own.role == NounRole::kMember) &&
        is_thing(mention_[static_cast<std::size_t>(u)]))
      roots.push_back(mention_[static_cast<std::size_t>(u)]);
    if (own.role == NounRole::kReference && names_one_of(roots, mention_[static_cast<std::size_t>(u)]))
      so_far_.again = mention_[static_cast<std::size_t>(u)];
    const NounKind kind = unit(u).kind == UnitKind::kNoun ? chunk(u).noun.kind : NounKind::kObject;
    if (own.role == NounRole::kRoot && (kind == NounKind::kDoor || kind == NounKind::kWindow))
      so_far_.opening = mention_[static_cast<std::size_t>(u)];
    if (unit(u).kind == UnitKind::kPlace && own.fronted && own.subject != kNobody && link_[static_cast<std::size_t>(u)] >= 0) {
      const std::vector<int>& references = link_at(link_[static_cast<std::size_t>(u)]).references;
      if (!references.empty() && is_thing(references.front()) && !own.inverse) fronted = references.front();
    }
  }
  // "Guests may sit at a table by the window": of the table
  for (std::size_t u = 0; u < sentence_->size() && roots.empty(); ++u) {
    const int m = mention_[u];
    if (unit(static_cast<int>(u)).kind == UnitKind::kNoun && is_thing(m) && mention_at(m).introduces) roots.push_back(m);
  }
  if (!roots.empty()) so_far_.opening = -1;
  so_far_.fronted = fronted;
  so_far_.sided = -1;
  so_far_.side = RoomRegion::kMiddle;
  for (std::size_t l = sentence_links_; l < document_.links.size(); ++l) {
    for (const PhraseSense& sense : document_.links[l].senses) {
      if (sense.region == RoomRegion::kLeft || sense.region == RoomRegion::kRight) so_far_.side = *sense.region;
    }
  }
  for (std::size_t l = sentence_links_; l < document_.links.size(); ++l) {
    const Link& link = document_.links[l];
    so_far_.left = says(link.senses, RelationType::kLeftOf);
    if (link.references.empty() || !(so_far_.left || says(link.senses, RelationType::kRightOf))) continue;
    so_far_.sided = link.references.front();
    break;
  }
  std::vector<int> listed = roots;
  std::erase_if(listed, [&](int m) { return !mention_at(m).introduces; });
  if (listed.size() > 1) so_far_.listed = std::move(listed);
  if (!roots.empty()) {
    so_far_.topic = roots.front();
    so_far_.roots = std::move(roots);
    so_far_.first = sentence_mentions_;
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
    const bool counted = chunk(m).noun.count > 0;  // "between a counter and a fridge, all three": not just the list
    if (member.role == NounRole::kMember && member.whole_list && member.meant >= 0 && !counted && !is(u, UnitKind::kHave)) {
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
  link.sides = said.phrase.sides > 0 ? said.phrase.sides : said.phrase.all ? Link::kAllSides : 0;
  link.sides_shared = said.phrase.shared;
  link.distance = said.distance;
  link.rows = said.rows;
  link.columns = said.columns;
  link.gap = said.gap;
  link.at_least = said.at_least;
  link.at_most = said.at_most;
  link.soft = unit(u).soft;
  return link;
}

void Scribe::write_have(int u) {
  const UnitReading& own = reading(u);
  if (own.of_room || own.subject == kNobody) return;
  const std::vector<int> hosts = subjects_of(u);
  if (hosts.empty()) return;
  const std::string& how = word(u);
  const bool plain = unit(u).unsaid || how == "with" || how == "featuring" || how == "features" || how == "feature" || how == "including" ||
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
    link.senses = {{RelationType::kCorner, Direction::kDirect, {}, {}, {}},
                   {RelationType::kOn, Direction::kDirect, {}, {}, {}},
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
  if (word(u) == "stacked" && own.subject >= 0) stack(u);
  if (!chunk(u).hang || (is(u + 1, UnitKind::kPlace) && unit(u + 1).joiner == Joiner::kNone)) return;
  if (own.subject >= 0) hang(subjects_of(u), u);
}

// "a washer and a dryer stacked in the corner": one on the other.
void Scribe::stack(int u) {
  Link link = link_at_unit(u);
  link.senses = {{RelationType::kStacked, Direction::kDirect, {}, {}, {}}};
  for (int m = reading(u).subject; m >= 0 && unit(m).joiner != Joiner::kComma; m = reading(m).former) {
    const int former = reading(m).former;
    if (link.targets.empty() && former >= 0) link.targets = mentions_of(m);
    if (!link.targets.empty() && former >= 0) {
      const std::vector<int> before = mentions_of(former);
      link.targets.insert(link.targets.begin(), before.begin(), before.end());
    }
  }
  std::erase_if(link.targets, [&](int m) { return !is_thing(m); });
  if (link.targets.size() < 2) return;
  Mention other;
  other.noun.kind = NounKind::kPronoun;
  other.reciprocal = true;
  document_.mentions.push_back(std::move(other));
  link.references = {static_cast<int>(document_.mentions.size()) - 1};
  document_.links.push_back(std::move(link));
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

// "two chairs, one red and one blue": of the one right before it, not of all who the sentence is about.
std::vector<int> Scribe::described_by(int u) const {
  const bool of_member = u > 0 && is(u - 1, UnitKind::kNoun) && unit(u).joiner == Joiner::kNone &&
                         chunk(u - 1).noun.kind == NounKind::kMember && is_thing(mention_[static_cast<std::size_t>(u - 1)]);
  if (!of_member) return subjects_of(u);
  return {mention_[static_cast<std::size_t>(u - 1)]};
}

void Scribe::write_attribute(int u) {
  if (reading(u).subject == kNobody) return;
  mark(u, Use::kUsed, "attribute");
  // "The floor is black and white tiles": as the wordings have it, checkered ones.
  const std::string words = words_between(document_, chunk(u).first, chunk(u).last);
  const bool reworded = words.find(document_.tokens[chunk(u).first].text) == std::string::npos;
  const std::string said = reworded ? text_of(document_.tokens, chunk(u).first, chunk(u).last) : words;
  const WordClass word_class = lexicon_.find(document_.tokens, chunk(u).first).meanings.front().word_class;
  const auto add_to = [&](NounPhrase& noun) {
    noun.attributes.push_back(said);
    noun.attribute_classes.push_back(word_class);
  };
  for (const int subject : described_by(u)) {
    add_to(mention_at(subject).noun);
    for (const int item : mention_at(subject).items) add_to(document_.items[static_cast<std::size_t>(item)].noun);
  }
}

}  // namespace layoutbox::offline
