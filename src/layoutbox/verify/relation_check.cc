#include "layoutbox/verify/relation_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/verify/checks.h"

namespace layoutbox::checks {
namespace {

constexpr double kDegreesPerMetre = 100;  // only to tell which of several misses is the worst

Finding measured(bool held, double value, double limit, std::string message) {
  return {held, value, "m", std::move(message), held ? 0 : std::abs(value - limit), limit};
}

Finding any_face(const RelationCase& c, const std::vector<Face>& all, const std::function<bool(const Face&)>& wanted,
                 const std::string& nothing, const std::function<Finding(const Face&)>& check) {
  std::vector<Finding> findings;
  for (const Face* face : named_or_all(c, all, wanted)) findings.push_back(check(*face));
  return any_of(std::move(findings), nothing);
}

}  // namespace

std::optional<double> RelationCase::metres(std::optional<Mm> RelationFigures::*parameter) const {
  const std::optional<Mm> length = in_effect(relation, parameter);
  return length ? std::optional(*length / 1000.0) : std::nullopt;
}

double max_of(const RelationCase& c) { return c.metres(&RelationParameters::max).value_or(0); }

Finding all_of(std::vector<Finding> findings) {
  if (findings.empty()) return {};
  const auto worst = std::max_element(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return a.held != b.held ? a.held : !a.held && a.miss < b.miss;
  });
  return std::move(*(worst->held ? findings.begin() : worst));
}

Finding any_of(std::vector<Finding> findings, std::string nothing) {
  if (findings.empty()) return {false, 0, {}, std::move(nothing), 0};
  return std::move(*std::min_element(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return a.held != b.held ? a.held : !a.held && a.miss < b.miss;
  }));
}

Finding each_target(const RelationCase& c, const std::function<Finding(const Body&)>& check) {
  std::vector<Finding> findings;
  for (const Body* target : c.targets) findings.push_back(check(*target));
  return all_of(std::move(findings));
}

Finding each_pair(const RelationCase& c, const std::function<Finding(const Body&, const RelationReference&)>& check) {
  return each_target(c, [&](const Body& target) {
    std::vector<Finding> findings;
    for (const RelationReference& reference : c.references) findings.push_back(check(target, reference));
    return all_of(std::move(findings));
  });
}

std::vector<const Face*> named_or_all(const RelationCase& c, const std::vector<Face>& all, const std::function<bool(const Face&)>& wanted) {
  std::vector<const Face*> faces;
  // What is named is meant, be it a door or a window.
  for (const RelationReference& reference : c.references) {
    const bool fits =
        reference.face != nullptr && (wanted(*reference.face) || (reference.face->opening != nullptr && &all == &c.view.openings));
    if (fits) faces.push_back(reference.face);
  }
  const bool any_named = std::any_of(c.references.begin(), c.references.end(), [](const RelationReference& r) { return !r.is_place(); });
  if (any_named) return faces;
  for (const Face& face : all) {
    if (wanted(face)) faces.push_back(&face);
  }
  return faces;
}

Finding any_wall(const RelationCase& c, const std::function<Finding(const Face&)>& check) {
  return any_face(
      c, c.view.walls, [](const Face& face) { return face.opening == nullptr; }, "there is no such wall", check);
}
Finding any_door(const RelationCase& c, const std::function<Finding(const Face&)>& check) {
  return any_face(
      c, c.view.openings, [](const Face& face) { return face.is_door(); }, "there is no such door", check);
}
Finding any_window(const RelationCase& c, const std::function<Finding(const Face&)>& check) {
  return any_face(
      c, c.view.openings, [](const Face& face) { return face.is_window(); }, "there is no such window", check);
}

Finding at_most(const std::string& what, double value, double limit, double slack) {
  return measured(value <= limit + slack + kTiny, value, limit,
                  fmt::format("{} {} m, at most {} m", what, figure_beside(value, limit), figure(limit)));
}

Finding at_least(const std::string& what, double value, double limit, double slack) {
  return measured(value >= limit - slack - kTiny, value, limit,
                  fmt::format("{} {} m, at least {} m", what, figure_beside(value, limit), figure(limit)));
}

Finding in_band(const std::string& what, double value, std::optional<double> min, std::optional<double> max, double slack) {
  if (min && value < *min - slack - kTiny) return at_least(what, value, *min, slack);
  if (max) return at_most(what, value, *max, slack);
  if (min) return at_least(what, value, *min, slack);
  return measured(true, value, 0, fmt::format("{} {} m", what, figure(value)));
}

Finding equal_to(const std::string& what, double value, double wanted, double slack) {
  return measured(std::abs(value - wanted) <= slack + kTiny, value, value - wanted,
                  fmt::format("{} {} m, to be {} m", what, figure_beside(value, wanted), figure(wanted)));
}

Finding condition(bool held, const std::string& message) { return {held, held ? 1.0 : 0.0, {}, message, held ? 0 : 1.0}; }

Finding degrees_at_most(const std::string& what, double value, double limit) {
  const bool held = value <= limit + kTiny;
  return {held, value, "degrees", fmt::format("{} {:.0f} degrees, at most {:.0f}", what, value, limit),
          held ? 0 : value / kDegreesPerMetre};
}

}  // namespace layoutbox::checks
