#include "layoutbox/pipeline/batch.h"
#include "layoutbox/pipeline/shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <thread>

#include "layoutbox/base/words.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/model_flags.h"

namespace layoutbox::cli {
namespace {

struct BatchArguments {
  std::string prompts, folder;
  int jobs = 1;
  bool no_render = false, force = false;
  std::string pack, shard;
  ShardOptions shards;
  PlanFlags plan;
  ModelFlags model;
  SolveFlags solve;
  RenderFlags render;
  FurnishFlags furnish;
  BatchOptions options;
};

void tell(const Console& console, const BatchItem& item, std::size_t ended, std::size_t all) {
  if (item.state == BatchState::kFailed && item.error) {
    console.warn(fmt::format("{} (line {}): {}{}", item.id, item.line, item.error->message,
                             item.error->hint.empty() ? "" : fmt::format(" ({})", item.error->hint)));
  } else if (item.state == BatchState::kNotAsAsked) {
    console.warn(fmt::format("{} (line {}): not as asked; its run.json and report.json say what", item.id, item.line));
  }
  console.progress("batch", static_cast<double>(ended) / static_cast<double>(all));
}

// "out: 24 rooms: 21 done (3 of them earlier), 2 not as asked, 1 failed; 12.3 s".
std::string summary_line(const BatchOutcome& outcome, const std::string& folder) {
  const std::size_t kept = outcome.kept();
  std::string line = fmt::format("{}: {}: {} done", folder, counted(outcome.items.size(), "room"), outcome.count(BatchState::kDone));
  line += fmt::format(", {} not as asked, {} failed", outcome.count(BatchState::kNotAsAsked), outcome.count(BatchState::kFailed));
  if (kept > 0) line += fmt::format(", {} of them were there already", kept);
  if (const std::size_t left = outcome.count(BatchState::kNotStarted)) line += fmt::format(", {} not started", left);
  return line + fmt::format("; {:.1f} s", outcome.seconds);
}

// Stopped, part of it failed, or all that failed did so for want of something on this machine.
int status_of(const BatchOutcome& outcome) {
  if (outcome.stopped) return kStoppedByUser;
  bool surroundings = false, other = outcome.count(BatchState::kNotAsAsked) > 0;
  for (const BatchItem& item : outcome.items) {
    if (item.state != BatchState::kFailed) continue;
    const bool here = item.error && exit_status(*item.error) == kWrongSurroundings;
    (here ? surroundings : other) = true;
  }
  if (other) return kNotAsAsked;
  return surroundings ? kWrongSurroundings : kDone;
}

// "2/4": the second of four machines.
Status read_share(BatchArguments& flags) {
  if (flags.pack.empty() && flags.shard.empty()) return {};
  if (flags.pack.empty()) return layoutbox::fail(ErrorCode::kUsage, "only packed rooms are shared out", "--shard", "add --pack webdataset");
  if (flags.pack != "webdataset")
    return layoutbox::fail(ErrorCode::kUsage, fmt::format("there is no pack '{}'", flags.pack), "--pack", "use webdataset");
  if (flags.shard.empty()) return {};
  ShardOptions& share = flags.shards;
  const std::size_t slash = flags.shard.find('/');
  const char* const end = flags.shard.data() + flags.shard.size();
  const auto number = [](const char* from, const char* to, std::size_t& value) {
    const auto read = std::from_chars(from, to, value);
    return read.ec == std::errc() && read.ptr == to;
  };
  const bool good = slash != std::string::npos && number(flags.shard.data(), flags.shard.data() + slash, share.machine) &&
                    number(flags.shard.data() + slash + 1, end, share.machines);
  if (good && share.machine >= 1 && share.machine <= share.machines) return {};
  return layoutbox::fail(ErrorCode::kUsage, fmt::format("'{}' is no share", flags.shard), "--shard",
                         "write 1/4 for the first of four machines, 4/4 for the last");
}

Status prepare_batch(BatchArguments& flags, const Console& console) {
  GenerateOptions& options = flags.options.generate;
  LAYOUTBOX_CHECK(flags.plan.apply(options));
  LAYOUTBOX_CHECK(flags.solve.apply(options.solve, flags.plan.by_model()));
  LAYOUTBOX_CHECK(flags.render.apply(options.render));
  LAYOUTBOX_CHECK(flags.furnish.apply(options.furnish));
  options.furnish.asset_folders = asset_folders(flags.plan.catalog_file, flags.plan.assets);
  options.pictures = !flags.no_render && flags.pack.empty();
  LAYOUTBOX_CHECK(read_share(flags));
  options.stop = &stop_flag();
  flags.options.jobs = flags.jobs;
  flags.options.force = flags.force;
  flags.options.on_item = [&console](const BatchItem& item, std::size_t ended, std::size_t all) { tell(console, item, ended, all); };
  return {};
}

Result<BatchOutcome> run_lines(BatchArguments& flags, const Console& console) {
  if (flags.model.dry_run)
    return layoutbox::fail(ErrorCode::kUsage, "a batch has many requests", "--dry-run", "try one line of it with generate");
  LAYOUTBOX_CHECK(prepare_batch(flags, console));
  LAYOUTBOX_ASSIGN(const std::string text, read_input(flags.prompts));
  auto lines = read_batch(text);
  if (!lines) return Failure(in_file(lines.error(), flags.prompts));
  LAYOUTBOX_ASSIGN(const CatalogInUse catalog, flags.plan.load_catalog());
  console.notes(catalog.notes);
  GenerateOptions& options = flags.options.generate;
  options.inputs.insert(options.inputs.end(), catalog.inputs.begin(), catalog.inputs.end());
  LAYOUTBOX_ASSIGN(const auto planner, flags.model.make_planner(flags.plan.planner, catalog.get(), options, console));
  if (!flags.pack.empty()) return run_packed_batch(*lines, *planner, catalog.get(), flags.folder, flags.options, flags.shards);
  return run_batch(*lines, *planner, catalog.get(), flags.folder, flags.options);
}

int run_batch(BatchArguments& flags, const Console& console) {
  clear_up(console);
  const auto outcome = run_lines(flags, console);
  if (!outcome) return console.fail(outcome.error());
  console.result(summary_line(*outcome, flags.folder), write_batch_summary(*outcome));
  return status_of(*outcome);
}

}  // namespace

void add_batch(CLI::App& app, Context& context) {
  auto flags = std::make_shared<BatchArguments>();
  flags->jobs = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
  CLI::App* command = app.add_subcommand("batch", "Many rooms: a folder for every line of a file; goes on where it was stopped");
  command
      ->add_option(
          "prompts", flags->prompts,
          "Lines of {\"id\", \"prompt\"} (also room, units, seed, effort), a table with such columns, or a prompt a line; - reads stdin")
      ->required();
  command->add_option("-o,--output", flags->folder, "Folder for the rooms' folders and summary.json")->required();
  command->add_option("-j,--jobs", flags->jobs, "How many rooms at a time (default: as many as there are cores)")
      ->check(CLI::Range(1, 256));
  command->add_flag("--force", flags->force, "Also make again what is there already");
  command->add_option("--pack", flags->pack, "webdataset: rooms in tar files with a manifest each, instead of folders; no pictures");
  command->add_option("--shard-size", flags->shards.rooms, "Rooms in each tar file")->capture_default_str()->check(CLI::Range(1, 100'000));
  command->add_option("--shard", flags->shard, "Of all tar files the share of this machine: 2/4 for the second of four");
  command->add_flag("--no-render", flags->no_render, "Make no pictures: no Blender is needed");
  flags->plan.add_to(*command);
  flags->plan.add_companions_to(*command);
  flags->model.add_to(*command, flags->options.generate.repair);
  flags->solve.add_to(*command, flags->options.generate.solve);
  flags->render.add_to(*command);
  flags->furnish.add_to(*command);
  command->callback([flags, &context] { context.status = run_batch(*flags, context.console); });
}

}  // namespace layoutbox::cli
