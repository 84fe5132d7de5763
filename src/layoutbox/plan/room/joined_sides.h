// Rarer ways to say how large a room is: "4 meter and 3 meter", "six tatami mats".
#pragma once

#include <cstddef>
#include <span>

#include "layoutbox/plan/phrases/noun_phrase.h"
#include "layoutbox/plan/room/size_owner.h"

namespace layoutbox::offline {

// "Room is 4 meter and 3 meter.": both with their unit and no word for which is which; "10 on 8 meters", "3 to 4 m".
SidesRead read_two_joined(const Lexicon& lexicon, std::span<const Token> tokens, const SizeOwner& owner, std::size_t at);

struct AreaRead {
  double area = 0;         // m²
  std::size_t length = 0;  // tokens; 0: none is said
};

// "size is six tatami mats", "a six tatami room"; not "a room with six tatami mats".
AreaRead read_mats(const Lexicon& lexicon, std::span<const Token> tokens, const SizeOwner& owner, std::size_t at);

}  // namespace layoutbox::offline
