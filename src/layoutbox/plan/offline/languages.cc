#include "layoutbox/plan/offline/languages.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox::offline {
namespace {

// As the tokens of a text are written: "tür" as "tur".
std::string as_tokens(std::string_view words) {
  std::string text;
  for (const Token& token : tokenize(words)) text += (text.empty() ? "" : " ") + token.text;
  return text;
}

WordList languages() { return word_list("words_languages").at("languages"); }

// By its small words: those of each language as tokens, made once.
using Signs = std::vector<std::pair<std::string_view, std::set<std::string>>>;
const Signs& signs_of_languages() {
  static const Signs signs = [] {
    Signs made;
    for (const WordList::Member language : languages()) {
      std::set<std::string>& words = made.emplace_back(language.key, std::set<std::string>{}).second;
      for (const WordList::Member word : language.value.at("signs")) words.insert(as_tokens(word.value.text()));
    }
    return made;
  }();
  return signs;
}

// Which of them the text has, and how often it has any.
struct Found {
  std::set<std::string_view> words;
  int times = 0;
};

Found found_of(const Document& document, const std::set<std::string>& signs) {
  Found found;
  for (const Token& token : document.tokens) {
    const auto sign = signs.find(token.text);
    if (sign == signs.end()) continue;
    found.words.insert(*sign);
    ++found.times;
  }
  return found;
}

class Translator {
 public:
  Translator(const WordList& glossary, std::vector<Token>& tokens) : tokens_(tokens) {
    for (const WordList::Member word : glossary.at("words")) words_.emplace(as_tokens(word.key), word.value.text());
    for (const WordList::Member ending : glossary.at("endings")) endings_.push_back(ending.value.text());
  }

  void run() {
    for (std::size_t i = 0; i < tokens_.size();) {
      const std::size_t length = tokens_[i].kind == Token::Kind::kWord ? read(i) : 0;
      if (length == 0) english_.push_back(tokens_[i]);
      i += std::max<std::size_t>(length, 1);
    }
    tokens_ = std::move(english_);
  }

 private:
  static constexpr std::size_t kLongest = 4;  // words of a phrase

  // How many tokens from i on were put into English; 0: none, which then stand as they are.
  std::size_t read(std::size_t i) {
    std::vector<std::string> phrases;
    std::string phrase;
    for (std::size_t k = i; k < std::min(tokens_.size(), i + kLongest) && tokens_[k].kind == Token::Kind::kWord; ++k) {
      phrase += (phrase.empty() ? "" : " ") + tokens_[k].text;
      phrases.push_back(phrase);
    }
    for (std::size_t length = phrases.size(); length > 0; --length) {
      if (const std::string_view* meant = find(phrases[length - 1])) return put(*meant, i, length);
    }
    const auto [first, second] = parts_of(phrases.front());
    if (first == nullptr) return 0;
    return put(std::string(*first) + " " + std::string(*second), i, 1);
  }

  const std::string_view* find(const std::string& word) const {
    if (const auto found = words_.find(word); found != words_.end()) return &found->second;
    for (const std::string_view ending : endings_) {
      if (word.size() <= ending.size() + 1 || !word.ends_with(ending)) continue;
      const auto found = words_.find(std::string_view(word).substr(0, word.size() - ending.size()));
      if (found != words_.end()) return &found->second;
    }
    return nullptr;
  }

  // "holztisch": both parts are words of their own.
  std::pair<const std::string_view*, const std::string_view*> parts_of(const std::string& word) const {
    constexpr std::size_t kShortest = 3;
    for (std::size_t at = kShortest; at + kShortest <= word.size(); ++at) {
      const std::string_view *first = find(word.substr(0, at)), *second = first == nullptr ? nullptr : find(word.substr(at));
      if (second != nullptr && !first->empty() && !second->empty()) return {first, second};
    }
    return {nullptr, nullptr};
  }

  std::size_t put(std::string_view english, std::size_t at, std::size_t length) {
    Token token = tokens_[at];
    token.end = tokens_[at + length - 1].end;
    for (Token& word : tokenize(english)) {
      word.begin = token.begin;
      word.end = token.end;
      word.glued = token.glued && token.begin < token.end;
      english_.push_back(word);
      token.begin = token.end;  // what is more than one word has its place once
    }
    return length;
  }

  std::vector<Token>& tokens_;
  std::vector<Token> english_;
  std::map<std::string, std::string_view, std::less<>> words_;  // by how the tokens of a text are written
  std::vector<std::string_view> endings_;
};

}  // namespace

std::optional<std::string> foreign_language(const Document& document) {
  constexpr std::size_t kLeastWords = 3;  // different ones: names and borrowed words come alone
  constexpr int kShare = 6;               // of so many words one is such a small word
  constexpr std::string_view kOwn = "English";
  const auto words = std::ranges::count(document.tokens, Token::Kind::kWord, &Token::kind);
  std::optional<std::string> most;
  int times = 0, english = 0;
  for (const auto& [language, signs] : signs_of_languages()) {
    const Found found = found_of(document, signs);
    if (language == kOwn) english = found.times;
    if (language == kOwn || found.words.size() < kLeastWords || found.times <= times || found.times * kShare < words) continue;
    most = language;
    times = found.times;
  }
  if (times <= english) return std::nullopt;
  return most;
}

bool translate(const std::string& language, Document& document) {
  const WordList glossary = languages().at(language);
  if (!glossary.contains("words")) return false;
  Translator(glossary, document.tokens).run();
  std::string english;
  for (const Token& token : document.tokens)
    english += (english.empty() || token.kind == Token::Kind::kPunctuation ? "" : " ") + token.text;
  document.notes.push_back({"filled", "the text is taken for " + language + " and read word by word: \"" + english + "\"", "prompt"});
  return true;
}

}  // namespace layoutbox::offline
