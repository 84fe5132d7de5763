// Distances, rows and sizes that stand by themselves.
#include <algorithm>
#include <array>
#include <string_view>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

// "50 cm apart": a row with that much between its members.
const PhraseSenses& row_senses() {
  static const PhraseSenses senses{{RelationType::kRow, PhraseSense::Direction::kAlone, {}, {}, {}}};
  return senses;
}

const PhraseSenses& grid_senses() {
  static const PhraseSenses senses{{RelationType::kGrid, PhraseSense::Direction::kAlone, {}, {}, {}}};
  return senses;
}

}  // namespace

// "with a gap of 40 cm", "leaving a 40 cm gap", "at a distance of 50 cm".
Chunker::Gap Chunker::gap_here() const {
  Gap gap{i_, false, false};
  if (length_of(WordClass::kAtLeast) > 0) return gap;  // "at least 1 m from it"
  const auto skip = [&](std::initializer_list<std::string_view> words) {
    const bool found = gap.at < tokens_.size() && std::find(words.begin(), words.end(), tokens_[gap.at].text) != words.end();
    gap.at += found ? 1 : 0;
    return found;
  };
  gap.led = skip({"with", "leaving", "leave", "keeping", "keep", "at"});
  const std::size_t article = gap.at;
  if (skip({"a", "an"}) && gap.at < tokens_.size() && lexicon_.is(tokens_[gap.at], WordClass::kUnit))
    gap.at = article;  // "with a metre between"
  if (says_gap(gap.at) && gap.at + 1 < tokens_.size() && tokens_[gap.at + 1].text == "of") return {gap.at + 2, gap.led, true};
  return gap.led ? gap : Gap{i_, false, false};
}

bool Chunker::says_gap(std::size_t at) const { return at < tokens_.size() && one_of(tokens_[at].text, WordSet::kGaps); }

// Past the word for the gap after its length, or `at`: "600 mm gap", "40 cm of free space".
std::size_t Chunker::gap_ends(std::size_t at) const {
  std::size_t word = at;
  if (word < tokens_.size() && tokens_[word].text == "of") ++word;
  if (word < tokens_.size() && tokens_[word].text == "free") ++word;
  return says_gap(word) ? word + 1 : at;
}

// "a metre apart", "a foot from the wall": one of that unit.
bool Chunker::is_one_unit(std::size_t at) const {
  static constexpr std::array<std::string_view, 7> kAfter = {"apart", "away", "from", "between", "behind", "above", "below"};
  if (at + 2 >= tokens_.size() || tokens_[at].text != "a" || !lexicon_.is(tokens_[at + 1], WordClass::kUnit)) return false;
  const bool beyond = tokens_[at + 2].text == "in" && at + 3 < tokens_.size() && tokens_[at + 3].text == "front";
  const bool within = at > 0 && tokens_[at - 1].text == "within" && tokens_[at + 2].text == "of";
  return beyond || within || std::find(kAfter.begin(), kAfter.end(), tokens_[at + 2].text) != kAfter.end() || says_gap(at + 2);
}

std::optional<Measure> Chunker::read_unit(std::size_t at) const {
  for (const Meaning& meaning : lexicon_.find(tokens_, at + 1, WordClass::kUnit).meanings) {
    if (meaning.word_class == WordClass::kUnit) return Measure{meaning.value, 2};
  }
  return std::nullopt;
}

// "Bed 140 cm against the left wall": so wide, and not so far from it; or no phrase at all.
bool Chunker::takes_no_distance(std::size_t at, const Measure& measure, const PhraseMatch& phrase) const {
  if (phrase.length == 0) return true;
  if (!says(*phrase.senses, RelationType::kAgainstWall)) return false;
  if (at != i_ + measure.length || chunks_.empty() || chunks_.back().kind != ChunkKind::kNoun) return false;
  const CatalogEntry* entry = chunks_.back().noun.entry;
  const Mm width = mm_from_m(measure.metres);
  return entry != nullptr && entry->is(Trait::kBed) && entry->size.least.width <= width && width <= entry->size.greatest.width;
}

bool Chunker::read_distance() {
  std::size_t at = i_;
  const auto skip_class = [&](WordClass word_class) {
    const std::size_t length = lexicon_.find(tokens_, at, word_class).length;
    at += length;
    return length > 0;
  };
  bool at_least = false, at_most = false;
  const Gap gap = gap_here();
  bool apart = gap.said;
  at = gap.at;
  if (at >= tokens_.size()) return false;
  if (tokens_[at].text == "within") at_most = true, ++at;
  at_least = skip_class(WordClass::kAtLeast) || skip_class(WordClass::kMoreThan);
  at_most |= skip_class(WordClass::kAtMost);
  skip_class(WordClass::kExactly);
  const bool one = at < tokens_.size() && is_one_unit(at);
  const auto measure = one ? read_unit(at) : read_measure(lexicon_, tokens_, at);
  if (!measure) return false;
  at += measure->length;
  // "a table, 1.2 m by 0.8": a size
  if (at + 1 < tokens_.size() && (tokens_[at].text == "by" || tokens_[at].text == "x") && tokens_[at + 1].kind == Token::Kind::kNumber)
    return false;
  if (lexicon_.find(tokens_, at, WordClass::kDimension).length > std::max<std::size_t>(lexicon_.find_phrase(tokens_, at).length, 1))
    return false;
  if (const std::size_t end = gap_ends(at); !apart && end > at) apart = true, at = end;
  at_least |= one_of(tokens_[i_].text, {"keep", "keeping", "leave", "leaving"});
  if (read_kept_free(at, measure->metres)) return true;
  const auto next_is = [&](std::initializer_list<std::string_view> words) {
    return at < tokens_.size() && std::find(words.begin(), words.end(), tokens_[at].text) != words.end();
  };
  if (gap.led && !apart && !next_is({"between", "in"})) return false;
  if (apart && next_is({"in"}) && at + 1 < tokens_.size() && tokens_[at + 1].text == "between") ++at;
  if (apart && !next_is({"from", "to", "between"})) {
    if (at < tokens_.size() && lexicon_.find_phrase(tokens_, at).length > 0) return false;  // "80 cm of space around it": kept free
    Chunk& chunk = add(ChunkKind::kRelation, at - i_);
    chunk.phrase = PhraseMatch{chunk.last - chunk.first, &distance_senses()};
    chunk.distance = measure->metres;
    return true;
  }
  if (at >= tokens_.size()) return false;
  while (at < tokens_.size() && (tokens_[at].text == "away" || tokens_[at].text == "of") && at + 1 < tokens_.size()) {
    if (tokens_[at].text == "of" && !at_most) return false;
    ++at;
  }
  if (tokens_[at].text == "apart") {
    Chunk& chunk = add(ChunkKind::kRelation, at + 1 - i_);
    chunk.phrase = PhraseMatch{chunk.last - chunk.first, &row_senses()};
    chunk.distance = measure->metres;
    return true;
  }
  if (tokens_[at].text == "between") {
    Chunk& chunk = add(ChunkKind::kRelation, at + 1 - i_);
    chunk.phrase = lexicon_.find_phrase(tokens_.first(at + 1), at);  // "them" is whom it is between
    chunk.distance = measure->metres;
    chunk.at_least = at_least;
    chunk.at_most = at_most;
    chunk.gap = true;
    return true;
  }
  const PhraseMatch phrase = lexicon_.find_phrase(tokens_, at);
  const bool from =
      tokens_[at].text == "from" || (apart && tokens_[at].text == "to") || tokens_[at - 1].text == "of" || tokens_[at].text == "off";
  if (!from && takes_no_distance(at, *measure, phrase)) return false;
  const std::size_t first = i_;
  const std::size_t length = at - first + (tokens_[at - 1].text == "of" ? 0 : from ? 1 : phrase.length);
  Chunk& chunk = add(ChunkKind::kRelation, length);
  chunk.phrase = from ? PhraseMatch{length, &distance_senses()} : phrase;
  chunk.distance = measure->metres;
  chunk.at_least = at_least;
  chunk.at_most = at_most;
  return true;
}

// "85 cm free in front of the toilet", "2 m clear before and behind the saw", "1.5 m of turning space before the bed": floor that is kept
// free, at those sides of what comes next.
bool Chunker::read_kept_free(std::size_t at, double metres) {
  if (at < tokens_.size() && tokens_[at].text == "of") ++at;
  const std::size_t said = at;
  while (at < tokens_.size() && one_of(tokens_[at].text, WordSet::kKeptFree)) ++at;
  if (at == said) return false;
  while (at < tokens_.size() && one_of(tokens_[at].text, {"floor", "space", "room", "circle", "radius"})) ++at;
  const PhraseMatch phrase = at < tokens_.size() ? lexicon_.find_phrase(tokens_, at) : PhraseMatch{};
  if (phrase.length == 0) return false;
  static const PhraseSenses kFront = direct_senses<RelationType::kInFrontOf>(), kBack = direct_senses<RelationType::kBehind>();
  static const PhraseSenses kBoth = {kFront.front(), kBack.front()};
  const auto front = [](const PhraseMatch& match) { return match.length > 0 && says(*match.senses, RelationType::kInFrontOf); };
  const auto back = [](const PhraseMatch& match) { return match.length > 0 && says(*match.senses, RelationType::kBehind); };
  std::size_t end = at + phrase.length;
  bool before = front(phrase), behind = back(phrase);
  if (!before && !behind) return false;
  if (end + 1 < tokens_.size() && tokens_[end].text == "and") {
    const PhraseMatch second = lexicon_.find_phrase(tokens_, end + 1);
    if (front(second) || back(second)) end += 1 + second.length, before |= front(second), behind |= back(second);
  }
  Chunk& chunk = add(ChunkKind::kRelation, end - i_);
  chunk.phrase = PhraseMatch{chunk.last - chunk.first, before && behind ? &kBoth : before ? &kFront : &kBack};
  chunk.distance = metres;
  chunk.gap = true;
  return true;
}

bool Chunker::read_rows() {
  std::size_t at = i_;
  if (tokens_[at].text != "in" && tokens_[at].text != "into") return false;
  ++at;
  const auto number = [&]() {
    if (at >= tokens_.size()) return 0;
    if (tokens_[at].kind == Token::Kind::kNumber) return static_cast<int>(std::clamp(tokens_[at++].number, 0.0, 1000.0));
    const Match match = lexicon_.find(tokens_, at, WordClass::kNumber);
    if (match.length == 0) return 0;
    at += match.length;
    for (const Meaning& meaning : match.meanings) {
      if (meaning.word_class == WordClass::kNumber) return static_cast<int>(meaning.value);
    }
    return 0;
  };
  const bool rows_of = at + 1 < tokens_.size() && tokens_[at].text == "rows" && tokens_[at + 1].text == "of";  // "of three" abreast
  const int rows = rows_of ? 0 : number();
  if (at < tokens_.size() && (tokens_[at].text == "neat" || tokens_[at].text == "straight" || tokens_[at].text == "parallel")) ++at;
  const bool columns_first = at < tokens_.size() && tokens_[at].text == "columns";
  if (at >= tokens_.size() || (tokens_[at].text != "rows" && !columns_first)) return false;
  ++at;
  int columns = 0;
  if (at + 1 < tokens_.size() && tokens_[at].text == "of") {
    const std::size_t before = at++;
    columns = number();
    if (columns == 0) at = before;
  }
  if (rows_of && (columns < 2 || (at < tokens_.size() && lexicon_.find(tokens_, at, WordClass::kObject).length > 0))) return false;
  Chunk& chunk = add(ChunkKind::kRelation, at - i_);
  chunk.phrase = PhraseMatch{chunk.last - chunk.first, &grid_senses()};
  chunk.rows = columns_first ? columns : rows;
  chunk.columns = columns_first ? rows : columns;
  return true;
}

// "W 100 D 60 H 200", "w: 1.2 m, d: 0.6 m": sides by their letters, at least two; in centimetres where no unit is said.
bool Chunker::read_lettered_size() {
  SaidSize size;
  std::size_t at = i_, sides = 0;
  while (at + 1 < tokens_.size() && tokens_[at].end == tokens_[at].begin + 1) {
    const char letter = tokens_[at].text[0];  // a "w" alone was written out as "with"
    std::optional<double>* side = letter == 'w'   ? &size.width
                                  : letter == 'd' ? &size.depth
                                  : letter == 'h' ? &size.height
                                  : letter == 'l' ? &size.length
                                                  : nullptr;
    const std::size_t number = at + (tokens_[at + 1].text == ":" ? 2 : 1);
    if (side == nullptr || number >= tokens_.size() || tokens_[number].kind != Token::Kind::kNumber) break;
    const auto measure = read_measure(lexicon_, tokens_, number);
    constexpr double kCentimetre = 0.01;
    *side = measure ? measure->metres : tokens_[number].number * kCentimetre;
    at = number + (measure ? measure->length : 1);
    ++sides;
    if (at + 1 < tokens_.size() && (tokens_[at].text == "x" || tokens_[at].text == ",") && tokens_[at + 1].text.size() == 1) ++at;
  }
  if (sides < 2) return false;
  add(ChunkKind::kSize, at - i_).size = size;
  return true;
}

// "a sofa 220 cm", "a sofa (220 cm)": its width, where the length ends what is said of it.
// "a counter of 3 m along the wall": how long it is, not how far from the wall.
bool Chunker::follows_of() const {
  return i_ > 0 && tokens_[i_ - 1].text == "of" && previous() == ChunkKind::kNoun && chunks_.size() > 1 &&
         chunks_.back().kind == ChunkKind::kIgnored && chunks_[telling_].noun.kind == NounKind::kObject &&
         chunks_[telling_].last == chunks_.back().first;
}

bool Chunker::read_bare_length() {
  const bool bracketed = i_ > 0 && tokens_[i_ - 1].text == "(" && chunks_.size() > 1;
  const bool of = follows_of();
  const Chunk* const said_of = chunks_.empty() ? nullptr : &chunks_[chunks_.size() - (bracketed || of ? 2 : 1)];
  const bool follows = said_of != nullptr && said_of->kind == ChunkKind::kNoun && (bracketed || previous() == ChunkKind::kNoun);
  const auto measure = follows ? read_measure(lexicon_, tokens_, i_) : std::nullopt;
  if (!measure || said_of->noun.kind != NounKind::kObject || said_of->noun.size.any()) return false;
  const std::size_t end = i_ + measure->length;
  constexpr double kShortest = 0.25, kLongest = 8;  // metres
  if (measure->metres < kShortest || measure->metres > kLongest) return false;
  const bool ends = of || end >= tokens_.size() || tokens_[end].text == (bracketed ? ")" : ",") || tokens_[end].ends_sentence ||
                    one_of(tokens_[end].text, {"and", "with", "along", "in", "under", "beneath", "below"});
  if (!ends) return false;
  add(ChunkKind::kSize, measure->length).size.width = measure->metres;
  return true;
}

// In metres, of lengths that nobody gave a unit: "a bed (140x200)", "BED 1.6x2.0", "a rug 2 x 3"; 0: they may be anything.
double Chunker::bare_unit(const std::vector<double>& values) const {
  constexpr double kFewestCentimetres = 30, kMostMetres = 5;
  if (values.size() < 2) return 0;
  const auto [least, most] = std::ranges::minmax(values);
  if (least >= kFewestCentimetres) return 0.01;
  const bool of_one = previous() == ChunkKind::kNoun && chunks_.back().noun.kind == NounKind::kObject && !chunks_.back().noun.plural;
  return of_one && most <= kMostMetres ? 1 : 0;
}

bool Chunker::read_size_chunk() {
  SaidSize size;
  if (const std::size_t taken = previous() == ChunkKind::kStop ? 0 : read_size_of(lexicon_, tokens_, i_, size);
      taken > 0 && !(lexicon_.is(tokens_[i_], WordClass::kIndefinite) && noun_goes_on(lexicon_, tokens_, i_ + taken))) {
    add(ChunkKind::kSize, taken).size = size;
    return true;
  }
  std::size_t at = i_;
  std::vector<double> values;
  double unit = 0;
  while (at < tokens_.size()) {
    const auto measure = read_measure(lexicon_, tokens_, at);
    if (!measure && tokens_[at].kind != Token::Kind::kNumber) break;
    values.push_back(measure ? measure->metres : tokens_[at].number);
    if (measure) {
      unit = measure->metres / std::max(read_number(lexicon_, tokens_, at).value, 1e-9);
      SaidSize named;
      const std::size_t taken = read_size(lexicon_, tokens_, at, named);
      if (taken > 0 && values.size() == 1) {  // "120 cm wide and 60 cm deep" comes in two
        // Before a noun it belongs to the noun phrase.
        constexpr std::array kStandsAfter = {ChunkKind::kNoun, ChunkKind::kComma, ChunkKind::kAnd, ChunkKind::kVerb, ChunkKind::kIgnored};
        if (std::ranges::find(kStandsAfter, previous()) == kStandsAfter.end()) return false;
        if (at + taken < tokens_.size() && lexicon_.find(tokens_, at + taken, WordClass::kObject).length > 0) return false;
        Chunk& chunk = add(ChunkKind::kSize, at + taken - i_);
        chunk.size = named;
        return true;
      }
    }
    at += measure ? measure->length : 1;
    if (at + 1 < tokens_.size() && (tokens_[at].text == "x" || tokens_[at].text == "by" || tokens_[at].text == "*") &&
        tokens_[at + 1].kind == Token::Kind::kNumber) {
      ++at;
      continue;
    }
    break;
  }
  if (unit == 0) unit = bare_unit(values);
  if (values.size() < 2 || unit == 0 || noun_goes_on(lexicon_, tokens_, at)) return false;
  // One unit at the end holds for all: "120 x 60 cm".
  std::size_t check = i_;
  for (double& value : values) {
    const auto measure = read_measure(lexicon_, tokens_, check);
    if (!measure) value *= unit;
    check += (measure ? measure->length : 1) + 1;
  }
  size.width = values[0];
  size.depth = values[1];
  if (values.size() > 2) size.height = values[2];
  size.either = true;  // "a car, 4.5 m by 1.8 m": the longer side is the one that such a thing has
  Chunk& chunk = add(ChunkKind::kSize, at - i_);
  chunk.size = size;
  return true;
}

}  // namespace layoutbox::offline
