#include "layoutbox/judge/judge.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "layoutbox/base/files.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/judge_pictures.h"
#include "layoutbox/cli/judge_questions.h"
#include "layoutbox/judge/report_html.h"

namespace layoutbox::cli {
namespace {

namespace fs = std::filesystem;

struct JudgeArguments {
  std::vector<std::string> files;
  std::string scene, annotations, id, format, models, output, report, picture;
  bool reasons = false, unsafe_scripts = false;
  QuestionFlags questions;
};

struct RoomPlace {
  std::string id, path;
};

// The name of a room: of DIR/ID/layout.json and DIR/ID.layout.json the ID, else the file's stem.
std::string id_of(const fs::path& path) {
  const std::string name = path.filename().string();
  if (name == "layout.json" || name == "scene.json" || name == "scene.glb" || name == "scene.blend")
    return path.parent_path().filename().string();
  if (name.ends_with(".layout.json")) return name.substr(0, name.size() - std::string(".layout.json").size());
  return path.stem().string();
}

// A file, or every room in a folder that has one folder or file for each.
std::vector<RoomPlace> places_of(const std::vector<std::string>& files) {
  std::vector<RoomPlace> places;
  for (const std::string& file : files) {
    std::error_code error;
    if (file == "-" || !fs::is_directory(file, error)) {
      places.push_back({file == "-" ? "-" : id_of(fs::absolute(file, error)), file});
      continue;
    }
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(file, error)) {
      if (entry.is_directory(error) && fs::exists(entry.path() / "layout.json", error)) inside.push_back(entry.path() / "layout.json");
      if (entry.path().filename().string().ends_with(".layout.json")) inside.push_back(entry.path());
    }
    std::sort(inside.begin(), inside.end());
    for (const fs::path& path : inside) places.push_back({id_of(path), path.string()});
  }
  return places;
}

class JudgeRun {
 public:
  JudgeRun(const JudgeArguments& flags, const Console& console) : flags_(flags), console_(console) {}

  int run() {
    if (const Status read = read_what_was_asked(); !read) return console_.fail(read.error());
    std::vector<RoomPlace> places = places_of(flags_.files);
    if (!flags_.id.empty() && places.size() == 1) places[0].id = flags_.id;
    if (places.empty())
      return console_.fail(
          {ErrorCode::kEmpty, "there is no room in what was given", flags_.files[0], "name files, or a folder of ID/layout.json", {}});
    std::vector<Judgement> judgements;
    for (const RoomPlace& place : places) {
      if (const Status judged = judge_one(place, places.size() == 1, judgements); !judged) return console_.fail(judged.error());
    }
    if (flags_.questions.wanted()) {
      QuestionFlags questions = flags_.questions;
      questions.options.reasons = flags_.reasons;
      return answer_questions(questions, judgements, pictures_, flags_.output, console_);
    }
    add_missing(places, judgements);
    const std::string json = judgement_json(judgements);
    if (!flags_.output.empty()) {
      if (const Status written = write_output(flags_.output, json); !written) return console_.fail(written.error());
    }
    if (!flags_.report.empty()) {
      if (const Status written = write_file(flags_.report, judgement_html(judgements, pictures_)); !written)
        return console_.fail(written.error());
    }
    if (flags_.output != "-") console_.result(judgement_text(judgements, flags_.reasons), json);
    const bool all = std::all_of(judgements.begin(), judgements.end(), [](const Judgement& judgement) { return judgement.everything; });
    return all ? kDone : kNotAsAsked;
  }

 private:
  Status read_what_was_asked() {
    if (!flags_.scene.empty()) {
      LAYOUTBOX_ASSIGN(scene_, read_scene_file(flags_.scene));
    }
    if (!flags_.annotations.empty()) {
      LAYOUTBOX_ASSIGN(const std::string text, read_input(flags_.annotations));
      auto annotations = scoring::read_annotations(text);
      if (!annotations) return Failure(in_file(std::move(annotations).error(), flags_.annotations));
      annotations_ = *std::move(annotations);
    }
    options_.format = flags_.format;
    options_.without_walls = flags_.unsafe_scripts;
    if (!flags_.models.empty()) {
      LAYOUTBOX_ASSIGN(options_.models, read_input(flags_.models));
    }
    return {};
  }

  const scoring::Annotation* annotation_for(const std::string& id) const {
    for (const scoring::Annotation& annotation : annotations_) {
      if (annotation.id == id) return &annotation;
    }
    return nullptr;
  }

  Result<Asked> asked_for(const std::string& id) const {
    Asked asked;
    asked.scene = scene_;
    if (annotations_.empty()) return asked;
    const scoring::Annotation* annotation = annotation_for(id);
    if (annotation == nullptr) {
      return fail(ErrorCode::kReference, fmt::format("the table of annotations has no row \"{}\"", id), flags_.annotations,
                  "name the row by --id, or the file by it: ID/layout.json");
    }
    asked.annotation = *annotation;
    return asked;
  }

  // A file that is the only one must be read; of many, one that is broken counts as missed.
  Status judge_one(const RoomPlace& place, bool alone, std::vector<Judgement>& judgements) {
    LAYOUTBOX_ASSIGN(const Asked asked, asked_for(place.id));
    auto bytes = read_input(place.path);
    auto room = bytes ? read_room_file(*bytes, Catalog::builtin(), options_) : Result<RoomFile>(Failure(bytes.error()));
    if (!room) {
      if (alone) return Failure(std::move(room).error());
      console_.warn(fmt::format("{}: {}", place.path, room.error().message));
      judgements.push_back(judge_missing(place.id, room.error().message, asked));
      return {};
    }
    room->name = place.id;
    LAYOUTBOX_CHECK(find_picture(place, alone));
    judgements.push_back(judge_room(*std::move(room), asked, Catalog::builtin()));
    return {};
  }

  Status find_picture(const RoomPlace& place, bool alone) {
    if (flags_.report.empty() && !flags_.questions.shows_pictures()) return {};
    LAYOUTBOX_ASSIGN(std::optional<RoomPicture> picture, picture_of_room(place.path, alone ? flags_.picture : std::string()));
    if (picture) pictures_[place.id] = *std::move(picture);
    return {};
  }

  // Rows of the table that no file is for: all missed, where whole folders are judged.
  void add_missing(const std::vector<RoomPlace>& places, std::vector<Judgement>& judgements) const {
    if (places.size() < 2) return;
    for (const scoring::Annotation& annotation : annotations_) {
      const bool there = std::any_of(places.begin(), places.end(), [&](const RoomPlace& place) { return place.id == annotation.id; });
      if (there) continue;
      Asked asked;
      asked.annotation = annotation;
      judgements.push_back(judge_missing(annotation.id, "no file", asked));
    }
  }

  const JudgeArguments& flags_;
  const Console& console_;
  std::optional<SceneGraph> scene_;
  std::vector<scoring::Annotation> annotations_;
  RoomFileOptions options_;
  std::map<std::string, RoomPicture> pictures_;
};

}  // namespace

void add_judge(CLI::App& app, Context& context) {
  auto flags = std::make_shared<JudgeArguments>();
  CLI::App* command = app.add_subcommand("judge", "Judge anybody's rooms: what was asked for, and the field's measures, by geometry");
  command
      ->add_option("rooms", flags->files,
                   "Rooms: layout, scene with positions, glTF, .blend, SceneEval state, LayoutVLM or Holodeck JSON; or a folder")
      ->required();
  auto* scene = command->add_option("--scene", flags->scene, "What was asked for, as a scene graph");
  command->add_option("--annotations", flags->annotations, "What was asked for, as a table (ID, Description, ObjCount, OORel, OARel)")
      ->excludes(scene);
  command->add_option("--id", flags->id, "The row of the table, where the file's name does not say it");
  command->add_option("--format", flags->format, "Read the rooms as this format instead of by what they look like");
  command->add_option("--models", flags->models, "JSON with names and sizes of models, for formats that name only models");
  command->add_option("-o,--output", flags->output, "Where the judgement goes as JSON; - writes it to stdout");
  command->add_option("--report", flags->report, "Where a page goes: picture, plan with the failures drawn in, tables; one file");
  command->add_option("--image,--picture", flags->picture,
                      "A picture of the room for the page and for questions (else scene.png beside it)");
  command->add_flag("--unsafe-scripts", flags->unsafe_scripts, "Open a .blend although there is no sandbox on this machine");
  flags->questions.add_to(*command, true);
  command->add_flag("--reasons", flags->reasons, "Each failed entry and check, with what was measured");
  command->callback([flags, &context] { context.status = JudgeRun(*flags, context.console).run(); });
}

}  // namespace layoutbox::cli
