// The rows of catalog/words_wordings.json: words of a text and the plain ones that are read instead.
#pragma once

#include <string_view>
#include <vector>

#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {

// One element of a row: what may stand there, how often, and what becomes of it.
struct WordingElement {
  enum class Class {
    kNone,
    kArticle,
    kNumber,
    kDefinite,
    kObject,
    kRoom,
    kWindow,
    kUnit,
    kPerson,
    kScreen,
    kColor,
    kLook,
    kWord,
    kPlain,
    kBegin,
    kEnd
  };
  enum class Look { kHere, kNot, kAfter, kAfterNot };  // there; not there; before it; not before it. All but the first take no token

  Class kind = Class::kNone;
  std::vector<std::string_view> words;  // where it is no class
  std::string_view becomes;             // read instead; empty: as it stands
  Look look = Look::kHere;
  int least = 1, most = 1;
  bool left_out = false;
};

struct Wording {
  std::string_view name;
  std::vector<std::vector<WordingElement>> says;  // one or the other
  std::vector<std::string_view> only_with, unless;
  std::string_view example, plain;
};

// All rows, in the order of the file.
const std::vector<Wording>& wordings();

// Reads all rows in `tokens`: their words are replaced, those that say nothing are marked in `skip`.
void read_wording_table(const Lexicon& lexicon, std::vector<Token>& tokens, std::vector<bool>& skip);

}  // namespace layoutbox::offline
