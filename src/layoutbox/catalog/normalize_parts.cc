// Parts of things that relations name and nothing has.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/parts.h"

namespace layoutbox {

std::set<std::string, std::less<>> space_names(const CatalogEntry& entry) {
  std::set<std::string, std::less<>> names;
  for (const SpaceFormula& space : entry.spaces) names.insert(space.name);
  for (const SizeVariant& variant : entry.variants) {
    for (const SpaceFormula& space : variant.spaces) names.insert(space.name);
  }
  return names;
}

bool is_part(RelationType type, const ThingPart& part, const std::set<std::string, std::less<>>& spaces) {
  if (part.empty() || spaces.contains(part.text())) return true;
  return part.is_words() && (type != RelationType::kIn || !part.has(PartWord::kTop));
}

void check_parts(NormalizeContext& context) {
  for (std::size_t i = 0; i < context.scene.relations.size(); ++i) {
    const Relation& relation = context.scene.relations[i];
    if (relation.parameters.part.empty() || !relation_row(relation.type).reads("part")) continue;
    for (const std::string& reference : relation.references) {
      const SceneObject* host = context.scene.find_object(reference);
      if (host == nullptr || !host->size) continue;
      const CatalogEntry& entry = context.catalog.entry_or_nearest(host->category);
      std::set<std::string, std::less<>> spaces = host->spaces_given ? std::set<std::string, std::less<>>{} : space_names(entry);
      for (const Space& space : spaces_of(*host, entry, host->size->usual)) spaces.insert(space.name);
      if (is_part(relation.type, relation.parameters.part, spaces)) continue;
      std::string hint = fmt::format("give some of: {}", fmt::join(part_words(), ", "));
      if (!spaces.empty()) hint += fmt::format("; or one of its spaces: {}", fmt::join(spaces, ", "));
      context.error(ErrorCode::kSchema,
                    fmt::format("{} names the part \"{}\", which {} does not have", relation_row(relation.type).name,
                                relation.parameters.part.text(), reference),
                    fmt::format("/constraints/{}/part", i), std::move(hint));
    }
  }
}

}  // namespace layoutbox
