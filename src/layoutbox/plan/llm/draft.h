// What a model handed over, read, mended and judged.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/chat/chat.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::llm {

// A scene that validates. Its notes say what was mended.
struct Draft {
  std::string document;  // the scene as JSON after mending: what a patch of the model refers to
  SceneGraph scene;      // not yet normalised; without positions where the model gave none
};

// Either a draft, or what is wrong with the answer, for the model to hear.
struct Reading {
  std::optional<Draft> draft;
  std::vector<Error> faults;
};

// `previous` and `named` of read_draft.
struct Known {
  std::string_view previous;  // the document of the last draft, to which a patch applies; empty where there is none
  std::size_t named = 0;      // how many things the text names; 0: not known
};

enum class Leniency {
  kNormal,   // small faults are mended, larger ones are faults
  kSalvage,  // what cannot be mended is left out, and noted: for when the model will not be asked again
};

// An answer that was cut off counts as far as it is whole, where that holds as many things as the text names, or in salvage.
// Errors (kNotFound) only for what asking again cannot change: a refusal, an answer that a filter held back.
Result<Reading> read_draft(const chat::Response& answer, const Catalog& catalog, const Known& known, Leniency leniency = Leniency::kNormal);

// The same from a document alone.
Reading read_document(std::string document, const Catalog& catalog, std::vector<Note> notes, Leniency leniency);

// True when two documents say the same scene, whatever the order of members and the spaces.
bool same_document(std::string_view a, std::string_view b);

}  // namespace layoutbox::llm
