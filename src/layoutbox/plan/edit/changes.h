// The words of a command that say how far, how much, which way: taken out of it, so that what is left reads as a description.
#pragma once

#include <optional>
#include <vector>

#include "layoutbox/plan/edit.h"
#include "layoutbox/plan/edit/world.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::edit {

using Tokens = std::vector<offline::Token>;

// "the larger table": takes the word out, and says before which token it stood.
struct PickedAt {
  std::size_t token = 0;
  Pick pick = Pick::kNone;
};
std::vector<PickedAt> take_picks(Tokens& tokens);

// "by 90 degrees clockwise", "around", "a quarter turn", "the other way": degrees counter-clockwise. `of_verb`: a turn is what the verb
// says, so that "a bit" is one too.
std::optional<double> take_turn(Tokens& tokens, bool of_verb);

// "30 cm to the left", "a bit closer to", "up": `reference` stays empty; with kTowards and kAway the noun that follows at `at` names it.
struct ShiftAt {
  EditShift shift;
  std::size_t at = 0;
};
std::optional<ShiftAt> take_shift(const offline::Lexicon& lexicon, Tokens& tokens, std::string_view verb);

// "20 cm wider", "twice as long", "to 1.6 x 2 m", "larger". `exact_only`: nothing where no size is said but that it shall be another.
std::optional<EditResize> take_resize(const offline::Lexicon& lexicon, Tokens& tokens, std::string_view verb, bool exact_only);

}  // namespace layoutbox::edit
