#include "layoutbox/plan/offline/room_reader.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/noun_phrase_parts.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/offline/word_sets.h"

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

// A size that is ours to choose gives way to a room whose size is said.
void fit(Opening& opening, const Room& room) {
  double longest = 0;
  for (std::size_t i = 0; i < room.polygon.size(); ++i) {
    const Point a = room.polygon[i], b = room.polygon[(i + 1) % room.polygon.size()];
    longest = std::max(longest, std::hypot(double(b.x - a.x), double(b.y - a.y)));
  }
  constexpr Mm kBeside = 200, kAbove = 100;
  if (longest > 2 * kBeside) opening.width = std::min(opening.width, (static_cast<Mm>(longest) - 2 * kBeside) / kGridMm * kGridMm);
  if (room.height > opening.sill + kAbove) opening.height = std::min(opening.height, room.height - kAbove - opening.sill);
}

// What the last one is across from is in the wall there.
void face_opening(Room& room) {
  const Opening& last = room.openings.back();
  for (Opening& other : room.openings) {
    if (other.type != last.type && other.wall.empty()) other.wall = wall_across(last.wall);
  }
}

void add_opening(SceneGraph& scene, OpeningType type, const NounPhrase& noun, const std::string& wall) {
  Opening opening = opening_said(type, noun);
  const auto number =
      std::count_if(scene.room.openings.begin(), scene.room.openings.end(), [&](const Opening& o) { return o.type == type; }) + 1;
  opening.id = std::string(name_of(type)) + std::to_string(number);
  opening.wall = wall_of_opening(wall, type, scene.room);
  if (!noun.size.any()) fit(opening, scene.room);
  opening.called = bare_name(noun);
  if (noun.in_middle) opening.place = "middle";
  if (!noun.near_corner.empty()) opening.place = noun.near_corner;
  scene.room.openings.push_back(std::move(opening));
}

}  // namespace

void add_assumed_opening(SceneGraph& scene, OpeningType type, const std::string& wall) {
  add_opening(scene, type, {}, wall);
  scene.room.openings.back().origin = Origin::kAssumed;
  scene.notes.push_back({"filled", std::string("a ") + std::string(name_of(type)) + " is assumed", "/room/openings"});
}

namespace {

// "a double door", "large windows", "the red door": what a default one is not.
bool is_described(OpeningType type, const NounPhrase& noun) {
  const Opening opening = opening_said(type, noun);
  return !opening.attributes.empty() || (noun.determiner != Determiner::kDefinite && !is_usual(opening));
}

// "no windows", "a windowless room"
bool wants_none(const Document& document, OpeningType type) {
  const bool door = type == OpeningType::kDoor;
  const NounKind kind = door ? NounKind::kDoor : NounKind::kWindow;
  const std::string_view word = door ? "doorless" : "windowless";
  const auto of_room = [&](const NounPhrase& room) {
    return std::ranges::find(room.attributes, word) != room.attributes.end() ||
           (!door && std::ranges::any_of(words_of(room.name), [](const std::string& w) { return one_of(w, WordSet::kWithoutDaylight); }));
  };
  return std::ranges::any_of(document.excluded, [&](const NounPhrase& noun) { return noun.kind == kind; }) ||
         std::ranges::any_of(document.rooms, of_room) ||  // not "a doorless wardrobe"
         (!door && std::ranges::any_of(document.tokens, [&](const Token& token) { return token.text == word; }));
}

// Those of that type whose size nobody gave take that of `like`.
void resize_openings(Room& room, const Opening& like) {
  for (Opening& opening : room.openings) {
    if (opening.type != like.type) continue;
    opening.width = like.width;
    opening.height = like.height;
  }
}

}  // namespace

namespace {

// Where the text puts a door or a window: the wall, and the corner there that it is near ("right").
struct PlacedOpening {
  const Mention* mention = nullptr;
  std::string wall, corner;
};
using PlacedOpenings = std::vector<PlacedOpening>;

OpeningType opening_type(const Mention& mention) {
  return mention.noun.kind == NounKind::kDoor ? OpeningType::kDoor : OpeningType::kWindow;
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

void set_kind(const Document& document, SceneGraph& scene) {
  Room& room = scene.room;
  std::vector<std::string> types;
  for (const NounPhrase& noun : document.rooms) {
    if (noun.kind != NounKind::kRoom) continue;
    const std::string type = room_type(noun);
    describe_room(noun, document, room);
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
  if (!types.empty()) room.type = types.front();
  if (types.size() > 1) {
    std::string all;
    for (const std::string& type : types) all += (all.empty() ? "" : ", ") + type;
    scene.notes.push_back({"ignored", "the text speaks of several rooms (" + all + "): all goes into one " + room.type, "prompt"});
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

void set_size(const Document& document, RoomSize size, SceneGraph& scene) {
  Room& room = scene.room;
  // "circular, about 6 metres across": one side says the other
  const bool even = room.shape == "round" || room.shape == "square";
  if (even && (size.width == 0 || size.depth == 0)) size.width = size.depth = std::max(size.width, size.depth);
  if (size.width > 0 && size.depth > 0) {
    Mm w = mm_from_m(size.width), d = mm_from_m(size.depth);
    // "long and narrow, 4.5 x 2.2 m": one comes in at a narrow end, and its long sides are the left and the right one.
    const bool by_sides = std::ranges::any_of(document.tokens, [](const Token& t) { return t.text == "left" || t.text == "right"; });
    if (room.shape == "long" && !document.niche && by_sides && w > d) std::swap(w, d);
    if (!document.niche && turns_by_walls(document, w, d)) std::swap(w, d);
    room.polygon = document.niche ? outline_with_niche(w, d, *document.niche) : room_outline(room.shape, w, d);
  } else if (size.area > 0) {
    room.area_m2 = size.area;
  }
  if (document.niche && room.polygon.empty())
    scene.notes.push_back({"ignored", "a niche is only made where the room's width and depth are given", "prompt"});
  if (size.height > 0) room.height = mm_from_m(size.height);
}

// Which wall a place says: "in the middle of the short wall", "opposite the door" (the one across from it).
std::string wall_said(const Link& link, const NounPhrase& by, NounKind of) {
  if (is_opening(by)) {
    const bool across = std::ranges::any_of(link.senses, [](const PhraseSense& sense) { return sense.type == RelationType::kOpposite; });
    return !across ? "" : by.kind == of ? "other" : "across";  // "a second door opposite the entrance"
  }
  const NounPhrase& wall = by.kind == NounKind::kCenter && by.of ? *by.of : by;
  const auto is_across = [&](std::string_view word) {
    return wall.wall_relation == word || std::ranges::find(wall.attributes, word) != wall.attributes.end();
  };
  if (wall.kind == NounKind::kWall && wall.wall_word.empty() && (is_across("opposite") || is_across("other")))
    return "other";  // "the door in the long wall, a window on the opposite wall"
  return wall.wall_word.empty() && wall.kind == NounKind::kWall ? length_word(wall) : wall.wall_word;
}

PlacedOpenings placed_openings(const Document& document) {
  PlacedOpenings placed;
  for (const Link& link : document.links) {
    for (const int target : link.targets) {
      const Mention& mention = document.mentions[static_cast<std::size_t>(target)];
      if (!is_opening(mention.noun)) continue;
      std::string wall = mention.noun.wall_word, corner;
      for (const int reference : link.references) {
        const NounPhrase& by = document.mentions[static_cast<std::size_t>(reference)].noun;
        const std::string said = wall_said(link, by, mention.noun.kind);
        // "windows in the left and back walls": of several one in each, as they are named.
        const bool many = openings_said(mention.noun) > 1 || mention.noun.plural;
        if (by.kind == NounKind::kWall && !said.empty() && !wall.empty() && wall != said && many) placed.push_back({&mention, wall, {}});
        if (!said.empty() || mention.noun.wall_word.empty()) wall = said;
        if (by.kind == NounKind::kCorner) corner = by.wall_word;
      }
      wall = wall.substr(0, wall.find(' '));
      // "in the north wall near the east corner": one door.
      const auto known = std::ranges::find_if(placed, [&](const PlacedOpening& p) { return p.mention == &mention; });
      const bool elsewhere = mention.noun.plural && known != placed.end() && corner.empty() && !wall.empty() && known->wall != wall;
      if (known == placed.end() || openings_said(mention.noun) > 1 || elsewhere) {
        placed.push_back({&mention, wall, corner});
      } else {
        if (!wall.empty() && (known->wall.empty() || corner.empty())) known->wall = wall;
        if (known->corner.empty()) known->corner = corner;
      }
    }
  }
  return placed;
}

// `across`: those that are across from another one, which comes first.
void put_openings(const PlacedOpenings& placed, bool across, SceneGraph& scene) {
  for (const PlacedOpening& place : placed) {
    const auto& [mention, wall, corner] = place;
    if ((wall == "other" || wall == "across") != across) continue;
    const OpeningType type = opening_type(*mention);
    const auto known = std::ranges::find_if(scene.room.openings, [&](const Opening& o) { return o.type == type; });
    // "a window at the end … opposite the door": the one that is there.
    if (wall == "across" && mention->noun.determiner == Determiner::kDefinite && known != scene.room.openings.end()) {
      if (known->wall.empty()) known->wall = wall_of_opening(wall, type, scene.room);
      continue;
    }
    // "two doors, one in the front wall and one in the left wall": shared out.
    const auto places = std::count_if(placed.begin(), placed.end(), [&, m = mention](const auto& p) { return p.mention == m; });
    const int said = openings_said(mention->noun), all = static_cast<int>(places);
    const bool first = &place == &*std::ranges::find(placed, mention, &PlacedOpening::mention);  // gets what is left over
    const int count = std::max(1, said / all + (first && said > all ? said % all : 0));
    for (int i = 0; i < std::min(count, 12); ++i) add_opening(scene, type, mention->noun, wall);
    Opening& last = scene.room.openings.back();
    if (!corner.empty() && count == 1) last.place = corner;
    if (wall == "across") face_opening(scene.room);
  }
}

// Doors and windows that the text brings in; those it only refers to are the default ones.
void add_openings(const Document& document, SceneGraph& scene) {
  const Room& room = scene.room;
  const PlacedOpenings placed = placed_openings(document);
  put_openings(placed, false, scene);
  for (const Mention& mention : document.mentions) {
    if (!is_opening(mention.noun)) continue;
    const OpeningType type = opening_type(mention);
    const bool said = std::any_of(placed.begin(), placed.end(), [&](const auto& p) { return p.mention == &mention; });
    const bool counted = mention.noun.count > 1 || (mention.noun.plural && mention.noun.determiner != Determiner::kDefinite);
    if (said || (!counted && !mention.noun.size.any() && mention.noun.wall_word.empty() && !is_described(type, mention.noun))) continue;
    // "The entrance is on the narrow side … The door to the yard is at the back": another one
    const Opening meant = opening_said(type, mention.noun);
    const bool anew = mention.noun.determiner != Determiner::kDefinite && !meant.attributes.empty();
    const auto same = [&](const Opening& o) {
      const std::string wall = wall_of_opening(mention.noun.wall_word, type, room);
      const bool other = leads_elsewhere(o, room) != leads_elsewhere(meant, room) || (anew && o.attributes != meant.attributes);
      return o.type == type && !other && (wall.empty() || o.wall.empty() || o.wall == wall);
    };
    const auto there = std::ranges::find_if(scene.room.openings, same);
    if (there != scene.room.openings.end()) {  // "there is a window in the back wall. The window is 2 m wide."
      if (there->attributes.empty()) there->attributes = meant.attributes;
      if (mention.noun.size.any()) resize_openings(scene.room, meant);
      continue;
    }
    const int count = openings_said(mention.noun);
    for (int i = 0; i < std::min(count, 12); ++i) add_opening(scene, type, mention.noun, mention.noun.wall_word);
  }
  put_openings(placed, true, scene);
}

// A door to the outside is no entrance.
bool is_there(OpeningType type, const Room& room) {
  return std::ranges::any_of(room.openings, [&](const Opening& o) { return o.type == type && !leads_elsewhere(o, room); });
}

// A wall that the text says nothing of, for a door to the outside: seen best, and not where one comes in.
std::string wall_to_outside(const Document& document, const Room& room) {
  for (const std::string_view word : {"back", "left", "right"}) {
    const bool said = std::ranges::any_of(document.mentions, [&](const Mention& m) { return m.noun.wall_word == word; }) ||
                      std::ranges::any_of(room.openings, [&](const Opening& o) { return o.wall == word; });
    if (!said) return std::string(word);
  }
  return {};
}

// The wall that a thing is said to be at; empty: none.
std::string wall_of_thing(const Document& document, int mention) {
  const Mention& thing = document.mentions[static_cast<std::size_t>(mention)];
  for (const Link& link : document.links) {
    for (const int target : link.targets) {
      const Mention& placed = document.mentions[static_cast<std::size_t>(target)];
      if (placed.items.empty() || placed.items != thing.items) continue;
      for (const int reference : link.references) {
        const NounPhrase& by = document.mentions[static_cast<std::size_t>(reference)].noun;
        if (by.kind == NounKind::kWall && !by.wall_word.empty()) return by.wall_word;
      }
    }
  }
  return {};
}

// "a bay window with a seat on the right wall": where the seat is.
std::string wall_of_seat_in_window(const Document& document) {
  for (std::size_t m = 0; m < document.mentions.size(); ++m) {
    const CatalogEntry* entry = document.mentions[m].noun.entry;
    if (entry == nullptr || !entry->is(Trait::kInWindow)) continue;
    if (const std::string wall = wall_of_thing(document, static_cast<int>(m)); !wall.empty()) return wall;
  }
  return {};
}

// One kind named, the other is still needed, where it is not said that there is none.
void add_needed_openings(const Document& document, SceneGraph& scene) {
  Room& room = scene.room;
  const bool outdoors = room.type == "balcony";
  const bool windowless = wants_none(document, OpeningType::kWindow) || outdoors, doorless = wants_none(document, OpeningType::kDoor);
  const PlacedOpenings placed = placed_openings(document);
  for (Opening& opening : room.openings) {
    const OpeningLook look = look_of(opening);
    if (look.bay && opening.wall.empty()) opening.wall = wall_of_seat_in_window(document);
    if ((look.outside || look.whole || look.bay) && opening.wall.empty()) opening.wall = wall_to_outside(document, room);
  }
  room.openings_given = windowless && doorless;
  if (!room.openings.empty() || windowless || doorless) {
    for (const OpeningType type : {OpeningType::kDoor, OpeningType::kWindow}) {
      if (is_there(type, room)) continue;
      if (type == OpeningType::kWindow ? windowless : doorless) continue;
      const bool across = !room.openings.empty() && std::ranges::any_of(placed, [](const auto& p) { return p.wall == "across"; });
      add_assumed_opening(scene, type, across ? wall_across(room.openings.front().wall) : std::string{});
      if (outdoors) room.openings.back().wall = "back", room.openings.back().attributes = {"glass"};  // where the house is
    }
  }
}

// A garage has a garage door, besides the one into the house where that is named.
void add_door_of_kind(const Catalog& catalog, SceneGraph& scene) {
  Room& room = scene.room;
  const RoomKind* kind = catalog.find_room(room.type);
  if (kind == nullptr || kind->door.empty()) return;
  const bool told = std::ranges::any_of(room.openings, [&](const Opening& o) {
    return o.type == OpeningType::kDoor && std::ranges::find(o.attributes, kind->door) != o.attributes.end();
  });
  // Of two doors that are named one is it.
  const auto doors = std::ranges::count(room.openings, OpeningType::kDoor, &Opening::type);
  if (told || doors > 1) return;
  NounPhrase door;
  door.attributes = {kind->door};
  add_opening(scene, OpeningType::kDoor, door, {});
  room.openings.back().origin = Origin::kAssumed;
  scene.notes.push_back({"filled", "a " + kind->door + " door is assumed", "/room/openings"});
}

bool is_shade(const std::string& word) {
  for (const WordList::Member shade : word_list("words_room").at("shades")) {
    if (shade.value.text() == word) return true;
  }
  return false;
}

// The materials and colours that a wall or a floor is said to have: "dark green", "exposed brick", "stone" of "a stone floor".
std::string finish_of(const Lexicon& lexicon, const Document& document, const NounPhrase& noun) {
  std::string material;
  const auto add = [&](const std::string& words) { material += (material.empty() ? "" : " ") + words; };
  // "soft yellow": what changes the colour goes with it.
  const auto add_shade = [&] {
    for (std::size_t i = noun.first; i + 1 < noun.last && i + 1 < document.tokens.size(); ++i) {
      const std::string& word = document.tokens[i].text;
      if (is_shade(word) && lexicon.find(document.tokens, i, WordClass::kColor).length == 0) return add(word);
    }
  };
  for (std::size_t a = 0; a < noun.attributes.size() && a < noun.attribute_classes.size(); ++a) {
    const bool color = noun.attribute_classes[a] == WordClass::kColor;
    if (color && material.empty()) add_shade();
    if (color || noun.attribute_classes[a] == WordClass::kMaterial) add(noun.attributes[a]);
  }
  // "white stone walls": of stone as well
  const bool colored = !material.empty() && std::ranges::find(noun.attribute_classes, WordClass::kMaterial) == noun.attribute_classes.end();
  for (std::size_t i = noun.first; colored && i < noun.last && i < document.tokens.size(); ++i) {
    const std::size_t length = lexicon.find(document.tokens, i, WordClass::kMaterial).length;
    if (length > 0 && lexicon.find(document.tokens, i, WordClass::kColor).length == 0) add(text_of(document.tokens, i, length));
  }
  for (std::size_t i = noun.first; material.empty() && i < noun.last && i < document.tokens.size(); ++i) {
    const Match color = lexicon.find(document.tokens, i, WordClass::kColor), stuff = lexicon.find(document.tokens, i, WordClass::kMaterial);
    if (const std::size_t length = std::max(color.length, stuff.length); length > 0)
      add(text_of(document.tokens, i, std::min(i + length, noun.last)));
  }
  if (material.empty() && noun.kind == NounKind::kFloor) {
    if (noun.name.find("wood") != std::string::npos) material = "wood";  // "hardwood floor": a name of its own
    if (noun.name.find("tatami") != std::string::npos) material = "tatami";
  }
  const auto said = [&](std::string_view word) { return std::ranges::find(noun.attributes, word) != noun.attributes.end(); };
  if (material.empty() && noun.kind == NounKind::kWall) material = said("dark") ? "dark gray" : said("bright") ? "white" : "";
  return material;
}

// "Brick wall, dark green paint": of two that are said of no wall the one that is said of one wall is on the back wall.
void set_walls(Room& room, const std::string& material, bool all, bool& all_before) {
  if (!room.wall_material.empty() && room.wall_material != material && all != all_before) {
    room.wall_looks.emplace_back("back", all ? room.wall_material : material);
    if (all) room.wall_material = material;
  } else {
    room.wall_material = material;
  }
  all_before = all_before || all;
}

void set_surfaces(const Lexicon& lexicon, const Document& document, Room& room) {
  bool all_walls = false;
  for (std::size_t m = 0; m < document.mentions.size(); ++m) {
    const NounPhrase& noun = document.mentions[m].noun;
    if (noun.kind != NounKind::kFloor && noun.kind != NounKind::kWall && noun.kind != NounKind::kCeiling) continue;
    const std::string material = finish_of(lexicon, document, noun);
    if (material.empty()) continue;
    if (noun.name == kWallsAndFloor && room.floor_material.empty()) room.floor_material = material;
    if (noun.kind == NounKind::kCeiling)
      room.ceiling_material = material;
    else if (noun.kind == NounKind::kFloor)
      room.floor_material = material.find("floor") == std::string::npos ? material + " floor" : material;
    else if (const std::string wall = single_wall(document, static_cast<int>(m), room); !wall.empty())
      room.wall_looks.emplace_back(wall, material);
    else if (noun.wall_relation.empty())
      set_walls(room, material, noun.plural, all_walls);
  }
}

}  // namespace

int thing_before_wall(const Document& document, int wall) {
  const NounPhrase& noun = document.mentions[static_cast<std::size_t>(wall)].noun;
  if (noun.kind != NounKind::kWall || !says_one_of(document, noun.last, {"behind"})) return -1;
  const auto thing = std::ranges::find_if(document.mentions, [&](const Mention& m) {
    return m.noun.first == noun.last + 1 && m.noun.kind == NounKind::kObject && !m.items.empty();
  });
  return thing == document.mentions.end() ? -1 : static_cast<int>(thing - document.mentions.begin());
}

std::string single_wall(const Document& document, int wall, const Room& room) {
  const NounPhrase& noun = document.mentions[static_cast<std::size_t>(wall)].noun;
  if (!noun.wall_word.empty()) return noun.wall_word;
  const int thing = thing_before_wall(document, wall);
  if (const std::string own = thing >= 0 ? wall_of_thing(document, thing) : std::string{}; !own.empty()) return own;
  const bool one = noun.determiner == Determiner::kIndefinite || noun.count == 1 || says_one_of(document, noun.first, {"one"}) ||
                   noun.name.find("accent") != std::string::npos || noun.name.find("feature") != std::string::npos;
  if (noun.plural || noun.count > 1 || !noun.wall_relation.empty() || (!one && thing < 0)) return {};
  // Seen best, and with nothing let into it that the text speaks of.
  for (const std::string_view word : {"back", "left", "right"}) {
    if (std::ranges::none_of(room.openings, [&](const Opening& o) { return o.wall == word; })) return std::string(word);
  }
  return "back";
}

void build_room(const Lexicon& lexicon, const Document& document, const RoomSize& size, SceneGraph& scene) {
  set_kind(document, scene);
  if (scene.room.shape.empty()) scene.room.shape = read_room_form(lexicon, document);
  set_size(document, size, scene);
  add_openings(document, scene);
  add_door_of_kind(lexicon.catalog(), scene);
  add_needed_openings(document, scene);
  set_surfaces(lexicon, document, scene.room);
}

}  // namespace layoutbox::offline
