#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/llm/mend.h"
#include "layoutbox/plan/llm/mend_text.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

// Names that models give to relations, beside those that differ in case and separators only.
struct Alias {
  const char *name, *type;
};
constexpr Alias kAliases[] = {{"beside", "nextTo"},
                              {"adjacent", "nextTo"},
                              {"adjacentTo", "nextTo"},
                              {"closeTo", "near"},
                              {"onTopOf", "on"},
                              {"onTop", "on"},
                              {"placedOn", "on"},
                              {"below", "under"},
                              {"beneath", "under"},
                              {"underneath", "under"},
                              {"over", "above"},
                              {"hangingAbove", "above"},
                              {"faces", "facing"},
                              {"lookAt", "facing"},
                              {"faceTo", "facing"},
                              {"againstTheWall", "againstWall"},
                              {"flushWall", "againstWall"},
                              {"wallAligned", "againstWall"},
                              {"inCorner", "corner"},
                              {"center", "centerOfRoom"},
                              {"centered", "centerOfRoom"},
                              {"middleOfRoom", "centerOfRoom"},
                              {"left", "leftOf"},
                              {"right", "rightOf"},
                              {"toTheLeftOf", "leftOf"},
                              {"toTheRightOf", "rightOf"},
                              {"front", "inFrontOf"},
                              {"back", "behind"},
                              {"hangsFromCeiling", "onCeiling"},
                              {"mountedOnWall", "onWall"},
                              {"hangsOnWall", "onWall"},
                              {"farFrom", "far"},
                              {"acrossFrom", "opposite"},
                              {"betweenObjects", "between"},
                              {"surrounds", "around"},
                              {"flanking", "eachSideOf"},
                              {"touches", "touching"},
                              {"insideOf", "in"}};

// "bed_1" → "bed"
std::string stem_of(std::string_view id) {
  while (!id.empty() && ((id.back() >= '0' && id.back() <= '9') || id.back() == '_' || id.back() == '-' || id.back() == ' '))
    id.remove_suffix(1);
  return key_of(id);
}

class RelationMender {
 public:
  RelationMender(json& scene, Notes& notes) : scene_(scene), notes_(notes) {
    for (const json& object : scene_["furniture"]) {
      if (object.is_object()) objects_.push_back({text_of(object, "id"), text_of(object, "category"), text_of(object, "name")});
    }
    if (!scene_.contains("room") || !scene_["room"].is_object()) return;
    for (const char* list : {"walls", "openings"}) {
      if (!scene_["room"].contains(list) || !scene_["room"][list].is_array()) continue;
      for (const json& part : scene_["room"][list]) {
        if (part.is_object()) parts_.push_back({text_of(part, "id"), std::string(list) == "walls" ? "wall" : text_of(part, "type"), {}});
      }
    }
  }

  void run() {
    json& relations = scene_["constraints"];
    std::set<std::string> seen, ids;
    json kept = json::array();
    for (std::size_t i = 0; i < relations.size(); ++i) {
      json& relation = relations[i];
      const std::string at = fmt::format("/constraints/{}", i);
      if (!relation.is_object()) {
        note(notes_, "something that is no relation is left out", at);
        continue;
      }
      if (!mend_one(relation, at)) continue;
      json same = relation;
      for (const char* key : {"id", "why"}) same.erase(key);
      if (!seen.insert(same.dump()).second) {
        note(notes_, "the same relation is said twice", at);
        continue;
      }
      settle_id(relation, ids, i);
      kept.push_back(std::move(relation));
    }
    relations = std::move(kept);
  }

 private:
  struct Named {
    std::string id, category, name;
  };

  // False: nothing is left of it.
  bool mend_one(json& relation, const std::string& at) {
    const RelationRow* row = find_relation(text_of(relation, "type"));
    if (row == nullptr) return true;  // for the validator
    if (relation.contains("targets") && relation["targets"].is_array()) {
      for (json& target : relation["targets"]) mend_name(target, at + "/targets", true);
      drop_repeats(relation["targets"]);
    }
    if (!relation.contains("relativeTo")) return true;
    if (row->arity == RelationArity::kNone) {
      relation.erase("relativeTo");
      note(notes_, fmt::format("{} takes no relativeTo: it is left out", row->name), at);
      return true;
    }
    json list = relation["relativeTo"].is_array() ? relation["relativeTo"] : json::array({relation["relativeTo"]});
    for (json& reference : list) mend_name(reference, at + "/relativeTo", false);
    drop_repeats(list);
    if (row->arity == RelationArity::kOptional) drop_general_words(list, *row, at);
    return settle_references(relation, list, *row, at);
  }

  bool settle_references(json& relation, json& list, const RelationRow& row, const std::string& at) {
    const auto& targets = relation.value("targets", json::array());
    const std::size_t before = list.size();
    json others = json::array();
    for (const json& reference : list) {
      if (std::ranges::find(targets, reference) == targets.end()) others.push_back(reference);
    }
    if (others.size() < before) {
      note(notes_, "a thing has no relation to itself", at);
      if (others.empty() && row.arity != RelationArity::kOptional) return false;
    }
    if (others.empty()) {
      relation.erase("relativeTo");
      return true;
    }
    if ((row.arity == RelationArity::kOne) && others.size() > 1) {
      note(notes_, fmt::format("{} takes one relativeTo: the first is taken", row.name), at);
      others = json::array({others[0]});
    }
    relation["relativeTo"] = others.size() == 1 ? others[0] : others;
    return true;
  }

  // "wall", "any wall", "room" where a wall is meant: any.
  void drop_general_words(json& list, const RelationRow& row, const std::string& at) {
    json kept = json::array();
    for (const json& reference : list) {
      const std::string key = reference.is_string() ? key_of(reference.get<std::string>()) : "";
      const bool general =
          key == "wall" || key == "anywall" || key == "walls" || key == "any" || (key == "room" && (row.reference_kinds & kRoom) == 0) ||
          ((key == "window" || key == "door" || key == "anywindow") && (row.reference_kinds & kOpening) != 0 && exact(key) == nullptr);
      if (!general || exact(key) != nullptr) {
        kept.push_back(reference);
      } else {
        note(notes_, fmt::format("\"{}\" is read as any", reference.get<std::string>()), at);
      }
    }
    list = std::move(kept);
  }

  const std::string* exact(std::string_view name) const {
    for (const auto* list : {&objects_, &parts_}) {
      for (const Named& named : *list) {
        if (same_name(named.id, name)) return &named.id;
      }
    }
    return nullptr;
  }

  // The one thing that a name can mean: by its id, its name, its category, or its id without the number.
  void mend_name(json& value, const std::string& at, bool objects_only) {
    if (!value.is_string()) return;
    const std::string written = value.get<std::string>();
    if (exact(written) != nullptr) return;
    const SceneGraph& walls = default_walls();
    if (!objects_only && (walls.find_wall(written) != nullptr || written == "room" || written == "floor" || written == "ceiling")) return;
    std::string meant = only_match(objects_, written);
    if (meant.empty() && !objects_only) meant = only_match(parts_, written);
    if (meant.empty() && !objects_only) {
      if (const auto side = wall_word(written); !side.empty()) meant = side;
    }
    if (meant.empty()) return;
    note(notes_, fmt::format("\"{}\" is read as \"{}\"", written.substr(0, 40), meant), at);
    value = meant;
  }

  static std::string only_match(const std::vector<Named>& list, std::string_view written) {
    std::string found;
    for (const Named& named : list) {
      const std::string key = key_of(written);
      const bool fits = key == key_of(named.name) || key == key_of(named.category) || key == stem_of(named.id) ||
                        stem_of(written) == key_of(named.category) || stem_of(written) == stem_of(named.id);
      if (!fits) continue;
      if (!found.empty()) return {};  // it may mean several
      found = named.id;
    }
    return found;
  }

  // "north wall", "the back wall" → back
  static std::string wall_word(const std::string& written) {
    for (const std::string& word : words_of(written)) {
      if (const auto side = room_side_from_word(word)) return std::string(name_of(*side));
    }
    return {};
  }

  // The four walls of a room that names none.
  static const SceneGraph& default_walls() {
    static const SceneGraph scene = [] {
      SceneGraph made;
      const Point corners[] = {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
      for (int i = 0; i < 4; ++i) {
        Wall wall;
        wall.id = fmt::format("wall{}", i + 1);
        wall.start = corners[i], wall.end = corners[(i + 1) % 4];
        made.room.walls.push_back(wall);
      }
      return made;
    }();
    return scene;
  }

  static void drop_repeats(json& list) {
    json kept = json::array();
    for (const json& item : list) {
      if (std::ranges::find(kept, item) == kept.end()) kept.push_back(item);
    }
    list = std::move(kept);
  }

  static void settle_id(json& relation, std::set<std::string>& ids, std::size_t index) {
    std::string id = text_of(relation, "id");
    for (std::size_t number = index + 1; id.empty() || id.size() > 60 || ids.contains(id); ++number) id = fmt::format("c{}", number);
    ids.insert(id);
    relation["id"] = id;
  }

  json& scene_;
  Notes& notes_;
  std::vector<Named> objects_, parts_;
};

// Before the schema looks for the nearest of the right names.
void mend_types(json& scene, Notes& notes) {
  if (!scene.is_object() || !scene.contains("constraints") || !scene["constraints"].is_array()) return;
  std::size_t index = 0;
  for (json& relation : scene["constraints"]) {
    const std::string at = fmt::format("/constraints/{}/type", index++);
    const std::string written = relation.is_object() ? text_of(relation, "type") : std::string();
    if (written.empty() || find_relation(written) != nullptr) continue;
    const auto* const alias = std::ranges::find_if(kAliases, [&](const Alias& one) { return key_of(written) == key_of(one.name); });
    if (alias == std::end(kAliases)) continue;
    relation["type"] = alias->type;
    note(notes, fmt::format("the relation \"{}\" is read as \"{}\"", written.substr(0, 40), alias->type), at);
  }
}

}  // namespace

void mend_relations(json& scene, Notes& notes) {
  if (!scene.is_object() || !scene.contains("furniture") || !scene["furniture"].is_array()) return;
  if (scene.contains("constraints") && scene["constraints"].is_array()) RelationMender(scene, notes).run();
}

void mend_scene(json& scene, const Catalog& catalog, Notes& notes) {
  mend_form(scene, notes);
  mend_types(scene, notes);
  mend_edges_and_regions(scene, notes);
  mend_by_schema(scene, notes);
  mend_objects(scene, catalog, notes);
  mend_room(scene, notes);
  mend_relations(scene, notes);
  mend_parts(scene, catalog, notes);
}

}  // namespace layoutbox::llm
