#include "layoutbox/serve/call_parts.h"

#include <chrono>

#include "layoutbox/scene/json_documents.h"

namespace layoutbox::serve {
namespace {

double now_ms() { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::string text_of(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

// The error of a part of the request, with its place in the whole.
Error below(Error error, const std::string& key) {
  error.pointer = "/" + key + error.pointer;
  for (Error& detail : error.details) detail = below(std::move(detail), key);
  return error;
}

template <class T>
Result<T> placed(Result<T> result, const char* key) {
  if (!result) return Failure(below(std::move(result).error(), key));
  return result;
}

}  // namespace

Result<Layout> layout_of(const Json& request, const char* key) { return placed(layout_from_json(request.at(key)), key); }

Result<SceneGraph> scene_of_request(const Json& request, const char* key) { return placed(scene_from_json(request.at(key)), key); }

SolveOptions solve_options(const Json& request, const Surroundings& around) {
  SolveOptions options;
  options.seed = request.value("seed", options.seed);
  options.effort = request.value("effort", options.effort);
  options.time_limit_s = request.value("timeLimit", 10.0);
  if (request.value("onConflict", "relax") == "fail") options.on_conflict = OnConflict::kFail;
  options.locked = request.value("locked", options.locked);
  options.stop = around.stop;
  options.on_progress = around.on_progress;
  return options;
}

Result<GenerateOptions> generate_options(const Json& request, const Surroundings& around) {
  GenerateOptions options;
  options.companions = request.value("companions", options.companions);
  options.variants = request.value("variants", 1);
  options.plan.stop = around.stop;
  options.stop = around.stop;
  options.solve = solve_options(request, around);
  if (request.contains("room")) {
    auto room = placed(room_from_json(request.at("room")), "room");
    if (!room) return Failure(std::move(room).error());
    options.shell = *std::move(room);
  }
  return options;
}

Json json_of_notes(const std::vector<Note>& notes) {
  Json list = Json::array();
  for (const Note& note : notes) list.push_back({{"code", note.code}, {"message", note.message}, {"pointer", note.pointer}});
  return list;
}

Json json_of_words(const std::vector<WordReading>& words) {
  const auto name = [](WordReading::Use use) {
    return use == WordReading::Use::kUsed ? "used" : use == WordReading::Use::kIgnored ? "ignored" : "notUnderstood";
  };
  Json list = Json::array();
  for (const WordReading& word : words) {
    list.push_back({{"begin", word.begin}, {"end", word.end}, {"use", name(word.use)}, {"role", word.role}});
  }
  return list;
}

Answer json_answer(const Json& body, int status) { return {status, "application/json", text_of(body)}; }

JsonText& JsonText::add(std::string_view key, const Json& value) { return add_written(key, text_of(value)); }

JsonText& JsonText::add_written(std::string_view key, std::string_view json) {
  if (text_.size() > 1) text_ += ',';
  ((text_ += '"') += key) += "\":";
  text_ += json;
  return *this;
}

JsonText& JsonText::add_written(std::string_view key, const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& item : list) (text += text.empty() ? '[' : ',') += item;
  return add_written(key, text.empty() ? "[]" : text + ']');
}

Stopwatch::Stopwatch() : last_(now_ms()) {}

double Stopwatch::lap() {
  const double before = last_;
  last_ = now_ms();
  return last_ - before;
}

}  // namespace layoutbox::serve
