// The colours of a room: of its palette, as the text says them, and without those that it is not to have.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

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

// How far from grey, 0 to 1.
double chroma_of(const Color& color);

// The colours of cloth beside what the text says of a large thing: that colour, a paler one, and what is calm of the usual ones.
std::vector<Color> accents_beside(const std::optional<Color>& said, const std::vector<Color>& usual);

// Whether the text says what the walls are like, rather than what is at them: "walls pale blue", "beside the brick wall", "painted".
bool says_walls(std::string_view prompt);

// "Black fixtures", "brass taps": what is usually of chrome and steel is of that.
void take_fittings(Decor& decor);

// A floor of the woods that the text says of the whole room, and none that is far darker than the colours that it says. `room`: what
// decor.json has of rooms of the kind.
void suit_floor(Decor& decor, const nlohmann::json& room, std::uint64_t chance);

// The colours and woods that the text says of the whole room; what it does not want gives way. `dark`: the room is to be dark.
void take_room_look(Decor& decor, RoomLook said, const std::string& kind, bool dark);

}  // namespace layoutbox
