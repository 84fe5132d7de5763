#include "layoutbox/base/plain_text.h"

#include "layoutbox/base/utf8.h"

namespace layoutbox {
namespace {

bool is_unseen(char32_t sign) {
  const auto is_within = [sign](char32_t first, char32_t last) { return sign >= first && sign <= last; };
  return is_within(0, 0x1F) || is_within(0x7F, 0x9F) || sign == 0x061C || is_within(0x200B, 0x200F) || is_within(0x2028, 0x202E) ||
         is_within(0x2060, 0x206F) || sign == 0xFEFF || is_within(0xE0000, 0xE0FFF);
}

}  // namespace

std::string plain_text(std::string_view text) { return with_blanks(text, is_unseen); }

}  // namespace layoutbox
