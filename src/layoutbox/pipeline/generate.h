// The whole way from text to a furnished, checked room, and the only place that knows the order of the stages.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/export/export.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/plan/planner.h"
#include "layoutbox/render/render.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {

// How a stage went; reported as it ends, and kept in run.json.
struct StageTime {
  std::string stage;  // "plan", "solve", "dress", "furnish", "export", "verify", "render"
  double seconds = 0;
  std::string summary;  // "6 objects, 4 relations"
};

// A file besides the prompt that a run read: kept in run.json, so that it shows when one has changed.
struct InputFile {
  std::string option, file, key;  // "--catalog", its path, content_key() of its text
};

// Draws the pictures of a script that stands in a folder, into that folder.
using DrawPictures =
    std::function<Result<RenderOutputs>(const std::filesystem::path& script, const std::filesystem::path& folder, const RenderOptions&)>;

// How often a model is asked, where a model plans (pipeline/repair.h).
struct RepairOptions {
  // All answers of a run, those that do not validate included. REQUIRES: > 0. DEFAULT: 5, as in the paper.
  int max_attempts = 5;
  // Of these after the first scene that has no layout, each with the reason and ways out. DEFAULT: 2.
  int repair_attempts = 2;
  // As the paper does: a notice without a reason, one new scene, then the scene's own positions. DEFAULT: false.
  bool paper_retries = false;
  // Seconds between attempts. DEFAULT: 1.
  double pause_s = 1;
};

struct GenerateOptions {
  // Who plans, in words that differ where the scene may: kept in run.json.
  std::string planner = "offline";
  PlanOptions plan;
  // What the use of the named things needs comes with them (plan/companions.h), and the finished room is dressed (dress/dress.h), where a
  // text is planned without a model. DEFAULT: true.
  bool companions = true;
  RepairOptions repair;
  NormalizeOptions normalize;
  // A shell of the user's own (polygon, walls, openings) that takes the place of the scene's; its kind of room stays the scene's where
  // the shell names none. DEFAULT: none.
  std::optional<Room> shell;
  SolveOptions solve;
  // How many layouts are made, each unlike the others; the first is furnished, drawn and judged, of the others there is the layout and
  // its floor plan. REQUIRES: > 0. DEFAULT: 1.
  int variants = 1;
  FurnishOptions furnish;
  RenderOptions render;
  VerifyOptions verify;
  // DEFAULT: true. False: no Blender is looked for; scene.blend and scene.png are not made.
  bool pictures = true;
  // Who draws them; empty: a Blender that is looked for and started for this room alone.
  DrawPictures draw;
  // What else the room depends on. DEFAULT: none.
  std::vector<InputFile> inputs;
  // Set by another thread or a signal to stop; what is finished is kept. May be null. Passed on to every stage.
  const std::atomic<bool>* stop = nullptr;
  // Called as each stage ends; may be empty.
  std::function<void(const StageTime&)> on_stage;
};

// What a run made. Files are named relative to the output folder, in the order they were written.
struct GenerateOutcome {
  SceneGraph scene;  // normalised, with its notes
  Layout layout;
  std::vector<Layout> more_layouts;  // the other variants
  Report report;
  std::vector<StageTime> stages;
  std::vector<std::string> files;
  std::string model_requests;          // what was asked of a model and answered, as a JSON list; empty: nothing
  std::string blender_version;         // empty when no picture was made
  std::optional<Error> picture_error;  // why there is no picture although one was asked for; all else is there
};

// Writes into `folder`: scene.json, layout.json, floorplan.svg, scene.glb, blender.py, scene.blend, scene.png, report.json, run.json.
// Each file appears whole or not at all. Only one run at a time may write into a folder (kIo otherwise).
// Errors: those of the stages; files of the stages before are there, and run.json says where it ended.
Result<GenerateOutcome> generate(std::string_view prompt, const Planner& planner, const Catalog& catalog,
                                 const std::filesystem::path& folder, const GenerateOptions& options = {});

// The same from a scene that is already there (a file of the paper's form, an earlier scene.json).
Result<GenerateOutcome> generate_from_scene(SceneGraph scene, const Catalog& catalog, const std::filesystem::path& folder,
                                            const GenerateOptions& options = {});

// The same from a layout that is there already (an edited one), and the normalised scene it belongs to: nothing is solved.
Result<GenerateOutcome> generate_from_layout(SceneGraph scene, Layout layout, const Catalog& catalog, const std::filesystem::path& folder,
                                             const GenerateOptions& options = {});

// The scene in the shell of `options`, with everything filled in: what solve() takes.
Result<SceneGraph> prepare_scene(SceneGraph scene, const Catalog& catalog, const GenerateOptions& options);

// Do things that nobody named come with that plan: where the options let them, and no model planned.
bool comes_with_more(const Plan& plan, const GenerateOptions& options);

// The same of a plan from text, with the companions of what it names.
Result<SceneGraph> prepare_plan(const Plan& plan, const Catalog& catalog, const GenerateOptions& options);

// What a layout of such a plan gets besides, where the options let companions come (dress/dress.h); the scene gets the same.
// REQUIRES: the scene is prepare_plan()'s, the layout solve()'s of it. Returns how many things were added.
std::size_t dress_room(const Plan& plan, SceneGraph& scene, Layout& layout, const Catalog& catalog, const GenerateOptions& options);

// Is that the name of a file that a run writes?
bool is_output_name(std::string_view name);

// True when the room is what was asked for: solved, nothing hard given up, every required check passed.
bool as_asked(const GenerateOutcome& outcome);
bool as_asked(const Layout& layout, const Report& report);

// The program's version, "0.1.0".
std::string_view program_version();

}  // namespace layoutbox
