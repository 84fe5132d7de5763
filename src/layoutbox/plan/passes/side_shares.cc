#include "layoutbox/plan/passes/side_shares.h"

#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/splice.h"

namespace layoutbox::offline {
namespace {

// "three on each long side", "one at both ends", "two per side": at each of two sides so many.
struct Share {
  std::size_t number = 0;  // the token that says how many
  std::size_t side = 0;    // "side", "ends"
  int count = 0;
  bool end = false, long_said = false;
};

class ShareReader {
 public:
  ShareReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) : lexicon_(lexicon), document_(document), skip_(skip) {}

  void run() {
    for (std::size_t i = 1; i < document_.tokens.size() && !is_set(document_.stop); ++i) read(i);
    splice(document_, skip_, std::move(words_));
  }

 private:
  bool is(std::size_t at, std::initializer_list<std::string_view> words) const { return says_one_of(document_, at, words); }

  std::vector<Share> shares_at(std::size_t i) const {
    std::vector<Share> shares;
    for (std::size_t at = i;;) {
      const auto share = share_at(at);
      if (!share) return shares;
      shares.push_back(*share);
      at = share->side + 1;
      while (is(at, {",", "and", "plus", "with"})) ++at;
    }
  }

  std::optional<Share> share_at(std::size_t i) const {
    const NumberRead number = read_number(lexicon_, document_.tokens, i);
    if (number.length != 1) return {};
    Share share{i, i + 1, static_cast<int>(number.value)};
    if (is(share.side, {"per"})) {
      ++share.side;
    } else if (is(share.side, {"on", "at", "along", "down"}) && is(share.side + 1, {"each", "both", "either", "every"})) {
      share.side += is(share.side + 2, {"of"}) ? 4 : 2;
    } else {
      return {};
    }
    share.long_said = is(share.side, {"long", "longer"});
    share.end = is(share.side, {"short", "shorter"});
    if (share.long_said || share.end) ++share.side;
    if (is(share.side, {"end", "ends", "head", "heads"}))
      share.end = true;
    else if (!is(share.side, {"side", "sides"}))
      return {};
    return share;
  }

  // The number of the thing whose name ends before `last`; 0: it has none.
  std::size_t number_before(std::size_t last) const {
    constexpr std::size_t kName = 4;  // words
    for (std::size_t at = last; at-- > 0 && at + kName >= last && document_.tokens[at].kind != Token::Kind::kPunctuation;) {
      const NumberRead number = read_number(lexicon_, document_.tokens, at);
      if (number.length == 1 && at + 1 < last) return at;
    }
    return 0;
  }

  void read(std::size_t i) {
    std::size_t before = i;
    while (before > 0 && is(before - 1, {",", ":", "(", "-", "with", "namely", "so", "placed", "arranged"})) --before;
    if (before == i || before == 0) return;
    const std::string& noun = document_.tokens[before - 1].text;
    const std::size_t number = number_before(before);
    const std::vector<Share> shares = shares_at(i);
    if (number == 0 || shares.size() < 2 || singular_of(noun) == noun) return;
    int sum = 0;
    bool ends = false;
    for (const Share& share : shares) sum += 2 * share.count, ends |= share.end;
    if (sum != static_cast<int>(read_number(lexicon_, document_.tokens, number).value)) return;
    const Token first = document_.tokens[i];
    Token& counted = document_.tokens[number];
    counted.kind = first.kind, counted.text = first.text, counted.number = first.number;
    if (shares.front().count == 1) document_.tokens[before - 1].text = singular_of(noun);
    for (std::size_t t = before; t <= i; ++t) skip_[t] = true;
    for (const Share& share : shares) {
      document_.tokens[share.side].text = share.end && !share.long_said && !is(share.side, {"side", "sides"}) ? "end" : "side";
      if (!is(share.number + 1, {"per"})) document_.tokens[share.number + 2].text = "each";
      if (!share.end && !share.long_said && ends) words_.push_back({share.side, word_token("long")});
    }
  }

  const Lexicon& lexicon_;
  Document& document_;
  std::vector<bool>& skip_;
  std::vector<Splice> words_;
};

}  // namespace

void read_side_shares(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { ShareReader(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
