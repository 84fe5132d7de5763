// Cloudinary's signed upload.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "layoutbox/publish/crypto.h"
#include "layoutbox/publish/upload.h"

namespace layoutbox::publish {
namespace {

struct Account {
  Address endpoint;
  std::string cloud, key, secret;
  bool sha256 = false;  // else SHA-1, the usual setting of an account
};

std::string part(std::string_view boundary, std::string_view head, std::string_view body) {
  return fmt::format("--{}\r\nContent-Disposition: form-data; {}\r\n\r\n{}\r\n", boundary, head, body);
}

class CloudinaryPublisher final : public Publisher {
 public:
  CloudinaryPublisher(Account account, const Crypto& crypto, Settings settings)
      : account_(std::move(account)), crypto_(crypto), settings_(std::move(settings)) {}

  Result<std::string> publish(const File& file, const std::atomic<bool>* stop) override {
    const std::string name = name_for(file);
    std::map<std::string, std::string> fields{{"public_id", "layoutbox/" + name.substr(0, name.find('.'))}, {"timestamp", time_seconds()}};
    std::string text;
    for (const auto& [field, value] : fields) text += fmt::format("{}{}={}", text.empty() ? "" : "&", field, value);
    fields["signature"] = hex(account_.sha256 ? crypto_.sha256(text + account_.secret) : crypto_.sha1(text + account_.secret));
    fields["api_key"] = account_.key;
    const std::string boundary = "layoutbox-" + hex(crypto_.sha256(file.bytes));
    chat::HttpRequest http;
    http.url = fmt::format("{}://{}{}/v1_1/{}/image/upload", account_.endpoint.scheme, account_.endpoint.host, account_.endpoint.path,
                           account_.cloud);
    http.headers = {"Content-Type: multipart/form-data; boundary=" + boundary, "Expect:"};
    for (const auto& [field, value] : fields) http.body += part(boundary, fmt::format("name=\"{}\"", field), value);
    http.body += part(boundary, fmt::format("name=\"file\"; filename=\"{}\"\r\nContent-Type: {}", name, file.media_type), file.bytes);
    http.body += "--" + boundary + "--\r\n";
    LAYOUTBOX_ASSIGN(const std::string answer, send(http, settings_, stop));
    const auto document = nlohmann::json::parse(answer, nullptr, false);
    if (document.is_object() && document.contains("secure_url") && document["secure_url"].is_string()) {
      return document["secure_url"].get<std::string>();
    }
    return fail(ErrorCode::kNetwork, "the picture was not published: the answer holds no secure_url", "--publish");
  }

 private:
  Account account_;
  const Crypto& crypto_;
  Settings settings_;
};

}  // namespace

Result<std::unique_ptr<Publisher>> make_cloudinary_publisher(Settings settings) {
  LAYOUTBOX_ASSIGN(const Crypto* crypto, Crypto::get());
  LAYOUTBOX_ASSIGN(const std::string url, settings.need("CLOUDINARY_URL", true));
  constexpr std::string_view kScheme = "cloudinary://";
  const std::size_t colon = url.find(':', kScheme.size()), at = url.rfind('@');
  if (!url.starts_with(kScheme) || colon == std::string::npos || at == std::string::npos || at < colon || at + 1 == url.size()) {
    return fail(ErrorCode::kUsage, "CLOUDINARY_URL is not of the form cloudinary://KEY:SECRET@CLOUD", "--publish");
  }
  Account account;
  account.key = url.substr(kScheme.size(), colon - kScheme.size());
  account.secret = url.substr(colon + 1, at - colon - 1);
  account.cloud = url.substr(at + 1);
  if (account.cloud.find_first_of("/?#") != std::string::npos) account.cloud.resize(account.cloud.find_first_of("/?#"));
  settings.hide(account.secret);
  settings.hide(account.key);
  account.sha256 = settings.get({"CLOUDINARY_SIGNATURE_ALGORITHM"}) == "sha256";
  const std::string endpoint = settings.get({"LAYOUTBOX_CLOUDINARY_ENDPOINT"});
  LAYOUTBOX_ASSIGN(account.endpoint,
                   read_address(endpoint.empty() ? "https://api.cloudinary.com" : endpoint, "LAYOUTBOX_CLOUDINARY_ENDPOINT"));
  return std::make_unique<CloudinaryPublisher>(std::move(account), *crypto, std::move(settings));
}

}  // namespace layoutbox::publish
