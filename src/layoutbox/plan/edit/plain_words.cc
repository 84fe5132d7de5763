#include "layoutbox/plan/edit/plain_words.h"

#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/changes_parts.h"
#include "layoutbox/plan/edit/short_words.h"

namespace layoutbox::edit {

using namespace offline;

namespace {

// "… should go", "… has to go".
bool says_go(Command& command) {
  Tokens& tokens = command.tokens;
  if (command.verb != Verb::kNone || tokens.size() < 3 || !is_at(tokens, tokens.size() - 1, "go")) return false;
  std::size_t end = tokens.size() - 1;
  if (is_at(tokens, end - 1, "to") && end > 1 && one_of(tokens[end - 2].text, {"has", "have", "needs", "need"}))
    end -= 2;
  else if (one_of(tokens[end - 1].text, {"should", "must", "can", "may"}))
    end -= 1;
  if (end + 1 >= tokens.size()) return false;
  tokens.resize(end);
  command.verb = Verb::kRemove;
  return true;
}

// "I want a bigger rug".
bool wants_size(const Lexicon& lexicon, const World& world, Command& command) {
  static constexpr std::pair<std::string_view, std::string_view> kSizes[] = {
      {"bigger", "enlarge"},  {"larger", "enlarge"},  {"smaller", "shrink"},  {"wider", "widen"},
      {"narrower", "narrow"}, {"longer", "lengthen"}, {"shorter", "shorten"}, {"deeper", "deepen"}};
  Tokens& tokens = command.tokens;
  if (command.verb != Verb::kPlace || command.word != "i" || tokens.size() != 3 || !is_at(tokens, 0, "a")) return false;
  for (const auto& [adjective, verb] : kSizes) {
    if (!is_at(tokens, 1, adjective)) continue;
    const auto noun = read_noun_phrase(lexicon, tokens, 2, true);
    if (!noun || noun->kind != NounKind::kObject || world.of_kind(*noun).size() != 1) return false;
    command.verb = Verb::kResize;
    command.word = verb;
    tokens[0].text = "the";
    erase(tokens, 1, 2);
    return true;
  }
  return false;
}

// "the desk is too big", "the bed is much too close to the window".
bool says_too(Command& command) {
  Tokens& tokens = command.tokens;
  std::size_t too = 1;
  while (too < tokens.size() && tokens[too].text != "too") ++too;
  if (command.verb != Verb::kNone || too + 1 >= tokens.size()) return false;
  std::size_t is = too;
  while (is > 1 && one_of(tokens[is - 1].text, {"much", "way", "far", "a", "bit", "little", "just"})) --is;
  if (!one_of(tokens[is - 1].text, {"is", "are", "looks", "look", "seems", "seem"})) return false;
  const std::string said = tokens[too + 1].text;
  const bool at_end = too + 2 == tokens.size();
  const auto say = [&](Verb verb, std::string_view word, std::string_view instead) {
    command.verb = verb;
    command.word = word;
    tokens[too + 1].text = instead;
    erase(tokens, is - 1, too + 1);
    return true;
  };
  const bool ceiling = is_at(tokens, is - 2, "ceiling") || is_at(tokens, is - 2, "ceilings");
  if (at_end && ceiling && (said == "low" || said == "high")) {
    tokens.resize(is - 1);
    command.verb = Verb::kMove;
    command.word = said == "low" ? "raise" : "lower";
    return true;
  }
  static constexpr std::pair<std::string_view, std::string_view> kOther[] = {
      {"big", "smaller"},    {"large", "smaller"}, {"huge", "smaller"}, {"bulky", "smaller"}, {"small", "larger"}, {"little", "larger"},
      {"tiny", "larger"},    {"wide", "narrower"}, {"narrow", "wider"}, {"long", "shorter"},  {"short", "longer"}, {"deep", "shallower"},
      {"shallow", "deeper"}, {"tall", "lower"},    {"high", "lower"},   {"low", "higher"}};
  for (const auto& [adjective, instead] : kOther) {
    if (at_end && said == adjective) return say(Verb::kMake, "make", instead);
  }
  if (one_of(said, {"close", "near"}) && is_at(tokens, too + 2, "to")) {
    tokens[too + 2].text = "from";
    return say(Verb::kMove, "move", "away");
  }
  if (said == "far" && !at_end) {
    if (is_at(tokens, too + 2, "away")) erase(tokens, too + 2, too + 3);
    if (!is_at(tokens, too + 2, "from")) return false;
    tokens[too + 2].text = "to";
    return say(Verb::kMove, "move", "closer");
  }
  return false;
}

// "make the ceiling lower", "lower the ceiling a bit": a move of the ceiling by a little.
bool says_ceiling(Command& command) {
  Tokens& tokens = command.tokens;
  std::size_t at = 0;
  while (at < tokens.size() && !one_of(tokens[at].text, {"ceiling", "ceilings"})) ++at;
  const std::size_t way = at + 1 + degree_words(tokens, at + 1);
  if (at >= tokens.size() || way < tokens.size() - 1) return false;
  const bool moves = command.verb == Verb::kMove && one_of(command.word, {"raise", "lower"});
  if (moves && way == tokens.size() && way > at + 1) {
    tokens.resize(at + 1);
    return true;
  }
  if (moves || way >= tokens.size() || !one_of(tokens[way].text, {"lower", "higher"})) return false;
  command.verb = Verb::kMove;
  command.word = tokens[way].text == "lower" ? "lower" : "raise";
  tokens.resize(at + 1);
  return true;
}

// "10 cm out from the wall" is away from it.
void say_away(Tokens& tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].text == "out" && tokens[i + 1].text == "from") tokens[i].text = "away";
  }
}

bool is_property(std::string_view word) {
  return one_of(word, {"color", "size", "position", "positions", "place", "places", "material", "orientation", "name", "location"});
}

// How many tokens from `i` say "so that it faces", "to face", "toward"; 0 for none.
std::size_t facing_at(const Tokens& tokens, std::size_t i) {
  const auto at = [&](std::size_t k, std::string_view word) { return is_at(tokens, k, word); };
  const bool so = at(i, "so");
  std::size_t end = i + (so ? 1 : 0);
  if (so && at(end, "that")) ++end;
  if (so && (at(end, "it") || at(end, "they"))) ++end;
  if (at(end, "to") && (at(end + 1, "face") || at(end + 1, "look")))
    return end + 2 - i + (at(end + 2, "at") || at(end + 2, "toward") ? 1 : 0);
  if (end < tokens.size() && one_of(tokens[end].text, {"faces", "face", "toward", "towards", "facing", "at", "to"})) return end + 1 - i;
  return 0;
}

}  // namespace

Command in_plain_words(const Lexicon& lexicon, const World& world, Command command) {
  if (command.verb == Verb::kMove || command.verb == Verb::kPlace) say_away(command.tokens);
  say_in_full(lexicon, command);
  if (!says_go(command) && !says_too(command) && !says_ceiling(command)) wants_size(lexicon, world, command);
  return command;
}

void drop_properties(Tokens& tokens, const Command& command) {
  const bool making =
      command.verb == Verb::kMake || command.verb == Verb::kRecolor || command.verb == Verb::kNone || command.verb == Verb::kSwap;
  for (std::size_t i = 0; i < tokens.size();) {
    const bool next_is = i + 1 < tokens.size() && is_property(tokens[i + 1].text);
    if (making && is_at(tokens, i, "the") && next_is && is_at(tokens, i + 2, "of")) {
      erase(tokens, i, i + 3);
    } else if (making && is_at(tokens, i, "'s") && next_is) {
      erase(tokens, i, i + 2);
    } else if (making && i > 1 && is_at(tokens, i - 2, "the") && is_property(tokens[i].text) &&
               (i + 1 == tokens.size() || one_of(tokens[i + 1].text, {"to", "is", "should", "into"}))) {  // "the floor color to green"
      erase(tokens, i, i + 1);
      if (tokens[i - 1].text == "wall") tokens[i - 1].text = "walls";
    } else if (command.verb == Verb::kSwap && i + 1 == tokens.size() && (is_property(tokens[i].text) || tokens[i].text == "around")) {
      erase(tokens, i, i + 1);
    } else if (i > 0 && (is_at(tokens, i, "new") || (is_at(tokens, i, "more") && command.verb == Verb::kAdd)) &&
               command.verb != Verb::kRename) {
      erase(tokens, i, i + 1);
    } else if (is_at(tokens, i, "instead") && is_at(tokens, i + 1, "of")) {  // names what goes
      ++i;
    } else if (one_of(tokens[i].text, {"please", "instead", "too", "also"})) {
      erase(tokens, i, i + 1);
    } else {
      ++i;
    }
  }
}

void name_after_as(Tokens& tokens) {
  std::erase_if(tokens, [&, first = true](const Token& token) mutable { return token.text == "\"" && !std::exchange(first, false); });
  for (Token& token : tokens) {
    if (token.text == "\"") token.text = "as", token.kind = Token::Kind::kWord;
  }
}

void tuck_under(Tokens& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!is_at(tokens, i, "under") || (i > 0 && is_at(tokens, i - 1, "tucked"))) continue;
    Token tucked = tokens[i];
    tucked.text = "tucked";
    tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(i++), tucked);
  }
}

void say_facing(Tokens& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::size_t length = facing_at(tokens, i);
    if (length == 0) continue;
    tokens[i].text = "facing";
    if (length > 1) erase(tokens, i + 1, i + length);
    if (is_at(tokens, i + 1, "toward") || is_at(tokens, i + 1, "towards")) erase(tokens, i + 1, i + 2);
    return;
  }
}

void drop_to_before_color(const Lexicon& lexicon, Tokens& tokens) {
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    if (!one_of(tokens[i].text, {"to", "in", "into"})) continue;
    const Match match = lexicon.find(tokens, i + 1);
    const bool attribute = std::any_of(match.meanings.begin(), match.meanings.end(), [](const Meaning& m) {
      return m.word_class == WordClass::kColor || m.word_class == WordClass::kMaterial;
    });
    if (attribute || tokens[i + 1].text == "dark" || tokens[i + 1].text == "light") erase(tokens, i, i + 1);
  }
}

}  // namespace layoutbox::edit
