#include "layoutbox/plan/edit/edit_reader.h"

#include <algorithm>
#include <utility>

#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/relation_builder.h"

namespace layoutbox::edit {

using namespace offline;

namespace {

bool has(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }

bool is_everything(const NounPhrase& noun) {
  return noun.head == "everything" || noun.head == "furniture" || noun.name == "everything else" || noun.head == "anything";
}

Pick pick_of(const NounPhrase& noun) {
  if (noun.determiner == Determiner::kOther) return Pick::kOther;
  if (noun.wall_word == "left") return Pick::kLeft;
  if (noun.wall_word == "right") return Pick::kRight;
  if (noun.wall_word == "front") return Pick::kFront;
  return noun.wall_word == "back" ? Pick::kBack : Pick::kNone;
}

// "the opposite wall", "the other wall": of the one that the thing stands at.
bool is_opposite_wall(const NounPhrase& noun) {
  const auto& said = noun.attributes;
  return noun.kind == NounKind::kWall && noun.wall_word.empty() &&
         (noun.determiner == Determiner::kOther || noun.wall_relation == "opposite" ||
          std::find(said.begin(), said.end(), "opposite") != said.end());
}

bool only_turns(const EditStep& step) {
  return std::all_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return r.type == RelationType::kFacing; });
}

constexpr const char* kWhatToSay =
    "say for example: move the desk under the window; remove the rug; add a lamp on the desk; make the sofa red; swap the bed and the desk";

}  // namespace

Failure EditReader::not_understood(const Clause& clause, std::string_view words) const {
  const std::string what =
      words.empty() || words == clause.why ? "\"" + clause.why + "\"" : "\"" + std::string(words) + "\" in \"" + clause.why + "\"";
  return fail(ErrorCode::kParse, what + " is not understood as a change of the room", "text", kWhatToSay);
}

const Chunk* EditReader::peek(const Clause& clause, std::size_t ahead) const {
  return clause.k + ahead < clause.document.chunks.size() ? &clause.document.chunks[clause.k + ahead] : nullptr;
}

void EditReader::skip(Clause& clause, std::initializer_list<ChunkKind> kinds) const {
  while (more(clause) && std::find(kinds.begin(), kinds.end(), peek(clause)->kind) != kinds.end()) ++clause.k;
}

// Takes the next chunk where it is one of these words.
bool EditReader::take_word(Clause& clause, std::initializer_list<std::string_view> words) const {
  if (!more(clause)) return false;
  const Chunk& next = *peek(clause);
  const std::string text = words_of(clause, next);
  if (std::find(words.begin(), words.end(), text) == words.end()) return false;
  ++clause.k;
  return true;
}

bool EditReader::noun_next(const Clause& clause) const { return more(clause) && peek(clause)->kind == ChunkKind::kNoun; }

std::vector<std::string> EditReader::ids(const std::vector<int>& things) const {
  std::vector<std::string> all;
  for (const int i : things) all.push_back(world_.thing(i).id);
  return all;
}

void EditReader::remember(const std::vector<int>& things) {
  last_ = things;
  mentioned_.insert(mentioned_.end(), things.begin(), things.end());
}

EditStep& EditReader::begin(EditKind kind, const Clause& clause, const std::vector<int>& targets) {
  EditStep step;
  step.kind = kind;
  step.targets = ids(targets);
  step.why = clause.why;
  plan_.steps.push_back(std::move(step));
  return plan_.steps.back();
}

void EditReader::chunk(Clause& clause) const {
  Document& document = clause.document;
  document.readings.clear();
  for (const Token& token : document.tokens) document.readings.push_back({token.begin, token.end, WordReading::Use::kIgnored, {}});
  document.chunks = chunk_tokens(lexicon_, document.tokens);
  // "bed_1": a thing by its id.
  for (Chunk& chunk : document.chunks) {
    if (chunk.kind == ChunkKind::kNoun || chunk.last != chunk.first + 1) continue;
    const std::string& word = document.tokens[chunk.first].text;
    if (word.find('_') == std::string::npos && word != "everything") continue;
    if (word != "everything" && world_.find(word) < 0) continue;
    chunk.kind = ChunkKind::kNoun;
    chunk.noun = NounPhrase{};
    chunk.noun.name = chunk.noun.head = word;
    chunk.noun.determiner = Determiner::kDefinite;
    chunk.noun.first = chunk.first, chunk.noun.last = chunk.last;
  }
}

// ---- which things

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
      return fail(ErrorCode::kReference, "what \"" + words + "\" means in \"" + clause.why + "\" is not said", "text", "name the thing");
    }
    return result;
  }
  std::vector<int> found;
  if (noun.kind == NounKind::kMember) {
    if (noun.of && noun.of->kind == NounKind::kObject) {
      found = world_.with_attributes(world_.of_kind(*noun.of), *noun.of);
    } else if (last_.size() > 1) {
      found = last_;
    } else if (!last_.empty()) {
      NounPhrase kind = world_.thing(last_.front()).noun;
      kind.plural = true;
      kind.attributes.clear();
      found = world_.of_kind(kind);
    }
    found = world_.with_attributes(found, noun);
    found = world_.picked(found, pick, mentioned_, wanted);
    const bool all = noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach;
    if (!all && found.size() > wanted) found.erase(found.begin(), found.end() - static_cast<std::ptrdiff_t>(wanted));
    result.things = found;
  } else if (is_everything(noun)) {
    for (std::size_t i = 0; i < world_.things().size(); ++i) {
      if (!world_.things()[i].gone) found.push_back(static_cast<int>(i));
    }
    const bool but_mentioned = take_word(clause, {"else"}) || noun.name.ends_with("else") || noun.determiner == Determiner::kOther;
    if (but_mentioned) std::erase_if(found, [&](int i) { return has(mentioned_, i); });
    NounPhrase all = noun;
    all.plural = true, all.count = 0;
    if (auto narrowed = narrow(clause, found, all, true)) result.things = *narrowed;
    result.noun.plural = true;
    return result;
  } else if (noun.kind == NounKind::kObject) {
    found = world_.of_kind(noun);
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
    ++clause.k;
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

// ---- places

int EditReader::mention_of(Clause& clause, const NounPhrase& noun, const std::vector<int>& things) const {
  Mention mention;
  mention.noun = noun;
  mention.items = things;
  clause.document.mentions.push_back(std::move(mention));
  return static_cast<int>(clause.document.mentions.size()) - 1;
}

int EditReader::mention_of(Clause& clause, const std::vector<int>& things, bool each) const {
  NounPhrase noun = world_.thing(things.front()).noun;
  noun.count = static_cast<int>(things.size());
  const int mention = mention_of(clause, noun, things);
  clause.document.mentions.back().distributes = each;
  return mention;
}

int EditReader::bring_in(Clause& clause, const NounPhrase& noun, EditStep& step) {
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
  const int index = world_.add(object.id, noun, object.attributes);
  clause.document.items.push_back({noun, clause.document.groups++});
  added_[object.id] = object;
  step.objects.push_back(std::move(object));
  return index;
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

Status EditReader::read_links(Clause& clause, std::vector<int>& targets, EditStep& step, bool& any) {
  Document& document = clause.document;
  bool soft = false;
  while (more(clause)) {
    const std::size_t before = clause.k;
    skip(clause, {ChunkKind::kIgnored, ChunkKind::kParticiple, ChunkKind::kVerb, ChunkKind::kComma, ChunkKind::kAnd, ChunkKind::kRelative});
    if (!more(clause)) return {};
    const Chunk chunk = *peek(clause);
    if (chunk.kind == ChunkKind::kSoft) {
      soft = true;
      ++clause.k;
      continue;
    }
    const std::string said = words_of(clause, chunk);
    if (chunk.kind == ChunkKind::kHave && said == "with" && step.kind == EditKind::kAdd) {  // "with a lamp on it"
      ++clause.k;
      while (noun_next(clause)) {
        const NounPhrase noun = peek(clause)->noun;
        if (noun.kind != NounKind::kObject) return not_understood(clause, words_between(document, noun.first, noun.last));
        ++clause.k;
        std::vector<int> contents;
        const int count = noun.count > 0 ? noun.count : noun.plural ? 2 : 1;
        for (int i = 0; i < count; ++i) contents.push_back(bring_in(clause, noun, step));
        Link link;
        link.kind = Link::Kind::kHave;
        link.first = chunk.first, link.last = chunk.last;
        const Chunk* next = peek(clause);
        const Chunk* after = peek(clause, 1);
        if (next && after && next->kind == ChunkKind::kRelation && after->kind == ChunkKind::kNoun &&
            after->noun.kind == NounKind::kPronoun && next->phrase.senses != nullptr) {
          link.kind = Link::Kind::kRelation;
          link.senses = *next->phrase.senses;
          link.first = next->first, link.last = next->last;
          clause.k += 2;
        }
        link.targets = {mention_of(clause, contents, false)};
        link.references = {mention_of(clause, targets, false)};
        document.links.push_back(std::move(link));
        skip(clause, {ChunkKind::kComma, ChunkKind::kAnd});
      }
      any = true;
      continue;
    }
    const bool to = said == "to" || said == "into" || said == "onto" || said == "over to" || said == "in" || said == "at";
    if (chunk.kind != ChunkKind::kRelation && !(to && peek(clause, 1) && peek(clause, 1)->kind == ChunkKind::kNoun)) {
      clause.k = before;
      return {};
    }
    ++clause.k;
    Link link;
    link.first = chunk.first, link.last = chunk.last;
    link.soft = soft;
    link.each = chunk.phrase.each;
    link.distance = chunk.distance, link.at_least = chunk.at_least, link.at_most = chunk.at_most;
    if (chunk.kind == ChunkKind::kRelation && chunk.phrase.senses != nullptr) link.senses = *chunk.phrase.senses;
    bool each = chunk.phrase.each;
    std::size_t references = 0;
    while (noun_next(clause)) {
      const Chunk noun_chunk = *peek(clause);
      // "…, the chair to the left wall": another thing and its place.
      const Chunk* after = peek(clause, 1);
      const bool between =
          std::any_of(link.senses.begin(), link.senses.end(), [](const auto& s) { return s.type == RelationType::kBetween; });
      if (references > 0 && !between && after != nullptr && (after->kind == ChunkKind::kRelation || after->kind == ChunkKind::kVerb)) break;
      ++clause.k;
      LAYOUTBOX_ASSIGN(Found found, find_reference(clause, noun_chunk));
      link.last = std::max(link.last, noun_chunk.last);
      std::erase_if(found.things, [&](int i) { return has(targets, i); });
      const bool object = !found.things.empty();
      if (!object && (noun_chunk.noun.kind == NounKind::kObject || noun_chunk.noun.kind == NounKind::kPronoun))
        return not_understood(clause);
      if (to && (said == "to" || said == "over to" || said == "into" || chunk.kind != ChunkKind::kRelation)) {
        // Where "to" leads: on what carries a small thing, beside another, into a corner, near a window, against a wall.
        const NounKind kind = noun_chunk.noun.kind;
        const bool carried = object &&
                             may_carry(lexicon_.catalog(), world_.thing(found.things.front()).noun, world_.thing(targets.front()).noun) &&
                             mount_of(world_.thing(targets.front()).noun) == Mount::kSurface;
        const std::string_view phrase = object && noun_chunk.noun.kind != NounKind::kObject && noun_chunk.noun.kind != NounKind::kPronoun
                                            ? "at"
                                        : carried                                              ? "on"
                                        : object                                               ? "next to"
                                        : kind == NounKind::kWindow || kind == NounKind::kDoor ? "near"
                                        : kind == NounKind::kWall                              ? "against"
                                                                                               : "in";
        const std::vector<Token> tokens = tokenize(phrase);
        if (const PhraseMatch match = lexicon_.find_phrase(tokens, 0); match.senses != nullptr) link.senses = *match.senses;
      }
      if (is_opposite_wall(found.noun)) {
        if (const Wall* wall = world_.wall_of(targets.front())) {
          for (const auto& [side, other] : {std::pair{"left", "right"}, {"right", "left"}, {"front", "back"}, {"back", "front"}}) {
            if (world_.layout().find_wall(side) == wall) found.noun.wall_word = other;
          }
        }
      }
      each = each || found.each;
      const bool whole = noun_chunk.noun.kind == NounKind::kObject || noun_chunk.noun.kind == NounKind::kPronoun ||
                         noun_chunk.noun.kind == NounKind::kMember;
      const int mention = object && whole ? mention_of(clause, found.things, found.each) : mention_of(clause, found.noun, found.things);
      link.references.push_back(mention);
      ++references;
      const std::size_t here = clause.k;
      skip(clause, {ChunkKind::kComma, ChunkKind::kAnd});
      if (clause.k == here || !noun_next(clause)) {
        clause.k = here;
        break;
      }
    }
    // "a lamp on each nightstand", "a plant on each side of the sofa": as many as there are places.
    if (each && step.kind == EditKind::kAdd && targets.size() == 1 && references == 1) {
      const Mention& place = document.mentions[static_cast<std::size_t>(link.references.front())];
      const bool sides =
          std::any_of(link.senses.begin(), link.senses.end(), [](const auto& s) { return s.type == RelationType::kEachSideOf; });
      const std::size_t wanted = sides && !place.distributes ? 2 : place.items.size();
      const NounPhrase noun = world_.thing(targets.front()).noun;
      while (targets.size() < wanted) targets.push_back(bring_in(clause, noun, step));
      link.each = true;
    }
    link.targets = {mention_of(clause, targets, false)};
    document.links.push_back(std::move(link));
    any = true;
  }
  return {};
}

Status EditReader::build(Clause& clause, EditStep& step) {
  SceneGraph scene;
  scene.room = world_.layout().room;
  for (const Thing& thing : world_.things()) {
    SceneObject object;
    if (const auto added = added_.find(thing.id); added != added_.end()) {
      object = added->second;
    } else {
      object.id = thing.id, object.category = thing.placed->category, object.name = thing.placed->name;
      object.mount = thing.placed->mount;
    }
    scene.objects.push_back(std::move(object));
  }
  build_relations(lexicon_, clause.document, scene);
  for (const Note& note : scene.notes) {
    if (note.code == "not-understood" || note.code == "contradiction") {
      return fail(ErrorCode::kParse, note.message + " (\"" + clause.why + "\")", "text", kWhatToSay);
    }
  }
  const auto is_new = [&](const std::string& id) {
    return std::any_of(step.objects.begin(), step.objects.end(), [&](const SceneObject& o) { return o.id == id; });
  };
  for (Relation& relation : scene.relations) {
    const bool of_new = std::any_of(relation.targets.begin(), relation.targets.end(), is_new);
    if (relation.assumed && !of_new) continue;  // habits of what was there before
    // A window that was named: that one.
    for (const Mention& mention : clause.document.mentions) {
      const bool opening = mention.noun.kind == NounKind::kWindow || mention.noun.kind == NounKind::kDoor;
      if (!opening || !relation.references.empty() || (relation_row(relation.type).reference_kinds & kOpening) == 0) continue;
      const auto meant = world_.openings_of(mention.noun);
      if (meant.size() == 1) relation.references = {meant.front()->id};
    }
    relation.id.clear();
    step.relations.push_back(relation);
  }
  for (SceneObject& object : step.objects) {
    if (const SceneObject* settled = scene.find_object(object.id)) added_[object.id] = object = *settled;
  }
  return {};
}

Status EditReader::rest_understood(const Clause& clause) const {
  for (std::size_t k = clause.k; k < clause.document.chunks.size(); ++k) {
    const Chunk& chunk = clause.document.chunks[k];
    switch (chunk.kind) {
      case ChunkKind::kIgnored:
      case ChunkKind::kComma:
      case ChunkKind::kAnd:
      case ChunkKind::kSoft:
      case ChunkKind::kStop:
      case ChunkKind::kParticiple:
      case ChunkKind::kVerb: continue;
      default: return not_understood(clause, words_between(clause.document, chunk.first, chunk.last));
    }
  }
  return {};
}

// ---- commands

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

Status EditReader::read_move(Clause& clause, const std::optional<ShiftAt>& shift) {
  if (shift) {
    LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, false));
    EditShift way = shift->shift;
    if (way.way == EditShift::Way::kTowards || way.way == EditShift::Way::kAway) {
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
        const Wall* wall = chunk.noun.wall_word.empty() ? world_.wall_of(things.front()) : world_.layout().find_wall(chunk.noun.wall_word);
        if (wall != nullptr) way.reference = wall->id;
      }
      if (way.reference.empty()) return not_understood(clause, words_between(clause.document, chunk.first, chunk.last));
    }
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
  if (!noun_next(clause) || peek(clause)->noun.kind != NounKind::kObject) return not_understood(clause);
  const NounPhrase noun = peek(clause)->noun;
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
  LAYOUTBOX_ASSIGN(const std::vector<int> things, read_things(clause, false));
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
  begin(EditKind::kKeep, clause, things);
  return {};  // "where it is", "as it is", "alone"
}

Status EditReader::read_command(const Command& command) {
  Clause clause;
  clause.verb = command.verb;
  clause.word = command.word;
  clause.why = std::string(text_.substr(command.begin, command.end - command.begin));
  clause.document.prompt = std::string(text_);
  clause.earlier = last_;
  Tokens tokens = command.tokens;
  const auto at = [&tokens](std::size_t i, std::string_view word) { return i < tokens.size() && tokens[i].text == word; };
  const auto erase = [&tokens](std::size_t first, std::size_t count) {
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(first), tokens.begin() + static_cast<std::ptrdiff_t>(first + count));
  };
  const auto is_property = [](std::string_view word) {
    for (const std::string_view property :
         {"color", "size", "position", "positions", "place", "places", "material", "orientation", "name", "location"}) {
      if (word == property) return true;
    }
    return false;
  };
  const bool making =
      clause.verb == Verb::kMake || clause.verb == Verb::kRecolor || clause.verb == Verb::kNone || clause.verb == Verb::kSwap;
  for (std::size_t i = 0; i < tokens.size();) {
    // "the color of the sofa", "the sofa's color": the sofa.
    if (making && at(i, "the") && i + 2 < tokens.size() && is_property(tokens[i + 1].text) && at(i + 2, "of")) {
      erase(i, 3);
    } else if (making && at(i, "'s") && i + 1 < tokens.size() && is_property(tokens[i + 1].text)) {
      erase(i, 2);
    } else if (clause.verb == Verb::kSwap && is_property(tokens[i].text) && i + 1 == tokens.size()) {
      erase(i, 1);
    } else if (i > 0 && (at(i, "new") || (at(i, "more") && clause.verb == Verb::kAdd)) && clause.verb != Verb::kRename) {
      erase(i, 1);
    } else if (at(i, "please") || at(i, "instead") || at(i, "too") || at(i, "also")) {
      // "instead of" names what goes.
      if (at(i, "instead") && at(i + 1, "of")) {
        ++i;
      } else {
        erase(i, 1);
      }
    } else {
      ++i;
    }
  }
  if (clause.verb == Verb::kRename) {
    std::erase_if(tokens, [&, first = true](const Token& token) mutable { return token.text == "\"" && !std::exchange(first, false); });
    for (Token& token : tokens) {
      if (token.text == "\"") token.text = "as", token.kind = Token::Kind::kWord;
    }
  }
  if (clause.word == "tuck") {
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (!at(i, "under") || (i > 0 && at(i - 1, "tucked"))) continue;
      Token tucked = tokens[i];
      tucked.text = "tucked";
      tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(i++), tucked);
    }
  }
  clause.picks = take_picks(tokens);
  std::optional<double> degrees;
  std::optional<ShiftAt> shift;
  std::optional<EditResize> resize;
  if (clause.verb == Verb::kTurn) {
    // "toward the window", "to face the window", "so that it faces the window", and "face it to the window".
    degrees = take_turn(tokens);
    if (!degrees) {
      for (std::size_t i = 0; i < tokens.size(); ++i) {
        const bool so = at(i, "so");
        std::size_t end = i + (so ? 1 : 0);
        if (so && at(end, "that")) ++end;
        if (so && (at(end, "it") || at(end, "they"))) ++end;
        std::size_t length = 0;
        if (at(end, "to") && (at(end + 1, "face") || at(end + 1, "look")))
          length = end + 2 - i + (at(end + 2, "at") || at(end + 2, "toward") ? 1 : 0);
        else if (at(end, "faces") || at(end, "face") || at(end, "toward") || at(end, "towards") || at(end, "facing") || at(end, "at"))
          length = end + 1 - i;
        else if (at(end, "to") || at(end, "into"))
          length = at(end, "to") ? end + 1 - i : 0;
        if (length == 0) continue;
        tokens[i].text = "facing";
        if (length > 1) erase(i + 1, length - 1);
        if (at(i + 1, "toward") || at(i + 1, "towards")) erase(i + 1, 1);
        break;
      }
    }
  } else if (clause.verb == Verb::kMove || clause.verb == Verb::kPlace) {
    shift = take_shift(lexicon_, tokens, clause.word);
  } else if (clause.verb == Verb::kMake || clause.verb == Verb::kNone || clause.verb == Verb::kResize) {
    resize = take_resize(lexicon_, tokens, clause.verb == Verb::kResize ? clause.word : "");
    if (!resize) degrees = take_turn(tokens);
    if (!resize && !degrees) shift = take_shift(lexicon_, tokens, "");
  }
  if (clause.verb == Verb::kRecolor || clause.verb == Verb::kMake) {  // "to red", "in blue"
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
      if (!at(i, "to") && !at(i, "in") && !at(i, "into")) continue;
      const Match match = lexicon_.find(tokens, i + 1);
      const bool attribute = std::any_of(match.meanings.begin(), match.meanings.end(), [](const Meaning& m) {
        return m.word_class == WordClass::kColor || m.word_class == WordClass::kMaterial;
      });
      if (attribute || tokens[i + 1].text == "dark" || tokens[i + 1].text == "light") erase(i, 1);
    }
  }
  clause.document.tokens = std::move(tokens);
  for (const Thing& thing : world_.things()) clause.document.items.push_back({thing.noun, clause.document.groups++});
  chunk(clause);
  switch (clause.verb) {
    case Verb::kAdd: return read_add(clause);
    case Verb::kPlace: return shift ? read_move(clause, shift) : read_place(clause);
    case Verb::kRemove: return read_remove(clause);
    case Verb::kMove: return read_move(clause, shift);
    case Verb::kSwap: return read_swap(clause);
    case Verb::kReplace: return read_replace(clause, false);
    case Verb::kSubstitute: return read_replace(clause, true);
    case Verb::kTurn: return degrees ? read_turn(clause, degrees) : read_make(clause, std::nullopt, std::nullopt, std::nullopt);
    case Verb::kRename: return read_rename(clause);
    case Verb::kKeep: return read_keep(clause);
    case Verb::kMake:
    case Verb::kRecolor:
    case Verb::kResize:
    case Verb::kNone: return read_make(clause, resize, degrees, shift);
  }
  return not_understood(clause);
}

Result<EditPlan> EditReader::read() {
  std::vector<Token> tokens = tokenize(text_);
  // "bed_1" comes in three pieces.
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    while (i + 2 < tokens.size() && tokens[i + 1].text == "_" && tokens[i + 1].glued && tokens[i + 2].glued) {
      tokens[i].text += "_" + tokens[i + 2].text;
      tokens[i].end = tokens[i + 2].end;
      tokens[i].kind = Token::Kind::kWord;
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 1, tokens.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    }
  }
  const std::vector<Command> commands = split_commands(tokens);
  if (commands.empty()) return fail(ErrorCode::kEmpty, "there is nothing in the text", "text", kWhatToSay);
  for (const Command& command : commands) LAYOUTBOX_CHECK(read_command(command));
  return std::move(plan_);
}

}  // namespace layoutbox::edit

namespace layoutbox {

std::string_view name_of(EditKind kind) {
  switch (kind) {
    case EditKind::kAdd: return "add";
    case EditKind::kRemove: return "remove";
    case EditKind::kMove: return "move";
    case EditKind::kShift: return "shift";
    case EditKind::kSwap: return "swap";
    case EditKind::kReplace: return "replace";
    case EditKind::kTurn: return "turn";
    case EditKind::kResize: return "resize";
    case EditKind::kRecolor: return "recolor";
    case EditKind::kRename: return "rename";
    case EditKind::kKeep: return "keep";
  }
  return "move";
}

Result<EditPlan> plan_edit(std::string_view text, const Layout& layout, const Catalog& catalog) {
  if (text.size() > 100'000) return fail(ErrorCode::kTooLarge, "the text has more than 100000 bytes", "text");
  const offline::Lexicon lexicon(catalog);
  return edit::EditReader(lexicon, layout, text).read();
}

}  // namespace layoutbox
