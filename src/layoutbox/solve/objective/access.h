// The free floor that things want at their sides: strips at used sides, and what the catalogue wants besides.
#pragma once

#include <vector>

#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

inline constexpr Mm kBodyReach = 2000;  // what begins higher is in nobody's way

// Fills what of the item and its states the rest of this file goes by: whether it is a seat, and around what its floor lies.
void note_floor_use(Item& item);

// Does the item stand in somebody's way on the floor?
bool blocks_floor(const Item& item, const GridBox& box);

// Does `body`, which stands on the floor whenever it is there, count as in the way of the floor that `owner` wants?
bool surely_blocks(const PlacementModel& model, ItemId body, ItemId owner);

// How far the body that reaches farthest into the clear box of an opening does so, in millimetres.
Mm intrusion_of(const PlacementModel& model, ItemId opening, const Placements& placements);

// Cost of the strips and wanted floors of one placed item; of a door or window, of what reaches into its swing.
std::int64_t access_cost_of(const PlacementModel& model, ItemId item, const Placements& placements);

// The items for which that may have changed since things stood as in `before`, where only those of the group have moved.
std::vector<ItemId> access_touched(const PlacementModel& model, const Placements& before, const Placements& after,
                                   const std::vector<ItemId>& group);

// What one item costs in many places while the others stay: its own floor, and what it takes of theirs.
class AccessProbe {
 public:
  explicit AccessProbe(const PlacementModel& model) : model_(model), claims_(model.items.size()) {}

  // REQUIRES: `placements` stay as they are until the next call. The item itself is taken as not placed.
  void start(const Placements& placements, ItemId item);
  // The low corner will lie between these.
  void focus(int state, const Vec3& lo, const Vec3& hi);
  // Where it comes to `enough`, perhaps less than all of it, but so much.
  std::int64_t cost_at(const Vec3& at, std::int64_t enough);

 private:
  struct Body {
    ItemId item;
    GridBox box;
  };
  struct Claim {
    GridBox floor;
    std::int64_t area = 0, blocked = 0;  // by all but the item that is tried
  };
  struct Claims {
    bool known = false;
    std::vector<Claim> strips, wanted;
    std::int64_t cost = 0;
  };

  const Claims& claims_of(ItemId owner);
  Claim claim_of(const GridBox& floor, ItemId owner, const std::vector<Body>& bodies) const;

  const PlacementModel& model_;
  const Placements* placements_ = nullptr;
  ItemId item_;
  int state_ = -1;
  std::vector<Body> bodies_, near_bodies_;
  std::vector<ItemId> near_owners_;
  ById<ItemId, Claims> claims_;
};

}  // namespace layoutbox::placement
