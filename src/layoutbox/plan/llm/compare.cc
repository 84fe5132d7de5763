#include "layoutbox/plan/llm/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "layoutbox/plan/llm/draft_comparison.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::llm {

using nlohmann::json;

std::vector<std::string> DraftComparison::run() {
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

void DraftComparison::compare_room() {
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

void DraftComparison::compare_openings() {
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

std::string DraftComparison::unused(const std::string& id) const {
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
void DraftComparison::take_over() {
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

std::vector<std::string> compare_with_text(const Plan& read_offline, const Catalog& catalog, const Settling& settling, Draft& draft) {
  return DraftComparison(read_offline, catalog, settling, draft).run();
}

}  // namespace layoutbox::llm
