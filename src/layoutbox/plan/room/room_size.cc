// The size of the room: "4 x 3 m", "20 square meters", "ceilings 3 m high".
#include <algorithm>
#include <cmath>
#include <utility>

#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/room/bare_sides.h"
#include "layoutbox/plan/room/joined_sides.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/room/size_owner.h"

namespace layoutbox::offline {
namespace {

constexpr double kLongestSide = 100;                       // m, as in scene files
constexpr double kNarrowest = 1.2, kNarrowestOfTwo = 0.8;  // m: of a side said alone, and of two
constexpr double kLowestCeiling = 1.2;                     // m

class SizeReader {
 public:
  SizeReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip, std::vector<Splice>& commas)
      : lexicon_(lexicon),
        document_(document),
        tokens_(document.tokens),
        skip_(skip),
        commas_(commas),
        owner_(lexicon, document.tokens, size_) {}

  RoomSize run() {
    for (std::size_t i = 3; i + 1 < tokens_.size(); ++i) settle_for(i);
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) l_shaped_ |= tokens_[i].text == "l" && tokens_[i + 1].text.starts_with("shape");
    for (std::size_t i = 0; i < tokens_.size() && !is_set(document_.stop); ++i) {
      if (tokens_[i].kind != Token::Kind::kNumber && lexicon_.find(tokens_, i, WordClass::kNumber).length == 0) continue;
      if (const std::size_t niche = read_niche_of(i); niche > 0) {
        i += niche - 1;
      } else if (const std::size_t taken = read_product(i); taken > 0) {
        i += taken - 1;
      } else if (const std::size_t area = read_area(i); area > 0) {
        i += area - 1;
      } else if (const std::size_t height = read_height(i); height > 0) {
        i += height - 1;
      } else if (const std::size_t side = read_side(i); side > 0) {
        i += side - 1;
      }
    }
    return size_;
  }

 private:
  // "office 5 meters for 6": by.
  void settle_for(std::size_t i) {
    const std::size_t after = i + 2;
    const bool ends =
        after >= tokens_.size() || tokens_[after].kind == Token::Kind::kPunctuation || lexicon_.is(tokens_[after], WordClass::kUnit);
    const bool room = lexicon_.is(tokens_[i - 3], WordClass::kRoom) || tokens_[i - 3].text == "room";
    if (tokens_[i].text == "for" && ends && room && tokens_[i + 1].kind == Token::Kind::kNumber &&
        lexicon_.is(tokens_[i - 1], WordClass::kUnit) && tokens_[i - 2].kind == Token::Kind::kNumber)
      document_.tokens[i].text = "by";
  }

  void take(std::size_t first, std::size_t last, const char* role) {
    // "about 5 x 6 m": not that all that follows is only about there
    while (first > 0 && !skip_[first - 1] && says_one_of(document_, first - 1, {"about", "roughly", "around", "approximately", "circa"}))
      --first;
    for (std::size_t i = first; i < last && i < tokens_.size(); ++i) {
      skip_[i] = true;
      document_.readings[i].use = WordReading::Use::kUsed;
      document_.readings[i].role = role;
    }
  }

  // The niche whose size begins at `at`: up to where its words end.
  std::size_t read_niche_of(std::size_t at) {
    if (document_.niche) return 0;
    const auto read = read_niche(lexicon_, tokens_, at);
    if (!read) return 0;
    document_.niche = read->niche;
    take(read->first, read->last, "niche of the room");
    return read->last - at;
  }

  // A second size: of the other part of an L, or one that contradicts the first.
  std::size_t read_second(std::size_t at, std::size_t length, const std::vector<double>& sides) {
    constexpr double kSame = 0.01;
    const bool same = std::abs(sides[0] - size_.width) < kSame && std::abs(sides[1] - size_.depth) < kSame;
    if (l_shaped_ && !document_.niche && !same) {
      add_part(sides[0], sides[1]);
      take(at, at + length, "size of the room's other part");
      return length;
    }
    if (!same) {
      document_.notes.push_back({"contradiction",
                                 "the room is given two sizes: \"" + words_between(document_, at, at + length) + "\" is not followed",
                                 "prompt:" + std::to_string(tokens_[at].begin) + "-" + std::to_string(tokens_[at + length - 1].end)});
    }
    take(at, at + length, same ? "size of the room" : "contradicts the size of the room");
    return length;
  }

  // The smaller part of an L stands at the right end of the larger one, against the back wall: what is in front of it is cut out.
  void add_part(double width, double depth) {
    if (depth > size_.depth) {
      std::swap(width, size_.width);
      std::swap(depth, size_.depth);
    }
    if (size_.depth - depth < 0.1) return;
    document_.niche = Niche{width, size_.depth - depth, true, "front right"};
    size_.width += width;
  }

  std::size_t read_product(std::size_t at) {
    SidesRead read = read_sides(lexicon_, tokens_, at);
    if (read.sides.empty()) read = read_two_joined(lexicon_, tokens_, owner_, at);
    if (read.sides.empty()) read = read_square(at);
    if (read.sides.size() == 2 && !read.united && is_in_feet(read.sides)) {
      for (double& side : read.sides) side *= kFoot;
    }
    const std::vector<double>& values = read.sides;
    const std::size_t length = read.length;
    if (!values.empty() && owner_.says_free_floor(at)) {
      document_.notes.push_back({"ignored", "no such part of the floor is kept free: \"" + words_between(document_, at, at + length) + "\"",
                                 "prompt:" + std::to_string(tokens_[at].begin) + "-" + std::to_string(tokens_[at + length - 1].end)});
      take(at, at + length, "size of a free floor");
      return length;
    }
    if (values.empty() || (!owner_.speaks_of_room(at, at + length, values) && !opens_sentence(at, length, values))) return 0;
    const auto impossible = [](double side) { return side == 0 || side > kLongestSide; };
    size_.impossible = size_.impossible || std::any_of(values.begin(), values.end(), impossible);
    if (values[0] < 0.8 || values[1] < 0.8) return 0;
    if (size_.width > 0) return read_second(at, length, values);
    size_.width = values[0];
    size_.depth = values[1];
    if (values.size() > 2) size_.height = values[2];
    take(at, at + length, "size of the room");
    end_phrase(at, at + length);
    return length + (values.size() == 2 ? read_height_after(at + length) : 0);
  }

  // "Primary bath, 9x11": metres would make many times such a room.
  bool is_in_feet(const std::vector<double>& sides) const {
    constexpr double kTimes = 6, kShare = 0.35;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const Match match = lexicon_.find(tokens_, i);
      const Meaning* meaning = meaning_of(match, WordClass::kRoom);
      if (meaning == nullptr || meaning->room == nullptr) continue;
      const double usual = m_from_mm(meaning->room->usual_size.width) * m_from_mm(meaning->room->usual_size.depth);
      const double area = sides[0] * sides[1];
      return area > kTimes * usual && area * kFoot * kFoot > kShare * usual;
    }
    return false;
  }

  // "15 feet square": both sides of a floor. Not "15 feet square table".
  SidesRead read_square(std::size_t at) const {
    const auto side = read_measure(lexicon_, tokens_, at);
    const std::size_t last = side ? at + side->length : at;
    if (!side || last >= tokens_.size() || tokens_[last].text != "square" || tokens_[last - 1].ends_sentence) return {};
    if (last + 1 < tokens_.size() && tokens_[last + 1].kind == Token::Kind::kWord && lexicon_.find_phrase(tokens_, last + 1).length == 0 &&
        !lexicon_.is(tokens_[last + 1], WordClass::kHave) && !lexicon_.is(tokens_[last + 1], WordClass::kAnd))
      return {};
    SidesRead read;
    read.sides = {side->metres, side->metres};
    read.length = side->length + 1;
    return read;
  }

  // "…, me on the other. 15 feet square, a fireplace": a floor by itself is the room's.
  bool opens_sentence(std::size_t at, std::size_t length, const std::vector<double>& sides) const {
    constexpr double kLeast = 2.4, kSmallest = 2.5;  // m, m²
    const bool large = sides.size() >= 2 && ((sides[0] >= kLeast && sides[1] >= kLeast) || owner_.exceeds_last_thing(at, sides, kSmallest));
    return large && size_.width == 0 && at > 0 && tokens_[at - 1].ends_sentence && owner_.stands_alone(at, at + length);
  }

  // "6 x 6 m and 3.5 m high": the room's as well.
  std::size_t read_height_after(std::size_t at) {
    std::size_t next = at;
    while (next < tokens_.size() && !tokens_[next - 1].ends_sentence && (tokens_[next].text == "," || tokens_[next].text == "and")) ++next;
    SaidSize said;
    const std::size_t length = next < tokens_.size() ? read_size(lexicon_, tokens_, next, said) : 0;
    if (length == 0 || !said.height || said.width || said.depth || *said.height < kLowestCeiling) return 0;
    size_.height = *said.height;
    take(next, next + length, "height of the room");
    return next + length - at;
  }

  // "living room 3.2 x 3.8 m sofa, …": what follows is no part of the room's name.
  void end_phrase(std::size_t first, std::size_t last) {
    if (last >= tokens_.size() || !owner_.follows_room(first) || lexicon_.find(tokens_, last, WordClass::kObject).length == 0) return;
    commas_.push_back({last, comma_token()});
  }

  std::size_t read_area(std::size_t at) {
    if (const AreaRead mats = read_mats(lexicon_, tokens_, owner_, at); mats.length > 0) {
      size_.area = mats.area;
      take(at, at + mats.length, "area of the room");
      return mats.length;
    }
    if (tokens_[at].kind != Token::Kind::kNumber || at + 1 >= tokens_.size()) return 0;
    Match unit = lexicon_.find(tokens_, at + 1, WordClass::kAreaUnit);
    double scale = 1;
    std::size_t length = 0;
    if (unit.length > 0) {
      for (const Meaning& m : unit.meanings) {
        if (m.word_class == WordClass::kAreaUnit) scale = m.value;
      }
      length = 1 + unit.length;
    } else if ((tokens_[at + 1].text == "m" || tokens_[at + 1].text == "ft") && at + 2 < tokens_.size() && tokens_[at + 2].glued &&
               tokens_[at + 2].text == "2") {
      scale = tokens_[at + 1].text == "m" ? 1 : kFoot * kFoot;
      length = 3;
    } else {
      return 0;
    }
    const double side = std::sqrt(tokens_[at].number * scale);
    if (!owner_.stands_alone(at, at + length) && !owner_.speaks_of_room(at, at + length, {side, side})) return 0;
    size_.area = tokens_[at].number * scale;
    take(at, at + length, "area of the room");
    return length;
  }

  bool is_ceiling(std::size_t at) const { return at < tokens_.size() && has_class(lexicon_.find(tokens_, at), WordClass::kCeiling); }

  // "3 m ceilings", "a 3 m high ceiling"
  bool ceiling_after(std::size_t last) const {
    return is_ceiling(last) ||
           (last < tokens_.size() && (tokens_[last].text == "high" || tokens_[last].text == "tall") && is_ceiling(last + 1));
  }

  // "ceiling 3 m", "a ceiling height of 2.8 m", "ceilings about 3 m high"; not "hangs from the ceiling 50 cm above the table".
  bool ceiling_before(std::size_t at, std::size_t last) const {
    constexpr std::size_t kFar = 5;
    for (std::size_t back = 1; back <= kFar && back <= at; ++back) {
      const Token& token = tokens_[at - back];
      if (token.kind == Token::Kind::kPunctuation && token.text != "(" && token.text != ":") return false;
      if (has_class(lexicon_.find(tokens_, at - back), WordClass::kObject)) return false;
      if (is_ceiling(at - back))
        return last >= tokens_.size() || tokens_[last].text == "high" || lexicon_.find_phrase(tokens_, last).length == 0;
    }
    return false;
  }

  // "the ceiling is only 2.5 so …": metres, as nobody says the unit.
  bool says_height_alone(std::size_t at) const {
    constexpr double kLowest = 2, kHighest = 6;
    const bool ends = at + 1 >= tokens_.size() || tokens_[at].ends_sentence || tokens_[at + 1].kind == Token::Kind::kPunctuation ||
                      has_class(lexicon_.find(tokens_, at + 1), WordClass::kClause) ||
                      has_class(lexicon_.find(tokens_, at + 1), WordClass::kAnd);
    return ends && tokens_[at].kind == Token::Kind::kNumber && tokens_[at].number >= kLowest && tokens_[at].number <= kHighest;
  }

  // "ceilings 3 m high", "3 m high ceiling", "a ceiling height of 2.8 m".
  std::size_t read_height(std::size_t at) {
    constexpr double kHighest = 30;
    auto measure = read_measure(lexicon_, tokens_, at);
    if (!measure && says_height_alone(at)) measure = Measure{tokens_[at].number, 1};
    if (!measure || measure->metres < kLowestCeiling || measure->metres > kHighest) return 0;
    const std::size_t last = at + measure->length;
    if (!ceiling_after(last) && !ceiling_before(at, last)) return 0;
    size_.height = measure->metres;
    take(at, last, "height of the room");
    return last - at;
  }

  // "1.4 m wide and 4 m long" at [at, …): both of them, where a second one follows; the first is at most left to say.
  std::vector<double> sides_from(std::size_t at, std::size_t length, const SaidSize& first) {
    const auto side_of = [](const SaidSize& said) { return said.width.value_or(said.depth.value_or(said.length.value_or(0))); };
    if (other_side_ > 0) return {side_of(first), std::exchange(other_side_, 0)};
    std::size_t next = at + length;
    const auto passed = [&](const Token& token) { return token.text == "," || token.text == "and" || token.text == "by"; };
    while (next < tokens_.size() && (passed(tokens_[next]) || lexicon_.find(tokens_, next, WordClass::kExactly).length == 1)) ++next;
    SaidSize second;
    if (next >= tokens_.size() || read_size(lexicon_, tokens_, next, second) == 0 || side_of(second) == 0) return {};
    other_side_ = side_of(first);
    return {side_of(first), side_of(second)};
  }

  // "the room is 4 m wide and 3 m long", "width 4 m": one side at a time.
  std::size_t read_side(std::size_t at) {
    constexpr std::size_t kNameBefore = 2;  // "width", "width:"
    SaidSize said;
    std::size_t length = read_size(lexicon_, tokens_, at, said);
    for (std::size_t back = 1; length == 0 && back <= std::min(kNameBefore, at); ++back) {
      const std::size_t taken = read_size_of(lexicon_, tokens_, at - back, said);
      if (taken > back) length = taken - back;
    }
    if (length == 0) return 0;
    const bool second = other_side_ > 0;  // of two sides that were said of the room
    const std::vector<double> sides = sides_from(at, length, said);
    if (!second && !owner_.speaks_of_room(at, at + length, sides)) {
      other_side_ = 0;
      return 0;
    }
    const double value = said.width.value_or(said.depth.value_or(said.length.value_or(0)));
    if (value > 0 && value < (sides.empty() ? kNarrowest : kNarrowestOfTwo)) return 0;
    if (size_.width > 0 && size_.depth > 0 && !said.height && !second && sides.empty()) return 0;  // "7 x 5 m, a kitchen line 3 m long"
    if (said.width) size_.width = *said.width;
    if (said.depth) size_.depth = *said.depth;
    if (said.length) size_.depth = *said.length;
    if (said.height) size_.height = *said.height;
    take(at, at + length, "size of the room");
    return length;
  }

  const Lexicon& lexicon_;
  Document& document_;
  const std::vector<Token>& tokens_;
  std::vector<bool>& skip_;
  std::vector<Splice>& commas_;  // behind sizes that a thing follows
  RoomSize size_;
  SizeOwner owner_;
  double other_side_ = 0;  // that the side read last was said together with
  bool l_shaped_ = false;
};

}  // namespace

RoomSize read_room_size(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  complete_bare_sides(lexicon, document, skip);
  std::vector<Splice> commas;
  const RoomSize size = SizeReader(lexicon, document, skip, commas).run();
  splice(document, skip, std::move(commas));
  return size;
}

}  // namespace layoutbox::offline
