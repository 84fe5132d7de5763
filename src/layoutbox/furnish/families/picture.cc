// Pictures and posters: what one shows is read from its own words, else from its room.
#include <algorithm>
#include <cmath>
#include <string>

#include "layoutbox/base/words.h"
#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/families/picture_sheet.h"
#include "layoutbox/furnish/picture_subjects.h"

namespace layoutbox::kit {
namespace pictures {
namespace {

// Simple compositions: hills and a sun, blocks of colour, arches.
void hills(Piece& p, PictureSheet& on, const Color& accent, const Color& warm) {
  on.bar(mixed(accent, {0.9, 0.93, 0.96}, 0.75), 0, 1, 0.3, 1);
  on.disc(warm, {p.random(0.3, 0.7), 0.72}, 0.1);
  for (int k = 0; k < 3; ++k)
    on.paint(mixed(accent, mixed(accent, {0.1, 0.12, 0.16}, 0.5), k / 2.0), rolling(0.5 - 0.15 * k, 0.06, 1.1, p.random(0, 6)));
}

void color_blocks(Piece& p, PictureSheet& on, const Color& accent, const Color& warm) {
  const double a = p.random(0.35, 0.6), b = p.random(0.4, 0.65);
  on.bar(accent, 0.06, a, 0.06, b);
  on.bar(warm, a + 0.03, 0.94, 0.06, b - 0.12);
  on.bar(mixed(accent, {0.1, 0.12, 0.16}, 0.5), a - 0.1, 0.94, b + 0.03, 0.94);
  on.bar({0.90, 0.84, 0.74}, 0.06, a - 0.13, b + 0.03, 0.94);
}

void arches(PictureSheet& on, const Color& accent, const Color& warm) {
  for (int k = 0; k < 3; ++k) {
    const double r = 0.42 - 0.12 * k;
    std::vector<Vec2> arch{{0.5 - r, 0.08}, {0.5 + r, 0.08}};
    for (int i = 0; i <= 14; ++i) arch.push_back({0.5 + r * std::cos(kPi * i / 14), 0.45 + r * std::sin(kPi * i / 14)});
    on.paint(k == 0 ? accent : k == 1 ? Color{0.90, 0.84, 0.74} : warm, arch);
  }
}

void composition(Piece& p, PictureSheet& on) {
  const Color accent = p.color_asked() ? Color{0.45, 0.5, 0.55} : p.accent(), warm = p.second_accent();
  const int kind = p.word("kind", "") == "abstract" ? 1 : p.turn(3);
  if (kind == 0) return hills(p, on, accent, warm);
  if (kind == 1) return color_blocks(p, on, accent, warm);
  arches(on, accent, warm);
}

void abstract(Piece& p, PictureSheet& on) {
  const Color accent = p.color_asked() ? Color{0.45, 0.5, 0.55} : p.accent();
  color_blocks(p, on, accent, p.second_accent());
}

// Of several names one, by turns.
std::string one_of(Piece& p, std::string_view listed) {
  const std::vector<std::string> names = names_in(listed);
  return names.empty() ? "" : names[static_cast<std::size_t>(p.turn(static_cast<int>(names.size())))];
}

// The name of what is drawn.
std::string subject_of(Piece& p) {
  std::string name = subject_said(p);
  if (name.empty()) name = one_of(p, p.pictures());
  // In an old house even a plain portrait is one of the forebears.
  return name == "portrait" && lists(p.pictures(), "forebear") ? "forebear" : name;
}

// How a picture is framed for what it shows.
struct Framing {
  double width, mat;  // metres; a share of the shorter side that is left white within the frame
  bool gilded;
};
Framing framing(Piece& p, std::string_view subject) {
  if (subject == "forebear" || subject == "icon") return {0.045, 0, true};
  const bool paper = subject == "botanical" || p.category() == "photo";
  return {0.025, paper && std::min(p.w, p.h) > 0.15 ? 0.11 : 0, false};
}

void picture(Piece& p) {
  const std::string said = p.word("kind", ""), subject = subject_of(p);
  const Framing frame = framing(p, subject);
  // Posters and canvases have no frame.
  const bool bare = said == "poster" || said == "canvas";
  const double t = bare ? 0 : std::min({frame.width, p.w * 0.2, p.h * 0.2}), y = -p.d / 2 + std::min(bare ? 0.0012 : 0.006, p.d * 0.45);
  if (!bare) picture_frame(p, frame.gilded && !p.color_asked() ? p.tinted("lacquer", {0.62, 0.47, 0.22}) : p.frame("walnut"), t);
  const double x0 = -p.w / 2 + t, x1 = p.w / 2 - t, z0 = t, z1 = p.h - t;
  p.add(p.main("paper"), box(sides(x0, x1, y, p.d / 2 - 0.001, z0, z1), 0));
  const double mat = bare ? 0 : frame.mat * std::min(p.w, p.h);
  PictureSheet on(p, sides(x0 + mat, x1 - mat, y, p.d / 2, z0 + mat, z1 - mat), -p.d / 2);
  if (p.says("black and white") || p.says("monochrome") || p.says("sepia")) on.without_color();
  const auto drawing = drawings().find(subject);
  (drawing == drawings().end() ? composition : drawing->second)(p, on);
}

}  // namespace

std::string subject_said(Piece& p) {
  return one_of(p, picture_subject([&p](std::string_view word) { return p.says(word); }));
}

const Drawings& drawings() {
  static const Drawings all = [] {
    Drawings to{{"composition", composition}, {"abstract", abstract}};
    for (const auto add : {add_scenery, add_travels, add_flowers, add_people, add_animals, add_wild_animals, add_children_pictures,
                           add_charts, add_maps, add_posters, add_pastime_pictures})
      add(to);
    return to;
  }();
  return all;
}

}  // namespace pictures

void add_pictures(Families& to) {
  to["picture"] = pictures::picture;
  pictures::add_tapestry(to);
}

}  // namespace layoutbox::kit
