// What a thing looks like, said behind it: "a sofa in navy blue", "a chair covered in red leather", "a door painted black and white".
#include <algorithm>

#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

struct LookWords {
  std::vector<std::string> words;
  std::vector<WordClass> classes;
  std::size_t last = 0;  // token after it; 0: none
};

class LookReader {
 public:
  LookReader(const Lexicon& lexicon, std::span<const Token> tokens) : lexicon_(lexicon), tokens_(tokens) {}

  // Colours and materials from `at` on, of which the first may have shades before it.
  LookWords read(std::size_t at) {
    LookWords so_far, whole;
    const std::size_t first = past_shades(at);
    for (std::size_t i = first; take(so_far, i == first ? at : i, i);) {
      if (is_over(i)) whole = so_far, whole.last = i;
      i = past_joiner(i);
      if (i == 0) break;
    }
    return whole;
  }

 private:
  bool is(std::size_t i, WordClass word_class) const { return i < tokens_.size() && lexicon_.is(tokens_[i], word_class); }

  // "soft", "polished", "very dark": what goes before.
  std::size_t past_shades(std::size_t i) const {
    constexpr std::size_t kMost = 3;
    const auto is_shade = [&](std::size_t k) {
      return is(k, WordClass::kQuality) || is(k, WordClass::kStyle) || is(k, WordClass::kAdverb) ||
             word_form(tokens_[k].text) == WordForm::kAdjective || tokens_[k].text.ends_with("able");  // "washable grey"
    };
    for (std::size_t k = 0; k < kMost && i < tokens_.size() && length_at(i) == 0 && is_shade(i); ++k) ++i;
    return i;
  }

  std::size_t length_at(std::size_t i) const {
    if (i >= tokens_.size()) return 0;
    return std::max(lexicon_.find(tokens_, i, WordClass::kColor).length, lexicon_.find(tokens_, i, WordClass::kMaterial).length);
  }

  // The colours and materials at `i`, in a row, with what is before them from `from` on; `i` goes past them.
  bool take(LookWords& look, std::size_t from, std::size_t& i) const {
    bool any = false;
    for (std::size_t length = length_at(i); length > 0; length = length_at(i), from = i) {
      const bool color = lexicon_.find(tokens_, i, WordClass::kColor).length == length;
      look.words.push_back(text_of(tokens_, from, i + length));
      look.classes.push_back(color ? WordClass::kColor : WordClass::kMaterial);
      i += length;
      any = true;
    }
    return any;
  }

  // "blue and white", "red, green and gold"; 0: nothing is joined.
  std::size_t past_joiner(std::size_t i) const {
    if (i + 1 >= tokens_.size()) return 0;
    const bool joins = tokens_[i].text == "," || tokens_[i].text == "-" || is(i, WordClass::kAnd);
    return joins && length_at(i + 1) > 0 ? i + 1 : 0;
  }

  // No noun of such a look follows: "in a glass cabinet", "in white boxes".
  bool is_over(std::size_t i) const {
    return i >= tokens_.size() || tokens_[i].kind == Token::Kind::kPunctuation || is(i, WordClass::kAnd) || is(i, WordClass::kHave) ||
           is(i, WordClass::kBe) || is(i, WordClass::kPlaceVerb) || is(i, WordClass::kParticiple) || is(i, WordClass::kRelative) ||
           lexicon_.find_phrase(tokens_, i).length > 0 || tokens_[i].ends_sentence;
  }

  const Lexicon& lexicon_;
  std::span<const Token> tokens_;
};

}  // namespace

// Where the look begins that is said right behind a noun, after "in", "of", "painted a", "upholstered in"; 0: nowhere.
std::size_t Chunker::look_begins() const {
  std::size_t i = i_;
  const bool covered = one_of(tokens_[i].text, WordSet::kCoveredWith);
  if (covered) ++i;
  const bool within = i < tokens_.size() && one_of(tokens_[i].text, {"in", "of", "from", "with"});
  if (within && (covered || tokens_[i].text != "with")) ++i;
  if (i == i_ || i >= tokens_.size()) return 0;
  if (tokens_[i].text == "a" || tokens_[i].text == "an") {
    // "in a deep green"; "in a rose", "in a glass" is inside
    const bool color =
        lexicon_.find(tokens_, i + 1, WordClass::kColor).length > 0 || word_form(tokens_[i + 1].text) == WordForm::kAdjective;
    const bool thing = lexicon_.find(tokens_, i + 1, WordClass::kObject).length > 0;
    if (i + 1 >= tokens_.size() || !color || thing) return 0;
    ++i;
  }
  return i;
}

bool Chunker::read_look() {
  // "a sofa, in dark green,"
  const bool parted_off = previous() == ChunkKind::kComma && chunks_.size() > 1 && chunks_.back().last == i_ && tokens_[i_].text == "in" &&
                          chunks_[chunks_.size() - 2].kind == ChunkKind::kNoun && chunks_[chunks_.size() - 2].last == chunks_.back().first;
  if (!parted_off && (previous() != ChunkKind::kNoun || chunks_.empty() || chunks_.back().last != i_)) return false;
  NounPhrase& noun = chunks_[chunks_.size() - (parted_off ? 2 : 1)].noun;
  if (noun.kind != NounKind::kObject && noun.kind != NounKind::kPart && noun.kind != NounKind::kDoor && noun.kind != NounKind::kWindow)
    return false;
  const std::size_t from = look_begins();
  if (from == 0) return false;
  const LookWords look = LookReader(lexicon_, tokens_).read(from);
  const bool of = tokens_[i_].text == "of" || tokens_[i_].text == "from";  // "a bed of gold", but "a jar of honey"
  const bool stuff = std::ranges::any_of(look.classes, [](WordClass c) { return c == WordClass::kMaterial; });
  if (look.last == 0 || (of && !stuff && !one_of(look.words.back(), {"gold", "silver"}))) return false;
  // "in a black, glass cabinet"; "in teal velvet, walnut tv unit" goes on with another thing
  const bool parted =
      look.last < tokens_.size() && tokens_[look.last].text == "," && !lexicon_.is(tokens_[from - 1], WordClass::kIndefinite);
  const auto longer = parted ? std::nullopt : read_noun_phrase(lexicon_, tokens_, from, true);
  if (longer && longer->last > look.last) return false;
  noun.attributes.insert(noun.attributes.end(), look.words.begin(), look.words.end());
  noun.attribute_classes.resize(noun.attributes.size() - look.words.size(), WordClass::kQuality);
  noun.attribute_classes.insert(noun.attribute_classes.end(), look.classes.begin(), look.classes.end());
  add(ChunkKind::kIgnored, look.last - i_);
  return true;
}

}  // namespace layoutbox::offline
