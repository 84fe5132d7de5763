#include "layoutbox/plan/passes/said_counts.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"

namespace layoutbox::offline {
namespace {

using Words = std::vector<std::string_view>;

class SaidCounts {
 public:
  SaidCounts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : lexicon_(lexicon), tokens_(document.tokens), readings_(document.readings), skip_(skip) {}

  void run() {
    read_pairs();
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      read_as_many(i);
      read_one_of_them(i);
      read_quantity(i);
      read_per_row(i);
      read_leader(i);
      read_shortened(i);
      read_behind(i);
      read_sum(i);
      read_among(i);
    }
  }

 private:
  bool is(std::size_t at, std::string_view text) const { return at < tokens_.size() && tokens_[at].text == text; }
  bool is_one_of(std::size_t at, const Words& words) const {
    return at < tokens_.size() && std::ranges::find(words, tokens_[at].text) != words.end();
  }
  bool is_count(std::size_t at) const {
    return at < tokens_.size() && (tokens_[at].kind == Token::Kind::kNumber || lexicon_.is(tokens_[at], WordClass::kNumber));
  }
  bool is_word(std::size_t at) const { return at < tokens_.size() && tokens_[at].kind == Token::Kind::kWord; }
  bool ends(std::size_t at) const { return at >= tokens_.size() || tokens_[at].kind == Token::Kind::kPunctuation; }
  // "as many bookshelves as possible", "… as fit": many.
  void read_as_many(std::size_t i) {
    constexpr std::size_t kName = 5;  // words of what they are
    if (!is(i - 1, "as") || !is(i, "many")) return;
    for (std::size_t at = i + 2; at <= i + kName && !ends(at); ++at) {
      if (!is(at, "as") || !is_one_of(at + 1, {"possible", "fit", "will"})) continue;
      leave_out(i - 1, i);
      leave_out(at, at + (is(at + 1, "will") && is(at + 2, "fit") ? 3 : 2));
      return;
    }
  }
  // "six chairs, one chair blocking the fridge": one of them.
  void read_one_of_them(std::size_t i) {
    if (i < 3 || !is_one_of(i, {"one", "two", "three"}) || !is_one_of(i - 1, {",", "("}) || !is_plural(tokens_[i - 2].text) ||
        ends(i + 2) || !is_word(i + 1))
      return;
    const bool same = singular_of(tokens_[i + 1].text) == singular_of(tokens_[i - 2].text);
    const bool told = tokens_[i + 2].text.ends_with("ing") || tokens_[i + 2].text.ends_with("ed");
    if (same && told && is_count(i - 3)) leave_out(i + 1, i + 2);
  }
  void leave_out(std::size_t first, std::size_t last) {
    std::fill(skip_.begin() + static_cast<std::ptrdiff_t>(first), skip_.begin() + static_cast<std::ptrdiff_t>(last), true);
  }
  std::size_t past_signs(std::size_t at) const {
    while (is_one_of(at, {":", ".", "=", ","})) ++at;
    return at;
  }

  // "chairs, qty 4", "chair for guests ... quantity: 4": the number goes before its line's first word.
  void read_quantity(std::size_t i) {
    constexpr std::size_t kLongest = 8;  // words
    if (!is_one_of(i, {"qty", "quantity", "qnty", "quant"})) return;
    const std::size_t number = past_signs(i + 1);
    if (number >= tokens_.size() || tokens_[number].kind != Token::Kind::kNumber) return;
    std::size_t line = i;
    const auto is_side = [&](std::size_t at) { return is(at + 1, "x") || (at > 0 && is(at - 1, "x")); };  // "0.45x0.4 qty 2"
    while (line > 0 && i - line < kLongest && !tokens_[line - 1].ends_sentence && (!is_count(line - 1) || is_side(line - 1)) &&
           !lexicon_.is(tokens_[line - 1], WordClass::kAnd) && !is_one_of(line - 1, {"with", "has", "have", "includes", "including", "of"}))
      --line;
    leave_out(i, number);
    if (line == i || !is_word(line) || lexicon_.is(tokens_[line], WordClass::kIndefinite)) return leave_out(number, number + 1);
    if (is_one_of(i - 1, {",", ":", "("})) leave_out(i - 1, i);
    bring_forward(line, number);
  }

  // The token at `from` comes before the one at `to`.
  void bring_forward(std::size_t to, std::size_t from) {
    const auto at = [](auto& all, std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    std::rotate(at(tokens_, to), at(tokens_, from), at(tokens_, from + 1));
    std::rotate(at(readings_, to), at(readings_, from), at(readings_, from + 1));
    std::rotate(at(skip_, to), at(skip_, from), at(skip_, from + 1));
  }

  // "two rows of racks facing each other, five in each row": two rows of five racks.
  void read_per_row(std::size_t i) {
    constexpr std::size_t kReach = 24;  // tokens
    if (!is_count(i) || !is_one_of(i + 1, {"in", "for", "to"}) || !is_one_of(i + 2, {"each", "every", "a"}) ||
        !is_one_of(i + 3, {"row", "line", "column"}))
      return;
    std::size_t of = i;
    while (of > 1 && i - of < kReach && !tokens_[of - 1].ends_sentence &&
           !(is(of - 1, "of") && is_one_of(of - 2, {"rows", "lines", "columns"})))
      --of;
    if (of < 2 || !is(of - 1, "of") || is_count(of)) return;
    leave_out(i + 1, i + 4);
    std::size_t first = i;
    while (first > of && is_one_of(first - 1, {",", "with", "and"})) --first;
    leave_out(first, i);
    bring_forward(of, i);
  }

  // "Chair ........ 2": chair x 2. "As many as six": six.
  void read_leader(std::size_t i) {
    constexpr std::size_t kFewest = 3;  // bytes
    if (is_one_of(i, {"as"}) && is(i + 1, "many") && is(i + 2, "as") && is_count(i + 3)) leave_out(i, i + 3);
    if (!is(i, ",") || tokens_[i].end - tokens_[i].begin < kFewest || !ends(i + 2)) return;
    if (!is_word(i - 1) || i + 1 >= tokens_.size() || tokens_[i + 1].kind != Token::Kind::kNumber) return;
    tokens_[i].text = "x";
    tokens_[i].kind = Token::Kind::kWord;
  }

  // "table one, chair four, lamp two": the numbers of what is named without article, in the order of other languages. One alone is one
  // only where it is several: "table one" may be a name.
  void read_pairs() {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;  // the name's first word, the number
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      if (const std::size_t first = name_before_count(i); first < i) pairs.emplace_back(first, i);
    }
    for (const auto& [first, number] : pairs) {
      const bool several = !lexicon_.is(tokens_[number], WordClass::kNumber) ? is_plural(tokens_[number - 1].text) : !is(number, "one");
      if (pairs.size() > 1 || several) bring_forward(first, number);
    }
  }

  // Where the name of a thing begins that ends in front of the number at `number` and opens an item of a list; `number` where none does.
  std::size_t name_before_count(std::size_t number) const {
    constexpr std::size_t kName = 4;
    const bool over = ends(number + 1) || lexicon_.is(tokens_[number + 1], WordClass::kAnd) || is(number + 1, "also");
    if (!is_count(number) || !over || !is_word(number - 1)) return number;
    for (std::size_t first = number - 1; first + kName >= number; --first) {
      const Match match = lexicon_.find(tokens_, first);
      const bool named = meaning_of(match, WordClass::kObject) != nullptr && first + match.length == number;
      const bool opens = first == 0 || !is_word(first - 1) || lexicon_.is(tokens_[first - 1], WordClass::kAnd) ||
                         lexicon_.is(tokens_[first - 1], WordClass::kBe) || lexicon_.is(tokens_[first - 1], WordClass::kHave);
      if (named && opens && tokens_[first].kind == Token::Kind::kWord) return first;
      if (first == 0 || !is_word(first - 1)) break;
    }
    return number;
  }

  // "min. 6", "4 no. chairs": no sentence ends there.
  void read_shortened(std::size_t i) {
    // "on the shelf minimum six shoes": no shelf of that name.
    if (is_one_of(i, {"minimum", "maximum", "min", "max"}) && is_count(i + 1) && is_word(i - 1)) leave_out(i, i + 1);
    const bool bound = is_one_of(i, {"min", "max", "approx", "ca", "diameter"}) && is(i + 1, ".") && is_count(i + 2);
    if (bound) leave_out(i + 1, i + 2);
    const bool numero = is_one_of(i, {"no", "nos", "pcs", "pc"}) && is(i + 1, ".") && tokens_[i - 1].kind == Token::Kind::kNumber;
    const bool goes_on = is_one_of(i + 2, {","}) || (is_word(i + 2) && !tokens_[i + 2].capital);
    if (numero) leave_out(i, goes_on ? i + 2 : i + 1);
  }

  // "chairs, minimum four", "glasses (six pieces)", "stools, 4 at the very most": the number alone.
  void read_behind(std::size_t i) {
    if (!is_count(i) || !is_word(i - 1)) {
      if (!is_count(i) || !is_one_of(i - 1, {",", "(", ":"})) return;
    }
    static const Words kBefore{"minimum", "min", "maximum", "max"};
    const bool bound = is_one_of(i - 1, kBefore) && i >= 2 && is_one_of(i - 2, {",", "(", ":"});
    if (!bound && !is_one_of(i - 1, {",", "(", ":"})) return;
    const std::size_t last = past_unit(i + 1);
    if (!ends(last)) return;
    if (bound) leave_out(i - 1, i);
    leave_out(i + 1, last);
  }

  // Behind the first of the wordings that stands at `at`; `at` where none does.
  std::size_t past_first_of(std::span<const Words> wordings, std::size_t at) const {
    for (const Words& words : wordings) {
      std::size_t t = at;
      while (t - at < words.size() && is(t, words[t - at])) ++t;
      if (t - at == words.size()) return t;
    }
    return at;
  }

  std::size_t past_unit(std::size_t at) const {
    static const std::array<Words, 12> kUnits{{{"in", "number"},
                                               {"at", "the", "very", "most"},
                                               {"at", "the", "very", "least"},
                                               {"at", "the", "most"},
                                               {"at", "the", "least"},
                                               {"at", "most"},
                                               {"at", "least"},
                                               {"pieces"},
                                               {"pcs"},
                                               {"units"},
                                               {"max"},
                                               {"min"}}};
    return past_first_of(kUnits, at);
  }

  // Words that say a sum is to come ("so", "that makes", "for a total of"), before the number at `number`: where they begin, else `number`.
  std::size_t sum_begins(std::size_t number) const {
    static const std::array<Words, 13> kLeads{{{"for", "a", "total", "of"},
                                               {"a", "total", "of"},
                                               {"that", "makes"},
                                               {"which", "makes"},
                                               {"this", "makes"},
                                               {"making"},
                                               {"makes"},
                                               {"that", "is"},
                                               {"that", "'s"},
                                               {"totaling"},
                                               {"totalling"},
                                               {"so"},
                                               {"thus"}}};
    for (const Words& lead : kLeads) {
      if (number < lead.size() + 1) continue;
      const std::size_t first = number - lead.size();
      bool same = true;
      for (std::size_t k = 0; k < lead.size(); ++k) same = same && tokens_[first + k].text == lead[k];
      if (!same) continue;
      const bool again = is_one_of(first - 1, {"so", "and"});
      return again ? first - 1 : first;
    }
    return number;
  }

  std::size_t past_total(std::size_t at) const {
    static const std::array<Words, 9> kTrails{{{"in", "total"},
                                               {"in", "all"},
                                               {"all", "in", "all"},
                                               {"all", "told"},
                                               {"all", "together"},
                                               {"total"},
                                               {"altogether"},
                                               {"overall"},
                                               {"totally"}}};
    return past_first_of(kTrails, at);
  }

  // "…, so four chairs in all", "(that's 8 stools)": what was counted before, summed up.
  void read_sum(std::size_t i) {
    constexpr std::size_t kName = 3;  // words of what is counted
    if (!is_count(i) || skip_[i]) return;
    const std::size_t first = sum_begins(i);
    const bool led = first < i && !is(first, "that") && is_word(first - 1);  // "a trolley so two trolleys and …"
    if (first == 0 || (!led && !is_one_of(first - 1, {",", "(", "-", ":", "and"}))) return;
    std::size_t noun = i + 1;
    while (is_word(noun + 1) && noun < i + kName && !lexicon_.is(tokens_[noun + 1], WordClass::kAnd) && past_total(noun + 1) == noun + 1)
      ++noun;
    if (!is_word(noun) || !is_plural(tokens_[noun].text)) return;
    const std::size_t last = past_total(noun + 1);
    if (!(ends(last) || (first < i && lexicon_.is(tokens_[last], WordClass::kAnd))) || (first == i && last == noun + 1) ||
        !counted_before(first, singular_of(tokens_[noun].text)))
      return;
    leave_out(first, last);
  }

  // "lined with lockers, six of them", "a row of jars, five in all": how many of what was named last.
  void read_among(std::size_t i) {
    constexpr std::size_t kReach = 8;  // words
    if (!is_count(i) || skip_[i] || i < 2 || !is_one_of(i - 1, {",", "("})) return;
    const bool of_them = is(i + 1, "of") && is_one_of(i + 2, {"them", "these", "those"});
    const std::size_t last = of_them ? i + 3 : past_total(i + 1);
    if (last == i + 1 || (!ends(last) && !(of_them && is(last, "in") && is_one_of(last + 1, {"a", "all", "total"})))) return;
    for (std::size_t t = i - 1; t-- > 0 && t + kReach >= i && is_word(t);) {
      if (!is_plural(tokens_[t].text)) continue;
      if (is_verb_here(t)) continue;
      std::size_t first = t;
      for (std::size_t f = t + 1; f-- > 0 && f + 4 > t && is_word(f);) {
        const Match match = lexicon_.find(tokens_, f);
        if (meaning_of(match, WordClass::kObject) != nullptr && f + match.length == t + 1) first = f;
      }
      if (meaning_of(lexicon_.find(tokens_, first), WordClass::kObject) == nullptr) continue;
      const bool counted =
          first > 0 && (is_count(first - 1) || is_one_of(first - 1, {"the", "these", "those", "both", "all", "its", "their"}));
      if (counted) return;
      leave_out(i + 1, last);
      skip_[i - 1] = skip_[i - 1] || !ends(last);
      bring_forward(first, i);
      return;
    }
  }

  // "stands", "holds": no things.
  bool is_verb_here(std::size_t at) const { return lexicon_.is(tokens_[at], WordClass::kVerb) || lexicon_.is(tokens_[at], WordClass::kBe); }

  static bool is_plural(const std::string& word) { return singular_of(word) != word; }

  // The thing was named in this sentence or the one before, with a number or for each of something.
  bool counted_before(std::size_t first, const std::string& thing) const {
    constexpr int kSentences = 2;
    bool named = false, counted = false;
    int sentences = 0;
    for (std::size_t t = first; t-- > 0 && sentences < kSentences;) {
      if (tokens_[t].ends_sentence) ++sentences;
      const bool here = singular_of(tokens_[t].text) == thing;
      if (here && t > 0 && is_one_of(t - 1, {"per", "each", "every"})) return false;  // "one stool per easel, six easels in all"
      named = named || here;
      counted = counted || (named && (is_count(t) || is_one_of(t, {"a", "an", "each", "every", "per", "either", "both"})));
    }
    return named && counted;
  }

  const Lexicon& lexicon_;
  std::vector<Token>& tokens_;
  std::vector<WordReading>& readings_;
  std::vector<bool>& skip_;
};

}  // namespace

void read_said_counts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { SaidCounts(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
