#include "layoutbox/plan/llm/record.h"

#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_text.h"

namespace layoutbox::llm {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson json_of(const Note& note) { return {{"message", note.message}, {"pointer", note.pointer}}; }

// A text of JSON as JSON, so that run.json can be read without unpacking texts.
OrderedJson unpacked(const std::string& text) {
  OrderedJson document = OrderedJson::parse(text, nullptr, false);
  return document.is_discarded() ? OrderedJson(text) : document;
}

OrderedJson json_of(const Attempt& attempt) {
  const chat::Response& answer = attempt.answer;
  OrderedJson entry{{"attempt", attempt.number}, {"purpose", attempt.purpose}, {"outcome", attempt.outcome}};
  if (!answer.request.empty()) {
    entry["mode"] = name_of(answer.mode);
    entry["request"] = unpacked(answer.request);
    entry["response"] = unpacked(answer.body);
    entry["tokens"] = {
        {"request", answer.usage.request_tokens}, {"response", answer.usage.response_tokens}, {"estimated", answer.usage.estimated}};
    entry["cost"] = answer.cost ? OrderedJson(*answer.cost) : OrderedJson();
    entry["seconds"] = answer.seconds;
    entry["ownSeconds"] = answer.own_seconds;
    entry["retries"] = answer.retries;
    entry["cached"] = answer.cached;
  }
  entry["errors"] = OrderedJson::array();
  for (const Error& fault : attempt.faults) entry["errors"].push_back(OrderedJson::parse(write_error(fault)));
  entry["mended"] = OrderedJson::array();
  for (const Note& note : attempt.mended) entry["mended"].push_back(json_of(note));
  entry["differences"] = attempt.differences;
  if (!attempt.conflict.empty()) entry["conflict"] = attempt.conflict;
  return entry;
}

}  // namespace

std::string write_attempts(const std::vector<Attempt>& attempts) {
  OrderedJson list = OrderedJson::array();
  for (const Attempt& attempt : attempts) list.push_back(json_of(attempt));
  return list.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace layoutbox::llm
