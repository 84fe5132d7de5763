#include "layoutbox/scene/scene_graph.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/name_tables.h"

namespace layoutbox {
namespace {

std::string plain(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c != '_' && c != '-' && c != ' ') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

template <class T>
const T* find_by_id(const std::vector<T>& items, std::string_view id) {
  const auto found = std::find_if(items.begin(), items.end(), [&](const T& item) { return item.id == id; });
  return found == items.end() ? nullptr : &*found;
}

const Wall* find_wall_in(const std::vector<Wall>& walls, std::string_view id_or_word) {
  if (const Wall* exact = find_by_id(walls, id_or_word)) return exact;
  for (const Wall& wall : walls) {
    if (same_name(wall.id, id_or_word)) return &wall;
  }
  const std::optional<Side> side = room_side_from_word(id_or_word);
  return side ? wall_on_side(walls, *side) : nullptr;
}

}  // namespace

bool same_name(std::string_view a, std::string_view b) { return plain(a) == plain(b); }

std::optional<Side> room_side_from_word(std::string_view word) {
  std::string name = plain(word);
  if (name.starts_with("the")) name.erase(0, 3);
  if (name.starts_with("wall")) name.erase(0, 4);
  if (name.ends_with("wall")) name.erase(name.size() - 4);
  if (name.ends_with("ern")) name.erase(name.size() - 3);
  if (name == "front" || name == "south") return Side::kFront;
  if (name == "back" || name == "north" || name == "rear") return Side::kBack;
  if (name == "left" || name == "west") return Side::kLeft;
  if (name == "right" || name == "east") return Side::kRight;
  return std::nullopt;
}

const Wall* wall_on_side(const std::vector<Wall>& walls, Side side) {
  const bool along_x = side == Side::kFront || side == Side::kBack;
  const int outward = side == Side::kFront || side == Side::kLeft ? -1 : 1;
  const Wall* best = nullptr;
  // Doubled middle coordinate across the wall, in the outward direction; and the length.
  long best_place = 0, best_length = 0;
  long inner = 0;
  for (const Wall& wall : walls) {
    const long dx = std::labs(long{wall.end.x} - wall.start.x), dy = std::labs(long{wall.end.y} - wall.start.y);
    inner += along_x ? long{wall.start.y} + wall.end.y : long{wall.start.x} + wall.end.x;
    if (along_x ? dx < dy : dy < dx) continue;
    const long place = outward * (along_x ? long{wall.start.y} + wall.end.y : long{wall.start.x} + wall.end.x);
    const long length = std::max(dx, dy);
    if (best == nullptr || place > best_place || (place == best_place && length > best_length)) {
      best = &wall;
      best_place = place;
      best_length = length;
    }
  }
  // In a list that lacks a side, the opposite wall must not answer for it.
  if (best != nullptr && walls.size() > 1 && best_place * static_cast<long>(walls.size()) < outward * inner) return nullptr;
  return best;
}

const SceneObject* SceneGraph::find_object(std::string_view id) const { return find_by_id(objects, id); }
const Opening* SceneGraph::find_opening(std::string_view id) const { return find_by_id(room.openings, id); }
const Wall* SceneGraph::find_wall(std::string_view id_or_word) const { return find_wall_in(room.walls, id_or_word); }

const PlacedObject* Layout::find_object(std::string_view id) const { return find_by_id(objects, id); }
const Opening* Layout::find_opening(std::string_view id) const { return find_by_id(room.openings, id); }
bool Layout::lists_as_given_up(std::string_view relation) const {
  const auto is_it = [&](const Relaxation& item) { return item.relation == relation; };
  return std::ranges::any_of(relaxed, is_it) || std::ranges::any_of(gave_way, is_it);
}
const Wall* Layout::find_wall(std::string_view id_or_word) const { return find_wall_in(room.walls, id_or_word); }

std::string_view name_of(Mount mount) { return name_in(kMountNames, mount); }
std::string_view name_of(Side side) { return name_in(kSideNames, side); }
std::string_view name_of(Axis axis) { return name_in(kAxisNames, axis); }
std::string_view name_of(OpeningType type) { return name_in(kOpeningTypeNames, type); }
std::string_view name_of(Swing swing) { return name_in(kSwingNames, swing); }
std::string_view name_of(SizeSource source) { return name_in(kSizeSourceNames, source); }
std::string_view name_of(Origin origin) { return name_in(kOriginNames, origin); }
std::string_view name_of(LayoutStatus status) { return name_in(kLayoutStatusNames, status); }

std::optional<Mount> mount_from_name(std::string_view name) { return value_in<Mount>(kMountNames, name); }
std::optional<Side> side_from_name(std::string_view name) { return value_in<Side>(kSideNames, name); }
std::optional<Axis> axis_from_name(std::string_view name) { return value_in<Axis>(kAxisNames, name); }
std::optional<OpeningType> opening_type_from_name(std::string_view name) { return value_in<OpeningType>(kOpeningTypeNames, name); }
std::optional<Swing> swing_from_name(std::string_view name) { return value_in<Swing>(kSwingNames, name); }
std::optional<SizeSource> size_source_from_name(std::string_view name) { return value_in<SizeSource>(kSizeSourceNames, name); }
std::optional<Origin> origin_from_name(std::string_view name) { return value_in<Origin>(kOriginNames, name); }
std::optional<LayoutStatus> layout_status_from_name(std::string_view name) { return value_in<LayoutStatus>(kLayoutStatusNames, name); }

}  // namespace layoutbox
