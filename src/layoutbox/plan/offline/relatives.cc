#include "layoutbox/plan/offline/relatives.h"

#include <algorithm>

#include "layoutbox/plan/offline/english.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/splice.h"

namespace layoutbox::offline {
namespace {

class RelativeParter {
 public:
  RelativeParter(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : lexicon_(lexicon), document_(document), tokens_(document.tokens), readings_(document.readings), skip_(skip) {}

  void run() {
    std::size_t begin = 0;
    for (std::size_t i = 1; i + 2 < tokens_.size(); ++i) {
      if (tokens_[i].ends_sentence || joins_clauses(i)) begin = i + 1;
      if (tokens_[i].text != "," || !is_subject(begin, i)) continue;
      if (opens_relative(i + 1)) part(begin, i);
      if (opens_comment(i + 1)) pass_over(i);
      if (is_description(i + 1)) move_before_noun(begin, i);
    }
  }

 private:
  static constexpr std::size_t kSubject = 7, kClause = 30;  // tokens

  // "The old desk": a noun phrase and nothing more, as far as one sees from its words.
  bool is_subject(std::size_t begin, std::size_t end) const {
    if (end <= begin + 1 || end - begin > kSubject) return false;
    if (!lexicon_.is(tokens_[begin], WordClass::kDefinite) && !lexicon_.is(tokens_[begin], WordClass::kIndefinite) &&
        !lexicon_.is(tokens_[begin], WordClass::kPossessive))
      return false;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const bool verb =
          lexicon_.is(tokens_[i], WordClass::kBe) || lexicon_.is(tokens_[i], WordClass::kHave) || lexicon_.is(tokens_[i], WordClass::kAnd);
      if (verb || tokens_[i].kind != Token::Kind::kWord || lexicon_.find_phrase(tokens_, i).length > 0) return false;
    }
    return true;
  }

  // "on which", "to the left of which"
  bool opens_relative(std::size_t at) const {
    const std::size_t which = at + lexicon_.find_phrase(tokens_, at).length;
    return which > at && which < tokens_.size() && tokens_[which].text == "which";
  }

  // ", while the old desk", ", and a stone font"
  bool joins_clauses(std::size_t at) const {
    const bool joins = lexicon_.is(tokens_[at], WordClass::kAnd) || lexicon_.is(tokens_[at], WordClass::kClause);
    return joins && at > 0 && tokens_[at - 1].text == ",";
  }

  // "which every visitor passes", "which she likes for its pictures": what somebody does, and nothing of a place.
  bool opens_comment(std::size_t at) const {
    if (tokens_[at].text != "which" && tokens_[at].text != "whom") return false;
    const Token& next = tokens_[at + 1];
    if (!(lexicon_.is(next, WordClass::kDefinite) || lexicon_.is(next, WordClass::kPossessive) || lexicon_.is(next, WordClass::kEach) ||
          lexicon_.is(next, WordClass::kDoer) || lexicon_.is_person(next.text)))
      return false;
    const std::size_t second = second_comma(at);
    for (std::size_t i = at; i < second; ++i) {
      if (lexicon_.find_phrase(tokens_, i).length > 0 || one_of(tokens_[i].text, {"at", "in", "on", "by"})) return false;
    }
    return second > 0;
  }

  // "orange and round": adjectives and nothing more, up to the sentence's own verb.
  bool is_description(std::size_t at) const {
    const std::size_t second = second_comma(at);
    if (second == 0) return false;
    for (std::size_t i = at; i < second; ++i) {
      const bool describes = lexicon_.is(tokens_[i], WordClass::kColor) || lexicon_.is(tokens_[i], WordClass::kShape) ||
                             lexicon_.is(tokens_[i], WordClass::kQuality) || lexicon_.is(tokens_[i], WordClass::kSizeWord) ||
                             lexicon_.is(tokens_[i], WordClass::kAdverb) || word_form(tokens_[i].text) == WordForm::kAdjective;
      if (!describes && !(i > at && lexicon_.is(tokens_[i], WordClass::kAnd))) return false;
    }
    return true;
  }

  // The comma after which the sentence goes on; 0: there is none.
  std::size_t second_comma(std::size_t at) const {
    for (std::size_t i = at; i < std::min(tokens_.size(), at + kClause) && !tokens_[i].ends_sentence; ++i) {
      if (tokens_[i].text == "," && goes_on(i + 1)) return i;
    }
    return 0;
  }

  void pass_over(std::size_t comma) {
    const std::size_t second = second_comma(comma + 1);
    for (std::size_t i = comma; i <= second; ++i) {
      skip_[i] = true;
      readings_[i].use = WordReading::Use::kIgnored, readings_[i].role = "by the way";
    }
  }

  // "The pouf, orange and round, is": the orange and round pouf is.
  void move_before_noun(std::size_t begin, std::size_t comma) {
    const std::size_t second = second_comma(comma + 1);
    skip_[comma] = skip_[second] = true;
    for (std::size_t i = comma; i < second; ++i) skip_[i] = skip_[i] || lexicon_.is(tokens_[i], WordClass::kAnd);
    move_before(document_, skip_, begin + 1, comma, second);
  }

  // The sentence's own verb or place.
  bool goes_on(std::size_t at) const {
    if (at >= tokens_.size()) return false;
    const bool verb = lexicon_.is(tokens_[at], WordClass::kBe) || lexicon_.is(tokens_[at], WordClass::kPlaceVerb) ||
                      lexicon_.is(tokens_[at], WordClass::kHang) || lexicon_.is(tokens_[at], WordClass::kHave) ||
                      lexicon_.is(tokens_[at], WordClass::kParticiple);
    return verb || (lexicon_.find_phrase(tokens_, at).length > 0 && !opens_relative(at));
  }

  void part(std::size_t begin, std::size_t comma) {
    const std::size_t second = second_comma(comma + 1);
    if (second == 0) return;
    std::size_t end = second + 1;
    while (end < tokens_.size() && !tokens_[end].ends_sentence) ++end;
    const bool plural = tokens_[begin + 1].text != "a" &&
                        (tokens_[begin + 1].kind == Token::Kind::kNumber || lexicon_.is(tokens_[begin + 1], WordClass::kNumber));
    for (std::size_t i = comma + 1; i < second; ++i) {
      if (tokens_[i].text == "which") tokens_[i].text = plural ? "them" : "it";
    }
    skip_[second] = true;
    move_before(document_, skip_, comma, second + 1, end);
    Token& stop = tokens_[comma + end - second - 1];
    stop.text = ".";
    stop.ends_sentence = true;
  }

  const Lexicon& lexicon_;
  Document& document_;
  std::vector<Token>& tokens_;
  std::vector<WordReading>& readings_;
  std::vector<bool>& skip_;
};

}  // namespace

void part_relatives(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { RelativeParter(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
