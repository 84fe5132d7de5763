// Yes-no questions about a room, each with the truth that geometry gives: single relations, and several that must all hold. Every question
// that is true has one beside it that is false, so that who says yes to everything is right half of the time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox::vlm {

enum class QuestionKind { kSingle, kMulti };
std::string_view name_of(QuestionKind kind);

// One relation of a question, and what the verifier says of it.
struct Hop {
  Relation relation;
  std::string sentence;  // "the desk stands to the left of the bed"
  bool holds = false;
  std::string why;  // what was measured
  // The same, measured in the .blend that the picture was drawn from; empty where that was not read.
  std::optional<bool> in_blend = {};
  std::string why_in_blend = {};
};

struct RoomQuestion {
  std::string id;  // "s1", "s1-false", "m1"…
  QuestionKind kind = QuestionKind::kSingle;
  std::string text;
  std::vector<Hop> hops;
  bool truth = false;    // all hops hold
  bool written = false;  // its words are a model's
};

struct QuestionOptions {
  std::uint64_t seed = 1;
  int singles = 2;  // and as many false ones
  int multis = 1;   // over four relations each, and as many false ones
};

// Relations are the layout's own that were asked for; where they are too few, others that hold are read from the room. A room with fewer
// than two objects has none. The same options give the same questions.
std::vector<RoomQuestion> draw_questions(const Layout& layout, const Catalog& catalog, const QuestionOptions& options);

// Measures each relation of the questions once more in the room as it was read back from its .blend: things are found by their ids, one
// that is not there fails its relations.
void measure_in_blend(std::vector<RoomQuestion>& questions, const Layout& layout, const Layout& read_back, const Catalog& catalog);

// "the desk stands to the left of the bed"; empty where a relation has a parameter that its sentence cannot say.
std::string sentence_of(const Relation& relation, const Layout& layout);

}  // namespace layoutbox::vlm
