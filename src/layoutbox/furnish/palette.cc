#include "layoutbox/furnish/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;

// "#" stands for a gap that no phrase reaches over.
std::vector<std::string> words_and_gaps(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    if (std::isalnum(u) || u >= 128) {
      words.back() += static_cast<char>(std::tolower(u));
    } else if (c == ',' || c == ';') {
      words.insert(words.end(), {"#", ""});
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  std::erase(words, "");
  return words;
}

std::string phrase(std::span<const std::string> words) { return fmt::format("{}", fmt::join(words, " ")); }

Color color_of(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

struct ColorModifier {
  Color color;
  double share = 0;
  std::optional<Color> alone;  // "a pale sofa": where it is said of no colour
};

// Everything that the two data files say, by phrase of words.
struct Tables {
  std::vector<NamedSurface> surfaces;
  std::map<std::string, std::size_t, std::less<>> by_name, by_phrase;
  std::map<std::string, Color, std::less<>> colors;
  std::map<std::string, ColorModifier, std::less<>> modifiers;
  std::set<std::string, std::less<>> look_words;
};

NamedSurface surface_of(const Json& json) {
  NamedSurface named;
  Surface& s = named.surface;
  s.name = json.at("name").get<std::string>();
  s.base = color_of(json.at("base"));
  s.second = color_of(json.at("second"));
  s.roughness = json.value("roughness", 0.7F);
  s.metallic = json.value("metallic", 0.0F);
  s.alpha = json.value("alpha", 1.0F);
  s.emission = json.value("emission", 0.0F);
  s.texture = json.value("texture", "");
  s.scale = json.value("scale", 1.0F);
  named.kind = json.at("kind").get<std::string>();
  named.words = json.at("words").get<std::vector<std::string>>();
  named.tint = json.value("tint", false);
  return named;
}

Tables read_tables() {
  Tables tables;
  const Json materials = Json::parse(embedded::materials_json), colors = Json::parse(embedded::colors_json);
  for (const Json& json : materials.at("surfaces")) {
    const std::size_t index = tables.surfaces.size();
    tables.surfaces.push_back(surface_of(json));
    const NamedSurface& named = tables.surfaces.back();
    tables.by_name.emplace(named.surface.name, index);
    tables.by_phrase.emplace(phrase(words_and_gaps(named.surface.name)), index);
    for (const std::string& words : named.words) tables.by_phrase.emplace(phrase(words_and_gaps(words)), index);
  }
  for (const auto& [words, color] : colors.at("colors").items()) tables.colors.emplace(phrase(words_and_gaps(words)), color_of(color));
  for (const auto& [word, modifier] : colors.at("modifiers").items()) {
    tables.modifiers.emplace(word,
                             ColorModifier{color_of(modifier.at("color")), modifier.at("share").get<double>(),
                                           modifier.contains("alone") ? std::optional(color_of(modifier.at("alone"))) : std::nullopt});
  }
  const auto note = [&](std::string_view said) {
    for (std::string& word : words_and_gaps(said)) tables.look_words.insert(std::move(word));
  };
  for (const auto& [said, index] : tables.by_phrase) {
    if (tables.surfaces[index].kind != "floor") note(said);
  }
  for (const auto& [said, color] : tables.colors) note(said);
  for (const auto& [word, modifier] : tables.modifiers) note(word);
  return tables;
}

const Tables& tables() {
  static const Tables all = read_tables();
  return all;
}

constexpr std::size_t kLongestPhrase = 5;  // words of a material's name

bool brownish(const Color& c) { return c.r > c.g && c.g > c.b && c.r - c.b > 0.12 && c.g - c.b < 0.35 && c.r < 0.85 && c.r - c.g < 0.32; }

}  // namespace

std::span<const NamedSurface> named_surfaces() { return tables().surfaces; }

const NamedSurface& named_surface(std::string_view name) {
  static const NamedSurface grey{{"grey", {0.6, 0.6, 0.6}, 0.7F, 0, 1, 0, "", {0.6, 0.6, 0.6}, 1, "", nullptr}, "other", {}, true};
  const auto found = tables().by_name.find(name);
  assert(found != tables().by_name.end());
  return found == tables().by_name.end() ? grey : tables().surfaces[found->second];
}

const NamedSurface* SurfaceWish::fitting(const NamedSurface& like) const {
  const auto found = std::find_if(materials.begin(), materials.end(), [&](const NamedSurface* m) { return m->soft() == like.soft(); });
  return found == materials.end() ? nullptr : *found;
}

SurfaceWish read_wish(std::string_view text, std::span<const std::string> skip) {
  SurfaceWish wish;
  const std::vector<std::string> words = words_and_gaps(text);
  std::optional<ColorModifier> modifier;
  std::optional<Color> alone;
  for (std::size_t i = 0; i < words.size();) {
    if (std::find(skip.begin(), skip.end(), words[i]) != skip.end()) {
      ++i;
      continue;
    }
    std::size_t used = 0;
    for (std::size_t n = std::min(kLongestPhrase, words.size() - i); n > 0 && used == 0; --n) {
      const std::string part = phrase(std::span(words).subspan(i, n));
      // "gold" alone is a colour of cloth and a metal of lamps: it counts as both.
      const auto material = tables().by_phrase.find(part);
      const auto color = tables().colors.find(part);
      if (material != tables().by_phrase.end()) wish.materials.push_back(&tables().surfaces[material->second]);
      if (color != tables().colors.end() && !wish.second) {
        (wish.color ? wish.second : wish.color) = modifier ? mixed(color->second, modifier->color, modifier->share) : color->second;
      }
      if (material != tables().by_phrase.end() || color != tables().colors.end()) used = n;
    }
    const auto found = tables().modifiers.find(words[i]);
    modifier = used == 0 && found != tables().modifiers.end() ? std::optional(found->second) : std::nullopt;
    if (modifier && modifier->alone) alone = modifier->alone;
    i += std::max<std::size_t>(used, 1);
  }
  if (!wish.color && wish.materials.empty()) wish.color = alone;
  return wish;
}

bool is_look_word(std::string_view word) { return tables().look_words.contains(word); }

Color mixed(const Color& a, const Color& b, double t) { return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t}; }

Surface colored(const NamedSurface& named, const Color& color) {
  const NamedSurface* from = &named;
  if (!named.tint && named.kind == "wood" && !brownish(color)) from = &named_surface("lacquer");
  if (!named.tint && named.kind == "metal") from = &named_surface("painted_metal");
  if (!named.tint && named.kind == "plastic") from = &named_surface("plastic");
  if (named.surface.name == "cardboard") from = &named_surface("paper");  // a box of a colour is of dyed board
  Surface surface = from->surface;
  // What is seen through, gilded or veined keeps its own colour.
  if (!from->tint && from->kind != "wood" && from->kind != "leather" && from->kind != "floor") return surface;
  const std::string& texture = from->surface.texture;
  const double dark = std::max({color.r, color.g, color.b}), pale = std::min({color.r, color.g, color.b});
  const bool checker = texture == "checker" || texture == "rosettes";  // of two colours, the second of which is the one that is said
  if (checker && (dark < 0.2 || pale > 0.8)) return surface;           // black and white are its own two
  (checker ? surface.second : surface.base) = color;
  const bool printed = from->kind == "floor" && (texture == "stripes" || texture == "flowers");  // on paper of that colour
  if (!checker)
    surface.second = printed ? mixed(color, Color{1, 1, 1}, 0.6)
                             : mixed(color, Color{0, 0, 0}, from->kind == "floor" && texture == "tiles" ? 0.3 : 0.16);
  const auto byte = [](double c) { return static_cast<int>(std::clamp(c, 0.0, 1.0) * 255 + 0.5); };
  surface.name = fmt::format("{}_{:02x}{:02x}{:02x}", from->surface.name, byte(color.r), byte(color.g), byte(color.b));
  return surface;
}

Surface worn(const Surface& surface, double wear) {
  constexpr Color kGrime{0.27, 0.23, 0.18};
  constexpr double kOnAll = 0.35, kInBlotches = 0.95;  // shares of the grime
  if (wear <= 0 || surface.emission > 0 || surface.alpha < 1) return surface;
  Surface old = surface;
  old.base = mixed(surface.base, kGrime, kOnAll * wear);
  old.second = mixed(surface.second, kGrime, kInBlotches * wear);
  old.roughness = static_cast<float>(std::lerp(static_cast<double>(surface.roughness), 0.95, wear));
  old.metallic = static_cast<float>(static_cast<double>(surface.metallic) * (1 - wear));
  if (old.texture.empty() || old.texture == "plaster" || old.texture == "brushed") old.texture = "concrete", old.scale = 0.45F;
  return old;
}

int Palette::add(const Surface& added) {
  const Surface surface = worn(added, wear_);
  const auto same = [](const Surface& a, const Surface& b) {
    return a.base == b.base && a.second == b.second && a.roughness == b.roughness && a.metallic == b.metallic && a.alpha == b.alpha &&
           a.emission == b.emission && a.texture == b.texture && a.scale == b.scale && a.image == b.image;
  };
  int others = 0;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (surfaces_[i].name != surface.name && !surfaces_[i].name.starts_with(surface.name + "~")) continue;
    if (same(surfaces_[i], surface)) return static_cast<int>(i);
    ++others;
  }
  surfaces_.push_back(surface);
  if (others > 0) surfaces_.back().name = fmt::format("{}~{}", surface.name, others + 1);
  return static_cast<int>(surfaces_.size() - 1);
}

}  // namespace layoutbox
