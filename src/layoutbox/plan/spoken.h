// What a text speaks of: the kinds that it names, counts or wants none of, and its very words. What is added unasked keeps off these.
#pragma once

#include <compare>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/dressing.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

class Spoken {
 public:
  // Of a scene planned from text; `excluded`: the kinds that it wants none of (Plan::unwanted). What was added or is only usual is not
  // spoken of. REQUIRES: the catalogue outlives it.
  Spoken(const SceneGraph& scene, std::vector<std::string> excluded, const Catalog& catalog);

  // The text has things of that kind, of a more general or a special one, or of the same head noun; or it wants none.
  bool of(const CatalogEntry& kind) const;
  // The same, but for things of a more general kind.
  bool of_just(const CatalogEntry& kind) const;
  // It asks for that kind or a special one, or it wants none: "chairs" are no office chairs, and those of "a table for four" not asked for.
  bool names(const CatalogEntry& kind) const;
  // It asks for so many kinds of things that it wants those, and not what such a habit adds.
  bool says_enough_for(const Dressing& habit) const;
  // No pot plants in ruins, no prints in a dungeon, nothing on tops that are said to be clear. `place`: as in dress.json.
  bool keeps_off(const std::string& kind, const std::string& place, const std::string& room) const;
  // One of the phrases stands in the text, word for word.
  bool says_any(const std::vector<std::string>& phrases) const;
  // "Nothing else", "an empty room"; but not "an empty room, please furnish".
  bool wants_no_more(const Groups& groups) const;

 private:
  int kinds_asked() const;
  bool excludes(const CatalogEntry& kind) const;
  bool akin(const std::string& a, const std::string& b) const { return catalog_->is_a(a, b) || catalog_->is_a(b, a); }

  const Catalog* catalog_;
  std::vector<std::string> excluded_, said_;
  struct Named {
    std::string category, head;  // `head`: its noun
    bool asked = false;          // not only concluded from for how many it is
    auto operator<=>(const Named&) const = default;
  };
  std::set<Named> named_;  // each once, however many there are
};

}  // namespace layoutbox
