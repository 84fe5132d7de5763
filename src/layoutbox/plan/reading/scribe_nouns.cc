// The mentions that nouns make, sets of things among them, and what "each" at the end of a list means.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/scribe.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// The noun is what a place that may say that is by.
bool Scribe::as_reference_of(int u, RelationType type) const {
  const UnitReading& own = reading(u);
  return own.role == NounRole::kReference && own.predicate >= 0 && says(unit(own.predicate).direct, type);
}

int Scribe::make_mention(int u) {
  NounPhrase noun = chunk(u).noun;
  const UnitReading& own = reading(u);
  // "A crooked room. A cauldron stands in the middle of it": of the room.
  if (noun.kind == NounKind::kCenter && own.meant == kNobody && noun.of && noun.of->kind == NounKind::kPronoun) noun.of.reset();
  const bool in_middle = as_reference_of(u, RelationType::kCenterOfRoom);
  if (in_middle && noun.kind == NounKind::kPronoun && noun.head == "it" && own.meant == kNobody) noun.kind = NounKind::kRoom;
  const bool as_reference = own.role == NounRole::kReference;
  if (const int openings = each_of_openings(u, noun); openings >= 0) return openings;
  if (noun.kind == NounKind::kMember) return make_member(u, noun);
  int antecedent = -1;
  if (noun.kind == NounKind::kPronoun) {
    antecedent = noun.reciprocal ? -1 : antecedent_of(u);
    const bool former = noun.head == "former";
    if (former || noun.head == "latter") {
      int back = former ? 2 : 1;
      const std::vector<int> busy = own.predicate >= 0 ? subjects_of(own.predicate) : std::vector<int>{};
      for (std::size_t m = document_.mentions.size(); m-- > 0 && back > 0;) {
        if (document_.mentions[m].introduces && !contains(busy, static_cast<int>(m)) && !document_.mentions[m].items.empty() && --back == 0)
          antecedent = static_cast<int>(m);
      }
    }
  } else if (own.meant != kNobody) {
    antecedent = antecedent_of(u);
  }
  if (const int shared = shared_as(u, noun); shared >= 0) return shared;
  // "three mirrors …, bottles under mirrors": those that were named.
  const bool bare = as_reference && noun.kind == NounKind::kObject && noun.determiner == Determiner::kNone && noun.plural &&
                    noun.count == 0 && !noun.vague && noun.attributes.empty();
  if (bare && references_.known(noun).size() > 1) noun.determiner = Determiner::kDefinite;
  const bool opens = own.role == NounRole::kRoot && own.opens_clause;
  const int mention = references_.mention(noun, antecedent, as_reference, as_reference || opens);
  if (const int other = not_itself(u, noun, mention); other >= 0) return other;
  mention_at(mention).reciprocal = noun.reciprocal;
  const bool of_each = noun.kind == NounKind::kPronoun && !noun.plural && antecedent >= 0 && mention_at(antecedent).distributes;
  const bool both_have = noun.kind == NounKind::kObject && noun.determiner == Determiner::kBoth && is(u + 1, UnitKind::kHave);
  if (of_each || both_have || (noun.kind == NounKind::kPronoun && noun.determiner == Determiner::kEach))
    mention_at(mention).distributes = true;
  return mention;
}

// What nobody says outright that the hosts have; the tokens that show it are [first, last).
void Scribe::add_have(int content, std::vector<int> hosts, std::size_t first, std::size_t last) {
  Link link;
  link.kind = Link::Kind::kHave;
  link.weak = true;
  link.targets = {content};
  link.references = std::move(hosts);
  link.first = first;
  link.last = last;
  document_.links.push_back(std::move(link));
}

// "six square tables, four chairs each", "three tables with two stools each": what was listed last belongs to every one of the others.
bool Scribe::trails_each(int u) {
  const NounPhrase& noun = chunk(u).noun;
  // "two chairs each facing the window" speaks of the chairs, "tables with two chairs each along the window" of the tables.
  const bool placed_on = is(u + 1, UnitKind::kPlace) && unit(u + 1).joiner == Joiner::kNone &&
                         (!is(u - 1, UnitKind::kNoun) || reading(u - 1).role != NounRole::kContent ||
                          document_.tokens[chunk(u + 1).first].text.ends_with("ing"));
  const bool trails = noun.kind == NounKind::kMember && noun.determiner == Determiner::kEach && noun.count == 0 && !noun.of &&
                      unit(u).joiner == Joiner::kNone && is(u - 1, UnitKind::kNoun) && !is(u + 1, UnitKind::kHave) &&
                      !is(u + 1, UnitKind::kParticiple) && !placed_on &&
                      !(is(u + 1, UnitKind::kVerb) && unit(u + 1).joiner == Joiner::kNone);
  if (!trails || reading(u).role == NounRole::kReference) return false;
  const int content = mention_[static_cast<std::size_t>(u - 1)];
  const UnitReading& before = reading(u - 1);
  if (!is_thing(content) || !mention_at(content).introduces) return false;
  std::vector<int> hosts;
  const bool placed = before.role == NounRole::kReference && is(before.predicate, UnitKind::kPlace);  // "three chairs face a mirror each"
  if (before.predicate >= 0 && (placed || before.role == NounRole::kContent)) hosts = subjects_of(before.predicate);
  const bool listed = hosts.empty() && before.former >= 0;
  if (listed) hosts = {mention_[static_cast<std::size_t>(before.former)]};
  std::size_t count = 0;
  for (const int host : hosts) {
    const NounPhrase& by = noun_of(host);
    const bool walls = by.kind == NounKind::kWall && by.plural;  // "the side walls take three lockers each"
    count += is_thing(host) ? mention_at(host).items.size() : walls ? static_cast<std::size_t>(std::max(by.count, 2)) : 0;
  }
  if (count < 2) return false;
  references_.grow(content, mention_at(content).items.size() * count);
  mark(u, Use::kUsed, "reference");
  if (hosts.size() == 1) mention_[static_cast<std::size_t>(u)] = hosts.front();
  if (!listed) return true;
  add_have(content, hosts, chunk(u - 1).first, chunk(u).last);
  return true;
}

// "a dining set for six": a table and six chairs around it.
bool Scribe::write_set(int u) {
  const NounPhrase noun = chunk(u).noun;
  if (reading(u).role == NounRole::kReference || noun.determiner == Determiner::kDefinite) return false;
  const Lexicon::Set* set = lexicon_.set_called(noun.name);
  if (set == nullptr) return false;
  const auto member = [&](const CatalogEntry& entry, int count) {
    NounPhrase one = noun;
    one.kind = NounKind::kObject;
    one.entry = &entry;
    one.exact = true;
    one.name = one.head = entry.name;
    one.head = one.head.substr(one.head.rfind(' ') + 1);
    one.category = entry.id;
    one.count = count;
    one.plural = count > 1;
    one.collective = false;
    one.seats = 0;
    return references_.mention(one, -1, false);
  };
  mark(u, Use::kUsed, set->front().first->name);
  const int host = member(*set->front().first, noun.count > 0 ? noun.count : set->front().second);
  mention_[static_cast<std::size_t>(u)] = host;
  // "for six", "with four chairs": how many sit at it.
  const bool chairs_said = is(u + 1, UnitKind::kHave) && is(u + 2, UnitKind::kNoun) && is_seat(lexicon_.catalog(), chunk(u + 2).noun);
  const std::size_t after = unit(u).chunk + 1;
  int seats = noun.seats;
  if (after + 1 < document_.chunks.size() && document_.chunks[after].kind == ChunkKind::kPurpose &&
      document_.chunks[after + 1].kind == ChunkKind::kNoun)
    seats = document_.chunks[after + 1].noun.count;
  for (std::size_t m = 1; m < set->size() && !chairs_said; ++m) {
    const bool chairs = is_table(lexicon_.catalog(), noun_of(host));
    const int others = member(*(*set)[m].first, chairs && seats > 0 ? seats : (*set)[m].second);
    if (!chairs) continue;
    Link link;
    link.senses = {{RelationType::kAround, Direction::kDirect, {}, {}, {}}};
    link.targets = {others};
    link.references = {host};
    link.first = chunk(u).first;
    link.last = chunk(u).last;
    document_.links.push_back(std::move(link));
  }
  return true;
}

void Scribe::mark_noun(int u, int mention) {
  const NounPhrase& noun = chunk(u).noun;
  const bool content = reading(u).role == NounRole::kContent;
  const bool abstract = noun.kind == NounKind::kAbstract && !(noun.collective && content);
  const std::string role = abstract                                                          ? "no object"
                           : noun.kind == NounKind::kMember || noun_of(mention).name.empty() ? "reference"
                                                                                             : noun_of(mention).name;
  mark(u, abstract ? Use::kIgnored : Use::kUsed, role);
}

void Scribe::write_noun(int u) {
  if (trails_each(u)) return;
  const UnitReading& own = reading(u);
  if (write_set(u)) {
    const int host = mention_[static_cast<std::size_t>(u)];
    if (own.role == NounRole::kContent) fill_content(u, host);
    if (own.role == NounRole::kRoot) fill_root(u, host);
    return;
  }
  // Collectives ("bath essentials") are things where something holds them.
  NounPhrase& noun = document_.chunks[unit(u).chunk].noun;
  if (noun.kind == NounKind::kAbstract && noun.collective && own.role == NounRole::kContent) noun.kind = NounKind::kObject;
  const std::size_t items = document_.items.size();
  const int mention = make_mention(u);
  mention_[static_cast<std::size_t>(u)] = mention;
  if (unit(u).share > 1 && is_thing(mention))
    references_.grow(mention, mention_at(mention).items.size() * static_cast<std::size_t>(unit(u).share));
  if (document_.items.size() > items && !is_evident(u)) forget(u, mention, items);
  if (own.role == NounRole::kReference && mention_at(mention).items.empty() &&
      (noun.kind == NounKind::kAbstract || noun.kind == NounKind::kRoom)) {
    if (const int meant = thing_of_zone(u, noun); meant >= 0) {
      if (link_[static_cast<std::size_t>(own.predicate)] >= 0) link_at(link_[static_cast<std::size_t>(own.predicate)]).implied = true;
      mention_at(mention).items = mention_at(meant).items;
      mention_at(mention).noun = noun_of(meant);
    }
  }
  mark_noun(u, mention);
  switch (own.role) {
    case NounRole::kReference: fill_reference(u, mention); break;
    case NounRole::kContent: fill_content(u, mention); break;
    case NounRole::kRoot:
    case NounRole::kMember: fill_root(u, mention); break;
    default: break;
  }
  add_named_contents(u, mention);
  seat_at_its(u, mention);
}

// "a desk by the wall. Its chair faces the window": at what one sits at and was named last.
void Scribe::seat_at_its(int u, int mention) {
  const NounPhrase& noun = chunk(u).noun;
  if (noun.determiner != Determiner::kPossessive || document_.tokens[noun.first].text != "its" || !is_thing(mention) ||
      !mention_at(mention).introduces || !is_seat(lexicon_.catalog(), noun))
    return;
  for (std::size_t m = static_cast<std::size_t>(mention), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (!is_thing(static_cast<int>(m)) || !is_table(lexicon_.catalog(), document_.mentions[m].noun)) continue;
    return add_have(mention, {static_cast<int>(m)}, noun.first, noun.last);
  }
}

}  // namespace layoutbox::offline
