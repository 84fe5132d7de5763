#include "layoutbox/catalog/catalog.h"

#include "layoutbox/catalog/size_words.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/catalog_json.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/pack.h"
#include "layoutbox/embedded/catalog_pack.h"
#include "layoutbox/scene/scene_check.h"

namespace layoutbox {
namespace {

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
    CatalogIndex index;
    unpack_catalog(embedded::catalog_pack, data, index);
    return Catalog(std::move(data.entries), std::move(data.rooms), std::move(index));
  }();
  return catalog;
}

Result<Catalog> Catalog::from_json(std::string_view entries_json, std::string_view rooms_json) {
  CatalogData data;
  LAYOUTBOX_CHECK(read_checked_catalog_data(entries_json, data));
  LAYOUTBOX_CHECK(read_checked_catalog_data(rooms_json, data));
  if (std::vector<Error> errors = check_catalog_data(data); !errors.empty()) return Failure(combined(std::move(errors)));
  inherit_from_kinds(data);
  return Catalog(std::move(data.entries), std::move(data.rooms));
}

Catalog::Catalog(std::vector<CatalogEntry> entries, std::vector<RoomKind> rooms, bool only_articles)
    : entries_(std::move(entries)), rooms_(std::move(rooms)), only_articles_(only_articles), index_(index_of(entries_, rooms_)) {
  has_articles_ = std::ranges::any_of(entries_, [](const CatalogEntry& entry) { return !entry.article.empty(); });
}

const CatalogEntry* Catalog::find(std::string_view id) const {
  const auto found = find_key(index_.ids, id);
  return found ? &entries_[*found] : nullptr;
}

// By the words, or by the longest ending of them that is known; that ending may have another word in what is known ("crash trolley" →
// crash cart), if that is a kind of it or of what it is a kind of.
const CatalogEntry* Catalog::find_by_words(std::string_view words) const {
  const std::vector<std::string> all = words_of(words);
  const auto kind_called = [&](const std::string& modifier, std::string_view word, const CatalogEntry& head) -> const CatalogEntry* {
    const auto found = find_key(index_.words, modifier + key_of(word));
    if (!found) return nullptr;
    const CatalogEntry& entry = entries_[*found];
    return is_a(entry.id, head.id) || (!head.kind_of.empty() && is_a(entry.id, head.kind_of)) ? &entry : nullptr;
  };
  const auto with_modifier = [&](std::span<const std::string> before, const CatalogEntry& head) -> const CatalogEntry* {
    for (; !before.empty(); before = before.subspan(1)) {
      std::string modifier;
      for (const std::string& word : before) modifier += word;
      if (const CatalogEntry* entry = kind_called(modifier, head.name, head)) return entry;
      for (const std::string& synonym : head.synonyms) {
        if (const CatalogEntry* entry = kind_called(modifier, synonym, head)) return entry;
      }
    }
    return &head;
  };
  for (std::span<const std::string> rest(all); !rest.empty(); rest = rest.subspan(1)) {
    for (const std::string& key : candidate_keys(rest)) {
      if (const auto found = find_key(index_.words, key)) {
        return with_modifier(std::span(all).first(all.size() - rest.size()), entries_[*found]);
      }
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
        if (const auto found = find_key(index_.room_words, key)) return &rooms_[*found];
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
    if (entry == nullptr && step == 0) {  // what is like an entry: "wok" → pan
      id = liked_entry(id);
      continue;
    }
    if (entry == nullptr) return false;
    id = entry->kind_of;
  }
  return false;
}

const CatalogEntry& Catalog::entry_or_nearest(std::string_view category) const {
  if (const CatalogEntry* exact = find(category)) return *exact;
  if (const CatalogEntry* like = find(liked_entry(category))) return *like;
  if (const CatalogEntry* by_words = find_by_words(category)) return *by_words;
  if (const CatalogEntry* kin = kin_of(*this, category)) return *kin;
  // "workdesk" → desk: the longest known word that it ends with.
  constexpr std::size_t kShortest = 3;
  const std::vector<std::string> words = words_of(category);
  if (!words.empty()) {
    for (const std::string& form : singular_forms(words.back())) {
      for (std::size_t begin = 1; begin + kShortest <= form.size(); ++begin) {
        if (const auto found = find_key(index_.words, std::string_view(form).substr(begin))) return entries_[*found];
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

namespace {

std::vector<Space> spaces_from(const std::vector<SpaceFormula>& formulas, const Size& size) {
  // To a tenth of a millimetre, which is what layout files hold.
  const auto rounded = [](double mm) { return std::round(mm * 10) / 10; };
  std::vector<Space> spaces;
  spaces.reserve(formulas.size());
  for (const SpaceFormula& formula : formulas) {
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

}  // namespace

std::vector<Space> spaces_at(const CatalogEntry& entry, const Size& size) { return spaces_from(entry.spaces, size); }

namespace {

// The spaces of its kind, as its words name it.
std::vector<Space> usual_spaces_of(const SceneObject& object, const CatalogEntry& entry, const Size& size) {
  const bool differ = std::ranges::any_of(entry.variants, [](const SizeVariant& variant) { return !variant.spaces.empty(); });
  if (!differ) return spaces_at(entry, size);
  const std::vector<std::string> said = words_said_of(object);
  for (const SizeVariant& variant : entry.variants) {
    const bool named = std::ranges::any_of(variant.words, [&](const std::string& word) { return says(said, word); });
    if (named && !variant.spaces.empty()) return spaces_from(variant.spaces, size);
  }
  return spaces_at(entry, size);
}

}  // namespace

std::vector<Space> spaces_of(const SceneObject& object, const CatalogEntry& entry, const Size& size) {
  constexpr double kWall = 0.08, kLeg = 50;  // of a side; mm
  if (object.spaces_given) return object.spaces;
  std::vector<Space> spaces = usual_spaces_of(object, entry, {size.width, size.depth, size.height - object.raised});
  const double x = size.width / 2.0, y = size.depth / 2.0;
  if (object.hollow) {
    const double bottom = std::round(kWall * size.height);
    spaces.push_back({"inside", {-x * (1 - kWall), -y * (1 - kWall), bottom}, {x * (1 - kWall), y * (1 - kWall), size.height * 1.0}, true});
  }
  if (object.raised > 0) {
    for (Space& space : spaces) space.min[2] += object.raised, space.max[2] += object.raised;
    spaces.push_back({std::string(kSpaceUnderIt), {kLeg - x, -y, 0}, {x - kLeg, y - kLeg, object.raised * 1.0}, false});
  }
  return spaces;
}

}  // namespace layoutbox
