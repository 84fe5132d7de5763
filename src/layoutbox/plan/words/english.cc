#include "layoutbox/plan/words/english.h"

#include <algorithm>
#include <array>
#include <string>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

WordForm form_of(std::string_view line) {
  if (line.empty()) return WordForm::kUnknown;
  switch (line[0]) {
    case 't': return WordForm::kThing;
    case 'c': return WordForm::kBody;
    case 'p': return WordForm::kPerson;
    case 'o': return WordForm::kRarelyThing;
    case 'n': return WordForm::kNoun;
    case 'v': return WordForm::kVerb;
    case 'a': return WordForm::kAdjective;
    case 'k': return WordForm::kUnknown;
    default: return WordForm::kAdverb;
  }
}

// A darkroom and a driveway are built, but stand in no room; a hand is somebody's.
WordForm without_places(WordForm form, std::string_view word) {
  return (form == WordForm::kThing || form == WordForm::kBody) && is_no_thing(Catalog::builtin(), word) ? WordForm::kNoun : form;
}

}  // namespace

WordForm word_form(std::string_view word) {
  if (const WordForm form = form_of(english_line(word)); form != WordForm::kUnknown) return without_places(form, word);
  for (const std::string& singular : singular_forms(word)) {
    if (const WordForm form = form_of(english_line(singular)); is_noun(form) || form == WordForm::kVerb)
      return without_places(form, singular);
  }
  for (const std::string_view ending : {"ly", "ways", "wards", "wise"}) {
    if (word.ends_with(ending)) return WordForm::kAdverb;
  }
  for (const std::string_view ending : {"ing", "ed"}) {
    if (!word.ends_with(ending) || word.size() < ending.size() + 3) continue;
    const std::string base(word.substr(0, word.size() - ending.size()));
    const std::string undoubled = base[base.size() - 1] == base[base.size() - 2] ? base.substr(0, base.size() - 1) : base;
    for (const std::string& stem : {base, base + "e", undoubled}) {
      if (form_of(english_line(stem)) == WordForm::kVerb) return WordForm::kVerb;
    }
    return WordForm::kAdjective;
  }
  return WordForm::kUnknown;
}

bool is_english(std::string_view word) {
  if (word_form(word) != WordForm::kUnknown) return true;
  const std::vector<std::string> forms = singular_forms(word);
  return std::any_of(forms.begin(), forms.end(), [](const std::string& form) { return !english_line(form).empty(); });
}

WordForm noun_form(std::string_view word) {
  for (const std::string& singular : singular_forms(word)) {
    const std::string_view line = english_line(singular);
    if (line.empty()) continue;
    const std::string_view letters = line.substr(0, line.find(' '));
    const WordForm form = form_of(letters.substr(letters.size() - 1));
    if (is_noun(form)) return without_places(form, singular);
  }
  return WordForm::kUnknown;
}

bool may_be_verb(std::string_view word) {
  const auto has_verb = [](std::string_view line) { return line.substr(0, line.find(' ')).find('v') != std::string_view::npos; };
  const std::vector<std::string> forms = singular_forms(word);
  return has_verb(english_line(word)) ||
         std::any_of(forms.begin(), forms.end(), [&](const std::string& form) { return has_verb(english_line(form)); });
}

bool is_collective(std::string_view singular) { return one_of(singular, WordSet::kCollectives); }

}  // namespace layoutbox::offline
