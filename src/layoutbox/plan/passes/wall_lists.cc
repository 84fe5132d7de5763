#include "layoutbox/plan/passes/wall_lists.h"

#include <utility>

#include "layoutbox/plan/phrases/splice.h"

namespace layoutbox::offline {

namespace {

// "Along one wall a bench; against another a wardrobe": against another wall.
void name_other_walls(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  constexpr std::size_t kReach = 60;  // tokens
  const std::vector<Token>& tokens = document.tokens;
  std::vector<Splice> walls;
  std::size_t one = tokens.size();  // where "one wall" was spoken of last
  for (std::size_t i = 1; i + 2 < tokens.size() && !is_set(document.stop); ++i) {
    if (says_one_of(document, i, {"one", "a"}) && says_one_of(document, i + 1, {"wall"})) one = i;
    if (one > i || i - one > kReach || !says_one_of(document, i - 1, {"against", "along"})) continue;
    const std::size_t next = i + (says_one_of(document, i, {"the"}) ? 2 : 1);
    if (!says_one_of(document, next - 1, {"another", "other"})) continue;
    const Token& after = tokens[next];
    const bool alone = after.kind != Token::Kind::kWord || lexicon.is(after, WordClass::kIndefinite) ||
                       lexicon.is(after, WordClass::kNumber) || lexicon.is(after, WordClass::kBe) ||
                       lexicon.is(after, WordClass::kPlaceVerb);
    if (!alone) continue;
    Token word = tokens[next - 1];
    word.text = "wall";
    word.ends_sentence = false;
    walls.push_back({next, std::move(word)});
  }
  splice(document, skip, std::move(walls));
}

}  // namespace

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
  name_other_walls(lexicon, document, skip);
}

}  // namespace layoutbox::offline
