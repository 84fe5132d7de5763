// Named surfaces and colour words (catalog/materials.json, catalog/colors.json), and the surfaces that one model uses.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "layoutbox/furnish/model.h"

namespace layoutbox {

struct NamedSurface {
  Surface surface;
  std::string kind;                // wood, metal, glass, stone, ceramic, plastic, floor, fabric, leather, other
  std::vector<std::string> words;  // what a text calls it
  bool tint = false;               // takes an asked colour
  bool soft() const { return kind == "fabric" || kind == "leather"; }
};

// All of them, read once.
std::span<const NamedSurface> named_surfaces();
// By name; a name that nobody knows is an assertion in debug builds and plain grey otherwise.
const NamedSurface& named_surface(std::string_view name);

// What a text asks of a surface: "dark green velvet", "white wooden".
struct SurfaceWish {
  std::optional<Color> color, second;          // second: of "black and cream"
  std::vector<const NamedSurface*> materials;  // in the order of the text
  // The first that can be had where `like` is the usual surface: soft for soft, hard for hard. Null where there is none.
  const NamedSurface* fitting(const NamedSurface& like) const;
};
// Longer phrases win ("black metal" is a material, not a colour and a material); `skip` are words of the thing's own name ("coffee table").
SurfaceWish read_wish(std::string_view text, std::span<const std::string> skip = {});

// Is it a word of a colour or material, or one that changes a colour ("pale")? Words of floors ("floor", "tiles") are none.
bool is_look_word(std::string_view word);

// `surface` as its kind shows that colour: fabric dyed, brown wood stained, other wood lacquered, metal painted.
Surface colored(const NamedSurface& surface, const Color& color);
Color mixed(const Color& a, const Color& b, double share_of_b);

// As it is when it was used or left alone for long: browner, dull, in blotches. What shines or is seen through stays.
Surface worn(const Surface& surface, double wear);

// The surfaces of one model, each once.
class Palette {
 public:
  int add(const Surface& surface);  // its index; one that is the same already is shared, another of the same name gets a new name
  int named(std::string_view name) { return add(named_surface(name).surface); }
  // What is added from now on is so worn and dirty, 0 to 1; returns what it was.
  double wear_from_now(double wear) { return std::exchange(wear_, wear); }
  std::vector<Surface> take() { return std::move(surfaces_); }

 private:
  double wear_ = 0;
  std::vector<Surface> surfaces_;
};

}  // namespace layoutbox
