#include "layoutbox/plan/offline/wall_lists.h"

#include <utility>

#include "layoutbox/plan/offline/splice.h"

namespace layoutbox::offline {

void complete_wall_lists(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  const std::vector<Token>& tokens = document.tokens;
  const auto side_at = [&](std::size_t at) {
    return at < tokens.size() && !skip[at] ? lexicon.find(tokens, at, WordClass::kWallWord).length : std::size_t{0};
  };
  std::vector<Splice> walls;
  for (std::size_t i = 1; i + 2 < tokens.size() && !is_set(document.stop); ++i) {
    const std::size_t first = side_at(i), joiner = i + first;
    if (first == 0 || !says_one_of(document, joiner, {"and"})) continue;
    const std::size_t article = says_one_of(document, joiner + 1, {"the"}) ? 1 : 0;
    const std::size_t second = joiner + 1 + article, length = side_at(second);
    const std::size_t wall = second + length;
    // "the left and right walls" is one phrase to the reader.
    const bool shared =
        length > 0 && (article > 0 ? says_one_of(document, wall, {"wall", "walls"}) : says_one_of(document, wall, {"wall"}));
    if (!shared) continue;
    Token word = tokens[wall];
    word.text = "wall";
    word.ends_sentence = false;
    walls.push_back({joiner, std::move(word)});
    i = wall;
  }
  splice(document, skip, std::move(walls));
}

}  // namespace layoutbox::offline
