// Edges and regions as people and models write them.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/scene/quirks.h"

namespace layoutbox {

using nlohmann::json;

void settle_edge_and_region(json& relation, const std::string& at, std::vector<Note>& notes) {
  const auto type = relation.find("type");
  const RelationRow* row = type != relation.end() && type->is_string() ? find_relation(type->get<std::string>()) : nullptr;
  for (const std::string key : {"edge", "region"}) {
    const auto found = relation.find(key);
    if (found == relation.end() || !found->is_string()) continue;
    const std::string written = found->get<std::string>();
    std::optional<std::string_view> name;
    if (key == "edge") {
      if (const auto edge = edge_from_words(written)) name = name_of(*edge);
    } else if (const auto region = region_from_words(written)) {
      name = name_of(*region);
    }
    if (name && *name != written) {
      notes.push_back({"converted", fmt::format("the {} \"{}\" is read as \"{}\"", key, written, *name), at + "/" + key});
      *found = *name;
    } else if (!name && row != nullptr && !row->reads(key)) {  // it says nothing there, and older files have it
      if (!written.empty()) notes.push_back({"ignored", fmt::format("{} has no {}: \"{}\"", row->name, key, written), at + "/" + key});
      relation.erase(found);
    } else if (written.empty()) {
      relation.erase(found);
    }
  }
}

}  // namespace layoutbox
