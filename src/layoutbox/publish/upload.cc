#include "layoutbox/publish/upload.h"

#include <fmt/format.h>

#include <ctime>

#include "layoutbox/base/bytes.h"
#include "layoutbox/chat/endpoint.h"

namespace layoutbox::publish {
namespace {

bool is_this_machine(std::string_view host) {
  const std::string_view name = host.substr(0, host.starts_with('[') ? host.find(']') + 1 : host.find(':'));
  return name == "localhost" || name == "127.0.0.1" || name == "[::1]" || name.ends_with(".localhost");
}

// Of an error as S3 writes it <Message>…</Message>, as Cloudinary does {"error": {"message": …}}: its beginning says enough.
std::string words_of(const std::string& body) {
  for (const auto& [begin, end] : {std::pair{"<Message>", "</Message>"}, {"\"message\":\"", "\""}, {"\"message\": \"", "\""}}) {
    const std::size_t at = body.find(begin);
    if (at == std::string::npos) continue;
    const std::size_t from = at + std::string_view(begin).size();
    return body.substr(from, body.find(end, from) - from);
  }
  return body;
}

}  // namespace

Result<Address> read_address(const std::string& text, std::string_view setting) {
  const auto bad = [&](std::string_view why) { return fail(ErrorCode::kUsage, fmt::format("{} {}", setting, why), std::string(setting)); };
  const std::size_t colon = text.find("://");
  if (colon == std::string::npos) return bad("is no address: it begins with https://");
  Address address;
  address.scheme = text.substr(0, colon);
  const std::size_t slash = text.find('/', colon + 3);
  address.host = text.substr(colon + 3, slash == std::string::npos ? slash : slash - colon - 3);
  if (slash != std::string::npos) address.path = text.substr(slash);
  while (address.path.ends_with('/')) address.path.pop_back();
  if (address.host.empty() || text.find_first_of(" \t\r\n") != std::string::npos) return bad("is no address");
  if (address.host.find('@') != std::string::npos) return bad("carries a password: set it apart");
  if (address.scheme != "https" && !(address.scheme == "http" && is_this_machine(address.host))) return bad("must begin with https://");
  return address;
}

std::string name_for(const File& file) { return content_key(file.bytes) + (file.media_type == "image/jpeg" ? ".jpg" : ".png"); }

Result<std::string> send(const chat::HttpRequest& request, const Settings& settings, const std::atomic<bool>* stop) {
  chat::HttpClient client;
  const auto response = client.post(request, stop);
  const auto error = [&](const std::string& why) {
    return fail(ErrorCode::kNetwork, "the picture was not published: " + settings.without_secrets(chat::one_line(why)), "--publish");
  };
  if (!response) {
    if (response.error().fault == chat::HttpFault::kStopped) return fail(ErrorCode::kInterrupted, "stopped");
    return error(response.error().message);
  }
  if (response->status >= 300 && response->status < 400) return error("the server sends to another address; a wrong region or endpoint");
  if (response->status < 200 || response->status > 299)
    return error(fmt::format("status {}: {}", response->status, words_of(response->body)));
  return response->body;
}

std::string time_text() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[20] = "";
  std::strftime(text, sizeof text, "%Y%m%dT%H%M%SZ", &parts);
  return text;
}

std::string time_seconds() { return std::to_string(std::time(nullptr)); }

}  // namespace layoutbox::publish
