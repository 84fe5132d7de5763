// What furniture is to hold, and who sits there: what the files that size it share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "layoutbox/catalog/normalize_steps.h"

namespace layoutbox {

inline constexpr Mm kHostGap = 20;     // between things that stand side by side
inline constexpr Mm kSeatWidth = 620;  // of a table's edge that one person needs

struct HostContents {
  std::vector<Size> on_top, inside;
  std::vector<Size> least_on_top, least_inside;  // … at their least sizes
  int around = 0, along = 0;                     // seats
  int before = 0;
  Mm seat = 0;                       // width of the widest seat around or along it
  Mm front = 0;                      // width of the seats before it
  Mm abreast = 0;                    // … and of the screens on it, which stand side by side
  std::vector<std::string> screens;  // their ids
};

using ObjectsById = std::map<std::string, const SceneObject*>;
using HostsById = std::map<std::string, HostContents>;

// As many places at a table as seats of that width take: an armchair needs more than one.
int places(int seats, const HostContents& contents);

// Who sits at the one that the relation names.
void count_seats(const Catalog& catalog, const ObjectsById& by_id, const Relation& relation, HostContents& contents);
// Seats that no relation places go to the only thing of the kind they usually stand by, or share those out that one sits round: bar stools
// to the island, chairs to the table.
void share_out_seats(const NormalizeContext& context, HostsById& hosts, const ObjectsById& by_id);
// Seats along a table, across from what sits at its other side, are side by side: the table is as long as that takes.
void seat_at_one_side(const SceneGraph& scene, HostsById& hosts);

// So large as the catalogue says it is for so many, be that larger than such things mostly are.
void grow_with_seats(const NormalizeContext& context, const CatalogEntry& entry, const HostContents& contents, SceneObject& host);
// A bench at the long side of a table is nearly as long as that.
void stretch_benches(const NormalizeContext& context);

}  // namespace layoutbox
