#include <fmt/format.h>

#include <memory>

#include "layoutbox/base/files.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/judge_pictures.h"
#include "layoutbox/cli/judge_questions.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/judge/drawn_room.h"
#include "layoutbox/judge/report_html.h"
#include "layoutbox/verify/drawn.h"

namespace layoutbox::cli {
namespace {

struct VerifyArguments {
  std::string layout, output, page, mask, picture, answers;
  bool boxes_only = false, reasons = false;
  QuestionFlags questions;
};

std::string summary(const Report& report, bool reasons) {
  std::string text;
  for (const Check& check : report.checks) {
    if (!check.passed) text += fmt::format("{} {}: {}\n", check.required ? "FAILED " : "warning", check.name, check.message);
    if (check.passed && reasons) text += fmt::format("passed  {}: {}\n", check.name, check.message);
  }
  for (const auto& [name, value] : report.metrics) text += fmt::format("{:<20} {:.4g}\n", name, value);
  return text + (report.passed ? "passed" : "failed");
}

// On boxes, as drawn, and as the picture shows it.
Result<Report> report_of(const Layout& layout, const VerifyArguments& flags) {
  const Catalog& catalog = Catalog::builtin();
  Report report;
  if (flags.boxes_only) {
    report = verify(layout, catalog);
  } else {
    LAYOUTBOX_ASSIGN(const Model model, furnish(layout, catalog));
    report = verify_with_furniture(layout, model, catalog);
  }
  if (!flags.mask.empty()) {
    LAYOUTBOX_ASSIGN(const std::string mask, read_file(flags.mask));
    LAYOUTBOX_CHECK(verify_seen(layout, mask, report));
  }
  return report;
}

// The room as `judge` has it, for the page and for questions.
struct RoomAsked {
  std::vector<Judgement> judged;
  std::map<std::string, RoomPicture> pictures;
};

Result<RoomAsked> room_of(const Layout& layout, const Report& report, const VerifyArguments& flags) {
  RoomAsked room;
  room.judged.push_back(judge_room(RoomFile{flags.layout, "layout", layout, {}}, {}, Catalog::builtin()));
  room.judged.back().report = report;
  LAYOUTBOX_ASSIGN(std::optional<RoomPicture> picture, picture_of_room(flags.layout, flags.picture));
  if (picture) room.pictures[flags.layout] = *std::move(picture);
  return room;
}

int run_verify(VerifyArguments flags, const Console& console) {
  const auto layout = read_layout_file(flags.layout);
  if (!layout) return console.fail(layout.error());
  const auto report = report_of(*layout, flags);
  if (!report) return console.fail(report.error());
  const std::string text = write_report(*report);
  if (!flags.output.empty()) {
    if (const Status written = write_output(flags.output, text); !written) return console.fail(written.error());
  }
  const bool asks = flags.questions.wanted();
  if (!flags.page.empty() || asks) {
    const auto room = room_of(*layout, *report, flags);
    if (!room) return console.fail(room.error());
    if (!flags.page.empty()) {
      const Status written = write_file(flags.page, judgement_html(room->judged, room->pictures));
      if (!written) return console.fail(written.error());
    }
    if (asks) {
      console.say(summary(*report, flags.reasons));
      flags.questions.options.reasons = flags.reasons;
      const int status = answer_questions(flags.questions, room->judged, room->pictures, flags.answers, console);
      return status == kDone && !report->passed ? kNotAsAsked : status;
    }
  }
  if (flags.output != "-") console.result(summary(*report, flags.reasons), text);
  return report->passed ? kDone : kNotAsAsked;
}

}  // namespace

void add_verify(CLI::App& app, Context& context) {
  auto flags = std::make_shared<VerifyArguments>();
  CLI::App* command =
      app.add_subcommand("verify", "Check a layout by geometry, and by a vision model: collisions, bounds, doors, relations");
  command->add_option("layout", flags->layout, "layout.json; - reads stdin")->required();
  command->add_option("-o,--output", flags->output, "Where report.json goes; - writes it to stdout");
  command->add_option("--report", flags->page, "Where a page goes: picture, plan with the failures drawn in, every check; one file");
  command->add_option("--mask", flags->mask, "mask.json of a picture of it: also what is seen of each object");
  command->add_option("--image,--picture", flags->picture, "A picture of it for the page and for questions (else scene.png beside it)");
  command->add_flag("--boxes-only", flags->boxes_only, "Leave out the furniture as it is drawn");
  command->add_flag("--reasons", flags->reasons, "Every check with what was measured, and why a vision model answers as it does");
  flags->questions.add_to(*command, false);
  command->add_option("--answers", flags->answers, "Where the answers to questions go as JSON (else they are the command's result)")
      ->group("Questions");
  command->callback([flags, &context] { context.status = run_verify(*flags, context.console); });
}

}  // namespace layoutbox::cli
