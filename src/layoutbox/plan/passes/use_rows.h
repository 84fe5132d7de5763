// What people do somewhere and the thing that is there for it: the rows of catalog/words_uses.json.
#pragma once

#include <optional>
#include <string_view>

#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {

// A reader of tokens that knows these rows.
class UseRows : public TokenReader {
 public:
  using TokenReader::TokenReader;

 protected:
  struct Use {
    WordList row;
    std::size_t end = 0;  // of the words that say it
    int people = 0;       // "for three friends to sit"; 0: nobody says for how many
  };

  // The tokens from `at` on that say these words, determiners and plurals aside; 0: they say something else.
  std::size_t matched(std::string_view words, std::size_t at) const;
  // The use of which most words are said there; `list`: "to", "for" or "pets".
  std::optional<Use> longest(std::string_view list, std::size_t at, int people) const;
  // What is done there: "sit", or "drop my uniform", which has its place where it is kept.
  std::optional<Use> to_do(std::size_t at, int people) const;
  // The tokens of "put", "drop", "set down" there; 0: nothing is kept.
  std::size_t keeping(std::size_t at) const;
  // The kind of room that the text names first, or empty.
  std::string_view room() const;
  // Whether what does it already (`unless`) is named anywhere outside the use itself, which begins at `first`.
  bool is_served(const Use& use, std::size_t first) const;
  // What is there for it in a room of that kind.
  static std::string_view thing_of(const Use& use, std::string_view room);

  const WordList words_ = word_list("words_uses");

 private:
  std::size_t past_quantity(std::size_t at) const;
};

}  // namespace layoutbox::offline
