#include "layoutbox/plan/passes/relatives.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

class RelativeParter {
 public:
  RelativeParter(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : lexicon_(lexicon), document_(document), tokens_(document.tokens), readings_(document.readings), skip_(skip) {}

  void run() {
    set_off();
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
  static constexpr std::size_t kSubject = 7, kClause = 30, kUse = 12;  // tokens

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

  // "The table on which two lamps stand is by the door": as "the table, on which two lamps stand, is".
  void set_off() {
    std::vector<Splice> commas;
    std::size_t begin = 0;
    for (std::size_t i = 1; i + 2 < tokens_.size(); ++i) {
      if (tokens_[i].ends_sentence || tokens_[i].text == "," || joins_clauses(i)) begin = i + 1;
      if (begin + 1 >= i || skip_[i]) continue;
      pass_over_use(i);
      const std::size_t verb = !skip_[i] && opens_relative(i) && is_subject(begin, i) ? own_verb(i) : 0;
      if (verb == 0) continue;
      commas.push_back({i, comma_token()});
      commas.push_back({verb, comma_token()});
      i = verb;
    }
    splice(document_, skip_, std::move(commas));
  }

  bool is_verb(std::size_t at) const {
    return lexicon_.is(tokens_[at], WordClass::kBe) || lexicon_.is(tokens_[at], WordClass::kPlaceVerb) ||
           lexicon_.is(tokens_[at], WordClass::kHang);
  }

  // The verb of what the clause at i tells of, after the clause's own; 0: there is none.
  std::size_t own_verb(std::size_t i) const {
    std::size_t found = 0;
    bool verb = false;
    for (std::size_t at = i + lexicon_.find_phrase(tokens_, i).length + 1;
         at + 1 < std::min(tokens_.size(), i + kUse) && tokens_[at].kind == Token::Kind::kWord; ++at) {
      const bool helped = lexicon_.is(tokens_[at - 1], WordClass::kHave) || lexicon_.is(tokens_[at - 1], WordClass::kBe);  // "has been"
      if (verb && !helped && is_verb(at) && lexicon_.find_phrase(tokens_, at + 1).length > 0) found = at;
      verb = verb || is_verb(at) || is_keeping(at);
    }
    return found;
  }

  // "The desk on which she writes is", "the lectern from which lessons were given stands": what somebody does there, up to the verb of the
  // desk.
  void pass_over_use(std::size_t i) {
    if (!one_of(tokens_[i].text, {"at", "in", "on", "by", "from", "with", "to", "for", "under", "behind"}) ||
        tokens_[i + 1].text != "which" || tokens_[i - 1].kind != Token::Kind::kWord ||
        !lexicon_.is(tokens_[begin_of_subject(i)], WordClass::kDefinite))
      return;
    const Token& who = tokens_[i + 2];
    const bool doer = lexicon_.is(who, WordClass::kDoer) || lexicon_.is_person(who.text) ||
                      one_of(who.text, {"he", "she", "they", "we", "i", "you", "one"});
    std::size_t verb = i + 3;
    if (doer && is_keeping(verb)) return;
    if (!doer) {  // "lessons were given"
      if (verb + 2 >= tokens_.size() || !lexicon_.is(tokens_[verb], WordClass::kBe) || is_keeping(verb + 1) || !is_verb(verb + 2)) return;
      ++verb;
    }
    for (std::size_t end = verb + 1; end < std::min(tokens_.size(), i + kUse) && tokens_[end].kind == Token::Kind::kWord; ++end) {
      if (!is_verb(end)) continue;
      for (std::size_t at = i; at < end; ++at) {
        skip_[at] = true;
        readings_[at].use = WordReading::Use::kIgnored, readings_[at].role = "by the way";
      }
      return;
    }
  }

  // "keeps her books", "has put a vase": something is there.
  bool is_keeping(std::size_t verb) const {
    return verb >= tokens_.size() || lexicon_.is(tokens_[verb], WordClass::kHave) || lexicon_.is(tokens_[verb], WordClass::kCommand) ||
           one_of(singular_of(tokens_[verb].text),
                  {"keep", "kept", "store", "put", "hang", "hung", "place", "display", "leave", "left", "have", "had", "find", "found"});
  }

  // Where "the old desk" before token i begins.
  std::size_t begin_of_subject(std::size_t i) const {
    std::size_t first = i - 1;
    while (first > 0 && first + kSubject > i && !lexicon_.is(tokens_[first], WordClass::kDefinite) &&
           tokens_[first - 1].kind == Token::Kind::kWord)
      --first;
    return first;
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
