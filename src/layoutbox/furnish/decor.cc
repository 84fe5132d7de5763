#include "layoutbox/furnish/decor.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "layoutbox/base/units.h"
#include "layoutbox/base/words.h"
#include "layoutbox/furnish/decor_colors.h"
#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/decor_style.h"
#include "layoutbox/furnish/palette.h"
#include "layoutbox/furnish/picture_subjects.h"
#include "layoutbox/furnish/prompt_words.h"
#include "layoutbox/furnish/room_look.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;

std::uint64_t hash(std::string_view text, std::uint64_t seed) {
  std::uint64_t h = 1469598103934665603ULL ^ (seed * 0x9E3779B97F4A7C15ULL);
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return h ^ (h >> 29);
}

template <class List>
const auto& one_of(const List& list, std::uint64_t number) {
  return list[static_cast<typename List::size_type>(number % list.size())];
}

const Json& room_data(std::string_view kind) {
  for (const auto& [kinds, room] : decor_data().at("looks").items()) {
    if (!kind.empty() && lists(kinds, kind)) return room;
  }
  return decor_data().at("looks").at("default");
}

// The value whose key "a b c" lists the word; empty where none does.
std::string value_listed(const Json& by_words, std::string_view word) {
  for (const auto& [words, value] : by_words.items()) {
    if (!word.empty() && lists(words, word)) return value.get<std::string>();
  }
  return "";
}

// The colours of a child's room, by whose it is.
const Json& child_palette(std::string_view prompt) {
  const Json& palettes = decor_data().at("child_palettes");
  for (const std::string& word : words_of(prompt)) {
    for (const auto& [words, colors] : palettes.items()) {
      if (lists(words, word)) return colors;
    }
  }
  return palettes.at("");
}

// "A shelf for the toys", "shelves stacked with jars": what the text says that shelves hold, by the word for them.
std::map<std::string, std::string, std::less<>> shelves_said(std::string_view prompt) {
  constexpr std::size_t kReach = 5;  // words from the shelf to what it holds
  const Json& holders = decor_data().at("shelf_holders");
  const std::string joins = holders.at("joins").get<std::string>(), nouns = holders.at("nouns").get<std::string>();
  std::map<std::string, std::string, std::less<>> said;
  for (std::size_t at = 0; at < prompt.size();) {
    const std::size_t end = std::min(prompt.find_first_of(",.;:!?\n", at), prompt.size());
    const std::vector<std::string> words = words_of(prompt.substr(at, end - at));
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
      if (!lists(nouns, words[i]) || !lists(joins, words[i + 1])) continue;
      for (std::size_t k = i + 2; k < std::min(words.size(), i + 2 + kReach); ++k) {
        std::string contents = value_listed(decor_data().at("shelf_words"), words[k]);
        if (!contents.empty()) said.emplace(singular_of(words[i]), std::move(contents));
      }
    }
    at = end + 1;
  }
  return said;
}

// Whether the text has one of the words of that list of decor.json.
bool says_one_of(std::string_view prompt, const char* list) {
  const std::string& listed = decor_data().at(list).get_ref<const std::string&>();
  return std::ranges::any_of(words_of(prompt), [&](const std::string& word) { return lists(listed, word); });
}

// A room for children, or a bedroom of one by the words of the text.
bool is_childs(const std::string& kind, std::string_view prompt) {
  const Json& children = decor_data().at("child_rooms");
  if (std::find(children.begin(), children.end(), kind) != children.end()) return true;
  return kind == "bedroom" && says_one_of(prompt, "child_words");
}

// The text without what only sounds worn: "shabby chic".
std::string without_not_worn(std::string text) {
  for (const Json& phrase : decor_data().at("not_worn")) {
    const std::string& words = phrase.get_ref<const std::string&>();
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words)) text.erase(at, words.size());
  }
  return text;
}

// "An abandoned ward", "a dark cellar": what is said of the whole room as it opens, by which it is darker or more worn.
void take_conditions(Decor& decor, std::string_view prompt) {
  constexpr std::size_t kLongestOpening = 80;  // characters
  const std::string text = without_not_worn(lower_case(prompt)),
                    opening = text.substr(0, std::min(text.find_first_of(":;.\n"), kLongestOpening));
  for (const Json& condition : decor_data().at("conditions")) {
    const std::string& where = condition.value("anywhere", false) ? text : opening;
    const bool said =
        std::ranges::any_of(condition.at("says"), [&](const Json& phrase) { return says_word(where, phrase.get<std::string>()); });
    if (!said) continue;
    decor.daylight = std::min(decor.daylight, condition.value("daylight", 1.0));
    decor.wear = std::max(decor.wear, condition.value("wear", 0.0));
  }
}

// The last words of the names of what stands in the room: "lamp" of a table lamp.
std::vector<std::string> things_of(const Layout& layout) {
  std::vector<std::string> heads;
  for (const PlacedObject& object : layout.objects) {
    const std::vector<std::string> words = words_of(object.name);
    if (!words.empty()) heads.push_back(words.back());
  }
  return heads;
}

// The colour that the text gives the largest of what stands in the room, else its walls; nothing where none is more than grey.
std::optional<Color> said_of_things(const Layout& layout) {
  constexpr double kLeast = 0.25, kVivid = 0.12;  // m², chroma
  std::optional<Color> said = layout.room.wall_material.empty() ? std::nullopt : read_wish(layout.room.wall_material).color;
  if (said && chroma_of(*said) < kVivid) said.reset();
  double largest = kLeast;
  for (const PlacedObject& object : layout.objects) {
    std::string look = object.material;
    for (const std::string& word : object.attributes) look += " " + word;
    const std::optional<Color> color = read_wish(look).color;
    const double area = m_from_mm(object.size.width) * m_from_mm(object.size.depth);
    if (!color || area < largest || chroma_of(*color) < kVivid) continue;
    said = color;
    largest = area;
  }
  return said;
}

// Woods, metal and colours of a style.
void take_style(Decor& decor, const RoomStyle& style) {
  decor.style = style.name;
  decor.woods = style.data->at("woods").get<std::vector<std::string>>();
  decor.metal = style.data->value("metal", decor.metal);
  decor.rug = style.data->value("rug", decor.rug);
  if (style.data->contains("leather")) decor.leather = read_wish(style.data->at("leather").get<std::string>()).color;
  if (style.data->contains("palette")) decor.accents = palette_of(style.data->at("palette"));
}

// "Snow outside the windows".
void take_view(Decor& decor, std::string_view prompt) {
  const std::string text = lower_case(prompt);
  for (const Json& view : decor_data().at("views")) {
    const bool said = std::ranges::any_of(view.at("says"), [&](const Json& phrase) { return says_word(text, phrase.get<std::string>()); });
    if (said) decor.view = view.at("window").get<std::string>();
  }
}

// Walls, skirtings, doors and windows of a style.
void take_shell(Decor& decor, const Json& style) {
  if (style.contains("wall")) {
    const Json& wall = style.at("wall");
    decor.wall_finish = (wall.is_array() ? one_of(wall, decor.chance >> 8) : wall).get<std::string>();
  }
  if (style.contains("feature")) decor.feature = read_wish(style.at("feature").get<std::string>()).color;
  decor.skirting = style.value("skirting", decor.skirting);
  decor.door = style.value("door", decor.door);
  decor.window = style.value("window", decor.window);
}

// The name of the floor's surface, so that the furniture can differ from it.
std::string floor_name(const std::string& asked) {
  const SurfaceWish wish = read_wish(asked);
  return wish.materials.empty() ? "" : wish.materials.front()->surface.name;
}

std::vector<std::string> woods_on(const std::string& floor, std::uint64_t chance) {
  std::vector<std::string> woods;
  const Json& all = decor_data().at("woods");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Json& wood = all[(i + chance) % all.size()];
    const Json& not_on = wood.at("not_on");
    if (std::find(not_on.begin(), not_on.end(), floor) == not_on.end()) woods.push_back(wood.at("name").get<std::string>());
  }
  return woods;
}

}  // namespace

std::string_view Decor::wood_for(std::string_view usual, std::uint64_t kind) const {
  // Painted white is what a style has that lists it; others have their wood instead.
  const bool painted = usual == "lacquer" && !style.empty() && !woods.empty() && std::ranges::find(woods, "lacquer") == woods.end() &&
                       woods.front() != "birch";
  if (painted) return woods.front();
  if (woods.empty() || (usual != "oak" && usual != "walnut")) return usual;
  // Most things are of the room's first wood; what is usually dark, and one kind in five, is of the next one that differs.
  const auto other = std::find_if(woods.begin(), woods.end(), [&](const std::string& wood) { return wood != woods.front(); });
  if (other != woods.end() && (usual == "walnut" || kind % 5 == 0)) return *other;
  return woods.front();
}

Decor decor_of(const Layout& layout, std::uint64_t seed) {
  // What edits add are further lines: they change what they speak of, not the whole room's colours.
  const std::uint64_t chance = hash(layout.prompt.substr(0, layout.prompt.find('\n')), seed);
  const std::string& kind = layout.room.type;
  const Json& room = room_data(kind);
  const bool plain = room.value("plain", false), tiled = room.value("tiled", false);
  const bool wet = tiled || lists(decor_data().at("colored_fronts").get_ref<const std::string&>(), kind);
  RoomStyle named = style_of(layout.prompt, things_of(layout));
  const bool dark = named.data == &decor_data().at("moods").at("dark");
  const Json changed = plain && named.data != nullptr ? in_plain_room(*named.data, wet) : Json();
  if (!changed.is_null()) named.data = &changed;
  const Json* style = named.data;
  Decor decor;
  decor.chance = chance;
  decor.parapet = room.value("parapet", false);
  decor.shelves = value_listed(decor_data().at("shelves"), kind);
  decor.cases = value_listed(decor_data().at("cases"), kind);
  decor.pictures = value_listed(decor_data().at("pictures"), kind);
  if (room.contains("wall")) decor.wall_finish = room.at("wall").get<std::string>();
  // A style that has walls of its own goes before what such rooms mostly look like.
  const bool strong = style != nullptr && (style->contains("wall") || style->value("own_floor", false));
  const bool own_floor = style != nullptr && style->contains("floors") && (strong || !plain);
  decor.floor = one_of(own_floor ? style->at("floors") : room.at("floors"), chance).get<std::string>();
  decor.wall = color_of_json(one_of(decor_data().at(plain ? "plain_walls" : "walls"), chance >> 8));
  const bool own_tiles = style != nullptr && style->contains("tiled_wall");
  if (tiled) decor.wall_finish = (own_tiles ? *style : decor_data()).at("tiled_wall").get<std::string>();
  const std::string& floor = layout.room.floor_material.empty() ? decor.floor : layout.room.floor_material;
  decor.woods = woods_on(floor_name(floor), chance >> 16);
  if (is_childs(kind, layout.prompt)) {
    decor.accents = palette_of(child_palette(layout.prompt));
    decor.pictures = says_one_of(layout.prompt, "grown_words") ? "" : "child";
    decor.woods = {"birch", "lacquer"};
  } else {
    decor.accents = accents_beside(said_of_things(layout), palette_of(one_of(decor_data().at("palettes"), chance >> 24)));
  }
  if (std::string theme = picture_theme(layout.prompt, decor.pictures == "child"); !theme.empty()) decor.pictures = std::move(theme);
  if (style != nullptr) take_style(decor, named);
  if (style != nullptr && style->contains("walls") && decor.wall_finish.empty())
    decor.wall = color_of_json(one_of(style->at("walls"), chance >> 8));
  if (style != nullptr) take_shell(decor, *style);
  take_conditions(decor, layout.prompt);
  take_view(decor, layout.prompt);
  decor.shelves_said = shelves_said(layout.prompt);
  decor.parts = part_looks(layout.prompt);
  take_room_look(decor, room_look(layout.prompt), kind, dark);
  if (style != nullptr && style->contains("parts")) {
    for (const auto& [part, look] : style->at("parts").items()) decor.parts.emplace(part, part_look_of(look.get<std::string>()));
  }
  decor.scheme_walls = decor.colors_said && !says_walls(layout.prompt);
  decor.of_things = thing_parts(layout);
  take_fittings(decor);
  suit_floor(decor, room, chance);
  if (const auto accents = decor.parts.find("accents"); accents != decor.parts.end() && !accents->second.colors.empty())
    decor.accents = accents->second.colors;
  return decor;
}

double wear_said(std::string_view text) {
  double wear = 0;
  for (const auto& [words, share] : decor_data().at("wear").items()) {
    for (const std::string& word : words_of(without_not_worn(lower_case(text)))) {
      if (lists(words, word)) wear = std::max(wear, share.get<double>());
    }
  }
  return wear;
}

std::string shelf_contents_named(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" ,", at), text.size());
    if (std::string found = value_listed(decor_data().at("shelf_words"), text.substr(at, end - at)); !found.empty()) return found;
    at = end + 1;
  }
  return "";
}

Decor decor_of_thing(const Decor& room, std::string_view text) {
  const RoomStyle style = style_of(text);
  if (style.data == nullptr) return room;
  Decor decor = room;
  take_style(decor, style);
  if (room.colors_said) decor.accents = room.accents;
  if (room.woods_said) decor.woods = room.woods;
  return decor;
}

}  // namespace layoutbox
