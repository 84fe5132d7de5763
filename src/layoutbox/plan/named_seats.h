// What a text has of seats at tables.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/growing_scene.h"

namespace layoutbox {

// What the text has of seats at tables, before any comes with them.
struct NamedSeats {
  // The text itself speaks of chairs or stools.
  bool spoken_of = false;
  // One stands by nothing in particular: it may well be meant for any table.
  bool loose = false;
  // "two desks, a meeting table with four chairs": all are those of another table, so that the desk's are still to come.
  bool taken = false;
  // "a desk, a bean bag": no seat that is named is one to work at.
  bool easy_only = false;
  // … or of other desks: pupils' chairs are not the teacher's.
  bool at_desks = false;

  NamedSeats(const GrowingScene& scene, const Catalog& catalog);
};

}  // namespace layoutbox
