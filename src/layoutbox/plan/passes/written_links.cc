#include "layoutbox/plan/passes/written_links.h"

#include <optional>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {
namespace {

class WrittenLinks : public TokenReader {
 public:
  WrittenLinks(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : TokenReader(lexicon, document.tokens, skip), document_(document) {}

  void run() {
    for (std::size_t i = 1; i < tokens_.size() && !is_set(document_.stop); ++i) {
      if (skip_[i]) continue;
      read_colon(i);
      read_parts(i);
      read_order(i);
    }
    splice(document_, skip_, std::move(words_));
  }

 private:
  void read_as_with(std::size_t colon) {
    tokens_[colon].kind = Token::Kind::kWord;
    tokens_[colon].text = "with";
    tokens_[colon].ends_sentence = false;
  }

  // "stands a table laid for six: six plates and a candelabra", "here is the desk: a lamp and a mug on it"
  void read_colon(std::size_t colon) {
    constexpr std::size_t kLongest = 8;  // words of the furniture and what is said of it
    if (!is(colon, {":"}) || colon + 1 >= tokens_.size()) return;
    const auto content = thing_named_at(colon + 1);
    const CatalogEntry* small = content ? content->entry : nullptr;
    if (small == nullptr || small->mount != Mount::kSurface) return;
    for (std::size_t at = colon - 1; at > 0 && colon - at <= kLongest && !ends(at); --at) {
      if (!lexicon_.is(tokens_[at], WordClass::kPlaceVerb) && !is(at, {"stands", "is", "are", "stand"})) continue;
      const auto carrier = thing_named_at(at + 1);
      const CatalogEntry* host = carrier ? carrier->entry : nullptr;
      if (host == nullptr || host->mount != Mount::kFloor || !host->top_carries) return;
      if (tells_on(colon)) {
        tokens_[colon].text = ";";
        tokens_[colon].ends_sentence = true;
      } else {
        read_as_with(colon);
      }
      return;
    }
  }

  // "four styling stations: mirrors and chairs": what each of them has.
  void read_parts(std::size_t colon) {
    if (!is(colon, {":"}) || colon < 2 || ends(colon + 1) || is_article(colon + 1)) return;
    const auto part = thing_named_at(colon + 1);
    if (!part || tokens_[part->noun].text == singular_of(tokens_[part->noun].text) || !is(part->last, {"and"})) return;
    for (std::size_t at = colon; at-- > 0 && at + 4 > colon && !ends(at);) {
      const NumberRead number = read_number(lexicon_, tokens_, at);
      const auto things = number.length > 0 && number.value > 1 ? thing_named_at(at) : std::nullopt;
      if (things && things->last == colon) return read_as_with(colon);
    }
  }

  // "…: six plates are on it": a sentence of its own.
  bool tells_on(std::size_t colon) const {
    for (std::size_t at = colon + 1; at < tokens_.size() && !tokens_[at].ends_sentence; ++at) {
      if (is(at, {"is", "are", "stands", "stand", "lies", "lie", "sits", "sit"})) return true;
    }
    return false;
  }

  // The two things that were brought in last before `at`, in the part of the text that names two.
  std::optional<std::pair<NamedThing, NamedThing>> pair_before(std::size_t at) const {
    std::vector<NamedThing> names;
    std::size_t last = at;
    for (int parts = 0; parts < 2; ++parts) {
      std::size_t first = last;
      while (first > 0 && !tokens_[first - 1].ends_sentence) --first;
      names.clear();
      for (std::size_t i = first; i < last; ++i) {
        if (!lexicon_.is(tokens_[i], WordClass::kIndefinite)) continue;
        if (const auto thing = thing_named_at(i); thing && thing->last <= last) names.push_back(*thing);
      }
      if (names.size() >= 2) return std::pair{names[names.size() - 2], names.back()};
      if (first == 0) break;
      last = first - 1;
    }
    return {};
  }

  // "the former has a lamp on it, while the latter is filled with books"
  void read_order(std::size_t at) {
    if (!is(at, {"former", "latter"}) || !is(at - 1, {"the"})) return;
    if (!ends(at + 1) && lexicon_.find(tokens_, at + 1, WordClass::kObject).length > 0) return;  // "the former counter"
    if (is(at, {"former"}) || !named_) named_ = pair_before(at - 1);
    if (!named_) return;
    const NamedThing& thing = is(at, {"former"}) ? named_->first : named_->second;
    for (std::size_t i = thing.name; i < thing.noun; ++i) words_.push_back({at, word_token(tokens_[i].text)});
    tokens_[at].text = tokens_[thing.noun].text;
  }

  Document& document_;
  std::vector<Splice> words_;
  std::optional<std::pair<NamedThing, NamedThing>> named_;  // of the last "former"
};

}  // namespace

void read_written_links(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  WrittenLinks(lexicon, document, skip).run();
}

}  // namespace layoutbox::offline
