// What the catalogue knows of good rooms, as soft constraints in the same small form as the relations. Each file habits_*.cc has those of
// one kind.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/priors/formation.h"

namespace layoutbox::placement {

// Points per metre missed; docs/solve.md says where they come from.
inline constexpr int kBackToWall = 900, kBeside = 500, kFaces = 600, kAtWall = 150, kSeatToWall = 700, kRug = 300, kHint = 800,
                     kHintOfTurn = 20000, kOpeningPlace = 80, kHangs = 200, kSits = 400, kCurtain = 900, kMiddle = 40, kLight = 25,
                     kFormation = 150, kInLine = 1000;
// Between the seats that are before mirrors; the mirrors hang as far apart as those need.
inline constexpr Mm kBetweenMirrored = 450;

inline std::int64_t area_of(const Item& item) { return std::int64_t{item.states[0].size.width} * item.states[0].size.depth; }

// Twice the middle of the floor's extent.
inline Linear room_mid2(const PlacementModel& model, int axis) { return {std::int64_t{model.room.lo[axis]} + model.room.hi[axis]}; }

// The states in which its front looks that way.
std::uint64_t states_looking(const Item& item, Direction direction);

class Habits {
 public:
  explicit Habits(PlacementModel& model);
  void add(int index);
  void spread();

 private:
  void stand(int index);
  void stand_by_itself(int index, bool looks);
  Constraint& habit(const std::string& what, int item, int weight, Formula formula, std::vector<int> hosts = {});
  std::vector<int> items_of_kinds(const std::vector<std::string>& kinds, int except) const;
  int rank_of(int item) const;
  // The relations of the scene that speak of it.
  const std::vector<const Relation*>& said_of(int item) const { return said_of_[static_cast<std::size_t>(item)]; }
  bool related(int a, int b) const;
  bool only_related_by(int a, int b, RelationSet types) const;
  bool related_as_target(int item, int reference, RelationType type) const;
  bool related_by_any(int a, int b, RelationSet types) const;
  bool placed_by_relation(int item) const;
  bool only_told_opening(int item) const;
  bool is_low_aside(int item) const;
  bool told_to_stand_free(int item) const;
  void keep_hint(int item);
  void keep_turn(int item, double degrees);
  static std::vector<Side> used_sides(const Item& item) { return item.object->used_sides.value_or(item.entry->used_sides); }

  // Habits of what stands on something else.
  // Twice how far off the middle of its host something lies, towards the host's right and back; no `back2`: at the back.
  struct Spot {
    std::int64_t right2 = 0;
    std::optional<std::int64_t> back2;
  };
  std::pair<Side, Side> sides_on(int host, bool screen) const;
  void sit_on_host(int item);
  std::optional<Spot> spot_on(int item, int host) const;
  static std::optional<Spot> spot_beside_screens(Mm length, Mm screens, Mm widest, std::int64_t before, std::int64_t all, bool at_back);
  Spot spot_of_screen(int item, int host) const;
  std::vector<int> screen_before(int item, int host) const;
  void stand_at_back(Case& c, int item, int host, Direction back) const;
  bool lies_free(int item, int host) const;
  int seat_told_to_be_at(int host, int rank) const;
  bool is_sat_behind(int host) const;
  void look_at_user(int item, int user);
  bool rests_on(int item, int host) const;
  int rider_that_is(Trait trait, int host) const;
  bool lie_at_hand(int item, int host);

  // Habits towards the room: backs to walls, the middle, light, rugs; doors and windows nobody placed.
  void back_to_wall(int item, int weight);
  bool may_float(int item) const;
  void back_to_divider(Formula& f, int item);
  std::vector<std::pair<RelationType, std::vector<std::string>>> words_of(int item) const;
  void lie_alike(int item);
  bool is_narrow_bed(int item) const;
  bool has_bedside(int bed) const;
  bool ends_run(int item) const;
  bool keeps_to_corner(int item) const;
  void stand_in_its_corner(int item);
  bool is_faced_by_kind(int item) const;
  int table_served_by(int item) const;
  void stand_in_table_axis(int item);
  bool is_looked_at(int item) const;
  bool only_told_across(int item) const;
  bool leave_room_behind(int item);
  int board_of_room() const;
  void face_the_class(int item);
  bool middle_is_taken(int item) const;
  void swing_clear_of_doors(int item);
  bool has_sitters(int item) const;
  bool is_sat_at_alone(int item) const;
  int sitters_of(int item) const;
  void stand_at_wall(int item);
  void stand_in_middle(int item);
  void lie_straight(int item);
  void lie_along_window(int item);
  void stand_near_door(int item);
  bool stand_before_waiting(int item);
  void open_to_room(int item, int weight = kAtWall);
  void near_light(int item);
  void lie_under(int item);
  void lie_at_foot(int item, int bed);
  void lie_lengthwise(int item);
  void lie_beside(int item);
  void lie_before(int item, int sofa);
  void lie_before_use(int item, int host);
  void open_well(int item);
  void leave_wall_free(int item);

  // Habits of what hangs on walls and from ceilings.
  void hang_from_ceiling(int item);
  void hang_clear(int item);
  bool told_where_it_hangs(int item) const;
  bool hang_along(int item);
  Formula hung_along_top(int item, int host, const Linear& aside2) const;
  bool share_length_of_table(int item);
  int curtained_by(int item) const;
  std::vector<int> usually_under(int item) const;
  int seat_facing(int item) const;
  bool hang_in_row(int item);
  bool hang_in_row_over(int item);
  bool is_of_few_on_wall(int item) const;
  void share_wall_out(int item);
  void leave_seat_behind(int item);
  void keep_off_play(int item);
  bool hang_close_below(int item);
  void hang_on_wall(int item);
  std::uint64_t states_facing(int item, const RoomWall& wall) const;
  bool placed_by_relation_besides_walls(int item) const;
  void cover_window(int item);
  int long_table() const;
  void hang_before_table(Formula& f, int item, int table);
  void leave_free_before(int item);
  void hang_clear_of_doors(int item);

  // Habits towards other things: beside, round, before and facing what they belong to.
  int mirror_of(int item) const;
  int usual_mirror_of(int item) const;
  bool is_told_before_mirror(int seat, int mirror) const;
  bool is_wall_mirror(int item) const;
  bool sit_before_mirror(int item);
  int stand_of_screen(int screen) const;
  bool leaves_screen_to_others(int item, int screen) const;
  bool comes_after_screen(int item, int screen) const;
  void stay_before_screen(int item, int screen);
  void have_screen_before(int item, int screen);
  void watch_from_near(int item, int screen);
  bool only_sees_screen(int item) const;
  void watch_past_tables(int item, int screen);
  void come_near(int item, int host);
  void sit_facing(int item, int host);
  bool sit_by_between(int item);
  void keep_nose_free(int item);
  void keep_before_counter(int item);
  bool only_turned_by(int item, int host) const;
  bool only_near(int item, int host) const;
  bool leaves_usual_place(int item, int host) const;
  bool sit_in_row(int item, int host, RelationType how);
  bool told_short_side(int item, int host) const;
  bool stand_abreast(int item);
  bool stand_abreast_of(int item, int host, RelationType how);
  bool is_seated(int item, int neighbour) const;
  void stand_at_side(int item);

  // Habits by the greater thing one goes with (habits_beside.cc).
  bool stand_beside(int item);
  bool stand_as_told_by(int item);
  std::vector<int> hosts_beside(int item) const;
  std::optional<int> told_host(int item, const std::vector<int>& hosts) const;
  bool told_to_sit_elsewhere(int item) const;
  int low_table_of(int item) const;
  bool sit_near_low_table(int item);
  void leave_seated_to_their_seats(std::vector<int>& hosts, int item) const;
  bool sit_at(int item, int host, int hosts);
  bool hang_along_side(int item);
  void stand_edge_on(int item, int host);
  void stand_at(int item, int host, int hosts);
  // Seats that stand in a row along a side of what they look at.
  struct SeatRow {
    std::string name;  // of the habit
    Side side = Side::kFront;
    std::vector<int> seats;
    Mm between = 0, off = 0;  // the seats; they and what they look at
  };
  void sit_in_row(int item, int at, const SeatRow& row);
  void sit_behind_served(int item, int host);
  void sit_round_low_table(int item, int table);
  bool told_away_from_group(int item) const;
  void stand_before_middle(int item, int host);
  void flank(int item, int host, int hosts);
  std::vector<int> seats_at(int item, int host, int hosts) const;
  bool before_its_host(int item) const;
  std::vector<int> usual_hosts(int item) const;
  bool takes_seat(int host, int seat) const;
  std::vector<int> seen_from(int item) const;
  std::vector<int> seen_by_crowd(int item) const;
  bool look_at(int item, bool leads = false, const std::vector<int>& crowd = {});

  // Habits of groups (habits_groups.cc).
  void stay_under_loft(int item);
  bool is_dined_at(int item) const;
  void keep_off_sofas(int item);
  void keep_off_beds(int item);
  void keep_hall_free(int item);
  void keep_off_sitters_rug(int item);
  const Relation* divided_by(int item) const;
  void stand_across(int item);
  bool is_window_bar(int item) const;
  void stand_at_window(int item);
  bool is_served_over(int item) const;
  bool waits_for(int item, int desk) const;
  void wait_before_counter(int item);
  void face_entrance(int item);

  // Habits of those who sit to talk (habits_talk.cc).
  std::vector<int> loose_easy_chairs(int item) const;
  bool sit_round_sofa(int item, int sofa);
  bool sit_by_fire(int item);
  bool sit_to_talk(int item);

  // Habits of things that come in numbers.
  // The things of a kind that stand in formation: asked for as a grid, or many that nobody placed.
  struct Group {
    std::vector<int> members;
    int columns = 0;
  };
  std::optional<Group> formation_with(int item) const;
  std::optional<Group> grid_with(int item) const;
  std::size_t least_in_formation(int item) const;
  PartOfRoom part_of(const Group& group);
  bool placed_besides_facing(int item) const;
  bool fits_islands(int item) const;
  int leader_of(const Group& group) const;
  int counter_of_room() const;
  bool stand_behind_server(int item);
  Mm depth_behind_server(int counter) const;
  int desk_waited_at(const Group& group) const;
  Mm teachers_depth() const;
  Mm depth_of_seats(const Group& group) const;
  Mm depth_before(int first) const;
  Mm view_of(const Group& group) const;
  bool faces_a_class(int item) const;
  bool only_placed_before(int item, int other) const;
  void enter_behind_class(int door);
  void hang_on_blank_wall(int board);
  bool stand_in_islands(int item, const Group& group, int k);
  bool stand_in_blocks(int item);
  bool told_where_to_look(int item) const;
  bool told_middle_with_others(int item) const;
  void turn_as(int item, int other);
  bool stand_in_formation(int item);
  void keep_off_faced(int item);
  void stand_before_crowd(int faced);
  void stand_before_middle_of(const std::vector<int>& crowd, int faced);
  void stand_in_run(int item);
  void keep_tall_off_worked_at(int item);
  bool stand_along_run(int item);
  bool only_told_its_wall(int item) const;
  void stand_in_wall_row(int item);
  void stand_abreast_in_row(int item);
  bool stand_as_twin(int item);

  PlacementModel& model_;
  std::vector<std::vector<const Relation*>> said_of_;        // by item
  std::optional<std::vector<std::vector<int>>> formations_;  // all there are, once somebody asked
};

}  // namespace layoutbox::placement
