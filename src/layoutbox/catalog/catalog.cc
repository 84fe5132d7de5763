#include "layoutbox/catalog/catalog.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/catalog_json.h"
#include "layoutbox/embedded/catalog_data.h"
#include "layoutbox/scene/scene_check.h"

namespace layoutbox {
namespace {

// True for files of entries or rooms: other data beside them (phrases, colours) begins with another key and is not even parsed.
bool is_catalog_file(std::string_view text) {
  const std::size_t brace = text.find('{');
  if (brace == std::string_view::npos) return false;
  const std::size_t quote = text.find('"', brace);
  if (quote == std::string_view::npos) return false;
  const std::string_view key = text.substr(quote + 1, 8);
  return key.starts_with("entries\"") || key.starts_with("rooms\"");
}

// What nobody knows: a plain box that stands on the floor.
const CatalogEntry& generic_entry() {
  static const CatalogEntry entry = [] {
    CatalogEntry box;
    box.id = box.name = "object";
    box.size = {{200, 200, 200}, {500, 500, 500}, {1000, 1000, 1500}};
    box.used_sides = {Side::kFront};
    box.shape.family = "box";
    return box;
  }();
  return entry;
}

}  // namespace

const Catalog& Catalog::builtin() {
  static const Catalog catalog = [] {
    CatalogData data;
    for (const auto& [name, text] : embedded::catalog_data_files()) {
      if (!is_catalog_file(text)) continue;
      [[maybe_unused]] const Status status = read_catalog_data(text, data);
      assert(status.has_value());
    }
    return Catalog(std::move(data.entries), std::move(data.rooms));
  }();
  return catalog;
}

Result<Catalog> Catalog::from_json(std::string_view entries_json, std::string_view rooms_json) {
  CatalogData data;
  LAYOUTBOX_CHECK(read_checked_catalog_data(entries_json, data));
  LAYOUTBOX_CHECK(read_checked_catalog_data(rooms_json, data));
  if (std::vector<Error> errors = check_catalog_data(data); !errors.empty()) return Failure(combined(std::move(errors)));
  return Catalog(std::move(data.entries), std::move(data.rooms));
}

Catalog::Catalog(std::vector<CatalogEntry> entries, std::vector<RoomKind> rooms, bool only_articles)
    : entries_(std::move(entries)), rooms_(std::move(rooms)), only_articles_(only_articles) {
  has_articles_ = std::ranges::any_of(entries_, [](const CatalogEntry& entry) { return !entry.article.empty(); });
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    by_id_.emplace(entries_[i].id, i);
    by_words_.emplace(key_of(entries_[i].id), i);
    by_words_.emplace(key_of(entries_[i].name), i);
    for (const std::string& word : entries_[i].synonyms) by_words_.emplace(key_of(word), i);
  }
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    room_by_words_.emplace(key_of(rooms_[i].id), i);
    room_by_words_.emplace(key_of(rooms_[i].name), i);
    for (const std::string& word : rooms_[i].synonyms) room_by_words_.emplace(key_of(word), i);
  }
}

const CatalogEntry* Catalog::find(std::string_view id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &entries_[found->second];
}

const CatalogEntry* Catalog::find_by_words(std::string_view words) const {
  const std::vector<std::string> all = words_of(words);
  for (std::span<const std::string> rest(all); !rest.empty(); rest = rest.subspan(1)) {
    for (const std::string& key : candidate_keys(rest)) {
      if (const auto found = by_words_.find(key); found != by_words_.end()) return &entries_[found->second];
    }
  }
  return nullptr;
}

const RoomKind* Catalog::find_room(std::string_view words) const {
  const std::vector<std::string> all = words_of(words);
  // "a cosy master bedroom in the attic": the longest run of words that is a room, the last one where several are as long.
  for (std::size_t length = all.size(); length > 0; --length) {
    for (std::size_t begin = all.size() - length + 1; begin-- > 0;) {
      for (const std::string& key : candidate_keys(std::span(all).subspan(begin, length))) {
        if (const auto found = room_by_words_.find(key); found != room_by_words_.end()) return &rooms_[found->second];
      }
    }
  }
  return nullptr;
}

bool Catalog::is_a(std::string_view id, std::string_view ancestor) const {
  // The chain is short; the bound keeps a circle in somebody's data from hanging us.
  for (int step = 0; step < 20 && !id.empty(); ++step) {
    if (id == ancestor) return true;
    const CatalogEntry* entry = find(id);
    if (entry == nullptr) return false;
    id = entry->kind_of;
  }
  return false;
}

const CatalogEntry& Catalog::entry_or_nearest(std::string_view category) const {
  if (const CatalogEntry* exact = find(category)) return *exact;
  if (const CatalogEntry* by_words = find_by_words(category)) return *by_words;
  // "workdesk" → desk: the longest known word that it ends with.
  constexpr std::size_t kShortest = 3;
  const std::vector<std::string> words = words_of(category);
  if (!words.empty()) {
    for (const std::string& form : singular_forms(words.back())) {
      for (std::size_t begin = 1; begin + kShortest <= form.size(); ++begin) {
        if (const auto found = by_words_.find(form.substr(begin)); found != by_words_.end()) return entries_[found->second];
      }
    }
  }
  const CatalogEntry* object = find("object");
  return object != nullptr ? *object : generic_entry();
}

std::vector<const CatalogEntry*> Catalog::articles_of(std::string_view id) const {
  std::vector<const CatalogEntry*> articles;
  if (!has_articles_) return articles;
  for (const CatalogEntry& entry : entries_) {
    if (!entry.article.empty() && is_a(entry.id, id)) articles.push_back(&entry);
  }
  return articles;
}

std::vector<Space> spaces_at(const CatalogEntry& entry, const Size& size) {
  // To a tenth of a millimetre, which is what layout files hold.
  const auto rounded = [](double mm) { return std::round(mm * 10) / 10; };
  std::vector<Space> spaces;
  spaces.reserve(entry.spaces.size());
  for (const SpaceFormula& formula : entry.spaces) {
    Space space;
    space.name = formula.name;
    space.carries = formula.carries;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      space.min[axis] = rounded(formula.min[axis].at(size));
      space.max[axis] = rounded(formula.max[axis].at(size));
    }
    spaces.push_back(std::move(space));
  }
  return spaces;
}

}  // namespace layoutbox
