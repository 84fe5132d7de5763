// Relations of the text that the model's scene does not have.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "layoutbox/plan/llm/draft_comparison.h"
#include "layoutbox/scene/json_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::llm {

using nlohmann::json;

namespace {

bool says_at_least(RelationType said, RelationType wanted) { return said == wanted || traits_of(wanted).said_by.has(said); }

}  // namespace

// The text's name of a thing, a wall or an opening as the scene has it; empty where it has none.
std::string DraftComparison::translated(const std::string& name) const {
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
std::string DraftComparison::canonical(const std::string& name) const {
  if (const auto side = room_side_from_word(name)) return std::string(name_of(*side));
  static const std::map<std::string, std::string> usual = {{"wall1", "front"}, {"wall2", "right"}, {"wall3", "back"}, {"wall4", "left"}};
  const auto found = usual.find(name);
  return found != usual.end() ? found->second : name;
}

bool DraftComparison::shares_reference(const std::vector<std::string>& made, const std::vector<std::string>& wanted) const {
  if (wanted.empty()) return true;
  return std::ranges::any_of(made, [&](const std::string& m) {
    return std::ranges::any_of(wanted, [&](const std::string& w) { return canonical(m) == canonical(w); });
  });
}

void DraftComparison::compare_relations() {
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

bool DraftComparison::is_said(RelationType type, const std::vector<std::string>& targets,
                              const std::vector<std::string>& references) const {
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

void DraftComparison::add_relation(const Relation& said, const std::vector<std::string>& targets,
                                   const std::vector<std::string>& references) {
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

}  // namespace layoutbox::llm
