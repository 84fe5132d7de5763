#include "layoutbox/solve/model/repeated.h"

#include <fmt/format.h>

#include <string>
#include <unordered_map>

namespace layoutbox::placement {
namespace {

// All that a relation says, its id and words apart.
std::string meaning_of(const Relation& r) {
  const auto number = [](const auto& value) { return value ? fmt::format("{}", static_cast<int>(*value)) : std::string("-"); };
  const RelationParameters& p = r.parameters;
  std::string key = fmt::format("{}|{}|{}|{}|", static_cast<int>(r.type), r.hard, r.weight, static_cast<int>(r.origin));
  for (const auto* ids : {&r.targets, &r.references}) {
    for (const std::string& id : *ids) key += id + ",";
    key += "|";
  }
  for (const auto& length : {p.distance, p.min, p.max, p.gap, p.depth, p.width, p.height}) key += number(length) + "|";
  return key + number(p.axis) + "|" + number(p.side) + "|" + number(p.columns) + "|" + number(p.edge) + "|" + number(p.region) + "|" +
         p.part.text();
}

// By relation, the first that says the same.
std::vector<std::size_t> firsts_of(const SceneGraph& scene) {
  std::unordered_map<std::string, std::size_t> known;
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < scene.relations.size(); ++i)
    firsts.push_back(known.try_emplace(meaning_of(scene.relations[i]), i).first->second);
  return firsts;
}

}  // namespace

std::optional<SceneGraph> without_repeats(const SceneGraph& scene) {
  const std::vector<std::size_t> firsts = firsts_of(scene);
  std::vector<Relation> kept;
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    if (firsts[i] == i) kept.push_back(scene.relations[i]);
  }
  if (kept.size() == scene.relations.size()) return std::nullopt;
  SceneGraph fewer = scene;
  fewer.relations = std::move(kept);
  return fewer;
}

void add_repeats(const SceneGraph& scene, Layout& layout) {
  const std::vector<std::size_t> firsts = firsts_of(scene);
  std::unordered_map<std::string, std::vector<std::string>> again;  // by the id of the first
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    if (firsts[i] != i) again[scene.relations[firsts[i]].id].push_back(scene.relations[i].id);
  }
  std::unordered_map<std::string, std::size_t> placed;
  for (std::size_t i = 0; i < layout.relations.size(); ++i) placed.emplace(layout.relations[i].relation.id, i);
  std::vector<PlacedRelation> all;
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    const auto found = placed.find(scene.relations[firsts[i]].id);
    if (found == placed.end()) continue;
    all.push_back(layout.relations[found->second]);
    all.back().relation.id = scene.relations[i].id;
    all.back().relation.why = scene.relations[i].why;
  }
  layout.relations = std::move(all);
  for (std::vector<Relaxation>* list : {&layout.relaxed, &layout.gave_way}) {
    for (std::size_t i = 0, n = list->size(); i < n; ++i) {
      const Relaxation first = (*list)[i];
      for (const std::string& id : again[first.relation]) list->push_back({id, first.by, first.unit, first.why});
    }
  }
}

}  // namespace layoutbox::placement
