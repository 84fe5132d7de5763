#include "synthetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/relation_check.h"

namespace layoutbox::synthetic {
namespace {

constexpr Mm kStep = 20;  // sizes are multiples: centres and edges then lie on the solver's 1 cm grid

// A small generator of its own: the library's distributions differ between machines.
class Random {
 public:
  // Mixed: the streams of neighbouring seeds would else be one stream, begun at other places.
  explicit Random(std::uint64_t seed) : state_(mixed(seed * 0x9E3779B97F4A7C15u + 0x632BE59BD9B4E019u)) {}

  // In [low, high].
  int number(int low, int high) { return high <= low ? low : low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1)); }
  bool chance(int percent) { return number(1, 100) <= percent; }
  template <class Items>
  const auto& one_of(const Items& items) {
    return items[static_cast<std::size_t>(number(0, static_cast<int>(std::size(items)) - 1))];
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t next() { return mixed(state_ += 0x9E3779B97F4A7C15u); }  // splitmix64
  std::uint64_t state_;
};

Mm rounded(double length) { return std::max(kStep, static_cast<Mm>(std::lround(length / kStep)) * kStep); }

class Maker {
 public:
  explicit Maker(const SceneOptions& options) : options_(options), random_(options.seed * 2 + options.planted) {}

  Scene make() {
    make_room();
    const int wanted = options_.objects.value_or(random_.number(3, 12));
    if (options_.planted) {
      plant_objects(wanted);
      read_relations(options_.relations.value_or(random_.number(1, wanted)));
    } else {
      for (int i = 0; i < wanted; ++i) draw_object();
      for (int i = options_.relations.value_or(random_.number(1, wanted + 2)); i > 0; --i) scene_.relations.push_back(draw_relation(i));
    }
    NormalizeOptions normalize;
    normalize.default_openings = false;
    Result<SceneGraph> normalised = normalize_scene(scene_, Catalog::builtin(), normalize);
    Scene result;
    if (normalised) result.scene = *std::move(normalised);
    if (normalised && options_.planted) result.planted = std::move(layout_);
    return result;
  }

 private:
  // ---- the room

  void make_room() {
    const Mm width = random_.number(26, 70) * 100, depth = random_.number(26, 60) * 100;
    SceneGraph empty;
    empty.room.polygon = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
    if (random_.chance(20)) {
      const Mm x = width * random_.number(4, 7) / 10 / 100 * 100, y = depth * random_.number(4, 7) / 10 / 100 * 100;
      empty.room.polygon = {{0, 0}, {width, 0}, {width, y}, {x, y}, {x, depth}, {0, depth}};
    }
    empty.room.height = random_.number(23, 32) * 100;
    NormalizeOptions normalize;
    normalize.default_openings = false;
    scene_.room = normalize_scene(empty, Catalog::builtin(), normalize)->room;
    if (random_.chance(85)) add_opening("door1", OpeningType::kDoor, 900, 2000, 0);
    if (random_.chance(70)) add_opening("window1", OpeningType::kWindow, 1200, 1200, 900);
    layout_.room = scene_.room;
  }

  void add_opening(const std::string& id, OpeningType type, Mm width, Mm height, Mm sill) {
    Opening opening;
    opening.id = id, opening.type = type, opening.width = width, opening.height = height, opening.sill = sill;
    opening.swing = type == OpeningType::kWindow
                        ? Swing::kNone
                        : random_.one_of(std::array{Swing::kInLeft, Swing::kInRight, Swing::kOutLeft, Swing::kSliding});
    if (!options_.planted && random_.chance(30)) {
      scene_.room.openings.push_back(opening);  // the solver finds its place
      return;
    }
    const Wall& wall = random_.one_of(scene_.room.walls);
    const Mm length = static_cast<Mm>(std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y));
    if (length < width + 100) return;
    opening.wall = wall.id;
    opening.offset = random_.number(0, (length - width) / 50) * 50;
    for (const Opening& other : scene_.room.openings) {
      if (other.wall == opening.wall && *opening.offset < *other.offset + other.width && *other.offset < *opening.offset + width) return;
    }
    scene_.room.openings.push_back(opening);
  }

  // ---- objects

  // A sloping ceiling is part of the room: it stands along a wall, however it is turned.
  const CatalogEntry& draw_entry() {
    const CatalogEntry& drawn = random_.one_of(Catalog::builtin().entries());
    return drawn.shape.family == "roof_slope" ? *Catalog::builtin().find("painting") : drawn;
  }

  SceneObject object_of(const CatalogEntry& entry) {
    SceneObject object;
    object.category = entry.id, object.name = entry.name;
    object.id = entry.id + "_" + std::to_string(scene_.objects.size() + 1);
    const Size usual{rounded(entry.size.usual.width), rounded(entry.size.usual.depth),
                     entry.thin ? entry.size.usual.height : rounded(entry.size.usual.height)};
    object.size = SizeRange{usual, usual, usual};
    object.size_source = SizeSource::kUser;
    object.mount = entry.mount;
    return object;
  }

  void draw_object() {
    const CatalogEntry& entry = draw_entry();
    SceneObject object = object_of(entry);
    if (random_.chance(40)) object.size.reset(), object.size_source = SizeSource::kUnknown;
    if (random_.chance(10)) {
      object.hint.position = std::array<double, 3>{random_.number(0, 500) * 10.0, random_.number(0, 500) * 10.0, 0};
      object.hint.rotation_deg = random_.number(0, 3) * 90;
    }
    scene_.objects.push_back(std::move(object));
  }

  // ---- planting

  void plant_objects(int wanted) {
    std::vector<const CatalogEntry*> entries;
    for (int i = 0; i < wanted; ++i) entries.push_back(&draw_entry());
    // What others stand on comes first.
    std::stable_sort(entries.begin(), entries.end(), [](const CatalogEntry* a, const CatalogEntry* b) { return a->mount < b->mount; });
    for (const CatalogEntry* entry : entries) {
      for (int attempt = 0; attempt < 40; ++attempt) {
        if (plant(*entry)) break;
      }
    }
    if (random_.chance(40)) seat_chairs();
  }

  // Chairs at the sides of something that has room below, pushed under it or a little off.
  void seat_chairs() {
    const CatalogEntry* chair = Catalog::builtin().find("chair");
    const std::vector<PlacedObject> hosts = layout_.objects;
    for (const PlacedObject& host : hosts) {
      const bool hollow = std::any_of(host.spaces.begin(), host.spaces.end(), [](const Space& space) { return !space.carries; });
      if (chair == nullptr || !hollow || host.mount != Mount::kFloor) continue;
      const int pushed_in = random_.number(-30, 20) * 10;
      for (int quarter = 0; quarter < 4; ++quarter) {
        if (random_.chance(60)) plant(*chair, [&](PlacedObject& placed) { return put_at_side(placed, host, quarter, pushed_in); });
      }
      return;
    }
  }

  bool put_at_side(PlacedObject& placed, const PlacedObject& host, int quarter, int pushed_in) {
    const checks::Frame frame = checks::frame_at(host.rotation_deg + 90.0 * quarter);
    const double reach = (quarter % 2 == 0 ? host.size.depth : host.size.width) / 2.0 + placed.size.depth / 2.0 - pushed_in;
    placed.rotation_deg = normalized_degrees(host.rotation_deg + 90.0 * quarter + 180);
    placed.position = {host.position[0] - frame.y.x * reach, host.position[1] - frame.y.y * reach, 0};
    return true;
  }

  // In line with an object that is there, at its left, right, front or back.
  bool put_beside(PlacedObject& placed) {
    const PlacedObject& other = random_.one_of(layout_.objects);
    if (other.mount != Mount::kFloor) return false;
    const int gap = random_.number(0, 8) * 100;
    const checks::Frame frame = checks::frame_at(other.rotation_deg);
    const bool sideways = random_.chance(60);
    const double reach = (sideways ? other.size.width + placed.size.width : other.size.depth + placed.size.depth) / 2.0 + gap;
    const checks::Vec2d way = (sideways ? frame.x : frame.y) * (random_.chance(50) ? reach : -reach);
    placed.rotation_deg = other.rotation_deg;
    placed.position = {other.position[0] + way.x, other.position[1] + way.y, 0};
    return true;
  }

  bool plant(const CatalogEntry& entry, const std::function<bool(PlacedObject&)>& put = {}) {
    const SceneObject object = object_of(entry);
    PlacedObject placed;
    placed.id = object.id, placed.category = object.category, placed.name = object.name;
    placed.size = object.size->usual, placed.mount = entry.mount, placed.used_sides = entry.used_sides;
    placed.spaces = spaces_at(entry, placed.size);
    std::optional<Relation> support;
    if (put && !put(placed)) return false;
    if (!put) switch (entry.mount) {
        case Mount::kFloor: put_on_floor(placed, entry); break;
        case Mount::kCeiling:
          put_on_floor(placed, entry);
          placed.position[2] = layout_.room.height - placed.size.height;
          placed.supported_by = "ceiling";
          break;
        case Mount::kWall:
          if (!put_on_wall(placed)) return false;
          support = relation_of(RelationType::kOnWall, placed.id, placed.supported_by);
          break;
        case Mount::kSurface:
          if (!put_on_host(placed)) return false;
          support = relation_of(stands_inside(placed) ? RelationType::kIn : RelationType::kOn, placed.id, placed.supported_by);
          break;
        case Mount::kHung: return false;
      }
    layout_.objects.push_back(placed);
    if (!possible()) {
      layout_.objects.pop_back();
      return false;
    }
    scene_.objects.push_back(object);
    if (support) scene_.relations.push_back(*support);
    return true;
  }

  static bool across(double rotation) { return rotation == 90 || rotation == 270; }

  Mm width_of_room() const {
    return largest([](Point p) { return p.x; });
  }
  Mm depth_of_room() const {
    return largest([](Point p) { return p.y; });
  }
  template <class Key>
  Mm largest(Key key) const {
    Mm most = 0;
    for (const Point p : layout_.room.polygon) most = std::max(most, key(p));
    return most;
  }

  // A place of the 1 cm grid at which a length fits into [0, whole], as a middle.
  double middle_within(Mm length, Mm whole) { return length / 2.0 + 10.0 * random_.number(0, std::max(0, (whole - length) / 10)); }

  void put_on_floor(PlacedObject& placed, const CatalogEntry& entry) {
    placed.rotation_deg = random_.number(0, 3) * 90;
    if (!layout_.objects.empty() && random_.chance(40) && put_beside(placed)) return;
    if (entry.back_to_wall || random_.chance(30)) {
      if (put_on_wall(placed)) placed.supported_by = "floor", placed.position[2] = 0;
      return;
    }
    const bool turned = across(placed.rotation_deg);
    placed.position = {middle_within(turned ? placed.size.depth : placed.size.width, width_of_room()),
                       middle_within(turned ? placed.size.width : placed.size.depth, depth_of_room()), 0};
  }

  bool put_on_wall(PlacedObject& placed) {
    const Wall& wall = random_.one_of(layout_.room.walls);
    const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::hypot(dx, dy);
    if (length < placed.size.width) return false;
    const double along = middle_within(placed.size.width, static_cast<Mm>(length)), in = placed.size.depth / 2.0;
    const double ux = dx / length, uy = dy / length;
    placed.position = {wall.start.x + ux * along - uy * in, wall.start.y + uy * along + ux * in,
                       10.0 * random_.number(90, std::max(90, (layout_.room.height - placed.size.height) / 10))};
    // Its back looks out of the room, which lies on the wall's left: out is (uy, −ux), and the back of an unturned object (0, 1).
    placed.rotation_deg = normalized_degrees(std::round(std::atan2(-uy, -ux) * 180 / kPi));
    placed.supported_by = wall.id;
    return placed.mount != Mount::kWall || !before_opening(placed, wall);
  }

  bool before_opening(const PlacedObject& placed, const Wall& wall) const {
    const double at = std::hypot(placed.position[0] - wall.start.x, placed.position[1] - wall.start.y);
    return std::any_of(layout_.room.openings.begin(), layout_.room.openings.end(), [&](const Opening& opening) {
      return opening.wall == wall.id && at + placed.size.width > *opening.offset &&
             at - placed.size.width < *opening.offset + opening.width;
    });
  }

  bool put_on_host(PlacedObject& placed) {
    if (layout_.objects.empty()) return false;
    const PlacedObject host = random_.one_of(layout_.objects);
    if (host.mount != Mount::kFloor) return false;
    // The floor it gets, in the host's frame: its top, or the floor of one of its spaces.
    Space floor{"",
                {-host.size.width / 2.0, -host.size.depth / 2.0, 0.0 + host.size.height},
                {host.size.width / 2.0, host.size.depth / 2.0, 1e6},
                true};
    if (!host.spaces.empty() && random_.chance(60))
      floor = random_.one_of(host.spaces);
    else if (!Catalog::builtin().entry_or_nearest(host.category).top_carries)
      return false;
    const Mm width = static_cast<Mm>(floor.max[0] - floor.min[0]), depth = static_cast<Mm>(floor.max[1] - floor.min[1]);
    if (!floor.carries || placed.size.width > width || placed.size.depth > depth || placed.size.height > floor.max[2] - floor.min[2])
      return false;
    const double x = middle_within(placed.size.width, width) + floor.min[0], y = middle_within(placed.size.depth, depth) + floor.min[1];
    const checks::Frame frame = checks::frame_at(host.rotation_deg);
    placed.rotation_deg = host.rotation_deg;
    placed.position = {host.position[0] + frame.x.x * x + frame.y.x * y, host.position[1] + frame.x.y * x + frame.y.y * y,
                       host.position[2] + floor.min[2]};
    placed.supported_by = host.id;
    return true;
  }

  // Stands in a space of its host rather than on its top.
  bool stands_inside(const PlacedObject& placed) const {
    const PlacedObject* host = layout_.find_object(placed.supported_by);
    return host != nullptr && placed.position[2] < host->position[2] + host->size.height &&
           placed.position[2] + placed.size.height / 2.0 <= host->position[2] + host->size.height;
  }

  // On what one lies or kneels nothing stands, thin as it is: the solver keeps that free.
  bool lies_free() const {
    const auto half = [](const PlacedObject& o, int axis) {
      const bool turned = static_cast<int>(o.rotation_deg) % 180 == 90;
      return ((axis == 0) != turned ? o.size.width : o.size.depth) / 2.0;
    };
    const auto over = [&](const PlacedObject& one, const PlacedObject& other, int axis) {
      const auto at = static_cast<std::size_t>(axis);
      return std::abs(one.position[at] - other.position[at]) < half(one, axis) + half(other, axis);
    };
    return std::ranges::all_of(layout_.objects, [&](const PlacedObject& mat) {
      if (!Catalog::builtin().entry_or_nearest(mat.category).lain_on) return true;
      return std::ranges::none_of(layout_.objects, [&](const PlacedObject& other) {
        const bool stands = other.id != mat.id && other.mount == Mount::kFloor && other.supported_by == "floor";
        return stands && over(mat, other, 0) && over(mat, other, 1);
      });
    });
  }

  // Nothing overlaps, stands in the air, reaches out of the room or stands before an opening.
  bool possible() const {
    if (!lies_free()) return false;
    VerifyOptions strict;
    strict.collision_tolerance_m = strict.support_tolerance_m = 0;
    const checks::RoomView view(layout_, Catalog::builtin(), strict);
    Report report;
    checks::check_collisions(view, report);
    checks::check_bounds(view, report);
    checks::check_support(view, report);
    checks::check_openings(view, report);
    return std::all_of(report.checks.begin(), report.checks.end(),
                       [](const Check& check) { return check.passed && !(check.name == "outOfBounds" && check.value > 1e-9); });
  }

  // ---- relations

  static Relation relation_of(RelationType type, const std::string& target, const std::string& reference) {
    Relation relation;
    relation.id = "s" + target;
    relation.type = type, relation.targets = {target}, relation.references = {reference};
    return relation;
  }

  std::string draw_reference(unsigned kinds) {
    for (int attempt = 0; attempt < 8; ++attempt) {
      const unsigned kind = 1u << random_.number(0, 3);
      if (!(kinds & kind)) continue;
      if (kind == kObject && !scene_.objects.empty()) return random_.one_of(scene_.objects).id;
      if (kind == kWall) return random_.one_of(scene_.room.walls).id;
      if (kind == kOpening && !scene_.room.openings.empty()) return random_.one_of(scene_.room.openings).id;
      if (kind == kRoom) return "room";
    }
    return scene_.objects.empty() ? "room" : random_.one_of(scene_.objects).id;
  }

  Relation draw_relation(int number) {
    const RelationRow& row = random_.one_of(relation_table());
    Relation relation;
    relation.id = "c" + std::to_string(number);
    relation.type = row.type;
    relation.hard = random_.chance(80);
    const bool group = row.group == RelationGroup::kGroupGroup && row.type != RelationType::kBetween;
    const bool several = group || row.type == RelationType::kGroupAlign || row.type == RelationType::kStacked || random_.chance(10);
    draw_targets(relation, several ? random_.number(2, 4) : 1);
    int references = row.arity == RelationArity::kNone   ? 0
                     : row.arity == RelationArity::kOne  ? 1
                     : row.arity == RelationArity::kMany ? 1
                                                         : random_.number(0, 1);
    if (row.type == RelationType::kBetween || row.type == RelationType::kPairedWith) references = 2;
    for (int i = 0; i < references; ++i) draw_other_reference(relation, row.reference_kinds);
    draw_parameters(relation, row.parameters);
    return relation;
  }

  void draw_targets(Relation& relation, int count) {
    for (int i = 0; i < count && !scene_.objects.empty(); ++i) {
      const std::string& id = random_.one_of(scene_.objects).id;
      if (std::find(relation.targets.begin(), relation.targets.end(), id) == relation.targets.end()) relation.targets.push_back(id);
    }
  }

  void draw_other_reference(Relation& relation, unsigned kinds) {
    for (int attempt = 0; attempt < 8; ++attempt) {
      const std::string id = draw_reference(kinds);
      const auto in = [&](const std::vector<std::string>& ids) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
      if (in(relation.targets) || in(relation.references)) continue;
      relation.references.push_back(id);
      return;
    }
  }

  void draw_parameters(Relation& relation, std::string_view names) {
    RelationParameters& p = relation.parameters;
    const auto reads = [&](std::string_view name) {
      const std::size_t at = names.find(name);
      return at != std::string_view::npos && random_.chance(50);
    };
    if (reads("axis")) p.axis = random_.chance(50) ? Axis::kX : Axis::kY;
    if (reads("max")) p.max = random_.number(1, 30) * 100;
    if (reads("min")) p.min = random_.number(0, p.max ? *p.max / 100 : 20) * 100;
    if (reads("distance")) p.distance = random_.number(0, 15) * 100;
    if (reads("gap")) p.gap = random_.number(0, 5) * 100;
    if (reads("depth")) p.depth = random_.number(3, 9) * 100;
    if (reads("width")) p.width = random_.number(5, 9) * 100;
    if (reads("height")) p.height = random_.number(9, 18) * 100;
    if (reads("side")) p.side = random_.one_of(std::array{Side::kFront, Side::kLeft, Side::kRight, Side::kBack, Side::kLong, Side::kShort});
    if (reads("part")) {
      using enum PartWord;
      p.part =
          random_.one_of(std::array<ThingPart, 9>{kLeft, kRight, kFront, kBack, kCenter, kCorner, kEdge, kEnd, ThingPart{kLeft, kCorner}});
    }
    if (reads("edge")) p.edge = random_.one_of(edges_of(relation.type));
    if (names.find("region") != std::string_view::npos) p.region = static_cast<RoomRegion>(random_.number(0, 8));
    if (reads("columns")) p.columns = random_.number(1, 3);
  }

  // Figures that chance would hardly meet are read from the planted layout.
  void fit_parameters(Relation& relation, const checks::RoomView& view) const {
    const checks::Body* t = view.find_body(relation.targets.front());
    if (relation.type == RelationType::kOnWall) relation.parameters.height = mm_from_m(t->underside());
    if (relation.references.empty()) return;
    const checks::Body* r = view.find_body(relation.references.front());
    if (r == nullptr) return;
    if (relation.type == RelationType::kOffset && relation.parameters.axis) {
      const checks::Vec2d axis = *relation.parameters.axis == Axis::kX ? checks::Vec2d{1, 0} : checks::Vec2d{0, 1};
      relation.parameters.distance =
          std::max(0, mm_from_m(-checks::overlap(checks::extent(t->shape, axis), checks::extent(r->shape, axis))));
    }
    if (relation.type == RelationType::kDistance) {
      const Mm gap = mm_from_m(checks::gap(t->shape, r->shape));
      relation.parameters.min = std::max(0, gap - 200), relation.parameters.max = gap + 100;
    }
    if (relation.type == RelationType::kAbove) relation.parameters.gap.reset();
  }

  // Nobody says of a table that it stands around the cup on it, or of the cup that it stands around the table; the solver looks for a
  // ring outside of what it is around.
  bool surrounds_host_or_load(const Relation& relation) const {
    if ((relation.type != RelationType::kSurround && relation.type != RelationType::kAround) || relation.references.size() != 1)
      return false;
    const auto stands_on = [&](const std::string& load, const std::string& host) {
      const PlacedObject* placed = layout_.find_object(load);
      return placed != nullptr && placed->supported_by == host;
    };
    const std::string& middle = relation.references[0];
    return std::ranges::any_of(relation.targets, [&](const auto& t) { return stands_on(middle, t) || stands_on(t, middle); });
  }

  // Draws relations until enough of them hold in the planted layout, without any slack.
  void read_relations(int wanted) {
    if (scene_.objects.empty()) return;
    VerifyOptions strict;
    strict.relation_slack_m = 0;
    const checks::RoomView view(layout_, Catalog::builtin(), strict);
    Layout drawn = layout_;
    for (int i = 0; i < 60 * wanted; ++i) {
      Relation relation = draw_relation(i);
      if (relation.targets.empty() || (relation.type == RelationType::kReachable && !random_.chance(5))) continue;
      fit_parameters(relation, view);
      drawn.relations.push_back({relation, false});
    }
    const checks::RoomView with_relations(drawn, Catalog::builtin(), strict);
    Report report;
    checks::check_relations(with_relations, report);
    std::vector<int> of_type(relation_table().size(), 0);
    for (std::size_t i = 0; i < drawn.relations.size() && wanted > 0; ++i) {
      const Relation& relation = drawn.relations[i].relation;
      int& used = of_type[static_cast<std::size_t>(relation.type)];
      if (!report.checks[i].passed || used >= 2 || surrounds_host_or_load(relation)) continue;
      ++used, --wanted;
      scene_.relations.push_back(relation);
    }
    keep_those_that_hold();
  }

  // What belongs to what depends on the relations themselves: look once more with those that were taken.
  void keep_those_that_hold() {
    VerifyOptions strict;
    strict.relation_slack_m = 0;
    for (bool all = false; !all;) {
      layout_.relations.clear();
      for (const Relation& relation : scene_.relations) layout_.relations.push_back({relation, true});
      Report report;
      checks::check_relations(checks::RoomView(layout_, Catalog::builtin(), strict), report);
      std::size_t i = 0;
      all = std::erase_if(scene_.relations, [&](const Relation&) { return !report.checks[i++].passed; }) == 0;
    }
  }

  SceneOptions options_;
  Random random_;
  SceneGraph scene_;
  Layout layout_;
};

}  // namespace

Scene make_scene(const SceneOptions& options) { return Maker(options).make(); }

}  // namespace layoutbox::synthetic
