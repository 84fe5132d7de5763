// The class behind build_relations; its members stand in relation_builder, relation_single, relation_for_each, relation_in_room,
// contents, support, mounts, relation_habits and contradictions.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder.h"
#include "layoutbox/plan/relations/relation_writer.h"

namespace layoutbox::offline {

class RelationBuilder : private RelationWriter {
 public:
  using RelationWriter::RelationWriter;
  void run();

 private:
  // What relativeTo says for a reference that is a part of the room.
  std::vector<std::string> room_reference(const NounPhrase& noun, RelationType type) const;
  mutable std::unordered_map<std::size_t, std::string> wall_of_;  // which wall a mention of one by its length means, by its first token
  std::string freer_of(const std::string& one, const std::string& other) const;
  // A door or window that has an id of its own, else the word, which normalisation gives to the default one.
  // As many of them as the words say: "between two windows".
  std::vector<std::string> opening_ids(const NounPhrase& noun) const;
  void complete_contents();
  // A thing and what it has: which of them a place behind the list is said of.
  struct HostBond {
    bool seats = false, ends_in_seat = false, list = false, carried = false, own = false;
    bool under_window = false;  // of that place only
    int last = -1;              // the mention behind which the place stands
  };
  std::optional<HostBond> bond_of(const Link& have) const;
  bool places_host(const Link& link, const Link& have, const HostBond& bond, int target) const;
  void place_host_of(const Link& have);
  int standing_before(int m) const;
  void place_between_hosts(const Link& have);
  void place_hosts();
  void place_before_walls();
  void let_into_tops();
  void let_in(int m, const CatalogEntry& host);
  void add_gap(const Link& link);
  // "to the right of the bed is a door" (relation_openings.cc)
  void add_by_openings(const Link& link);
  void add_alone(const Link& link, const std::vector<int>& targets);
  void add_relations(const Link& link);
  void take_height_or_note(const Link& link, const Mention& target, const NounPhrase& reference);
  void share_corner(const Link& link, const Mention& target);
  bool sit_in_corner(const Link& link, const Mention& target);
  void add_relations_to(const Link& link, const std::vector<int>& targets, const Mention& reference_mention);
  void add_rows();
  void add_stacks();
  void add_clusters();
  bool look_at_one_thing(const Mention& mention) const;
  void set_heights();
  void set_coordinates();
  void add_in_niche(const Link& link, const Mention& target);
  bool add_across_room(const Link& link, const Mention& target, const std::vector<int>& references);
  void add_wall_opposite(const Link& link, const Mention& target);
  std::string table_of(const std::string& seat) const;
  bool add_across_table(const Link& link, const Mention& target, int table);
  bool add_on_other_side(const Link& link, PhraseSense& sense, const Mention& target, int reference);
  // "eight chairs around the table, two of them at its ends": the others at its long sides.
  void complete_sides();
  // "on opposite walls", "both side walls": which walls they share out; empty where that is not said.
  std::vector<std::string> shared_walls(const NounPhrase& walls, bool boards) const;
  std::vector<std::string> shared_places(const PhraseSense& sense, const Mention& target, const NounPhrase& place) const;
  bool add_at_walls(const Link& link, const std::vector<int>& targets);
  void name_shelf(PhraseSense& sense, const NounPhrase& said, const NounPhrase& host) const;
  bool is_told_to_hang(const Link& link) const;
  void note_no_place(const Link& link, const Mention& target);
  std::string place_of(const Link& link) const;
  // "facing each other": every one of the targets and its neighbour.
  void stand_in_line(const Link& link, const std::string& next, const std::string& one, const NounPhrase& other,
                     const NounPhrase& neighbour);
  std::vector<int> by_tables(const std::vector<int>& targets) const;
  [[nodiscard]] std::vector<int> by_shares(const std::vector<int>& targets) const;
  void face_across(const Link& link, const std::vector<int>& things, const PhraseSense& sense);
  void leave_room_for_knees(const std::vector<int>& seats);
  void add_each_other(const Link& link, const std::vector<int>& said);
  bool are_desks(const std::vector<int>& items) const;
  void add_island(const Link& link, const std::vector<int>& members);
  void add_island_of_backs(const Link& link, const std::vector<int>& members);
  std::string carrier_of(const std::vector<std::string>& objects) const;
  std::vector<std::vector<std::string>> between_pairs(const std::vector<int>& parted, const std::vector<std::string>& all) const;
  std::vector<int> parted_by(const Link& link) const;
  int seen_across(const Link& link) const;
  std::vector<int> last_two_before(const Link& link) const;
  void add_between(const Link& link, const std::vector<int>& targets);
  void add_seats_near(const Link& link, const std::vector<std::string>& seats, int table);
  bool are_flankers(const std::vector<std::string>& pair, int middle) const;
  // Small things that stand on the host wherever they are said to be by it.
  bool lie_on(const Link& link, const std::vector<int>& items, int host) const;
  bool add_laden_sides(const Link& link, const PhraseSense& sense, const std::vector<int>& targets, int host);
  RelationType user_side(int host, bool one = false) const;  // one: the only seat at it
  bool seats_one_side(const Link& link, int seat, int host) const;
  void add_group(const Link& link, PhraseSense sense, const std::vector<int>& targets, const std::vector<int>& references,
                 const Mention* place);
  void add_single(const Link& link, PhraseSense sense, const Mention& target, const std::vector<int>& references, const Mention* place);
  std::string wall_behind(int item) const;
  void stand_in_corners();
  void place_on_tops();
  void sit_off_the_fire();
  void leave_corners_to_servers();
  void add_in_leg(const Link& link, const Mention& target, const NounPhrase& place);
  static bool is_curtain(const NounPhrase& noun);
  void add_in_room(const Link& link, const PhraseSense& sense, const Mention& target, const NounPhrase& place);
  bool is_side_on(const Link& link, const PhraseSense& sense, const NounPhrase& thing, const NounPhrase& host) const;
  bool says_top(const Link& link) const;
  static bool is_closed(const CatalogEntry& host);
  void settle_sense(const Link& link, PhraseSense& sense, const Mention& target, const std::vector<int>& references) const;
  bool add_drawn_up(const Link& link, const PhraseSense& sense, const Mention& target, const std::vector<int>& references);
  bool add_before_seats(const Link& link, const PhraseSense& sense, const Mention& target, const std::vector<int>& references);
  bool is_worked_at(const NounPhrase& noun) const;
  bool sits_at(const Link& link, const PhraseSense& sense, const NounPhrase& seat, const NounPhrase& table) const;
  bool add_by_one(const Link& link, const PhraseSense& sense, const Mention& target, int reference);
  bool add_under_hung(const Link& link, const PhraseSense& sense, const Mention& target, const std::vector<int>& references);
  bool add_by_carrier(const Link& link, const PhraseSense& sense, const Mention& target, int reference);
  std::string carrier_said(int item) const;
  bool says_over(const Link& link) const;
  void settle_lighting(PhraseSense& sense, const NounPhrase& lamp, const NounPhrase& lit) const;
  bool hangs_over(const PhraseSense& sense, const Mention& target, const std::vector<int>& references) const;
  bool add_over_table_between(const Link& link, const PhraseSense& sense, const Mention& target, const std::vector<int>& references);
  void add_for_each(const Link& link, PhraseSense sense, const Mention& target, const std::vector<int>& references);
  void add_in_middle(const Link& link, const PhraseSense& sense, const std::vector<int>& targets);
  bool is_tall_end(const Link& link, int target) const;
  bool in_ring(const std::vector<int>& targets, const std::vector<int>& references) const;
  void hang_beside(const std::vector<int>& targets, int host);
  bool add_at_sides(const Link& link, const PhraseSense& sense, const std::vector<int>& targets, int host);
  void add_shares(const Link& link, const PhraseSense& sense, const std::vector<int>& targets, const std::vector<int>& references);
  // Two of a kind that stand by beds (sofas …) "beside" one stand on either side of it.
  static bool is_mirror(const NounPhrase& noun);
  bool add_before_mirrors(const Link& link, const Mention& target, const std::vector<int>& references);
  bool flanks(const NounPhrase& thing, const NounPhrase& host) const;
  // What one sees into: things that it has are in it; on others they stand on top.
  bool holds_inside(const NounPhrase& host) const;
  bool has_inside(const NounPhrase& host) const;
  bool is_entered(const NounPhrase& host) const;
  bool is_hollow_by(const Link& link, const NounPhrase& host) const;
  // Who is in front of a desk or a screen looks at it; a screen in front of a bed looks at the bed.
  void add_look(const Link& link, RelationType type, int item, int reference);
  // "across from" is a gap as well, which holds even where the two cannot look at each other.
  void add_across(const Link& link, int item, const std::vector<std::string>& reference);
  void stand_across_openings();
  bool add_as_many(const Link& link, const PhraseSense& sense, const Mention& target, const std::vector<int>& references);
  std::optional<PhraseSense> sense_to_each_other(const Link& link, const std::vector<int>& said, const NounPhrase& target,
                                                 const NounPhrase& other) const;
  bool hang_at_sides(const Link& link, const std::vector<int>& targets, const std::vector<int>& references) const;
  std::vector<int> bearers_of(std::vector<int> things) const;
  bool add_rows_behind(const Link& link, const PhraseSense& sense, const Mention& target, int barrier);
  bool stands_across(const Relation& r, const std::string& opening) const;
  void stand_at_wall_across(const std::string& opening, const std::string& wall);
  bool stands_at_walls(const NounPhrase& noun) const;
  void add_seats_at_sides(const Link& link, const std::vector<int>& seats, int table);
  static bool fits_beside_in_corner(const NounPhrase& noun);
  void add_corners(const Link& link, const Mention& target, const NounPhrase& corner);
  bool is_placed(int item) const;
  void keep_standing(std::vector<int>& items) const;
  bool is_placed_apart(const std::vector<int>& items, bool of_table = false) const;
  bool is_related(int item, int other) const;
  // What a thing has: on it, in it, at it, by it, as the two allow.
  void add_contents(const Link& link);
  std::vector<int> hosts_of(const Link& link, int m) const;
  std::vector<int> carriers_among(const Link& link, int m, std::vector<int> hosts) const;
  void share_out(const Link& link, RelationType type, const std::vector<int>& items, const std::vector<int>& hosts);
  void add_seats(const Link& link, const std::vector<int>& seats, const std::vector<int>& tables);
  void add_hung_content(const Link& link, const Mention& target, const std::vector<int>& hosts);
  bool is_joined_by(const Link& link) const;
  bool is_sat_on(const NounPhrase& noun) const;
  void add_content(const Link& link, const Mention& target, const std::vector<int>& hosts);
  void add_standing_content(const Link& link, const Mention& target, const std::vector<int>& hosts);
  // "holding", "displaying": the host carries it, whatever it is.
  bool shows(const Link& link) const;
  bool says_inside(const Link& link) const;
  void add_hanging(const Link& link);
  // "a wall-mounted TV", "a floating shelf".
  void add_mounts_said();
  // Rows of desks that face a board look its way; only those before it look straight at it.
  // "a reading corner with a rug and beanbags": together, in one corner (zone_habits.cc).
  static constexpr int kTogether = 100;
  int heart_of(const Zone& zone) const;
  void keep_zones();
  void seat_in_zone(const Zone& zone);
  bool has_usual_place(const CatalogEntry& entry, const CatalogEntry& heart) const;
  void keep_in_zone(const Zone& zone, int item, int heart);
  // "an open bookshelf as a divider" (dividers.cc)
  bool may_divide(int item) const;
  int side_at(std::size_t i) const;
  int other_side(int divider, int side) const;
  int only_twin(int side) const;
  void widen(int divider, const std::vector<int>& sides = {});
  void divide(std::size_t word);
  void part_groups();
  void part_halves();
  void stand_out_from_walls();
  void share_like_sides();
  void divide_groups();
  // A kitchen told by its units (kitchens.cc)
  bool stands_in_run(const std::string& object) const;
  std::vector<std::string> units_of_run() const;
  void build_in(std::size_t oven);
  void build_in_ovens();
  void stand_hobs();
  void turn_other_leg(const std::vector<std::string>& units);
  void line_up_units(const std::vector<std::string>& units);
  std::string counter_of_run(const std::vector<std::string>& units) const;
  void place_at_counter(Relation& relation, const std::string& counter, bool left);
  void place_in_run(Relation& relation, const std::vector<std::string>& units);
  void share_out_over_run(const std::vector<std::string>& units);
  void settle_kitchen();
  std::string told_wall_of(const std::string& unit) const;
  void stand_at_walls_of_run(const std::vector<std::string>& units);
  void leave_window_to_sink();
  void add_front();
  void show_where_seated();
  bool shows_in(RoomRegion region) const;
  void middle_what_is_surrounded();
  void add_end_walls();
  void serve_towards_room(const SceneObject& counter, const std::string& end);
  void hang_hoods();
  void screen_from_door();
  // The new relation, which no text says but use does; it may be given up.
  Relation& add_habit(RelationType type, std::vector<std::string> targets, std::vector<std::string> references, int weight,
                      std::string why);
  // … what follows from what the text says, and holds as that does.
  Relation& conclude(RelationType type, std::vector<std::string> targets, std::vector<std::string> references, std::string why);
  void lay_beds_along();
  void share_nightstand();
  void head_row_of_beds();
  void keep_to_one_wall();
  void turn_two_sided_tables();
  void seat_around_faced_tables();
  void turn_screens_to_viewers();
  void make_islands();
  bool is_only_by_opening(const std::string& object) const;
  void seat_at_only_table();
  void seat_at_placed_table();
  void seat_viewers();
  void work_at_windows();
  void place_by_covered_windows();
  void watch_from_afar();
  void turn_to_what_hangs_over();
  void stand_abreast();
  void stand_between_likes();
  bool speaks_of_ends() const;
  void stand_at_ends();
  void stand_rows_in_halves();
  void stand_under_wall_cabinets();
  void line_up(const std::string& first, const std::string& next);
  const SceneObject* mirror_looked_into(const Relation& looks) const;
  void hang_mirrors_over_counters();
  void share_doors();
  void hang_bed_curtains();
  void hang_within();
  void stand_within();
  void stand_before_sitters();
  void sit_in_aids();
  void touch_back_to_back();
  void lie_along_walls();
  void wait_at_walls();
  void sit_together();
  void stand_at_both_sides();
  bool is_eaten_at(const NounPhrase& noun) const;
  void seat_those_who_wait();
  bool alone_faces(const Relation& facing) const;
  void face_as_group();
  void face_as_crowd();
  bool sits_at(const std::string& seat) const;
  // What a reader takes for granted; soft, and marked as ours.
  void add_habits();
  void stand_before_middles();
  void keep_sides_near();
  void dine_at_plain_tables();
  void seat_in_windows();
  void sit_in_u();
  void sit_across_table();
  void leave_room_to_serve();
  void leave_room_at_wall();
  void sit_at_windows();
  void park_cars();
  void sit_before_mirrors();
  void sit_at_what_they_face(const std::vector<std::string>& seats);
  void stand_under_counters();
  bool is_only_table(std::size_t index) const;
  // How a thing is held where the relations say otherwise than its kind.
  bool settle_on_floor(SceneObject& object, const NounPhrase& noun);
  bool settle_tall(SceneObject& object, const NounPhrase& noun);
  void settle_stands();
  void fill_whole_walls();
  void lengthen_counters();
  void settle_seat_heights();
  void leave_middle_to_rows();
  void make_room_between();
  void seat_in_reach(const std::vector<std::pair<std::string, std::string>>& in_reach);
  // Small things and the tables that the lamps above them hang over.
  std::vector<std::pair<std::size_t, std::string>> lit_on_tables() const;
  void center_on_walls();
  void settle_mount(std::size_t index);
  bool over_table(const std::string& object) const;
  // What the relations say of how it is held; `beside`: by what stands on the floor.
  struct Held {
    bool wall = false, ceiling = false, supported = false, beside = false, above = false;
  };
  bool is_under_piece(const Relation& relation) const;
  Held how_held(const SceneObject& object, const NounPhrase& noun) const;
  void settle_on_wall(SceneObject& object, const NounPhrase& noun);
  void specialise(SceneObject& object, const NounPhrase& noun, std::initializer_list<const char*> kinds) const;
  // Small things beside small things share what those stand on (support.cc).
  void part_from_neighbours();
  void leave_small_vessels();
  void stand_carriers_at_walls();
  std::string own_of_several(std::size_t index, const std::string& host) const;
  void carry_support();
  void seat_on_platforms();
  void drop_implied_support();
  std::string said_support(const std::string& object) const;
  bool hangs_opposite(std::size_t index) const;
  bool is_small(std::size_t index) const;
  bool may_lean(std::size_t index) const;
  std::vector<std::vector<std::size_t>> small_neighbours() const;
  std::string host_with_room(std::string host, const NounPhrase& thing) const;
  std::string host_spoken_of(std::size_t index);
  bool is_sat_round(const std::string& table, const NounPhrase& thing) const;
  std::size_t sentence_of(std::size_t token);
  bool only_small(const std::vector<std::string>& ids) const;
  const CatalogEntry* wall_kind(const NounPhrase& noun) const;
  bool has_wall_kind(const NounPhrase& noun) const;
  bool is_board_under(const Relation& relation, const NounPhrase& noun) const;
  bool hangs_on_hooks(const std::string& object) const;
  bool is_said_to_hang(std::size_t index) const;
  bool stands_on_fellow(const Mention& things, std::size_t which) const;
  // On or in a thing other than a rug.
  bool lies_folded(const std::string& object, const NounPhrase& noun) const;
  bool is_carried(const std::string& object) const;
  void soften_middles();
  void soften_overhead();
  void stand_before_glass();
  void note_contradictions();
  std::vector<std::pair<std::string, Mm>> heights_;
  std::unordered_set<int> on_floor_;    // mentions that are told to be there: "… and a basket on the floor"
  std::vector<std::size_t> sentences_;  // of each token
};

}  // namespace layoutbox::offline
