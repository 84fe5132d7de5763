// What the shares of the terms cost in one arrangement, each measured once: most moves are weighed against the same.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "layoutbox/solve/objective/terms.h"

namespace layoutbox::placement {

class KnownCosts {
 public:
  // How much less all but the late terms cost after the change. No more than `least_gain`: perhaps not all of the loss, but so much.
  std::int64_t gain(const PlacementModel& model, const Change& change, std::int64_t least_gain);

 private:
  using Shares = std::vector<std::size_t>;

  void are_of(const PlacementModel& model, const Placements& placements);
  void forget(const PlacementModel& model);

  Placements of_;
  std::vector<std::vector<std::optional<std::int64_t>>> known_;  // by term and share
  std::vector<Shares> touched_;                                  // by term; kept for their room
};

}  // namespace layoutbox::placement
