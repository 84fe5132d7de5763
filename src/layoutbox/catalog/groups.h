// What belongs together: who sits at what and how large that is for how many, what the use of a thing needs besides, and when a room is
// bare. The data is catalog/groups.json.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// So large is a table for so many; a depth of 0: as usual.
struct SizeForSeats {
  int seats = 0;
  Mm width = 0, depth = 0;
};

struct Seating {
  std::string at, seat;            // kinds; no seat: nobody sits there
  std::vector<std::string> rooms;  // in these kinds of room only; empty: in all
  bool comes = false;              // also where the text speaks of no seat
  int seats = 0;                   // at one, where there are no sizes
  std::vector<SizeForSeats> sizes, round;
};

struct Companion {
  std::string of, adds;             // kinds
  int each = 1;                     // so many by every one of them
  bool anywhere = false;            // in the room, not beside it
  std::vector<std::string> unless;  // not where one of these kinds is there
  std::vector<std::string> rooms;   // in these kinds of room only; empty: in all
  Mm both_sides_from = 0;           // by what is that wide twice as many; 0: by none
  int up_to = 0;                    // not where more of them stand than so many; 0: however many
};

// Over what a thing usually hangs, or under what it lies; best first.
struct UsuallyAt {
  std::string what;            // a kind
  std::optional<Mount> mount;  // only so; none: however it is there
  std::vector<std::string> at;
};

// A room is bare below the first share of its floor that is covered; its usual furniture comes up to the second. Where hardly any
// furniture is named, the text says what kind of room it is, and no list of what is in it: it is furnished as such rooms are.
struct Filling {
  double bare = 0, until = 0;
  int hardly_any = 0;          // so many pieces that stand on the floor
  double usually_covered = 0;  // … up to this share
  int most = 0;
  std::vector<std::pair<std::string, std::string>> unless;  // the first kind does not come where the second is
};

// What a named part of a room is for, by the words before "corner", "area", "nook", and what is usual there.
struct ZoneUse {
  std::vector<std::string> said, rooms;                    // rooms: in these kinds only; empty: in all
  std::vector<std::pair<std::string, int>> has;            // kinds, and how many
  std::vector<std::string> unless;                         // nothing comes where one of these kinds is there
  std::vector<std::pair<std::string, std::string>> means;  // what a plain kind is there: a table for children
};

// What stands in a room says what kind of room it is: something of each of these lists.
struct RoomByContents {
  std::string room;                           // a kind
  std::vector<std::vector<std::string>> has;  // kinds of furniture
  int at_least = 1;                           // so many of each list
  std::vector<std::string> without;           // and none of these
  bool young = false;                         // only for children
};

struct Groups {
  std::vector<Seating> seatings;         // special kinds first
  int oval = 0;                          // so many sit all round an oval table, more of them along its sides
  std::vector<Companion> companions;     // in this order
  std::vector<ZoneUse> zones;            // special ones first
  std::vector<RoomByContents> contents;  // the first that fits
  std::vector<std::string> by_door;      // kinds that stand near a door
  std::vector<UsuallyAt> hangs, lies;    // special kinds first
  std::vector<UsuallyAt> within;         // what stands in another where it is only said to be with it
  std::vector<UsuallyAt> by;             // … and by another where nothing is said of it
  std::vector<UsuallyAt> before;         // … and what stands before another, turned to who is there
  Filling fill;
  std::vector<std::string> carried;             // kinds that get something to stand on where nothing there carries them
  std::vector<std::string> sat_at;              // words by which a table is one to sit at
  std::vector<std::string> none, none_to_fill;  // words by which nothing comes; by which a bare room stays bare
  std::vector<std::string> empty, to_furnish;   // words by which nothing comes, and by which it does in spite of them

  // The first seating whose kind `entry` is, in a room of that kind (empty: a rule for all rooms). Null: none.
  const Seating* seating_at(const Catalog& catalog, const CatalogEntry& entry, const std::string& room) const;
  // The kinds of the first row that fits; none: nothing.
  static const std::vector<std::string>& usual_at(const std::vector<UsuallyAt>& rows, const Catalog& catalog, const CatalogEntry& entry,
                                                  Mount mount);
  static const Groups& builtin();
};

// How large that is for so many seats (between the rows in proportion, beyond the last as the last grows); nothing where the data does
// not say.
std::optional<SizeForSeats> size_for_seats(const Seating& seating, bool round, int seats);
// Is it told to be round, or such a thing mostly round (a pub table)?
bool is_round(const SceneObject& object, const CatalogEntry& entry);
// How many sit at one of that size; at least 1 where somebody sits there at all.
int seats_at_size(const Seating& seating, bool round, const Size& size);

}  // namespace layoutbox
