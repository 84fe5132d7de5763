// The colours of a room: of its palette, as the text says them, and without those that it is not to have.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "layoutbox/furnish/decor.h"
#include "layoutbox/furnish/room_look.h"

namespace layoutbox {

Color color_of_json(const nlohmann::json& json);

// A palette of decor.json: a number of one of the common ones, colours by their numbers, or by their names.
std::vector<Color> palette_of(const nlohmann::json& palette);

// The look that words of the data give a part ("sage", "butcher block").
PartLook part_look_of(const std::string& words);

// Whether a person would call it by the name of one of those: "no grey" bans all greys, "no black" what is nearly black.
bool is_banned(const Color& color, std::span<const Color> banned);

// The colours and woods that the text says of the whole room; what it does not want gives way. `dark`: the room is to be dark.
void take_room_look(Decor& decor, RoomLook said, const std::string& kind, bool dark);

}  // namespace layoutbox
