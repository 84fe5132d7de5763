#include "layoutbox/plan/passes/agents.h"

#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {
namespace {

class AgentReader : public TokenReader {
 public:
  AgentReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : TokenReader(lexicon, document.tokens, skip), document_(document) {}

  void run() {
    for (std::size_t i = 1; i + 1 < tokens_.size(); ++i) {
      const bool new_thing = is_article(i + 1) && !lexicon_.is(tokens_[i + 1], WordClass::kDefinite);  // "and by the window" is a place
      if (is(i, {"by"}) && lexicon_.is(tokens_[i - 1], WordClass::kAnd) && new_thing) say_again(i);
    }
    splice(document_, skip_, std::move(said_again_));
  }

 private:
  // What stands before "by" earlier in the sentence, where it has one place in front: "flanked", "surrounded".
  void say_again(std::size_t by) {
    constexpr std::size_t kReach = 30;  // tokens
    for (std::size_t i = by - 1; i-- > 0 && i + kReach > by && !tokens_[i].ends_sentence;) {
      const PhraseMatch phrase = lexicon_.find_phrase(tokens_, i);
      if (phrase.length != 2 || !is(i + 1, {"by"}) || !has_direction(*phrase.senses, Direction::kInverse)) continue;
      said_again_.push_back({by, word_token(tokens_[i].text)});
      return;
    }
  }

  Document& document_;
  std::vector<Splice> said_again_;
};

}  // namespace

void read_agents(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { AgentReader(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
