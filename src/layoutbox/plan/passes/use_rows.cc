#include "layoutbox/plan/passes/use_rows.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"

namespace layoutbox::offline {

// Behind "all the", "about a hundred", "her three".
std::size_t UseRows::past_quantity(std::size_t at) const {
  constexpr std::size_t kMost = 4;  // tokens
  if (is(at, {"all", "about", "around", "roughly", "some", "nearly", "over"}) && is_article(at + 1)) ++at;
  for (std::size_t taken = 0; taken < kMost && is_article(at); ++taken) ++at;
  // "four pairs of boots"
  if (is(at, {"pairs", "lots", "stacks", "piles", "heaps", "sets", "pair", "pile", "stack"}) && is(at + 1, {"of"})) at += 2;
  return at;
}

std::size_t UseRows::matched(std::string_view words, std::size_t at) const {
  const std::size_t first = at;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    while (at > first && is_article(at) && tokens_[at].text != word) ++at;
    if (at == first) at = past_quantity(at);
    if (at >= tokens_.size() || tokens_[at].text.empty()) return 0;
    const bool alike = tokens_[at].text.front() == word.front();  // no plural begins otherwise
    if (!alike || (tokens_[at].text != word && singular_of(tokens_[at].text) != singular_of(word))) return 0;
    ++at;
  }
  return at - first;
}

std::optional<UseRows::Use> UseRows::longest(std::string_view list, std::size_t at, int people) const {
  std::optional<Use> best;
  for (const WordList::Member row : words_.at("uses")) {
    if (!row.value.contains(list)) continue;
    for (const WordList::Member words : row.value.at(list)) {
      const std::size_t length = matched(words.value.text(), at);
      if (length > 0 && (!best || at + length > best->end)) best = Use{row.value, at + length, people};
    }
  }
  return best;
}

std::optional<UseRows::Use> UseRows::to_do(std::size_t at, int people) const {
  const auto done = longest("to", at, people);
  if (done) return done;
  const std::size_t length = keeping(at);
  return length > 0 ? longest("for", at + length, people) : std::nullopt;
}

std::size_t UseRows::keeping(std::size_t at) const {
  for (const WordList::Member word : words_.at("keep")) {
    if (const std::size_t length = matched(word.value.text(), at); length > 0) return length;
  }
  return 0;
}

std::string_view UseRows::room() const {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    for (const Meaning& meaning : lexicon_.find(tokens_, i, WordClass::kRoom).meanings) {
      if (meaning.word_class == WordClass::kRoom && meaning.room != nullptr) return meaning.room->id;
    }
  }
  return {};
}

bool UseRows::is_served(const Use& use, std::size_t first) const {
  if (!use.row.contains("unless")) return false;
  for (const WordList::Member words : use.row.at("unless")) {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const bool outside = i < first || i >= use.end;
      if (outside && !skip_[i] && tokens_[i].kind == Token::Kind::kWord && matched(words.value.text(), i) > 0) return true;
    }
  }
  return false;
}

std::string_view UseRows::thing_of(const Use& use, std::string_view room) {
  if (use.row.contains("rooms")) {
    for (const WordList::Member kind : use.row.at("rooms")) {
      if (kind.key == room) return kind.value.text();
    }
  }
  return use.row.at("is").text();
}

}  // namespace layoutbox::offline
