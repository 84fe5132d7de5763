#include <array>

#include "layoutbox/render/render.h"

namespace layoutbox {
namespace {
constexpr std::array<std::string_view, 5> kViewNames{"iso", "top", "front", "eye", "door"};  // in the order of View
}

std::string_view name_of(View view) { return kViewNames.at(static_cast<std::size_t>(view)); }

std::optional<View> view_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kViewNames.size(); ++i) {
    if (kViewNames[i] == name) return static_cast<View>(i);
  }
  return std::nullopt;
}

std::string picture_name(View view) { return view == View::kIso ? "scene.png" : "scene-" + std::string(name_of(view)) + ".png"; }

}  // namespace layoutbox
