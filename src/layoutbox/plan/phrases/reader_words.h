// Small questions that the files of the reader share.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "layoutbox/plan/phrases/noun_phrase.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using Direction = PhraseSense::Direction;

// How many mentions back "it" may reach; keeps long texts linear.
inline constexpr std::size_t kReach = 200;

inline bool has_direction(const PhraseSenses& senses, Direction direction) {
  return std::any_of(senses.begin(), senses.end(), [&](const PhraseSense& s) { return s.direction == direction; });
}

inline PhraseSenses with_direction(const PhraseSenses& senses, Direction direction) {
  PhraseSenses chosen;
  for (const PhraseSense& sense : senses) {
    if (sense.direction != direction) continue;
    chosen.push_back(sense);
    chosen.back().direction = Direction::kDirect;
  }
  return chosen;
}

inline bool says(const PhraseSenses& senses, RelationType type) {
  return std::any_of(senses.begin(), senses.end(), [&](const PhraseSense& s) { return s.type == type; });
}

inline bool says(const PhraseSenses& senses, bool RelationTraits::*so) {
  return std::any_of(senses.begin(), senses.end(), [&](const PhraseSense& s) { return traits_of(s.type).*so; });
}

// "holds", "decorates": a finite verb among the relation phrases and the words of having.
inline bool is_finite(std::string_view word) {
  static constexpr std::string_view kNot[] = {"across", "towards", "besides", "plus", "as", "opposites"};
  return word.size() > 2 && word.ends_with("s") && std::find(std::begin(kNot), std::end(kNot), word) == std::end(kNot);
}

// "the dining area", "a reading nook": a part of the room.
inline bool is_zone(std::string_view head) { return one_of(head, WordSet::kZones); }

inline bool is_new_here(const NounPhrase& noun) {
  return noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother || noun.count > 0;
}

inline bool is_opening(const NounPhrase& noun) { return noun.kind == NounKind::kDoor || noun.kind == NounKind::kWindow; }

// "metal shelving", "racking": stuff that nobody counts.
inline bool is_uncounted_stuff(const NounPhrase& noun) {
  return !noun.plural && noun.determiner == Determiner::kNone && noun.count == 0 && noun.head.ends_with("ing");
}

// A wall, a corner, a door …
inline bool is_part_of_room(const NounPhrase& noun) {
  return noun.kind == NounKind::kWall || noun.kind == NounKind::kCorner || noun.kind == NounKind::kCenter ||
         noun.kind == NounKind::kCeiling || is_opening(noun);
}

inline bool contains(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }
inline bool contains_word(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace layoutbox::offline
