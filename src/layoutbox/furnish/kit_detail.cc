#include "layoutbox/furnish/kit_detail.h"

namespace layoutbox::kit {
namespace {

thread_local Detail level = Detail::kUsual;

}  // namespace

DetailScope::DetailScope(Detail detail) { level = detail; }
DetailScope::~DetailScope() { level = Detail::kUsual; }

Detail detail() { return level; }

int sides_at_detail(int sides) {
  if (level == Detail::kUsual || sides < 8) return sides;
  if (level == Detail::kLow) return std::max(8, (sides + 7) / 8 * 4);
  return (sides * 7 / 4 + 3) / 4 * 4;
}

int steps_at_detail(int steps, int least) {
  switch (level) {
    case Detail::kLow: return std::min(steps, std::max(least, steps / 2));  // what is coarse already stays so
    case Detail::kUsual: return steps;
    case Detail::kHigh: return steps * 2;
  }
  return steps;
}

double bevel_at_detail(double bevel) { return level == Detail::kLow ? 0 : bevel; }

}  // namespace layoutbox::kit
