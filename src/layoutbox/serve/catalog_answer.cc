#include <algorithm>
#include <cctype>

#include "layoutbox/scene/relation_table.h"
#include "layoutbox/serve/call_parts.h"

namespace layoutbox::serve {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// 3: begins with it, 2: a word of it does, 1: it stands within, 0: not there.
int match(std::string_view name, std::string_view wanted) {
  const std::string text = lower_case(name);
  const std::size_t at = text.find(wanted);
  if (at == std::string::npos) return 0;
  if (at == 0) return 3;
  return text.find(" " + std::string(wanted)) != std::string::npos ? 2 : 1;
}

int best_match(const CatalogEntry& entry, std::string_view wanted) {
  int best = 2 * match(entry.name, wanted);
  for (const std::string& word : entry.synonyms) best = std::max(best, 2 * match(word, wanted) - 1);
  return best;
}

Json article_of(const CatalogEntry& entry) {
  const auto metres = [](Mm length) { return static_cast<double>(length) / 1000; };
  const Size& size = entry.size.usual;
  return {{"id", entry.id},
          {"name", entry.name},
          {"size", {metres(size.width), metres(size.depth), metres(size.height)}},
          {"mount", name_of(entry.mount)},
          {"rooms", entry.rooms}};
}

}  // namespace

Answer catalog_answer(const Catalog& catalog, std::string_view search, std::size_t limit) {
  const std::string wanted = lower_case(search);
  std::vector<std::pair<int, const CatalogEntry*>> found;
  for (const CatalogEntry& entry : catalog.entries()) {
    const int score = wanted.empty() ? 1 : best_match(entry, wanted);
    if (score > 0) found.emplace_back(-score, &entry);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  if (found.size() > limit) found.resize(limit);
  Json articles = Json::array();
  for (const auto& [score, entry] : found) articles.push_back(article_of(*entry));
  return json_answer({{"articles", std::move(articles)}});
}

}  // namespace layoutbox::serve
