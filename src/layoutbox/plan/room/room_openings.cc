// What the text says of doors and windows: their sizes, their looks, the walls that words stand for.
#include <algorithm>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {

namespace {

// Everything that a noun phrase says of a door or a window, as one text.
std::string words_of_opening(const NounPhrase& noun) {
  std::string words = noun.name;
  for (const std::string& attribute : noun.attributes) words += " " + attribute;
  return words;
}

// "Floor-to-ceiling windows" of no said number are the front of a room: one from wall to wall.
bool is_front(OpeningType type, const NounPhrase& noun) {
  const std::string words = words_of_opening(noun);
  const auto says = [&](std::string_view word) { return words.find(word) != std::string::npos; };
  return type == OpeningType::kWindow && noun.plural && noun.count == 0 &&
         (says("floor to ceiling") || says("floor-to-ceiling") || says("full height") || says("full-height"));
}

// What of it changes its look: phrases of the table, colours and materials ("black-framed").
std::vector<std::string> looks_said(OpeningType type, const NounPhrase& noun) {
  std::vector<std::string> looks = look_words(type, words_of_opening(noun));
  if (is_front(type, noun)) looks.emplace_back("window front");
  for (std::size_t a = 0; a < noun.attributes.size(); ++a) {
    const bool framed = noun.attributes[a].ends_with("framed");
    const bool plain = a < noun.attribute_classes.size() &&
                       (noun.attribute_classes[a] == WordClass::kColor || noun.attribute_classes[a] == WordClass::kMaterial);
    const bool known = std::ranges::any_of(looks, [&](const std::string& look) { return look == noun.attributes[a]; });
    if ((framed || plain) && !known) looks.push_back(noun.attributes[a]);
  }
  return looks;
}
}  // namespace

std::string length_word(const NounPhrase& wall) {
  const auto said = [&](std::string_view word) {
    return (" " + wall.name + " ").find(" " + std::string(word) + " ") != std::string::npos ||
           std::find(wall.attributes.begin(), wall.attributes.end(), word) != wall.attributes.end();
  };
  if (said("long") || said("longer") || said("longest")) return "long";
  return said("short") || said("shorter") || said("shortest") || said("narrow") ? "short" : "";
}

Point extent_of(const Room& room) {
  Point extent{0, 0};
  for (const Point& corner : room.polygon) extent = {std::max(extent.x, corner.x), std::max(extent.y, corner.y)};
  return extent;
}

std::pair<std::string, std::string> walls_by_length(const NounPhrase& noun, const Room& room) {
  const std::string word = length_word(noun);
  if (word.empty()) return {};
  const auto [width, depth] = extent_of(room);
  // A room of no said size is at least as wide as deep, unless it is said to be long.
  const bool wide = width > 0 ? width >= depth : room.shape != "long";
  if (wide == (word == "long")) return {"back", "front"};
  return {"left", "right"};
}

// "French doors", "double doors", "sliding doors": one opening, whose leaves they are.
int openings_said(const NounPhrase& noun) {
  if (noun.wall_word == "ends" || noun.wall_word == "lengths") return std::max(2, noun.count);  // "a window at both ends"
  const bool glass = noun.kind == NounKind::kWindow && opening_look(OpeningType::kWindow, {words_of_opening(noun)}).whole;
  if (noun.count == 0 && glass && noun.plural && noun.name.ends_with("walls")) return 3;  // all but the one with the door
  if (noun.count == 0 && (glass || (noun.kind == NounKind::kWindow && is_front(OpeningType::kWindow, noun)))) return 1;
  if (noun.kind == NounKind::kDoor && noun.plural) {
    const OpeningLook look = opening_look(OpeningType::kDoor, {words_of_opening(noun)});
    const bool of_leaves = look.leaves == 2 || look.slides || look.leaf == Leaf::kGlazed;
    if (of_leaves && (noun.count == 0 || noun.name.find("double") != std::string::npos)) return 1;
  }
  return noun.count > 0 ? noun.count : noun.plural ? 2 : 1;
}

void settle_opening_sizes(Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    if (chunks[k].kind != ChunkKind::kNoun || (chunks[k].noun.kind != NounKind::kDoor && chunks[k].noun.kind != NounKind::kWindow))
      continue;
    bool placed = false;  // "two windows in the back wall, each 2 m wide", "…, 1.5 m wide"
    for (std::size_t n = k + 1; n < chunks.size(); ++n) {
      Chunk& next = chunks[n];
      const bool aside = chunks[n - 1].kind == ChunkKind::kComma;
      if (next.kind == ChunkKind::kSize && (!placed || aside)) {
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

// "a door 90 cm wide opening outwards", "the door swings out": until another thing is named.
void settle_door_swings(Document& document) {
  constexpr std::size_t kWords = 10;
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    NounPhrase& door = document.chunks[k].noun;
    if (document.chunks[k].kind != ChunkKind::kNoun || door.kind != NounKind::kDoor) continue;
    const auto next = std::find_if(document.chunks.begin() + static_cast<std::ptrdiff_t>(k) + 1, document.chunks.end(), [](const Chunk& c) {
      return c.kind == ChunkKind::kStop ||
             (c.kind == ChunkKind::kNoun && (c.noun.kind == NounKind::kObject || c.noun.kind == NounKind::kWindow));
    });
    const std::size_t end = next == document.chunks.end() ? document.tokens.size() : next->first;
    for (std::size_t i = door.first; i + 1 < std::min(end, door.last + kWords); ++i) {
      if (says_one_of(document, i, {"open", "opens", "opening", "swinging"}) &&
          says_one_of(document, i + 1, {"out", "outward", "outwards"}))
        door.attributes.emplace_back("outwards");
    }
  }
}

std::string bare_name(const NounPhrase& noun) {
  std::string_view name = noun.name;
  for (const std::string_view article : {"the ", "a ", "an ", "this ", "that ", "one ", "single "}) {
    if (name.starts_with(article)) name.remove_prefix(article.size());
  }
  return std::string(name);
}

std::string wall_across(std::string_view wall) {
  static constexpr std::pair<std::string_view, std::string_view> kAcross[] = {
      {"front", "back"}, {"back", "front"}, {"left", "right"}, {"right", "left"}};
  const auto* found = std::ranges::find(kAcross, wall, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kAcross) ? std::string{} : std::string(found->second);
}

std::string wall_of_opening(const std::string& word, OpeningType type, const Room& room) {
  if (word == "across") {  // from the door, or from the window
    auto by = std::ranges::find_if(room.openings, [&](const Opening& opening) { return opening.type != type; });
    if (by == room.openings.end() && type == OpeningType::kDoor) by = room.openings.begin();  // "a second door opposite the entrance"
    const std::string wall = by == room.openings.end() ? std::string{} : wall_across(by->wall);
    return !wall.empty() ? wall : type == OpeningType::kWindow ? "back" : "front";
  }
  if (word == "sides") {  // "windows on two sides": one each, those first that the picture shows
    for (const std::string_view side : {"back", "left", "right"}) {
      if (std::ranges::none_of(room.openings, [&](const Opening& opening) { return opening.wall == side; })) return std::string(side);
    }
    return {};
  }
  if (word == "same") return room.openings.empty() ? "back" : room.openings.back().wall;
  if (word == "other") return room.openings.empty() ? std::string{} : wall_across(room.openings.back().wall);
  if (word != "short" && word != "long" && word != "ends" && word != "lengths") return word;
  NounPhrase wall;
  wall.name = word == "long" || word == "lengths" ? "long wall" : "short wall";
  const auto [one, other] = walls_by_length(wall, room);
  const auto taken_at = [&](const std::string& side) { return std::ranges::count(room.openings, side, &Opening::wall); };
  if (word == "ends" || word == "lengths") return taken_at(one) > taken_at(other) ? other : one;
  const bool taken = taken_at(other) > 0;
  return type == OpeningType::kWindow || taken ? one : other;
}

Opening opening_said(OpeningType type, const NounPhrase& noun) {
  const OpeningLook look = opening_look(type, {words_of_opening(noun), is_front(type, noun) ? "window front" : ""});
  const bool window = type == OpeningType::kWindow;
  Opening opening;
  opening.type = type;
  opening.attributes = looks_said(type, noun);
  opening.swing = window ? Swing::kNone : look.slides ? Swing::kSliding : look.outward ? Swing::kOutLeft : Swing::kInLeft;
  const Mm usual = window ? 1200 : openings_said(noun) == 1 && noun.plural ? 1600 : 900;
  opening.width = look.width.value_or(usual);
  opening.height = look.height.value_or(window ? 1200 : 2000);
  opening.sill = look.sill.value_or(window ? 900 : 0);
  if (noun.size.span) opening.width = mm_from_m(*noun.size.span);
  if (noun.size.either && noun.size.depth) opening.height = mm_from_m(*noun.size.depth);
  if (noun.size.length) opening.width = mm_from_m(*noun.size.length);
  if (noun.size.width) opening.width = mm_from_m(*noun.size.width);
  if (noun.size.height) opening.height = mm_from_m(*noun.size.height);
  constexpr Mm kUsualTop = 2400;  // no higher than ceilings mostly are: a tall window begins lower
  if (noun.sill)
    opening.sill = mm_from_m(*noun.sill);
  else if (window && !look.sill)
    opening.sill = std::clamp<Mm>(kUsualTop - opening.height, 50, opening.sill);
  return opening;
}

bool is_usual(const Opening& opening) {
  const Opening usual = opening_said(opening.type, {});
  return opening.attributes.empty() && opening.width == usual.width && opening.height == usual.height && opening.sill == usual.sill &&
         opening.swing == usual.swing;
}

bool leads_elsewhere(const Opening& opening, const Room& room) {
  const OpeningLook look = look_of(opening);
  const bool into_itself = std::ranges::any_of(opening.attributes, [&](const std::string& word) { return word == room.type; });
  return look.outside || (look.onward && !into_itself);  // "the bathroom door" of a bathroom is its entrance
}

}  // namespace layoutbox::offline
