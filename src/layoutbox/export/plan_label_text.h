// What labels of a floor plan say, and how large that is on paper.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/export/plan_ink.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

// The name that a person knows the object by, not too long.
std::string label_name(const PlacedObject& object);

// Centimetres: "160 × 200".
std::string label_size(const PlacedObject& object);

// Lines of text in the middle of each other, the last maybe a size in smaller letters.
struct LabelText {
  std::vector<std::string> lines;
  bool with_size = false;
  double letter = 2.5;  // millimetres
  bool upright = false;

  LabelText(const std::string& name, int name_lines, const std::string& size, double letter_size, bool stands);

  // The box that the text fills around a middle.
  PaperBox around(PaperPoint middle) const;
  void draw(Canvas& page, PaperPoint middle) const;

 private:
  bool is_size(std::size_t line) const { return with_size && line + 1 == lines.size(); }
  double letter_of(std::size_t line) const;
};

}  // namespace layoutbox
