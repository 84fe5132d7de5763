#include "layoutbox/plan/passes/wordings.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/passes/wording_table.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/token_reader.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

// What no row of the table can say: it looks further than a few words.
class WordingReader : public TokenReader {
 public:
  using TokenReader::TokenReader;

  void run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (skip_[i]) continue;
      read_besides(i);
      read_in_it(i);
      read_denied_in_brackets(i);
      read_ends(i);
      read_halves(i);
      read_each_side(i);
      read_behind_me(i);
      read_likewise_owned(i);
      read_left_there(i);
      read_trade(i);
    }
  }

 private:
  // "I need a bed, a desk and a shelf in it.": in the room that was spoken of.
  void read_in_it(std::size_t i) {
    if (!is(i, {"in", "inside"}) || !is(i + 1, {"it", "there"}) || !(i + 2 >= tokens_.size() || tokens_[i + 2].ends_sentence)) return;
    std::size_t first = i;
    std::size_t commas = 0;
    bool had = false;  // "…, a cage with a parrot in it": in the cage
    for (; first > 0 && !tokens_[first - 1].ends_sentence; --first) {
      had |= commas == 0 && is(first, {"with"});
      commas += tokens_[first].text == "," ? 1 : 0;
    }
    if (had && commas > 0) return;
    if (commas > 0 && is(first, {"i", "we", "it", "there", "put", "place", "please"}) && first > 0) leave_out(i, i + 2);
  }

  // "a piano with its stool (not near the radiator, please), a television": said of what stands before the bracket.
  void read_denied_in_brackets(std::size_t i) {
    constexpr std::size_t kAside = 16;  // tokens
    if (!is(i, {"("}) || !is(i + 1, {"not", "never"})) return;
    leave_out(i, i + 1);
    for (std::size_t at = i + 1; at < std::min(tokens_.size(), i + kAside); ++at) {
      if (is(at, {"please"})) leave_out(is(at - 1, {","}) ? at - 1 : at, at + 1);
      if (!is(at, {")"})) continue;
      if (at + 1 < tokens_.size() && tokens_[at + 1].kind == Token::Kind::kPunctuation) leave_out(at, at + 1);
      return;
    }
  }

  // "Besides the sofa there is an armchair", "apart from the bed I want a desk": as well as what was named, not beside it.
  void read_besides(std::size_t i) {
    constexpr std::size_t kName = 8;  // tokens
    const bool from = is(i, {"apart", "aside"}) && is(i + 1, {"from"});
    if (!begins(i) || !(is(i, {"besides"}) || from) || !is_article(i + (from ? 2 : 1))) return;
    std::size_t end = i + 1;
    while (end < i + kName && !ends(end) && !is(end, {"there", "i", "we"})) ++end;
    if (end >= i + kName || end >= tokens_.size() || (tokens_[end].text != "," && ends(end))) return;
    const std::string& name = tokens_[end - 1].text;
    const bool named = std::any_of(tokens_.begin(), tokens_.begin() + static_cast<std::ptrdiff_t>(i),
                                   [&](const Token& token) { return token.text == name; });
    if (named) return leave_out(i, end + (tokens_[end].text == "," ? 1 : 0));
    tokens_[i].text = "add";
    if (from) leave_out(i + 1, i + 2);
  }

  static constexpr std::size_t kReach = 200;  // tokens in which the other half, or a seat, is looked for

  // A thing of that kind is named there.
  bool names(std::size_t at, Trait trait) const {
    const Match match = lexicon_.find(tokens_, at, WordClass::kObject);
    const Meaning* thing = meaning_of(match, WordClass::kObject);
    return match.length == 1 && thing != nullptr && thing->entry != nullptr && thing->entry->is(trait);
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

  // "a bookcase behind me": behind where one sits.
  void read_behind_me(std::size_t i) {
    if (!is(i, {"behind"}) || !is(i + 1, {"me", "you", "him", "her", "us"})) return;
    for (std::size_t at = i > kReach ? i - kReach : 0; at < std::min(tokens_.size(), i + kReach); ++at) {
      if (!names(at, Trait::kSeat)) continue;
      tokens_[i + 1].text = tokens_[at].text;
      return;
    }
  }

  // "a book left on the sofa", "shoes left by the door": kept there, where no side is meant. Not "wardrobe left in the corner".
  void read_left_there(std::size_t i) {
    if (!is(i, {"left"}) || i == 0 || ends(i - 1) ||
        is(i - 1, {"the", "its", "his", "her", "far", "on", "to", "one", "other", "is", "turn"}))
      return;
    if (!is(i + 1, {"on", "in", "under", "by", "beside", "behind", "near", "at", "inside", "there", "over", "across", "against", "lying",
                    "standing"}))
      return;
    for (std::size_t at = i; at < tokens_.size() && !tokens_[at].ends_sentence; ++at) {
      if (is(at, {"right"})) return;  // "bed left by the window, desk right"
    }
    const Meaning* thing = meaning_of(lexicon_.find(tokens_, i - 1, WordClass::kObject), WordClass::kObject);
    constexpr Mm kLeftBehind = 700;  // what somebody puts down
    if (thing != nullptr && thing->entry != nullptr && thing->entry->size.usual.width > kLeftBehind) return;
    tokens_[i].text = is(i + 1, {"over", "across"}) ? "draped" : "kept";
  }

  // "Anna Lind builds violins in a former dairy": who it is and what is done there, no violins.
  void read_trade(std::size_t i) {
    constexpr std::size_t kNames = 3;
    if (!begins(i) || !tokens_[i].capital) return;
    std::size_t verb = i;
    while (verb < i + kNames && verb < tokens_.size() && tokens_[verb].capital && lexicon_.find(tokens_, verb).length == 0) ++verb;
    const std::size_t things = verb + 1;
    if (verb == i || things + 1 >= tokens_.size() || tokens_[verb].kind != Token::Kind::kWord) return;
    const std::string &does = tokens_[verb].text, &what = tokens_[things].text;
    const bool acts = singular_of(does) != does && may_be_verb(singular_of(does)) && !lexicon_.is(tokens_[verb], WordClass::kPlaceVerb) &&
                      !lexicon_.is(tokens_[verb], WordClass::kHave) && !lexicon_.is(tokens_[verb], WordClass::kHang);
    const bool over = tokens_[things + 1].ends_sentence || is(things + 1, {"in", "at", "for", "here", "from", "and"});
    if (acts && over && singular_of(what) != what) leave_out(i, things + 1);
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
};

}  // namespace

void read_wordings(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  WordingReader(lexicon, document.tokens, skip).run();
  read_wording_table(lexicon, document.tokens, skip);
}

}  // namespace layoutbox::offline
