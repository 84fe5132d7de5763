// Members by other names, members that are null, and units, wherever files of others have them.
#include <iterator>
#include <nlohmann/json.hpp>

#include "layoutbox/scene/quirks.h"

namespace layoutbox {

using nlohmann::json;

bool rename_member(json& object, std::string_view from, std::string_view to) {
  const auto found = object.find(from);
  if (found == object.end() || object.contains(to)) return false;
  json value = std::move(*found);
  object.erase(std::string(from));
  object[std::string(to)] = std::move(value);
  return true;
}

void drop_nulls(json& value) {
  if (value.is_object()) {
    for (auto it = value.begin(); it != value.end();) it = it->is_null() ? value.erase(it) : std::next(it);
  }
  if (!value.is_structured()) return;
  for (json& child : value) drop_nulls(child);
}

std::optional<double> metres_per_unit(std::string_view unit) {
  struct Unit {
    std::string_view names[7];
    double metres;
  };
  static constexpr Unit kUnits[] = {{{"m", "metre", "metres", "meter", "meters"}, 1},
                                    {{"cm", "centimetre", "centimetres", "centimeter", "centimeters"}, 0.01},
                                    {{"mm", "millimetre", "millimetres", "millimeter", "millimeters"}, 0.001},
                                    {{"ft", "foot", "feet", "'", "′"}, 0.3048},
                                    {{"in", "inch", "inches", "\"", "″"}, 0.0254}};
  if (unit.empty()) return 1;
  std::string lower;
  for (const char c : unit) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  for (const Unit& known : kUnits) {
    for (const std::string_view name : known.names) {
      if (!name.empty() && name == lower) return known.metres;
    }
  }
  return std::nullopt;
}

}  // namespace layoutbox
