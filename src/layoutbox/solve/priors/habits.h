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
  void add(ItemId index);
  void spread();

 private:
  void stand(ItemId index);
  void stand_by_itself(ItemId index, bool looks);
  Constraint& habit(const std::string& what, ItemId item, int weight, Formula formula, std::vector<ItemId> hosts = {});
  std::vector<ItemId> items_of_kinds(const std::vector<std::string>& kinds, ItemId except) const;
  int rank_of(ItemId item) const;
  // The relations of the scene that speak of it.
  const std::vector<const Relation*>& said_of(ItemId item) const { return said_of_[item]; }
  bool related(ItemId a, ItemId b) const;
  bool only_related_by(ItemId a, ItemId b, RelationSet types) const;
  bool related_as_target(ItemId item, ItemId reference, RelationType type) const;
  bool related_by_any(ItemId a, ItemId b, RelationSet types) const;
  bool placed_by_relation(ItemId item) const;
  bool only_told_opening(ItemId item) const;
  bool is_low_aside(ItemId item) const;
  bool told_to_stand_free(ItemId item) const;
  void keep_hint(ItemId item);
  void keep_turn(ItemId item, double degrees);
  static std::vector<Side> used_sides(const Item& item) { return item.object->used_sides.value_or(item.entry->used_sides); }

  // Habits of what stands on something else.
  // Twice how far off the middle of its host something lies, towards the host's right and back; no `back2`: at the back.
  struct Spot {
    std::int64_t right2 = 0;
    std::optional<std::int64_t> back2;
  };
  std::pair<Side, Side> sides_on(ItemId host, bool screen) const;
  void sit_on_host(ItemId item);
  std::optional<Spot> spot_on(ItemId item, ItemId host) const;
  static std::optional<Spot> spot_beside_screens(Mm length, Mm screens, Mm widest, std::int64_t before, std::int64_t all, bool at_back);
  Spot spot_of_screen(ItemId item, ItemId host) const;
  std::vector<ItemId> screen_before(ItemId item, ItemId host) const;
  void stand_at_back(Case& c, ItemId item, ItemId host, Direction back) const;
  bool lies_free(ItemId item, ItemId host) const;
  ItemId seat_told_to_be_at(ItemId host, int rank) const;
  bool is_sat_behind(ItemId host) const;
  void look_at_user(ItemId item, ItemId user);
  bool rests_on(ItemId item, ItemId host) const;
  ItemId rider_that_is(Trait trait, ItemId host) const;
  bool lie_at_hand(ItemId item, ItemId host);

  // Habits towards the room: backs to walls, the middle, light, rugs; doors and windows nobody placed.
  void back_to_wall(ItemId item, int weight);
  bool may_float(ItemId item) const;
  void back_to_divider(Formula& f, ItemId item);
  std::vector<std::pair<RelationType, std::vector<std::string>>> words_of(ItemId item) const;
  void lie_alike(ItemId item);
  bool is_narrow_bed(ItemId item) const;
  bool has_bedside(ItemId bed) const;
  bool ends_run(ItemId item) const;
  bool keeps_to_corner(ItemId item) const;
  void stand_in_its_corner(ItemId item);
  bool is_faced_by_kind(ItemId item) const;
  ItemId table_served_by(ItemId item) const;
  void stand_in_table_axis(ItemId item);
  bool is_looked_at(ItemId item) const;
  bool only_told_across(ItemId item) const;
  bool only_told_fire(ItemId item) const;
  bool only_told_part_or_opening(ItemId item) const;
  bool leave_room_behind(ItemId item);
  ItemId board_of_room() const;
  void face_the_class(ItemId item);
  bool middle_is_taken(ItemId item) const;
  void swing_clear_of_doors(ItemId item);
  bool has_sitters(ItemId item) const;
  bool is_sat_at_alone(ItemId item) const;
  int sitters_of(ItemId item) const;
  void stand_at_wall(ItemId item);
  void stand_in_middle(ItemId item);
  void lie_straight(ItemId item);
  void lie_along_window(ItemId item);
  void stand_near_door(ItemId item);
  bool stand_before_waiting(ItemId item);
  void open_to_room(ItemId item, int weight = kAtWall);
  void near_light(ItemId item);
  void lie_under(ItemId item);
  void lie_at_foot(ItemId item, ItemId bed);
  void lie_lengthwise(ItemId item);
  void lie_beside(ItemId item);
  void lie_before(ItemId item, ItemId sofa);
  void lie_before_use(ItemId item, ItemId host);
  void open_well(ItemId item);
  std::pair<int, int> window_in_wall(ItemId item) const;
  void leave_wall_free(ItemId item);

  // Habits of what hangs on walls and from ceilings.
  void hang_from_ceiling(ItemId item);
  void hang_clear(ItemId item);
  bool told_where_it_hangs(ItemId item) const;
  bool hang_along(ItemId item);
  Formula hung_along_top(ItemId item, ItemId host, const Linear& aside2) const;
  bool share_length_of_table(ItemId item);
  ItemId curtained_by(ItemId item) const;
  std::vector<ItemId> usually_under(ItemId item) const;
  ItemId seat_facing(ItemId item) const;
  bool hang_in_row(ItemId item);
  bool begin_row(ItemId item, Mm pitch, int count);
  bool hang_in_row_over(ItemId item);
  bool hang_over_both(ItemId item);
  Mm air_on_wall(ItemId item, int count) const;
  bool is_of_few_on_wall(ItemId item) const;
  void share_wall_out(ItemId item);
  void leave_seat_behind(ItemId item);
  void keep_off_play(ItemId item);
  bool hang_close_below(ItemId item);
  void hang_on_wall(ItemId item);
  std::uint64_t states_facing(ItemId item, const RoomWall& wall) const;
  bool placed_by_relation_besides_walls(ItemId item) const;
  void cover_window(ItemId item);
  ItemId long_table() const;
  void hang_before_table(Formula& f, ItemId item, ItemId table);
  void leave_free_before(ItemId item);
  void hang_clear_of_doors(ItemId item);

  // Habits towards other things: beside, round, before and facing what they belong to.
  ItemId mirror_of(ItemId item) const;
  ItemId usual_mirror_of(ItemId item) const;
  bool is_told_before_mirror(ItemId seat, ItemId mirror) const;
  bool is_wall_mirror(ItemId item) const;
  bool sit_before_mirror(ItemId item);
  ItemId stand_of_screen(ItemId screen) const;
  bool leaves_screen_to_others(ItemId item, ItemId screen) const;
  bool comes_after_screen(ItemId item, ItemId screen) const;
  void stay_before_screen(ItemId item, ItemId screen, bool at_ease);
  void have_screen_before(ItemId item, ItemId screen);
  void watch_from_near(ItemId item, ItemId screen);
  bool only_sees_screen(ItemId item) const;
  void watch_past_tables(ItemId item, ItemId screen);
  void come_near(ItemId item, ItemId host);
  void sit_facing(ItemId item, ItemId host);
  bool sit_by_between(ItemId item);
  void keep_nose_free(ItemId item);
  void keep_nose_off_walls(ItemId item);
  void keep_before_counter(ItemId item);
  bool only_turned_by(ItemId item, ItemId host) const;
  bool only_near(ItemId item, ItemId host) const;
  bool leaves_usual_place(ItemId item, ItemId host) const;
  bool sit_in_row(ItemId item, ItemId host, RelationType how);
  bool told_short_side(ItemId item, ItemId host) const;
  bool stand_abreast(ItemId item);
  bool stand_abreast_of(ItemId item, ItemId host, RelationType how);
  bool is_seated(ItemId item, ItemId neighbour) const;
  void stand_at_side(ItemId item);

  // Habits by the greater thing one goes with (habits_beside.cc).
  bool stand_beside(ItemId item);
  bool stand_as_told_by(ItemId item);
  std::vector<ItemId> hosts_beside(ItemId item) const;
  std::optional<ItemId> told_host(ItemId item, const std::vector<ItemId>& hosts) const;
  bool told_to_sit_elsewhere(ItemId item) const;
  ItemId low_table_of(ItemId item) const;
  bool sit_near_low_table(ItemId item);
  void leave_seated_to_their_seats(std::vector<ItemId>& hosts, ItemId item) const;
  bool sit_at(ItemId item, ItemId host, int hosts);
  bool hang_along_side(ItemId item);
  void stand_edge_on(ItemId item, ItemId host);
  void stand_at_back_of_seat(ItemId item);
  void stand_at(ItemId item, ItemId host, int hosts);
  // Seats that stand in a row along a side of what they look at.
  struct SeatRow {
    std::string name;  // of the habit
    Side side = Side::kFront;
    std::vector<ItemId> seats;
    Mm between = 0, off = 0;  // the seats; they and what they look at
  };
  void sit_in_row(ItemId item, ItemId at, const SeatRow& row);
  void sit_behind_served(ItemId item, ItemId host);
  void sit_round_low_table(ItemId item, ItemId table);
  bool told_away_from_group(ItemId item) const;
  void stand_before_middle(ItemId item, ItemId host);
  void flank(ItemId item, ItemId host, int hosts);
  std::vector<ItemId> seats_at(ItemId item, ItemId host, int hosts) const;
  bool before_its_host(ItemId item) const;
  std::vector<ItemId> usual_hosts(ItemId item) const;
  bool takes_seat(ItemId host, ItemId seat) const;
  std::vector<ItemId> seen_from(ItemId item) const;
  std::vector<ItemId> seen_by_crowd(ItemId item) const;
  bool look_at(ItemId item, bool leads = false, const std::vector<ItemId>& crowd = {});

  // Habits of groups (habits_groups.cc).
  void stay_under_loft(ItemId item);
  bool is_dined_at(ItemId item) const;
  void keep_off_sofas(ItemId item);
  void keep_off_other_tables(ItemId item);
  void keep_off_beds(ItemId item);
  void keep_hall_free(ItemId item);
  void keep_off_sitters_rug(ItemId item);
  const Relation* divided_by(ItemId item) const;
  void stand_across(ItemId item);
  bool is_window_bar(ItemId item) const;
  void stand_at_window(ItemId item);
  bool is_served_over(ItemId item) const;
  bool waits_for(ItemId item, ItemId desk) const;
  void wait_before_counter(ItemId item);
  void face_entrance(ItemId item);

  // Habits of those who sit to talk (habits_talk.cc).
  std::vector<ItemId> loose_easy_chairs(ItemId item) const;
  bool sit_round_sofa(ItemId item, ItemId sofa);
  bool sit_by_fire(ItemId item);
  bool sit_to_talk(ItemId item);

  // Habits of things that come in numbers.
  // The things of a kind that stand in formation: asked for as a grid, or many that nobody placed.
  struct Group {
    std::vector<ItemId> members;
    int columns = 0;
    bool spread = false;
  };
  std::optional<Group> formation_with(ItemId item) const;
  std::optional<Group> grid_with(ItemId item) const;
  bool told_in_line(const Group& group) const;
  std::size_t least_in_formation(ItemId item) const;
  PartOfRoom part_of(const Group& group);
  bool placed_besides_facing(ItemId item) const;
  bool fits_islands(ItemId item) const;
  int leader_of(const Group& group) const;
  ItemId counter_of_room() const;
  bool stand_behind_server(ItemId item);
  Mm depth_behind_server(ItemId counter) const;
  ItemId desk_waited_at(const Group& group) const;
  Mm teachers_depth() const;
  Mm depth_of_seats(const Group& group) const;
  Mm depth_before(ItemId first) const;
  Mm view_of(const Group& group) const;
  bool faces_a_class(ItemId item) const;
  bool only_placed_before(ItemId item, ItemId other) const;
  void enter_behind_class(ItemId door);
  void hang_on_blank_wall(ItemId board);
  bool stand_in_islands(ItemId item, const Group& group, int k);
  bool stand_in_blocks(ItemId item);
  bool told_where_to_look(ItemId item) const;
  bool told_middle_with_others(ItemId item) const;
  void turn_as(ItemId item, ItemId other);
  bool stand_in_formation(ItemId item);
  void keep_off_faced(ItemId item);
  void stand_before_crowd(ItemId faced);
  void stand_before_middle_of(const std::vector<ItemId>& crowd, ItemId faced);
  void stand_in_run(ItemId item);
  void keep_tall_off_worked_at(ItemId item);
  void have_worktop_aside(ItemId item);
  bool stand_along_run(ItemId item);
  bool only_told_its_wall(ItemId item) const;
  void stand_in_wall_row(ItemId item);
  void stand_abreast_in_row(ItemId item);
  bool stand_as_twin(ItemId item);

  PlacementModel& model_;
  ById<ItemId, std::vector<const Relation*>> said_of_;
  std::optional<std::vector<std::vector<ItemId>>> formations_;  // all there are, once somebody asked
};

}  // namespace layoutbox::placement
