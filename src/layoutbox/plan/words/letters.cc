#include "layoutbox/plan/words/letters.h"

#include <algorithm>
#include <array>
#include <utility>

namespace layoutbox::offline {
namespace {

// Signs outside ASCII and what they mean here.
constexpr std::array<std::pair<std::string_view, char>, 35> kSigns = {{
    {"\u2018", '\''}, {"\u2019", '\''}, {"\u02BC", '\''}, {"\u201C", '"'}, {"\u201D", '"'}, {"\u2032", '\''}, {"\u2033", '"'},
    {"\u2013", '-'},  {"\u2014", ','},  {"\u2010", '-'},  {"\u2011", '-'}, {"\u2212", '-'}, {"\u00D7", 'x'},  {"\u2715", 'x'},
    {"\u2192", ':'},  {"\u2A2F", 'x'},  {"\u2026", '.'},  {"\u00A0", ' '}, {"\u202F", ' '}, {"\u2009", ' '},  {"\u2022", ';'},
    {"\u00BD", 'h'},  {"\u00B2", '2'},  {"\u00A3", '$'},  {"\u20AC", '$'}, {"\u00A5", '$'},  // then marks of list items
    {"\u2713", ';'},  {"\u2714", ';'},  {"\u2610", ';'},  {"\u2611", ';'}, {"\u25AA", ';'}, {"\u25CF", ';'},  {"\u25B8", ';'},
    {"\u25A0", ';'},  {"\u27A4", ';'},
}};

// Letters with accents, folded to plain ones.
constexpr std::array<std::pair<std::string_view, char>, 16> kAccents = {{
    {"\u00E9", 'e'},
    {"\u00E8", 'e'},
    {"\u00EA", 'e'},
    {"\u00EB", 'e'},
    {"\u00E0", 'a'},
    {"\u00E2", 'a'},
    {"\u00E4", 'a'},
    {"\u00E1", 'a'},
    {"\u00F6", 'o'},
    {"\u00F4", 'o'},
    {"\u00F3", 'o'},
    {"\u00FC", 'u'},
    {"\u00FB", 'u'},
    {"\u00EE", 'i'},
    {"\u00EF", 'i'},
    {"\u00E7", 'c'},
}};

// Emoji, dingbats and what joins or varies them: they part words and say nothing.
bool is_picture_sign(std::string_view sign) {
  static constexpr std::array<std::string_view, 7> kBlocks = {"\xF0\x9F", "\xE2\x98", "\xE2\x99",    "\xE2\x9C",
                                                              "\xE2\x9D", "\xEF\xB8", "\xE2\x80\x8D"};
  return std::ranges::any_of(kBlocks, [&](std::string_view block) { return sign.starts_with(block); });
}

}  // namespace

Letter letter_at(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (static_cast<unsigned char>(c) < 0x80) {
    if (c == '`') return {'\'', 1};
    return {c, 1};
  }
  for (const auto& [sign, value] : kSigns) {
    if (text.substr(at).starts_with(sign)) return {value, sign.size()};
  }
  for (const auto& [sign, value] : kAccents) {
    if (text.substr(at).starts_with(sign)) return {value, sign.size()};
  }
  std::size_t size = 1;
  while (at + size < text.size() && (static_cast<unsigned char>(text[at + size]) & 0xC0) == 0x80) ++size;
  return {is_picture_sign(text.substr(at, size)) ? ' ' : '~', size};  // another script: a word of its own
}

}  // namespace layoutbox::offline
