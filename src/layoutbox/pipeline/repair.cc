#include "layoutbox/pipeline/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "layoutbox/pipeline/ways_out.h"

namespace layoutbox {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string relation_line(const Relation& relation) {
  return fmt::format("- {}: {} {} {}{}", relation.id, fmt::join(relation.targets, ", "), relation_row(relation.type).name,
                     relation.references.empty() ? "(any)" : fmt::format("{}", fmt::join(relation.references, ", ")),
                     relation.why.empty() ? "" : fmt::format(" (\"{}\")", relation.why));
}

std::string object_line(const SceneObject& object) {
  if (!object.size) return fmt::format("- {}: {}", object.id, object.category);
  const Size& size = object.size->usual;
  return fmt::format("- {}: {}, {:.2f} x {:.2f} x {:.2f} m", object.id, object.category, m_from_mm(size.width), m_from_mm(size.depth),
                     m_from_mm(size.height));
}

bool takes_part(const Layout& layout, const std::string& name) {
  const auto has = [&](const std::vector<std::string>& names) { return std::ranges::find(names, name) != names.end(); };
  return std::ranges::any_of(layout.conflicts, [&](const Conflict& c) { return has(c.relations) || has(c.objects); }) ||
         std::ranges::any_of(layout.relaxed, [&](const Relaxation& r) { return r.relation == name; });
}

std::string sentences_of(const Layout& layout) {
  std::string text;
  for (const Conflict& conflict : layout.conflicts) text += (text.empty() ? "" : "; ") + conflict.sentence;
  if (text.empty() && !layout.relaxed.empty()) text = layout.relaxed[0].why;
  return text;
}

std::size_t things_left_out(const WayOut& way) {
  const OrderedJson patch = OrderedJson::parse(way.patch, nullptr, false);
  if (!patch.is_array()) return 0;
  return static_cast<std::size_t>(std::ranges::count_if(patch, [](const OrderedJson& change) {
    return change.value("op", "") == "remove" && change.value("path", "").starts_with("/furniture/");
  }));
}

// Where not even giving up brings a layout, everything takes part in the conflict.
Layout layout_of_nothing(const SceneGraph& scene, const Error& error) {
  Layout layout;
  layout.status = LayoutStatus::kRelaxed;
  Conflict conflict;
  conflict.sentence = error.message;
  conflict.minimal = false;
  for (const Relation& relation : scene.relations) conflict.relations.push_back(relation.id);
  for (const SceneObject& object : scene.objects) conflict.objects.push_back(object.id);
  layout.conflicts.push_back(std::move(conflict));
  return layout;
}

}  // namespace

RepairLoop::RepairLoop(Planning& planning, const Catalog& catalog, const GenerateOptions& options)
    : planning_(planning), catalog_(catalog), options_(options), limits_(options.repair) {
  if (limits_.paper_retries) limits_.repair_attempts = 1;
}

Result<PlannedRoom> RepairLoop::run() { return loop(std::nullopt); }

Result<PlannedRoom> RepairLoop::run_again(const std::string& failure) {
  repeated_ = false;
  auto room = loop(Feedback{Feedback::Kind::kFailure, failure, {}, {}});
  if (room && repeated_) return fail(ErrorCode::kNotFound, "the model gave the same scene again");
  return room;
}

Result<PlannedRoom> RepairLoop::loop(std::optional<Feedback> feedback) {
  while (has_attempts_left()) {
    auto proposal = feedback ? planning_.revise(*feedback) : planning_.propose();
    if (!proposal) {
      // What was there before is better than nothing, unless the user stopped it.
      if (proposal.error().code == ErrorCode::kInterrupted || !best_) return Failure(proposal.error());
      break;
    }
    if (proposal->repeated && feedback && last_) {
      repeated_ = true;
      planning_.note({"same as before", {}, {}});
      break;
    }
    ProposalOutcome result{"faults", proposal->faults, {}};
    if (proposal->scene) {
      LAYOUTBOX_ASSIGN(result, judge(std::move(*proposal)));
      planning_.note(result);
    }
    if (result.outcome == "solved") return std::move(last_->room);
    if (result.outcome == "conflict") {
      if (repairs_ >= limits_.repair_attempts) break;
      ++repairs_;
      feedback = conflict_feedback(*last_);
    } else {
      feedback = Feedback{Feedback::Kind::kFaults, {}, std::move(result.faults), {}};
    }
  }
  return settle();
}

Result<ProposalOutcome> RepairLoop::judge(Proposal proposal) {
  if (adjust) adjust(*proposal.scene);
  auto scene = prepare_scene(std::move(*proposal.scene), catalog_, options_);
  if (!scene)  // walls that do not meet, an object of an impossible size
    return ProposalOutcome{"faults", scene.error().details.empty() ? std::vector<Error>{scene.error()} : scene.error().details, {}};
  SolveOptions solve_options = options_.solve;
  solve_options.on_conflict = OnConflict::kRelax;
  Result<Layout> solved = solve(*scene, catalog_, solve_options);
  if (!solved && solved.error().code != ErrorCode::kNotFound && solved.error().code != ErrorCode::kInfeasible)
    return Failure(solved.error());
  if (!solved) unsolved_ = solved.error();
  const bool has_layout = solved.has_value();
  Layout layout = has_layout ? std::move(*solved) : layout_of_nothing(*scene, solved.error());
  const bool conflict = !has_layout || gives_up_what_was_asked(layout, *scene);
  last_ = Candidate{{std::move(*scene), std::move(layout)}, std::move(proposal.document), 0};
  last_->given_up = last_->room.layout.relaxed.size();
  if (has_layout && (!best_ || last_->given_up < best_->given_up)) best_ = last_;
  if (!conflict) return ProposalOutcome{"solved", {}, {}};
  return ProposalOutcome{"conflict", {}, sentences_of(last_->room.layout)};
}

Feedback RepairLoop::conflict_feedback(const Candidate& candidate) const {
  const Layout& layout = candidate.room.layout;
  Feedback feedback;
  feedback.kind = Feedback::Kind::kConflict;
  feedback.may_go = std::max<std::size_t>(1, layout.conflicts.size());
  std::string relations, objects;
  std::vector<std::string> ids;
  for (const Relation& relation : candidate.room.scene.relations) {
    if (!takes_part(layout, relation.id)) continue;
    relations += relation_line(relation) + "\n";
    ids.insert(ids.end(), relation.targets.begin(), relation.targets.end());
  }
  for (const SceneObject& object : candidate.room.scene.objects) {
    if (!takes_part(layout, object.id) && std::ranges::find(ids, object.id) == ids.end()) continue;
    objects += object_line(object) + "\n";
    feedback.categories.insert(object.category);
  }
  if (limits_.paper_retries) {
    feedback.kind = Feedback::Kind::kNotice;
    return feedback;
  }
  feedback.text = fmt::format("There is no layout for this scene: {}.\n", sentences_of(layout));
  if (!relations.empty()) feedback.text += "Relations that take part:\n" + relations;
  if (!objects.empty()) feedback.text += "Things that take part:\n" + objects;
  WaysOutOptions limits;
  limits.room_may_grow = options_.normalize.room_size.width == 0 && !options_.shell;
  const auto ways = find_ways_out(candidate.document, layout, catalog_, options_, limits);
  for (const auto& way : ways) feedback.may_go = std::max(feedback.may_go, things_left_out(way));
  if (!ways.empty()) feedback.text += "Ways out, each tried and enough, as changes (RFC 6902) to the scene as it stands above:\n";
  for (std::size_t i = 0; i < ways.size(); ++i) feedback.text += fmt::format("{}. {}: {}\n", i + 1, ways[i].sentence, ways[i].patch);
  return feedback;
}

// After the last attempt.
Result<PlannedRoom> RepairLoop::settle() {
  if (!best_ && !unsolved_) {
    if (auto proposal = planning_.salvage()) LAYOUTBOX_CHECK(judge(std::move(*proposal)));
  }
  if (!best_ && unsolved_) return Failure(*unsolved_);
  if (!best_) return Failure(planning_.no_usable_scene());
  const OnConflict choice = limits_.paper_retries ? OnConflict::kOriginal : options_.solve.on_conflict;
  if (choice == OnConflict::kRelax || !gives_up_what_was_asked(best_->room.layout, best_->room.scene)) return std::move(best_->room);
  SolveOptions solve_options = options_.solve;
  solve_options.on_conflict = choice;
  LAYOUTBOX_ASSIGN(best_->room.layout, solve(best_->room.scene, catalog_, solve_options));
  return std::move(best_->room);
}

}  // namespace layoutbox
