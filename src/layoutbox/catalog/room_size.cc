#include "layoutbox/catalog/room_size.h"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <vector>

#include "layoutbox/scene/quirks.h"

namespace layoutbox {
namespace {

constexpr double kLeast = 0.5, kGreatest = 100, kGreatestHeight = 50;

struct SizeMeasure {
  double value = 0;  // in its unit
  std::string unit;  // empty: not said
};

// Other spellings of the signs, one byte each.
std::string plain_signs(std::string_view text) {
  static constexpr std::pair<std::string_view, char> kSigns[] = {{"×", 'x'}, {"✕", 'x'}, {"′", '\''},    {"’", '\''},
                                                                 {"″", '"'}, {"”", '"'}, {"\u00a0", ' '}};
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    bool found = false;
    for (const auto& [sign, byte] : kSigns) {
      if (!text.substr(i).starts_with(sign)) continue;
      out += byte;
      i += sign.size();
      found = true;
      break;
    }
    if (!found) out += text[i++];
  }
  return out;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class RoomSizeReader {
 public:
  explicit RoomSizeReader(std::string_view text) : text_(plain_signs(text)) {
    // A comma is the decimal sign only where something else separates the numbers.
    const bool other_separator = text_.find_first_of("xX*") != std::string::npos || text_.find("by") != std::string::npos;
    comma_is_decimal_ = other_separator && text_.find('.') == std::string::npos;
  }

  Result<std::vector<SizeMeasure>> read() {
    std::vector<SizeMeasure> measures;
    while (skip_separators()) {
      LAYOUTBOX_ASSIGN(SizeMeasure measure, read_measure());
      // 12'6": feet and inches are one length.
      if (measure.unit == "'" && place_ < text_.size() && is_digit(text_[place_])) {
        LAYOUTBOX_ASSIGN(const SizeMeasure inches, read_measure());
        measure.value += inches.value / 12;
      }
      measures.push_back(std::move(measure));
    }
    return measures;
  }

 private:
  // False at the end of the text.
  bool skip_separators() {
    while (place_ < text_.size()) {
      const std::string_view rest = std::string_view(text_).substr(place_);
      const std::size_t length = rest.starts_with("by") || rest.starts_with("BY") ? 2 : 1;
      if (length == 1 && std::string_view(" \txX*,;()").find(rest.front()) == std::string_view::npos) return true;
      place_ += length;
    }
    return false;
  }

  Result<SizeMeasure> read_measure() {
    std::string number;
    while (place_ < text_.size() && (is_digit(text_[place_]) || text_[place_] == '.' || text_[place_] == '-' || decimal_comma_here())) {
      number += text_[place_] == ',' ? '.' : text_[place_];
      ++place_;
    }
    SizeMeasure measure;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), measure.value);
    if (number.empty() || error != std::errc{} || end != number.data() + number.size()) return wrong();
    std::size_t begin = place_;
    while (begin < text_.size() && text_[begin] == ' ') ++begin;
    std::size_t stop = begin;
    if (stop < text_.size() && (text_[stop] == '\'' || text_[stop] == '"'))
      ++stop;
    else
      while (stop < text_.size() && is_letter(text_[stop])) ++stop;
    std::string unit = text_.substr(begin, stop - begin);
    // "4x3": the x is no unit; "4mx3m": nor is the one behind the unit.
    if (unit == "x" || unit == "X" || unit == "by" || unit == "BY") return measure;
    if (unit.size() > 1 && !metres_per_unit(unit) && (unit.back() == 'x' || unit.back() == 'X')) {
      unit.pop_back();
      --stop;
    }
    if (unit.empty()) return measure;
    if (!metres_per_unit(unit))
      return fail(ErrorCode::kUsage, fmt::format("\"{}\" is no unit of length", unit), {}, "give m, cm, mm, ft or in");
    measure.unit = std::move(unit);
    place_ = stop;
    return measure;
  }

  bool decimal_comma_here() const {
    return comma_is_decimal_ && text_[place_] == ',' && place_ + 1 < text_.size() && is_digit(text_[place_ + 1]);
  }

  Failure wrong() const {
    return fail(ErrorCode::kParse, fmt::format("\"{}\" is not the size of a room", text_.substr(0, 60)), {},
                "write width x depth x height, such as 4x3.2x3");
  }

  std::string text_;
  std::size_t place_ = 0;
  bool comma_is_decimal_ = false;
};

}  // namespace

Result<Size> parse_room_size(std::string_view text, std::string_view units) {
  if (!metres_per_unit(units))
    return fail(ErrorCode::kUsage, fmt::format("\"{}\" is no unit of length", units), {}, "give m, cm, mm, ft or in");
  LAYOUTBOX_ASSIGN(std::vector<SizeMeasure> measures, RoomSizeReader(text.substr(0, 200)).read());
  if (measures.size() < 2 || measures.size() > 3) {
    return fail(ErrorCode::kParse, fmt::format("the size of a room is two or three numbers, not {}", measures.size()), {},
                "write width x depth x height, such as 4x3.2x3");
  }
  std::string unit(units);
  std::vector<double> metres(measures.size());
  for (std::size_t i = measures.size(); i-- > 0;) {
    if (!measures[i].unit.empty()) unit = measures[i].unit;
    metres[i] = measures[i].value * metres_per_unit(unit).value_or(1);
  }
  constexpr std::string_view kNames[] = {"width", "depth", "height"};
  for (std::size_t i = 0; i < metres.size(); ++i) {
    const double greatest = i == 2 ? kGreatestHeight : kGreatest;
    if (metres[i] >= kLeast && metres[i] <= greatest) continue;
    return fail(ErrorCode::kGeometry, fmt::format("the room's {} is {:.6g} m", kNames[i], metres[i]), {},
                fmt::format("give {} to {} m; is the unit right?", kLeast, greatest));
  }
  return Size{mm_from_m(metres[0]), mm_from_m(metres[1]), metres.size() == 3 ? mm_from_m(metres[2]) : 0};
}

}  // namespace layoutbox
