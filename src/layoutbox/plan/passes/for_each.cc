#include "layoutbox/plan/passes/for_each.h"

#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

int people_before(const Lexicon& lexicon, const std::vector<Chunk>& chunks, std::size_t k) {
  constexpr std::size_t kBack = 200;  // chunks
  for (std::size_t looked = 0; k-- > 0 && looked < kBack; ++looked) {
    const NounPhrase& who = chunks[k].noun;
    const bool somebody = who.entry == nullptr && word_form(who.head) == WordForm::kPerson;
    if (chunks[k].kind != ChunkKind::kNoun || !(somebody || lexicon.is_person(who.head))) continue;
    if (who.count > 1) return who.count;
    if (who.head == "twin" || who.head == "couple") return 2;
  }
  return 0;
}

namespace {

// "a bed each", "one desk each": the chunk at k is a thing, of which everybody has as many as it says, and no thing of its sentence before
// it is there more than once, which "each" could mean.
bool is_each_ones(const std::vector<Chunk>& chunks, std::size_t k) {
  const auto is_each = [&](std::size_t c) {
    const NounPhrase& noun = chunks[c].noun;
    return chunks[c].kind == ChunkKind::kNoun && noun.kind == NounKind::kMember && noun.determiner == Determiner::kEach && !noun.of &&
           noun.last == noun.first + 1;
  };
  const NounPhrase& thing = chunks[k].noun;
  const bool anew = thing.determiner == Determiner::kIndefinite || thing.determiner == Determiner::kNone;
  if (k + 1 >= chunks.size() || !is_thing(chunks[k]) || !anew || !is_each(k + 1)) return false;
  if (k + 2 < chunks.size() && chunks[k + 2].kind == ChunkKind::kHave) return false;  // "eight tables each with four chairs"
  for (std::size_t c = k; c-- > 0 && chunks[c].kind != ChunkKind::kStop;) {
    const NounPhrase& before = chunks[c].noun;
    if (is_thing(chunks[c]) && (before.count > 1 || before.plural) && !is_each(c + 1)) return false;
  }
  return true;
}

// "a bed each", "one desk each": as many as there are people.
void count_each_ones(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  std::vector<std::size_t> each_ones;  // all are found before the first is counted: a counted one could be what "each" means
  for (std::size_t k = 0; k + 1 < chunks.size() && !is_set(document.stop); ++k) {
    if (is_each_ones(chunks, k)) each_ones.push_back(k);
  }
  for (const std::size_t k : each_ones) {
    const int people = people_before(lexicon, chunks, k);
    if (people < 2) continue;
    chunks[k].noun.count = people * std::max(chunks[k].noun.count, 1);
    chunks[k].noun.plural = true;
    chunks[k].noun.determiner = Determiner::kNone;
    chunks[k + 1].kind = ChunkKind::kIgnored;
  }
}

// How many sleep in the beds that are named.
int sleepers(const std::vector<Chunk>& chunks) {
  int sleep = 0;
  for (const Chunk& chunk : chunks) {
    if (!is_thing(chunk) || chunk.noun.entry == nullptr || !chunk.noun.entry->is(Trait::kBed)) continue;
    sleep += std::max(chunk.noun.count, chunk.noun.plural ? 2 : 1) * (chunk.noun.entry->id == "bunk_bed" ? 2 : 1);
  }
  return sleep;
}

// "for two girls: bed, desk and wardrobe for each": as many of everything that is listed.
void share_out_list(std::vector<Chunk>& chunks, std::size_t k, int people) {
  while (k-- > 0) {
    Chunk& chunk = chunks[k];
    const bool joins = chunk.kind == ChunkKind::kComma || chunk.kind == ChunkKind::kAnd || chunk.kind == ChunkKind::kIgnored;
    if (joins) continue;
    if (!is_thing(chunk)) return;
    const Determiner said = chunk.noun.determiner;
    if (chunk.noun.plural || chunk.noun.count > 1 || (said != Determiner::kNone && said != Determiner::kIndefinite)) return;
    chunk.noun.count = people;
    chunk.noun.plural = true;
    chunk.noun.determiner = Determiner::kNone;
  }
}

// "six desks with a chair for each child": at each of the desks that the sentence names.
bool sit_at_each(Document& document, std::size_t k) {
  for (std::size_t c = k; c-- > 0 && document.chunks[c].kind != ChunkKind::kStop;) {
    const NounPhrase& desks = document.chunks[c].noun;
    if (!is_thing(document.chunks[c]) || desks.entry == nullptr || !desks.entry->is(Trait::kDesk) || !desks.is_plural()) continue;
    NounPhrase& whom = document.chunks[k + 1].noun;
    const std::size_t first = whom.first, last = whom.last;
    whom = desks;
    whom.first = first, whom.last = last;
    whom.determiner = Determiner::kEach;
    whom.count = whom.rows = whom.clusters = whom.together = 0;
    whom.plural = false;
    return true;
  }
  return false;
}

// "for two girls: bed, desk and wardrobe for each": of everything that is listed as many as there are people.
void share_out_for_each(const Lexicon& lexicon, Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 1; k + 1 < chunks.size() && !is_set(document.stop); ++k) {
    const NounPhrase& whom = chunks[k + 1].noun;
    const bool person = whom.kind == NounKind::kMember || (lexicon.is_person(whom.head) && is_thing(chunks[k - 1]));
    const std::string& word = document.tokens[chunks[k].first].text;
    // "a chair for each child": of a seat it is read as a place
    const bool at_whom = chunks[k].kind == ChunkKind::kRelation && word == "at" && whom.kind != NounKind::kMember;
    const bool for_whom = (chunks[k].kind == ChunkKind::kPurpose && word == "for") || at_whom;
    const bool for_each = for_whom && chunks[k + 1].kind == ChunkKind::kNoun && person && whom.determiner == Determiner::kEach && !whom.of;
    if (at_whom && for_each && sit_at_each(document, k)) continue;
    int people = for_each ? people_before(lexicon, chunks, k) : 0;
    if (for_each && people < 2 && whom.kind != NounKind::kMember) people = sleepers(chunks);
    if (people < 2) continue;
    share_out_list(chunks, k, people);
    chunks[k].kind = chunks[k + 1].kind = ChunkKind::kIgnored;
  }
}

}  // namespace

void settle_for_each(const Lexicon& lexicon, Document& document) {
  count_each_ones(lexicon, document);
  share_out_for_each(lexicon, document);
}

}  // namespace layoutbox::offline
