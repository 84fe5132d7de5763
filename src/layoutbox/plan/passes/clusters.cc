#include "layoutbox/plan/passes/clusters.h"

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/words/word_sets.h"

#include <algorithm>
#include <string_view>

namespace layoutbox::offline {
namespace {

// How many stand together, the tokens that say it, and in how many such groups; 0: that is not said.
struct GroupsSaid {
  int count = 0;
  std::size_t last = 0;
  int groups = 0;
};

// "in groups of four, five groups": the groups are counted behind.
void read_groups_behind(const Lexicon& lexicon, const Document& document, GroupsSaid& together) {
  std::size_t at = together.last;
  if (says_one_of(document, at, {",", "("})) ++at;
  const NumberRead groups = read_number(lexicon, document.tokens, at);
  const std::size_t noun = at + groups.length;
  if (together.groups > 0 || groups.length == 0 || !says_one_of(document, noun, WordSet::kClusters) ||
      says_one_of(document, noun + 1, {"of"}))
    return;
  together.groups = static_cast<int>(groups.value);
  together.last = noun + (says_one_of(document, noun + 1, {")"}) ? 2 : 1);
}

// "in groups of four", "in five groups of four", "in pairs".
GroupsSaid together_at(const Lexicon& lexicon, const Document& document, std::size_t at) {
  if (says_one_of(document, at, {"arranged", "grouped", "placed", "set", "seated", "sitting", "sit", "working", "pushed", "put", "joined"}))
    ++at;
  if (says_one_of(document, at, {"together"})) ++at;
  if (!says_one_of(document, at, {"in", "into", "at"})) return {};
  GroupsSaid together;
  if (const NumberRead count = read_number(lexicon, document.tokens, at + 1);  // "in three groups of four"
      count.length > 0 && says_one_of(document, at + 1 + count.length, WordSet::kClustersOrRows)) {
    if (says_one_of(document, at + 1 + count.length, WordSet::kClusters)) together.groups = static_cast<int>(count.value);
    at += count.length;
  }
  if (says_one_of(document, at + 1, {"pairs", "twos", "couples"})) return {2, at + 2};
  if (says_one_of(document, at + 1, {"threes"})) return {3, at + 2};
  const bool sixes =
      says_one_of(document, at + 2, {"and", "or"}) && says_one_of(document, at + 3, {"sixes", "fives"});  // "in fours and sixes"
  if (says_one_of(document, at + 1, {"fours"})) return {4, at + (sixes ? 4 : 2)};
  if (says_one_of(document, at + 1, {"sixes"})) return {6, at + 2};
  if (!says_one_of(document, at + 1, WordSet::kClusters) || !says_one_of(document, at + 2, {"of"})) return {};
  const NumberRead number = read_number(lexicon, document.tokens, at + 3);
  constexpr double kMost = 12;
  if (number.length == 0 || number.value < 2 || number.value > kMost) return {};
  together.count = static_cast<int>(number.value);
  together.last = at + 3 + number.length;
  read_groups_behind(lexicon, document, together);
  return together;
}

// A room in which everybody has a desk for pupils.
bool is_class(const Lexicon& lexicon, const Document& document) {
  return std::ranges::any_of(document.chunks, [&](const Chunk& chunk) {
    const bool room = chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kRoom && chunk.noun.room != nullptr;
    const Lexicon::Set* needs = room ? lexicon.needs_in(chunk.noun.room->id) : nullptr;
    return needs != nullptr && needs->front().first->id == "school_desk";
  });
}

// "in two groups": how many of them there are, and the tokens that say it; 0: nothing of the kind.
std::pair<int, std::size_t> clusters_at(const Lexicon& lexicon, const Document& document, std::size_t at) {
  if (says_one_of(document, at, {"arranged", "grouped", "placed", "set"})) ++at;
  if (!says_one_of(document, at, {"in", "into"})) return {};
  const NumberRead count = read_number(lexicon, document.tokens, at + 1);
  const std::size_t end = at + 2 + count.length;
  if (count.length == 0 || count.value < 2 || !says_one_of(document, end - 1, WordSet::kClusters) || says_one_of(document, end, {"of"}))
    return {};
  return {static_cast<int>(count.value), end};
}

// "a cluster of four desks".
bool is_one_cluster(const Document& document, const Chunk& chunk) {
  for (std::size_t i = chunk.first; i + 1 < chunk.last; ++i) {
    if (says_one_of(document, i, {"cluster", "group", "island", "pod"}) && says_one_of(document, i + 1, {"of"})) return true;
  }
  return false;
}

// "each pair with a side table": as many tables as there are pairs.
void give_each_group(Document& document, std::size_t k, int groups) {
  std::vector<Chunk>& chunks = document.chunks;
  if (groups < 2 || k + 1 >= chunks.size() || chunks[k + 1].kind != ChunkKind::kHave) return;
  chunks[k].kind = ChunkKind::kIgnored;
  for (std::size_t c = k + 2; c < chunks.size() && (chunks[c].kind == ChunkKind::kNoun || chunks[c].kind == ChunkKind::kAnd); ++c) {
    NounPhrase& noun = chunks[c].noun;
    if (chunks[c].kind != ChunkKind::kNoun || noun.kind != NounKind::kObject) continue;
    const bool one = noun.determiner == Determiner::kIndefinite && noun.count == 0;
    if (!one && noun.count == 0) continue;
    noun.count = groups * (one ? 1 : noun.count);
    noun.determiner = Determiner::kNone;
    noun.plural = true;
  }
}

// "for 6 people": the desks are theirs.
bool counts_people(const Lexicon& lexicon, const Document& document) {
  for (std::size_t i = 0; i + 1 < document.tokens.size(); ++i) {
    const NumberRead number = read_number(lexicon, document.tokens, i);
    const std::size_t next = i + number.length;
    if (number.length > 0 && next < document.tokens.size() && lexicon.is_person(singular_of(document.tokens[next].text))) return true;
  }
  return false;
}

// How many seats each of those has: "…, each with four chairs"; 0: that is not said.
NounPhrase* seats_of_each(const Lexicon& lexicon, Document& document, std::size_t k) {
  std::vector<Chunk>& chunks = document.chunks;
  std::size_t at = k + 1;
  if (at < chunks.size() && chunks[at].kind == ChunkKind::kComma) ++at;
  if (at + 2 >= chunks.size() || chunks[at].kind != ChunkKind::kNoun || chunks[at + 1].kind != ChunkKind::kHave) return nullptr;
  NounPhrase& seats = chunks[at + 2].noun;
  const bool each = chunks[at].last == chunks[at].first + 1 && says_one_of(document, chunks[at].first, {"each"});
  return each && chunks[at + 2].kind == ChunkKind::kNoun && is_seat(lexicon.catalog(), seats) && seats.count > 1 ? &seats : nullptr;
}

// "Three islands of desks": each has a desk for each of its chairs, or as many as mostly stand together.
void count_in_clusters(const Lexicon& lexicon, Document& document, std::size_t k) {
  constexpr int kDesks = 4, kOthers = 3;
  NounPhrase& noun = document.chunks[k].noun;
  if (noun.count > 0 || noun.clusters < 2 || counts_people(lexicon, document)) return;
  NounPhrase* seats = seats_of_each(lexicon, document, k);
  const int own = seats != nullptr ? seats->count : one_of(noun.head, WordSet::kDesks) ? kDesks : kOthers;
  noun.count = noun.clusters * own;
  if (seats == nullptr) return;
  seats->count = 1;
  seats->plural = false;
}

// Puts so many of them together, in so many groups where that is said.
void put_together(const Lexicon& lexicon, const Document& document, NounPhrase& noun, int together, int in_groups) {
  // "tables in groups of four", of which nobody says how many: tables at which so many sit, as a class does at desks put together.
  const bool desks = noun.head == "desk" && is_class(lexicon, document);
  const bool shared = (noun.head == "table" || desks) && noun.count == 0 && together > 2;
  (shared ? noun.seats : noun.together) = together;
  if (in_groups > 1 && noun.count == 0) noun.count = shared ? in_groups : in_groups * together;
  constexpr int kGroups = 4;  // of a class of which nobody says how many they are
  if (shared && desks && noun.count == 0 && document.people == 0 && !counts_people(lexicon, document)) noun.count = kGroups;
  if (const CatalogEntry* table = lexicon.catalog().find("table"); shared && desks && table != nullptr)
    noun.entry = table, noun.category = table->id;
}

}  // namespace

int people_together(const Lexicon& lexicon, const Document& document) {
  for (std::size_t i = 1; i < document.tokens.size(); ++i) {
    if (!lexicon.is_person(singular_of(document.tokens[i - 1].text))) continue;
    if (const int together = together_at(lexicon, document, i).count; together > 0) return together;
  }
  return 0;
}

void settle_clusters(const Lexicon& lexicon, Document& document) {
  const NounPhrase* grouped = nullptr;
  for (Chunk& chunk : document.chunks) {
    if (chunk.kind != ChunkKind::kNoun) continue;
    NounPhrase& noun = chunk.noun;
    const bool names_group = one_of(noun.head, {"group", "cluster", "pair"});
    if (grouped != nullptr && names_group && noun.determiner == Determiner::kEach && grouped->together > 0) {
      give_each_group(document, static_cast<std::size_t>(&chunk - document.chunks.data()), grouped->count / grouped->together);
      continue;
    }
    const bool groups = noun.determiner == Determiner::kDefinite && names_group;
    if (grouped != nullptr && groups && !noun.of) {  // "plants between the groups"
      const NounPhrase said = noun;
      noun = *grouped;
      noun.apart = grouped->together;
      noun.determiner = Determiner::kDefinite;
      noun.count = noun.together = 0;
      noun.first = said.first;
      noun.last = said.last;
      continue;
    }
    if (noun.kind != NounKind::kObject || !noun.is_plural()) continue;
    if (noun.clusters == 0 && is_one_cluster(document, chunk)) noun.clusters = 1;
    count_in_clusters(lexicon, document, static_cast<std::size_t>(&chunk - document.chunks.data()));
    if (const auto [clusters, last] = clusters_at(lexicon, document, chunk.last); clusters > 0) {
      noun.clusters = clusters;
      grouped = &noun;
      take_chunks(document, chunk.last, last, "together");
      continue;
    }
    const bool stacked = says_one_of(document, chunk.last, {"stacked", "piled"});
    const auto [together, end, in_groups] = together_at(lexicon, document, stacked ? chunk.last + 1 : chunk.last);
    if (together == 0) continue;
    if (stacked) noun.attributes.emplace_back("stacked");  // "dryers stacked in pairs"
    put_together(lexicon, document, noun, together, in_groups);
    grouped = &noun;
    take_chunks(document, chunk.last, end, "together");
  }
}

void settle_grid_counts(Document& document) {
  constexpr int kMost = 200;
  NounPhrase* things = nullptr;
  for (Chunk& chunk : document.chunks) {
    if (chunk.kind == ChunkKind::kStop) things = nullptr;
    if (is_thing(chunk)) things = &chunk.noun;
    if (things == nullptr || chunk.rows <= 0) continue;
    const bool for_some = std::ranges::any_of(document.chunks, [](const Chunk& c) { return c.kind == ChunkKind::kPurpose; });
    if (chunk.columns <= 0 && !for_some && chunk.rows <= kMost && things->plural && things->count == 0 &&
        things->determiner == Determiner::kNone && chunk.rows > 1) {  // "pews in three rows": two or more in each
      things->count = 2 * chunk.rows;
      things->vague = true;
    }
    if (chunk.columns <= 0) continue;
    const bool uncounted = things->plural && things->count == 0 && things->determiner == Determiner::kNone;
    if (uncounted && chunk.rows <= kMost && chunk.columns <= kMost) things->count = std::min(chunk.rows * chunk.columns, kMost);
  }
}

}  // namespace layoutbox::offline
