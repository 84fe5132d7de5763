// A scene that gets more than its text names. What is there is known by id and by kind, so that asking takes no longer where much is.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

class Spoken;

class GrowingScene {
 public:
  // `sized`: the same scene with all sizes filled in. REQUIRES: they and the catalogue outlive it; nobody else adds to the scene.
  GrowingScene(SceneGraph& scene, const SceneGraph& sized, const Catalog& catalog);

  const SceneGraph& graph() const { return scene_; }
  const Room& sized_room() const { return sized_.room; }
  // Null: there is no such thing; it has come since.
  const SceneObject* find(const std::string& id) const;
  const SceneObject* sized(const std::string& id) const;

  bool has_kind(const std::string& kind) const;
  // Is a seat placed by it: a chair, a bench, cushions on the floor? Not a visitor's: who works there sits behind.
  bool has_seat(const std::string& table) const { return with_seat_.contains(table); }
  // The relations that place it, by their number.
  const std::vector<std::size_t>& relations_of(const std::string& id) const;

  // Adds a thing of that kind; its id.
  std::string add(const CatalogEntry& kind);
  void relate(RelationType type, std::vector<std::string> targets, const std::string& reference, std::optional<Mm> max = {});

 private:
  void note(std::size_t relation);

  SceneGraph& scene_;
  const SceneGraph& sized_;
  const Catalog& catalog_;
  std::unordered_map<std::string, std::size_t> by_id_, sized_by_id_;
  std::unordered_map<std::string, std::vector<std::size_t>> relations_of_;
  std::unordered_set<std::string> with_seat_;
  std::set<std::string> kinds_;
  std::map<std::string, int> last_number_;  // of ids, by kind
  int relations_ = 0;                       // that were added
};

// Furniture that takes up floor.
bool stands_on_floor(const Catalog& catalog, const SceneObject& object);

// What a bare room of its kind mostly has, the most important first. `named`: so many of its things are the text's.
void fill_bare_room(GrowingScene& scene, const Spoken& spoken, std::size_t named, const Catalog& catalog);

}  // namespace layoutbox
