// What the picture shows of each object, by the index of its mask.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "layoutbox/scene/json_text.h"
#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/drawn.h"

namespace layoutbox {
namespace {

using nlohmann::json;

constexpr double kLeastSeen = 0.2;  // quality.md

struct Sight {
  double visible = 0;
  std::vector<std::string> behind;
};

std::optional<Sight> sight_of(const json& objects, const std::string& id) {
  const auto found = objects.find(id);
  if (found == objects.end() || !found->is_object()) return std::nullopt;
  Sight sight;
  if (const auto visible = found->find("visible"); visible != found->end() && visible->is_number()) sight.visible = visible->get<double>();
  if (const auto behind = found->find("behind"); behind != found->end() && behind->is_array()) {
    for (const json& id_of_other : *behind) {
      if (id_of_other.is_string()) sight.behind.push_back(id_of_other.get<std::string>());
    }
  }
  return sight;
}

std::string words_for(const std::string& id, const Sight& sight) {
  if (sight.visible >= kLeastSeen) return fmt::format("{:.0f} % of {} is seen in the picture", sight.visible * 100, id);
  return fmt::format("{} of {} is seen in the picture, at least 20 %{}{}",
                     sight.visible <= 0 ? "nothing" : fmt::format("{:.0f} %", sight.visible * 100), id,
                     sight.behind.empty() ? "" : ": it is behind ", fmt::join(sight.behind, ", "));
}

}  // namespace

Status verify_seen(const Layout& layout, std::string_view mask_index, Report& report) {
  LAYOUTBOX_ASSIGN(const json document, parse_json(mask_index));
  const json::json_pointer place_of_objects("/visibility/objects");
  if (!document.contains(place_of_objects) || !document.at(place_of_objects).is_object()) {
    return fail(ErrorCode::kSchema, "the index of a mask has no \"objects\" under \"visibility\"", "/visibility/objects",
                "give the mask.json that --mask wrote");
  }
  const json& visibility = document.at("visibility");
  int seen = 0, all = 0;
  for (std::size_t i = 0; i < layout.objects.size(); ++i) {
    const std::string& id = layout.objects[i].id;
    const std::optional<Sight> sight = sight_of(visibility.at("objects"), id);
    if (!sight) continue;  // left out of the picture together with the wall on which it hangs
    const bool enough = sight->visible >= kLeastSeen;
    ++all, seen += enough;
    report.checks.push_back(
        {"visibility", id, enough, false, sight->visible, "share", words_for(id, *sight), fmt::format("/objects/{}", i), kLeastSeen});
  }
  const auto behind = visibility.find("behindWalls");
  const double hidden = behind != visibility.end() && behind->is_number() ? behind->get<double>() : 0;
  report.checks.push_back(
      {"visibility", "walls", hidden == 0, false, hidden, "",
       hidden == 0 ? "no wall stands before anything" : fmt::format("walls stand before {} pixels of furniture", hidden), "/room", 0});
  report.metrics["visibility"] = all == 0 ? 1.0 : seen / static_cast<double>(all);
  return {};
}

}  // namespace layoutbox
