// syntax_tokens: text on standard input, its sentences as the planner's tokens on standard output. A token a line:
// word, as written, "-" where a hyphen came before (else "."); an empty line after a sentence.
#include <cstdio>
#include <iostream>
#include <iterator>
#include <string>

#include "layoutbox/plan/offline/tokens.h"

int main() {
  std::string line;
  while (std::getline(std::cin, line)) {
    bool open = false;
    for (const auto& token : layoutbox::offline::tokenize(line)) {
      const bool hyphen =
          token.glued && token.begin > 0 && line[token.begin - 1] == '-' && token.kind != layoutbox::offline::Token::Kind::kPunctuation;
      std::cout << token.text << '\t' << line.substr(token.begin, token.end - token.begin) << '\t' << (hyphen ? '-' : '.') << '\n';
      open = true;
      if (token.ends_sentence) {
        std::cout << '\n';
        open = false;
      }
    }
    if (open) std::cout << '\n';
  }
}
