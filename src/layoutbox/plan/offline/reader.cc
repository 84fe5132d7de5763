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
  if (k < passed_until_) return;
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
      skipping_ = false;
      if (denies_place(k)) break;
      negated_ = !excepts_from_nothing(k);
      break;
    case ChunkKind::kPurpose:
      if (names_contents(k)) {
        read_have(k);
        break;
      }
      if (passes_count(k) || passes_role(k)) break;
      if (k > 0 && chunk(k).first > 0 && lexicon_.is(document_.tokens[chunk(k).first - 1], WordClass::kCommand) &&
          lexicon_.is(document_.tokens[chunk(k).first], WordClass::kCommand)) {
        mark(k, Use::kIgnored, "opens a statement");  // "for the bedroom I imagine a bed"
        break;
      }
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
      if (chunk(k).hang && !chain_.empty() &&
          !(is(next(next(k)), ChunkKind::kNoun) && chunk(next(next(k))).noun.kind == NounKind::kFloor)) {
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

// "a table", "two chairs": brought in here.
bool DocumentReader::new_thing_at(std::size_t k) const {
  if (!is(k, ChunkKind::kNoun) || chunk(k).noun.kind != NounKind::kObject) return false;
  const NounPhrase& noun = chunk(k).noun;
  return noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother ||
         (noun.determiner == Determiner::kNone && noun.count > 0);
}

// "the bed", "it", "the corner", "each desk".
bool DocumentReader::speaks_of_known(const NounPhrase& noun) const {
  return noun.kind != NounKind::kObject || noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kEach ||
         noun.determiner == Determiner::kPossessive || noun.determiner == Determiner::kBoth;
}

// "in front of the sofa is a table", "near the window, a chair": a place before its thing.
bool DocumentReader::place_comes_first(std::size_t k) const {
  const std::size_t n = next(k);
  // "and to its right is a lamp"
  if (((is(n, ChunkKind::kVerb) && chunk(n).passive) || is(n, ChunkKind::kThere)) && is(k, ChunkKind::kRelation) &&
      has_direction(*chunk(k).phrase.senses, Direction::kAlone))
    return is(next(n), ChunkKind::kNoun) && chunk(next(n)).noun.kind == NounKind::kObject;
  if (!is(n, ChunkKind::kNoun) || verb_at(k)) return false;
  std::size_t after = next(n);
  if (chunk(n).noun.owner) after = next(after);
  if (new_thing_at(after) && speaks_of_known(chunk(n).noun)) return true;  // "in front of it a table"
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
      // In a list without articles the next bare thing goes on with it: "bed for guests, desk, lamp".
      const bool bare_list = !roots_.empty() && noun_of(roots_.front()).determiner == Determiner::kNone &&
                             noun_of(roots_.front()).kind == NounKind::kObject && noun_of(roots_.front()).count == 0;
      if (comma && bare_list && noun.kind == NounKind::kObject && noun.exact) resume = true;
      // "to be used as an office: sofa bed, desk, …"
      if (comma && document_.tokens[chunk(k).first].text == ":" && noun.kind == NounKind::kObject) resume = true;
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

}  // namespace layoutbox::offline
