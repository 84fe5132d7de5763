#include "layoutbox/plan/room/coordinates.h"

#include <algorithm>

#include "layoutbox/base/units.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/phrases/token_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

class CoordinateReader : public TokenReader {
 public:
  CoordinateReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : TokenReader(lexicon, document.tokens, skip), document_(document) {}

  void run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      CoordinatesSaid said;
      std::size_t last = read_named(i, said);
      if (last == 0) last = read_pair(i, said);
      if (last == 0) continue;
      std::size_t first = i;
      while (first > 0 && is(first - 1, WordSet::kBeforeCoordinates)) --first;
      said.begin = tokens_[i].begin;
      leave_out(first, last);
      for (std::size_t n = first; n < last; ++n) document_.readings[n].role = "where it is, by coordinates";
      document_.coordinates.push_back(said);
      i = last - 1;
    }
  }

 private:
  // A length, with or without its unit; the place behind it, 0: none.
  std::size_t read_metres(std::size_t i, std::optional<double>& metres) const {
    if (i >= tokens_.size() || tokens_[i].kind != Token::Kind::kNumber) return 0;
    const auto measure = read_measure(lexicon_, tokens_, i);
    metres = measure ? measure->metres : tokens_[i].number;
    return i + (measure ? measure->length : 1);
  }

  // "x=3.0", "x = 1 m, y = 0.5 m"
  std::size_t read_named(std::size_t i, CoordinatesSaid& said) const {
    std::size_t last = 0;
    while (is(i, {"x", "y"})) {
      if (i > 0 && last == 0 && tokens_[i - 1].kind == Token::Kind::kNumber) return 0;  // "4 x 3 m"
      if (!is(i + 1, {"=", ":"})) return last;
      const std::size_t end = read_metres(i + 2, is(i, {"x"}) ? said.x : said.y);
      if (end == 0) return last;
      last = i = end;
      while (is(i, {",", "and"})) ++i;
    }
    return last;
  }

  // "at (5.6, 0.4)": two numbers in brackets; a third one is a height, which follows from what it stands on.
  std::size_t read_pair(std::size_t i, CoordinatesSaid& said) const {
    if (!is(i, {"("}) || i == 0 || !is(i - 1, WordSet::kBeforeCoordinates)) return 0;
    std::size_t end = read_metres(i + 1, said.x);
    if (end == 0 || !is(end, {",", ";"})) return 0;
    end = read_metres(end + 1, said.y);
    std::optional<double> height;
    if (end > 0 && is(end, {","})) end = read_metres(end + 1, height);
    return end > 0 && is(end, {")"}) ? end + 1 : 0;
  }

  Document& document_;
};

bool is_placed(const Chunk& chunk) {
  return chunk.kind == ChunkKind::kNoun &&
         (chunk.noun.kind == NounKind::kObject || chunk.noun.kind == NounKind::kDoor || chunk.noun.kind == NounKind::kWindow);
}

bool ends_sentence_between(const Document& document, std::size_t first, std::size_t last) {
  return std::any_of(document.tokens.begin() + static_cast<std::ptrdiff_t>(first),
                     document.tokens.begin() + static_cast<std::ptrdiff_t>(last), [](const Token& t) { return t.ends_sentence; });
}

NounPhrase* noun_told(Document& document, std::size_t begin) {
  std::size_t at = 0;  // the first token behind the place
  while (at < document.tokens.size() && document.tokens[at].begin < begin) ++at;
  NounPhrase *before = nullptr, *behind = nullptr;
  for (Chunk& chunk : document.chunks) {
    if (!is_placed(chunk)) continue;
    if (chunk.last <= at && !ends_sentence_between(document, chunk.last, at)) before = &chunk.noun;
    if (chunk.first >= at && behind == nullptr && !ends_sentence_between(document, at, chunk.first)) behind = &chunk.noun;
  }
  return before != nullptr ? before : behind;
}

// "0.3 m from the west corner" right behind a door or window, its wall or its size: how far, which corner, and the place behind it.
struct CornerSaid {
  double metres = 0;
  std::string corner;
  std::size_t last = 0;
};
CornerSaid corner_said_at(const Lexicon& lexicon, const Document& document, std::size_t i) {
  const std::vector<Token>& tokens = document.tokens;
  const auto measure = i < tokens.size() ? read_measure(lexicon, tokens, i) : std::nullopt;
  if (!measure) return {};
  std::size_t n = i + measure->length;
  if (!says_one_of(document, n, {"from", "off"})) return {};
  for (++n; says_one_of(document, n, {"the", "its"});) ++n;
  const Match side = lexicon.find(tokens, n, WordClass::kWallWord);
  if (side.length == 0 || !says_one_of(document, n + side.length, {"corner", "end", "wall", "side"})) return {};
  return {measure->metres, std::string(meaning_of(side, WordClass::kWallWord)->word), n + side.length + 1};
}

// "sill at 0.8 m", "sill height 90 cm", "a 50 cm sill": how high, and the place behind it.
struct SillSaid {
  double metres = 0;
  std::size_t last = 0;
};
SillSaid sill_said_at(const Lexicon& lexicon, const Document& document, std::size_t i) {
  const std::vector<Token>& tokens = document.tokens;
  if (i < tokens.size() && tokens[i].kind == Token::Kind::kNumber) {
    const auto before = read_measure(lexicon, tokens, i);
    const std::size_t end = before ? i + before->length : 0;
    return before && says_one_of(document, end, {"sill"}) ? SillSaid{before->metres, end + 1} : SillSaid{};
  }
  if (!says_one_of(document, i, {"sill", "sills"})) return {};
  std::size_t n = i + 1;
  while (says_one_of(document, n, {"height", "at", "of", "is", ":", "=", "a"})) ++n;
  const auto measure = n < tokens.size() ? read_measure(lexicon, tokens, n) : std::nullopt;
  return measure ? SillSaid{measure->metres, n + measure->length} : SillSaid{};
}

}  // namespace

void read_coordinates(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  CoordinateReader(lexicon, document, skip).run();
}

void settle_coordinates(const Lexicon& lexicon, Document& document) {
  for (const CoordinatesSaid& said : document.coordinates) {
    NounPhrase* noun = noun_told(document, said.begin);
    if (noun == nullptr || noun->count > 1) continue;
    if (said.x) noun->place.x = mm_from_m(*said.x);
    if (said.y) noun->place.y = mm_from_m(*said.y);
  }
  for (std::size_t i = 0; i < document.tokens.size(); ++i) {
    const SillSaid sill = sill_said_at(lexicon, document, i);
    if (NounPhrase* window = sill.last == 0 ? nullptr : noun_told(document, document.tokens[i].begin);
        window != nullptr && window->kind == NounKind::kWindow) {
      window->sill = sill.metres;
      take_chunks(document, i, sill.last, "how high the sill is");
    }
    const CornerSaid said = corner_said_at(lexicon, document, i);
    NounPhrase* noun = said.last == 0 ? nullptr : noun_told(document, document.tokens[i].begin);
    if (noun == nullptr || noun->kind == NounKind::kObject || noun->count > 1) continue;
    noun->place.corner = said.corner;
    noun->place.from_corner = mm_from_m(said.metres);
    take_chunks(document, i, said.last, "where in its wall");
  }
}

}  // namespace layoutbox::offline
