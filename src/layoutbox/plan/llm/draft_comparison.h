// The class behind compare_with_text; its members stand in compare (the whole, the room), compare_objects and compare_relations.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/plan/llm/compare.h"
#include "layoutbox/plan/llm/evidence.h"

namespace layoutbox::llm {

class DraftComparison {
 public:
  DraftComparison(const Plan& plan, const Catalog& catalog, const Settling& settling, Draft& draft)
      : evidence_(plan, catalog),
        text_(plan.scene),
        catalog_(catalog),
        settling_(settling),
        draft_(draft),
        document_(nlohmann::json::parse(draft.document)) {}

  std::vector<std::string> run();

 private:
  static constexpr Mm kSameLength = 15;

  void differ(std::string sentence) { differences_.push_back(std::move(sentence)); }
  int likeness(const SceneObject& said, const SceneObject& made) const;
  void match_objects();
  void compare_room();
  void compare_openings();
  // The model chose to leave it out, as it was asked to; not more than that takes.
  bool may_be_missing(const SceneObject& said) {
    if (!settling_.open.contains(said.category) || missing_ >= settling_.may_be_missing) return false;
    ++missing_;
    return true;
  }
  void compare_objects();
  bool has_thing_of_its_own() const;
  void add(const SceneObject& said);
  static void set_size(const SceneObject& said, nlohmann::json& object);
  void compare_size(const SceneObject& said, const SceneObject& made);
  void compare_surplus();
  void remove(const std::set<std::string>& gone);
  std::string translated(const std::string& name) const;
  std::string canonical(const std::string& name) const;
  bool shares_reference(const std::vector<std::string>& made, const std::vector<std::string>& wanted) const;
  void compare_relations();
  bool is_said(RelationType type, const std::vector<std::string>& targets, const std::vector<std::string>& references) const;
  void add_relation(const Relation& said, const std::vector<std::string>& targets, const std::vector<std::string>& references);
  std::string unused(const std::string& id) const;
  void take_over();

  const Evidence evidence_;
  const SceneGraph& text_;
  const Catalog& catalog_;
  const Settling& settling_;
  std::size_t missing_ = 0;
  Draft& draft_;
  nlohmann::json document_;
  std::map<std::string, std::string> ids_;  // of the text → of the scene
  std::vector<std::size_t> surplus_;
  std::vector<std::string> differences_;
  bool changed_ = false;
};

}  // namespace layoutbox::llm
