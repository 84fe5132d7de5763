// What comes in, and what of it at once.
#include <algorithm>
#include <numeric>
#include <utility>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"

namespace layoutbox::edit {

using namespace offline;

namespace {

// Which of the new things come in together: those that are placed by each other, those that were named as several, and a list of which
// nothing is said. Of each the first one of its cluster.
class Together {
 public:
  explicit Together(std::vector<std::string> ids) : ids_(std::move(ids)), cluster_(ids_.size()), placed_(ids_.size(), false) {
    std::iota(cluster_.begin(), cluster_.end(), 0);
  }

  // The new ones of a relation.
  std::vector<std::size_t> new_of(const Relation& relation) const {
    std::vector<std::size_t> found;
    for (const auto* ids : {&relation.targets, &relation.references}) {
      for (const std::string& id : *ids) {
        const auto at = std::find(ids_.begin(), ids_.end(), id);
        if (at != ids_.end()) found.push_back(static_cast<std::size_t>(at - ids_.begin()));
      }
    }
    return found;
  }
  void place(const Relation& relation) {
    const std::vector<std::size_t> together = new_of(relation);
    for (const std::size_t i : together) {
      placed_[i] = true;
      join(i, together.front());
    }
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t from = std::max(cluster_[a], cluster_[b]), into = std::min(cluster_[a], cluster_[b]);
    std::replace(cluster_.begin(), cluster_.end(), from, into);
  }
  bool is_placed(std::size_t i) const { return placed_[i]; }
  std::size_t cluster(std::size_t i) const { return cluster_[i]; }
  std::size_t size() const { return ids_.size(); }

 private:
  std::vector<std::string> ids_;
  std::vector<std::size_t> cluster_;
  std::vector<bool> placed_;
};

}  // namespace

Status EditReader::bring_in_items(Clause& clause) {
  const Document& document = clause.document;
  const std::size_t first = world_.things().size(), all = document.items.size();
  constexpr std::size_t kMost = 50;
  if (all == first || all - first > kMost) return not_understood(clause);
  std::vector<int> fresh;
  for (std::size_t i = first; i < all; ++i) {
    EditStep unused;
    fresh.push_back(bring_in(document.items[i].noun, unused));
  }
  LAYOUTBOX_ASSIGN(const std::vector<Relation> relations, build(clause));
  Together together(ids(fresh));
  for (const Relation& relation : relations) {
    if (relation.origin != Origin::kAssumed) together.place(relation);
  }
  for (std::size_t i = 1; i < together.size(); ++i) {
    const bool same = document.items[first + i].group == document.items[first + i - 1].group;
    if (same || (!together.is_placed(i) && !together.is_placed(i - 1))) together.join(i, i - 1);
  }
  for (std::size_t c = 0; c < together.size(); ++c) {
    if (together.cluster(c) != c) continue;
    EditStep& step = begin(EditKind::kAdd, clause);
    for (std::size_t i = c; i < together.size(); ++i) {
      if (together.cluster(i) == c) step.objects.push_back(added_.at(world_.thing(fresh[i]).id));
    }
    for (const Relation& relation : relations) {
      const std::vector<std::size_t> of = together.new_of(relation);
      if (!of.empty() && together.cluster(of.front()) == c) step.relations.push_back(relation);
    }
  }
  const auto of_old = [&](const Relation& r) { return r.origin != Origin::kAssumed && together.new_of(r).empty(); };
  if (std::any_of(relations.begin(), relations.end(), of_old))
    plan_.notes.push_back({"info", "\"" + clause.why + "\": what is there already stays where it is", "text"});
  remember(fresh);
  return {};
}

SceneObject EditReader::new_object(const NounPhrase& noun) const {
  SceneObject object;
  object.category = noun.category;
  object.name = noun.name;
  object.attributes = noun.attributes;
  object.id = world_.new_id(noun.category);
  if (noun.size.any() && noun.entry != nullptr) {
    SizeRange range = noun.entry->size;
    const auto fix = [&range](Mm Size::*side, double metres) {
      range.least.*side = range.usual.*side = range.greatest.*side = mm_from_m(metres);
    };
    const bool deep = range.usual.depth > range.usual.width;
    if (noun.size.length) fix(deep ? &Size::depth : &Size::width, *noun.size.length);
    if (noun.size.width) fix(&Size::width, *noun.size.width);
    if (noun.size.depth) fix(&Size::depth, *noun.size.depth);
    if (noun.size.height) fix(&Size::height, *noun.size.height);
    object.size = range;
    object.size_source = SizeSource::kUser;
  }
  return object;
}

int EditReader::bring_in(const NounPhrase& noun, EditStep& step) {
  SceneObject object = new_object(noun);
  const int index = world_.add(object.id, noun, object.attributes);
  added_[object.id] = object;
  step.objects.push_back(std::move(object));
  return index;
}

}  // namespace layoutbox::edit
