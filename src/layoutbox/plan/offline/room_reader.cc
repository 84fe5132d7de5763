#include "layoutbox/plan/offline/room_reader.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/offline/noun_phrase_parts.h"

namespace layoutbox::offline {
namespace {

using Class = WordClass;

std::string room_type(const NounPhrase& noun) {
  if (noun.room != nullptr) return noun.room->id;
  // "gaming room", "this basement": the words themselves; "the room", "a space" say nothing.
  static constexpr std::string_view kPlain[] = {"room",  "space", "interior", "layout",  "area",       "zone",     "place",
                                                "house", "home",  "scene",    "setting", "floor plan", "floorplan"};
  const bool plain = std::find(std::begin(kPlain), std::end(kPlain), noun.head) != std::end(kPlain);
  if (!plain) return snake_case(noun.head);
  if (noun.head != "room") return {};
  const std::vector<std::string> words = words_of(noun.name);
  static constexpr std::string_view kKinds[] = {
      "gaming",   "game",        "play",      "laundry",    "music",   "media",   "tv",         "sun",      "guest",
      "meeting",  "conference",  "class",     "waiting",    "storage", "utility", "craft",      "hotel",    "exam",
      "locker",   "show",        "break",     "board",      "mud",     "powder",  "reading",    "exercise", "yoga",
      "dressing", "theater",     "rec",       "recreation", "hobby",   "prayer",  "meditation", "server",   "staff",
      "lunch",    "examination", "treatment", "hospital",   "dorm",    "tea",     "billiard",   "home"};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i + 1] == "room" && std::find(std::begin(kKinds), std::end(kKinds), words[i]) != std::end(kKinds)) return words[i] + "_room";
  }
  return {};
}

void add_opening(SceneGraph& scene, OpeningType type, const NounPhrase& noun, const std::string& wall) {
  Opening opening = opening_said(type, noun);
  const auto number =
      std::count_if(scene.room.openings.begin(), scene.room.openings.end(), [&](const Opening& o) { return o.type == type; }) + 1;
  opening.id = std::string(name_of(type)) + std::to_string(number);
  opening.wall = wall;
  scene.room.openings.push_back(std::move(opening));
}

// "a double door", "large windows": what a default one is not.
bool is_described(const NounPhrase& noun) {
  static constexpr std::string_view kWords[] = {"double", "sliding", "large", "big", "wide", "small", "round", "floor-to-ceiling"};
  return noun.determiner != Determiner::kDefinite && std::any_of(noun.attributes.begin(), noun.attributes.end(), [](const std::string& a) {
           return std::find(std::begin(kWords), std::end(kWords), a) != std::end(kWords);
         });
}

// "no windows", "a windowless room"
bool wants_no_window(const Document& document) {
  const auto windowless = [](const NounPhrase& room) { return room.name.find("windowless") != std::string::npos; };
  return std::any_of(document.excluded.begin(), document.excluded.end(), [](const NounPhrase& n) { return n.kind == NounKind::kWindow; }) ||
         std::any_of(document.rooms.begin(), document.rooms.end(), windowless);
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

void settle_opening_sizes(Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    if (chunks[k].kind != ChunkKind::kNoun || (chunks[k].noun.kind != NounKind::kDoor && chunks[k].noun.kind != NounKind::kWindow))
      continue;
    bool placed = false;  // "two windows in the back wall, each 2 m wide"
    for (std::size_t n = k + 1; n < chunks.size(); ++n) {
      Chunk& next = chunks[n];
      if (next.kind == ChunkKind::kSize && !placed) {
        chunks[k].noun.size = next.size;
        next.kind = ChunkKind::kIgnored;
        for (std::size_t i = next.first; i < next.last; ++i) {
          document.readings[i].use = WordReading::Use::kUsed;
          document.readings[i].role = "size of the opening";
        }
        break;
      }
      const bool each = next.kind == ChunkKind::kNoun && next.noun.kind == NounKind::kMember;
      if (each && next.noun.size.any()) {  // "each 2 m wide"
        chunks[k].noun.size = next.noun.size;
        next.kind = ChunkKind::kIgnored;
        break;
      }
      placed |= next.kind == ChunkKind::kRelation;
      if (placed && next.kind == ChunkKind::kNoun && next.noun.kind == NounKind::kWall) continue;
      if (next.kind != ChunkKind::kIgnored && next.kind != ChunkKind::kRelation && next.kind != ChunkKind::kComma &&
          next.kind != ChunkKind::kVerb && !each)
        break;
    }
  }
}

// "a window to the east", "the entrance is on the left", "the window faces south": which wall.
void settle_opening_walls(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  const auto passed = [&](std::size_t n) {
    return n < chunks.size() && (chunks[n].kind == ChunkKind::kIgnored || chunks[n].kind == ChunkKind::kVerb ||
                                 chunks[n].kind == ChunkKind::kParticiple || chunks[n].kind == ChunkKind::kSize);
  };
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    NounPhrase& noun = chunks[k].noun;
    if (chunks[k].kind != ChunkKind::kNoun || (noun.kind != NounKind::kDoor && noun.kind != NounKind::kWindow)) continue;
    std::size_t n = k + 1;
    while (passed(n)) ++n;
    if (n >= chunks.size() || chunks[n].kind != ChunkKind::kRelation) continue;
    const std::size_t first = n++;
    while (n < chunks.size() && chunks[n].kind == ChunkKind::kIgnored) ++n;
    if (n < chunks.size() && chunks[n].kind == ChunkKind::kNoun) continue;
    for (std::size_t i = chunks[first].first; i < chunks[n - 1].last; ++i) {
      const Match side = lexicon.find(document.tokens, i, Class::kWallWord);
      if (side.length == 0) continue;
      noun.wall_word = meaning_of(side, Class::kWallWord)->word;
      for (std::size_t c = first; c < n; ++c) chunks[c].kind = ChunkKind::kIgnored;
      break;
    }
  }
}

Opening opening_said(OpeningType type, const NounPhrase& noun) {
  Opening opening;
  opening.type = type;
  const auto said = [&](std::string_view word) {
    return std::find(noun.attributes.begin(), noun.attributes.end(), word) != noun.attributes.end();
  };
  if (type == OpeningType::kWindow) {
    opening.width = said("large") || said("big") || said("wide") ? 1800 : said("small") ? 800 : 1200;
    opening.height = 1200;
    opening.sill = 900;
    opening.swing = Swing::kNone;
    if (noun.name.find("floor to ceiling") != std::string::npos || noun.name.find("floor-to-ceiling") != std::string::npos)
      opening.sill = 100, opening.height = 2200;
  } else {
    opening.width = said("double") ? 1600 : 900;
    opening.height = 2000;
    if (said("sliding")) opening.swing = Swing::kSliding;
  }
  if (noun.size.span) opening.width = mm_from_m(*noun.size.span);
  if (noun.size.either && noun.size.depth) opening.height = mm_from_m(*noun.size.depth);
  if (noun.size.length) opening.width = mm_from_m(*noun.size.length);
  if (noun.size.width) opening.width = mm_from_m(*noun.size.width);
  if (noun.size.height) opening.height = mm_from_m(*noun.size.height);
  return opening;
}

void build_room(const Lexicon& lexicon, const Document& document, const RoomSize& size, SceneGraph& scene) {
  Room& room = scene.room;
  std::vector<std::string> types;
  for (const NounPhrase& noun : document.rooms) {
    const std::string type = room_type(noun);
    const bool mentioned = noun.kind == NounKind::kRoom;
    if (!mentioned) continue;
    for (const std::string& word : noun.attributes) {
      static constexpr std::pair<std::string_view, std::string_view> kWords[] = {
          {"small", "small"},         {"tiny", "tiny"},     {"compact", "compact"}, {"little", "small"}, {"narrow", "narrow"},
          {"medium-sized", "medium"}, {"medium", "medium"}, {"large", "large"},     {"big", "large"},    {"huge", "huge"},
          {"spacious", "spacious"},   {"grand", "large"},   {"vast", "vast"},       {"cozy", "cozy"}};
      for (const auto& [said, kept] : kWords) {
        if (word == said && room.size_word.empty()) room.size_word = kept;
      }
      static constexpr std::pair<std::string_view, std::string_view> kShapes[] = {
          {"l-shaped", "L"}, {"t-shaped", "T"}, {"u-shaped", "U"}, {"round", "round"}, {"circular", "round"}};
      for (const auto& [said, kept] : kShapes) {
        if (word == said) room.shape = kept;
      }
    }
    if (!type.empty() && std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
  }
  if (!types.empty()) room.type = types.front();
  if (types.size() > 1) {
    std::string all;
    for (const std::string& type : types) all += (all.empty() ? "" : ", ") + type;
    scene.notes.push_back({"ignored", "the text speaks of several rooms (" + all + "): all goes into one " + room.type, "prompt"});
  }
  if (size.width > 0 && size.depth > 0) {
    const Mm w = mm_from_m(size.width), d = mm_from_m(size.depth);
    room.polygon = document.niche ? outline_with_niche(w, d, *document.niche) : room_outline(room.shape, w, d);
  } else if (size.area > 0) {
    room.area_m2 = size.area;
  }
  if (document.niche && room.polygon.empty())
    scene.notes.push_back({"ignored", "a niche is only made where the room's width and depth are given", "prompt"});
  if (size.height > 0) room.height = mm_from_m(size.height);

  // Doors and windows that the text brings in; those it only refers to are the default ones.
  std::vector<std::pair<const Mention*, std::string>> placed;
  for (const Link& link : document.links) {
    for (const int target : link.targets) {
      const Mention& mention = document.mentions[static_cast<std::size_t>(target)];
      if (mention.noun.kind != NounKind::kDoor && mention.noun.kind != NounKind::kWindow) continue;
      std::string wall = mention.noun.wall_word;
      for (const int reference : link.references) wall = document.mentions[static_cast<std::size_t>(reference)].noun.wall_word;
      placed.emplace_back(&mention, wall.substr(0, wall.find(' ')));
    }
  }
  for (const auto& [mention, wall] : placed) {
    const OpeningType type = mention->noun.kind == NounKind::kDoor ? OpeningType::kDoor : OpeningType::kWindow;
    // "two doors, one in the front wall and one in the left wall": shared out.
    const auto places = std::count_if(placed.begin(), placed.end(), [&, m = mention](const auto& p) { return p.first == m; });
    const int all = mention->noun.count > 0 ? mention->noun.count : mention->noun.plural ? 2 : 1;
    const int count = std::max(1, all / static_cast<int>(places));
    for (int i = 0; i < std::min(count, 12); ++i) add_opening(scene, type, mention->noun, wall);
  }
  for (const Mention& mention : document.mentions) {
    if (mention.noun.kind != NounKind::kDoor && mention.noun.kind != NounKind::kWindow) continue;
    const bool said = std::any_of(placed.begin(), placed.end(), [&](const auto& p) { return p.first == &mention; });
    const bool counted = mention.noun.count > 1 || (mention.noun.plural && mention.noun.determiner != Determiner::kDefinite);
    if (said || (!counted && !mention.noun.size.any() && mention.noun.wall_word.empty() && !is_described(mention.noun))) continue;
    const OpeningType type = mention.noun.kind == NounKind::kDoor ? OpeningType::kDoor : OpeningType::kWindow;
    const bool there = std::any_of(room.openings.begin(), room.openings.end(), [&](const Opening& o) { return o.type == type; });
    if (there) {  // "there is a window in the back wall. The window is 2 m wide."
      if (mention.noun.size.any()) resize_openings(room, opening_said(type, mention.noun));
      continue;
    }
    const int count = mention.noun.count > 0 ? mention.noun.count : counted ? 2 : 1;
    for (int i = 0; i < std::min(count, 12); ++i) add_opening(scene, type, mention.noun, mention.noun.wall_word);
  }
  // One kind named, the other is still needed; nobody wants to do without a door.
  const bool windowless = wants_no_window(document);
  if (!room.openings.empty() || windowless) {
    for (const OpeningType type : {OpeningType::kDoor, OpeningType::kWindow}) {
      if (std::any_of(room.openings.begin(), room.openings.end(), [&](const Opening& o) { return o.type == type; })) continue;
      if (type == OpeningType::kWindow && windowless) continue;
      add_opening(scene, type, {}, {});
      room.openings.back().origin = Origin::kAssumed;
      scene.notes.push_back({"filled", std::string("a ") + std::string(name_of(type)) + " is assumed", "/room/openings"});
    }
  }
  // Floor and walls.
  for (const Mention& mention : document.mentions) {
    const NounPhrase& noun = mention.noun;
    if (noun.kind != NounKind::kFloor && noun.kind != NounKind::kWall) continue;
    std::string material;
    for (std::size_t a = 0; a < noun.attributes.size(); ++a) {
      if (a < noun.attribute_classes.size() &&
          (noun.attribute_classes[a] == Class::kColor || noun.attribute_classes[a] == Class::kMaterial))
        material += (material.empty() ? "" : " ") + noun.attributes[a];
    }
    if (noun.kind == NounKind::kFloor && material.empty() && noun.name.find("hardwood") != std::string::npos) material = "wood";
    if (material.empty()) continue;
    if (noun.kind == NounKind::kFloor)
      room.floor_material = material + " floor";
    else if (noun.wall_word.empty() && noun.wall_relation.empty())
      room.wall_material = material;
  }
  (void)lexicon;
}

}  // namespace layoutbox::offline
