#include "layoutbox/cli/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "layoutbox/base/files.h"
#include "layoutbox/catalog/room_size.h"
#include "layoutbox/cli/console.h"
#include "layoutbox/pipeline/run_record.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/quirks.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::cli {
namespace {

constexpr std::size_t kMaxInputBytes = 64u << 20;

Result<std::string> read_stdin() {
  std::string text;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stdin)) {
    text.append(buffer, count);
    if (text.size() > kMaxInputBytes) return layoutbox::fail(ErrorCode::kTooLarge, "stdin holds more than 64 MB");
  }
  return text;
}

template <class T>
Result<T> located(Result<T> result, const std::string& path) {
  if (result) return result;
  return Failure(in_file(std::move(result).error(), path));
}

}  // namespace

Error in_file(Error error, const std::string& path) {
  const std::string file = path == "-" ? "stdin" : path;
  error.pointer = error.pointer.empty() ? file : fmt::format("{}{}{}", file, error.pointer.starts_with('/') ? "#" : " ", error.pointer);
  return error;
}

void PlanFlags::add_to(CLI::App& command) {
  command
      .add_option("--planner", planner, "How text is understood: offline (no model, no network), or llm (a language model, docs/llm.md)")
      ->capture_default_str();
  command.add_option("--room", room, "Size of the room, width x depth x height: 4x3.2x3");
  command.add_option("--room-file", room_file, "A room of your own: polygon, walls and openings in the form of a scene's room")
      ->excludes("--room");
  command.add_option("--units", units, "Units of --room and of files that name none: m, cm, mm, ft, in")
      ->check([](const std::string& unit) {
        return metres_per_unit(unit) ? std::string() : fmt::format("\"{}\" is no unit of length: give m, cm, mm, ft or in", unit);
      });
  auto* file = add_catalog_option(command, catalog_file);
  command.add_flag("--catalog-only", catalog_only, "Place nothing but the furniture of --catalog")->needs(file);
  command.add_option("--assets", assets, "Folder of meshes (GLB, glTF, OBJ) with an index.csv or index.json: category, file, size, front")
      ->excludes(file);
}

void PlanFlags::add_companions_to(CLI::App& command) {
  command.add_option("--companions", companions, "What the use of named things needs comes with them (a desk's chair): on, off")
      ->capture_default_str()
      ->check(CLI::IsMember({"on", "off"}));
}

Status PlanFlags::apply(GenerateOptions& options) const {
  options.companions = companions == "on";
  if (planner != "offline" && planner != "llm") {
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("there is no planner '{}'", planner), "--planner", "use offline or llm");
  }
  if (!room.empty()) {
    LAYOUTBOX_ASSIGN(options.normalize.room_size, parse_room_size(room, units));
  }
  if (!room_file.empty()) {
    LAYOUTBOX_ASSIGN(const std::string text, read_input(room_file));
    options.inputs.push_back({"--room-file", room_file, content_key(text)});
    LAYOUTBOX_ASSIGN(options.shell, located(read_room(text, units), room_file));
  }
  return {};
}

namespace {

// The index of a folder of meshes.
Result<std::string> index_of(const std::string& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) {
    return layoutbox::fail(ErrorCode::kIo, fmt::format("{} is not a folder", folder), "--assets", "name a folder of meshes");
  }
  for (const char* name : {"index.csv", "index.json"}) {
    const auto path = std::filesystem::path(folder) / name;
    if (std::filesystem::exists(path, ignored)) return path.string();
  }
  return layoutbox::fail(ErrorCode::kIo, fmt::format("there is no index.csv or index.json in {}", folder), "--assets",
                         "list its meshes there: category,file,width,depth,height,front");
}

}  // namespace

Result<CatalogInUse> load_catalog(const std::string& file, CatalogMerge merge, const std::string& units) {
  CatalogInUse chosen;
  if (file.empty()) return chosen;
  LAYOUTBOX_ASSIGN(const std::string text, read_input(file));
  chosen.inputs.push_back({merge == CatalogMerge::kOnly ? "--catalog-only" : "--catalog", file, content_key(text)});
  LAYOUTBOX_ASSIGN(UserCatalog user, located(read_user_catalog(text, units), file));
  chosen.own = with_articles(Catalog::builtin(), user, merge);
  chosen.notes = std::move(user.notes);
  return chosen;
}

Result<CatalogInUse> PlanFlags::load_catalog() const {
  std::string file = catalog_file;
  if (file.empty() && !assets.empty()) {
    LAYOUTBOX_ASSIGN(file, index_of(assets));
  }
  return cli::load_catalog(file, catalog_only ? CatalogMerge::kOnly : CatalogMerge::kAdd, units);
}

CLI::Option* add_catalog_option(CLI::App& command, std::string& file) {
  return command.add_option("--catalog", file, "Furniture of your own, JSON or CSV: id, category, width, depth, height");
}

void add_seed_option(CLI::App& command, std::uint64_t& seed) {
  // Else CLI11 takes -1 for the largest number and nothing for 0.
  const auto is_seed = [](const std::string& text) {
    const bool whole = !text.empty() && text.size() <= 19 && text.find_first_not_of("0123456789") == std::string::npos;
    return whole ? std::string() : fmt::format("\"{}\" is no seed: give a whole number of at most 19 digits", text);
  };
  command.add_option("--seed", seed, "Which of the good layouts; the same seed gives the same bytes")
      ->capture_default_str()
      ->check(is_seed);
}

void SolveFlags::add_to(CLI::App& command, SolveOptions& options) {
  add_seed_option(command, options.seed);
  command.add_option("--effort", options.effort, "Deterministic work units of the solver")
      ->capture_default_str()
      ->check(CLI::Range(1, 10'000'000));
  command.add_option("--time-limit", options.time_limit_s, "Seconds after which the solver stops at the latest")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 86400.0));
  command.add_option("--on-conflict", on_conflict,
                     "When not everything can hold: relax (default), original, fail; with --planner llm: repair");
}

void add_variants_to(CLI::App& command, GenerateOptions& options) {
  command.add_option("--variants", options.variants, "So many different layouts: layout.json, layout-2.json, …")
      ->capture_default_str()
      ->check(CLI::Range(1, 50));
}

Status SolveFlags::apply(SolveOptions& options, bool model_plans) const {
  if (on_conflict.empty() || on_conflict == "relax" || (on_conflict == "repair" && model_plans)) {
    options.on_conflict = OnConflict::kRelax;
  } else if (on_conflict == "fail") {
    options.on_conflict = OnConflict::kFail;
  } else if (on_conflict == "original") {
    options.on_conflict = OnConflict::kOriginal;
  } else if (on_conflict == "repair") {
    return layoutbox::fail(ErrorCode::kUsage, "repair asks a language model, and the offline planner is none", "--on-conflict",
                           "use relax, original or fail");
  } else {
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("'{}' is not a way to meet a conflict", on_conflict), "--on-conflict",
                           "use relax, original or fail");
  }
  options.stop = &stop_flag();
  return {};
}

void RenderFlags::add_to(CLI::App& command) {
  command.add_option("--quality", quality, "draft, preview or final")->capture_default_str();
  command.add_option("--size", size, "Width x height of the picture in pixels")->capture_default_str();
  command.add_option("--views", views, "A picture each, with commas: iso, top, front, eye (in the room), door")
      ->delimiter(',')
      ->capture_default_str();
  command.add_option("--corner", corner, "Where iso is drawn from: best (most fronts seen, least hidden), NE, NW, SE, SW")
      ->capture_default_str();
  command.add_flag("--overlay", overlay, "Also scene-overlay.png: names, clearances, and what does not hold in red");
  command.add_flag("--mask", mask, "Also mask.png and mask.json: which pixel is which object, and what is seen of each");
  command.add_option("--turntable", turntable, "Also a film once round the room: gif or mp4");
}

namespace {

Result<std::vector<View>> views_named(const std::vector<std::string>& names) {
  std::vector<View> views;
  for (const std::string& name : names) {
    const auto view = view_from_name(name);
    if (!view) {
      return layoutbox::fail(ErrorCode::kUsage, fmt::format("there is no view '{}'", name), "--views", "use iso, top, front, eye or door");
    }
    if (std::find(views.begin(), views.end(), *view) == views.end()) views.push_back(*view);
  }
  return views;
}

}  // namespace

Status RenderFlags::apply(RenderOptions& options) const {
  if (quality == "draft") {
    options.quality = Quality::kDraft;
  } else if (quality == "preview") {
    options.quality = Quality::kPreview;
  } else if (quality == "final") {
    options.quality = Quality::kFinal;
  } else {
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("there is no quality '{}'", quality), "--quality", "use draft, preview or final");
  }
  const char* const end = size.data() + size.size();
  const auto width = std::from_chars(size.data(), end, options.width);
  const bool has_x = width.ptr != end && (*width.ptr == 'x' || *width.ptr == 'X');
  const auto height = has_x ? std::from_chars(width.ptr + 1, end, options.height) : width;
  const bool in_range = options.width >= 16 && options.width <= 16384 && options.height >= 16 && options.height <= 16384;
  if (width.ec != std::errc{} || !has_x || height.ec != std::errc{} || height.ptr != end || !in_range) {
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("'{}' is not a size of a picture", size), "--size",
                           "write it as 1920x1080, each side from 16 to 16384");
  }
  if (!turntable.empty() && turntable != "gif" && turntable != "mp4") {
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("'{}' is no kind of film", turntable), "--turntable", "use gif or mp4");
  }
  const auto from = corner_from_name(corner);
  if (!from) {
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("there is no corner '{}'", corner), "--corner", "use best, NE, NW, SE or SW");
  }
  options.corner = *from;
  LAYOUTBOX_ASSIGN(options.views, views_named(views));
  options.overlay = overlay;
  options.object_mask = mask;
  options.turntable = turntable;
  options.stop = &stop_flag();
  return {};
}

void FurnishFlags::add_to(CLI::App& command) {
  command.add_option("--detail", detail, "How finely furniture is made: low, usual or high")->capture_default_str();
}

Status FurnishFlags::apply(FurnishOptions& options) const {
  const auto level = detail_from_name(detail);
  if (!level) {
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("there is no level of detail '{}'", detail), "--detail",
                           "use low, usual or high");
  }
  options.detail = *level;
  return {};
}

void clear_up(const Console& console) {
  for (const std::filesystem::path& folder : remove_abandoned_folders())
    console.say(fmt::format("removed   {}, which a killed run had left", folder.string()));
}

Result<std::string> read_prompt(const std::string& argument) { return argument == "-" ? read_stdin() : Result<std::string>(argument); }

Result<std::string> read_input(const std::string& path) { return path == "-" ? read_stdin() : read_file(path, kMaxInputBytes); }

Result<Layout> read_layout_file(const std::string& path) {
  LAYOUTBOX_ASSIGN(const std::string text, read_input(path));
  return located(read_layout(text), path);
}

Result<SceneGraph> read_scene_file(const std::string& path, const std::string& units) {
  LAYOUTBOX_ASSIGN(const std::string text, read_input(path));
  return located(read_scene(text, units), path);
}

Result<SceneOrLayout> read_scene_or_layout_file(const std::string& path, const std::string& units) {
  LAYOUTBOX_ASSIGN(const std::string text, read_input(path));
  SceneOrLayout file;
  if (const auto kind = kind_of_document(text); kind && *kind == "layout") {
    LAYOUTBOX_ASSIGN(file.layout, located(read_layout(text), path));
    file.scene = scene_of(*file.layout);
    return file;
  }
  LAYOUTBOX_ASSIGN(file.scene, located(read_scene(text, units), path));
  return file;
}

std::vector<std::filesystem::path> asset_folders(const std::string& input, const std::string& assets) {
  std::vector<std::filesystem::path> folders;
  if (!assets.empty()) folders.emplace_back(assets);
  const std::filesystem::path beside = input.empty() || input == "-" ? "." : std::filesystem::path(input).parent_path();
  folders.push_back(beside.empty() ? "." : beside);
  return folders;
}

Status write_output(const std::string& path, std::string_view bytes) {
  return path.empty() || path == "-" ? write_stdout(bytes) : write_file(path, bytes);
}

}  // namespace layoutbox::cli
