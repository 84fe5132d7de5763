#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

std::string words_between(const Document& document, std::size_t first, std::size_t last) {
  if (first >= last || last > document.tokens.size()) return {};
  const std::size_t begin = document.tokens[first].begin, end = document.tokens[last - 1].end;
  return document.prompt.substr(begin, end - begin);
}

void DocumentReader::mark(std::size_t k, WordReading::Use use, std::string role) {
  for (std::size_t i = chunk(k).first; i < chunk(k).last; ++i) {
    document_.readings[i].use = use;
    document_.readings[i].role = role;
  }
}

std::size_t DocumentReader::next(std::size_t k) const {
  ++k;
  while (is(k, ChunkKind::kIgnored) || is(k, ChunkKind::kSoft)) ++k;
  return k;
}

int DocumentReader::add_link(Link link) {
  link.soft |= soft_;
  document_.links.push_back(std::move(link));
  return static_cast<int>(document_.links.size()) - 1;
}

void DocumentReader::begin_clause() {
  if (!subject_.empty())
    last_topic_ = subject_.front();
  else if (roots_.size() > clause_start_)
    last_topic_ = roots_.back();
  clause_start_ = roots_.size();
  subject_.clear();
  fronted_.clear();
  frames_.clear();
  chain_.clear();
  after_verb_ = after_participle_ = imperative_ = false;
  expects_reference_ = expects_content_ = skipping_ = negated_ = soft_ = hang_ = centering_ = false;
  reference_link_ = last_reference_ = owner_ = relative_host_ = where_host_ = last_wall_ = arranging_link_ = held_for_with_ = -1;
  joiner_ = Joiner::kNone;
}

void DocumentReader::begin_sentence() {
  begin_clause();
  // The sentence's first thing is what the next one's "it" most likely means.
  for (const int root : roots_) {
    if (is_thing(root)) {
      last_topic_ = root;
      break;
    }
  }
  former_fronted_ = fronted_topic_;
  fronted_topic_ = -1;
  former_roots_ = std::move(roots_);
  roots_.clear();
  last_it_ = outer_root_ = one_side_link_ = -1;
  sentence_links_ = document_.links.size();
  root_joiners_.clear();
  root_modified_.clear();
  clause_start_ = 0;
  in_room_list_ = false;
}

void DocumentReader::read() {
  for (std::size_t k = 0; k < document_.chunks.size(); ++k) read_chunk(k);
}

void DocumentReader::read_chunk(std::size_t k) {
  using Use = WordReading::Use;
  switch (chunk(k).kind) {
    case ChunkKind::kStop: begin_sentence(); break;
    case ChunkKind::kClause: {
      mark(k, Use::kIgnored, "joins clauses");
      const bool says_where = document_.tokens[chunk(k).first].text == "where";
      const int place = says_where && !chain_.empty() ? chain_.back() : -1;
      begin_clause();
      in_room_list_ = false;
      where_host_ = place;
      // "against the wall where it meets the bed": which part of the wall, not a demand of its own.
      soft_ = says_where && k > 0 && chunk(k - 1).kind == ChunkKind::kNoun && chunk(k - 1).noun.kind == NounKind::kWall;
      break;
    }
    case ChunkKind::kComma:
    case ChunkKind::kAnd: read_break(k); break;
    case ChunkKind::kIgnored:
      if (document_.readings[chunk(k).first].role.empty()) mark(k, Use::kIgnored, "filler");
      break;
    case ChunkKind::kUnknown: mark(k, skipping_ ? Use::kIgnored : Use::kNotUnderstood, skipping_ ? "purpose" : "not understood"); break;
    case ChunkKind::kSoft:
      mark(k, Use::kUsed, "soft");
      soft_ = true;
      break;
    case ChunkKind::kWithout:
      mark(k, Use::kUsed, "negation");
      negated_ = true;
      skipping_ = false;
      break;
    case ChunkKind::kPurpose:
      if (names_contents(k)) {
        read_have(k);
        break;
      }
      if (passes_count(k)) break;
      mark(k, Use::kIgnored, "purpose");
      skipping_ = true;
      joiner_ = Joiner::kNone;
      break;
    case ChunkKind::kThere:
    case ChunkKind::kCommand:
      mark(k, Use::kIgnored, "opens a statement");
      skipping_ = false;
      break;
    case ChunkKind::kRelative:
      mark(k, Use::kUsed, "relative clause");
      skipping_ = false;
      relative_host_ = chain_.empty() ? last_topic_ : chain_.back();
      break;
    case ChunkKind::kAttribute:
      mark(k, after_verb_ ? Use::kUsed : Use::kIgnored, "attribute");
      if (after_verb_) {
        for (const int subject : subject_) {
          const std::string word = words_between(document_, chunk(k).first, chunk(k).last);
          const auto word_class = lexicon_.find(document_.tokens, chunk(k).first).meanings.front().word_class;
          const auto add_to = [&](NounPhrase& noun) {
            noun.attributes.push_back(word);
            noun.attribute_classes.push_back(word_class);
          };
          add_to(mention_at(subject).noun);
          for (const int item : mention_at(subject).items) add_to(document_.items[static_cast<std::size_t>(item)].noun);
        }
      }
      break;
    case ChunkKind::kSize:
      mark(k, Use::kUsed, "size");
      if (const int owner = chain_.empty() ? last_topic_ : chain_.back(); owner >= 0) {
        for (const int item : mention_at(owner).items) {
          SaidSize& size = document_.items[static_cast<std::size_t>(item)].noun.size;
          const SaidSize& said = chunk(k).size;
          if (said.width) size.width = said.width;
          if (said.depth) size.depth = said.depth;
          if (said.height) size.height = said.height;
          if (said.length) size.length = said.length;
        }
      }
      break;
    case ChunkKind::kNoun: read_noun(k); break;
    case ChunkKind::kRelation: read_relation(k); break;
    case ChunkKind::kHave: read_have(k); break;
    case ChunkKind::kVerb: read_verb(k); break;
    case ChunkKind::kParticiple:
      if (skipping_) {
        mark(k, Use::kIgnored, "purpose");
        break;
      }
      mark(k, Use::kUsed, "placing");
      after_participle_ = true;
      if (chunk(k).hang && !chain_.empty()) {
        int best = chain_.back();
        for (std::size_t c = chain_.size(); c-- > 0;) {
          if (!is_thing(chain_[c])) continue;
          const Mount mount = mount_of(noun_of(chain_[c]));
          if (mount == Mount::kWall || mount == Mount::kCeiling) {
            best = chain_[c];
            break;
          }
        }
        if (is_thing(best)) hang({best}, k);
      }
      break;
  }
}

// A verb, in whatever chunk it stands.
bool DocumentReader::verb_at(std::size_t k) const {
  if (is(k, ChunkKind::kVerb)) return true;
  return (is(k, ChunkKind::kRelation) || is(k, ChunkKind::kHave)) && is_finite(document_.tokens[chunk(k).first].text);
}

// "in front of the sofa is a table", "near the window, a chair": a place before its thing.
bool DocumentReader::place_comes_first(std::size_t k) const {
  const std::size_t n = next(k);
  // "and to its right is a lamp"
  if (is(n, ChunkKind::kVerb) && chunk(n).passive && is(k, ChunkKind::kRelation) &&
      has_direction(*chunk(k).phrase.senses, Direction::kAlone))
    return is(next(n), ChunkKind::kNoun) && chunk(next(n)).noun.kind == NounKind::kObject;
  if (!is(n, ChunkKind::kNoun) || verb_at(k)) return false;
  std::size_t after = next(n);
  if (chunk(n).noun.owner) after = next(after);
  if (is(after, ChunkKind::kVerb) || is(after, ChunkKind::kThere)) {
    const std::size_t thing = next(after);
    return is(thing, ChunkKind::kNoun) && chunk(thing).noun.kind == NounKind::kObject;
  }
  if (is(after, ChunkKind::kComma) && joiner_ != Joiner::kComma) {
    const std::size_t thing = next(after);
    return is(thing, ChunkKind::kThere) || (is(thing, ChunkKind::kNoun) && chunk(thing).noun.kind == NounKind::kObject &&
                                            chunk(thing).noun.determiner != Determiner::kDefinite);
  }
  return false;
}

void DocumentReader::read_break(std::size_t k) {
  const bool comma = is(k, ChunkKind::kComma);
  mark(k, WordReading::Use::kIgnored, comma ? "" : "joins");
  const std::size_t n = next(k);
  if (skipping_) {
    bool resume = false;
    if (is(n, ChunkKind::kNoun)) {
      const NounPhrase& noun = chunk(n).noun;
      const bool said = noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother ||
                        noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach || noun.count > 0;
      const bool definite = noun.determiner == Determiner::kDefinite && (comma || is(next(n), ChunkKind::kVerb));
      resume = (said && noun.kind != NounKind::kAbstract) || definite || (noun.kind == NounKind::kMember && comma) ||
               is(next(n), ChunkKind::kVerb);
      if (!comma && noun.kind != NounKind::kAbstract && said) resume = true;
    } else if (comma) {
      resume = is(n, ChunkKind::kRelation) || is(n, ChunkKind::kHave) || is(n, ChunkKind::kParticiple) || is(n, ChunkKind::kRelative) ||
               is(n, ChunkKind::kThere) || is(n, ChunkKind::kAnd) || is(n, ChunkKind::kVerb);
    } else {
      resume = is(n, ChunkKind::kVerb) || is(n, ChunkKind::kThere) || is(n, ChunkKind::kCommand);
    }
    if (is(n, ChunkKind::kAnd)) resume = false;  // the "and" decides
    if (resume) {
      skipping_ = false;
      expects_content_ = expects_reference_ = false;
      reference_link_ = -1;
    }
  }
  if (negated_) {
    const bool more = is(n, ChunkKind::kNoun) && chunk(n).noun.determiner == Determiner::kNone && chunk(n).noun.count == 0;
    if (!more) negated_ = false;
  }
  if (comma)
    joiner_ = Joiner::kComma;
  else
    joiner_ = joiner_ == Joiner::kComma ? Joiner::kCommaAnd : Joiner::kAnd;
  if (comma) after_participle_ = hang_ = false;
}

void DocumentReader::read_noun(std::size_t k) {
  using Use = WordReading::Use;
  if (k == passed_over_) return;
  const NounPhrase& noun = chunk(k).noun;
  if (skipping_) {
    mark(k, Use::kIgnored, "purpose");
    if (noun.kind == NounKind::kRoom) document_.rooms.push_back(noun);
    return;
  }
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
  if (noun.kind == NounKind::kRoom && !expects_reference_) document_.rooms.push_back(noun);
  if (noun.kind == NounKind::kRoom && expects_reference_ && noun.room != nullptr) document_.rooms.push_back(noun);
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
  if (read_set(k)) return;

  std::vector<int> busy;
  if (expects_reference_ && reference_link_ >= 0) busy = link_at(reference_link_).targets;
  if (expects_reference_ && busy.empty() && !chain_.empty()) busy = {chain_.back()};
  int antecedent = -1;
  const bool base_is_pronoun = noun.of && (noun.of->kind == NounKind::kPronoun || noun.of->kind == NounKind::kMember);
  if (noun.kind == NounKind::kPronoun) {
    antecedent = noun.plural ? implied_group(busy) : meant_by_it(busy);
    if (noun.head == "which" && !chain_.empty()) antecedent = chain_.back();
    if (noun.reciprocal) antecedent = -1;
    if (noun.head == "it" && expects_reference_) last_it_ = antecedent;
  } else if (noun.kind == NounKind::kMember) {
    if (expects_reference_ && other_side(k, {})) {
      mark(k, Use::kUsed, "the other side");
      return;
    }
    antecedent = references_.latest_group();
    for (std::size_t c = chain_.size(); c-- > 0;) {
      if (mention_at(chain_[c]).items.size() > 1) {
        antecedent = chain_[c];
        break;
      }
    }
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
}

}  // namespace layoutbox::offline
