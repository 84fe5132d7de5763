// What several calls read from a request and put into an answer.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/pipeline/generate.h"
#include "layoutbox/serve/calls.h"

namespace layoutbox::serve {

using Json = nlohmann::json;

// The document under `key`, read as a layout or scene; pointers of errors begin with "/key".
Result<Layout> layout_of(const Json& request, const char* key = "layout");
Result<SceneGraph> scene_of_request(const Json& request, const char* key = "scene");

// seed, effort, timeLimit, onConflict, locked and the stop flag.
SolveOptions solve_options(const Json& request, const Surroundings& around);
// Companions and the user's own room.
Result<GenerateOptions> generate_options(const Json& request, const Surroundings& around);

Json json_of_layout(const Layout& layout);
Json json_of_report(const Report& report);
Json json_of_notes(const std::vector<Note>& notes);
Json json_of_words(const std::vector<WordReading>& words);

Answer json_answer(const Json& body, int status = 200);

// Milliseconds since it was made, or since the last call.
class Stopwatch {
 public:
  Stopwatch();
  double lap();

 private:
  double last_;
};

}  // namespace layoutbox::serve
