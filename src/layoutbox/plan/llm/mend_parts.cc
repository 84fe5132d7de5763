#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/catalog/parts.h"
#include "layoutbox/plan/llm/mend.h"
#include "layoutbox/plan/llm/mend_text.h"
#include "layoutbox/scene/quirks.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

template <class Function>
void for_each_relation(json& scene, Function function) {
  if (!scene.is_object() || !scene.contains("constraints") || !scene["constraints"].is_array()) return;
  std::size_t index = 0;
  for (json& relation : scene["constraints"]) {
    const std::string at = fmt::format("/constraints/{}", index++);
    if (relation.is_object()) function(relation, at);
  }
}

// The kinds of what a relation is relative to; empty where one of them is no thing of the scene.
std::vector<const CatalogEntry*> hosts_of(const json& scene, const json& relation, const Catalog& catalog) {
  std::vector<const CatalogEntry*> hosts;
  const json to = relation.value("relativeTo", json());
  for (const json& reference : to.is_array() ? to : json::array({to})) {
    for (const json& object : scene.value("furniture", json::array())) {
      if (object.is_object() && reference.is_string() && text_of(object, "id") == reference.get<std::string>())
        hosts.push_back(&catalog.entry_or_nearest(text_of(object, "category")));
    }
  }
  return hosts;
}

}  // namespace

void mend_edges_and_regions(json& scene, Notes& notes) {
  for_each_relation(scene, [&](json& relation, const std::string& at) { settle_edge_and_region(relation, at, notes); });
}

void mend_parts(json& scene, const Catalog& catalog, Notes& notes) {
  for_each_relation(scene, [&](json& relation, const std::string& at) {
    const RelationRow* row = find_relation(text_of(relation, "type"));
    const ThingPart part(text_of(relation, "part"));
    if (row == nullptr || !row->reads("part") || part.empty()) return;
    const std::vector<const CatalogEntry*> hosts = hosts_of(scene, relation, catalog);
    bool known = !hosts.empty() || part.is_words();
    for (const CatalogEntry* host : hosts) known = known && is_part(row->type, part, space_names(*host));
    if (known) return;
    note(notes, fmt::format("\"{}\" is no part of what it is relative to: it is left out", part.text().substr(0, 40)), at + "/part");
    relation.erase("part");
  });
}

}  // namespace layoutbox::llm
