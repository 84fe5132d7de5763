// What a relation may say besides its type and its things: lengths, sides, and where on a thing, along which edge, in which part of
// the room. Which of them a type reads stands in the relation table.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/units.h"

namespace layoutbox {

enum class RelationType;
enum class Side { kFront, kBack, kLeft, kRight, kTop, kBottom, kLong, kShort };
enum class Axis { kX, kY, kZ };
// Which coordinate of two things is the same. kMin, kMax: the lesser, the greater along the relation's axis.
enum class Edge { kCenter, kLeft, kRight, kFront, kBack, kBottom, kTop, kMin, kMax };
enum class RoomRegion { kMiddle, kLeft, kRight, kFront, kBack, kFrontLeft, kFrontRight, kBackLeft, kBackRight };
enum class PartWord { kBack, kFront, kLeft, kRight, kCenter, kCorner, kEdge, kEnd, kTop };

// Where on or in a thing: words for a part of its top, of which all hold ("back left corner"), or the name of one of its spaces. Where a
// thing has a space of that name, the space is meant.
class ThingPart {
 public:
  ThingPart() = default;
  ThingPart(PartWord word) : ThingPart({word}) {}  // NOLINT(google-explicit-constructor): one word is a part
  ThingPart(std::initializer_list<PartWord> words);
  explicit ThingPart(std::string text);

  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }
  // None where a word of it is none of those: it can only be the name of a space.
  bool is_words() const { return words_ != 0; }
  bool has(PartWord word) const { return (words_ >> static_cast<unsigned>(word) & 1U) != 0; }
  std::vector<PartWord> words() const;
  // More than that it is on top.
  bool says_where() const { return (words_ & ~(1U << static_cast<unsigned>(PartWord::kTop))) != 0; }
  friend bool operator==(const ThingPart&, const ThingPart&) = default;

 private:
  std::string text_;  // as written
  std::uint16_t words_ = 0;
};

// What a default in the relation table can say as well.
struct RelationFigures {
  std::optional<Axis> axis;
  std::optional<Mm> distance, min, max, gap, depth, width, height;
  std::optional<Side> side;
  std::optional<Edge> edge;
  std::optional<RoomRegion> region;
  std::optional<int> columns;
  friend bool operator==(const RelationFigures&, const RelationFigures&) = default;
};

// Absent = the table's default.
struct RelationParameters : RelationFigures {
  ThingPart part;
};

// Does that part of the room lie at that side? The middle at none, "back left" at two.
bool lies_at(RoomRegion region, Side side);

// The edges that a type speaks of; empty where it speaks of none.
std::vector<Edge> edges_of(RelationType type);

// Names as they stand in JSON, in the order of the values.
std::string_view name_of(Edge edge);
std::string_view name_of(RoomRegion region);
std::string_view name_of(PartWord word);
std::vector<std::string_view> edge_names();
std::vector<std::string_view> region_names();
std::vector<std::string_view> part_words();

// By those names and as people write them: in any case and order, "centre" and "middle" for "center", "left side", "the back-left part".
std::optional<Edge> edge_from_words(std::string_view words);
std::optional<RoomRegion> region_from_words(std::string_view words);

}  // namespace layoutbox
