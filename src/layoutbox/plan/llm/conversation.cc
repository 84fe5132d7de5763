#include "layoutbox/plan/llm/conversation.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "layoutbox/base/words.h"
#include "layoutbox/chat/tokens.h"
#include "layoutbox/plan/llm/functions.h"
#include "layoutbox/plan/llm/prompt.h"

namespace layoutbox::llm {
namespace {

constexpr std::string_view kEditRules =
    "\n\nThe request is a change to the scene below. Hand over the whole scene after the change; leave everything else as it is, ids and "
    "xform.pos above all.\nThe scene:\n";

const char* purpose_of(const std::optional<Complaint>& complaint) {
  if (!complaint) return "first";
  switch (complaint->kind) {
    case Complaint::Kind::kFaults: return "faults";
    case Complaint::Kind::kConflict: return "conflict";
    case Complaint::Kind::kNotice: return "notice";
    case Complaint::Kind::kFailure: return "failure";
  }
  return "";
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
  return client_.describe_request(question_for(std::nullopt));
}

chat::Request Conversation::question_for(const std::optional<Complaint>& complaint) const {
  chat::Request question = question_of(complaint, false);
  question.shorter = std::make_shared<const chat::Request>(question_of(complaint, true));
  return question;
}

chat::Request Conversation::question_of(const std::optional<Complaint>& complaint, bool brief) const {
  chat::Request question;
  // Another seed each time: where nothing else has changed, the same question would bring the same answer.
  question.seed = plan_.seed + attempts_.size() - (attempts_.empty() ? 0 : 1);
  const SchemaWanted wanted = schema_wanted(brief);
  const bool was_cut = last_answer_ && last_answer_->finish_reason == "length";
  question.max_response_tokens = was_cut ? options_.max_response_tokens : std::min(options_.max_response_tokens, answer_tokens(wanted));
  question.messages = {{"system", brief ? system_brief_ : system_}, {"user", quoted_request(text_)}};
  question.functions.push_back(create_scene_function(wanted));
  if (!complaint) return question;
  if (!document_.empty()) question.messages.push_back({"assistant", document_});
  question.messages.push_back({"user", complaint->text});
  if (!document_.empty() && complaint->kind == Complaint::Kind::kConflict) question.functions.push_back(patch_scene_function());
  return question;
}

Result<Reading> Conversation::ask(const std::optional<Complaint>& complaint) {
  if (!readable_) return Failure(readable_.error());
  Attempt& attempt = attempts_.emplace_back();
  attempt.number = static_cast<int>(attempts_.size());
  attempt.purpose = purpose_of(complaint);
  attempt.outcome = "no answer";
  if (complaint && (complaint->kind == Complaint::Kind::kConflict || complaint->kind == Complaint::Kind::kNotice)) {
    settling_.sizes_and_relations = false;
    settling_.open.insert(complaint->categories.begin(), complaint->categories.end());
    settling_.may_be_missing += complaint->may_go;
    settling_.room_may_grow = true;
  }
  Result<chat::Response> answer = client_.ask(question_for(complaint));
  if (!answer) {
    attempt.faults.push_back(answer.error());
    return Failure(answer.error());
  }
  attempt.answer = *answer;
  last_answer_ = std::move(*answer);
  Result<Reading> reading = read_draft(*last_answer_, catalog_, {document_, named_objects()});
  if (!reading) {
    attempt.faults.push_back(reading.error());
    return reading;
  }
  attempt.outcome = reading->draft ? "scene" : "faults";
  attempt.faults = reading->faults;
  if (reading->draft) {
    attempt.mended = reading->draft->scene.notes;
    settle_differences(*reading->draft, attempt);
    document_ = reading->draft->document;
  }
  return reading;
}

void Conversation::settle_differences(Draft& draft, Attempt& attempt) const {
  draft.scene.prompt = text_;
  if (!offline_) return;
  attempt.differences = compare_with_text(*offline_, catalog_, settling_, draft);
}

std::optional<Draft> Conversation::salvage() const {
  if (!last_answer_) return std::nullopt;
  const Result<Reading> reading = read_draft(*last_answer_, catalog_, {document_, named_objects()}, Leniency::kSalvage);
  if (!reading || !reading->draft) return std::nullopt;
  Draft draft = *reading->draft;
  Attempt unused;
  settle_differences(draft, unused);
  return draft;
}

Complaint complaint_of(const std::vector<Error>& faults) {
  constexpr std::size_t kMost = 20;
  Complaint complaint;
  complaint.text = "The scene cannot be used:\n";
  for (std::size_t i = 0; i < std::min(faults.size(), kMost); ++i) {
    const Error& fault = faults[i];
    complaint.text += fmt::format("- {}{}{}{}\n", fault.pointer, fault.pointer.empty() ? "" : ": ", chat::one_line(fault.message, 200),
                                  fault.hint.empty() ? "" : " (" + chat::one_line(fault.hint, 200) + ")");
  }
  if (faults.size() > kMost) complaint.text += fmt::format("- and {} more\n", faults.size() - kMost);
  complaint.text += "Call create_scene with the whole scene, corrected.";
  return complaint;
}

namespace {

class ModelPlanner final : public Planner {
 public:
  ModelPlanner(const Catalog& catalog, chat::ChatOptions chat, ConversationOptions options, Patience patience)
      : catalog_(catalog), chat_(std::move(chat)), options_(std::move(options)), patience_(patience) {}

  Result<Plan> plan(std::string_view prompt, const PlanOptions& options) const override {
    const auto conversation = converse(prompt, options, {});
    std::optional<Complaint> complaint;
    std::vector<Error> faults;
    for (int attempt = 0; attempt < patience_.max_attempts; ++attempt) {
      if (attempt > 0) LAYOUTBOX_CHECK(pause_after(conversation->attempts().back(), patience_.pause_s, chat_.stop));
      LAYOUTBOX_ASSIGN(Reading reading, conversation->ask(complaint));
      if (reading.draft) return Plan{std::move(reading.draft->scene), {}, {}, {}};
      complaint = complaint_of(reading.faults);
      faults = std::move(reading.faults);
    }
    if (auto draft = conversation->salvage()) return Plan{std::move(draft->scene), {}, {}, {}};
    return Failure(no_usable_answer(patience_.max_attempts, faults));
  }

  std::unique_ptr<Conversation> converse(std::string_view prompt, const PlanOptions& options, const RoomGiven& room) const override {
    return std::make_unique<Conversation>(catalog_, chat_, std::string(prompt), options, room, options_);
  }

 private:
  const Catalog& catalog_;
  chat::ChatOptions chat_;
  ConversationOptions options_;
  Patience patience_;
};

}  // namespace

Status pause_after(const Attempt& attempt, double seconds, const std::atomic<bool>* stop) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(attempt.answer.cached ? 0.0 : seconds);
  while (Clock::now() < end) {
    if (stop != nullptr && stop->load()) return fail(ErrorCode::kInterrupted, "stopped", {}, "what was finished is kept");
    std::this_thread::sleep_for(std::min<std::chrono::duration<double>>(end - Clock::now(), std::chrono::milliseconds(50)));
  }
  return {};
}

Error no_usable_answer(int attempts, const std::vector<Error>& faults) {
  Error error{ErrorCode::kNotFound,
              fmt::format("the model gave no usable scene in {}", counted(static_cast<std::size_t>(attempts), "answer")),
              {},
              "take another model, or the offline planner",
              faults};
  return error;
}

std::unique_ptr<Planner> make_model_planner(const Catalog& catalog, chat::ChatOptions chat, ConversationOptions options,
                                            Patience patience) {
  return std::make_unique<ModelPlanner>(catalog, std::move(chat), std::move(options), patience);
}

}  // namespace layoutbox::llm

namespace layoutbox {

std::unique_ptr<llm::Conversation> Planner::converse(std::string_view, const PlanOptions&, const RoomGiven&) const { return nullptr; }

}  // namespace layoutbox
