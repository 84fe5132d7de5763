// Where the light or who lives there comes in, and what one finds on which hand then.
#include <algorithm>
#include <array>

#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Direction = PhraseSense::Direction;

namespace {

bool one_of_words(const Token& token, std::initializer_list<std::string_view> words) {
  return token.kind == Token::Kind::kWord && std::find(words.begin(), words.end(), token.text) != words.end();
}

bool enters(const Token& token) { return one_of(token.text, WordSet::kComing); }

}  // namespace

// "in", "into the room", "through the door": past what follows a verb of coming.
std::size_t Chunker::past_inside(std::size_t at) const {
  while (at < tokens_.size() && one_of_words(tokens_[at], {"in", "inside", "through", "into"})) ++at;
  const auto where = at < tokens_.size() ? read_noun_phrase(lexicon_, tokens_, at, false) : std::nullopt;
  const bool room = where && (where->kind == NounKind::kRoom || where->kind == NounKind::kDoor);
  return room && where->determiner == Determiner::kDefinite ? where->last : at;
}

// "where the light comes in" is the window, "where you come in" the door.
bool Chunker::read_where_in() {
  if (tokens_[i_].text != "where") return false;
  std::size_t at = i_ + 1;
  constexpr std::size_t kWords = 3;
  while (at < tokens_.size() && at < i_ + kWords && one_of_words(tokens_[at], {"the", "most", "all", "morning", "evening", "afternoon"}))
    ++at;
  if (at + 2 > tokens_.size() || at + 1 >= tokens_.size()) return false;
  const bool light = one_of(tokens_[at].text, WordSet::kDaylight);
  const bool who = lexicon_.is(tokens_[at], WordClass::kDoer) || tokens_[at].text == "one" || lexicon_.is_person(tokens_[at].text);
  const Token& verb = tokens_[at + 1];
  const bool pours = one_of(verb.text, WordSet::kLightComes);
  const bool good = light && verb.text == "is" && at + 2 < tokens_.size() && tokens_[at + 2].kind == Token::Kind::kWord;  // "is best"
  if (!(light && pours) && !good && !(who && enters(verb))) return false;
  const std::size_t end = past_inside(at + (good ? 3 : 2));
  if (end == at + 2 && !verb.text.starts_with("enter") && !light) return false;
  add_opening(light ? NounKind::kWindow : NounKind::kDoor, end);
  return true;
}

// "as you enter", "when one walks in", "on entering the room": what is on the left or right then is so in the room.
bool Chunker::read_entering() {
  std::size_t end = 0;
  if (one_of_words(tokens_[i_], {"on", "upon"}) && i_ + 1 < tokens_.size() && one_of_words(tokens_[i_ + 1], {"entering", "entry"})) {
    end = past_inside(i_ + 2);
  } else if (one_of_words(tokens_[i_], {"as", "when", "once", "after"}) && i_ + 2 < tokens_.size() && enters(tokens_[i_ + 2]) &&
             (lexicon_.is(tokens_[i_ + 1], WordClass::kDoer) || tokens_[i_ + 1].text == "one")) {
    end = past_inside(i_ + 3);
    if (end == i_ + 3 && !tokens_[i_ + 2].text.starts_with("enter")) return false;
  }
  if (end == 0) return false;
  entering_ = true;
  const bool place = telling_ < chunks_.size() && chunks_[telling_].kind == ChunkKind::kRelation;
  const bool which =
      place && telling_ > 0 && chunks_[telling_ - 1].kind == ChunkKind::kNoun && chunks_[telling_ - 1].noun.kind == NounKind::kWall;
  if (place && !which) mean_hand(chunks_[telling_]);
  const bool ends = end >= tokens_.size() || tokens_[end].kind == Token::Kind::kPunctuation;
  const bool verb = previous() == ChunkKind::kVerb && telling_ > 0 && chunks_[telling_ - 1].kind == ChunkKind::kNoun;
  const bool thing = previous() == ChunkKind::kNoun && chunks_[telling_].noun.kind == NounKind::kObject &&
                     (telling_ == 0 || chunks_[telling_ - 1].kind != ChunkKind::kRelation);
  if (ends && end > i_ + 1 && (verb || thing)) {  // "a harp as you come in": by the door
    add_opening(NounKind::kDoor, end);
    return true;
  }
  add(ChunkKind::kIgnored, end - i_);
  return true;
}

// The words up to `end` say that something is by the window or the door.
void Chunker::add_opening(NounKind kind, std::size_t end) {
  if (previous() == ChunkKind::kRelation) {
    add(ChunkKind::kIgnored, 1);
  } else {
    Chunk& place = add(ChunkKind::kRelation, 1);
    place.phrase.length = 1;
    place.phrase.senses = &direct_senses<RelationType::kNextTo>();
  }
  NounPhrase opening;
  opening.kind = kind;
  opening.determiner = Determiner::kDefinite;
  opening.name = opening.head = kind == NounKind::kWindow ? "window" : "door";
  opening.first = i_;
  opening.last = end;
  add(ChunkKind::kNoun, end - i_).noun = std::move(opening);
}

// "hard left on the right wall": whose wall is at that hand of who looks at the wall that is named next.
std::string Chunker::wall_at_hand(std::string_view hand, std::size_t at) const {
  const bool left = hand == "left", named = at + 3 < tokens_.size() && one_of_words(tokens_[at], {"on", "at", "along", "against"}) &&
                                            one_of_words(tokens_[at + 2], {"left", "right"}) &&
                                            lexicon_.is(tokens_[at + 3], WordClass::kWall);
  if (!named || (!left && hand != "right")) return std::string(hand);
  return left == (tokens_[at + 2].text == "left") ? "front" : "back";
}

// "the bed flush left", "hard right", "a shelf tight to the left": against that wall.
bool Chunker::read_flush() {
  const ChunkKind before = previous();
  const bool placed = before == ChunkKind::kNoun || before == ChunkKind::kVerb || before == ChunkKind::kParticiple;
  if (!one_of(tokens_[i_].text, WordSet::kFlush) || !placed) return false;
  std::size_t at = i_ + 1;
  while (at < tokens_.size() && at < i_ + 3 && one_of_words(tokens_[at], {"to", "against", "with", "on", "the"})) ++at;
  const Match which = lexicon_.find(tokens_, at, WordClass::kWallWord);
  const std::size_t end = at + which.length;
  const bool ends = end >= tokens_.size() || tokens_[end].kind == Token::Kind::kPunctuation || lexicon_.is(tokens_[end], WordClass::kAnd) ||
                    lexicon_.find_phrase(tokens_, end).length > 0;
  if (which.length == 0 || !ends || (end < tokens_.size() && tokens_[end].text == "of")) return false;
  Chunk& place = add(ChunkKind::kRelation, 1);
  place.phrase.length = 1;
  place.phrase.senses = &direct_senses<RelationType::kAgainstWall>();
  NounPhrase wall;
  wall.kind = NounKind::kWall;
  wall.determiner = Determiner::kDefinite;
  wall.wall_word = wall_at_hand(meaning_of(which, WordClass::kWallWord)->word, end);
  wall.head = "wall";
  wall.name = wall.wall_word + " wall";
  wall.first = i_;
  wall.last = end;
  add(ChunkKind::kNoun, end - i_).noun = std::move(wall);
  return true;
}

// "on the left", said of the room.
void Chunker::mean_hand(Chunk& place) {
  static const PhraseSenses kLeft = {{RelationType::kInRegion, Direction::kAlone, {}, RoomRegion::kLeft, {}}};
  static const PhraseSenses kRight = {{RelationType::kInRegion, Direction::kAlone, {}, RoomRegion::kRight, {}}};
  for (const PhraseSense& sense : *place.phrase.senses) {
    if (sense.direction != Direction::kAlone) continue;
    if (sense.type == RelationType::kLeftOf) place.phrase.senses = &kLeft;
    if (sense.type == RelationType::kRightOf) place.phrase.senses = &kRight;
    if (place.phrase.senses == &kLeft || place.phrase.senses == &kRight) return;
  }
}

}  // namespace layoutbox::offline
