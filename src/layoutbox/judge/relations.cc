// What a scene or a layout itself asks for, by the relations of docs/relations.md.
#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/judge/entries.h"
#include "layoutbox/judge/vocabulary.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::scoring {
namespace {

bool names_object(const Layout& layout, const Relation& relation) {
  return std::any_of(relation.references.begin(), relation.references.end(),
                     [&](const std::string& id) { return layout.find_object(id) != nullptr; });
}

// Scene id → layout id: the same id with a fitting kind, else the best of the same kind that is not taken.
std::map<std::string, std::string> pair_objects(const SceneGraph& scene, const Layout& layout, const Catalog& catalog) {
  NounMatcher matcher(catalog);
  const auto fit = [&](const SceneObject& wanted, const PlacedObject& have) {
    int best = 0;
    for (const std::string* a : {&wanted.category, &wanted.name}) {
      for (const std::string* b : {&have.category, &have.name}) {
        if (!a->empty() && !b->empty()) best = std::max(best, matcher.strength(*a, *b));
      }
    }
    return best;
  };
  std::map<std::string, std::string> pairs;
  std::set<std::string> taken;
  for (const SceneObject& wanted : scene.objects) {
    if (const PlacedObject* same = layout.find_object(wanted.id); same != nullptr && fit(wanted, *same) > 0) {
      pairs[wanted.id] = same->id;
      taken.insert(same->id);
    }
  }
  for (int least = 4; least >= 1; --least) {
    for (const SceneObject& wanted : scene.objects) {
      if (pairs.contains(wanted.id)) continue;
      for (const PlacedObject& have : layout.objects) {
        if (taken.contains(have.id) || fit(wanted, have) < least) continue;
        pairs[wanted.id] = have.id;
        taken.insert(have.id);
        break;
      }
    }
  }
  return pairs;
}

void rename(Relation& relation, const std::map<std::string, std::string>& pairs) {
  for (std::vector<std::string>* list : {&relation.targets, &relation.references}) {
    for (std::string& id : *list) {
      if (const auto found = pairs.find(id); found != pairs.end()) id = found->second;
    }
  }
}

std::vector<Verdict> judge_relations(Layout layout, const Catalog& catalog) {
  layout.relaxed.clear();
  layout.gave_way.clear();
  const Report report = verify(layout, catalog);
  std::vector<Verdict> verdicts;
  auto check = std::find_if(report.checks.begin(), report.checks.end(), [](const Check& c) { return c.name == "relation"; });
  for (const PlacedRelation& placed : layout.relations) {
    const EntryKind kind =
        names_object(layout, placed.relation) || placed.relation.references.empty() ? EntryKind::kObjects : EntryKind::kRoom;
    // What the layout claims of it is no matter here.
    const std::string why = check->message.substr(0, check->message.find(" (the layout says"));
    verdicts.push_back({kind, fmt::format("{} {}", placed.relation.id, relation_row(placed.relation.type).name), check->passed, why});
    ++check;
  }
  return verdicts;
}

}  // namespace

std::vector<Verdict> judge_own_relations(const Layout& layout, const Catalog& catalog) {
  Layout asked = layout;
  std::erase_if(asked.relations, [](const PlacedRelation& placed) { return !placed.relation.hard || !placed.relation.asked(); });
  return judge_relations(std::move(asked), catalog);
}

std::vector<Verdict> judge_scene(const SceneGraph& scene, const Layout& layout, const Catalog& catalog) {
  const std::map<std::string, std::string> pairs = pair_objects(scene, layout, catalog);
  std::vector<Verdict> verdicts;
  std::map<std::string, std::vector<const SceneObject*>> kinds;
  for (const SceneObject& object : scene.objects) {
    if (object.asked()) kinds[object.category].push_back(&object);
  }
  for (const auto& [category, objects] : kinds) {
    const auto there = std::count_if(objects.begin(), objects.end(), [&](const SceneObject* object) { return pairs.contains(object->id); });
    verdicts.push_back({EntryKind::kCount, fmt::format("{} {}", objects.size(), category),
                        there == static_cast<std::ptrdiff_t>(objects.size()), fmt::format("found {}", there)});
  }
  Layout asked = layout;
  asked.relations.clear();
  for (Relation relation : scene.relations) {
    if (!relation.hard || !relation.asked()) continue;
    rename(relation, pairs);
    asked.relations.push_back({std::move(relation), true});
  }
  for (Verdict& verdict : judge_relations(std::move(asked), catalog)) verdicts.push_back(std::move(verdict));
  return verdicts;
}

}  // namespace layoutbox::scoring
