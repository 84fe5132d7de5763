// What readers that rewrite tokens before phrases are looked for have in common (requests, wordings).
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "layoutbox/plan/words/lexicon.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

class TokenReader {
 public:
  using Words = std::initializer_list<std::string_view>;

  TokenReader(const Lexicon& lexicon, std::vector<Token>& tokens, std::vector<bool>& skip)
      : lexicon_(lexicon), tokens_(tokens), skip_(skip) {}

 protected:
  // One of these words stands there.
  bool is(std::size_t at, Words words) const {
    return at < tokens_.size() && std::ranges::find(words, std::string_view(tokens_[at].text)) != words.end();
  }
  bool is(std::size_t at, WordSet set) const { return at < tokens_.size() && one_of(tokens_[at].text, set); }
  // Past a few words of the set: more in a row are no sentence, and would be looked at again from each of them.
  std::size_t past(std::size_t at, WordSet set) const {
    constexpr std::size_t kMost = 8;
    for (std::size_t n = 0; n < kMost && is(at, set); ++n) ++at;
    return at;
  }
  // All of them do, one after the other.
  bool are(std::size_t at, Words words) const { return stand_at(tokens_, at, words); }
  // An article, "my", or a number.
  bool is_article(std::size_t at) const {
    return at < tokens_.size() && (lexicon_.is(tokens_[at], WordClass::kIndefinite) || lexicon_.is(tokens_[at], WordClass::kDefinite) ||
                                   lexicon_.is(tokens_[at], WordClass::kPossessive) || lexicon_.is(tokens_[at], WordClass::kNumber) ||
                                   tokens_[at].kind == Token::Kind::kNumber);
  }
  bool ends(std::size_t at) const { return at >= tokens_.size() || tokens_[at].kind == Token::Kind::kPunctuation; }
  bool begins(std::size_t at) const { return at == 0 || tokens_[at - 1].ends_sentence; }
  // A thing that is named with its article or number and what it is like: the first word, where its name begins, the last word of that,
  // where it ends, and what it is.
  struct NamedThing {
    std::size_t first = 0, name = 0, noun = 0, last = 0;
    const CatalogEntry* entry = nullptr;
  };
  // What is named from `at` on; of "a glass table" the table.
  std::optional<NamedThing> thing_named_at(std::size_t at) const;
  void leave_out(std::size_t first, std::size_t last) {
    std::fill(skip_.begin() + static_cast<std::ptrdiff_t>(first), skip_.begin() + static_cast<std::ptrdiff_t>(last), true);
  }

  const Lexicon& lexicon_;
  std::vector<Token>& tokens_;
  std::vector<bool>& skip_;
};

}  // namespace layoutbox::offline
