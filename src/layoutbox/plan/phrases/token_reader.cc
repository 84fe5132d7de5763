#include "layoutbox/plan/phrases/token_reader.h"

#include "layoutbox/plan/phrases/noun_phrase_parts.h"

namespace layoutbox::offline {

std::optional<TokenReader::NamedThing> TokenReader::thing_named_at(std::size_t at) const {
  constexpr std::size_t kMostAdjectives = 3;
  const std::size_t begin = at + (is_article(at) ? 1 : 0);
  for (std::size_t i = begin; i <= begin + kMostAdjectives && !ends(i); ++i) {
    const Match match = lexicon_.find(tokens_, i);
    const bool made_of = attribute_of(match) != nullptr && meaning_of(lexicon_.find(tokens_, i + 1), WordClass::kObject) != nullptr;
    const Meaning* thing = meaning_of(match, WordClass::kObject);
    if (thing != nullptr && !made_of) return NamedThing{at, i, i + match.length - 1, i + match.length, thing->entry};
    if (attribute_of(match) == nullptr && (match.length > 0 || lexicon_.find_phrase(tokens_, i).length > 0)) break;
  }
  return std::nullopt;
}

}  // namespace layoutbox::offline
