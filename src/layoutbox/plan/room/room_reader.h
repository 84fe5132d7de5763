// The room: size, shape, height, doors and windows, floor and walls.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Sizes of the room that stand in the text, in metres; tokens that said them are marked in `skip`.
struct RoomSize {
  double width = 0, depth = 0, height = 0, area = 0;
  bool impossible = false;  // a side of 0 m or of more than 100 m
};
RoomSize read_room_size(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

// A niche or a missing corner whose size begins at `at`, with the words around that name it and say where it is.
struct NicheRead {
  Niche niche;
  std::size_t first = 0, last = 0;  // tokens
};
std::optional<NicheRead> read_niche(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at);

// The corners of a rectangular room with that niche, the front left one at the origin; lengths in millimetres.
std::vector<Point> outline_with_niche(Mm width, Mm depth, const Niche& niche);
// The id of the niche's own wall, the one furthest in; empty where the room has no such outline.
std::string wall_of_niche(const Room& room, const Niche& niche);

// "The door is 1 m wide", "two windows, each 2 m wide": the sizes become the openings' own.
void settle_opening_sizes(Document& document);

// Which doors are said to open out of the room.
void settle_door_swings(Document& document);

// "a window to the east", "the entrance is on the left": the side becomes the opening's wall word.
void settle_opening_walls(const Lexicon& lexicon, Document& document);
// "three doors, one on the left wall, two on the back"
void share_out_openings(const Lexicon& lexicon, Document& document);

// The name of what is said of both: "black tiles".
inline constexpr std::string_view kWallsAndFloor = "walls and floor";

// "the door at one end and the window at the other", "the entrance on the narrow side": the opening's wall word is "short", "long" or
// "other", which is settled when the room's sides are known.
void settle_opening_ends(const Lexicon& lexicon, Document& document);
// "exposed brick on the back wall", "floral wallpaper": the words become the wall or the floor that they speak of.
void settle_finishes(const Lexicon& lexicon, Document& document);
// What such a word means for an opening of that type after those that the room has; any other word stays.
std::string wall_of_opening(const std::string& word, OpeningType type, const Room& room);
// The wall across from that one.
// The name of a noun phrase without its article: "boss door".
std::string bare_name(const NounPhrase& noun);

std::string wall_across(std::string_view wall);

// A door or window that nobody spoke of, at that wall or at any.
void add_assumed_opening(SceneGraph& scene, OpeningType type, const std::string& wall);

// A door or a window as a noun phrase says it, without an id and a place.
Opening opening_said(OpeningType type, const NounPhrase& noun);

// How wide and deep the room is, from its front-left corner; 0 where nothing is said of its size.
Point extent_of(const Room& room);

// "short" or "long", where a wall or a side is said to be so; empty elsewhere.
std::string length_word(const NounPhrase& wall);
// "the short wall", "a long side": the two walls of that length, words for them; empty where nothing of the kind is said.
std::pair<std::string, std::string> walls_by_length(const NounPhrase& noun, const Room& room);

// Neither its size nor its look is said to be another than that of an opening of which nothing is said.
bool is_usual(const Opening& opening);
// To a balcony, a terrace, the garden: no entrance.
bool leads_elsewhere(const Opening& opening, const Room& room);
// How many openings a noun phrase names.
int openings_said(const NounPhrase& noun);

// "gray carpet, white walls": a carpet named beside the walls is the floor.
void settle_floor_carpets(Document& document);
// "A chair with a red seat": a red chair (part_looks).
void settle_part_looks(Document& document);

// "Pink and grey.", "a kitchen in white and oak", "green tiles": colours of the whole room, for its walls and its floor.
void read_room_colors(const Lexicon& lexicon, Document& document, Room& room);

// Of a wall "behind the bed" the mention of the bed; −1: none.
int thing_before_wall(const Document& document, int wall);
// The wall's word where that mention speaks of one wall of the room and not of all ("an accent wall behind the bed"); else empty.
std::string single_wall(const Document& document, int wall, const Room& room);

// "long", "wide" or "square" where the text says that the room is so; empty elsewhere.
std::string read_room_form(const Lexicon& lexicon, const Document& document);

// Fills the scene's room from what was read.
void build_room(const Lexicon& lexicon, const Document& document, const RoomSize& size, SceneGraph& scene);

// "the window wall", "the wall with the door": the wall of that opening, which is in the usual one where nobody says. REQUIRES: the room is
// read.
void name_walls_by_openings(const Lexicon& lexicon, Document& document, SceneGraph& scene);

}  // namespace layoutbox::offline
