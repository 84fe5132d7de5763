// The mentions that noun phrases make.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/scribe.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

int Scribe::combined(const std::vector<int>& mentions) {
  std::vector<int> things = mentions;
  std::erase_if(things, [&](int m) { return !is_thing(m); });
  if (things.empty()) return -1;
  Mention all = mention_at(things.front());
  all.introduces = all.distributes = false;
  for (const int mention : things) {
    for (const int item : mention_at(mention).items) {
      if (!contains(all.items, item)) all.items.push_back(item);
    }
  }
  document_.mentions.push_back(std::move(all));
  return static_cast<int>(document_.mentions.size()) - 1;
}

// Two single things of which one was placed by the other, as one mention, or -1.
int Scribe::pair_just_related() {
  for (std::size_t l = document_.links.size(), looked = 0; l-- > 0 && looked < 6; ++looked) {
    const Link& link = document_.links[l];
    if (link.kind != Link::Kind::kRelation || link.targets.size() != 1 || link.references.size() != 1) continue;
    const Mention &one = mention_at(link.targets.front()), &other = mention_at(link.references.front());
    if (one.items.size() != 1 || other.items.size() != 1 || one.items == other.items) continue;
    const Mount mount = mount_of(one.noun);
    if (mount != mount_of(other.noun) || (mount != Mount::kFloor && mount != Mount::kSurface)) continue;
    return combined({link.targets.front(), link.references.front()});
  }
  return pair_looking();
}

// "A sofa faces a TV; between the two is a table": the last two single things of which one looks at the other, or -1.
int Scribe::pair_looking() {
  for (std::size_t l = document_.links.size(), looked = 0; l-- > 0 && looked < 6; ++looked) {
    const Link& link = document_.links[l];
    if (!says(link.senses, RelationType::kFacing) && !says(link.senses, RelationType::kOpposite)) continue;
    if (link.targets.size() != 1 || link.references.size() != 1) continue;
    const Mention &one = mention_at(link.targets.front()), &other = mention_at(link.references.front());
    if (one.items.size() == 1 && other.items.size() == 1 && one.items != other.items)
      return combined({link.targets.front(), link.references.front()});
  }
  return -1;
}

// "a nightstand to its left; a second nightstand is on the right; each of them": what was brought in last and the one before of its name.
int Scribe::pair_of_a_name() {
  int last = -1;
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    const Mention& one = document_.mentions[m];
    if (!one.introduces || one.items.size() != 1 || one.noun.kind != NounKind::kObject) continue;
    if (last >= 0 && one.noun.name == noun_of(last).name) return combined({static_cast<int>(m), last});
    if (last < 0) last = static_cast<int>(m);
  }
  return -1;
}

int Scribe::antecedent_of(int u) {
  const UnitReading& own = reading(u);
  const NounPhrase& noun = chunk(u).noun;
  const bool both = noun.kind == NounKind::kMember && noun.determiner == Determiner::kBoth;
  const bool each_of_them = noun.kind == NounKind::kMember && noun.determiner == Determiner::kEach && noun.subset && !noun.of;
  const bool plural = noun.plural || both || each_of_them ||
                      (noun.kind == NounKind::kMember && noun.determiner == Determiner::kDefinite && noun.count == 2);
  // "the crib is between the wardrobe and the dresser; all three …"
  if (both && noun.count > 0) {
    std::vector<int> last;
    std::size_t items = 0;
    for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < 8 && items < static_cast<std::size_t>(noun.count);
         ++looked) {
      if (document_.mentions[m].items.empty() || !document_.mentions[m].introduces) continue;
      last.insert(last.begin(), static_cast<int>(m));
      items += document_.mentions[m].items.size();
    }
    if (items == static_cast<std::size_t>(noun.count)) return combined(last);
  }
  if (own.whole_list && own.meant >= 0) {
    std::vector<int> all;
    for (const int m : list_meant(own.meant)) all.push_back(mention_[static_cast<std::size_t>(m)]);
    const bool one = all.size() == 1 && is_thing(all.front()) && mention_at(all.front()).items.size() == 1;
    if (!one) return combined(all);
  }
  const std::vector<int> meant = mentions_of(own.meant);
  const int antecedent = meant.empty() ? -1 : meant.front();
  if (const int listed = list_ranked(noun, antecedent); listed >= 0) return listed;
  if (plural && (antecedent < 0 || mention_at(antecedent).items.size() < 2)) {
    const std::vector<int> placed = own.predicate >= 0 ? subjects_of(own.predicate) : std::vector<int>{};
    if (const std::vector<int> two = pair_named_last(u, placed); two.size() == 2) return combined(two);
    if (const std::vector<int> two = two_alike(u, !each_of_them); two.size() == 2 && own.predicate < 0) return combined(two);
    if (const int pair = pair_of_a_name(); pair >= 0) return pair;
    if (const int pair = pair_just_related(); pair >= 0) return pair;
    // The last two things that were spoken of.
    if (so_far_.roots.size() > 1) return combined({so_far_.roots[so_far_.roots.size() - 2], so_far_.roots.back()});
  }
  return antecedent;
}

// "a crib, a table and a chair. The first two …, the third …": of what the sentence before listed, where nothing named is as many.
int Scribe::list_ranked(const NounPhrase& noun, int antecedent) {
  const bool ranked =
      noun.kind == NounKind::kMember && !noun.of && (noun.ordinal != 0 || noun.rank != Rank::kAny) && noun.attributes.empty();
  if (!ranked) return -1;
  const std::size_t wanted =
      static_cast<std::size_t>(std::max({noun.ordinal, 0, 2})) + static_cast<std::size_t>(std::max(noun.count, 1)) - 1;
  const bool group = antecedent >= 0 && mention_at(references_.whole_group(antecedent)).items.size() > 1;
  if (group) return -1;
  if (so_far_.listed.size() < wanted || so_far_.listed.size() < 2) return -1;
  return combined(so_far_.listed);
}

// "for each guest a bed and a lamp beside the bed": the bed of every one.
int Scribe::shared_as(int u, const NounPhrase& noun) {
  const bool known = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive;
  if (unit(u).share < 2 || noun.kind != NounKind::kObject || !known || noun.is_plural()) return -1;
  for (int before = u; before-- > 0;) {
    const int m = mention_[static_cast<std::size_t>(before)];
    if (!is(before, UnitKind::kNoun) || !is_thing(m) || !mention_at(m).introduces || unit(before).share < 2) continue;
    const std::string& name = noun_of(m).name;
    if (name == noun.name || name.ends_with(" " + noun.name)) return combined({m});
  }
  return -1;
}

// The noun is what a place that may say that is by.
bool Scribe::as_reference_of(int u, RelationType type) const {
  const UnitReading& own = reading(u);
  return own.role == NounRole::kReference && own.predicate >= 0 && says(unit(own.predicate).direct, type);
}

// "two windows, a radiator under each": each of the windows; −1: the words mean nothing of the kind.
int Scribe::each_of_openings(int u, const NounPhrase& noun) {
  const bool each = noun.determiner == Determiner::kEach || noun.determiner == Determiner::kBoth;
  const std::vector<int> meant = each && noun.kind != NounKind::kObject ? mentions_of(reading(u).meant) : std::vector<int>{};
  if (meant.empty()) return -1;
  const NounKind kind = noun_of(meant.front()).kind;
  if (kind != NounKind::kDoor && kind != NounKind::kWindow) return -1;
  Mention all = mention_at(meant.front());
  all.introduces = false;
  all.noun.determiner = Determiner::kEach;
  document_.mentions.push_back(std::move(all));
  return static_cast<int>(document_.mentions.size()) - 1;
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

// What stands for an area of the room: "the dining area" is where the dining table is, "the seating area" where one sits.
// A rug under a seating area lies under the low table in its middle.
int Scribe::thing_of_zone(int u, const NounPhrase& noun) const {
  if (!is_zone(noun.head) || noun.determiner != Determiner::kDefinite) return -1;
  const std::string words = words_between(document_, noun.first, noun.last);
  int seat = -1, sofa = -1, named = -1, low_table = -1;
  for (std::size_t m = document_.mentions.size(); m-- > 0;) {
    const Mention& mention = document_.mentions[m];
    if (mention.items.empty() || !mention.introduces || mention.noun.kind != NounKind::kObject) continue;
    const CatalogEntry* entry = mention.noun.entry;
    if (entry != nullptr && entry->is(Trait::kCenterPiece) && !entry->is(Trait::kBed)) sofa = static_cast<int>(m);
    if (entry != nullptr && entry->is(Trait::kCoffeeTable)) low_table = static_cast<int>(m);
    const std::string first = mention.noun.name.substr(0, mention.noun.name.find(' '));
    if (first != mention.noun.name && words.find(first) != std::string::npos) {
      if (!is_seat(lexicon_.catalog(), mention.noun)) return static_cast<int>(m);
      if (named < 0) named = static_cast<int>(m);
    }
    if (seat < 0 && is_seat(lexicon_.catalog(), mention.noun)) seat = static_cast<int>(m);
  }
  if (named >= 0) return named;
  if (words.find("seating") != std::string::npos || words.find("sitting") != std::string::npos || words.find("lounge") != std::string::npos)
    return low_table >= 0 && as_reference_of(u, RelationType::kUnder) ? low_table : sofa >= 0 ? sofa : seat;
  if (words.find("sleeping") != std::string::npos) {
    const auto bed = std::ranges::find_if(document_.mentions, [](const Mention& m) { return !m.items.empty() && m.noun.head == "bed"; });
    if (bed != document_.mentions.end()) return static_cast<int>(bed - document_.mentions.begin());
  }
  return so_far_.topic >= 0 && is_thing(so_far_.topic) ? so_far_.topic : -1;
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
  Link link;
  link.kind = Link::Kind::kHave;
  link.weak = true;
  link.targets = {content};
  link.references = hosts;
  link.first = chunk(u - 1).first;
  link.last = chunk(u).last;
  document_.links.push_back(std::move(link));
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
    Link link;
    link.kind = Link::Kind::kHave;
    link.weak = true;
    link.targets = {mention};
    link.references = {static_cast<int>(m)};
    link.first = noun.first;
    link.last = noun.last;
    document_.links.push_back(std::move(link));
    return;
  }
}

}  // namespace layoutbox::offline
