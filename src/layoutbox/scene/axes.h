// Files whose axes differ from ours (y up, z towards the viewer…), turned into our frame.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// Which axis of the file, and in which direction, is right, forward (away from the viewer) and up.
class Axes {
 public:
  // Reads metadata.axes. False where its directions do not make a frame; they are then as usual.
  [[nodiscard]] bool read(const nlohmann::json& metadata, std::vector<Note>& notes);

  bool is_usual() const;
  std::size_t up_index() const { return axis_[2]; }
  // 1 where a positive turn about the file's up axis is counter-clockwise seen from above, else -1.
  double turn_sign() const;
  std::array<double, 3> room_from_file(const std::array<double, 3>& p) const;
  nlohmann::json scale_from_file(const nlohmann::json& scale) const;
  Axis room_axis(Axis file_axis) const;

  // Where an axis of the file runs against ours and nothing but positions says where the room is, they come out negative by the room's
  // size: moves them back into it. REQUIRES: the document is in metres and in our axes.
  void move_into_room(nlohmann::json& scene, std::vector<Note>& notes) const;

 private:
  std::array<std::size_t, 3> axis_{0, 1, 2};  // of right, forward, up: 0 = the file's x…
  std::array<double, 3> sign_{1, 1, 1};
};

}  // namespace layoutbox
