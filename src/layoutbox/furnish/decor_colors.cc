#include "layoutbox/furnish/decor_colors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/prompt_words.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;

double brightness(const Color& c) { return 0.3 * c.r + 0.59 * c.g + 0.11 * c.b; }

// Degrees round the circle of hues.
double hue(const Color& c) {
  const double most = std::max({c.r, c.g, c.b}), span = chroma_of(c);
  if (span <= 0) return 0;
  const double sixths = most == c.r ? (c.g - c.b) / span : most == c.g ? 2 + (c.b - c.r) / span : 4 + (c.r - c.g) / span;
  return 60 * (sixths < 0 ? sixths + 6 : sixths);
}

// Grey goes from nearly black to nearly white, and is of hardly any hue.
bool is_like_gray(const Color& color, const Color& gray) {
  constexpr double kHardly = 0.075, kBlack = 0.17, kWhite = 0.84;
  const double light = brightness(color), of_gray = brightness(gray);
  if (chroma_of(color) > kHardly) return false;
  if (of_gray < kBlack) return light < kBlack + 0.08;
  return of_gray > kWhite ? light > kWhite : light >= kBlack && light <= kWhite;
}

bool is_like(const Color& color, const Color& banned) {
  constexpr double kGray = 0.06, kVivid = 0.3, kHue = 24, kFaint = 0.16;
  if (is_much_like(color, banned)) return true;
  if (chroma_of(banned) < kGray) return is_like_gray(color, banned);
  const double apart = std::abs(hue(color) - hue(banned)), turn = std::min(apart, 360 - apart);
  return chroma_of(banned) > kVivid && chroma_of(color) > kFaint && turn < kHue && brightness(banned) > 0.35;
}

// Walls of a room whose colours are said: of the lightest of them, far paler; of a pale colour beside white, so that it is seen.
Color wall_of(const std::vector<Color>& said) {
  constexpr double kPale = 0.6, kTinged = 0.05, kVivid = 0.35;
  const Color& lightest = *std::ranges::max_element(said, {}, brightness);
  const auto pale = std::ranges::find_if(said, [](const Color& c) { return brightness(c) > kPale && chroma_of(c) > kTinged; });
  // Red is never so pale that it is not pink.
  if (lightest.r > lightest.g + kVivid && lightest.r > lightest.b + kVivid) return mixed(lightest, {0.93, 0.91, 0.88}, 0.93);
  const bool tinged = pale != said.end() && chroma_of(lightest) < kTinged;
  return mixed(tinged ? *pale : lightest, {0.95, 0.94, 0.92}, tinged && chroma_of(*pale) < kVivid ? 0.5 : 0.65);
}

std::vector<Color> calm_colors() { return palette_of(decor_data().at("calm")); }

// One colour alone is told from itself by paler ones and by what is calm.
void add_shades(std::vector<Color>& said) {
  if (said.size() != 1) return;
  constexpr double kGray = 0.06;
  const Color color = said.front();
  const bool gray = chroma_of(color) < kGray;
  said.push_back(mixed(color, {0.95, 0.93, 0.89}, 0.08));  // most things have it nearly as it is said
  said.push_back(gray ? mixed(color, {0.75, 0.75, 0.74}, 0.3) : mixed(color, {0.95, 0.93, 0.89}, 0.45));
  said.push_back(gray ? mixed(color, {0.75, 0.73, 0.69}, 0.2) : calm_colors().front());
}

// White, cream and black are what furniture is painted; a grey or a beige leaves it of wood.
bool is_paint(const Color& color) {
  constexpr double kWhite = 0.84, kTinge = 0.17, kBlack = 0.2, kHardly = 0.08;
  return (brightness(color) > kWhite && chroma_of(color) < kTinge) || (brightness(color) < kBlack && chroma_of(color) < kHardly);
}

// "Teal and white": the furniture is white, cloth and one wall are teal.
void part_neutral(Decor& decor, std::vector<Color>& said) {
  constexpr double kStrong = 0.2, kDeep = 0.6;  // chroma, brightness
  const auto neutral = std::ranges::min_element(said, {}, [](const Color& c) { return is_paint(c) ? chroma_of(c) : 1; });
  if (neutral == said.end() || !is_paint(*neutral)) return;
  if (!decor.woods_said) decor.paint = *neutral;
  const bool strong = std::ranges::any_of(said, [](const Color& c) { return chroma_of(c) > kStrong; });
  if (!strong) return;
  said.erase(neutral);
  const auto deep = std::ranges::find_if(said, [](const Color& c) { return chroma_of(c) > kStrong && brightness(c) < kDeep; });
  if (deep != said.end()) decor.feature = *deep;
}

// The first of those that is not banned, by its own colour; the usual one where all are.
std::string not_banned(const std::string& usual, const Json& others, std::span<const Color> banned) {
  const auto is_out = [&](const std::string& name) {
    const SurfaceWish wish = read_wish(name);
    return !wish.materials.empty() && is_banned(wish.color.value_or(wish.materials.front()->surface.base), banned);
  };
  if (!is_out(usual)) return usual;
  for (const Json& other : others) {
    if (!is_out(other.get<std::string>())) return other.get<std::string>();
  }
  return usual;
}

// Everything that nobody asked for gives way where it is of an unwanted colour or stuff.
void give_way(Decor& decor) {
  const auto banned = [&](const Color& color) { return is_banned(color, decor.unwanted); };
  std::erase_if(decor.accents, banned);
  const bool enough = decor.colors_said && !decor.accents.empty();
  for (const Color& calm : calm_colors()) {
    if (!enough && decor.accents.size() < 3 && !banned(calm)) decor.accents.push_back(calm);
  }
  const Json& others = decor_data().at("others");
  std::erase_if(decor.woods, [&](const std::string& wood) { return banned(named_surface(wood).surface.base); });
  if (decor.woods.empty()) decor.woods.push_back(not_banned("oak", others.at("wood"), decor.unwanted));
  decor.floor = not_banned(decor.floor, others.at("floors"), decor.unwanted);
  if (!decor.wall_finish.empty()) decor.wall_finish = not_banned(decor.wall_finish, others.at("walls"), decor.unwanted);
  for (const NamedSurface& named : named_surfaces()) {
    if (!others.contains(named.kind) || !banned(named.surface.base)) continue;
    const std::string other = not_banned(named.surface.name, others.at(named.kind), decor.unwanted);
    if (other != named.surface.name) decor.others.emplace(named.surface.name, other);
  }
  if (!banned(decor.wall)) return;
  for (const Json& wall : decor_data().at("walls")) {
    if (!banned(color_of_json(wall))) decor.wall = color_of_json(wall);
  }
}

}  // namespace

Color color_of_json(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

double chroma_of(const Color& color) { return std::max({color.r, color.g, color.b}) - std::min({color.r, color.g, color.b}); }

std::vector<Color> accents_beside(const std::optional<Color>& said, const std::vector<Color>& usual) {
  if (!said) return usual;
  constexpr double kCalm = 0.14;  // chroma
  std::vector<Color> accents{*said};
  std::ranges::copy_if(usual, std::back_inserter(accents), [](const Color& color) { return chroma_of(color) < kCalm; });
  accents.push_back(mixed(*said, {0.90, 0.87, 0.81}, 0.5));
  return accents;
}

bool says_walls(std::string_view prompt) {
  const std::vector<std::string> words = words_and_signs(prompt);
  const auto looks = [&](std::size_t at) { return at < words.size() && is_look_word(words[at]); };
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (is_in_list("cover_words", words[i])) return true;
    if (is_in_list("wall_words", words[i]) && ((i > 0 && looks(i - 1)) || looks(i + 1) || looks(i + 2))) return true;
  }
  return false;
}

void take_fittings(Decor& decor) {
  const auto said = decor.parts.find("fittings");
  if (said == decor.parts.end()) return;
  constexpr double kDark = 0.25;
  const PartLook& look = said->second;
  const bool metal = look.material != nullptr && look.material->kind == "metal";
  if (!metal && look.colors.empty()) return;
  decor.metal = metal ? look.material->surface.name : brightness(look.colors.front()) < kDark ? "black_metal" : "painted_metal";
  for (const char* usual : {"chrome", "steel"}) {
    if (decor.metal != usual) decor.others.insert_or_assign(usual, decor.metal);
  }
}

void suit_floor(Decor& decor, const Json& room, std::uint64_t chance) {
  constexpr double kLight = 0.6, kDark = 0.45;
  const auto tone = [](const std::string& floor) {
    const SurfaceWish wish = read_wish(floor);
    return wish.materials.empty() ? 1.0 : brightness(wish.color.value_or(wish.materials.front()->surface.base));
  };
  const Json& boards = decor_data().at("wood_floors");
  const SurfaceWish now = read_wish(decor.floor);
  const bool planks = !now.materials.empty() && now.materials.front()->surface.texture == "planks";
  if (decor.woods_said && planks && boards.contains(decor.woods.front())) decor.floor = boards.at(decor.woods.front()).get<std::string>();
  double light = 0;
  for (const Color& color : decor.accents) light += brightness(color) / static_cast<double>(decor.accents.size());
  if (!decor.colors_said || light < kLight || tone(decor.floor) > kDark) return;
  const Json& floors = room.at("floors");
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const std::string other = floors[(i + chance) % floors.size()].get<std::string>();
    if (tone(other) > kDark) decor.floor = other;
  }
}

std::vector<Color> palette_of(const Json& palette) {
  const Json& colors = palette.is_number() ? decor_data().at("palettes")[palette.get<std::size_t>()] : palette;
  std::vector<Color> all;
  for (const Json& color : colors)
    all.push_back(color.is_string() ? read_wish(color.get<std::string>()).color.value_or(Color{0.8, 0.8, 0.8}) : color_of_json(color));
  return all;
}

PartLook part_look_of(const std::string& words) {
  const SurfaceWish wish = read_wish(words);
  PartLook look;
  if (wish.color) look.colors.push_back(*wish.color);
  if (!wish.materials.empty()) look.material = wish.materials.front();
  return look;
}

bool is_banned(const Color& color, std::span<const Color> banned) {
  return std::ranges::any_of(banned, [&](const Color& other) { return is_like(color, other); });
}

void take_room_look(Decor& decor, RoomLook said, const std::string& kind, bool dark) {
  decor.woods_said = !said.woods.empty();
  if (decor.woods_said) decor.woods = said.woods;
  if (!said.metal.empty()) decor.metal = said.metal;
  std::erase_if(decor.woods,
                [&](const std::string& wood) { return std::ranges::find(said.unwanted_stuffs, wood) != said.unwanted_stuffs.end(); });
  decor.all = said.all;
  decor.unwanted = std::move(said.unwanted);
  if (!said.colors.empty()) {
    constexpr double kDarkened = 0.55;
    decor.feature.reset();  // a style's own
    decor.wall = dark ? mixed(said.colors.front(), decor.wall, kDarkened) : wall_of(said.colors);
    if (lists(decor_data().at("colored_fronts").get<std::string>(), kind))
      decor.parts.emplace("fronts", PartLook{{said.colors.front()}, nullptr});
    part_neutral(decor, said.colors);
    add_shades(said.colors);
    decor.accents = std::move(said.colors);
    decor.colors_said = true;
  }
  if (!decor.unwanted.empty()) give_way(decor);
}

}  // namespace layoutbox
