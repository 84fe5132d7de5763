#include "layoutbox/plan/spoken.h"

#include <algorithm>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/size_words.h"

namespace layoutbox {
namespace {

std::string head_of(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  return words.empty() ? std::string{} : key_of(singular_of(words.back()));
}

}  // namespace

Spoken::Spoken(const SceneGraph& scene, std::vector<std::string> excluded, const Catalog& catalog)
    : catalog_(&catalog), excluded_(std::move(excluded)), said_(words_of(scene.prompt)) {
  for (const SceneObject& object : scene.objects) {
    const bool named = object.origin == Origin::kAsked || object.origin == Origin::kConcluded;
    if (named) named_.insert({object.category, head_of(object.name), object.origin == Origin::kAsked});
  }
}

bool Spoken::excludes(const CatalogEntry& kind) const {
  const std::string head = head_of(kind.name);
  return std::ranges::any_of(excluded_, [&](const std::string& id) {
    const CatalogEntry* entry = catalog_->find(id);
    return akin(id, kind.id) || (entry != nullptr && head_of(entry->name) == head);
  });
}

bool Spoken::of(const CatalogEntry& kind) const {
  const auto is_more_general = [&](const auto& thing) { return catalog_->is_a(kind.id, thing.category); };
  return of_just(kind) || std::ranges::any_of(named_, is_more_general);
}

bool Spoken::of_just(const CatalogEntry& kind) const {
  const std::string head = head_of(kind.name);
  const auto names = [&](const auto& thing) { return catalog_->is_a(thing.category, kind.id) || thing.head == head; };
  return std::ranges::any_of(named_, names) || excludes(kind);
}

bool Spoken::names(const CatalogEntry& kind) const {
  return excludes(kind) ||
         std::ranges::any_of(named_, [&](const auto& thing) { return thing.asked && catalog_->is_a(thing.category, kind.id); });
}

int Spoken::kinds_asked() const {
  std::set<std::string_view> kinds;
  for (const Named& thing : named_) {
    if (thing.asked) kinds.insert(thing.category);
  }
  return static_cast<int>(kinds.size());
}

bool Spoken::says_enough_for(const Dressing& habit) const {
  return habit.few > 0 && kinds_asked() > habit.few && !says_any(Dressings::builtin().dressed);
}

bool Spoken::keeps_off(const std::string& kind, const std::string& place, const std::string& room) const {
  const auto has = [](const std::vector<std::string>& list, const std::string& one) { return std::ranges::find(list, one) != list.end(); };
  return std::ranges::any_of(Dressings::builtin().themes, [&](const DressingTheme& theme) {
    return (has(theme.without, kind) || has(theme.places, place)) && (says_any(theme.said) || has(theme.rooms, room));
  });
}

bool Spoken::says_any(const std::vector<std::string>& phrases) const {
  return std::ranges::any_of(phrases, [&](const std::string& phrase) { return says(said_, phrase); });
}

bool Spoken::wants_no_more(const Groups& groups) const {
  return says_any(groups.none) || (says_any(groups.empty) && !says_any(groups.to_furnish));
}

}  // namespace layoutbox
