// What things become: red, larger, turned, at another place.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"

namespace layoutbox::edit {

using namespace offline;

// What an attribute says: a color, a material …
std::string_view EditReader::class_of(std::span<const Token> tokens, std::size_t at) const {
  while (at + 1 < tokens.size() &&
         (tokens[at].text == "dark" || tokens[at].text == "light" || tokens[at].text == "pale" || tokens[at].text == "bright"))
    ++at;
  const Match match = lexicon_.find(tokens, at);
  for (const Meaning& meaning : match.meanings) {
    switch (meaning.word_class) {
      case WordClass::kColor: return "color";
      case WordClass::kMaterial: return "material";
      case WordClass::kShape: return "shape";
      case WordClass::kStyle: return "style";
      case WordClass::kSizeWord: return "size";
      default: break;
    }
  }
  return "";
}

// "… red and next to the bed": what things become, up to the next thing that is spoken of.
Status EditReader::read_predicates(Clause& clause, const std::vector<int>& things, const std::vector<std::string>& surfaces, bool& any) {
  std::vector<std::string> attributes, classes;
  while (more(clause)) {
    skip(clause, {ChunkKind::kIgnored, ChunkKind::kAnd, ChunkKind::kComma, ChunkKind::kVerb, ChunkKind::kParticiple, ChunkKind::kSoft});
    skip(clause, {ChunkKind::kStop, ChunkKind::kAnd, ChunkKind::kComma, ChunkKind::kIgnored});
    if (!more(clause) || noun_next(clause)) break;
    const Chunk chunk = *peek(clause);
    if (chunk.kind == ChunkKind::kAttribute) {
      std::string words = words_of(clause, chunk);
      if (chunk.first > 0) {  // "dark green"
        const std::string& before = clause.document.tokens[chunk.first - 1].text;
        if (before == "dark" || before == "light" || before == "pale" || before == "bright") words = before + " " + words;
      }
      attributes.push_back(words);
      classes.emplace_back(class_of(clause.document.tokens, chunk.first));
      ++clause.k;
      continue;
    }
    if (things.empty()) break;
    bool placed = false;
    LAYOUTBOX_CHECK(read_places(clause, things, placed));
    if (!placed) break;
    any = true;
  }
  if (attributes.empty()) return {};
  EditStep& step = begin(EditKind::kRecolor, clause, things);
  if (!surfaces.empty()) step.targets = surfaces;
  step.attributes = std::move(attributes);
  step.attribute_class = std::move(classes);
  // "Make the blue bed green": it is blue no longer.
  for (const int i : things) {
    for (const std::string& old : world_.thing(i).attributes) {
      const std::string_view old_class = class_of(tokenize(old), 0);
      const auto& now = step.attribute_class;
      const auto& kept = step.attributes;
      if (!old_class.empty() && std::find(now.begin(), now.end(), old_class) != now.end() &&
          std::find(kept.begin(), kept.end(), old) == kept.end())
        step.dropped_attributes.push_back(old);
    }
  }
  any = true;
  return {};
}

bool EditReader::is_surface(Verb verb, const NounPhrase& noun) {
  return noun.kind == NounKind::kWall || noun.kind == NounKind::kFloor || noun.kind == NounKind::kCeiling ||
         (noun.kind == NounKind::kRoom && verb == Verb::kRecolor);  // "paint the room yellow"
}

// "the walls", "the floor", "the back wall": what is painted.
Result<std::string> EditReader::surface_of(const Clause& clause, const NounPhrase& noun) const {
  if (noun.kind == NounKind::kFloor) return std::string(kEditFloor);
  if (noun.kind == NounKind::kCeiling) return std::string(kEditCeiling);
  if (noun.kind == NounKind::kRoom || noun.wall_word.empty()) return std::string(kEditWalls);
  const Wall* wall = world_.layout().find_wall(noun.wall_word);
  if (wall == nullptr) return not_understood(clause, words_between(clause.document, noun.first, noun.last));
  return wall->id;
}

Status EditReader::read_make(Clause& clause, const std::optional<EditResize>& resize, std::optional<double> degrees,
                             const std::optional<ShiftAt>& shift) {
  // "change the armchair into a bean bag"
  for (std::size_t k = 0; k + 1 < clause.document.chunks.size() && clause.verb != Verb::kNone; ++k) {
    const std::string words = words_of(clause, clause.document.chunks[k]);
    const Chunk& next = clause.document.chunks[k + 1];
    const bool named = next.noun.kind == NounKind::kObject || (next.noun.kind == NounKind::kMember && !next.noun.attributes.empty());
    const bool new_thing = next.kind == ChunkKind::kNoun && named &&
                           (next.noun.determiner == Determiner::kIndefinite || next.noun.determiner == Determiner::kNone);
    if (k > 0 && new_thing && (words == "into" || words == "to")) return read_replace(clause, false);
  }
  bool first = true;
  while (first || noun_next(clause)) {
    skip(clause, {ChunkKind::kIgnored, ChunkKind::kThere});
    std::vector<int> things;
    std::vector<std::string> surfaces;
    while (noun_next(clause) && is_surface(clause.verb, peek(clause)->noun)) {
      LAYOUTBOX_ASSIGN(std::string surface, surface_of(clause, peek(clause)->noun));
      surfaces.push_back(std::move(surface));
      ++clause.k;
      skip(clause, {ChunkKind::kAnd, ChunkKind::kComma});
    }
    if (surfaces.empty()) {
      LAYOUTBOX_ASSIGN(things, read_things(clause, true));
    }
    bool any = false;
    if (first && resize && !things.empty()) begin(EditKind::kResize, clause, things).resize = *resize, any = true;
    if (first && degrees && !things.empty()) begin(EditKind::kTurn, clause, things).degrees = *degrees, any = true;
    if (first && shift && !things.empty() && shift->shift.way != EditShift::Way::kTowards && shift->shift.way != EditShift::Way::kAway) {
      begin(EditKind::kShift, clause, things).shift = shift->shift, any = true;
    }
    LAYOUTBOX_CHECK(read_predicates(clause, things, surfaces, any));
    if (!any) return not_understood(clause);
    first = false;
  }
  return rest_understood(clause);
}

}  // namespace layoutbox::edit
