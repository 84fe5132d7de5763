// Whose size is it that a text says: the room's, a thing's, or that of a floor to be left free?
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {

inline bool has_class(const Match& match, WordClass word_class) {
  return std::any_of(match.meanings.begin(), match.meanings.end(), [&](const Meaning& m) { return m.word_class == word_class; });
}

class SizeOwner {
 public:
  // REQUIRES: all outlive it. `known`: what of the room's size has been read so far.
  SizeOwner(const Lexicon& lexicon, const std::vector<Token>& tokens, const RoomSize& known)
      : lexicon_(lexicon), tokens_(tokens), known_(known) {}

  // Whether a size at [first, last) is the room's: a room follows, or is the last thing that was named before it.
  // `sides`: what it says, in metres; what is far too large for a thing is no size of that ("a desk and a bookshelf, 3 x 4 m").
  bool speaks_of_room(std::size_t first, std::size_t last, const std::vector<double>& sides = {}) const;
  // "Leave an open space of 6 by 8 for stretching": a part of the floor.
  bool says_free_floor(std::size_t size) const;
  // "bathroom 2x2.5 shower, toilet": right after the room.
  bool follows_room(std::size_t at) const;
  // "my dorm room: bed, desk, fridge, 10 sqm": an item of its own is no thing's floor.
  bool stands_alone(std::size_t first, std::size_t last) const;
  // "A bed and a wardrobe. Size 4 x 3.5 m.": a floor of at least `smallest` m², and far more than what was named last before `begin` takes.
  bool exceeds_last_thing(std::size_t begin, const std::vector<double>& sides, double smallest) const;

 private:
  // What is named in a stretch of text, compounds whole: a camper van is no van.
  struct Named {
    std::size_t at = 0;
    Match match;
  };
  std::optional<bool> room_follows(std::size_t last) const;
  bool is_referred_to(const Named& name) const;
  bool says_centimetres(std::size_t at) const;
  bool is_left_free(std::size_t space) const;
  std::vector<Named> named_in(std::size_t begin, std::size_t end) const;
  bool fits_thing_before(std::size_t end, const std::vector<double>& sides) const;

  const Lexicon& lexicon_;
  const std::vector<Token>& tokens_;
  const RoomSize& known_;
};

}  // namespace layoutbox::offline
