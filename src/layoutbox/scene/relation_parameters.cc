#include "layoutbox/scene/relation_parameters.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/scene/name_tables.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox {
namespace {

std::string one_spelling(std::string word) { return word == "centre" || word == "middle" ? "center" : word; }

// The words of a place without those that say nothing of which it is.
std::vector<std::string> telling_words(std::string_view text, std::initializer_list<std::string_view> idle) {
  std::vector<std::string> words;
  for (std::string& word : words_of(text)) {
    if (std::ranges::find(idle, word) == idle.end()) words.push_back(one_spelling(std::move(word)));
  }
  return words;
}

template <std::size_t N>
std::vector<std::string_view> list_of(const std::string_view (&names)[N]) {
  return {std::begin(names), std::end(names)};
}

std::optional<Side> opposite_of(Side side) {
  switch (side) {
    case Side::kLeft: return Side::kRight;
    case Side::kRight: return Side::kLeft;
    case Side::kFront: return Side::kBack;
    case Side::kBack: return Side::kFront;
    default: return std::nullopt;
  }
}

constexpr unsigned bit_of(PartWord word) { return 1U << static_cast<unsigned>(word); }

}  // namespace

ThingPart::ThingPart(std::initializer_list<PartWord> words) {
  for (const PartWord word : words) {
    text_ += (text_.empty() ? "" : " ") + std::string(name_of(word));
    words_ |= static_cast<std::uint16_t>(bit_of(word));
  }
}

ThingPart::ThingPart(std::string text) : text_(std::move(text)) {
  std::uint16_t known = 0;
  for (const std::string& word : telling_words(text_, {"the", "side", "half", "part"})) {
    const auto found = value_in<PartWord>(kPartWordNames, word);
    if (!found) return;
    known |= static_cast<std::uint16_t>(bit_of(*found));
  }
  words_ = known;
}

std::vector<PartWord> ThingPart::words() const {
  std::vector<PartWord> words;
  for (unsigned i = 0; i < std::size(kPartWordNames); ++i) {
    if (has(static_cast<PartWord>(i))) words.push_back(static_cast<PartWord>(i));
  }
  return words;
}

bool lies_at(RoomRegion region, Side side) {
  switch (region) {
    case RoomRegion::kMiddle: return false;
    case RoomRegion::kLeft: return side == Side::kLeft;
    case RoomRegion::kRight: return side == Side::kRight;
    case RoomRegion::kFront: return side == Side::kFront;
    case RoomRegion::kBack: return side == Side::kBack;
    case RoomRegion::kFrontLeft: return side == Side::kFront || side == Side::kLeft;
    case RoomRegion::kFrontRight: return side == Side::kFront || side == Side::kRight;
    case RoomRegion::kBackLeft: return side == Side::kBack || side == Side::kLeft;
    case RoomRegion::kBackRight: return side == Side::kBack || side == Side::kRight;
  }
  return false;
}

std::vector<Edge> edges_of(RelationType type) {
  using enum Edge;
  if (type == RelationType::kEdgeAlign) return {kFront, kBack, kLeft, kRight, kCenter};  // of a thing's own frame, which has no axis
  if (type == RelationType::kAlign || type == RelationType::kGroupAlign)
    return {kCenter, kLeft, kRight, kFront, kBack, kBottom, kTop, kMin, kMax};
  if (type == RelationType::kOffset) return {kCenter};  // else its nearer edge
  return {};
}

std::string_view name_of(Edge edge) { return name_in(kEdgeNames, edge); }
std::string_view name_of(RoomRegion region) { return name_in(kRegionNames, region); }
std::string_view name_of(PartWord word) { return name_in(kPartWordNames, word); }
std::vector<std::string_view> edge_names() { return list_of(kEdgeNames); }
std::vector<std::string_view> region_names() { return list_of(kRegionNames); }
std::vector<std::string_view> part_words() { return list_of(kPartWordNames); }

std::optional<Edge> edge_from_words(std::string_view words) {
  const std::vector<std::string> telling = telling_words(words, {"the", "edge", "edges", "side", "sides"});
  return telling.size() == 1 ? value_in<Edge>(kEdgeNames, telling.front()) : std::nullopt;
}

// A middle with a side is that side: the region's halves have no middle of their own.
std::optional<RoomRegion> region_from_words(std::string_view words) {
  std::vector<Side> sides;
  bool middle = false;
  for (const std::string& word : telling_words(words, {"the", "side", "half", "part", "third", "corner", "area", "end", "of", "room"})) {
    if (word == "center") {
      middle = true;
    } else {
      const auto side = value_in<Side>(kSideNames, word);
      if (!side || !opposite_of(*side) || std::ranges::find(sides, *opposite_of(*side)) != sides.end()) return std::nullopt;
      if (std::ranges::find(sides, *side) == sides.end()) sides.push_back(*side);
    }
  }
  if (sides.empty()) return middle ? std::optional(RoomRegion::kMiddle) : std::nullopt;
  for (std::size_t i = 0; i < std::size(kRegionNames); ++i) {
    const RoomRegion region = static_cast<RoomRegion>(i);
    const bool fits = std::ranges::all_of(sides, [&](Side side) { return lies_at(region, side); });
    if (fits && (sides.size() == 2) == (region >= RoomRegion::kFrontLeft)) return region;
  }
  return std::nullopt;
}

}  // namespace layoutbox
