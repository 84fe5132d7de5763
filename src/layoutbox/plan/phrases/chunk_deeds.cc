// What somebody does: "we teach the violin", "I'm writing a thriller". No thing of the room comes of it; where it is done, the units read.
#include <algorithm>
#include <array>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

// Who does something stands right before, alone: "we", "they also".
bool Chunker::follows_doer() const {
  if (telling_ >= chunks_.size()) return false;
  const Chunk& who = chunks_[telling_];
  return who.last == who.first + 1 && lexicon_.is(tokens_[who.first], WordClass::kDoer);
}

// "somebody", "my sister", "the owner", "the family": so many words say who does something, before the word at which that verb stands.
std::size_t Chunker::doer_length() const {
  if (lexicon_.is(tokens_[i_], WordClass::kDoer)) return 1;
  if (!lexicon_.is(tokens_[i_], WordClass::kDefinite) && !lexicon_.is(tokens_[i_], WordClass::kPossessive)) return 0;
  if (i_ + 1 < tokens_.size() && one_of(tokens_[i_ + 1].text, WordSet::kHouseholds)) return 2;
  constexpr std::size_t kMostWords = 4;
  const auto who = read_noun_phrase(lexicon_, tokens_, i_, false);
  if (!who || who->entry != nullptr || who->of || who->owner || who->last > i_ + kMostWords) return 0;
  const bool people = lexicon_.is_person(who->head) || noun_form(who->head) == WordForm::kPerson;
  return people ? who->last - i_ : 0;
}

// A clause that begins with its place ends here: "above the sofa", "…, and on it".
bool Chunker::follows_first_place() const {
  std::size_t first = chunks_.size();
  constexpr std::size_t kMostChunks = 12;
  while (first > 0 && first + kMostChunks > chunks_.size() &&
         (chunks_[first - 1].kind == ChunkKind::kNoun || chunks_[first - 1].kind == ChunkKind::kRelation ||
          chunks_[first - 1].kind == ChunkKind::kIgnored))
    --first;
  const ChunkKind before = first == 0 ? ChunkKind::kStop : chunks_[first - 1].kind;
  const bool joined = before == ChunkKind::kAnd || before == ChunkKind::kComma;  // ", and behind the chair he keeps a basket"
  const bool opens = before == ChunkKind::kStop || before == ChunkKind::kClause || joined;
  const bool placed = previous() == ChunkKind::kNoun || previous() == ChunkKind::kRelation;  // "on it I keep two monitors"
  return opens && first < chunks_.size() && chunks_[first].kind == ChunkKind::kRelation && placed;
}

// "on the desk I wish one lamp", "here we require two vases": what is wanted is there, as after "I want".
bool Chunker::read_wishing() {
  const std::size_t who = i_ + 2 < tokens_.size() ? doer_length() : 0;
  if (who == 0 || i_ + who + 1 >= tokens_.size()) return false;
  const bool named = who > 1 || !lexicon_.is(tokens_[i_], WordClass::kDoer);
  if (named && !follows_first_place()) return false;  // "above the sofa my sister has hung a map"
  std::size_t verb = i_ + who;
  bool helped = false;
  for (; verb + 1 < tokens_.size() && is_helping(verb); ++verb) helped |= !says_how_much(verb);
  if (helped) return read_helped_wish(verb);
  if (named) return false;
  // "the sink I want near the door"
  const bool told = previous() == ChunkKind::kNoun && chunks_.back().noun.kind == NounKind::kObject && !opens_noun(tokens_[verb + 1]);
  if (told && (tokens_[verb].text == "want" || tokens_[verb].text == "need" || tokens_[verb].text == "like") &&
      lexicon_.find_phrase(tokens_, verb + 1).length > 0) {
    add(ChunkKind::kIgnored, verb + 1 - i_);
    return true;
  }
  const std::size_t thing = verb + (is_for_whom(verb + 1) ? 2 : 1);
  if (!thing_next(thing) || (!lexicon_.is_in("wishing", tokens_[verb].text) && !owns_furniture(verb))) return false;
  add(ChunkKind::kThere, thing - i_);
  return true;
}

// "he got himself a recliner", "they bought me a desk"
bool Chunker::is_for_whom(std::size_t at) const {
  if (at + 1 >= tokens_.size()) return false;
  const std::string& word = tokens_[at].text;
  return word.ends_with("self") || word.ends_with("selves") || word == "me" || word == "us" || word == "him" || word == "her" ||
         word == "them";
}

// "he also owns a rocking chair": a piece of furniture somebody has is there; a cat, a boat and a shop are told of.
bool Chunker::owns_furniture(std::size_t verb) const {
  if (!one_of(tokens_[verb].text, WordSet::kOwning)) return false;
  const auto thing = read_noun_phrase(lexicon_, tokens_, verb + 1, false);
  return thing && thing->kind == NounKind::kObject && thing->exact && !thing->entry->is(Trait::kPet);
}

// "really", "probably", "rather": between what helps and the verb.
bool Chunker::says_how_much(std::size_t at) const {
  const std::string& word = tokens_[at].text;
  return word == "just" || word == "also" || lexicon_.is(tokens_[at], WordClass::kAdverb) || lexicon_.is(tokens_[at], WordClass::kSoft) ||
         (word.ends_with("ly") && word_form(word) == WordForm::kAdverb);
}

// "would", "have", "also", "really": before what somebody wants or has put somewhere.
bool Chunker::is_helping(std::size_t at) const {
  static constexpr std::array<std::string_view, 12> kHelping = {"would", "will", "have",   "has",   "had", "do",
                                                                "just",  "also", "really", "still", "now", "then"};
  return std::ranges::find(kHelping, tokens_[at].text) != kHelping.end() || says_how_much(at);
}

// "set up a table", "laid out three maps", "put away a box"
bool Chunker::is_particle_verb(std::size_t verb) const {
  static constexpr std::array<std::string_view, 5> kParticles = {"up", "out", "down", "aside", "away"};
  return verb + 2 < tokens_.size() && tokens_[verb].kind == Token::Kind::kWord &&
         std::ranges::find(kParticles, tokens_[verb + 1].text) != kParticles.end() && thing_next(verb + 2) &&
         (may_be_verb(tokens_[verb].text) || tokens_[verb].text.ends_with("ed") || one_of(tokens_[verb].text, WordSet::kFinding));
}

// "I would just like my recliner …", "someone had left a bucket", "I'd also like to put the till …", after "would", "had".
bool Chunker::read_helped_wish(std::size_t verb) {
  bool wanted = false, put = false;
  for (; verb + 1 < tokens_.size(); verb += 2) {
    put = put || is_particle_verb(verb);
    wanted |= one_of(tokens_[verb].text, WordSet::kLiking);
    put |= brings_in(verb) || lexicon_.is(tokens_[verb], WordClass::kParticiple) || lexicon_.is(tokens_[verb], WordClass::kPlaceVerb) ||
           lexicon_.is(tokens_[verb], WordClass::kHang);
    if (tokens_[verb + 1].text != "to") break;
  }
  const std::size_t thing = verb + (is_particle_verb(verb) ? 2 : 1);
  if ((!wanted && !put) || thing >= tokens_.size()) return false;
  const bool known = lexicon_.is(tokens_[thing], WordClass::kDefinite) || lexicon_.is(tokens_[thing], WordClass::kPossessive);
  if (!thing_next(thing) && !(wanted && known)) return false;
  add(ChunkKind::kThere, thing - i_);
  return true;
}

// "opposite the door you meet a desk", "by the window he keeps a telescope", "above it my sister hung a map": somebody finds or puts a
// thing where the clause begins.
bool Chunker::read_finding() {
  const std::size_t who = i_ + 2 < tokens_.size() && !chunks_.empty() ? doer_length() : 0, verb = i_ + who;
  if (who == 0) return false;
  const std::size_t object = verb + (is_particle_verb(verb) ? 2 : 1);
  if (object >= tokens_.size() || tokens_[verb].kind != Token::Kind::kWord) return false;
  const auto own = lexicon_.is(tokens_[object], WordClass::kPossessive) ? read_noun_phrase(lexicon_, tokens_, object, false) : std::nullopt;
  const bool thing = thing_next(object) || (own && own->kind == NounKind::kObject && own->exact);  // "I keep my guitar"
  const std::string& does = tokens_[verb].text;
  if (!thing || !(may_be_verb(does) || does.ends_with("ed") || one_of(does, WordSet::kFinding)) || !follows_first_place()) return false;
  add(ChunkKind::kThere, object - i_);
  return true;
}

// "I'm writing a thriller", "nobody will weigh the dog". "I'm building a cabin" is about the cabin, "we are placing a sofa" about the sofa.
bool Chunker::read_doing() {
  if (!follows_doer()) return false;
  if (is_deed(i_)) {
    add(ChunkKind::kPurpose, 1);
    return true;
  }
  if (i_ + 2 >= tokens_.size() || length_of(WordClass::kBe) != 1 || is_placing(i_ + 1)) return false;
  const std::string& doing = tokens_[i_ + 1].text;
  const bool is = tokens_[i_].text == "am" || tokens_[i_].text == "are" || tokens_[i_].text == "is";
  if (is ? !doing.ends_with("ing") : brings_in(i_ + 1) || !opens_noun(tokens_[i_ + 2])) return false;
  const bool making = is && one_of(doing, WordSet::kMaking);
  add(making ? ChunkKind::kCommand : ChunkKind::kPurpose, 2);
  return true;
}

// "sits open on the ottoman", "stands guard by the door", "goes lengthways down the wall": how, between a thing's verb and its place.
bool Chunker::read_manner() {
  if (telling_ >= chunks_.size() || telling_ + 1 != chunks_.size() || telling_ == 0) return false;
  const Chunk &verb = chunks_[telling_], &thing = chunks_[telling_ - 1];
  const bool placing = (verb.kind == ChunkKind::kVerb || verb.kind == ChunkKind::kParticiple) && verb.placing;
  if (!placing || thing.kind != ChunkKind::kNoun || thing.noun.kind != NounKind::kObject) return false;
  // "by the door stand umbrellas in a tub"
  if (telling_ > 1 && chunks_[telling_ - 2].kind == ChunkKind::kRelation) return false;
  constexpr std::size_t kMostWords = 3;
  std::size_t at = i_;
  while (at < tokens_.size() && at < i_ + kMostWords && may_tell_how(at)) ++at;
  if (at == i_ || lexicon_.find_phrase(tokens_, at).length == 0) return false;
  add(ChunkKind::kIgnored, at - i_);
  return true;
}

// A word that says nothing of what or where.
bool Chunker::may_tell_how(std::size_t at) const {
  if (tokens_[at].kind != Token::Kind::kWord || opens_noun(tokens_[at]) || lexicon_.find_phrase(tokens_, at).length > 0) return false;
  constexpr std::array kTelling = {WordClass::kAbstract, WordClass::kVerb,  WordClass::kAdverb,
                                   WordClass::kQuality,  WordClass::kStyle, WordClass::kSizeWord};
  const Match match = lexicon_.find(tokens_, at);
  return std::ranges::all_of(match.meanings, [&](const Meaning& m) { return std::ranges::find(kTelling, m.word_class) != kTelling.end(); });
}

// A verb that says where something is or that it is there.
bool Chunker::is_placing(std::size_t at) const {
  constexpr std::array kPlacing = {WordClass::kParticiple, WordClass::kHang, WordClass::kHave,
                                   WordClass::kPlaceVerb,  WordClass::kBe,   WordClass::kAdverb};
  return std::any_of(kPlacing.begin(), kPlacing.end(), [&](WordClass placing) { return lexicon_.is(tokens_[at], placing); });
}

// What is wanted, kept or put somewhere.
bool Chunker::brings_in(std::size_t at) const {
  return lexicon_.is(tokens_[at], WordClass::kCommand) || lexicon_.is_in("wishing", tokens_[at].text);
}

// The word right after who does it is the verb, whatever it is elsewhere ("we host", "I record"). In the past tense, and of a new thing
// that stands on the floor, it may as well say what is there: "we bought a sofa", "I fancy a big bed".
bool Chunker::is_deed(std::size_t at) const {
  const std::string& who = tokens_[chunks_[telling_].first].text;
  const Token& verb = tokens_[at];
  if (verb.kind != Token::Kind::kWord || at + 1 >= tokens_.size() || opens_noun(verb) || brings_in(at) || is_placing(at) ||
      lexicon_.find(tokens_, at, WordClass::kThere).length > 0 || lexicon_.find_phrase(tokens_, at).length > 0 || !is_english(verb.text))
    return false;
  if (lexicon_.find(tokens_, at, WordClass::kWithout).length > 0) return false;          // "plants I do not want"
  if (who != "i" && who != "we" && lexicon_.find(tokens_, at).length > 0) return false;  // "they face", "you find"
  const bool third = who == "he" || who == "she";
  if (verb.text.ends_with("ed") || verb.text.ends_with("ing") || (third && !verb.text.ends_with("s"))) return false;
  const WordForm form = word_form(verb.text);
  if (form == WordForm::kAdverb || form == WordForm::kAdjective) return false;
  const auto object = read_noun_phrase(lexicon_, tokens_, at + 1, false);
  const bool anew = object && object->kind == NounKind::kObject && object->exact && object->entry->mount != Mount::kSurface &&
                    (object->determiner == Determiner::kIndefinite || object->determiner == Determiner::kAnother || object->count > 0);
  return !anew;
}

}  // namespace layoutbox::offline
