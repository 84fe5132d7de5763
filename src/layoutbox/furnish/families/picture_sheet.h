// What pictures are drawn on and with: flat shapes in layers. Each drawing is a function of its own (picture_*.cc), found by the name of
// what it shows.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit::pictures {

// The canvas of a picture. Places are shares of its sides (0 to 1, x to the right, y up). Figures keep their shape whatever the canvas
// measures: their outlines are in halves of its shorter side. Every shape lies a hair before those it covers, so that no faces coincide.
class PictureSheet {
 public:
  PictureSheet(Piece& p, const Box& face, double front);

  void fill(const Color& color) { bar(color, 0, 1, 0, 1); }
  void paint(const Color& color, const std::vector<Vec2>& outline);
  void bar(const Color& color, double x0, double x1, double z0, double z1);
  // Round in the room; `r` in shares of the shorter side, `tall`: higher than wide.
  void disc(const Color& color, Vec2 at, double r, double tall = 1);
  // Half a disc that lies on its straight side, or hangs from it.
  void dome(const Color& color, Vec2 at, double r, double tall = 1);

  // What follows is drawn round `at`, so many times as large; a size below 0 looks the other way.
  void stand_at(Vec2 at, double size);
  void figure(const Color& color, const std::vector<Vec2>& outline);
  void round(const Color& color, Vec2 at, double rx, double ry);
  void block(const Color& color, double x0, double x1, double z0, double z1);
  // A brush drawn along points, which it rounds, so wide at its beginning and its end.
  void stroke(const Color& color, const std::vector<Vec2>& points, double wide, double wide_at_end);
  void stroke(const Color& color, const std::vector<Vec2>& points, double wide) { stroke(color, points, wide, wide); }
  // Capitals from the left, or round the middle, so high; as narrow as `most` needs (all in shares of the sides).
  void letters(const Color& color, std::string_view text, Vec2 middle, double high, double most = 0.84);

  // The height of the canvas in its widths: above 1 where it stands upright.
  double upright() const { return h_ / w_; }
  // How large a figure of that size is where an upright canvas leaves it more room.
  double larger(double size) const { return size * std::clamp(upright(), 1.0, 1.3); }
  // All that is painted from now on is grey: an old photograph.
  void without_color() { grey_ = true; }

 private:
  Vec2 placed(Vec2 q) const;
  double layer_over(const Box& b);
  void letter(const Color& color, std::string_view rows, Vec2 corner, double step);

  Piece& p_;
  double x0_, z0_, w_, h_, y_, step_;
  Vec2 at_{0.5, 0.5};
  double size_ = 1;
  bool grey_ = false;
  struct Shape {
    Box box;
    int layer;
  };
  std::vector<Shape> shapes_;
};

using Drawing = void (*)(Piece&, PictureSheet&);
using Drawings = std::map<std::string_view, Drawing>;
// All drawings by the names that decor.json uses for what they show.
const Drawings& drawings();
// The name of what a picture shows by its own words; empty where they do not say.
std::string subject_said(Piece& p);
void add_tapestry(Families& to);

// A closed smooth line through the points.
std::vector<Vec2> smooth(const std::vector<Vec2>& points, int steps = 5);
// A range of hills or waves from edge to edge: its level, how much it rises and falls, and how often.
std::vector<Vec2> rolling(double level, double swing, double times, double phase);

inline constexpr Color kDark{0.20, 0.20, 0.24}, kWhite{0.97, 0.96, 0.93}, kCream{0.94, 0.90, 0.80}, kNight{0.10, 0.13, 0.24};
inline constexpr Color kGay[] = {{0.36, 0.62, 0.80}, {0.95, 0.74, 0.36}, {0.88, 0.48, 0.42}, {0.48, 0.70, 0.52}, {0.66, 0.56, 0.78}};

// Spread over picture_*.cc.
void add_scenery(Drawings& to);
void add_travels(Drawings& to);
void add_flowers(Drawings& to);
void add_people(Drawings& to);
void add_animals(Drawings& to);
void add_wild_animals(Drawings& to);
void add_children_pictures(Drawings& to);
void add_charts(Drawings& to);
void add_maps(Drawings& to);
void add_posters(Drawings& to);
void add_pastime_pictures(Drawings& to);

}  // namespace layoutbox::kit::pictures
