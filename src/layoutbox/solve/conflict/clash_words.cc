// Conflicts in words.
#include "layoutbox/solve/conflict/clash_words.h"

#include <fmt/format.h>

#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/compile/compile.h"
#include "layoutbox/solve/conflict/conflict.h"
#include "layoutbox/solve/model/items.h"

namespace layoutbox::placement {

std::string metres(Mm length) { return fmt::format("{:.2f} m", length / 1000.0); }

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

std::string sizes_in_words(const Item& item) {
  const Size& size = item.fixed ? item.states[0].size : item.object->size->least;
  return fmt::format("{:.2f} × {:.2f} × {:.2f} m", size.width / 1000.0, size.depth / 1000.0, size.height / 1000.0);
}

std::string room_in_words(const PlacementModel& model) {
  return fmt::format("{:.2f} × {:.2f} × {:.2f} m", model.room.extent(0) / 1000.0, model.room.extent(1) / 1000.0,
                     model.room.extent(2) / 1000.0);
}

namespace {

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

std::string reference_in_words(const PlacementModel& model, const std::string& id) {
  if (const ItemId item = model.find_item(id); item.exists()) return object_in_words(model, item);
  if (const WallId wall = model.find_wall(id); wall.exists()) return wall_in_words(model.walls[wall], model.walls.size() == 4);
  return "the " + id;
}

void replace(std::string& text, std::string_view what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

std::string length_in_words(const Compilation& c, std::optional<Mm> RelationFigures::*parameter) { return metres(c.length(parameter)); }

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

std::string clearance_in_words(const PlacementModel& model, const Constraint& constraint) {
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (!item.is_opening() || constraint.name != model.constraints[item.clearance_constraint].name) continue;
    return fmt::format("the floor before {} stays free ({} deep)", object_in_words(model, i), metres(clear_depth(*item.opening)));
  }
  return constraint.name;
}

}  // namespace

std::string object_in_words(const PlacementModel& model, ItemId index) {
  const std::string name = name_of_item(model.items[index]);
  int rank = 0, count = 0;
  for (const ItemId i : model.items.ids()) {
    if (name_of_item(model.items[i]) != name) continue;
    ++count;
    if (i <= index) ++rank;
  }
  const std::string words = spaced(name);
  return count > 1 ? fmt::format("the {} {}", words, rank) : "the " + words;
}

std::string things_in_words(const PlacementModel& model, const std::vector<ItemId>& items) {
  std::vector<std::string> words;
  std::vector<std::string> done;
  for (const ItemId item : items) {
    const std::string name = name_of_item(model.items[item]);
    if (std::find(done.begin(), done.end(), name) != done.end()) continue;
    done.push_back(name);
    const auto of_name = [&](const Item& i) { return name_of_item(i) == name; };
    const auto here = std::count_if(items.begin(), items.end(), [&](ItemId i) { return of_name(model.items[i]); });
    const auto all = std::count_if(model.items.begin(), model.items.end(), of_name);
    if (here == 1) {
      words.push_back(object_in_words(model, item));
    } else {
      words.push_back((here < all ? fmt::format("{} of the {} ", here, all) : fmt::format("the {} ", all)) + plural_of(spaced(name)));
    }
  }
  return listed(words);
}

std::string relation_in_words(const PlacementModel& model, const Relation& relation) {
  std::vector<std::string> targets, references;
  for (const std::string& id : relation.targets) targets.push_back(reference_in_words(model, id));
  for (const std::string& id : relation.references) references.push_back(reference_in_words(model, id));
  const RelationRow& row = relation_row(relation.type);
  if (references.empty()) references.emplace_back(unnamed_reference(relation.type));
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
  if (relation.type == RelationType::kOffset && p.edge) replace(text, "{targets}", "the middle of {targets}");
  if (targets.size() == 1) replace(text, "each of {targets}", "{targets}");
  replace(text, "{targets}", listed(targets));
  replace(text, "{references}", listed(references));
  replace(text, "{distance}", length_in_words(c, &RelationParameters::distance));
  replace(text, "{min}", length_in_words(c, &RelationParameters::min));
  if (relation.type == RelationType::kDistance && !p.max) replace(text, " and {max}", " and any distance");
  replace(text, "{max}", length_in_words(c, &RelationParameters::max));
  if (relation.type == RelationType::kClearance && !p.depth) replace(text, "{depth} of ", "");
  replace(text, "{depth}", length_in_words(c, &RelationParameters::depth));
  if (p.axis) replace(text, "{axis}", *p.axis == Axis::kX ? "x" : *p.axis == Axis::kY ? "y" : "z");
  replace(text, "{side}", std::string(name_of(or_default(relation, &RelationParameters::side))));
  replace(text, "{edge}", std::string(name_of(or_default(relation, &RelationParameters::edge))));
  if (p.region) replace(text, "{region}", std::string(name_of(*p.region)));
  if (!p.columns) replace(text, " of {columns} columns", "");
  replace(text, "{columns}", std::to_string(p.columns.value_or(0)));
  if (p.columns == 1) replace(text, "1 columns", "1 column");
  switch (relation.type) {  // words that stand for a figure
    case RelationType::kFar: text += fmt::format(" (at least {})", length_in_words(c, &RelationParameters::min)); break;
    case RelationType::kNextTo: text += fmt::format(" (at most {} apart)", length_in_words(c, &RelationParameters::max)); break;
    case RelationType::kNear:
      text += fmt::format(" ({} to {} apart)", length_in_words(c, &RelationParameters::min), length_in_words(c, &RelationParameters::max));
      break;
    default: break;
  }
  return text;
}

std::string describe_clash(const PlacementModel& model, const Clash& clash) {
  if (!clash.sentence.empty()) return clash.sentence;
  std::vector<std::string> relations, objects;
  for (const Demand& demand : clash.demands) {
    if (demand.is_item()) {
      const Item& item = model.items[demand.item];
      if (item.is_opening()) {
        objects.push_back(fmt::format("{} ({} wide)", object_in_words(model, demand.item), metres(item.opening->width)));
      } else {
        objects.push_back(fmt::format("{} (at least {})", object_in_words(model, demand.item), sizes_in_words(item)));
      }
      continue;
    }
    const Constraint& constraint = model.constraints[demand.constraint];
    relations.push_back(constraint.relation.exists() ? relation_in_words(model, model.relation(constraint.relation))
                        : !constraint.words.empty()  ? constraint.words
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

}  // namespace layoutbox::placement
