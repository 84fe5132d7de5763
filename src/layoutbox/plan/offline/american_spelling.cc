#include "layoutbox/plan/offline/american_spelling.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace layoutbox::offline {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 36> kSpellings = {{
    {"colour", "color"},
    {"coloured", "colored"},
    {"colourful", "colorful"},
    {"grey", "gray"},
    {"centre", "center"},
    {"centred", "centered"},
    {"centres", "centers"},
    {"storeys", "stories"},
    {"metre", "meter"},
    {"metres", "meters"},
    {"cosy", "cozy"},
    {"centimetre", "centimeter"},
    {"centimetres", "centimeters"},
    {"millimetre", "millimeter"},
    {"millimetres", "millimeters"},
    {"theatre", "theater"},
    {"jewellery", "jewelry"},
    {"moulding", "molding"},
    {"plough", "plow"},
    {"aluminium", "aluminum"},
    {"organiser", "organizer"},
    {"mouldings", "moldings"},
    {"catalogue", "catalog"},
    {"centrepiece", "centerpiece"},
    {"grilles", "grills"},
    {"kerb", "curb"},
    {"neighbouring", "neighboring"},
    {"rigourous", "rigorous"},
    {"draught", "draft"},
    {"tyre", "tire"},
    {"tyres", "tires"},
    {"pyjama", "pajama"},
    {"storey", "story"},
    {"favourite", "favorite"},
    {"parallelled", "paralleled"},
    {"armour", "armor"},
}};

}  // namespace

std::string american_spelling(std::string word) {
  const auto twin = std::ranges::find(kSpellings, word, &decltype(kSpellings)::value_type::first);
  return twin == kSpellings.end() ? word : std::string(twin->second);
}

}  // namespace layoutbox::offline
