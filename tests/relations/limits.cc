#include "limits.h"

#include <algorithm>
#include <cctype>

namespace layoutbox::checks {

const std::vector<Limit>& limits() {
  static const std::vector<Limit> kLimits = [] {
    std::vector<Limit> all;
    for (const auto family : {paper_limits, room_limits, opening_limits, pair_limits, height_limits, group_limits, space_limits}) {
      const std::vector<Limit> some = family();
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return kLimits;
}

Layout furnished(const Limit& limit, double share) {
  TestRoom room;
  limit.furnish(room);
  PlacedObject& object = room.object(limit.breaks.who);
  const TestPlace& by = limit.breaks.by;
  object.position[0] += by.x * 1000 * share;
  object.position[1] += by.y * 1000 * share;
  object.position[2] += by.z * 1000 * share;
  object.rotation_deg += by.rotation * share;
  return room.layout;
}

std::string test_name(std::string words) {
  std::replace_if(
      words.begin(), words.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return words;
}

}  // namespace layoutbox::checks
