// Parts that several families share.
#pragma once

#include <span>

#include "layoutbox/furnish/piece.h"

namespace layoutbox::kit {

// A box by its sides, which reads better in a family than two points.
inline Box sides(double x0, double x1, double y0, double y1, double z0, double z1) { return {{x0, y0, z0}, {x1, y1, z1}}; }

// A table top or seat of the shape that `top` says (rect, round, oval) in that box.
void slab(Piece& p, int surface, const Box& b, std::string_view top, double bevel = 0.006);

// How thick what stands at the left and right may be: up to the spaces between them, at most `most`.
double side_room(const Piece& p, double most);

// The levels and edges of a seat, from its free space where it has one.
struct Seat {
  double level, left, right, back;
};
Seat seat_of(const Piece& p, double level, double arm, double back);

// A handle or knob on a front that looks to −y: its plate at y, reaching `out` towards the viewer. `vertical` handles are `size` long.
enum class Handle { kNone, kKnob, kVertical, kHorizontal };
void handle(Piece& p, int surface, Handle kind, Vec at, double size, double out);

// Fronts over a rectangle of a body, in `rows` and `columns` with gaps between them, from y (front face) back by `thick`, handles in front.
struct Fronts {
  double x0, x1, z0, z1, y;
  int rows = 1, columns = 1;
  bool doors = false;  // doors: handles upright at the opening edge; drawers: in the middle
  double thick = 0.018, out = 0.02;
};
void fronts(Piece& p, int surface, int handle_surface, const Fronts& f);

// The slab on top of kitchen units: by the words of the piece, else as the text has the worktops, else granite.
int worktop(Piece& p);

// A cabinet in that box: boards round every space in it, fronts where it is closed (one column of doors per `door_width`, or drawers).
struct Carcass {
  Box box;
  int body, front, handles;
  int drawers = 0;  // rows of drawers in closed parts; 0: doors
  int doors = 0;    // columns; 0: by width
  bool closed_fronts = true;
  double out = 0.02;  // how far handles stand before the fronts; the box includes it
};
void carcass(Piece& p, const Carcass& c);

// Books, spines to −y, filling a box from the left as far as chance has it.
void books(Piece& p, const Box& room);

// What stands in a shelf's compartment that nothing was said of: as the piece's words say, else as the kind of room has it, else books.
// Null where it stays empty.
using ShelfContents = void (*)(Piece&, const Box&);
ShelfContents contents_of(const Piece& p);
// … by its word in decor.json; books where no such word is known.
ShelfContents contents_named(std::string_view name);
// … of what shops have alone; null where it is none of those.
ShelfContents shop_contents_named(std::string_view name);

// A frame of four bars round a rectangle on a wall; what it holds lies between its front and back.
void picture_frame(Piece& p, int surface, double width);

// The inside of a machine whose door stands open, between z0 and z1 behind its front at `face`.
void open_inside(Piece& p, double z0, double z1, double face, bool cold);
// A door that dropped open before a machine, lying level at z, with the rack drawn out over it; one that swung open at the left edge.
void dropped_door(Piece& p, int surface, double z, double high, double face, bool rack);
void swung_door(Piece& p, int surface, double z0, double z1, double face, double wide);

// Chairs of wicker are of a build of their own.
bool is_wicker(const Piece& p);
void wicker_chair(Piece& p);

// A candle behind panes in a frame with a ring, so high, standing at z = 0.
void lantern(Piece& p, double high);

// A rug, as it is said or as its room's style has them.
void rug(Piece& p);

// Pillow-like seat or back cushions side by side.
void cushions(Piece& p, int surface, const Box& room, int n, double radius);

// A box open above: walls of `wall` (or as thick as its free space leaves them) round it.
void open_box(Piece& p, int surface, const Box& b, double wall, double bevel = 0.004);
// A round vessel turned from its outside (from the foot's rim up to the lip), hollow by `wall` down to `floor`; elliptical where the piece
// is.
void vessel(Piece& p, int surface, std::span<const Vec2> outside, double wall, double floor, int sides = 28);
void vessel(Piece& p, int surface, std::initializer_list<Vec2> outside, double wall, double floor, int sides = 28);
// A plain body that fills the piece, with a plinth set back, for machines.
void machine_body(Piece& p, int surface, const Box& b, double bevel = 0.01);
// A thin disc that looks to −y (knobs, dials, portholes): centre of its back, radius, thickness.
void dial(Piece& p, int surface, Vec at, double radius, double thick, int sides = 20);

}  // namespace layoutbox::kit
