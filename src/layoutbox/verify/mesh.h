// Meshes as the verifier measures them: do two meet, how far are they within a floor.
#pragma once

#include <vector>

#include "layoutbox/verify/drawn.h"
#include "layoutbox/verify/geometry.h"

namespace layoutbox::checks {

struct MeshBox {
  Interval x, y, z;
};

class BodyMesh {
 public:
  // REQUIRES: at least one triangle. `frame`: the body's own, along which it is made smaller.
  BodyMesh(std::vector<Triangle> triangles, Frame frame);

  // Each side `inset` metres further in (negative: further out), the middle where it is.
  BodyMesh inset(double inset) const;
  BodyMesh lowered(double by) const;

  const MeshBox& box() const { return box_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  std::vector<Triangle> triangles_;
  Frame frame_;
  MeshBox box_;
};

// Their surfaces cut each other, or one is wholly inside the other.
bool meet(const BodyMesh& a, const BodyMesh& b);
// By how much each of the two would have to be smaller at each side for them to part, to the millimetre, and `most` at most.
double depth_of_meeting(const BodyMesh& a, const BodyMesh& b, double most);
// The share of its surface that does not lie over the floor.
double share_off(const BodyMesh& mesh, const Polygon& floor);

}  // namespace layoutbox::checks
