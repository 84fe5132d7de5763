// Words that are told apart by their neighbours: "left" as a side and as how something is kept, "on" as a part of a word.
#include <algorithm>
#include <iterator>

#include "layoutbox/plan/words/tokens.h"

namespace layoutbox::offline {
namespace {

// "an on-air lamp", "the on-call bed": one word, no place.
bool joins_on(const Token& on, const Token& next) {
  return on.text == "on" && next.glued && next.kind == Token::Kind::kWord && next.begin == on.end + 1;
}

// "two lamps, one left, one right of the bed", "the other right of it": on the left, on the right. Not "the left one".
bool is_on_side(const std::vector<Token>& tokens, std::size_t at) {
  const std::string &side = tokens[at].text, &before = tokens[at - 1].text;
  if ((side != "left" && side != "right") || (before != "one" && before != "other")) return false;
  if (at + 1 >= tokens.size()) return true;
  const Token& next = tokens[at + 1];
  return next.kind == Token::Kind::kPunctuation || next.text == "of" || next.text == "and";
}

// "a vase, left without flowers", "left open": kept so, not a side.
bool is_kept(const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::string_view kState[] = {"without", "empty",     "open",       "bare",  "unlocked", "ajar",
                                                "free",    "untouched", "unfinished", "alone", "clear"};
  static constexpr std::string_view kSide[] = {"the", "its", "his", "her", "far", "on", "to"};
  if (tokens[at].text != "left" || at == 0 || at + 1 >= tokens.size()) return false;
  return std::find(std::begin(kState), std::end(kState), tokens[at + 1].text) != std::end(kState) &&
         std::find(std::begin(kSide), std::end(kSide), tokens[at - 1].text) == std::end(kSide);
}

// "an Eames-like chair": in that style.
bool is_likeness(const std::vector<Token>& tokens, std::size_t at) {
  return tokens[at].text == "like" && at > 0 && tokens[at].glued && tokens[at - 1].kind == Token::Kind::kWord &&
         tokens[at].begin == tokens[at - 1].end + 1;
}

// "six-ish metres", "4ish": about so many.
bool is_about(const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::string_view kNumbers[] = {"two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "twelve"};
  if (tokens[at].text != "ish" || at == 0 || !tokens[at].glued) return false;
  const Token& number = tokens[at - 1];
  return number.kind == Token::Kind::kNumber || std::ranges::find(kNumbers, number.text) != std::end(kNumbers);
}

}  // namespace

std::vector<Token> settle_on(const std::vector<Token>& tokens) {
  std::vector<Token> out;
  out.reserve(tokens.size());
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (is_about(tokens, i)) continue;
    if (i > 0 && is_on_side(tokens, i)) {
      Token& on = out.emplace_back();
      on.text = "on";
      on.begin = on.end = tokens[i].begin;
    }
    if (i == 0 || i + 1 >= tokens.size() || !joins_on(tokens[i], tokens[i + 1])) {
      out.push_back(tokens[i]);
      if (is_kept(tokens, i)) out.back().text = "kept";
      if (is_likeness(tokens, i)) out.back().text = "styled";
      continue;
    }
    Token& word = out.emplace_back(tokens[i + 1]);
    word.text = "on-" + word.text;
    word.begin = tokens[i].begin;
    word.glued = false;
    ++i;
  }
  return out;
}

}  // namespace layoutbox::offline
