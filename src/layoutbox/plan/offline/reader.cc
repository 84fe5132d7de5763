#include "layoutbox/plan/offline/reader.h"

#include <algorithm>

#include "layoutbox/plan/offline/knowledge.h"

namespace layoutbox::offline {
namespace {

using Direction = PhraseSense::Direction;

// How many mentions back "it" may reach; keeps long texts linear.
constexpr std::size_t kReach = 200;

bool has_direction(const PhraseSenses& senses, Direction direction) {
  return std::any_of(senses.begin(), senses.end(), [&](const PhraseSense& s) { return s.direction == direction; });
}

PhraseSenses with_direction(const PhraseSenses& senses, Direction direction) {
  PhraseSenses chosen;
  for (const PhraseSense& sense : senses) {
    if (sense.direction != direction) continue;
    chosen.push_back(sense);
    chosen.back().direction = Direction::kDirect;
  }
  return chosen;
}

bool says(const PhraseSenses& senses, RelationType type) {
  return std::any_of(senses.begin(), senses.end(), [&](const PhraseSense& s) { return s.type == type; });
}

// "holds", "decorates": a finite verb among the relation phrases and the words of having.
bool is_finite(std::string_view word) {
  static constexpr std::string_view kNot[] = {"across", "towards", "besides", "plus", "as", "opposites"};
  return word.size() > 2 && word.ends_with("s") && std::find(std::begin(kNot), std::end(kNot), word) == std::end(kNot);
}

bool contains(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }

}  // namespace

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
  expects_reference_ = expects_content_ = skipping_ = negated_ = soft_ = hang_ = false;
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
  roots_.clear();
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
      const int place = document_.tokens[chunk(k).first].text == "where" && !chain_.empty() ? chain_.back() : -1;
      begin_clause();
      in_room_list_ = false;
      where_host_ = place;
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

int DocumentReader::implied_reference(const std::vector<int>& targets) const {
  const auto usable = [&](int mention) {
    if (mention < 0 || !is_thing(mention)) return false;
    for (const int target : targets) {
      for (const int item : document_.mentions[static_cast<std::size_t>(target)].items) {
        if (contains(document_.mentions[static_cast<std::size_t>(mention)].items, item)) return false;
      }
    }
    return true;
  };
  for (std::size_t f = frames_.size(); f-- > 0;) {
    for (const int host : frames_[f].hosts) {
      if (!frames_[f].room && usable(host)) return host;
    }
  }
  for (const int subject : subject_) {
    if (usable(subject)) return subject;
  }
  for (std::size_t r = roots_.size(); r-- > 0;) {
    if (usable(roots_[r])) return roots_[r];
  }
  if (usable(last_topic_)) return last_topic_;
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (usable(static_cast<int>(m))) return static_cast<int>(m);
  }
  return -1;
}

int DocumentReader::implied_group(const std::vector<int>& targets) const {
  const auto usable = [&](int mention) {
    return mention >= 0 && document_.mentions[static_cast<std::size_t>(mention)].items.size() > 1 && !contains(targets, mention);
  };
  for (std::size_t f = frames_.size(); f-- > 0;) {
    for (const int host : frames_[f].hosts) {
      if (usable(host)) return host;
    }
  }
  for (std::size_t c = chain_.size(); c-- > 0;) {
    if (usable(chain_[c])) return chain_[c];
  }
  for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
    if (usable(static_cast<int>(m))) return static_cast<int>(m);
  }
  return implied_reference(targets);
}

void DocumentReader::read_noun(std::size_t k) {
  using Use = WordReading::Use;
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
  if (noun.kind == NounKind::kDoor || noun.kind == NounKind::kWindow) document_.openings.push_back(noun);

  std::vector<int> busy;
  if (expects_reference_ && reference_link_ >= 0) busy = link_at(reference_link_).targets;
  if (expects_reference_ && busy.empty() && !chain_.empty()) busy = {chain_.back()};
  int antecedent = -1;
  const bool base_is_pronoun = noun.of && (noun.of->kind == NounKind::kPronoun || noun.of->kind == NounKind::kMember);
  if (noun.kind == NounKind::kPronoun) {
    antecedent = noun.plural ? implied_group(busy) : implied_reference(busy);
    if (noun.head == "which" && !chain_.empty()) antecedent = chain_.back();
  } else if (noun.kind == NounKind::kMember) {
    antecedent = references_.latest_group();
    for (std::size_t c = chain_.size(); c-- > 0;) {
      if (mention_at(chain_[c]).items.size() > 1) {
        antecedent = chain_[c];
        break;
      }
    }
    // "two chairs on each long side and one on each short side": another one of the kind.
    const bool direct_follows = is(next(k), ChunkKind::kRelation) && has_direction(*chunk(next(k)).phrase.senses, Direction::kDirect);
    if ((joiner_ == Joiner::kAnd || joiner_ == Joiner::kCommaAnd) && noun.determiner == Determiner::kNone && noun.count > 0 &&
        !noun.subset && !expects_reference_ &&
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
  if (owner_ >= 0 && !owned.of) owned.of = std::make_shared<NounPhrase>(noun_of(owner_));
  if (owned.of && owner_ >= 0) owned.of->determiner = Determiner::kDefinite;
  owner_ = -1;
  const int mention = references_.mention(owned, antecedent, expects_reference_);
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

// What stands for an area of the room: "the dining area" is where the dining table is, "the seating area" where one sits.
int DocumentReader::thing_of_zone(const NounPhrase& noun) const {
  static constexpr std::string_view kZones[] = {"area",    "zone", "nook",    "setup",  "arrangement",
                                                "section", "spot", "station", "corner", "set-up"};
  if (std::find(std::begin(kZones), std::end(kZones), noun.head) == std::end(kZones) || noun.determiner != Determiner::kDefinite) return -1;
  const std::string words = words_between(document_, noun.first, noun.last);
  int seat = -1, named = -1;
  for (std::size_t m = document_.mentions.size(); m-- > 0;) {
    const Mention& mention = document_.mentions[m];
    if (mention.items.empty() || !mention.introduces || mention.noun.kind != NounKind::kObject) continue;
    const std::string first = mention.noun.name.substr(0, mention.noun.name.find(' '));
    if (first != mention.noun.name && words.find(first) != std::string::npos) {
      if (!is_seat(lexicon_.catalog(), mention.noun)) return static_cast<int>(m);
      if (named < 0) named = static_cast<int>(m);
    }
    if (seat < 0 && is_seat(lexicon_.catalog(), mention.noun)) seat = static_cast<int>(m);
  }
  if (named >= 0) return named;
  if (words.find("seating") != std::string::npos || words.find("sitting") != std::string::npos || words.find("lounge") != std::string::npos)
    return seat;
  if (words.find("sleeping") != std::string::npos) {
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      if (!document_.mentions[m].items.empty() && document_.mentions[m].noun.head == "bed") return static_cast<int>(m);
    }
  }
  return last_topic_ >= 0 && is_thing(last_topic_) ? last_topic_ : -1;
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

void DocumentReader::place_root(std::size_t k, int mention) {
  const NounPhrase& noun = noun_of(mention);
  const bool thing = is_thing(mention);
  // A subject after a verb opens a clause of its own; a command's objects share it.
  if (!subject_.empty() && !imperative_ && joiner_ != Joiner::kNone) {
    const bool room_list = in_room_list_;
    begin_clause();
    in_room_list_ = room_list;
  }
  if (imperative_ && is(next(k), ChunkKind::kVerb)) imperative_ = false;
  while (!frames_.empty() && !frames_.back().room) frames_.pop_back();
  reference_link_ = -1;
  after_participle_ = false;
  roots_.push_back(mention);
  root_joiners_.push_back(joiner_);
  root_modified_.push_back(false);
  chain_ = {mention};
  if (!thing) return;
  // "each", "one": speaks of things that are there already.
  for (const int link : fronted_) {
    Link& waiting = link_at(link);
    if (!waiting.targets.empty() && waiting.references.empty())
      waiting.references = {mention};
    else if (waiting.references.empty() || !contains(waiting.references, mention)) {
      waiting.targets.push_back(mention);
      if (waiting.each) grow_for_sides(waiting.senses, mention);
      for (const int reference : waiting.references) {
        if (mention_at(reference).distributes && mention_at(reference).items.size() > 1)
          references_.grow(mention, mention_at(mention).items.size() * mention_at(reference).items.size());
      }
    }
    root_modified_.back() = true;
  }
  if (!imperative_ && hang_ && !fronted_.empty()) hang({mention}, k);  // "above the bed hangs a painting"
  if (imperative_) {
    if (joiner_ == Joiner::kNone) subject_.clear();
    subject_.push_back(mention);
    if (hang_) hang({mention}, k);
  }
  (void)noun;
  imply_adjective(mention, k);
}

void DocumentReader::place_reference(std::size_t k, int mention) {
  expects_reference_ = false;
  Link& link = link_at(reference_link_);
  link.references.push_back(mention);
  link.last = chunk(k).last;
  last_reference_ = static_cast<int>(k);
  if (noun_of(mention).kind == NounKind::kWall) last_wall_ = mention;
  const bool is_fronted = contains(fronted_, reference_link_) || reference_link_ == held_for_with_;
  if (!is_fronted && link.references.size() == 1) {
    link.targets = targets_for(link.senses, Direction::kDirect, noun_of(mention), after_participle_, k);
    for (const int target : link.targets) {
      for (std::size_t r = 0; r < roots_.size(); ++r) {
        if (roots_[r] == target) root_modified_[r] = true;
      }
    }
    // Several at each side, desk or corner: as many as the places ask for.
    if (link.each && is_thing(mention)) {
      for (const int target : link.targets) grow_for_sides(link.senses, target);
    }
    if (noun_of(mention).kind == NounKind::kCorner && noun_of(mention).determiner == Determiner::kEach) {
      for (const int target : link.targets) {
        if (noun_of(target).count == 0 || noun_of(target).count == 1) references_.grow(target, 4);
      }
    }
    if (mention_at(mention).distributes) {
      for (const int target : link.targets) {
        const std::size_t places = std::max<std::size_t>(mention_at(mention).items.size(), 1);
        if (mention_at(mention).distributes && places > 1) references_.grow(target, mention_at(target).items.size() * places);
      }
    }
    // A screen on a stand looks where the stand looks.
    if (says(link.senses, RelationType::kFacing) && chain_.size() > 1 && link.targets.size() == 1 &&
        link.targets.front() == chain_.back() && is_thing(chain_[chain_.size() - 2])) {
      const NounPhrase& carried = noun_of(chain_[chain_.size() - 2]);
      if (carried.head == "tv" || carried.head == "television" || carried.head == "monitor" || carried.head == "screen")
        link.targets.push_back(chain_[chain_.size() - 2]);
    }
    if (hang_ && !link.targets.empty()) {
      const NounKind kind = noun_of(mention).kind;
      const std::vector<int> hung = link.targets;  // `link` does not outlive a new one
      if (kind != NounKind::kWall && kind != NounKind::kCeiling) hang(hung, k);
      hang_ = false;
    }
  }
  if (is_thing(mention) && !is_fronted) chain_.push_back(mention);
}

void DocumentReader::place_content(std::size_t k, int mention) {
  const bool first = expects_content_;
  expects_content_ = false;
  if (frames_.empty()) {
    place_root(k, mention);
    return;
  }
  if (frames_.back().room) {
    place_root(k, mention);
    return;
  }
  const Frame frame = frames_.back();
  chain_.erase(
      std::remove_if(chain_.begin(), chain_.end(), [&](int m) { return frame.link >= 0 && contains(link_at(frame.link).targets, m); }),
      chain_.end());
  for (const int host : frame.hosts) {
    if (!contains(chain_, host)) chain_.push_back(host);
  }
  if (is_thing(mention)) {
    if (frame.link >= 0) {
      Link& link = link_at(frame.link);
      link.targets.push_back(mention);
      link.last = chunk(k).last;
      for (const int host : frame.hosts) {
        if (mention_at(host).distributes)
          references_.grow(mention, mention_at(mention).items.size() * std::max<std::size_t>(mention_at(host).items.size(), 1));
      }
    }
    imply_adjective(mention, k);
  }
  chain_.push_back(mention);
  reference_link_ = -1;
  after_participle_ = false;
  (void)first;
}

bool DocumentReader::goes_on_with_reference(std::size_t k, const NounPhrase& noun) const {
  if (reference_link_ < 0 || last_reference_ < 0) return false;
  const Link& link = document_.links[static_cast<std::size_t>(reference_link_)];
  const bool adjacent = next(next(static_cast<std::size_t>(last_reference_))) == k;
  if (!adjacent || link.references.empty()) return false;
  if (says(link.senses, RelationType::kBetween)) return joiner_ == Joiner::kAnd;
  if (joiner_ != Joiner::kAnd) return false;
  const NounPhrase& former = noun_of(link.references.back());
  const auto definite = [](const NounPhrase& n) {
    return n.determiner == Determiner::kDefinite || n.determiner == Determiner::kEach || n.determiner == Determiner::kBoth ||
           n.determiner == Determiner::kPossessive;
  };
  const bool place = former.kind != NounKind::kObject;
  if (place || noun.kind != NounKind::kObject) return place && noun.kind == former.kind && noun.kind != NounKind::kRoom;
  if (definite(former) != definite(noun)) return false;
  const std::size_t n = next(k);
  if (contains(fronted_, reference_link_)) return true;
  return !is(n, ChunkKind::kRelation) && !verb_at(n) && !is(n, ChunkKind::kParticiple) && !is(n, ChunkKind::kHave);
}

bool DocumentReader::goes_on_with_contents(std::size_t k, const NounPhrase& noun) const {
  if (frames_.empty() || joiner_ == Joiner::kNone) return false;
  const Frame& frame = frames_.back();
  if (frame.room || frame.link < 0) return false;
  const Link& link = document_.links[static_cast<std::size_t>(frame.link)];
  if (noun.kind != NounKind::kObject && !noun.collective && noun.kind != NounKind::kAbstract) return false;
  if (noun.kind == NounKind::kMember || link.targets.empty()) return false;
  const std::size_t n = next(k);
  if (verb_at(n)) {
    // "a cart stocked with glasses and bottles stands": the verb's number tells that the cart is its subject.
    const std::string& verb = document_.tokens[chunk(n).first].text;
    const bool singular = verb == "is" || verb == "was" || (verb != "was" && verb.ends_with("s"));
    return joiner_ == Joiner::kAnd && singular && noun.is_plural();
  }
  if (frame.hosts.empty()) return true;
  const NounPhrase& host = noun_of(frame.hosts.front());
  if (host.kind == NounKind::kWall || host.kind == NounKind::kCorner) return joiner_ == Joiner::kAnd || joiner_ == Joiner::kComma;
  const Catalog& catalog = lexicon_.catalog();
  if (noun.kind == NounKind::kAbstract) return !noun.collective || joiner_ != Joiner::kNone;
  if (host.entry != nullptr && host.entry->thin) return false;
  const bool shares_article = joiner_ == Joiner::kAnd && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural &&
                              noun_of(link.targets.back()).determiner != Determiner::kNone;
  if (shares_article) return true;
  if (frame.after_comma && mount_of(noun) == Mount::kFloor) return false;
  const NounPhrase& former = noun_of(link.targets.back());
  const bool carried = may_carry(catalog, host, noun);
  if (link.kind == Link::Kind::kHave) {
    if (link.holding && mount_of(noun) == Mount::kSurface) return true;
    if (carried && (link.holding || may_carry(catalog, host, former))) return true;
    const bool on_top = is(n, ChunkKind::kRelation) && says(*chunk(n).phrase.senses, RelationType::kOn) && !is(next(n), ChunkKind::kNoun);
    if (joiner_ == Joiner::kAnd && on_top) return true;
    if (joiner_ == Joiner::kAnd) return mount_of(former) == mount_of(noun) && !is(n, ChunkKind::kRelation) && !is(n, ChunkKind::kHave);
    return false;
  }
  // "surrounded by a sofa and two ottomans", "flanked by a lamp and a plant".
  if (joiner_ == Joiner::kAnd) return !is(n, ChunkKind::kRelation) || carried;
  return carried && mount_of(former) == Mount::kSurface;
}

std::vector<int> DocumentReader::joined_with(int mention, bool after_participle, bool in_center) const {
  if (contains(subject_, mention)) return subject_;
  const auto at = std::find(roots_.begin(), roots_.end(), mention);
  std::vector<int> joined{mention};
  const auto shares = [&](int later, int former) {
    const NounPhrase& noun = noun_of(later);
    return noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && noun_of(former).determiner != Determiner::kNone;
  };
  if (!frames_.empty() && frames_.back().link >= 0) {  // "with a small desk and bookshelf in the corner"
    const std::vector<int>& contents = document_.links[static_cast<std::size_t>(frames_.back().link)].targets;
    const auto own = std::find(contents.begin(), contents.end(), mention);
    if (own != contents.end() && own != contents.begin() && shares(mention, *(own - 1))) joined.insert(joined.begin(), *(own - 1));
    if (own != contents.end()) return joined;
  }
  if (at == roots_.end()) return joined;
  for (std::size_t r = static_cast<std::size_t>(at - roots_.begin()); r > clause_start_; --r) {
    const bool shares_article = shares(roots_[r], roots_[r - 1]);
    if (root_joiners_[r] != Joiner::kAnd || root_modified_[r - 1] || !is_thing(roots_[r - 1])) break;
    const bool pair_in_center = in_center && r == clause_start_ + 1 && r + 1 == roots_.size();
    if (!shares_article && !after_participle && !pair_in_center) break;
    joined.insert(joined.begin(), roots_[r - 1]);
  }
  return joined;
}

std::vector<int> DocumentReader::targets_for(const PhraseSenses& senses, Direction direction, const NounPhrase& reference,
                                             bool after_participle, std::size_t k) const {
  (void)k;
  const Catalog& catalog = lexicon_.catalog();
  const bool apart =
      joiner_before_relation_ == Joiner::kComma || joiner_before_relation_ == Joiner::kCommaAnd || joiner_before_relation_ == Joiner::kAnd;
  int best = -1, best_score = 0;
  const std::size_t count = chain_.size();
  for (std::size_t step = 0; step < count; ++step) {
    const std::size_t c = apart ? step : count - 1 - step;  // after a comma the root comes first
    const int mention = chain_[c];
    if (!is_thing(mention)) continue;
    const NounPhrase& noun = noun_of(mention);
    const auto sense = choose_sense(catalog, senses, direction, noun, reference);
    if (!sense) continue;
    int score = 10 * suits(catalog, *sense, noun, reference);
    const bool root = contains(roots_, mention) || contains(subject_, mention);
    const bool room_place = reference.kind == NounKind::kCorner || reference.kind == NounKind::kWall ||
                            reference.kind == NounKind::kWindow || reference.kind == NounKind::kDoor || reference.kind == NounKind::kCenter;
    if (room_place && !apart && step == 0 && count > 1 && is_content(mention) &&
        (is_seat(catalog, noun) || mount_of(noun) == Mount::kSurface) && !hang_)
      score -= 12;
    // What was there before is seldom placed anew by the way.
    if (!document_.mentions[static_cast<std::size_t>(mention)].introduces && !root) score -= 15;
    if (hang_ && !apart && c + 1 == count && score > 0) score += 12;  // "a bicycle hung on the wall"
    if (reference.kind == NounKind::kObject && noun.name == reference.name && noun.first == reference.first) continue;
    if (score > best_score) best = mention, best_score = score;
  }
  if (best < 0) {
    for (const int mention : chain_) {
      if (is_thing(mention) && best < 0) best = mention;
    }
  }
  // "a door in the left wall", "two windows on the back wall".
  if (best < 0 && reference.kind == NounKind::kWall && !chain_.empty()) {
    const NounKind kind = noun_of(chain_.front()).kind;
    if (kind == NounKind::kDoor || kind == NounKind::kWindow) return {chain_.front()};
  }
  if (best < 0) return {};
  return joined_with(best, after_participle, reference.kind == NounKind::kCenter);
}

void DocumentReader::imply_adjective(int mention, std::size_t k) {
  const NounPhrase noun = noun_of(mention);
  for (const std::string& attribute : noun.attributes) {
    const bool next_to = attribute == "adjacent", near = attribute == "nearby", opposite = attribute == "opposite";
    if (!next_to && !near && !opposite) continue;
    if (!mention_at(mention).introduces) continue;
    const int reference = implied_reference({mention});
    if (reference < 0) continue;
    Link link;
    link.senses = {{next_to ? RelationType::kNextTo
                    : near  ? RelationType::kNear
                            : RelationType::kOpposite,
                    Direction::kDirect,
                    {},
                    {},
                    {}}};
    link.targets = {mention};
    link.references = {reference};
    link.first = chunk(k).first;
    link.last = chunk(k).last;
    add_link(std::move(link));
  }
}

// "a lamp on each side" is two lamps, "two chairs on each long side" four.
void DocumentReader::grow_for_sides(const PhraseSenses& senses, int target) {
  const std::size_t count = mention_at(target).items.size();
  if (says(senses, RelationType::kAlongSide))
    references_.grow(target, count * 2);
  else if (says(senses, RelationType::kEachSideOf) && count != 2)
    references_.grow(target, count * 2);
}

// "a laptop on the right side of the desk and a wallet on the left side": of the desk as well; "on the short side": of a table.
int DocumentReader::implied_side_host(const PhraseSenses& senses, const std::vector<int>& targets) const {
  const bool side = says(senses, RelationType::kLeftOf) || says(senses, RelationType::kRightOf);
  const bool table = says(senses, RelationType::kAlongSide);
  const auto own = [&](int mention) {
    for (const int target : targets) {
      for (const int item : document_.mentions[static_cast<std::size_t>(target)].items) {
        if (contains(document_.mentions[static_cast<std::size_t>(mention)].items, item)) return true;
      }
    }
    return false;
  };
  if (side && (joiner_before_relation_ == Joiner::kNone)) {
    for (std::size_t l = document_.links.size(); l-- > sentence_links_;) {
      const Link& link = document_.links[l];
      if (!(says(link.senses, RelationType::kLeftOf) || says(link.senses, RelationType::kRightOf)) || link.references.empty()) continue;
      if (is_thing(link.references.front()) && !own(link.references.front()) && frames_are_room()) return link.references.front();
    }
  }
  if (table) {
    const auto fits = [&](int mention) {
      return mention >= 0 && is_thing(mention) && !own(mention) && is_table(lexicon_.catalog(), noun_of(mention));
    };
    for (std::size_t f = frames_.size(); f-- > 0;) {
      for (const int host : frames_[f].hosts) {
        if (fits(host)) return host;
      }
    }
    for (std::size_t r = roots_.size(); r-- > 0;) {
      if (fits(roots_[r])) return roots_[r];
    }
    for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < kReach; ++looked) {
      if (fits(static_cast<int>(m))) return static_cast<int>(m);
    }
  }
  return implied_reference(targets);
}

bool DocumentReader::is_content(int mention) const {
  return std::any_of(frames_.begin(), frames_.end(), [&](const Frame& frame) {
    return frame.link >= 0 && contains(document_.links[static_cast<std::size_t>(frame.link)].targets, mention);
  });
}

bool DocumentReader::frames_are_room() const {
  return std::all_of(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.room; });
}

std::size_t DocumentReader::previous(std::size_t k) const {
  while (k-- > 0) {
    if (!is(k, ChunkKind::kIgnored) && !is(k, ChunkKind::kSoft)) return k;
  }
  return document_.chunks.size();
}

void DocumentReader::hang(const std::vector<int>& targets, std::size_t k) {
  Link link;
  link.kind = Link::Kind::kHang;
  link.targets = targets;
  link.first = chunk(k).first;
  link.last = chunk(k).last;
  add_link(std::move(link));
}

void DocumentReader::read_relation(std::size_t k) {
  const Chunk& relation = chunk(k);
  if (skipping_) {
    mark(k, WordReading::Use::kIgnored, "purpose");
    return;
  }
  mark(k, WordReading::Use::kUsed, "relation");
  joiner_before_relation_ = joiner_;
  const std::string& first_word = document_.tokens[relation.first].text;
  if (relation.placing || first_word.ends_with("ing") || first_word.ends_with("ed")) after_participle_ = true;
  if (joiner_ != Joiner::kNone && joiner_ != Joiner::kComma && place_comes_first(k)) {
    begin_clause();
  }
  const PhraseSenses& senses = *relation.phrase.senses;
  const std::size_t n = next(k);
  const bool noun_follows = is(n, ChunkKind::kNoun);
  const bool at_start = roots_.size() == clause_start_ && chain_.empty() && !expects_content_;
  Link link;
  link.first = relation.first;
  link.last = relation.last;
  link.each = relation.phrase.each;
  link.distance = relation.distance;
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
    reference_link_ = add_link(std::move(link));
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
  if (at_start) {
    const int reference = says(link.senses, RelationType::kRow) ? -1 : implied_reference({});
    if (reference >= 0) link.references = {reference};
    fronted_.push_back(add_link(std::move(link)));
    joiner_ = Joiner::kNone;
    return;
  }
  const std::size_t before = previous(k);
  // "against the wall to the right": which wall.
  if (is(before, ChunkKind::kNoun) && chunk(before).noun.kind == NounKind::kWall && last_wall_ >= 0 &&
      (says(link.senses, RelationType::kLeftOf) || says(link.senses, RelationType::kRightOf))) {
    mention_at(last_wall_).noun.wall_word = says(link.senses, RelationType::kLeftOf) ? "left" : "right";
    return;
  }
  if (is(before, ChunkKind::kNoun) && (chunk(before).noun.kind == NounKind::kAbstract || chunk(before).noun.kind == NounKind::kPart) &&
      joiner_ == Joiner::kNone)
    return;
  const bool group_only = std::all_of(link.senses.begin(), link.senses.end(),
                                      [](const PhraseSense& s) { return relation_row(s.type).arity == RelationArity::kNone; });
  std::vector<int> targets;
  if (!chain_.empty()) {
    int target = chain_.back();
    const bool apart = joiner_ != Joiner::kNone;
    const bool verb_before = is(before, ChunkKind::kVerb);
    if (apart || verb_before) target = chain_.front();
    // "a lamp on the nightstand to the left": the new thing, not the one that was there.
    if (!document_.mentions[static_cast<std::size_t>(target)].introduces) target = chain_.front();
    if (!is_thing(target)) target = chain_.front();
    if (group_only) {
      NounPhrase room;
      room.kind = NounKind::kRoom;
      int best = -1;
      for (std::size_t c = chain_.size(); c-- > 0;) {
        if (!is_thing(chain_[c]) || !document_.mentions[static_cast<std::size_t>(chain_[c])].introduces) continue;
        const int score = suits(lexicon_.catalog(), link.senses.front(), noun_of(chain_[c]), room);
        if (score > best) best = score, target = chain_[c];
      }
    }
    if (is_thing(target)) targets = joined_with(target, after_participle_, group_only && says(link.senses, RelationType::kCenterOfRoom));
    // "cups and sodas on top": all that the host has.
    if (says(link.senses, RelationType::kOn) && !frames_.empty() && frames_.back().link >= 0 &&
        contains(link_at(frames_.back().link).targets, target))
      targets = link_at(frames_.back().link).targets;
  }
  if (targets.empty()) return;
  link.targets = targets;
  if (!group_only) {
    const int reference = implied_side_host(link.senses, targets);
    if (reference >= 0) link.references = {reference};
    link.implied = true;
  }
  // "a lamp on each side": one for either side.
  if (link.each) {
    for (const int target : targets) grow_for_sides(link.senses, target);
  }
  if (relation.hang || hang_) hang(targets, k);
  hang_ = false;
  for (std::size_t r = 0; r < roots_.size(); ++r) {
    if (contains(targets, roots_[r])) root_modified_[r] = true;
  }
  add_link(std::move(link));
  joiner_ = Joiner::kNone;
}

void DocumentReader::read_inverse(std::size_t k, PhraseSenses senses) {
  Link link;
  link.senses = std::move(senses);
  link.first = chunk(k).first;
  link.last = chunk(k).last;
  link.each = chunk(k).phrase.each;
  const bool at_start = roots_.size() == clause_start_ && chain_.empty();
  std::vector<int> hosts;
  if (!at_start) {
    int host = chain_.empty() ? -1 : chain_.back();
    const bool apart = joiner_ != Joiner::kNone || is(previous(k), ChunkKind::kVerb);
    if (apart && !chain_.empty()) host = chain_.front();
    if (is_finite(document_.tokens[chunk(k).first].text) && roots_.size() > clause_start_) host = roots_.back();
    if (host >= 0 && !is_thing(host)) {
      for (const int mention : chain_) {
        if (is_thing(mention)) host = mention;
      }
    }
    if (relative_host_ >= 0) host = relative_host_;
    if (host >= 0) hosts = {host};
    if (host >= 0 && contains(subject_, host)) hosts = subject_;
    relative_host_ = -1;
  }
  for (const int host : hosts) {
    for (std::size_t r = 0; r < roots_.size(); ++r) {
      if (roots_[r] == host) root_modified_[r] = true;
    }
  }
  link.references = hosts;
  const int index = add_link(std::move(link));
  if (at_start) fronted_.push_back(index);
  frames_.push_back({index, hosts, false, false});
  expects_content_ = true;
  joiner_ = Joiner::kNone;
}

void DocumentReader::read_have(std::size_t k) {
  if (skipping_ && is_finite(document_.tokens[chunk(k).first].text) && is(previous(k), ChunkKind::kNoun)) skipping_ = false;
  if (skipping_) {
    mark(k, WordReading::Use::kIgnored, "purpose");
    return;
  }
  skipping_ = false;
  mark(k, WordReading::Use::kUsed, "has");
  const std::string& word = document_.tokens[chunk(k).first].text;
  Link link;
  link.kind = Link::Kind::kHave;
  link.first = chunk(k).first;
  link.last = chunk(k).last;
  const bool plain = word == "with" || word == "featuring" || word == "features" || word == "feature" || word == "including" ||
                     word == "includes" || word == "include" || word == "has" || word == "have" || word == "having";
  link.holding = !plain;
  link.weak = plain;
  const bool after_comma = joiner_ == Joiner::kComma || joiner_ == Joiner::kCommaAnd;
  joiner_ = Joiner::kNone;
  // "Flank the bed with two nightstands": the verb says how.
  if (word == "with" && arranging_link_ >= 0 && link_at(arranging_link_).references.size() == 1) {
    const std::vector<int> hosts = link_at(arranging_link_).references;
    frames_.push_back({arranging_link_, hosts, false, false});
    chain_ = hosts;
    arranging_link_ = -1;
    expects_content_ = true;
    return;
  }
  // The host: what stands right before; after a comma or a verb the clause's own thing.
  int host = chain_.empty() ? -1 : chain_.back();
  if (host >= 0 && is_thing(host) && !mention_at(host).introduces && is_thing(chain_.front()) && noun_of(host).kind == NounKind::kObject)
    host = chain_.front();
  if ((after_comma || is(previous(k), ChunkKind::kVerb)) && !chain_.empty()) host = chain_.front();
  if (is_finite(word) && roots_.size() > clause_start_) host = roots_.back();
  if (is_finite(word) && host >= 0 &&
      (noun_of(host).kind == NounKind::kWall || noun_of(host).kind == NounKind::kFloor || noun_of(host).kind == NounKind::kWindow)) {
    // "An office with white walls has a desk": the office has.
    for (const int root : roots_) {
      if (noun_of(root).kind == NounKind::kRoom) host = root;
    }
  }
  if (relative_host_ >= 0) host = relative_host_;
  relative_host_ = -1;
  if (host < 0 && !roots_.empty() && roots_.size() > clause_start_) host = roots_.back();
  link.after_comma = after_comma;
  const auto kind = host >= 0 ? noun_of(host).kind : NounKind::kRoom;
  if (host >= 0 && is_thing(host) && kind != NounKind::kAbstract) {
    link.references = joined_with(host, !plain);
    const std::vector<int> hosts = link.references;
    const int index = add_link(std::move(link));
    frames_.push_back({index, hosts, false, after_comma});
    for (std::size_t r = 0; r < roots_.size(); ++r) {
      if (contains(hosts, roots_[r])) root_modified_[r] = true;
    }
  } else if (kind == NounKind::kWall || kind == NounKind::kCorner || kind == NounKind::kCenter || kind == NounKind::kCeiling ||
             kind == NounKind::kFloor) {
    link.kind = Link::Kind::kRelation;
    link.weak = false;
    link.senses = {{RelationType::kOn, Direction::kDirect, {}, {}, {}},
                   {RelationType::kOnWall, Direction::kDirect, {}, {}, {}},
                   {RelationType::kAgainstWall, Direction::kDirect, {}, {}, {}},
                   {RelationType::kOnCeiling, Direction::kDirect, {}, {}, {}}};
    link.references = {host};
    const int index = add_link(std::move(link));
    frames_.push_back({index, {host}, false, false});
  } else if (kind == NounKind::kAbstract && !frames_.empty() && !frames_.back().room && frames_.back().link >= 0) {
    // "a desk with a setup of …": what the setup has, the desk has.
  } else {
    // A room, an area, a window: what it has is a list of things.
    frames_.push_back({-1, {}, true, false});
    if (kind == NounKind::kRoom || kind == NounKind::kOutsideRoom || kind == NounKind::kAbstract) in_room_list_ = true;
    clause_start_ = roots_.size();
    chain_.clear();
    subject_.clear();
    imperative_ = false;
  }
  expects_content_ = true;
}

void DocumentReader::read_verb(std::size_t k) {
  if (skipping_ && is_finite(document_.tokens[chunk(k).first].text) && is(previous(k), ChunkKind::kNoun)) skipping_ = false;
  if (skipping_) {
    mark(k, WordReading::Use::kIgnored, "purpose");
    return;
  }
  mark(k, WordReading::Use::kUsed, "placing");
  if (relative_host_ >= 0) {
    subject_ = {relative_host_};
    chain_ = {relative_host_};
    after_verb_ = true;
    if (chunk(k).hang) hang(subject_, k);
    relative_host_ = -1;
    joiner_ = Joiner::kNone;
    return;
  }
  const bool has_root = roots_.size() > clause_start_;
  if (!has_root || (joiner_ != Joiner::kNone && !chunk(k).passive && is(next(k), ChunkKind::kNoun))) {
    if (fronted_.empty() || has_root) {
      // A command: "Place the bed …", "…, and hang the lamp …".
      if (has_root) begin_clause();
      imperative_ = !chunk(k).passive;
      subject_.clear();
    }
    hang_ = chunk(k).hang;
    after_verb_ = false;
    joiner_ = Joiner::kNone;
    return;
  }
  // The subject: a plural verb takes all that "and" joined, a singular one the last.
  const std::string& word = document_.tokens[chunk(k).first].text;
  const bool plural_verb = word == "are" || word == "were" || word == "have" || (!word.ends_with("s") && word != "is" && word != "was");
  std::vector<int> subject{roots_.back()};
  if (plural_verb && !noun_of(roots_.back()).is_plural()) {
    for (std::size_t r = roots_.size() - 1; r > clause_start_ && root_joiners_[r] != Joiner::kNone; --r) {
      if (in_room_list_ && root_joiners_[r] != Joiner::kAnd) break;
      subject.insert(subject.begin(), roots_[r - 1]);
    }
  } else if (plural_verb && !in_room_list_) {
    for (std::size_t r = roots_.size() - 1; r > clause_start_ && root_joiners_[r] == Joiner::kAnd && !root_modified_[r - 1]; --r)
      subject.insert(subject.begin(), roots_[r - 1]);
  }
  subject.erase(std::remove_if(subject.begin(), subject.end(), [&](int m) { return subject.size() > 1 && !is_thing(m); }), subject.end());
  if (subject.empty()) subject = {roots_.back()};
  subject_ = subject;
  // "a table where puzzles lie": on the table.
  const std::size_t after = next(k);
  if (where_host_ >= 0 && is_thing(where_host_) && is_thing(subject_.front()) &&
      (is(after, ChunkKind::kStop) || is(after, ChunkKind::kComma))) {
    Link link;
    link.kind = Link::Kind::kHave;
    link.holding = true;
    link.targets = subject_;
    link.references = {where_host_};
    link.first = chunk(k).first;
    link.last = chunk(k).last;
    add_link(std::move(link));
  }
  chain_ = {subject_.front()};
  after_verb_ = true;
  imperative_ = false;
  frames_.clear();
  if (chunk(k).hang && is_thing(subject_.front())) hang(subject_, k);
  joiner_ = Joiner::kNone;
}

void read_document(const Lexicon& lexicon, Document& document) { DocumentReader(lexicon, document).read(); }

}  // namespace layoutbox::offline
