// The class behind read_units; its members stand in units and the files unit_*.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/units.h"

namespace layoutbox::offline {

class UnitReader {
 public:
  UnitReader(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), document_(document) {}
  std::vector<Sentence> run();

 private:
  // How many chunks are looked back at, at most: keeps long texts linear.
  static constexpr std::size_t kFarthestBack = 400;

  void read(std::size_t k);
  void end_sentence();
  Unit& add(UnitKind kind, std::size_t k);
  void mark(std::size_t k, WordReading::Use use, const std::string& role);

  bool is_size_of_way(std::size_t k) const;
  void read_break(std::size_t k);
  bool after_room(std::size_t k) const;
  void read_place(std::size_t k);
  bool centers_in_room(std::size_t k);
  bool tells_which(std::size_t k);
  bool names_doer(std::size_t k);
  bool takes_order(std::size_t k);
  void add_place(std::size_t k, const PhraseSenses& senses);
  void add_shorter_senses(std::size_t k);
  void choose_way(std::size_t k);
  void read_have(std::size_t k);
  void read_verb(std::size_t k);

  // Purposes and what is not wanted.
  void read_purpose(std::size_t k);
  bool is_bare_list() const;
  bool keeps_place_for(std::size_t k);
  bool wishes_to(std::size_t k);
  bool gives_reason(std::size_t k);
  bool brings_each(std::size_t k);
  bool is_for_somebody(std::size_t k) const;
  bool names_furniture_before(std::size_t k) const;
  bool purpose_ends_before_verb(bool comma, std::size_t n) const;
  bool purpose_ends(std::size_t k, std::size_t n) const;
  bool place_after_purpose(std::size_t k) const;
  bool follows_whom(std::size_t k) const;
  bool closes_purpose(std::size_t k) const;
  bool follows_purpose(std::size_t k) const;
  bool denies_before(std::size_t k);
  bool names_contents(std::size_t k) const;
  bool passes_keeper(std::size_t k);
  bool passes_placer(std::size_t k);
  bool passes_trade(std::size_t k);
  bool passes_like(std::size_t k);
  bool passes_depicted(std::size_t k);
  bool is_picture(const NounPhrase& noun) const;
  bool ends_comparison(std::size_t k) const;
  bool ends_contact_clause(std::size_t k) const;
  bool reads_as_verb(std::size_t k) const;
  bool passes_count(std::size_t k);
  bool is_enough(std::size_t k) const;
  bool is_one_for_each(std::size_t k) const;
  std::size_t seats_in_rows_before(std::size_t k) const;
  static void count_for(NounPhrase& things, int people);
  bool passes_role(std::size_t k);
  bool serves_for(std::size_t k, std::size_t role);
  bool brings_for_each(std::size_t k);
  void seat_so_many(NounPhrase& tables, int people) const;
  const PhraseSenses* kept_free(std::size_t r, std::size_t n);
  bool denies_place(std::size_t k);
  bool excepts_from_nothing(std::size_t k) const;

  // What is told by the way.
  std::size_t clause_end(std::size_t k) const;
  bool is_person(std::size_t k) const;
  bool says_what_is_there(std::size_t first, std::size_t last) const;
  bool says_where_known_is(std::size_t first, std::size_t last) const;
  bool passes_aside(std::size_t k);
  bool passes_apposition(std::size_t k);
  bool does_it_there(std::size_t k) const;
  bool names_thing(std::size_t k) const;
  bool is_done_here(std::size_t k) const;
  std::size_t subject_of_being(std::size_t k) const;
  bool is_said_of_subject(std::size_t k);
  bool is_named_before(std::size_t k, std::string_view head) const;
  bool is_title(std::size_t k) const;
  bool is_addressed(std::size_t k) const;
  bool is_within_room(std::size_t k) const;
  bool sums_up(std::size_t k) const;
  bool counts_before(std::size_t k);
  bool announces_things(std::size_t k) const;
  bool is_address(std::size_t k) const;
  bool is_one_of_rooms(std::size_t k) const;
  bool is_used_in_place(std::size_t k) const;
  void take_told(std::size_t k);
  bool opens_command(std::size_t k);
  bool inverts(std::size_t k) const;
  bool is_figure(std::size_t k) const;

  // What is there for each.
  int shares_of(std::size_t k) const;
  bool shares_by_purpose(std::size_t k);
  bool shares_by_subject(std::size_t k);
  void open_share(std::size_t first, std::size_t last, int shares);
  void has_unsaid(std::size_t k);
  void has_its_own(std::size_t k);
  bool is_for_all(std::size_t k) const;
  const PhraseSenses* place_of_topic(std::size_t k) const;
  bool opens_topic(std::size_t k);

  // Nouns.
  bool says_nothing_but_there(std::size_t k);
  void place_at_named_wall(std::size_t k);
  bool is_told_by_the_way(std::size_t k);
  void read_noun(std::size_t k);
  bool is_placed_itself(std::size_t k) const;
  bool is_let_in(const NounPhrase& object) const;
  bool is_at_table(const NounPhrase& object) const;
  bool says_where_room_is(std::size_t k);
  bool is_past(const NounPhrase& noun) const;
  void shares_out(std::size_t k);
  bool takes_new_share(std::size_t k) const;
  bool speaks_again(std::size_t k) const;
  bool is_topic_before_colon(std::size_t k) const;
  bool is_placed_topic(std::size_t k) const;
  bool goes_on_to_or(std::size_t k) const;
  bool lists_placed(std::size_t n) const;
  bool denies_doors(std::size_t k) const;
  bool turns_to_furniture(std::size_t k, std::size_t n) const;
  bool is_living(std::size_t k) const;
  bool passes_company(std::size_t k);
  void name_room(const NounPhrase& noun);
  bool is_where_somebody_is(const NounPhrase& noun) const;
  bool tells_where_room_is(const NounPhrase& noun) const;
  void settle_noun(std::size_t k);
  void settle_place_words(std::size_t k);
  bool repeats_place(std::size_t k);
  void repeat_owner(std::size_t k);
  void mean_group(std::size_t k);
  void mean_twin(std::size_t k);
  void mean_side_of_room(std::size_t k);
  void mean_end_of_room(std::size_t k);
  bool stands_in_room(std::size_t k) const;
  std::size_t carrier_of(std::size_t thing) const;
  const PhraseSenses* end_of_room(std::size_t k) const;
  bool is_side_of_room(std::size_t k) const;
  std::string run_side_of_room(std::size_t k) const;
  bool tells_of_end_of_room(std::size_t k) const;
  bool tells_of_room_end(std::size_t k) const;
  bool is_great_table(std::size_t thing) const;
  bool is_large_by_itself(std::size_t thing) const;
  bool is_one_not_wanted(std::size_t k) const;
  void mean_fabric(std::size_t k);
  void mean_fire(std::size_t k);
  void mean_thing_of_zone(std::size_t k);
  void place_at_spot(std::size_t k);
  bool is_unread_verb(std::size_t k) const;
  bool wall_has(std::size_t k) const;
  bool passes_spot(std::size_t k);
  bool passes_patch(std::size_t k);
  bool is_unlisted_verb(std::size_t k) const;
  bool passes_light_noun(std::size_t k);
  bool stresses(std::size_t k);
  void mean_desktop(std::size_t k);
  void mean_owner_of_spot(std::size_t k);
  void mean_own_part(std::size_t k);
  void mean_hand_of_owner(std::size_t k);
  const NounPhrase* subject_of_verb(std::size_t verb) const;
  void place_by_verb(std::size_t k);
  bool is_content_of_thing() const;
  bool is_part(std::size_t k) const;
  bool names_known(std::size_t k) const;
  bool is_thing_in_company(std::size_t k) const;
  bool is_told_where(std::size_t k) const;
  bool lists_on_thing(std::size_t k) const;
  bool stands_among_things(std::size_t k) const;
  bool inverts_after(std::size_t k) const;
  bool tells_of_pot(std::size_t k);
  bool is_own_frame(std::size_t k) const;
  void leave_out_part(std::size_t k, bool goes_on);
  bool says_room_seats(std::size_t k);
  // The latest noun of the sentence, past the end if there is none.
  std::size_t last_noun() const;
  std::size_t subject_before() const;
  bool after_place() const { return !units_.empty() && units_.back().kind == UnitKind::kPlace && joiner_ == Joiner::kNone; }

  const Chunk& chunk(std::size_t k) const { return document_.chunks[k]; }
  bool is(std::size_t k, ChunkKind kind) const { return k < document_.chunks.size() && document_.chunks[k].kind == kind; }
  std::size_t next(std::size_t k) const;      // the next chunk that is not ignored
  std::size_t previous(std::size_t k) const;  // past the end if there is none

  const Lexicon& lexicon_;
  Document& document_;
  std::vector<Sentence> sentences_;
  Sentence units_;
  Joiner joiner_ = Joiner::kNone;
  bool clause_ = false, where_ = false, soft_ = false, skipping_ = false, negated_ = false;
  bool denies_list_ = false;                         // "Avoid: a rug, a TV": all that the sentence goes on to list
  bool instead_ = false;                             // … "instead of", "rather than"
  bool contrasted_ = false;                          // what is not wanted is named instead of the thing before it: "shower not bath"
  bool doing_ = false;                               // what is skipped is what a person does
  std::size_t told_ = static_cast<std::size_t>(-1);  // … with this thing
  std::size_t passed_over_ = static_cast<std::size_t>(-1), passed_until_ = 0;
  int share_ = 1;                    // so many times is there what the sentence brings in: "for every place …"
  bool named_ = false;               // a noun was read
  int one_corner_ = -1, wall_ = -1;  // chunks: "in one corner", the last wall
  std::size_t order_ = kNoOrder;     // "from left to right", said before its list
  bool in_brackets_ = false;         // … between commas
  std::size_t owner_ = static_cast<std::size_t>(-1);
};

}  // namespace layoutbox::offline
