// The sheet of paper round a floor plan: its title, the words that the room was made from, scale and north.
#pragma once

#include <string>

#include "layoutbox/export/canvas.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

// A4 across, in millimetres.
inline constexpr double kSheetWidth = 297, kSheetHeight = 210, kSheetMargin = 10, kSheetTitleHeight = 20, kSheetKeyWidth = 46;
inline constexpr double kSheetTitleTop = kSheetHeight - kSheetMargin - kSheetTitleHeight;

// What the room is called: its name, else its kind.
std::string plan_title(const Layout& layout);

// `ratio`: the plan's scale is 1 to that.
void draw_sheet(Canvas& page, const Layout& layout, int ratio, bool scale_bar);

}  // namespace layoutbox
