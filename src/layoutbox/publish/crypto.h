// Digests for signatures, by libcrypto, which libcurl brings along; opened at first use.
#pragma once

#include <string>
#include <string_view>

#include "layoutbox/base/result.h"

namespace layoutbox::publish {

class Crypto {
 public:
  // The one copy. Errors: kNetwork where the library cannot be loaded.
  static Result<const Crypto*> get();

  // Raw bytes.
  std::string sha1(std::string_view text) const;
  std::string sha256(std::string_view text) const;
  std::string hmac_sha256(std::string_view key, std::string_view text) const;

 private:
  using Digest = unsigned char* (*)(const unsigned char*, std::size_t, unsigned char*);
  using Kind = const void* (*)();
  using Hmac = unsigned char* (*)(const void*, const void*, int, const unsigned char*, std::size_t, unsigned char*, unsigned*);
  static Result<Crypto> open();

  Digest sha1_ = nullptr, sha256_ = nullptr;
  Kind kind_of_sha256_ = nullptr;
  Hmac hmac_ = nullptr;
};

std::string hex(std::string_view bytes);

}  // namespace layoutbox::publish
