// Text to tokens: words, numbers and punctuation with their places in the prompt.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace layoutbox::offline {

struct Token {
  enum class Kind { kWord, kNumber, kPunctuation };
  Kind kind = Kind::kWord;
  std::string text;                // lower case, plain apostrophes, American spelling; numbers and signs as written
  std::size_t begin = 0, end = 0;  // byte places in the prompt
  double number = 0;
  bool glued = false;          // no space before it, as "size" in "king-size" (the hyphen is left out)
  bool capital = false;        // written with a capital letter
  bool ends_sentence = false;  // on punctuation
  bool contrasted = false;     // of "her", where the like is somebody else's as well
};

// Splits a prompt. Hyphens within a word and possessive apostrophes part it ("bed's" → bed, 's). REQUIRES: valid UTF-8.
std::vector<Token> tokenize(std::string_view prompt);

// The same tokens with "on" where it is meant, and as a part of the word that it belongs to. Part of tokenize().
std::vector<Token> settle_on(const std::vector<Token>& tokens);

// All of these words stand from `at` on, one after the other.
template <class Words>
bool stand_at(const std::vector<Token>& tokens, std::size_t at, const Words& words) {
  for (const std::string_view word : words) {
    if (at >= tokens.size() || tokens[at++].text != word) return false;
  }
  return true;
}

// "the bin's under the sink": 's that is no possessive becomes "is". After spelling is corrected.
void part_contractions(std::vector<Token>& tokens);

}  // namespace layoutbox::offline
