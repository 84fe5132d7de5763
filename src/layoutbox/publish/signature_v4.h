// Signature version 4 of Amazon's services, as any S3-compatible store takes it.
#pragma once

#include <map>
#include <string>

#include "layoutbox/publish/crypto.h"

namespace layoutbox::publish {

struct S3Key {
  std::string id, secret, session, region;
};

struct S3Request {
  std::string method, host;                    // host with its port, where that is not the usual one
  std::string path;                            // as in the address: already escaped, begins with a slash
  std::map<std::string, std::string> query;    // not escaped
  std::map<std::string, std::string> headers;  // names in small letters; all of them are signed. `host` is added
  std::string payload_hash;                    // hexadecimal, or UNSIGNED-PAYLOAD
  std::string time;                            // 20130524T000000Z
};

// As in an address; a slash stays one where `path`.
std::string escaped(std::string_view text, bool path);

// The header Authorization.
std::string authorization(const S3Request& request, const S3Key& key, const Crypto& crypto);

// The query of an address by which anybody may fetch for `seconds`, signature included.
std::string presigned_query(S3Request request, int seconds, const S3Key& key, const Crypto& crypto);

}  // namespace layoutbox::publish
