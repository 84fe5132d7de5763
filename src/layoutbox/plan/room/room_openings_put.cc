// Doors and windows that the text puts into walls.
#include <algorithm>
#include <cmath>

#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/room/room_reader_parts.h"

namespace layoutbox::offline {

namespace {

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

}  // namespace

void add_opening(SceneGraph& scene, OpeningType type, const NounPhrase& noun, const std::string& wall) {
  Opening opening = opening_said(type, noun);
  const auto number =
      std::count_if(scene.room.openings.begin(), scene.room.openings.end(), [&](const Opening& o) { return o.type == type; }) + 1;
  opening.id = std::string(name_of(type)) + std::to_string(number);
  opening.wall = wall_of_opening(wall, type, scene.room);
  if (!noun.size.any()) fit(opening, scene.room);
  opening.called = bare_name(noun);
  opening.place = noun.place;
  scene.room.openings.push_back(std::move(opening));
}

namespace {

// "a double door", "large windows", "the red door": what a default one is not.
bool is_described(OpeningType type, const NounPhrase& noun) {
  const Opening opening = opening_said(type, noun);
  return !opening.attributes.empty() || (noun.determiner != Determiner::kDefinite && !is_usual(opening));
}

// Those of that type whose size nobody gave take that of `like`.
void resize_openings(Room& room, const Opening& like) {
  for (Opening& opening : room.openings) {
    if (opening.type != like.type) continue;
    opening.width = like.width;
    opening.height = like.height;
  }
}

// Windows of which so many are there already, brought in by what is told to be at them, are as many as are counted and look as is said.
void complete_openings(SceneGraph& scene, const NounPhrase& noun, const std::string& wall, OpeningType type, int known) {
  const Opening meant = opening_said(type, noun);
  for (Opening& opening : scene.room.openings) {
    if (opening.type != type || !is_usual(opening)) continue;
    opening.width = meant.width, opening.height = meant.height, opening.sill = meant.sill;
  }
  for (int i = known; i < std::min(openings_said(noun), 12); ++i) add_opening(scene, type, noun, wall);
}

OpeningType opening_type(const Mention& mention) {
  return mention.noun.kind == NounKind::kDoor ? OpeningType::kDoor : OpeningType::kWindow;
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

}  // namespace

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

namespace {

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
    if (!corner.empty() && count == 1) last.place.corner = corner;
    if (wall == "across") face_opening(scene.room);
  }
}

}  // namespace

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
      if (o.type != type || !(wall.empty() || o.wall.empty() || o.wall == wall)) return false;
      return leads_elsewhere(o, room) == leads_elsewhere(meant, room) && !(anew && o.attributes != meant.attributes);
    };
    const auto there = std::ranges::find_if(scene.room.openings, same);
    if (there != scene.room.openings.end()) {  // "there is a window in the back wall. The window is 2 m wide."
      if (there->attributes.empty()) there->attributes = meant.attributes;
      if (mention.noun.size.any()) resize_openings(scene.room, meant);
      // "by the north windows … Three tall windows north": as many as are counted.
      if (mention.noun.count > 1)
        complete_openings(scene, mention.noun, mention.noun.wall_word, type,
                          static_cast<int>(std::ranges::count_if(scene.room.openings, same)));
      continue;
    }
    const int count = openings_said(mention.noun);
    for (int i = 0; i < std::min(count, 12); ++i) add_opening(scene, type, mention.noun, mention.noun.wall_word);
  }
  put_openings(placed, true, scene);
}

}  // namespace layoutbox::offline
