// Where things are to stand: links between them, built into relations.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/relation_builder.h"

namespace layoutbox::edit {

using namespace offline;

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
      if (found.noun.kind == NounKind::kCorner && found.noun.wall_word.empty()) {
        found.noun.wall_word = world_.other_corner(targets.front(), found.noun);
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
    if (relation.origin == Origin::kAssumed && !of_new) continue;  // habits of what was there before
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

}  // namespace layoutbox::edit
