// Shapes that are written down instead of programmed: catalog/models.json has a line for every solid (docs/furnish.md has the grammar).
#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/embedded/catalog_data.h"
#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

using ModelLines = std::vector<std::string>;

const std::map<std::string, ModelLines>& models() {
  static const auto all = nlohmann::json::parse(embedded::models_json).at("models").get<std::map<std::string, ModelLines>>();
  return all;
}

std::vector<std::string_view> words_of_line(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0) words.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

int integer(std::string_view text, int base = 10) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value, base);
  return value;
}

// "oak", "main:oak", "frame:oak", "accent:linen", "plastic#c03028"; "main:plastic#c03028" where no colour is asked.
int surface_of(Piece& p, std::string_view word) {
  if (const std::size_t hash = word.find('#'); word.starts_with("main:") && hash != std::string_view::npos) {
    constexpr std::size_t kMain = 5;
    return p.color_asked() ? p.main(word.substr(kMain, hash - kMain)) : surface_of(p, word.substr(kMain));
  }
  if (const std::size_t colon = word.find(':'); colon != std::string_view::npos) {
    const std::string_view usual = word.substr(colon + 1);
    return word.starts_with("main") ? p.main(usual) : word.starts_with("frame") ? p.frame(usual) : p.main_accent(usual);
  }
  if (const std::size_t hash = word.find('#'); hash != std::string_view::npos) {
    const int rgb = integer(word.substr(hash + 1), 16);
    return p.tinted(word.substr(0, hash), {((rgb >> 16) & 255) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0});
  }
  return p.named(word);
}

using Numbers = std::vector<double>;

Box box_of(const Numbers& n) { return {{n[0], n[2], n[4]}, {n[1], n[3], n[5]}}; }
double or_else(const Numbers& n, std::size_t at, double otherwise) { return n.size() > at ? n[at] : otherwise; }

// An outline, or a profile that is closed along its axis; counter-clockwise in whichever order it is listed.
std::vector<Vec2> outline_from(const Numbers& n, std::size_t at) {
  std::vector<Vec2> points;
  for (; at + 1 < n.size(); at += 2) points.push_back({n[at], n[at + 1]});
  double twice_area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i], b = points[(i + 1) % points.size()];
    twice_area += a.x * b.y - b.x * a.y;
  }
  if (twice_area < 0) std::ranges::reverse(points);
  return points;
}

int sides_for(double radius) { return radius > 0.04 ? 24 : radius > 0.012 ? 14 : 10; }

Mesh round_rod(const Numbers& n) { return rod({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6], sides_for(n[6])); }

Mesh bent_tube(const Numbers& n) {
  std::vector<Vec> points;
  for (std::size_t at = 1; at + 2 < n.size(); at += 3) points.push_back({n[at], n[at + 1], n[at + 2]});
  return tube(points.size() > 2 ? curve(points, 4) : points, n[0], 8);
}

// An outline in the plane of x and z, drawn out along y.
Mesh prism_along_y(const Numbers& n) { return posed(prism(outline_from(n, 2), -n[1], -n[0]), {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}}); }
// An outline in the plane of y and z, drawn out along x.
Mesh prism_along_x(const Numbers& n) { return posed(prism(outline_from(n, 2), n[0], n[1]), {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}}); }

Mesh ellipsoid_in(const Numbers& n) {
  const Box b = box_of(n);
  return ellipsoid(b.center(), b.size() * 0.5, 16, 10);
}

struct ModeledSolid {
  std::size_t least;  // numbers that it needs
  Mesh (*make)(const Numbers&);
};

const std::map<std::string_view, ModeledSolid>& solids() {
  static const std::map<std::string_view, ModeledSolid> all = {
      {"box", {6, [](const Numbers& n) { return box(box_of(n), or_else(n, 6, 0.003)); }}},
      {"rounded", {7, [](const Numbers& n) { return rounded_box(box_of(n), n[6]); }}},
      {"cushion", {7, [](const Numbers& n) { return cushion(box_of(n), n[6]); }}},
      {"ball", {6, ellipsoid_in}},
      {"can",
       {5,
        [](const Numbers& n) {
          return cylinder({n[0], n[1], n[3]}, n[2], n[4] - n[3], sides_for(n[2]));
        }}},
      {"cone",
       {6,
        [](const Numbers& n) {
          return cone({n[0], n[1], n[4]}, n[2], n[3], n[5] - n[4], sides_for(std::max(n[2], n[3])));
        }}},
      {"rod", {7, round_rod}},
      {"beam",
       {8,
        [](const Numbers& n) {
          return beam({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7]});
        }}},
      {"tube", {7, bent_tube}},
      {"ring",
       {5,
        [](const Numbers& n) {
          return torus({n[0], n[1], n[2]}, n[3], n[4], 20, 6);
        }}},
      {"turned", {8, [](const Numbers& n) { return posed(lathe(outline_from(n, 2), 24), moved(n[0], n[1], 0)); }}},
      {"oval", {9, [](const Numbers& n) { return posed(lathe(outline_from(n, 3), 24), moved(n[0], n[1], 0) * scaled(1, n[2], 1)); }}},
      {"prism", {8, [](const Numbers& n) { return prism(outline_from(n, 2), n[0], n[1]); }}},
      {"prism_y", {8, prism_along_y}},
      {"prism_x", {8, prism_along_x}},
      {"waves", {7, [](const Numbers& n) { return waves(box_of(n), static_cast<int>(n[6]), 0.01); }}},
  };
  return all;
}

// "/x90": turned about the middle of what it is.
Mesh turned(Mesh mesh, std::string_view word) {
  const Vec c = bounds(mesh).center();
  const double degrees = integer(word.substr(2));
  const Pose turn = word[1] == 'x' ? turned_x(degrees) : word[1] == 'y' ? turned_y(degrees) : turned_z(degrees);
  return posed(std::move(mesh), moved(c) * turn * moved(c * -1));
}

// What a line of a model has made.
struct Made {
  Mesh mesh;
  int surface = 0;
};

// One solid of a line; false where the line is none.
bool make_solid(Piece& p, std::span<const std::string_view> words, int index, std::vector<Made>& to) {
  const auto mm = [](double metres) { return static_cast<Mm>(std::lround(metres * 1000)); };
  const Size size{mm(p.w), mm(p.d), mm(p.h)};
  Numbers numbers;
  std::size_t at = 2;
  for (; at < words.size() && words[at][0] != '/'; ++at) {
    const Result<LinearFormula> formula = parse_formula(words[at], index);
    if (!formula) return false;
    numbers.push_back(formula->at(size) / 1000);
  }
  if (words[0] == "light" && numbers.size() == 4) {
    p.light({numbers[0], numbers[1], numbers[2]}, numbers[3]);
    return true;
  }
  const auto solid = solids().find(words[0]);
  if (solid == solids().end() || numbers.size() < solid->second.least) return false;
  Mesh mesh = solid->second.make(numbers);
  for (; at < words.size(); ++at) mesh = turned(std::move(mesh), words[at]);
  to.push_back({std::move(mesh), surface_of(p, words[1])});
  return true;
}

bool make_line(Piece& p, std::string_view line, std::vector<Made>& to) {
  const std::vector<std::string_view> words = words_of_line(line);
  const bool repeats = !words.empty() && words[0].ends_with('*');
  const auto rest = std::span(words).subspan(repeats ? 1 : 0);
  if (rest.size() < 3) return false;
  const int count = repeats ? integer(words[0]) : 1;
  for (int i = 0; i < count; ++i) {
    if (!make_solid(p, rest, i, to)) return false;
  }
  return true;
}

void modeled(Piece& p) {
  const auto model = models().find(p.word("model", ""));
  if (model == models().end()) return family_or_generic("generic")(p);
  std::vector<Made> made;
  for (const std::string& line : model->second) {
    if (!make_line(p, line, made)) return family_or_generic("generic")(p);
  }
  if (made.empty()) return family_or_generic("generic")(p);
  for (const Made& one : made) p.add(one.surface, one.mesh);
  if (p.spaces.empty()) p.fit();
  const ShelfContents contents =
      p.word("contents", "").empty() || !p.may_show_contents() ? nullptr : contents_named(p.word("contents", ""));
  for (const FreeSpace& s : p.spaces) {
    if (contents != nullptr && s.carries && !s.held) contents(p, s.box);
  }
}

}  // namespace

void add_modeled(Families& to) { to["modeled"] = modeled; }

}  // namespace layoutbox::kit
