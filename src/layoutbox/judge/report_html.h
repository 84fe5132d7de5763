// A judgement as one self-contained page: picture, plan with the failures drawn in, tables.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "layoutbox/judge/judge.h"

namespace layoutbox {

struct RoomPicture {
  std::string media_type;  // "image/png", "image/jpeg"
  std::string bytes;
};

// `pictures` by the name of the room; a room without one shows its plan alone.
std::string judgement_html(const std::vector<Judgement>& judgements, const std::map<std::string, RoomPicture>& pictures = {});

// The floor plan as SVG, with what failed drawn in and numbered as in the report.
// `sheet`: with title and lengths; else the room alone, small.
std::string judged_plan(const Judgement& judgement, bool sheet = true);

// Text as it stands in a page.
std::string escaped_html(std::string_view text);

}  // namespace layoutbox
