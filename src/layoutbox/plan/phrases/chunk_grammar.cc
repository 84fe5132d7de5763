// Places by the way they are built, whatever their verb is: looking and turning towards something, "from beneath", steps away.
#include <algorithm>
#include <array>

#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// What an inflected verb may be a form of, itself first: "gazing", "angled", "trained".
std::vector<std::string> verb_bases(const std::string& word) {
  std::vector<std::string> bases{word};
  for (const std::string_view ending : {"ing", "ed", "es", "s"}) {
    if (!word.ends_with(ending) || word.size() < ending.size() + 2) continue;
    const std::string stem = word.substr(0, word.size() - ending.size());
    bases.push_back(stem);
    if (ending == "s") continue;
    bases.push_back(stem + "e");
    if (stem[stem.size() - 1] == stem[stem.size() - 2]) bases.push_back(stem.substr(0, stem.size() - 1));
  }
  return bases;
}

}  // namespace

bool Chunker::is_verb_of(std::string_view list, std::size_t at) const {
  if (at >= tokens_.size() || tokens_[at].kind != Token::Kind::kWord) return false;
  return std::ranges::any_of(verb_bases(tokens_[at].text), [&](const std::string& base) { return lexicon_.is_in(list, base); });
}

// Past adverbs and particles: "slightly", "straight", "out", "down".
std::size_t Chunker::past_particles(std::size_t at) const {
  static constexpr std::array<std::string_view, 12> kParticles = {"out",    "down",    "up",      "back",     "straight", "over",
                                                                  "inward", "inwards", "outward", "outwards", "across",   "right"};
  const auto passes = [&](std::size_t i) {
    const Token& token = tokens_[i];
    if (token.text == "toward" || token.text == "towards") return false;
    if (lexicon_.is(token, WordClass::kAdverb) || is_among(kParticles, token.text)) return true;
    return word_form(token.text) == WordForm::kAdverb && lexicon_.find_phrase(tokens_, i).length == 0;
  };
  while (at < tokens_.size() && passes(at)) ++at;
  return at;
}

// "gazes out of", "staring down at", "watching", "angled slightly to", "trained on": the tokens of a verb that says what a thing faces and
// of its preposition; 0 for none.
std::size_t Chunker::length_of_looking() const {
  static constexpr std::array<std::string_view, 12> kLookingAt = {"at",   "to",   "toward", "towards", "on",      "onto",
                                                                  "upon", "over", "into",   "through", "outside", "of"};
  static constexpr std::array<std::string_view, 3> kTurnedTo = {"to", "toward", "towards"};
  if (lexicon_.find(tokens_, i_, WordClass::kObject).length > 1) return 0;  // "an eye chart", "a watch stand"
  const bool looks = is_verb_of("looking", i_), turns = is_verb_of("turning", i_), watches = is_verb_of("watching", i_);
  if (!looks && !turns && !watches) return 0;
  // "a watch on the table": a noun.
  const bool subject = previous() == ChunkKind::kNoun || previous() == ChunkKind::kVerb || previous() == ChunkKind::kRelative ||
                       previous() == ChunkKind::kComma || previous() == ChunkKind::kAnd;
  if (!subject) return 0;
  const auto ends_at = [&](std::size_t at) { return at < tokens_.size() && tokens_[at].kind == Token::Kind::kWord ? at - i_ : 0; };
  if (watches && i_ + 1 < tokens_.size()) {
    const std::size_t at = i_ + (tokens_[i_ + 1].text == "over" ? 2 : 1);
    return at < tokens_.size() && (opens_noun(tokens_[at]) || lexicon_.find(tokens_, at, WordClass::kObject).length > 0) ? ends_at(at) : 0;
  }
  std::size_t at = past_particles(i_ + 1);
  const bool over = at > i_ + 1 && (tokens_[at - 1].text == "over" || tokens_[at - 1].text == "across");  // "looks over the bay"
  if (at >= tokens_.size()) return 0;
  const std::string& word = tokens_[at].text;
  const bool aims = (word == "at" || word == "on" || word == "out") && is_verb_of("aiming", i_);
  if (looks || aims ? is_among(kLookingAt, word) : is_among(kTurnedTo, word)) {
    const bool through = word == "of" && tokens_[at - 1].text != "out";
    return through ? 0 : ends_at(at + 1);
  }
  return looks && over && opens_noun(tokens_[at]) ? ends_at(at) : 0;
}

// "has a clear view of", "with views over": the tokens up to the preposition; 0 for none.
std::size_t Chunker::length_of_view() const {
  static constexpr std::array<std::string_view, 6> kOver = {"of", "over", "to", "onto", "across", "through"};
  constexpr std::size_t kMost = 4;
  if (!one_of(tokens_[i_].text, WordSet::kHavingView) || previous() == ChunkKind::kStop) return 0;
  for (std::size_t at = i_ + 1; at + 2 < tokens_.size() && at <= i_ + kMost && tokens_[at].kind == Token::Kind::kWord; ++at) {
    if (one_of(tokens_[at].text, WordSet::kViews)) return is_among(kOver, tokens_[at + 1].text) ? at + 2 - i_ : 0;
    if (lexicon_.find(tokens_, at, WordClass::kObject).length > 0) return 0;
  }
  return 0;
}

// "peeks out from beneath the bed", "in behind the sofa", "over by the window": a particle before the preposition that counts.
std::size_t Chunker::length_of_particle() const {
  static constexpr std::array<std::string_view, 14> kParticles = {"from", "out",  "up",    "down", "in",     "over", "along",
                                                                  "back", "away", "close", "off",  "around", "low",  "just"};
  static constexpr std::array<std::string_view, 16> kPlaces = {"beneath", "under",   "underneath", "below", "behind", "beside",
                                                               "by",      "against", "alongside",  "above", "among",  "amid",
                                                               "between", "next",    "atop",       "beyond"};
  std::size_t at = i_;
  while (at < tokens_.size() && at < i_ + 3 && is_among(kParticles, tokens_[at].text)) ++at;
  return at > i_ && at < tokens_.size() && is_among(kPlaces, tokens_[at].text) ? at - i_ : 0;
}

// "faced the window", "flanked a bed", "held two pens", "ran along the wall": what the present says, where it stands in the lists.
bool Chunker::read_past() {
  const std::string& word = tokens_[i_].text;
  const ChunkKind before = previous();
  if ((before != ChunkKind::kNoun && before != ChunkKind::kRelative && before != ChunkKind::kAnd) || i_ + 1 >= tokens_.size()) return false;
  if (before == ChunkKind::kAnd && !opens_noun(tokens_[i_ + 1])) return false;
  std::vector<std::string> finite;
  if (const std::string_view present = lexicon_.present_of(word); !present.empty()) finite.emplace_back(present);
  if (word.ends_with("ed")) {
    for (const std::string& base : verb_bases(word)) finite.push_back(base + "s"), finite.push_back(base + "es");
  }
  const bool object = opens_noun(tokens_[i_ + 1]) && tokens_[i_ + 1].text != "at" && tokens_[i_ + 1].text != "over";
  for (const std::string& verb : finite) {
    Token as = tokens_[i_];
    as.text = verb;
    const PhraseSenses* senses = object ? lexicon_.senses_of(verb) : nullptr;
    if (senses != nullptr) {
      PhraseMatch phrase;
      phrase.length = 1;
      phrase.senses = senses;
      add_phrase(phrase);
      return true;
    }
    if (object && lexicon_.is(as, WordClass::kHave)) {
      add(ChunkKind::kHave, 1);
      return true;
    }
    if (!lexicon_.present_of(word).empty() && lexicon_.is(as, WordClass::kPlaceVerb) && lexicon_.find_phrase(tokens_, i_ + 1).length > 0) {
      add(ChunkKind::kVerb, 1).placing = true;
      return true;
    }
  }
  return false;
}

// "a rail from which two coats hang": they hang on it; "a bench from which to watch" is no place.
bool Chunker::hangs_from_which() const {
  constexpr std::size_t kFar = 20;
  if (tokens_[i_].text != "from" || i_ + 2 >= tokens_.size() || tokens_[i_ + 1].text != "which") return false;
  for (std::size_t i = i_ + 2; i < tokens_.size() && i < i_ + kFar && tokens_[i].kind == Token::Kind::kWord; ++i) {
    if (lexicon_.is(tokens_[i], WordClass::kHang)) return true;
  }
  return false;
}

bool Chunker::add_said_as(std::string_view words, std::size_t length) {
  const PhraseSenses* senses = lexicon_.senses_of(words);
  if (senses == nullptr) return false;
  add_phrase(PhraseMatch{length, senses});
  return true;
}

// A place that no list has as it stands.
bool Chunker::read_built_place() {
  if (tokens_[i_].kind != Token::Kind::kWord) return false;
  if (read_steps() || read_past()) return true;
  if (hangs_from_which()) return add_said_as("hanging from", 1);
  if (read_parted()) return true;
  if (parts_from()) return add_said_as("separating", 1);
  const std::size_t listed = lexicon_.find_phrase(tokens_, i_).length;
  if (const std::size_t looking = std::max(length_of_looking(), length_of_view()); looking > listed) return add_said_as("facing", looking);
  const std::size_t particle = length_of_particle();
  if (particle == 0) return false;
  PhraseMatch place = lexicon_.find_phrase(tokens_, i_ + particle);
  if (place.length == 0 || particle + place.length <= listed) return false;
  place.length += particle;
  add_phrase(place);
  return true;
}

// "a step", "a few paces", "two inches", "arm's length": how far that is, in metres, and the tokens it takes.
std::optional<Measure> Chunker::read_stride(std::size_t at) const {
  const std::size_t first = at;
  double number = 0;
  if (at < tokens_.size() && (tokens_[at].text == "half")) number = 0.5, ++at;
  if (const Match vague = lexicon_.find(tokens_, at, WordClass::kVague), count = lexicon_.find(tokens_, at, WordClass::kNumber);
      std::max(vague.length, count.length) > 0) {
    const Match& said = vague.length > count.length ? vague : count;
    for (const Meaning& meaning : said.meanings) number = std::max(number, meaning.value);
    at += said.length;
  } else if (at < tokens_.size() && lexicon_.is(tokens_[at], WordClass::kIndefinite)) {
    number = number > 0 ? number : 1;
    ++at;
  }
  while (at < tokens_.size() && (tokens_[at].text == "mere" || tokens_[at].text == "good" || tokens_[at].text == "single" ||
                                 tokens_[at].text == "short" || tokens_[at].text == "full"))
    ++at;
  std::string words;
  for (std::size_t i = at; i < tokens_.size() && i < at + 3; ++i) {
    if (tokens_[i].text == "'s") continue;
    words += (words.empty() ? "" : " ") + tokens_[i].text;
    if (const double stride = lexicon_.stride_of(words); stride > 0) return Measure{std::max(number, 1.0) * stride, i + 1 - first};
  }
  const Match unit = lexicon_.find(tokens_, at, WordClass::kUnit);
  if (number < 2 || unit.length == 0 || tokens_[at].text == "in") return std::nullopt;
  for (const Meaning& meaning : unit.meanings) {
    if (meaning.word_class == WordClass::kUnit) return Measure{number * meaning.value, at + unit.length - first};
  }
  return std::nullopt;
}

// "no more than a step from", "within arm's reach of", "a hand's breadth to the left of", "two paces away": at most so far.
bool Chunker::read_steps() {
  static constexpr std::array<std::string_view, 16> kLeads = {"within", "barely",  "hardly", "only", "just", "scarcely",
                                                              "about",  "roughly", "at",     "some", "mere", "almost",
                                                              "not",    "merely",  "but",    "no"};
  std::size_t at = i_;
  bool led = false;
  while (at < tokens_.size()) {
    const std::size_t bound =
        std::max(lexicon_.find(tokens_, at, WordClass::kAtMost).length, lexicon_.find(tokens_, at, WordClass::kMoreThan).length);
    const std::size_t taken = bound > 0 ? bound : is_among(kLeads, tokens_[at].text) ? 1 : 0;
    if (taken == 0 || read_stride(at)) break;
    at += taken;
    led = true;
  }
  const auto stride = read_stride(at);
  if (!stride) return false;
  at += stride->length;
  const auto next_is = [&](std::initializer_list<std::string_view> words) {
    return at < tokens_.size() && std::find(words.begin(), words.end(), tokens_[at].text) != words.end();
  };
  if (next_is({"or"}) && at + 1 < tokens_.size()) at += 2;  // "a step or two"
  const bool away = next_is({"away", "off", "apart", "distant"});
  at += away ? 1 : 0;
  const bool from = next_is({"from", "of"}) || (away && next_is({"to"})) || (!away && next_is({"off"}));
  const PhraseMatch phrase = from ? PhraseMatch{} : lexicon_.find_phrase(tokens_, at);
  const bool ends = at >= tokens_.size() || tokens_[at].kind == Token::Kind::kPunctuation || lexicon_.is(tokens_[at], WordClass::kAnd);
  const bool direct = phrase.length > 0 && !ends;
  if (!from && !direct && !(ends && (away || led))) return false;
  const std::size_t length = at - i_ + (from ? 1 : phrase.length);
  Chunk& chunk = add(ChunkKind::kRelation, length);
  chunk.phrase = phrase;
  chunk.phrase.length = length;
  if (!direct) chunk.phrase.senses = &distance_senses();
  chunk.distance = stride->metres;
  chunk.at_most = true;
  return true;
}

// "The desk is served by an office chair", "shaded with two parasols": a verb that no list has, and what the thing has by it.
bool Chunker::read_having_by() {
  if (i_ + 2 >= tokens_.size() || tokens_[i_].kind != Token::Kind::kWord) return false;
  const std::string &verb = tokens_[i_].text, &by = tokens_[i_ + 1].text;
  const ChunkKind before = previous();
  const bool subject = before == ChunkKind::kNoun || before == ChunkKind::kVerb || before == ChunkKind::kComma || before == ChunkKind::kAnd;
  if ((by != "by" && by != "with") || !subject || !(verb.ends_with("ed") || verb.ends_with("en"))) return false;
  if (lexicon_.find(tokens_, i_).length > 0 || lexicon_.find_phrase(tokens_, i_).length > 0 || word_form(verb) != WordForm::kVerb)
    return false;
  const auto thing = read_noun_phrase(lexicon_, tokens_, i_ + 2, true);
  if (!thing || thing->kind != NounKind::kObject || thing->entry == nullptr || thing->determiner == Determiner::kPossessive) return false;
  if (word_form(thing->head) == WordForm::kPerson || (by == "by" && thing->determiner == Determiner::kDefinite)) return false;
  add(ChunkKind::kHave, 2);
  return true;
}

}  // namespace layoutbox::offline
