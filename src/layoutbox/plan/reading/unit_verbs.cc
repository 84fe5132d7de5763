// What a verb that no list has says of two things: "a vase enlivens the sideboard", "a screen shields the bath".
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

// On, above, under or beside, as the two allow (senses).
const PhraseSenses& senses_of_any_verb() {
  return direct_senses<RelationType::kOn, RelationType::kAbove, RelationType::kUnder, RelationType::kNextTo, RelationType::kAgainstWall,
                       RelationType::kOnWall, RelationType::kCorner>();
}

// "guard", "borders": what "guarding", "bordering" say, where that is listed; null where it is not.
const PhraseSenses* senses_of_doing(const Lexicon& lexicon, const std::string& verb) {
  for (std::string stem : singular_forms(verb)) {
    if (const PhraseSenses* senses = lexicon.senses_of(stem + "ing")) return senses;
    if (stem.ends_with('e')) stem.pop_back();
    if (const PhraseSenses* senses = lexicon.senses_of(stem + "ing")) return senses;
  }
  return nullptr;
}

}  // namespace

// The chunk is a verb that no list has, and says no purpose.
bool UnitReader::is_unlisted_verb(std::size_t k) const {
  if (!is_unread_verb(k)) return false;
  const Token& verb = document_.tokens[chunk(k).first];
  return !lexicon_.is(verb, WordClass::kPurpose) && !lexicon_.is(verb, WordClass::kDoer) && !lexicon_.is(verb, WordClass::kCommand) &&
         (word_form(verb.text) == WordForm::kVerb || may_be_verb(verb.text) || senses_of_doing(lexicon_, verb.text) != nullptr);
}

// The thing that a verb at that chunk is said of: the noun before it, or before "which"; null where it is none.
const NounPhrase* UnitReader::subject_of_verb(std::size_t verb) const {
  if (units_.empty() || units_.back().chunk != previous(verb)) return nullptr;
  std::size_t u = units_.size() - 1;
  if (units_[u].kind == UnitKind::kRelative) {
    if (document_.tokens[chunk(units_[u].chunk).first].text == "who" || u == 0) return nullptr;
    --u;
  }
  if (units_[u].kind != UnitKind::kNoun) return nullptr;
  const NounPhrase& subject = chunk(units_[u].chunk).noun;
  const bool thing = subject.kind == NounKind::kObject && subject.entry != nullptr && !subject.entry->is(Trait::kPet);
  return thing && word_form(subject.head) != WordForm::kPerson ? &subject : nullptr;
}

// "the armchair I bought goes by the window", "the chest we found in Lyon stands in the corner": the second verb is the thing's.
bool UnitReader::ends_contact_clause(std::size_t k) const {
  if (units_.empty() || joiner_ != Joiner::kNone || chunk(k).passive) return false;
  const std::size_t thing = last_noun();
  if (thing >= k || chunk(thing).noun.kind != NounKind::kObject) return false;
  const bool placed = is(k, ChunkKind::kVerb) && is(next(k), ChunkKind::kRelation);  // not "sits on", which is one chunk
  if (!placed && !is_finite(document_.tokens[chunk(k).first].text)) return false;
  std::size_t doer = next(thing);
  if (is(doer, ChunkKind::kRelative)) doer = next(doer);
  if (doer >= k || !is_person(doer)) return false;
  bool done = false;  // it has a verb of its own
  for (std::size_t c = next(doer); c < k; c = next(c)) {
    if (is(c, ChunkKind::kComma) || is(c, ChunkKind::kAnd)) return false;
    done = done || is(c, ChunkKind::kPurpose) || is(c, ChunkKind::kUnknown) || is(c, ChunkKind::kVerb) || is(c, ChunkKind::kHave);
  }
  return done;
}

// A thing, a verb that no list has, and the noun at k: where the first is by the second, or that it has it.
void UnitReader::place_by_verb(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t verb = previous(k);
  if (verb >= k || joiner_ != Joiner::kNone || !is_unlisted_verb(verb)) return;
  const NounPhrase* subject = subject_of_verb(verb);
  if (subject == nullptr) return;
  const bool part = noun.kind == NounKind::kPart && noun.of && noun.of->kind == NounKind::kObject;
  const bool said = noun.determiner != Determiner::kNone || noun.count > 0 || noun.plural;
  const bool thing = noun.kind == NounKind::kObject && noun.entry != nullptr && said;
  if (!part && !thing) return;
  const bool anew = thing && noun.determiner != Determiner::kDefinite && noun.determiner != Determiner::kPossessive;
  const Catalog& catalog = lexicon_.catalog();
  // What such a verb says of two known things is seldom where they are ("it complements the sofa"), but "a fleece softens the bench".
  const bool lies = thing &&
                    (mount_of(*subject) == Mount::kSurface || is_textile(catalog, *subject) ||
                     (subject->entry->thin && mount_of(*subject) == Mount::kFloor)) &&
                    may_carry(catalog, noun, *subject);
  const PhraseSenses* known = senses_of_doing(lexicon_, document_.tokens[chunk(verb).first].text);
  if (!anew && !lies && known == nullptr && lexicon_.is(document_.tokens[chunk(verb).first], WordClass::kVerb)) return;
  skipping_ = doing_ = false;
  const bool has = anew && mount_of(noun) == Mount::kSurface && may_carry(catalog, *subject, noun) && !may_carry(catalog, noun, *subject);
  mark(verb, WordReading::Use::kUsed, has ? "has" : "placing");
  if (has) {
    add(UnitKind::kHave, verb);
    return;
  }
  const PhraseSenses& senses = known != nullptr ? *known : senses_of_any_verb();
  document_.chunks[verb].kind = ChunkKind::kRelation;
  document_.chunks[verb].phrase.senses = &senses;
  add_place(verb, senses);
  units_.back().soft = known == nullptr;
}

// "stands guard beside the door", "keeps watch over it": a noun that only goes with its verb.
bool UnitReader::passes_light_noun(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  if (units_.empty() || units_.back().kind != UnitKind::kVerb || units_.back().chunk != previous(k) || joiner_ != Joiner::kNone)
    return false;
  const bool bare = noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && noun.last - noun.first == 1;
  const bool none = noun.kind == NounKind::kAbstract || (noun.kind == NounKind::kObject && !noun.exact);
  const bool after_thing = units_.size() > 1 && units_[units_.size() - 2].kind == UnitKind::kNoun;
  if (!bare || !none || !after_thing || !is(next(k), ChunkKind::kRelation)) return false;
  mark(k, WordReading::Use::kIgnored, "goes with the verb");
  return true;
}

// "a typewriter in the middle of the desktop": of the desk, where one was named and no computer.
void UnitReader::mean_desktop(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  if (noun.name != "desktop" || noun.kind != NounKind::kObject || noun.determiner != Determiner::kDefinite) return;
  const std::size_t verb = next(k);
  const bool has = is(verb, ChunkKind::kHave) || (is(verb, ChunkKind::kRelation) && document_.tokens[chunk(verb).first].text == "supports");
  if (!after_place() && !has) return;
  bool desk = false;
  for (std::size_t c = k > kFarthestBack ? k - kFarthestBack : 0; c < k; ++c) {
    if (!is(c, ChunkKind::kNoun) || chunk(c).noun.kind != NounKind::kObject) continue;
    if (chunk(c).noun.entry == noun.entry && chunk(c).noun.entry != nullptr) return;
    desk |= one_of(chunk(c).noun.head, {"desk", "workstation"});
  }
  if (!desk) return;
  noun.kind = NounKind::kPart;
  noun.entry = nullptr;
  noun.category.clear();
}

// "on the bed itself": the bed; "the altar, a block of limestone, is": the altar.
bool UnitReader::stresses(std::size_t k) {
  if (passes_apposition(k)) return true;
  const NounPhrase& noun = chunk(k).noun;
  const bool self = noun.kind == NounKind::kPronoun && one_of(noun.head, {"itself", "themselves"});
  if (!self || joiner_ != Joiner::kNone || !is(previous(k), ChunkKind::kNoun)) return false;
  mark(k, WordReading::Use::kIgnored, "filler");
  return true;
}

// "a bench in front of its keyboard", "a lamp above its needle": a small part of what was named, which no other words bring in: at the
// thing.
void UnitReader::mean_own_part(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  if (noun.kind != NounKind::kObject || noun.determiner != Determiner::kPossessive || noun.of || noun.is_plural() ||
      !noun.attributes.empty() || !after_place())
    return;
  if (!one_of(document_.tokens[noun.first].text, {"its", "their"}) || is_named_before(k, noun.head)) return;
  if (mount_of(noun) != Mount::kSurface) return;
  const PhraseSenses& direct = units_.back().direct;
  const bool before_it = says(direct, RelationType::kInFrontOf) || says(direct, RelationType::kAbove) ||
                         says(direct, RelationType::kBehind) || says(direct, RelationType::kNextTo) || says(direct, RelationType::kFacing);
  if (!before_it || says(direct, &RelationTraits::rests)) return;
  NounPhrase whole;
  whole.kind = NounKind::kPronoun;
  whole.head = "it";
  whole.first = noun.first;
  whole.last = noun.last;
  noun = whole;
}

// "on the sofa's left side", "at the desk's right": left of the owner, as "to the left of" it.
void UnitReader::mean_hand_of_owner(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  const std::size_t place = units_.empty() ? 0 : units_.back().chunk;
  if (!noun.owner || !after_place() || chunk(place).last - chunk(place).first != 1) return;
  if (!one_of(document_.tokens[chunk(place).first].text, {"on", "at", "to", "upon", "by"})) return;
  std::size_t at = chunk(k).last;
  const auto says_next = [&](std::initializer_list<std::string_view> words) {
    return at < document_.tokens.size() && one_of(document_.tokens[at].text, words);
  };
  if (says_next({"immediate"})) ++at;
  const bool left = says_next({"left"});
  if (!left && !says_next({"right"})) return;
  ++at;
  if (says_next({"hand"})) ++at;
  const bool part = says_next({"end", "edge", "half"});  // on it, where it carries that
  if (part && is(k + 1, ChunkKind::kNoun) && chunk(k + 1).noun.kind == NounKind::kPart) return;
  if (part || says_next({"side", "flank"})) ++at;
  // Not "the desk's left drawer", which is a part.
  std::size_t after = k + 1;
  while (after < document_.chunks.size() && chunk(after).first < at && chunk(after).last <= at) ++after;
  if (after < document_.chunks.size() &&
      (chunk(after).first < at ||
       (is(after, ChunkKind::kNoun) && chunk(after).noun.determiner == Determiner::kNone && chunk(after).noun.count == 0)))
    return;
  const PhraseSenses* senses = part ? &senses_of_any_verb() : lexicon_.senses_of(left ? "to left of" : "to right of");
  if (senses == nullptr) return;
  noun.owner = false;
  units_.back().direct = *senses;
  units_.back().senses = senses;
  units_.back().inverse.clear();
  units_.back().alone.clear();
  for (std::size_t c = k + 1; c < after; ++c) mark(c, WordReading::Use::kUsed, "relation");
  passed_until_ = after;
}

// "in the shadow of the wardrobe", "at the flank of the sofa", "a mug at its elbow": by the thing, or on it, as the preposition has it.
void UnitReader::mean_owner_of_spot(std::size_t k) {
  NounPhrase& noun = document_.chunks[k].noun;
  if (!after_place() || chunk(units_.back().chunk).last - chunk(units_.back().chunk).first != 1) return;
  const std::string& preposition = document_.tokens[chunk(units_.back().chunk).first].text;
  if (!one_of(preposition, {"in", "at", "by", "on", "to", "upon", "along", "beside", "near"})) return;
  const bool body = one_of(noun.head, WordSet::kBodyParts) && (noun.kind == NounKind::kAbstract || noun.kind == NounKind::kObject);
  const bool own_side = one_of(noun.head, {"side", "end"}) && !noun.plural && noun.kind == NounKind::kAbstract;  // "along its far side"
  // "a table, a bench along the near side"
  const bool at_table =
      own_side && preposition == "along" && noun.determiner == Determiner::kDefinite && std::ranges::any_of(units_, [&](const Unit& unit) {
        return unit.kind == UnitKind::kNoun && is_table(lexicon_.catalog(), chunk(unit.chunk).noun);
      });
  const bool its = (at_table || ((body || own_side) && noun.determiner == Determiner::kPossessive)) && !noun.of;
  const bool named = noun.of && (noun.kind == NounKind::kAbstract || body) && !noun.niche && noun.of->kind == NounKind::kObject &&
                     noun.of->exact && (noun.of->determiner == Determiner::kDefinite || noun.of->determiner == Determiner::kPossessive);
  if ((!its && !named) || is_zone(noun.head)) return;
  NounPhrase whole;
  if (named) {
    whole = *noun.of;
    whole.owner = false;
  } else {
    whole.kind = NounKind::kPronoun;
    whole.head = "it";
  }
  whole.first = noun.first;
  whole.last = noun.last;
  const bool side = one_of(noun.head, {"side", "end", "edge"});  // on a desk's far side a lamp is on it, a chair by it
  const bool upon = preposition == "on" || preposition == "upon";
  const PhraseSenses& senses = side   ? senses_of_any_verb()
                               : upon ? direct_senses<RelationType::kOn>()
                                      : direct_senses<RelationType::kNextTo>();
  units_.back().direct = senses;
  units_.back().senses = &senses;
  units_.back().inverse.clear();
  units_.back().alone.clear();
  noun = whole;
}

}  // namespace layoutbox::offline
