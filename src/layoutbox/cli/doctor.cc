#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/cli/commands.h"
#include "layoutbox/export/cairo_canvas.h"

namespace layoutbox::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Finding {
  std::string what;
  bool there = false;
  std::string detail;  // path and version, or why it is missing
  std::string costs;   // what does not work without it
  std::string remedy;  // how to get it
};

Finding examine_solver() {
  const auto library = describe_cp_sat_library();
  if (library) return {"CP-SAT solver library", true, *library, "", ""};
  return {"CP-SAT solver library", false, library.error().message,
          "rooms that the quick search cannot furnish, and proofs that a room is impossible", library.error().hint};
}

Finding examine_blender() {
  const auto blender = find_blender();
  if (!blender)
    return {"Blender", false, blender.error().message, "pictures (scene.png) and scene.blend; all other files are made",
            blender.error().hint};
  return {"Blender", true, fmt::format("{}, {}", fmt::join(blender->command, " "), blender->version), "", ""};
}

Finding examine_cairo() {
  const auto cairo = describe_cairo();
  if (!cairo) return {"Cairo", false, cairo.error().message, "floor plans as PDF and PNG; SVG needs it not", cairo.error().hint};
  return {"Cairo", true, *cairo, "", ""};
}

int run(const Console& console) {
  const Catalog& catalog = Catalog::builtin();
  const Finding findings[] = {{"layoutbox", true,
                               fmt::format("version {}, {} kinds of furniture, {} kinds of room", program_version(),
                                           catalog.entries().size(), catalog.rooms().size()),
                               "", ""},
                              examine_solver(),
                              examine_blender(),
                              examine_cairo()};
  std::string text;
  Json json = Json::array();
  bool all_there = true;
  for (const Finding& finding : findings) {
    all_there = all_there && finding.there;
    text += fmt::format("{} {}: {}\n", finding.there ? "ok     " : "MISSING", finding.what, finding.detail);
    if (!finding.there) text += fmt::format("        without it: no {}\n        to get it: {}\n", finding.costs, finding.remedy);
    json.push_back({{"what", finding.what},
                    {"there", finding.there},
                    {"detail", finding.detail},
                    {"costs", finding.costs},
                    {"remedy", finding.remedy}});
  }
  text.pop_back();
  console.result(text, json.dump());
  return all_there ? kDone : kWrongSurroundings;
}

}  // namespace

void add_doctor(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("doctor", "What is installed, what is missing, what each missing thing costs, how to get it");
  command->callback([&context] { context.status = run(context.console); });
}

}  // namespace layoutbox::cli
