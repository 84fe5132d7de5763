// Where things are to stand: the planner's own reading of the clause, with what is in the room as what may be spoken of.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/edit_reader.h"
#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder.h"

namespace layoutbox::edit {

using namespace offline;

namespace {

bool is_joiner(ChunkKind kind) { return kind == ChunkKind::kComma || kind == ChunkKind::kAnd; }

// It brings a thing in, or speaks of one that comes in: none of those that are there.
bool comes_in(const NounPhrase& noun) {
  if (noun.kind == NounKind::kMember)
    return noun.determiner == Determiner::kAnother || (noun.determiner == Determiner::kIndefinite && !noun.attributes.empty());
  return noun.kind == NounKind::kObject && (noun.determiner == Determiner::kIndefinite || noun.determiner == Determiner::kAnother ||
                                            noun.determiner == Determiner::kNone || noun.determiner == Determiner::kNo);
}

bool speaks_of_things(const NounPhrase& noun) {
  return noun.kind == NounKind::kObject || noun.kind == NounKind::kMember || noun.kind == NounKind::kPronoun;
}

}  // namespace

// Which of the room a noun of the passage speaks of; what follows it and only tells which is taken with it.
Status EditReader::know_noun(Clause& clause, Chunk& chunk, const std::vector<int>& subject) {
  LAYOUTBOX_ASSIGN(Found found, find_reference(clause, chunk));
  NounPhrase& noun = chunk.noun;
  std::erase_if(found.things, [&](int i) { return has(subject, i); });
  if (found.things.empty()) {
    if (noun.kind == NounKind::kPronoun) return {};  // of the subject itself: "the desk …, with the chair in front of it"
    if (noun.kind == NounKind::kObject) return not_understood(clause);
    if (is_opposite_wall(noun) && !subject.empty()) {
      if (const Wall* wall = world_.wall_of(subject.front())) {
        for (const auto& [side, other] : {std::pair{"left", "right"}, {"right", "left"}, {"front", "back"}, {"back", "front"}}) {
          if (world_.layout().find_wall(side) == wall) noun.wall_word = other;
        }
      }
    }
    // "50 cm away from the wall": from its own
    const bool from = chunk.first > 0 && clause.document.tokens[chunk.first - 1].text == "from";
    if (noun.kind == NounKind::kWall && noun.wall_word.empty() && noun.wall_relation.empty() && noun.determiner == Determiner::kDefinite &&
        !noun.plural && from && !subject.empty()) {
      const Wall* wall = world_.wall_of(subject.front());
      for (const std::string_view side : {"left", "right", "front", "back"}) {
        if (wall != nullptr && world_.layout().find_wall(side) == wall) noun.wall_word = side;
      }
    }
    if (noun.kind == NounKind::kCorner && noun.wall_word.empty() && !subject.empty())
      noun.wall_word = world_.other_corner(subject.front(), noun);
    return {};
  }
  if (speaks_of_things(noun)) {
    NounPhrase known = world_.thing(found.things.front()).noun;
    known.first = noun.first, known.last = noun.last;
    known.determiner = found.each ? Determiner::kEach : Determiner::kDefinite;
    known.count = static_cast<int>(found.things.size());
    known.plural = known.count > 1;
    noun = std::move(known);
  }
  noun.items = std::move(found.things);
  return {};
}

// Where "to" leads: on what carries a small thing, beside another, into a corner, near a window, against a wall.
void EditReader::lead_to(Clause& clause, std::vector<Chunk>& chunks, std::size_t at, const std::vector<int>& subject) const {
  Chunk& place = chunks[at];
  const std::string said = words_of(clause, place);
  const bool to = said == "to" || said == "into" || said == "onto" || said == "over to" || said == "in" || said == "at";
  const bool leads = said == "to" || said == "over to" || said == "into" || (to && place.kind != ChunkKind::kRelation);
  if (!leads || subject.empty() || at + 1 >= chunks.size() || chunks[at + 1].kind != ChunkKind::kNoun) return;
  const NounPhrase& noun = chunks[at + 1].noun;
  const NounPhrase& target = world_.thing(subject.front()).noun;
  std::string_view phrase = "in";
  if (!noun.items.empty() && noun.kind != NounKind::kObject)
    phrase = "at";
  else if (!noun.items.empty())
    phrase = may_carry(lexicon_.catalog(), noun, target) && mount_of(target) == Mount::kSurface ? "on" : "next to";
  else if (noun.kind == NounKind::kWindow || noun.kind == NounKind::kDoor)
    phrase = "near";
  else if (noun.kind == NounKind::kWall)
    phrase = "against";
  const std::vector<Token> tokens = tokenize(phrase);
  const PhraseMatch match = lexicon_.find_phrase(tokens, 0);
  if (match.senses == nullptr) return;
  place.kind = ChunkKind::kRelation;
  place.phrase = match;
}

// "another chair like the red one": of its kind and its looks.
bool EditReader::follow_like(Clause& clause, std::vector<Chunk>& chunks, std::size_t k) {
  if (k + 1 >= clause.document.chunks.size() || words_of(clause, clause.document.chunks[k]) != "like" || chunks.empty() ||
      chunks.back().kind != ChunkKind::kNoun || clause.document.chunks[k + 1].kind != ChunkKind::kNoun)
    return false;
  NounPhrase& noun = chunks.back().noun;
  clause.k = k + 2;
  const auto found = find_things(clause, clause.document.chunks[k + 1].noun, false);
  if (!found || found->things.empty()) return false;
  const NounPhrase like = world_.thing(found->things.front()).noun;
  if (noun.entry == nullptr || like.entry == nullptr || noun.kind == NounKind::kMember ||
      lexicon_.catalog().is_a(like.entry->id, noun.entry->id)) {
    noun.entry = like.entry;
    noun.category = like.category;
    noun.name = like.name;
    noun.head = like.head;
    noun.kind = NounKind::kObject;
  }
  for (const std::string& attribute : like.attributes) {
    if (noun.attributes.empty()) noun.attributes.push_back(attribute);
  }
  return true;
}

Result<std::vector<Chunk>> EditReader::passage(Clause& clause, const std::vector<int>* subject) {
  std::vector<Chunk> chunks;
  std::vector<int> about = subject != nullptr ? *subject : std::vector<int>{};
  bool new_before = false;
  const std::vector<Chunk> said = clause.document.chunks;
  for (std::size_t k = clause.k; k < said.size();) {
    Chunk chunk = said[k];
    clause.k = k + 1;
    if (subject == nullptr && follow_like(clause, chunks, k)) {
      k = clause.k;
      continue;
    }
    if (chunk.kind == ChunkKind::kClause && words_of(clause, chunk) == "where") return not_understood(clause, "where");
    if (chunk.kind == ChunkKind::kNoun) {
      const NounPhrase& noun = chunk.noun;
      const bool first = chunks.empty() || is_joiner(chunks.back().kind);
      const bool opens_list = subject == nullptr && chunks.empty() && noun.kind == NounKind::kObject;
      const bool own_place =
          first && k + 1 < said.size() && (said[k + 1].kind == ChunkKind::kRelation || words_of(clause, said[k + 1]) == "to");
      const bool left = comes_in(noun) || opens_list || noun.reciprocal || (noun.kind == NounKind::kPronoun && new_before);
      if (subject != nullptr && own_place && speaks_of_things(noun) && !comes_in(noun)) {
        // "…, the bed to the left wall": another thing and its place.
        clause.reserved = 1;
        LAYOUTBOX_ASSIGN(const Found found, find_things(clause, noun, true));
        clause.reserved = 0;
        about = found.things;
        remember(about);
        LAYOUTBOX_CHECK(know_noun(clause, chunk, {}));
        chunk.noun.items = about;
      } else if (!left) {
        LAYOUTBOX_CHECK(know_noun(clause, chunk, about));
      } else if (noun.kind == NounKind::kObject) {
        new_before = true;
        clause.kind = &said[k].noun;
        if (opens_list && !comes_in(noun)) chunk.noun.determiner = Determiner::kIndefinite;
      }
      chunks.push_back(std::move(chunk));
      if (chunks.size() > 1) lead_to(clause, chunks, chunks.size() - 2, about);
    } else {
      chunks.push_back(std::move(chunk));
    }
    k = clause.k;
  }
  clause.kind = nullptr;
  return chunks;
}

Status EditReader::decode(Clause& clause, std::vector<Chunk> chunks) {
  Document& document = clause.document;
  document.chunks = std::move(chunks);
  document.mentions.clear();
  document.links.clear();
  for (WordReading& reading : document.readings) reading = {reading.begin, reading.end, WordReading::Use::kIgnored, {}};
  if (!clause.earlier.empty()) {  // what "it" and what is not said may mean
    Mention mention;
    mention.noun = world_.thing(clause.earlier.front()).noun;
    mention.items = clause.earlier;
    document.mentions.push_back(std::move(mention));
  }
  read_document(lexicon_, document);
  for (const Chunk& chunk : document.chunks) {
    const WordReading& reading = document.readings[chunk.first];
    const bool lost = reading.use == WordReading::Use::kNotUnderstood ||
                      (chunk.kind == ChunkKind::kNoun && speaks_of_things(chunk.noun) && reading.use == WordReading::Use::kIgnored);
    if (lost) return not_understood(clause, words_between(document, chunk.first, chunk.last));
  }
  for (const Link& link : document.links) {
    for (const int reference : link.references) {
      const Mention& mention = document.mentions[static_cast<std::size_t>(reference)];
      if (mention.noun.kind == NounKind::kPronoun && mention.items.empty() && !mention.reciprocal)
        return fail(
            ErrorCode::kReference,
            "what \"" + words_between(document, mention.noun.first, mention.noun.last) + "\" means in \"" + clause.why + "\" is not said",
            "text", "name the thing");
    }
  }
  clause.k = document.chunks.size();
  return {};
}

Status EditReader::read_places(Clause& clause, const std::vector<int>& things, bool& any) {
  Chunk subject = clause.document.chunks[clause.subject];
  subject.noun = world_.thing(things.front()).noun;
  subject.noun.first = subject.first, subject.noun.last = subject.last;
  subject.noun.count = static_cast<int>(things.size());
  subject.noun.plural = things.size() > 1;
  subject.noun.items = things;
  LAYOUTBOX_ASSIGN(std::vector<Chunk> chunks, passage(clause, &things));
  chunks.insert(chunks.begin(), std::move(subject));
  LAYOUTBOX_CHECK(decode(clause, std::move(chunks)));
  if (clause.document.items.size() > world_.things().size()) {
    const NounPhrase& fresh = clause.document.items[world_.things().size()].noun;
    return not_understood(clause, words_between(clause.document, fresh.first, fresh.last));
  }
  if (clause.document.links.empty()) return {};
  LAYOUTBOX_ASSIGN(std::vector<Relation> relations, build(clause));
  const std::vector<std::string> own = ids(things);
  for (Relation& relation : relations) {
    const bool of_own = std::all_of(relation.targets.begin(), relation.targets.end(),
                                    [&](const auto& id) { return std::find(own.begin(), own.end(), id) != own.end(); });
    const std::vector<std::string>& targets = of_own ? own : relation.targets;
    EditStep& step = any && plan_.steps.back().targets == targets && plan_.steps.back().why == clause.why ? plan_.steps.back()
                                                                                                          : begin(EditKind::kMove, clause);
    step.targets = targets;
    step.relations.push_back(std::move(relation));
    step.kind = only_turns(step) ? EditKind::kTurn : EditKind::kMove;
    any = true;
  }
  return {};
}

Result<std::vector<Relation>> EditReader::build(Clause& clause) {
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
  const auto is_new = [&](const std::string& id) { return added_.contains(id); };
  // Of what was there before, nothing is asked but of what is spoken of: no habits, no chairs that a table is found for.
  std::set<std::string> spoken;
  for (const Mention& mention : clause.document.mentions) {
    for (const int item : mention.items) {
      if (item < static_cast<int>(world_.things().size())) spoken.insert(world_.thing(item).id);
    }
  }
  std::erase_if(scene.relations, [&](const Relation& relation) {
    if (std::any_of(relation.targets.begin(), relation.targets.end(), is_new)) return false;
    const auto unspoken = [&](const std::string& id) { return !spoken.contains(id); };
    return relation.origin == Origin::kAssumed || std::any_of(relation.targets.begin(), relation.targets.end(), unspoken);
  });
  for (Relation& relation : scene.relations) {
    // A window that was named: that one.
    for (const Mention& mention : clause.document.mentions) {
      const bool opening = mention.noun.kind == NounKind::kWindow || mention.noun.kind == NounKind::kDoor;
      if (!opening || !relation.references.empty() || (relation_row(relation.type).reference_kinds & kOpening) == 0) continue;
      const auto meant = world_.openings_of(mention.noun);
      if (meant.size() == 1) relation.references = {meant.front()->id};
    }
    relation.id.clear();
  }
  for (auto& [id, object] : added_) {
    if (const SceneObject* settled = scene.find_object(id)) object = *settled;
  }
  return std::move(scene.relations);
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
