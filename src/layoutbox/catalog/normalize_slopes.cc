// Slopes of the roof stand along a whole wall, between a knee wall and the ceiling; roof windows sit in them.
#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

constexpr Mm kMiddle = 2020;                         // the slope's own: above it nobody's way is blocked
constexpr Mm kLowestKnee = 900, kLeastRise = 400;    // mm
constexpr double kRun = 0.9;                         // of the rise: 48 degrees
constexpr double kMostOfTwo = 0.36, kMostOf = 0.55;  // of the room, how far they reach into it
constexpr Mm kWindow = 780, kWindowApart = 400;

Mm even(double length) { return static_cast<Mm>(std::floor(length / 2)) * 2; }

// A wall along an axis of the room, seen by what has its back to it at that turn.
struct SlopeWall {
  const Wall* wall = nullptr;
  int turn = 0;
  Mm low = 0, high = 0, at = 0;  // along it, and where it stands across
  bool along_x() const { return turn % 180 == 0; }
  // Towards the room, across the wall.
  int inward() const { return turn == 0 || turn == 270 ? -1 : 1; }
};

int turn_at(const Wall& wall) {
  if (wall.start.y == wall.end.y) return wall.end.x > wall.start.x ? 180 : 0;
  if (wall.start.x == wall.end.x) return wall.end.y > wall.start.y ? 270 : 90;
  return -1;
}

class SlopeNormalizer {
 public:
  explicit SlopeNormalizer(NormalizeContext& context) : context_(context), room_(context.scene.room) {}

  void run() {
    std::vector<SlopeWall> taken;
    for (SceneObject& object : context_.scene.objects) {
      if (!is(object, Trait::kRoofSlope)) continue;
      SlopeWall wall = wall_of(object);
      if (wall.wall == nullptr) continue;
      cut_back(wall, taken);
      build(object, wall);
      taken.push_back(wall);
      let_in(object, wall);
    }
  }

 private:
  bool is(const SceneObject& object, Trait trait) const { return context_.catalog.entry_or_nearest(object.category).is(trait); }

  // The longest wall that it has its back to; of those of no said turn the back wall.
  SlopeWall wall_of(const SceneObject& object) const {
    const int turn = static_cast<int>(std::lround(object.hint.rotation_deg.value_or(0))) % 360;
    SlopeWall longest;
    for (const Wall& wall : room_.walls) {
      if (turn_at(wall) != turn) continue;
      const bool along_x = turn % 180 == 0;
      const auto [low, high] = along_x ? std::minmax(wall.start.x, wall.end.x) : std::minmax(wall.start.y, wall.end.y);
      if (longest.wall == nullptr || high - low > longest.high - longest.low)
        longest = {&wall, turn, low, high, along_x ? wall.start.y : wall.start.x};
    }
    return longest;
  }

  double share(const SlopeWall& wall) const {
    const bool two = std::ranges::any_of(context_.scene.objects, [&](const SceneObject& other) {
      return is(other, Trait::kRoofSlope) && std::lround(other.hint.rotation_deg.value_or(0)) == (wall.turn + 180) % 360;
    });
    return two ? kMostOfTwo : kMostOf;
  }

  // How far it reaches into the room.
  Mm depth_of(const SlopeWall& wall, Mm rise) const {
    Mm least = room_.polygon.front().x, most = least;
    if (wall.along_x()) least = most = room_.polygon.front().y;
    for (const Point& corner : room_.polygon) {
      const Mm at = wall.along_x() ? corner.y : corner.x;
      least = std::min(least, at), most = std::max(most, at);
    }
    return even(std::min(kRun * rise, share(wall) * (most - least)));
  }

  Mm rise() const {
    const Mm knee = std::clamp(2 * kMiddle - room_.height, kLowestKnee, std::max(kLowestKnee, room_.height - kLeastRise));
    return even(std::max(kLeastRise, room_.height - knee));
  }

  // Where two meet in a corner the later one ends at the earlier.
  void cut_back(SlopeWall& wall, const std::vector<SlopeWall>& taken) const {
    for (const SlopeWall& other : taken) {
      if (other.along_x() == wall.along_x()) continue;
      const Mm depth = depth_of(other, rise());
      (other.inward() > 0 ? wall.low : wall.high) += other.inward() * depth;
    }
  }

  void build(SceneObject& object, const SlopeWall& wall) const {
    const Mm up = rise();
    const Size size{even(wall.high - wall.low), depth_of(wall, up), up};
    const double middle = wall.low + size.width / 2, off = wall.at + wall.inward() * size.depth / 2.0;
    fix(object, size, wall.turn, wall.along_x() ? middle : off, wall.along_x() ? off : middle, room_.height - up);
  }

  static void fix(SceneObject& object, const Size& size, int turn, double x, double y, Mm underside) {
    object.size = SizeRange{size, size, size};
    object.size_source = SizeSource::kInferred;
    object.fixed = true;
    object.hint.position = std::array<double, 3>{x, y, double(underside)};
    object.hint.rotation_deg = turn;
  }

  // Windows that are said to be in it: side by side in its middle, each in an opening of its own.
  void let_in(SceneObject& slope, const SlopeWall& wall) const {
    std::vector<SceneObject*> windows;
    for (const Relation& relation : context_.scene.relations) {
      if (relation.type != RelationType::kIn || relation.references != std::vector{slope.id}) continue;
      for (SceneObject& object : context_.scene.objects) {
        if (names(relation.targets, object.id) && is(object, Trait::kInSlope)) windows.push_back(&object);
      }
    }
    if (windows.empty()) return;
    const Size whole = slope.size->usual;
    const Mm pitch = kWindow + kWindowApart, from = -static_cast<Mm>(windows.size() - 1) * pitch / 2;
    const Mm deep = even(whole.depth * 0.42), low = even(double(whole.height) * (whole.depth - deep) / 2 / whole.depth);
    const Size size{std::min(kWindow, even(whole.width / 2.0)), deep, even(double(whole.height) * deep / whole.depth)};
    if (!slope.spaces_given) slope.spaces = spaces_of(slope, context_.catalog.entry_or_nearest(slope.category), whole);
    slope.spaces_given = true;
    std::erase_if(slope.spaces, [](const Space& space) { return space.name.starts_with("window"); });
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const Mm x = from + static_cast<Mm>(i) * pitch;
      slope.spaces.push_back({"window " + std::to_string(i + 1),
                              {x - size.width / 2.0, -deep / 2.0, double(low)},
                              {x + size.width / 2.0, deep / 2.0, double(low + size.height)},
                              true});
      const double turn = wall.turn * M_PI / 180, c = std::round(std::cos(turn)), s = std::round(std::sin(turn));
      const auto& at = *slope.hint.position;
      fix(*windows[i], size, wall.turn, at[0] + c * x, at[1] + s * x, static_cast<Mm>(at[2]) + low);
    }
  }

  NormalizeContext& context_;
  Room& room_;
};

}  // namespace

void normalize_slopes(NormalizeContext& context) { SlopeNormalizer(context).run(); }

}  // namespace layoutbox
