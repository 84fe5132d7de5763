#include "layoutbox/base/png_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace layoutbox {
namespace {

// 2 × 2 pixels of RGB, as a library wrote them.
const std::string& whole() {
  static const std::string png = [] {
    std::string bytes;
    for (const unsigned char c : {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
                                  0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02, 0x00, 0x00, 0x00, 0xfd, 0xd4, 0x9a, 0x73, 0x00,
                                  0x00, 0x00, 0x0b, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0x40, 0x06, 0x00, 0x00, 0x0e, 0x00,
                                  0x01, 0xa9, 0x91, 0x73, 0xb1, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82}) {
      bytes += static_cast<char>(c);
    }
    return bytes;
  }();
  return png;
}

TEST(CheckPng, ReadsTheSizeOfAWholeOne) {
  const auto size = check_png(whole());
  ASSERT_TRUE(size) << size.error().message;
  EXPECT_EQ(size->width, 2);
  EXPECT_EQ(size->height, 2);
}

TEST(CheckPng, RefusesEveryPrefix) {
  for (std::size_t length = 0; length < whole().size(); ++length) {
    EXPECT_FALSE(check_png(whole().substr(0, length))) << length << " bytes";
  }
}

TEST(CheckPng, RefusesEveryChangedByte) {
  for (std::size_t i = 0; i < whole().size(); ++i) {
    std::string changed = whole();
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    EXPECT_FALSE(check_png(changed)) << "byte " << i;
  }
}

}  // namespace
}  // namespace layoutbox
