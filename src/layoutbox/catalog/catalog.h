// What furniture is: kinds, sizes and their ranges, mounts, used sides, free spaces, shape families, and the words for them.
// The data is catalog/*.json, checked against schema/catalog.schema.json and embedded when the program is built.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/traits.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// A length as a linear form of the object's size: w·width + d·depth + h·height + constant, in millimetres.
// Written in the catalogue as a formula in metres: "w/2 - 0.02", "h*2/5".
struct LinearFormula {
  double w = 0, d = 0, h = 0, constant = 0;
  double at(const Size& size) const { return w * size.width + d * size.depth + h * size.height + constant; }
};

// A free box within the object's box whose sides are formulas of its size (scene-format.md, `spaces`).
struct SpaceFormula {
  std::string name;
  std::array<LinearFormula, 3> min, max;
  bool carries = true;
};

// A size that goes with a word: "king" bed, "round" table, "two-seater" sofa; and the spaces, where they are others than the entry's
// (a round table stands on one foot).
struct SizeVariant {
  std::vector<std::string> words;
  SizeRange size;
  std::vector<SpaceFormula> spaces;  // none: the entry's
};

struct ShapeSpec {
  std::string family;                        // "bed", "table", "chair"…: furnish/families
  std::string symbol;                        // what the floor plan draws: its own, else its family's (catalog/shapes.json); empty: a box
  std::map<std::string, double> numbers;     // parameters of the family: "legs": 4, "drawers": 3
  std::map<std::string, std::string> words;  // "top": "round", "material": "oak"
};

struct CatalogEntry {
  std::string id;                     // "dining_table", the category in scenes and layouts
  std::string name;                   // "dining table"
  std::vector<std::string> synonyms;  // other words for exactly this kind; unique over the catalogue
  std::string kind_of;                // a more general entry's id, or empty ("bunk_bed" is a kind of "bed")
  Traits traits;                      // its own and those of what it is a kind of
  Traits traits_lacked;               // those of what it is a kind of that it does not have
  SizeRange size;
  std::vector<SizeVariant> variants;
  Mount mount = Mount::kFloor;
  std::vector<Side> used_sides;
  bool has_front = true;         // false: a plant, a round table; sides are then the room's
  bool back_to_wall = false;     // habit: beds, wardrobes, sofas, desks, shelves
  bool thin = false;             // rugs and mats: at most 30 mm high, collide with nothing
  bool lain_on = false;          // thin, but lain or stood on: nothing else stands there (a yoga mat)
  bool top_carries = false;      // things can stand on its top
  std::map<Side, Mm> clearance;  // free floor wanted at a side (soft), in millimetres
  Mm hang_height = 0;            // wall: usual height of the underside; ceiling: length it hangs down is its height
  std::vector<SpaceFormula> spaces;
  std::vector<std::string> stands_on;  // surface mount: entry ids it usually stands on, best first
  std::vector<std::string> faces;      // entry ids its front usually looks at (sofa: tv, coffee_table)
  std::vector<std::string> beside;     // entry ids it usually stands by (nightstand: bed; desk_chair: desk)
  std::vector<std::string> rooms;      // kinds of room it is usual in
  ShapeSpec shape;
  bool is(Trait trait) const { return traits.has(trait); }
  std::string source;  // where the sizes come from
  // Of an article from the user's catalogue (user_catalog.h): its number, how many there are (-1: not said), and its own looks.
  std::string article;
  int stock = -1;
  std::string article_material, article_mesh, article_mesh_front;
  std::vector<std::string> article_attributes;  // colour, style…
};

// The usual furniture and size of a kind of room.
struct RoomKind {
  std::string id, name;  // "living_room", "living room"
  std::vector<std::string> synonyms;
  Size usual_size;                                 // of an ordinary room of this kind
  std::vector<std::pair<std::string, int>> usual;  // entry id and how many, most important first
  std::vector<std::vector<std::string>> needs;     // what it is no such room without: one of each row, usually the first
  std::string door;                                // the look of a door of its own ("garage"), by words_openings.json; empty: none
};

// Where words lead: sorted keys (key_of) with places in the lists of entries and rooms.
struct CatalogIndex {
  using Keys = std::vector<std::pair<std::string, std::uint32_t>>;
  Keys ids, words, room_words;
};
CatalogIndex index_of(const std::vector<CatalogEntry>& entries, const std::vector<RoomKind>& rooms);
std::optional<std::uint32_t> find_key(const CatalogIndex::Keys& keys, std::string_view key);

class Catalog {
 public:
  // REQUIRES: ids are unique. A word that two entries claim means the earlier one.
  Catalog(std::vector<CatalogEntry> entries, std::vector<RoomKind> rooms, bool only_articles = false);

  // The embedded catalogue, read once. It is checked when the program is built, so it is always there.
  static const Catalog& builtin();

  // Reads a catalogue from JSON text in our own form; all errors at once.
  // Errors: kParse, kSchema; kReference (ids or words used twice, names of nothing), kGeometry (spaces outside their box).
  static Result<Catalog> from_json(std::string_view entries_json, std::string_view rooms_json);

  std::span<const CatalogEntry> entries() const { return entries_; }
  std::span<const RoomKind> rooms() const { return rooms_; }

  const CatalogEntry* find(std::string_view id) const;  // exactly that id
  // By id, name, synonym or plural, case and separators apart; else by the longest known ending ("oak bookshelf" → bookshelf).
  const CatalogEntry* find_by_words(std::string_view words) const;
  const RoomKind* find_room(std::string_view words) const;
  // True when `id` is `ancestor` or a kind of it.
  bool is_a(std::string_view id, std::string_view ancestor) const;
  // What an object of any category is: its entry, else the nearest entry, else the generic box ("object").
  const CatalogEntry& entry_or_nearest(std::string_view category) const;

  // The entries that are articles of the user's and a kind of `id` (or that article itself), in their order.
  std::vector<const CatalogEntry*> articles_of(std::string_view id) const;
  // True when there are articles at all, and when nothing else may be placed.
  bool has_articles() const { return has_articles_; }
  bool only_articles() const { return only_articles_; }

 private:
  Catalog(std::vector<CatalogEntry> entries, std::vector<RoomKind> rooms, CatalogIndex index)
      : entries_(std::move(entries)), rooms_(std::move(rooms)), index_(std::move(index)) {}

  std::vector<CatalogEntry> entries_;
  std::vector<RoomKind> rooms_;
  bool has_articles_ = false, only_articles_ = false;
  CatalogIndex index_;
};

// The catalogue's free spaces at that size.
std::vector<Space> spaces_at(const CatalogEntry& entry, const Size& size);

// The space below what was raised onto legs so that something finds room there; the body of its kind stands above it.
inline constexpr std::string_view kSpaceUnderIt = "under it";

// The free spaces of an object: the scene's own where a file gave them, else those of the first variant of its entry that its words name
// ("round" table) where that has any, else the entry's; and those that it was given to hold what is to be in or under it.
std::vector<Space> spaces_of(const SceneObject& object, const CatalogEntry& entry, const Size& size);

// "w/2 - 0.02" in metres → millimetres; error with the place in the text.
Result<LinearFormula> parse_formula(std::string_view text, double index = 0);

}  // namespace layoutbox
