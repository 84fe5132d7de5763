// The joint choice: of all ways to read a sentence's units the likeliest, by a beam from left to right over what stays open.
#pragma once

#include <functional>
#include <vector>

#include "layoutbox/plan/reading/reading.h"
#include "layoutbox/plan/reading/sense_score.h"
#include "layoutbox/plan/reading/tree.h"

namespace layoutbox::offline {

// It brings a thing in: "a lamp", "another lamp", "two lamps".
inline bool is_new_thing(const NounPhrase& noun) {
  return noun.kind == NounKind::kObject && (noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother ||
                                            (noun.determiner == Determiner::kNone && noun.count > 0));
}

// "it", "one", "each", "the other": speaks of what was named. "Another one" is new.
bool speaks_of_others(const NounPhrase& noun);
// "another one", "a smaller one", "high ones": brings in more of a kind.
bool is_another(const NounPhrase& noun);

class Decoder {
 public:
  // All must outlive the decoder. `tree` says what syntax thinks of the sentence.
  Decoder(const Lexicon& lexicon, const Document& document, const Sentence& sentence, const SentenceTree& tree, const TextSoFar& before)
      : lexicon_(lexicon), document_(document), sentence_(sentence), tree_(tree), before_(before), sense_(lexicon.catalog()) {
    find_known();
  }
  SentenceReading run();

 private:
  struct State {
    double score = 0;
    std::vector<UnitReading> units;
    std::vector<int> frontier;       // nouns that may still be spoken of, the clause's own first
    std::vector<int> fronted;        // places that wait for their things
    std::vector<int> outer_fronted;  // "Above the mantel, on which …, hangs": the places whose thing is yet to come
    std::vector<int> roots;          // of all clauses
    int waiting = -1;                // the place or having whose noun comes next
    int place = -1;                  // the last place that was complete
    int relative = -1;               // whom a relative clause speaks of
    int told = -1;                   // … whom the last one spoke of, which "and" may go on with
    bool verb = false;               // the clause has its verb
    bool imperative = false;
    bool participle = false;  // since the last noun
    bool room_list = false;   // the clause lists what the room has
    int first_subject = -1;   // of the clause's verb
    int inverted = -1;        // a verb that waits for its subject
    int where = -1;           // "a table where …": the table
    int outer = -1;           // "the desk, on which …, is": the subject that waits
    int it = kNobody;         // what the last pronoun meant
    int by = kNobody;         // … by which something was placed that is none of its own
  };
  struct Action {
    std::size_t state = 0;
    double score = 0;  // of the state with it
    int kind = 0;
    int unit = -1;   // a noun or place that it goes with
    int first = -1;  // the first member of the list that shares it
    Referent meant = kNobody;
    bool list = false;
  };
  enum Kind {
    kFill,      // the noun that was waited for
    kNewRoot,   // opens a clause
    kNextRoot,  // goes on with the clause's list
    kElided,    // contents of what `unit` said before
    kSameList,  // … with the list of `unit`
    kSpeakOf,   // speaks of `meant`
    kFront,     // a place that comes first
    kFrontAlone,
    kAttach,  // a place of `unit`
    kAttachInverse,
    kAttachAlone,
    kHaveRoom,
    kHaveThing,
    kFinite,  // the clause's verb
    kCommand,
    kInvert,  // a verb after places
    kRelate,  // a relative clause about `unit`
    kPass,
  };

  struct Candidate {
    Referent referent = kNobody;
    double score = 0;
    bool list = false;
  };
  // Looks at one who may be meant, a list if so said; whether it is a new one.
  using Trial = std::function<bool(Referent, double order, bool list)>;

  void find_known();
  // Adds the ways to go on from state s with unit u.
  void noun_actions(std::size_t s, int u);
  void waited_actions(std::size_t s, int u);
  void waited_content_actions(std::size_t s, int u);
  void waited_member_actions(std::size_t s, int u);
  void list_actions(std::size_t s, int u);
  int open_list(const State& state) const;
  bool goes_on_with_clause(const State& state, int u) const;
  bool never_closes(const State& state, int u) const;
  bool on_part_of_top(const State& state, int u) const;
  double told_nothing(int u) const;
  void root_list_actions(std::size_t s, int u, double gain);
  bool placed_by_clause(const State& state, int u) const;
  void member_actions(std::size_t s, int u);
  bool is_part_of_other(int u) const;
  void place_actions(std::size_t s, int u);
  Referent meant_by_which_before(const State& state, int u) const;
  void relative_place_actions(std::size_t s, int u);
  void opening_place_actions(std::size_t s, int u);
  void first_place_actions(std::size_t s, int u);
  void alone_actions(std::size_t s, int u);
  void front_alone_actions(std::size_t s, int u, double gain);
  void alone_of_member(std::size_t s, int u, std::size_t level, int nearer);
  void alone_of_list(std::size_t s, int u, std::size_t level, const Candidate& meant);
  bool is_at_center_of_host(const State& state, int u, Referent member) const;
  double own_center_score(const State& state, int u, int member) const;
  void alone_of_room(std::size_t s, int u, std::size_t level, double gain);
  void attach_actions(std::size_t s, int u, Kind kind);
  bool says_around(int u) const;
  Referent whole_of(const State& state, int u, Kind kind, int member) const;
  void attach_to(std::size_t s, int u, Kind kind, std::size_t level);
  void have_actions(std::size_t s, int u);
  void finite_have_actions(std::size_t s, int u);
  bool is_aside_of(const State& state, int u, int member) const;
  double finite_score(const State& state, int u, int member, int steps) const;
  double own_place_score(int u) const;
  bool tops_clause(const State& state, int u) const;
  bool is_told_by_itself(const State& state, int member) const;
  bool is_placed_apart(const State& state, int member) const;
  int first_of_plural(const State& state, int last) const;
  std::optional<double> retold_score(const State& state, int u) const;
  void verb_actions(std::size_t s, int u);
  void relative_actions(std::size_t s, int u);
  void add(std::size_t s, Kind kind, double gain, int unit = -1, int first = -1, Referent meant = kNobody, bool list = false);
  void apply(State& state, const Action& action, int u) const;
  void apply_noun(State& state, const Action& action, int u) const;
  void fill_fronted(State& state, int u) const;
  void apply_fill(State& state, int u) const;
  void apply_root(State& state, const Action& action, int u) const;
  void apply_member(State& state, Referent meant, int u) const;
  void front_place(State& state, const Action& action, int u) const;
  void apply_predicate(State& state, const Action& action, int u) const;
  void apply_finite(State& state, const Action& action, int u) const;
  void take_subject(State& state, const Action& action, int u) const;
  void fill_place(State& state, int place, int u) const;
  void begin_clause(State& state) const;
  void cut_frontier(State& state, int unit) const;

  double attach_score(const State& state, int u, int level, bool inverse) const;
  double likely_place_score(const State& state, int u, int member) const;
  double share_score(const State& state, int member, int u, Referent implied = kNobody) const;
  double share_kind_score(const State& state, int member, int u, Referent implied, const NounPhrase& by) const;
  bool is_pair(const State& state, int member, int u) const;
  bool lies_on_placed(int u, const NounPhrase& host) const;
  double closing_score(const State& state, int u, Referent owner, const NounPhrase& host) const;
  double content_list_score(const State& state, int member, int u) const;
  bool told_alike(int predicate, int u) const;
  bool is_bare_after_comma(int u) const;
  bool looked_at_elsewhere(const NounPhrase& host, const NounPhrase& noun) const;
  double list_kind_score(const State& state, int member, int u, std::size_t length) const;
  double reference_list_score(const State& state, int member, int u) const;
  double reference_score(const State& state, int place, Referent reference) const;
  bool comes_with(const State& state, Referent member) const;
  double habit_score(const State& state, int place, Referent subject, Referent other, const PhraseSenses& senses) const;
  double part_score(const State& state, int place, const NounPhrase& part, Referent meant) const;
  void repeated_part_actions(std::size_t s, int u);
  double content_score(const State& state, int predicate, Referent content) const;
  bool speaks_of_no_thing(const State& state) const;
  bool lists_on_it(int u) const;
  bool carries_list(int predicate) const;
  double host_of_top_score(const State& state, int u, int member) const;
  bool goes_on_apart(const NounPhrase& host, const NounPhrase& noun, Joiner joiner) const;
  bool has_top_for(const NounPhrase& host, const NounPhrase& noun) const;
  bool stands_small(const NounPhrase& noun) const;
  bool ends_objects(int predicate, int u) const;
  bool is_outer_item(int u, const NounPhrase& former) const;
  bool may_come_with(const NounPhrase& host, const NounPhrase& noun) const;
  bool placed_by_unsaid(int u) const;
  bool placed_by_it(int u) const;
  bool placed_by_host(int u) const;
  bool comes_with_it(const State& state, int u) const;
  double array_score(const State& state, int u, int member, bool many) const;
  double before_own_host_score(const State& state, Referent referent, Referent subject, const PhraseSenses& senses,
                               const NounPhrase* noun) const;
  bool is_fresh(int u) const;
  bool hangs_twice(const State& state, int u, int member) const;
  double parallel_score(const State& state, int u, int member) const;
  Referent carrier_before(const State& state, int u) const;
  bool lies_twice(const State& state, int u, int member) const;
  bool names_own_carrier(int u) const;
  bool stands_otherwise(const State& state, int u, int member) const;
  bool share_wall(const State& state, int member, int u) const;
  bool stands_in_middle(const State& state, int u, int member) const;
  bool lies_on_unplaced(const State& state, int u, int member) const;
  bool is_led_to_wall(const State& state, int u, int member) const;
  bool is_one_of_several(int u) const;
  bool nothing_nearer(const State& state, std::size_t level) const;
  Referent side_ahead(int u, const PhraseSenses& senses) const;
  bool begins_with_side(int u) const;
  Referent sides_ahead(int u, const PhraseSenses& senses) const;
  Referent side_host(const State& state, int u, const PhraseSenses& senses) const;
  std::optional<double> room_side_score(const State& state, int u) const;
  double end_score(const State& state) const;

  // Whom a pronoun, a member or an unsaid reference may mean, the likeliest first; `subject`: who is placed by it.
  // `first_subject`: the first of the list that is placed with it.
  std::vector<Candidate> antecedents(const State& state, Referent subject, const PhraseSenses* senses, const NounPhrase* noun,
                                     int first_subject = -1) const;
  std::vector<Candidate> carriers(const State& state, Referent subject) const;
  void contents_of(const State& state, int u, const NounPhrase& noun, double order, const Trial& trial) const;
  void named_last(const State& state, const Trial& trial) const;
  void others_of(const State& state, const NounPhrase& noun, double order, const Trial& trial) const;
  double clause_antecedents(const State& state, const NounPhrase* noun, const Trial& trial) const;
  bool carries_first(const State& state, int u) const;
  double topics_before(const State& state, const NounPhrase* noun, const Trial& trial, double order) const;
  double references_before(const State& state, const NounPhrase* noun, const Trial& trial, double order) const;
  bool placed_by_before(const State& state, int u) const;
  void text_antecedents(const State& state, const PhraseSenses* senses, const NounPhrase* noun, const Trial& trial, double order) const;
  double by_small_score(const State& state, const NounPhrase& target, Referent referent, const PhraseSenses& senses) const;
  double before_other_score(const State& state, const NounPhrase& target, Referent referent, const PhraseSenses& senses) const;
  bool is_carried(const State& state, Referent referent) const;
  bool lies_on(const State& state, Referent one, Referent other) const;
  bool several_last_of(const State& state, Referent list) const;
  bool is_tied_to(const State& state, Referent referent, Referent subject, const PhraseSenses* senses, bool list) const;
  bool is_told_on_floor(const State& state, int subject) const;
  double antecedent_place_score(const State& state, Referent referent, Referent subject, const PhraseSenses& senses,
                                const NounPhrase* noun) const;
  bool is_over_or_under(const State& state, Referent one, Referent other) const;
  double apart_score(const State& state, Referent referent, Referent subject, const PhraseSenses& senses) const;
  bool is_low_and_small(const NounPhrase& noun) const;
  double standing_score(const State& state, Referent referent, Referent subject, const PhraseSenses& senses) const;
  bool is_of_one_group(const State& state, Referent group, Referent subject, const NounPhrase* noun) const;
  int things_of(const State& state, Referent referent, bool list) const;
  bool is_list_beside_pair(const State& state, Referent list, int subject) const;
  bool consider(std::vector<Candidate>& all, const State& state, Referent referent, double order, Referent subject,
                const PhraseSenses* senses, const NounPhrase* noun, bool list) const;

  static const UnitReading& read_as(const State& state, int u) { return state.units[static_cast<std::size_t>(u)]; }
  static UnitReading& read_as(State& state, int u) { return state.units[static_cast<std::size_t>(u)]; }
  const Unit& unit(int u) const { return sentence_[static_cast<std::size_t>(u)]; }
  const Chunk& chunk(int u) const { return document_.chunks[unit(u).chunk]; }
  bool is(int u, UnitKind kind) const { return u >= 0 && u < static_cast<int>(sentence_.size()) && unit(u).kind == kind; }
  bool follows(int u, UnitKind kind) const { return is(u + 1, kind) && unit(u + 1).joiner == Joiner::kNone && !unit(u + 1).clause; }
  const NounPhrase& noun_of(const State& state, Referent referent) const;
  bool is_thing(const State& state, Referent referent) const;
  bool same(const State& state, Referent one, Referent other) const;
  bool several(const State& state, Referent referent) const;
  bool is_known(const State& state, int u) const;
  const NounPhrase& called_before(const State& state, int u) const;
  bool is_definite(const State& state, int u) const;
  std::vector<int> list_of(const State& state, int last, int first) const;
  Referent host_of(const State& state, int content) const;
  const std::string& word(int u) const { return document_.tokens[chunk(u).first].text; }
  const PhraseSenses& alone_senses(int u) const;
  bool by_each_other(int u) const;
  bool is_own_top(const State& state, int u) const;
  int doer_of_relative(const State& state, int u) const;
  int past_places(int u) const;
  bool brings_by_verb(int u) const;
  bool goes_on_in_turn(const State& state, int u) const;
  bool says_its(int u) const;
  bool is_subject(int u) const;
  bool heads_subject(int u) const;
  double fronted_score(const State& state, int u) const;
  double each_has_score(const State& state, int member, int u, Referent owner) const;
  double own_top_score(double so_far, const NounPhrase& noun, const NounPhrase& host, const NounPhrase& target) const;
  double below_seat_score(const State& state, const NounPhrase& target, Referent referent) const;
  bool strewn_past_host(const State& state, int place, int u) const;
  bool has_place(int u) const;
  bool has_own_place(int u) const;
  bool verb_like(int u) const;
  bool finite_place(int u) const;

  const Lexicon& lexicon_;
  const Document& document_;
  const Sentence& sentence_;
  const SentenceTree& tree_;
  const TextSoFar& before_;
  SenseScore sense_;
  std::vector<State> states_;
  std::vector<Action> actions_;
  NounPhrase nothing_;
  std::vector<bool> known_;  // of each unit: a noun that was named before
};

}  // namespace layoutbox::offline
