#include "layoutbox/plan/room/room_reader.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/room/room_reader_parts.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

std::string room_type(const NounPhrase& noun) {
  if (noun.room != nullptr) return noun.room->id;
  // "gaming room", "this basement": the words themselves; "the room", "a space" say nothing.
  const bool plain = one_of(noun.head, WordSet::kPlainRooms);
  if (!plain) return snake_case(noun.head);
  if (noun.head != "room") return {};
  const std::vector<std::string> words = words_of(noun.name);
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i + 1] == "room" && one_of(words[i], WordSet::kRoomKinds)) return words[i] + "_room";
  }
  return {};
}

// Of an "L-shaped kitchen" the units stand in an L, unless the parts of the room have sizes.
bool means_its_units(const NounPhrase& noun, const Document& document) { return noun.head == "kitchen" && !document.niche; }

// "a small L-shaped room"
void describe_room(const NounPhrase& noun, const Document& document, Room& room) {
  for (const std::string& word : noun.attributes) {
    static constexpr std::pair<std::string_view, std::string_view> kWords[] = {
        {"small", "small"},         {"tiny", "tiny"},     {"compact", "compact"}, {"little", "small"}, {"narrow", "narrow"},
        {"medium-sized", "medium"}, {"medium", "medium"}, {"large", "large"},     {"big", "large"},    {"huge", "huge"},
        {"spacious", "spacious"},   {"cramped", "tiny"},  {"poky", "tiny"},       {"shoebox", "tiny"}, {"minuscule", "tiny"},
        {"grand", "large"},         {"vast", "vast"},     {"cozy", "cozy"}};
    for (const auto& [said, kept] : kWords) {
      if (word == said && room.size_word.empty()) room.size_word = kept;
    }
    static constexpr std::pair<std::string_view, std::string_view> kShapes[] = {
        {"l-shaped", "L"}, {"t-shaped", "T"}, {"u-shaped", "U"}, {"round", "round"}, {"circular", "round"}};
    for (const auto& [said, kept] : kShapes) {
      if (word == said && !means_its_units(noun, document)) room.shape = kept;
    }
  }
}

// "first apartment!! living room is 4 x 5 m": the room of the apartment, where that is no studio and nobody is to sleep there.
bool is_home_of(const Document& document, const std::vector<std::string>& types) {
  static constexpr std::string_view kRooms[] = {"living_room", "kitchen", "bathroom", "dining_room", "study", "hallway", "kids_room"};
  const auto home = std::ranges::find_if(document.rooms, [](const NounPhrase& r) { return r.room != nullptr; });
  if (types.front() != "studio_apartment" || home == document.rooms.end() || (home->head != "apartment" && home->head != "flat"))
    return false;
  const bool one_room = std::ranges::any_of(document.tokens, [](const Token& t) { return t.text == "studio" || t.text == "one"; });
  const bool sleeps = std::ranges::any_of(
      document.items, [](const TextItem& item) { return item.noun.entry != nullptr && item.noun.entry->is(Trait::kBed); });
  return types.size() == 2 && !one_room && !sleeps && std::ranges::find(kRooms, types[1]) != std::end(kRooms);
}

void set_kind(const Document& document, SceneGraph& scene) {
  Room& room = scene.room;
  std::vector<std::string> types;
  for (const NounPhrase& noun : document.rooms) {
    if (noun.kind != NounKind::kRoom || names_another_place(document, noun)) continue;
    const std::string type = room_type(noun);
    if (type.empty() || types.empty() || type == types.front()) describe_room(noun, document, room);  // not "a tiny kitchen" of a flat
    if (!type.empty() && std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
  }
  // "Our basement should become a cinema": what it is to be, not where it is.
  const auto where = [](const std::string& type) { return type == "basement" || type == "attic" || type == "garage"; };
  const bool has_own = !types.empty() && std::ranges::any_of(document.items, [&](const TextItem& item) {
    const CatalogEntry* entry = item.noun.entry;
    return entry != nullptr && !entry->rooms.empty() && entry->rooms.front() == types.front();
  });
  // ("a garage with a car in it and my workshop" is still a garage)
  if (types.size() > 1 && where(types.front()) && !has_own) std::rotate(types.begin(), types.begin() + 1, types.end());
  if (types.size() > 1 && is_home_of(document, types)) types.erase(types.begin());
  if (!types.empty()) room.type = types.front();
  if (types.size() > 1) {
    std::string all;
    for (const std::string& type : types) all += (all.empty() ? "" : ", ") + type;
    scene.notes.push_back({"warning", "the text speaks of several rooms (" + all + "): all goes into one " + room.type, "prompt"});
  }
}

// "6 by 4 m, two windows on the long right wall": what is said of the length of a wall says which side is which.
bool turns_by_walls(const Document& document, Mm width, Mm depth) {
  return std::ranges::any_of(document.mentions, [&](const Mention& mention) {
    const NounPhrase& wall = mention.noun;
    if (wall.kind != NounKind::kWall || wall.wall_word.empty()) return false;
    const std::string length = length_word(wall);
    const bool side = wall.wall_word == "left" || wall.wall_word == "right", end = wall.wall_word == "back" || wall.wall_word == "front";
    if (length.empty() || (!side && !end)) return false;
    return side == (length == "long") ? width > depth : width < depth;
  });
}

// "12 m long and 7 m wide, the altar at the east end": a room's ends are its narrow sides.
bool turns_by_ends(const Document& document, Mm width, Mm depth) {
  for (std::size_t i = 0; i + 1 < document.tokens.size(); ++i) {
    if (!says_one_of(document, i + 1, {"end", "ends"}) || (says_one_of(document, i + 2, {"of"}) && !says_one_of(document, i + 4, {"room"})))
      continue;
    if (says_one_of(document, i, {"east", "eastern", "west", "western"})) return width < depth;
    if (says_one_of(document, i, {"north", "northern", "south", "southern"})) return width > depth;
  }
  return false;
}

void set_size(const Document& document, RoomSize size, SceneGraph& scene) {
  Room& room = scene.room;
  // "circular, about 6 metres across": one side says the other
  const bool even = room.shape == "round" || room.shape == "square";
  if (even && (size.width == 0 || size.depth == 0)) size.width = size.depth = std::max(size.width, size.depth);
  if (size.width > 0 && size.depth > 0) {
    Mm w = mm_from_m(size.width), d = mm_from_m(size.depth);
    // "long and narrow, 4.5 x 2.2 m": one comes in at a narrow end, and its long sides are the left and the right one.
    const auto is_side = [](std::string_view word) { return word == "left" || word == "right"; };
    const bool by_sides =
        std::ranges::any_of(document.tokens, is_side, &Token::text) || std::ranges::any_of(document.bans, is_side, &Ban::of);
    if (room.shape == "long" && !document.niche && by_sides && w > d) std::swap(w, d);
    if (!document.niche && (turns_by_walls(document, w, d) || turns_by_ends(document, w, d))) std::swap(w, d);
    room.polygon = document.niche ? outline_with_niche(w, d, *document.niche) : room_outline(room.shape, w, d);
  } else if (size.area > 0) {
    room.area_m2 = size.area;
  }
  if (document.niche && room.polygon.empty())
    scene.notes.push_back({"ignored", "a niche is only made where the room's width and depth are given", "prompt"});
  if (size.height > 0) room.height = mm_from_m(size.height);
}

// "bookcases down both long walls": the sides of a room that one enters at a narrow end.
bool has_two_long_walls(const Document& document) {
  return std::ranges::any_of(document.mentions, [](const Mention& mention) {
    const NounPhrase& wall = mention.noun;
    return wall.kind == NounKind::kWall && wall.wall_word.empty() && (wall.plural || wall.determiner == Determiner::kBoth) &&
           length_word(wall) == "long";
  });
}

}  // namespace

void build_room(const Lexicon& lexicon, const Document& document, const RoomSize& size, SceneGraph& scene) {
  set_kind(document, scene);
  if (scene.room.shape.empty()) scene.room.shape = read_room_form(lexicon, document);
  if (scene.room.shape.empty() && size.width == 0 && has_two_long_walls(document)) scene.room.shape = "long";
  set_size(document, size, scene);
  add_openings(document, scene);
  add_door_of_kind(lexicon.catalog(), scene);
  add_needed_openings(document, scene);
  set_surfaces(lexicon, document, scene.room);
}

}  // namespace layoutbox::offline
