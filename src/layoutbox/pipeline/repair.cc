#include "layoutbox/pipeline/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "layoutbox/pipeline/run_record.h"
#include "layoutbox/pipeline/ways_out.h"

namespace layoutbox {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kPaperNotice = "No feasible layout was found for this scene. Adjust the constraints and call create_scene again.";

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

OrderedJson json_of(const Note& note) { return {{"message", note.message}, {"pointer", note.pointer}}; }

// A text of JSON as JSON, so that run.json can be read without unpacking texts.
OrderedJson unpacked(const std::string& text) {
  OrderedJson json = OrderedJson::parse(text, nullptr, false);
  return json.is_discarded() ? OrderedJson(text) : json;
}

OrderedJson json_of(const llm::Attempt& attempt) {
  const chat::Response& answer = attempt.answer;
  OrderedJson json{{"attempt", attempt.number}, {"purpose", attempt.purpose}, {"outcome", attempt.outcome}};
  if (!answer.request.empty()) {
    json["mode"] = name_of(answer.mode);
    json["request"] = unpacked(answer.request);
    json["answer"] = unpacked(answer.body);
    json["tokens"] = {
        {"question", answer.usage.request_tokens}, {"answer", answer.usage.response_tokens}, {"estimated", answer.usage.estimated}};
    json["cost"] = answer.cost ? OrderedJson(*answer.cost) : OrderedJson();
    json["seconds"] = answer.seconds;
    json["ownSeconds"] = answer.own_seconds;
    json["retries"] = answer.retries;
    json["cached"] = answer.cached;
  }
  json["errors"] = OrderedJson::array();
  for (const Error& fault : attempt.faults) json["errors"].push_back(json_of_error(fault));
  json["mended"] = OrderedJson::array();
  for (const Note& note : attempt.mended) json["mended"].push_back(json_of(note));
  json["differences"] = attempt.differences;
  if (!attempt.conflict.empty()) json["conflict"] = attempt.conflict;
  return json;
}

}  // namespace

RepairLoop::RepairLoop(llm::Conversation& conversation, const Catalog& catalog, const GenerateOptions& options)
    : conversation_(conversation), catalog_(catalog), options_(options), limits_(options.repair) {
  if (limits_.paper_retries) limits_.repair_attempts = 1;
}

Result<PlannedRoom> RepairLoop::run() { return loop(std::nullopt); }

Result<PlannedRoom> RepairLoop::run_again(const std::string& failure) {
  LAYOUTBOX_CHECK(pause());
  auto room = loop(llm::Complaint{llm::Complaint::Kind::kFailure, failure, {}});
  if (room && conversation_.attempts().back().outcome == "same as before")
    return fail(ErrorCode::kNotFound, "the model gave the same scene again");
  return room;
}

Result<PlannedRoom> RepairLoop::loop(std::optional<llm::Complaint> complaint) {
  while (has_attempts_left()) {
    auto reading = conversation_.ask(complaint);
    llm::Attempt& attempt = conversation_.attempts().back();
    if (!reading) {
      // What was there before is better than nothing, unless the user stopped it.
      if (reading.error().code == ErrorCode::kInterrupted || !best_) return Failure(reading.error());
      break;
    }
    if (reading->draft) {
      const bool same = last_ && llm::same_document(last_->document, reading->draft->document);
      if (same && complaint) {
        attempt.outcome = "same as before";
        break;
      }
      LAYOUTBOX_ASSIGN(const bool solved, try_draft(std::move(*reading->draft), attempt));
      if (solved) return std::move(last_->room);
    } else {
      faults_ = reading->faults;
    }
    if (attempt.outcome == "conflict") {
      if (repairs_ >= limits_.repair_attempts) break;
      ++repairs_;
      complaint = conflict_complaint(*last_);
    } else {
      complaint = llm::complaint_of(attempt.faults);
    }
    if (has_attempts_left()) LAYOUTBOX_CHECK(pause());
  }
  return settle();
}

Result<bool> RepairLoop::try_draft(llm::Draft draft, llm::Attempt& attempt) {
  if (adjust) adjust(draft.scene);
  auto scene = prepare_scene(draft.scene, catalog_, options_);
  if (!scene) {  // walls that do not meet, an object of an impossible size
    attempt.faults = scene.error().details.empty() ? std::vector<Error>{scene.error()} : scene.error().details;
    attempt.outcome = "faults";
    faults_ = attempt.faults;
    return false;
  }
  SolveOptions solve_options = options_.solve;
  solve_options.on_conflict = OnConflict::kRelax;
  Result<Layout> solved = solve(*scene, catalog_, solve_options);
  if (!solved && solved.error().code != ErrorCode::kNotFound && solved.error().code != ErrorCode::kInfeasible)
    return Failure(solved.error());
  if (!solved) unsolved_ = solved.error();
  const bool has_layout = solved.has_value();
  Layout layout = has_layout ? std::move(*solved) : layout_of_nothing(*scene, solved.error());
  const bool conflict = !has_layout || gives_up_what_was_asked(layout, *scene);
  last_ = Candidate{{std::move(*scene), std::move(layout)}, std::move(draft.document), 0};
  last_->given_up = last_->room.layout.relaxed.size();
  if (has_layout && (!best_ || last_->given_up < best_->given_up)) best_ = last_;
  attempt.outcome = conflict ? "conflict" : "solved";
  if (conflict) attempt.conflict = sentences_of(last_->room.layout);
  return !conflict;
}

llm::Complaint RepairLoop::conflict_complaint(const Candidate& candidate) const {
  const Layout& layout = candidate.room.layout;
  llm::Complaint complaint;
  complaint.kind = llm::Complaint::Kind::kConflict;
  complaint.may_go = std::max<std::size_t>(1, layout.conflicts.size());
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
    complaint.categories.insert(object.category);
  }
  if (limits_.paper_retries) {
    complaint.kind = llm::Complaint::Kind::kNotice;
    complaint.text = kPaperNotice;
    return complaint;
  }
  complaint.text = fmt::format("There is no layout for this scene: {}.\n", sentences_of(layout));
  if (!relations.empty()) complaint.text += "Relations that take part:\n" + relations;
  if (!objects.empty()) complaint.text += "Things that take part:\n" + objects;
  WaysOutOptions limits;
  limits.room_may_grow = options_.normalize.room_size.width == 0 && !options_.shell;
  const auto ways = find_ways_out(candidate.document, layout, catalog_, options_, limits);
  for (const auto& way : ways) complaint.may_go = std::max(complaint.may_go, things_left_out(way));
  if (!ways.empty()) complaint.text += "Ways out, each tried and enough, as changes (RFC 6902) to the scene as it stands above:\n";
  for (std::size_t i = 0; i < ways.size(); ++i) complaint.text += fmt::format("{}. {}: {}\n", i + 1, ways[i].sentence, ways[i].patch);
  complaint.text +=
      "Call patch_scene with the one that keeps most of what the description asks for, or create_scene with the whole scene changed. "
      "Leave all else as it is.";
  return complaint;
}

// After the last attempt.
Result<PlannedRoom> RepairLoop::settle() {
  if (!best_ && !unsolved_) {
    if (auto draft = conversation_.salvage()) {
      llm::Attempt unused;
      LAYOUTBOX_CHECK(try_draft(std::move(*draft), unused));
    }
  }
  if (!best_ && unsolved_) return Failure(*unsolved_);
  if (!best_) return Failure(llm::no_usable_answer(attempts(), faults_));
  const OnConflict choice = limits_.paper_retries ? OnConflict::kOriginal : options_.solve.on_conflict;
  if (choice == OnConflict::kRelax || !gives_up_what_was_asked(best_->room.layout, best_->room.scene)) return std::move(best_->room);
  SolveOptions solve_options = options_.solve;
  solve_options.on_conflict = choice;
  LAYOUTBOX_ASSIGN(best_->room.layout, solve(best_->room.scene, catalog_, solve_options));
  return std::move(best_->room);
}

Status RepairLoop::pause() const { return llm::pause_after(conversation_.attempts().back(), limits_.pause_s, options_.stop); }

std::string write_attempts(const std::vector<llm::Attempt>& attempts) {
  OrderedJson json = OrderedJson::array();
  for (const llm::Attempt& attempt : attempts) json.push_back(json_of(attempt));
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace layoutbox
