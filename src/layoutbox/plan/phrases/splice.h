// Words that a reader puts into a text before it is parted into phrases.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// A token that is to stand before token `at`.
struct Splice {
  std::size_t at = 0;
  Token token;
};

inline Token word_token(std::string_view word) {
  Token token;
  token.kind = Token::Kind::kWord;
  token.text = word;
  return token;
}

inline Token comma_token() {
  Token token;
  token.kind = Token::Kind::kPunctuation;
  token.text = ",";
  return token;
}

inline Token number_token(int number) {
  Token token;
  token.kind = Token::Kind::kNumber;
  token.text = std::to_string(number);
  token.number = number;
  return token;
}

// Tokens [middle, last) come before [first, middle). REQUIRES: one reading and one mark of `skip` a token.
inline void move_before(Document& document, std::vector<bool>& skip, std::size_t first, std::size_t middle, std::size_t last) {
  const auto rotate = [&](auto& all) {
    const auto at = [&](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    std::rotate(at(first), at(middle), at(last));
  };
  rotate(document.tokens), rotate(document.readings), rotate(skip);
}

// REQUIRES: in the order of their places, and one reading and one mark of `skip` a token; then so it is again.
inline void splice(Document& document, std::vector<bool>& skip, std::vector<Splice> splices) {
  if (splices.empty()) return;
  std::vector<Token> tokens;
  std::vector<WordReading> readings;
  std::vector<bool> skipped;
  std::size_t next = 0;
  for (std::size_t i = 0; i < document.tokens.size(); ++i) {
    for (; next < splices.size() && splices[next].at == i; ++next) {
      Token& token = splices[next].token;
      token.begin = token.end = document.tokens[i].begin;
      readings.push_back({token.begin, token.end, WordReading::Use::kIgnored, {}});
      tokens.push_back(std::move(token));
      skipped.push_back(false);
    }
    tokens.push_back(std::move(document.tokens[i]));
    readings.push_back(std::move(document.readings[i]));
    skipped.push_back(skip[i]);
  }
  for (; next < splices.size(); ++next) {
    Token& token = splices[next].token;
    token.begin = token.end = tokens.empty() ? 0 : tokens.back().end;
    readings.push_back({token.begin, token.end, WordReading::Use::kIgnored, {}});
    tokens.push_back(std::move(token));
    skipped.push_back(false);
  }
  document.tokens = std::move(tokens);
  document.readings = std::move(readings);
  skip = std::move(skipped);
}

}  // namespace layoutbox::offline
