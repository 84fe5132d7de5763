#include "reading_measure.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

namespace layoutbox::reading {

namespace {

using R = RelationType;

std::string spaced(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return c == '_' || c == '-' ? ' ' : std::tolower(c); });
  return text;
}

bool ends(const std::string& text, const std::string& word) { return text == word || text.ends_with(" " + word); }

// Whether the thing is what the word calls it: by its name or its category, or a kind of it.
bool is_called(const Catalog& catalog, const SceneObject& object, const std::string& word) {
  for (const std::string& own : {spaced(object.name), spaced(object.category)}) {
    if (ends(own, word) || ends(word, own)) return true;
  }
  const CatalogEntry* entry = catalog.find_by_words(word);
  return entry != nullptr && (entry->id == object.category || catalog.is_a(object.category, entry->id));
}

class Judge {
 public:
  Judge(const Catalog& catalog, const SceneGraph& scene) : catalog_(catalog), scene_(scene) {}

  bool met(const Wanted& wanted) const {
    std::set<std::string> placed, references;
    for (const Relation& relation : scene_.relations) {
      if (std::find(wanted.any.begin(), wanted.any.end(), relation.type) == wanted.any.end()) continue;
      for (const std::string& target : relation.targets) {
        if (says(wanted, relation, target, wanted.subject, wanted.object)) {
          placed.insert(target);
          references.insert(relation.references.begin(), relation.references.end());
        }
        if (wanted.both && says(wanted, relation, target, wanted.object, wanted.subject)) return true;
      }
    }
    const std::size_t least = static_cast<std::size_t>(std::max(1, wanted.count));
    return placed.size() >= least || references.size() >= least;
  }

  bool speaks_of(const Wanted& wanted, const Relation& relation, const std::string& target) const {
    if (std::find(wanted.any.begin(), wanted.any.end(), relation.type) == wanted.any.end()) return false;
    return says(wanted, relation, target, wanted.subject, wanted.object) ||
           (wanted.both && says(wanted, relation, target, wanted.object, wanted.subject));
  }

 private:
  bool named(const std::string& id, const std::string& word) const {
    if (id == word || ((word == "window" || word == "door") && id.starts_with(word))) return true;
    const SceneObject* object = scene_.find_object(id);
    return object != nullptr && is_called(catalog_, *object, word);
  }

  bool says(const Wanted& wanted, const Relation& relation, const std::string& target, const std::string& subject,
            const std::string& object) const {
    if (!named(target, subject)) return false;
    if (object.empty() || relation.type == R::kUnderWindow || relation.type == R::kInRegion) return true;
    const bool all =
        std::any_of(relation.references.begin(), relation.references.end(), [&](const std::string& r) { return named(r, object); });
    if (all || (relation.type != R::kOn && relation.type != R::kIn) || !(wanted.any.front() == R::kOn || wanted.any.front() == R::kIn))
      return all;
    // What stands on a tray on the table is on the table.
    return std::any_of(relation.references.begin(), relation.references.end(),
                       [&](const std::string& r) { return rests_on(r, object, 3); });
  }

  bool rests_on(const std::string& id, const std::string& word, int depth) const {
    for (const Relation& relation : scene_.relations) {
      if ((relation.type != R::kOn && relation.type != R::kIn) || relation.targets.front() != id) continue;
      for (const std::string& r : relation.references) {
        if (named(r, word) || (depth > 0 && rests_on(r, word, depth - 1))) return true;
      }
    }
    return false;
  }

  const Catalog& catalog_;
  const SceneGraph& scene_;
};

// How a group stands in itself, or how a thing is held: neither right nor wrong here.
bool is_aside(R type) {
  return type == R::kRow || type == R::kGrid || type == R::kColumn || type == R::kSameOrientation || type == R::kOnWall ||
         type == R::kOnCeiling || type == R::kPairedWith || type == R::kParallel || type == R::kEvenlySpaced || type == R::kFacing ||
         type == R::kDistance || type == R::kAlign;
}

}  // namespace

std::vector<Description> read_descriptions(const std::string& path) {
  std::vector<Description> all;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (json.is_discarded()) continue;
    Description& description = all.emplace_back();
    description.id = json.value("id", "");
    description.prompt = json.value("prompt", "");
    description.exact = json.value("exact", false);
    for (const auto& entry : json["wanted"]) {
      Wanted& wanted = description.wanted.emplace_back();
      for (const std::string name : entry["any"]) {
        if (const RelationRow* row = find_relation(name); row != nullptr) wanted.any.push_back(row->type);
      }
      wanted.subject = spaced(entry["subject"]);
      wanted.object = spaced(entry["object"]);
      wanted.count = entry["count"];
      wanted.both = entry["both"];
    }
  }
  return all;
}

void measure(const Catalog& catalog, const Description& description, const SceneGraph& scene, Tally& tally,
             std::vector<std::string>* misses) {
  const Judge judge(catalog, scene);
  for (const Wanted& wanted : description.wanted) {
    if (wanted.any.empty()) continue;
    const bool met = judge.met(wanted);
    tally.wanted += 1;
    tally.found += met ? 1 : 0;
    if (!met && misses != nullptr)
      misses->push_back("lacks " + wanted.subject + " " + std::string(relation_row(wanted.any.front()).name) + " " + wanted.object);
  }
  if (!description.exact) return;
  for (const Relation& relation : scene.relations) {
    if (!relation.asked() || is_aside(relation.type)) continue;
    for (const std::string& target : relation.targets) {
      const bool right = std::any_of(description.wanted.begin(), description.wanted.end(),
                                     [&](const Wanted& wanted) { return judge.speaks_of(wanted, relation, target); });
      tally.made += 1;
      tally.wrong += right ? 0 : 1;
      if (!right && misses != nullptr)
        misses->push_back("wrong " + target + " " + std::string(relation_row(relation.type).name) + " " +
                          (relation.references.empty() ? "" : relation.references.front()));
    }
  }
}

}  // namespace layoutbox::reading
