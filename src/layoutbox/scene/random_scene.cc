#include "layoutbox/scene/random_scene.h"

#include "layoutbox/scene/shell.h"

namespace layoutbox {

std::string RandomScenes::text() {
  static const char* const kWords[] = {"oak", "a \"quoted\" word", "tab\there", "größe", "\\", "4 × 3", "", "line\nfeed", "plain"};
  return kWords[number(0, 8)];
}

std::vector<Space> RandomScenes::spaces() {
  std::vector<Space> spaces;
  for (int i = number(0, 3); i > 0; --i) spaces.push_back({"space " + std::to_string(i), place(900), place(900), coin()});
  return spaces;
}

std::vector<Side> RandomScenes::sides() {
  std::vector<Side> sides;
  for (int i = number(0, 3); i > 0; --i) sides.push_back(static_cast<Side>(number(0, 7)));
  return sides;
}

Room RandomScenes::room() {
  Room room;
  room.type = coin() ? "bedroom" : "";
  const Mm w = number(200, 900) * 10, d = number(200, 900) * 10;
  room.polygon = coin() ? std::vector<Point>{{0, 0}, {w, 0}, {w, d}, {0, d}}
                        : std::vector<Point>{{0, 0}, {w, 0}, {w, d / 2}, {w / 2, d / 2}, {w / 2, d}, {0, d}};
  room.height = number(2000, 4000);
  room.walls = walls_along(room.polygon);
  for (Wall& wall : room.walls) {
    wall.thickness = number(0, 300);
    wall.material = text();
  }
  room.openings_given = true;
  for (int i = number(0, 2); i > 0; --i) {
    Opening opening;
    opening.id = "opening" + std::to_string(i);
    opening.type = static_cast<OpeningType>(number(0, 2));
    opening.wall = "wall" + std::to_string(i);
    opening.offset = number(0, 50);
    opening.width = number(300, 900);
    opening.height = number(300, 1000);
    opening.sill = number(0, 900);
    opening.swing = opening.type == OpeningType::kDoor ? static_cast<Swing>(number(0, 5)) : Swing::kNone;
    if (opening.type == OpeningType::kWindow) opening.sill_depth = number(0, 400);
    if (coin()) opening.attributes = {"french", "red"};
    opening.origin = static_cast<Origin>(number(0, 3));
    room.openings.push_back(opening);
  }
  room.floor_material = text();
  room.ceiling_material = text();
  room.wall_material = text();
  return room;
}

SceneObject RandomScenes::object(int index) {
  SceneObject object;
  object.id = "object" + std::to_string(index);
  object.category = coin() ? "desk" : "odd thing";
  object.name = text();
  object.catalog_id = text();
  if (coin()) object.attributes = {"blue", "large"};
  if (coin()) {
    const Size usual = size();
    object.size = SizeRange{usual, usual, usual};
    if (coin()) object.size->greatest.width += 100;
    if (coin()) object.size->least.height -= 5;
    object.size_source = static_cast<SizeSource>(number(0, 3));
  }
  if (coin()) object.mount = static_cast<Mount>(number(0, 4));
  object.mount_assumed = object.mount && coin();
  if (coin()) object.used_sides = sides();
  object.spaces_given = coin();
  if (object.spaces_given) object.spaces = spaces();
  if (coin()) object.hint.position = place(4000);
  if (coin()) object.hint.rotation_deg = number(0, 3599) / 10.0;
  object.fixed = object.hint.position && coin();
  if (coin()) object.scale = {1, 2, 0.5};
  object.mesh = text();
  object.mesh_front = text();
  object.material = text();
  if (coin()) object.tags = {"a", "b"};
  object.origin = static_cast<Origin>(number(0, 3));
  return object;
}

PlacedObject RandomScenes::placed_object(int index) {
  PlacedObject object;
  object.id = "object" + std::to_string(index);
  object.category = "desk";
  object.name = text();
  object.catalog_id = text();
  if (coin()) object.attributes = {"blue", "large"};
  object.size = size();
  object.position = place(4000);
  object.rotation_deg = number(0, 3599) / 10.0;
  object.mount = static_cast<Mount>(number(0, 4));
  object.supported_by = index == 0 || coin() ? "floor" : "object0";
  object.used_sides = sides();
  object.spaces = spaces();
  object.origin = static_cast<Origin>(number(0, 3));
  object.mesh = text();
  object.mesh_front = text();
  object.material = text();
  object.fixed = coin();
  return object;
}

Relation RandomScenes::relation(int index, const std::vector<std::string>& objects) {
  Relation relation;
  relation.id = "c" + std::to_string(index);
  relation.type = relation_table()[static_cast<std::size_t>(number(0, static_cast<int>(relation_table().size()) - 1))].type;
  relation.targets = {objects.front()};
  relation.references = {"wall1"};
  if (coin()) relation.references.push_back("room");
  RelationParameters& p = relation.parameters;
  if (coin()) p.axis = static_cast<Axis>(number(0, 2));
  if (coin()) p.distance = number(-2000, 2000);
  if (coin()) p.min = number(0, 500);
  if (coin()) p.max = number(500, 2000);
  if (coin()) p.gap = number(0, 100);
  if (coin()) p.depth = number(0, 900);
  if (coin()) p.width = number(0, 900);
  if (coin()) p.height = number(0, 900);
  if (coin()) p.side = static_cast<Side>(number(0, 7));
  if (coin()) p.part = static_cast<PartWord>(number(0, 8));
  if (const std::vector<Edge> edges = edges_of(relation.type); !edges.empty() && coin())
    p.edge = edges[static_cast<std::size_t>(number(0, static_cast<int>(edges.size()) - 1))];
  if (coin()) p.region = static_cast<RoomRegion>(number(0, 8));
  if (coin()) p.columns = number(1, 9);
  relation.hard = coin();
  relation.weight = number(0, 200);
  relation.why = text();
  relation.origin = static_cast<Origin>(number(0, 3));
  return relation;
}

std::vector<Material> RandomScenes::materials() {
  std::vector<Material> materials;
  for (int i = number(0, 2); i > 0; --i) {
    Material material;
    material.id = "material" + std::to_string(i);
    if (coin()) material.color = Color{number(0, 100) / 100.0, 0.5, 1};
    material.texture = text();
    if (coin()) material.roughness = number(0, 100) / 100.0;
    if (coin()) material.uv_scale = {2, 0.25};
    materials.push_back(material);
  }
  return materials;
}

SceneGraph RandomScenes::scene() {
  SceneGraph scene;
  scene.prompt = text();
  scene.name = text();
  scene.project_id = text();
  scene.room = room();
  if (coin()) {
    scene.room.walls.clear();
    for (Opening& opening : scene.room.openings) opening.wall.clear();
  }
  std::vector<std::string> ids;
  for (int i = number(1, 5); i > 0; --i) {
    scene.objects.push_back(object(i));
    ids.push_back(scene.objects.back().id);
  }
  for (int i = number(0, 5); i > 0; --i) scene.relations.push_back(relation(i, ids));
  scene.materials = materials();
  if (coin()) scene.notes = {{"filled", "something", "/room"}, {"guessed", text(), ""}};
  return scene;
}

Layout RandomScenes::layout() {
  Layout layout;
  layout.prompt = text();
  layout.name = text();
  layout.status = static_cast<LayoutStatus>(number(0, 2));
  layout.room = room();
  std::vector<std::string> ids;
  for (int i = 0, count = number(1, 5); i < count; ++i) {
    layout.objects.push_back(placed_object(i));
    ids.push_back(layout.objects.back().id);
  }
  for (int i = number(0, 5); i > 0; --i) layout.relations.push_back({relation(i, ids), coin()});
  if (coin()) layout.relaxed = {{"c1", 0.12, "m", text()}, {"c2", 15, "", ""}};
  if (coin()) layout.gave_way = {{"free space before window1", 0.3, "m", text()}};
  if (coin()) layout.conflicts = {{{"c1", "c2"}, {ids.front()}, "They clash.", coin()}};
  layout.materials = materials();
  layout.score = number(0, 10000) / 10000.0;
  if (coin()) layout.score_terms = {{"walks", 0.5}, {"walls", 1}};
  layout.stats = {"search", static_cast<std::uint64_t>(number(0, 1000)), number(0, 9999) / 10000.0, coin(), coin()};
  return layout;
}

}  // namespace layoutbox
