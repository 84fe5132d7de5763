// The verbs of editing: where one command ends and the next begins.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/plan/words/tokens.h"

namespace layoutbox::edit {

enum class Verb {
  kNone,
  kAdd,
  kPlace,
  kRemove,
  kMove,
  kSwap,
  kReplace,
  kSubstitute,
  kTurn,
  kMake,
  kRecolor,
  kResize,
  kRename,
  kKeep,
  kMention,
  kClear,  // what stands on or in it, all there is in the room
  kCopy,   // one more like it
  // What an edit does not do.
  kUndo,
  kRedo,
  kRearrange,
  kAfresh
};

// One command: its verb, the word of it, and the tokens that follow.
struct Command {
  Verb verb = Verb::kNone;
  std::string word;  // "enlarge"
  std::vector<offline::Token> tokens;
  bool along_wall = false;         // "to the left along the wall": as one who looks at that wall has it
  std::size_t begin = 0, end = 0;  // byte places in the text, the verb included
};

// Splits at the ends of sentences, and at "and", "then" and commas where a verb follows. A command without a verb ("the desk should be
// under the window") has kNone.
std::vector<Command> split_commands(std::span<const offline::Token> tokens);

}  // namespace layoutbox::edit
