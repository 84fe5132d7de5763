#include "layoutbox/base/utf8.h"

#include <gtest/gtest.h>

#include "layoutbox/base/plain_text.h"

namespace layoutbox {
namespace {

TEST(Utf8, IsAsUnicodeHasIt) {
  for (const char* good : {"", "bed", "Sofá", "椅子", "🛋", "\xef\xbf\xbd"}) EXPECT_TRUE(is_utf8(good)) << good;
  for (const char* bad :
       {"\xff", "a\x80", "\xc3", "\xe6\xa4", "\xf0\x9f\x9b", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80"}) {
    EXPECT_FALSE(is_utf8(bad)) << bad;
  }
}

TEST(Utf8, NoCharacterIsCut) {
  EXPECT_EQ(characters_in("Sofá 椅子"), 7u);
  EXPECT_EQ(first_characters("Sofá 椅子", 4), "Sofá");
  EXPECT_EQ(first_characters("Sofá", 40), "Sofá");
  EXPECT_EQ(first_bytes("Sofá", 4), "Sof");
  EXPECT_EQ(first_bytes("椅子", 2), "");
  EXPECT_EQ(first_bytes("椅子", 6), "椅子");
}

TEST(Utf8, WhatCannotBeSeenIsABlank) {
  EXPECT_EQ(plain_text("a\tb\nc\x7f"), "a b c ");
  EXPECT_EQ(plain_text("left\u202Eright \u200Bx \u061C \U000E0041 \uFEFF\u0085"), "left right  x       ");
  EXPECT_EQ(plain_text("Sofá 椅子 🛋"), "Sofá 椅子 🛋");
  EXPECT_EQ(plain_text("a\xff\x62"), "a b") << "what is no character cannot be shown";
}

}  // namespace
}  // namespace layoutbox
