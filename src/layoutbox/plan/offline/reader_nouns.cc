// A noun phrase: what it brings in or speaks of again.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

void DocumentReader::read_noun(std::size_t k) {
  using Use = WordReading::Use;
  if (k == passed_over_) return;
  if (const auto& object = chunk(k).noun.as_object;
      object != nullptr && (!expects_reference_ || chunk(k).noun.determiner == Determiner::kIndefinite) &&
      (frames_.empty() || frames_.back().room || (joiner_ == Joiner::kNone && !expects_content_)))
    document_.chunks[k].noun = NounPhrase(*object);
  // "A craft brewery taproom has a bar": what nobody knows and has things, at the very beginning, is the room.
  if (NounPhrase& first = document_.chunks[k].noun; document_.mentions.empty() && first.kind == NounKind::kObject &&
                                                    first.entry == nullptr && !first.is_plural() && is(next(k), ChunkKind::kHave) &&
                                                    !skipping_ && !negated_)
    first.kind = NounKind::kRoom;
  // "A reading corner with an armchair": so is the corner that it is all about.
  if (NounPhrase& first = document_.chunks[k].noun; document_.mentions.empty() && first.kind == NounKind::kCorner &&
                                                    first.wall_word.empty() && !expects_reference_ && is(next(k), ChunkKind::kHave))
    first.kind = NounKind::kRoom;
  if (means_wall(chunk(k).noun)) {
    NounPhrase& wall = document_.chunks[k].noun;
    wall.kind = NounKind::kWall;
    wall.wall_word = wall.head;
  }
  if (means_other_corner(k)) return;
  const NounPhrase& noun = chunk(k).noun;
  if (skipping_) {
    mark(k, Use::kIgnored, "purpose");
    if (noun.kind == NounKind::kRoom) document_.rooms.push_back(noun);
    return;
  }
  // "instead of a bathtub a shower": what stands beside what is not wanted.
  if (negated_ && joiner_ == Joiner::kNone && k > 0 && is(k - 1, ChunkKind::kNoun) && noun.determiner == Determiner::kIndefinite)
    negated_ = false;
  if (negated_) {
    mark(k, Use::kUsed, "not wanted");
    if (noun.kind == NounKind::kObject) document_.excluded.push_back(noun);
    return;
  }
  if (noun.kind == NounKind::kOutsideRoom) {
    mark(k, Use::kIgnored, "another room");
    document_.notes.push_back(
        {"ignored",
         "\"" + words_between(document_, chunk(k).first, chunk(k).last) + "\" is another room: what is said to be in it goes into this one",
         "prompt:" + std::to_string(document_.tokens[chunk(k).first].begin) + "-" +
             std::to_string(document_.tokens[chunk(k).last - 1].end)});
  }
  if (noun.kind == NounKind::kRoom && (!expects_reference_ || noun.room != nullptr)) document_.rooms.push_back(noun);
  // "a cabinet with glass doors": parts of it.
  const bool of_a_thing = expects_content_ && !frames_.empty() && !frames_.back().room && !frames_.back().hosts.empty() &&
                          is_thing(frames_.back().hosts.front());
  const bool of_bed = noun.kind == NounKind::kObject && noun.head == "mattress" && of_a_thing &&
                      noun_of(frames_.back().hosts.front()).name.find("bed") != std::string::npos;
  if (((noun.kind == NounKind::kDoor || noun.kind == NounKind::kWindow) && of_a_thing) || of_bed) {
    mark(k, Use::kUsed, "part");
    expects_content_ = is(next(k), ChunkKind::kAnd);  // "with a soft mattress and two pillows"
    joiner_ = Joiner::kNone;
    return;
  }
  if (noun.kind == NounKind::kDoor || noun.kind == NounKind::kWindow) document_.openings.push_back(noun);

  // "king bed north wall": against it.
  if ((noun.kind == NounKind::kWall || noun.kind == NounKind::kCorner) && !noun.wall_word.empty() && !expects_reference_ &&
      !expects_content_ && k > 0 && is(k - 1, ChunkKind::kNoun) && chunk(k - 1).noun.kind == NounKind::kObject && !chain_.empty()) {
    Link link;
    link.senses = {{RelationType::kAgainstWall, Direction::kDirect, {}, {}, {}}};
    link.targets = {chain_.back()};
    link.references = {references_.mention(noun, -1, true)};
    link.first = chunk(k).first;
    link.last = chunk(k).last;
    add_link(std::move(link));
    mark(k, Use::kUsed, "wall");
    return;
  }
  if (noun.kind == NounKind::kMember && take_all(k)) return;
  // "three tables with two stools each"
  if (noun.kind == NounKind::kMember && noun.determiner == Determiner::kEach && noun.count == 0 && !expects_reference_ &&
      !expects_content_ && joiner_ == Joiner::kNone && !frames_.empty() && frames_.back().link >= 0 &&
      !link_at(frames_.back().link).targets.empty() && !is(next(k), ChunkKind::kHave) && !is(next(k), ChunkKind::kRelation) &&
      !is(next(k), ChunkKind::kParticiple)) {
    std::size_t hosts = 0;
    for (const int host : frames_.back().hosts) hosts += mention_at(host).items.size();
    const int content = link_at(frames_.back().link).targets.back();
    references_.grow(content, mention_at(content).items.size() * std::max<std::size_t>(hosts, 1));
    mark(k, Use::kUsed, "reference");
    return;
  }
  if (each_has_those(k) || read_set(k)) return;

  std::vector<int> busy;
  if (expects_reference_ && reference_link_ >= 0) busy = link_at(reference_link_).targets;
  if (expects_reference_ && busy.empty() && !chain_.empty()) busy = {chain_.back()};
  int antecedent = -1;
  const bool base_is_pronoun = noun.of && (noun.of->kind == NounKind::kPronoun || noun.of->kind == NounKind::kMember);
  if (noun.kind == NounKind::kPronoun) {
    antecedent = noun.plural ? implied_group(busy) : meant_by_it(busy);
    if (noun.head == "which" && !chain_.empty()) antecedent = chain_.back();
    if (noun.head == "latter" || noun.head == "former") antecedent = of_the_two(noun.head == "former", busy);
    if (noun.reciprocal) antecedent = -1;
    if (noun.head == "it" && expects_reference_) last_it_ = antecedent;
  } else if (noun.kind == NounKind::kMember) {
    if (expects_reference_ && other_side(k, {})) {
      mark(k, Use::kUsed, "the other side");
      return;
    }
    // "the bed against the left wall, the desk against the right one"
    if (expects_reference_ && last_wall_said_ >= 0 && !noun.wall_word.empty() && reference_link_ >= 0 &&
        says(link_at(reference_link_).senses, RelationType::kAgainstWall)) {
      NounPhrase wall = noun_of(last_wall_said_);
      wall.wall_word = noun.wall_word;
      wall.first = noun.first;
      wall.last = noun.last;
      mark(k, Use::kUsed, "wall");
      read_place(k, references_.mention(wall, -1, true));
      return;
    }
    if (const int more = another_one(noun); more >= 0) {
      mark(k, Use::kUsed, "one more " + noun_of(more).name);
      read_place(k, more);
      return;
    }
    antecedent = noun.ordinal != 0 ? last_ordinal() : -1;
    if (noun.ordinal != 0 && antecedent >= 0) {  // "the first wardrobe … the second": of the same kind
      NounPhrase same = mention_at(antecedent).noun;
      same.ordinal = noun.ordinal;
      same.determiner = Determiner::kDefinite;
      same.first = noun.first;
      same.last = noun.last;
      const int mention = references_.mention(same, -1, expects_reference_);
      mark(k, Use::kUsed, "reference");
      read_place(k, mention);
      return;
    }
    const bool the_two = noun.determiner == Determiner::kDefinite && noun.count == 2 && noun.attributes.empty() && expects_reference_;
    if (const int pair = the_two ? just_related() : -1; pair >= 0) {  // "a sofa opposite the fireplace, and between the two …"
      mark(k, Use::kUsed, "reference");
      read_place(k, pair);
      return;
    }
    if (antecedent < 0) antecedent = group_meant(k, noun);
    // "ten books, five on the top shelf and five on the bottom shelf": the other five.
    if (references_.has_left(antecedent, noun.count)) antecedent = references_.whole_group(antecedent);
    // "two chairs on each long side and one on each short side": another one of the kind.
    const bool direct_follows = is(next(k), ChunkKind::kRelation) && has_direction(*chunk(next(k)).phrase.senses, Direction::kDirect);
    if ((joiner_ == Joiner::kAnd || joiner_ == Joiner::kCommaAnd) && noun.determiner == Determiner::kNone && noun.count > 0 &&
        !noun.subset && !expects_reference_ && !references_.has_left(antecedent, noun.count) &&
        (direct_follows || (is(next(k), ChunkKind::kRelation) && has_direction(*chunk(next(k)).phrase.senses, Direction::kAlone)))) {
      if (antecedent < 0 && !chain_.empty()) antecedent = chain_.front();
      int kind = frames_.empty() || frames_.back().room || frames_.back().link < 0 || link_at(frames_.back().link).targets.empty()
                     ? antecedent
                     : link_at(frames_.back().link).targets.back();
      if (kind >= 0) {
        NounPhrase copy = mention_at(kind).noun;
        copy.determiner = Determiner::kNone;
        copy.count = noun.count;
        copy.plural = noun.count > 1;
        copy.first = noun.first;
        copy.last = noun.last;
        const int mention = references_.mention(copy, -1, false);
        mark(k, Use::kUsed, "count of " + copy.name);
        read_place(k, mention);
        return;
      }
    }
  } else if (noun.kind == NounKind::kPart || noun.determiner == Determiner::kPossessive || base_is_pronoun) {
    const bool of_something = noun.kind != NounKind::kPart || expects_reference_ || expects_content_ ||
                              noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive || base_is_pronoun;
    antecedent = owner_ >= 0 ? owner_ : of_something ? implied_reference(busy) : -1;
    if (noun.determiner == Determiner::kPossessive && noun.kind != NounKind::kPart && noun.kind != NounKind::kObject &&
        noun.kind != NounKind::kCorner && noun.kind != NounKind::kCenter)
      antecedent = -1;
    if (noun.kind == NounKind::kCenter && noun.determiner == Determiner::kPossessive && document_.items.empty()) antecedent = -1;
  }
  // "the desk's left corner" is the left corner of the desk.
  NounPhrase owned = noun;
  if (noun.kind == NounKind::kMember && whole_group(k, noun, antecedent)) owned.determiner = Determiner::kBoth;
  if (owner_ >= 0 && !owned.of) owned.of = std::make_shared<NounPhrase>(noun_of(owner_));
  if (owned.of && owner_ >= 0) owned.of->determiner = Determiner::kDefinite;
  owner_ = -1;
  const bool of_known = expects_reference_ || (roots_.size() == clause_start_ && frames_.empty() && joiner_ == Joiner::kNone);
  const int mention = references_.mention(owned, antecedent, expects_reference_, of_known);
  mention_at(mention).reciprocal = noun.reciprocal;
  // "one holding a lamp and the other a vase": the verb is said once.
  if (noun.kind == NounKind::kMember && noun.determiner == Determiner::kOther && !expects_reference_ && !expects_content_ &&
      (joiner_ == Joiner::kAnd || joiner_ == Joiner::kCommaAnd) && !frames_.empty() && frames_.back().link >= 0 && is_thing(mention) &&
      is(next(k), ChunkKind::kNoun) && chunk(next(k)).noun.kind == NounKind::kObject) {
    Link same = link_at(frames_.back().link);
    same.targets.clear();
    same.references = {mention};
    frames_.push_back({add_link(std::move(same)), {mention}, false, false});
    chain_ = {mention};
    expects_content_ = true;
    joiner_ = Joiner::kNone;
    mark(k, Use::kUsed, "reference");
    return;
  }
  if (expects_reference_ && mention_at(mention).items.empty() && (noun.kind == NounKind::kAbstract || noun.kind == NounKind::kRoom)) {
    const int meant = thing_of_zone(noun);
    if (meant >= 0) {
      if (reference_link_ >= 0) link_at(reference_link_).implied = true;
      mention_at(mention).items = mention_at(meant).items;
      mention_at(mention).noun = noun_of(meant);
    }
  }
  if (noun.owner) {
    owner_ = mention;
    mark(k, Use::kUsed, "owner");
    return;
  }
  const bool abstract = noun.kind == NounKind::kAbstract && !(noun.collective && expects_content_);
  mark(k, abstract ? Use::kIgnored : Use::kUsed, abstract ? "no object" : noun.name.empty() ? "reference" : noun.name);
  read_place(k, mention);
}

void DocumentReader::read_place(std::size_t k, int mention) {
  // Collectives ("bath essentials") are things where something holds them.
  NounPhrase& noun = mention_at(mention).noun;
  if (noun.kind == NounKind::kAbstract && noun.collective && mention_at(mention).items.empty()) {
    const bool contents = (expects_content_ && !frames_.empty() && !frames_.back().room) ||
                          (joiner_ != Joiner::kNone && !frames_.empty() && !frames_.back().room);
    if (contents) {
      noun.kind = NounKind::kObject;
      document_.mentions.pop_back();
      const NounPhrase copy = [&] {
        NounPhrase n = chunk(k).noun;
        n.kind = NounKind::kObject;
        return n;
      }();
      mention = references_.mention(copy, -1, false);
      mark(k, WordReading::Use::kUsed, copy.name);
    }
  }
  NounPhrase read = mention_at(mention).noun;
  if (chunk(k).noun.kind == NounKind::kMember && !mention_at(mention).introduces) read.kind = NounKind::kMember;
  if (expects_reference_) {
    place_reference(k, mention);
  } else if (expects_content_) {
    place_content(k, mention);
  } else if (goes_on_with_reference(k, read)) {
    place_reference(k, mention);
  } else if (goes_on_with_contents(k, read)) {
    place_content(k, mention);
  } else {
    place_root(k, mention);
  }
  joiner_ = Joiner::kNone;
  add_named_contents(k, mention);
}

// "a bench along the left": along that wall.
bool DocumentReader::means_wall(const NounPhrase& noun) const {
  return expects_reference_ && reference_link_ >= 0 && noun.kind == NounKind::kPart && (noun.head == "left" || noun.head == "right") &&
         !noun.of && !noun.plural && noun.determiner != Determiner::kPossessive &&
         says(document_.links[static_cast<std::size_t>(reference_link_)].senses, RelationType::kAgainstWall);
}

// "a kitchen in one corner and a tent in the other": in another one. True if it was read.
bool DocumentReader::means_other_corner(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  if (expects_reference_ && noun.kind == NounKind::kCorner && noun.count == 1) one_corner_ = static_cast<int>(k);
  if (one_corner_ < 0 || !expects_reference_ || noun.kind != NounKind::kMember || noun.determiner != Determiner::kOther || noun.of ||
      one_side_link_ >= 0)
    return false;
  const PhraseSenses& senses = link_at(reference_link_).senses;
  if (!says(senses, RelationType::kIn) && !says(senses, RelationType::kCorner)) return false;
  NounPhrase corner = chunk(static_cast<std::size_t>(one_corner_)).noun;
  corner.first = noun.first;
  corner.last = noun.last;
  one_corner_ = -1;
  mark(k, WordReading::Use::kUsed, "corner");
  read_place(k, references_.mention(corner, -1, true));
  return true;
}

// "a rack of dumbbells": the dumbbells are on it.
void DocumentReader::add_named_contents(std::size_t k, int host) {
  static constexpr std::string_view kOpen[] = {"rack",   "crate", "basket",  "shelf", "tray",
                                               "bucket", "cart",  "trolley", "vase",  "bookshelf"};
  if (chunk(k).noun.contents == nullptr || !is_thing(host) || !mention_at(host).introduces ||
      std::find(std::begin(kOpen), std::end(kOpen), noun_of(host).head) == std::end(kOpen))
    return;
  const NounPhrase things = *chunk(k).noun.contents;
  if (!may_carry(lexicon_.catalog(), noun_of(host), things)) return;
  const int content = references_.mention(things, -1, false);
  references_.grow(content, mention_at(content).items.size() * mention_at(host).items.size());
  Link link;
  link.kind = Link::Kind::kHave;
  link.holding = true;
  link.targets = {content};
  link.references = {host};
  link.first = chunk(k).first;
  link.last = chunk(k).last;
  add_link(std::move(link));
}

}  // namespace layoutbox::offline
