// What a noun that the catalogue lacks is like: the nearest of its more general kinds that is known. Nouns and their kinds are those of
// catalog/words_english.txt (from WordNet); what the kinds mean here stands in catalog/words_kinds.json.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "layoutbox/catalog/catalog.h"

namespace layoutbox {

// The rest of the line of a lower-case word in words_english.txt: its letter and kinds ("t sofa seat furniture"); empty where it is not
// there. Searched in place: nothing is read at start.
std::string_view english_line(std::string_view word);

// The entry that a thing of that name ("koala", "plush koala", "soup tureen") is sized, held and drawn like, or null.
const CatalogEntry* kin_of(const Catalog& catalog, std::string_view noun);

// A word for a place, a part or some stuff ("darkroom", "driveway", "seam"), by its more general kinds; none of the nearer ones has an
// entry.
bool is_no_thing(const Catalog& catalog, std::string_view word);

// The id of the entry that a word is listed to be like ("wok" → pan), case and separators apart, or empty.
std::string_view liked_entry(std::string_view words);

// All words that are listed so, with those ids, in alphabetical order: for word lists.
std::vector<std::pair<std::string_view, std::string_view>> like_words();

// The id of the entry that so much of something in it or of it is like ("tub" of clay → jar), or empty.
std::string_view portion_entry(std::string_view container);

// Where a thing is of another kind than where it mostly is.
enum class KinPlace : std::uint8_t {
  kOnWall,        // bookshelf → wall_bookshelf
  kOnFloor,       // of what mostly stands on something: lamp → floor_lamp
  kOnCeiling,     // lamp → ceiling_lamp
  kOnThing,       // of what mostly stands on the floor: plant → small_plant
  kBetweenSeats,  // table → side_table
  kBetweenSofas,  // table → coffee_table
  kAroundBed,     // curtain_rod → privacy_curtain
  kSetIn,         // let into the top of something: sink → inset_sink
  kAtSides,       // on the wall at both sides of something: grab_rail → fold_down_rail
};

// The entry that one of that id is there; null where it stays what it is, or where the catalogue has no such entry.
const CatalogEntry* kind_at(const Catalog& catalog, std::string_view id, KinPlace place);

// The id of the entry that a plain word means of what stands on or in such a thing ("bin" on shelves → storage_bin), or empty.
std::string_view kept_in_entry(std::string_view head, const CatalogEntry& host);

// Whether a thing of the one kind has such a part of its own (a backwash chair its basin).
bool is_own_part(const Catalog& catalog, std::string_view owner, std::string_view part);

// What a kind is where another is named beside it: pairs of that other kind and what it is then (a PC: with a monitor the tower).
std::vector<std::pair<std::string_view, std::string_view>> kinds_in_company(std::string_view id);

// The kind that a plain thing is of where it is for somebody ("chairs for patients": visitors' chairs), or empty.
std::string_view kinds_for(std::string_view user);

// "plush", "toy", "model": a word before a noun that says more of what a thing is like than the noun does.
bool is_kin_modifier(std::string_view word);

// "board", "tube": whether compounds of that last word are things, though what it says alone is no more than stuff or a part.
bool is_kin_head(std::string_view word);

}  // namespace layoutbox
