#include "layoutbox/plan/passes/labels.h"
#include "layoutbox/plan/words/word_sets.h"

#include <algorithm>
#include <string_view>

namespace layoutbox::offline {
namespace {

class LabelReader {
 public:
  LabelReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : lexicon_(lexicon), document_(document), tokens_(document.tokens), skip_(skip) {}

  void run() {
    read_titles();
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      read_price(i);
      read_amount(i);
      read_code(i);
      read_bracketed_name(i);
      read_address(i);
      read_count_signs(i);
      read_sender(i);
      read_time(i);
      read_greeting(i);
    }
    read_closing();
  }

 private:
  bool is_quote(std::size_t i) const { return tokens_[i].kind == Token::Kind::kPunctuation && tokens_[i].text == "\""; }
  bool is_number(std::size_t i) const { return i < tokens_.size() && tokens_[i].kind == Token::Kind::kNumber; }
  bool is_word(std::size_t i) const { return i < tokens_.size() && tokens_[i].kind == Token::Kind::kWord; }
  bool is_one_of(std::size_t i, WordSet set) const { return i < tokens_.size() && one_of(tokens_[i].text, set); }
  bool is_one_of(std::size_t i, std::initializer_list<std::string_view> words) const {
    return i < tokens_.size() && std::ranges::find(words, std::string_view(tokens_[i].text)) != words.end();
  }
  template <std::size_t n>
  bool is_one_of(std::size_t i, const std::string_view (&words)[n]) const {
    return i < tokens_.size() && std::ranges::find(words, tokens_[i].text) != std::end(words);
  }

  bool is_in(std::string_view list, std::size_t i) const { return i < tokens_.size() && lexicon_.is_in(list, tokens_[i].text); }

  void leave_out(std::size_t first, std::size_t last, std::string_view role) {
    for (std::size_t i = first; i < last; ++i) {
      skip_[i] = true;
      document_.readings[i].role = role;
    }
  }

  void read_titles() {
    constexpr std::size_t kLongest = 12, kFewest = 2;  // words
    for (std::size_t open = 0; open < tokens_.size(); ++open) {
      if (!is_quote(open)) continue;
      std::size_t close = open + 1, capitals = 0;
      while (close < tokens_.size() && close - open <= kLongest && !is_quote(close)) capitals += tokens_[close++].capital ? 1 : 0;
      if (close >= tokens_.size() || !is_quote(close)) continue;
      const bool said = open > 0 && is_in("name_verbs", open - 1);
      // a red "on air" sign
      if (!said && open > 0 && is_word(open - 1) && lexicon_.find(tokens_, close + 1, WordClass::kObject).length > 0)
        leave_out(open, close + 1, "a name");
      if (said || (capitals >= kFewest && 2 * capitals > close - open - 1)) leave_out(open - (said ? 1 : 0), close + 1, "a name");
      open = close;
    }
  }

  bool is_sign(std::size_t i) const { return i < tokens_.size() && tokens_[i].text == "$"; }  // of any money

  bool is_currency(std::size_t i) const { return is_sign(i) || is_in("money", i); }

  void read_price(std::size_t i) {
    static constexpr std::string_view kLeading[] = {"for",    "at",    "under",   "over", "below", "about", "around", "roughly",
                                                    "less",   "than",  "up",      "to",   "most",  "only",  "just",   "approximately",
                                                    "within", "costs", "costing", "worth"};
    static constexpr std::string_view kAfter[] = {"each", "apiece", "max", "tops", "total", "or", "less", "in", "altogether"};
    if (!is_number(i) || skip_[i]) return;
    std::size_t first = i, last = i + 1;
    if (i > 0 && is_sign(i - 1)) --first;
    if (last < tokens_.size() && tokens_[last].text == "k" && tokens_[last].glued) ++last;
    const bool before = first < i;
    if (!before && !is_currency(last)) return;
    if (is_currency(last)) ++last;
    const std::size_t sum = first;
    while (first > 0 && is_one_of(first - 1, kLeading)) --first;
    if (first < sum) {  // "at 30 bucks each"; "a $40 chair in a corner" goes on
      const std::size_t end = last;
      while (is_one_of(last, kAfter)) ++last;
      if (last > end && (tokens_[last - 1].text == "in" || tokens_[last - 1].text == "or")) last = end;
    }
    leave_out(first, last, "a price");
  }

  // "from 5 to 30 kg", "a 20 kg kettlebell": how heavy, how warm, how strong; no number of things.
  void read_amount(std::size_t i) {
    if (!is_number(i) || skip_[i] || !is_one_of(i + 1, WordSet::kAmounts)) return;
    std::size_t first = i;
    if (i > 1 && is_number(i - 2) && is_one_of(i - 1, {"to", "-", "and", "or"})) first = i - 2;
    if (first > 0 && is_one_of(first - 1, {"from", "of", "between", "at"})) --first;
    leave_out(first, i + 2, "an amount");
  }

  // "3B", "A3", "B12": one capital at a number, which is neither a unit nor a count ("4x").
  void read_code(std::size_t i) {
    static constexpr std::string_view kLetters = "abcefgijknopqrstuvyz";
    const auto is_letter = [&](std::size_t at) {
      return is_word(at) && tokens_[at].capital && tokens_[at].text.size() == 1 && kLetters.find(tokens_[at].text[0]) != std::string::npos;
    };
    if (!is_number(i) || skip_[i]) return;
    const bool behind = is_letter(i + 1) && tokens_[i + 1].glued;
    const bool before = i > 0 && is_letter(i - 1) && tokens_[i].glued && tokens_[i].begin == tokens_[i - 1].end;
    // "Item 6, the committee room", "(6-DoF)"
    const bool listed =
        i > 0 && is_one_of(i - 1, WordSet::kListedAs) && i + 1 < tokens_.size() && tokens_[i + 1].kind == Token::Kind::kPunctuation;
    const bool bracketed = i > 0 && tokens_[i - 1].text == "(" && is_word(i + 1) && i + 2 < tokens_.size() && tokens_[i + 2].text == ")" &&
                           tokens_[i + 1].glued && !lexicon_.is(tokens_[i + 1], WordClass::kUnit) && tokens_[i + 1].text != "x";
    if (listed) leave_out(i - 1, i + 1, "a name");
    if (bracketed) leave_out(i, i + 2, "a name");
    if (behind || before) leave_out(before ? i - 1 : i, behind ? i + 2 : i + 1, "a name");
  }

  // "a bookcase (Billy)": what it is called.
  void read_bracketed_name(std::size_t i) {
    if (i == 0 || i + 2 >= tokens_.size() || tokens_[i].text != "(" || tokens_[i + 2].text != ")" || !is_word(i + 1)) return;
    const Token& word = tokens_[i + 1];
    if (word.capital && is_word(i - 1) && lexicon_.find(tokens_, i + 1).length == 0) leave_out(i + 1, i + 2, "a name");
  }

  // "14 Alder Close", "221 Baker Street": two capitalised words or more at a number, of which none is a thing of the catalogue's.
  void read_address(std::size_t i) {
    if (!is_number(i) || skip_[i] || (i > 0 && is_word(i - 1) && tokens_[i - 1].capital && i > 1 && !tokens_[i - 2].ends_sentence)) return;
    if (i > 0 && tokens_[i - 1].text == "x") return;  // "stool x1 IN FRONT OF"
    std::size_t end = i + 1;
    for (; is_word(end) && tokens_[end].capital; ++end) {
      const Match known = lexicon_.find(tokens_, end);
      if (known.length > 0 && known.meanings.front().entry != nullptr) return;
    }
    if (end - i > 2) leave_out(i, end, "a name");
  }

  // Names at most: "Thanks! Bed, desk, lamp." goes on.
  bool names_nothing(std::size_t from) const {
    for (std::size_t i = from; i < tokens_.size(); ++i) {
      const bool thing = is_number(i) || (!tokens_[i].capital && lexicon_.find(tokens_, i, WordClass::kObject).length > 0);
      if (thing || lexicon_.is(tokens_[i], WordClass::kIndefinite)) return false;
    }
    return true;
  }

  // "stools (x4)", "chairs - 8 pcs": what surrounds the number says nothing more.
  void read_count_signs(std::size_t i) {
    if (!is_number(i)) return;
    const bool times =
        i > 1 && tokens_[i - 1].text == "x" && tokens_[i - 2].text == "(" && i + 1 < tokens_.size() && tokens_[i + 1].text == ")";
    if (times) skip_[i - 2] = skip_[i + 1] = true;
    if (is_one_of(i + 1, WordSet::kPieces) && !is_word(i + 2)) skip_[i + 1] = true;
  }

  // "Hi Facilities,", "Buenas!", "Dear builder,": whom the text greets.
  void read_greeting(std::size_t i) {
    constexpr std::size_t kMostNames = 4;
    if (!is_one_of(i, WordSet::kGreetings) || (i > 0 && !tokens_[i - 1].ends_sentence)) return;
    std::size_t end = i + 1;
    while (is_word(end) && !lexicon_.is(tokens_[end], WordClass::kIndefinite) && !lexicon_.is(tokens_[end], WordClass::kNumber)) ++end;
    if (end <= i + 1 + kMostNames && end < tokens_.size() && tokens_[end].kind == Token::Kind::kPunctuation)
      leave_out(i, end, "a greeting");
  }

  // "stopped at 3:10", "from 9:30 pm"
  void read_time(std::size_t i) {
    static constexpr std::string_view kAt[] = {"at", "until", "till", "from", "by", "before", "after", "to"};
    static constexpr std::string_view kHalf[] = {"am", "pm", "a", "p", "h", "hrs"};
    if (!is_number(i) || i + 2 >= tokens_.size() || tokens_[i + 1].text != ":" || !is_number(i + 2) || tokens_[i + 2].text.size() != 2)
      return;
    if (tokens_[i].number > 24 || tokens_[i + 2].number > 59 || tokens_[i + 2].begin != tokens_[i + 1].end) return;
    leave_out(i > 0 && is_one_of(i - 1, kAt) ? i - 1 : i, is_one_of(i + 3, kHalf) ? i + 4 : i + 3, "a time");
  }

  // "From Jonas", a line of its own.
  void read_sender(std::size_t i) {
    constexpr std::size_t kMostNames = 3;
    if (tokens_[i].text != "from" || !tokens_[i].capital || (i > 0 && !tokens_[i - 1].ends_sentence)) return;
    std::size_t end = i + 1;
    while (is_word(end) && tokens_[end].capital && lexicon_.find(tokens_, end, WordClass::kObject).length == 0) ++end;
    if (end > i + 1 && end <= i + 1 + kMostNames && (end >= tokens_.size() || tokens_[end].ends_sentence)) leave_out(i, end, "who writes");
  }

  // The end of a letter: few words, of which the first say so.
  void read_closing() {
    constexpr std::size_t kMost = 12;  // words of it
    std::size_t words = 0;
    for (std::size_t i = tokens_.size(); i-- > 0 && words <= kMost;) {
      if (!is_word(i)) continue;
      ++words;
      const bool opens = i == 0 || tokens_[i - 1].ends_sentence || tokens_[i - 1].text == ",";
      if (!opens || i == 0) continue;
      std::size_t at = i;
      while (is_in("closing_leads", at) && is_word(at + 1)) ++at;
      const bool sent = tokens_[i].text == "sent" && i + 1 < tokens_.size() && tokens_[i + 1].text == "from";
      const bool wishes = at > i && (tokens_[at].text == "wishes" || tokens_[at].text == "blessing");
      const bool plain = at == i && is_word(at + 1) && !tokens_[at + 1].capital && tokens_[at + 1].text != "in";  // "yours by the window"
      if (sent || ((wishes || is_in("closings", at)) && !plain && names_nothing(at + 1)))
        leave_out(i, tokens_.size() - 1, "how the letter ends");
    }
  }

  const Lexicon& lexicon_;
  Document& document_;
  const std::vector<Token>& tokens_;
  std::vector<bool>& skip_;
};

}  // namespace

void read_labels(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { LabelReader(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
