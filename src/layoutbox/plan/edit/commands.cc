#include "layoutbox/plan/edit/commands.h"

#include <algorithm>
#include <array>
#include <utility>

namespace layoutbox::edit {
namespace {

using offline::Token;

struct VerbWords {
  std::string_view words;
  Verb verb;
};

constexpr VerbWords kVerbs[] = {
    {"add", Verb::kAdd},
    {"include", Verb::kAdd},
    {"insert", Verb::kAdd},
    {"introduce", Verb::kAdd},
    {"bring in", Verb::kAdd},
    {"give me", Verb::kAdd},
    {"give it", Verb::kAdd},
    {"give the room", Verb::kAdd},
    {"i want", Verb::kPlace},
    {"i need", Verb::kPlace},
    {"i would like", Verb::kPlace},
    {"i would love", Verb::kPlace},
    {"we want", Verb::kPlace},
    {"we need", Verb::kPlace},
    {"we would like", Verb::kPlace},
    {"it needs", Verb::kAdd},
    {"the room needs", Verb::kAdd},
    {"get me", Verb::kAdd},
    {"get us", Verb::kAdd},
    {"there should be", Verb::kAdd},
    {"put in", Verb::kAdd},
    {"put", Verb::kPlace},
    {"place", Verb::kPlace},
    {"set", Verb::kPlace},
    {"stand", Verb::kPlace},
    {"lay", Verb::kPlace},
    {"hang", Verb::kPlace},
    {"mount", Verb::kPlace},
    {"lean", Verb::kPlace},
    {"install", Verb::kPlace},
    {"position", Verb::kPlace},
    {"arrange", Verb::kPlace},
    {"remove", Verb::kRemove},
    {"delete", Verb::kRemove},
    {"drop", Verb::kRemove},
    {"discard", Verb::kRemove},
    {"eliminate", Verb::kRemove},
    {"take out", Verb::kRemove},
    {"take away", Verb::kRemove},
    {"take", Verb::kRemove},
    {"get rid of", Verb::kRemove},
    {"do not need", Verb::kRemove},
    {"do not want", Verb::kRemove},
    {"do not like", Verb::kMention},
    {"throw out", Verb::kRemove},
    {"throw away", Verb::kRemove},
    {"clear away", Verb::kRemove},
    {"clear", Verb::kClear},
    {"empty", Verb::kClear},
    {"clear out", Verb::kClear},
    {"empty out", Verb::kClear},
    {"lose", Verb::kRemove},
    {"erase", Verb::kRemove},
    {"move", Verb::kMove},
    {"shift", Verb::kMove},
    {"push", Verb::kMove},
    {"pull", Verb::kMove},
    {"slide", Verb::kMove},
    {"drag", Verb::kMove},
    {"scoot", Verb::kMove},
    {"nudge", Verb::kMove},
    {"spread", Verb::kMove},
    {"bring", Verb::kMove},
    {"relocate", Verb::kMove},
    {"reposition", Verb::kMove},
    {"center", Verb::kMove},
    {"raise", Verb::kMove},
    {"lower", Verb::kMove},
    {"tuck", Verb::kMove},
    {"lift", Verb::kMove},
    {"hide", Verb::kMove},
    {"stow", Verb::kMove},
    {"bring back", Verb::kPlace},
    {"restore", Verb::kPlace},
    {"copy", Verb::kCopy},
    {"duplicate", Verb::kCopy},
    {"clone", Verb::kCopy},
    {"swap", Verb::kSwap},
    {"exchange", Verb::kSwap},
    {"switch", Verb::kSwap},
    {"trade", Verb::kSwap},
    {"interchange", Verb::kSwap},
    {"replace", Verb::kReplace},
    {"substitute", Verb::kSubstitute},
    {"use", Verb::kSubstitute},
    {"would rather have", Verb::kSubstitute},
    {"would prefer", Verb::kSubstitute},
    {"prefer", Verb::kSubstitute},
    {"turn", Verb::kTurn},
    {"rotate", Verb::kTurn},
    {"face", Verb::kTurn},
    {"spin", Verb::kTurn},
    {"orient", Verb::kTurn},
    {"flip", Verb::kTurn},
    {"point", Verb::kTurn},
    {"angle", Verb::kTurn},
    {"swivel", Verb::kTurn},
    {"pivot", Verb::kTurn},
    {"twist", Verb::kTurn},
    {"make", Verb::kMake},
    {"change", Verb::kMake},
    {"let", Verb::kMake},
    {"have", Verb::kMake},
    {"paint", Verb::kRecolor},
    {"color", Verb::kRecolor},
    {"recolor", Verb::kRecolor},
    {"dye", Verb::kRecolor},
    {"repaint", Verb::kRecolor},
    {"resize", Verb::kResize},
    {"enlarge", Verb::kResize},
    {"shrink", Verb::kResize},
    {"widen", Verb::kResize},
    {"narrow", Verb::kResize},
    {"lengthen", Verb::kResize},
    {"shorten", Verb::kResize},
    {"deepen", Verb::kResize},
    {"double", Verb::kResize},
    {"halve", Verb::kResize},
    {"stretch", Verb::kResize},
    {"extend", Verb::kResize},
    {"scale", Verb::kResize},
    {"rename", Verb::kRename},
    {"call", Verb::kRename},
    {"keep", Verb::kKeep},
    {"leave", Verb::kKeep},
    {"do not move", Verb::kKeep},
    {"do not touch", Verb::kKeep},
    {"lock", Verb::kKeep},
    {"undo", Verb::kUndo},
    {"revert", Verb::kUndo},
    {"take that back", Verb::kUndo},
    {"go back", Verb::kUndo},
    {"roll back", Verb::kUndo},
    {"redo", Verb::kRedo},
    {"do it again", Verb::kRedo},
    {"do that again", Verb::kRedo},
    {"repeat", Verb::kRedo},
    {"rearrange", Verb::kRearrange},
    {"reorganize", Verb::kRearrange},
    {"shuffle", Verb::kRearrange},
    {"reshuffle", Verb::kRearrange},
    {"tidy up", Verb::kRearrange},
    {"start over", Verb::kAfresh},
    {"start again", Verb::kAfresh},
    {"reset", Verb::kAfresh},
};

// Words before a verb that change nothing.
constexpr std::string_view kLead[] = {"please",
                                      "now",
                                      "also",
                                      "then",
                                      "next",
                                      "finally",
                                      "just",
                                      "afterwards",
                                      "first",
                                      "second",
                                      "instead",
                                      "lets",
                                      "let 's",
                                      "i",
                                      "we",
                                      "really",
                                      "can we",
                                      "could we",
                                      "could you",
                                      "can you",
                                      "would you",
                                      "i want you to",
                                      "i would like you to",
                                      "i want to",
                                      "i would like to",
                                      "we should",
                                      "you should",
                                      "after that",
                                      "and",
                                      "so",
                                      "but",
                                      "let us"};

std::size_t count_words(std::string_view words) { return static_cast<std::size_t>(std::count(words.begin(), words.end(), ' ')) + 1; }

bool stands_at(std::span<const Token> tokens, std::size_t at, std::string_view words) {
  while (!words.empty()) {
    const std::size_t space = std::min(words.find(' '), words.size());
    if (at >= tokens.size() || tokens[at].text != words.substr(0, space)) return false;
    ++at;
    words.remove_prefix(std::min(space + 1, words.size()));
  }
  return true;
}

// The longest verb from `at`; its tokens, 0 for none.
std::pair<Verb, std::size_t> verb_at(std::span<const Token> tokens, std::size_t at) {
  std::pair<Verb, std::size_t> best{Verb::kNone, 0};
  for (const auto& [words, verb] : kVerbs) {
    const std::size_t length = count_words(words);
    if (length > best.second && stands_at(tokens, at, words)) best = {verb, length};
  }
  // "set of …", "double bed", "lower shelf": a verb is followed by what it acts on.
  if (best.first >= Verb::kUndo) return best;  // may stand alone
  if (best.second == 0 || at + best.second >= tokens.size()) return {Verb::kNone, 0};
  if (tokens[at + best.second].text == "of" || tokens[at + best.second].text == "'s") return {Verb::kNone, 0};
  static constexpr std::string_view kAlsoOther[] = {"double", "narrow", "lower", "set",  "stand", "face", "color",
                                                    "call",   "switch", "drop",  "have", "lean",  "copy", "empty"};
  const bool doubtful =
      best.second == 1 && std::find(std::begin(kAlsoOther), std::end(kAlsoOther), tokens[at].text) != std::end(kAlsoOther);
  static constexpr std::string_view kActedOn[] = {"the",   "it",      "them",       "a",    "an",  "all",  "both", "every",
                                                  "each",  "two",     "my",         "our",  "its", "this", "that", "these",
                                                  "those", "another", "everything", "down", "out", "away"};
  const std::string& next = tokens[at + best.second].text;
  if (doubtful && std::find(std::begin(kActedOn), std::end(kActedOn), next) == std::end(kActedOn) && next.find('_') == std::string::npos &&
      tokens[at + 1].kind != Token::Kind::kNumber)
    return {Verb::kNone, 0};
  return best;
}

std::size_t lead_at(std::span<const Token> tokens, std::size_t at) {
  std::size_t longest = 0;
  for (const std::string_view words : kLead) {
    const std::size_t length = count_words(words);
    if (length > longest && stands_at(tokens, at, words)) longest = length;
  }
  return longest;
}

bool is_break(const Token& token) {
  return token.ends_sentence || (token.kind == Token::Kind::kPunctuation && (token.text == "," || token.text == ":"));
}

// Past the commas and leading words from `at`.
std::size_t skip_lead(std::span<const Token> tokens, std::size_t at) {
  for (;;) {
    if (at < tokens.size() && is_break(tokens[at])) {
      ++at;
    } else if (const std::size_t lead = lead_at(tokens, at); lead > 0 && verb_at(tokens, at).second < lead) {
      at += lead;
    } else {
      return at;
    }
  }
}

// Does a new command begin behind the joining word or sign at `at`?
bool command_follows(std::span<const Token> tokens, std::size_t at) {
  if (tokens[at].ends_sentence) return true;
  if (!is_break(tokens[at]) && tokens[at].text != "and" && tokens[at].text != "then" && tokens[at].text != "but") return false;
  return verb_at(tokens, skip_lead(tokens, at)).second > 0;
}

}  // namespace

std::vector<Command> split_commands(std::span<const Token> tokens) {
  std::vector<Command> commands;
  std::size_t at = 0;
  while ((at = skip_lead(tokens, at)) < tokens.size()) {
    const auto [verb, length] = verb_at(tokens, at);
    Command command;
    command.verb = verb;
    command.begin = tokens[at].begin;
    if (length > 0) command.word = tokens[at].text;
    at += length;
    while (at < tokens.size() && !command_follows(tokens, at)) command.tokens.push_back(tokens[at++]);
    while (!command.tokens.empty() && is_break(command.tokens.back())) command.tokens.pop_back();
    command.end = command.tokens.empty() ? tokens[at - 1].end : command.tokens.back().end;
    commands.push_back(std::move(command));
  }
  return commands;
}

}  // namespace layoutbox::edit
