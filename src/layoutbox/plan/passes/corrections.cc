#include "layoutbox/plan/passes/corrections.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {
namespace {

constexpr std::array<std::array<std::string_view, 3>, 11> kMarkers{{{"no", "wait", ""},
                                                                    {"wait", "no", ""},
                                                                    {"scratch", "that", ""},
                                                                    {"strike", "that", ""},
                                                                    {"hang", "on", ""},
                                                                    {"hold", "on", ""},
                                                                    {"on", "second", "thought"},
                                                                    {"on", "second", "thoughts"},
                                                                    {"actually", "no", ""},
                                                                    {"no", "actually", ""},
                                                                    {"correction", "", ""}}};

// Of the words from `at`, how many say that what was said is taken back. Punctuation between them does not count.
std::size_t marker_at(const std::vector<Token>& tokens, std::size_t at) {
  for (const auto& marker : kMarkers) {
    std::size_t t = at;
    bool same = true;
    for (const std::string_view word : marker) {
      if (word.empty()) break;
      while (t > at && t < tokens.size() && tokens[t].text == ",") ++t;
      same = same && t < tokens.size() && tokens[t].text == word;
      ++t;
    }
    if (same) return t - at;
  }
  return 0;
}

bool is_count(const Lexicon& lexicon, const Token& token) {
  return token.kind == Token::Kind::kNumber || lexicon.is(token, WordClass::kNumber);
}

// "make that", "make it", "make them".
bool makes(const std::vector<Token>& tokens, std::size_t at) {
  if (at + 1 >= tokens.size() || tokens[at].text != "make") return false;
  const std::string& what = tokens[at + 1].text;
  return what == "that" || what == "it" || what == "them" || what == "those";
}

// The words before "make that" that lead to it: ", no wait, actually".
std::size_t lead_of(const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::array<std::string_view, 9> kLeading{"actually", "no", "wait", "sorry", "or", "rather", ",", "oh", "hmm"};
  while (at > 0 && !tokens[at - 1].ends_sentence && std::ranges::find(kLeading, tokens[at - 1].text) != kLeading.end()) --at;
  return at;
}

// What is said again: "two chairs, no wait, three", "a sofa, I mean a loveseat". What it is said instead of is left out.
class Retakes : public TokenReader {
 public:
  using TokenReader::TokenReader;

  void run() {
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      const std::size_t again = past_markers(i);
      if (again > i && !skip_[i] && !take_number(i, again)) take_thing(i, again);
    }
  }

 private:
  static constexpr std::size_t kReachBack = 14;  // tokens

  // Where what is said instead begins, after all that takes back what was said; `at` itself where nothing does.
  std::size_t past_markers(std::size_t at) const {
    const bool parted = tokens_[at - 1].kind == Token::Kind::kPunctuation;
    if (!parted) return are(at, {"or", "rather"}) ? at + 2 : at;
    bool takes_back = false, only_no = true;
    std::size_t t = at;
    for (;;) {
      const std::size_t taken = marker_at(tokens_, t);
      const bool mean = are(t, {"i", "mean"});
      if (taken > 0 || mean || is(t, {"actually", "sorry", "rather", "wait", "no"})) {
        only_no = only_no && is(t, {"no"}) && taken == 0;
        takes_back = true;
        t += taken > 0 ? taken : mean ? 2 : 1;
      } else if (is(t, {"oh", "hmm", "um", "well", "or"}) || (takes_back && is(t, {",", "just", "only", "better"}))) {
        ++t;
      } else {
        break;
      }
    }
    if (!takes_back || (only_no && !is(t - 1, {",", "just", "only"}))) return at;  // "no sofa"
    return t;
  }

  std::size_t past_sign(std::size_t at) const { return is(at, {",", ")"}) ? at + 1 : at; }

  // "…, no wait, three, beside a table": the last number counts.
  bool take_number(std::size_t marker, std::size_t number) {
    if (number >= tokens_.size() || !is_count(lexicon_, tokens_[number]) || !ends(number + 1) || tokens_[marker - 1].ends_sentence)
      return false;
    std::size_t counted = marker - 1;
    while (counted > 0 && counted + kReachBack > marker && !is_count(lexicon_, tokens_[counted])) --counted;
    if (!is_count(lexicon_, tokens_[counted])) return false;
    set_count(counted, number);
    leave_out(marker - 1, past_sign(number + 1));
    return true;
  }

  void set_count(std::size_t to, std::size_t from) {
    tokens_[to].text = tokens_[from].text;
    tokens_[to].kind = tokens_[from].kind;
    tokens_[to].number = tokens_[from].number;
  }

  std::optional<NamedThing> thing_with_article(std::size_t at) const { return is_article(at) ? thing_named_at(at) : std::nullopt; }

  // The thing that was named last before `marker`, or that of the same name.
  std::optional<NamedThing> named_before(std::size_t marker, std::string_view name) const {
    for (std::size_t at = marker - 1; at > 0 && at + kReachBack > marker; --at) {
      const std::optional<NamedThing> named = thing_with_article(at - 1);
      if (named && named->last < marker && (name.empty() || singular_of(tokens_[named->noun].text) == name)) return named;
    }
    return std::nullopt;
  }

  // "…, no, sorry, one armchair": instead of what was named right before, or as many of what is called the same.
  void take_thing(std::size_t marker, std::size_t at) {
    const std::optional<NamedThing> now = thing_with_article(at);
    if (!now || is(now->last, {"too", "also", "as", "instead"})) return;
    const bool parted = tokens_[marker - 1].kind == Token::Kind::kPunctuation;
    const std::size_t sign = parted ? marker - 1 : marker;
    const std::optional<NamedThing> same = named_before(marker, singular_of(tokens_[now->noun].text));
    const std::optional<NamedThing> last = tokens_[sign].ends_sentence ? same : named_before(marker, {});
    if (last && last->last == sign) {
      leave_out(last->first, at);
      if (is(now->last, {")"})) leave_out(now->last, now->last + 1);
    } else if (same) {
      set_count(same->first, now->first);
      leave_out(tokens_[sign].ends_sentence ? marker : sign, past_sign(now->last));
    }
  }
};

}  // namespace

void read_corrected_counts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  Retakes(lexicon, document.tokens, skip).run();
  std::vector<Token>& tokens = document.tokens;
  for (std::size_t i = 1; i + 2 < tokens.size(); ++i) {
    if (!makes(tokens, i) || !is_count(lexicon, tokens[i + 2])) continue;
    const bool ends = i + 3 >= tokens.size() || tokens[i + 3].kind == Token::Kind::kPunctuation ||
                      lexicon.is(tokens[i + 3], WordClass::kAnd) || tokens[i + 3].text == "please";
    const std::size_t lead = lead_of(tokens, i);
    if (!ends || lead == 0) continue;
    std::size_t counted = lead;
    while (counted-- > 0 && !is_count(lexicon, tokens[counted]) && !lexicon.is(tokens[counted], WordClass::kIndefinite)) {
      if (counted == 0 || (tokens[counted].ends_sentence && counted + 1 < lead)) break;
    }
    if (counted >= lead || (!is_count(lexicon, tokens[counted]) && !lexicon.is(tokens[counted], WordClass::kIndefinite))) continue;
    tokens[counted].text = tokens[i + 2].text;
    tokens[counted].kind = tokens[i + 2].kind;
    tokens[counted].number = tokens[i + 2].number;
    std::fill(skip.begin() + static_cast<std::ptrdiff_t>(lead), skip.begin() + static_cast<std::ptrdiff_t>(i + 3), true);
  }
}

void settle_corrected_places(Document& document) {
  constexpr std::size_t kChunksBack = 40;  // chunks: the time stays linear in the text
  std::vector<Chunk>& chunks = document.chunks;
  const auto stops = [&](std::size_t k) { return chunks[k].kind == ChunkKind::kStop; };
  for (std::size_t k = 1; k < chunks.size(); ++k) {
    if (!(stops(k - 1) || chunks[k - 1].kind == ChunkKind::kComma) || marker_at(document.tokens, chunks[k].first) == 0) continue;
    // What is put elsewhere is spoken of as "it", and where is said.
    std::size_t again = k;
    bool placed = false;
    for (std::size_t c = k; c < std::min(chunks.size(), k + kChunksBack) && !stops(c); ++c) {
      const NounPhrase& noun = chunks[c].noun;
      if (chunks[c].kind == ChunkKind::kNoun && noun.kind == NounKind::kPronoun && again == k) again = c;
      placed |= again > k && chunks[c].kind == ChunkKind::kRelation;
    }
    if (!placed) continue;
    std::size_t place = k - 1;
    while (place > 0 && stops(place)) --place;
    while (place > 0 && place + kChunksBack > k && chunks[place].kind != ChunkKind::kRelation && !stops(place)) --place;
    if (chunks[place].kind != ChunkKind::kRelation) continue;
    for (std::size_t c = place; c < again; ++c) {
      if (!stops(c)) chunks[c].kind = ChunkKind::kIgnored;
    }
  }
}

}  // namespace layoutbox::offline
