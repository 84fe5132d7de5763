#include "layoutbox/plan/passes/alternatives.h"

#include <optional>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {
namespace {

class AlternativeReader : public TokenReader {
 public:
  AlternativeReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : TokenReader(lexicon, document.tokens, skip), document_(document) {}

  void run() {
    for (std::size_t i = 1; i + 1 < tokens_.size(); ++i) {
      if (!is(i, {"or"}) || skip_[i] || take_look(i)) continue;
      const std::size_t end = past_thing(i + 1);
      if (end == 0 || !ends_thing(i) || is_denied(i)) continue;
      leave_out(i, end);
      const std::optional<std::size_t> either = either_before(i);
      if (either) keep_first(*either, i);
      document_.notes.push_back({"ignored", "of what \"or\" joins the first is taken, not \"" + words_between(document_, i, end) + "\"",
                                 "prompt:" + std::to_string(tokens_[i].begin) + "-" + std::to_string(tokens_[end - 1].end)});
    }
  }

 private:
  static constexpr std::size_t kFarthest = 40;  // tokens back: the time stays linear in the text

  // "a red or blue chair", "a table in oak or walnut": of two looks the first.
  bool take_look(std::size_t at) {
    const auto looks = [&](std::size_t i) {
      return lexicon_.is(tokens_[i], WordClass::kColor) || lexicon_.is(tokens_[i], WordClass::kMaterial) ||
             lexicon_.is(tokens_[i], WordClass::kShape);
    };
    const bool both = looks(at - 1) && looks(at + 1) && !is_denied(at);
    if (both) leave_out(at, at + 2);
    return both;
  }

  // Past a thing with its article and what it is like, 0 where none is named there.
  std::size_t past_thing(std::size_t at) const {
    const std::optional<NamedThing> thing = thing_named_at(at);
    return thing ? thing->last : 0;
  }

  // The words before `at` end in the name of a thing.
  bool ends_thing(std::size_t at) const {
    constexpr std::size_t kLongest = 4;
    for (std::size_t first = at - 1; first + kLongest >= at; --first) {
      const Match match = lexicon_.find(tokens_, first);
      if (meaning_of(match, WordClass::kObject) != nullptr && first + match.length == at) return true;
      if (first == 0) break;
    }
    return false;
  }

  // "no TV or sofa", "neither a desk or a table": none of them.
  bool is_denied(std::size_t at) const {
    for (const std::size_t or_at = at; at-- > 0 && at + kFarthest > or_at && !tokens_[at].ends_sentence;) {
      if (is(at, {"no", "not", "without", "neither", "never", "nor", "avoid", "exclude", "skip", "than"})) return true;
    }
    return false;
  }

  std::optional<std::size_t> either_before(std::size_t at) const {
    while (at-- > 0 && !tokens_[at].ends_sentence && !is(at, {"or"})) {
      if (is(at, {"either"}) && !is(at + 1, {"side", "end", "of"})) return at;
    }
    return std::nullopt;
  }

  // "either a desk, a table or a bench": what is between the first and the last of them.
  void keep_first(std::size_t either, std::size_t at) {
    leave_out(either, either + 1);
    const std::size_t first = past_thing(either + 1);
    for (std::size_t i = first; first > 0 && i < at;) {
      const std::size_t end = is(i, {","}) ? past_thing(i + 1) : 0;
      if (end == 0 || end > at) return;
      leave_out(i, end);
      i = end;
    }
  }

  Document& document_;
};

}  // namespace

void read_alternatives(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  AlternativeReader(lexicon, document, skip).run();
}

}  // namespace layoutbox::offline
