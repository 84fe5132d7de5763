// Other ways to say a command, in the words that the reader takes.
#pragma once

#include "layoutbox/plan/edit/changes.h"
#include "layoutbox/plan/edit/commands.h"

namespace layoutbox::edit {

// "the rug should go" removes, "I want a bigger rug" enlarges the one that is there, "the desk is too big" asks for a smaller one, "too
// close to the bed" to go away from it.
Command in_plain_words(const offline::Lexicon& lexicon, const World& world, Command command);

// "the color of the sofa", "the sofa's color": the sofa. And words that add nothing: new, please, instead.
void drop_properties(Tokens& tokens, const Command& command);

// "call it \"den\"": as den.
void name_after_as(Tokens& tokens);

// "tuck the chair under the desk": tucked under.
void tuck_under(Tokens& tokens);

// "toward the window", "to face the window", "so that it faces the window", "to the window": facing the window.
void say_facing(Tokens& tokens);

// "to red", "in blue": red, blue.
void drop_to_before_color(const offline::Lexicon& lexicon, Tokens& tokens);

}  // namespace layoutbox::edit
