#include "layoutbox/plan/llm/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/llm/evidence.h"
#include "layoutbox/scene/json_parts.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

constexpr Mm kSameLength = 15;

bool says_at_least(RelationType said, RelationType wanted) { return said == wanted || traits_of(wanted).said_by.has(said); }

class DraftComparison {
 public:
  DraftComparison(const Plan& plan, const Catalog& catalog, const Settling& settling, Draft& draft)
      : evidence_(plan, catalog),
        text_(plan.scene),
        catalog_(catalog),
        settling_(settling),
        draft_(draft),
        document_(json::parse(draft.document)) {}

  std::vector<std::string> run() {
    match_objects();
    compare_room();
    compare_openings();
    compare_objects();
    compare_surplus();
    compare_relations();
    if (changed_) take_over();
    for (const std::string& sentence : differences_) draft_.scene.notes.push_back({"text-differs", sentence, {}});
    return std::move(differences_);
  }

 private:
  void differ(std::string sentence) { differences_.push_back(std::move(sentence)); }

  // How well a thing of the scene is one of the text; 0: not at all.
  int likeness(const SceneObject& said, const SceneObject& made) const {
    const auto entry_of = [&](const SceneObject& object) {
      const CatalogEntry* entry = catalog_.find(object.category);
      return entry != nullptr                                     ? entry->id
             : catalog_.find_by_words(object.category) != nullptr ? catalog_.find_by_words(object.category)->id
                                                                  : object.category;
    };
    const std::string a = entry_of(said), b = entry_of(made);
    int points = a == b ? 4 : catalog_.is_a(b, a) ? 3 : catalog_.is_a(a, b) ? 2 : 0;
    if (points == 0 && key_of(said.name) == key_of(made.name)) points = 3;
    if (points == 0) return 0;
    const auto said_words = words_of(said.name), made_words = words_of(made.name);
    for (const std::string& word : said_words) points += std::ranges::find(made_words, word) != made_words.end();
    for (const std::string& word : said.attributes) points += std::ranges::find(made.attributes, word) != made.attributes.end();
    return points;
  }

  void match_objects() {
    struct Pair {
      int points;
      std::size_t said, made;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < text_.objects.size(); ++i) {
      for (std::size_t k = 0; k < draft_.scene.objects.size(); ++k) {
        if (const int points = likeness(text_.objects[i], draft_.scene.objects[k]); points > 0) pairs.push_back({points, i, k});
      }
    }
    std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) { return a.points > b.points; });
    std::set<std::size_t> taken;
    for (const Pair& pair : pairs) {
      const std::string& id = text_.objects[pair.said].id;
      if (ids_.contains(id) || !taken.insert(pair.made).second) continue;
      ids_[id] = draft_.scene.objects[pair.made].id;
    }
    for (std::size_t k = 0; k < draft_.scene.objects.size(); ++k) {
      if (!taken.contains(k)) surplus_.push_back(k);
    }
  }

  void compare_room() {
    const Room& said = text_.room;
    if (said.polygon.size() != 4 || !said.shape.empty()) return;
    const Point far = said.polygon[2];
    const auto& made = draft_.scene.room.polygon;
    // Which side is the width is not always said.
    const auto is = [&](Mm x, Mm y) { return std::abs(made[2].x - x) <= kSameLength && std::abs(made[2].y - y) <= kSameLength; };
    const bool same = made.size() == 4 && (is(far.x, far.y) || is(far.y, far.x));
    const bool same_height =
        said.height == 0 || draft_.scene.room.height == 0 || std::abs(said.height - draft_.scene.room.height) <= kSameLength;
    if (same && same_height) return;
    differ(fmt::format("the text's room is {:g} x {:g} m{}, the model's is not", m_from_mm(far.x), m_from_mm(far.y),
                       said.height > 0 ? fmt::format(" and {:g} m high", m_from_mm(said.height)) : ""));
    const bool larger = made.size() == 4 && made[2].x + kSameLength >= far.x && made[2].y + kSameLength >= far.y;
    const bool other_shape = made.size() > 4;  // it may have read of a niche
    if (!settling_.room || other_shape || (settling_.room_may_grow && larger)) return;
    json& room = document_["room"];
    for (const char* key : {"polygon", "height", "walls"}) room.erase(key);
    json dims = room.value("dims", json::object());
    dims["w"] = m_from_mm(far.x), dims["d"] = m_from_mm(far.y);
    if (said.height > 0) dims["h"] = m_from_mm(said.height);
    room["dims"] = std::move(dims);
    changed_ = true;
  }

  void compare_openings() {
    for (const OpeningType type : {OpeningType::kDoor, OpeningType::kWindow}) {
      std::vector<const Opening*> said;
      for (const Opening& opening : text_.room.openings) {
        if (opening.asked() && opening.type == type) said.push_back(&opening);
      }
      const auto made = std::ranges::count_if(draft_.scene.room.openings, [&](const Opening& o) { return o.type == type; });
      if (static_cast<std::size_t>(made) >= said.size()) continue;
      differ(fmt::format("the text has {} {}{}, the model's room {}", said.size(), name_of(type), said.size() > 1 ? "s" : "", made));
      if (!settling_.room || settling_.room_may_grow) continue;
      for (std::size_t i = static_cast<std::size_t>(made); i < said.size(); ++i) {
        json opening{{"id", unused(said[i]->id)},
                     {"type", name_of(type)},
                     {"w", m_from_mm(said[i]->width)},
                     {"h", m_from_mm(said[i]->height)},
                     {"sill", m_from_mm(said[i]->sill)}};
        if (!said[i]->wall.empty()) opening["wallId"] = said[i]->wall;
        document_["room"]["openings"].push_back(std::move(opening));
        changed_ = true;
      }
    }
  }

  // The model chose to leave it out, as it was asked to; not more than that takes.
  bool may_be_missing(const SceneObject& said) {
    if (!settling_.open.contains(said.category) || missing_ >= settling_.may_be_missing) return false;
    ++missing_;
    return true;
  }

  void compare_objects() {
    for (const SceneObject& said : text_.objects) {
      if (!said.asked()) continue;
      if (!ids_.contains(said.id)) {
        differ(fmt::format("the text names {} ({}), the model's scene has none for it", said.name, said.category));
        if (settling_.objects && evidence_.names(said) && !has_thing_of_its_own() && !may_be_missing(said)) add(said);
        continue;
      }
      compare_size(said, *draft_.scene.find_object(ids_[said.id]));
    }
  }

  // Something that nothing in the text is like: what the text names and the scene seems not to have may be that, under another name.
  bool has_thing_of_its_own() const {
    return std::ranges::any_of(surplus_, [&](std::size_t made) {
      return std::ranges::none_of(text_.objects, [&](const SceneObject& said) { return likeness(said, draft_.scene.objects[made]) > 0; });
    });
  }

  void add(const SceneObject& said) {
    json object{{"id", unused(said.id)}, {"category", said.category}, {"name", said.name}};
    if (!said.attributes.empty()) object["attributes"] = said.attributes;
    ids_[said.id] = object["id"].get<std::string>();
    set_size(said, object);
    document_["furniture"].push_back(std::move(object));
    changed_ = true;
  }

  // Sides that the text gives: those without a range.
  static void set_size(const SceneObject& said, json& object) {
    if (said.size_source != SizeSource::kUser || !said.size) return;
    const auto set = [&](const char* key, Mm Size::*side) {
      if (said.size->least.*side == said.size->greatest.*side && said.size->usual.*side > 0)
        object["dims"][key] = m_from_mm(said.size->usual.*side);
    };
    set("w", &Size::width), set("d", &Size::depth), set("h", &Size::height);
  }

  void compare_size(const SceneObject& said, const SceneObject& made) {
    if (said.size_source != SizeSource::kUser || !said.size) return;
    bool differs = false;
    for (const auto side : {&Size::width, &Size::depth, &Size::height}) {
      if (said.size->least.*side != said.size->greatest.*side || said.size->usual.*side == 0) continue;
      differs = differs || !made.size || std::abs(made.size->usual.*side - said.size->usual.*side) > kSameLength;
    }
    if (!differs) return;
    differ(fmt::format("the text gives the size of {}, the model's {} has another", said.name, made.id));
    const bool without = !made.size;
    if (!settling_.sizes_and_relations || !(without || evidence_.names(said))) return;
    for (json& object : document_["furniture"]) {
      if (object.value("id", "") == made.id) set_size(said, object);
    }
    changed_ = true;
  }

  // More of a kind than the text says; other things than it names are only listed.
  void compare_surplus() {
    std::set<std::string> gone;
    for (const std::size_t index : surplus_) {
      const SceneObject& made = draft_.scene.objects[index];
      std::string category;
      for (const SceneObject& said : text_.objects) {
        if (said.asked() && likeness(said, made) >= 3) category = said.category;
      }
      const auto count =
          static_cast<std::size_t>(std::ranges::count_if(text_.objects, [&](const SceneObject& o) { return o.category == category; }));
      if (category.empty() && std::ranges::none_of(text_.objects, &SceneObject::asked)) continue;  // the text leaves it to the planner
      if (category.empty()) {
        differ(fmt::format("the model adds {} ({}), which the text does not name", made.id, made.category));
      } else {
        differ(fmt::format("the text has {} of {}, the model adds {}", count, category, made.id));
        if (settling_.objects && evidence_.counts(category, count)) gone.insert(made.id);
      }
    }
    if (!gone.empty()) remove(gone);
  }

  void remove(const std::set<std::string>& gone) {
    const auto is_gone = [&](const json& id) { return id.is_string() && gone.contains(id.get<std::string>()); };
    auto& furniture = document_["furniture"].get_ref<json::array_t&>();
    std::erase_if(furniture, [&](const json& object) { return is_gone(object.at("id")); });
    changed_ = true;
    if (!document_.contains("constraints")) return;
    auto& relations = document_["constraints"].get_ref<json::array_t&>();
    std::erase_if(relations, [&](json& relation) {
      bool had = false;
      for (const char* key : {"targets", "relativeTo"}) {
        if (!relation.contains(key)) continue;
        json& list = relation[key];
        if (is_gone(list)) return true;
        if (!list.is_array()) continue;
        had = had || std::ranges::any_of(list, is_gone);
        std::erase_if(list.get_ref<json::array_t&>(), is_gone);
        if (list.empty()) return true;
      }
      return had && relation["targets"].empty();
    });
  }

  // The text's name of a thing, a wall or an opening as the scene has it; empty where it has none.
  std::string translated(const std::string& name) const {
    if (const auto found = ids_.find(name); found != ids_.end()) return found->second;
    if (text_.find_object(name) != nullptr) return {};
    if (const Opening* opening = text_.find_opening(name)) {
      for (const Opening& made : draft_.scene.room.openings) {
        if (made.type == opening->type) return made.id;
      }
      return {};
    }
    return name;  // a wall, the room
  }

  // Walls by the side they are on, whatever they are called.
  std::string canonical(const std::string& name) const {
    if (const auto side = room_side_from_word(name)) return std::string(name_of(*side));
    static const std::map<std::string, std::string> usual = {{"wall1", "front"}, {"wall2", "right"}, {"wall3", "back"}, {"wall4", "left"}};
    const auto found = usual.find(name);
    return found != usual.end() ? found->second : name;
  }

  bool shares_reference(const std::vector<std::string>& made, const std::vector<std::string>& wanted) const {
    if (wanted.empty()) return true;
    return std::ranges::any_of(made, [&](const std::string& m) {
      return std::ranges::any_of(wanted, [&](const std::string& w) { return canonical(m) == canonical(w); });
    });
  }

  void compare_relations() {
    for (const Relation& said : text_.relations) {
      if (!said.asked() || !said.hard) continue;
      std::vector<std::string> targets, references;
      bool known = true;
      for (const auto& [from, to] : {std::pair{&said.targets, &targets}, std::pair{&said.references, &references}}) {
        for (const std::string& name : *from) {
          to->push_back(translated(name));
          known = known && !to->back().empty();
        }
      }
      if (!known || is_said(said.type, targets, references)) continue;
      differ(fmt::format("the text says \"{}\" ({} of {}), the model's scene does not", said.why, relation_row(said.type).name,
                         fmt::join(targets, ", ")));
      if (settling_.sizes_and_relations && evidence_.relates(said)) add_relation(said, targets, references);
    }
  }

  bool is_said(RelationType type, const std::vector<std::string>& targets, const std::vector<std::string>& references) const {
    return std::ranges::all_of(targets, [&](const std::string& target) {
      return std::ranges::any_of(draft_.scene.relations, [&](const Relation& made) {
        if (!says_at_least(made.type, type)) return false;
        const bool one_way = std::ranges::find(made.targets, target) != made.targets.end() && shares_reference(made.references, references);
        const bool other_way = traits_of(type).symmetric && std::ranges::find(made.references, target) != made.references.end() &&
                               shares_reference(made.targets, references);
        const bool wall_any = references.empty() || (made.type == RelationType::kOnCeiling);
        return one_way || other_way || (wall_any && std::ranges::find(made.targets, target) != made.targets.end());
      });
    });
  }

  void add_relation(const Relation& said, const std::vector<std::string>& targets, const std::vector<std::string>& references) {
    Relation relation = said;
    relation.targets = targets, relation.references = references;
    if (!document_.contains("constraints")) document_["constraints"] = json::array();
    auto& list = document_["constraints"].get_ref<json::array_t&>();
    // What the model said instead gives way.
    std::erase_if(list, [&](const json& made) {
      const RelationRow* row = find_relation(made.value("type", ""));
      if (row == nullptr || !are_opposed(row->type, said.type)) return false;
      const auto names = [&](const char* key) {
        std::vector<std::string> out;
        if (made.contains(key) && made[key].is_string()) out.push_back(made[key].get<std::string>());
        if (made.contains(key) && made[key].is_array()) {
          for (const json& one : made[key]) out.push_back(one.get<std::string>());
        }
        return out;
      };
      const auto made_targets = names("targets"), made_references = names("relativeTo");
      const bool same_target =
          std::ranges::any_of(made_targets, [&](const auto& t) { return std::ranges::find(targets, t) != targets.end(); });
      const bool walls = (row->reference_kinds & kWall) != 0 && (relation_row(said.type).reference_kinds & kWall) != 0;
      return same_target && (walls || shares_reference(made_references, references));
    });
    std::set<std::string> ids;
    for (const json& made : list) ids.insert(made.value("id", ""));
    relation.id = "t1";
    for (int number = 2; ids.contains(relation.id); ++number) relation.id = fmt::format("t{}", number);
    list.push_back(json::parse(json_of(relation).dump()));
    changed_ = true;
  }

  std::string unused(const std::string& id) const {
    const auto taken = [&](const std::string& name) {
      if (std::ranges::any_of(document_["furniture"], [&](const json& o) { return same_name(o.value("id", ""), name); })) return true;
      const json openings = document_["room"].value("openings", json::array());
      return std::ranges::any_of(openings, [&](const json& o) { return same_name(o.value("id", ""), name); });
    };
    std::string stem = id;
    while (!stem.empty() && (std::isdigit(static_cast<unsigned char>(stem.back())) != 0 || stem.back() == '_')) stem.pop_back();
    std::string name = id;
    for (int number = 1; taken(name); ++number) name = fmt::format("{}_{}", stem, number);
    return name;
  }

  // Read again, so that document and scene are the same; where the change does not validate, all stays as the model had it.
  void take_over() {
    std::string written = document_.dump();
    Result<SceneGraph> scene = read_scene(written);
    if (!scene) {
      differ("the differences could not be settled: " + scene.error().message);
      return;
    }
    scene->notes = std::move(draft_.scene.notes);
    scene->prompt = draft_.scene.prompt;
    draft_.scene = std::move(*scene);
    draft_.document = std::move(written);
  }

  const Evidence evidence_;
  const SceneGraph& text_;
  const Catalog& catalog_;
  const Settling& settling_;
  std::size_t missing_ = 0;
  Draft& draft_;
  json document_;
  std::map<std::string, std::string> ids_;  // of the text → of the scene
  std::vector<std::size_t> surplus_;
  std::vector<std::string> differences_;
  bool changed_ = false;
};

}  // namespace

std::vector<std::string> compare_with_text(const Plan& read_offline, const Catalog& catalog, const Settling& settling, Draft& draft) {
  return DraftComparison(read_offline, catalog, settling, draft).run();
}

}  // namespace layoutbox::llm
