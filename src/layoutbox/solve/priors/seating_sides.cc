// How many sit at each side of a table: the most even ways first.
#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/priors/seating.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kSquare = 150;  // sides that differ by less are alike
constexpr int kSqueezed = 60;

struct Arm {
  double x, y;
};

// 0 (one heap) to 1 (like distances, like angles), the measure of SceneEval for "surround".
double evenness(const std::vector<Arm>& arms) {
  const std::size_t n = arms.size();
  if (n < 2) return 1;
  std::vector<double> lengths, angles;
  for (const Arm& a : arms) {
    lengths.push_back(std::hypot(a.x, a.y));
    angles.push_back(std::atan2(a.y, a.x));
  }
  std::vector<double> sorted = lengths;
  std::sort(sorted.begin(), sorted.end());
  const double typical = n % 2 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
  const double ideal = 2 * kPi / static_cast<double>(n);
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double next = 2 * kPi;
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) continue;
      const double turn = std::fmod(angles[j] - angles[i] + 4 * kPi, 2 * kPi);
      next = std::min(next, turn);
    }
    const double off_distance = std::min(1.0, std::abs(lengths[i] - typical) / typical),
                 off_angle = std::min(1.0, std::abs(next - ideal) / ideal);
    total += (0.5 * (1 - off_distance) * (1 - off_distance) + 0.5 * (1 - off_angle) * (1 - off_angle)) / static_cast<double>(n);
  }
  return total;
}

std::vector<Arm> arms_of(const Seats& seats, Mm width, Mm depth, Mm out) {
  std::vector<Arm> arms;
  for (int s = 0; s < 4; ++s) {
    const double length = s < 2 ? width : depth, off = (s < 2 ? depth : width) / 2.0 + out;
    for (int k = 0; k < seats[s]; ++k) {
      const double along = length * (2 * k + 1) / (2.0 * seats[s]) - length / 2;
      if (s == 0) arms.push_back({along, -off});
      if (s == 1) arms.push_back({along, off});
      if (s == 2) arms.push_back({-off, along});
      if (s == 3) arms.push_back({off, along});
    }
  }
  return arms;
}

// The less even, the more crowded and the less usual, the dearer.
int price_of(const Seats& s, int n, Mm width, Mm depth, Mm seat_width, bool circle) {
  const double even = n == 1 ? 1 : evenness(arms_of(s, width, depth, seat_width / 2 - measures().pushed_under));
  int price = static_cast<int>((1 - even) * (circle ? 600 : 300));
  price += 40 * (std::abs(s[0] - s[1]) + std::abs(s[2] - s[3]));
  for (std::size_t side = 0; side < s.size(); ++side) {
    if (s[side] >= 2 && s[side] * (seat_width + measures().elbows) > (side < 2 ? width : depth)) price += kSqueezed;
  }
  if (n <= 4 && std::abs(width - depth) < kSquare && std::ranges::max(s) > 1) price += 120;        // one at each side of a square one
  if (n <= 2 && (width > depth ? s[2] + s[3] : width < depth ? s[0] + s[1] : 0) > 0) price += 20;  // long sides first
  return price;
}

}  // namespace

std::vector<std::pair<Seats, int>> seatings(int n, Mm width, Mm depth, Mm seat_width, bool circle, std::size_t limit) {
  std::vector<std::pair<Seats, int>> found;
  const int half = (n + 1) / 2;
  const auto room_for = [&](Mm length) { return std::max(1, static_cast<int>((length + 40) / (seat_width + 40))); };
  const int along = std::min(room_for(width), n), deep = std::min(room_for(depth), n);
  for (Seats s{}; s[0] <= std::min(along, half); ++s[0]) {
    for (s[1] = 0; s[1] <= std::min(along, half); ++s[1]) {
      for (s[2] = 0; s[2] <= std::min(deep, half); ++s[2]) {
        s[3] = n - s[0] - s[1] - s[2];
        if (s[3] < 0 || s[3] > std::min(deep, half)) continue;
        found.push_back({s, price_of(s, n, width, depth, seat_width, circle)});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (found.size() > limit) found.resize(limit);
  return found;
}

}  // namespace layoutbox::placement
