#include "layoutbox/plan/words/spelling.h"

#include <algorithm>
#include <ranges>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

constexpr std::size_t kMostLookups = 200;  // of different words in one text; keeps long texts linear
constexpr std::size_t kShortest = 4, kLong = 9;

bool is_listed(const Lexicon& lexicon, const std::string& word) {
  if (lexicon.lists(word) || is_english(word) || lexicon.knows(word)) return true;
  const std::vector<std::string> forms = singular_forms(word);
  return std::any_of(forms.begin(), forms.end(), [&](const std::string& form) { return lexicon.knows(form); });
}

// "recycler", "dehumidifiers": who or what does that; "wider".
bool is_doer(const Lexicon& lexicon, const std::string& word) {
  const std::string one = singular_of(word);
  for (const std::string_view ending : {"er", "or"}) {
    if (!one.ends_with(ending) || one.size() < kShortest - 1 + ending.size()) continue;
    const std::string stem = one.substr(0, one.size() - ending.size());
    if (is_listed(lexicon, stem) || is_listed(lexicon, stem + "e")) return true;
  }
  return false;
}

// "eyewash", "softbox": two words that were grown together.
bool is_compound(const Lexicon& lexicon, const std::string& word) {
  constexpr std::size_t kShortestPart = 3, kShortestOther = 4;
  for (std::size_t at = kShortestPart; at + kShortestPart <= word.size(); ++at) {
    const std::string first = word.substr(0, at), second = word.substr(at);
    if (std::max(first.size(), second.size()) < kShortestOther || singular_of(first) != first) continue;
    if (is_noun(noun_form(second)) && is_listed(lexicon, first)) return true;
  }
  return false;
}

// The word with doubled letters said once.
std::string undoubled(std::string_view word) {
  std::string text;
  for (const char c : word) {
    if (text.empty() || text.back() != c) text += c;
  }
  return text;
}

// Of words as near the likelier: a letter that should be double ("pilow") before one that was swapped before one that was lost.
int likelihood(std::string_view word, std::string_view known) {
  if (undoubled(word) == undoubled(known)) return 2;
  return known.size() == word.size() ? 1 : 0;
}

// "demo" is no "deco": of four letters that differ in one, rather another word than a slip, unless two were swapped.
bool is_other_short_word(std::string_view word, std::string_view known) {
  if (word.size() != kShortest || known.size() != kShortest) return false;
  return std::ranges::count_if(std::views::iota(std::size_t{0}, kShortest), [&](std::size_t i) { return word[i] != known[i]; }) == 1;
}

// The nearest known word: one letter changed, added, left out or swapped; two in long words that
// are no compounds. Empty where there is none.
std::string nearest(const Lexicon& lexicon, const std::string& word) {
  const std::size_t reach = word.size() >= kLong && !is_compound(lexicon, word) ? 2 : 1;
  std::string best;
  std::size_t least = reach + 1;
  const auto look = [&](char first) {
    for (std::size_t length = word.size() - reach; length <= word.size() + reach; ++length) {
      for (const std::string_view known : lexicon.words_like(first, length)) {
        if (is_other_short_word(word, known)) continue;
        const bool swapped = known.size() > 1 && known[1] == word[0];  // "dram" and "ajar" are no "ram" and "jar"
        if (first != word[0] && !swapped) continue;
        const std::size_t distance = edit_distance(word, known);
        const bool better =
            distance < least || (distance == least && distance <= reach && likelihood(word, known) > likelihood(word, best));
        if (better) best = known, least = distance;
      }
    }
  };
  look(word[0]);
  if (least > 1 && word[1] != word[0]) look(word[1]);  // the first two swapped
  return best;
}

bool is_known(const Lexicon& lexicon, const std::string& word) { return is_listed(lexicon, word) || is_doer(lexicon, word); }

// "neighbours", "parlour": the word as American English spells it, where that is the known one; else empty.
std::string american(const Lexicon& lexicon, const std::string& word) {
  constexpr std::size_t kShortestWord = 6;
  static constexpr std::pair<std::string_view, std::string_view> kSpellings[] = {
      {"our", "or"}, {"tre", "ter"}, {"ise", "ize"}, {"ogue", "og"}};
  if (word.size() < kShortestWord || lexicon.lists(word) || lexicon.knows(word)) return {};
  for (const auto& [british, us] : kSpellings) {
    const std::size_t at = word.rfind(british);
    if (at == std::string::npos || at < 2) continue;
    std::string spelt = word.substr(0, at) + std::string(us) + word.substr(at + british.size());
    if (is_noun(noun_form(spelt)) && (word_form(singular_of(word)) == WordForm::kUnknown || lexicon.knows(singular_of(spelt))))
      return spelt;
  }
  return {};
}

// One token becomes several where a space was left out ("infront").
void add_words(const Token& whole, const std::vector<std::string>& words, std::vector<Token>& tokens) {
  std::size_t begin = whole.begin;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool last = i + 1 == words.size();
    const std::size_t end = last ? whole.end : std::min(begin + words[i].size(), whole.end - (words.size() - 1 - i));
    Token part = whole;
    part.text = words[i];
    part.begin = begin;
    part.end = end;
    part.glued = i == 0 && whole.glued;
    begin = end;
    tokens.push_back(std::move(part));
  }
}

// "bed n desk", "on the n wall": what a letter alone stands for, or empty.
std::string_view meant_by_letter(const std::vector<Token>& tokens, std::size_t i) {
  static constexpr std::pair<std::string_view, std::string_view> kCompass[] = {
      {"n", "north"}, {"s", "south"}, {"e", "east"}, {"w", "west"}};
  if (tokens[i].text.size() != 1 || i + 1 >= tokens.size()) return {};
  const bool wall = tokens[i + 1].text == "wall" || tokens[i + 1].text == "side";
  for (const auto& [letter, word] : kCompass) {
    if (wall && tokens[i].text == letter) return word;
  }
  const bool between = i > 0 && tokens[i - 1].kind == Token::Kind::kWord && tokens[i + 1].kind != Token::Kind::kPunctuation;
  return between && tokens[i].text == "n" ? "and" : std::string_view{};
}

// "four per side", "two per long side": at each of a thing's sides, not for each of several things.
bool shares_sides(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t i) {
  if (tokens[i].text != "per") return false;
  for (std::size_t next = i + 1; next < tokens.size() && next <= i + 2 && tokens[next].kind == Token::Kind::kWord; ++next) {
    if (lexicon.is(tokens[next], WordClass::kSide)) return true;
  }
  return false;
}

}  // namespace

void correct_spelling(const Lexicon& lexicon, std::vector<Token>& tokens, StopFlag stop) {
  std::unordered_map<std::string, std::string> seen;
  std::vector<Token> corrected;
  corrected.reserve(tokens.size());
  for (std::size_t i = 0; i < tokens.size() && !is_set(stop); ++i) {
    Token& token = tokens[i];
    if (const std::string_view letter = meant_by_letter(tokens, i); !letter.empty()) token.text = letter;
    const bool word = token.kind == Token::Kind::kWord && token.text.find('~') == std::string::npos;
    std::vector<std::string> meant = word ? words_of(lexicon.meant_by(token.text)) : std::vector<std::string>{};
    if (word && shares_sides(lexicon, tokens, i)) meant = {"on", "each"};
    if (!meant.empty() && token.end - token.begin >= meant.size()) {
      add_words(token, meant, corrected);
      continue;
    }
    if (std::string spelt = word ? american(lexicon, token.text) : std::string{}; !spelt.empty()) token.text = std::move(spelt);
    const bool name = token.capital && !corrected.empty() && !corrected.back().ends_sentence;
    if (word && !name && token.text.size() >= kShortest && seen.size() < kMostLookups && !is_known(lexicon, token.text)) {
      const auto [found, fresh] = seen.try_emplace(token.text);
      if (fresh) found->second = nearest(lexicon, token.text);
      if (fresh && token.text.ends_with('s') && token.text.size() > kShortest) {
        const std::string said = token.text.substr(0, token.text.size() - 1), one = nearest(lexicon, said);
        const bool better = found->second.empty() || likelihood(said, one) > std::max(1, likelihood(token.text, found->second));
        if (!one.empty() && better) found->second = one + "s";
      }
      if (!found->second.empty()) token.text = found->second;
    }
    corrected.push_back(std::move(token));
  }
  tokens = std::move(corrected);
}

}  // namespace layoutbox::offline
