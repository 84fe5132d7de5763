// What several subcommands read and how their shared options become the stages' option structs.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/user_catalog.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox::cli {

class Console;

// The catalogue of a run: ours, or ours with the user's articles.
struct CatalogInUse {
  std::optional<Catalog> own;
  std::vector<Note> notes;  // what was inferred about the user's articles
  std::vector<InputFile> inputs;
  const Catalog& get() const { return own ? *own : Catalog::builtin(); }
};

// Ours alone where `file` is empty. `kOnly`: nothing but the user's articles. Errors: those of reading the file.
Result<CatalogInUse> load_catalog(const std::string& file, CatalogMerge merge = CatalogMerge::kAdd, const std::string& units = {});

// --catalog.
CLI::Option* add_catalog_option(CLI::App& command, std::string& file);

// Options of planning, of the room and of the catalogue: --planner, --room, --room-file, --units, --catalog, --catalog-only, --assets.
struct PlanFlags {
  std::string planner = "offline";
  std::string room, room_file, units;
  std::string catalog_file, assets;
  std::string companions = "on";
  bool catalog_only = false;
  void add_to(CLI::App& command);
  // --companions, of the commands that plan from text.
  void add_companions_to(CLI::App& command);
  Status apply(GenerateOptions& options) const;
  bool by_model() const { return planner == "llm"; }
  Result<CatalogInUse> load_catalog() const;
};

void add_seed_option(CLI::App& command, std::uint64_t& seed);

// Options of the solver: --seed, --effort, --time-limit, --on-conflict.
struct SolveFlags {
  std::string on_conflict;
  void add_to(CLI::App& command, SolveOptions& options);
  // `model_plans`: the planner can be told of a conflict, so that "repair" means something.
  Status apply(SolveOptions& options, bool model_plans = false) const;
};

// --variants.
void add_variants_to(CLI::App& command, GenerateOptions& options);

// Options of pictures: --quality, --size, --views, --corner, --overlay, --mask, --turntable.
struct RenderFlags {
  std::string quality = "preview";
  std::vector<std::string> views{"iso"};
  std::string turntable;
  bool overlay = false, mask = false;
  std::string size = "1920x1080", corner = "best";
  void add_to(CLI::App& command);
  Status apply(RenderOptions& options) const;
};

// How things are made: --detail.
struct FurnishFlags {
  std::string detail = "usual";
  void add_to(CLI::App& command);
  Status apply(FurnishOptions& options) const;
};

// Before a run: temporary folders that killed runs left are removed, and said to be.
void clear_up(const Console& console);

// A prompt as given, or all of stdin for "-".
Result<std::string> read_prompt(const std::string& argument);

// A file's text, or all of stdin for "-".
Result<std::string> read_input(const std::string& path);

// An error in a file's text, its place with the file before it: "scene.json#/room/dims/w", "prompts.csv line 2".
Error in_file(Error error, const std::string& path);

Result<Layout> read_layout_file(const std::string& path);
Result<SceneGraph> read_scene_file(const std::string& path, const std::string& units = {});

// A file that may be either; of a layout also the scene it could have come from.
struct SceneOrLayout {
  SceneGraph scene;
  std::optional<Layout> layout;
};
Result<SceneOrLayout> read_scene_or_layout_file(const std::string& path, const std::string& units = {});

// Where meshes and images of the user's own are looked for: beside the input file (in this folder for "-"), and in --assets.
std::vector<std::filesystem::path> asset_folders(const std::string& input, const std::string& assets);

// Writes to a file, or to stdout for "-" or an empty path.
Status write_output(const std::string& path, std::string_view bytes);

}  // namespace layoutbox::cli
