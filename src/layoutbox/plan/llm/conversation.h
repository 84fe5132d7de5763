// A conversation with a model about one scene: a first question, then what was wrong with each answer until one is good.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/chat/chat_client.h"
#include "layoutbox/plan/llm/compare.h"
#include "layoutbox/plan/llm/draft.h"
#include "layoutbox/plan/llm/strict_schema.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox::llm {

struct ConversationOptions {
  Trust trust = Trust::kText;
  int max_response_tokens = 8000;  // of one answer; less where the text is short
  int max_attempts = 5;            // of plan()
  double pause_s = 1;              // before a model is asked again, unless its answer was kept on disk
  // An earlier scene to be changed, as JSON, where the text is a change to it. Empty: the text describes a room.
  std::string scene_to_edit;
};

// One question and what became of it; run.json holds them all.
struct Attempt {
  int number = 0;
  std::string purpose;    // "first", "faults", "conflict", "notice", "failure"
  chat::Response answer;  // empty where none came
  std::vector<Error> faults;
  std::vector<Note> mended;
  std::vector<std::string> differences;  // between the text and the model's scene
  std::string conflict;                  // what the solver found, empty where it found a layout
  std::string outcome;                   // "solved", "conflict", "faults", "no answer", "same as before"
};

class Conversation final : public Planning {
 public:
  // The catalogue must outlive it. `text` is the user's.
  Conversation(const Catalog& catalog, chat::ChatOptions chat, std::string text, const PlanOptions& plan, const RoomGiven& room,
               ConversationOptions options);

  // What would be asked first: method, address, headers without the key, and body.
  Result<std::string> describe_first_request() const override;

  // Both add to the attempts in any case. Errors: those of ChatClient::ask, and kNotFound for a refusal. A blank text is kEmpty, one that
  // is too long kTooLarge.
  Result<Proposal> propose() override { return ask(nullptr); }
  // Errors: also kInterrupted, within a twentieth of a second of `stop`, while it waits.
  Result<Proposal> revise(const Feedback& feedback) override;

  std::optional<Proposal> salvage() const override;
  void note(ProposalOutcome result) override;
  int attempts() const override { return static_cast<int>(attempts_.size()); }
  std::string record() const override;
  std::string cost_in_words() const override;
  Error no_usable_scene() const override;

 private:
  Result<Proposal> ask(const Feedback* feedback);
  chat::Request question_for(const Feedback* feedback) const;
  chat::Request question_of(const Feedback* feedback, bool brief) const;
  SchemaWanted schema_wanted(bool brief) const;
  std::size_t named_objects() const { return offline_ ? offline_->scene.objects.size() : 0; }
  std::string system_text(const RoomGiven& room, bool brief) const;
  void settle_differences(Draft& draft, Attempt& attempt) const;

  const Catalog& catalog_;
  chat::ChatClient client_;
  std::string text_;
  PlanOptions plan_;
  ConversationOptions options_;
  std::optional<Plan> offline_;  // how the offline planner reads the text
  Status readable_;              // of the text
  std::string system_, system_brief_;
  std::string document_;   // of the last draft
  bool proposed_ = false;  // the document is a draft of the model's
  std::optional<chat::Response> last_answer_;
  Settling settling_;  // what the text still decides
  std::vector<Attempt> attempts_;
};

// The planner by model. Each planning has a client of its own; all draw on the one spend_limit of `chat`. plan() asks again while the
// answers do not validate. The catalogue must outlive the planner.
std::unique_ptr<Planner> make_model_planner(const Catalog& catalog, chat::ChatOptions chat, ConversationOptions options);

}  // namespace layoutbox::llm
