#include "layoutbox/plan/offline/forward_counts.h"

#include <algorithm>

namespace layoutbox::offline {

namespace {

bool is_thing(const Chunk& chunk) { return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kObject; }

// "table" and "round table", "bed" and "bed"; no "table lamp".
bool is_same(const NounPhrase& one, const NounPhrase& other) {
  const auto ends = [](const std::string& name, const std::string& word) { return name == word || name.ends_with(" " + word); };
  return ends(one.name, other.name) || ends(other.name, one.name);
}

// "… the tables, five of them", "the chairs, two in number": how many, behind the noun at k; 0: not said.
int count_behind(const std::vector<Chunk>& chunks, std::size_t k) {
  if (k + 2 >= chunks.size() || chunks[k + 1].kind != ChunkKind::kComma || chunks[k + 2].kind != ChunkKind::kNoun) return 0;
  const NounPhrase& count = chunks[k + 2].noun;
  return count.kind == NounKind::kMember && count.attributes.empty() && !count.of ? count.count : 0;
}

// Four of it lie on a table, and look like many.
bool is_small(const NounPhrase& noun) {
  constexpr Mm kSmall = 350;
  return noun.entry != nullptr && std::max(noun.entry->size.usual.width, noun.entry->size.usual.depth) <= kSmall;
}

bool has_filling_word(const Lexicon& lexicon, const Document& document, const Chunk& chunk) {
  for (std::size_t t = chunk.first; t < chunk.last; ++t) {
    if (lexicon.is_in("filling", document.tokens[t].text)) return true;
  }
  return false;
}

bool is_all_over(const Document& document, std::size_t token) {
  return token + 1 < document.tokens.size() && document.tokens[token].text == "all" && document.tokens[token + 1].text == "over";
}

}  // namespace

void settle_filling_counts(const Lexicon& lexicon, Document& document) {
  constexpr int kMany = 4;  // as "many" has it (words_grammar.json)
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size() && !is_set(document.stop); ++k) {
    NounPhrase& noun = chunks[k].noun;
    const bool bare = is_thing(chunks[k]) && noun.plural && noun.count == 0 && noun.determiner == Determiner::kNone && is_small(noun);
    if (!bare) continue;
    const bool filling = k > 0 && has_filling_word(lexicon, document, chunks[k - 1]);
    if (!filling && !is_all_over(document, chunks[k].last)) continue;
    noun.count = kMany;
    noun.vague = noun.at_least = true;
  }
}

void settle_forward_counts(Document& document) {
  constexpr std::size_t kReach = 200;  // chunks that are looked at either way
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size() && !is_set(document.stop); ++k) {
    if (!is_thing(chunks[k])) continue;
    NounPhrase& each = chunks[k].noun;
    const bool either = each.determiner == Determiner::kBoth && document.tokens[each.first].text == "either";
    if ((each.determiner != Determiner::kEach && !either) || each.count > 0) continue;
    const auto speaks_of = [&](std::size_t c) { return is_thing(chunks[c]) && is_same(chunks[c].noun, each); };
    bool named = false;
    for (std::size_t c = k; c-- > 0 && c + kReach > k && !named;) {
      if (!speaks_of(c)) continue;
      named = true;  // "a lamp per bed and a chest at the foot of each bed": as many as those
      if (chunks[c].noun.determiner == Determiner::kEach) each.count = chunks[c].noun.count;
    }
    for (std::size_t c = k + 1; c < chunks.size() && c < k + kReach && !named; ++c) {
      if (!speaks_of(c) || chunks[c].noun.determiner == Determiner::kEach) continue;
      NounPhrase& all = chunks[c].noun;
      const int behind = all.plural && all.count == 0 ? count_behind(chunks, c) : 0;
      const int count = std::max(all.count, behind);
      if (count > 1) {
        each.count = count;
        if (either) each.determiner = Determiner::kEach;
        all.count = count;
        all.determiner = Determiner::kDefinite;
      }
      break;
    }
  }
}

}  // namespace layoutbox::offline
