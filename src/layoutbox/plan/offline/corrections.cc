#include "layoutbox/plan/offline/corrections.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace layoutbox::offline {
namespace {

using Class = WordClass;

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
  return token.kind == Token::Kind::kNumber || lexicon.is(token, Class::kNumber);
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

// "two chairs, no wait, three, beside a table": the last number counts.
void read_numbers_taken_back(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  constexpr std::size_t kBack = 8;  // tokens
  std::vector<Token>& tokens = document.tokens;
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    const std::size_t marker = tokens[i - 1].text == "," ? marker_at(tokens, i) : 0;
    std::size_t number = i + marker;
    while (marker > 0 && number < tokens.size() && tokens[number].text == ",") ++number;
    if (marker == 0 || number + 1 >= tokens.size() || !is_count(lexicon, tokens[number]) ||
        tokens[number + 1].kind != Token::Kind::kPunctuation)
      continue;
    std::size_t counted = i - 1;
    while (counted > 0 && counted + kBack > i && !is_count(lexicon, tokens[counted])) --counted;
    if (!is_count(lexicon, tokens[counted])) continue;
    tokens[counted].text = tokens[number].text;
    tokens[counted].kind = tokens[number].kind;
    tokens[counted].number = tokens[number].number;
    std::fill(skip.begin() + static_cast<std::ptrdiff_t>(i) - 1, skip.begin() + static_cast<std::ptrdiff_t>(number) + 2, true);
    if (tokens[number + 1].ends_sentence) skip[number + 1] = false;
  }
}

}  // namespace

void read_corrected_counts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  read_numbers_taken_back(lexicon, document, skip);
  std::vector<Token>& tokens = document.tokens;
  for (std::size_t i = 1; i + 2 < tokens.size(); ++i) {
    if (!makes(tokens, i) || !is_count(lexicon, tokens[i + 2])) continue;
    const bool ends = i + 3 >= tokens.size() || tokens[i + 3].kind == Token::Kind::kPunctuation || lexicon.is(tokens[i + 3], Class::kAnd) ||
                      tokens[i + 3].text == "please";
    const std::size_t lead = lead_of(tokens, i);
    if (!ends || lead == 0) continue;
    std::size_t counted = lead;
    while (counted-- > 0 && !is_count(lexicon, tokens[counted]) && !lexicon.is(tokens[counted], Class::kIndefinite)) {
      if (counted == 0 || (tokens[counted].ends_sentence && counted + 1 < lead)) break;
    }
    if (counted >= lead || (!is_count(lexicon, tokens[counted]) && !lexicon.is(tokens[counted], Class::kIndefinite))) continue;
    tokens[counted].text = tokens[i + 2].text;
    tokens[counted].kind = tokens[i + 2].kind;
    tokens[counted].number = tokens[i + 2].number;
    std::fill(skip.begin() + static_cast<std::ptrdiff_t>(lead), skip.begin() + static_cast<std::ptrdiff_t>(i + 3), true);
  }
}

void settle_corrected_places(Document& document) {
  constexpr std::size_t kReach = 40;  // chunks: the time stays linear in the text
  std::vector<Chunk>& chunks = document.chunks;
  const auto stops = [&](std::size_t k) { return chunks[k].kind == ChunkKind::kStop; };
  for (std::size_t k = 1; k < chunks.size(); ++k) {
    if (!(stops(k - 1) || chunks[k - 1].kind == ChunkKind::kComma) || marker_at(document.tokens, chunks[k].first) == 0) continue;
    // What is put elsewhere is spoken of as "it", and where is said.
    std::size_t again = k;
    bool placed = false;
    for (std::size_t c = k; c < std::min(chunks.size(), k + kReach) && !stops(c); ++c) {
      const NounPhrase& noun = chunks[c].noun;
      if (chunks[c].kind == ChunkKind::kNoun && noun.kind == NounKind::kPronoun && again == k) again = c;
      placed |= again > k && chunks[c].kind == ChunkKind::kRelation;
    }
    if (!placed) continue;
    std::size_t place = k - 1;
    while (place > 0 && stops(place)) --place;
    while (place > 0 && place + kReach > k && chunks[place].kind != ChunkKind::kRelation && !stops(place)) --place;
    if (chunks[place].kind != ChunkKind::kRelation) continue;
    for (std::size_t c = place; c < again; ++c) {
      if (!stops(c)) chunks[c].kind = ChunkKind::kIgnored;
    }
  }
}

}  // namespace layoutbox::offline
