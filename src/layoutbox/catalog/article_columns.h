// What the columns of somebody's catalogue mean, and how lengths are written in them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace layoutbox {

enum class Column {
  kId,
  kCategory,
  kName,
  kWidth,
  kDepth,
  kHeight,
  kLength,
  kSize,
  kColor,
  kMaterial,
  kStyle,
  kStock,
  kMesh,
  kMeshFront,
  kUnits,
  kSource,
  kUnknown
};

// Two such columns would say two things of one article.
bool is_one_figure(Column column);

// A column's meaning, and the unit that its name may carry: "Width (cm)", "height_mm".
struct Header {
  Column column = Column::kUnknown;
  std::string unit;
};

Header header_of(std::string_view written);

// "160", "1,6", "160 cm", "1.6m".
struct Length {
  double value = 0;
  std::string unit;
  std::optional<double> grouped;  // "1.600": what it is where the sign parts thousands
  std::string text;               // as it was written
};

// Empty where it is none, or in no unit of length.
std::optional<Length> length_from(std::string text);

// "160x200x50 cm" → three lengths.
std::vector<std::string> split_size(std::string_view text);

}  // namespace layoutbox
