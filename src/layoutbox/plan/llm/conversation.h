// A conversation with a model about one scene: a first question, then what was wrong with each answer until one is good.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <set>
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
  // An earlier scene to be changed, as JSON, where the text is a change to it. Empty: the text describes a room.
  std::string scene_to_edit;
};

// Why a model is asked again.
struct Complaint {
  enum class Kind {
    kFaults,    // the answer does not validate
    kConflict,  // no layout exists: the reason and ways out
    kNotice,    // no layout exists, without a reason: as the paper does
    kFailure,   // the script or the picture failed
  } kind = Kind::kFaults;
  std::string text;
  // kConflict: of what takes part, which the model may leave out against the text, and how many things that takes at most.
  std::set<std::string> categories;
  std::size_t may_go = 0;
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

class Conversation {
 public:
  // The catalogue must outlive it. `text` is the user's.
  Conversation(const Catalog& catalog, chat::ChatOptions chat, std::string text, const PlanOptions& plan, const RoomGiven& room,
               ConversationOptions options);

  // What would be asked first: method, address, headers without the key, and body. Errors: those of the text.
  Result<std::string> describe_first_request() const;

  // Asks, the first time or again. The attempt is added to attempts() in any case. Errors: those of ChatClient::ask, and kNotFound for a
  // refusal. A blank text is kEmpty, one that is too long kTooLarge.
  Result<Reading> ask(const std::optional<Complaint>& complaint = std::nullopt);

  // The last answer that was JSON at all, with everything left out that is wrong in it; empty where there was none.
  std::optional<Draft> salvage() const;

  std::vector<Attempt>& attempts() { return attempts_; }
  const chat::ChatClient& client() const { return client_; }
  const Catalog& catalog() const { return catalog_; }

 private:
  chat::Request question_for(const std::optional<Complaint>& complaint) const;
  chat::Request question_of(const std::optional<Complaint>& complaint, bool brief) const;
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
  std::string document_;  // of the last draft
  std::optional<chat::Response> last_answer_;
  Settling settling_;  // what the text still decides
  std::vector<Attempt> attempts_;
};

// How often a model is asked, and how long it is left alone in between.
struct Patience {
  int max_attempts = 5;
  double pause_s = 1;
};

// Waits between two attempts; not after an answer that was kept on disk. Errors: kInterrupted within a twentieth of a second of `stop`.
Status pause_after(const Attempt& attempt, double seconds, const std::atomic<bool>* stop);

// The planner by model. Each conversation has a client of its own; all draw on the one spend_limit of `chat`. plan() asks again as patience
// says while the answers do not validate. The catalogue must outlive the planner.
std::unique_ptr<Planner> make_model_planner(const Catalog& catalog, chat::ChatOptions chat, ConversationOptions options, Patience patience);

// After the last attempt: what was wrong with its answer is in the details.
Error no_usable_answer(int attempts, const std::vector<Error>& faults);

// What is wrong with an answer, as the model hears it.
Complaint complaint_of(const std::vector<Error>& faults);

}  // namespace layoutbox::llm
