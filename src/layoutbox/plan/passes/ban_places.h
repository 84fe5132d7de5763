// Where something is not to stand, and which sides of a thing are to stay free, as the words say it.
#pragma once

#include "layoutbox/plan/passes/bans.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {

// Where a place ends that begins with an article: "the window", "the right hand wall", "the middle of the room".
struct PlaceSaid {
  Ban ban;
  std::size_t last = 0;
};

class BanPlaces : public TokenReader {
 public:
  using TokenReader::TokenReader;

 protected:
  // The window, the door, a wall of a side, the middle or a side of the room.
  std::optional<PlaceSaid> place_at(std::size_t i) const;
  // "both sides", "the right hand side", and what they go past; empty: none are named.
  std::vector<Side> sides_at(std::size_t& i) const;

 private:
  std::optional<PlaceSaid> opening(std::string_view type, std::size_t i) const;
  std::optional<PlaceSaid> middle(std::size_t i) const;
};

}  // namespace layoutbox::offline
