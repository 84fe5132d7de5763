// What would make a room possible.
#include <algorithm>
#include <utility>

#include "layoutbox/pipeline/ways_out.h"
#include "layoutbox/serve/call_parts.h"

namespace layoutbox::serve {
namespace {

constexpr double kLongestLook = 10;  // seconds

}  // namespace

Result<Answer> remedies_call(const Json& request, const Surroundings& around) {
  LAYOUTBOX_ASSIGN(GenerateOptions options, generate_options(request, around));
  options.solve.on_progress = {};  // of each of many small tries
  LAYOUTBOX_ASSIGN(const Layout layout, layout_of(request));
  LAYOUTBOX_CHECK(scene_of_request(request));
  WaysOutOptions limits;
  limits.time_limit_s = std::min(kLongestLook, options.solve.time_limit_s);
  const Json& scene = request.at("scene");
  Json ways = Json::array();
  for (const WayOut& way : find_ways_out(scene.dump(), layout, around.catalog, options, limits)) {
    ways.push_back({{"sentence", way.sentence}, {"scene", scene.patch(Json::parse(way.patch))}});
  }
  return json_answer({{"ways", std::move(ways)}});
}

}  // namespace layoutbox::serve
