#include "layoutbox/catalog/catalog_json.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/scene_check.h"
#include "layoutbox/scene/schema_check.h"

namespace layoutbox {
namespace {

using nlohmann::json;

// [least, usual, greatest] in millimetres.
std::array<Mm, 3> read_lengths(const json& value) {
  if (value.is_number()) {
    const Mm length = mm_from_m(value.get<double>());
    return {length, length, length};
  }
  return {mm_from_m(value.at(0).get<double>()), mm_from_m(value.at(1).get<double>()), mm_from_m(value.at(2).get<double>())};
}

void set_side(SizeRange& range, Mm Size::*side, const json& value) {
  const auto [least, usual, greatest] = read_lengths(value);
  range.least.*side = least;
  range.usual.*side = usual;
  range.greatest.*side = greatest;
}

// Sides that `value` leaves out stay as in `range`.
SizeRange read_size(const json& value, SizeRange range = {}) {
  if (const auto w = value.find("w"); w != value.end()) set_side(range, &Size::width, *w);
  if (const auto d = value.find("d"); d != value.end()) set_side(range, &Size::depth, *d);
  if (const auto h = value.find("h"); h != value.end()) set_side(range, &Size::height, *h);
  return range;
}

void read_strings(const json& from, const char* key, std::vector<std::string>& to) {
  if (const auto found = from.find(key); found != from.end()) to = found->get<std::vector<std::string>>();
}

Side read_side(const std::string& name) {
  const auto side = side_from_name(name);
  if (!side) throw json::other_error::create(501, "there is no side \"" + name + "\"", nullptr);
  return *side;
}

Result<std::array<LinearFormula, 3>> read_corner(const json& value, int index) {
  std::array<LinearFormula, 3> corner;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    LAYOUTBOX_ASSIGN(corner[axis], parse_formula(value.at(axis).get_ref<const std::string&>(), index));
  }
  return corner;
}

Status read_spaces(const json& value, std::vector<SpaceFormula>& spaces) {
  for (const json& item : value) {
    const int count = item.value("repeat", 1);
    for (int i = 0; i < count; ++i) {
      SpaceFormula space;
      space.name = item.at("name").get<std::string>();
      if (const std::size_t place = space.name.find("{i}"); place != std::string::npos) space.name.replace(place, 3, std::to_string(i + 1));
      LAYOUTBOX_ASSIGN(space.min, read_corner(item.at("min"), i));
      LAYOUTBOX_ASSIGN(space.max, read_corner(item.at("max"), i));
      space.carries = item.value("carries", true);
      spaces.push_back(std::move(space));
    }
  }
  return {};
}

ShapeSpec read_shape(const json& value) {
  ShapeSpec shape;
  shape.family = value.at("family").get<std::string>();
  shape.symbol = value.value("symbol", std::string());
  if (const auto numbers = value.find("numbers"); numbers != value.end()) shape.numbers = numbers->get<std::map<std::string, double>>();
  if (const auto words = value.find("words"); words != value.end()) shape.words = words->get<std::map<std::string, std::string>>();
  return shape;
}

// "seat", or "-seat" where what it is a kind of is one and it is not.
Status read_traits(const json& names, CatalogEntry& entry) {
  for (const json& item : names) {
    std::string_view name = item.get_ref<const std::string&>();
    const bool lacks = name.starts_with('-');
    if (lacks) name.remove_prefix(1);
    const auto trait = trait_from_name(name);
    if (!trait) return fail(ErrorCode::kSchema, fmt::format("\"{}\" has the unknown trait \"{}\"", entry.id, name));
    (lacks ? entry.traits_lacked : entry.traits).set(*trait);
  }
  return {};
}

std::map<std::string, ShapeFamily::Word> read_shape_words(const json& from) {
  std::map<std::string, ShapeFamily::Word> words;
  const auto found = from.find("words");
  if (found == from.end()) return words;
  for (const auto& [name, item] : found->items()) {
    ShapeFamily::Word word;
    read_strings(item, "values", word.values);
    if (const auto usual = item.find("default"); usual != item.end()) word.usual = usual->get<std::string>();
    words.emplace(name, std::move(word));
  }
  return words;
}

ShapeFamily read_family(const json& value) {
  ShapeFamily family;
  family.symbol = value.value("symbol", std::string());
  if (const auto numbers = value.find("numbers"); numbers != value.end()) {
    for (const auto& [name, item] : numbers->items()) {
      ShapeFamily::Number number{item.at("range").at(0).get<double>(), item.at("range").at(1).get<double>(), {}};
      if (const auto usual = item.find("default"); usual != item.end()) number.usual = usual->get<double>();
      family.numbers.emplace(name, number);
    }
  }
  family.words = read_shape_words(value);
  return family;
}

Result<CatalogEntry> read_entry(const json& value) {
  CatalogEntry entry;
  entry.id = value.at("id").get<std::string>();
  entry.name = value.at("name").get<std::string>();
  read_strings(value, "synonyms", entry.synonyms);
  entry.kind_of = value.value("kindOf", std::string());
  if (const auto traits = value.find("traits"); traits != value.end()) LAYOUTBOX_CHECK(read_traits(*traits, entry));
  entry.size = read_size(value.at("size"));
  if (const auto variants = value.find("variants"); variants != value.end()) {
    for (const json& item : *variants) {
      SizeVariant variant;
      read_strings(item, "words", variant.words);
      variant.size = read_size(item.at("size"), entry.size);
      if (const auto spaces = item.find("spaces"); spaces != item.end()) LAYOUTBOX_CHECK(read_spaces(*spaces, variant.spaces));
      entry.variants.push_back(std::move(variant));
    }
  }
  const auto mount = mount_from_name(value.value("mount", std::string("floor")));
  if (!mount) return fail(ErrorCode::kSchema, fmt::format("\"{}\" has an unknown mount", entry.id));
  entry.mount = *mount;
  if (const auto sides = value.find("usedSides"); sides != value.end()) {
    for (const json& side : *sides) entry.used_sides.push_back(read_side(side.get<std::string>()));
  }
  entry.has_front = value.value("hasFront", true);
  entry.back_to_wall = value.value("backToWall", false);
  entry.thin = value.value("thin", false);
  entry.lain_on = value.value("lainOn", false);
  entry.top_carries = value.value("topCarries", false);
  if (const auto clearance = value.find("clearance"); clearance != value.end()) {
    for (const auto& [side, depth] : clearance->items()) entry.clearance[read_side(side)] = mm_from_m(depth.get<double>());
  }
  entry.hang_height = mm_from_m(value.value("hangHeight", 0.0));
  if (const auto spaces = value.find("spaces"); spaces != value.end()) LAYOUTBOX_CHECK(read_spaces(*spaces, entry.spaces));
  read_strings(value, "standsOn", entry.stands_on);
  read_strings(value, "faces", entry.faces);
  read_strings(value, "beside", entry.beside);
  read_strings(value, "rooms", entry.rooms);
  entry.shape = read_shape(value.at("shape"));
  entry.source = value.value("source", std::string());
  return entry;
}

RoomKind read_room(const json& value) {
  RoomKind room;
  room.id = value.at("id").get<std::string>();
  room.name = value.at("name").get<std::string>();
  read_strings(value, "synonyms", room.synonyms);
  const json& size = value.at("size");
  room.usual_size = {mm_from_m(size.at("w").get<double>()), mm_from_m(size.at("d").get<double>()), mm_from_m(size.at("h").get<double>())};
  for (const json& item : value.at("usual")) room.usual.emplace_back(item.at(0).get<std::string>(), item.at(1).get<int>());
  if (const auto needs = value.find("needs"); needs != value.end()) room.needs = needs->get<std::vector<std::vector<std::string>>>();
  room.door = value.value("door", std::string());
  return room;
}

}  // namespace

Status read_catalog_data(std::string_view text, CatalogData& data) {
  try {
    const json document = json::parse(text);
    if (const auto families = document.find("families"); families != document.end()) {
      for (const auto& [name, value] : families->items()) data.families.emplace(name, read_family(value));
      data.shape_words = read_shape_words(document);
    }
    if (const auto entries = document.find("entries"); entries != document.end()) {
      for (const json& value : *entries) {
        auto entry = read_entry(value);
        if (!entry) return Failure(std::move(entry).error());
        data.entries.push_back(std::move(*entry));
      }
    }
    if (const auto rooms = document.find("rooms"); rooms != document.end()) {
      for (const json& value : *rooms) data.rooms.push_back(read_room(value));
    }
  } catch (const json::exception& error) {
    return fail(ErrorCode::kSchema, fmt::format("the catalogue cannot be read: {}", error.what()));
  }
  return {};
}

Status read_checked_catalog_data(std::string_view text, CatalogData& data) {
  LAYOUTBOX_ASSIGN(const json document, parse_json(text));
  if (std::vector<Error> errors = check_against_schema(document, SchemaName::kCatalog); !errors.empty())
    return Failure(combined(std::move(errors)));
  return read_catalog_data(text, data);
}

void inherit_from_kinds(CatalogData& data) {
  std::map<std::string_view, const CatalogEntry*> by_id;
  for (const CatalogEntry& entry : data.entries) by_id.emplace(entry.id, &entry);
  std::vector<Traits> all;
  for (const CatalogEntry& entry : data.entries) {
    Traits traits = entry.traits, lacked = entry.traits_lacked;
    // The chain is short; the bound keeps a circle in somebody's data from hanging us.
    auto kind = by_id.find(entry.kind_of);
    for (int step = 0; step < 20 && kind != by_id.end(); ++step, kind = by_id.find(kind->second->kind_of)) {
      Traits more = kind->second->traits;
      more.remove(lacked);
      traits.add(more);
      lacked.add(kind->second->traits_lacked);
    }
    all.push_back(traits);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    CatalogEntry& entry = data.entries[i];
    entry.traits = all[i];
    const auto family = data.families.find(entry.shape.family);
    if (entry.shape.symbol.empty() && family != data.families.end()) entry.shape.symbol = family->second.symbol;
  }
}

}  // namespace layoutbox
