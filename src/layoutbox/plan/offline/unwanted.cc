// What a text wants none of.
#include "layoutbox/plan/companions.h"
#include "layoutbox/plan/offline/document.h"
#include "layoutbox/plan/offline/lexicon.h"
#include "layoutbox/plan/offline/spelling.h"

namespace layoutbox {

std::vector<std::string> kinds_unwanted(std::string_view prompt) {
  static const offline::Lexicon lexicon(Catalog::builtin());
  offline::Document document;
  document.prompt = std::string(prompt);
  document.tokens = offline::tokenize(prompt);
  offline::correct_spelling(lexicon, document.tokens);
  for (const offline::Token& token : document.tokens) document.readings.push_back({token.begin, token.end, WordReading::Use::kIgnored, {}});
  document.chunks = offline::chunk_tokens(lexicon, document.tokens);
  offline::read_document(lexicon, document);
  std::vector<std::string> kinds;
  for (const offline::NounPhrase& noun : document.excluded) {
    if (noun.entry != nullptr) kinds.push_back(noun.entry->id);
  }
  return kinds;
}

}  // namespace layoutbox
