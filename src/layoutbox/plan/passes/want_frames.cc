#include "layoutbox/plan/passes/want_frames.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

// "cooking", "washes", "having": what such a verb may be without its ending.
std::vector<std::string> bases_of(const std::string& word) {
  std::vector<std::string> bases = {word};
  const std::size_t length = word.size();
  constexpr std::size_t kShortest = 5;
  if (length >= kShortest && word.ends_with("ing")) {
    const std::string stem = word.substr(0, length - 3);
    bases.push_back(stem);
    bases.push_back(stem + "e");
    if (stem.size() > 2 && stem.back() == stem[stem.size() - 2]) bases.push_back(stem.substr(0, stem.size() - 1));
  }
  if (length > 2 && word.ends_with("s") && !word.ends_with("ss")) bases.push_back(word.substr(0, length - 1));
  if (length > 3 && word.ends_with("es")) bases.push_back(word.substr(0, length - 2));
  if (length > 3 && word.ends_with("ies")) bases.push_back(word.substr(0, length - 3) + "y");
  return bases;
}

}  // namespace

std::optional<WantFrames::Frame> WantFrames::frame_at(std::size_t i) {
  // "a kitchen can work for me: cooking, washing up", "a room for sleeping, drawing": done, one after the other
  const bool led = is(i, {":"}) || (is(i, {"for"}) && i > 0 && is(i - 1, {"work", "room", "space", "place", "good", "right", "fit"}));
  if (led && i + 1 < tokens_.size() && tokens_[i + 1].text.ends_with("ing")) return Frame{i, i + 1, 0, 2};
  // "somewhere to open suitcases, hang clothes, make a coffee"
  if (one_of(tokens_[i].text, WordSet::kSomewhere) && is(i + 1, {"to"}) && !ends(i + 2) && use_of_verb(i + 2, 0))
    return Frame{i, i + 2, 0, 2};
  if (is(i, {"let", "lets"})) {
    std::optional<Frame> frame = frame_of_doers(i + 1, i);
    if (frame) frame->least = 1;
    return frame;
  }
  const bool opens = begins(i) || (i > 0 && is(i - 1, {",", ";", ":", "and", "but", "because", "so"}));
  if (opens) {
    if (const std::optional<Frame> frame = frame_of_clause(i)) return frame;
    if (!begins(i) && !is(i - 1, {":", ","})) return std::nullopt;
    if (const std::optional<Frame> frame = names_any_furniture() ? std::nullopt : frame_of_doers(i, i)) return frame;
    // "Sleep, cook simple stuff, eat with a guest."
    if (begins(i) && tokens_[i].kind == Token::Kind::kWord && use_of_verb(i, 0)) return Frame{i, i, 0, 3};
    return std::nullopt;
  }
  // "a bathroom where I can bathe two toddlers"
  const bool room = i > 0 && (lexicon_.find(tokens_, i - 1, WordClass::kRoom).length > 0 || is(i - 1, {"room", "space", "house", "flat"}) ||
                              one_of(tokens_[i - 1].text, WordSet::kSomewhere));
  if (!room) return std::nullopt;
  const std::size_t who = is(i, {"where", "that", "which", "so"}) ? i + 1 : i;
  std::optional<Frame> frame = frame_of_clause(who);
  if (frame && frame->first == who) frame->first = i;
  return frame;
}

std::optional<WantFrames::Frame> WantFrames::frame_of_doers(std::size_t at, std::size_t first) {
  constexpr std::size_t kSubject = 3;  // words
  Frame frame{first, 0, 0, 2};
  for (std::size_t who = at; who < at + kSubject && !ends(who); ++who) {
    if (const NumberRead number = read_number(lexicon_, tokens_, who); number.length > 0) frame.people = static_cast<int>(number.value);
    if (!is_doer(who)) continue;
    frame.verb = past_adverbs(who + 1);
    return !ends(frame.verb) && use_of_verb(frame.verb, 0) ? std::optional(frame) : std::nullopt;
  }
  return std::nullopt;
}

bool WantFrames::is_doer(std::size_t at) const {
  return is(at, {"i", "we", "us", "they", "you", "he", "she", "people", "person", "everyone", "everybody", "someone", "somebody", "who"}) ||
         lexicon_.is_person(tokens_[at].text) || lexicon_.is_person(singular(at));
}

std::optional<WantFrames::Frame> WantFrames::frame_of_clause(std::size_t first) const {
  constexpr std::size_t kSubject = 9;  // words
  Frame frame{first, 0, 0, 1};
  std::size_t at = first;
  bool person = false;
  for (; at < first + kSubject && !ends(at); ++at) {
    if (wants_at(at) != 0) break;
    if (is(at, {"not", "n't", "never", "no", "nobody", "without", "hardly", "don't", "can't"})) return std::nullopt;
    const std::size_t room =
        std::max<std::size_t>(lexicon_.find(tokens_, at, WordClass::kRoom).length, one_of(tokens_[at].text, WordSet::kSomewhere) ? 1 : 0);
    if (room > 0 || is(at, {"where"})) frame.first = at + room;  // "need a living room where they can climb"
    if (room == 0 && lexicon_.find(tokens_, at, WordClass::kObject).length > 0) return std::nullopt;  // "a table where we can eat"
    if (const NumberRead number = read_number(lexicon_, tokens_, at); number.length > 0) frame.people = static_cast<int>(number.value);
    if (is(at, {"both"})) frame.people = 2;
    person |= is_doer(at) || is(at, {"both"});
  }
  const std::size_t wanting = wants_at(at);
  if (wanting == 0 || (!person && !is(at + 1, {"be"}))) return std::nullopt;  // "Residents should be able to …"
  frame.verb = past_adverbs(at + wanting);
  if (is(frame.verb, {"not", "n't", "never", "no"})) return std::nullopt;
  return ends(frame.verb) ? std::nullopt : std::optional(frame);
}

std::string WantFrames::singular(std::size_t at) const {
  const std::string& word = tokens_[at].text;
  return word.ends_with("s") ? word.substr(0, word.size() - 1) : word;
}

std::size_t WantFrames::wants_at(std::size_t at) const {
  std::size_t next = at;
  if (is(next, {"would", "'d", "do", "also", "still", "just"})) ++next;
  if (is(next, {"also", "still", "just", "really"})) ++next;
  if (is(next, {"need", "needs", "want", "wants", "like", "likes", "love", "loves", "have", "has", "hope", "wish"}) && is(next + 1, {"to"}))
    return next + 2 - at + able_at(next + 2);
  if (!is(at, {"should", "must", "can", "could", "may", "might", "will", "would"})) return 0;
  next = at + 1;
  if (is(next, {"all", "both", "also", "each", "still"})) ++next;
  return next - at + able_at(next);
}

std::size_t WantFrames::able_at(std::size_t at) const {
  const std::size_t be = is(at, {"be"}) ? 1 : 0;
  return is(at + be, {"able"}) && is(at + be + 1, {"to"}) ? be + 2 : 0;
}

std::size_t WantFrames::past_adverbs(std::size_t at) const {
  constexpr std::size_t kMost = 3;
  for (std::size_t taken = 0; taken < kMost; ++taken) {
    if (!is(at, {"also", "both", "all", "still", "just", "easily", "comfortably", "properly", "to", "then", "even", "sometimes", "now"}))
      break;
    ++at;
  }
  return at;
}

std::optional<UseRows::Use> WantFrames::use_of_verb(std::size_t at, int people) {
  const std::string written = tokens_[at].text;
  std::optional<Use> best;
  for (const std::string& base : bases_of(written)) {
    tokens_[at].text = base;
    const std::optional<Use> use = to_do(at, people);
    if (use && (!best || use->end > best->end)) best = use;
  }
  tokens_[at].text = written;
  return best;
}

bool WantFrames::names_any_furniture() const {
  for (std::size_t at = 0; at < tokens_.size(); ++at) {
    const Meaning* thing = meaning_of(lexicon_.find(tokens_, at, WordClass::kObject), WordClass::kObject);
    if (thing != nullptr && thing->entry != nullptr && thing->entry->mount == Mount::kFloor && !thing->entry->is(Trait::kPet)) return true;
  }
  return false;
}

}  // namespace layoutbox::offline
