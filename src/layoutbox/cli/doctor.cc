#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/chat/endpoint.h"
#include "layoutbox/chat/http_client.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/export/cairo_canvas.h"
#include "layoutbox/sandbox/sandbox.h"

namespace layoutbox::cli {
namespace {

using Json = nlohmann::ordered_json;

struct DoctorFinding {
  std::string what;
  bool there = false;
  bool needed = true;  // without it something is missing that every run may want
  std::string detail;  // path and version, or why it is missing
  std::string costs;   // what does not work without it
  std::string remedy;  // how to get it
};

DoctorFinding examine_solver() {
  const auto library = describe_cp_sat_library();
  if (library) return {"CP-SAT solver library", true, true, *library, "", ""};
  return {"CP-SAT solver library",
          false,
          true,
          library.error().message,
          "rooms that the quick search cannot furnish, and proofs that a room is impossible",
          library.error().hint};
}

DoctorFinding examine_blender() {
  const auto blender = find_blender();
  if (!blender)
    return {"Blender",           false, true, blender.error().message, "pictures (scene.png) and scene.blend; all other files are made",
            blender.error().hint};
  return {"Blender", true, true, fmt::format("{}, {}", fmt::join(blender->command, " "), blender->version), "", ""};
}

DoctorFinding examine_sandbox() {
  const auto walls = sandbox::describe_walls();
  if (walls) return {"sandbox", true, false, *walls, "", ""};
  return {"sandbox", false, false, walls.error().message, "scripts that a model wrote, and .blend files of others", walls.error().hint};
}

DoctorFinding examine_http() {
  const auto library = chat::describe_http_library();
  if (library) return {"libcurl", true, false, *library, "", ""};
  return {"libcurl", false, false, library.error().message, "planning by a language model (--planner llm)", "install the package libcurl4"};
}

// Whether a model could be asked; the key itself is never shown, and nothing is sent.
DoctorFinding examine_model() {
  const auto endpoint = chat::find_endpoint();
  const std::string costs = "planning by a language model (--planner llm)";
  if (!endpoint) return {"language model", false, false, endpoint.error().message, costs, endpoint.error().hint};
  const std::string detail =
      fmt::format("{} at {}, key {}, not tried", endpoint->model, endpoint->base_url, endpoint->key.empty() ? "not set" : "set");
  if (const Status key = chat::check_key(*endpoint); !key) return {"language model", false, false, detail, costs, key.error().hint};
  return {"language model", true, false, detail, "", ""};
}

DoctorFinding examine_cairo() {
  const auto cairo = describe_cairo();
  if (!cairo) return {"Cairo", false, true, cairo.error().message, "floor plans as PDF and PNG; SVG needs it not", cairo.error().hint};
  return {"Cairo", true, true, *cairo, "", ""};
}

int run_doctor(const Console& console) {
  const Catalog& catalog = Catalog::builtin();
  const DoctorFinding findings[] = {{"layoutbox", true, true,
                                     fmt::format("version {}, {} kinds of furniture, {} kinds of room", program_version(),
                                                 catalog.entries().size(), catalog.rooms().size()),
                                     "", ""},
                                    examine_solver(),
                                    examine_blender(),
                                    examine_cairo(),
                                    examine_sandbox(),
                                    examine_http(),
                                    examine_model()};
  std::string text;
  Json json = Json::array();
  bool all_there = true;
  for (const DoctorFinding& finding : findings) {
    all_there = all_there && (finding.there || !finding.needed);
    text += fmt::format("{} {}: {}\n", finding.there ? "ok     " : finding.needed ? "MISSING" : "not set", finding.what, finding.detail);
    if (!finding.there) text += fmt::format("        without it: no {}\n        to get it: {}\n", finding.costs, finding.remedy);
    json.push_back({{"what", finding.what},
                    {"there", finding.there},
                    {"needed", finding.needed},
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
  command->callback([&context] { context.status = run_doctor(context.console); });
}

}  // namespace layoutbox::cli
