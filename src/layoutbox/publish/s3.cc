// Any S3-compatible store: a signed PUT, and an address that may be fetched for an hour.
#include <fmt/format.h>

#include "layoutbox/publish/signature_v4.h"
#include "layoutbox/publish/upload.h"

namespace layoutbox::publish {
namespace {

constexpr int kFetchSeconds = 3600;

struct BucketStore {
  Address endpoint;
  std::string bucket, prefix;
  bool bucket_in_path = true;  // else in the host
  S3Key key;
};

class S3Publisher final : public Publisher {
 public:
  S3Publisher(BucketStore store, const Crypto& crypto, Settings settings)
      : store_(std::move(store)), crypto_(crypto), settings_(std::move(settings)) {}

  Result<std::string> publish(const File& file, const std::atomic<bool>* stop) override {
    S3Request request = request_for("PUT", store_.prefix + name_for(file));
    request.payload_hash = hex(crypto_.sha256(file.bytes));
    request.headers = {{"content-type", file.media_type}, {"x-amz-content-sha256", request.payload_hash}, {"x-amz-date", request.time}};
    if (!store_.key.session.empty()) request.headers["x-amz-security-token"] = store_.key.session;
    chat::HttpRequest http;
    http.method = "PUT";
    http.url = address_of(request);
    http.body = file.bytes;
    for (const auto& [name, value] : request.headers) http.headers.push_back(name + ": " + value);
    http.headers.push_back("Authorization: " + authorization(request, store_.key, crypto_));
    http.headers.emplace_back("Expect:");
    LAYOUTBOX_CHECK(send(http, settings_, stop));
    const S3Request fetch = request_for("GET", store_.prefix + name_for(file));
    return address_of(fetch) + "?" + presigned_query(fetch, kFetchSeconds, store_.key, crypto_);
  }

 private:
  S3Request request_for(std::string method, const std::string& name) const {
    S3Request request;
    request.method = std::move(method);
    request.host = store_.bucket_in_path ? store_.endpoint.host : store_.bucket + "." + store_.endpoint.host;
    request.path = store_.endpoint.path + (store_.bucket_in_path ? "/" + store_.bucket : "") + "/" + escaped(name, true);
    request.time = time_text();
    return request;
  }
  std::string address_of(const S3Request& request) const { return store_.endpoint.scheme + "://" + request.host + request.path; }

  BucketStore store_;
  const Crypto& crypto_;
  Settings settings_;
};

bool is_bucket(std::string_view name) {
  return name.size() >= 3 && name.size() <= 63 &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-") == std::string_view::npos;
}

}  // namespace

Result<std::unique_ptr<Publisher>> make_s3_publisher(Settings settings) {
  LAYOUTBOX_ASSIGN(const Crypto* crypto, Crypto::get());
  BucketStore store;
  LAYOUTBOX_ASSIGN(store.bucket, settings.need("LAYOUTBOX_S3_BUCKET", false));
  LAYOUTBOX_ASSIGN(store.key.id, settings.need("AWS_ACCESS_KEY_ID", true));
  LAYOUTBOX_ASSIGN(store.key.secret, settings.need("AWS_SECRET_ACCESS_KEY", true));
  store.key.session = settings.secret({"AWS_SESSION_TOKEN"});
  store.key.region = settings.get({"AWS_REGION", "AWS_DEFAULT_REGION"});
  if (store.key.region.empty()) store.key.region = "us-east-1";
  if (!is_bucket(store.bucket)) return fail(ErrorCode::kUsage, "LAYOUTBOX_S3_BUCKET is no name of a bucket", "--publish");
  const std::string endpoint = settings.get({"LAYOUTBOX_S3_ENDPOINT", "AWS_ENDPOINT_URL_S3", "AWS_ENDPOINT_URL"});
  LAYOUTBOX_ASSIGN(store.endpoint, read_address(endpoint.empty() ? fmt::format("https://s3.{}.amazonaws.com", store.key.region) : endpoint,
                                                "LAYOUTBOX_S3_ENDPOINT"));
  const std::string style = settings.get({"LAYOUTBOX_S3_STYLE"});
  if (!style.empty() && style != "path" && style != "virtual") {
    return fail(ErrorCode::kUsage, "LAYOUTBOX_S3_STYLE is neither path nor virtual", "--publish");
  }
  // A dot in a bucket's name fits no certificate of bucket.host.
  store.bucket_in_path = style.empty() ? !endpoint.empty() || store.bucket.find('.') != std::string::npos : style == "path";
  store.prefix = settings.get({"LAYOUTBOX_S3_PREFIX"});
  if (store.prefix.empty()) store.prefix = "layoutbox/";
  return std::make_unique<S3Publisher>(std::move(store), *crypto, std::move(settings));
}

}  // namespace layoutbox::publish
