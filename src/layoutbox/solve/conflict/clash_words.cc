// Conflicts in words, and the sums that show some of them at once.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "layoutbox/solve/compile/compile.h"
#include "layoutbox/solve/conflict/conflict.h"
#include "layoutbox/solve/conflict/fixed.h"
#include "layoutbox/solve/model/items.h"

namespace layoutbox::placement {

std::string metres(Mm length) { return fmt::format("{:.2f} m", length / 1000.0); }

namespace {

std::string wall_in_words(const RoomWall& wall, bool rectangle) {
  if (!rectangle) {  // "wall5" is wall 5
    const std::size_t digits = wall.id.find_first_of("0123456789");
    const bool numbered = digits != std::string::npos && wall.id.substr(0, digits) == "wall";
    return numbered ? "wall " + wall.id.substr(digits) : "the wall " + wall.id;
  }
  switch (wall.turn) {
    case 0: return "the back wall";
    case 90: return "the left wall";
    case 180: return "the front wall";
    default: return "the right wall";
  }
}

std::string listed(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return out;
}

std::string name_of_item(const Item& item) {
  if (!item.is_opening()) return item.object->name.empty() ? item.object->category : item.object->name;
  switch (item.opening->type) {
    case OpeningType::kWindow: return "window";
    case OpeningType::kDoor: return "door";
    default: return "opening";
  }
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// "beds", "boxes", "bookshelves".
std::string plural_of(const std::string& name) {
  const auto ends = [&](std::string_view with) { return name.size() > with.size() && name.ends_with(with); };
  if (ends("shelf")) return name.substr(0, name.size() - 1) + "ves";
  if (ends("y") && std::string_view("aeiou").find(name[name.size() - 2]) == std::string_view::npos)
    return name.substr(0, name.size() - 1) + "ies";
  return name + (ends("s") || ends("x") || ends("ch") || ends("sh") ? "es" : "s");
}

std::string reference_in_words(const Model& model, const std::string& id) {
  if (const int item = model.find_item(id); item >= 0) return object_in_words(model, item);
  if (const int wall = model.find_wall(id); wall >= 0) return wall_in_words(model.walls[wall], model.walls.size() == 4);
  return "the " + id;
}

// The least an object can measure along its width or depth.
Mm least_width(const Item& item) { return item.object->size->least.width; }

std::string sizes_in_words(const Item& item) {
  const Size& size = item.fixed ? item.states[0].size : item.object->size->least;
  return fmt::format("{:.2f} × {:.2f} × {:.2f} m", size.width / 1000.0, size.depth / 1000.0, size.height / 1000.0);
}

std::string room_in_words(const Model& model) {
  return fmt::format("{:.2f} × {:.2f} × {:.2f} m", model.room.extent(0) / 1000.0, model.room.extent(1) / 1000.0,
                     model.room.extent(2) / 1000.0);
}

void replace(std::string& text, std::string_view what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

std::string parameter_in_words(const Compilation& c, std::string_view name, const std::optional<Mm>& given) {
  return metres(c.length(given, name, 0));
}

// "stands", "hangs" and "is" of one thing are "stand", "hang" and "are" of several.
void make_plural(std::string& sentence) {
  for (const auto& [one, many] : {std::pair{"{targets} stands", "{targets} stand"},
                                  {"{targets} hangs", "{targets} hang"},
                                  {"{targets} is", "{targets} are"},
                                  {"{targets} faces", "{targets} face"},
                                  {"{targets} touches", "{targets} touch"},
                                  {"{targets} keeps", "{targets} keep"},
                                  {"{targets} has", "{targets} have"},
                                  {"{targets} looks", "{targets} look"},
                                  {"at its ", "at their "},
                                  {"with a side", "with a side each"},
                                  {"with its back", "with their backs"}}) {
    replace(sentence, one, many);
  }
}

std::string clearance_in_words(const Model& model, const Constraint& constraint) {
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    const Item& item = model.items[i];
    if (!item.is_opening() || constraint.name != model.constraints[item.clearance_constraint].name) continue;
    return fmt::format("the floor before {} stays free ({} deep)", object_in_words(model, static_cast<int>(i)),
                       metres(clear_depth(*item.opening)));
  }
  return constraint.name;
}

// Objects that must stay out of a clash because they are elsewhere or hold others.
bool stands_on_floor_always(const Item& item) {
  return !item.is_opening() && !item.thin && item.supports.size() == 1 && item.supports[0].kind == SupportOption::Kind::kFloor;
}

std::int64_t least_floor(const Item& item) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const State& state : item.states) {
    std::int64_t covered = 0;  // what of the floor is body: a table's legs are little, but two tables never share their outline
    covered = std::int64_t{state.size.width} * state.size.depth;
    least = std::min(least, covered);
  }
  return least;
}

std::int64_t room_area(const Model& model) {
  std::int64_t twice = 0;
  const std::vector<Point>& polygon = model.scene->room.polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return (std::abs(twice) + 1) / 2;
}

// Relations without a single case: left of itself, in a thing that has no inside.
void add_never(const Model& model, const std::vector<char>& given_up, std::vector<Clash>& out) {
  for (std::size_t c = 0; c < model.constraints.size(); ++c) {
    const Constraint& constraint = model.constraints[c];
    if (constraint.relation < 0 || constraint.firmness != Firmness::kHard || given_up[c]) continue;
    const auto never = [](const Formula& f) { return f.cases.empty() && f.exact; };
    if (std::none_of(constraint.formulas.begin(), constraint.formulas.end(), never)) continue;
    Clash clash;
    clash.demands.push_back({Demand::Kind::kConstraint, static_cast<int>(c)});
    clash.sentence = fmt::format("it can never be that {}", relation_in_words(model, model.scene->relations[constraint.relation]));
    out.push_back(std::move(clash));
  }
}

void add_too_large(const Model& model, const std::vector<char>& left_out, std::vector<Clash>& out) {
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    const Item& item = model.items[i];
    if (item.is_opening() || item.fixed || left_out[i]) continue;
    const auto fits = [&](const State& s) {
      return s.extent[0] <= model.room.extent(0) && s.extent[1] <= model.room.extent(1) && s.extent[2] <= model.room.extent(2);
    };
    if (std::any_of(item.states.begin(), item.states.end(), fits)) continue;
    Clash clash;
    clash.demands.push_back({Demand::Kind::kItem, static_cast<int>(i)});
    clash.sentence = fmt::format("{} measures at least {} and does not fit into the room, which measures {}",
                                 object_in_words(model, static_cast<int>(i)), sizes_in_words(item), room_in_words(model));
    out.push_back(std::move(clash));
  }
}

// Do these things surely fit into the room side by side, wherever they please? Steinberg's theorem on packing rectangles.
bool surely_fit(const Model& model, const std::vector<int>& items) {
  std::int64_t widest = 0, deepest = 0, area = 0;
  for (const int i : items) {
    const State& state = model.items[i].states[0];
    widest = std::max<std::int64_t>(widest, state.extent[0]), deepest = std::max<std::int64_t>(deepest, state.extent[1]);
    area += std::int64_t{state.extent[0]} * state.extent[1];
  }
  const std::int64_t w = model.room.extent(0), d = model.room.extent(1);
  const std::int64_t lost = std::max<std::int64_t>(2 * widest - w, 0) * std::max<std::int64_t>(2 * deepest - d, 0);
  return model.outside.empty() && widest <= w && deepest <= d && 2 * area <= w * d - lost;
}

// Backs against one wall side by side: the widths add up.
// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
void add_too_wide(const Model& model, const std::vector<char>& given_up, const std::vector<char>& left_out, std::vector<Clash>& out) {
  for (std::size_t w = 0; w < model.walls.size(); ++w) {
    const RoomWall& wall = model.walls[w];
    struct Piece {
      int item, constraint;
      Mm width;
    };
    std::vector<Piece> pieces;
    for (std::size_t c = 0; c < model.constraints.size(); ++c) {
      const Constraint& constraint = model.constraints[c];
      if (constraint.relation < 0 || constraint.firmness != Firmness::kHard || given_up[c]) continue;
      const Relation& relation = model.scene->relations[constraint.relation];
      const bool back = relation.type == RelationType::kAgainstWall || relation.type == RelationType::kCenteredOnWall;
      if (!back || relation.references.size() != 1 || model.find_wall(relation.references[0]) != static_cast<int>(w)) continue;
      for (const std::string& id : relation.targets) {
        const int item = model.find_item(id);
        if (item < 0 || left_out[item] || !stands_on_floor_always(model.items[item]) || !model.items[item].has_front) continue;
        const auto same = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& p) { return p.item == item; });
        if (same == pieces.end()) pieces.push_back({item, static_cast<int>(c), least_width(model.items[item])});
      }
    }
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.width > b.width; });
    std::int64_t sum = 0;
    std::size_t needed = 0;
    const auto length = static_cast<Mm>(std::ceil(std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y)));
    while (needed < pieces.size() && sum <= length) sum += pieces[needed++].width;
    if (sum <= length) continue;
    Clash clash;
    std::vector<std::string> words;
    std::vector<int> items;
    for (std::size_t i = 0; i < needed; ++i) items.push_back(pieces[i].item);
    clash.minimal = surely_fit(model, items);  // else the room may be too small for them whatever the wall
    for (std::size_t i = 0; i < needed; ++i) {
      clash.demands.push_back({Demand::Kind::kItem, pieces[i].item});
      const Demand relation{Demand::Kind::kConstraint, pieces[i].constraint};
      if (std::find(clash.demands.begin(), clash.demands.end(), relation) == clash.demands.end()) clash.demands.push_back(relation);
      words.push_back(fmt::format("{} ({})", object_in_words(model, pieces[i].item), metres(pieces[i].width)));
    }
    clash.sentence = fmt::format("{} {} against {}, which is {} long", listed(words),
                                 needed == 2   ? "both stand"
                                 : needed == 1 ? "stands"
                                               : "all stand",
                                 wall_in_words(wall, model.walls.size() == 4), metres(wall.hi - wall.lo));
    out.push_back(std::move(clash));
  }
}

// The door that wants the most free floor before it, which lies within the room wherever in its walls it is; −1: none.
int widest_door(const Model& model, const std::vector<char>& given_up, std::int64_t& area) {
  int widest = -1;
  area = 0;
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    const Item& item = model.items[i];
    if (!item.is_opening() || item.opening->sill > 0 || item.states.empty() || given_up[item.clearance_constraint]) continue;
    if (!model.outside.empty() || item.opening->type == OpeningType::kWindow) continue;
    const std::int64_t clear = floor_area(item.states[0].clear[0]);
    const bool fits = item.opening->width <= std::min(model.room.extent(0), model.room.extent(1));
    if (fits && clear > area) area = clear, widest = static_cast<int>(i);
  }
  return widest;
}

void add_too_much(const Model& model, const std::vector<char>& given_up, const std::vector<char>& left_out, std::vector<Clash>& out) {
  std::vector<std::pair<std::int64_t, int>> areas;
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    const Item& item = model.items[i];
    // Only what surely covers its outline alone: nothing slides under it and it slides under nothing.
    const auto close = [&](std::size_t j) { return j != i && model.pair(static_cast<int>(i), static_cast<int>(j)) == PairRule::kSolids; };
    bool alone = true;
    for (std::size_t j = 0; j < model.items.size() && alone; ++j) alone = !close(j) || !stands_on_floor_always(model.items[j]);
    if (left_out[i] || !stands_on_floor_always(item) || item.fixed || !alone) continue;
    areas.push_back({least_floor(item), static_cast<int>(i)});
  }
  std::stable_sort(areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  const std::int64_t room = room_area(model);
  std::int64_t sum = 0, before_door = 0;
  int door = widest_door(model, given_up, before_door);
  Clash clash;
  std::vector<int> items;
  const std::int64_t all =
      std::accumulate(areas.begin(), areas.end(), std::int64_t{0}, [](std::int64_t s, const auto& a) { return s + a.first; });
  if (all > room) door = -1, before_door = 0;
  for (const auto& [area, item] : areas) {
    if (sum + before_door > room) break;
    sum += area;
    clash.demands.push_back({Demand::Kind::kItem, item});
    items.push_back(item);
  }
  if (sum + before_door <= room) return;
  clash.minimal = false;  // by the sum alone: it says nothing of how the rest would fit
  std::string door_words;
  if (door >= 0) {
    clash.demands.push_back({Demand::Kind::kItem, door});
    clash.demands.push_back({Demand::Kind::kConstraint, model.items[door].clearance_constraint});
    door_words = fmt::format(", {} keeps {:.2f} m² free before it", object_in_words(model, door), static_cast<double>(before_door) / 1e6);
  }
  clash.sentence = fmt::format("{} cover{} at least {:.2f} m² of floor{}, and the room has {:.2f} m²", things_in_words(model, items),
                               items.size() == 1 ? "s" : "", static_cast<double>(sum) / 1e6, door_words, static_cast<double>(room) / 1e6);
  out.push_back(std::move(clash));
}

}  // namespace

std::string object_in_words(const Model& model, int index) {
  const std::string name = name_of_item(model.items[index]);
  int rank = 0, count = 0;
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    if (name_of_item(model.items[i]) != name) continue;
    ++count;
    if (static_cast<int>(i) <= index) ++rank;
  }
  const std::string words = spaced(name);
  return count > 1 ? fmt::format("the {} {}", words, rank) : "the " + words;
}

std::string things_in_words(const Model& model, const std::vector<int>& items) {
  std::vector<std::string> words;
  std::vector<std::string> done;
  for (const int item : items) {
    const std::string name = name_of_item(model.items[item]);
    if (std::find(done.begin(), done.end(), name) != done.end()) continue;
    done.push_back(name);
    const auto of_name = [&](const Item& i) { return name_of_item(i) == name; };
    const auto here = std::count_if(items.begin(), items.end(), [&](int i) { return of_name(model.items[i]); });
    const auto all = std::count_if(model.items.begin(), model.items.end(), of_name);
    if (here == 1) {
      words.push_back(object_in_words(model, item));
    } else {
      words.push_back((here < all ? fmt::format("{} of the {} ", here, all) : fmt::format("the {} ", all)) + plural_of(spaced(name)));
    }
  }
  return listed(words);
}

namespace {

// What is meant where nothing is named.
std::string anything_in_words(RelationType type, const RelationRow& row) {
  switch (type) {
    case RelationType::kUnderWindow:
    case RelationType::kNearWindow: return "a window";
    case RelationType::kFarFromWindow: return "the windows";
    case RelationType::kNearDoor: return "a door";
    case RelationType::kFarFromDoor: return "the doors";
    case RelationType::kNotBlocking: return "the doors and windows";
    case RelationType::kKeepClear: return "that part of the room";
    case RelationType::kAwayFromWall: return "the walls";
    case RelationType::kCorner: return "the room";
    case RelationType::kStacked: return "one another";
    case RelationType::kAlign: return "one another";
    default: return row.reference_kinds & kWall ? "a wall" : row.reference_kinds & kOpening ? "an opening" : "the room";
  }
}

}  // namespace

std::string relation_in_words(const Model& model, const Relation& relation) {
  std::vector<std::string> targets, references;
  for (const std::string& id : relation.targets) targets.push_back(reference_in_words(model, id));
  for (const std::string& id : relation.references) references.push_back(reference_in_words(model, id));
  const RelationRow& row = relation_row(relation.type);
  if (references.empty()) references.push_back(anything_in_words(relation.type, row));
  const bool stands = relation.type == RelationType::kOn || relation.type == RelationType::kStacked;
  for (std::string& reference : references) {
    if (stands && reference == "the room") reference = "the floor";
  }
  std::string text(row.sentence);
  if (targets.size() > 1) make_plural(text);
  Constraint unused;
  const Compilation c{model, relation, {}, {}, unused};
  const RelationParameters& p = relation.parameters;
  if (!p.axis)
    replace(text, " along {axis}",
            relation.type == RelationType::kGroupAlign || relation.type == RelationType::kAlign ? " along x or y" : "");
  if (targets.size() == 1) replace(text, "each of {targets}", "{targets}");
  replace(text, "{targets}", listed(targets));
  replace(text, "{references}", listed(references));
  replace(text, "{distance}", parameter_in_words(c, "distance", p.distance));
  replace(text, "{min}", parameter_in_words(c, "min", p.min));
  if (relation.type == RelationType::kDistance && !p.max) replace(text, " and {max}", " and any distance");
  replace(text, "{max}", parameter_in_words(c, "max", p.max));
  if (relation.type == RelationType::kClearance && !p.depth) replace(text, "{depth} of ", "");
  replace(text, "{depth}", parameter_in_words(c, "depth", p.depth));
  if (p.axis) replace(text, "{axis}", *p.axis == Axis::kX ? "x" : *p.axis == Axis::kY ? "y" : "z");
  replace(text, "{side}", std::string(name_of(p.side.value_or(relation.type == RelationType::kAlongSide ? Side::kLong : Side::kFront))));
  replace(text, "{edge}", p.edge.empty() ? "front" : p.edge);
  replace(text, "{region}", p.region);
  if (!p.columns) replace(text, " of {columns} columns", "");
  replace(text, "{columns}", std::to_string(p.columns.value_or(0)));
  if (p.columns == 1) replace(text, "1 columns", "1 column");
  switch (relation.type) {  // words that stand for a figure
    case RelationType::kFar: text += fmt::format(" (at least {})", parameter_in_words(c, "min", p.min)); break;
    case RelationType::kNextTo: text += fmt::format(" (at most {} apart)", parameter_in_words(c, "max", p.max)); break;
    case RelationType::kNear:
      text += fmt::format(" ({} to {} apart)", parameter_in_words(c, "min", p.min), parameter_in_words(c, "max", p.max));
      break;
    default: break;
  }
  return text;
}

std::string describe_clash(const Model& model, const Clash& clash) {
  if (!clash.sentence.empty()) return clash.sentence;
  std::vector<std::string> relations, objects;
  for (const Demand& demand : clash.demands) {
    if (demand.kind == Demand::Kind::kItem) {
      const Item& item = model.items[demand.index];
      if (item.is_opening()) {
        objects.push_back(fmt::format("{} ({} wide)", object_in_words(model, demand.index), metres(item.opening->width)));
      } else {
        objects.push_back(fmt::format("{} (at least {})", object_in_words(model, demand.index), sizes_in_words(item)));
      }
      continue;
    }
    const Constraint& constraint = model.constraints[demand.index];
    relations.push_back(constraint.relation >= 0    ? relation_in_words(model, model.scene->relations[constraint.relation])
                        : !constraint.words.empty() ? constraint.words
                                                    : clearance_in_words(model, constraint));
  }
  const std::string room = fmt::format("the room, which measures {}", room_in_words(model));
  if (relations.empty() && !clash.proven) return fmt::format("no layout was found for {} together in {}", listed(objects), room);
  if (relations.empty()) return fmt::format("{} do not fit together into {}", listed(objects), room);
  const std::string what = !clash.proven           ? "no layout was found such that "
                           : relations.size() == 1 ? "it cannot be that "
                           : relations.size() == 2 ? "it cannot both be that "
                                                   : "it cannot all be that ";
  std::string out = what;
  for (std::size_t i = 0; i < relations.size(); ++i)
    out += (i == 0 ? "" : i + 1 == relations.size() ? " and that " : ", that ") + relations[i];
  if (!objects.empty()) out += fmt::format(", with {} in {}", listed(objects), room);
  return out;
}

std::vector<Clash> clashes_by_sums(const Model& model, const std::vector<char>& given_up, const std::vector<char>& left_out) {
  std::vector<Clash> out = clashes_of_fixed(model, left_out);
  add_never(model, given_up, out);
  add_too_large(model, left_out, out);
  add_too_wide(model, given_up, left_out, out);
  if (out.empty()) add_too_much(model, given_up, left_out, out);
  return out;
}

}  // namespace layoutbox::placement
