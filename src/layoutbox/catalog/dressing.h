// What a finished room gets besides, where there is room left: curtains, pictures, a plant in a corner, the rest of a fitted kitchen. The
// data is catalog/dress.json.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/base/units.h"

namespace layoutbox {

// One habit of those who furnish: so many of a kind at such places of such rooms.
struct Dressing {
  std::string place;                  // how a place is looked for: "window", "corner"… (dress/places.h)
  std::string adds;                   // the kind
  std::vector<std::string> words;     // said of it: "large"
  std::vector<std::string> of;        // kinds that it goes with, the best first
  std::vector<std::string> with;      // only on what carries one of these already: keyboards before monitors
  std::vector<std::string> rooms;     // in these kinds of room only
  std::vector<std::string> unless;    // not where one of these kinds is there
  std::vector<std::string> unspoken;  // not where the text names one of these or wants none; empty: speaks of what is added
  std::vector<std::string> said;      // only where the text says one of these words; empty: in any
  std::vector<std::string> unsaid;    // not where it says one of these
  std::vector<std::string> lifted;    // where it says one of these, `unspoken` does not hold of what is added
  int most = 1;                       // of it in all
  Size size;                          // sides of 0 are usual, or follow from the place
  Mm stretch = 0;                     // so much wall must be free
  Mm before = 0;                      // so much floor stays free before it
  double area_m2 = 0;                 // not in smaller rooms
  int few = 0;                        // not where the text asks for more kinds of things than that (its grade); 0: however many
};

// How the units of a kitchen are arranged, and by which words a text says so.
struct KitchenForm {
  std::string form;  // "L", "U", "galley", "one wall"
  std::vector<std::string> words;
};

// What does not come, and the places at which nothing does, to a room of which one of these words is said, or of one of these kinds.
struct DressingTheme {
  std::vector<std::string> said, rooms, without, places;
};

struct Dressings {
  std::vector<Dressing> rows;  // in this order
  std::vector<DressingTheme> themes;
  std::vector<std::string> dressed;  // words by which all grades come
  std::vector<std::string> rehung;   // kinds that hang anywhere in view where nothing says where
  std::vector<KitchenForm> kitchen_forms;

  static const Dressings& builtin();
};

}  // namespace layoutbox
