#include "layoutbox/plan/passes/absent.h"

#include <algorithm>
#include <string_view>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox::offline {

namespace {

class AbsentReader {
 public:
  AbsentReader(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), document_(document), tokens_(document.tokens) {}

  void run() {
    const WordList grammar = word_list("words_grammar");
    const WordList absent = grammar.at("absent"), replaced = grammar.at("replaced"), yet = grammar.at("absent_yet");
    bool for_now = false;
    for (std::size_t i = 0; i < tokens_.size() && !for_now; ++i) for_now = match(grammar.at("for_now"), i) > 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (const std::size_t length = match(replaced, i); length > 0) {
        pass_over(clause_begins(i), i + length);
        continue;
      }
      const std::size_t length = std::max(match(absent, i), for_now ? match(yet, i) : 0);
      if (length == 0 || is_outside_thing(i + length)) continue;
      const std::size_t first = clause_begins(i);
      std::size_t end = i + length;
      if (first == i && end < tokens_.size() && tokens_[end].text == ",") ++end;            // "eventually, …"
      const bool heading = first == i && end < tokens_.size() && tokens_[end].text == ":";  // "Not wanted: a television, a rug"
      while (heading && end < tokens_.size() && !tokens_[end].ends_sentence) ++end;
      pass_over(first, heading ? end : clause_ends(end));
    }
  }

 private:
  // How many tokens from `at` are one of these phrases, of which a word may be one of several: "is|are gone".
  std::size_t match(const WordList& phrases, std::size_t at) const {
    for (const WordList::Member phrase : phrases) {
      std::string_view rest = phrase.value.text();
      std::size_t i = at;
      while (!rest.empty() && i < tokens_.size()) {
        const std::string_view word = rest.substr(0, rest.find(' '));
        if (!is_one_of(tokens_[i].text, word)) break;
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
        ++i;
      }
      if (rest.empty()) return i - at;
    }
    return 0;
  }

  // `words`: "is|are"
  static bool is_one_of(std::string_view token, std::string_view words) {
    for (std::size_t at = words.find(token); at != std::string_view::npos; at = words.find(token, at + 1)) {
      const std::size_t end = at + token.size();
      if ((at == 0 || words[at - 1] == '|') && (end == words.size() || words[end] == '|')) return true;
    }
    return false;
  }

  // "Four blocks are outside the toy box": out of a thing that is in the room, and so in the room.
  bool is_outside_thing(std::size_t end) const {
    if (tokens_[end - 1].text != "outside") return false;
    return std::ranges::any_of(document_.chunks, [&](const Chunk& chunk) {
      const std::size_t of = end < tokens_.size() && tokens_[end].text == "of" ? end + 1 : end;
      return chunk.kind == ChunkKind::kNoun && chunk.first == of && chunk.noun.kind == NounKind::kObject;
    });
  }

  bool is_break(std::size_t i) const {
    static constexpr std::string_view kNow[] = {"now", "today", "instead"};
    const Token& token = tokens_[i];
    return token.ends_sentence || token.text == ":" || lexicon_.is(token, WordClass::kClause) ||
           std::ranges::find(kNow, token.text) != std::end(kNow);
  }

  // "…, and the printer comes later": a comma or "and" before who or what it is said of.
  std::size_t clause_begins(std::size_t at) const {
    for (std::size_t i = at; i-- > 0;) {
      if (is_break(i)) return i + 1;
      const bool joins = tokens_[i].text == "," || lexicon_.is(tokens_[i], WordClass::kAnd);
      const Token& next = tokens_[i + 1];
      // "a desk, printer: none", "two chairs, TV not needed"
      constexpr std::size_t kName = 4;
      const bool one = tokens_[i].text == "," && at - i <= kName && tokens_[at].text != "are" && tokens_[at].text != "were" &&
                       tokens_[at].text != "have";
      const bool listed = tokens_[at].kind == Token::Kind::kPunctuation || one;
      if (joins && (listed || i + 1 == at || lexicon_.is(next, WordClass::kDefinite) || lexicon_.is(next, WordClass::kPossessive) ||
                    lexicon_.is(next, WordClass::kDoer)))
        return i + 1;
    }
    return 0;
  }

  std::size_t clause_ends(std::size_t at) const {
    while (at < tokens_.size() && !is_break(at) && tokens_[at].text != ",") ++at;
    return at;
  }

  void pass_over(std::size_t first, std::size_t last) {
    for (Chunk& chunk : document_.chunks) {
      if (chunk.first < first || chunk.first >= last || chunk.kind == ChunkKind::kStop) continue;
      if (chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kRoom) continue;
      if (chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kObject) document_.excluded.push_back(chunk.noun);
      chunk.kind = ChunkKind::kIgnored;
      for (std::size_t i = chunk.first; i < chunk.last; ++i)
        document_.readings[i] = {document_.readings[i].begin, document_.readings[i].end, WordReading::Use::kUsed, "not there"};
    }
  }

  const Lexicon& lexicon_;
  Document& document_;
  const std::vector<Token>& tokens_;
};

}  // namespace

void settle_absent(const Lexicon& lexicon, Document& document) { AbsentReader(lexicon, document).run(); }

}  // namespace layoutbox::offline
