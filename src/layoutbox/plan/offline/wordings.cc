#include "layoutbox/plan/offline/wordings.h"

#include <algorithm>
#include <string_view>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/offline/token_reader.h"

namespace layoutbox::offline {
namespace {

class WordingReader : public TokenReader {
 public:
  using TokenReader::TokenReader;

  void run() {
    // Once: asked at every word, these would make long texts quadratic.
    for (const Token& token : tokens_) {
      speaks_of_kitchen_ |= token.text == "kitchen";
      outdoors_ |= token.text == "balcony" || token.text == "loggia";
    }
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (skip_[i]) continue;
      read_picture(i);
      read_besides(i);
      read_seater(i);
      read_burners(i);
      read_on_stand(i);
      read_double_sinks(i);
      read_wall_of_windows(i);
      read_railing(i);
      read_bedrooms(i);
      read_pattern(i);
      read_boards(i);
      read_round(i);
      read_class(i);
      read_doorway(i);
      read_has_back(i);
      read_in_it(i);
      read_needs(i);
      read_see_how(i);
      read_clear_between(i);
      read_sofa_group(i);
      read_on_wheels(i);
      read_end_wall(i);
      read_fit_in(i);
      read_denied_in_brackets(i);
    }
  }

 private:
  // "I need a picture of a living room", "a 3D model of my kitchen": the room.
  void read_picture(std::size_t i) {
    constexpr std::size_t kName = 5;  // words of the room
    if (!is(i, {"picture", "image", "photo", "drawing", "sketch", "rendering", "render", "model", "view", "visualization", "illustration",
                "design", "plan"}) ||
        !is(i + 1, {"of", "for"}) || !is_article(i + 2))
      return;
    for (std::size_t at = i + 2; at < i + 2 + kName && !ends(at); ++at) {
      if (lexicon_.find(tokens_, at, WordClass::kRoom).length == 0 && !is(at, {"room"})) continue;
      std::size_t first = i;
      while (first > 0 && !is_article(first) && i - first < 3) --first;
      if (is_article(first)) leave_out(first, i + 2);
      return;
    }
  }

  // "on the end wall": on a short one.
  void read_end_wall(std::size_t i) {
    if (is(i, {"end"}) && is(i + 1, {"wall", "walls"})) tokens_[i].text = "short";
  }

  // "a 3 seater": a sofa; "a two seater" a small one.
  void read_seater(std::size_t i) {
    if (i == 0 || !is(i, {"seater", "seaters"})) return;
    if (i + 1 < tokens_.size() && !tokens_[i].ends_sentence && lexicon_.find(tokens_, i + 1, WordClass::kObject).length > 0) return;
    const NumberRead number = read_number(lexicon_, tokens_, i - 1);
    if (number.length != 1 || number.value < 2) return;
    tokens_[i].text = number.value < 3 ? "loveseat" : "sofa";
    leave_out(i - 1, i);
  }

  // "a wall of windows", "a wall of glass": a glass wall.
  void read_wall_of_windows(std::size_t i) {
    if (!are(i, {"wall", "of"}) || !is(i + 2, {"windows", "window", "glass"})) return;
    tokens_[i].text = "glass";
    tokens_[i + 1].text = "wall";
    leave_out(i + 2, i + 3);
  }

  // "with double sinks": one vanity that has two.
  void read_double_sinks(std::size_t i) {
    if (!is(i, {"double", "twin", "dual"}) || !is(i + 1, {"sinks", "basins", "washbasins", "vanities"})) return;
    if (speaks_of_kitchen_ || (i > 0 && read_number(lexicon_, tokens_, i - 1).length > 0)) return;
    tokens_[i].text = "double";
    tokens_[i + 1].text = "vanity";
  }

  // "planters along the railing" of a balcony: its low wall.
  void read_railing(std::size_t i) {
    if (i == 0 || !is(i, {"railing", "railings", "balustrade", "parapet"}) || !is_article(i - 1)) return;
    if (!outdoors_ || !lexicon_.is(tokens_[i - 1], WordClass::kDefinite)) return;
    tokens_[i - 1].text = "front";
    tokens_[i].text = "wall";
  }

  // "tv on stand opposite the sofa": on one for it; the word is no verb there.
  void read_on_stand(std::size_t i) {
    if (i == 0 || !is(i, {"on"}) || !is(i + 1, {"stand"}) || !is(i - 1, {"tv", "television", "telly", "screen"})) return;
    tokens_[i + 1].text = "lowboard";
  }

  // "a kitchenette with two burners": one hob.
  void read_burners(std::size_t i) {
    if (i == 0 || !is(i, {"burners", "rings"}) || (i + 1 < tokens_.size() && is(i + 1, {"on"}))) return;
    const std::size_t first = is(i - 1, {"gas", "electric", "cooking"}) ? i - 1 : i;
    if (first == 0 || (is(i, {"rings"}) && first == i)) return;
    const NumberRead number = read_number(lexicon_, tokens_, first - 1);
    if (number.length != 1) return;
    tokens_[first - 1].text = "a";
    tokens_[first - 1].kind = Token::Kind::kWord;
    tokens_[i].text = "hob";
  }

  // "a two-bed flat", "3 bedroom house": how large a home is whose room this is.
  void read_bedrooms(std::size_t i) {
    if (i == 0 || !is(i, {"bed", "beds", "bedroom", "bedroomed"}) ||
        !is(i + 1, {"flat", "apartment", "house", "home", "bungalow", "terrace", "maisonette", "semi", "property", "condo", "townhouse"}))
      return;
    if (const NumberRead number = read_number(lexicon_, tokens_, i - 1); number.length == 1) leave_out(i - 1, i + 1);
  }

  // "a carpet with roads on it", "curtains with clouds on them": what is printed or woven on cloth, where the catalogue has no such thing.
  void read_pattern(std::size_t i) {
    constexpr std::size_t kName = 3;  // words of what is on it
    if (i == 0 || !is(i, {"with"}) ||
        !is(i - 1, {"carpet", "rug", "wallpaper", "curtain", "curtains", "bedding", "duvet", "blanket", "mat", "cushion", "cushions",
                    "poster", "tiles", "walls", "wall"}))
      return;
    std::size_t on = i + 1;
    while (on <= i + kName && !ends(on) && !is(on, {"on"})) ++on;
    if (on == i + 1 || !is(on, {"on"}) || !is(on + 1, {"it", "them"}) || is_article(i + 1)) return;
    for (std::size_t at = i + 1; at < on; ++at) {
      if (lexicon_.find(tokens_, at, WordClass::kObject).length > 0) return;
    }
    // "a bar on the back wall with bottles on it": the bar's.
    for (std::size_t before = i - 1; is(i - 1, {"wall", "walls"}) && before > 0 && i - before < kName + 2; --before) {
      if (is(before - 1, {"on", "against", "along", "at", "to", "near", "by"})) return;
    }
    leave_out(i, on + 2);
  }

  // "a doorway without a door": no less an opening.
  void read_doorway(std::size_t i) {
    if (i == 0 || !is(i - 1, {"doorway", "archway", "opening", "entrance"}) || !is(i, {"without"})) return;
    const std::size_t door = i + (is(i + 1, {"a", "any"}) ? 2 : 1);
    if (is(door, {"door", "doors"})) leave_out(i, door + 1);
  }

  // "a classroom with 24 pupils": for so many.
  void read_class(std::size_t i) {
    if (i == 0 || !is(i, {"with"})) return;
    const NumberRead number = read_number(lexicon_, tokens_, i + 1);
    const std::size_t who = i + 1 + number.length;
    if (number.length == 0 || who >= tokens_.size() || !lexicon_.is_person(singular_of(tokens_[who].text))) return;
    if (is(who + 1, {"'s"})) return;  // "with 20 pupils' desks"
    constexpr std::size_t kName = 3;  // words of the room
    for (std::size_t back = 1; back <= std::min(i, kName); ++back) {
      if (lexicon_.find(tokens_, i - back, WordClass::kRoom).length == back) tokens_[i].text = "for";
    }
  }

  // "a locker, round window above the bunk": its shape, and not around it.
  void read_round(std::size_t i) {
    const bool item = begins(i) || tokens_[i - 1].kind == Token::Kind::kPunctuation || is(i - 1, {"and", "with"});
    if (item && is(i, {"round"}) && i + 1 < tokens_.size() && lexicon_.find(tokens_, i + 1, WordClass::kWindow).length > 0)
      tokens_[i].text = "circular";
  }

  // "Floor is old wooden planks": of wood.
  void read_boards(std::size_t i) {
    constexpr std::size_t kWords = 4;  // what they are like
    if (!is(i, {"floor", "floors"}) || !is(i + 1, {"is", "are", "of"})) return;
    for (std::size_t at = i + 2; at <= i + 1 + kWords && !ends(at); ++at) {
      if (at > i + 2 && is(at, {"planks", "boards", "floorboards", "slabs", "plank"})) return leave_out(at, at + 1);
    }
  }

  // "The sofa should have its back to the wall": it stands with its back to it.
  void read_has_back(std::size_t i) {
    if (!is(i, {"has", "have", "having"}) || !is(i + 1, {"its", "their"}) || !is(i + 2, {"back", "backs"}) ||
        !is(i + 3, {"to", "against", "toward", "towards"}))
      return;
    tokens_[i].text = "with";
    tokens_[i + 3].text = "to";
  }

  // "I need a bed, a desk and a shelf in it.": in the room that was spoken of.
  void read_in_it(std::size_t i) {
    if (!is(i, {"in", "inside"}) || !is(i + 1, {"it", "there"}) || !(i + 2 >= tokens_.size() || tokens_[i + 2].ends_sentence)) return;
    std::size_t first = i;
    std::size_t commas = 0;
    for (; first > 0 && !tokens_[first - 1].ends_sentence; --first) commas += tokens_[first].text == "," ? 1 : 0;
    if (commas > 0 && is(first, {"i", "we", "it", "there", "put", "place", "please"}) && first > 0) leave_out(i, i + 2);
  }

  // "I want to see how my new couch would look in the lounge": it is there.
  void read_see_how(std::size_t i) {
    constexpr std::size_t kName = 8;  // tokens
    if (i == 0 || !is(i, {"how"}) || !is(i - 1, {"see", "know", "imagine", "show", "me"}) || !is_article(i + 1)) return;
    std::size_t would = i + 1;
    while (would < i + kName && !ends(would) && !is(would, {"would", "will", "could", "might"})) ++would;
    if (!is(would, {"would", "will", "could", "might"}) || !is(would + 1, {"look", "fit", "go", "work", "stand"})) return;
    leave_out(i > 1 && is(i - 2, {"to"}) ? i - 2 : i - 1, i + 1);
    leave_out(would, would + (is(would + 2, {"like"}) ? 3 : 2));
  }

  // "90 cm of clear floor between the sofa and the table": the gap.
  void read_clear_between(std::size_t i) {
    if (i < 3 || !is(i, {"between"})) return;
    std::size_t first = i;
    while (first > 0 && is(first - 1, {"clear", "free", "open", "empty", "floor", "space", "room", "of", "walkway", "clearance", "gap"}))
      --first;
    if (first == i || first == 0 || lexicon_.find(tokens_, first - 1, WordClass::kUnit).length == 0) return;
    leave_out(first, i);
  }

  // "between the sofa group and the dining table": the sofa.
  void read_sofa_group(std::size_t i) {
    if (i < 2 || !is(i, {"group", "suite"}) || !is(i - 2, {"the"}) || !is(i - 1, {"sofa", "couch", "settee", "table", "dining"})) return;
    if (lexicon_.find(tokens_, i - 1, WordClass::kObject).length > 0) leave_out(i, i + 1);
  }

  // "whether my armchair and the television fit in with the bed": all of them are there.
  void read_fit_in(std::size_t i) {
    if (i == 0 || !is(i, {"fit", "fits", "go", "goes"}) || !are(i + 1, {"in", "with"}) || !is_article(i + 3)) return;
    leave_out(i, i + 2);
    tokens_[i + 2].text = "and";
  }

  // "a tool chest on wheels, a cabinet on castors": how it is made.
  void read_on_wheels(std::size_t i) {
    if (i > 0 && is(i, {"on"}) && is(i + 1, {"wheels", "castors", "casters", "rollers"})) leave_out(i, i + 2);
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

  // "Each of the three nurses needs a desk", "every guest gets a towel": has one.
  void read_needs(std::size_t i) {
    constexpr std::size_t kName = 6;  // words of who
    if (!is(i, {"needs", "gets", "wants", "requires"}) || !is_article(i + 1)) return;
    for (std::size_t at = i; at-- > 0 && i - at <= kName && !ends(at);) {
      if (is(at, {"each", "every"})) tokens_[i].text = "has";
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

  bool speaks_of_kitchen_ = false, outdoors_ = false;
};

}  // namespace

void read_wordings(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  WordingReader(lexicon, document.tokens, skip).run();
}

}  // namespace layoutbox::offline
