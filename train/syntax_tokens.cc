// syntax_tokens: text on standard input, its sentences as the planner's tokens on standard output. A token a line:
// word, as written, "-" where a hyphen came before (else "."); an empty line after a sentence.
// syntax_tokens --parse: word, tag, head (1 = first, 0 = none), label, margin by the program's weights instead.
#include <iostream>
#include <string>
#include <vector>

#include "layoutbox/plan/syntax/syntax.h"
#include "layoutbox/plan/words/tokens.h"

namespace {

using layoutbox::offline::Token;

void print_tokens(const std::string& line, const std::vector<Token>& tokens) {
  for (const Token& token : tokens) {
    const bool hyphen = token.glued && token.begin > 0 && line[token.begin - 1] == '-' && token.kind != Token::Kind::kPunctuation;
    std::cout << token.text << '\t' << line.substr(token.begin, token.end - token.begin) << '\t' << (hyphen ? '-' : '.') << '\n';
  }
  std::cout << '\n';
}

void print_tree(const std::vector<Token>& tokens) {
  std::vector<std::string_view> words;
  for (const Token& token : tokens) words.emplace_back(token.text);
  const auto nodes = layoutbox::syntax::parse(words);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::cout << words[i] << '\t' << name(nodes[i].tag) << '\t' << nodes[i].head + 1 << '\t' << name(nodes[i].arc) << '\t'
              << nodes[i].margin << '\n';
  }
  std::cout << '\n';
}

}  // namespace

int main(int count, char** values) {
  const bool trees = count > 1 && std::string_view(values[1]) == "--parse";
  std::string line;
  while (std::getline(std::cin, line)) {
    std::vector<Token> sentence;
    const auto flush = [&] {
      if (!sentence.empty()) trees ? print_tree(sentence) : print_tokens(line, sentence);
      sentence.clear();
    };
    for (const Token& token : layoutbox::offline::tokenize(line)) {
      sentence.push_back(token);
      if (token.ends_sentence) flush();
    }
    flush();
  }
}
