// The user's own furniture: a list of articles with exact sizes, from JSON or CSV, and how it goes together with our catalogue.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// One article. A side of its size that is 0 was not given.
struct Article {
  std::string id;        // the article number, as written
  std::string category;  // the words for what it is: "queen bed"
  std::string name;      // what it is called, or the category
  Size size;
  std::vector<std::string> attributes;  // colour, style…
  std::string material, mesh, mesh_front;
  int stock = -1;  // how many there are; -1: not said
};

struct UserCatalog {
  std::vector<Article> articles;
  std::vector<Note> notes;  // what was read in another way than written
};

// JSON: a list of objects, or one object with such a list ("items", "furniture", "catalog", "products", "articles").
// CSV: a header line, then an article a line, separated by commas, semicolons or tabs. Members and columns go by many names (id, sku,
// article; category, type, kind; width, w, "Width (cm)"; depth, d, length, l; height, h; dims, size…). Lengths are in `units` unless the
// column, the value or the file ("units": "cm") says otherwise; where nobody says, in metres, or in cm or mm where metres cannot be.
// Errors, all at once in `details`: kParse with the line that is broken, kSchema, kReference (an id twice), kGeometry (an impossible size),
// kTooLarge.
Result<UserCatalog> read_user_catalog(std::string_view text, std::string_view units = {});

enum class CatalogMerge {
  kAdd,   // its articles are preferred, our own sizes fill in what it lacks
  kOnly,  // nothing but its articles is placed; what it lacks is left out and noted
};

// Our catalogue with the user's articles: each becomes an entry of its own (CatalogEntry::article) that is like the kind it is of, with
// exactly its size. Sides that were not given are inferred from the kind, and that is added to the notes of `user`.
Catalog with_articles(const Catalog& ours, UserCatalog& user, CatalogMerge merge = CatalogMerge::kAdd);

}  // namespace layoutbox
