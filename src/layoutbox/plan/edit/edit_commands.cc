// One function a command: add, place, remove, move, swap, replace, turn, change, rename, keep.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/relation_builder.h"

namespace layoutbox::edit {

using namespace offline;

Status EditReader::read_add(Clause& clause) {
  take_word(clause, {"back"});
  skip(clause, {ChunkKind::kIgnored});
  bool first = true;
  while (more(clause)) {
    if (!noun_next(clause)) return first ? Status(not_understood(clause)) : rest_understood(clause);
    EditStep step;
    step.kind = EditKind::kAdd;
    step.why = clause.why;
    std::vector<int> targets;
    while (noun_next(clause)) {
      NounPhrase noun = peek(clause)->noun;
      const Chunk* after = peek(clause, 1);
      if (noun.kind != NounKind::kObject) return not_understood(clause, words_between(clause.document, noun.first, noun.last));
      ++clause.k;
      if (more(clause) && peek(clause)->kind == ChunkKind::kSize) {
        const SaidSize& said = peek(clause)->size;
        if (said.width) noun.size.width = said.width;
        if (said.depth) noun.size.depth = said.depth;
        if (said.height) noun.size.height = said.height;
        if (said.length) noun.size.length = said.length;
        ++clause.k;
      }
      const int count = noun.count > 0 ? noun.count : noun.plural ? 2 : 1;
      if (count > 50) return not_understood(clause, words_between(clause.document, noun.first, noun.last));
      for (int i = 0; i < count; ++i) targets.push_back(bring_in(clause, noun, step));
      if (after == nullptr || (after->kind != ChunkKind::kAnd && after->kind != ChunkKind::kComma)) break;
      const std::size_t here = clause.k;
      skip(clause, {ChunkKind::kComma, ChunkKind::kAnd, ChunkKind::kIgnored});
      if (!noun_next(clause)) {
        clause.k = here;
        break;
      }
    }
    bool any = false;
    clause.document.links.clear();
    clause.targets = targets;
    LAYOUTBOX_CHECK(read_links(clause, targets, step, any));
    LAYOUTBOX_CHECK(build(clause, step));
    remember(targets);
    plan_.steps.push_back(std::move(step));
    first = false;
    skip(clause, {ChunkKind::kComma, ChunkKind::kAnd, ChunkKind::kIgnored});
  }
  return first ? Status(not_understood(clause)) : Status{};
}

// "Put the lamp on the desk": the lamp that is there, or else a new one.
Status EditReader::read_place(Clause& clause) {
  skip(clause, {ChunkKind::kIgnored});
  if (!noun_next(clause)) return not_understood(clause);
  const NounPhrase& noun = peek(clause)->noun;
  const bool definite = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive ||
                        noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach ||
                        noun.determiner == Determiner::kOther;
  const bool there = noun.kind != NounKind::kObject || is_everything(noun) || (definite && !world_.of_kind(noun).empty());
  if (there) return read_move(clause, std::nullopt);
  if (definite) plan_.notes.push_back({"warning", "there was no " + noun.name + ": one comes in", "text"});
  return read_add(clause);
}

Status EditReader::read_remove(Clause& clause) {
  LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, false));
  take_word(clause, {"out", "away"});
  LAYOUTBOX_CHECK(rest_understood(clause));
  begin(EditKind::kRemove, clause, things);
  for (const int i : things) world_.things()[static_cast<std::size_t>(i)].gone = true;
  return {};
}

// "closer to the window": what it goes towards or away from. "The wall" is the one that it is at.
Result<EditShift> EditReader::read_shift_reference(Clause& clause, EditShift way, const Wall* at_wall) {
  if (way.way != EditShift::Way::kTowards && way.way != EditShift::Way::kAway) return way;
  if (!noun_next(clause)) return not_understood(clause);
  const Chunk chunk = *peek(clause);
  ++clause.k;
  LAYOUTBOX_ASSIGN(const Found found, find_reference(clause, chunk));
  if (!found.things.empty()) {
    way.reference = world_.thing(found.things.front()).id;
  } else if (const auto openings = world_.openings_of(chunk.noun);
             !openings.empty() && (chunk.noun.kind == NounKind::kWindow || chunk.noun.kind == NounKind::kDoor)) {
    way.reference = openings.front()->id;
  } else if (chunk.noun.kind == NounKind::kWall) {
    const Wall* wall = chunk.noun.wall_word.empty() ? at_wall : world_.layout().find_wall(chunk.noun.wall_word);
    if (wall != nullptr) way.reference = wall->id;
  }
  if (way.reference.empty()) return not_understood(clause, words_between(clause.document, chunk.first, chunk.last));
  return way;
}

Status EditReader::read_move(Clause& clause, const std::optional<ShiftAt>& shift) {
  if (shift) {
    LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, false));
    LAYOUTBOX_ASSIGN(const EditShift way, read_shift_reference(clause, shift->shift, world_.wall_of(things.front())));
    LAYOUTBOX_CHECK(rest_understood(clause));
    begin(EditKind::kShift, clause, things).shift = way;
    return {};
  }
  bool first = true;
  while (more(clause)) {
    if (!first && !noun_next(clause)) break;
    LAYOUTBOX_ASSIGN(std::vector<int> things, read_things(clause, true));
    EditStep step;
    step.kind = EditKind::kMove;
    step.why = clause.why;
    step.targets = ids(things);
    bool any = false;
    clause.document.links.clear();
    LAYOUTBOX_CHECK(read_links(clause, things, step, any));
    if (!any && clause.word == "center") {  // "center the rug"
      Link link;
      link.senses = {{RelationType::kCenterOfRoom, PhraseSense::Direction::kAlone, {}, {}, {}}};
      link.targets = {mention_of(clause, things, false)};
      clause.document.links.push_back(std::move(link));
      any = true;
    }
    if (!any) return not_understood(clause);
    LAYOUTBOX_CHECK(build(clause, step));
    if (step.relations.empty()) return not_understood(clause);
    if (only_turns(step)) step.kind = EditKind::kTurn;
    plan_.steps.push_back(std::move(step));
    first = false;
    skip(clause, {ChunkKind::kComma, ChunkKind::kAnd, ChunkKind::kIgnored});
  }
  return first ? Status(not_understood(clause)) : rest_understood(clause);
}

Status EditReader::read_swap(Clause& clause) {
  // "swap the armchair for a bean bag" replaces.
  for (std::size_t i = 0; i + 1 < clause.document.tokens.size(); ++i) {
    if (clause.document.tokens[i].text == "for") return read_replace(clause, false);
  }
  LAYOUTBOX_ASSIGN(std::vector<int> things, read_things(clause, false));
  if (things.size() == 1) {
    if (!take_word(clause, {"with", "against", "and"})) return not_understood(clause);
    LAYOUTBOX_ASSIGN(const std::vector<int> others, read_things(clause, false));
    things.insert(things.end(), others.begin(), others.end());
  }
  LAYOUTBOX_CHECK(rest_understood(clause));
  if (things.size() != 2 || things[0] == things[1]) {
    return fail(ErrorCode::kParse, "two things are swapped, and \"" + clause.why + "\" names " + std::to_string(things.size()), "text",
                "say for example: swap the bed and the desk");
  }
  remember(things);
  begin(EditKind::kSwap, clause, things);
  return {};
}

// "replace A with B", "use B instead of A".
Status EditReader::read_replace(Clause& clause, bool new_first) {
  std::vector<int> things;
  if (!new_first) {
    LAYOUTBOX_ASSIGN(things, read_things(clause, false));
    while (more(clause) && !noun_next(clause)) ++clause.k;  // with, by, for, into
  }
  skip(clause, {ChunkKind::kIgnored});
  if (!noun_next(clause)) return not_understood(clause);
  NounPhrase noun = peek(clause)->noun;
  if (noun.kind == NounKind::kMember && !things.empty()) {  // "a round glass one": the same kind of thing
    NounPhrase kind = world_.thing(things.front()).noun;
    kind.attributes = noun.attributes, kind.attribute_classes = noun.attribute_classes;
    kind.determiner = noun.determiner, kind.count = noun.count, kind.plural = noun.plural;
    kind.first = noun.first, kind.last = noun.last;
    noun = std::move(kind);
  }
  if (noun.kind != NounKind::kObject) return not_understood(clause);
  ++clause.k;
  if (new_first) {
    while (more(clause) && !noun_next(clause)) ++clause.k;  // for, instead of
    LAYOUTBOX_ASSIGN(things, read_things(clause, false));
  }
  LAYOUTBOX_CHECK(rest_understood(clause));
  EditStep step;
  step.kind = EditKind::kReplace;
  step.why = clause.why;
  step.targets = ids(things);
  std::vector<int> fresh;
  const std::size_t wanted = noun.count > 0 ? static_cast<std::size_t>(noun.count) : noun.plural ? things.size() : 1;
  if (wanted > 50) return not_understood(clause);
  // One for each, where a plural or "a" stands for each of several.
  const std::size_t count = noun.count == 0 && noun.determiner != Determiner::kIndefinite ? things.size() : wanted;
  for (std::size_t i = 0; i < count; ++i) fresh.push_back(bring_in(clause, noun, step));
  for (const int i : things) world_.things()[static_cast<std::size_t>(i)].gone = true;
  remember(fresh);
  plan_.steps.push_back(std::move(step));
  return {};
}

Status EditReader::read_turn(Clause& clause, std::optional<double> degrees) {
  // "turn the armchair into a bean bag"
  for (const Token& token : clause.document.tokens) {
    if (token.text == "into") return read_replace(clause, false);
  }
  LAYOUTBOX_ASSIGN(std::vector<int> things, read_things(clause, false));
  if (degrees) {
    LAYOUTBOX_CHECK(rest_understood(clause));
    begin(EditKind::kTurn, clause, things).degrees = *degrees;
    return {};
  }
  return not_understood(clause);
}

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
    EditStep step;
    step.kind = EditKind::kMove;
    step.why = clause.why;
    step.targets = ids(things);
    bool placed = false;
    clause.document.links.clear();
    std::vector<int> targets = things;
    LAYOUTBOX_CHECK(read_links(clause, targets, step, placed));
    if (!placed) break;
    LAYOUTBOX_CHECK(build(clause, step));
    if (step.relations.empty()) return not_understood(clause);
    if (only_turns(step)) step.kind = EditKind::kTurn;
    plan_.steps.push_back(std::move(step));
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

Status EditReader::read_make(Clause& clause, const std::optional<EditResize>& resize, std::optional<double> degrees,
                             const std::optional<ShiftAt>& shift) {
  // "change the armchair into a bean bag"
  for (std::size_t k = 0; k + 1 < clause.document.chunks.size() && clause.verb != Verb::kNone; ++k) {
    const std::string words = words_of(clause, clause.document.chunks[k]);
    const Chunk& next = clause.document.chunks[k + 1];
    const bool new_thing = next.kind == ChunkKind::kNoun && next.noun.kind == NounKind::kObject &&
                           (next.noun.determiner == Determiner::kIndefinite || next.noun.determiner == Determiner::kNone);
    if (k > 0 && new_thing && (words == "into" || words == "to")) return read_replace(clause, false);
  }
  bool first = true;
  while (first || noun_next(clause)) {
    skip(clause, {ChunkKind::kIgnored, ChunkKind::kThere});
    std::vector<int> things;
    std::vector<std::string> surfaces;
    while (noun_next(clause) && (peek(clause)->noun.kind == NounKind::kWall || peek(clause)->noun.kind == NounKind::kFloor)) {
      surfaces.emplace_back(peek(clause)->noun.kind == NounKind::kWall ? "walls" : "floor");
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

Status EditReader::read_rename(Clause& clause) {
  const bool relation_follows = more(clause) && peek(clause)->kind == ChunkKind::kRelation;
  LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, !relation_follows));
  if (things.size() != 1) return not_understood(clause);
  std::size_t first = more(clause) ? peek(clause)->first : clause.document.tokens.size();
  std::string name;
  for (; first < clause.document.tokens.size(); ++first) {
    const Token& token = clause.document.tokens[first];
    const bool before = name.empty() && (token.text == "to" || token.text == "into" || token.text == "as");
    if (token.kind != Token::Kind::kPunctuation && !before) name += (name.empty() ? "" : " ") + token.text;
  }
  if (name.empty()) return not_understood(clause);
  for (const char* article : {"a ", "an ", "the "}) {
    if (name.starts_with(article)) name.erase(0, std::string_view(article).size());
  }
  begin(EditKind::kRename, clause, things).name = name;
  return {};
}

Status EditReader::read_keep(Clause& clause) {
  LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, false));
  // "keep the chair with it", "keep it next to the desk": not where it is, but by the thing.
  if (more(clause) &&
      (peek(clause)->kind == ChunkKind::kHave || (peek(clause)->kind == ChunkKind::kRelation && relations_ahead(clause) > 0 &&
                                                  peek(clause, 1) != nullptr && peek(clause, 1)->kind == ChunkKind::kNoun))) {
    plan_.notes.push_back({"info", "\"" + clause.why + "\": it stays by what it stands by, and may move with it", "text"});
    return {};
  }
  begin(EditKind::kKeep, clause, things);
  return {};  // "where it is", "as it is", "alone"
}

}  // namespace layoutbox::edit
