// Judges anybody's rooms: is it a possible room, and is it the one that was asked for. docs/judge.md has the measures.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/judge/annotation.h"
#include "layoutbox/judge/entries.h"
#include "layoutbox/judge/room_file.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {

// A share as its parts, so that shares of many rooms can be added.
struct Tally {
  double part = 0, whole = 0;
  double share() const { return whole > 0 ? part / whole : 1; }
};

struct Judgement {
  std::string name;   // of the room: its file or id
  std::string error;  // why it could not be read; then every entry is missed
  RoomFile room;
  Report report;                           // verify's
  std::vector<scoring::Verdict> verdicts;  // what was asked for
  std::map<std::string, Tally> measures;   // CNT, OOR, OAR, COL, OOB, SUP, NAV, ACC, OPEN, CF, IB
  bool everything = false;                 // all that was asked for, and a possible room
};

// What a room is compared with: at most one of the two; with neither, with what the layout itself says was asked for.
struct Asked {
  std::optional<scoring::Annotation> annotation;
  std::optional<SceneGraph> scene;
};

Judgement judge_room(RoomFile room, const Asked& asked, const Catalog& catalog);
// A room that is not there or cannot be read: all missed, as many bad objects as were asked for.
Judgement judge_missing(std::string name, std::string error, const Asked& asked);

// The names of the measures in the order in which they are shown, what each means, and whether more is better.
struct MeasureRow {
  std::string_view name, meaning;
  bool more_is_better;
};
const std::vector<MeasureRow>& measure_rows();
std::map<std::string, Tally> totals(const std::vector<Judgement>& judgements);

// For a person (`reasons`: each failed entry and check), and for programs (judgement@1).
std::string judgement_text(const std::vector<Judgement>& judgements, bool reasons);
std::string judgement_json(const std::vector<Judgement>& judgements);

}  // namespace layoutbox
