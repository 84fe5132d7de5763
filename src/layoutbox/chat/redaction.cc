#include "layoutbox/chat/redaction.h"

#include <algorithm>
#include <set>
#include <vector>

#include "layoutbox/base/bytes.h"

namespace layoutbox::chat {
namespace {

constexpr std::string_view kInstead = "[key]";
constexpr std::size_t kPiece = 12;  // of so many letters and digits only the secret's own are like it

bool is_letter_or_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

// Letters and digits of a text alone, and where each stood.
struct Bare {
  std::string letters;
  std::vector<std::size_t> places;

  explicit Bare(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (is_letter_or_digit(text[i])) letters += text[i], places.push_back(i);
    }
  }
};

// Parts of a text that are to go.
class Parts {
 public:
  void add(std::size_t begin, std::size_t end) {
    if (!parts_.empty() && begin <= parts_.back().second) {
      parts_.back().second = std::max(parts_.back().second, end);
    } else {
      parts_.emplace_back(begin, end);
    }
  }

  std::string without(std::string_view text) const {
    std::string rest;
    std::size_t at = 0;
    for (const auto& [begin, end] : parts_) {
      rest.append(text.substr(at, begin - at)).append(kInstead);
      at = end;
    }
    return rest.append(text.substr(at));
  }

 private:
  std::vector<std::pair<std::size_t, std::size_t>> parts_;  // in order
};

// A secret of signs, which nothing is left of without them.
std::string without_signs(std::string_view text, std::string_view secret) {
  Parts parts;
  for (std::size_t at = text.find(secret); at != std::string_view::npos; at = text.find(secret, at + secret.size())) {
    parts.add(at, at + secret.size());
  }
  return parts.without(text);
}

std::string without_letters(std::string_view text, std::string_view secret) {
  const Bare bare(text);
  const std::size_t length = std::min(secret.size(), kPiece);
  std::set<std::string_view> pieces;
  for (std::size_t i = 0; i + length <= secret.size(); ++i) pieces.insert(secret.substr(i, length));
  Parts parts;
  for (std::size_t i = 0; i + length <= bare.letters.size(); ++i) {
    if (pieces.contains(std::string_view(bare.letters).substr(i, length))) parts.add(bare.places[i], bare.places[i + length - 1] + 1);
  }
  return parts.without(text);
}

std::string without_form(std::string_view text, std::string_view form) {
  constexpr std::size_t kFewLetters = 8;
  const Bare bare(form);
  return bare.letters.size() < kFewLetters ? without_signs(text, form) : without_letters(text, bare.letters);
}

}  // namespace

std::string without_secret(std::string_view text, std::string_view secret) {
  std::string left = without_form(text, secret);
  for (std::size_t before = 0; before < 3; ++before) {  // bytes of a group of three that stand before it
    const std::string encoded = base64(std::string(before, '\0') + std::string(secret));
    const std::size_t begin = (before * 8 + 5) / 6, end = (before + secret.size()) * 8 / 6;
    left = without_form(left, std::string_view(encoded).substr(begin, end - begin));
  }
  return left;
}

}  // namespace layoutbox::chat
