// Which things a clause speaks of.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder.h"

namespace layoutbox::edit {

using namespace offline;

namespace {

Pick pick_of(const NounPhrase& noun) {
  if (noun.determiner == Determiner::kOther) return Pick::kOther;
  if (noun.wall_word == "left") return Pick::kLeft;
  if (noun.wall_word == "right") return Pick::kRight;
  if (noun.wall_word == "front") return Pick::kFront;
  return noun.wall_word == "back" ? Pick::kBack : Pick::kNone;
}

}  // namespace

std::vector<int> EditReader::exceptions(Clause& clause) {
  std::vector<int> but;
  if (!take_word(clause, {"except", "except for", "but", "but not", "apart from", "other than"})) return but;
  take_word(clause, {"for", "not"});
  while (noun_next(clause)) {
    const NounPhrase noun = peek(clause)->noun;
    ++clause.k;
    if (auto found = find_things(clause, noun, false)) but.insert(but.end(), found->things.begin(), found->things.end());
    skip(clause, {ChunkKind::kComma, ChunkKind::kAnd});
  }
  return but;
}

std::optional<Modifier> EditReader::read_modifier(Clause& clause) {
  const std::size_t before = clause.k;
  const bool from = take_word(clause, {"from", "of", "off"});
  if (!from) skip(clause, {ChunkKind::kRelative, ChunkKind::kVerb, ChunkKind::kParticiple, ChunkKind::kIgnored});
  const bool relation = !from && more(clause) && peek(clause)->kind == ChunkKind::kRelation;
  if (!relation && !from) {
    clause.k = before;
    return std::nullopt;
  }
  Modifier modifier;
  if (relation) {
    const Chunk& chunk = *peek(clause);
    if (chunk.phrase.senses != nullptr) modifier.senses = *chunk.phrase.senses;
    ++clause.k;
  } else {
    modifier.senses = {{RelationType::kOn, PhraseSense::Direction::kDirect, {}, {}, {}}};
  }
  if (!noun_next(clause)) {
    if (relation && !last_.empty()) {  // "on it", "on top": of what was spoken of
      modifier.things = last_;
      return modifier;
    }
    clause.k = before;
    return std::nullopt;
  }
  const NounPhrase noun = peek(clause)->noun;
  ++clause.k;
  modifier.place = noun;
  if (noun.kind == NounKind::kObject || noun.kind == NounKind::kPronoun || noun.kind == NounKind::kMember) {
    auto found = find_things(clause, noun, false);
    if (!found) {
      clause.k = before;
      return std::nullopt;
    }
    modifier.things = found->things;
  }
  return modifier;
}

std::size_t EditReader::relations_ahead(const Clause& clause) {
  std::size_t count = 0;
  for (std::size_t k = clause.k; k < clause.document.chunks.size(); ++k) {
    const Chunk& chunk = clause.document.chunks[k];
    const bool to = chunk.kind == ChunkKind::kIgnored && clause.document.tokens[chunk.first].text == "to";
    if (chunk.kind == ChunkKind::kRelation || to) ++count;
  }
  return count;
}

// The words of a chunk as they are read, not as they were written.
std::string EditReader::words_of(const Clause& clause, const Chunk& chunk) {
  std::string words;
  for (std::size_t i = chunk.first; i < chunk.last; ++i) words += (words.empty() ? "" : " ") + clause.document.tokens[i].text;
  return words;
}

// One of several, by what follows the noun.
Result<std::vector<int>> EditReader::narrow(Clause& clause, std::vector<int> found, const NounPhrase& noun, bool as_target) {
  const bool plural = noun.is_plural() || noun.determiner == Determiner::kEach || noun.determiner == Determiner::kBoth;
  const std::size_t wanted = noun.count > 0 ? static_cast<std::size_t>(noun.count) : 1;
  const bool relative = more(clause) && peek(clause)->kind == ChunkKind::kRelative;
  const bool several = found.size() > wanted || plural;
  const bool may_modify = relative || (as_target && clause.reserved == 0) || (several && relations_ahead(clause) > clause.reserved);
  if (may_modify) {
    if (const auto modifier = read_modifier(clause)) found = world_.modified(found, *modifier);
  }
  for (const int out : exceptions(clause)) std::erase(found, out);
  if (noun.determiner == Determiner::kPossessive && !last_.empty()) {  // "the left nightstand and its lamp": what stands on it
    std::vector<int> own;
    for (const int i : found) {
      const PlacedObject* placed = world_.thing(i).placed;
      const auto holds = [&](int holder) { return placed != nullptr && world_.thing(holder).id == placed->supported_by; };
      if (std::any_of(last_.begin(), last_.end(), holds)) own.push_back(i);
    }
    if (!own.empty()) found = own;
  }
  if (plural && noun.count == 0) return found;
  if (found.size() <= wanted) return found;
  if (noun.determiner == Determiner::kIndefinite || (noun.determiner == Determiner::kNone && noun.count > 0)) {
    return std::vector<int>(found.end() - static_cast<std::ptrdiff_t>(wanted), found.end());
  }
  std::vector<int> spoken;  // "the lamp" is the one that was spoken of
  for (const int i : found) {
    if (has(last_, i)) spoken.push_back(i);
  }
  return spoken.size() == wanted ? spoken : found;
}

// "the other one", "each of the chairs", "the red one".
std::vector<int> EditReader::members(const Clause& clause, const NounPhrase& noun, Pick pick, bool as_target) const {
  const std::size_t wanted = noun.count > 0 ? static_cast<std::size_t>(noun.count) : 1;
  std::vector<int> found;
  if (noun.of && noun.of->kind == NounKind::kObject) {
    found = world_.with_attributes(world_.of_kind(*noun.of), *noun.of);
  } else if (last_.size() > 1) {
    found = last_;
  } else if (clause.kind != nullptr || !last_.empty() || !clause.targets.empty()) {
    NounPhrase kind = clause.kind != nullptr ? *clause.kind : world_.thing(last_.empty() ? clause.targets.front() : last_.front()).noun;
    kind.plural = true;
    kind.attributes.clear();
    found = world_.of_kind(kind);
    if (!as_target) std::erase_if(found, [&](int i) { return has(clause.targets, i); });
  }
  found = world_.with_attributes(found, noun);
  found = world_.picked(found, pick, mentioned_, wanted);
  const bool all = noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach;
  if (!all && found.size() > wanted) found.erase(found.begin(), found.end() - static_cast<std::ptrdiff_t>(wanted));
  return found;
}

// "everything except the bed", "all the other furniture".
std::vector<int> EditReader::all_things(Clause& clause, const NounPhrase& noun) {
  std::vector<int> found;
  for (std::size_t i = 0; i < world_.things().size(); ++i) {
    if (!world_.things()[i].gone) found.push_back(static_cast<int>(i));
  }
  const bool but_mentioned = take_word(clause, {"else"}) || noun.name.ends_with("else") || noun.determiner == Determiner::kOther;
  if (but_mentioned) std::erase_if(found, [&](int i) { return has(mentioned_, i); });
  NounPhrase all = noun;
  all.plural = true, all.count = 0;
  const auto narrowed = narrow(clause, found, all, true);
  return narrowed ? *narrowed : std::vector<int>{};
}

Result<EditReader::Found> EditReader::find_things(Clause& clause, const NounPhrase& noun, bool as_target) {
  Found result;
  result.noun = noun;
  result.each = noun.determiner == Determiner::kEach;
  const std::string words = words_between(clause.document, noun.first, std::max(noun.last, noun.first + 1));
  Pick pick = pick_of(noun);
  for (const PickedAt& picked : clause.picks) {
    if (picked.token >= noun.first && picked.token <= noun.last && noun.last > noun.first) pick = picked.pick;
  }
  const std::size_t wanted = noun.count > 0 ? static_cast<std::size_t>(noun.count) : 1;
  if (noun.kind == NounKind::kPronoun) {
    const bool itself = !as_target && last_ == clause.targets && !clause.earlier.empty();  // "put the rug in front of it"
    result.things = itself ? clause.earlier : last_;
    std::erase_if(result.things, [&](int i) { return world_.thing(i).gone; });
    if (result.things.empty()) {
      return fail(ErrorCode::kReference, "what \"" + words + "\" means in \"" + clause.why + "\" is not said", "text",
                  "name the thing; of the room itself the size, the walls, the floor and the ceiling are edited, no shape and no style");
    }
    if (std::exchange(recalled_, false)) {
      plan_.notes.push_back(
          {"warning", "\"" + clause.why + "\": " + world_.names(result.things) + ", which was spoken of before, is meant", "text"});
    }
    return result;
  }
  if (noun.kind == NounKind::kMember) {
    result.things = members(clause, noun, pick, as_target);
  } else if (is_everything(noun)) {
    result.things = all_things(clause, noun);
    result.noun.plural = true;
    return result;
  } else if (noun.kind == NounKind::kObject) {
    std::vector<int> found = world_.of_kind(noun);
    if (found.empty()) {
      return fail(ErrorCode::kReference, "there is no \"" + noun.name + "\" in this room", "text", "there are: " + world_.all_names());
    }
    const std::vector<int> kind = found;
    found = world_.with_attributes(found, noun);
    found = world_.picked(found, pick, mentioned_, wanted);
    if (found.empty()) {
      return fail(ErrorCode::kReference, "none of " + world_.names(kind) + " is \"" + words + "\"", "text",
                  "name one by its id, its place or what it stands by");
    }
    LAYOUTBOX_ASSIGN(result.things, narrow(clause, found, noun, as_target));
  } else if (noun.kind == NounKind::kRoom || noun.kind == NounKind::kWall || noun.kind == NounKind::kDoor ||
             noun.kind == NounKind::kWindow) {
    return fail(ErrorCode::kParse,
                "\"" + words + "\" in \"" + clause.why + "\": the room itself, its doors and its windows cannot be edited", "text",
                "plan it anew, or edit the room in scene.json");
  } else {
    return not_understood(clause, words);
  }
  if (result.things.empty()) return not_understood(clause, words);
  const bool plural = noun.is_plural() || result.each || noun.determiner == Determiner::kBoth;
  if (noun.kind == NounKind::kObject && result.things.size() > wanted && (!plural || noun.count > 0)) {
    result.noun.count = -1;  // several, and which is not said
  }
  return result;
}

Result<std::vector<int>> EditReader::read_things(Clause& clause, bool places_follow) {
  std::vector<int> all;
  skip(clause, {ChunkKind::kIgnored, ChunkKind::kThere});
  while (noun_next(clause)) {
    const NounPhrase noun = peek(clause)->noun;
    clause.subject = clause.k++;
    clause.reserved = places_follow ? 1 : 0;
    LAYOUTBOX_ASSIGN(const Found found, find_things(clause, noun, true));
    clause.reserved = 0;
    last_ = found.things;
    if (found.noun.count == -1) {
      return fail(ErrorCode::kReference, "which of " + world_.names(found.things) + " is meant by \"" + noun.name + "\" is not said",
                  "text", "name one by its id, its place or what it stands by, or say \"all\"");
    }
    for (const int i : found.things) {
      if (!has(all, i)) all.push_back(i);
    }
    const std::size_t before = clause.k;
    skip(clause, {ChunkKind::kComma, ChunkKind::kAnd});
    if (clause.k > before) skip(clause, {ChunkKind::kIgnored});
    const Chunk* with = peek(clause);
    const Chunk* whom = peek(clause, 1);
    if (clause.k == before && with != nullptr && whom != nullptr && whom->kind == ChunkKind::kNoun &&
        words_of(clause, *with).ends_with("with") &&
        (whom->noun.determiner == Determiner::kPossessive || whom->noun.determiner == Determiner::kDefinite) &&
        clause.verb != Verb::kSwap && clause.verb != Verb::kReplace && clause.verb != Verb::kKeep && clause.verb != Verb::kSubstitute) {
      ++clause.k;  // "the table with its chairs", "together with the chairs"
    }
    if (clause.k == before || !noun_next(clause)) {
      clause.k = before;
      break;
    }
  }
  clause.targets = all;
  if (all.empty()) return not_understood(clause);
  remember(all);
  return all;
}

Result<EditReader::Found> EditReader::find_reference(Clause& clause, const Chunk& chunk) {
  const NounPhrase& noun = chunk.noun;
  Found found;
  found.noun = noun;
  switch (noun.kind) {
    case NounKind::kObject:
    case NounKind::kPronoun:
    case NounKind::kMember: {
      LAYOUTBOX_ASSIGN(found, find_things(clause, noun, false));
      if (found.noun.count == -1 && !noun.is_plural()) {
        return fail(ErrorCode::kReference, "which of " + world_.names(found.things) + " is meant by \"" + noun.name + "\" is not said",
                    "text", "name one by its id, its place or what it stands by, or say \"each\"");
      }
      return found;
    }
    default: break;
  }
  if (noun.of && noun.of->kind != NounKind::kRoom) {  // "the foot of the bed", "the corner of the desk"
    if (noun.of->kind == NounKind::kObject || noun.of->kind == NounKind::kPronoun) {
      LAYOUTBOX_ASSIGN(const Found whole, find_things(clause, *noun.of, false));
      found.things = whole.things;
    }
  }
  return found;
}

}  // namespace layoutbox::edit
