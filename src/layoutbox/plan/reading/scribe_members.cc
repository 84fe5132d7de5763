// Mentions of one of several, of more of a kind, of what was named before.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/scribe.h"

namespace layoutbox::offline {

// "a tray on its left and a mug on its right, a spoon between the two": what the sentence named last of the size of who is placed by them.
std::vector<int> Scribe::pair_named_last(int u, const std::vector<int>& placed) const {
  if (placed.size() != 1 || !is_thing(placed.front()) || mount_of(noun_of(placed.front())) != Mount::kSurface) return {};
  std::vector<int> two;
  for (int before = u; before-- > 0 && two.size() < 2;) {
    const int m = mention_[static_cast<std::size_t>(before)];
    const bool thing = is(before, UnitKind::kNoun) && is_thing(m) && reading(before).role != NounRole::kReference && m != placed.front();
    if (thing && mention_at(m).introduces && mention_at(m).items.size() == 1 && mount_of(noun_of(m)) == Mount::kSurface)
      two.insert(two.begin(), m);
  }
  return two;
}

// The last two single things that the sentence brought in: held alike, or of one name.
std::vector<int> Scribe::two_alike(int u, bool by_name) const {
  std::vector<int> two;
  for (int before = u; before-- > 0 && two.size() < 2;) {
    const int m = mention_[static_cast<std::size_t>(before)];
    if (!is(before, UnitKind::kNoun) || !is_thing(m) || !mention_at(m).introduces || reading(before).role == NounRole::kReference) continue;
    if (mention_at(m).items.size() != 1) return {};
    if (!two.empty() && (by_name ? noun_of(m).name != noun_of(two.front()).name : mount_of(noun_of(m)) != mount_of(noun_of(two.front()))))
      return {};
    two.insert(two.begin(), m);
  }
  return two;
}

// "a cup, a jar and a bowl, the jar between the other two": of the list those that are not placed by it; −1: nothing was listed so.
int Scribe::others_listed(int u, const NounPhrase& noun) {
  const UnitReading& own = reading(u);
  if (noun.determiner != Determiner::kOther || noun.of || own.role != NounRole::kReference || own.predicate < 0) return -1;
  const std::vector<int> placed = subjects_of(own.predicate);
  if (placed.size() != 1 || !is_thing(placed.front()) || mention_at(placed.front()).items.size() != 1 || noun.count < 2) return -1;
  for (int last = u; last-- > 0;) {
    if (!is(last, UnitKind::kNoun)) continue;
    std::vector<int> others;
    bool mine = false;
    for (int m = last; m >= 0; m = reading(m).former) {
      const int mention = mention_[static_cast<std::size_t>(m)];
      if (!is_thing(mention)) continue;
      const bool itself = mention_at(mention).items == mention_at(placed.front()).items;
      mine = mine || itself;
      if (!itself) others.insert(others.begin(), mention);
    }
    if (mine && others.size() == static_cast<std::size_t>(noun.count)) return combined(others);
  }
  return -1;
}

// "a large bookcase and a smaller one", "another one": brought in anew.
int Scribe::make_another(int u, const NounPhrase& noun) {
  const std::vector<int> kind = mentions_of(reading(u).meant);
  if (kind.empty() || !is_thing(kind.front()) || noun_of(kind.front()).kind != NounKind::kObject) return -1;
  const bool another = noun.determiner == Determiner::kAnother;
  if (another && references_.has_left(references_.latest_group(), std::max(noun.count, 1))) return -1;
  NounPhrase copy = noun_of(kind.front());
  copy.determiner = Determiner::kIndefinite;
  copy.count = noun.count;
  copy.plural = noun.plural || noun.count > 1;
  copy.rows = 0;
  if (!noun.attributes.empty()) {
    copy.attributes = noun.attributes;
    copy.attribute_classes = noun.attribute_classes;
    // "low bookcases …, high ones": bookcases that are not low
    const std::size_t space = copy.name.find(' ');
    const bool sized = std::ranges::find(noun.attribute_classes, WordClass::kSizeWord) != noun.attribute_classes.end();
    const std::vector<Token> first = tokenize(copy.name.substr(0, space));
    const CatalogEntry* plain = lexicon_.catalog().find_by_words(copy.head);
    if (sized && space != std::string::npos && plain != nullptr && lexicon_.find(first, 0, WordClass::kSizeWord).length > 0) {
      copy.name = copy.head;
      copy.entry = plain;
      copy.category = plain->id;
    }
  }
  copy.first = noun.first;
  copy.last = noun.last;
  return references_.mention(copy, -1, false);
}

// "two chairs on each long side and one on each short side": more of the kind.
int Scribe::make_more(int u, const NounPhrase& noun) {
  const bool joined = unit(u).joiner == Joiner::kAnd || unit(u).joiner == Joiner::kCommaAnd;
  if (!joined || noun.determiner != Determiner::kNone || noun.count == 0 || noun.subset || !is(u + 1, UnitKind::kPlace)) return -1;
  std::vector<int> kind = mentions_of(reading(u).meant);
  for (int before = u; before-- > 0;) {
    // "three doors: the front door at the end and two on the left": doors
    const bool opening = is(before, UnitKind::kNoun) && is_opening(chunk(before).noun);
    if (opening) return mention_[static_cast<std::size_t>(before)] < 0 ? -1 : copy_of(mention_[static_cast<std::size_t>(before)], noun);
    if (is(before, UnitKind::kNoun) && is_thing(mention_[static_cast<std::size_t>(before)]) &&
        mention_at(mention_[static_cast<std::size_t>(before)]).introduces && reading(before).role != NounRole::kReference) {
      kind = {mention_[static_cast<std::size_t>(before)]};
      break;
    }
  }
  if (kind.empty() || references_.has_left(kind.front(), noun.count)) return -1;
  return more_of(kind.front(), noun);
}

// "two chairs at its sides and two at its ends": "every chair" is of the four.
int Scribe::more_of(int mention, const NounPhrase& said) {
  const int more = copy_of(mention, said);
  references_.join_group(more, mention);
  return more;
}

// As many more of the mention's kind as the words say.
int Scribe::copy_of(int mention, const NounPhrase& said) {
  NounPhrase copy = noun_of(mention);
  copy.determiner = Determiner::kNone;
  copy.count = std::max(said.count, 1);
  copy.plural = copy.count > 1;
  copy.rows = 0;
  copy.first = said.first;
  copy.last = said.last;
  return references_.mention(copy, -1, false);
}

// "Two chairs face two on the other side", "three recliners opposite another three", "a loveseat facing another": more of who is placed.
int Scribe::make_opposed(int u, const NounPhrase& noun) {
  const UnitReading& own = reading(u);
  const bool more = noun.determiner == Determiner::kNone ? noun.count > 0
                                                         : noun.determiner == Determiner::kAnother || noun.determiner == Determiner::kOther;
  if (own.role != NounRole::kReference || own.predicate < 0 || !more || noun.of || noun.ordinal != 0) return -1;
  const std::vector<int> placed = subjects_of(own.predicate);
  if (placed.size() != 1 || !is_thing(placed.front()) || !mention_at(placed.front()).introduces) return -1;
  const Mention& group = mention_at(placed.front());
  if (noun.determiner == Determiner::kOther && noun.count == 0 && !chunk(u).noun.plural) return -1;  // "the other"
  if (references_.whole_group(placed.front()) != placed.front() ||
      (noun.count > 0 && group.items.size() > 2 * static_cast<std::size_t>(noun.count)))
    return -1;
  return copy_of(placed.front(), noun);
}

// "On the left bookcase stands a globe, on the right one two vases": where one of a side was all that was named, the other is a second.
bool Scribe::is_across_from(const NounPhrase& noun, int antecedent) const {
  if (antecedent < 0 || mention_at(antecedent).items.size() != 1) return false;
  const auto is_side = [](const std::string& word) { return word == "left" || word == "right"; };
  const std::string& side = document_.items[static_cast<std::size_t>(mention_at(antecedent).items.front())].noun.wall_word;
  return noun.count <= 1 && is_side(noun.wall_word) && is_side(side) && side != noun.wall_word;
}

// "the first wardrobe … the second": of the same kind.
int Scribe::make_ordinal(const NounPhrase& noun) {
  if (noun.ordinal == 0) return -1;
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (document_.mentions[m].noun.ordinal == 0 || document_.mentions[m].items.empty()) continue;
    NounPhrase same = document_.mentions[m].noun;
    same.ordinal = noun.ordinal;
    same.determiner = Determiner::kDefinite;
    same.first = noun.first;
    same.last = noun.last;
    return references_.mention(same, -1, true);
  }
  return -1;
}

// Nobody but who is placed by it is there to be meant.
bool Scribe::same_as_placed(int u) const {
  const UnitReading& own = reading(u);
  if (own.predicate < 0) return false;
  const std::vector<int> meant = mentions_of(own.meant), placed = subjects_of(own.predicate);
  return meant.size() == 1 && placed.size() == 1 && mention_at(meant.front()).items == mention_at(placed.front()).items;
}

// "two beds: a large one under the window and a small one by the door": of those that the sentence counted, while some are left.
bool Scribe::describes_one_of(int u, const NounPhrase& noun) const {
  if (noun.determiner == Determiner::kIndefinite ? noun.count > 1 : noun.determiner != Determiner::kNone) return false;
  for (int before = u; before-- > 0;) {
    const int m = mention_[static_cast<std::size_t>(before)];
    if (!is(before, UnitKind::kNoun) || !is_thing(m) || !mention_at(m).introduces) continue;
    const bool counted = noun_of(m).count > 1 && mention_at(m).items.size() == static_cast<std::size_t>(noun_of(m).count);
    // "two red chairs by the window, two blue ones by the door": none of those
    const bool unlike = std::ranges::any_of(noun.attribute_classes, [&](WordClass word_class) {
      return std::ranges::find(noun_of(m).attribute_classes, word_class) != noun_of(m).attribute_classes.end();
    });
    if (counted && unlike) return false;
    if (counted && reading(before).role != NounRole::kReference)
      return unit(before + 1).joiner != Joiner::kNone || is(before + 1, UnitKind::kPlace) ? references_.has_left_of(m) : false;
    if (noun_of(m).count <= 1 && reading(before).role != NounRole::kReference) return false;
  }
  return false;
}

// "vases stand on three of the tables, one each": as many vases as that are; −1: nothing was put so.
int Scribe::share_one_each(const NounPhrase& noun) {
  const bool each = noun.count == 1 && noun.last == noun.first + 2 && document_.tokens[noun.last - 1].text == "each";
  for (std::size_t l = document_.links.size(); each && l-- > sentence_links_;) {
    const Link link = document_.links[l];
    if (link.kind != Link::Kind::kRelation || link.targets.size() != 1 || link.references.size() != 1) continue;
    const int thing = link.targets.front(), by = link.references.front();
    if (!is_thing(thing) || !is_thing(by) || mention_at(by).items.size() < 2) continue;
    if (!mention_at(thing).introduces || !noun_of(thing).plural || noun_of(thing).count > 0) continue;
    references_.grow(thing, mention_at(by).items.size());
    return thing;
  }
  return -1;
}

int Scribe::make_member(int u, const NounPhrase& noun) {
  if (const int shared = share_one_each(noun); shared >= 0) return shared;
  if (const int same = make_ordinal(noun); same >= 0) return same;
  if (const int others = others_listed(u, noun); others >= 0) return others;
  if (is_another(noun) && !describes_one_of(u, noun)) {
    if (const int another = make_another(u, noun); another >= 0) return another;
  }
  if (const int more = make_more(u, noun); more >= 0) return more;
  // "two bunks on the left wall, two more on the right"
  const std::vector<int> kind = says_one_of(document_, noun.last, {"more"}) ? mentions_of(reading(u).meant) : std::vector<int>{};
  if (noun.count > 0 && !kind.empty() && is_thing(kind.front())) return more_of(kind.front(), noun);
  if (reading(u).meant == kNobody || same_as_placed(u)) {
    if (const int opposed = make_opposed(u, noun); opposed >= 0) return opposed;
  }
  int antecedent = antecedent_of(u);
  if (is_across_from(noun, antecedent)) return copy_of(antecedent, noun);
  // "Four chairs stand round the table; the fifth is by the door."
  if (antecedent >= 0 && noun.count == 0 && noun.ordinal > 1 && mention_at(antecedent).introduces &&
      static_cast<std::size_t>(noun.ordinal) == mention_at(antecedent).items.size() + 1)
    return copy_of(antecedent, noun);
  const int rest = group_left(noun);
  if (rest >= 0) antecedent = rest;
  // "two lockers stand by the door and the other two at the window": four.
  const bool of_placed = antecedent >= 0 && mention_at(antecedent).introduces &&
                         mention_at(antecedent).items.size() <= static_cast<std::size_t>(std::max(noun.count, 1)) &&
                         reading(u).role != NounRole::kReference;
  if (noun.determiner == Determiner::kOther && of_placed && rest < 0) {
    if (const int others = make_another(u, noun); others >= 0) {
      references_.join_group(others, antecedent);
      return others;
    }
  }
  // "Two of them are at the wall, and each of these has a lamp": of the two.
  const bool just_picked =
      antecedent >= 0 && noun.determiner == Determiner::kEach && noun.subset && !noun.of && is_some_of_group(antecedent);
  if (antecedent >= 0 && !just_picked && references_.has_left(antecedent, noun.count)) {
    const int whole = references_.whole_group(antecedent);
    if (mention_at(whole).items.size() >= mention_at(antecedent).items.size()) antecedent = whole;  // not the first thing of a list
  }
  const int mention = references_.mention(shared_out_to_all(u, noun, antecedent), antecedent, reading(u).role == NounRole::kReference);
  // "both have a lamp": every single one.
  if (noun.determiner == Determiner::kBoth && is(u + 1, UnitKind::kHave)) mention_at(mention).distributes = true;
  return mention;
}

// "jars are on three of the desks, and the remaining three are bare": the desks, of which so many are left; −1: none.
int Scribe::group_left(const NounPhrase& noun) const {
  const int last = noun.determiner == Determiner::kOther && noun.count > 0 ? references_.latest_group() : -1;
  return last >= 0 && is_some_of_group(last) && references_.has_left(last, noun.count) ? last : -1;
}

// The member as all of the group, where its place shares them out.
NounPhrase Scribe::shared_out_to_all(int u, const NounPhrase& noun, int antecedent) const {
  NounPhrase meant = noun;
  // "two tables, one on each side of the bed": the two, not one of them.
  const bool sides =
      is(u + 1, UnitKind::kPlace) && unit(u + 1).each && reading(u).role != NounRole::kReference && noun.count > 0 && !noun.subset;
  const PhraseSenses none;
  const PhraseSenses& senses = sides ? *unit(u + 1).senses : none;
  if (sides && antecedent >= 0 && (says(senses, RelationType::kEachSideOf) || says(senses, RelationType::kAlongSide)) &&
      mention_at(antecedent).items.size() == 2 * static_cast<std::size_t>(noun.count))
    meant.determiner = Determiner::kBoth;
  // "four lamps, one in every corner": all four.
  const bool by_all = is(u + 2, UnitKind::kNoun) && (chunk(u + 2).noun.determiner == Determiner::kEach ||
                                                     (chunk(u + 2).noun.determiner == Determiner::kBoth && !chunk(u + 2).noun.plural));
  const bool shared_out = is(u + 1, UnitKind::kPlace) && by_all && reading(u + 2).predicate == u + 1 &&
                          reading(u).role != NounRole::kReference && noun.count >= 1 && !noun.subset;
  const std::size_t all = antecedent >= 0 ? mention_at(antecedent).items.size() : 0,
                    share = static_cast<std::size_t>(std::max(noun.count, 1));
  if (shared_out && all > share && all % share == 0) meant.determiner = Determiner::kBoth;  // "six stools, two per table"
  return meant;
}

// "A bassinet is drawn up to the bed": a bassinet is a bed, but nothing stands by itself. −1: the mention means something else.
int Scribe::not_itself(int u, const NounPhrase& noun, int mention) {
  const UnitReading& own = reading(u);
  if (own.role != NounRole::kReference || own.predicate < 0 || noun.kind != NounKind::kObject || reading(own.predicate).fronted) return -1;
  const std::vector<int> placed = subjects_of(own.predicate);
  if (placed.size() != 1 || !is_thing(mention) || mention_at(placed.front()).items != mention_at(mention).items) return -1;
  if (noun_of(placed.front()).name == noun.name || !noun.exact || noun_of(placed.front()).entry == noun.entry) return -1;
  NounPhrase fresh = noun;
  fresh.determiner = Determiner::kIndefinite;
  return references_.mention(fresh, -1, false);
}

}  // namespace layoutbox::offline
