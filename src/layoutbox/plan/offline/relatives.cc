#include "layoutbox/plan/offline/relatives.h"

#include <algorithm>

namespace layoutbox::offline {
namespace {

class RelativeParter {
 public:
  RelativeParter(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : lexicon_(lexicon), tokens_(document.tokens), readings_(document.readings), skip_(skip) {}

  void run() {
    std::size_t begin = 0;
    for (std::size_t i = 1; i + 2 < tokens_.size(); ++i) {
      if (tokens_[i].ends_sentence) begin = i + 1;
      if (tokens_[i].text == "," && is_subject(begin, i) && opens_relative(i + 1)) part(begin, i);
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

  // The sentence's own verb or place.
  bool goes_on(std::size_t at) const {
    if (at >= tokens_.size()) return false;
    const bool verb = lexicon_.is(tokens_[at], WordClass::kBe) || lexicon_.is(tokens_[at], WordClass::kPlaceVerb) ||
                      lexicon_.is(tokens_[at], WordClass::kHang) || lexicon_.is(tokens_[at], WordClass::kHave) ||
                      lexicon_.is(tokens_[at], WordClass::kParticiple);
    return verb || (lexicon_.find_phrase(tokens_, at).length > 0 && !opens_relative(at));
  }

  void part(std::size_t begin, std::size_t comma) {
    std::size_t second = comma + 1;
    const std::size_t most = std::min(tokens_.size(), comma + kClause);
    while (second < most && !tokens_[second].ends_sentence && !(tokens_[second].text == "," && goes_on(second + 1))) ++second;
    if (second >= most || tokens_[second].text != ",") return;
    std::size_t end = second + 1;
    while (end < tokens_.size() && !tokens_[end].ends_sentence) ++end;
    const bool plural = tokens_[begin + 1].text != "a" &&
                        (tokens_[begin + 1].kind == Token::Kind::kNumber || lexicon_.is(tokens_[begin + 1], WordClass::kNumber));
    for (std::size_t i = comma + 1; i < second; ++i) {
      if (tokens_[i].text == "which") tokens_[i].text = plural ? "them" : "it";
    }
    skip_[second] = true;
    const auto at = [](auto& all, std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    std::rotate(at(tokens_, comma), at(tokens_, second + 1), at(tokens_, end));
    std::rotate(at(readings_, comma), at(readings_, second + 1), at(readings_, end));
    std::rotate(at(skip_, comma), at(skip_, second + 1), at(skip_, end));
    Token& stop = tokens_[comma + end - second - 1];
    stop.text = ".";
    stop.ends_sentence = true;
  }

  const Lexicon& lexicon_;
  std::vector<Token>& tokens_;
  std::vector<WordReading>& readings_;
  std::vector<bool>& skip_;
};

}  // namespace

void part_relatives(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { RelativeParter(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
