// What the text says of doors and windows: their sizes, their walls.
#include <algorithm>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/plan/offline/noun_phrase_parts.h"
#include "layoutbox/plan/offline/room_reader.h"

namespace layoutbox::offline {

namespace {
using Class = WordClass;

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
    const bool plain =
        a < noun.attribute_classes.size() && (noun.attribute_classes[a] == Class::kColor || noun.attribute_classes[a] == Class::kMaterial);
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
  if (noun.wall_word == "ends" || noun.wall_word == "lengths") return 2;  // "a window at both ends"
  const bool glass = noun.kind == NounKind::kWindow && opening_look(OpeningType::kWindow, {words_of_opening(noun)}).whole;
  if (noun.count == 0 && (glass || (noun.kind == NounKind::kWindow && is_front(OpeningType::kWindow, noun)))) return 1;
  if (noun.kind == NounKind::kDoor && noun.plural) {
    const OpeningLook look = opening_look(OpeningType::kDoor, {words_of_opening(noun)});
    const bool of_leaves = look.leaves == 2 || look.slides;
    if (of_leaves && (noun.count == 0 || noun.name.find("double") != std::string::npos)) return 1;
  }
  return noun.count > 0 ? noun.count : noun.plural ? 2 : 1;
}

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

namespace {

// "the door to the bakehouse is at the back": where the door leads, in the two chunks from n on.
void leave_out_where_it_leads(Document& document, NounPhrase& door, std::size_t n) {
  std::vector<Chunk>& chunks = document.chunks;
  const bool leads = n + 1 < chunks.size() && chunks[n].first + 1 == chunks[n].last && document.tokens[chunks[n].first].text == "to" &&
                     chunks[n + 1].kind == ChunkKind::kNoun &&
                     (chunks[n + 1].noun.kind != NounKind::kObject || !chunks[n + 1].noun.exact) &&
                     chunks[n + 1].noun.kind != NounKind::kWall;
  if (!leads) return;
  if (opening_look(OpeningType::kDoor, {chunks[n + 1].noun.head}).outside) door.attributes.push_back(chunks[n + 1].noun.head);
  for (std::size_t c = n; c < n + 2; ++c) {
    chunks[c].kind = ChunkKind::kIgnored;
    for (std::size_t i = chunks[c].first; i < chunks[c].last; ++i) {
      document.readings[i].use = WordReading::Use::kIgnored;
      document.readings[i].role = "where the door leads";
    }
  }
}

}  // namespace

namespace {

// What is said of an opening's place where no wall is named: "entrance south", "window (east)", "the door is on the front", "man door
// back right corner".
struct SideSaid {
  std::string wall, corner;
  std::size_t last = 0;  // the token behind it; 0: nothing is said
};
SideSaid side_said_at(const Lexicon& lexicon, const Document& document, std::size_t i) {
  const std::vector<Token>& tokens = document.tokens;
  const auto is = [&](std::initializer_list<std::string_view> words) { return says_one_of(document, i, words); };
  const bool bracket = is({"("});
  if (bracket) ++i;
  // "the balcony door, which takes almost all the right wall"
  const bool relative = is({","}) && says_one_of(document, i + 1, {"which", "that"}) &&
                        says_one_of(document, i + 2, {"takes", "occupies", "fills", "covers", "spans", "is", "are"});
  if (relative) i += 3;
  while (relative && is({"up", "almost", "nearly", "all", "most", "of", "whole", "entire"})) ++i;
  while (is({"is", "are", "on", "at", "in", "to", "the", "located", "placed", "situated"})) ++i;
  const auto side_at = [&](std::size_t at) { return at < tokens.size() ? lexicon.find(tokens, at, Class::kWallWord) : Match{}; };
  const Match side = side_at(i);
  if (side.length == 0) return {};
  SideSaid said{std::string(meaning_of(side, Class::kWallWord)->word), {}, i + side.length};
  i = said.last;
  if (const Match second = side_at(i); second.length > 0) {
    said.corner = meaning_of(second, Class::kWallWord)->word;
    i += second.length;
    if (!is({"corner"})) return {};
    ++i;
  } else if (is({"side", "end"}) || (relative && is({"wall"}))) {
    ++i;
  }
  const bool ends = i >= tokens.size() || tokens[i].kind == Token::Kind::kPunctuation || lexicon.is(tokens[i], Class::kAnd);
  if (!ends || (bracket && !is({")"}))) return {};
  said.last = i + (bracket ? 1 : 0);
  return said;
}

}  // namespace

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
    if (noun.kind == NounKind::kDoor) leave_out_where_it_leads(document, noun, n);
    if (const SideSaid side = side_said_at(lexicon, document, chunks[k].last); side.last > 0) {
      noun.wall_word = side.wall;
      noun.near_corner = side.corner;
      take_chunks(document, chunks[k].last, side.last, "which wall");
      continue;
    }
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

namespace {

// "on the short side", "at one end", "opposite": which wall, by its length or by the other opening, and where the words end; none: "".
std::pair<std::string, std::size_t> end_said_at(const Document& document, std::size_t i) {
  const auto is = [&](std::size_t at, std::initializer_list<std::string_view> words) { return says_one_of(document, at, words); };
  // "door on the short side, balcony door opposite."
  const bool across = is(i, {"opposite"}) && (i + 1 >= document.tokens.size() || document.tokens[i + 1].kind == Token::Kind::kPunctuation);
  if (is(i, {"at", "on"}) && is(i + 1, {"both", "each", "either"}) && is(i + 2, {"end", "ends"}))
    return {"ends", i + (is(i + 3, {"of"}) && is(i + 4, {"the", "it"}) ? is(i + 4, {"it"}) ? 5 : 6 : 3)};
  if (is(i, {"at", "on", "in", "along"}) && is(i + 1, {"both", "each"}) && is(i + 2, {"long", "longer"}) &&
      is(i + 3, {"side", "sides", "wall", "walls"}))
    return {"lengths", i + 4};
  if (is(i, {"on", "in", "along"}) && is(i + 1, {"two", "three", "both"}) && is(i + 2, {"sides", "walls"})) return {"sides", i + 3};
  if (is(i, {"opposite", "facing"}) && is(i + 1, {"each"}) && is(i + 2, {"other"})) return {"across", i + 3};
  if (!across && !is(i++, {"at", "on", "in"})) return {};
  while (is(i, {"the", "one", "a", "of", "its", "two"})) ++i;
  std::string word;
  for (; is(i, {"long", "longer", "short", "shorter", "narrow", "other", "opposite"}); ++i)
    word = is(i, {"other", "opposite"}) ? "other" : document.tokens[i].text.starts_with("long") ? "long" : "short";
  const bool end = is(i, {"end", "ends"}), side = is(i, {"side", "sides", "one"});
  if (end || (side && !word.empty())) ++i;
  if (end && word.empty()) word = "short";
  if (word.empty() || is(i, {"wall", "walls"}) || (!end && !side && word != "other")) return {};
  if (is(i, {"of"}) && is(i + 1, {"the", "it"})) i += is(i + 1, {"it"}) ? 2 : 3;  // "of the room"
  return {word, i};
}

// "in the middle of one short wall", "centered on the left wall": which wall, and where the words end; none: "".
std::pair<std::string, std::size_t> middle_said_at(const Lexicon& lexicon, const Document& document, std::size_t i) {
  const auto is = [&](std::size_t at, std::initializer_list<std::string_view> words) { return says_one_of(document, at, words); };
  const bool middle = is(i, {"in", "at"}) && is(i + 1, {"the"}) && is(i + 2, {"middle", "center"}) && is(i + 3, {"of"});
  if (!middle && !(is(i, {"centered"}) && is(i + 1, {"on", "in"}))) return {};
  i += middle ? 4 : 2;
  while (is(i, {"the", "one", "a", "of", "its"})) ++i;
  std::string word;
  if (const Match wall = lexicon.find(document.tokens, i, Class::kWallWord); wall.length > 0) {
    word = meaning_of(wall, Class::kWallWord)->word;
    i += wall.length;
  } else if (is(i, {"long", "longer", "short", "shorter", "narrow"})) {
    word = document.tokens[i++].text.starts_with("long") ? "long" : "short";
  }
  const bool wall = is(i, {"wall", "side", "end"});
  const bool ends = i >= document.tokens.size() || document.tokens[i].kind == Token::Kind::kPunctuation ||
                    lexicon.is(document.tokens[i], Class::kAnd);  // "in the middle of the front"
  if (word.empty() || (!wall && !ends)) return {};
  return {word, i + (wall ? 1 : 0)};
}

}  // namespace

void settle_opening_ends(const Lexicon& lexicon, Document& document) {
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    Chunk& chunk = document.chunks[k];
    if (chunk.kind != ChunkKind::kNoun || (chunk.noun.kind != NounKind::kDoor && chunk.noun.kind != NounKind::kWindow)) continue;
    std::size_t first = chunk.last;
    for (std::size_t n = k + 1; n < document.chunks.size() && document.chunks[n].kind == ChunkKind::kIgnored; ++n)
      first = document.chunks[n].last;
    while (says_one_of(document, first, {"is", "are", "being", "located", "placed", "situated"})) ++first;
    const auto middle = middle_said_at(lexicon, document, first);
    const auto& [word, last] = middle.first.empty() ? end_said_at(document, first) : middle;
    if (word.empty()) continue;
    chunk.noun.wall_word = word;
    chunk.noun.in_middle = !middle.first.empty();
    take_chunks(document, first, last, "which wall");
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
    const auto by = std::ranges::find_if(room.openings, [&](const Opening& opening) { return opening.type != type; });
    const std::string wall = by == room.openings.end() ? std::string{} : wall_across(by->wall);
    return !wall.empty() ? wall : type == OpeningType::kWindow ? "back" : "front";
  }
  if (word == "sides") {  // "windows on two sides": one each, those first that the picture shows
    for (const std::string_view side : {"back", "left", "right"}) {
      if (std::ranges::none_of(room.openings, [&](const Opening& opening) { return opening.wall == side; })) return std::string(side);
    }
    return {};
  }
  if (word == "other") return room.openings.empty() ? std::string{} : wall_across(room.openings.back().wall);
  if (word != "short" && word != "long" && word != "ends" && word != "lengths") return word;
  NounPhrase wall;
  wall.name = word == "long" || word == "lengths" ? "long wall" : "short wall";
  const auto [one, other] = walls_by_length(wall, room);
  const auto is_taken = [&](const std::string& side) {
    return std::ranges::any_of(room.openings, [&](const Opening& opening) { return opening.wall == side; });
  };
  if (word == "ends" || word == "lengths") return is_taken(one) ? other : one;
  const bool taken = is_taken(other);
  return type == OpeningType::kWindow || taken ? one : other;
}

Opening opening_said(OpeningType type, const NounPhrase& noun) {
  const OpeningLook look = opening_look(type, {words_of_opening(noun), is_front(type, noun) ? "window front" : ""});
  const bool window = type == OpeningType::kWindow;
  Opening opening;
  opening.type = type;
  opening.attributes = looks_said(type, noun);
  opening.swing = window ? Swing::kNone : look.slides ? Swing::kSliding : Swing::kInLeft;
  const Mm usual = window ? 1200 : openings_said(noun) == 1 && noun.plural ? 1600 : 900;
  opening.width = look.width.value_or(usual);
  opening.height = look.height.value_or(window ? 1200 : 2000);
  opening.sill = look.sill.value_or(window ? 900 : 0);
  if (noun.size.span) opening.width = mm_from_m(*noun.size.span);
  if (noun.size.either && noun.size.depth) opening.height = mm_from_m(*noun.size.depth);
  if (noun.size.length) opening.width = mm_from_m(*noun.size.length);
  if (noun.size.width) opening.width = mm_from_m(*noun.size.width);
  if (noun.size.height) opening.height = mm_from_m(*noun.size.height);
  return opening;
}

bool is_usual(const Opening& opening) {
  const Opening usual = opening_said(opening.type, {});
  return opening.attributes.empty() && opening.width == usual.width && opening.height == usual.height && opening.sill == usual.sill &&
         opening.swing == usual.swing;
}

bool leads_outside(const Opening& opening) { return look_of(opening).outside; }

}  // namespace layoutbox::offline
