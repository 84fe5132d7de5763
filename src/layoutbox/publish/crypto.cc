#include "layoutbox/publish/crypto.h"

#include <dlfcn.h>

namespace layoutbox::publish {
namespace {

constexpr const char* kNames[] = {"libcrypto.so.3", "libcrypto.so.1.1"};

template <class Function>
bool look_up(void* handle, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(handle, name));
  return function != nullptr;
}

const unsigned char* bytes_of(std::string_view text) { return reinterpret_cast<const unsigned char*>(text.data()); }
unsigned char* bytes_of(std::string& text) { return reinterpret_cast<unsigned char*>(text.data()); }

}  // namespace

Result<Crypto> Crypto::open() {
  for (const char* name : kNames) {
    void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    Crypto crypto;
    if (handle != nullptr && look_up(handle, "SHA1", crypto.sha1_) && look_up(handle, "SHA256", crypto.sha256_) &&
        look_up(handle, "EVP_sha256", crypto.kind_of_sha256_) && look_up(handle, "HMAC", crypto.hmac_)) {
      return crypto;
    }
  }
  return fail(ErrorCode::kNetwork, "libcrypto, by which uploads are signed, is not installed", {}, "install the package libssl3");
}

Result<const Crypto*> Crypto::get() {
  static const Result<Crypto> crypto = open();
  if (!crypto) return Failure(crypto.error());
  return &*crypto;
}

std::string Crypto::sha1(std::string_view text) const {
  std::string digest(20, '\0');
  sha1_(bytes_of(text), text.size(), bytes_of(digest));
  return digest;
}

std::string Crypto::sha256(std::string_view text) const {
  std::string digest(32, '\0');
  sha256_(bytes_of(text), text.size(), bytes_of(digest));
  return digest;
}

std::string Crypto::hmac_sha256(std::string_view key, std::string_view text) const {
  std::string digest(32, '\0');
  unsigned length = 32;
  hmac_(kind_of_sha256_(), key.data(), static_cast<int>(key.size()), bytes_of(text), text.size(), bytes_of(digest), &length);
  return digest;
}

std::string hex(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    text += kDigits[value >> 4];
    text += kDigits[value & 15];
  }
  return text;
}

}  // namespace layoutbox::publish
