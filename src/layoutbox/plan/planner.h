// Text to scene graph. Two implementations: plan/offline (no model, no network) and plan/llm (function calling).
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

namespace llm {
class Conversation;
}

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

struct Plan {
  SceneGraph scene;                   // not yet normalised
  std::vector<WordReading> readings;  // every word of the prompt once, in order (offline planner)
  std::vector<CloseReading> close;    // (offline planner)
  std::vector<std::string> unwanted;  // kinds of which the text wants none ("no coffee table"), catalogue ids (offline planner)
};

// What the room is, where it is given beside the text.
struct RoomGiven {
  Size size{};                  // millimetres; 0: not given
  const Room* shell = nullptr;  // the user's own room, or null
};

class Planner {
 public:
  virtual ~Planner() = default;
  // Errors: kEmpty (nothing in the prompt), kTooLarge, kParse (not UTF-8), kInterrupted; of a model also kNetwork, kNotFound.
  virtual Result<Plan> plan(std::string_view prompt, const PlanOptions& options) const = 0;

  // A planner that can be told what is wrong with its scene begins a conversation; null: it has one answer, that of plan().
  // The planner must outlive the conversation. May be called from several threads.
  virtual std::unique_ptr<llm::Conversation> converse(std::string_view prompt, const PlanOptions& options, const RoomGiven& room) const;
};

// The catalogue must outlive the planner.
std::unique_ptr<Planner> make_offline_planner(const Catalog& catalog);

}  // namespace layoutbox
