// One function a command: add, place, remove, move, swap, replace, turn, change, rename, keep.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder.h"

namespace layoutbox::edit {

using namespace offline;

Status EditReader::read_add(Clause& clause) {
  take_word(clause, {"back"});
  skip(clause, {ChunkKind::kIgnored});
  if (!noun_next(clause)) return not_understood(clause);
  const NounPhrase& noun = peek(clause)->noun;
  if (noun.kind != NounKind::kObject && noun.kind != NounKind::kMember)
    return not_understood(clause, words_between(clause.document, noun.first, noun.last));
  LAYOUTBOX_ASSIGN(std::vector<Chunk> chunks, passage(clause, nullptr));
  LAYOUTBOX_CHECK(decode(clause, std::move(chunks)));
  return bring_in_items(clause);
}

// "Put the lamp on the desk": the lamp that is there, or else a new one.
Status EditReader::read_place(Clause& clause) {
  skip(clause, {ChunkKind::kIgnored});
  if (!noun_next(clause)) return not_understood(clause);
  const NounPhrase& noun = peek(clause)->noun;
  const bool definite = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive ||
                        noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach ||
                        noun.determiner == Determiner::kOther;
  if (is_surface(clause.verb, noun)) return read_make(clause, std::nullopt, std::nullopt, std::nullopt);
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
    LAYOUTBOX_ASSIGN(EditShift way, read_shift_reference(clause, shift->shift, world_.wall_of(things.front())));
    if (clause.along_wall) way = along_wall(way, things);
    LAYOUTBOX_CHECK(rest_understood(clause));
    begin(EditKind::kShift, clause, things).shift = way;
    return {};
  }
  LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, true));
  LAYOUTBOX_ASSIGN(const bool swapped, read_place_of_other(clause, things));
  if (swapped) return {};
  bool any = false;
  LAYOUTBOX_CHECK(read_places(clause, things, any));
  if (any) return rest_understood(clause);
  if (clause.word != "center") return not_understood(clause);  // "center the rug"
  EditStep& step = begin(EditKind::kMove, clause, things);
  Relation relation;
  relation.type = RelationType::kCenterOfRoom;
  relation.targets = step.targets;
  step.relations.push_back(std::move(relation));
  return {};
}

Result<bool> EditReader::read_place_of_other(Clause& clause, const std::vector<int>& things) {
  std::size_t k = clause.k;
  const auto& chunks = clause.document.chunks;
  while (k < chunks.size() && (chunks[k].kind == ChunkKind::kIgnored || one_of(words_of(clause, chunks[k]), {"to", "over", "over to"})))
    ++k;
  if (k + 1 >= chunks.size() || words_of(clause, chunks[k]) != "where" || chunks[k + 1].kind != ChunkKind::kNoun) return false;
  clause.k = k + 1;
  LAYOUTBOX_ASSIGN(const std::vector<int> others, read_things(clause, false));
  const bool is = more(clause) && peek(clause)->kind == ChunkKind::kVerb;
  if (!is || things.size() != 1 || others.size() != 1 || things == others) return not_understood(clause);
  ++clause.k;
  begin(EditKind::kSwap, clause, {things.front(), others.front()});
  remember(things);
  LAYOUTBOX_CHECK(rest_understood(clause));
  return true;
}

Status EditReader::read_mention(Clause& clause) {
  LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, false));
  LAYOUTBOX_CHECK(rest_understood(clause));
  plan_.notes.push_back({"info", "\"" + clause.why + "\" says nothing of what is to become of " + world_.names(things), "text"});
  return {};
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
  if (!noun_next(clause) && !new_first) {
    return fail(ErrorCode::kParse, "what " + world_.names(things) + " is to be replaced with is not said in \"" + clause.why + "\"", "text",
                "say for example: " + clause.why + " with a bench");
  }
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
  for (std::size_t i = 0; i < count; ++i) fresh.push_back(bring_in(noun, step));
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
