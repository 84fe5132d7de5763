// Where a purpose ends: what after it is said of the thing or of the room again.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// "a lamp provides light next to the table": where the thing is, after what its verb says of the room.
bool UnitReader::place_after_purpose(std::size_t k) const {
  const std::size_t n = next(k);
  const std::size_t p = previous(k);
  const bool place = is(n, ChunkKind::kNoun) && (chunk(n).noun.kind == NounKind::kObject || chunk(n).noun.kind == NounKind::kWindow ||
                                                 chunk(n).noun.kind == NounKind::kDoor || chunk(n).noun.kind == NounKind::kCorner);
  if (!place || chunk(n).noun.determiner != Determiner::kDefinite) return false;
  // "a lamp throws light on the rug": where the light falls
  const bool falls = is(p, ChunkKind::kNoun) && one_of(chunk(p).noun.head, WordSet::kDaylight) &&
                     one_of(document_.tokens[chunk(k).first].text, {"on", "over", "onto", "upon", "across", "into"});
  if (falls) return false;
  const bool light =
      is(p, ChunkKind::kNoun) && chunk(p).noun.determiner == Determiner::kDefinite && one_of(chunk(p).noun.head, WordSet::kFromOutside);
  if (!light && (!is(p, ChunkKind::kNoun) || chunk(p).noun.kind != NounKind::kAbstract)) return false;
  if (chunk(p).noun.determiner == Determiner::kIndefinite && !is_zone(chunk(p).noun.head))
    return false;  // "forms a sitting area on the rug"
  for (std::size_t c = k; c-- > 0 && !is(c, ChunkKind::kComma) && !is(c, ChunkKind::kStop);) {
    if (is(c, ChunkKind::kPurpose)) return is_finite(document_.tokens[chunk(c).first].text);
  }
  return false;
}

// "a recliner for my partner facing the TV", "a box for toys at the foot of the bed": for whom or what it is, and where it is.
bool UnitReader::follows_whom(std::size_t k) const {
  const std::size_t p = previous(k), n = next(k), host = last_noun();
  // "an armchair for me beside the bookcase"
  const bool for_us = is(p, ChunkKind::kPurpose) && document_.tokens[chunk(p).first].text == "for" && chunk(k).first > chunk(p).last &&
                      one_of(document_.tokens[chunk(k).first - 1].text, {"me", "us", "myself", "ourselves"});
  // "a sideboard for coffee opposite the screen": which is a color as well
  const bool for_coffee = chunk(k).first > 1 && document_.tokens[chunk(k).first - 2].text == "for" &&
                          lexicon_.is(document_.tokens[chunk(k).first - 1], WordClass::kColor);
  // "chairs for the visitors along the wall": who might do something there
  const bool for_doer = is(p, ChunkKind::kPurpose) && chunk(p).last == chunk(p).first + 1 &&
                        lexicon_.is(document_.tokens[chunk(p).first], WordClass::kDoer) && is(previous(p), ChunkKind::kPurpose) &&
                        document_.tokens[chunk(previous(p)).last - 1].text == "for";
  if ((for_us || for_coffee || for_doer) && is(n, ChunkKind::kNoun)) return is_part_of_room(chunk(n).noun) || names_thing(n);
  if (!is(p, ChunkKind::kNoun) || !is(previous(p), ChunkKind::kPurpose) || !is(n, ChunkKind::kNoun)) return false;
  const std::string& word = document_.tokens[chunk(previous(p)).last - 1].text;
  const NounPhrase &whom = chunk(p).noun, &by = chunk(n).noun;
  // "a lamp shaped like a mushroom on a table": where the lamp is
  if (word == "like" && host < document_.chunks.size() && names_thing(host) && names_thing(n)) return true;
  if (word != "for") return false;
  const bool part_of_room =
      by.kind == NounKind::kWall || by.kind == NounKind::kWindow || by.kind == NounKind::kDoor || by.kind == NounKind::kCorner;
  if (lexicon_.is_person(whom.head) || word_form(whom.head) == WordForm::kPerson) return part_of_room || by.kind == NounKind::kObject;
  // "a rack for 12 coats by the door"
  if (host >= document_.chunks.size() || chunk(host).noun.kind != NounKind::kObject || whom.determiner == Determiner::kIndefinite ||
      (whom.count > 0 && !part_of_room))
    return false;
  const NounPhrase& known = by.kind == NounKind::kPart && by.of ? *by.of : by;
  const bool definite = known.determiner == Determiner::kDefinite || known.determiner == Determiner::kPossessive;
  const bool new_here = known.determiner == Determiner::kIndefinite && known.exact;       // "a shelf for glazes above a bench"
  if (by.kind == NounKind::kPronoun && by.head == "it" && whom.is_plural()) return true;  // "a bookshelf, a basket for toys next to it"
  return part_of_room || (known.kind == NounKind::kObject && (definite || new_here));
}

// "a sink for washing hair in the back, …": a part of the room that ends what a thing is for is where the thing stands.
bool UnitReader::closes_purpose(std::size_t k) const {
  const bool named =
      is(next(k), ChunkKind::kNoun) && (chunk(next(k)).noun.kind == NounKind::kCenter || !chunk(next(k)).noun.wall_word.empty());
  const std::size_t n = named ? next(next(k)) : next(k);
  const bool ends = n >= document_.chunks.size() || is(n, ChunkKind::kComma) || is(n, ChunkKind::kStop) || is(n, ChunkKind::kAnd);
  const PhraseSenses* senses = chunk(k).phrase.senses;
  const bool part = senses != nullptr && std::ranges::any_of(*senses, [](const PhraseSense& s) {
                      const bool there = s.type == RelationType::kInRegion || s.type == RelationType::kCenterOfRoom ||
                                         traits_of(s.type).sideways ||
                                         s.type == RelationType::kOpposite;  // "two chairs for visitors opposite"
                      return s.direction == PhraseSense::Direction::kAlone && there;
                    });
  if (!ends || !(part || named)) return false;
  for (std::size_t c = previous(k); c < k && !is(c, ChunkKind::kComma) && !is(c, ChunkKind::kStop); c = previous(c)) {
    if (is(c, ChunkKind::kPurpose) && document_.tokens[chunk(c).first].text == "for") return is(previous(c), ChunkKind::kNoun);
    if (c == 0) break;
  }
  return false;
}

// "For the family a recliner by the window": after whom or what it is for, at the beginning of a clause.
bool UnitReader::follows_purpose(std::size_t k) const {
  const std::size_t whom = previous(k), purpose = is(whom, ChunkKind::kNoun) ? previous(whom) : whom, before = previous(purpose);
  if (!is(purpose, ChunkKind::kPurpose) || chunk(purpose).last == chunk(k).first || document_.tokens[chunk(purpose).first].text != "for")
    return false;
  const NounPhrase& noun = chunk(k).noun;
  const bool anew = noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || noun.count > 0;
  const bool opens = before >= document_.chunks.size() || is(before, ChunkKind::kStop) || is(before, ChunkKind::kComma) ||
                     is(before, ChunkKind::kAnd) || is(before, ChunkKind::kClause);
  return opens && anew && noun.kind == NounKind::kObject;
}

// The clause's first thing, or its last one, has neither article nor number.
bool UnitReader::is_bare_list() const {
  const auto is_thing = [&](const Unit& unit) { return unit.kind == UnitKind::kNoun && chunk(unit.chunk).noun.kind == NounKind::kObject; };
  const auto is_bare = [&](const Unit& unit) {
    return chunk(unit.chunk).noun.determiner == Determiner::kNone && chunk(unit.chunk).noun.count == 0;
  };
  const auto first = std::find_if(units_.begin(), units_.end(), is_thing);
  const auto last = std::find_if(units_.rbegin(), units_.rend(), is_thing);
  return first != units_.end() && (is_bare(*first) || (is_bare(*last) && !chunk(last->chunk).noun.plural));
}

// The purpose that chunk k is in has named something that stands on the floor.
bool UnitReader::names_furniture_before(std::size_t k) const {
  while (k-- > 0 && !is(k, ChunkKind::kPurpose) && !is(k, ChunkKind::kStop)) {
    if (is(k, ChunkKind::kNoun) && chunk(k).noun.exact && mount_of(chunk(k).noun) == Mount::kFloor) return true;
  }
  return false;
}

// … where what follows is no noun.
bool UnitReader::purpose_ends_before_verb(bool comma, std::size_t n) const {
  if (comma && is(n, ChunkKind::kRelative) && document_.tokens[chunk(n).first].text == "who") return false;  // "for my aunt, who has a dog"
  if (!comma && is(n, ChunkKind::kRelation) && chunk(n).last - chunk(n).first > 1) return true;  // "… and at the right one for the guitar"
  if (!comma && doing_ && is(n, ChunkKind::kVerb)) return false;                                 // "guests come in and hang up their coats"
  // "it serves as a stand and carries a lamp"
  if (!comma && !doing_ && (is(n, ChunkKind::kRelation) || is(n, ChunkKind::kHave)) && is_finite(document_.tokens[chunk(n).first].text))
    return true;
  if (!comma) return is(n, ChunkKind::kVerb) || is(n, ChunkKind::kThere) || is(n, ChunkKind::kCommand);
  return is(n, ChunkKind::kRelation) || is(n, ChunkKind::kHave) || is(n, ChunkKind::kParticiple) || is(n, ChunkKind::kRelative) ||
         is(n, ChunkKind::kThere) || is(n, ChunkKind::kVerb);
}

// "for the listener", right before chunk k.
bool UnitReader::is_for_somebody(std::size_t k) const {
  const std::size_t who = previous(k);
  if (!is(who, ChunkKind::kNoun) || chunk(who).first == 0) return false;
  const NounPhrase& noun = chunk(who).noun;
  const bool named = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive;
  const bool person = lexicon_.is_person(noun.head) || word_form(noun.head) == WordForm::kPerson || (named && !noun.exact);
  return document_.tokens[noun.first - 1].text == "for" && person;
}

// The break at chunk k, before chunk n, ends a purpose: what follows is said of the room again.
bool UnitReader::purpose_ends(std::size_t k, std::size_t n) const {
  const bool comma = is(k, ChunkKind::kComma);
  if (!is(n, ChunkKind::kNoun)) return purpose_ends_before_verb(comma, n);
  const NounPhrase& noun = chunk(n).noun;
  const bool verb_follows = is(next(n), ChunkKind::kVerb);
  const bool said = noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother ||
                    noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach || noun.count > 0;
  if ((said && noun.kind != NounKind::kAbstract) || verb_follows) return true;
  // "for keys and mirror over it"
  const bool thing = noun.kind == NounKind::kObject && noun.entry != nullptr && !noun.doubted;
  if (thing && (noun.exact || comma) && is(next(n), ChunkKind::kRelation)) return true;
  // "a lamp he can reach from bed, and my sewing table"
  if (!comma && thing && noun.exact && noun.determiner == Determiner::kPossessive && mount_of(noun) == Mount::kFloor && k > 0 &&
      is(k - 1, ChunkKind::kComma))
    return true;
  if (!comma) return false;
  // "a hall for a game, entrance south"
  if (is_opening(noun)) return true;
  // "a kitchen for my mum, red tiles"
  if ((noun.kind == NounKind::kWall || noun.kind == NounKind::kFloor) && !noun.attributes.empty()) return true;
  // "…, hooks for coats", "…, shelves with files": what has a purpose or things of its own
  const bool own =
      is(next(n), ChunkKind::kHave) || (is(next(n), ChunkKind::kPurpose) && document_.tokens[chunk(next(n)).first].text == "for");
  if (own && noun.kind == NounKind::kObject && noun.exact) return true;
  if (noun.determiner == Determiner::kDefinite || noun.kind == NounKind::kMember) return true;
  // In a list without articles the next bare thing goes on with it: "bed for guests, desk, lamp".
  if (is_bare_list() && thing) return true;
  // "an armchair for the listener, thick rug and lamps": whom it is for is all of the purpose
  if (thing && noun.exact && is_for_somebody(k)) return true;
  // "for 24 children, tables in groups of four": furniture, after a purpose that names none
  if (thing && noun.exact && mount_of(noun) == Mount::kFloor && !names_furniture_before(k)) return true;
  // "to be used as an office: sofa bed, desk, …"
  // "a shed for garden stuff - long bench, tool rack"
  const Token& sign = document_.tokens[chunk(k).first];
  const bool dash = sign.begin < document_.prompt.size() && document_.prompt[sign.begin] != ',' && document_.prompt[sign.begin] != '(';
  return (sign.text == ":" || (sign.text == "," && dash)) && (noun.kind == NounKind::kObject || noun.kind == NounKind::kAbstract);
}

}  // namespace layoutbox::offline
