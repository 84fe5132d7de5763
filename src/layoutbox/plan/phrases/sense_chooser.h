// The class behind choose_sense; its members stand in senses (what the two are) and sense_places (a part of the room or of a thing).
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

// The sense that a phrase has between these two.
class SenseChooser {
 public:
  SenseChooser(const Catalog& catalog, const PhraseSenses& senses, PhraseSense::Direction direction, const NounPhrase& target,
               const NounPhrase& reference)
      : catalog_(catalog), senses_(senses), direction_(direction), target_(target), reference_(reference) {}

  std::optional<PhraseSense> run() const {
    if (says(R::kOn) && says(R::kAbove) && says(R::kUnder) && says(R::kNextTo)) return by_any_verb();
    if (direction_ == PhraseSense::Direction::kDirect) {
      if (const auto place = by_kind(); place.chosen) return place.sense;
    }
    if (const auto sense = at_opening_or_table()) return sense;
    return first_that_fits();
  }

 private:
  using R = RelationType;

  // What the reference's kind says; not chosen: it says nothing, and the phrase decides.
  struct Choice {
    bool chosen = false;
    std::optional<PhraseSense> sense;
  };
  static Choice chosen(std::optional<PhraseSense> sense) { return {true, std::move(sense)}; }
  static Choice if_any(std::optional<PhraseSense> sense) { return {sense.has_value(), std::move(sense)}; }

  PhraseSense own(R type) const { return {type, direction_, {}, {}, {}}; }
  PhraseSense on_part(ThingPart part) const {
    PhraseSense sense = own(R::kOn);
    sense.part = std::move(part);
    return sense;
  }
  bool says(R type) const {
    return std::any_of(senses_.begin(), senses_.end(), [&](const PhraseSense& s) { return s.type == type && s.direction == direction_; });
  }
  bool says(bool RelationTraits::*so) const {
    return std::any_of(senses_.begin(), senses_.end(),
                       [&](const PhraseSense& s) { return traits_of(s.type).*so && s.direction == direction_; });
  }
  bool says_at() const { return says_any({R::kNextTo, R::kAlongSide}) && !says(R::kNear); }
  bool says_any(std::initializer_list<R> types) const {
    return std::any_of(types.begin(), types.end(), [&](R type) { return says(type); });
  }

  Choice by_kind() const;
  std::optional<PhraseSense> by_any_verb() const;
  Choice at_corner() const;
  std::optional<PhraseSense> at_center() const;
  bool is_leg_of_room() const;
  std::optional<PhraseSense> at_end_of_length() const;
  std::optional<PhraseSense> at_part() const;
  PhraseSense at_end_of_room() const;
  std::optional<PhraseSense> at_side() const;
  std::optional<PhraseSense> at_wall() const;
  std::optional<PhraseSense> at_opening_or_table() const;
  std::optional<PhraseSense> first_that_fits() const;
  bool stands_beside(const PhraseSense& on) const;
  bool at_end_of_seat(const PhraseSense& sense) const;
  bool lies_over() const;
  bool contradicts_kinds(const PhraseSense& sense) const;

  const Catalog& catalog_;
  const PhraseSenses& senses_;
  PhraseSense::Direction direction_;
  const NounPhrase &target_, &reference_;
};

}  // namespace layoutbox::offline
