// Puts a picture where a vision model can fetch it by an address (docs/judge.md, "Pictures by address").
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

#include "layoutbox/base/result.h"
#include "layoutbox/publish/settings.h"

namespace layoutbox::publish {

struct File {
  std::string media_type, bytes;
};

class Publisher {
 public:
  virtual ~Publisher() = default;
  // The address. The name is made of the bytes, so that one file is there once. Errors: kNetwork, with what the server said and without
  // any credential; kInterrupted.
  virtual Result<std::string> publish(const File& file, const std::atomic<bool>* stop) = 0;
};

// "cloudinary", "s3" or "put". Errors: kUsage (another name; a setting that is missing or makes no sense).
Result<std::unique_ptr<Publisher>> make_publisher(std::string_view name, Settings settings);

// One for each, for make_publisher.
Result<std::unique_ptr<Publisher>> make_cloudinary_publisher(Settings settings);
Result<std::unique_ptr<Publisher>> make_s3_publisher(Settings settings);
Result<std::unique_ptr<Publisher>> make_put_publisher(Settings settings);

}  // namespace layoutbox::publish
