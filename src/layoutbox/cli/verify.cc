#include <fmt/format.h>

#include <memory>

#include "layoutbox/base/files.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/judge/drawn_room.h"
#include "layoutbox/judge/report_html.h"
#include "layoutbox/verify/drawn.h"

namespace layoutbox::cli {
namespace {

struct VerifyArguments {
  std::string layout, output, page, mask;
  bool boxes_only = false;
};

std::string summary(const Report& report) {
  std::string text;
  for (const Check& check : report.checks) {
    if (!check.passed) text += fmt::format("{} {}: {}\n", check.required ? "FAILED " : "warning", check.name, check.message);
  }
  for (const auto& [name, value] : report.metrics) text += fmt::format("{:<20} {:.4g}\n", name, value);
  return text + (report.passed ? "passed" : "failed");
}

// On boxes, as drawn, and as the picture shows it.
Result<Report> report_of(const Layout& layout, const VerifyArguments& flags) {
  const Catalog& catalog = Catalog::builtin();
  const VerifyOptions options;
  Report report = verify(layout, catalog, options);
  if (!flags.boxes_only) {
    LAYOUTBOX_ASSIGN(const Model model, furnish(layout, catalog));
    verify_drawn(layout, catalog, drawn_objects(model), options, report);
  }
  if (!flags.mask.empty()) {
    LAYOUTBOX_ASSIGN(const std::string mask, read_file(flags.mask));
    LAYOUTBOX_CHECK(verify_seen(layout, mask, report));
  }
  return report;
}

int run_verify(const VerifyArguments& flags, const Console& console) {
  const auto layout = read_layout_file(flags.layout);
  if (!layout) return console.fail(layout.error());
  const auto report = report_of(*layout, flags);
  if (!report) return console.fail(report.error());
  const std::string text = write_report(*report);
  if (!flags.output.empty()) {
    if (const Status written = write_output(flags.output, text); !written) return console.fail(written.error());
  }
  if (!flags.page.empty()) {
    std::vector<Judgement> judged;
    judged.push_back(judge_room(RoomFile{flags.layout, "layout", *layout, {}}, {}, Catalog::builtin()));
    judged.back().report = *report;
    const Status written = write_file(flags.page, judgement_html(judged));
    if (!written) return console.fail(written.error());
  }
  if (flags.output != "-") console.result(summary(*report), text);
  return report->passed ? kDone : kNotAsAsked;
}

}  // namespace

void add_verify(CLI::App& app, Context& context) {
  auto flags = std::make_shared<VerifyArguments>();
  CLI::App* command = app.add_subcommand("verify", "Check a layout by geometry: collisions, bounds, support, doors, relations");
  command->add_option("layout", flags->layout, "layout.json; - reads stdin")->required();
  command->add_option("-o,--output", flags->output, "Where report.json goes; - writes it to stdout");
  command->add_option("--report", flags->page, "Where a page goes: the plan with the failures drawn in, and every check; one file");
  command->add_option("--mask", flags->mask, "mask.json of a picture of it: also what is seen of each object");
  command->add_flag("--boxes-only", flags->boxes_only, "Leave out the furniture as it is drawn");
  command->callback([flags, &context] { context.status = run_verify(*flags, context.console); });
}

}  // namespace layoutbox::cli
