// Writes a decided reading down: mentions, items and links of the document.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/plan/reading/reading.h"
#include "layoutbox/plan/reading/references.h"

namespace layoutbox::offline {

class Scribe {
 public:
  Scribe(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), document_(document), references_(lexicon, document) {}
  // Adds what the sentence says; the sentence and its reading must outlive the call only.
  void write(const Sentence& sentence, const SentenceReading& reading);
  const TextSoFar& so_far() const { return so_far_; }

 private:
  void write_noun(int u);
  void write_place(int u);
  void grow_alone(const Link& link);
  void write_place_alone(int u);
  int whole_of(int mention);
  std::vector<int> list_meant(int last) const;
  std::vector<int> references_alone(int u, const Link& link);
  void complete_pair(int u, Link& link);
  static void mean_side_of_room(Link& link);
  bool is_mutual(int u, const Link& link) const;
  bool centers(int u) const;
  void write_have(int u);
  void write_verb(int u);
  void write_participle(int u);
  void stack(int u);
  void write_size(int u);
  std::vector<int> described_by(int u) const;
  void write_attribute(int u);
  void end_sentence();
  bool names_one_of(const std::vector<int>& mentions, int mention) const;

  // Mentions of nouns.
  int make_mention(int u);
  bool as_reference_of(int u, RelationType type) const;
  int group_left(const NounPhrase& noun) const;
  NounPhrase shared_out_to_all(int u, const NounPhrase& noun, int antecedent) const;
  int share_one_each(const NounPhrase& noun);
  int make_member(int u, const NounPhrase& noun);
  int make_another(int u, const NounPhrase& noun);
  int make_more(int u, const NounPhrase& noun);
  int make_opposed(int u, const NounPhrase& noun);
  int not_itself(int u, const NounPhrase& noun, int mention);
  int copy_of(int mention, const NounPhrase& said);
  int more_of(int mention, const NounPhrase& said);
  bool same_as_placed(int u) const;
  std::vector<int> pair_named_last(int u, const std::vector<int>& placed) const;
  std::vector<int> two_alike(int u, bool by_name) const;
  bool describes_one_of(int u, const NounPhrase& noun) const;
  int others_listed(int u, const NounPhrase& noun);
  int make_ordinal(const NounPhrase& noun);
  bool is_across_from(const NounPhrase& noun, int antecedent) const;
  int antecedent_of(int u);
  int shared_as(int u, const NounPhrase& noun);
  std::vector<int> last_introduced(std::size_t count) const;
  int list_ranked(const NounPhrase& noun, int antecedent);
  int combined(const std::vector<int>& mentions);
  int pair_just_related();
  int pair_of_a_name();
  bool says_free(const NounPhrase& noun) const;
  int thing_of_zone(int u, const NounPhrase& noun) const;
  void add_have(int content, std::vector<int> hosts, std::size_t first, std::size_t last);
  bool trails_each(int u);
  bool write_set(int u);
  void mark_noun(int u, int mention);

  // Whether an unknown noun is a thing of the room.
  bool tells_more() const;
  bool is_named_anew(int u) const;
  bool is_listed(int u) const;
  bool is_living(const NounPhrase& noun) const;
  bool is_evident(int u) const;
  void forget(int u, int mention, std::size_t items);

  // What a noun is for.
  std::size_t row_along_walls(const Link& link, int target, const NounPhrase& wall) const;
  void grow_at_two_walls(const Link& link);
  void grow_along_walls(const Link& link, int target, const NounPhrase& wall);
  bool is_one_of_each(int mention) const;
  void grow_on_all(const Link& link, int mention, bool both);
  void grow_for_every(int index, int mention);
  void grow_for_reference(int index, int mention, bool both);
  void fill_reference(int u, int mention);
  bool is_put_by_fellow(int u) const;
  void fill_content(int u, int mention);
  void fill_root(int u, int mention);
  void grow_fronted(int p, int mention);
  bool takes_other_side(const std::vector<int>& targets);
  void add_named_contents(int u, int host);
  void seat_at_its(int u, int mention);
  void imply_adjective(int u, int mention);
  bool is_placed_before(int mention, int link) const;
  int last_at_wall(const std::vector<int>& but) const;
  int last_great_thing(const std::vector<int>& but) const;
  void imply_opposite(int u, const NounPhrase& place, int link);
  void mean_each_other(Link& link);
  bool is_told_to_hang(int u) const;
  void follow_screen(Link& link, int u) const;

  // Counts that follow from places.
  int sides_meant(const Link& link, int target, int reference) const;
  void grow_for_sides(const Link& link, int target, int reference);
  void grow_for_hosts(int content, const std::vector<int>& hosts);
  void grow_for_each(int thing, int each);
  void place_with_zone(const std::vector<int>& hosts, int index);
  void grow_for_corners(const NounPhrase& corner, int target);
  int pair_looking();
  void mean_sides_of_room(Link& link);
  void grow_on(const Link& link, int thing, int some);
  void grow_on_some(const Link& link, int some);
  bool is_some_of_group(int mention) const;
  void grow_for_openings(const NounPhrase& opening, int target);
  int each_of_openings(int u, const NounPhrase& noun);
  void grow_contents(int host, std::size_t before);
  void add_laden_stand(const PhraseSenses& senses, std::vector<int>& targets) const;

  std::vector<int> subjects_of(int u) const;
  std::vector<int> mentions_of(Referent referent) const;
  int looked_at_by(int mention, const std::vector<int>& but) const;
  Link link_at_unit(int u) const;
  int add_link(int u, Link link);
  void join_sides();
  void write_orders();
  std::vector<int> list_ordered(int u) const;
  bool verb_ends(int u) const;
  void place_where(int u, const std::vector<int>& targets);
  void mean_between(int u, const Link& looking);
  void lies_between(int u, int mention);
  void hang(const std::vector<int>& targets, int u);
  bool hangs(int u) const;

  const Unit& unit(int u) const { return (*sentence_)[static_cast<std::size_t>(u)]; }
  const UnitReading& reading(int u) const { return reading_->units[static_cast<std::size_t>(u)]; }
  const Chunk& chunk(int u) const { return document_.chunks[unit(u).chunk]; }
  bool is(int u, UnitKind kind) const { return u >= 0 && u < static_cast<int>(sentence_->size()) && unit(u).kind == kind; }
  const std::string& word(int u) const { return document_.tokens[chunk(u).first].text; }
  Mention& mention_at(int mention) { return document_.mentions[static_cast<std::size_t>(mention)]; }
  const Mention& mention_at(int mention) const { return document_.mentions[static_cast<std::size_t>(mention)]; }
  const NounPhrase& noun_of(int mention) const { return mention_at(mention).noun; }
  bool is_thing(int mention) const { return mention >= 0 && !mention_at(mention).items.empty(); }
  Link& link_at(int link) { return document_.links[static_cast<std::size_t>(link)]; }
  void mark(int u, WordReading::Use use, const std::string& role);

  const Lexicon& lexicon_;
  Document& document_;
  References references_;
  TextSoFar so_far_;
  const Sentence* sentence_ = nullptr;
  const SentenceReading* reading_ = nullptr;
  std::vector<int> mention_;  // of each unit, −1: none
  std::vector<int> link_;     // of each unit
  int one_side_ = -1;         // "on one side of": "on the other" may follow
  std::size_t sentence_links_ = 0;
  int sentence_mentions_ = 0;
};

}  // namespace layoutbox::offline
