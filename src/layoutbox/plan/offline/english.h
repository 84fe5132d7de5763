// What is known of English words outside the catalogue: their form, and which kind of thing a noun is.
#pragma once

#include <string_view>

#include "layoutbox/catalog/catalog.h"

namespace layoutbox::offline {

enum class WordForm { kUnknown, kThing, kNoun, kVerb, kAdjective, kAdverb };

// What a lower-case word mostly is; a noun that is no physical thing is kNoun. Plurals and inflected verbs are known by their base.
WordForm word_form(std::string_view word);

// The catalogue entry that an unknown noun is a kind of, or null.
const CatalogEntry* known_kind(const Catalog& catalog, std::string_view noun);

// "items", "essentials", "supplies": nouns that stand for things when something holds them.
bool is_collective(std::string_view singular);

}  // namespace layoutbox::offline
