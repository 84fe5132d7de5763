// What is known of English words outside the catalogue: their form, and which kind of thing a noun is.
#pragma once

#include <string_view>

namespace layoutbox::offline {

enum class WordForm {
  kUnknown,
  kThing,
  kBody,  // an animal, a stone, a plant: a thing where it is named or counted
  kPerson,
  kRarelyThing,  // a noun that is a thing in a rarer sense ("case")
  kNoun,         // no physical thing
  kVerb,
  kAdjective,
  kAdverb,
};

constexpr bool is_noun(WordForm form) {
  return form == WordForm::kThing || form == WordForm::kBody || form == WordForm::kPerson || form == WordForm::kRarelyThing ||
         form == WordForm::kNoun;
}

// Whether English has the word or its base, rare ones too.
bool is_english(std::string_view word);

// What a lower-case word mostly is. Plurals and inflected verbs are known by their base.
WordForm word_form(std::string_view word);

// What it is as a noun, even where it mostly is a verb or an adjective ("a cross"); kUnknown where it is none or not known.
WordForm noun_form(std::string_view word);

// Whether it is a verb among other things ("throw", "bears").
bool may_be_verb(std::string_view word);

// "items", "essentials", "supplies": nouns that stand for things when something holds them.
bool is_collective(std::string_view singular);

}  // namespace layoutbox::offline
