#include "layoutbox/experiment/charts.h"

#include <fmt/format.h>

#include <string_view>

#include "layoutbox/judge/report_html.h"

namespace layoutbox::experiment {
namespace {

constexpr double kNames = 150, kColumn = 118, kPlot = 96, kRow = 24, kHead = 30;  // px

struct ChartColumn {
  std::string name;
  bool more_is_better;
};

std::vector<ChartColumn> columns() {
  std::vector<ChartColumn> all{{"everything", true}};
  for (const MeasureRow& row : measure_rows()) {
    if (row.name != "CF" && row.name != "IB") all.push_back({std::string(row.name), row.more_is_better});  // 1 − COL and 1 − OOB
  }
  return all;
}

std::string dot(const vlm::Estimate& share, double x, double y, bool more_is_better) {
  const double good = more_is_better ? share.value : 1 - share.value;
  const std::string_view color = good >= 0.99 ? "#186a1e" : good >= 0.5 ? "#33658a" : "#b00000";
  return fmt::format(
      "<line x1={:.1f} x2={:.1f} y1={:.0f} y2={:.0f} stroke={} stroke-width=3 stroke-opacity=.35 />"
      "<circle cx={:.1f} cy={:.0f} r=4 fill={}><title>{:.1f} % [{:.0f}, {:.0f}]</title></circle>",
      x + kPlot * share.low, x + kPlot * share.high, y, y, color, x + kPlot * share.value, y, color, share.value * 100, share.low * 100,
      share.high * 100);
}

}  // namespace

std::string shares_chart(const std::vector<std::pair<std::string, Records>>& groups) {
  const std::vector<ChartColumn> all = columns();
  const double width = kNames + kColumn * static_cast<double>(all.size()), height = kHead + kRow * static_cast<double>(groups.size()) + 18;
  std::string svg = fmt::format("<svg class=chart viewBox=\"0 0 {:.0f} {:.0f}\" role=img aria-label=\"Shares by method\">", width, height);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const double x = kNames + kColumn * static_cast<double>(c);
    svg += fmt::format("<text x={:.0f} y=16 font-weight=600>{}{}</text>", x, all[c].name, all[c].more_is_better ? "" : " (less)");
    for (const double at : {0.0, 0.5, 1.0}) {
      svg += fmt::format("<line x1={0:.0f} x2={0:.0f} y1={1:.0f} y2={2:.0f} stroke=#e0e0e0 />", x + kPlot * at, kHead - 6, height - 16);
    }
    svg += fmt::format("<text x={:.0f} y={:.0f} class=axis>0</text><text x={:.0f} y={:.0f} class=axis text-anchor=end>100 %</text>", x,
                       height - 4, x + kPlot + 8, height - 4);
  }
  for (std::size_t r = 0; r < groups.size(); ++r) {
    const double y = kHead + kRow * (static_cast<double>(r) + 0.5);
    svg += fmt::format("<text x=0 y={:.0f}>{}</text>", y + 4, escaped_html(groups[r].first));
    for (std::size_t c = 0; c < all.size(); ++c) {
      const auto share = c == 0 ? everything_over(groups[r].second) : measure_over(groups[r].second, all[c].name);
      if (share) svg += dot(*share, kNames + kColumn * static_cast<double>(c), y, all[c].more_is_better);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace layoutbox::experiment
