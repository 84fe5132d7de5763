#include "layoutbox/pipeline/room_pack.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "layoutbox/base/bytes.h"
#include "layoutbox/pipeline/artefacts.h"
#include "layoutbox/pipeline/run_record.h"
#include "layoutbox/pipeline/tar.h"

namespace layoutbox {
namespace {

using OrderedJson = nlohmann::ordered_json;

// The name of a room in a shard: readers take what stands before the first dot for it, and tar has 100 bytes.
std::string key_in_shard(const std::string& id) {
  constexpr std::size_t kLongest = 80, kKept = 60;
  if (id.size() <= kLongest && id.find('.') == std::string::npos) return id;
  std::string key = id.substr(0, kKept);
  std::replace(key.begin(), key.end(), '.', '_');
  return key + "-" + content_key(id);
}

bool is_of_surroundings(ErrorCode code) {
  return code == ErrorCode::kInterrupted || code == ErrorCode::kNoSolver || code == ErrorCode::kIo || code == ErrorCode::kNetwork;
}

Result<GenerateOutcome> lay_out(const Expected& expected, const Planner& planner, const Catalog& catalog) {
  GenerateOutcome outcome;
  LAYOUTBOX_ASSIGN(const Plan plan, planner.plan(expected.line->prompt, expected.options.plan));
  LAYOUTBOX_ASSIGN(outcome.scene, prepare_plan(plan, catalog, expected.options));
  LAYOUTBOX_ASSIGN(outcome.layout, solve(outcome.scene, catalog, expected.options.solve));
  dress_room(plan, outcome.scene, outcome.layout, catalog, expected.options);
  outcome.layout.stats.seconds = 0;  // no clock in the bytes
  outcome.report = verify(outcome.layout, catalog, expected.options.verify);
  return outcome;
}

Status pack_files(const Expected& expected, const Catalog& catalog, const GenerateOutcome& outcome, Packed& packed) {
  LAYOUTBOX_ASSIGN(const Model model, furnish(outcome.layout, catalog, expected.options.furnish));
  const RoomSoFar room{catalog, outcome.scene, outcome.layout, model, outcome.report, expected.options};
  const std::string key = key_in_shard(expected.line->id);
  for (const Artefact& one : artefacts()) {
    if (!one.packed) continue;
    LAYOUTBOX_ASSIGN(const std::string bytes, one.make(room));
    add_to_tar(packed.tar, fmt::format("{}.{}", key, one.file), bytes);
  }
  return {};
}

OrderedJson manifest_of_room(const GenerateOutcome& outcome) {
  OrderedJson json{{"objects", outcome.layout.objects.size()}, {"held", OrderedJson::array()}, {"relaxed", OrderedJson::array()}};
  for (const PlacedRelation& placed : outcome.layout.relations) {
    if (placed.held) json["held"].push_back(placed.relation.id);
  }
  for (const Relaxation& one : outcome.layout.relaxed) {
    json["relaxed"].push_back({{"relation", one.relation}, {"by", one.by}, {"unit", one.unit}, {"why", one.why}});
  }
  OrderedJson failed = OrderedJson::array();
  for (const Check& check : outcome.report.checks) {
    if (check.required && !check.passed) failed.push_back({{"name", check.name}, {"subject", check.subject}, {"message", check.message}});
  }
  json["checks"] = {{"made", outcome.report.checks.size()}, {"failed", std::move(failed)}};
  json["metrics"] = outcome.report.metrics;
  if (outcome.layout.stats.stopped_by_clock) json["stoppedByClock"] = true;  // its bytes may differ next time
  return json;
}

}  // namespace

Expected expected_of(const BatchLine& line, const GenerateOptions& all) {
  Expected expected{&line, options_of(line, all), {}};
  expected.options.pictures = false;
  expected.options.variants = 1;
  expected.made = content_key(line.prompt + "\n" + options_text(expected.options));
  return expected;
}

Packed pack_room(const Expected& expected, const Planner& planner, const Catalog& catalog) {
  const auto start = std::chrono::steady_clock::now();
  const BatchLine& line = *expected.line;
  Packed packed;
  packed.item.id = line.id;
  packed.item.line = line.line;
  packed.manifest = {{"id", line.id},
                     {"key", key_in_shard(line.id)},
                     {"prompt", line.prompt},
                     {"seed", expected.options.solve.seed},
                     {"made", expected.made}};
  std::optional<Error> error = line.error;
  OrderedJson room;
  if (!error) {
    const auto outcome = lay_out(expected, planner, catalog);
    const Status filed = outcome ? pack_files(expected, catalog, *outcome, packed) : Status(Failure(outcome.error()));
    if (filed) {
      packed.item.state = as_asked(*outcome) ? BatchState::kDone : BatchState::kNotAsAsked;
      room = manifest_of_room(*outcome);
    } else {
      error = filed.error();
    }
  }
  if (error) {
    packed.tar.clear();
    packed.item.state = BatchState::kFailed;
    packed.item.error = error;
    if (!line.error && is_of_surroundings(error->code)) packed.surroundings = error;
  }
  packed.manifest["state"] = name_of(packed.item.state);
  packed.manifest["bytes"] = packed.tar.size();
  packed.manifest["hash"] = content_key(packed.tar);
  if (!room.is_null()) packed.manifest.update(room);
  if (error) packed.manifest["error"] = json_of_error(*error);
  packed.item.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return packed;
}

}  // namespace layoutbox
