#include "layoutbox/plan/offline/requests.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace layoutbox::offline {
namespace {

using Words = std::initializer_list<std::string_view>;

class RequestReader {
 public:
  RequestReader(const Lexicon& lexicon, std::vector<Token>& tokens, std::vector<bool>& skip) : lexicon_(lexicon), tokens_(tokens), skip_(skip) {}

  void run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (skip_[i]) continue;
      read_possible(i);
      read_spot(i);
      read_looked_for(i);
      read_nothing_but(i);
      read_weight(i);
      read_whose(i);
      read_not_but(i);
    }
  }

 private:
  bool is(std::size_t at, Words words) const {
    return at < tokens_.size() && std::ranges::find(words, std::string_view(tokens_[at].text)) != words.end();
  }
  bool are(std::size_t at, Words words) const {
    for (const std::string_view word : words) {
      if (at >= tokens_.size() || tokens_[at++].text != word) return false;
    }
    return true;
  }
  bool is_article(std::size_t at) const {
    return at < tokens_.size() && (lexicon_.is(tokens_[at], WordClass::kIndefinite) || lexicon_.is(tokens_[at], WordClass::kDefinite) ||
                                   lexicon_.is(tokens_[at], WordClass::kPossessive) || lexicon_.is(tokens_[at], WordClass::kNumber) ||
                                   tokens_[at].kind == Token::Kind::kNumber);
  }
  bool is_place(std::size_t at) const { return at < tokens_.size() && lexicon_.find_phrase(tokens_, at).length > 0; }
  bool ends(std::size_t at) const { return at >= tokens_.size() || tokens_[at].kind == Token::Kind::kPunctuation; }
  void leave_out(std::size_t first, std::size_t last) {
    std::fill(skip_.begin() + static_cast<std::ptrdiff_t>(first), skip_.begin() + static_cast<std::ptrdiff_t>(last), true);
  }

  // "Would it be possible for the TV to sit on the cabinet, and for the console to be in it?": the TV sits there.
  void read_possible(std::size_t i) {
    constexpr std::size_t kName = 8, kSentence = 40;  // tokens
    const bool may = is(i, {"would", "could", "might"}) && are(i + 1, {"it", "be", "possible"});
    const bool is_it = is(i, {"is"}) && are(i + 1, {"it", "possible"});
    if (!may && !is_it) return;
    std::size_t at = i + (may ? 4 : 3);
    leave_out(i, at);
    for (const std::size_t last = std::min(tokens_.size(), at + kSentence); at < last && !tokens_[at].ends_sentence; ++at) {
      if (!is(at, {"for"}) || !is_article(at + 1)) continue;
      std::size_t to = at + 2;
      while (to < last && to < at + kName && !is(to, {"to"}) && !ends(to)) ++to;
      if (!is(to, {"to"})) continue;
      leave_out(at, at + 1);
      leave_out(to, to + 1);
      at = to;
    }
  }

  // "Find a spot for the plant by the window", "make room beside the printer for a plant": put it there.
  void read_spot(std::size_t i) {
    constexpr std::size_t kReach = 12;  // tokens
    if (!is(i, {"find", "make", "leave", "reserve", "save", "keep", "have"})) return;
    std::size_t spot = i + 1;
    while (is(spot, {"a", "an", "some", "enough", "good", "nice", "suitable", "the"})) ++spot;
    if (!is(spot, {"spot", "place", "room", "space", "home"})) return;
    if (is(spot + 1, {"for"}) && is_article(spot + 2)) {
      tokens_[i].text = "put";
      leave_out(i + 1, spot + 2);
      return;
    }
    if (!is_place(spot + 1)) return;
    std::size_t on = spot + 1;
    while (on < tokens_.size() && on < spot + kReach && !tokens_[on].ends_sentence && !(is(on, {"for"}) && is_article(on + 1))) ++on;
    if (!is(on, {"for"})) return;
    leave_out(i, spot + 1);
    if (tokens_[on - 1].text == ",") leave_out(on - 1, on);
    tokens_[on].text = "put";
  }

  // "The bottle you're looking for is in the crate"
  void read_looked_for(std::size_t i) {
    const std::size_t at = is(i, {"that", "which"}) ? i + 1 : i;
    if (i == 0 || !is(at, {"you", "we", "i"}) || !is(at + 1, {"are", "am", "were"}) || !is(at + 2, {"looking", "searching"})) return;
    if (is(at + 3, {"for"})) leave_out(i, at + 4);
  }

  // "contains nothing but a suitcase", "its top bare except for a radio"
  void read_nothing_but(std::size_t i) {
    const auto past_except = [&](std::size_t at) {
      if (is(at, {"except", "but", "save"})) return at + (is(at + 1, {"for"}) ? 2 : 1);
      return are(at, {"apart", "from"}) || are(at, {"other", "than"}) ? at + 2 : at;
    };
    const bool nothing = is(i, {"nothing"}), bare = is(i, {"bare", "empty", "clear"});
    const std::size_t past = past_except(i + 1);
    if ((!nothing && !bare) || past == i + 1 || !is_article(past) || i == 0) return;
    if (nothing && !lexicon_.is(tokens_[i - 1], WordClass::kHave) && lexicon_.find_phrase(tokens_, i - 1).length == 0) return;
    if (bare) tokens_[i].text = "with";
    leave_out(bare ? i + 1 : i, past);
  }

  // "bears the weight of four jars"
  void read_weight(std::size_t i) {
    if (i > 0 && are(i, {"the", "weight", "of"}) && is(i - 1, {"bears", "bear", "bearing", "takes", "carries", "supports", "supporting"}))
      leave_out(i, i + 3);
  }

  // "a bench on whose seat a box has been left": on which
  void read_whose(std::size_t i) {
    if (!is(i, {"whose"}) || !is(i + 1, {"seat", "top", "surface", "lid", "tabletop", "shelf", "shelves", "cushion"}) || !is_article(i + 2)) return;
    if (i == 0 || lexicon_.find_phrase(tokens_, i - 1).length == 0) return;
    tokens_[i].text = "which";
    leave_out(i + 1, i + 2);
  }

  // "not on the table but on the stool": on the stool
  void read_not_but(std::size_t i) {
    constexpr std::size_t kReach = 8;  // tokens
    if (!is(i, {"not"}) || !is_place(i + 1)) return;
    for (std::size_t but = i + 2; but < tokens_.size() && but < i + kReach && !tokens_[but].ends_sentence; ++but) {
      if (!is(but, {"but"}) || !is_place(but + 1)) continue;
      leave_out(i, but + 1);
      if (i > 0 && tokens_[i - 1].text == ",") leave_out(i - 1, i);
      return;
    }
  }

  const Lexicon& lexicon_;
  std::vector<Token>& tokens_;
  std::vector<bool>& skip_;
};

}  // namespace

void read_requests(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  RequestReader(lexicon, document.tokens, skip).run();
}

}  // namespace layoutbox::offline
