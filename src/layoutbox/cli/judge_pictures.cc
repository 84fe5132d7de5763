#include "layoutbox/cli/judge_pictures.h"

#include <fmt/format.h>

#include "layoutbox/base/files.h"
#include "layoutbox/export/export.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/render/render.h"

namespace layoutbox::cli {
namespace {

constexpr int kWidth = 960, kHeight = 540;  // of pictures drawn for a judge

Result<vlm::Picture> plan_of(const Layout& layout) {
  FloorPlanOptions plan;
  plan.dots_per_inch = 120;
  LAYOUTBOX_ASSIGN(std::string png, write_floor_plan_png(layout, Catalog::builtin(), plan));
  return vlm::Picture{"image/png", std::move(png), {}, "its floor plan"};
}

std::string words_for(View view) {
  switch (view) {
    case View::kTop: return "seen from straight above";
    case View::kFront: return "seen from the front, the front wall left out";
    case View::kEye: return "seen by somebody who stands in it";
    case View::kDoor: return "seen from its door";
    default: return "seen from above a corner";
  }
}

// Drawn now, whatever pictures there are: the views that were asked for, in their order.
Result<std::vector<vlm::Picture>> drawn_pictures(const Layout& layout, const std::vector<std::string>& views) {
  RenderOptions render;
  render.views.clear();
  render.quality = Quality::kDraft;
  render.width = kWidth, render.height = kHeight;
  render.save_blend = false;
  render.stop = &stop_flag();
  for (const std::string& name : views) {
    if (const auto view = view_from_name(name)) render.views.push_back(*view);
  }
  LAYOUTBOX_ASSIGN(const auto folder, TemporaryFolder::make("views"));
  if (!render.views.empty()) {
    LAYOUTBOX_ASSIGN(const Model model, furnish(layout, Catalog::builtin()));
    LAYOUTBOX_CHECK(write_file(folder.path() / "blender.py", write_blender_script(model, layout, Catalog::builtin(), render)));
    LAYOUTBOX_ASSIGN(const Blender blender, find_blender());
    LAYOUTBOX_CHECK(run_blender(blender, folder.path() / "blender.py", folder.path(), render));
  }
  std::vector<vlm::Picture> pictures;
  for (const std::string& name : views) {
    const auto view = view_from_name(name);
    if (!view) {
      LAYOUTBOX_ASSIGN(pictures.emplace_back(), plan_of(layout));
      continue;
    }
    LAYOUTBOX_ASSIGN(std::string png, read_file(folder.path() / picture_name(*view)));
    pictures.push_back({"image/png", std::move(png), {}, words_for(*view)});
  }
  return pictures;
}

}  // namespace

Result<std::optional<RoomPicture>> picture_of_room(const std::string& room_file, const std::string& given) {
  namespace fs = std::filesystem;
  const fs::path path = given.empty() ? fs::path(room_file).parent_path() / "scene.png" : fs::path(given);
  std::error_code error;
  if (given.empty() && !fs::exists(path, error)) return std::optional<RoomPicture>();
  LAYOUTBOX_ASSIGN(std::string bytes, read_file(path, 64u << 20));
  if (!bytes.starts_with("\x89PNG") && !bytes.starts_with("\xff\xd8")) {
    return layoutbox::fail(ErrorCode::kParse, fmt::format("{} is neither PNG nor JPEG", path.string()), path.string());
  }
  return std::optional(RoomPicture{bytes.starts_with("\xff") ? "image/jpeg" : "image/png", std::move(bytes)});
}

Result<Showing> Showing::make(const QuestionFlags& flags, const std::map<std::string, RoomPicture>& pictures, const Console& console) {
  Showing showing(flags, pictures, console);
  if (flags.publish.empty()) return showing;
  LAYOUTBOX_ASSIGN(publish::Settings settings, publish::Settings::of_user());
  LAYOUTBOX_ASSIGN(showing.publisher_, publish::make_publisher(flags.publish, std::move(settings)));
  return showing;
}

Result<std::vector<vlm::Picture>> Showing::of(const std::string& name, const Layout& layout, bool own) const {
  std::vector<vlm::Picture> shown;
  const auto found = pictures_->find(name);
  if (!flags_->views.empty()) {
    LAYOUTBOX_ASSIGN(shown, drawn_pictures(layout, flags_->views));
  } else if (own && found != pictures_->end()) {
    shown.push_back({found->second.media_type, found->second.bytes});
  } else {
    if (own) console_->say(fmt::format("judge    {} has no picture; its floor plan is shown", name));
    LAYOUTBOX_ASSIGN(shown.emplace_back(), plan_of(layout));
  }
  for (vlm::Picture& picture : shown) {
    if (publisher_ == nullptr) break;
    LAYOUTBOX_ASSIGN(picture.url, publisher_->publish({picture.media_type, picture.bytes}, &stop_flag()));
  }
  return shown;
}

}  // namespace layoutbox::cli
