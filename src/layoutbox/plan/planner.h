// Text to scene graph. Two implementations: plan/offline (no model, no network) and plan/llm (function calling).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

struct PlanOptions {
  // DEFAULT: 1. Only models use it; the offline planner has no randomness.
  std::uint64_t seed = 1;
  // Longest prompt that is read, in bytes. REQUIRES: > 0.
  std::size_t max_prompt_bytes = 1'000'000;
  // DEFAULT: none. Ends the offline planner's reading when it becomes true.
  const std::atomic<bool>* stop = nullptr;
};

// How one word of the prompt was read; `plan --explain` prints them.
struct WordReading {
  enum class Use { kUsed, kIgnored, kNotUnderstood };
  std::size_t begin = 0, end = 0;  // byte places in the prompt
  Use use = Use::kUsed;
  std::string role;  // "object bed_1", "count of chair", "relation c3", "filler", …
};

// Words that were nearly as likely to be meant in another way; `plan --explain` prints them.
struct CloseReading {
  std::size_t begin = 0, end = 0;  // byte places in the prompt
  std::string taken, other;        // how they were read, and how else: "is said of “a lamp”"
};

// Things of one mention that stand along walls; `open`: the text leaves open how many they are.
struct Lining {
  std::vector<std::string> ids;
  bool open = false;
  bool one_wall = false;
};

struct Plan {
  SceneGraph scene;                   // not yet normalised
  std::vector<WordReading> readings;  // every word of the prompt once, in order (offline planner)
  std::vector<CloseReading> close;    // (offline planner)
  std::vector<std::string> unwanted;  // kinds of which the text wants none ("no coffee table"), catalogue ids (offline planner)
  std::vector<Lining> linings;        // (offline planner)
  bool by_model = false;              // a model names all that it wants: nothing comes with it
};

// What the room is, where it is given beside the text.
struct RoomGiven {
  Size size{};                  // millimetres; 0: not given
  const Room* shell = nullptr;  // the user's own room, or null
};

// Why a scene goes back to who planned it.
struct Feedback {
  enum class Kind {
    kFaults,    // it cannot be used
    kConflict,  // it has no layout: the reason and ways out
    kNotice,    // it has no layout, without a reason: as the paper does
    kFailure,   // its script or its picture failed
  } kind = Kind::kFaults;
  std::string text;           // what is wrong; kFaults, kNotice: empty
  std::vector<Error> faults;  // kFaults
  // kConflict: of what takes part, which may be left out against the prompt, and how many things that takes at most.
  std::set<std::string> categories;
  std::size_t may_go = 0;
};

// What came of a proposal, for the record.
struct ProposalOutcome {
  std::string outcome;        // "solved", "conflict", "faults", "same as before"
  std::vector<Error> faults;  // what the scene was found unusable for
  std::string conflict;       // what the solver found, empty where it found a layout
};

// A scene, or what is wrong with the one that was made.
struct Proposal {
  std::optional<SceneGraph> scene;  // not yet normalised
  std::string document;             // the scene as JSON as the planner wrote it: to which a change of it refers
  bool repeated = false;            // it is the scene proposed before
  std::vector<Error> faults;
};

// One prompt in the hands of a planner that can be told what is wrong with its scene. One thread at a time.
class Planning {
 public:
  virtual ~Planning() = default;
  // The first scene. Errors: those of Planner::plan().
  virtual Result<Proposal> propose() = 0;
  // Another one, after what is wrong with the last. Errors: the same.
  virtual Result<Proposal> revise(const Feedback& feedback) = 0;
  // The last proposal with everything left out that is wrong in it; empty where there was none.
  virtual std::optional<Proposal> salvage() const = 0;

  // What became of the last proposal.
  virtual void note(ProposalOutcome result) = 0;
  // Scenes that were asked for so far, those that did not come included.
  virtual int attempts() const = 0;
  // What was asked and answered, as run.json keeps it: a list, as JSON.
  virtual std::string record() const = 0;
  // What it took, for people: "2 answers, 9123 tokens".
  virtual std::string cost_in_words() const = 0;
  // That nothing usable came of it, and what was wrong with the last proposal.
  virtual Error no_usable_scene() const = 0;
  // What is asked of others first, in full. Errors: those of the prompt.
  virtual Result<std::string> describe_first_request() const = 0;
};

class Planner {
 public:
  virtual ~Planner() = default;
  // Errors: kEmpty (nothing in the prompt), kTooLarge, kParse (not UTF-8), kInterrupted; of a model also kNetwork, kNotFound.
  virtual Result<Plan> plan(std::string_view prompt, const PlanOptions& options) const = 0;

  // Takes a prompt in hand; null: this planner has one answer, that of plan(). The planner must outlive what it gives out. May be called
  // from several threads.
  virtual std::unique_ptr<Planning> begin(std::string_view prompt, const PlanOptions& options, const RoomGiven& room) const;
  // The same for a text that changes a room: `scene` as it stands, with the places of its things. Null: this planner changes none.
  virtual std::unique_ptr<Planning> begin_change(std::string_view text, const SceneGraph& scene, const PlanOptions& options,
                                                 const RoomGiven& room) const;
};

// The catalogue must outlive the planner.
std::unique_ptr<Planner> make_offline_planner(const Catalog& catalog);

}  // namespace layoutbox
