// Things of the text beside things of the model's scene: which is which, what is missing or too much, other sizes.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/llm/draft_comparison.h"

namespace layoutbox::llm {

using nlohmann::json;

// How well a thing of the scene is one of the text; 0: not at all.
int DraftComparison::likeness(const SceneObject& said, const SceneObject& made) const {
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

void DraftComparison::match_objects() {
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

void DraftComparison::compare_objects() {
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
bool DraftComparison::has_thing_of_its_own() const {
  return std::ranges::any_of(surplus_, [&](std::size_t made) {
    return std::ranges::none_of(text_.objects, [&](const SceneObject& said) { return likeness(said, draft_.scene.objects[made]) > 0; });
  });
}

void DraftComparison::add(const SceneObject& said) {
  json object{{"id", unused(said.id)}, {"category", said.category}, {"name", said.name}};
  if (!said.attributes.empty()) object["attributes"] = said.attributes;
  ids_[said.id] = object["id"].get<std::string>();
  set_size(said, object);
  document_["furniture"].push_back(std::move(object));
  changed_ = true;
}

// Sides that the text gives: those without a range.
void DraftComparison::set_size(const SceneObject& said, json& object) {
  if (said.size_source != SizeSource::kUser || !said.size) return;
  const auto set = [&](const char* key, Mm Size::*side) {
    if (said.size->least.*side == said.size->greatest.*side && said.size->usual.*side > 0)
      object["dims"][key] = m_from_mm(said.size->usual.*side);
  };
  set("w", &Size::width), set("d", &Size::depth), set("h", &Size::height);
}

void DraftComparison::compare_size(const SceneObject& said, const SceneObject& made) {
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
void DraftComparison::compare_surplus() {
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

void DraftComparison::remove(const std::set<std::string>& gone) {
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

}  // namespace layoutbox::llm
