// Commands that say little: what "it" is before anything was spoken of, turns of no said angle, copies, clearing, and what is no edit.
#include <algorithm>
#include <cmath>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"

namespace layoutbox::edit {

using namespace offline;

void EditReader::recall() {
  const std::string& prompt = world_.layout().prompt;
  const std::size_t line = prompt.rfind('\n');
  if (line == std::string::npos) {
    room_last_ = !prompt.empty();
    return;
  }
  const std::vector<Command> commands = split_commands(tokenize(std::string_view(prompt).substr(line + 1)));
  if (commands.empty()) return;
  Clause before;
  Tokens tokens = commands.back().tokens;
  static_cast<void>(take_resize(lexicon_, tokens, "", false));
  before.document.tokens = std::move(tokens);
  chunk(before);
  const auto first = std::ranges::find(before.document.chunks, ChunkKind::kNoun, &Chunk::kind);
  if (first == before.document.chunks.end()) return;
  const NounPhrase& noun = first->noun;
  room_last_ = noun.kind == NounKind::kRoom;
  if (noun.kind != NounKind::kObject) return;
  std::vector<int> found = world_.with_attributes(world_.of_kind(noun), noun);
  const std::size_t wanted = noun.count > 0 ? static_cast<std::size_t>(noun.count) : 1;
  const bool came_in = noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || noun.count > 0;
  if (found.size() > wanted && came_in) found.erase(found.begin(), found.end() - static_cast<std::ptrdiff_t>(wanted));
  if (found.size() > wanted && !noun.is_plural()) return;
  last_ = std::move(found);
  recalled_ = !last_.empty();
}

std::optional<double> EditReader::plain_turn(const Clause& clause) {
  const auto& chunks = clause.document.chunks;
  const auto bare = [](const Chunk& chunk) {
    return chunk.kind == ChunkKind::kNoun || chunk.kind == ChunkKind::kAnd || chunk.kind == ChunkKind::kComma;
  };
  if (chunks.empty() || !std::ranges::all_of(chunks, bare) || one_of(clause.word, {"face", "orient", "point", "angle"}))
    return std::nullopt;
  const bool around = one_of(clause.word, {"flip", "spin"});
  plan_.notes.push_back(
      {"info", "\"" + clause.why + "\": " + (around ? "half a turn" : "a quarter turn to the left") + " is taken", "text"});
  return around ? 180 : 90;
}

// Left and right of one who looks at the wall that the thing is at.
EditShift EditReader::along_wall(EditShift shift, const std::vector<int>& things) const {
  using enum EditShift::Way;
  const Wall* wall = things.empty() ? nullptr : world_.wall_of(things.front());
  if (wall == nullptr || (shift.way != kLeft && shift.way != kRight)) return shift;
  const double sign = shift.way == kRight ? -1 : 1;  // walls run counter-clockwise: to the left of one who looks at them from within
  const double x = sign * (wall->end.x - wall->start.x), y = sign * (wall->end.y - wall->start.y);
  shift.way = std::abs(x) >= std::abs(y) ? (x > 0 ? kRight : kLeft) : y > 0 ? kBack : kFront;
  return shift;
}

Status EditReader::read_clear(Clause& clause) {
  skip(clause, {ChunkKind::kIgnored});
  std::vector<int> goes;
  const auto gone = [&](int i) { return world_.thing(i).gone; };
  const auto all = [&] {
    std::vector<int> there;
    for (int i = 0; i < static_cast<int>(world_.things().size()); ++i) {
      if (!gone(i)) there.push_back(i);
    }
    return there;
  };
  if (noun_next(clause) && peek(clause)->noun.kind == NounKind::kRoom) {
    ++clause.k;
    goes = all();
  } else {
    LAYOUTBOX_ASSIGN(const std::vector<int> holders, read_things(clause, false));
    std::vector<std::string> held_by = ids(holders);
    for (bool more_found = true; more_found;) {
      more_found = false;
      for (const int i : all()) {
        const PlacedObject* placed = world_.thing(i).placed;
        if (placed == nullptr || has(goes, i) || std::ranges::find(held_by, placed->supported_by) == held_by.end()) continue;
        goes.push_back(i);
        held_by.push_back(placed->id);
        more_found = true;
      }
    }
    if (goes.empty()) {
      return fail(ErrorCode::kReference, "nothing stands on or in " + world_.names(holders), "text",
                  "to take away the thing itself say: remove it");
    }
  }
  LAYOUTBOX_CHECK(rest_understood(clause));
  if (goes.empty()) return fail(ErrorCode::kReference, "nothing is in the room", "text", kWhatToSay);
  begin(EditKind::kRemove, clause, goes);
  for (const int i : goes) world_.things()[static_cast<std::size_t>(i)].gone = true;
  return {};
}

Status EditReader::read_copy(Clause& clause) {
  LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, false));
  LAYOUTBOX_CHECK(rest_understood(clause));
  EditStep step;
  step.kind = EditKind::kAdd;
  step.why = clause.why;
  std::vector<int> fresh;
  for (const int i : things) {
    const Thing model = world_.thing(i);
    NounPhrase noun = model.noun;
    noun.attributes = model.attributes;
    fresh.push_back(bring_in(noun, step));
    SceneObject& copy = step.objects.back();
    if (model.placed == nullptr) continue;
    copy.size = SizeRange{model.placed->size, model.placed->size, model.placed->size};
    copy.size_source = SizeSource::kUser;
    added_[copy.id] = copy;
  }
  plan_.steps.push_back(std::move(step));
  remember(fresh);
  return {};
}

Failure EditReader::refusal(const Clause& clause) {
  const auto say = [&](const char* why, const char* hint) {
    return fail(ErrorCode::kParse, "\"" + clause.why + "\" is not a change of the room: " + why, "text", hint);
  };
  switch (clause.verb) {
    case Verb::kUndo:
      return say("what was before is not kept here",
                 "go on from the layout that this one was made of, unless -o wrote this one over it; in the studio Ctrl+Z undoes");
    case Verb::kRedo:
      return say("what was done before is not known here", "say it again in full; in the studio Ctrl+Shift+Z does again what was undone");
    case Verb::kRearrange:
      return say("an edit leaves in its place what nothing is said of",
                 "say what goes where; for other arrangements of the same room: layoutbox solve scene.json --variants 3");
    default:
      return say("it would be another room", "describe that: layoutbox generate \"…\"; to take out all there is say: remove everything");
  }
}

Status EditReader::check_shade(const Clause& clause) {
  if (clause.verb != Verb::kMake && clause.verb != Verb::kRecolor && clause.verb != Verb::kNone) return {};
  for (const Token& token : clause.document.tokens) {
    if (!one_of(token.text, {"darker", "lighter", "brighter", "paler"})) continue;
    return fail(ErrorCode::kParse, "\"" + token.text + "\" in \"" + clause.why + "\": than what is not known here", "text",
                "say the color itself, for example: paint the walls dark green");
  }
  return {};
}

}  // namespace layoutbox::edit
