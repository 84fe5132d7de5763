#include "layoutbox/scene/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace layoutbox {

using nlohmann::json;

bool Axes::read(const json& metadata, std::vector<Note>& notes) {
  const auto axes = metadata.find("axes");
  if (axes == metadata.end() || !axes->is_object()) return true;
  std::array<std::size_t, 3> axis = axis_;
  std::array<double, 3> sign = sign_;
  constexpr const char* kNames[] = {"right", "forward", "up"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto text = axes->find(kNames[i]);
    if (text == axes->end() || !text->is_string()) continue;
    const std::string& word = text->get_ref<const std::string&>();
    const std::size_t letter = word.find_first_of("XYZxyz");
    if (letter == std::string::npos) return true;  // the schema names it
    axis[i] = static_cast<std::size_t>((word[letter] | 0x20) - 'x');
    sign[i] = word.find('-') != std::string::npos ? -1 : 1;
  }
  if (axis[0] == axis[1] || axis[1] == axis[2] || axis[0] == axis[2]) {
    return false;
  }
  axis_ = axis;
  sign_ = sign;
  if (!is_usual()) notes.push_back({"converted", "positions are turned into x right, y forward, z up", "/metadata/axes"});
  return true;
}

bool Axes::is_usual() const { return axis_ == std::array<std::size_t, 3>{0, 1, 2} && sign_ == std::array<double, 3>{1, 1, 1}; }

double Axes::turn_sign() const {
  // The determinant of the frame in the file's coordinates: a left-handed file turns the other way.
  const bool even = (axis_[1] + 3 - axis_[0]) % 3 == 1;
  return (even ? 1 : -1) * sign_[0] * sign_[1] * sign_[2] * sign_[2];
}

std::array<double, 3> Axes::room_from_file(const std::array<double, 3>& p) const {
  return {sign_[0] * p[axis_[0]], sign_[1] * p[axis_[1]], sign_[2] * p[axis_[2]]};
}

json Axes::scale_from_file(const json& scale) const { return {scale[axis_[0]], scale[axis_[1]], scale[axis_[2]]}; }

Axis Axes::room_axis(Axis file_axis) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (axis_[i] == static_cast<std::size_t>(file_axis)) return static_cast<Axis>(i);
  }
  return file_axis;
}

void Axes::move_into_room(json& scene, std::vector<Note>& notes) const {
  const auto room = scene.find("room");
  if (room == scene.end() || !room->is_object() || room->contains("walls") || room->contains("polygon")) return;
  const auto dims = room->find("dims");
  const auto furniture = scene.find("furniture");
  if (dims == room->end() || !dims->is_object() || furniture == scene.end() || !furniture->is_array()) return;
  std::vector<json*> positions;
  for (json& object : *furniture) {
    if (!object.is_object() || !object.contains("xform") || !object["xform"].is_object() || !object["xform"].contains("pos")) continue;
    json& pos = object["xform"]["pos"];
    if (pos.is_array() && pos.size() == 3 && std::ranges::all_of(pos, [](const json& v) { return v.is_number(); }))
      positions.push_back(&pos);
  }
  constexpr const char* kSides[] = {"w", "d"};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto side = dims->find(kSides[i]);
    if (sign_[i] > 0 || positions.empty() || side == dims->end() || !side->is_number()) continue;
    if (!std::ranges::all_of(positions, [&](const json* pos) { return (*pos)[i].get<double>() <= 0; })) continue;
    for (json* pos : positions) (*pos)[i] = (*pos)[i].get<double>() + side->get<double>();
    notes.push_back({"converted", fmt::format("positions along {} are counted from the other side of the room", "xy"[i]), "/furniture"});
  }
}

}  // namespace layoutbox
