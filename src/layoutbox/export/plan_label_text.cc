#include "layoutbox/export/plan_label_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "layoutbox/base/utf8.h"

namespace layoutbox {
namespace {

constexpr double kLineHeight = 1.15;
constexpr std::size_t kMostCharacters = 32;

// The first characters of a text, whole UTF-8 sequences.
std::string shortened(const std::string& text) {
  const std::string_view kept = first_characters(text, kMostCharacters);
  return kept.size() == text.size() ? text : std::string(kept) + "…";
}

// One line, or two broken at the space nearest the middle.
std::vector<std::string> broken(const std::string& name, int lines) {
  if (lines == 1) return {name};
  std::optional<std::size_t> best;
  for (std::size_t i = 1; i + 1 < name.size(); ++i) {
    const auto off = [&](std::size_t place) { return std::abs(static_cast<double>(place) - static_cast<double>(name.size()) / 2); };
    if (name[i] == ' ' && (!best || off(i) < off(*best))) best = i;
  }
  return best ? std::vector<std::string>{name.substr(0, *best), name.substr(*best + 1)} : std::vector<std::string>{name};
}

}  // namespace

std::string label_name(const PlacedObject& object) {
  std::string name = object.name.empty() ? object.category : object.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  return shortened(name);
}

std::string label_size(const PlacedObject& object) {
  return fmt::format("{:g} × {:g}", std::round(object.size.width) / 10, std::round(object.size.depth) / 10);
}

LabelText::LabelText(const std::string& name, int name_lines, const std::string& size, double letter_size, bool stands)
    : lines(broken(name, name_lines)), with_size(!size.empty()), letter(letter_size), upright(stands) {
  if (with_size) lines.push_back(size);
}

// Sizes are smaller than names, but as large as can be read on A4.
double LabelText::letter_of(std::size_t line) const { return is_size(line) ? std::max(1.75, 0.8 * letter) : letter; }

PaperBox LabelText::around(PaperPoint middle) const {
  double across = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) across = std::max(across, text_width(lines[i], letter_of(i)));
  across += 0.6;
  double down = static_cast<double>(lines.size()) * letter * kLineHeight + 0.4;
  if (upright) std::swap(across, down);
  return {middle.x - across / 2, middle.y - down / 2, middle.x + across / 2, middle.y + down / 2};
}

void LabelText::draw(Canvas& page, PaperPoint middle) const {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double off = (static_cast<double>(i) - (static_cast<double>(lines.size()) - 1) / 2) * letter * kLineHeight + 0.35 * letter;
    const PaperPoint at = upright ? PaperPoint{middle.x + off, middle.y} : PaperPoint{middle.x, middle.y + off};
    page.text(at, letter_of(i), lines[i], TextAnchor::kMiddle, upright ? -90 : 0, is_size(i) ? "#666" : "#222");
  }
}

}  // namespace layoutbox
