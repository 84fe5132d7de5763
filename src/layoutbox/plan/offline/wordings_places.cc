// Other words for where things are: "in one half … in the other half", "behind me", "each side".
#include <algorithm>
#include <string>
#include <string_view>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/noun_phrase_parts.h"
#include "layoutbox/plan/offline/token_reader.h"
#include "layoutbox/plan/offline/wordings.h"

namespace layoutbox::offline {
namespace {

class PlaceWordingReader : public TokenReader {
 public:
  using TokenReader::TokenReader;

  void run() {
    // Once: asked at every word, this would make long texts quadratic.
    for (const Token& token : tokens_) speaks_of_shape_ |= token.text.starts_with("shape");
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (skip_[i]) continue;
      read_bare_opposite(i);
      read_ends(i);
      read_left_and_right(i);
      read_halves(i);
      read_other_part(i);
      read_each_side(i);
      read_down_the_side(i);
      read_short_end(i);
      read_follow(i);
      read_watched_from(i);
      read_behind_me(i);
      read_from_to(i);
      read_same_wall(i);
      read_likewise_owned(i);
      read_going_up(i);
    }
  }

 private:
  static constexpr std::size_t kReach = 200;  // tokens in which the other half, or a seat, is looked for

  // A thing of that kind is named there.
  bool names(std::size_t at, Trait trait) const {
    const Match match = lexicon_.find(tokens_, at, WordClass::kObject);
    const Meaning* thing = meaning_of(match, WordClass::kObject);
    return match.length == 1 && thing != nullptr && thing->entry != nullptr && thing->entry->is(trait);
  }

  // "wardrobe opposite bed": across from it; no bed that is the opposite one.
  void read_bare_opposite(std::size_t i) {
    if (i == 0 || !is(i, {"opposite"}) || ends(i + 1) || ends(i - 1)) return;
    const bool between =
        lexicon_.find(tokens_, i - 1, WordClass::kObject).length > 0 && lexicon_.find(tokens_, i + 1, WordClass::kObject).length > 0;
    if (between && lexicon_.find(tokens_, i + 1, WordClass::kWall).length == 0) tokens_[i].text = "across";
  }

  // "Kitchen at one end, a sofa at the other": the ends are the room's.
  void read_ends(std::size_t i) {
    if (i == 0 || !are(i, {"at", "one", "end"}) || is(i + 3, {"of"}) || lexicon_.find(tokens_, i - 1, WordClass::kRoom).length == 0) return;
    for (std::size_t at = i + 3; at + 2 < tokens_.size() && !tokens_[at].ends_sentence; ++at) {
      if (!are(at, {"at", "the", "other"}) || is(at + 4, {"of"})) continue;
      tokens_[at + 2].text = "back";
      if (is(at + 3, {"end", "side"})) leave_out(at + 3, at + 4);
    }
  }

  // "speakers left and right of the screen", "two lamps left and right": on both sides.
  // "on the left and on the right of the bookcase" likewise.
  void read_left_and_right(std::size_t i) {
    const auto is_side = [&](std::size_t at, std::string_view side) {
      return is(at, {"on", "to"}) && is(at + 1, {"the"}) && is(at + 2, {side});
    };
    if (is_side(i, "left") && is(i + 3, {"and"}) && is_side(i + 4, "right") && (ends(i + 7) || is(i + 7, {"of"}))) leave_out(i + 4, i + 6);
    if (i == 0 || !are(i, {"left", "and", "right"}) || !(ends(i + 3) || is(i + 3, {"of"})) ||
        is(i - 1, {"the", "to", "on", "its", "from", "both"}))
      return;
    tokens_[i].text = "on";
    tokens_[i + 1].text = "both";
    tokens_[i + 2].text = "sides";
  }

  // "in the center of one half … in the other half": the left and the right half.
  void read_halves(std::size_t i) {
    if (!is(i, {"in", "at", "on"})) return;
    std::size_t half = i + 1;
    if (is(half, {"the"}) && is(half + 1, {"center", "middle"}) && is(half + 2, {"of"})) half += 3;
    if (!is(half, {"one"}) || !is(half + 1, {"half"})) return;
    const bool of_room = are(half + 2, {"of", "the", "room"});
    if (is(half + 2, {"of"}) && !of_room) return;  // "one half of the chairs"
    tokens_[i].text = "in";
    tokens_[half].text = "left";
    if (half > i + 1) leave_out(i + 1, half);
    if (of_room) leave_out(half + 2, half + 5);
    for (std::size_t at = half + 2; at < std::min(tokens_.size(), half + kReach); ++at) {
      if (!is(at, {"in", "at", "on"}) || !are(at + 1, {"the", "other", "half"})) continue;
      tokens_[at].text = "in";
      tokens_[at + 2].text = "right";
      return;
    }
  }

  // "in the other half of the room", and of a room in the form of an L "in the small part … in the long one": part of the room, no more.
  void read_other_part(std::size_t i) {
    if (!are(i, {"in", "the"})) return;
    const bool other = is(i + 2, {"other"}) && is(i + 3, {"half", "part"});
    const bool leg =
        speaks_of_shape_ &&
        is(i + 2, {"small", "smaller", "large", "larger", "long", "longer", "short", "shorter", "main", "big", "wide", "narrow"}) &&
        is(i + 3, {"part", "one", "section", "leg", "half", "bit"});
    if (!other && !leg) return;
    const bool of_room = are(i + 4, {"of", "the", "room"});
    if (of_room || ends(i + 4) || is(i + 4, {"and"})) leave_out(i, i + (of_room ? 7 : 4));
  }

  // "a double bed, a bedside table each side": two of them beside it.
  void read_each_side(std::size_t i) {
    constexpr std::size_t kName = 3;  // words of what stands there
    if (i < 2 || !is(i, {"each", "either"}) || !is(i + 1, {"side"}) || is(i + 2, {"of"}) || tokens_[i - 1].kind != Token::Kind::kWord)
      return;
    if (lexicon_.find(tokens_, i - 1, WordClass::kObject).length == 0) return;
    for (std::size_t at = i - 1; at-- > 0 && i - at <= kName + 1 && !ends(at);) {
      if (!is(at, {"a", "an", "one"})) continue;
      tokens_[at].text = "two";
      tokens_[i].text = "beside";
      tokens_[i + 1].text = "it";
      return;
    }
    // "double bed, nightstand each side with lamps"
    std::string several = tokens_[i - 1].text + "s";
    if (singular_of(several) != tokens_[i - 1].text) return;
    tokens_[i - 1].text = std::move(several);
    tokens_[i].text = "beside";
    tokens_[i + 1].text = "it";
  }

  // "down the left side", "halfway along the right side": at that wall, in the middle of it.
  void read_down_the_side(std::size_t i) {
    const std::size_t side = is(i + 3, {"hand"}) ? i + 4 : i + 3;  // "left-hand side"
    if (!is(i, {"down", "along", "up"}) || !is(i + 1, {"the"}) || !is(i + 2, {"left", "right"}) || !is(side, {"side", "wall"}) ||
        is(side + 1, {"of"}))
      return;
    const bool halfway = i > 0 && is(i - 1, {"halfway"});
    tokens_[i].text = halfway ? "on" : "along";
    if (halfway) tokens_[i - 1].text = "centered";
    tokens_[side].text = "wall";
    if (side > i + 3) leave_out(i + 3, side);
    if (i > 1 && is(i - 1, {"all"}) && is(i - 2, {"windows"})) leave_out(i - 1, i);
  }

  // "a screen at the short end": on the wall there.
  void read_short_end(std::size_t i) {
    if (i == 0 || !are(i, {"at", "the"}) || !is(i + 2, {"short", "shorter", "narrow"}) || !is(i + 3, {"end"}) || is(i + 4, {"of"})) return;
    if (!names(i - 1, Trait::kScreen)) return;
    tokens_[i].text = "on";
    tokens_[i + 3].text = "wall";
  }

  // "three tables follow one another in a row": they stand so.
  void read_follow(std::size_t i) {
    if (!is(i, {"follow", "succeed"}) || !(are(i + 1, {"one", "another"}) || are(i + 1, {"each", "other"}))) return;
    tokens_[i].text = "stand";
    leave_out(i + 1, i + 3);
  }

  // "a tv he can watch from bed": opposite the bed.
  void read_watched_from(std::size_t i) {
    if (i == 0 || !is(i, {"watch", "see", "watched", "seen", "viewed", "visible"}) || !is(i + 1, {"from"})) return;
    std::size_t first = i;
    while (first > 0 && is(first - 1, {"can", "could", "to", "be", "is", "i", "you", "he", "she", "we", "they", "that", "one", "which"}))
      --first;
    if (first == 0 || !names(first - 1, Trait::kScreen)) return;
    if (first < i) leave_out(first, i);
    tokens_[i].text = "opposite";
    if (is_article(i + 2))
      leave_out(i + 1, i + 2);
    else
      tokens_[i + 1].text = "the";
  }

  // "a bookcase behind me": behind where one sits.
  void read_behind_me(std::size_t i) {
    if (!is(i, {"behind"}) || !is(i + 1, {"me", "you", "him", "her", "us"})) return;
    for (std::size_t at = i > kReach ? i - kReach : 0; at < std::min(tokens_.size(), i + kReach); ++at) {
      if (!names(at, Trait::kSeat)) continue;
      tokens_[i + 1].text = tokens_[at].text;
      return;
    }
  }

  // "a red carpet from the door to the throne": between the two.
  void read_from_to(std::size_t i) {
    constexpr std::size_t kName = 4;  // words of where it begins
    if (i == 0 || !is(i, {"from"}) || !is_article(i + 1) || !is(i - 1, {"carpet", "rug", "runner", "path", "walkway", "aisle"})) return;
    for (std::size_t to = i + 3; to <= i + 2 + kName && !ends(to); ++to) {
      if (!is(to, {"to"}) || !is_article(to + 1)) continue;
      tokens_[i].text = "between";
      tokens_[to].text = "and";
      return;
    }
  }

  // "two beds, not same wall please": on two that face each other.
  void read_same_wall(std::size_t i) {
    if (i == 0 || !is(i, {"not", "never"})) return;
    std::size_t at = i + 1;
    while (is(at, {"on", "at", "against", "along", "the"})) ++at;
    if (!are(at, {"same", "wall"})) return;
    std::size_t first = i;
    if (is(i - 1, {","})) --first;
    tokens_[at - 1].text = "on";
    tokens_[at].text = "opposite";
    tokens_[at + 1].text = "walls";
    if (first < at - 1) leave_out(first, at - 1);
    if (is(at + 2, {"please"})) leave_out(at + 2, at + 3);
  }

  // "the dentist's stool on the right and the assistant's on the left": a stool as well.
  void read_likewise_owned(std::size_t i) {
    const bool owned = is(i, {"'s"}) || (is(i, {"is"}) && tokens_[i].glued);  // "assistant's on" was taken for "is"
    if (i < 2 || !owned || is(i - 1, {"it", "that", "there", "here", "what", "who", "let", "he", "she", "how", "where"})) return;
    if (!ends(i + 1) && lexicon_.find_phrase(tokens_, i + 1).length == 0 && !lexicon_.is(tokens_[i + 1], WordClass::kAnd)) return;
    constexpr std::size_t kNear = 25;
    for (std::size_t owner = i - 1; owner-- > 0 && i - owner < kNear && !tokens_[owner].ends_sentence;) {
      const Match thing = is(owner, {"'s"}) ? lexicon_.find(tokens_, owner + 1, WordClass::kObject) : Match{};
      if (thing.length == 0 || owner + thing.length >= i - 1) continue;
      tokens_[i].text = tokens_[owner + thing.length].text;
      tokens_[i].glued = false;
      if (is(i - 2, {"the"})) tokens_[i - 2].text = "another";
      return;
    }
  }

  // "stairs going up on the right": where they lead is not where they are.
  void read_going_up(std::size_t i) {
    if (i == 0 || !is(i, {"going", "leading", "running"}) || !is(i + 1, {"up", "down", "upstairs", "downstairs"})) return;
    if (is(i - 1, {"stairs", "staircase", "stairway", "steps", "ladder"})) leave_out(i, i + 2);
  }

  bool speaks_of_shape_ = false;  // "an L-shaped room": it has parts
};

}  // namespace

void read_place_wordings(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  PlaceWordingReader(lexicon, document.tokens, skip).run();
}

}  // namespace layoutbox::offline
