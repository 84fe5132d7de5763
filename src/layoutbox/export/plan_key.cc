#include "layoutbox/export/plan_key.h"

#include <fmt/format.h>

#include <algorithm>

namespace layoutbox {

void draw_number(Canvas& page, PaperPoint at, int number) {
  page.circle(at, kNumberRadius, {"#fff", "#555", 0.15, {}});
  page.text({at.x, at.y + 0.7}, number < 10 ? 2.1 : 1.8, std::to_string(number));
}

void draw_key(Canvas& page, const std::vector<KeyRow>& rows, const PaperBox& box) {
  constexpr double kStep = 4.6, kLeastStep = 3.4, kName = 2.2, kSize = 1.8;
  const double step = std::clamp(box.height() / std::max(1.0, double(rows.size())), kLeastStep, kStep);
  const auto most = static_cast<std::size_t>(box.height() / step + 0.01);
  double y = box.y0 + step / 2;
  for (std::size_t i = 0; i < rows.size(); ++i, y += step) {
    if (i + 1 == most && rows.size() > most) {
      page.text({box.x0, y + 0.7}, kName, fmt::format("and {} kinds more", rows.size() - i), TextAnchor::kStart, 0, "#666");
      return;
    }
    draw_number(page, {box.x0 + kNumberRadius, y}, static_cast<int>(i) + 1);
    const double left = box.x0 + 2 * kNumberRadius + 1, has = box.x1 - left;
    const std::string name = rows[i].count > 1 ? fmt::format("{} × {}", rows[i].count, rows[i].name) : rows[i].name;
    const double width = text_width(name, kName);
    page.text({left, y + 0.75}, kName * std::min(1.0, has / width), name, TextAnchor::kStart);
    if (rows[i].size.empty() || width + 1.5 + text_width(rows[i].size, kSize) > has) continue;
    page.text({left + width + 1.5, y + 0.75}, kSize, rows[i].size, TextAnchor::kStart, 0, "#666");
  }
}

}  // namespace layoutbox
