// How doors and windows look that a text describes (catalog/words_openings.json).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

enum class Leaf { kPanelled, kGlazed, kSectional, kPlanks, kLattice, kHalf };
enum class OpeningShape { kRectangle, kRound, kArched };

struct OpeningLook {
  Leaf leaf = Leaf::kPanelled;
  int leaves = 0;  // 0: not said
  bool slides = false;
  bool rail = false;     // hangs before the wall
  bool outside = false;  // leads out of the house
  bool onward = false;   // leads on into another room, so that the room has an entrance besides
  bool outward = false;  // its leaf swings out of the room
  bool whole = false;    // from one end of its wall to the other
  bool bay = false;      // it stands out of the wall
  std::string wall;      // the room's side that it is in where nobody says; empty: any
  OpeningShape shape = OpeningShape::kRectangle;
  std::string pane, frame;  // surfaces as a text asks for them; empty: the usual ones
  std::optional<Mm> width, height, sill;
  friend bool operator==(const OpeningLook&, const OpeningLook&) = default;
};

// Of those words and phrases; what the table does not know changes nothing.
OpeningLook opening_look(OpeningType type, const std::vector<std::string>& said);
inline OpeningLook look_of(const Opening& opening) { return opening_look(opening.type, opening.attributes); }

// The phrases of the table that `text` says and that change more than the size: "french" of "french doors".
std::vector<std::string> look_words(OpeningType type, std::string_view text);

// Two leaves where the text says so, and wherever one would be too wide.
bool has_two_leaves(const Opening& opening);

}  // namespace layoutbox
