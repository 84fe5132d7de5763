// Rooms furnished in groups, with the relations that prompts have.
#include <algorithm>
#include <map>
#include <string>

#include "room_parts.h"
#include "rooms.h"

namespace layoutbox::bench {
namespace {

constexpr double kMostOfWalls = 0.8;

// Adds groups of furniture until there are enough objects.
class Furnisher {
 public:
  Furnisher(int objects, std::uint64_t seed) : wanted_(static_cast<std::size_t>(objects)), random_(seed) {}

  SceneGraph make() {
    while (scene_.objects.size() < wanted_) {
      switch (random_.number(0, 6)) {
        case 0: sleep(); break;
        case 1: work(); break;
        case 2: sit(); break;
        case 3: dine(); break;
        case 4: keep("bookshelf", "book"); break;
        case 5: keep("dresser", "vase"); break;
        default: small(); break;
      }
    }
    const double area = covered_ / 0.35;
    const auto width = static_cast<Mm>(std::lround(std::max(3000.0, std::sqrt(area * random_.number(100, 150) / 100.0)) / 100)) * 100;
    const auto depth = static_cast<Mm>(std::lround(std::max(3000.0, area / width) / 100)) * 100;
    scene_.room.polygon = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
    scene_.room.height = 2700;
    leave_room_at_walls(2 * (width + depth));
    open("door1", OpeningType::kDoor, "wall1", width);
    open("window1", OpeningType::kWindow, "wall3", width);
    return normalised(std::move(scene_));
  }

 private:
  void open(const std::string& id, OpeningType type, const std::string& wall, Mm length) {
    Opening opening;
    opening.id = id, opening.type = type, opening.wall = wall;
    opening.width = type == OpeningType::kDoor ? 900 : 1200, opening.height = type == OpeningType::kDoor ? 2000 : 1200;
    opening.sill = type == OpeningType::kDoor ? 0 : 900;
    opening.offset = 10 * random_.number(10, (length - opening.width) / 10 - 10);
    scene_.room.openings.push_back(opening);
    scene_.room.openings_given = true;
  }

  std::string piece(const std::string& kind) {
    SceneObject& object = scene_.objects.emplace_back();
    object.category = object.name = kind;
    object.id = kind + "_" + std::to_string(scene_.objects.size());
    const CatalogEntry& entry = Catalog::builtin().entry_or_nearest(kind);
    if (entry.mount == Mount::kFloor && !entry.thin) covered_ += double(entry.size.usual.width) * entry.size.usual.depth;
    return object.id;
  }

  // Walls grow with the root of the number of things: of very many the later ones stand free.
  void leave_room_at_walls(Mm perimeter) {
    std::map<std::string, Mm> widths;
    for (const SceneObject& object : scene_.objects)
      widths[object.id] = Catalog::builtin().entry_or_nearest(object.category).size.usual.width;
    Mm taken = 0;
    std::erase_if(scene_.relations, [&](const Relation& r) {
      const bool at_wall = r.type == RelationType::kAgainstWall || r.type == RelationType::kCorner;
      if (!at_wall && r.type != RelationType::kEachSideOf) return false;
      Mm more = 0;
      for (const std::string& id : r.targets) more += widths[id];
      if (at_wall && taken + more > kMostOfWalls * perimeter) return true;
      taken += more;
      return false;
    });
  }

  void relate(RelationType type, std::vector<std::string> targets, const std::string& reference = {}) {
    add(scene_, type, std::move(targets), reference.empty() ? std::vector<std::string>{} : std::vector{reference});
  }

  void sleep() {
    const std::string bed = piece("bed"), left = piece("nightstand"), right = piece("nightstand");
    relate(RelationType::kAgainstWall, {bed});
    relate(RelationType::kEachSideOf, {left, right}, bed);
    relate(RelationType::kOn, {piece("table_lamp")}, left);
    relate(RelationType::kAgainstWall, {piece("wardrobe")});
  }
  void work() {
    const std::string desk = piece("desk");
    relate(RelationType::kAgainstWall, {desk});
    relate(RelationType::kTuckedUnder, {piece("chair")}, desk);
    relate(RelationType::kOn, {piece("monitor")}, desk);
  }
  void sit() {
    const std::string sofa = piece("sofa"), stand = piece("tv_stand"), table = piece("coffee_table");
    relate(RelationType::kAgainstWall, {stand});
    relate(RelationType::kFacing, {sofa}, stand);
    relate(RelationType::kInFrontOf, {table}, sofa);
    relate(RelationType::kOn, {piece("tv")}, stand);
    relate(RelationType::kNextTo, {piece("floor_lamp")}, sofa);
  }
  void dine() {
    const std::string table = piece("dining_table");
    std::vector<std::string> chairs;
    for (int i = 0; i < 4; ++i) chairs.push_back(piece("dining_chair"));
    relate(RelationType::kAround, chairs, table);
  }
  void keep(const std::string& kind, const std::string& thing) {
    const std::string host = piece(kind);
    relate(RelationType::kAgainstWall, {host});
    relate(RelationType::kOn, {piece(thing)}, host);
  }
  void small() {
    relate(RelationType::kCorner, {piece("plant")});
    piece("armchair");
  }

  std::size_t wanted_;
  Random random_;
  SceneGraph scene_;
  double covered_ = 0;
};

}  // namespace

SceneGraph furnished_scene(int objects, std::uint64_t seed) { return Furnisher(objects, seed).make(); }

}  // namespace layoutbox::bench
