// Model to pictures by Blender: writes the script, finds a Blender, runs it, checks what it made.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/furnish/model.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

enum class Quality { kDraft, kPreview, kFinal };

// Where from: iso (from above at the front right), top (a plan), front (from the front, a doll's house), eye (standing in the room, in the
// corner with the best view), door (standing in the door).
enum class View { kIso, kTop, kFront, kEye, kDoor };

// "iso", "top", …
std::string_view name_of(View view);
std::optional<View> view_from_name(std::string_view name);
// "scene.png" for iso, "scene-top.png" for top, …
std::string picture_name(View view);

// Which corner of the room the camera of iso stands at: the one from which most fronts are seen and least is hidden, or that one.
enum class Corner { kBest, kNorthEast, kNorthWest, kSouthEast, kSouthWest };

// "best", "NE", "NW", "SE", "SW".
std::string_view name_of(Corner corner);
std::optional<Corner> corner_from_name(std::string_view name);
// Never kBest; the front right one (SE) where no other shows clearly more of what was asked for.
Corner best_corner(const Layout& layout, const Catalog& catalog, double elevation_deg = 65);

struct RenderOptions {
  Quality quality = Quality::kPreview;
  std::vector<View> views{View::kIso};  // one picture each
  int width = 1920, height = 1080;      // pixels. REQUIRES: 16…16384
  Corner corner = Corner::kBest;
  std::optional<double> azimuth_deg;  // of iso, in the corner's place: 45 is SE, at the front right (+x, −y), looking to the back left
  double elevation_deg = 65;
  bool orthographic = true;
  bool save_blend = true;
  // Also write an object mask (PNG, each object a flat colour) and its index (JSON), for visibility checks. DEFAULT: false.
  bool object_mask = false;
  // Also the first view with the objects' names, clearances, and what does not hold in red (scene-overlay.png). DEFAULT: false.
  bool overlay = false;
  // Also the overlay, else the first view, as a small JPEG for pages that show many (scene-small.jpg). DEFAULT: false.
  bool thumbnail = false;
  // No wall is cut away, as in the paper's pictures: near ones hide the room. For comparing; inside views have them anyway. DEFAULT: false.
  bool all_walls = false;
  // Also iso turned once round the room: "gif", "mp4", or empty for none. DEFAULT: none.
  std::string turntable;
  double time_limit_s = 600;
  const std::atomic<bool>* stop = nullptr;
  // Called with a share done in [0, 1]; may be empty.
  std::function<void(double)> progress;
};

// The azimuth of iso for that layout, degrees.
double azimuth_from(const Layout& layout, const Catalog& catalog, const RenderOptions& options);

// The self-contained script: readable Python on top, the meshes in one compressed block at its end. Runs by itself:
//   blender -b --python blender.py            (writes scene.blend and scene.png beside itself, or into the folder after `--`)
//   python3 blender.py                        (a Python with the module bpy)
std::string write_blender_script(const Model& model, const Layout& layout, const Catalog& catalog, const RenderOptions& options);

// A Blender that works: how it is started and what it is.
struct Blender {
  std::vector<std::string> command;  // {"blender"} or {"/…/python3"} with bpy
  bool is_python_module = false;
  std::string version;  // "5.0.1"
};

// Looks at LAYOUTBOX_BLENDER, `blender` on the PATH, a Python with `bpy`, the private environment of setup.sh. Error kNoBlender with
// what was tried and how to get one.
Result<Blender> find_blender();

struct RenderOutputs {
  std::filesystem::path picture, blend, mask, mask_index, turntable,
      thumbnail;                                // picture: the first view; the others empty unless asked for
  std::vector<std::filesystem::path> pictures;  // of all views in their order, then the overlay
  std::string blender_version;
  // All that there are, in the order they were asked for.
  std::vector<std::filesystem::path> files() const;
};

// Runs script_file (as written above) and puts scene.png and scene.blend into `folder`, each under a temporary name first and renamed only
// when it is whole. Errors: kNoBlender, kRenderFailed (with the last lines of Blender's log), kInterrupted, kIo.
Result<RenderOutputs> run_blender(const Blender& blender, const std::filesystem::path& script_file, const std::filesystem::path& folder,
                                  const RenderOptions& options);

struct ServerOptions {
  double memory_limit_mb = 8000;   // a job that needs more is ended and fails
  double restart_above_mb = 1500;  // a new process after a job that leaves it larger than this
  int restart_after_jobs = 200;    // and after so many jobs in any case
};

// One Blender that draws many rooms, one after the other: saves its start for each (about a second). Starts at the first job, and again
// when it died, grew or was ended; a job during which it died is tried once more in a new process. Not for use by two threads at once.
class BlenderServer {
 public:
  explicit BlenderServer(Blender blender, const ServerOptions& options = {});
  BlenderServer(BlenderServer&&) noexcept;
  BlenderServer& operator=(BlenderServer&&) noexcept;
  ~BlenderServer();  // as close()

  // As run_blender(), in the running process.
  Result<RenderOutputs> render(const std::filesystem::path& script_file, const std::filesystem::path& folder, const RenderOptions& options);
  int starts() const;  // how often a process was started
  // Ends the process; nothing is left behind. A later job starts a new one.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace layoutbox
