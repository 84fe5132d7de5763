// What things are by what is named beside them.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/people.h"
#include "layoutbox/plan/phrases/knowledge.h"

namespace layoutbox::offline {
namespace {

bool names_thing(const Chunk& chunk) {
  return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kObject && chunk.noun.entry != nullptr;
}

// The noun that is said to have what the chunk at `k` names, in a list or alone; null: none.
NounPhrase* owner_of(std::vector<Chunk>& chunks, std::size_t k) {
  bool has = false;
  for (std::size_t i = k; i-- > 0;) {
    Chunk& chunk = chunks[i];
    if (chunk.kind == ChunkKind::kHave) {
      has = true;
    } else if (chunk.kind == ChunkKind::kNoun && has) {
      return names_thing(chunk) ? &chunk.noun : nullptr;
    } else if (chunk.kind != ChunkKind::kNoun && chunk.kind != ChunkKind::kIgnored && chunk.kind != ChunkKind::kAnd) {
      return nullptr;
    }
  }
  return nullptr;
}

// "chairs for patients", "two chairs in front of the desk for the owners": whose a thing is, by the word behind "for" in its item of a
// list; empty: nobody's.
std::string user_of(const Lexicon& lexicon, const Document& document, std::size_t k) {
  constexpr std::size_t kNearby = 3, kPlace = 7;
  const std::vector<Token>& tokens = document.tokens;
  std::size_t at = document.chunks[k].last;
  if (at == 0 || tokens[at - 1].ends_sentence) return {};
  const std::size_t most = std::min(tokens.size(), at + kPlace);
  const auto ends = [&](std::size_t i) {
    return tokens[i].ends_sentence || tokens[i].kind == Token::Kind::kPunctuation || lexicon.is(tokens[i], WordClass::kAnd);
  };
  while (at < most && tokens[at].text != "for" && !ends(at)) ++at;
  if (at >= most || tokens[at].text != "for" || at + 1 >= tokens.size()) return {};
  for (std::size_t t = at + 1; t < std::min(tokens.size(), at + 1 + kNearby); ++t) {
    std::string word = singular_of(tokens[t].text);
    if (!kinds_for(word).empty()) return word;
  }
  return {};
}

// Where tables are named and no desk, who comes eats.
bool dines(const std::vector<Chunk>& chunks) {
  const auto names = [&](Trait trait) {
    return std::ranges::any_of(chunks, [&](const Chunk& chunk) { return names_thing(chunk) && chunk.noun.entry->is(trait); });
  };
  return names(Trait::kTable) && !names(Trait::kDeskLike);
}

}  // namespace

void settle_company(const Lexicon& lexicon, Document& document) {
  const Catalog& catalog = lexicon.catalog();
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    if (!names_thing(chunks[k])) continue;
    NounPhrase& noun = chunks[k].noun;
    NounPhrase* owner = owner_of(chunks, k);
    const std::size_t place = k + 1;  // "a shelf above it" is none
    const bool elsewhere = place < chunks.size() && chunks[place].kind == ChunkKind::kRelation &&
                           chunks[place].last < document.tokens.size() && !one_of(document.tokens[chunks[place].first].text, {"in"}) &&
                           (document.tokens[chunks[place].last].text == "it" || document.tokens[chunks[place].last - 1].text == "it");
    if (owner != nullptr && !elsewhere && is_own_part(catalog, owner->entry->id, noun.entry->id)) {
      noun.kind = NounKind::kPart;
      continue;
    }
    // "a basin with a vanity": one thing, which has the other
    if (owner != nullptr && !elsewhere && is_own_part(catalog, noun.entry->id, owner->entry->id) &&
        catalog.is_a(noun.entry->id, owner->entry->id)) {
      owner->entry = noun.entry;
      owner->category = noun.category;
      noun.kind = NounKind::kPart;
      continue;
    }
    if (const std::string user = user_of(lexicon, document, k); !user.empty() && !dines(chunks)) {
      const CatalogEntry* kind = catalog.find(std::string(kinds_for(user)));
      if (kind != nullptr && noun.name == noun.head && catalog.is_a(kind->id, noun.entry->id)) noun.entry = kind, noun.category = kind->id;
    }
    for (const auto& [other, becomes] : kinds_in_company(noun.entry->id)) {
      const std::string kind(other);
      const auto is_there = [&](const Chunk& c) { return &c.noun != &noun && names_thing(c) && catalog.is_a(c.noun.entry->id, kind); };
      const CatalogEntry* entry = catalog.find(std::string(becomes));
      if (entry == nullptr || std::ranges::none_of(chunks, is_there)) continue;
      noun.entry = entry;
      noun.category = entry->id;
      break;
    }
  }
}

}  // namespace layoutbox::offline
