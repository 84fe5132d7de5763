#include "layoutbox/plan/syntax/sentence.h"

#include <algorithm>

namespace layoutbox::syntax {
namespace {

std::uint32_t shape_of(std::string_view text) {
  bool digit = false, letter = false, other = false;
  for (const char c : text) {
    if (c >= '0' && c <= '9') {
      digit = true;
    } else if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) {
      letter = true;
    } else {
      other = true;
    }
  }
  const std::uint32_t length = std::min<std::uint32_t>(static_cast<std::uint32_t>(text.size()), 4);
  return (digit ? 1U : 0U) | (letter ? 2U : 0U) | (other ? 4U : 0U) | length << 3;
}

bool likely_verb(const Word& word) {
  static const std::uint64_t ing = word_key("ing"), ed = word_key("ed");
  constexpr std::uint32_t kCanBeVerb = 2, kMostlyVerb = 1;  // WordInfo's bits
  const std::uint32_t parts = word.info.parts();
  return (parts & kCanBeVerb) != 0 && parts >> 4 == kMostlyVerb && word.suffix3 != ing && word.suffix2 != ed;
}

std::uint64_t ending(std::string_view text, std::size_t letters) {
  return text.size() > letters ? word_key(text.substr(text.size() - letters)) : 1;
}

}  // namespace

Word read_word(std::string_view text, const Weights& weights) {
  Word word;
  word.key = word_key(text);
  word.suffix2 = ending(text, 2);
  word.suffix3 = ending(text, 3);
  word.suffix4 = ending(text, 4);
  word.prefix = text.size() > 3 ? word_key(text.substr(0, 3)) : 1;
  word.shape = shape_of(text);
  word.info.bits = weights.info(word.key);
  return word;
}

TaggedSentence read_sentence(std::span<const std::string_view> words, const Weights& weights) {
  TaggedSentence sentence;
  sentence.words.reserve(words.size());
  sentence.likely_verbs.assign(1, 0);
  for (const std::string_view word : words) {
    sentence.words.push_back(read_word(word, weights));
    sentence.likely_verbs.push_back(sentence.likely_verbs.back() + (likely_verb(sentence.words.back()) ? 1 : 0));
  }
  return sentence;
}

bool is_noun(std::uint8_t tag) {
  const Tag t{tag};
  return t == Tag::kNN || t == Tag::kNNS || t == Tag::kNNP || t == Tag::kNNPS;
}

bool is_finite(std::uint8_t tag) {
  const Tag t{tag};
  return t == Tag::kVBZ || t == Tag::kVBP || t == Tag::kVBD || t == Tag::kMD || t == Tag::kVB;
}

void look_ahead(TaggedSentence& sentence) {
  const std::size_t size = sentence.words.size();
  const auto fill = [&](std::vector<int>& next, auto&& is) {
    next.assign(size + 1, static_cast<int>(size));
    for (std::size_t i = size; i-- > 0;) next[i] = is(sentence.tags[i]) ? static_cast<int>(i) : next[i + 1];
  };
  fill(sentence.next_noun, is_noun);
  fill(sentence.next_verb, is_finite);
  fill(sentence.next_break, [](std::uint8_t tag) { return Tag{tag} == Tag::kPunct || Tag{tag} == Tag::kCC; });
  sentence.after_noun.assign(size + 1, static_cast<int>(size));
  for (std::size_t i = size; i-- > 0;) {
    const bool last_noun = is_noun(sentence.tags[i]) && (i + 1 == size || !is_noun(sentence.tags[i + 1]));
    sentence.after_noun[i] = last_noun ? static_cast<int>(i) + 1 : sentence.after_noun[i + 1];
  }
}

ParserState::ParserState(int words)
    : on_stack_(static_cast<std::size_t>(words) + 1),
      heads_(static_cast<std::size_t>(words) + 1, -1),
      arcs_(static_cast<std::size_t>(words) + 1, Arc::kDep),
      left_(static_cast<std::size_t>(words) + 1),
      right_(static_cast<std::size_t>(words) + 1) {
  stack_.reserve(static_cast<std::size_t>(words));
}

bool ParserState::allows(ParserStep step) const {
  switch (step) {
    case ParserStep::kShift: return next_ < size();
    case ParserStep::kLeft: return !stack_.empty();
    case ParserStep::kRight: return stack_.size() > 1;
  }
  return false;
}

void ParserState::apply(ParserStep step, Arc arc) {
  if (step == ParserStep::kShift) {
    on_stack_[static_cast<std::size_t>(next_)] = true;
    stack_.push_back(next_++);
    return;
  }
  const int child = dependent(step), above = head(step);
  heads_[static_cast<std::size_t>(child)] = above;
  arcs_[static_cast<std::size_t>(child)] = arc;
  Children& side = (step == ParserStep::kLeft ? left_ : right_)[static_cast<std::size_t>(above)];
  side.inner = side.outer;
  side.outer = child;
  ++side.count;
  side.labels |= std::uint64_t{1} << static_cast<unsigned>(arc);
  on_stack_[static_cast<std::size_t>(child)] = false;
  stack_.pop_back();
}

}  // namespace layoutbox::syntax
