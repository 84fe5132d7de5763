#include "layoutbox/judge/vlm/asking.h"

#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_text.h"

namespace layoutbox::vlm {
namespace {

constexpr std::string_view kSides =
    " Left and right, in front of and behind a thing are meant as its own: its front is where it is used from.";

}  // namespace

std::string views_of(const std::vector<Picture>& pictures) {
  std::string text;
  for (const Picture& picture : pictures) text += (text.empty() ? "" : ", ") + (picture.view.empty() ? "a picture" : picture.view);
  return text;
}

chat::Request request_for(Asking asking, const JudgeOptions& options) {
  chat::Request request;
  request.messages.push_back({"system", std::string(asking.task) + std::string(kSides)});
  chat::Message message{"user", std::move(asking.text)};
  for (const Picture* picture : asking.pictures) message.images.push_back({picture->media_type, picture->bytes, picture->url});
  request.messages.push_back(std::move(message));
  request.functions.push_back(std::move(asking.function));
  request.temperature = options.temperature;
  request.seed = asking.seed;
  request.max_response_tokens = 400;
  return request;
}

nlohmann::json document_of(const chat::Response& response) {
  const auto document = parse_json(response.calls.empty() ? response.content : response.calls[0].arguments);
  return document ? *document : nlohmann::json();
}

std::string member_text(const nlohmann::json& document, const char* key) {
  if (!document.is_object() || !document.contains(key) || !document.at(key).is_string()) return {};
  return document.at(key).get<std::string>();
}

}  // namespace layoutbox::vlm
