// Bodies drawn through outlines of their own: tubs, slings, shells.
#include "layoutbox/furnish/kit_base.h"

namespace layoutbox::kit {
namespace {

const double kSmoothLoftCosine = std::cos(radians_from_degrees(42));

// Rings of `n` points each, in order; faces between ring k and k + 1 wound so that ring × way is outside.
class Lofted {
 public:
  explicit Lofted(std::span<const std::vector<Vec>> rings) : rings_(rings), n_(rings.front().size()) {
    for (std::size_t k = 0; k + 1 < rings_.size(); ++k) {
      for (std::size_t i = 0; i < n_; ++i) faces_.push_back(cross(at(k + 1, i + 1) - at(k, i), at(k + 1, i) - at(k, i + 1)));
    }
  }

  Mesh mesh() {
    std::vector<double> along(n_, 0);
    for (std::size_t k = 0; k + 1 < rings_.size(); ++k) {
      std::vector<double> next(n_);
      double round = 0;
      for (std::size_t i = 0; i < n_; ++i) next[i] = along[i] + length(at(k + 1, i) - at(k, i));
      for (std::size_t i = 0; i < n_; ++i) {
        const std::size_t j = (i + 1) % n_;
        const double step = std::max(length(at(k, j) - at(k, i)), length(at(k + 1, j) - at(k + 1, i)));
        maker_.wound_quad(corner(k, i, k, i, {round, along[i]}), corner(k, i, k, j, {round + step, along[j]}),
                          corner(k, i, k + 1, j, {round + step, next[j]}), corner(k, i, k + 1, i, {round, next[i]}));
        round += step;
      }
      along = next;
    }
    cap(0, true);
    cap(rings_.size() - 1, false);
    return maker_.take();
  }

 private:
  Vec at(std::size_t k, std::size_t i) const { return rings_[k][i % n_]; }

  // A corner of face (k, i) at point (pk, pi): its normal is shared with the faces round that point that it meets bluntly.
  std::uint32_t corner(std::size_t k, std::size_t i, std::size_t pk, std::size_t pi, Vec2 uv) {
    const Vec own = unit(faces_[k * n_ + i]);
    Vec sum{};
    for (const std::size_t fk : {pk, pk - 1}) {
      if (fk >= rings_.size() - 1) continue;  // also where pk − 1 went below zero, and is very large
      for (const std::size_t fi : {pi % n_, (pi + n_ - 1) % n_}) {
        const Vec face = faces_[fk * n_ + fi];
        if (dot(unit(face), own) > kSmoothLoftCosine && length(face) > 0) sum = sum + face;
      }
    }
    return maker_.vertex(at(pk, pi), length(sum) > 0 ? sum : own, uv);
  }

  void cap(std::size_t k, bool first) {
    Vec middle{}, normal{};
    for (std::size_t i = 0; i < n_; ++i) middle = middle + at(k, i) * (1.0 / static_cast<double>(n_));
    for (std::size_t i = 0; i < n_; ++i) normal = normal + cross(at(k, i) - middle, at(k, i + 1) - middle);
    if (first) normal = normal * -1.0;
    const auto put = [&](Vec p) { return maker_.vertex(p, normal, {p.x, p.y}); };
    for (std::size_t i = 0; i < n_; ++i) {
      const std::uint32_t a = put(at(k, i)), b = put(at(k, i + 1)), c = put(middle);
      if (first)
        maker_.wound_triangle(b, a, c);
      else
        maker_.wound_triangle(a, b, c);
    }
  }

  std::span<const std::vector<Vec>> rings_;
  std::size_t n_;
  std::vector<Vec> faces_;
  Maker maker_;
};

}  // namespace

Mesh loft(std::span<const std::vector<Vec>> rings) { return rings.size() < 2 ? Mesh{} : Lofted(rings).mesh(); }

std::vector<Vec> ring_at(std::span<const Vec2> outline, double z) {
  std::vector<Vec> ring;
  ring.reserve(outline.size());
  for (const Vec2& p : outline) ring.push_back({p.x, p.y, z});
  return ring;
}

}  // namespace layoutbox::kit
