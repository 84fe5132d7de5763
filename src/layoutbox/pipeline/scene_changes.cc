#include "layoutbox/pipeline/scene_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;

std::string object_name(const SceneObject& object) {
  std::string words = object.name.empty() ? object.category : object.name;
  std::ranges::replace(words, '_', ' ');
  return fmt::format("the {} ({})", words, object.id);
}

std::string side_word(const SceneGraph& scene, const Wall& wall) {
  for (const Side side : {Side::kFront, Side::kRight, Side::kBack, Side::kLeft}) {
    if (wall_on_side(scene.room.walls, side) == &wall) return fmt::format("the {} wall ({})", name_of(side), wall.id);
  }
  return wall.id;
}

Json replace(const std::string& path, Json value) { return {{"op", "replace"}, {"path", path}, {"value", std::move(value)}}; }
Json add(const std::string& path, Json value) { return {{"op", "add"}, {"path", path}, {"value", std::move(value)}}; }
Json remove(const std::string& path) { return {{"op", "remove"}, {"path", path}}; }

// From (0, 0) round, as a room that has only its size.
bool is_rectangle(const std::vector<Point>& polygon) {
  return polygon.size() == 4 && polygon == std::vector<Point>{{0, 0}, {polygon[2].x, 0}, polygon[2], {0, polygon[2].y}};
}

// Changes to one scene that may settle its conflicts, the least first.
class Proposer {
 public:
  explicit Proposer(const Unsettled& unsettled)
      : document_(unsettled.document),
        scene_(unsettled.scene),
        layout_(unsettled.layout),
        catalog_(unsettled.catalog),
        room_may_grow_(unsettled.room_may_grow) {}

  std::vector<SceneChange> run() {
    collect();
    for (auto it = relations_.rbegin(); it != relations_.rend(); ++it) other_walls(**it);  // what was said last gives way first
    for (auto it = relations_.rbegin(); it != relations_.rend(); ++it) other_sides(**it);
    if (sizes_matter()) {
      for (const double share : {0.8, 0.6}) {
        for (const SceneObject* object : objects_) smaller(*object, share);
      }
    }
    for (auto it = relations_.rbegin(); it != relations_.rend(); ++it) looser(**it);
    if (room_may_grow_ && sizes_matter()) larger_room();
    for (auto it = relations_.rbegin(); it != relations_.rend(); ++it) dropped(**it);
    left_out();
    return std::move(changes_);
  }

 private:
  // What takes part in the conflicts and what was given up.
  void collect() {
    std::set<std::string> names;
    for (const Conflict& conflict : layout_.conflicts) {
      names.insert(conflict.relations.begin(), conflict.relations.end());
      names.insert(conflict.objects.begin(), conflict.objects.end());
    }
    for (const Relaxation& relaxation : layout_.relaxed) names.insert(relaxation.relation);
    for (const Relation& relation : scene_.relations) {
      if (names.contains(relation.id) && index_of("constraints", relation.id) >= 0) {
        relations_.push_back(&relation);
        names.insert(relation.targets.begin(), relation.targets.end());
      }
    }
    for (const SceneObject& object : scene_.objects) {
      if (names.contains(object.id) && index_of("furniture", object.id) >= 0) objects_.push_back(&object);
    }
    std::ranges::stable_sort(objects_, [](const SceneObject* a, const SceneObject* b) { return area(*a) > area(*b); });
  }

  // Where relations of things to one another contradict each other, no size helps.
  bool sizes_matter() const {
    return relations_.empty() || std::ranges::any_of(layout_.conflicts, [](const Conflict& c) { return !c.objects.empty(); }) ||
           std::ranges::any_of(relations_, [](const Relation* r) { return relation_row(r->type).group == RelationGroup::kRoomGroup; });
  }

  static std::int64_t area(const SceneObject& object) {
    return object.size ? std::int64_t{object.size->usual.width} * object.size->usual.depth : 0;
  }

  int index_of(const char* list, std::string_view id) const {
    if (!document_.contains(list)) return -1;
    int index = 0;
    for (const Json& item : document_[list]) {
      if (item.value("id", "") == id) return index;
      ++index;
    }
    return -1;
  }

  std::string path_of(const Relation& relation) const { return fmt::format("/constraints/{}", index_of("constraints", relation.id)); }

  std::string target_words(const Relation& relation) const {
    const SceneObject* object = relation.targets.empty() ? nullptr : scene_.find_object(relation.targets[0]);
    return object != nullptr ? object_name(*object) : "it";
  }

  void propose(std::string sentence, std::string subject, Json patch) {
    changes_.push_back({std::move(sentence), std::move(subject), std::move(patch)});
  }

  Json set_member(const Relation& relation, const char* key, Json value) const {
    const Json& written = document_["constraints"][static_cast<std::size_t>(index_of("constraints", relation.id))];
    const std::string path = path_of(relation) + "/" + key;
    return written.contains(key) ? replace(path, std::move(value)) : add(path, std::move(value));
  }

  void other_walls(const Relation& relation) {
    const RelationRow& row = relation_row(relation.type);
    if (row.group != RelationGroup::kRoomGroup || (row.reference_kinds & kWall) == 0 || relation.references.empty()) return;
    for (const Wall& wall : scene_.room.walls) {
      if (std::ranges::find(relation.references, wall.id) != relation.references.end()) continue;
      propose(fmt::format("put {} at {} instead", target_words(relation), side_word(scene_, wall)), "wall " + relation.id,
              Json::array({set_member(relation, "relativeTo", wall.id)}));
    }
  }

  // Does another relation say this already, with the type it would have, or seen from the other thing? Then the change only takes back
  // what contradicts that, and to leave it away is said further down.
  bool is_said(const Relation& relation, RelationType type) const {
    const auto inverse = traits_of(type).inverse;
    return std::ranges::any_of(scene_.relations, [&](const Relation& other) {
      if (other.id == relation.id) return false;
      const bool same = other.type == type && other.targets == relation.targets && other.references == relation.references;
      return same || (inverse && other.type == *inverse && other.targets == relation.references && other.references == relation.targets);
    });
  }

  // The other side of the same thing; then merely near it.
  void other_sides(const Relation& relation) {
    const auto to = traits_of(relation.type).instead;
    if (!to || is_said(relation, *to)) return;
    propose(fmt::format("let {} be {} instead of {}", target_words(relation), relation_row(*to).name, relation_row(relation.type).name),
            "side " + relation.id, Json::array({replace(path_of(relation) + "/type", relation_row(*to).name)}));
  }

  // Not below what the catalogue knows of such a thing.
  void smaller(const SceneObject& object, double share) {
    if (!object.size) return;
    const CatalogEntry& entry = catalog_.entry_or_nearest(object.category);
    if (!entry.article.empty() || object.fixed) return;  // the user's own have the size they have
    const Size& now = object.size->usual;
    const auto shrunk = [&](Mm side, Mm least) { return std::min(side, std::max(static_cast<Mm>(side * share) / 10 * 10, least)); };
    const Size to{shrunk(now.width, entry.size.least.width), shrunk(now.depth, entry.size.least.depth), now.height};
    if (to.width == now.width && to.depth == now.depth) return;
    const int index = index_of("furniture", object.id);
    const Json dims{{"w", m_from_mm(to.width)}, {"d", m_from_mm(to.depth)}, {"h", m_from_mm(to.height)}};
    Json patch = Json::array({add(fmt::format("/furniture/{}/dims", index), dims)});
    propose(fmt::format("make {} {:.2f} x {:.2f} m instead of {:.2f} x {:.2f} m", object_name(object), m_from_mm(to.width),
                        m_from_mm(to.depth), m_from_mm(now.width), m_from_mm(now.depth)),
            "size " + object.id, std::move(patch));
  }

  void looser(const Relation& relation) {
    if (!relation.hard) return;
    propose(fmt::format("make {} a wish only (hard: false): {}", relation.id, words_of_relation(relation)), "wish " + relation.id,
            Json::array({set_member(relation, "hard", false)}));
  }

  void dropped(const Relation& relation) {
    propose(fmt::format("leave {} away: {}", relation.id, words_of_relation(relation)), "drop " + relation.id,
            Json::array({remove(path_of(relation))}));
  }

  std::string words_of_relation(const Relation& relation) const {
    return fmt::format("{} {} {}", fmt::join(relation.targets, ", "), relation_row(relation.type).name,
                       fmt::join(relation.references, ", "));
  }

  void larger_room() {
    if (!is_rectangle(scene_.room.polygon) || !document_.contains("room")) return;
    const Point far = scene_.room.polygon[2];
    for (const double more : {0.5, 1.0, 2.0}) {
      const double w = m_from_mm(far.x) + more, d = m_from_mm(far.y) + more;
      Json dims{{"w", w}, {"d", d}};
      if (scene_.room.height > 0) dims["h"] = m_from_mm(scene_.room.height);
      Json patch = Json::array({add("/room/dims", std::move(dims))});
      for (const std::string key : {"polygon", "walls"}) {
        if (document_["room"].contains(key)) patch.push_back(remove("/room/" + key));
      }
      propose(fmt::format("make the room {:g} x {:g} m", w, d), "room", std::move(patch));
    }
  }

  // The smallest of the things that take part, of several of one kind the last; with what speaks of it.
  void left_out() {
    for (auto it = objects_.rbegin(); it != objects_.rend(); ++it) {
      const SceneObject& object = **it;
      Json patch = Json::array();
      if (document_.contains("constraints")) {
        for (std::size_t i = document_["constraints"].size(); i-- > 0;) {
          const std::string path = fmt::format("/constraints/{}", i);
          for (const char* key : {"relativeTo", "targets"}) take_out(document_["constraints"][i], key, path, object.id, patch);
        }
      }
      patch.push_back(remove(fmt::format("/furniture/{}", index_of("furniture", object.id))));
      propose(fmt::format("leave out {}", object_name(object)), "object " + object.category, std::move(patch));
    }
  }

  // An id out of a list of a relation; the relation with it where nothing else is left there.
  static void take_out(const Json& relation, const char* key, const std::string& path, const std::string& id, Json& patch) {
    if (!relation.contains(key) || (!patch.empty() && patch.back() == remove(path))) return;
    const Json& value = relation[key];
    const bool alone = value == id || (value.is_array() && value.size() == 1 && value[0] == id);
    if (alone) {
      patch.push_back(remove(path));
      return;
    }
    if (!value.is_array()) return;
    Json rest = Json::array();
    std::ranges::copy_if(value, std::back_inserter(rest), [&](const Json& one) { return one != id; });
    if (rest.size() < value.size()) patch.push_back(replace(path + "/" + key, std::move(rest)));
  }

  const Json& document_;
  const SceneGraph& scene_;
  const Layout& layout_;
  const Catalog& catalog_;
  bool room_may_grow_;
  std::vector<const Relation*> relations_;
  std::vector<const SceneObject*> objects_;
  std::vector<SceneChange> changes_;
};

}  // namespace

std::vector<SceneChange> propose_changes(const Unsettled& unsettled) { return Proposer(unsettled).run(); }

}  // namespace layoutbox
