// Doors and windows that a room needs, or has by its kind, where the text says nothing of them.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/room/room_reader_parts.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

void add_assumed_opening(SceneGraph& scene, OpeningType type, const std::string& wall) {
  add_opening(scene, type, {}, wall);
  scene.room.openings.back().origin = Origin::kAssumed;
  scene.notes.push_back({"filled", std::string("a ") + std::string(name_of(type)) + " is assumed", "/room/openings"});
}

namespace {

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

}  // namespace

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

namespace {

// "a bay window with a seat on the right wall": where the seat is.
std::string wall_of_seat_in_window(const Document& document) {
  for (std::size_t m = 0; m < document.mentions.size(); ++m) {
    const CatalogEntry* entry = document.mentions[m].noun.entry;
    if (entry == nullptr || !entry->is(Trait::kInWindow)) continue;
    if (const std::string wall = wall_of_thing(document, static_cast<int>(m)); !wall.empty()) return wall;
  }
  return {};
}

// Windows that the text takes for a row: "a sofa under the windows", "a bench under two windows". `wall` is that of what stands there, or
// empty.
struct RowOfWindows {
  const Mention* windows = nullptr;
  std::string wall;
};
RowOfWindows row_of_windows(const Document& document) {
  for (std::size_t m = 0; m < document.mentions.size(); ++m) {
    const NounPhrase& noun = document.mentions[m].noun;
    if (noun.kind != NounKind::kWindow || !noun.is_plural() || !noun.wall_word.empty()) continue;
    for (const Link& link : document.links) {
      const bool under = std::ranges::any_of(link.senses, [](const PhraseSense& s) { return s.type == RelationType::kUnderWindow; });
      if (!under || link.targets.size() != 1 || std::ranges::find(link.references, static_cast<int>(m)) == link.references.end()) continue;
      if (document.mentions[static_cast<std::size_t>(link.targets.front())].items.size() == 1)
        return {&document.mentions[m], wall_of_thing(document, link.targets.front())};
    }
  }
  const auto definite = std::ranges::find_if(document.mentions, [](const Mention& m) {
    return m.noun.kind == NounKind::kWindow && m.noun.plural && m.noun.determiner == Determiner::kDefinite;
  });
  return definite == document.mentions.end() ? RowOfWindows{} : RowOfWindows{&*definite, {}};
}

// A row of windows is in one wall, where that is long enough and the text has put them nowhere.
void put_row_of_windows(const Document& document, SceneGraph& scene) {
  constexpr Mm kWallForTwo = 3000;
  const RowOfWindows row = row_of_windows(document);
  if (row.windows == nullptr) return;
  const std::string wall = row.wall.empty() ? wall_to_outside(document, scene.room) : row.wall;
  const auto is_window = [](const Opening& o) { return o.type == OpeningType::kWindow; };
  const Point extent = extent_of(scene.room);
  if (extent.x > 0 && (wall == "back" || wall == "front" ? extent.x : extent.y) < kWallForTwo) return;
  if (std::ranges::none_of(scene.room.openings, is_window)) {
    for (int i = 0; i < openings_said(row.windows->noun); ++i) add_opening(scene, OpeningType::kWindow, row.windows->noun, {});
  }
  for (Opening& opening : scene.room.openings) {
    if (is_window(opening) && opening.wall.empty()) opening.wall = wall;
  }
}

}  // namespace

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
  if (!windowless) put_row_of_windows(document, scene);
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

void add_door_of_kind(const Catalog& catalog, SceneGraph& scene) {
  Room& room = scene.room;
  const RoomKind* kind = catalog.find_room(room.type);
  if (kind == nullptr || kind->door.empty()) return;
  Opening usual;
  usual.type = OpeningType::kDoor, usual.attributes = {kind->door};
  const auto is_it = [&](const Opening& o) {
    const bool alike = look_of(usual).leaf != Leaf::kPanelled && look_of(o).leaf == look_of(usual).leaf;  // "a roll-up door"
    return alike || std::ranges::find(o.attributes, kind->door) != o.attributes.end();
  };
  const bool told = std::ranges::any_of(room.openings, [&](const Opening& o) { return o.type == OpeningType::kDoor && is_it(o); });
  // Of two doors that are named one is it.
  const auto doors = std::ranges::count(room.openings, OpeningType::kDoor, &Opening::type);
  if (told || doors > 1) return;
  NounPhrase door;
  door.attributes = {kind->door};
  add_opening(scene, OpeningType::kDoor, door, {});
  room.openings.back().origin = Origin::kAssumed;
  scene.notes.push_back({"filled", "a " + kind->door + " door is assumed", "/room/openings"});
}

}  // namespace layoutbox::offline
