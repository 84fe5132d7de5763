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

Json json_of_notes(const std::vector<Note>& notes);
Json json_of_words(const std::vector<WordReading>& words);

Answer json_answer(const Json& body, int status = 200);

// An object as JSON text, member by member; what a stage has written as JSON goes in as it is. REQUIRES: no key given twice.
class JsonText {
 public:
  JsonText& add(std::string_view key, const Json& value);
  JsonText& add_written(std::string_view key, std::string_view json);
  JsonText& add_written(std::string_view key, const std::vector<std::string>& list);
  std::string text() const { return text_ + '}'; }
  Answer answer(int status = 200) const { return {status, "application/json", text()}; }

 private:
  std::string text_ = "{";
};

// Milliseconds since it was made, or since the last call.
class Stopwatch {
 public:
  Stopwatch();
  double lap();

 private:
  double last_;
};

}  // namespace layoutbox::serve
