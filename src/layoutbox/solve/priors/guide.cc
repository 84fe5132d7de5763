#include "layoutbox/solve/priors/guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "layoutbox/solve/conflict/conflict.h"

namespace layoutbox::placement {
namespace {

// Points: a metre away from the earlier place along each axis, another turn, not exactly where it was. Beside these all habits of
// good rooms (at most 900 a metre) only decide between places that are equally near.
constexpr int kStay = 20000, kTurned = 20000, kMoved = 200;
constexpr int kLockWeight = 5000;
// Points for standing where another layout has it (within so many millimetres, turned alike), of so many of the largest things.
constexpr int kSamePlace = 400;
constexpr Mm kElsewhere = 900;
constexpr std::size_t kDifferentThings = 4;

bool named(const std::vector<std::string>& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

struct EarlierPose {
  Size size;
  std::array<double, 3> position{};
  double rotation = 0;
};

// Where the object was: in the earlier layout, or, for what is to be locked, where the scene has it.
std::optional<EarlierPose> pose_of(const ModelOptions& options, const Item& item) {
  if (item.is_opening() || item.fixed || named(options.freed, item.id)) return std::nullopt;
  if (const PlacedObject* earlier = options.from ? options.from->find_object(item.id) : nullptr)
    return EarlierPose{earlier->size, earlier->position, earlier->rotation_deg};
  const PoseHint& hint = item.object->hint;
  if (!named(options.locked, item.id) || !hint.position) return std::nullopt;
  return EarlierPose{item.object->size->usual, *hint.position, hint.rotation_deg.value_or(0)};
}

bool between(Mm least, Mm length, Mm greatest) { return length >= least - 1 && length <= greatest + 1; }

bool allows(const SizeRange& range, const Size& size) {
  return between(range.least.width, size.width, range.greatest.width) && between(range.least.depth, size.depth, range.greatest.depth) &&
         between(range.least.height, size.height, range.greatest.height);
}

// The turn among `turns` that looks the same: what has no front looks alike from both sides, what is square from four.
std::optional<int> same_turn(const std::vector<int>& turns, int turn, bool has_front) {
  for (const int other : {turn, (turn + 180) % 360}) {
    if ((other == turn || !has_front) && std::find(turns.begin(), turns.end(), other) != turns.end()) return other;
  }
  return std::nullopt;
}

int whole_turn(double degrees) { return static_cast<int>(std::lround(normalized_degrees(degrees))) % 360; }

Mm difference(const Size& a, const Size& b) {
  return std::abs(a.width - b.width) + std::abs(a.depth - b.depth) + std::abs(a.height - b.height);
}

Placement start_of(const Item& item, const EarlierPose& pose) {
  std::vector<int> turns;
  for (const State& state : item.states) turns.push_back(state.turn);
  const std::optional<int> turn = same_turn(turns, whole_turn(pose.rotation), item.has_front || item.mount != Mount::kFloor);
  Placement start;
  Mm least = 0;
  for (std::size_t s = 0; s < item.states.size(); ++s) {
    const State& state = item.states[s];
    if (turn && state.turn != *turn) continue;
    const Mm off = difference(state.size, pose.size) + state.size_step;
    if (start.state < 0 || off < least) start.state = static_cast<int>(s), least = off;
  }
  const Vec3& extent = item.states[start.state].extent;
  for (int k = 0; k < 3; ++k) start.at[k] = static_cast<Mm>(std::lround(pose.position[k] - (k < 2 ? extent[k] / 2.0 : 0)));
  return start;
}

// Where an opening whose place the scene leaves open was.
Placement start_of_opening(const PlacementModel& model, const Item& item, const Opening& earlier) {
  Placement start;
  const WallId w = model.find_wall(earlier.wall);
  if (!w.exists() || !earlier.offset) return start;
  const RoomWall& wall = model.walls[w];
  const std::uint64_t states = wall.straight ? item.states_at(wall.turn) : 0;
  for (std::size_t s = 0; s < item.states.size() && start.state < 0; ++s) {
    if (states >> s & 1) start.state = static_cast<int>(s);
  }
  start.at[wall.normal()] = wall.at;
  start.at[wall.along] = wall.runs_up ? wall.lo + *earlier.offset : wall.hi - *earlier.offset - item.opening->width;
  start.at[2] = item.opening->sill;
  return start;
}

// The item that held this one up, where it is there and has a place too.
ItemId earlier_host(const PlacementModel& model, ItemId index) {
  const PlacedObject* earlier = model.from ? model.from->find_object(model.items[index].id) : nullptr;
  const ItemId host = earlier ? model.find_item(earlier->supported_by) : ItemId();
  const auto rests_on_it = [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.item == host; };
  const auto& supports = model.items[index].supports;
  return host.exists() && std::any_of(supports.begin(), supports.end(), rests_on_it) ? host : ItemId();
}

bool height_is_free(const Item& item) { return item.mount == Mount::kWall || item.mount == Mount::kHung; }

// Twice the middle of where it was.
std::int64_t middle2(const Item& item, const Placement& p, int axis) {
  return 2 * std::int64_t{p.at[axis]} + item.states[p.state].extent[axis];
}

// Near its place in the room.
Formula stay_in_room(const PlacementModel& model, ItemId index) {
  const Item& item = model.items[index];
  const Placement& start = model.start[index];
  const int axes = height_is_free(item) ? 3 : 2;
  Formula f;
  Case& exact = f.add().when(index, std::uint64_t{1} << start.state);
  for (int k = 0; k < axes; ++k) exact.require_small(lo(index, k) - Linear(start.at[k]), 0);
  for (const bool turned : {false, true}) {
    Case& c = f.add();
    c.price = kMoved + (turned ? kTurned : 0);
    if (!turned) c.when(index, item.states_at(item.states[start.state].turn));
    for (int k = 0; k < axes; ++k) c.wish(mid2(index, k) - Linear(middle2(item, start, k)), kStay, 2);
  }
  return f;
}

// Near its place on what holds it, wherever that goes.
Formula stay_on_host(const PlacementModel& model, ItemId index, ItemId host) {
  const Item &item = model.items[index], &under = model.items[host];
  const Placement &start = model.start[index], &base = model.start[host];
  const int was = under.states[base.state].turn;
  Formula f;
  std::uint64_t seen = 0;
  for (const State& state : under.states) {
    const std::uint64_t states = under.states_at(state.turn);
    if (states & seen || (state.turn - was) % 90 != 0) continue;
    seen |= states;
    const int by = (state.turn - was + 360) % 360;
    std::int64_t off[2] = {middle2(item, start, 0) - middle2(under, base, 0), middle2(item, start, 1) - middle2(under, base, 1)};
    for (int quarter = 0; quarter < by / 90; ++quarter) {
      const std::int64_t x = off[0];
      off[0] = -off[1], off[1] = x;
    }
    const std::uint64_t same = item.states_at((item.states[start.state].turn + by) % 360);
    for (const bool turned : {false, true}) {
      if (!turned && same == 0) continue;
      Case& c = f.add().when(host, states);
      if (!turned) c.when(index, same);
      c.price = turned && same != 0 ? kTurned / 4 : 0;
      for (int k = 0; k < 2; ++k) c.wish(mid2(index, k) - mid2(host, k) - Linear(off[k]), kStay, 2);
      c.wish(lo(index, 2) - lo(host, 2) - Linear(start.at[2] - base.at[2]), kStay);
    }
  }
  return f;
}

void add_lock(PlacementModel& model, ItemId index) {
  const Item& item = model.items[index];
  const Placement& start = model.start[index];
  Constraint lock;
  lock.name = "lock of " + item.id;
  lock.words = object_in_words(model, index) + " stays where it was";
  lock.firmness = Firmness::kHard;
  lock.weight = kLockWeight;
  Case& c = lock.formulas.emplace_back().add().when(index, std::uint64_t{1} << start.state);
  const int axes = height_is_free(item) || earlier_host(model, index).exists() ? 3 : 2;
  for (int k = 0; k < axes; ++k) c.require_small(lo(index, k) - Linear(start.at[k]), 0);
  model.constraints.push_back(std::move(lock));
}

}  // namespace

void add_earlier_pose(const ModelOptions& options, Item& item, std::vector<std::pair<Size, int>>& sizes, std::vector<int>& turns) {
  const std::optional<EarlierPose> pose = pose_of(options, item);
  if (!pose) return;
  if (named(options.locked, item.id)) {
    sizes.assign(1, {pose->size, 0});
  } else if (sizes[0].first != pose->size && allows(*item.object->size, pose->size)) {
    std::erase_if(sizes, [&](const auto& s) { return s.first == pose->size; });
    for (auto& [size, step] : sizes) ++step;
    sizes.insert(sizes.begin(), {pose->size, 0});
  }
  const int turn = whole_turn(pose->rotation);
  if (!same_turn(turns, turn, item.has_front || item.mount != Mount::kFloor)) turns.push_back(turn);
  if (sizes.size() * turns.size() > kMostStates) sizes.resize(kMostStates / turns.size());
}

Status find_starts(PlacementModel& model, const ModelOptions& options) {
  if (!options.from && options.locked.empty()) return {};
  model.from = options.from;
  model.start.assign(model.items.size(), {});
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (item.is_opening()) {
      const Opening* earlier = options.from ? options.from->find_opening(item.id) : nullptr;
      if (earlier && !item.opening->offset && !named(options.freed, item.id)) model.start[i] = start_of_opening(model, item, *earlier);
    } else if (const std::optional<EarlierPose> pose = pose_of(options, item)) {
      model.start[i] = start_of(item, *pose);
    }
  }
  for (const std::string& id : options.locked) {
    const ItemId index = model.find_item(id);
    if (!index.exists()) return fail(ErrorCode::kReference, fmt::format("\"{}\" is to stay where it is, but there is no such object", id));
    Item& item = model.items[index];
    if (item.fixed || (item.is_opening() && item.opening->offset)) continue;  // it stays anyway
    if (model.start[index].state < 0) {
      return fail(ErrorCode::kReference, fmt::format("\"{}\" is to stay where it is, but it had no place yet", id), {},
                  "give an earlier layout that has it, or its xform.pos");
    }
    item.locked = true;
  }
  return {};
}

void add_stays(PlacementModel& model) {
  for (const ItemId index : model.start.ids()) {
    if (model.start[index].state < 0) continue;
    if (model.items[index].locked) {
      add_lock(model, index);
      continue;
    }
    const ItemId host = earlier_host(model, index);
    const bool on_host = host.exists() && model.start[host].state >= 0;
    Constraint& stay = model.constraints.emplace_back();
    stay.name = "stay: " + model.items[index].id;
    stay.firmness = Firmness::kSoft;
    stay.weight = 3 * kStay;  // the exact place is no cheap way round the wishes
    stay.stay = true;
    stay.formulas.push_back(on_host ? stay_on_host(model, index, host) : stay_in_room(model, index));
    if (on_host) stay.hosts.push_back(host);
  }
}

void add_differences(PlacementModel& model, const std::vector<const Layout*>& unlike) {
  if (unlike.empty()) return;
  std::vector<ItemId> largest;
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (!item.is_opening() && !item.thin && !item.fixed && !item.locked && item.mount == Mount::kFloor) largest.push_back(i);
  }
  const auto area = [&](ItemId i) { return std::int64_t{model.items[i].states[0].size.width} * model.items[i].states[0].size.depth; };
  std::stable_sort(largest.begin(), largest.end(), [&](ItemId a, ItemId b) { return area(a) > area(b); });
  if (largest.size() > kDifferentThings) largest.resize(kDifferentThings);
  for (std::size_t rank = 0; rank < largest.size(); ++rank) {
    const ItemId index = largest[rank];
    const Item& item = model.items[index];
    for (const Layout* layout : unlike) {
      const PlacedObject* there = layout->find_object(item.id);
      if (there == nullptr) continue;
      Constraint& other = model.constraints.emplace_back();
      other.name = "unlike: " + item.id;
      other.firmness = Firmness::kSoft;
      other.weight = kSamePlace;
      other.stay = true;
      Formula& f = other.formulas.emplace_back();
      const std::uint64_t same = item.states_at(whole_turn(there->rotation_deg));
      if ((item.all_states & ~same) != 0) f.add().when(index, item.all_states & ~same);
      for (int k = 0; k < 2; ++k) {
        const auto was2 = static_cast<std::int64_t>(std::lround(2 * there->position[k]));
        f.add().require(mid2(index, k) - Linear(was2 + 2 * kElsewhere));
        f.add().require(Linear(was2 - 2 * kElsewhere) - mid2(index, k));
      }
      f.add().price = rank == 0 ? 2 * kSamePlace : kSamePlace;
    }
  }
}

}  // namespace layoutbox::placement
