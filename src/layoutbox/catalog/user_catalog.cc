#include "layoutbox/catalog/user_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/size_words.h"

namespace layoutbox {
namespace {

constexpr Mm kUnlike = 10;  // so many times smaller or larger than its kind: a wrong unit

std::string text_of(const Size& size) {
  return fmt::format("{:.4g} x {:.4g} x {:.4g} m", size.width / 1000.0, size.depth / 1000.0, size.height / 1000.0);
}

// An entry that is like `kind`, with the article's own size and names.
CatalogEntry entry_of(const Article& article, const CatalogEntry& kind, std::string id, std::vector<Note>& notes) {
  CatalogEntry entry = kind;
  entry.id = std::move(id);
  entry.name = article.name;
  entry.synonyms = {article.id};
  entry.kind_of = kind.id;
  entry.variants.clear();
  std::vector<std::string> said = words_of(article.name);
  for (const std::string& attribute : article.attributes) std::ranges::copy(words_of(attribute), std::back_inserter(said));
  std::ranges::copy(words_of(article.category), std::back_inserter(said));
  const Size usual = size_by_words(kind, said).usual;
  Size size = article.size;
  for (const auto side : {&Size::width, &Size::depth, &Size::height}) {
    if (size.*side == 0) size.*side = usual.*side;
  }
  if (size != article.size) {
    notes.push_back(
        {"filled",
         fmt::format("the size of article \"{}\" is not complete: {} is inferred from \"{}\"", article.id, text_of(size), kind.name),
         {}});
  }
  for (const auto& [side, name] : {std::pair{&Size::width, "wide"}, {&Size::depth, "deep"}, {&Size::height, "high"}}) {
    if (article.size.*side == 0 || kind.id == "object") continue;
    const Mm least = kind.size.least.*side, greatest = kind.size.greatest.*side;
    if (size.*side * kUnlike >= least && size.*side <= greatest * kUnlike) continue;
    notes.push_back({"warning",
                     fmt::format("article \"{}\" is read as {} mm {}, and a {} is {} to {} mm: the unit of that column, or the sign of its "
                                 "decimals, seems to be another; name the unit in the header, as in \"width (cm)\"",
                                 article.id, size.*side, name, kind.name, least, greatest),
                     {}});
  }
  entry.size = {size, size, size};
  entry.thin = kind.thin && size.height <= 30;
  entry.source = "the user's catalogue";
  entry.article = article.id;
  entry.stock = article.stock;
  entry.article_material = article.material;
  entry.article_mesh = article.mesh;
  entry.article_mesh_front = article.mesh_front;
  entry.article_attributes = article.attributes;
  return entry;
}

}  // namespace

Catalog with_articles(const Catalog& ours, UserCatalog& user, CatalogMerge merge) {
  std::vector<CatalogEntry> entries(ours.entries().begin(), ours.entries().end());
  std::set<std::string> ids;
  for (const CatalogEntry& entry : entries) ids.insert(entry.id);
  // Kinds that articles are of and that we do not know become entries too, so that words find them.
  for (const Article& article : user.articles) {
    const std::string category = snake_case(article.category);
    const CatalogEntry* kind = ours.find_by_words(article.category);
    if (kind == nullptr) {
      kind = &ours.entry_or_nearest(category);
      user.notes.push_back(
          {"guessed",
           fmt::format("what a \"{}\" is, is not known: article \"{}\" is drawn like \"{}\"", article.category, article.id, kind->name),
           {}});
      if (ids.insert(category).second) {
        CatalogEntry unknown = *kind;
        unknown.id = category;
        unknown.name = article.category;
        unknown.synonyms.clear();
        unknown.kind_of = kind->id == "object" ? "" : kind->id;
        entries.push_back(std::move(unknown));
      }
    }
    CatalogEntry like = *kind;
    if (ours.find_by_words(article.category) == nullptr) like.id = category;
    std::string id = snake_case(article.id);
    if (id.empty()) id = category + "_article";
    for (int n = 2; !ids.insert(id).second; ++n) id = fmt::format("{}_{}", snake_case(article.id), n);
    entries.push_back(entry_of(article, like, std::move(id), user.notes));
  }
  return Catalog(std::move(entries), {ours.rooms().begin(), ours.rooms().end()}, merge == CatalogMerge::kOnly);
}

}  // namespace layoutbox
