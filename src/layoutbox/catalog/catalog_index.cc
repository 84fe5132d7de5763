#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/catalog.h"

namespace layoutbox {
namespace {

// Sorted by key; the earlier of two places that claim a key keeps it.
void settle(CatalogIndex::Keys& keys) {
  std::ranges::sort(keys);
  const auto repeated = std::ranges::unique(keys, {}, &CatalogIndex::Keys::value_type::first);
  keys.erase(repeated.begin(), repeated.end());
}

template <class Item>
void add_words(CatalogIndex::Keys& keys, const Item& item, std::uint32_t place) {
  keys.emplace_back(key_of(item.id), place);
  keys.emplace_back(key_of(item.name), place);
  for (const std::string& word : item.synonyms) keys.emplace_back(key_of(word), place);
}

}  // namespace

CatalogIndex index_of(const std::vector<CatalogEntry>& entries, const std::vector<RoomKind>& rooms) {
  CatalogIndex index;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    index.ids.emplace_back(entries[i].id, i);
    add_words(index.words, entries[i], i);
  }
  for (std::uint32_t i = 0; i < rooms.size(); ++i) add_words(index.room_words, rooms[i], i);
  settle(index.ids);
  settle(index.words);
  settle(index.room_words);
  return index;
}

std::optional<std::uint32_t> find_key(const CatalogIndex::Keys& keys, std::string_view key) {
  const auto found = std::ranges::lower_bound(keys, key, {}, [](const auto& item) -> std::string_view { return item.first; });
  return found != keys.end() && found->first == key ? std::optional(found->second) : std::nullopt;
}

}  // namespace layoutbox
