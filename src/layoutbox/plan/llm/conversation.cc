#include "layoutbox/plan/llm/conversation.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "layoutbox/base/words.h"
#include "layoutbox/chat/tokens.h"
#include "layoutbox/plan/llm/functions.h"
#include "layoutbox/plan/llm/prompt.h"
#include "layoutbox/plan/llm/record.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::llm {
namespace {

constexpr std::string_view kEditRules =
    "\n\nThe request is a change to the scene below. Hand over the whole scene after the change; leave everything else as it is, ids and "
    "xform.pos above all.\nThe scene:\n";

const char* purpose_of(const Feedback* feedback) {
  if (feedback == nullptr) return "first";
  switch (feedback->kind) {
    case Feedback::Kind::kFaults: return "faults";
    case Feedback::Kind::kConflict: return "conflict";
    case Feedback::Kind::kNotice: return "notice";
    case Feedback::Kind::kFailure: return "failure";
  }
  return "";
}

std::string faults_in_words(const std::vector<Error>& faults) {
  constexpr std::size_t kMost = 20;
  std::string text = "The scene cannot be used:\n";
  for (std::size_t i = 0; i < std::min(faults.size(), kMost); ++i) {
    const Error& fault = faults[i];
    text += fmt::format("- {}{}{}{}\n", fault.pointer, fault.pointer.empty() ? "" : ": ", chat::one_line(fault.message, 200),
                        fault.hint.empty() ? "" : " (" + chat::one_line(fault.hint, 200) + ")");
  }
  if (faults.size() > kMost) text += fmt::format("- and {} more\n", faults.size() - kMost);
  return text;
}

// What is wrong with its scene as the model hears it, and which function it calls then.
std::string in_words(const Feedback& feedback) {
  switch (feedback.kind) {
    case Feedback::Kind::kFaults: return faults_in_words(feedback.faults) + "Call create_scene with the whole scene, corrected.";
    case Feedback::Kind::kConflict:
      return feedback.text +
             "Call patch_scene with the one that keeps most of what the description asks for, "
             "or create_scene with the whole scene changed. Leave all else as it is.";
    case Feedback::Kind::kNotice: return "No feasible layout was found for this scene. Adjust the constraints and call create_scene again.";
    case Feedback::Kind::kFailure: return feedback.text + ". Change what may be the reason and call create_scene with the whole scene.";
  }
  return feedback.text;
}

// Waits between two attempts; not after an answer that was kept on disk. Errors: kInterrupted.
Status pause_after(const Attempt& attempt, double seconds, const std::atomic<bool>* stop) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(attempt.answer.cached ? 0.0 : seconds);
  while (Clock::now() < end) {
    if (stop != nullptr && stop->load()) return fail(ErrorCode::kInterrupted, "stopped", {}, "what was finished is kept");
    std::this_thread::sleep_for(std::min<std::chrono::duration<double>>(end - Clock::now(), std::chrono::milliseconds(50)));
  }
  return {};
}

}  // namespace

Conversation::Conversation(const Catalog& catalog, chat::ChatOptions chat, std::string text, const PlanOptions& plan, const RoomGiven& room,
                           ConversationOptions options)
    : catalog_(catalog), client_(std::move(chat)), text_(std::move(text)), plan_(plan), options_(std::move(options)) {
  auto offline = make_offline_planner(catalog)->plan(text_, plan_);
  const bool blank = text_.find_first_not_of(" \t\r\n") == std::string::npos;
  const bool edits = !options_.scene_to_edit.empty();
  if (offline && !edits) {
    offline_ = std::move(*offline);
  } else if (!offline && (blank || offline.error().code != ErrorCode::kEmpty)) {  // what is not English a model may still understand
    readable_ = Failure(offline.error());
  }
  const bool by_text = options_.trust == Trust::kText;
  settling_ = {by_text, by_text && room.size.width == 0 && room.shell == nullptr, false, by_text, {}};
  if (edits) document_ = options_.scene_to_edit;
  system_ = system_text(room, false);
  system_brief_ = system_text(room, true);
}

SchemaWanted Conversation::schema_wanted(bool brief) const {
  SchemaWanted wanted{.brief = brief, .articles = catalog_.has_articles(), .objects = named_objects(), .categories = {}};
  if (!offline_) return wanted;
  wanted.openings = std::ranges::any_of(offline_->scene.room.openings, [](const Opening& opening) { return opening.asked(); });
  for (const SceneObject& object : offline_->scene.objects) wanted.categories.insert(object.category);
  wanted.sizes = std::ranges::any_of(offline_->scene.objects, [](const SceneObject& object) { return object.size.has_value(); });
  return wanted;
}

std::string Conversation::system_text(const RoomGiven& room, bool brief) const {
  const auto schema_tokens = static_cast<std::size_t>(chat::estimated_tokens(scene_schema(schema_wanted(brief))));
  std::string text =
      make_system_prompt(catalog_, {text_, offline_ ? &offline_->scene : nullptr, room.size, room.shell, schema_tokens, brief}).text;
  if (!options_.scene_to_edit.empty()) text += std::string(kEditRules) + options_.scene_to_edit;
  return text;
}

Result<std::string> Conversation::describe_first_request() const {
  if (!readable_) return Failure(readable_.error());
  return client_.describe_request(question_for(nullptr));
}

chat::Request Conversation::question_for(const Feedback* feedback) const {
  chat::Request question = question_of(feedback, false);
  question.shorter = std::make_shared<const chat::Request>(question_of(feedback, true));
  return question;
}

chat::Request Conversation::question_of(const Feedback* feedback, bool brief) const {
  chat::Request question;
  // Another seed each time: where nothing else has changed, the same question would bring the same answer.
  question.seed = plan_.seed + attempts_.size() - (attempts_.empty() ? 0 : 1);
  const SchemaWanted wanted = schema_wanted(brief);
  const bool was_cut = last_answer_ && last_answer_->finish_reason == "length";
  question.max_response_tokens = was_cut ? options_.max_response_tokens : std::min(options_.max_response_tokens, answer_tokens(wanted));
  question.messages = {{"system", brief ? system_brief_ : system_}, {"user", quoted_request(text_)}};
  question.functions.push_back(create_scene_function(wanted));
  if (feedback == nullptr) return question;
  if (!document_.empty()) question.messages.push_back({"assistant", document_});
  question.messages.push_back({"user", in_words(*feedback)});
  if (!document_.empty() && feedback->kind == Feedback::Kind::kConflict) question.functions.push_back(patch_scene_function());
  return question;
}

Result<Proposal> Conversation::ask(const Feedback* feedback) {
  if (!readable_) return Failure(readable_.error());
  Attempt& attempt = attempts_.emplace_back();
  attempt.number = static_cast<int>(attempts_.size());
  attempt.purpose = purpose_of(feedback);
  attempt.outcome = "no answer";
  if (feedback != nullptr && (feedback->kind == Feedback::Kind::kConflict || feedback->kind == Feedback::Kind::kNotice)) {
    settling_.sizes_and_relations = false;
    settling_.open.insert(feedback->categories.begin(), feedback->categories.end());
    settling_.may_be_missing += feedback->may_go;
    settling_.room_may_grow = true;
  }
  Result<chat::Response> answer = client_.ask(question_for(feedback));
  if (!answer) {
    attempt.faults.push_back(answer.error());
    return Failure(answer.error());
  }
  attempt.answer = *answer;
  last_answer_ = std::move(*answer);
  Result<Reading> reading = read_draft(*last_answer_, catalog_, {document_, named_objects()});
  if (!reading) {
    attempt.faults.push_back(reading.error());
    return Failure(reading.error());
  }
  attempt.outcome = reading->draft ? "scene" : "faults";
  attempt.faults = reading->faults;
  Proposal proposal;
  proposal.faults = std::move(reading->faults);
  if (reading->draft) {
    attempt.mended = reading->draft->scene.notes;
    settle_differences(*reading->draft, attempt);
    proposal.repeated = proposed_ && same_document(document_, reading->draft->document);
    proposed_ = true;
    proposal.document = document_ = reading->draft->document;
    proposal.scene = std::move(reading->draft->scene);
  }
  return proposal;
}

Result<Proposal> Conversation::revise(const Feedback& feedback) {
  if (!attempts_.empty()) LAYOUTBOX_CHECK(pause_after(attempts_.back(), options_.pause_s, plan_.stop));
  return ask(&feedback);
}

void Conversation::note(ProposalOutcome result) {
  if (attempts_.empty()) return;
  Attempt& attempt = attempts_.back();
  attempt.outcome = std::move(result.outcome);
  if (!result.faults.empty()) attempt.faults = std::move(result.faults);
  attempt.conflict = std::move(result.conflict);
}

void Conversation::settle_differences(Draft& draft, Attempt& attempt) const {
  draft.scene.prompt = text_;
  if (!offline_) return;
  attempt.differences = compare_with_text(*offline_, catalog_, settling_, draft);
}

std::optional<Proposal> Conversation::salvage() const {
  if (!last_answer_) return std::nullopt;
  Result<Reading> reading = read_draft(*last_answer_, catalog_, {document_, named_objects()}, Leniency::kSalvage);
  if (!reading || !reading->draft) return std::nullopt;
  Draft& draft = *reading->draft;
  Attempt unused;
  settle_differences(draft, unused);
  return Proposal{std::move(draft.scene), std::move(draft.document), false, {}};
}

std::string Conversation::record() const { return write_attempts(attempts_); }

std::string Conversation::cost_in_words() const {
  const chat::Usage usage = client_.usage();
  const auto cost = client_.cost();
  const std::string date = client_.price_date();
  std::string price = cost && *cost > 0 ? fmt::format(", ${:.4f}", *cost) : "";
  if (!price.empty() && !date.empty()) price += " at prices of " + date;
  return fmt::format("{}, {}{}", counted(attempts_.size(), "answer"),
                     counted(static_cast<std::size_t>(usage.request_tokens + usage.response_tokens), "token"), price);
}

Error Conversation::no_usable_scene() const {
  const auto last = std::find_if(attempts_.rbegin(), attempts_.rend(), [](const Attempt& attempt) { return !attempt.faults.empty(); });
  return {ErrorCode::kNotFound,
          "the model gave no usable scene in " + counted(attempts_.size(), "answer"),
          {},
          "take another model, or the offline planner",
          last == attempts_.rend() ? std::vector<Error>{} : last->faults};
}

namespace {

// What a model sees: no walls, spaces or notes, whose rules are its own, and not whose wish a thing was.
std::string scene_to_edit(SceneGraph scene) {
  scene.notes.clear();
  for (SceneObject& object : scene.objects) {
    object.spaces.clear();
    object.spaces_given = false;
    object.used_sides.reset();
  }
  nlohmann::ordered_json document = nlohmann::ordered_json::parse(write_scene(scene));
  const auto strip = [](nlohmann::ordered_json& items) {
    for (nlohmann::ordered_json& item : items) item.erase("origin"), item.erase("assumed");
  };
  strip(document["furniture"]), strip(document["constraints"]), strip(document["room"]["openings"]);
  return format_json(document);
}

class ModelPlanner final : public Planner {
 public:
  ModelPlanner(const Catalog& catalog, chat::ChatOptions chat, ConversationOptions options)
      : catalog_(catalog), chat_(std::move(chat)), options_(std::move(options)) {}

  Result<Plan> plan(std::string_view prompt, const PlanOptions& options) const override {
    const auto planning = begin(prompt, options, {});
    for (Feedback feedback; planning->attempts() < options_.max_attempts;) {
      LAYOUTBOX_ASSIGN(Proposal proposal, planning->attempts() == 0 ? planning->propose() : planning->revise(feedback));
      if (proposal.scene) return Plan{std::move(*proposal.scene), {}, {}, {}, {}, true};
      feedback.faults = std::move(proposal.faults);
    }
    if (auto proposal = planning->salvage()) return Plan{std::move(*proposal->scene), {}, {}, {}, {}, true};
    return Failure(planning->no_usable_scene());
  }

  std::unique_ptr<Planning> begin(std::string_view prompt, const PlanOptions& options, const RoomGiven& room) const override {
    PlanOptions own = options;
    if (own.stop == nullptr) own.stop = chat_.stop;
    return std::make_unique<Conversation>(catalog_, chat_, std::string(prompt), own, room, options_);
  }

  // A change is the model's to make, whatever the text alone would say.
  std::unique_ptr<Planning> begin_change(std::string_view text, const SceneGraph& scene, const PlanOptions& options,
                                         const RoomGiven& room) const override {
    PlanOptions own = options;
    if (own.stop == nullptr) own.stop = chat_.stop;
    ConversationOptions changing = options_;
    changing.trust = Trust::kModel;
    changing.scene_to_edit = scene_to_edit(scene);
    return std::make_unique<Conversation>(catalog_, chat_, std::string(text), own, room, std::move(changing));
  }

 private:
  const Catalog& catalog_;
  chat::ChatOptions chat_;
  ConversationOptions options_;
};

}  // namespace

std::unique_ptr<Planner> make_model_planner(const Catalog& catalog, chat::ChatOptions chat, ConversationOptions options) {
  return std::make_unique<ModelPlanner>(catalog, std::move(chat), std::move(options));
}

}  // namespace layoutbox::llm

namespace layoutbox {

std::unique_ptr<Planning> Planner::begin(std::string_view, const PlanOptions&, const RoomGiven&) const { return nullptr; }
std::unique_ptr<Planning> Planner::begin_change(std::string_view, const SceneGraph&, const PlanOptions&, const RoomGiven&) const {
  return nullptr;
}

}  // namespace layoutbox
