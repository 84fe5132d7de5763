#include "layoutbox/catalog/groups.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/base/units.h"
#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;

std::vector<std::string> strings(const Json& value, const char* key) { return value.value(key, std::vector<std::string>{}); }

std::vector<SizeForSeats> sizes(const Json& value, const char* key) {
  std::vector<SizeForSeats> rows;
  if (!value.contains(key)) return rows;
  for (const Json& row : value.at(key)) {
    const Mm width = mm_from_m(row.at(1).get<double>());
    rows.push_back({row.at(0).get<int>(), width, row.size() > 2 ? mm_from_m(row.at(2).get<double>()) : width});
  }
  return rows;
}

std::vector<UsuallyAt> usual_places(const Json& rows) {
  std::vector<UsuallyAt> usual;
  for (const Json& value : rows) {
    UsuallyAt row{value.at("is").get<std::string>(), {}, strings(value, "over")};
    if (value.contains("mount")) row.mount = mount_from_name(value.at("mount").get<std::string>());
    usual.push_back(std::move(row));
  }
  return usual;
}

Groups read_groups() {
  const Json data = Json::parse(embedded::groups_json);
  Groups groups;
  for (const Json& value : data.at("seatings")) {
    groups.seatings.push_back({value.at("at").get<std::string>(), value.at("seat").get<std::string>(), strings(value, "rooms"),
                               value.value("comes", false), value.value("seats", 0), sizes(value, "sizes"), sizes(value, "round")});
  }
  groups.oval = data.at("oval").get<int>();
  for (const Json& value : data.at("companions")) {
    groups.companions.push_back({value.at("of").get<std::string>(), value.at("adds").get<std::string>(), value.value("each", 1),
                                 value.value("anywhere", false), strings(value, "unless"), strings(value, "rooms"),
                                 mm_from_m(value.value("bothSidesFrom", 0.0)), value.value("upTo", 0)});
  }
  for (const Json& value : data.at("zones")) {
    ZoneUse zone{strings(value, "said"), strings(value, "rooms"), {}, strings(value, "unless"), {}};
    for (const Json& row : value.at("has")) zone.has.emplace_back(row.at(0).get<std::string>(), row.at(1).get<int>());
    for (const Json& row : value.value("means", Json::array()))
      zone.means.emplace_back(row.at(0).get<std::string>(), row.at(1).get<std::string>());
    groups.zones.push_back(std::move(zone));
  }
  for (const Json& value : data.at("contents")) {
    groups.contents.push_back({value.at("room").get<std::string>(), value.at("has").get<std::vector<std::vector<std::string>>>(),
                               value.value("atLeast", 1), strings(value, "without"), value.value("young", false)});
  }
  groups.by_door = strings(data, "by_door");
  groups.hangs = usual_places(data.at("hangs"));
  groups.lies = usual_places(data.at("lies"));
  groups.within = usual_places(data.at("within"));
  groups.by = usual_places(data.at("by"));
  groups.before = usual_places(data.at("before"));
  const Json& fill = data.at("fill");
  groups.fill = {fill.at("bare").get<double>(),    fill.at("until").get<double>(),
                 fill.at("hardly_any").get<int>(), fill.at("usually_covered").get<double>(),
                 fill.at("most").get<int>(),       {}};
  for (const Json& row : fill.at("unless")) groups.fill.unless.emplace_back(row.at(0).get<std::string>(), row.at(1).get<std::string>());
  groups.carried = strings(data, "carried");
  groups.sat_at = strings(data, "sat_at");
  groups.empty = strings(data, "empty");
  groups.to_furnish = strings(data, "to_furnish");
  groups.none = strings(data, "none");
  groups.none_to_fill = strings(data, "none_to_fill");
  return groups;
}

}  // namespace

const Groups& Groups::builtin() {
  static const Groups groups = read_groups();
  return groups;
}

const std::vector<std::string>& Groups::usual_at(const std::vector<UsuallyAt>& rows, const Catalog& catalog, const CatalogEntry& entry,
                                                 Mount mount) {
  static const std::vector<std::string> nothing;
  const auto found = std::ranges::find_if(
      rows, [&](const UsuallyAt& row) { return (!row.mount || row.mount == mount) && catalog.is_a(entry.id, row.what); });
  return found == rows.end() ? nothing : found->at;
}

const Seating* Groups::seating_at(const Catalog& catalog, const CatalogEntry& entry, const std::string& room) const {
  const auto fits = [&](const Seating& s) {
    return catalog.is_a(entry.id, s.at) && (s.rooms.empty() || std::ranges::find(s.rooms, room) != s.rooms.end());
  };
  const auto found = std::ranges::find_if(seatings, fits);
  return found == seatings.end() ? nullptr : &*found;
}

std::optional<SizeForSeats> size_for_seats(const Seating& seating, bool round, int seats) {
  const std::vector<SizeForSeats>& rows = round ? seating.round : seating.sizes;
  if (rows.empty() || seats <= 0) return std::nullopt;
  const auto next = std::ranges::find_if(rows, [&](const SizeForSeats& row) { return row.seats >= seats; });
  if (next == rows.begin()) return SizeForSeats{seats, next->width, next->depth};
  const SizeForSeats& high = next == rows.end() ? rows.back() : *next;
  const SizeForSeats low = rows.size() == 1 ? high : next == rows.end() ? rows[rows.size() - 2] : *(next - 1);
  const double share = high.seats == low.seats ? 1 : double(seats - low.seats) / (high.seats - low.seats);
  const auto between = [&](Mm a, Mm b) { return static_cast<Mm>(std::lround((a + (b - a) * share) / kGridMm)) * kGridMm; };
  return SizeForSeats{seats, between(low.width, high.width), std::min(between(low.depth, high.depth), std::max(low.depth, high.depth))};
}

bool is_round(const SceneObject& object, const CatalogEntry& entry) {
  const auto top = entry.shape.words.find("top");
  const bool kind = top != entry.shape.words.end() && top->second == "round";
  const auto says = [](const std::string& words) {
    return words == "round" || words == "circular" || words == "hexagonal" || words == "octagonal";  // one sits all round it
  };
  return kind || std::ranges::any_of(object.attributes, says) || object.name.starts_with("round ");
}

int seats_at_size(const Seating& seating, bool round, const Size& size) {
  const std::vector<SizeForSeats>& rows = round ? seating.round : seating.sizes;
  int seats = seating.seats;
  for (const SizeForSeats& row : rows) {
    if (row.width <= std::max(size.width, size.depth)) seats = row.seats;
  }
  if (seats == 0 && !rows.empty()) seats = std::min(rows.front().seats, 2);
  return std::max(seats, seating.seat.empty() ? 0 : 1);
}

}  // namespace layoutbox
