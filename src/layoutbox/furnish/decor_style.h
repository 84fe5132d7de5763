// The style or mood that a text names.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace layoutbox {

std::string lower_case(std::string_view text);

struct RoomStyle {
  std::string name;
  const nlohmann::json* data = nullptr;  // a row of decor.json
};

// The style that a text names first ("rustic"), else the mood ("make it dark"); without data where it names neither.
RoomStyle style_of(std::string_view text);

}  // namespace layoutbox
