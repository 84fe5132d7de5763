#include "layoutbox/plan/passes/wording_table.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <charconv>
#include <functional>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"

namespace layoutbox::offline {
namespace {

using Element = WordingElement;
using ElementClass = Element::Class;
using Look = Element::Look;

std::vector<std::string_view> parted(std::string_view text, char by) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(by), text.size());
    if (end > 0) parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

std::vector<std::string_view> texts_of(WordList row, std::string_view key) {
  std::vector<std::string_view> texts;
  if (!row.contains(key)) return texts;
  for (const WordList::Member member : row.at(key)) texts.push_back(member.value.text());
  return texts;
}

ElementClass class_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, ElementClass>, 15> kClasses = {{{"article", ElementClass::kArticle},
                                                                                   {"number", ElementClass::kNumber},
                                                                                   {"definite", ElementClass::kDefinite},
                                                                                   {"object", ElementClass::kObject},
                                                                                   {"room", ElementClass::kRoom},
                                                                                   {"window", ElementClass::kWindow},
                                                                                   {"unit", ElementClass::kUnit},
                                                                                   {"person", ElementClass::kPerson},
                                                                                   {"screen", ElementClass::kScreen},
                                                                                   {"color", ElementClass::kColor},
                                                                                   {"look", ElementClass::kLook},
                                                                                   {"word", ElementClass::kWord},
                                                                                   {"plain", ElementClass::kPlain},
                                                                                   {"begin", ElementClass::kBegin},
                                                                                   {"end", ElementClass::kEnd}}};
  const auto* found = std::ranges::find(kClasses, name, &std::pair<std::string_view, ElementClass>::first);
  return found == kClasses.end() ? ElementClass::kNone : found->second;
}

bool taken_off(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

// "x?" and "x{1,4}": how often.
void read_count(std::string_view& text, Element& element) {
  if (text.ends_with('?')) {
    element.least = 0;
    text.remove_suffix(1);
  } else if (const std::size_t brace = text.find('{'); brace != std::string_view::npos && text.ends_with('}')) {
    const char* const end = text.data() + text.size();
    const auto least = std::from_chars(text.data() + brace + 1, end, element.least);
    std::from_chars(least.ptr + 1, end, element.most);
    text = text.substr(0, brace);
  }
}

Element read_element(std::string_view text, WordList lists) {
  Element element;
  if (taken_off(text, "after!")) element.look = Look::kAfterNot;
  if (taken_off(text, "after:")) element.look = Look::kAfter;
  if (taken_off(text, "!")) element.look = Look::kNot;
  element.left_out = taken_off(text, "-");
  if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
    element.becomes = text.substr(equals + 1);
    text = text.substr(0, equals);
  }
  read_count(text, element);
  if (text.starts_with('<') && text.ends_with('>')) {
    element.kind = class_of(text.substr(1, text.size() - 2));
  } else if (taken_off(text, "@")) {
    element.words = texts_of(lists, text);
  } else {
    element.words = parted(text, '|');
  }
  return element;
}

std::vector<Wording> read_rows() {
  const WordList file = word_list("words_wordings");
  std::vector<Wording> rows;
  for (const WordList::Member member : file.at("wordings")) {
    Wording row;
    row.name = member.value.at("name").text();
    for (const std::string_view says : texts_of(member.value, "says")) {
      std::vector<Element>& elements = row.says.emplace_back();
      for (const std::string_view element : parted(says, ' ')) elements.push_back(read_element(element, file.at("lists")));
    }
    row.only_with = texts_of(member.value, "if");
    row.unless = texts_of(member.value, "unless");
    const std::vector<std::string_view> as = texts_of(member.value, "as");
    row.example = as.front();
    row.plain = as.back();
    rows.push_back(std::move(row));
  }
  return rows;
}

// The words of a text, a bit each of a few; some share one: what it lacks is not in the text.
class WordBits {
 public:
  void add(std::string_view word) { bits_.set(bit_of(word)); }
  bool may_have(std::string_view word) const { return bits_.test(bit_of(word)); }

 private:
  static constexpr std::size_t kBits = 2048;
  static std::size_t bit_of(std::string_view word) { return std::hash<std::string_view>{}(word) % kBits; }
  std::bitset<kBits> bits_;
};

// Must a word of it stand in the text?
bool is_needed(const Element& element) {
  return element.kind == ElementClass::kNone && element.least > 0 && !element.words.empty() &&
         (element.look == Look::kHere || element.look == Look::kAfter);
}

class TableReader : public TokenReader {
 public:
  using TokenReader::TokenReader;

  void run() {
    for (const Token& token : tokens_) there_.add(token.text);
    for (const Wording& row : wordings()) {
      if ((!row.only_with.empty() && !has_any(row.only_with)) || has_any(row.unless)) continue;
      for (const std::vector<Element>& says : row.says) {
        if (may_stand(says)) read(says);
      }
    }
  }

 private:
  // Most texts lack a word that the row needs, and are not looked through for it.
  bool may_stand(const std::vector<Element>& says) const {
    return std::ranges::all_of(says, [&](const Element& element) {
      return !is_needed(element) || std::ranges::any_of(element.words, [&](std::string_view word) { return there_.may_have(word); });
    });
  }

  bool has_any(const std::vector<std::string_view>& words) const {
    return std::ranges::any_of(
        words, [&](std::string_view word) { return std::ranges::any_of(tokens_, [&](const Token& token) { return token.text == word; }); });
  }

  void read(const std::vector<Element>& says) {
    ends_.resize(says.size());
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (skip_[i] || !holds(says, 0, i)) continue;
      std::size_t from = i;
      for (std::size_t e = 0; e < says.size(); from = ends_[e++]) rewrite(says[e], from, ends_[e]);
    }
  }

  void rewrite(const Element& element, std::size_t first, std::size_t last) {
    if (element.left_out) leave_out(first, last);
    if (element.becomes.empty() || first == last) return;
    tokens_[first].text = element.becomes;
    if (is_left_alone(first)) tokens_[first].glued = false;
    there_.add(element.becomes);
    tokens_[first].kind = Token::Kind::kWord;
  }

  // "20 seven-year-olds" as "20 children": all that it was joined to is left out.
  bool is_left_alone(std::size_t at) const {
    while (at > 0 && tokens_[at].glued) {
      if (!skip_[--at]) return false;
    }
    return true;
  }

  // The elements from `e` on stand at `at`; where each of them ends is in `ends_`.
  bool holds(const std::vector<Element>& says, std::size_t e, std::size_t at) {
    if (e == says.size()) return true;
    const Element& element = says[e];
    if (element.look != Look::kHere) {
      const bool before = element.look == Look::kAfter || element.look == Look::kAfterNot;
      const bool there = before ? at > 0 && !tokens_[at - 1].ends_sentence && length(element, at - 1) == 1 : length(element, at) > 0;
      if (there != (element.look == Look::kAfter)) return false;
      ends_[e] = at;
      return holds(says, e + 1, at);
    }
    if (element.kind == ElementClass::kBegin || element.kind == ElementClass::kEnd) {
      if (element.kind == ElementClass::kBegin ? !begins(at) : !ends(at)) return false;
      ends_[e] = at;
      return holds(says, e + 1, at);
    }
    for (int count = 0; count <= element.most; ++count) {
      if (count >= element.least) {
        ends_[e] = at;
        if (holds(says, e + 1, at)) return ends_[e] = at, true;
      }
      const std::size_t taken = count < element.most ? length(element, at) : 0;
      if (taken == 0) return false;
      at += taken;
    }
    return false;
  }

  // The tokens that one of `element` takes there; 0: it does not stand there.
  std::size_t length(const Element& element, std::size_t at) const {
    if (at >= tokens_.size()) return 0;
    if (element.kind == ElementClass::kNone) return std::ranges::find(element.words, tokens_[at].text) != element.words.end() ? 1 : 0;
    if (ends(at)) return 0;
    switch (element.kind) {
      case ElementClass::kArticle: return is_article(at) ? 1 : 0;
      case ElementClass::kDefinite: return lexicon_.is(tokens_[at], WordClass::kDefinite) ? 1 : 0;
      case ElementClass::kNumber: return read_number(lexicon_, tokens_, at).length;
      case ElementClass::kObject: return thing_at(at);
      case ElementClass::kRoom: return is(at, {"room"}) ? 1 : lexicon_.find(tokens_, at, WordClass::kRoom).length;
      case ElementClass::kWindow: return lexicon_.find(tokens_, at, WordClass::kWindow).length;
      case ElementClass::kColor: return lexicon_.find(tokens_, at, WordClass::kColor).length;
      case ElementClass::kLook: return look_at(at);
      case ElementClass::kUnit: return lexicon_.find(tokens_, at, WordClass::kUnit).length;
      case ElementClass::kPerson: return lexicon_.is_person(singular_of(tokens_[at].text)) ? 1 : 0;
      case ElementClass::kPlain: return thing_at(at) == 0 ? 1 : 0;
      case ElementClass::kScreen: return is_screen(at) ? 1 : 0;
      default: return 1;
    }
  }

  // "desk", "desks"
  std::size_t thing_at(std::size_t at) const {
    const Match match = lexicon_.find(tokens_, at);
    return meaning_of(match, WordClass::kObject) != nullptr ? match.length : lexicon_.find(tokens_, at, WordClass::kObject).length;
  }

  // "dark blue", "oak", and what joins them
  std::size_t look_at(std::size_t at) const {
    if (is(at, {"and", "dark", "light", "pale", "soft", "deep", "bright"})) return 1;
    return std::max(lexicon_.find(tokens_, at, WordClass::kColor).length, lexicon_.find(tokens_, at, WordClass::kMaterial).length);
  }

  bool is_screen(std::size_t at) const {
    const Match match = lexicon_.find(tokens_, at, WordClass::kObject);
    const Meaning* thing = meaning_of(match, WordClass::kObject);
    return match.length == 1 && thing != nullptr && thing->entry != nullptr && thing->entry->is(Trait::kScreen);
  }

  std::vector<std::size_t> ends_;  // of the elements that were found
  WordBits there_;
};

}  // namespace

const std::vector<Wording>& wordings() {
  static const std::vector<Wording> rows = read_rows();
  return rows;
}

void read_wording_table(const Lexicon& lexicon, std::vector<Token>& tokens, std::vector<bool>& skip) {
  TableReader(lexicon, tokens, skip).run();
}

}  // namespace layoutbox::offline
