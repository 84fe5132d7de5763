// How a room looks where nothing was said of it (catalog/decor.json): its floor, its walls, the wood and the colours of its furniture.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/furnish/part_looks.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

struct Decor {
  std::string style;                // "modern", "rustic", … (the first word of its line in decor.json); empty: none was named
  std::uint64_t chance = 0;         // of the room: which of several ways its things are drawn
  std::string floor = "oak floor";  // as a text would ask for it
  Color wall{0.93, 0.91, 0.88};     // of plaster
  std::string wall_finish;          // as a text would ask for it ("wall tiles", "stone"); empty: plaster
  std::vector<std::string> woods;   // usual furniture is of the first, some of the others; empty: as each family says
  std::string metal;                // instead of steel; empty: steel
  std::vector<Color> accents;       // of cloth; empty: as of old
  std::map<std::string, std::string, std::less<>> shelves_said;  // contents by the word for what holds them ("shelf": "toys")
  bool parapet = false;          // out of doors: walls that nothing is let into are no higher than a railing
  bool colors_said = false;      // the accents are the text's own
  bool scheme_walls = false;     // what colours the walls have is said of the whole room alone
  bool woods_said = false;       // the woods are the text's own
  std::optional<Color> paint;    // of furniture of which nothing was said, where the text has a neutral colour for the room
  std::optional<Color> feature;  // of the one wall that has the strong colour of a room whose others are neutral
  bool all = false;              // the furniture as well has these colours and woods, where nothing was said of it
  std::string cases;             // what lies in glass cases of which nothing was said; empty: nothing
  std::string shelves;           // what stands on a shelf of which nothing was said ("goods", "towels"); empty: books
  std::string pictures;          // what pictures show here, one of several names ("child", "horse landscape"); empty: compositions
  double daylight = 1;           // a share of the usual light from without
  double wear = 0;               // 0: new, 1: as worn and dirty as can be
  bool skirting = true;          // boards along the foot of plastered walls
  std::string view;              // a word for what is seen behind windows ("snow"); empty: the sky
  std::string door, window;      // words for doors and windows of which nothing was said ("plank", "arched")
  PartLooks parts;               // of parts, as the text says
  ThingParts of_things;          // of parts of single things, as the text says
  std::string rug;               // what is woven into rugs ("diamonds"); empty: by chance
  std::optional<Color> leather;  // of which nobody said the colour; nothing: brown
  std::vector<Color> unwanted;   // what nobody asked for is not to be of these
  std::map<std::string, std::string, std::less<>> others;  // surfaces by those that give way to them
  // A wood for a thing, where nobody said which: the room's. Stands for oak and walnut only.
  std::string_view wood_for(std::string_view usual, std::uint64_t kind) const;
};

// Of a room: by its kind, the style words of its prompt, and chance (the prompt and the seed).
Decor decor_of(const Layout& layout, std::uint64_t seed);
// The same with what the words of one object change ("rustic dining table"); `text` in lower case.
Decor decor_of_thing(const Decor& room, std::string_view text);

// How worn the words say a thing is ("old": a little, "rusty": much); 0 where they do not.
double wear_said(std::string_view text);

// What a shelf of that name holds ("wine shelf": bottles); empty where the name does not say. `text` in lower case.
std::string shelf_contents_named(std::string_view text);

}  // namespace layoutbox
