// How much sense a place makes between two things.
#pragma once

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

class SenseScore {
 public:
  explicit SenseScore(const Catalog& catalog) : catalog_(catalog) {}
  // TARGET phrase REFERENCE.
  double of_place(const PhraseSenses& senses, const NounPhrase& target, const NounPhrase& reference) const;
  // HOST has THING; `holds`: the words say that it is carried.
  double of_having(const NounPhrase& host, const NounPhrase& thing, bool holds) const;
  // A part that is named alone ("the tabletop") of the thing.
  double of_part(const NounPhrase& part, const NounPhrase& owner) const;
  bool carries(const NounPhrase& host, const NounPhrase& thing) const;

  // On a bed or a seat lies what is soft; that is not.
  bool on_soft(const NounPhrase& host, const NounPhrase& thing) const;

 private:
  // A thing that is above another.
  double on_top(const NounPhrase& target, const NounPhrase& reference) const;
  double before_each_seat(const NounPhrase& target, const NounPhrase& reference, double so_far) const;
  double opposite(const NounPhrase& target, const NounPhrase& reference) const;
  double at_end(RelationType type, const NounPhrase& reference) const;
  double over(const NounPhrase& target, const NounPhrase& reference) const;
  bool small_host(const NounPhrase& host) const;
  bool is_chair(const NounPhrase& noun) const;
  const Catalog& catalog_;
};

}  // namespace layoutbox::offline
