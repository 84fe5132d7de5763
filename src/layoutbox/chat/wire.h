// The chat-completions form: a question to the bytes of a request, the bytes of an answer to an Answer.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "layoutbox/chat/chat.h"
#include "layoutbox/chat/http_client.h"
#include "layoutbox/chat/tokens.h"

namespace layoutbox::chat {

// What is known of a server and a model: which parameters it does not take.
struct Habits {
  Mode mode = Mode::kStrictTools;
  bool known = false;             // the mode has worked before
  Capacity capacity;              // what it can hold
  std::set<std::string> without;  // "temperature", "seed", "max_completion_tokens", "tool_choice", "named_tool", "response_format"
};

// The body of the request; of a question that the model cannot hold a shorter form.
std::string write_request(const Question& asked, const std::string& model, const Habits& habits, bool stream);

struct ServerError {
  std::string message, parameter, code;
  std::int64_t context = 0;  // tokens that the model can hold, where the error says so in a member of its own (llama.cpp)
};

// What came with status 2xx.
struct ReadAnswer {
  enum class Kind {
    kAnswer,
    kCut,     // a stream without its end
    kBroken,  // empty, no JSON, not UTF-8, or nothing in it that is an answer
    kPage,    // a web page: some other server answered
    kError,   // an error object in spite of the status
  } kind = Kind::kBroken;
  Answer answer;
  ServerError error;  // kError; and what is wrong with a kBroken
};

ReadAnswer read_answer(const HttpResponse& response);

// The error object of an answer that is none; the beginning of its text where it has no such object.
ServerError read_error(std::string_view body);

}  // namespace layoutbox::chat
