// The examples of Amazon's own documentation ("Authenticating Requests", headers and query parameters).
#include "layoutbox/publish/signature_v4.h"

#include <gmock/gmock.h>

namespace layoutbox::publish {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

const S3Key kKey{"AKIAIOSFODNN7EXAMPLE", "wJalrXUtnFEMI/K7MDENG/bPxRfiCYEXAMPLEKEY", "", "us-east-1"};
constexpr const char* kTime = "20130524T000000Z";

class SignatureV4 : public testing::Test {
 protected:
  void SetUp() override {
    const auto found = Crypto::get();
    if (!found) GTEST_SKIP() << found.error().message;
    crypto_ = *found;
  }
  const Crypto* crypto_ = nullptr;
};

TEST_F(SignatureV4, Digests) {
  EXPECT_EQ(hex(crypto_->sha1("abc")), "a9993e364706816aba3e25717850c26c9cd0d89d");
  EXPECT_EQ(hex(crypto_->sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(SignatureV4, HeadersOfAGet) {
  S3Request request{"GET", "examplebucket.s3.amazonaws.com", "/test.txt", {}, {}, hex(crypto_->sha256("")), kTime};
  request.headers = {{"range", "bytes=0-9"}, {"x-amz-content-sha256", request.payload_hash}, {"x-amz-date", kTime}};
  EXPECT_EQ(authorization(request, kKey, *crypto_),
            "AWS4-HMAC-SHA256 Credential=AKIAIOSFODNN7EXAMPLE/20130524/us-east-1/s3/aws4_request,SignedHeaders=host;range;"
            "x-amz-content-sha256;x-amz-date,Signature=f0e8bdb87c964420e857bd35b5d6ed310bd44f0170aba48dd91039c6036bdb41");
}

TEST_F(SignatureV4, HeadersOfAPut) {
  S3Request request{"PUT", "examplebucket.s3.amazonaws.com", "/" + escaped("test$file.text", true), {}, {}, {}, kTime};
  request.payload_hash = hex(crypto_->sha256("Welcome to Amazon S3."));
  request.headers = {{"date", "Fri, 24 May 2013 00:00:00 GMT"},
                     {"x-amz-content-sha256", request.payload_hash},
                     {"x-amz-date", kTime},
                     {"x-amz-storage-class", "REDUCED_REDUNDANCY"}};
  EXPECT_THAT(authorization(request, kKey, *crypto_),
              EndsWith("Signature=98ad721746da40c64f1a55b78f14c238d841ea1380cd77a1b5971af0ece108bd"));
}

TEST_F(SignatureV4, AnAddressForADay) {
  const S3Request request{"GET", "examplebucket.s3.amazonaws.com", "/test.txt", {}, {}, {}, kTime};
  const std::string query = presigned_query(request, 86400, kKey, *crypto_);
  EXPECT_THAT(query, HasSubstr("X-Amz-Credential=AKIAIOSFODNN7EXAMPLE%2F20130524%2Fus-east-1%2Fs3%2Faws4_request"));
  EXPECT_THAT(query, EndsWith("&X-Amz-Signature=aeeed9bbccd4d02ee5c0109b86d86835f995330da4c265957d157751f604d404"));
}

}  // namespace
}  // namespace layoutbox::publish
