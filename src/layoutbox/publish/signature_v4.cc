#include "layoutbox/publish/signature_v4.h"

#include <fmt/format.h>

namespace layoutbox::publish {
namespace {

constexpr std::string_view kAlgorithm = "AWS4-HMAC-SHA256";

std::string scope_of(const S3Request& request, const S3Key& key) {
  return fmt::format("{}/{}/s3/aws4_request", request.time.substr(0, 8), key.region);
}

std::string query_text(const std::map<std::string, std::string>& query) {
  std::string text;
  for (const auto& [name, value] : query)
    text += fmt::format("{}{}={}", text.empty() ? "" : "&", escaped(name, false), escaped(value, false));
  return text;
}

std::map<std::string, std::string> signed_headers(const S3Request& request) {
  std::map<std::string, std::string> headers = request.headers;
  headers["host"] = request.host;
  return headers;
}

std::string names_of(const std::map<std::string, std::string>& headers) {
  std::string names;
  for (const auto& [name, value] : headers) names += (names.empty() ? "" : ";") + name;
  return names;
}

std::string signature_of(const S3Request& request, const S3Key& key, const Crypto& crypto) {
  const auto headers = signed_headers(request);
  std::string canonical = fmt::format("{}\n{}\n{}\n", request.method, request.path, query_text(request.query));
  for (const auto& [name, value] : headers) canonical += name + ":" + value + "\n";
  canonical += "\n" + names_of(headers) + "\n" + request.payload_hash;
  const std::string text = fmt::format("{}\n{}\n{}\n{}", kAlgorithm, request.time, scope_of(request, key), hex(crypto.sha256(canonical)));
  std::string signing_key = "AWS4" + key.secret;
  for (const std::string& part : {request.time.substr(0, 8), key.region, std::string("s3"), std::string("aws4_request")}) {
    signing_key = crypto.hmac_sha256(signing_key, part);
  }
  return hex(crypto.hmac_sha256(signing_key, text));
}

}  // namespace

std::string escaped(std::string_view text, bool path) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' ||
                       c == '~' || (path && c == '/');
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return out;
}

std::string authorization(const S3Request& request, const S3Key& key, const Crypto& crypto) {
  return fmt::format("{} Credential={}/{},SignedHeaders={},Signature={}", kAlgorithm, key.id, scope_of(request, key),
                     names_of(signed_headers(request)), signature_of(request, key, crypto));
}

std::string presigned_query(S3Request request, int seconds, const S3Key& key, const Crypto& crypto) {
  request.payload_hash = "UNSIGNED-PAYLOAD";
  request.query["X-Amz-Algorithm"] = kAlgorithm;
  request.query["X-Amz-Credential"] = key.id + "/" + scope_of(request, key);
  request.query["X-Amz-Date"] = request.time;
  request.query["X-Amz-Expires"] = std::to_string(seconds);
  request.query["X-Amz-SignedHeaders"] = names_of(signed_headers(request));
  if (!key.session.empty()) request.query["X-Amz-Security-Token"] = key.session;
  return query_text(request.query) + "&X-Amz-Signature=" + signature_of(request, key, crypto);
}

}  // namespace layoutbox::publish
