// Relations written into a scene, each once, and what is asked of those that are there. Who decides what to write derives from it.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/relations/relation_words.h"

namespace layoutbox::offline {

class RelationWriter {
 public:
  // REQUIRES: all outlive it; the scene's objects stand in the order of the document's items.
  RelationWriter(const Lexicon& lexicon, Document& document, SceneGraph& scene)
      : catalog_(lexicon.catalog()), document_(document), scene_(scene), words_(document.tokens) {
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) objects_.emplace(scene_.objects[i].id, i);
  }

 protected:
  const Mention& mention(int m) const { return document_.mentions[static_cast<std::size_t>(m)]; }
  const std::string& id(int item) const { return scene_.objects[static_cast<std::size_t>(item)].id; }
  const SceneObject* object_of(const std::string& object) const;
  const NounPhrase& noun_of_item(int item) const { return document_.items[static_cast<std::size_t>(item)].noun; }
  const NounPhrase& noun_of_object(const SceneObject& object) const;
  std::vector<std::string> ids(const std::vector<int>& items) const;
  std::vector<int> items_of(const std::vector<int>& mentions) const;
  // The relations that place the object, by their numbers.
  const std::vector<std::size_t>& relations_of(const std::string& object) const;

  // What says nothing is left out, and what was said before is not said again.
  void add(const Link& link, RelationType type, std::vector<std::string> targets, std::vector<std::string> references,
           const PhraseSense& sense = {});
  // One more relation of the scene, whatever was said before. Good until the next.
  Relation& write(RelationType type, std::vector<std::string> targets, std::vector<std::string> references);
  bool is_used_within(const SceneObject& object, const SceneObject& other) const;

  const Catalog& catalog_;
  Document& document_;
  SceneGraph& scene_;
  RelationWords words_;
  // Where in scene_.relations and scene_.objects they stand; keeps long texts linear.
  std::unordered_map<std::string, std::vector<std::size_t>> of_target_;
  std::unordered_map<std::string, std::size_t> objects_;

 private:
  bool repeats_known(const Link& link, RelationType type, const std::vector<std::string>& targets,
                     const std::vector<std::string>& references, const PhraseSense& sense);
  bool is_said_within(const Link& link, RelationType type, const std::vector<std::string>& targets,
                      const std::vector<std::string>& references) const;
  bool are_pillars(const std::vector<std::string>& objects) const;
  void add_two_rows(const Link& link, std::vector<std::string> targets);
  // "behind the sofa's right arm": behind it, its edge in line with that end.
  void add_at_end(const Link& link, RelationType type, const std::vector<std::string>& targets, const std::vector<std::string>& references,
                  PhraseSense sense);
  void keep_two_that_stand(std::vector<std::string>& objects) const;
  void say_lengths(const Link& link, Relation& relation) const;

  std::unordered_map<std::string, std::size_t> known_;  // where in scene_.relations they stand, by what they say
};

}  // namespace layoutbox::offline
