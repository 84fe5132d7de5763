#include "layoutbox/plan/passes/second_roles.h"

#include <algorithm>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

const CatalogEntry* object_of(const Match& match) {
  const Meaning* meaning = match.length == 0 ? nullptr : meaning_of(match, WordClass::kObject);
  return meaning == nullptr ? nullptr : meaning->entry;
}

// The object whose name ends right before `end`.
const CatalogEntry* object_before(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t end) {
  constexpr std::size_t kLongest = 3;
  for (std::size_t length = std::min(kLongest, end); length > 0; --length) {
    const Match match = lexicon.find(tokens, end - length, WordClass::kObject);
    if (match.length == length) return object_of(match);
  }
  return nullptr;
}

// "is also the", "folds out into a", "can be used as a": where the second name begins; 0: nothing of the kind.
std::size_t role_begins(const Document& document, std::size_t i) {
  constexpr std::size_t kLongest = 6;
  bool says_role = false;
  std::size_t at = i;
  for (; at < i + kLongest; ++at) {
    const bool verb = says_one_of(document, at, WordSet::kRoleVerbs);
    if (!verb && !says_one_of(document, at, WordSet::kRoleFillers)) break;
    says_role |= verb;
  }
  return says_role ? at : 0;
}

}  // namespace

void read_second_roles(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Token>& tokens = document.tokens;
  for (std::size_t that = 1; that < tokens.size(); ++that) {
    if (skip[that] || !says_one_of(document, that, {"that", "which"})) continue;
    const std::size_t first = role_begins(document, that + 1);
    const Match second = first == 0 ? Match{} : lexicon.find(tokens, first, WordClass::kObject);
    const CatalogEntry *is = object_before(lexicon, tokens, that), *also = object_of(second);
    if (is == nullptr || also == nullptr) continue;
    const Catalog& catalog = lexicon.catalog();
    const bool one = catalog.find(is->id + "_" + also->id) != nullptr, other = catalog.find(also->id + "_" + is->id) != nullptr;
    std::size_t kept = that;
    if (one || other) {
      tokens[that - 1].text = one ? is->name : also->name;
      tokens[that].text = one ? also->name : is->name;
      ++kept;
    }
    for (std::size_t n = kept; n < first + second.length; ++n) {
      skip[n] = true;
      document.readings[n].role = "what else it is";
    }
  }
}

}  // namespace layoutbox::offline
