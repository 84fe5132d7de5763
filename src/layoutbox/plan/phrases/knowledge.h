// What is likely of furniture: which relation a phrase means for these two things, and whether it makes sense for them.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

inline bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// "holds", "displaying": what a thing so said to have is on it or in it.
inline bool shows_things(std::string_view word) { return one_of(word, WordSet::kShowing); }

// What things on one floor are to each other.
bool stands_beside(RelationType type);

// The sense that a phrase has between a target and what it refers to, or nothing where none fits.
// A corner, the middle, the floor, the ceiling and parts of things choose their own relation.
std::optional<PhraseSense> choose_sense(const Catalog& catalog, const PhraseSenses& senses, PhraseSense::Direction direction,
                                        const NounPhrase& target, const NounPhrase& reference);

// How well the sense suits the target: 0 makes no sense, 1 possible, 2 usual.
int suits(const Catalog& catalog, const PhraseSense& sense, const NounPhrase& target, const NounPhrase& reference);

// The usual mount of a thing; floor where nothing is known.
Mount mount_of(const NounPhrase& noun);

// "a pew under a stuffed trout": what has no place of its own hangs over who sits or lies there.
bool may_sit_under(const Catalog& catalog, const NounPhrase& seat, const NounPhrase& over);

bool is_table(const Catalog& catalog, const NounPhrase& noun);     // one sits at it
bool one_sits_at(const Catalog& catalog, const NounPhrase& noun);  // a table, or what one plays or works at (a piano)
bool is_full_height(const NounPhrase& noun);                       // said to be as high as the room
bool is_tall(const NounPhrase& noun);                              // said to be tall, high, floor-to-ceiling: stands, and is no board
bool is_common(const NounPhrase& noun);                            // "a shared printer": one for all
bool is_seat(const Catalog& catalog, const NounPhrase& noun);      // for one person
bool is_for_several(const NounPhrase& noun);                       // a bench
bool is_wide_seat(const NounPhrase& noun);                         // a bench for two or more, that stands along a table's side
bool is_drawn_up(const Catalog& catalog, const NounPhrase& noun);  // a seat that one draws up to a table: no sofa, no armchair
bool lies_or_hangs(const NounPhrase& item);                        // a poster, a small mirror
bool is_lamp(const Catalog& catalog, const NounPhrase& noun);
bool is_storage(const NounPhrase& noun);                                                  // things are in it
bool is_textile(const Catalog& catalog, const NounPhrase& noun);                          // pillows, blankets: lie on beds and seats
bool stands_by(const Catalog& catalog, const NounPhrase& noun, const NounPhrase& other);  // a nightstand by a bed
// Whether the phrase makes sense between the two; used to find out who "it" is.
bool may_refer(const Catalog& catalog, const PhraseSenses& senses, const NounPhrase& target, const NounPhrase& reference);
bool has_hooks(const NounPhrase& noun);  // things hang on it: a pegboard, a towel rack
// "a hexagonal table": how many sides its shape has; 0: nobody says, or a ring.
int sides_by_shape(const NounPhrase& noun);

// What a vessel higher than wide is to hold is, but for one way in which it may stick out, no wider than the vessel: a fruit bowl goes into
// no vase.
bool goes_into(const NounPhrase& vessel, const NounPhrase& item);

bool is_heavy(const Catalog& catalog, const NounPhrase& noun);  // stands on the floor, never hangs on a wall
// True when `item` may stand on, lie on or be in `host`.
bool may_carry(const Catalog& catalog, const NounPhrase& host, const NounPhrase& item);

}  // namespace layoutbox::offline
