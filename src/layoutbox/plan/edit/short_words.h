// What people say of a room without a command's verb, or with one that says it another way.
#pragma once

#include "layoutbox/plan/edit/changes.h"
#include "layoutbox/plan/edit/commands.h"

namespace layoutbox::edit {

// "A and B should change places" swaps, "another chair" adds, "no rug" removes, "I want a green floor" paints, "higher ceilings" and "set
// the ceiling height to 3 m" change the ceiling, "to the left along the wall" is as one who looks at the wall has it. Whether it was one of
// these.
bool say_in_full(const offline::Lexicon& lexicon, Command& command);

}  // namespace layoutbox::edit
