// Noun phrases whose company says what they are: things among things, things spoken of again, shares and numbers of what was named.
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

// "a palette and a jar are on the trolley": a list that is all of one place, on a thing that is known.
bool UnitReader::lists_on_thing(std::size_t k) const {
  std::size_t n = next(k);
  while (is(n, ChunkKind::kAnd) || is(n, ChunkKind::kComma) || (is(n, ChunkKind::kNoun) && is_new_here(chunk(n).noun))) n = next(n);
  if (is(n, ChunkKind::kVerb) || is(n, ChunkKind::kParticiple)) n = next(n);
  const std::size_t host = next(n);
  if (!is(n, ChunkKind::kRelation) || !is(host, ChunkKind::kNoun)) return false;
  const NounPhrase& by = chunk(host).noun;
  const PhraseSenses& senses = *chunk(n).phrase.senses;
  return says(senses, &RelationTraits::rests) && by.kind == NounKind::kObject && by.exact && by.determiner == Determiner::kDefinite;
}

// Beside what is new in the room as well, in a list.
bool UnitReader::stands_among_things(std::size_t k) const {
  const auto is_new_thing = [&](std::size_t c) {
    if (!is(c, ChunkKind::kNoun) || chunk(c).noun.kind != NounKind::kObject) return false;
    return chunk(c).noun.determiner == Determiner::kIndefinite || chunk(c).noun.count > 0;
  };
  const auto past_break = [&](std::size_t c, bool forward) {
    std::size_t passed = 0;
    for (; is(c, ChunkKind::kComma) || is(c, ChunkKind::kAnd); ++passed) c = forward ? next(c) : previous(c);
    return passed > 0 ? c : document_.chunks.size();
  };
  return is_new_thing(past_break(previous(k), false)) || is_new_thing(past_break(next(k), true));
}

// "a cart with two lenses, a flash and a laptop", "a script on the sofa": what English alone says is no thing is one among things, or
// where the text says where it is.
bool UnitReader::is_thing_in_company(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const bool anew =
      noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || (noun.count > 0 && !noun.vague);
  // "a stacking tower", "a toy castle": outside elsewhere
  const bool compound = noun.last > noun.first + 2 && noun_form(noun.head) == WordForm::kThing && noun.attributes.empty() &&
                        noun.name.find(' ') != noun.name.rfind(' ');
  // "a palette and a jar are on the trolley": what is a thing as well, among things
  const bool thing_too = noun.last == noun.first + 2 && word_form(noun.head) == WordForm::kThing &&
                         (lists_on_thing(k) || is_told_where(k) || is_content_of_thing());
  if (noun.kind != NounKind::kAbstract || !(noun.doubted || compound || thing_too) || !anew || noun.of ||
      noun.name.find(" of ") != std::string::npos)
    return false;
  if (word_form(noun.head) == WordForm::kPerson || lexicon_.is_person(noun.head)) return false;
  return stands_among_things(k) || is_told_where(k);
}

// "a script on the sofa", "on the table lies a telegram", "on the desk a ticket lies"
bool UnitReader::is_told_where(std::size_t k) const {
  const auto is_at = [&](std::size_t place, std::size_t by) {
    if (!is(place, ChunkKind::kRelation) || !is(by, ChunkKind::kNoun)) return false;
    const NounPhrase& host = chunk(by).noun;
    return is_part_of_room(host) || (host.kind == NounKind::kObject && host.exact && host.determiner == Determiner::kDefinite);
  };
  std::size_t place = next(k);
  if (is(place, ChunkKind::kVerb) || is(place, ChunkKind::kParticiple)) place = next(place);
  if (is_at(place, next(place))) return true;
  const bool fronted = !is(previous(k), ChunkKind::kVerb);
  const std::size_t by = fronted ? previous(k) : previous(previous(k)), where = previous(by);
  return is_at(where, by) && (!fronted || where == 0 || is(where - 1, ChunkKind::kStop));
}

// "four display cases … in front of every case": a word that is a thing only in a rarer sense speaks of one whose name ends so.
bool UnitReader::names_known(std::size_t k) const {
  constexpr std::size_t kBack = 120;
  const NounPhrase& noun = chunk(k).noun;
  const bool of_known =
      noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kEach || noun.determiner == Determiner::kBoth;
  // "two pottery wheels … each wheel", "a pottery wheel … beside the wheel"
  const bool part =
      noun.kind == NounKind::kPart && (noun.determiner == Determiner::kEach || noun.determiner == Determiner::kDefinite) && !noun.of;
  // "a dish rack and a mug next to the rack": a thing on a counter, and no part
  const bool short_name = noun.kind == NounKind::kPart && noun.determiner == Determiner::kDefinite && !noun.of && noun.as_object != nullptr;
  if (!(noun.kind == NounKind::kAbstract && noun.doubted && of_known) && !part && !short_name) return false;
  for (std::size_t c = k; c-- > 0 && c + kBack > k;) {
    if (!is(c, ChunkKind::kNoun) || chunk(c).noun.kind != NounKind::kObject) continue;
    if (short_name && mount_of(chunk(c).noun) != Mount::kSurface) continue;
    const std::string& name = chunk(c).noun.name;
    constexpr std::size_t kShortest = 5;  // "the board" of a whiteboard
    if (name.ends_with(" " + noun.head) || (noun.head.size() >= kShortest && name.ends_with(noun.head))) return true;
  }
  return false;
}

// "with five of the cups in it": cups that nobody spoke of before.
bool UnitReader::takes_new_share(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  return noun.kind == NounKind::kMember && noun.subset && noun.count > 0 && noun.of && noun.of->kind == NounKind::kObject &&
         noun.of->exact && !is_named_before(k, noun.of->head);
}

// "a monitor on a cart, cart in the corner", "pc on cart, cart by the door", "2 bins, 1 table. Table stands along a wall.": a single thing
// that was named once and has no place of its own yet, or was just called "the", spoken of again without an article to say where it is.
bool UnitReader::speaks_again(std::size_t k) const {
  const NounPhrase& noun = chunk(k).noun;
  const bool bare =
      noun.kind == NounKind::kObject && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && noun.attributes.empty();
  if (!bare || (!units_.empty() && joiner_ == Joiner::kNone)) return false;
  const auto tells = [&](std::size_t c) {
    if (is(c, ChunkKind::kWithout)) return is(next(c), ChunkKind::kRelation);  // "cot not by the heater"
    return is(c, ChunkKind::kRelation) || is(c, ChunkKind::kParticiple) || is(c, ChunkKind::kVerb) || is(c, ChunkKind::kUnknown) ||
           is(c, ChunkKind::kPurpose);
  };
  if (!tells(next(k))) return false;
  std::size_t found = 0, one = 0;
  for (std::size_t c = k > kFarthestBack ? k - kFarthestBack : 0; c < k; ++c) {
    if (!is(c, ChunkKind::kNoun) || chunk(c).noun.kind != NounKind::kObject || chunk(c).noun.name != noun.name) continue;
    one = c;
    ++found;
  }
  if (found != 1 || chunk(one).noun.is_plural()) return false;
  // "the kettle and the toaster stand on the counter, kettle left of the toaster"
  const Determiner called = chunk(one).noun.determiner;
  const bool called_the = called == Determiner::kDefinite || called == Determiner::kPossessive;
  bool same_sentence = called_the;
  for (std::size_t c = one; same_sentence && c < k; ++c) same_sentence = !is(c, ChunkKind::kStop);
  if (same_sentence) return true;
  const bool reference = is(previous(one), ChunkKind::kRelation);
  if (units_.empty()) return reference || !tells(next(one));
  const bool just_named = units_.back().chunk == one && chunk(one).noun.determiner != Determiner::kNone;
  return just_named || (reference && one >= units_.front().chunk);
}

// "(two per side, so four)", "three each, making six in all": the number that was not said with the things.
bool UnitReader::sums_up(std::size_t k) const {
  if (!is(k, ChunkKind::kNoun) || chunk(k).first == 0) return false;
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t n = next(k);
  const bool ends = n >= document_.chunks.size() || is(n, ChunkKind::kStop) || is(n, ChunkKind::kComma);
  return noun.kind == NounKind::kMember && noun.count > 1 && noun.attributes.empty() && !noun.of && ends &&
         one_of(document_.tokens[chunk(k).first - 1].text, {"so", "making", "makes", "totaling", "giving"});
}

// "chairs around the table, eight of them", "lamps (three)": how many of what was named before.
bool UnitReader::counts_before(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const bool alone = noun.kind == NounKind::kMember && noun.attributes.empty() && noun.ordinal == 0 && !noun.of;
  const std::size_t n = next(k);
  const bool listed = joiner_ == Joiner::kComma && (is(n, ChunkKind::kStop) || is(n, ChunkKind::kComma));
  if (!alone || noun.count < 2 || !(listed || sums_up(k))) return false;
  for (std::size_t u = units_.size(); u-- > 0;) {
    if (units_[u].kind != UnitKind::kNoun) continue;
    NounPhrase& named = document_.chunks[units_[u].chunk].noun;
    if (named.kind != NounKind::kObject || !named.plural || named.count > 0) continue;
    named.count = noun.count;
    mark(k, WordReading::Use::kUsed, "how many");
    return true;
  }
  return false;
}

}  // namespace layoutbox::offline
