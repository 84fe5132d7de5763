// A server of one's own that takes files by PUT; and the table of publishers.
#include <fmt/format.h>

#include "layoutbox/publish/upload.h"

namespace layoutbox::publish {
namespace {

class PutPublisher final : public Publisher {
 public:
  PutPublisher(std::string folder, std::string seen_as, std::string header, Settings settings)
      : folder_(std::move(folder)), seen_as_(std::move(seen_as)), header_(std::move(header)), settings_(std::move(settings)) {}

  Result<std::string> publish(const File& file, const std::atomic<bool>* stop) override {
    chat::HttpRequest http;
    http.method = "PUT";
    http.url = folder_ + "/" + name_for(file);
    http.body = file.bytes;
    http.headers = {"Content-Type: " + file.media_type, "Expect:"};
    if (!header_.empty()) http.headers.push_back(header_);
    LAYOUTBOX_CHECK(send(http, settings_, stop));
    return seen_as_ + "/" + name_for(file);
  }

 private:
  std::string folder_, seen_as_, header_;
  Settings settings_;
};

std::string text_of(const Address& address) { return address.scheme + "://" + address.host + address.path; }

}  // namespace

Result<std::unique_ptr<Publisher>> make_put_publisher(Settings settings) {
  LAYOUTBOX_ASSIGN(const std::string folder, settings.need("LAYOUTBOX_PUT_URL", false));
  LAYOUTBOX_ASSIGN(const Address address, read_address(folder, "LAYOUTBOX_PUT_URL"));
  const std::string header = settings.secret({"LAYOUTBOX_PUT_HEADER"});
  if (!header.empty() && (header.find(": ") == std::string::npos || header.find_first_of("\r\n") != std::string::npos)) {
    return fail(ErrorCode::kUsage, "LAYOUTBOX_PUT_HEADER is no header: Name: value", "--publish");
  }
  if (!header.empty()) settings.hide(header.substr(header.find(": ") + 2));
  const std::string seen_as = settings.get({"LAYOUTBOX_PUT_SEEN_AS"});
  LAYOUTBOX_ASSIGN(const Address seen, read_address(seen_as.empty() ? folder : seen_as, "LAYOUTBOX_PUT_SEEN_AS"));
  return std::make_unique<PutPublisher>(text_of(address), text_of(seen), header, std::move(settings));
}

Result<std::unique_ptr<Publisher>> make_publisher(std::string_view name, Settings settings) {
  if (name == "cloudinary") return make_cloudinary_publisher(std::move(settings));
  if (name == "s3") return make_s3_publisher(std::move(settings));
  if (name == "put") return make_put_publisher(std::move(settings));
  return fail(ErrorCode::kUsage, fmt::format("there is no publisher \"{}\"", name), "--publish", "use cloudinary, s3 or put");
}

}  // namespace layoutbox::publish
