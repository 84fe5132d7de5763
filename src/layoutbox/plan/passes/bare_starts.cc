#include "layoutbox/plan/passes/bare_starts.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/noun_phrase.h"
#include "layoutbox/plan/phrases/splice.h"

namespace layoutbox::offline {
namespace {

class BareStarts {
 public:
  BareStarts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : lexicon_(lexicon), document_(document), tokens_(document.tokens), skip_(skip) {}

  void run() {
    for (std::size_t i = 4; i + 1 < tokens_.size() && !is_set(document_.stop); ++i) front_under_it(i);
    for (std::size_t i = 0; i < tokens_.size() && !is_set(document_.stop); ++i) {
      if (skip_[i]) continue;
      if (!complete_side(i) && !complete_place(i)) repeat_noun(i);
      name_it(i);
    }
    splice(document_, skip_, std::move(words_));
    halves();
  }

 private:
  bool is(std::size_t at, std::initializer_list<std::string_view> words) const { return says_one_of(document_, at, words); }
  bool breaks(std::size_t at) const {
    return at >= tokens_.size() || tokens_[at].kind == Token::Kind::kPunctuation || (at > 0 && tokens_[at - 1].ends_sentence);
  }
  bool begins_clause(std::size_t at) const {
    return at == 0 || tokens_[at - 1].ends_sentence || tokens_[at - 1].kind == Token::Kind::kPunctuation || is(at - 1, {"and"});
  }
  void put(std::size_t at, std::string_view word) { words_.push_back({at, word_token(word)}); }
  void put_article(std::size_t at, const std::string& noun) { put(at, noun == singular_of(noun) ? "a" : "some"); }

  std::size_t past_looks(std::size_t at) const {
    constexpr std::size_t kMost = 3;
    const std::size_t first = at;
    while (at < tokens_.size() && at < first + kMost && !breaks(at) &&
           (lexicon_.is(tokens_[at], WordClass::kSizeWord) || lexicon_.is(tokens_[at], WordClass::kColor) ||
            lexicon_.is(tokens_[at], WordClass::kMaterial)))
      ++at;
    return at;
  }

  // Where the thing ends that is named at `at`, its looks first; 0: none is.
  std::size_t thing_at(std::size_t at) const {
    for (std::size_t noun = past_looks(at) + 1; noun-- > at;) {  // "glass cabinet" is one by name
      if (breaks(noun)) continue;
      const Match match = lexicon_.find(tokens_, noun);
      if (std::ranges::find(match.meanings, WordClass::kObject, &Meaning::word_class) != match.meanings.end()) return noun + match.length;
    }
    return 0;
  }

  // Where a noun phrase with its article or number begins at `at`.
  bool is_determined(std::size_t at) const {
    return !breaks(at) && (lexicon_.is(tokens_[at], WordClass::kIndefinite) || read_number(lexicon_, tokens_, at).length > 0);
  }

  // "on left side", "at back end": of which no article is said.
  bool complete_side(std::size_t i) {
    if (!is(i, {"on", "at", "in"}) || !is(i + 1, {"left", "right", "back", "front", "far"}) || !is(i + 2, {"side", "end", "corner"}))
      return false;
    if (tokens_[i].ends_sentence || tokens_[i + 1].ends_sentence) return false;
    put(i + 1, "the");
    const std::size_t thing = i + 3;
    if (begins_clause(i) && !breaks(thing) && !is_determined(thing)) {
      if (const std::size_t last = thing_at(thing); last > 0) put_article(thing, tokens_[last - 1].text);
    }
    return true;
  }

  // "Behind counter wooden shelves": behind the counter some wooden shelves.
  bool complete_place(std::size_t i) {
    constexpr std::size_t kKnown = 4;  // words: "in front of", "on top of"
    if (!begins_clause(i)) return false;
    std::size_t at = i;
    if (is(i, {"behind", "beside", "opposite", "above", "under", "below", "over", "near", "by", "on"})) at = i + 1;
    if (is(i, {"next"}) && is(i + 1, {"to"})) at = i + 2;
    if (is(i, {"in"}) && is(i + 1, {"front"}) && is(i + 2, {"of"})) at = i + 3;
    if (at == i || at > i + kKnown || breaks(at) || is_determined(at)) return false;
    const std::size_t opening =
        std::max(lexicon_.find(tokens_, at, WordClass::kDoor).length, lexicon_.find(tokens_, at, WordClass::kWindow).length);
    const std::size_t thing = thing_at(at), last = thing == 0 && opening > 0 ? at + opening : thing;
    if (last == 0 || breaks(last) || tokens_[last - 1].text != singular_of(tokens_[last - 1].text)) return false;
    const bool determined = is_determined(last);
    const std::size_t other = determined ? 0 : thing_at(last);
    if (!determined && other == 0) return false;
    put(at, "the");
    if (!determined) put_article(last, tokens_[other - 1].text);
    return true;
  }

  // "one chair facing the door, two opposite": two chairs, which the first is none of.
  void repeat_noun(std::size_t i) {
    constexpr std::size_t kBack = 25;  // tokens
    const NumberRead number = read_number(lexicon_, tokens_, i);
    const std::size_t place = i + number.length + (is(i + number.length, {"more", "others", "other"}) ? 1 : 0);
    if (number.length == 0 || !begins_clause(i) || !is(place, {"opposite"}) || i == 0) return;
    if (!breaks(place + 1) && !is(place + 1, {"it", "them", "and"})) return;
    for (std::size_t at = i; at-- > 0 && i - at < kBack && !tokens_[at].ends_sentence;) {
      const Match thing = lexicon_.find(tokens_, at);
      const auto is_seat = [](const Meaning& m) {
        return m.entry != nullptr && (m.entry->is(Trait::kSeat) || m.entry->is(Trait::kEasySeat));
      };
      if (thing.length == 0 || std::ranges::none_of(thing.meanings, is_seat)) continue;
      const std::size_t last = at + thing.length;
      // "three chairs, two on one side, one opposite": of those
      if (breaks(last) || tokens_[last].text == ":") return;
      for (std::size_t k = last; k < i; ++k) {
        const std::size_t counted = read_number(lexicon_, tokens_, k).length;
        if (counted > 0 && lexicon_.find_phrase(tokens_, k + counted).length > 0) return;
      }
      for (std::size_t k = i + number.length; k < place; ++k) skip_[k] = true;
      for (std::size_t k = at; k < last; ++k) put(place, k + 1 < last || number.value > 1 ? tokens_[k].text : singular_of(tokens_[k].text));
      return;
    }
  }

  // The only meaning as a thing of what begins at `at`.
  const CatalogEntry* entry_at(std::size_t at) const {
    const Match match = lexicon_.find(tokens_, at);
    const auto thing = std::ranges::find(match.meanings, WordClass::kObject, &Meaning::word_class);
    return thing == match.meanings.end() ? nullptr : thing->entry;
  }

  // "a screen on the wall, a credenza with a machine and glasses under it": under it the credenza, as the glasses are on that.
  void front_under_it(std::size_t i) {
    constexpr std::size_t kLongest = 12;  // tokens
    if (skip_[i] || !is(i, {"under", "below", "beneath", "underneath"}) || !is(i + 1, {"it"}) || !breaks(i + 2)) return;
    std::size_t with = i;
    while (with > 1 && i - with < kLongest && !is(with, {"with"}) && !tokens_[with - 1].ends_sentence) --with;
    if (!is(with, {"with"})) return;
    int small = 0;
    for (std::size_t k = with + 1; k < i; k += std::max<std::size_t>(lexicon_.find(tokens_, k).length, 1)) {
      const CatalogEntry* entry = entry_at(k);
      if (entry != nullptr && entry->mount != Mount::kSurface) return;
      small += entry != nullptr ? 1 : 0;
    }
    std::size_t begin = with;
    while (begin > 0 && !begins_clause(begin)) --begin;
    const bool determined = is_determined(begin);
    if (small < 2 || begin == with || thing_at(begin + (determined ? 1 : 0)) != with) return;
    bool hung = false;
    for (std::size_t k = begin; k-- > 0 && !tokens_[k].ends_sentence;) {
      const CatalogEntry* entry = entry_at(k);
      hung = hung || (entry != nullptr && (entry->mount == Mount::kWall || entry->is(Trait::kScreen)));
    }
    if (!hung) return;
    std::swap(tokens_[i - 1].ends_sentence, tokens_[i + 1].ends_sentence);
    move_before(document_, skip_, begin, i, i + 2);
    if (!determined) splice(document_, skip_, {{begin + 2, word_token("a")}});
  }

  // "a counter over them and a basket on it": over them. A basket on the counter.
  void name_it(std::size_t i) {
    constexpr std::size_t kReach = 7;  // tokens
    if (i < 2 || !is(i, {"them"}) || !is(i - 1, {"over", "above", "under", "across", "behind", "below"})) return;
    std::size_t noun = 0;
    for (std::size_t k = i > 4 ? i - 4 : 0; k + 1 < i && noun == 0; ++k) {
      if (entry_at(k) != nullptr && k + lexicon_.find(tokens_, k).length == i - 1) noun = k;
    }
    const std::string& head = tokens_[i - 2].text;
    if (noun == 0 || head != singular_of(head)) return;
    begin_own_clause(noun);
    if (tokens_[i].ends_sentence || !is(i + 1, {"and"})) return;
    for (std::size_t it = i + 3; it < tokens_.size() && it < i + kReach && !tokens_[it - 1].ends_sentence; ++it) {
      if (!is(it, {"it"}) || !is(it - 1, {"on", "under", "above", "beside", "below"})) continue;
      tokens_[i].ends_sentence = skip_[i + 1] = true;
      tokens_[it].text = head;
      words_.push_back({it, word_token("the")});
      for (std::size_t k = noun; k + 2 < i; ++k) words_.push_back({it, word_token(tokens_[k].text)});
      return;
    }
  }

  // "a washer and a dryer with a counter over them": of both, so not the dryer's.
  void begin_own_clause(std::size_t noun) {
    constexpr std::size_t kBack = 12;  // tokens
    std::size_t with = noun;
    while (with > 0 && noun - with < 4 && !is(with, {"with"})) --with;
    if (!is(with, {"with"})) return;
    for (std::size_t k = with; k-- > 0 && with - k < kBack && !breaks(k) && !tokens_[k].ends_sentence && !is(k, {"with"});) {
      if (!is(k, {"and"})) continue;
      tokens_[with].kind = Token::Kind::kPunctuation;
      tokens_[with].text = ",";
      return;
    }
  }

  // "a fan in both halves", "two fans in each half": the same in the left half and in the right half.
  void halves() {
    for (std::size_t i = 2; i + 2 < tokens_.size() && !is_set(document_.stop); ++i) {
      if (skip_[i] || !is(i, {"in"}) || !is(i + 1, {"both", "each", "either"}) || breaks(i + 2)) continue;
      const std::size_t half = i + (is(i + 2, {"the"}) ? 3 : 2);
      if (!is(half, {"half", "halves"}) || (is(half + 1, {"of"}) && !is(half + 3, {"room", "hall", "space"}))) continue;
      std::size_t noun = i;
      while (noun > 0 && !breaks(noun - 1) && !tokens_[noun - 1].ends_sentence && !is(noun - 1, {"and", "with", "is", "are"})) --noun;
      if (noun == i || thing_at(noun + (is_determined(noun) ? 1 : 0)) != i) continue;
      tokens_[half].text = "half";
      tokens_[i + 1].text = "the";
      for (std::size_t k = i + 2; k < half; ++k) skip_[k] = true;
      put(half, "left");
      const std::size_t after = half + 1;
      const bool ends = tokens_[half].ends_sentence;
      tokens_[half].ends_sentence = false;
      put(after, "and");
      for (std::size_t k = noun; k < i; ++k) words_.push_back({after, tokens_[k]});
      for (const std::string_view word : {"in", "the", "right", "half"}) put(after, word);
      words_.back().token.ends_sentence = ends;
    }
    splice(document_, skip_, std::move(words_));
  }

  const Lexicon& lexicon_;
  Document& document_;
  std::vector<Token>& tokens_;
  std::vector<bool>& skip_;
  std::vector<Splice> words_;
};

}  // namespace

void complete_bare_starts(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  BareStarts(lexicon, document, skip).run();
}

}  // namespace layoutbox::offline
