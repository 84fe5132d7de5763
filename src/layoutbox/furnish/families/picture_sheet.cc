#include "layoutbox/furnish/families/picture_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace layoutbox::kit::pictures {
namespace {

constexpr double kEdge = 0.015;  // of the sheet that stays bare all round
constexpr int kLayers = 22;      // as many as lie between the sheet and the front of its frame

double area(const std::vector<Vec2>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2;
}

// Without points on a straight line between their neighbours, of which cutting at the edge makes some: their triangles would have no area.
std::vector<Vec2> corners_of(std::vector<Vec2> outline) {
  constexpr double kStraight = 1e-9;  // square metres
  for (std::size_t i = 0; i < outline.size() && outline.size() > 2;) {
    const std::size_t n = outline.size();
    const Vec2 a = outline[(i + n - 1) % n], b = outline[i], c = outline[(i + 1) % n];
    if (std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) > kStraight) {
      ++i;
      continue;
    }
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
    i = i < 2 ? 0 : i - 2;  // its neighbours may be such now
  }
  return outline;
}

// A point of the smooth line between b and c.
Vec2 between(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double t) {
  const auto along = [t](double q, double r, double s, double u) {
    return r + 0.5 * t * (s - q + t * (2 * q - 5 * r + 4 * s - u + t * (3 * (r - s) + u - q)));
  };
  return {along(a.x, b.x, c.x, d.x), along(a.y, b.y, c.y, d.y)};
}

// Letters as rows of points from the top.
constexpr std::array<std::string_view, 26> kLetters = {".#./#.#/###/#.#/#.#",
                                                       "##./#.#/##./#.#/##.",
                                                       ".##/#../#../#../.##",
                                                       "##./#.#/#.#/#.#/##.",
                                                       "###/#../##./#../###",
                                                       "###/#../##./#../#..",
                                                       ".###/#.../#.##/#..#/.###",
                                                       "#.#/#.#/###/#.#/#.#",
                                                       "#/#/#/#/#",
                                                       "..#/..#/..#/#.#/.#.",
                                                       "#.#/#.#/##./#.#/#.#",
                                                       "#../#../#../#../###",
                                                       "#...#/##.##/#.#.#/#...#/#...#",
                                                       "#..#/##.#/#.##/#..#/#..#",
                                                       "###/#.#/#.#/#.#/###",
                                                       "##./#.#/##./#../#..",
                                                       ".##./#..#/#..#/#.#./.#.#",
                                                       "##./#.#/##./#.#/#.#",
                                                       ".##/#../.#./..#/##.",
                                                       "###/.#./.#./.#./.#.",
                                                       "#.#/#.#/#.#/#.#/###",
                                                       "#.#/#.#/#.#/#.#/.#.",
                                                       "#...#/#...#/#.#.#/##.##/#...#",
                                                       "#.#/#.#/.#./#.#/#.#",
                                                       "#.#/#.#/.#./.#./.#.",
                                                       "###/..#/.#./#../###"};

std::string_view letter_of(char c) { return c >= 'A' && c <= 'Z' ? kLetters[static_cast<std::size_t>(c - 'A')] : ".."; }

// Points from the beginning of a letter to that of the next.
double advance(std::string_view letter) { return static_cast<double>(std::min(letter.find('/'), letter.size())) + 1; }

Box box_round(const std::vector<Vec2>& outline) {
  Box b{{1e9, 0, 1e9}, {-1e9, 0, -1e9}};
  for (const Vec2 q : outline) {
    b.min = {std::min(b.min.x, q.x), 0, std::min(b.min.z, q.y)};
    b.max = {std::max(b.max.x, q.x), 0, std::max(b.max.z, q.y)};
  }
  return b;
}

}  // namespace

std::vector<Vec2> smooth(const std::vector<Vec2>& points, int steps) {
  std::vector<Vec2> line;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < steps; ++k)
      line.push_back(between(points[(i + n - 1) % n], points[i], points[(i + 1) % n], points[(i + 2) % n], static_cast<double>(k) / steps));
  }
  return line;
}

std::vector<Vec2> rolling(double level, double swing, double times, double phase) {
  constexpr int kSteps = 24;
  std::vector<Vec2> hill{{0, 0}, {1, 0}};
  for (int i = kSteps; i >= 0; --i) {
    const double x = static_cast<double>(i) / kSteps;
    hill.push_back({x, level + swing * (std::sin(phase + 2 * kPi * times * x) + 0.35 * std::sin(2.3 * phase + 4.4 * kPi * times * x))});
  }
  return hill;
}

PictureSheet::PictureSheet(Piece& p, const Box& face, double front)
    : p_(p),
      x0_(face.min.x),
      z0_(face.min.z),
      w_(face.size().x),
      h_(face.size().z),
      y_(face.min.y),
      step_(std::min(0.0006, (face.min.y - front) / (kLayers + 1))) {}

double PictureSheet::layer_over(const Box& b) {
  constexpr double kTouch = 1e-6;  // what only touches is beside it
  int layer = 0;
  for (const Shape& s : shapes_) {
    const bool covers = b.min.x < s.box.max.x - kTouch && b.max.x > s.box.min.x + kTouch && b.min.z < s.box.max.z - kTouch &&
                        b.max.z > s.box.min.z + kTouch;
    if (covers) layer = std::max(layer, s.layer);
  }
  layer = std::min(layer + 1, kLayers);
  shapes_.push_back({b, layer});
  return step_ * layer;
}

void PictureSheet::paint(const Color& color, const std::vector<Vec2>& outline) {
  std::vector<Vec2> points;
  for (const Vec2 q : outline)
    points.push_back({x0_ + w_ * std::clamp(q.x, kEdge, 1 - kEdge), z0_ + h_ * std::clamp(q.y, kEdge, 1 - kEdge)});
  points = corners_of(std::move(points));
  const double size = area(points);
  if (std::abs(size) < 1e-8) return;  // all of it beyond the edge
  if (size < 0) std::reverse(points.begin(), points.end());
  const double light = 0.3 * color.r + 0.59 * color.g + 0.11 * color.b;
  const Pose upright{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, y_, 0}};
  p_.add(p_.tinted("paper", grey_ ? Color{light, light, light * 0.97} : color), prism(points, -0.0002, layer_over(box_round(points))),
         upright);
}

void PictureSheet::bar(const Color& color, double x0, double x1, double z0, double z1) {
  paint(color, {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}});
}

void PictureSheet::disc(const Color& color, Vec2 at, double r, double tall) {
  const double side = std::min(w_, h_);
  paint(color, ellipse(at, {r * side / w_, r * tall * side / h_}, 28));
}

void PictureSheet::dome(const Color& color, Vec2 at, double r, double tall) {
  const double side = std::min(w_, h_);
  std::vector<Vec2> half;
  for (int i = 0; i <= 14; ++i)
    half.push_back({at.x + r * side / w_ * std::cos(kPi * i / 14), at.y + r * tall * side / h_ * std::sin(kPi * i / 14)});
  paint(color, half);
}

void PictureSheet::stand_at(Vec2 at, double size) {
  at_ = at;
  size_ = size;
}

Vec2 PictureSheet::placed(Vec2 q) const {
  const double half = std::min(w_, h_) / 2;
  return {at_.x + q.x * size_ * half / w_, at_.y + q.y * std::abs(size_) * half / h_};
}

void PictureSheet::figure(const Color& color, const std::vector<Vec2>& outline) {
  std::vector<Vec2> points;
  for (const Vec2 q : outline) points.push_back(placed(q));
  paint(color, points);
}

void PictureSheet::round(const Color& color, Vec2 at, double rx, double ry) { figure(color, ellipse(at, {rx, ry}, 28)); }

void PictureSheet::block(const Color& color, double x0, double x1, double z0, double z1) {
  figure(color, {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}});
}

void PictureSheet::stroke(const Color& color, const std::vector<Vec2>& points, double wide, double wide_at_end) {
  constexpr int kSteps = 5;
  std::vector<Vec2> line;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (int k = 0; k < kSteps; ++k)
      line.push_back(
          between(points[i == 0 ? 0 : i - 1], points[i], points[i + 1], points[std::min(i + 2, n - 1)], static_cast<double>(k) / kSteps));
  }
  line.push_back(points.back());
  std::vector<Vec2> left, right;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i == 0 ? 0 : i - 1], b = line[std::min(i + 1, line.size() - 1)];
    const double far = std::max(1e-9, std::hypot(b.x - a.x, b.y - a.y)),
                 share = static_cast<double>(i) / static_cast<double>(line.size() - 1);
    const double half = (wide + (wide_at_end - wide) * share) / 2;
    const Vec2 across{(a.y - b.y) / far * half, (b.x - a.x) / far * half};
    left.push_back({line[i].x + across.x, line[i].y + across.y});
    right.push_back({line[i].x - across.x, line[i].y - across.y});
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  figure(color, left);
}

void PictureSheet::letters(const Color& color, std::string_view text, Vec2 middle, double high, double most) {
  double points = -1;
  for (const char c : text) points += advance(letter_of(c));
  const double step = std::min(high * h_ / 5, most * w_ / points);
  double left = middle.x - points * step / w_ / 2;
  for (const char c : text) {
    letter(color, letter_of(c), {left, middle.y + 2.5 * step / h_}, step);
    left += advance(letter_of(c)) * step / w_;
  }
}

void PictureSheet::letter(const Color& color, std::string_view rows, Vec2 corner, double step) {
  const double dx = step / w_, dz = step / h_;
  double column = 0, top = corner.y;
  for (std::size_t i = 0; i < rows.size(); ++i, ++column) {
    const std::size_t end = std::min(rows.find_first_not_of('#', i), rows.size());
    if (end > i) {  // points side by side are one stroke
      const double from = corner.x + column * dx, many = static_cast<double>(end - i);
      bar(color, from, from + many * dx, top - dz, top);
      column += many - 1;
      i = end - 1;
    } else if (rows[i] == '/') {
      top -= dz;
      column = -1;
    }
  }
}

}  // namespace layoutbox::kit::pictures
