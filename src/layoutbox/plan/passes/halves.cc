#include "layoutbox/plan/passes/halves.h"

#include <initializer_list>
#include <string_view>
#include <utility>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/splice.h"

namespace layoutbox::offline {
namespace {

std::string_view opposed(std::string_view side) {
  return side == "left" ? "right" : side == "right" ? "left" : side == "front" ? "back" : "front";
}

class HalfReader {
 public:
  HalfReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) : lexicon_(lexicon), document_(document), skip_(skip) {}

  void run() {
    for (std::size_t i = 0; i < document_.tokens.size(); ++i) {
      if (i > 0 && document_.tokens[i - 1].ends_sentence) ++sentences_;
      if (skip_[i] || !begins(i)) continue;
      const Half half = half_at(i);
      const std::size_t list = half.last == 0 ? 0 : list_after(half.last);
      if (list == 0) continue;
      said_ = half.side;
      said_in_ = sentences_;
      for (std::size_t at = i; at < list; ++at) skip_[at] = at != half.word;
      document_.tokens[half.word].text = half.side;
      put(half.word, {"in", "the"});
      put(list, {"half", "of", "the", "room", "is"});
    }
    splice(document_, skip_, std::move(words_));
  }

 private:
  // A side of the room that is spoken of, the word that stands for it, and where what is said of it begins; 0: there is none.
  struct Half {
    std::string_view side;
    std::size_t word = 0, last = 0;
  };

  void put(std::size_t at, std::initializer_list<std::string_view> words) {
    for (const std::string_view word : words) words_.push_back({at, word_token(word)});
  }

  bool is(std::size_t at, std::initializer_list<std::string_view> words) const { return says_one_of(document_, at, words); }
  bool over(std::size_t at) const { return at >= document_.tokens.size() || (at > 0 && document_.tokens[at - 1].ends_sentence); }

  bool begins(std::size_t at) const {
    return at == 0 || over(at) || document_.tokens[at - 1].kind == Token::Kind::kPunctuation ||
           lexicon_.is(document_.tokens[at - 1], WordClass::kAnd) || is(at - 1, {"while", "whereas"});
  }

  bool told_before() const { return !said_.empty() && said_in_ + 1 >= sentences_; }

  Half half_at(std::size_t i) const {
    const bool other = is(i, {"the"}) && is(i + 1, {"other"}), one = is(i, {"one"});
    const std::size_t at = i + (other ? 2 : is(i, {"the"}) || one ? 1 : 0);
    std::string_view side;
    for (const std::string_view word : {"left", "right", "front", "back"}) side = is(at, {word}) ? word : side;
    const std::size_t noun = at + (side.empty() ? 0 : 1);
    const bool half = is(noun, {"half"}), of_room = is(noun + 1, {"of"}) && names_room(noun + 2);
    if (!side.empty() && !half && is(noun, {"of"}) && names_room(noun + 1, false)) return {side, at, noun + 2};  // "Front of shop: …"
    if (other && told_before() && side.empty() && !half && is(noun, {"is", "for", "has", "serves"})) return {opposed(said_), i + 1, noun};
    if (!half || (side.empty() && !one && !other) || (other && !told_before())) return {};
    if (side.empty()) side = one ? "left" : opposed(said_);
    if (!of_room && is(noun + 1, {"of"})) return {};  // of a table
    std::size_t last = noun + 1;
    if (of_room) last += is(noun + 2, {"the", "this", "my", "our"}) ? 3 : 2;
    return {side, at, last};
  }

  bool names_room(std::size_t at, bool article = true) const {
    if (article && is(at, {"the", "this", "my", "our"})) ++at;
    if (at >= document_.tokens.size()) return false;
    return is(at, {"room", "it", "shop", "house", "hall", "space"}) || lexicon_.find(document_.tokens, at, WordClass::kRoom).length > 0;
  }

  bool opens_list(std::size_t at) const {
    if (at >= document_.tokens.size()) return false;
    const Token& token = document_.tokens[at];
    return token.kind == Token::Kind::kNumber || lexicon_.is(token, WordClass::kIndefinite) || lexicon_.is(token, WordClass::kNumber) ||
           lexicon_.is(token, WordClass::kPossessive) || lexicon_.find(document_.tokens, at, WordClass::kObject).length > 0;
  }

  // Where the list of what is there begins: after "has", "is an office with", "for working with", ":", or at once; 0: there is none.
  std::size_t list_after(std::size_t at) const {
    constexpr std::size_t kReach = 9;  // words of what it is or is for
    if (is(at, {":"}) || is(at, {"has", "holds", "contains", "houses", "gets"})) return opens_list(at + 1) ? at + 1 : 0;
    if (told_before() && opens_list(at) && lexicon_.is(document_.tokens[at], WordClass::kIndefinite) && !with_follows(at)) return at;
    if (!is(at, {"is", "for", "serves", "as"}) && !(told_before() && opens_list(at))) return 0;
    if (is(at, {"is"}) && is(at + 1, {"for"}) && names_thing(at + 2)) return at + 2;
    for (std::size_t i = at; i < at + kReach && !over(i + 1); ++i) {
      if (is(i, {"with", ":"})) return opens_list(i + 1) ? i + 1 : 0;
    }
    return 0;
  }

  // "… is for a table and two chairs", "… for the desk"; not "for the office".
  bool names_thing(std::size_t at) const {
    const bool article = at < document_.tokens.size() && (lexicon_.is(document_.tokens[at], WordClass::kIndefinite) ||
                                                          lexicon_.is(document_.tokens[at], WordClass::kDefinite));
    return article && lexicon_.find(document_.tokens, at + 1, WordClass::kObject).length > 0 && !with_follows(at);
  }

  // "the right half an office with a desk": what it is comes first.
  bool with_follows(std::size_t at) const {
    const std::size_t room = at + 1;
    return room < document_.tokens.size() && lexicon_.find(document_.tokens, room, WordClass::kRoom).length > 0;
  }

  const Lexicon& lexicon_;
  Document& document_;
  std::vector<bool>& skip_;
  std::vector<Splice> words_;
  std::string_view said_;
  std::size_t said_in_ = 0, sentences_ = 0;
};

}  // namespace

void read_halves(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { HalfReader(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
