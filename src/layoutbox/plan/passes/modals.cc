#include "layoutbox/plan/passes/modals.h"

#include <string>

#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {
namespace {

class ModalReader : public TokenReader {
 public:
  using TokenReader::TokenReader;

  void run() {
    for (std::size_t i = 1; i + 2 < tokens_.size(); ++i) {
      if (!skip_[i] && !lexicon_.is(tokens_[i - 1], WordClass::kDoer)) read(i);
    }
  }

 private:
  void read(std::size_t modal) {
    std::size_t verb = modal;
    if (is(modal, WordSet::kModals)) {
      verb = modal + 1;
    } else if (is(modal, WordSet::kModalsWithTo) && is(modal + 1, {"to"})) {
      verb = modal + 2;
    }
    while (verb > modal && verb + 1 < tokens_.size() && lexicon_.is(tokens_[verb], WordClass::kAdverb)) ++verb;
    if (verb == modal || verb + 1 >= tokens_.size() || !is_article(verb + 1)) return;
    const std::string present = present_of(tokens_[verb].text);
    if (has_or_places(tokens_[verb].text) || !has_or_places(present)) return;
    tokens_[verb].text = present;
    leave_out(modal, verb);
  }

  // "carries", "supports"
  static std::string present_of(const std::string& verb) {
    return verb.ends_with("y") ? verb.substr(0, verb.size() - 1) + "ies" : verb + "s";
  }

  bool has_or_places(const std::string& word) const {
    const Token token = word_token(word);
    return lexicon_.is(token, WordClass::kHave) || lexicon_.senses_of(word) != nullptr || one_of(word, WordSet::kHaving);
  }
};

}  // namespace

void read_modals(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { ModalReader(lexicon, document.tokens, skip).run(); }

}  // namespace layoutbox::offline
