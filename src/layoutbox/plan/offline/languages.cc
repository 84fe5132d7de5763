#include "layoutbox/plan/offline/languages.h"

#include <algorithm>
#include <set>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox::offline {
namespace {

// The words of a list that the text has, and how often it has any.
struct Found {
  std::set<std::string_view> words;
  int times = 0;
};

Found found_of(const Document& document, const WordList& list) {
  Found found;
  for (const WordList::Member word : list) {
    const auto is_it = [&](const Token& token) { return token.text == word.value.text(); };
    const auto times = std::ranges::count_if(document.tokens, is_it);
    if (times == 0) continue;
    found.words.insert(word.value.text());
    found.times += static_cast<int>(times);
  }
  return found;
}

}  // namespace

std::optional<std::string> foreign_language(const Document& document) {
  constexpr std::size_t kLeastWords = 3;  // different ones: names and borrowed words come alone
  constexpr int kShare = 6;               // of so many words one is such a small word
  const WordList languages = word_list("words_grammar").at("languages");
  const int english = found_of(document, languages.at("English")).times;
  const auto words = std::ranges::count_if(document.tokens, [](const Token& token) { return token.kind == Token::Kind::kWord; });
  for (const WordList::Member language : languages) {
    const Found found = found_of(document, language.value);
    if (language.key == "English" || found.words.size() < kLeastWords || found.times <= english) continue;
    if (found.times * kShare >= words) return std::string(language.key);
  }
  return std::nullopt;
}

}  // namespace layoutbox::offline
