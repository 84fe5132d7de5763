#include "layoutbox/plan/reading/units.h"

#include <string>
#include <utility>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

void UnitReader::mark(std::size_t k, Use use, const std::string& role) {
  for (std::size_t i = chunk(k).first; i < chunk(k).last; ++i) {
    document_.readings[i].use = use;
    document_.readings[i].role = role;
  }
}

std::size_t UnitReader::next(std::size_t k) const {
  ++k;
  while (is(k, ChunkKind::kIgnored) || is(k, ChunkKind::kSoft)) ++k;
  return k;
}

std::size_t UnitReader::previous(std::size_t k) const {
  while (k-- > 0) {
    if (!is(k, ChunkKind::kIgnored) && !is(k, ChunkKind::kSoft)) return k;
  }
  return document_.chunks.size();
}

std::vector<Sentence> UnitReader::run() {
  for (std::size_t k = 0; k < document_.chunks.size() && !is_set(document_.stop); ++k) {
    if (k >= passed_until_ && k != passed_over_) read(k);
  }
  end_sentence();
  if (document_.rooms.empty()) document_.rooms = document_.rooms_elsewhere;
  return std::move(sentences_);
}

void UnitReader::end_sentence() {
  if (!units_.empty()) sentences_.push_back(std::move(units_));
  units_.clear();
  order_ = kNoOrder;
  in_brackets_ = false;
  share_ = 1;
  joiner_ = Joiner::kNone;
  clause_ = where_ = soft_ = skipping_ = negated_ = denies_list_ = false;
}

Unit& UnitReader::add(UnitKind kind, std::size_t k) {
  if (units_.size() >= kLongestSentence) {
    const Joiner joiner = joiner_;
    const bool soft = soft_;
    const int share = share_;
    end_sentence();
    share_ = share;
    joiner_ = joiner;
    soft_ = soft;
  }
  Unit unit;
  unit.kind = kind;
  unit.chunk = k;
  unit.joiner = joiner_;
  unit.clause = clause_;
  unit.where = where_;
  unit.soft = soft_;
  unit.share = kind == UnitKind::kNoun && !is_for_all(k) ? share_ : 1;
  if (kind == UnitKind::kNoun && is_common(chunk(k).noun)) share_ = 1;  // nor has everyone what follows
  unit.order = std::exchange(order_, kNoOrder);
  in_brackets_ = false;
  joiner_ = Joiner::kNone;
  clause_ = where_ = false;
  units_.push_back(std::move(unit));
  return units_.back();
}

// "keep a free path 0.8 m wide": no thing's.
bool UnitReader::is_size_of_way(std::size_t k) const {
  return k > 0 && is(k - 1, ChunkKind::kNoun) && chunk(k - 1).noun.kind == NounKind::kAbstract;
}

void UnitReader::read(std::size_t k) {
  switch (chunk(k).kind) {
    case ChunkKind::kStop: end_sentence(); break;
    case ChunkKind::kClause:
      if (passes_aside(k)) break;
      mark(k, Use::kIgnored, "joins clauses");
      clause_ = true;
      where_ = document_.tokens[chunk(k).first].text == "where";
      soft_ = where_ && k > 0 && is(k - 1, ChunkKind::kNoun) && chunk(k - 1).noun.kind == NounKind::kWall;
      negated_ = skipping_ = false;
      joiner_ = Joiner::kNone;
      break;
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
      instead_ = one_of(document_.tokens[chunk(k).last - 1].text, {"of", "than"});
      contrasted_ = is_one_not_wanted(k);
      if (!denies_place(k) && !denies_before(k)) negated_ = !excepts_from_nothing(k);
      break;
    case ChunkKind::kPurpose: read_purpose(k); break;
    case ChunkKind::kThere:
    case ChunkKind::kCommand:
      if (passes_keeper(k)) break;
      mark(k, Use::kIgnored, "opens a statement");
      skipping_ = negated_ = false;  // "instead of chairs there are benches"
      add(UnitKind::kOpen, k);
      break;
    case ChunkKind::kRelative:
      // "a treadmill in a room that already has a sofa": the room has it
      if (units_.size() > 1 && after_room(k) && is(next(k), ChunkKind::kHave)) {
        mark(k, Use::kUsed, "has");
        mark(next(k), Use::kUsed, "has");
        skipping_ = false;
        add(UnitKind::kOpen, k);
        passed_until_ = next(k) + 1;
        break;
      }
      if (passes_trade(k)) break;
      mark(k, Use::kUsed, "relative clause");
      skipping_ = false;
      add(UnitKind::kRelative, k);
      break;
    case ChunkKind::kAttribute:
      mark(k, Use::kIgnored, "attribute");
      if (!skipping_) add(UnitKind::kAttribute, k);
      break;
    case ChunkKind::kSize:
      mark(k, Use::kUsed, "size");
      if (!skipping_ && !is_size_of_way(k)) add(UnitKind::kSize, k);
      break;
    case ChunkKind::kNoun: read_noun(k); break;
    case ChunkKind::kRelation: read_place(k); break;
    case ChunkKind::kHave: read_have(k); break;
    case ChunkKind::kVerb: read_verb(k); break;
    case ChunkKind::kParticiple:
      mark(k, skipping_ ? Use::kIgnored : Use::kUsed, skipping_ ? "purpose" : "placing");
      if (!skipping_ && owner_ >= document_.chunks.size() && !centers_in_room(k))
        add(UnitKind::kParticiple, k);  // not "the desk's left corner"
      break;
  }
}

// The last word said was a room that something was placed in.
bool UnitReader::after_room(std::size_t k) const {
  return is(previous(k), ChunkKind::kNoun) && chunk(previous(k)).noun.kind == NounKind::kRoom && units_.back().chunk == previous(k) &&
         units_[units_.size() - 2].kind == UnitKind::kPlace;
}

// "shower not bath, sink": instead of what was named; "a rug, no table, a sofa": one item of a list of what is there, which has no "or".
bool UnitReader::is_one_not_wanted(std::size_t k) const {
  const std::string& word = document_.tokens[chunk(k).last - 1].text;
  if (word == "not") return joiner_ == Joiner::kNone && is(previous(k), ChunkKind::kNoun);
  if (word != "no" || joiner_ == Joiner::kNone || units_.empty()) return false;
  for (std::size_t i = chunk(k).last; i < document_.tokens.size() && !document_.tokens[i].ends_sentence; ++i) {
    if (document_.tokens[i].text == "or" || document_.tokens[i].text == "nor") return false;
  }
  return true;
}

// "The bar counter: five stools lined up in front of it": what is said next is told of it, and is no more of one list.
bool UnitReader::is_topic_before_colon(std::size_t k) const {
  if (document_.tokens[chunk(k).first].text != ":" || units_.empty() || units_.back().kind != UnitKind::kNoun) return false;
  if (units_.size() > 1) return is_placed_topic(k);
  const NounPhrase& topic = chunk(units_.front().chunk).noun;
  return topic.kind == NounKind::kObject && topic.determiner == Determiner::kDefinite && !topic.is_plural();
}

// "By the door a rack: three hats on it, a pair of boots beneath": what has a place of its own is not by the door.
bool UnitReader::is_placed_topic(std::size_t k) const {
  const NounPhrase& topic = chunk(units_.back().chunk).noun;
  if (topic.kind != NounKind::kObject || topic.is_plural() || units_.back().joiner != Joiner::kNone) return false;
  if (units_.front().kind != UnitKind::kPlace || units_[units_.size() - 2].kind == UnitKind::kPlace) return false;
  for (const Unit& unit : units_) {
    if (unit.kind != UnitKind::kPlace && unit.kind != UnitKind::kNoun) return false;
  }
  const std::size_t n = next(k);
  return is(n, ChunkKind::kRelation) || (is(n, ChunkKind::kNoun) && is(next(n), ChunkKind::kRelation));
}

// "…, and mounted on the wall over it is a row of monitors": a clause whose subject comes last.
bool UnitReader::inverts_after(std::size_t k) const {
  std::size_t c = next(k);
  const bool hung = is(c, ChunkKind::kRelation) && lexicon_.is(document_.tokens[chunk(c).first], WordClass::kHang);  // "mounted on"
  if (!hung && !is(c, ChunkKind::kParticiple)) return false;
  if (!hung) c = next(c);
  bool placed = false;
  const auto by_it = [&](std::size_t at) { return document_.tokens[chunk(at).last - 1].text == "it"; };  // "over it"
  for (; is(c, ChunkKind::kRelation) && (by_it(c) || is(next(c), ChunkKind::kNoun)); c = by_it(c) ? next(c) : next(next(c))) placed = true;
  return placed && is(c, ChunkKind::kVerb) && one_of(document_.tokens[chunk(c).first].text, {"is", "are"}) &&
         is(next(c), ChunkKind::kNoun) && is_new_here(chunk(next(c)).noun);
}

// "without a TV, a sofa or a rug": a list of what is not wanted, which "or" joins, its articles repeated.
bool UnitReader::goes_on_to_or(std::size_t k) const {
  const auto is_or = [&](std::size_t c) { return is(c, ChunkKind::kAnd) && one_of(document_.tokens[chunk(c).first].text, {"or", "nor"}); };
  std::size_t at = k;
  while (is(at, ChunkKind::kComma) && is(next(at), ChunkKind::kNoun)) at = next(next(at));
  return is_or(at) && is(next(at), ChunkKind::kNoun);
}

void UnitReader::read_break(std::size_t k) {
  const bool comma = is(k, ChunkKind::kComma);
  mark(k, Use::kIgnored, comma ? "" : "joins");
  if (in_brackets_ && comma) return;
  const std::size_t n = next(k);
  if (inverts_after(k)) {
    clause_ = true;
    negated_ = skipping_ = false;
    joiner_ = Joiner::kNone;
    return;
  }
  const bool after_comma = !comma && is(previous(k), ChunkKind::kComma);  // "…, and the chair": as after the comma
  if (skipping_ && !is(n, ChunkKind::kAnd) && purpose_ends(after_comma && names_thing(n) ? previous(k) : k, n)) skipping_ = false;
  denies_list_ |= negated_ && is(previous(k), ChunkKind::kWithout) && document_.tokens[chunk(k).first].text == ":";
  if (negated_ && !denies_list_) {
    // "no sharp edges, toy chest below the window": what has a place of its own is there, and so is the list that it ends
    const bool placed = comma && (lists_placed(n) || turns_to_furniture(k, n));
    const bool more = is(n, ChunkKind::kNoun) && chunk(n).noun.determiner == Determiner::kNone && chunk(n).noun.count == 0 && !placed;
    // "facing the door, not the wall, chair, bookcase": what was told apart was a place
    const bool told_apart = comma && is(previous(k), ChunkKind::kNoun) && is_part_of_room(chunk(previous(k)).noun) &&
                            chunk(previous(k)).noun.determiner == Determiner::kDefinite;
    if ((!more && !goes_on_to_or(k)) || told_apart || (comma && contrasted_) ||
        (document_.tokens[chunk(k).first].text == ":" && is(previous(k), ChunkKind::kNoun)))
      negated_ = false;
  }
  if (is_topic_before_colon(k)) {
    clause_ = true;
    return;
  }
  if (comma)
    joiner_ = joiner_ == Joiner::kNone || joiner_ == Joiner::kComma ? Joiner::kComma : Joiner::kCommaAnd;  // "… and, across from it, …"
  else
    joiner_ = joiner_ == Joiner::kComma ? Joiner::kCommaAnd : Joiner::kAnd;
}

void UnitReader::read_have(std::size_t k) {
  if (passes_company(k) || passes_depicted(k)) return;
  const std::string& word = document_.tokens[chunk(k).first].text;
  const std::size_t n = next(k);
  if (skipping_) {
    const bool finite = is_finite(word) && is(previous(k), ChunkKind::kNoun) &&
                        !(doing_ && chunk(previous(k)).noun.kind == NounKind::kPronoun);  // "the vet says it needs light"
    const NounPhrase* noun = is(n, ChunkKind::kNoun) ? &chunk(n).noun : nullptr;
    const bool thing = noun != nullptr && noun->kind == NounKind::kObject &&
                       (noun->entry != nullptr || noun->determiner == Determiner::kIndefinite || noun->count > 0);
    if (finite || thing) skipping_ = false;
  }
  mark(k, skipping_ ? Use::kIgnored : Use::kUsed, skipping_ ? "purpose" : "has");
  if (!skipping_) add(UnitKind::kHave, k);
}

// "a clock shaped like a cat is hung on the wall": the verb is the clock's, which has none yet.
bool UnitReader::ends_comparison(std::size_t k) const {
  const std::size_t whom = previous(k), like = previous(whom);
  if (doing_ || !chunk(k).passive || !is(whom, ChunkKind::kNoun) || !is(like, ChunkKind::kPurpose)) return false;
  if (!one_of(document_.tokens[chunk(like).last - 1].text, {"like", "for", "as", "of"})) return false;
  for (std::size_t u = units_.size(); u-- > 0;) {
    if (units_[u].kind == UnitKind::kVerb || units_[u].kind == UnitKind::kOpen) return false;
    if (units_[u].clause || (units_[u].kind == UnitKind::kNoun && units_[u].joiner != Joiner::kNone)) break;
  }
  return !units_.empty() && units_.back().kind == UnitKind::kNoun;
}

void UnitReader::read_verb(std::size_t k) {
  if (skipping_ && is(previous(k), ChunkKind::kNoun) &&
      (is_finite(document_.tokens[chunk(k).first].text) || (!chunk(k).passive && is(next(k), ChunkKind::kRelation))))
    skipping_ = false;
  // "the first thing he sees is a mirror", "the stove we cook on is against the wall"
  const std::string& be = document_.tokens[chunk(k).first].text;
  if (skipping_ && (ends_comparison(k) || ends_contact_clause(k))) skipping_ = false;
  const bool over = doing_ && (be == "is" || be == "are") && !is(previous(k), ChunkKind::kNoun) && !units_.empty() &&
                    units_.back().kind == UnitKind::kNoun;
  if (over) skipping_ = false;
  mark(k, skipping_ ? Use::kIgnored : Use::kUsed, skipping_ ? "purpose" : "placing");
  if (skipping_) return;
  add(UnitKind::kVerb, k);
  centers_in_room(k);
}

std::vector<Sentence> read_units(const Lexicon& lexicon, Document& document) { return UnitReader(lexicon, document).run(); }

}  // namespace layoutbox::offline
