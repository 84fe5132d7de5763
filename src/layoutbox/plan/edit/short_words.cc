#include "layoutbox/plan/edit/short_words.h"

#include <algorithm>

#include "layoutbox/plan/edit/changes_parts.h"

namespace layoutbox::edit {

using namespace offline;

namespace {

bool word_in(const Tokens& tokens, std::size_t at, std::initializer_list<std::string_view> words) {
  return at < tokens.size() && std::ranges::find(words, tokens[at].text) != words.end();
}

Token worded(Token token, std::string_view word) {
  token.text = word;
  token.kind = Token::Kind::kWord;
  return token;
}

// "let the sofa and the desk trade places", "the sofa and the desk should change places".
bool says_places(Command& command) {
  Tokens& tokens = command.tokens;
  const std::size_t n = tokens.size();
  if ((command.verb != Verb::kNone && command.verb != Verb::kMake) || n < 4 || !word_in(tokens, n - 1, {"place", "places", "positions"}) ||
      !word_in(tokens, n - 2, {"trade", "swap", "change", "switch", "exchange"}))
    return false;
  std::size_t end = n - 2;
  while (end > 1 && word_in(tokens, end - 1, {"should", "must", "could", "can", "to", "have", "need"})) --end;
  tokens.resize(end);
  command.verb = Verb::kSwap;
  command.word = "swap";
  return true;
}

// "another chair", "one more chair", "two more chairs at the table".
bool says_more(Command& command) {
  Tokens& tokens = command.tokens;
  const bool more = is_at(tokens, 1, "more") && tokens.size() > 2;
  if (command.verb != Verb::kNone || tokens.size() < 2 || !(more || is_at(tokens, 0, "another"))) return false;
  if (more) erase(tokens, 1, 2);
  if (more && is_at(tokens, 0, "one")) tokens[0].text = "another";
  command.verb = Verb::kAdd;
  command.word = "add";
  return true;
}

// "no rug", "without the rug".
bool says_none(Command& command) {
  Tokens& tokens = command.tokens;
  if (command.verb != Verb::kNone || tokens.size() < 2 || !word_in(tokens, 0, {"no", "without"})) return false;
  erase(tokens, 0, is_at(tokens, 1, "more") ? 2 : 1);
  command.verb = Verb::kRemove;
  command.word = "remove";
  return !tokens.empty();
}

// Whether all words from `first` to before `last` are colors and materials.
bool paints(const Lexicon& lexicon, const Tokens& tokens, std::size_t first, std::size_t last) {
  if (first >= last) return false;
  for (std::size_t i = first; i < last;) {
    const Match match = lexicon.find(tokens, i);
    const bool look = std::ranges::any_of(
        match.meanings, [](const Meaning& m) { return m.word_class == WordClass::kColor || m.word_class == WordClass::kMaterial; });
    if (!look && !word_in(tokens, i, {"dark", "light", "pale", "bright"})) return false;
    i += std::max<std::size_t>(look ? match.length : 1, 1);
  }
  return true;
}

// "I want a green floor", "give the room white walls", "use oak for the floor".
bool says_surface(const Lexicon& lexicon, Command& command) {
  Tokens& tokens = command.tokens;
  const bool wished = command.verb == Verb::kPlace || command.verb == Verb::kAdd || command.verb == Verb::kSubstitute ||
                      (command.verb == Verb::kMake && command.word == "have");
  if (!wished || tokens.size() < 2 || !word_in(tokens, tokens.size() - 1, {"floor", "floors", "walls", "ceiling"})) return false;
  std::size_t end = tokens.size() - 1;
  if (end > 2 && is_at(tokens, end - 1, "the") && word_in(tokens, end - 2, {"for", "on"})) end -= 2;
  const std::size_t first = word_in(tokens, 0, {"a", "an", "some"}) ? 1 : 0;
  if (!paints(lexicon, tokens, first, end)) return false;
  Tokens said{worded(tokens.back(), "the"), tokens.back()};
  if (said[1].text == "floors") said[1].text = "floor";
  said.insert(said.end(), tokens.begin() + static_cast<std::ptrdiff_t>(first), tokens.begin() + static_cast<std::ptrdiff_t>(end));
  tokens = std::move(said);
  command.verb = Verb::kRecolor;
  command.word = "paint";
  return true;
}

// "higher ceilings", "I want a higher ceiling", "drop the ceiling by 20 cm", "set the ceiling height to 3 m".
bool says_height(const Lexicon& lexicon, Command& command) {
  Tokens& tokens = command.tokens;
  const auto ceiling = std::ranges::find_if(tokens, [](const Token& t) { return t.text == "ceiling" || t.text == "ceilings"; });
  if (ceiling == tokens.end()) return false;
  const auto at = static_cast<std::size_t>(ceiling - tokens.begin());
  const bool last = at + 1 == tokens.size();
  if (last && at > 0 && word_in(tokens, at - 1, {"higher", "taller", "lower"}) && command.verb != Verb::kRemove) {
    command.word = tokens[at - 1].text == "lower" ? "lower" : "raise";
    command.verb = Verb::kMove;
    tokens = {worded(tokens[at - 1], "the"), tokens[at]};
    return true;
  }
  if ((command.verb == Verb::kRemove && command.word == "drop") || (command.verb == Verb::kMove && command.word == "lift")) {
    command.word = command.word == "drop" ? "lower" : "raise";
    command.verb = Verb::kMove;
    return true;
  }
  std::size_t to = at + 1;
  while (word_in(tokens, to, {"height", "should", "must", "is", "be", "to", "at"})) ++to;
  const bool sets = command.verb == Verb::kPlace || command.verb == Verb::kMake || command.verb == Verb::kNone;
  const auto measure = length_at(lexicon, tokens, to);
  if (!sets || to == at + 1 || !measure || to + measure->length != tokens.size()) return false;
  tokens.push_back(worded(tokens.back(), "high"));
  erase(tokens, at + 1, to);
  command.verb = Verb::kMake;
  command.word = "make";
  return true;
}

bool says_along_wall(Command& command) {
  Tokens& tokens = command.tokens;
  if (command.verb != Verb::kMove && command.verb != Verb::kPlace) return false;
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (!is_at(tokens, i, "along") || !word_in(tokens, i + 1, {"the", "its", "that"}) || !is_at(tokens, i + 2, "wall")) continue;
    const auto sideways = [](const Token& token) { return token.text == "left" || token.text == "right"; };
    if (std::ranges::none_of(tokens, sideways)) return false;
    erase(tokens, i, i + 3);
    command.along_wall = true;
    return true;
  }
  return false;
}

}  // namespace

bool say_in_full(const Lexicon& lexicon, Command& command) {
  while (!command.tokens.empty() && command.tokens.back().text == "please") command.tokens.pop_back();
  return says_places(command) || says_none(command) || says_more(command) || says_surface(lexicon, command) ||
         says_height(lexicon, command) || says_along_wall(command);
}

}  // namespace layoutbox::edit
