// For how many a table or a room is, and what that brings in; what plain words mean in a kind of room.
#pragma once

#include <map>
#include <string>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "a table that seats six", "with seating for six" read as "a table for six": the words that are not needed are marked in `skip`.
void read_seats_said(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

// "mats" in a gym are for exercise, "a board" in a classroom is written on. The kind of room may be named anywhere in the text; where none
// is, it may be what the text opens with.
void settle_room_senses(const Lexicon& lexicon, Document& document);

// Words of several senses by the words beside them: "bare boards", a board with keys.
void settle_word_senses(const Lexicon& lexicon, Document& document);

// Trucks, trains and boats on or in furniture, on a rug or in a room for children are toys.
void settle_toys(const Lexicon& lexicon, Document& document);

// What such a thing has of its own is a part of it ("backwash chairs with basins"), and what is named beside another may be of another
// kind: a PC with two monitors is its tower.
void settle_company(const Lexicon& lexicon, Document& document);

// Adds the seats of a table that is "for six" and what each person needs in an office, classroom or bedroom "for three", where nothing
// of that kind is named; marked as assumed.
void add_for_people(const Lexicon& lexicon, Document& document);

// How many of what a room of that kind needs for so many people; empty for none.
std::map<std::string, int> needs_of(const Lexicon& lexicon, const std::string& room, int people);

}  // namespace layoutbox::offline
