// What of the offline planner's reading is beyond doubt: only that is held against a model, which mostly reads better.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox::llm {

// REQUIRES: plan and catalog outlive it.
class Evidence {
 public:
  Evidence(const Plan& plan, const Catalog& catalog);

  // It is brought in by a plain noun of the catalogue after a, an or a number ("two nightstands"), not as a choice, a likeness, a purpose
  // or a part ("a table or a desk", "like a cave", "for a phone"); and where there are several, their number is.
  bool names(const SceneObject& object) const;
  // So many, in one phrase of a number and the noun, which is spoken of nowhere else, in a sentence that counts nothing by the piece
  // ("a chair at each desk").
  bool counts(std::string_view category, std::size_t count) const;
  // It is all that its sentence relates, of one thing to one thing or wall, both named there.
  bool relates(const Relation& relation) const;

 private:
  struct Phrase {
    std::size_t first = 0, last = 0;  // readings
  };
  std::string word(std::size_t reading) const;  // in lower case
  std::string role_of(const SceneObject& object) const;
  std::vector<Phrase> phrases_of(std::string_view role) const;
  Phrase sentence_of(std::size_t reading) const;
  bool is_plain(const SceneObject& object) const;
  bool stands_alone(const Phrase& phrase) const;

  const Plan& plan_;
  const Catalog& catalog_;
};

}  // namespace layoutbox::llm
