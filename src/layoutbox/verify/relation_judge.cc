// Looks up what each relation of a layout names, measures it, and compares with what the layout claims.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

using CheckFunction = Finding (*)(const RelationCase&);

constexpr std::array kChecks{
#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) CheckFunction{&check_##name},
#include "layoutbox/scene/relation_list.inc"
#undef LAYOUTBOX_RELATION
};

bool is_place_word(const std::string& id) { return id == "room" || id == "floor" || id == "ceiling"; }

std::optional<RelationReference> look_up(const RoomView& view, const std::string& id) {
  if (const Body* body = view.find_body(id)) return RelationReference{id, body, nullptr};
  if (const Face* opening = view.find_opening(id)) return RelationReference{id, nullptr, opening};
  if (const Face* wall = view.find_wall(id)) return RelationReference{wall->id, nullptr, wall};
  if (is_place_word(id)) return RelationReference{id, nullptr, nullptr};
  return std::nullopt;
}

Finding measure(const RoomView& view, const Relation& relation) {
  RelationCase c{view, relation, {}, {}};
  std::vector<std::string> unknown;
  for (const std::string& id : relation.targets) {
    if (const Body* body = view.find_body(id)) {
      c.targets.push_back(body);
    } else {
      unknown.push_back(id);
    }
  }
  for (const std::string& id : relation.references) {
    if (std::optional<RelationReference> reference = look_up(view, id)) {
      c.references.push_back(*std::move(reference));
    } else {
      unknown.push_back(id);
    }
  }
  if (!unknown.empty()) return condition(false, fmt::format("names {}, which the layout does not have", fmt::join(unknown, ", ")));
  if (c.targets.empty()) return condition(false, "names no target");
  const RelationArity arity = relation_row(relation.type).arity;
  const bool needs_reference = arity == RelationArity::kOne || arity == RelationArity::kMany;
  if (needs_reference && c.references.empty()) return condition(false, "names nothing that it relates to");
  return kChecks[static_cast<std::size_t>(relation.type)](c);
}

std::string verdict(const PlacedRelation& placed, const Finding& finding, bool relaxed) {
  const std::string_view type = relation_row(placed.relation.type).name;
  if (finding.held) return fmt::format("{} holds: {}{}", type, finding.message, placed.held ? "" : " (the layout says that it does not)");
  std::string_view note;
  if (relaxed) {
    note = " (given up, as listed)";
  } else if (placed.held) {
    note = " (the layout says that it holds)";
  } else if (placed.relation.hard) {
    note = " (not listed as given up)";
  }
  return fmt::format("{} does not hold: {}{}", type, finding.message, note);
}

}  // namespace

void check_relations(const RoomView& view, Report& report) {
  int hard = 0, hard_held = 0, soft = 0, soft_held = 0, false_claims = 0;
  for (std::size_t i = 0; i < view.layout.relations.size(); ++i) {
    const PlacedRelation& placed = view.layout.relations[i];
    const Finding finding = measure(view, placed.relation);
    const bool relaxed = view.layout.lists_as_given_up(placed.relation.id);
    (placed.relation.hard ? hard : soft) += 1;
    (placed.relation.hard ? hard_held : soft_held) += finding.held;
    false_claims += placed.held && !finding.held;
    report.checks.push_back({"relation", placed.relation.id, finding.held, placed.relation.hard && !relaxed,
                             std::isfinite(finding.value) ? finding.value : 0, finding.unit, verdict(placed, finding, relaxed),
                             fmt::format("/relations/{}", i), finding.limit});
  }
  const auto share = [](int part, int whole) { return whole == 0 ? 1.0 : part / static_cast<double>(whole); };
  report.metrics["relationsHeld"] = share(hard_held, hard);
  report.metrics["softRelationsHeld"] = share(soft_held, soft);
  report.metrics["relationsRelaxed"] = static_cast<double>(view.layout.relaxed.size());
  report.metrics["falseClaims"] = false_claims;
}

}  // namespace layoutbox::checks
