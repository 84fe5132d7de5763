// Brings in what words only count: the seats of "a table for six", the desks of "an office for three".
#pragma once

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/words/lexicon.h"

namespace layoutbox::offline {

inline constexpr int kMostPeople = 60;

class SeatBuilder {
 public:
  SeatBuilder(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), document_(document) {}

  Mention& mention(int m) const { return document_.mentions[static_cast<std::size_t>(m)]; }

  // How many sit at each of those tables by their own words ("for six", "double", "an eight-seater"); 0: they do not say.
  int seats_said(const Mention& table) const;
  // Adds so many of a kind, as if "for eight" named them: their mention.
  int add(const CatalogEntry& entry, int count, const NounPhrase& by) const;
  void relate(Link::Kind kind, PhraseSenses senses, int target, int reference) const;
  void seat_at_table(int seats, int table, bool several) const;
  // A mention has at least so many things.
  void grow(int m, int count) const;
  bool excluded(const CatalogEntry& entry) const;

 private:
  const Lexicon& lexicon_;
  Document& document_;
};

}  // namespace layoutbox::offline
