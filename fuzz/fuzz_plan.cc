// Any bytes as a prompt: a scene that can be written and read, or an error.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/planner.h"
#include "layoutbox/scene/scene_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace layoutbox;
  static const std::unique_ptr<Planner> planner = make_offline_planner(Catalog::builtin());
  const Result<Plan> plan = planner->plan({reinterpret_cast<const char*>(data), size}, {});
  if (!plan) return 0;
  if (!read_scene(write_scene(plan->scene))) std::abort();
  (void)normalize_scene(plan->scene, Catalog::builtin());
  return 0;
}
