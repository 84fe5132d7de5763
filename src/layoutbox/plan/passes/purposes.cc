#include "layoutbox/plan/passes/purposes.h"

#include <algorithm>
#include <string_view>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

void pass_over(Document& document, Chunk& chunk, std::string_view role) {
  chunk.kind = ChunkKind::kIgnored;
  for (std::size_t i = chunk.first; i < chunk.last; ++i) {
    document.readings[i].use = WordReading::Use::kIgnored;
    document.readings[i].role = role;
  }
}

// A person, an activity, or what stands for one ("homework", "storage"); counts of people are read elsewhere.
bool is_whom_or_what_for(const Lexicon& lexicon, const Document& document, const Chunk& chunk) {
  if (chunk.kind == ChunkKind::kUnknown || chunk.kind == ChunkKind::kParticiple || document.tokens[chunk.last - 1].text == "twins")
    return true;  // "for meditation"
  if (chunk.kind != ChunkKind::kNoun) return chunk.last == chunk.first + 1 && document.tokens[chunk.first].text.ends_with("ing");
  const NounPhrase& noun = chunk.noun;
  if (noun.count > 0) return false;
  if (noun.kind == NounKind::kAbstract) return true;
  if (noun.kind != NounKind::kObject || noun.determiner == Determiner::kDefinite) return false;
  return lexicon.is_person(noun.head) || word_form(noun.head) == WordForm::kPerson ||
         (noun.determiner == Determiner::kNone && !noun.plural && noun.name == noun.head);
}

// "a bench for waiting by the window": where the bench is.
bool is_definite_place(const Chunk& chunk) {
  return chunk.kind == ChunkKind::kNoun && chunk.noun.kind != NounKind::kAbstract && chunk.noun.kind != NounKind::kRoom &&
         chunk.noun.determiner == Determiner::kDefinite;
}

// "somewhere to hang coats and a bench": what is listed after what one does there.
bool goes_on_with_thing(const std::vector<Chunk>& chunks, std::size_t k) {
  return chunks[k].kind == ChunkKind::kAnd && k + 1 < chunks.size() && chunks[k + 1].kind == ChunkKind::kNoun &&
         chunks[k + 1].noun.kind == NounKind::kObject && chunks[k + 1].noun.exact &&
         (chunks[k + 1].noun.determiner == Determiner::kIndefinite || chunks[k + 1].noun.count > 0);
}

// "a place to fix bikes", "somewhere to watch the game": what one does there brings in nothing.
void settle_activities(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 1; k < chunks.size(); ++k) {
    const std::size_t to = chunks[k].first;
    if (document.tokens[to].text != "to" || to + 1 >= document.tokens.size()) continue;
    const std::string& before = document.tokens[to - 1].text;
    const std::string& word = document.tokens[to + 1].text;
    const bool verb = word_form(word) == WordForm::kVerb || lexicon.is(document.tokens[to + 1], WordClass::kVerb) ||
                      lexicon.is(document.tokens[to + 1], WordClass::kHang);
    // "a bench to put your boots on"
    const bool whose = to + 2 < document.tokens.size() && lexicon.is(document.tokens[to + 2], WordClass::kPossessive) &&
                       (word == "put" || word == "keep" || word == "store" || word == "hang" || word == "lay");
    if (whose) {
      for (; k < chunks.size() && chunks[k].kind != ChunkKind::kStop && chunks[k].kind != ChunkKind::kComma &&
             chunks[k].kind != ChunkKind::kAnd;
           ++k)
        pass_over(document, chunks[k], "purpose");
      continue;
    }
    if (!verb || !one_of(before, WordSet::kSomePlace)) continue;
    for (; k < chunks.size() && chunks[k].kind != ChunkKind::kStop && chunks[k].kind != ChunkKind::kComma &&
           chunks[k].kind != ChunkKind::kHave && !goes_on_with_thing(chunks, k);
         ++k)
      pass_over(document, chunks[k], "purpose");
  }
}

// "I use a power chair", "a man in a wheelchair": what somebody comes with is not part of the room.
void settle_aids(const Lexicon& lexicon, Document& document) {
  constexpr std::size_t kReach = 4;  // tokens between the person and the aid
  static constexpr std::string_view kRoom[] = {"room", "space", "place"};
  static constexpr std::string_view kWith[] = {"use", "uses", "using", "need", "needs", "in", "has", "have", "with"};
  const auto is_one_of = [](const auto& words, const Token& token) { return std::ranges::find(words, token.text) != std::end(words); };
  for (Chunk& chunk : document.chunks) {
    if (chunk.kind != ChunkKind::kNoun || chunk.noun.entry == nullptr || !chunk.noun.entry->is(Trait::kPersonalAid) || chunk.first == 0)
      continue;
    bool with = false, person = false;
    for (std::size_t i = chunk.first; i-- > 0 && chunk.first - i <= kReach && !document.tokens[i].ends_sentence;) {
      const Token& token = document.tokens[i];
      with = with || is_one_of(kWith, token);
      person =
          person || one_of(token.text, WordSet::kPersons) || lexicon.is_person(token.text) || word_form(token.text) == WordForm::kPerson;
    }
    // "keep room for a wheelchair"
    const bool room_for =
        chunk.first > 1 && document.tokens[chunk.first - 1].text == "for" && is_one_of(kRoom, document.tokens[chunk.first - 2]);
    if ((with && person) || room_for) pass_over(document, chunk, "whom it is for");
  }
}

// Not "for each desk", "for two", "for large plants".
bool is_general(const NounPhrase& noun) {
  return noun.count == 0 && noun.attributes.empty() && noun.determiner != Determiner::kEach && noun.determiner != Determiner::kBoth;
}

// "a side table for tea" stays one: what is called by more than its last word is of that kind already.
bool is_other_compound(const Lexicon& lexicon, const NounPhrase& thing, const CatalogEntry& kind) {
  const bool compound = thing.exact && thing.entry != nullptr && thing.entry != lexicon.entry_called(thing.head);
  return compound && !lexicon.catalog().is_a(kind.id, thing.entry->id);
}

// "a bed for the dog", "a bin for toys": the kind that is called after whom or what it is for.
void settle_kinds_by_purpose(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 1; k + 1 < chunks.size(); ++k) {
    Chunk& thing = chunks[k - 1];
    if (chunks[k].kind != ChunkKind::kPurpose || document.tokens[chunks[k].last - 1].text != "for" || thing.kind != ChunkKind::kNoun ||
        thing.noun.kind != NounKind::kObject || thing.last != chunks[k].first)
      continue;
    const Chunk& whom = chunks[k + 1];
    const bool noun = whom.kind == ChunkKind::kNoun;
    if ((!noun && whom.last != whom.first + 1) || (noun && !is_general(whom.noun))) continue;
    const std::string called = singular_of(document.tokens[whom.last - 1].text) + " " + thing.noun.head;
    const CatalogEntry* kind = lexicon.entry_called(called);
    if (kind == nullptr || kind == thing.noun.entry || is_other_compound(lexicon, thing.noun, *kind)) continue;
    thing.noun.entry = kind;
    thing.noun.category = kind->id;
    thing.noun.exact = true;
    if (noun && whom.noun.plural && whom.noun.kind == NounKind::kObject) continue;  // shoes may be in their rack
    pass_over(document, chunks[k], "purpose");
    pass_over(document, chunks[k + 1], "whom or what it is for");
  }
}

}  // namespace

void settle_purposes(const Lexicon& lexicon, Document& document) {
  settle_activities(lexicon, document);
  settle_aids(lexicon, document);
  settle_kinds_by_purpose(lexicon, document);
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k + 2 < chunks.size(); ++k) {
    if (chunks[k].kind != ChunkKind::kPurpose || document.tokens[chunks[k].last - 1].text != "for" ||
        !is_whom_or_what_for(lexicon, document, chunks[k + 1]))
      continue;
    const Chunk& after = chunks[k + 2];
    const std::string& word = document.tokens[after.first].text;
    const bool placed = k > 0 && chunks[k - 1].kind == ChunkKind::kNoun && chunks[k - 1].noun.kind == NounKind::kObject &&
                        after.kind == ChunkKind::kRelation && k + 3 < chunks.size() && is_definite_place(chunks[k + 3]);
    if (after.kind != ChunkKind::kHave && !placed && !(after.kind == ChunkKind::kComma && word == ":")) continue;
    pass_over(document, chunks[k], "purpose");
    pass_over(document, chunks[k + 1], "whom or what it is for");
  }
}

}  // namespace layoutbox::offline
