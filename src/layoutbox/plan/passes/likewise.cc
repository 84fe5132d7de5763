#include "layoutbox/plan/passes/likewise.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {
namespace {

class LikewiseReader : public TokenReader {
 public:
  LikewiseReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : TokenReader(lexicon, document.tokens, skip), document_(document) {}

  void run() {
    for (std::size_t i = 1; i + 1 < tokens_.size(); ++i) {
      if (skip_[i] || !read_opening(i)) read_closing(i);
    }
    std::ranges::stable_sort(said_again_, {}, &Splice::at);
    splice(document_, skip_, std::move(said_again_));
  }

 private:
  // A clause: its first token, its verb, and where its words end.
  struct Said {
    std::size_t begin = 0, verb = 0, end = 0;
  };

  static constexpr std::size_t kFar = 40;  // tokens in which the clause before is looked for

  bool is_helper(std::size_t at) const { return is(at, {"does", "do", "is", "are", "did", "was", "were", "has", "have"}); }

  bool is_verb(std::size_t at) const {
    const Token& word = tokens_[at];
    if (lexicon_.is(word, WordClass::kBe) || lexicon_.is(word, WordClass::kPlaceVerb) || lexicon_.is(word, WordClass::kHang)) return true;
    return is_finite(word.text) && lexicon_.find_phrase(tokens_, at).length > 0 && is_article(at + 1);  // "faces the window"
  }

  // Where the clause that ends before `end` begins: after a full stop, or after the comma or "and" that begins its clause.
  std::size_t begin_of_clause(std::size_t end) const {
    std::size_t begin = end;
    while (begin > 0 && end - begin < kFar && !tokens_[begin - 1].ends_sentence) --begin;
    for (std::size_t i = begin; i + 1 < end; ++i) {
      const bool parts = tokens_[i].text == ";" || (tokens_[i].text == "," && is(i + 1, {"and", "while"}));
      if (parts && has_verb(i + 1, end) && has_verb(begin, i)) begin = i + (tokens_[i].text == ";" ? 1 : 2);
    }
    return begin;
  }

  bool has_verb(std::size_t first, std::size_t last) const {
    for (std::size_t i = first; i < last; ++i) {
      if (is_verb(i)) return true;
    }
    return false;
  }

  // The clause before `end`, and before what joins the two; nothing where it has no verb with a place.
  std::optional<Said> clause_before(std::size_t end) const {
    while (end > 0 && (tokens_[end - 1].kind == Token::Kind::kPunctuation || lexicon_.is(tokens_[end - 1], WordClass::kAnd))) --end;
    Said said{begin_of_clause(end), 0, end};
    said.verb = said.begin;
    while (said.verb < end && !is_verb(said.verb)) ++said.verb;
    if (said.verb >= end) return std::nullopt;
    for (std::size_t i = said.verb; i < end; ++i) {
      if (tokens_[i].kind == Token::Kind::kPunctuation) said.end = std::min(said.end, i);
    }
    return said;
  }

  // Where the things end that are named from `at` on: "two chairs and a bench".
  std::size_t end_of_things(std::size_t at) const {
    std::size_t end = at;
    while (const std::optional<NamedThing> thing = thing_named_at(at)) {
      end = thing->last;
      at = end + 1;
      if (end >= tokens_.size() || !lexicon_.is(tokens_[end], WordClass::kAnd)) break;
    }
    return end;
  }

  // … of a thing that no list has.
  std::size_t end_of_name(std::size_t at) const {
    constexpr std::size_t kLongest = 5;
    std::size_t end = at + 1;
    while (end < at + kLongest && !ends(end) && !lexicon_.is(tokens_[end], WordClass::kAnd) &&
           !lexicon_.is(tokens_[end], WordClass::kRelative) && lexicon_.find_phrase(tokens_, end).length == 0)
      ++end;
    return end > at + 1 ? end : at;
  }

  // The verb as it is said of so many.
  std::string verb_of(std::size_t verb, bool several) const {
    const std::string& text = tokens_[verb].text;
    if (text == "is" || text == "are") return several ? "are" : "is";
    const bool singular = text.ends_with("s");
    if (several == !singular || lexicon_.is(tokens_[verb], WordClass::kBe)) return text;
    return several ? text.substr(0, text.size() - 1) : text + "s";
  }

  // What the clause says is said once more at `at`.
  void say_again(const Said& said, std::size_t at, bool several) {
    const bool fronted = said.verb > said.begin && lexicon_.find_phrase(tokens_, said.begin).length > 0;
    const auto add = [&](std::string_view word) { said_again_.push_back({at, word_token(word)}); };
    add(verb_of(said.verb, several));
    const std::size_t first = fronted ? said.begin : said.verb + 1, last = fronted ? said.verb : said.end;
    for (std::size_t i = first; i < last; ++i) said_again_.push_back({at, tokens_[i]}), said_again_.back().token.ends_sentence = false;
  }

  bool are_several(std::size_t first, std::size_t last) const {
    const bool one = lexicon_.is(tokens_[first], WordClass::kIndefinite);
    const bool joined =
        std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(first), tokens_.begin() + static_cast<std::ptrdiff_t>(last),
                    [&](const Token& token) { return lexicon_.is(token, WordClass::kAnd); });
    return joined || (!one && singular_of(tokens_[last - 1].text) != tokens_[last - 1].text);
  }

  // "…, and so does a band saw", "…, as do two chairs", ". So is the lamp."
  bool read_opening(std::size_t i) {
    const bool so = is(i, {"so"}), as = is(i, {"as"}) && tokens_[i - 1].text == ",";
    if ((!so && !as) || !is_helper(i + 1) || !is_article(i + 2)) return false;
    std::size_t things = end_of_things(i + 2);
    if (things == i + 2 && is(i + 1, {"does", "do"})) things = end_of_name(i + 2);
    const std::optional<Said> said = clause_before(i);
    if (things == i + 2 || !said) return false;
    leave_out(as ? i + 1 : i, i + 2);
    if (as) tokens_[i].text = "and";
    say_again(*said, things, are_several(i + 2, things));
    return true;
  }

  // "…, and a plant does too": likewise.
  void read_closing(std::size_t i) {
    const bool likewise = is(i + 1, {"too", "likewise", "also"}) || are(i + 1, {"as", "well"}) || (is(i + 1, {"so"}) && is(i + 2, {"too"}));
    if (!is(i, {"does", "do", "is", "are"}) || !likewise) return;
    const std::size_t last = is(i + 1, {"as", "so"}) ? i + 3 : i + 2;
    if (!ends(last)) return;
    std::size_t first = i;
    while (first > 0 && i - first < kFar && tokens_[first - 1].kind == Token::Kind::kWord &&
           !lexicon_.is(tokens_[first - 1], WordClass::kAnd))
      --first;
    if (!thing_named_at(first) || end_of_things(first) != i) return;
    const std::optional<Said> said = clause_before(first);
    if (!said) return;
    leave_out(i, last);
    say_again(*said, i, are_several(first, i));
  }

  Document& document_;
  std::vector<Splice> said_again_;
};

}  // namespace

void read_likewise(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { LikewiseReader(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
