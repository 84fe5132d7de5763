// Whether a room is as an annotation or a scene asks: a verdict for each entry.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "layoutbox/judge/annotation.h"
#include "layoutbox/judge/predicates.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::scoring {

struct Verdict {
  EntryKind kind = EntryKind::kCount;
  std::string entry;  // as it was asked: "eq,2,nightstand", or a relation's id and type
  bool holds = false;
  std::string why;  // what was found and measured
};

// Category → places in the layout's objects. Each object goes to at most one category: the narrowest that fits best.
using Matches = std::map<std::string, std::vector<std::size_t>>;
Matches match_objects(const std::vector<std::string>& categories, const Layout& layout, const Catalog& catalog);

std::vector<Verdict> judge_annotation(const Annotation& annotation, const MeasuredRoom& room);

// The relations of a scene, by verify's own checks; objects go to those with the same id, else of the same kind. Counts are of kinds.
// Only what was asked for is judged.
std::vector<Verdict> judge_scene(const SceneGraph& scene, const Layout& layout, const Catalog& catalog);
// What the layout itself says was asked for.
std::vector<Verdict> judge_own_relations(const Layout& layout, const Catalog& catalog);

}  // namespace layoutbox::scoring
