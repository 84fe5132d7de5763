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
};

// Splits a prompt. Hyphens within a word and possessive apostrophes part it ("bed's" → bed, 's). REQUIRES: valid UTF-8.
std::vector<Token> tokenize(std::string_view prompt);

// "the bin's under the sink": 's that is no possessive becomes "is". After spelling is corrected.
void part_contractions(std::vector<Token>& tokens);

}  // namespace layoutbox::offline
