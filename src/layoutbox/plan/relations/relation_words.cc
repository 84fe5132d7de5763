#include "layoutbox/plan/relations/relation_words.h"

#include <algorithm>
#include <span>

namespace layoutbox::offline {

void RelationWords::keep(const std::string& relation, const Link& link) {
  places_.insert_or_assign(relation, Place{link.first, link.last, link.implied});
}

RelationWords::Place RelationWords::place_of(const Relation& relation) const {
  const auto found = places_.find(relation.id);
  return found == places_.end() ? Place{} : found->second;
}

bool RelationWords::have(const Relation& relation, WordSet set) const {
  const Place place = place_of(relation);
  return std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(place.first), tokens_.begin() + static_cast<std::ptrdiff_t>(place.last),
                     [&](const Token& token) { return one_of(token.text, set); });
}

bool RelationWords::have(const Relation& relation, std::string_view word) const { return have_phrase(relation, {word}); }

bool RelationWords::have_phrase(const Relation& relation, std::initializer_list<std::string_view> words) const {
  const Place place = place_of(relation);
  for (std::size_t at = place.first; at + words.size() <= place.last; ++at) {
    if (stand_at(tokens_, at, words)) return true;
  }
  return false;
}

bool RelationWords::begin_with(const Relation& relation, std::initializer_list<WordSet> sets) const {
  const Place place = place_of(relation);
  return place.first + sets.size() <= place.last &&
         std::ranges::equal(sets, std::span(tokens_).subspan(place.first, sets.size()),
                            [](WordSet set, const Token& token) { return one_of(token.text, set); });
}

bool RelationWords::end_with(const Relation& relation, WordSet set) const {
  const Place place = place_of(relation);
  return place.first < place.last && one_of(tokens_[place.last - 1].text, set);
}

bool RelationWords::end_with(const Relation& relation, std::string_view word) const {
  const Place place = place_of(relation);
  return place.first < place.last && tokens_[place.last - 1].text == word;
}

bool RelationWords::are_before(const Relation& relation, std::size_t token) const {
  const Place place = place_of(relation);
  return place.first < place.last && place.last <= token;
}

bool RelationWords::are_without_reference(const Relation& relation) const { return place_of(relation).implied; }

bool RelationWords::are_one(const Relation& one, const Relation& other) const {
  const Place a = place_of(one), b = place_of(other);
  return a.first < a.last && a.first == b.first && a.last == b.last;
}

}  // namespace layoutbox::offline
