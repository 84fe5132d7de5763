#include "layoutbox/pipeline/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "layoutbox/pipeline/artefacts.h"
#include "layoutbox/solve/solver.h"

namespace layoutbox {

std::string variant_name(const std::string& path, std::size_t index) {
  if (index == 0) return path;
  const std::filesystem::path whole(path);
  return (whole.parent_path() / fmt::format("{}-{}{}", whole.stem().string(), index + 1, whole.extension().string())).string();
}

bool is_variant_name(std::string_view name) {
  return std::ranges::any_of(artefacts(), [name](const Artefact& one) {
    const std::size_t dot = one.file.find('.');
    const std::string stem = std::string(one.file.substr(0, dot)) + "-";
    const std::string_view end = one.file.substr(dot);
    if (!one.each_variant || !name.starts_with(stem) || !name.ends_with(end) || name.size() <= stem.size() + end.size()) return false;
    return name.substr(stem.size(), name.size() - stem.size() - end.size()).find_first_not_of("0123456789") == std::string_view::npos;
  });
}

std::string variant_in_words(const std::vector<Layout>& layouts, std::size_t index) {
  const Layout& layout = layouts[index];
  Difference nearest = difference_between(layouts[0], layout);
  for (std::size_t k = 1; k < index; ++k) {
    if (const Difference other = difference_between(layouts[k], layout); other.mean_m < nearest.mean_m) nearest = other;
  }
  return fmt::format("score {:.2f}, {:.2f} m from the nearest of the others on average, {} of {} objects at another wall", layout.score,
                     nearest.mean_m, nearest.other_wall, layout.objects.size());
}

}  // namespace layoutbox
