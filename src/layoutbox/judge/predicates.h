// Whether what an annotation says of two objects, or of an object and the room, is so: a score each, above 0.5 it holds. The formulas are
// SceneEval's on boxes (docs/judge.md lists the differences).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "layoutbox/judge/blocks.h"

namespace layoutbox::scoring {

inline constexpr double kHolds = 0.5;

struct Scored {
  double score = 0;
  std::string text;   // what was measured
  std::string place;  // id of the wall, door or window that is meant, where there are several
};

// A room with its bodies as blocks, in the order of the layout.
struct MeasuredRoom {
  explicit MeasuredRoom(const checks::RoomView& of_view);
  const checks::RoomView& view;
  std::vector<Block> blocks;
};

// `check` is a name of annotation_words.json: "near", "left", "on"…  REQUIRES: it is one of the list `objects`.
Scored score_objects(std::string_view check, const Block& target, const Block& reference, const MeasuredRoom& room);
bool is_symmetric(std::string_view check);
// Three or more at like distances and like angles around the reference.
Scored score_ring(std::span<const Block* const> targets, const Block& reference);

// Against walls, doors or windows the best one counts. `element` is wall, door, window, ceiling, floor, else the room.
// Empty where the word stands for no check.
std::optional<Scored> score_room(std::string_view word, std::string_view element, const Block& target, const MeasuredRoom& room);

}  // namespace layoutbox::scoring
