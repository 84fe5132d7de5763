// The room itself, its doors and windows.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::edit {

using namespace offline;

namespace {

bool is_new(const NounPhrase& noun) {
  return noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || noun.determiner == Determiner::kNone;
}

std::array<double, 2> middle_of(const Wall& wall) { return {(wall.start.x + wall.end.x) / 2.0, (wall.start.y + wall.end.y) / 2.0}; }

// The wall across the room: whose middle is farthest in the direction that this one looks.
const Wall* wall_opposite(const Layout& layout, const Wall& wall) {
  const Wall* best = nullptr;
  double farthest = 1;
  const double nx = wall.start.y - wall.end.y, ny = wall.end.x - wall.start.x;  // inwards: the polygon runs counter-clockwise
  for (const Wall& other : layout.room.walls) {
    const bool parallel = (other.end.x - other.start.x) * nx + (other.end.y - other.start.y) * ny == 0;
    const auto from = middle_of(wall), to = middle_of(other);
    const double far = (to[0] - from[0]) * nx + (to[1] - from[1]) * ny;
    if (parallel && far > farthest) farthest = far, best = &other;
  }
  return best;
}

}  // namespace

std::optional<Status> EditReader::read_room_command(Clause& clause, const std::optional<EditResize>& resize,
                                                    const std::optional<ShiftAt>& shift) {
  std::size_t k = 0;
  const auto& chunks = clause.document.chunks;
  while (k < chunks.size() && (chunks[k].kind == ChunkKind::kIgnored || chunks[k].kind == ChunkKind::kThere)) ++k;
  if (k == chunks.size() || chunks[k].kind != ChunkKind::kNoun) return std::nullopt;
  const NounPhrase& noun = chunks[k].noun;
  clause.k = k;
  if (is_opening(noun)) return read_openings(clause, resize, shift);
  const bool height_only = resize && resize->sides[0].factor == 1 && resize->sides[0].more == 0 && !resize->sides[0].exact &&
                           resize->sides[1].factor == 1 && resize->sides[1].more == 0 && !resize->sides[1].exact;
  const bool walls = noun.kind == NounKind::kWall && noun.wall_word.empty() && height_only;
  if (noun.kind == NounKind::kCeiling && (resize || clause.verb == Verb::kMove)) return read_room_size(clause, resize, shift);
  const bool room_meant = noun.kind == NounKind::kPronoun && !noun.is_plural() && last_.empty() && room_last_;  // "make it bigger"
  if ((noun.kind == NounKind::kRoom || walls || room_meant) && resize) {
    if (room_meant) plan_.notes.push_back({"warning", "\"" + clause.why + "\": the room is meant, as no thing was spoken of", "text"});
    return read_room_size(clause, resize, shift);
  }
  clause.k = 0;
  return std::nullopt;
}

// "make the room 50 cm wider", "raise the ceiling by 20 cm".
Status EditReader::read_room_size(Clause& clause, const std::optional<EditResize>& resize, const std::optional<ShiftAt>& shift) {
  ++clause.k;
  LAYOUTBOX_CHECK(rest_understood(clause));
  EditResize change;
  if (resize) {
    change = *resize;
  } else {
    constexpr Mm kLittle = 200;
    const bool down = clause.word == "lower" || (shift && shift->shift.way == EditShift::Way::kDown);
    if (!down && clause.word != "raise" && !shift) return not_understood(clause);
    const Mm step = shift && shift->shift.distance ? *shift->shift.distance : kLittle;
    change.sides[2].more = down ? -step : step;
  }
  EditStep& step = begin(EditKind::kResize, clause);
  step.targets = {std::string(kEditRoom)};
  step.resize = change;
  return {};
}

Result<std::vector<std::string>> EditReader::find_openings(Clause& clause, const NounPhrase& noun) {
  std::vector<std::string> found;
  for (const Opening* opening : world_.openings_of(noun)) found.push_back(opening->id);
  const std::string words = words_between(clause.document, noun.first, std::max(noun.last, noun.first + 1));
  constexpr std::string_view kOrdinals[] = {"first", "second", "third", "fourth"};
  for (std::size_t n = 0; n < std::size(kOrdinals); ++n) {
    for (std::size_t i = noun.first; i < noun.last; ++i) {
      if (clause.document.tokens[i].text != kOrdinals[n]) continue;
      found = n < found.size() ? std::vector<std::string>{found[n]} : std::vector<std::string>{};
    }
  }
  if (found.empty()) {
    std::string there;
    for (const Opening& opening : world_.layout().room.openings) there += (there.empty() ? "" : ", ") + opening.id;
    return fail(ErrorCode::kReference, "there is no \"" + words + "\" in this room", "text",
                there.empty() ? "it has neither doors nor windows" : "there are: " + there);
  }
  // "the window on the left wall", "the door next to the bed".
  const bool plural = noun.is_plural() || noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach;
  if (found.size() > 1 && !plural && relations_ahead(clause) > 0 && (clause.verb == Verb::kRemove || relations_ahead(clause) > 1)) {
    const std::size_t before = clause.k;
    const auto place = read_opening_place(clause, found);
    if (place && !place->wall.empty()) {
      std::erase_if(found, [&](const std::string& id) { return world_.layout().find_opening(id)->wall != place->wall; });
    }
    if (!place || found.empty()) clause.k = before;
  }
  const std::size_t wanted = noun.count > 0 ? static_cast<std::size_t>(noun.count) : 1;
  if (found.size() > wanted && (!plural || noun.count > 0)) {
    if (is_new(noun) || noun.count > 0) return std::vector<std::string>(found.end() - static_cast<std::ptrdiff_t>(wanted), found.end());
    std::string all;
    for (const std::string& id : found) all += (all.empty() ? "" : ", ") + id;
    return fail(ErrorCode::kReference, "which of " + all + " is meant by \"" + words + "\" is not said", "text",
                "name one by its id or its wall, or say \"all\"");
  }
  return found;
}

// The wall that a noun speaks of, and the place along it, where it names one: "the left wall", "its middle", "the door", "the desk".
Result<EditOpeningPlace> EditReader::read_wall_place(Clause& clause, const Wall* own_wall, const PhraseSenses& senses) {
  const Layout& layout = world_.layout();
  const Chunk chunk = *peek(clause);
  const NounPhrase& noun = chunk.noun;
  const auto unclear = [&] { return not_understood(clause, words_between(clause.document, noun.first, noun.last)); };
  ++clause.k;
  EditOpeningPlace place;
  const Wall* wall = nullptr;
  const bool of_wall = noun.kind == NounKind::kCenter && noun.of && noun.of->kind == NounKind::kWall;
  if (noun.kind == NounKind::kWall || of_wall) {
    const NounPhrase& named = of_wall ? *noun.of : noun;
    if (!named.wall_word.empty())
      wall = layout.find_wall(named.wall_word);
    else if (is_opposite_wall(named))
      wall = own_wall != nullptr ? wall_opposite(layout, *own_wall) : nullptr;
    else
      wall = own_wall;
  } else if (noun.kind == NounKind::kCenter) {
    wall = own_wall;
  } else if (is_opening(noun)) {
    const auto others = world_.openings_of(noun);
    if (others.size() != 1) return unclear();
    wall = layout.find_wall(others.front()->wall);
    place.near = center_of(layout, *others.front());
  } else if (noun.kind == NounKind::kObject) {
    LAYOUTBOX_ASSIGN(const Found found, find_reference(clause, chunk));
    if (found.things.size() != 1) return unclear();
    wall = world_.wall_of(found.things.front());
    if (const PlacedObject* placed = world_.thing(found.things.front()).placed) place.near = {placed->position[0], placed->position[1]};
  }
  const bool by_thing = is_opening(noun) || noun.kind == NounKind::kObject;
  const bool across = by_thing && (says(senses, RelationType::kOpposite) || says(senses, RelationType::kFacing));
  if (across && wall != nullptr) wall = wall_opposite(layout, *wall);
  if (wall == nullptr) return unclear();
  place.wall = wall->id;
  return place;
}

// "… on the left wall", "in the middle of the back wall", "opposite the door", "above the desk".
Result<EditOpeningPlace> EditReader::read_opening_place(Clause& clause, const std::vector<std::string>& openings) {
  const Layout& layout = world_.layout();
  const Opening* own = openings.empty() ? nullptr : layout.find_opening(openings.front());
  const Wall* own_wall = own != nullptr ? layout.find_wall(own->wall) : nullptr;
  EditOpeningPlace place;
  bool any = false, middle = clause.word == "center";
  while (more(clause)) {
    const std::size_t before = clause.k;
    skip(clause, {ChunkKind::kIgnored, ChunkKind::kParticiple, ChunkKind::kVerb, ChunkKind::kRelative});
    PhraseSenses senses;
    if (more(clause) && peek(clause)->kind == ChunkKind::kRelation) {
      if (peek(clause)->phrase.senses != nullptr) senses = *peek(clause)->phrase.senses;
      const std::string words = words_of(clause, *peek(clause));
      middle = middle || words.find("center") != std::string::npos || words.find("middle") != std::string::npos;
      ++clause.k;
    }
    if (!noun_next(clause)) {
      clause.k = before;
      break;
    }
    middle = middle || peek(clause)->noun.kind == NounKind::kCenter;
    LAYOUTBOX_ASSIGN(const EditOpeningPlace next, read_wall_place(clause, own_wall, senses));
    place.wall = next.wall;
    if (next.near) place.near = next.near;
    any = true;
  }
  if (middle && place.wall.empty() && own_wall != nullptr) place.wall = own_wall->id, any = true;
  if (middle && !place.wall.empty()) place.near = middle_of(*layout.find_wall(place.wall));
  if (!any && !openings.empty()) return not_understood(clause);
  return place;
}

Status EditReader::add_openings(Clause& clause) {
  const NounPhrase noun = peek(clause)->noun;
  ++clause.k;
  NounPhrase sized = noun;
  if (more(clause) && peek(clause)->kind == ChunkKind::kSize) {
    const SaidSize& said = peek(clause)->size;
    if (said.width) sized.size.width = said.width;
    if (said.length && !said.width) sized.size.width = said.length;
    if (said.height) sized.size.height = said.height;
    ++clause.k;
  }
  LAYOUTBOX_ASSIGN(EditOpeningPlace place, read_opening_place(clause, {}));
  const OpeningType type = noun.kind == NounKind::kWindow ? OpeningType::kWindow : OpeningType::kDoor;
  const int count = noun.count > 0 ? noun.count : noun.plural ? 2 : 1;
  if (count > 12) return not_understood(clause, words_between(clause.document, noun.first, noun.last));
  EditStep& step = begin(EditKind::kAdd, clause);
  int number = 0;
  for (int i = 0; i < count; ++i) {
    Opening opening = opening_said(type, sized);
    do {
      opening.id = std::string(name_of(type)) + std::to_string(++number);
    } while (world_.layout().find_opening(opening.id) != nullptr ||
             std::find(added_openings_.begin(), added_openings_.end(), opening.id) != added_openings_.end());
    added_openings_.push_back(opening.id);
    step.openings.push_back(std::move(opening));
  }
  step.opening_place = std::move(place);
  return {};
}

Status EditReader::read_openings(Clause& clause, const std::optional<EditResize>& resize, const std::optional<ShiftAt>& shift) {
  const bool adds = clause.verb == Verb::kAdd || (clause.verb == Verb::kPlace && is_new(peek(clause)->noun));
  if (adds) {
    while (noun_next(clause) && is_opening(peek(clause)->noun)) {
      LAYOUTBOX_CHECK(add_openings(clause));
      skip(clause, {ChunkKind::kComma, ChunkKind::kAnd, ChunkKind::kIgnored});
    }
    return more(clause) && clause.verb == Verb::kAdd ? read_add(clause) : rest_understood(clause);
  }
  std::vector<std::string> found;
  while (noun_next(clause) && is_opening(peek(clause)->noun)) {
    const NounPhrase noun = peek(clause)->noun;
    ++clause.k;
    LAYOUTBOX_ASSIGN(const std::vector<std::string> more_of_them, find_openings(clause, noun));
    found.insert(found.end(), more_of_them.begin(), more_of_them.end());
    const std::size_t before = clause.k;
    skip(clause, {ChunkKind::kComma, ChunkKind::kAnd});
    if (!noun_next(clause)) clause.k = before;
  }
  const auto step_of = [&](EditKind kind) -> EditStep& {
    EditStep& step = begin(kind, clause);
    step.targets = found;
    return step;
  };
  switch (clause.verb) {
    case Verb::kRemove: step_of(EditKind::kRemove); return noun_next(clause) ? read_remove(clause) : rest_understood(clause);
    case Verb::kSwap:
      if (found.size() != 2 || found[0] == found[1]) return not_understood(clause);
      step_of(EditKind::kSwap);
      return rest_understood(clause);
    case Verb::kMove:
    case Verb::kPlace:
    case Verb::kMake:
    case Verb::kResize:
    case Verb::kNone: break;
    default: return not_understood(clause);
  }
  if (resize) {
    step_of(EditKind::kResize).resize = *resize;
    return rest_understood(clause);
  }
  if (shift) {
    const Opening* first = world_.layout().find_opening(found.front());
    LAYOUTBOX_ASSIGN(const EditShift way, read_shift_reference(clause, shift->shift, world_.layout().find_wall(first->wall)));
    step_of(EditKind::kShift).shift = way;
    return rest_understood(clause);
  }
  LAYOUTBOX_ASSIGN(EditOpeningPlace place, read_opening_place(clause, found));
  step_of(EditKind::kMove).opening_place = std::move(place);
  return rest_understood(clause);
}

}  // namespace layoutbox::edit
