#include "layoutbox/judge/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace layoutbox {
namespace {

using scoring::EntryKind;
using scoring::Verdict;

double metric(const Report& report, const char* name) {
  const auto found = report.metrics.find(name);
  return found == report.metrics.end() ? 0 : found->second;
}

void tally_entries(Judgement& judgement) {
  for (const EntryKind kind : {EntryKind::kCount, EntryKind::kObjects, EntryKind::kRoom}) {
    Tally& tally = judgement.measures[std::string(name_of(kind))];
    for (const Verdict& verdict : judgement.verdicts) {
      if (verdict.kind != kind) continue;
      tally.whole += 1;
      tally.part += verdict.holds;
    }
  }
}

// Over the objects of the room; what lies over another's rug or in its spaces does not collide.
void tally_geometry(Judgement& judgement) {
  const double objects = static_cast<double>(judgement.room.layout.objects.size());
  const Report& report = judgement.report;
  const double collisions = metric(report, "collisions"), outside = metric(report, "outOfBounds");
  auto& measures = judgement.measures;
  measures["COL"] = {collisions, objects};
  measures["OOB"] = {outside, objects};
  measures["SUP"] = {metric(report, "support") * objects, objects};
  measures["NAV"] = {metric(report, "navigability"), 1};
  const auto reached = std::count_if(report.checks.begin(), report.checks.end(), [](const Check& c) { return c.name == "accessibility"; });
  measures["ACC"] = {metric(report, "accessibility") * static_cast<double>(reached), static_cast<double>(reached)};
  const double openings = static_cast<double>(judgement.room.layout.room.openings.size());
  measures["OPEN"] = {metric(report, "openingClearance") * openings, openings};
  measures["CF"] = {objects - collisions, objects};
  measures["IB"] = {objects - outside, objects};
}

bool all_met(const Judgement& judgement) {
  const auto share = [&](const char* name) { return judgement.measures.at(name).share(); };
  const auto none = [&](const char* name) { return judgement.measures.at(name).part == 0; };
  const bool asked = std::all_of(judgement.verdicts.begin(), judgement.verdicts.end(), [](const Verdict& v) { return v.holds; });
  const bool doors = std::all_of(judgement.report.checks.begin(), judgement.report.checks.end(),
                                 [](const Check& check) { return check.passed || check.name != "doorSwing"; });
  return asked && doors && none("COL") && none("OOB") && share("SUP") == 1 && share("OPEN") == 1 && share("NAV") >= 0.99 &&
         share("ACC") >= 0.9;
}

int wanted_objects(const Asked& asked) {
  int count = 0;
  if (asked.scene) count = static_cast<int>(asked.scene->objects.size());
  if (asked.annotation) {
    for (const scoring::Entry& entry : asked.annotation->entries) {
      using scoring::Quantifier;
      if (entry.kind != EntryKind::kCount || entry.quantifier == Quantifier::kAtMost || entry.quantifier == Quantifier::kLess) continue;
      count += entry.count + (entry.quantifier == Quantifier::kMore);
    }
  }
  return std::max(1, count);
}

}  // namespace

Judgement judge_room(RoomFile room, const Asked& asked, const Catalog& catalog) {
  Judgement judgement;
  judgement.name = room.name;
  judgement.room = std::move(room);
  const Layout& layout = judgement.room.layout;
  const VerifyOptions options;
  judgement.report = verify(layout, catalog, options);
  if (asked.annotation) {
    const checks::RoomView view(layout, catalog, options);
    judgement.verdicts = scoring::judge_annotation(*asked.annotation, scoring::MeasuredRoom(view));
  } else if (asked.scene) {
    judgement.verdicts = scoring::judge_scene(*asked.scene, layout, catalog);
  } else {
    judgement.verdicts = scoring::judge_own_relations(layout, catalog);
  }
  tally_entries(judgement);
  tally_geometry(judgement);
  judgement.everything = all_met(judgement);
  return judgement;
}

Judgement judge_missing(std::string name, std::string error, const Asked& asked) {
  Judgement judgement;
  judgement.name = std::move(name);
  judgement.error = std::move(error);
  if (asked.annotation) {
    for (const scoring::Entry& entry : asked.annotation->entries) judgement.verdicts.push_back({entry.kind, entry.raw, false, "no room"});
  }
  tally_entries(judgement);
  const double count = wanted_objects(asked);
  for (const char* measure : {"COL", "OOB"}) judgement.measures[measure] = {count, count};
  for (const char* measure : {"SUP", "ACC", "CF", "IB"}) judgement.measures[measure] = {0, count};
  for (const char* measure : {"NAV", "OPEN"}) judgement.measures[measure] = {0, 1};
  return judgement;
}

const std::vector<MeasureRow>& measure_rows() {
  static const std::vector<MeasureRow> rows{
      {"CNT", "counts asked for that are met", true},
      {"OOR", "relations between objects that hold", true},
      {"OAR", "relations to the room that hold", true},
      {"COL", "objects that overlap another by more than 5 mm", false},
      {"OOB", "objects more than 1 % off the floor, or through the ceiling", false},
      {"SUP", "objects held by what they name", true},
      {"NAV", "free floor that hangs together", true},
      {"ACC", "free share of an object's best used side", true},
      {"OPEN", "doors and windows with nothing before them", true},
      {"CF", "objects that overlap no other (LayoutVLM's collision-free score)", true},
      {"IB", "objects within the room (LayoutVLM's in-boundary score)", true},
  };
  return rows;
}

std::map<std::string, Tally> totals(const std::vector<Judgement>& judgements) {
  std::map<std::string, Tally> sums;
  for (const Judgement& judgement : judgements) {
    for (const auto& [name, tally] : judgement.measures) {
      sums[name].part += tally.part;
      sums[name].whole += tally.whole;
    }
  }
  return sums;
}

}  // namespace layoutbox
