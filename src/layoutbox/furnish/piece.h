// One object while its family builds it: its size and parameters, its free spaces, the surfaces it was asked for, and what is made so far.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/random.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/furnish/decor.h"
#include "layoutbox/furnish/kit.h"
#include "layoutbox/furnish/palette.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox::kit {

// A free space in metres, in the object's frame. Nothing of the piece may reach into it, except contents where nothing is `held`.
struct FreeSpace {
  std::string name;
  Box box;
  bool carries = true;
  bool held = false;  // another object stands or hangs in it
};

class Piece {
 public:
  // `contents`: whether books, food and the like may be drawn in spaces that hold nothing. `material`: the scene's own, or null.
  // `decor`: the look of the room, where nothing is said of the thing.
  Piece(const PlacedObject& object, const CatalogEntry& entry, std::vector<FreeSpace> spaces, const Material* material, Palette& palette,
        const Decor& decor, std::uint64_t seed, bool contents);

  // Metres: the body reaches from −w/2 to w/2, −d/2 (front) to d/2, 0 to h.
  double w, d, h;
  Box body() const { return {{-w / 2, -d / 2, 0}, {w / 2, d / 2, h}}; }
  const std::vector<FreeSpace> spaces;
  // The side where another of its kind hangs right beside it: -1 left, 1 right, 0 none.
  int twin = 0;
  bool bears = false;  // another object stands on it

  // Parameters: of the catalogue, else `otherwise`.
  double number(std::string_view key, double otherwise) const;
  int count(std::string_view key, int otherwise) const;
  std::string word(std::string_view key, std::string_view otherwise) const;
  // Whether the object's name, attributes or shape words have that word or phrase.
  bool says(std::string_view word) const;
  std::string_view category() const { return object_.category; }
  Mount mount() const { return object_.mount; }

  // The largest carrying space that reaches (nearly) to the top: seat, mattress, inside of a basket; null where there is none.
  const FreeSpace* open_above() const;
  // The highest level that what stands on the floor within the piece reaches (knee room, room under a bed); `otherwise` where none.
  double clear_below(double otherwise) const;
  // Whether a box shares anything with a space.
  bool is_free(const Box& box) const;
  bool may_show_contents() const { return contents_; }

  // Surfaces. main: takes the asked colour and material; frame: only an asked material; named: as it is.
  int main(std::string_view usual);
  int frame(std::string_view usual);
  // main, but never see-through: of a fridge with a glass door only the door is glass.
  int solid_main(std::string_view usual);
  // A frame that is painted with the rest where a colour is asked: a red chair has red legs.
  int painted_frame(std::string_view usual) { return color_asked() ? main(usual) : frame(usual); }
  int named(std::string_view name) { return palette_.named(wanted(name)); }
  int tinted(std::string_view name, const Color& color) { return palette_.add(colored(named_surface(name), color)); }
  // A part as the text has it of such parts in the room ("butcher block counters"), else as is usual.
  int part(std::string_view part, std::string_view usual);
  const PartLook* part_look(std::string_view part) const;  // null: nothing was said
  // A part of this very thing as the text has it ("a marble top"); where it says nothing, what `otherwise` gives.
  const PartLook* own_part(std::string_view part) const;
  int own_part_or(std::string_view part, std::string_view usual, int (Piece::*otherwise)(std::string_view));
  // Whether the object or its room is of that style ("modern", "rustic", …).
  bool is_style(std::string_view style) const;
  // One of `n` ways to draw a kind, by its style and chance: the same for all things of a kind in a room.
  int variant(int n) const;
  // What shelves hold in a room of this kind, or by the piece's own name ("towel shelf"): a word of decor.json; empty where neither says.
  std::string shelf_contents() const;
  // What lies in glass cases in a room of this kind, or by the piece's own name; empty where neither says.
  std::string case_contents() const;
  // What the text says that things of its name hold ("a shelf for the toys"); empty where it says nothing.
  std::string said_contents() const;
  // What pictures show in this room, of several names one; empty: anything.
  const std::string& pictures() const { return decor_.pictures; }
  // A colour for what nobody gave a colour; the same for all things of a kind, so that a room looks of a piece.
  Color accent() const;
  // Another colour that goes with it: the second that was said of the thing, else of the room, else what is calm.
  Color second_accent() const;
  // What is woven into rugs of the room's style; empty: anything.
  const std::string& rug_pattern() const { return decor_.rug; }
  // main with that accent where no colour was asked.
  int main_accent(std::string_view usual);
  // Whether the text says what colours the whole room has.
  bool colors_said() const { return decor_.colors_said; }
  bool color_asked() const { return wish_.color.has_value() || (own_ != nullptr && own_->color.has_value()); }

  void add(int surface, const Mesh& mesh);
  void add(int surface, Mesh mesh, const Pose& pose) { add(surface, posed(std::move(mesh), pose)); }
  void light(Vec position, double watts, double radius = 0.05);
  // Scales what was made so that it fills the body (for grown and free shapes only; the rest is built to size).
  void fit();
  // Puts what was made so much higher, on legs at the corners of its box.
  void raise(double by);
  // Four legs (or as many as stand free) under a rectangle, square or round, moved outwards where a space is in the way.
  void legs(int surface, double top, double thick, double inset, bool round = false, double taper = 1);

  double random() { return random_.fraction(); }
  double random(double from, double to) { return from + (to - from) * random(); }
  int pick(int n) { return static_cast<int>(random() * n); }
  // One of `n` by turns, so that two of a kind (the first and the second poster) are sure to differ.
  int turn(int n) const;

  Node take_node();

 private:
  // One of the solids that were added: some points of the mesh of its surface.
  struct Solid {
    int surface;
    std::size_t from, to;
  };

  void part_coincident_faces();
  void take_part_look(const CatalogEntry& entry);
  void leave_to_parts();
  std::string_view wanted(std::string_view name) const;
  int look_surface(const PartLook& look, std::string_view usual);
  std::optional<Color> color_of_room(const NamedSurface& surface, bool unsaid) const;
  Surface asked(std::string_view usual, bool with_color) const;

  const PlacedObject& object_;
  const CatalogEntry& entry_;
  const Material* own_;
  Palette& palette_;
  Decor decor_;
  bool contents_;
  SurfaceWish wish_;                // what was said of the object, then what the catalogue says of its kind
  std::size_t said_materials_ = 0;  // so many of its materials were said
  std::string text_;
  Random random_;
  std::uint64_t kind_seed_;
  std::map<int, Mesh> meshes_;
  std::vector<Solid> solids_;
  std::vector<Light> lights_;
};

using Family = void (*)(Piece&);
using Families = std::map<std::string_view, Family>;

// All shape families by the names that the catalogue uses.
const Families& families();
// The family of that name, else one that suits anything of that size and mount.
Family family_or_generic(std::string_view name);

// Spread over the files of families/.
void add_seats(Families& to);
void add_sofas(Families& to);
void add_tables(Families& to);
void add_beds(Families& to);
void add_cribs(Families& to);
void add_storage(Families& to);
void add_lamps(Families& to);
void add_screens(Families& to);
void add_textiles(Families& to);
void add_wall_things(Families& to);
void add_pictures(Families& to);
void add_plants(Families& to);
void add_lounge(Families& to);
void add_kitchen(Families& to);
void add_sinks(Families& to);
void add_bath(Families& to);
void add_tableware(Families& to);
void add_small_things(Families& to);
void add_devices(Families& to);
void add_toys(Families& to);
void add_music(Families& to);
void add_gym(Families& to);
void add_shop(Families& to);
void add_vending(Families& to);
void add_trade(Families& to);
void add_games_and_clinic(Families& to);
void add_workshop(Families& to);
void add_hall(Families& to);
void add_appliances(Families& to);
void add_outdoor_things(Families& to);
void add_things_on_tables(Families& to);
void add_media(Families& to);
void add_household(Families& to);
void add_pastimes(Families& to);
void add_worn_things(Families& to);
void add_garden_things(Families& to);
void add_clocks(Families& to);
void add_odd_things(Families& to);
void add_pocket_things(Families& to);
void add_rolling_things(Families& to);
void add_modeled(Families& to);
void add_serving(Families& to);
void add_seat_rows(Families& to);
void add_roofs(Families& to);
void add_generic(Families& to);

}  // namespace layoutbox::kit
