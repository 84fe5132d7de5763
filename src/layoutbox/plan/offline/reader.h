// Reads a row of chunks from left to right: who is placed, and by what.
#pragma once

#include <string_view>
#include <vector>

#include "layoutbox/plan/offline/document.h"
#include "layoutbox/plan/offline/references.h"

namespace layoutbox::offline {

// The state of reading. A *root* is a thing that the clause itself speaks of (a subject, or a member of the room's list); what stands
// in a reference or in something's contents hangs on it. The *chain* is the root with all that hangs on it, the nearest last.
class DocumentReader {
 public:
  DocumentReader(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), document_(document), references_(lexicon, document) {}
  void read();

 private:
  enum class Joiner { kNone, kComma, kAnd, kCommaAnd };
  // Contents being listed: "with a lamp, a clock and …" of `hosts`.
  struct Frame {
    int link = -1;
    std::vector<int> hosts;
    bool room = false;  // the hosts are the room: members are roots
    bool after_comma = false;
  };

  void begin_clause();
  void begin_sentence();
  void read_chunk(std::size_t k);
  void read_noun(std::size_t k);
  void read_place(std::size_t k, int mention);
  void add_named_contents(std::size_t k, int host);
  int another_one(const NounPhrase& noun);
  int last_ordinal() const;
  int group_meant(std::size_t k, const NounPhrase& noun) const;
  int just_related();
  int of_the_two(bool former, const std::vector<int>& busy) const;
  void read_relation(std::size_t k);
  void read_inverse(std::size_t k, PhraseSenses senses);
  void read_have(std::size_t k);
  void read_verb(std::size_t k);
  void read_break(std::size_t k);

  // What the next noun phrase is for.
  void place_root(std::size_t k, int mention);
  void place_reference(std::size_t k, int mention);
  std::vector<int> chained_targets(const Link& link, int reference) const;
  bool lies_there(std::size_t k) const;
  void place_content(std::size_t k, int mention);
  bool goes_on_with_reference(std::size_t k, const NounPhrase& noun) const;
  bool ended_list(const Link& link) const;
  bool goes_on_with_contents(std::size_t k, const NounPhrase& noun) const;

  std::vector<int> targets_for(const PhraseSenses& senses, PhraseSense::Direction direction, const NounPhrase& reference,
                               bool after_participle, int reference_mention) const;
  // What shares the place of `mention`. With a host: things that lie on it together, seats around one table.
  std::vector<int> joined_with(int mention, bool after_participle, bool in_center = false, const NounPhrase* host = nullptr) const;
  int fronted_host() const;
  int implied_side_host(const PhraseSenses& senses, const std::vector<int>& targets);
  int thing_of_zone(const NounPhrase& noun) const;
  void add_laden_stand(const PhraseSenses& senses, std::vector<int>& targets) const;
  void grow_for_sides(const Link& link, int target, int reference);
  bool frames_are_room() const;
  bool is_content(int mention) const;
  bool verb_at(std::size_t k) const;
  bool new_thing_at(std::size_t k) const;
  bool speaks_of_known(const NounPhrase& noun) const;
  bool place_comes_first(std::size_t k) const;
  std::size_t previous(std::size_t k) const;  // the chunk before, ignored ones left out; past the end if none
  // Who is meant where it is not said, or by "it" (`single`: one thing). -1: nobody.
  // With senses: only who makes sense of them. A pronoun may also mean what lies on the floor.
  int implied_reference(const std::vector<int>& targets, bool single = false, const PhraseSenses* senses = nullptr,
                        bool pronoun = false) const;
  int meant_by_it(const std::vector<int>& targets) const;
  bool take_all(std::size_t k);
  bool read_set(std::size_t k);
  bool each_has_those(std::size_t k);
  bool read_relative_place(std::size_t k);
  bool whole_group(std::size_t k, const NounPhrase& noun, int group) const;
  bool passes_count(std::size_t k);
  void seat_so_many(int tables, int people);
  bool denies_place(std::size_t k);
  bool excepts_from_nothing(std::size_t k) const;
  bool passes_role(std::size_t k);
  bool other_side(std::size_t k, const std::vector<int>& targets);
  void grow_for_hosts(int content, const std::vector<int>& hosts);
  bool means_wall(const NounPhrase& noun) const;
  bool means_other_corner(std::size_t k);
  void grow_contents(int host, std::size_t before);
  void mean_each_other(Link& link);
  std::vector<int> unplaced(const std::vector<int>& all, int last, int host) const;
  bool is_root(int mention) const;
  bool was_root(int mention) const;
  bool names_contents(std::size_t k) const;
  bool lies_at_end_of_host(Link& link);
  bool sits_at(int seat, int table) const;
  int looked_at_by(int mention, const std::vector<int>& but) const;
  int implied_group(const std::vector<int>& targets);
  int last_two(const std::vector<int>& targets);
  int meant_opening(const std::vector<int>& targets) const;
  void imply_adjective(int mention, std::size_t k);
  void hang(const std::vector<int>& targets, std::size_t k);

  const Chunk& chunk(std::size_t k) const { return document_.chunks[k]; }
  std::size_t next(std::size_t k) const;  // the next chunk that is not ignored
  bool is(std::size_t k, ChunkKind kind) const { return k < document_.chunks.size() && document_.chunks[k].kind == kind; }
  const NounPhrase& noun_of(int mention) const { return document_.mentions[static_cast<std::size_t>(mention)].noun; }
  Mention& mention_at(int mention) { return document_.mentions[static_cast<std::size_t>(mention)]; }
  bool is_thing(int mention) const { return !document_.mentions[static_cast<std::size_t>(mention)].items.empty(); }
  int add_link(Link link);
  Link& link_at(int link) { return document_.links[static_cast<std::size_t>(link)]; }
  void mark(std::size_t k, WordReading::Use use, std::string role);

  const Lexicon& lexicon_;
  Document& document_;
  References references_;

  // Of the text so far.
  int last_topic_ = -1;                           // what the former clause spoke of
  int fronted_topic_ = -1, former_fronted_ = -1;  // "to its left is a lamp": what stands there is by this; of this sentence, of the former
  std::vector<int> former_roots_;                 // of the sentence before
  // Of the sentence.
  int last_it_ = -1;                                        // what "it" meant last
  int outer_root_ = -1;                                     // "the desk, on which …, is": the subject that waits
  int one_side_link_ = -1;                                  // "on one side of the bed": "on the other" may follow
  std::size_t passed_over_ = static_cast<std::size_t>(-1);  // a chunk that was read with the one before
  std::size_t passed_until_ = 0;                            // the first chunk after those that were passed over together
  // Of the clause.
  std::vector<int> roots_, subject_, chain_, fronted_;
  std::vector<Joiner> root_joiners_;  // how each root was joined to the one before it
  std::vector<bool> root_modified_;   // has a modifier of its own
  std::vector<Frame> frames_;
  bool after_verb_ = false;  // what follows speaks of the subject
  bool after_participle_ = false;
  int reference_link_ = -1;  // the link whose reference comes next (or may be joined by "and")
  bool expects_reference_ = false, expects_content_ = false, skipping_ = false, negated_ = false, soft_ = false;
  bool hang_ = false;       // a participle or verb of hanging waits for its place
  bool centering_ = false;  // "center the bed on the wall"
  int last_reference_ = -1;
  int last_wall_said_ = -1;      // of the text
  int one_corner_ = -1;          // "in one corner": "in the other" may follow
  int place_link_ = -1;          // the link whose reference was a place of the room …
  std::size_t place_chunk_ = 0;  // … and where that stands
  int owner_ = -1;
  int relative_host_ = -1, where_host_ = -1, last_wall_ = -1;
  int arranging_link_ = -1, held_for_with_ = -1;  // "flank the bed with …": the link whose targets "with" names
  std::size_t sentence_links_ = 0;                // links before this sentence
  Joiner joiner_ = Joiner::kNone, joiner_before_relation_ = Joiner::kNone;
  std::size_t clause_start_ = 0;  // of roots_
  bool imperative_ = false;       // "place the bed …": what is named next is placed
  bool in_room_list_ = false;     // the roots are the room's list
};

}  // namespace layoutbox::offline
