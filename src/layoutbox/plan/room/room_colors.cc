// Colours that a text gives the whole room.
#include <algorithm>

#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {
namespace {

struct Scheme {
  std::string walls, floor;
  std::size_t length = 0;  // tokens
  int colors = 0;
};

bool is_one_of(const Token& token, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, std::string_view(token.text)) != words.end();
}

// "A checkered floor, black and white": its own.
bool is_surface(const Token& token) {
  return is_one_of(token, {"floor", "floors", "flooring", "tiles", "tiling", "carpet", "rug", "wallpaper", "curtains", "walls", "ceiling"});
}

bool is_shade(const Token& token) { return is_one_of(token, {"light", "dark", "pale", "soft", "bright", "deep", "warm"}); }

// "white and oak", "mostly pale blue tones": a row of colours and materials from `at` on. Empty where something else is among them.
Scheme scheme_at(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t at) {
  Scheme scheme;
  std::size_t i = at;
  for (std::string shade; i < tokens.size();) {
    const Token& token = tokens[i];
    const Match color = lexicon.find(tokens, i, WordClass::kColor), material = lexicon.find(tokens, i, WordClass::kMaterial);
    if (color.length > 0) {
      for (std::size_t w = i; w < i + color.length; ++w) shade += (shade.empty() ? "" : " ") + tokens[w].text;
      if (scheme.walls.empty()) scheme.walls = shade;
      ++scheme.colors;
      shade.clear();
      i += color.length;
    } else if (material.length > 0) {
      if (token.text.starts_with("tile") && !scheme.walls.empty())
        scheme.walls += " tile";
      else if (scheme.floor.empty() &&
               is_one_of(token, {"oak", "wood", "walnut", "maple", "pine", "birch", "ash", "teak", "bamboo", "concrete"}))
        scheme.floor = token.text;
      shade.clear();
      i += material.length;
    } else if (is_shade(token)) {
      shade = token.text;
      ++i;
    } else if (is_one_of(token, {"and", ",", "tones", "tone", "colors", "color", "shades", "scheme", "palette", "mostly", "all", "please",
                                 "natural", "everywhere", "throughout"})) {
      ++i;
    } else {
      break;
    }
  }
  if (i > at && is_shade(tokens[i - 1])) return {};  // "Red light." is a lamp's
  scheme.length = i - at;
  return scheme;
}

// "Walls pale blue.", "walls: sage green, floor: oak": what comes right behind the noun, and nothing else before the clause ends.
Scheme finish_after(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t at, bool floor) {
  const std::size_t from = at < tokens.size() && is_one_of(tokens[at], {"in", ":"}) ? at + 1 : at;
  Scheme finish;
  std::string said;
  std::size_t i = from;
  bool known = false;
  for (std::size_t length = 1; i < tokens.size() && length > 0; i += length) {
    length = lexicon.find(tokens, i, floor ? WordClass::kMaterial : WordClass::kColor).length;
    known |= length > 0;
    if (length == 0 && floor && !known) length = lexicon.find(tokens, i, WordClass::kColor).length;  // "floor: red tiles"
    if (length == 0 && !known && is_shade(tokens[i])) length = 1;
    for (std::size_t w = i; w < i + length; ++w) said += (said.empty() ? "" : " ") + tokens[w].text;
  }
  const bool over = i >= tokens.size() || tokens[i].kind == Token::Kind::kPunctuation || is_one_of(tokens[i], {"and", "with"});
  if (!known || !over) return finish;
  (floor ? finish.floor : finish.walls) = said;
  finish.length = i - at;
  return finish;
}

bool ends(const std::vector<Token>& tokens, std::size_t at) { return at >= tokens.size() || tokens[at].ends_sentence; }

void use(Document& document, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    document.readings[i].use = WordReading::Use::kUsed;
    document.readings[i].role = "colors of the room";
  }
}

// "Green tiles." of nothing in particular: on the walls.
std::string tiles_said(const NounPhrase& noun) {
  if (noun.kind != NounKind::kPart || noun.head != "tile" || noun.of) return {};
  for (std::size_t a = 0; a < noun.attribute_classes.size() && a < noun.attributes.size(); ++a) {
    if (noun.attribute_classes[a] == WordClass::kColor) return noun.attributes[a] + " tile";
  }
  return {};
}

// "gray carpet, white walls": a carpet of a color, named with the walls, is the floor.
bool is_floor_by_company(const Document& document, std::size_t k) {
  const NounPhrase& noun = document.chunks[k].noun;
  if (noun.name != "carpet" || noun.determiner != Determiner::kNone || noun.count > 0 || noun.attributes.empty()) return false;
  const auto is_wall = [&](std::size_t c) {
    return c < document.chunks.size() && document.chunks[c].kind == ChunkKind::kNoun && document.chunks[c].noun.kind == NounKind::kWall;
  };
  const auto joins = [&](std::size_t c) {
    return c < document.chunks.size() && (document.chunks[c].kind == ChunkKind::kComma || document.chunks[c].kind == ChunkKind::kAnd);
  };
  return (joins(k + 1) && is_wall(k + 2)) || (k >= 2 && joins(k - 1) && is_wall(k - 2));
}

// What the text says of the room's walls and floor, where no noun phrase has it already.
class RoomColors {
 public:
  RoomColors(const Lexicon& lexicon, Document& document, Room& room) : lexicon_(lexicon), document_(document), room_(room) {}

  void run() {
    for (std::size_t i = 0; i < document_.tokens.size(); ++i) {
      if (i == 0 || document_.tokens[i - 1].ends_sentence)
        read_sentence(i);
      else if (document_.tokens[i - 1].text == ",")
        read_clause(i);
    }
    for (const Chunk& chunk : document_.chunks) {
      if (chunk.kind != ChunkKind::kNoun) continue;
      read_before_room(chunk);
      read_after_room(chunk);
      read_finish_after(chunk);
      read_tiles(chunk);
    }
  }

 private:
  void take(const Scheme& scheme, std::size_t first, std::size_t last) {
    if (room_.wall_material.empty()) room_.wall_material = scheme.walls;
    if (room_.floor_material.empty() && !scheme.floor.empty()) room_.floor_material = scheme.floor + " floor";
    use(document_, first, last);
  }

  static bool says_several(const Scheme& scheme) { return scheme.colors + (scheme.floor.empty() ? 0 : 1) > 1; }

  // "White and oak." is a sentence, "Yellow and white, nothing too loud." begins one.
  void read_sentence(std::size_t first) {
    const Scheme scheme = scheme_at(lexicon_, document_.tokens, first);
    const std::size_t end = first + scheme.length;
    if (scheme.walls.empty()) return;
    if (ends(document_.tokens, end) || (says_several(scheme) && document_.tokens[end - 1].text == ",")) take(scheme, first, end);
  }

  // "…, led lights, dark grey and purple.": several colors by themselves are nobody's but the room's.
  void read_clause(std::size_t first) {
    const auto is_look = [&](std::size_t at) {  // "a rug in red, blue and white"
      return lexicon_.find(document_.tokens, at, WordClass::kColor).length > 0 ||
             lexicon_.find(document_.tokens, at, WordClass::kMaterial).length > 0;
    };
    if (first < 2 || is_look(first - 2) || is_surface(document_.tokens[first - 2])) return;
    const Scheme scheme = scheme_at(lexicon_, document_.tokens, first);
    const std::size_t end = first + scheme.length;
    if (!scheme.walls.empty() && says_several(scheme) && (ends(document_.tokens, end) || document_.tokens[end - 1].text == ","))
      take(scheme, first, end);
  }

  // "A bright yellow kitchen": what has that color of a room are its walls.
  void read_before_room(const Chunk& chunk) {
    const NounPhrase& noun = chunk.noun;
    if (noun.kind != NounKind::kRoom || noun.room == nullptr || !room_.wall_material.empty()) return;
    const auto is_color = [&](std::size_t a) { return noun.attribute_classes[a] == WordClass::kColor; };
    std::size_t colors = 0, first = 0;
    for (std::size_t a = 0; a < noun.attribute_classes.size() && a < noun.attributes.size(); ++a) {
      if (is_color(a) && colors++ == 0) first = a;
    }
    if (colors == 1) room_.wall_material = noun.attributes[first];
  }

  // "A den in teal and white with …"
  void read_after_room(const Chunk& chunk) {
    const std::vector<Token>& tokens = document_.tokens;
    const std::size_t at = chunk.last;
    if (chunk.noun.kind != NounKind::kRoom || at + 1 >= tokens.size() || !is_one_of(tokens[at], {"in", "painted"})) return;
    const Scheme scheme = scheme_at(lexicon_, tokens, at + 1);
    const std::size_t end = at + 1 + scheme.length;
    const bool over = ends(tokens, end) || tokens[end - 1].text == "," || is_one_of(tokens[end], {"with", "for"});
    if (!scheme.walls.empty() && over) take(scheme, at, end);
  }

  void read_finish_after(const Chunk& chunk) {
    const bool of_walls = chunk.noun.kind == NounKind::kWall && chunk.noun.plural && chunk.noun.wall_word.empty();
    if (!of_walls && chunk.noun.kind != NounKind::kFloor) return;
    const Scheme finish = finish_after(lexicon_, document_.tokens, chunk.last, !of_walls);
    if (finish.length > 0) take(finish, chunk.last, chunk.last + finish.length);
  }

  // "Green tiles." are on the walls, "green tiles on the floor" there.
  void read_tiles(const Chunk& chunk) {
    const std::vector<Token>& tokens = document_.tokens;
    const std::string tiles = tiles_said(chunk.noun);
    if (tiles.empty()) return;
    const std::size_t at = chunk.last;
    const bool own = chunk.first == 0 || tokens[chunk.first - 1].kind == Token::Kind::kPunctuation;
    if (at + 2 < tokens.size() && tokens[at].text == "on" && tokens[at + 2].text == "floor") {
      if (room_.floor_material.empty()) room_.floor_material = tiles + " floor";
      use(document_, chunk.first, at + 3);
    } else if (own && room_.wall_material.empty()) {
      room_.wall_material = tiles;
      use(document_, chunk.first, at);
    }
  }

  const Lexicon& lexicon_;
  Document& document_;
  Room& room_;
};

}  // namespace

void settle_floor_carpets(Document& document) {
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    NounPhrase& noun = document.chunks[k].noun;
    if (document.chunks[k].kind != ChunkKind::kNoun || !is_floor_by_company(document, k)) continue;
    noun.kind = NounKind::kFloor;
    noun.attributes.push_back(noun.name);
    noun.attribute_classes.resize(noun.attributes.size() - 1, WordClass::kColor);
    noun.attribute_classes.push_back(WordClass::kMaterial);
    noun.name = noun.head = "floor";
    noun.entry = nullptr;
    noun.exact = false;
  }
}

void read_room_colors(const Lexicon& lexicon, Document& document, Room& room) { RoomColors(lexicon, document, room).run(); }

}  // namespace layoutbox::offline
