#include "layoutbox/cli/judge_questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "layoutbox/base/files.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/judge_pictures.h"
#include "layoutbox/cli/provider_names.h"
#include "layoutbox/judge/vlm/pairs.h"
#include "layoutbox/judge/vlm/planted.h"
#include "layoutbox/judge/vlm/written.h"

namespace layoutbox::cli {
namespace {

// A vision model with what it is shown.
struct VisionJudge {
  std::string name;
  Showing showing;
  std::unique_ptr<chat::ChatClient> client;

  static Result<VisionJudge> make(const QuestionFlags& flags, const std::map<std::string, RoomPicture>& pictures, const Console& console) {
    LAYOUTBOX_ASSIGN(chat::ChatOptions chat, flags.chat_options(console));
    LAYOUTBOX_ASSIGN(Showing showing, Showing::make(flags, pictures, console));
    std::string name = fmt::format("{} at {}", chat.endpoint.model, chat.endpoint.base_url);
    return VisionJudge{std::move(name), std::move(showing), std::make_unique<chat::ChatClient>(std::move(chat))};
  }
};

Result<std::vector<vlm::RoomAnswers>> ask_model(VisionJudge& judge, const QuestionFlags& flags, const std::vector<Judgement>& rooms) {
  std::vector<vlm::RoomAnswers> answers;
  for (const Judgement& room : rooms) {
    if (!room.error.empty()) continue;
    LAYOUTBOX_ASSIGN(const std::vector<vlm::Picture> shown, judge.showing.of(room.name, room.room.layout, true));
    LAYOUTBOX_ASSIGN(vlm::RoomAnswers said,
                     vlm::answer_by_model(room.name, room.room.layout, Catalog::builtin(), shown, *judge.client, flags.options));
    answers.push_back(std::move(said));
  }
  return answers;
}

std::optional<double> temperature_from(const std::string& word) {
  if (word == "default") return std::nullopt;
  return std::strtod(word.c_str(), nullptr);
}

int faults_in(const Judgement& room) {
  return static_cast<int>(std::ranges::count_if(room.report.checks, [](const Check& check) { return check.required && !check.passed; }) +
                          std::ranges::count_if(room.verdicts, [](const scoring::Verdict& verdict) { return !verdict.holds; }));
}

// Each two rooms, or each room and itself with a fault.
Result<std::vector<vlm::Comparison>> compare_rooms(VisionJudge& judge, const QuestionFlags& flags, const std::vector<Judgement>& rooms) {
  std::vector<vlm::Contestant> contestants;
  std::vector<vlm::Comparison> comparisons;
  const auto meet = [&](const vlm::Contestant& a, const vlm::Contestant& b, const std::string& fault, const std::string& wanted) -> Status {
    LAYOUTBOX_ASSIGN(vlm::Comparison said, vlm::compare(a, b, wanted, *judge.client, flags.options));
    said.fault = fault;
    comparisons.push_back(std::move(said));
    return {};
  };
  for (const Judgement& room : rooms) {
    if (!room.error.empty()) continue;
    const Layout& layout = room.room.layout;
    vlm::Contestant own{room.name, {}, faults_in(room)};
    // Beside a changed room, which has no picture of its own, it is shown in the same way.
    LAYOUTBOX_ASSIGN(own.pictures, judge.showing.of(room.name, layout, !flags.faults));
    if (flags.faults) {
      for (const vlm::PlantedFault& fault : vlm::plant_faults(layout, Catalog::builtin(), flags.options.questions.seed)) {
        if (flags.views.empty() && fault.kind == "hung in the air") continue;  // a plan does not show it
        vlm::Contestant changed{fmt::format("{} with {} {}", room.name, fault.object, fault.kind), {}, own.faults + 1};
        LAYOUTBOX_ASSIGN(changed.pictures, judge.showing.of(room.name, fault.layout, false));
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
  auto judge = VisionJudge::make(flags, pictures, console);
  if (!judge) return console.fail(judge.error());
  const auto said = compare_rooms(*judge, flags, rooms);
  if (!said) return console.fail(said.error());
  const std::string json = vlm::pairs_json(*said, judge->name);
  if (!output.empty()) {
    if (const Status written = write_output(output, json); !written) return console.fail(written.error());
  }
  if (output != "-") console.result(vlm::pairs_text(*said), json);
  return kDone;
}

// A model that reads text alone may write the questions that geometry answers.
Result<std::vector<vlm::RoomAnswers>> ask_geometry(const QuestionFlags& flags, const std::vector<Judgement>& rooms,
                                                   const Console& console) {
  std::optional<chat::ChatClient> writer;
  if (flags.options.written) {
    LAYOUTBOX_ASSIGN(chat::ChatOptions chat, flags.chat_options(console));
    writer.emplace(std::move(chat));
  }
  std::vector<vlm::RoomAnswers> answers;
  for (const Judgement& room : rooms) {
    if (!room.error.empty()) continue;
    const Layout& layout = room.room.layout;
    vlm::RoomAnswers said = vlm::answer_by_geometry(room.name, layout, Catalog::builtin(), flags.options);
    if (writer) LAYOUTBOX_CHECK(vlm::write_questions(said, layout, *writer, flags.options));
    answers.push_back(std::move(said));
  }
  return answers;
}

}  // namespace

Result<chat::ChatOptions> QuestionFlags::chat_options(const Console& console) const {
  chat::ChatOptions chat;
  std::string name = model;
  if (const char* named = std::getenv("LAYOUTBOX_VLM_MODEL"); name.empty() && named != nullptr) name = named;
  LAYOUTBOX_ASSIGN(chat.endpoint, chat::find_endpoint({base_url, name, provider}));
  LAYOUTBOX_ASSIGN(chat.prices, chat::Prices::of_user());
  chat.request_limit_s = timeout_s;
  chat.retry.total_s = std::max(chat.retry.total_s, timeout_s);
  chat.spend_limit->max_cost = max_cost;
  chat.use_cached_answers = !no_cache;
  chat.stop = &stop_flag();
  chat.on_wait = [&console](const std::string& line) { console.say("model    " + line); };
  return chat;
}

void add_publish_to(CLI::App& command, std::string& publish, const char* group) {
  command
      .add_option("--publish", publish,
                  "How pictures reach the vision model: by an address, put there by cloudinary, s3 or put (else they are sent along)")
      ->check(CLI::IsMember({"cloudinary", "s3", "put"}))
      ->group(group);
}

void QuestionFlags::add_asking_to(CLI::App& command) {
  const auto* const group = "Questions";
  command.add_option("--singles", options.questions.singles, "Questions over one relation for each room, and as many false ones")
      ->capture_default_str()
      ->check(CLI::Range(0, 100))
      ->group(group);
  command.add_option("--multis", options.questions.multis, "Questions over several relations, and as many false ones")
      ->capture_default_str()
      ->check(CLI::Range(0, 100))
      ->group(group);
  command.add_option("--question-seed", options.questions.seed, "Which questions")->capture_default_str()->group(group);
  command
      .add_flag("--with-scene", options.with_scene, "Show the scene's JSON beside the picture for questions too, not for the score alone")
      ->group(group);
  command.add_flag("--written", options.written, "The model writes the words of the questions first, from the scene's JSON")->group(group);
}

void QuestionFlags::add_to(CLI::App& command, bool many_rooms) {
  const auto* const group = "Questions";
  command.add_option("--by", by, "Who judges: geometry, or vlm: a vision model, by questions of which geometry knows the truth")
      ->capture_default_str()
      ->check(CLI::IsMember({"geometry", "vlm"}))
      ->group(group);
  command.add_flag("--questions", questions, "Answer the questions by geometry")->group(group);
  auto* planted =
      command
          .add_flag("--faults", faults, "A vision model compares each room with itself with a fault planted, both ways round: it is judged")
          ->group(group);
  if (many_rooms) {
    command.add_flag("--pairwise", pairwise, "A vision model compares each two rooms, both ways round")->excludes(planted)->group(group);
  }
  command
      .add_option(
          "--views", views,
          "What a vision model is shown, with commas between: plan, iso, top, front, eye, door, drawn now (else the room's picture)")
      ->delimiter(',')
      ->check(CLI::IsMember({"plan", "iso", "top", "front", "eye", "door"}))
      ->group(group);
  add_asking_to(command);
  command.add_option("--blend", blend, "The room's .blend: each relation of a question is measured in it too")->group(group);
  command.add_option("--repeats", options.repeats, "How often each is asked")
      ->capture_default_str()
      ->check(CLI::Range(1, 100))
      ->group(group);
  command
      .add_option_function<std::string>(
          "--temperature", [this](const std::string& word) { options.temperature = temperature_from(word); },
          "Of the model, 0 to 2; or default: its own")
      ->default_str("0")
      ->check(CLI::Range(0.0, 2.0) | CLI::IsMember({"default"}))
      ->group(group);
  add_publish_to(command, publish, group);
  command.add_option("--model", model, "The model's name (else LAYOUTBOX_VLM_MODEL, else LAYOUTBOX_MODEL)")->group(group);
  command.add_option("--base-url", base_url, "The server's address up to /v1 (else OPENAI_BASE_URL)")->group(group);
  command.add_option("--provider", provider, "The form it is asked in: " + provider_names())->group(group);
  command.add_option("--model-timeout", timeout_s, "Seconds for one answer")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0))
      ->group(group);
  command.add_option("--max-cost", max_cost, "US dollars that the answers may cost")->check(CLI::Range(0.0, 1e6))->group(group);
  command.add_flag("--no-cache", no_cache, "Ask although the same was asked before, and keep no answer")->group(group);
}

namespace {

Status read_blend_back(const QuestionFlags& flags, const std::vector<Judgement>& rooms, std::vector<vlm::RoomAnswers>& answers) {
  if (flags.blend.empty()) return {};
  if (rooms.size() != 1 || answers.size() != 1) {
    return layoutbox::fail(ErrorCode::kUsage, "a .blend is of one room", "--blend", "judge the room alone");
  }
  LAYOUTBOX_ASSIGN(const std::string bytes, read_file(flags.blend, 1u << 30));
  LAYOUTBOX_ASSIGN(const RoomFile room, read_room_file(bytes, Catalog::builtin(), {"blend", {}, flags.blend_is_ours}));
  measure_in_blend(answers[0], rooms[0].room.layout, room.layout, Catalog::builtin());
  return {};
}

}  // namespace

int answer_questions(const QuestionFlags& flags, const std::vector<Judgement>& rooms, const std::map<std::string, RoomPicture>& pictures,
                     const std::string& output, const Console& console) {
  if (flags.pairwise || flags.faults) return answer_comparisons(flags, rooms, pictures, output, console);
  std::string name = "geometry";
  std::vector<vlm::RoomAnswers> answers;
  if (flags.by == "vlm") {
    auto judge = VisionJudge::make(flags, pictures, console);
    if (!judge) return console.fail(judge.error());
    auto said = ask_model(*judge, flags, rooms);
    if (!said) return console.fail(said.error());
    answers = *std::move(said);
    name = judge->name;
  } else {
    auto said = ask_geometry(flags, rooms, console);
    if (!said) return console.fail(said.error());
    answers = *std::move(said);
  }
  if (const Status read = read_blend_back(flags, rooms, answers); !read) return console.fail(read.error());
  const std::string json = vlm::answers_json(answers, name, flags.options);
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
  const std::map<std::string, RoomPicture> pictures{{room.name, {"image/png", std::move(bytes)}}};
  LAYOUTBOX_ASSIGN(VisionJudge judge, VisionJudge::make(flags, pictures, console));
  LAYOUTBOX_ASSIGN(std::vector<vlm::RoomAnswers> answers, ask_model(judge, flags, {room}));
  QuestionFlags ours = flags;
  ours.blend_is_ours = true;
  if (std::find(outcome.files.begin(), outcome.files.end(), "scene.blend") != outcome.files.end()) ours.blend = folder + "/scene.blend";
  if (const Status read = read_blend_back(ours, {room}, answers); !read) {
    console.warn("the .blend could not be read back: " + read.error().message);
  }
  LAYOUTBOX_CHECK(write_file(std::filesystem::path(folder) / "answers.json", vlm::answers_json(answers, judge.name, flags.options)));
  console.say(vlm::answers_text(answers, flags.options.reasons));
  return {};
}

}  // namespace layoutbox::cli
