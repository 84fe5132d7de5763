// The style or mood that words name (catalog/decor.json).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace layoutbox {

std::string lower_case(std::string_view text);

struct RoomStyle {
  std::string name;                      // whose shapes its things have ("rustic")
  const nlohmann::json* data = nullptr;  // a row of decor.json
};

// The style that a text names ("rustic"), the first that is more than modern or traditional, else the mood ("make it dark"); without data
// where it names neither. What a room is not to be ("nothing modern") is instead as decor.json has it. What is said of a single thing (its
// name ends in one of `things`: "a Moroccan lantern") is no style of the whole.
RoomStyle style_of(std::string_view text, std::span<const std::string> things = {});

// A style as kitchens, bathrooms and workshops have it: what decor.json lists as `plain` is otherwise (null: it is not), with its
// `dry_floors` where nothing is cooked or washed.
nlohmann::json in_plain_room(nlohmann::json style, bool wet);

}  // namespace layoutbox
