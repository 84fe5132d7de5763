// The steps of normalize_scene, in their order. Each fills what is missing and notes it; errors are collected, not thrown.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "layoutbox/catalog/normalize.h"

namespace layoutbox {

inline bool names(const std::vector<std::string>& ids, const std::string& id) { return std::ranges::find(ids, id) != ids.end(); }

struct NormalizeContext {
  SceneGraph& scene;
  const Catalog& catalog;
  const NormalizeOptions& options;
  std::vector<Error> errors;
  std::map<std::string, int> articles_used;  // how often each of the user's articles was taken

  void note(std::string code, std::string message, std::string pointer = {});
  void error(ErrorCode code, std::string message, std::string pointer = {}, std::string hint = {});
};

// Curtains "on", "over" or "in front of" a window hang at it: none of them stands on its sill or hangs above it.
void hang_curtains_at_windows(NormalizeContext& context);

// A shelf below a mirror on the wall hangs there too, along all the mirrors that it is below.
void hang_shelves_under_mirrors(NormalizeContext& context);

// Ids, categories, sizes, used sides and mounts of all objects.
void normalize_objects(NormalizeContext& context);

// Larger usual sizes, within their ranges, for furniture that must hold more than usual. REQUIRES: sizes are known.
void normalize_hosts(NormalizeContext& context);

// Desks on which it is concluded that several screens stand have room for them side by side.
void normalize_screens(NormalizeContext& context);

// What is wider than the seat that it lies on, and of an assumed size, is folded: a blanket over an armchair.
void fold_over_seat(const Catalog& catalog, const SceneObject& seat, SceneObject& thing);

// What is to be in or under something finds room there: furniture that is solid gets legs or an inside, guests of an assumed size are
// smaller. REQUIRES: sizes are known.
void normalize_guests(NormalizeContext& context);

// Carpets that many pieces of furniture stand on, as large as those take. REQUIRES: sizes are known.
void normalize_carpets(NormalizeContext& context);

// The article of the user's that an object is: the one it names, else of its kind, the best by words, the least used; null for none.
const CatalogEntry* choose_article(const NormalizeContext& context, const SceneObject& object);

// Makes the object that article: its exact size, number, name and looks.
void take_article(NormalizeContext& context, SceneObject& object, const CatalogEntry& article, const std::string& pointer);

// Where nothing but articles may be placed: objects without one are left out; a room that only had its usual furniture gets a selection
// of what there is. Errors: kEmpty when nothing is left.
void settle_articles_only(NormalizeContext& context);

// Polygon, height, walls and openings. REQUIRES: sizes of objects are known (an unsized room grows with them).
void normalize_room(NormalizeContext& context);

// Walls, places and sizes of doors and windows; one of each where nobody spoke of any. REQUIRES: outline and height are known.
void normalize_openings(NormalizeContext& context);

// By how much both sides of a room of that area must grow so that the floor holds what stands on it, and the longest piece fits along a
// wall; or may shrink where little stands there and nobody spoke of the room's size.
double growth_for_furniture(const NormalizeContext& context, double area, double longest_side);

// The room's two sides, grown until the distances that words ask for find room in it, given how large things are: rather longer than
// larger.
struct FloorSides {
  double width = 0, depth = 0;  // mm
};
FloorSides grown_for_distances(const NormalizeContext& context, FloorSides sides);

// What is far in a room that is what it is, and heights of what is to hang above something. REQUIRES: the room is settled.
void normalize_distances(NormalizeContext& context);

// Columns of grids that nobody gave, by the room. REQUIRES: sizes of objects and the room are known.
void normalize_grids(NormalizeContext& context);

// Widths of curtains that nobody gave, by their windows. REQUIRES: sizes of objects and openings are known.
void normalize_curtains(NormalizeContext& context);

// Where the ceiling comes down: slopes run along their whole wall, from a knee wall up to the ceiling, and stay there; windows in them.
// REQUIRES: the room is settled.
void normalize_slopes(NormalizeContext& context);

// Benches that are told to be along a wall are as long as that and their range let them be. REQUIRES: relations name walls by their ids.
void normalize_worktops(NormalizeContext& context);

// Names that relations use: walls by word become ids, relations to nothing are left out; ids for those without.
void normalize_relations(NormalizeContext& context);

// Parts that relations name and their things do not have are errors. REQUIRES: names are settled, sizes known.
void check_parts(NormalizeContext& context);

// Visitors sit before the desk, who works there behind it, where words leave that open.
void normalize_visitors(NormalizeContext& context);

// What stands or hangs on something gets something to stand on; heights of pose hints that may mean the centre are settled.
void normalize_support(NormalizeContext& context);

// "bed_1" where "bed" is taken: the first of base, base_2, base_3… that no object, wall, opening or relation has.
std::string unused_id(const SceneGraph& scene, const std::string& base);

std::string metres_text(double mm);  // "1.6 m"

}  // namespace layoutbox
