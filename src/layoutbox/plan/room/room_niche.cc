// Niches, alcoves, notches and missing corners: what they are called, how large they are and where.
#include <algorithm>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox::offline {
namespace {

bool one_of_words(const Token& token, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), token.text) != words.end();
}

bool takes_away(const Token& token) {
  return one_of_words(token, {"missing", "lacking", "lacks", "cut", "removed", "taken", "minus", "less", "off", "gone", "chopped"});
}

class NicheReader {
 public:
  NicheReader(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at)
      : lexicon_(lexicon), tokens_(tokens), first_(at), last_(at) {}

  std::optional<NicheRead> read() {
    if (!read_lengths() || !(name_follows() || name_before())) return std::nullopt;
    take_missing();
    read_place();
    while (first_ > 0 &&
           (lexicon_.is(tokens_[first_ - 1], WordClass::kIndefinite) || one_of_words(tokens_[first_ - 1], {"of", "measuring"})))
      --first_;
    return NicheRead{niche_, first_, last_};
  }

 private:
  bool breaks(std::size_t i) const { return i >= tokens_.size() || tokens_[i].kind == Token::Kind::kPunctuation; }
  bool is_sign(std::size_t i, std::initializer_list<std::string_view> signs) const {
    return i < tokens_.size() && tokens_[i].kind == Token::Kind::kPunctuation && one_of_words(tokens_[i], signs);
  }

  // "2 x 2 m", "1.5 m wide and 1 m deep".
  bool read_lengths() {
    if (const SidesRead read = read_sides(lexicon_, tokens_, first_); read.length > 0) {
      const auto& [sides, numbers, length, united] = read;
      niche_.width = sides[0], niche_.depth = sides[1];
      last_ = first_ + length;
    } else {
      SaidSize said;
      for (std::size_t taken = 0; (taken = read_size(lexicon_, tokens_, last_, said)) > 0;) {
        last_ += taken;
        if (last_ + 1 < tokens_.size() && (tokens_[last_].text == "and" || tokens_[last_].text == ",") &&
            read_measure(lexicon_, tokens_, last_ + 1))
          ++last_;
      }
      niche_.width = said.width.value_or(said.length.value_or(0));
      niche_.depth = said.depth.value_or(said.width ? said.length.value_or(0) : 0);
    }
    constexpr double kLeast = 0.1;  // m
    return niche_.width >= kLeast && niche_.depth >= kLeast;
  }

  // "… notch", "… deep alcove", "… corner is cut off".
  bool name_follows() {
    for (std::size_t i = last_; i < last_ + 3 && !breaks(i); ++i) {
      if (names(i)) {
        last_ = i + std::max<std::size_t>(lexicon_.find(tokens_, i, WordClass::kNiche).length, 1);
        return true;
      }
      if (lexicon_.find_phrase(tokens_, i).length > 0 || lexicon_.find(tokens_, i, WordClass::kObject).length > 0) break;
    }
    return false;
  }

  // "a niche of …", "an alcove (…)", "missing a corner of …".
  bool name_before() {
    for (std::size_t i = first_, looked = 0; i-- > 0 && looked < 5; ++looked) {
      if (names(i)) {
        first_ = i;
        if (is_sign(last_, {")"})) ++last_;
        return true;
      }
      if ((breaks(i) && looked > 0) || is_sign(i, {".", ";"}) || lexicon_.find(tokens_, i, WordClass::kObject).length > 0 ||
          lexicon_.is(tokens_[i], WordClass::kRoomNoun))
        break;
    }
    return false;
  }

  // A niche by its name, or a corner that is not there.
  bool names(std::size_t i) {
    const Match match = lexicon_.find(tokens_, i, WordClass::kNiche);
    if (match.length > 0) {
      niche_.cut = lexicon_.find(tokens_, i, WordClass::kCutNiche).length > 0;
      return true;
    }
    if (tokens_[i].text != "corner") return false;
    const std::size_t from = i > 3 ? i - 3 : 0, until = std::min(i + 4, tokens_.size());
    const bool gone = std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(from), tokens_.begin() + static_cast<std::ptrdiff_t>(until),
                                  takes_away) ||
                      (last_ < tokens_.size() && takes_away(tokens_[last_])) ||
                      (last_ + 1 < tokens_.size() && !breaks(last_) && takes_away(tokens_[last_ + 1]));
    if (gone) niche_.cut = true;
    return gone;
  }

  // "missing a corner", "a corner is cut off": the words that say so are no wish to leave something out.
  void take_missing() {
    if (!niche_.cut) return;
    for (std::size_t i = first_, looked = 0; i-- > 0 && looked < 4 && !breaks(i); ++looked) {
      if (!takes_away(tokens_[i])) continue;
      read_words(i, first_);
      first_ = i;
      break;
    }
    for (std::size_t i = last_; i < last_ + 4 && !breaks(i); ++i) {
      if (takes_away(tokens_[i]) || one_of_words(tokens_[i], {"out"})) last_ = i + 1;
    }
  }

  // "… in the north-east corner", "… in the back wall", "… at the back left"
  void read_place() {
    std::size_t end = last_, said = 0;
    for (std::size_t i = last_; i < last_ + 8 && !breaks(i); ++i) {
      const Match match = lexicon_.find(tokens_, i, WordClass::kWallWord);
      if (match.length > 0) {
        end = i + match.length;
        ++said;
      } else if (lexicon_.is(tokens_[i], WordClass::kCorner) || lexicon_.is(tokens_[i], WordClass::kWall)) {
        end = i + 1;
        break;
      } else if (!one_of_words(tokens_[i], {"in", "at", "on", "from", "into", "of", "the", "its", "to", "along", "out"})) {
        break;
      }
    }
    read_words(last_, end);
    if (said > 0) last_ = end;
  }

  void read_words(std::size_t from, std::size_t until) {
    for (std::size_t i = from; i < until; ++i) {
      const Match match = lexicon_.find(tokens_, i, WordClass::kWallWord);
      if (match.length == 0) continue;
      niche_.walls += (niche_.walls.empty() ? "" : " ") + std::string(meaning_of(match, WordClass::kWallWord)->word);
    }
  }

  const Lexicon& lexicon_;
  std::span<const Token> tokens_;
  Niche niche_;
  std::size_t first_, last_;
};

bool says(const Niche& niche, std::string_view wall) { return niche.walls.find(wall) != std::string::npos; }

// Where it lies in a room of that size, within it or beyond its wall.
struct NichePlace {
  Point low, high;
};

NichePlace place_of(const Niche& niche, Mm w, Mm d) {
  Mm along = mm_from_m(niche.width), across = mm_from_m(niche.depth);
  const bool side_wall = niche.walls == "left" || niche.walls == "right";
  if (side_wall) std::swap(along, across);
  const bool left = says(niche, "left"), front = says(niche, "front"), corner = niche.walls.find(' ') != std::string::npos;
  // In a corner, or at the right end of the back wall where nothing is said; else in the middle of its wall.
  Mm x = left ? 0 : w - along, y = front ? 0 : d - across;
  if (!corner && (niche.walls == "back" || niche.walls == "front")) x = (w - along) / 2 / 10 * 10;
  if (side_wall) y = (d - across) / 2 / 10 * 10;
  if (!niche.cut) {
    if (side_wall)
      x += left ? -along : along;
    else
      y += front ? -across : across;
  }
  return {{x, y}, {x + along, y + across}};
}

// Corners without those that repeat or that lie on a straight line.
std::vector<Point> simplified(const std::vector<Point>& all) {
  std::vector<Point> kept;
  const std::size_t n = all.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (kept.empty() || all[i] != kept.back()) kept.push_back(all[i]);
  }
  if (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  std::vector<Point> corners;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Point a = kept[(i + kept.size() - 1) % kept.size()], b = kept[i], c = kept[(i + 1) % kept.size()];
    const bool straight = (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y);
    if (!straight) corners.push_back(b);
  }
  return corners;
}

}  // namespace

std::optional<NicheRead> read_niche(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  return NicheReader(lexicon, tokens, at).read();
}

std::vector<Point> outline_with_niche(Mm w, Mm d, const Niche& niche) {
  const auto [low, high] = place_of(niche, w, d);
  const Mm most_x = niche.cut ? w - 500 : w, most_y = niche.cut ? d - 500 : d;  // what is left must be a room
  const bool side_wall = niche.walls == "left" || niche.walls == "right";
  const bool fits = side_wall ? high.y - low.y <= most_y && (!niche.cut || high.x - low.x <= most_x)
                              : high.x - low.x <= most_x && (!niche.cut || high.y - low.y <= most_y);
  if (!fits) return room_outline({}, w, d);
  // Round the room counter-clockwise from the front left corner; the niche interrupts the wall that it is in.
  std::vector<Point> points;
  const bool right = !side_wall ? false : niche.walls == "right", left = side_wall && !right;
  const bool front = !side_wall && says(niche, "front"), back = !side_wall && !front;
  const Mm inner_x = niche.cut ? (right ? low.x : high.x) : (right ? high.x : low.x);
  const Mm inner_y = niche.cut ? (front ? high.y : low.y) : (front ? low.y : high.y);
  points.push_back({0, 0});
  if (front) points.insert(points.end(), {{low.x, 0}, {low.x, inner_y}, {high.x, inner_y}, {high.x, 0}});
  points.push_back({w, 0});
  if (right) points.insert(points.end(), {{w, low.y}, {inner_x, low.y}, {inner_x, high.y}, {w, high.y}});
  points.push_back({w, d});
  if (back) points.insert(points.end(), {{high.x, d}, {high.x, inner_y}, {low.x, inner_y}, {low.x, d}});
  points.push_back({0, d});
  if (left) points.insert(points.end(), {{0, high.y}, {inner_x, high.y}, {inner_x, low.y}, {0, low.y}});
  return simplified(points);
}

std::string wall_of_niche(const Room& room, const Niche& niche) {
  const auto polygon = tidy_polygon(room.polygon, "/room/polygon");
  if (!polygon || polygon->size() <= 4) return {};
  const bool side_wall = niche.walls == "left" || niche.walls == "right";
  const Mm length = mm_from_m(niche.width);
  // Of the walls that are as long as the niche is wide the one furthest out, of a notch the one furthest in.
  std::string best;
  Mm best_at = 0;
  for (const Wall& wall : walls_along(*polygon)) {
    const bool along_x = wall.start.y == wall.end.y;
    const Mm long_side = along_x ? std::abs(wall.end.x - wall.start.x) : std::abs(wall.end.y - wall.start.y);
    if (along_x == side_wall || std::abs(long_side - length) > 1) continue;
    const Mm at = along_x ? wall.start.y : wall.start.x;
    const bool towards_high = niche.walls.find("front") == std::string::npos && niche.walls != "left";
    const Mm score = towards_high ? at : -at;
    if (best.empty() || (niche.cut ? score < best_at : score > best_at)) best = wall.id, best_at = score;
  }
  return best;
}

}  // namespace layoutbox::offline
