#include "layoutbox/furnish/piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ranges>
#include <span>

#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/room_look.h"

namespace layoutbox::kit {
namespace {

std::uint64_t hash(std::string_view text, std::uint64_t seed) {
  std::uint64_t h = 1469598103934665603ULL ^ (seed * 0x9E3779B97F4A7C15ULL);
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return h;
}

std::string lower_words(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

constexpr std::size_t kNoTurn = ~std::size_t{0};

// Which of several colours a kind has, so that all of them are seen; none where it is left to chance.
std::size_t turn_of(const std::string& category) {
  const std::string kind = category.substr(category.rfind('_') + 1);
  std::size_t turn = 0;
  for (const nlohmann::json& kinds : decor_data().at("turns")) {
    if (lists(kinds.get_ref<const std::string&>(), kind)) return turn;
    ++turn;
  }
  return kNoTurn;
}

// What was said of the object itself.
std::string said_of(const PlacedObject& object) {
  return lower_words(fmt::format("{}, {}, {}", fmt::join(object.attributes, ", "), object.name, object.material));
}

// What the catalogue says of the look of its kind.
std::string usual_look(const CatalogEntry& entry) {
  std::string text;
  for (const char* key : {"color", "material"}) {
    if (const auto found = entry.shape.words.find(key); found != entry.shape.words.end()) text += lower_words(found->second) + ", ";
  }
  return text;
}

}  // namespace

Piece::Piece(const PlacedObject& object, const CatalogEntry& entry, std::vector<FreeSpace> free_spaces, const Material* material,
             Palette& palette, const Decor& decor, std::uint64_t seed, bool contents)
    : w(m_from_mm(object.size.width)),
      d(m_from_mm(object.size.depth)),
      h(m_from_mm(object.size.height)),
      spaces(std::move(free_spaces)),
      object_(object),
      entry_(entry),
      own_(material),
      palette_(palette),
      decor_(decor_of_thing(decor, said_of(object))),
      contents_(contents),
      random_(hash(object.id, seed)),
      kind_seed_(hash(object.category, seed ^ decor.chance)) {
  std::vector<std::string> own_name = split(lower_words(object.category));
  for (const std::string& word : split(lower_words(entry.name))) own_name.push_back(word);
  wish_ = read_wish(said_of(object), own_name);
  leave_to_parts();
  take_part_look(entry);
  said_materials_ = wish_.materials.size();
  const SurfaceWish usual = read_wish(usual_look(entry));
  wish_.materials.insert(wish_.materials.end(), usual.materials.begin(), usual.materials.end());
  // "sheer linen curtains" are white as others are: cloth may have any color.
  const bool any_color = std::ranges::all_of(wish_.materials, &NamedSurface::tint);
  if (!wish_.color && (said_materials_ == 0 || any_color)) wish_.color = usual.color;
  text_ = fmt::format(" {} {} ", lower_words(object.name), lower_words(fmt::format("{}", fmt::join(object.attributes, " "))));
  for (const auto& [key, value] : entry.shape.words) text_ += value + " ";
}

void Piece::take_part_look(const CatalogEntry& entry) {
  const auto part = entry.shape.words.find("part");
  // What is said of the slab ("marble countertops") is not of the fronts below it.
  const PartLook* slab = part != entry.shape.words.end() && part->second == "fronts" ? part_look("worktops") : nullptr;
  if (slab != nullptr && slab->material != nullptr && std::ranges::find(wish_.materials, slab->material) != wish_.materials.end())
    wish_ = {};
  const PartLook* look = part == entry.shape.words.end() || color_asked() || !wish_.materials.empty() ? nullptr : part_look(part->second);
  if (look == nullptr || (look->material != nullptr && look->material->surface.alpha < 1))
    return;  // doors of glass leave the rest as it is
  if (!look->colors.empty()) wish_.color = look->colors.front();
  if (look->material != nullptr) wish_.materials.push_back(look->material);
}

// "A bed with an emerald velvet headboard": what is said of a part is not of the rest.
void Piece::leave_to_parts() {
  const auto found = decor_.of_things.find(lower_words(object_.name));
  if (found == decor_.of_things.end()) return;
  for (const auto& [part, look] : found->second) {
    if (wish_.color && std::ranges::find(look.colors, *wish_.color) != look.colors.end()) wish_.color.reset();
    std::erase(wish_.materials, look.material);
  }
}

const PartLook* Piece::own_part(std::string_view part) const {
  const auto found = decor_.of_things.find(lower_words(object_.name));
  if (found == decor_.of_things.end()) return nullptr;
  const auto look = found->second.find(part);
  return look == found->second.end() ? nullptr : &look->second;
}

int Piece::own_part_or(std::string_view part, std::string_view usual, int (Piece::*otherwise)(std::string_view)) {
  const PartLook* look = own_part(part);
  return look == nullptr ? (this->*otherwise)(usual) : look_surface(*look, usual);
}

// What is had instead of a surface that the room is not to have.
std::string_view Piece::wanted(std::string_view name) const {
  const auto other = decor_.others.find(name);
  return other == decor_.others.end() ? name : std::string_view(other->second);
}

const PartLook* Piece::part_look(std::string_view part) const {
  const auto found = decor_.parts.find(part);
  return found == decor_.parts.end() ? nullptr : &found->second;
}

int Piece::part(std::string_view part, std::string_view usual) {
  const PartLook* look = part_look(part);
  return look == nullptr ? named(usual) : look_surface(*look, usual);
}

int Piece::look_surface(const PartLook& look, std::string_view usual) {
  const NamedSurface& surface = look.material != nullptr ? *look.material : named_surface(usual);
  if (look.colors.empty()) return palette_.add(surface.surface);
  return palette_.add(colored(surface.tint || surface.kind != "stone" ? surface : named_surface("lacquer"), look.colors.front()));
}

double Piece::number(std::string_view key, double otherwise) const {
  const auto found = entry_.shape.numbers.find(std::string(key));
  return found == entry_.shape.numbers.end() ? otherwise : found->second;
}

int Piece::count(std::string_view key, int otherwise) const {
  return std::clamp(static_cast<int>(std::lround(number(key, otherwise))), 0, 24);
}

std::string Piece::word(std::string_view key, std::string_view otherwise) const {
  const auto found = entry_.shape.words.find(std::string(key));
  return found == entry_.shape.words.end() ? std::string(otherwise) : found->second;
}

bool Piece::says(std::string_view word) const { return text_.find(fmt::format(" {} ", word)) != std::string::npos; }

const FreeSpace* Piece::open_above() const {
  const FreeSpace* best = nullptr;
  const auto volume = [](const Box& b) { return b.size().x * b.size().y * b.size().z; };
  for (const FreeSpace& space : spaces) {
    if (!space.carries || space.box.max.z < h - 0.085 || space.box.min.z < 0.005) continue;
    if (best == nullptr || volume(space.box) > volume(best->box)) best = &space;
  }
  return best;
}

double Piece::clear_below(double otherwise) const {
  double highest = 0;
  for (const FreeSpace& space : spaces) {
    if (space.box.min.z < 0.01 && space.box.max.z < h - 0.001) highest = std::max(highest, space.box.max.z);
  }
  return highest > 0 ? highest : otherwise;
}

bool Piece::is_free(const Box& b) const {
  const double e = 0.0005;
  return std::none_of(spaces.begin(), spaces.end(), [&](const FreeSpace& s) {
    return b.min.x < s.box.max.x - e && b.max.x > s.box.min.x + e && b.min.y < s.box.max.y - e && b.max.y > s.box.min.y + e &&
           b.min.z < s.box.max.z - e && b.max.z > s.box.min.z + e;
  });
}

// Its own color is the room's: "everything is black" is said of cloth and wood, unless woods were said with it; "pink and white" of
// furniture, which is painted white. `unsaid`: nobody said what it is of.
std::optional<Color> Piece::color_of_room(const NamedSurface& surface, bool unsaid) const {
  const bool wood = surface.kind == "wood", lacquer = surface.surface.name == "lacquer", free = !wish_.color && own_ == nullptr;
  const bool all = decor_.all && decor_.colors_said && (surface.soft() || ((wood || lacquer) && !decor_.woods_said));
  if (unsaid && free && all) return accent();
  if (unsaid && free && decor_.paint && ((wood && !surface.tint) || lacquer)) return decor_.paint;
  return surface.surface.name == "leather" && !color_asked() ? decor_.leather : std::nullopt;
}

Surface Piece::asked(std::string_view usual, bool with_color) const {
  const NamedSurface& like = named_surface(usual);
  const NamedSurface* fitting = wish_.fitting(like);
  // What nobody said anything about is of the room's own wood or metal.
  const auto said = std::span(wish_.materials).first(said_materials_);
  if (fitting == nullptr || std::find(said.begin(), said.end(), fitting) == said.end()) {
    const NamedSurface& now = fitting != nullptr ? *fitting : like;
    // What is all of steel (a fridge) may be black, never of brass.
    const bool noble = with_color && named_surface(decor_.metal.empty() ? "steel" : decor_.metal).surface.texture.empty() &&
                       decor_.metal != "black_metal" && decor_.metal != "chrome";
    const bool other_metal = now.surface.name == "steel" && !decor_.metal.empty() && !noble;
    const std::string_view own = other_metal ? std::string_view(decor_.metal) : decor_.wood_for(now.surface.name, kind_seed_);
    if (own != now.surface.name) fitting = &named_surface(own);
    // Of a thing that is all of metal, what is painted is more likely than what is gilded.
    const std::string_view wanted_name = wanted(fitting != nullptr ? fitting->surface.name : like.surface.name);
    if (wanted_name != (fitting != nullptr ? fitting->surface.name : like.surface.name))
      fitting = &named_surface(with_color && now.kind == "metal" ? "painted_metal" : wanted_name);
  }
  const NamedSurface& chosen = fitting != nullptr ? *fitting : like;
  if (const std::optional<Color> color = color_of_room(chosen, said.empty())) return colored(chosen, *color);
  Surface surface = chosen.surface;
  if (!with_color) {
    // A colour said together with a hard material is that material's: "white wooden bed".
    if (fitting == nullptr || !wish_.color || chosen.soft() || std::find(said.begin(), said.end(), fitting) == said.end()) return surface;
  }
  if (own_ != nullptr && own_->color) {
    surface = colored(chosen, *own_->color);
  } else if (wish_.color) {
    surface = colored(chosen, *wish_.color);
  }
  if (own_ != nullptr && with_color) {
    surface.name = own_->id;
    if (own_->roughness) surface.roughness = static_cast<float>(*own_->roughness);
    if (!own_->texture.empty()) {
      surface.image = own_->texture;
      surface.scale = static_cast<float>(1 / std::max(1e-3, own_->uv_scale[0]));
    }
  }
  return surface;
}

int Piece::main(std::string_view usual) { return palette_.add(asked(usual, true)); }
int Piece::solid_main(std::string_view usual) {
  const Surface surface = asked(usual, true);
  return surface.alpha < 1 ? named(usual) : palette_.add(surface);
}
int Piece::frame(std::string_view usual) { return palette_.add(asked(usual, false)); }

bool Piece::is_style(std::string_view style) const { return decor_.style == style; }

int Piece::variant(int n) const { return static_cast<int>((kind_seed_ >> 7) % static_cast<std::uint64_t>(n)); }

std::string Piece::shelf_contents() const {
  const std::string named = shelf_contents_named(text_);
  return named.empty() ? decor_.shelves : named;
}

std::string Piece::case_contents() const {
  const std::string named = shelf_contents_named(text_);
  return named.empty() ? decor_.cases : named;
}

std::string Piece::said_contents() const {
  const std::string name = lower_words(object_.name), head = name.substr(0, name.find(" of "));  // "shelf of wine bottles"
  for (const auto& [holder, contents] : decor_.shelves_said) {
    if (head.ends_with(holder)) return contents;
  }
  return {};
}

Color Piece::accent() const {
  static constexpr Color kCalm[] = {{0.80, 0.75, 0.66}, {0.62, 0.66, 0.60}, {0.60, 0.64, 0.68}, {0.72, 0.62, 0.52}, {0.84, 0.80, 0.73}};
  Random random(kind_seed_);
  const std::size_t turn = turn_of(object_.category);
  if (decor_.colors_said && turn != kNoTurn)
    return decor_.accents[(turn + (decor_.accents.size() == 2 ? decor_.chance % 2 : 0)) % decor_.accents.size()];
  if (!decor_.accents.empty()) return decor_.accents[random.below(decor_.accents.size())];
  return kCalm[random.below(std::size(kCalm))];
}

Color Piece::second_accent() const {
  if (wish_.second) return *wish_.second;
  const Color first = wish_.color.value_or(accent());
  const auto other = std::ranges::find_if(decor_.accents, [&](const Color& color) { return !is_much_like(color, first); });
  const bool own = wish_.color && !decor_.colors_said;  // what the room has besides need not go with it
  return own || other == decor_.accents.end() ? Color{0.92, 0.89, 0.82} : *other;
}

int Piece::main_accent(std::string_view usual) {
  const NamedSurface* fitting = wish_.fitting(named_surface(usual));
  const NamedSurface& chosen = fitting != nullptr ? *fitting : named_surface(usual);
  const bool own_look =
      color_asked() || !chosen.tint || chosen.kind == "leather" || chosen.surface.alpha < 1 || (fitting != nullptr && !chosen.soft());
  return own_look ? main(usual) : palette_.add(colored(chosen, accent()));
}

}  // namespace layoutbox::kit
