// What the words of a relation say that its type and parameters do not: "at the left end", "back to back", "with its head".
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

class RelationWords {
 public:
  explicit RelationWords(const std::vector<Token>& tokens) : tokens_(tokens) {}

  // The relation of that id was said by that link. What no link said (a habit of ours) has no words.
  void keep(const std::string& relation, const Link& link);

  // One of them is among the words.
  bool have(const Relation& relation, WordSet set) const;
  bool have(const Relation& relation, std::string_view word) const;
  // These words stand there, one after the other.
  bool have_phrase(const Relation& relation, std::initializer_list<std::string_view> words) const;
  bool begin_with(const Relation& relation, std::initializer_list<WordSet> sets) const;
  bool end_with(const Relation& relation, WordSet set) const;
  bool end_with(const Relation& relation, std::string_view word) const;
  // They stand before that token.
  bool are_before(const Relation& relation, std::size_t token) const;
  // "wall cabinets above": by what, nobody says.
  bool are_without_reference(const Relation& relation) const;
  // One place of the text says both.
  bool are_one(const Relation& one, const Relation& other) const;

 private:
  struct Place {
    std::size_t first = 0, last = 0;  // tokens
    bool implied = false;
  };
  Place place_of(const Relation& relation) const;

  const std::vector<Token>& tokens_;
  std::unordered_map<std::string, Place> places_;  // by relation
};

}  // namespace layoutbox::offline
