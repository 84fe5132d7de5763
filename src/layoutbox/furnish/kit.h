// The solids that furniture is made of. Every function returns a closed mesh with outward normals and uvs in metres (grain along u, which
// runs along the longer side of a face). Metres, z up; double inside, float in the meshes.
#pragma once

#include <span>
#include <vector>

#include "layoutbox/furnish/model.h"

namespace layoutbox::kit {

struct Vec {
  double x = 0, y = 0, z = 0;
  friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator*(Vec a, double k) { return {a.x * k, a.y * k, a.z * k}; }
};

double dot(Vec a, Vec b);
Vec cross(Vec a, Vec b);
double length(Vec a);
Vec unit(Vec a);  // {0, 0, 1} for a vector of no length

// A point in a plane: of a profile (radius, height), an outline (x, y).
struct Vec2 {
  double x = 0, y = 0;
};

struct Box {
  Vec min, max;
  Vec size() const { return max - min; }
  Vec center() const { return (min + max) * 0.5; }
};

// An affine map: a point p goes to x·p.x + y·p.y + z·p.z + origin.
struct Pose {
  Vec x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{};
  Vec point(Vec p) const { return x * p.x + y * p.y + z * p.z + origin; }
  friend Pose operator*(const Pose& a, const Pose& b);  // first b, then a
};
Pose moved(Vec by);
Pose moved(double x, double y, double z);
Pose turned_x(double degrees);
Pose turned_y(double degrees);
Pose turned_z(double degrees);
Pose scaled(double x, double y, double z);
// Turns z to `direction`.
Pose aimed(Vec from, Vec direction);

Mesh posed(Mesh mesh, const Pose& pose);
void append(Mesh& to, const Mesh& from);
Box bounds(const Mesh& mesh);

// A box with edges broken by `bevel` (made smaller where the box is thin; 0 = sharp). 44 triangles, 12 when sharp.
Mesh box(const Box& box, double bevel = 0.004);
// A box whose edges and corners are rounded with `radius`, `steps` facets to a quarter turn.
Mesh rounded_box(const Box& box, double radius, int steps = 3);
// A cushion: rounded at the sides by `radius`, its top (and underside, unless `flat_below`) domed; exactly fills the box.
Mesh cushion(const Box& box, double radius, bool flat_below = true, int steps = 8);
// A pillow: thin at the four edges, thick in the middle.
Mesh pillow(const Box& box, int steps = 8);
// A body between two rectangles (half extents) at two heights: tapered legs, shades, trapezes.
Mesh taper(Vec center_below, Vec2 half_below, Vec center_above, Vec2 half_above);
// Between two points, `size.x` by `size.y` across (size.y towards z as far as it goes).
Mesh beam(Vec from, Vec to, Vec2 size, double bevel = 0);

Mesh cylinder(Vec center_below, double radius, double height, int sides = 20);
Mesh cone(Vec center_below, double radius_below, double radius_above, double height, int sides = 20);
// A round leg whose ends are level however it leans.
Mesh leg(Vec below, Vec above, double radius_below, double radius_above, int sides = 14);
// A rod of round section from one point to another.
Mesh rod(Vec from, Vec to, double radius, int sides = 10);
// A profile (radius, z) turned about the z axis, listed so that the body is on its left: the outside from bottom to top, then inwards.
// Begins and ends on the axis or closes on itself. Edges sharper than 40° stay sharp. `squash` scales y.
Mesh lathe(std::span<const Vec2> profile, int sides = 24, double squash = 1);
Mesh lathe(std::initializer_list<Vec2> profile, int sides = 24, double squash = 1);
// A round rod along a line of points, capped at both ends; `closed` joins the last to the first instead.
Mesh tube(std::span<const Vec> path, double radius, int sides = 8, bool closed = false);
Mesh tube(std::initializer_list<Vec> path, double radius, int sides = 8, bool closed = false);
// A smooth line through the points (for tube).
std::vector<Vec> curve(std::span<const Vec> points, int steps = 6, bool closed = false);
std::vector<Vec> curve(std::initializer_list<Vec> points, int steps = 6, bool closed = false);
Mesh torus(Vec center, double radius, double thickness, int sides = 24, int section = 8);

// An outline (counter-clockwise, simple) drawn out from z0 to z1. `smooth` rounds the shading of its sides.
Mesh prism(std::span<const Vec2> outline, double z0, double z1, bool smooth = false);
Mesh prism(std::initializer_list<Vec2> outline, double z0, double z1, bool smooth = false);
// Outlines for prism.
std::vector<Vec2> ellipse(Vec2 center, Vec2 radius, int sides = 32);
std::vector<Vec2> rounded_rectangle(Vec2 min, Vec2 max, double radius, int steps = 4);
// Triangles of a simple polygon (indices into it).
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> outline);

// A body through rings of equally many points (at least two rings), capped at both ends; a ring runs counter-clockwise seen from where
// the next one lies, so a tub is listed up its outside, over its rim and down its inside. Edges sharper than 42° stay sharp.
Mesh loft(std::span<const std::vector<Vec>> rings);
// An outline as such a ring, at a height.
std::vector<Vec> ring_at(std::span<const Vec2> outline, double z);

Mesh ellipsoid(Vec center, Vec radius, int sides = 16, int rings = 8);
// A leaf of two faces, from `root` to `tip`, `width` wide, arched by `arch` (its middle lies so much above the straight line).
Mesh leaf(Vec root, Vec tip, double width, double arch, int steps = 4);
// A thin sheet that hangs in waves along x (curtains): fills the box.
Mesh waves(const Box& box, int folds, double thickness = 0.006);

// A wall-like slab in the x–z plane, from y0 to y1, with rectangular holes (x, z). x reaches from 0 to `length` at y1 (the inner face),
// and from −`more_at_start` to length + `more_at_end` at y0 (mitred corners).
struct Hole {
  double x0, x1, z0, z1;
};
Mesh pierced_slab(double length, double z0, double z1, double y0, double y1, std::span<const Hole> holes, double more_at_start = 0,
                  double more_at_end = 0);

}  // namespace layoutbox::kit
