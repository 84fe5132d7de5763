#include "layoutbox/cli/judge_questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "layoutbox/base/files.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/export/export.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/judge/vlm/pairs.h"
#include "layoutbox/judge/vlm/planted.h"
#include "layoutbox/publish/publish.h"

namespace layoutbox::cli {
namespace {

Result<chat::ChatOptions> vision_options(const QuestionFlags& flags, const Console& console) {
  chat::ChatOptions options;
  std::string model = flags.model;
  if (const char* named = std::getenv("LAYOUTBOX_VLM_MODEL"); model.empty() && named != nullptr) model = named;
  LAYOUTBOX_ASSIGN(options.endpoint, chat::find_endpoint({flags.base_url, model, flags.provider}));
  LAYOUTBOX_ASSIGN(options.prices, chat::Prices::of_user());
  options.request_limit_s = flags.timeout_s;
  options.retry.total_s = std::max(options.retry.total_s, flags.timeout_s);
  options.spend_limit->max_cost = flags.max_cost;
  options.use_cached_answers = !flags.no_cache;
  options.stop = &stop_flag();
  options.on_wait = [&console](const std::string& line) { console.say("model    " + line); };
  return options;
}

constexpr int kWidth = 960, kHeight = 540;  // of pictures drawn for a judge

Result<vlm::Picture> plan_of(const Layout& layout) {
  FloorPlanOptions plan;
  plan.dots_per_inch = 120;
  LAYOUTBOX_ASSIGN(std::string png, write_floor_plan_png(layout, plan));
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
  LAYOUTBOX_ASSIGN(const auto folder, TemporaryFolder::make("layoutbox-views"));
  if (!render.views.empty()) {
    LAYOUTBOX_ASSIGN(const Model model, furnish(layout, Catalog::builtin()));
    LAYOUTBOX_CHECK(write_file(folder.path() / "blender.py", write_blender_script(model, layout, render)));
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

// What a model is shown of rooms, and by which way.
class Showing {
 public:
  Showing(const QuestionFlags& flags, const std::map<std::string, RoomPicture>& pictures, const Console& console)
      : flags_(flags), pictures_(pictures), console_(console) {}

  Status prepare() {
    if (flags_.publish.empty()) return {};
    LAYOUTBOX_ASSIGN(publish::Settings settings, publish::Settings::of_user());
    LAYOUTBOX_ASSIGN(publisher_, publish::make_publisher(flags_.publish, std::move(settings)));
    return {};
  }

  // `own`: the room's own picture may be taken, which is none of a room that was changed.
  Result<std::vector<vlm::Picture>> of(const std::string& name, const Layout& layout, bool own) const {
    std::vector<vlm::Picture> shown;
    const auto found = pictures_.find(name);
    if (!flags_.views.empty()) {
      LAYOUTBOX_ASSIGN(shown, drawn_pictures(layout, flags_.views));
    } else if (own && found != pictures_.end()) {
      shown.push_back({found->second.media_type, found->second.bytes});
    } else {
      if (own) console_.say(fmt::format("judge    {} has no picture; its floor plan is shown", name));
      LAYOUTBOX_ASSIGN(shown.emplace_back(), plan_of(layout));
    }
    for (vlm::Picture& picture : shown) {
      if (publisher_ == nullptr) break;
      LAYOUTBOX_ASSIGN(picture.url, publisher_->publish({picture.media_type, picture.bytes}, &stop_flag()));
    }
    return shown;
  }

 private:
  const QuestionFlags& flags_;
  const std::map<std::string, RoomPicture>& pictures_;
  const Console& console_;
  std::unique_ptr<publish::Publisher> publisher_;
};

Result<std::vector<vlm::RoomAnswers>> ask_model(const QuestionFlags& flags, const std::vector<Judgement>& rooms,
                                                const std::map<std::string, RoomPicture>& pictures, std::string& judge,
                                                const Console& console) {
  LAYOUTBOX_ASSIGN(chat::ChatOptions chat, vision_options(flags, console));
  judge = fmt::format("{} at {}", chat.endpoint.model, chat.endpoint.base_url);
  chat::ChatClient client(std::move(chat));
  Showing showing(flags, pictures, console);
  LAYOUTBOX_CHECK(showing.prepare());
  std::vector<vlm::RoomAnswers> answers;
  for (const Judgement& room : rooms) {
    if (!room.error.empty()) continue;
    LAYOUTBOX_ASSIGN(const std::vector<vlm::Picture> shown, showing.of(room.name, room.room.layout, true));
    LAYOUTBOX_ASSIGN(vlm::RoomAnswers said,
                     vlm::answer_by_model(room.name, room.room.layout, Catalog::builtin(), shown, client, flags.options));
    answers.push_back(std::move(said));
  }
  return answers;
}

int faults_in(const Judgement& room) {
  return static_cast<int>(std::ranges::count_if(room.report.checks, [](const Check& check) { return check.required && !check.passed; }) +
                          std::ranges::count_if(room.verdicts, [](const scoring::Verdict& verdict) { return !verdict.holds; }));
}

// Each two rooms, or each room and itself with a fault.
Result<std::vector<vlm::Comparison>> compare_rooms(const QuestionFlags& flags, const std::vector<Judgement>& rooms,
                                                   const std::map<std::string, RoomPicture>& pictures, std::string& judge,
                                                   const Console& console) {
  LAYOUTBOX_ASSIGN(chat::ChatOptions chat, vision_options(flags, console));
  judge = fmt::format("{} at {}", chat.endpoint.model, chat.endpoint.base_url);
  chat::ChatClient client(std::move(chat));
  Showing showing(flags, pictures, console);
  LAYOUTBOX_CHECK(showing.prepare());
  std::vector<vlm::Contestant> contestants;
  std::vector<vlm::Comparison> comparisons;
  const auto meet = [&](const vlm::Contestant& a, const vlm::Contestant& b, const std::string& fault, const std::string& wanted) -> Status {
    LAYOUTBOX_ASSIGN(vlm::Comparison said, vlm::compare(a, b, wanted, client, flags.options));
    said.fault = fault;
    comparisons.push_back(std::move(said));
    return {};
  };
  for (const Judgement& room : rooms) {
    if (!room.error.empty()) continue;
    const Layout& layout = room.room.layout;
    vlm::Contestant own{room.name, {}, faults_in(room)};
    // Beside a changed room, which has no picture of its own, it is shown in the same way.
    LAYOUTBOX_ASSIGN(own.pictures, showing.of(room.name, layout, !flags.faults));
    if (flags.faults) {
      for (const vlm::PlantedFault& fault : vlm::plant_faults(layout, Catalog::builtin(), flags.options.questions.seed)) {
        if (flags.views.empty() && fault.kind == "hung in the air") continue;  // a plan does not show it
        vlm::Contestant changed{fmt::format("{} with {} {}", room.name, fault.object, fault.kind), {}, own.faults + 1};
        LAYOUTBOX_ASSIGN(changed.pictures, showing.of(room.name, fault.layout, false));
        LAYOUTBOX_CHECK(meet(own, changed, fault.kind, layout.prompt));
      }
      continue;
    }
    for (const vlm::Contestant& other : contestants) LAYOUTBOX_CHECK(meet(other, own, {}, layout.prompt));
    contestants.push_back(std::move(own));
  }
  return comparisons;
}

int answer_comparisons(const QuestionFlags& flags, const std::vector<Judgement>& rooms, const std::map<std::string, RoomPicture>& pictures,
                       const std::string& output, const Console& console) {
  std::string judge;
  const auto said = compare_rooms(flags, rooms, pictures, judge, console);
  if (!said) return console.fail(said.error());
  const std::string json = vlm::pairs_json(*said, judge);
  if (!output.empty()) {
    if (const Status written = write_output(output, json); !written) return console.fail(written.error());
  }
  if (output != "-") console.result(vlm::pairs_text(*said), json);
  return kDone;
}

std::vector<vlm::RoomAnswers> ask_geometry(const QuestionFlags& flags, const std::vector<Judgement>& rooms) {
  std::vector<vlm::RoomAnswers> answers;
  for (const Judgement& room : rooms) {
    if (room.error.empty()) answers.push_back(vlm::answer_by_geometry(room.name, room.room.layout, Catalog::builtin(), flags.options));
  }
  return answers;
}

}  // namespace

void add_publish_to(CLI::App& command, std::string& publish, const char* group) {
  command
      .add_option("--publish", publish,
                  "How pictures reach the vision model: by an address, put there by cloudinary, s3 or put (else they are sent along)")
      ->check(CLI::IsMember({"cloudinary", "s3", "put"}))
      ->group(group);
}

void QuestionFlags::add_to(CLI::App& command) {
  const auto* const group = "Questions";
  command.add_option("--by", by, "Who judges: geometry, or vlm: a vision model, by questions of which geometry knows the truth")
      ->capture_default_str()
      ->check(CLI::IsMember({"geometry", "vlm"}))
      ->group(group);
  command.add_flag("--questions", questions, "Answer the questions by geometry")->group(group);
  auto* two_rooms = command.add_flag("--pairwise", pairwise, "A vision model compares each two rooms, both ways round")->group(group);
  command.add_flag("--faults", faults, "A vision model compares each room with itself with a fault planted, both ways round: it is judged")
      ->excludes(two_rooms)
      ->group(group);
  command
      .add_option(
          "--views", views,
          "What a vision model is shown, with commas between: plan, iso, top, front, eye, door, drawn now (else the room's picture)")
      ->delimiter(',')
      ->check(CLI::IsMember({"plan", "iso", "top", "front", "eye", "door"}))
      ->group(group);
  command.add_option("--singles", options.questions.singles, "Questions over one relation for each room, and as many false ones")
      ->capture_default_str()
      ->check(CLI::Range(0, 100))
      ->group(group);
  command.add_option("--multis", options.questions.multis, "Questions over several relations, and as many false ones")
      ->capture_default_str()
      ->check(CLI::Range(0, 100))
      ->group(group);
  command.add_option("--question-seed", options.questions.seed, "Which questions")->capture_default_str()->group(group);
  command.add_option("--repeats", options.repeats, "How often each is asked")
      ->capture_default_str()
      ->check(CLI::Range(1, 100))
      ->group(group);
  command.add_option("--temperature", options.temperature, "Of the model")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 2.0))
      ->group(group);
  command
      .add_flag("--with-scene", options.with_scene, "Show the scene's JSON beside the picture for questions too, not for the score alone")
      ->group(group);
  add_publish_to(command, publish, group);
  command.add_option("--model", model, "The model's name (else LAYOUTBOX_VLM_MODEL, else LAYOUTBOX_MODEL)")->group(group);
  command.add_option("--base-url", base_url, "The server's address up to /v1 (else OPENAI_BASE_URL)")->group(group);
  command.add_option("--provider", provider, "The form it is asked in: openai or anthropic")->group(group);
  command.add_option("--model-timeout", timeout_s, "Seconds for one answer")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0))
      ->group(group);
  command.add_option("--max-cost", max_cost, "US dollars that the answers may cost")->check(CLI::Range(0.0, 1e6))->group(group);
  command.add_flag("--no-cache", no_cache, "Ask although the same was asked before, and keep no answer")->group(group);
}

int answer_questions(const QuestionFlags& flags, const std::vector<Judgement>& rooms, const std::map<std::string, RoomPicture>& pictures,
                     const std::string& output, const Console& console) {
  if (flags.pairwise || flags.faults) return answer_comparisons(flags, rooms, pictures, output, console);
  std::string judge = "geometry";
  std::vector<vlm::RoomAnswers> answers;
  if (flags.by == "vlm") {
    auto said = ask_model(flags, rooms, pictures, judge, console);
    if (!said) return console.fail(said.error());
    answers = *std::move(said);
  } else {
    answers = ask_geometry(flags, rooms);
  }
  const std::string json = vlm::answers_json(answers, judge, flags.options);
  if (!output.empty()) {
    if (const Status written = write_output(output, json); !written) return console.fail(written.error());
  }
  if (output != "-") console.result(vlm::answers_text(answers, flags.options.reasons), json);
  return kDone;
}

Status judge_generated(const QuestionFlags& flags, const GenerateOutcome& outcome, const std::string& folder, const Console& console) {
  const std::string file = picture_name(View::kIso);
  if (std::find(outcome.files.begin(), outcome.files.end(), file) == outcome.files.end()) {
    return layoutbox::fail(ErrorCode::kNoBlender, "there is no picture for a vision model to judge", "--vlm",
                           "leave out --no-render, and let iso be among the views");
  }
  LAYOUTBOX_ASSIGN(std::string bytes, read_file(std::filesystem::path(folder) / file, 64u << 20));
  Judgement room;
  room.name = std::filesystem::absolute(folder).lexically_normal().filename().string();
  room.room.layout = outcome.layout;
  std::string judge;
  LAYOUTBOX_ASSIGN(const std::vector<vlm::RoomAnswers> answers,
                   ask_model(flags, {room}, {{room.name, {"image/png", std::move(bytes)}}}, judge, console));
  LAYOUTBOX_CHECK(write_file(std::filesystem::path(folder) / "answers.json", vlm::answers_json(answers, judge, flags.options)));
  console.say(vlm::answers_text(answers, flags.options.reasons));
  return {};
}

}  // namespace layoutbox::cli
