#include "layoutbox/cli/judge_questions.h"

#include <fmt/format.h>

#include <cstdlib>

#include "layoutbox/cli/inputs.h"
#include "layoutbox/export/export.h"

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

Result<vlm::Picture> picture_of(const Judgement& room, const std::map<std::string, RoomPicture>& pictures, const Console& console) {
  if (const auto found = pictures.find(room.name); found != pictures.end())
    return vlm::Picture{found->second.media_type, found->second.bytes};
  console.say(fmt::format("judge    {} has no picture; its floor plan is shown", room.name));
  FloorPlanOptions plan;
  plan.dots_per_inch = 120;
  LAYOUTBOX_ASSIGN(std::string png, write_floor_plan_png(room.room.layout, plan));
  return vlm::Picture{"image/png", std::move(png)};
}

Result<std::vector<vlm::RoomAnswers>> ask_model(const QuestionFlags& flags, const std::vector<Judgement>& rooms,
                                                const std::map<std::string, RoomPicture>& pictures, std::string& judge,
                                                const Console& console) {
  LAYOUTBOX_ASSIGN(chat::ChatOptions chat, vision_options(flags, console));
  judge = fmt::format("{} at {}", chat.endpoint.model, chat.endpoint.base_url);
  chat::ChatClient client(std::move(chat));
  std::vector<vlm::RoomAnswers> answers;
  for (const Judgement& room : rooms) {
    if (!room.error.empty()) continue;
    LAYOUTBOX_ASSIGN(const vlm::Picture picture, picture_of(room, pictures, console));
    LAYOUTBOX_ASSIGN(vlm::RoomAnswers said,
                     vlm::answer_by_model(room.name, room.room.layout, Catalog::builtin(), picture, client, flags.options));
    answers.push_back(std::move(said));
  }
  return answers;
}

std::vector<vlm::RoomAnswers> ask_geometry(const QuestionFlags& flags, const std::vector<Judgement>& rooms) {
  std::vector<vlm::RoomAnswers> answers;
  for (const Judgement& room : rooms) {
    if (room.error.empty()) answers.push_back(vlm::answer_by_geometry(room.name, room.room.layout, Catalog::builtin(), flags.options));
  }
  return answers;
}

}  // namespace

void QuestionFlags::add_to(CLI::App& command) {
  const auto* const group = "Questions";
  command.add_option("--by", by, "Who judges: geometry, or vlm: a vision model, by questions of which geometry knows the truth")
      ->capture_default_str()
      ->check(CLI::IsMember({"geometry", "vlm"}))
      ->group(group);
  command.add_flag("--questions", questions, "Answer the questions by geometry")->group(group);
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

}  // namespace layoutbox::cli
