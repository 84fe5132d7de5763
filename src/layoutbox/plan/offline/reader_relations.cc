// Relation phrases, having and verbs.
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

void DocumentReader::read_relation(std::size_t k) {
  const Chunk& relation = chunk(k);
  if (skipping_) {
    mark(k, WordReading::Use::kIgnored, "purpose");
    return;
  }
  // "no chairs in the room": where they are not.
  if (negated_ && joiner_ == Joiner::kNone && is(previous(k), ChunkKind::kNoun) && is(next(k), ChunkKind::kNoun)) {
    mark(k, WordReading::Use::kIgnored, "not wanted");
    mark(next(k), WordReading::Use::kIgnored, "not wanted");
    if (chunk(next(k)).noun.kind == NounKind::kRoom) document_.rooms.push_back(chunk(next(k)).noun);
    passed_until_ = next(k) + 1;
    return;
  }
  mark(k, WordReading::Use::kUsed, "relation");
  if (read_relative_place(k)) return;
  joiner_before_relation_ = joiner_;
  // "shelves full of figurines hang on the wall": the shelves do.
  const std::string& verb = document_.tokens[relation.first].text;
  if (relation.hang && (verb == "hang" || verb == "hangs") && !chain_.empty() && is_content(chain_.back()) &&
      roots_.size() > clause_start_ && is_thing(roots_.back()) && noun_of(roots_.back()).is_plural() == (verb == "hang")) {
    chain_ = {roots_.back()};
    frames_.clear();
  }
  if (document_.tokens[relation.first].text == "from") joiner_before_relation_ = Joiner::kComma;  // of the clause's own thing
  const std::string& first_word = document_.tokens[relation.first].text;
  if (relation.placing || first_word.ends_with("ing") || first_word.ends_with("ed")) after_participle_ = true;
  const bool more_places = !fronted_.empty() && roots_.size() == clause_start_;
  const PhraseSenses& senses = *relation.phrase.senses;
  const std::size_t n = next(k);
  const bool thing_at_once = is(n, ChunkKind::kNoun) && !is_finite(first_word) && has_direction(senses, Direction::kDirect) &&
                             speaks_of_known(chunk(n).noun) && !chunk(n).noun.owner && new_thing_at(next(n));
  if (joiner_ != Joiner::kNone && !more_places && (joiner_ == Joiner::kComma ? thing_at_once : place_comes_first(k))) {
    begin_clause();
  }
  // "to its right there is a plant, to its left a table": by the same thing.
  if (joiner_ != Joiner::kNone && fronted_topic_ >= 0 && has_direction(senses, Direction::kAlone) && new_thing_at(n) &&
      (says(senses, RelationType::kLeftOf) || says(senses, RelationType::kRightOf)))
    begin_clause();
  // "to your left a bookcase, to your right a fireplace"
  if (joiner_ != Joiner::kNone && has_direction(senses, Direction::kAlone) && !has_direction(senses, Direction::kDirect) &&
      says(senses, RelationType::kInRegion) && is(n, ChunkKind::kNoun) && chunk(n).noun.kind == NounKind::kObject)
    begin_clause();
  // "two sofas facing each other across a table": the table is between them.
  if (const std::size_t before = previous(k); is(before, ChunkKind::kNoun) && chunk(before).noun.reciprocal && is(n, ChunkKind::kNoun) &&
                                              (says(senses, RelationType::kOpposite) || says(senses, RelationType::kAbove))) {
    read_inverse(k, {{RelationType::kBetween, Direction::kDirect, {}, {}, {}}});
    return;
  }
  const bool noun_follows = is(n, ChunkKind::kNoun);
  const bool at_start = roots_.size() == clause_start_ && chain_.empty() && !expects_content_;
  Link link;
  link.first = relation.first;
  link.last = relation.last;
  link.each = relation.phrase.each;
  link.one_side = relation.phrase.one && says(senses, RelationType::kNextTo);
  link.distance = relation.distance;
  link.rows = relation.rows;
  link.columns = relation.columns;
  link.gap = relation.gap;
  link.at_least = relation.at_least;
  link.at_most = relation.at_most;
  const bool direct = has_direction(senses, Direction::kDirect), inverse = has_direction(senses, Direction::kInverse),
             alone = has_direction(senses, Direction::kAlone);
  if (at_start && noun_follows && first_word == "line" && relation.last - relation.first == 1 && is(next(n), ChunkKind::kRelation)) {
    imperative_ = true;  // "Line the sofa along the wall"
    joiner_ = Joiner::kNone;
    return;
  }
  if (noun_follows && inverse && !direct) {
    read_inverse(k, with_direction(senses, Direction::kInverse));
    return;
  }
  if (noun_follows && direct) {
    link.senses = with_direction(senses, Direction::kDirect);
    if (centering_) {
      link.senses.insert(link.senses.begin(), {{RelationType::kCenteredOnWall, Direction::kDirect, {}, {}, {}}});
      centering_ = false;
    }
    const bool one_side = link.one_side;
    reference_link_ = add_link(std::move(link));
    if (one_side) one_side_link_ = reference_link_;
    expects_reference_ = true;
    hang_ |= relation.hang;
    // "Flank the bed with …": a command, not a place that comes first.
    const bool command = at_start && relation.last - relation.first == 1 && is(next(n), ChunkKind::kHave) &&
                         document_.tokens[chunk(next(n)).first].text == "with";
    if (command) arranging_link_ = reference_link_;
    if (at_start) fronted_.push_back(reference_link_);
    if (command) fronted_.pop_back(), held_for_with_ = reference_link_;
    joiner_ = Joiner::kNone;
    return;
  }
  const std::string& last_word = document_.tokens[relation.last - 1].text;
  const bool open_end = last_word == "of" || last_word == "to" || last_word == "from" || last_word == "with" || last_word == "by" ||
                        last_word == "at" || last_word == "on" || last_word == "in" || last_word == "against";
  const bool up_or_down = says(senses, RelationType::kAbove) || says(senses, RelationType::kUnder);
  if (!alone && !relation.phrase.possessive && (open_end || !direct || !up_or_down)) {
    if (relation.hang && !chain_.empty()) hang({chain_.back()}, k);
    return;
  }
  // The reference is what was spoken of.
  link.senses = with_direction(senses, alone ? Direction::kAlone : Direction::kDirect);
  // "on the shelf below": which shelf.
  if (const std::size_t before = previous(k); static_cast<int>(before) == last_reference_ && joiner_ == Joiner::kNone &&
                                              (says(link.senses, RelationType::kUnder) || says(link.senses, RelationType::kAbove)) &&
                                              document_.tokens[relation.last - 1].text != "it" &&
                                              chunk(before).noun.determiner == Determiner::kDefinite)
    return;
  // "side by side": by each other.
  const bool by_each_other = (first_word == "side" || first_word == "back") && document_.tokens[relation.last - 1].text == first_word &&
                             relation.last > relation.first + 1;
  if (by_each_other || says(link.senses, RelationType::kStacked)) {
    if (chain_.empty()) return;
    Mention other;
    other.noun.kind = NounKind::kPronoun;
    other.reciprocal = true;
    document_.mentions.push_back(std::move(other));
    link.references = {static_cast<int>(document_.mentions.size()) - 1};
    const bool verb_before = is(previous(k), ChunkKind::kVerb);
    link.targets = joined_with(verb_before ? chain_.front() : chain_.back(), true);
    mean_each_other(link);
    add_link(std::move(link));
    joiner_ = Joiner::kNone;
    return;
  }
  // "against the wall to the right": which wall.
  if (is(previous(k), ChunkKind::kNoun) && chunk(previous(k)).noun.kind == NounKind::kWall && last_wall_ >= 0 &&
      (says(link.senses, RelationType::kLeftOf) || says(link.senses, RelationType::kRightOf))) {
    mention_at(last_wall_).noun.wall_word = says(link.senses, RelationType::kLeftOf) ? "left" : "right";
    return;
  }
  if (at_start) {
    const bool side = says(link.senses, RelationType::kLeftOf) || says(link.senses, RelationType::kRightOf);
    const bool lies = says(link.senses, RelationType::kOn) || says(link.senses, RelationType::kIn);
    const bool of_room = std::all_of(link.senses.begin(), link.senses.end(),
                                     [](const PhraseSense& s) { return relation_row(s.type).arity == RelationArity::kNone; });
    const bool between = says(link.senses, RelationType::kBetween);
    int reference = of_room                                           ? -1
                    : between                                         ? implied_group({})
                    : former_fronted_ >= 0 && !lies && roots_.empty() ? former_fronted_
                                                                      : implied_reference({});
    // "to the left of the sofa, a lamp; to the right, a table": of the sofa.
    for (std::size_t l = document_.links.size(); side && l-- > 0 && l + 4 > document_.links.size();) {
      const Link& before = document_.links[l];
      const bool sides = says(before.senses, RelationType::kLeftOf) || says(before.senses, RelationType::kRightOf);
      if (!sides || before.references.empty() || !is_thing(before.references.front())) continue;
      reference = before.references.front();
      break;
    }
    if (reference >= 0) link.references = {reference};
    if (relation.phrase.possessive && reference >= 0) last_it_ = reference;
    fronted_.push_back(add_link(std::move(link)));
    joiner_ = Joiner::kNone;
    return;
  }
  const std::size_t before = previous(k);
  if (is(before, ChunkKind::kNoun) && (chunk(before).noun.kind == NounKind::kAbstract || chunk(before).noun.kind == NounKind::kPart) &&
      joiner_ == Joiner::kNone)
    return;
  // "in front of it, at a distance of 50 cm": of what was placed last.
  if (says(link.senses, RelationType::kDistance) && document_.links.size() > sentence_links_) {
    const Link& placed = document_.links.back();
    link.targets = placed.targets;
    link.references = placed.references;
    if (!link.targets.empty() && !link.references.empty()) add_link(std::move(link));
    return;
  }
  // "a table with a laptop in the center": of the table.
  if (says(link.senses, RelationType::kCenterOfRoom) && !chain_.empty() && joiner_ == Joiner::kNone && is_content(chain_.back()) &&
      is_thing(chain_.back()) && mention_at(chain_.back()).items.size() == 1 && mount_of(noun_of(chain_.back())) == Mount::kSurface &&
      !frames_.back().hosts.empty()) {
    link.senses = {{RelationType::kOn, Direction::kDirect, "center", {}, {}}};
    link.targets = {chain_.back()};
    link.references = frames_.back().hosts;
    add_link(std::move(link));
    return;
  }
  // "on the altar two candles and a bible in the middle": of the altar.
  if (const int host = fronted_host(); host >= 0 && says(link.senses, RelationType::kCenterOfRoom) && !chain_.empty() &&
                                       joiner_ == Joiner::kNone && is_thing(chain_.back()) &&
                                       mount_of(noun_of(chain_.back())) == Mount::kSurface) {
    link.senses = {{RelationType::kOn, Direction::kDirect, "center", {}, {}}};
    link.targets = {chain_.back()};
    link.references = {host};
    add_link(std::move(link));
    return;
  }
  if (lies_at_end_of_host(link)) return;
  const bool group_only = std::all_of(link.senses.begin(), link.senses.end(),
                                      [](const PhraseSense& s) { return relation_row(s.type).arity == RelationArity::kNone; });
  std::vector<int> targets;
  bool all_in_row = false;
  if (!chain_.empty()) {
    int target = chain_.back();
    const bool apart = joiner_ != Joiner::kNone;
    // "a low table with a vase between them": the table is.
    if (says(link.senses, RelationType::kBetween) && is_content(target) && is_thing(chain_.front()) && is_root(chain_.front()) &&
        (may_carry(lexicon_.catalog(), noun_of(chain_.front()), noun_of(target)) || sits_at(target, chain_.front())) &&
        mention_at(chain_.front()).items.size() == 1)
      target = chain_.front();
    const bool verb_before = is(before, ChunkKind::kVerb);
    if (apart || verb_before) target = chain_.front();
    // "a lamp on the nightstand to the left": the new thing, not the one that was there.
    if (!document_.mentions[static_cast<std::size_t>(target)].introduces && !is_content(target)) target = chain_.front();
    if (!is_thing(target)) target = chain_.front();
    if (group_only) {
      NounPhrase room;
      room.kind = NounKind::kRoom;
      int best = -1;
      for (std::size_t c = chain_.size(); c-- > 0;) {
        if (!is_thing(chain_[c]) || !document_.mentions[static_cast<std::size_t>(chain_[c])].introduces) continue;
        const bool many =
            says(link.senses, RelationType::kRow) || says(link.senses, RelationType::kGrid) || says(link.senses, RelationType::kColumn);
        if (many && mention_at(chain_[c]).items.size() < 2) continue;
        const int score = suits(lexicon_.catalog(), link.senses.front(), noun_of(chain_[c]), room);
        if (score > best) best = score, target = chain_[c];
      }
    }
    // "a fridge, a stove and a sink in a row": all of them.
    if (says(link.senses, RelationType::kRow) && is_thing(target) && mention_at(target).items.size() == 1 && is_root(target)) {
      for (std::size_t r = clause_start_; r < roots_.size(); ++r) {
        if (is_thing(roots_[r])) targets.push_back(roots_[r]);
      }
    }
    const bool lies = says(link.senses, RelationType::kOn) || says(link.senses, RelationType::kIn);
    const int host = lies && is_thing(target) ? implied_side_host(link.senses, {target}) : -1;
    if (targets.size() > 1)
      all_in_row = true;
    else if (is_thing(target))
      targets = joined_with(target, after_participle_, group_only && says(link.senses, RelationType::kCenterOfRoom),
                            host >= 0 ? &noun_of(host) : nullptr);
    // "cups and sodas on top": all that the host has.
    if (says(link.senses, RelationType::kOn) && !frames_.empty() && frames_.back().link >= 0 &&
        contains(link_at(frames_.back().link).targets, target))
      targets = unplaced(link_at(frames_.back().link).targets, target, host);
  }
  if (targets.empty()) return;
  if (link.each) add_laden_stand(link.senses, targets);
  if (relation.phrase.other && one_side_link_ >= 0 && other_side(k, targets)) {
    joiner_ = Joiner::kNone;
    return;
  }
  link.targets = targets;
  if (!group_only) {
    const int reference = implied_side_host(link.senses, targets);
    if (reference >= 0) link.references = {reference};
    // "a sofa facing a TV, with a table in between": between the two.
    const bool them = document_.tokens[relation.last - 1].text == "them" && reference >= 0 && mention_at(reference).items.size() > 1;
    if (says(link.senses, RelationType::kBetween) && reference >= 0 && !them) {
      if (const int other = looked_at_by(reference, targets); other >= 0) link.references.push_back(other);
    }
    link.implied = true;
  }
  // "a lamp on each side": one for either side.
  if (link.each) {
    for (const int target : targets) grow_for_sides(link, target, link.references.empty() ? -1 : link.references.front());
  }
  if (relation.hang || hang_) hang(targets, k);
  hang_ = false;
  for (std::size_t r = 0; r < roots_.size(); ++r) {
    if (contains(targets, roots_[r])) root_modified_[r] = true;
  }
  const bool one_side = link.one_side;
  const int added = add_link(std::move(link));
  if (one_side) one_side_link_ = added;
  if (all_in_row) place_link_ = added, place_chunk_ = k;  // "… along the wall"
  joiner_ = Joiner::kNone;
}

void read_document(const Lexicon& lexicon, Document& document) { DocumentReader(lexicon, document).read(); }

}  // namespace layoutbox::offline
