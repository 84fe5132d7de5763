#include "layoutbox/plan/reading/tree.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "layoutbox/plan/syntax/syntax.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

namespace {

using syntax::Arc;
using syntax::Tag;
using syntax::TreeNode;

bool is_verb(Tag tag) {
  return tag == Tag::kVB || tag == Tag::kVBD || tag == Tag::kVBG || tag == Tag::kVBN || tag == Tag::kVBP || tag == Tag::kVBZ;
}

}  // namespace

// Follows the tree from units to nouns.
class TreeWalk {
 public:
  TreeWalk(const Document& document, const Sentence& sentence) : document_(document), sentence_(sentence) {
    constexpr std::size_t kMost = 400;  // words of a sentence, where it has no end
    first_ = document.chunks[sentence.front().chunk].first;
    std::size_t last = document.chunks[sentence.back().chunk].last;
    for (std::size_t back = 0; first_ > 0 && !document.tokens[first_ - 1].ends_sentence && back < kMost; ++back) --first_;
    while (last < document.tokens.size() && !document.tokens[last].ends_sentence && last - first_ < kMost) ++last;
    std::vector<std::string_view> words;
    for (std::size_t t = first_; t < last; ++t) words.push_back(document.tokens[t].text);
    nodes_ = syntax::parse(words);
    unit_of_.assign(nodes_.size(), -1);
    for (std::size_t u = 0; u < sentence.size(); ++u) {
      const Chunk& chunk = document.chunks[sentence[u].chunk];
      for (std::size_t t = chunk.first; t < chunk.last && t - first_ < unit_of_.size(); ++t) unit_of_[t - first_] = static_cast<int>(u);
    }
    subject_.assign(nodes_.size(), -1);
    object_.assign(nodes_.size(), -1);
    for (std::size_t t = 0; t < nodes_.size(); ++t) {
      const TreeNode& node = nodes_[t];
      if (node.head < 0) continue;
      const auto head = static_cast<std::size_t>(node.head);
      if (node.arc == Arc::kNsubj || node.arc == Arc::kNsubjpass) subject_[head] = static_cast<int>(t);
      if (node.arc == Arc::kDobj && object_[head] < 0) object_[head] = static_cast<int>(t);
    }
  }

  // The noun unit that unit u belongs to (−1: not known), and how sure that is.
  std::pair<int, double> owner_of(std::size_t u) const {
    const Chunk& chunk = document_.chunks[sentence_[u].chunk];
    const int top = top_of(chunk);
    if (top < 0) return {-1, 0};
    double sure = 1;
    if (sentence_[u].kind == UnitKind::kNoun) return listed_with(top);
    int at = top;
    for (int steps = 0; steps < 8 && at >= 0; ++steps) {
      const TreeNode& node = nodes_[static_cast<std::size_t>(at)];
      // A verb's own subject.
      if (is_verb(node.tag) && steps >= 0) {
        const int subject = noun_unit(subject_[static_cast<std::size_t>(at)], u);
        if (subject >= 0) return {subject, sure};
        const bool command = node.tag == Tag::kVB && (node.arc == Arc::kRoot || node.arc == Arc::kConj) && steps > 0;
        const int object = command ? noun_unit(object_[static_cast<std::size_t>(at)], u) : -1;
        if (object >= 0) return {object, sure};
      }
      sure = std::min(sure, static_cast<double>(std::max(node.margin, 0.0F)));
      at = node.head;
      if (at < 0) break;
      if (const int noun = noun_unit(at, u); noun >= 0) return {noun, sure};
    }
    return {-1, 0};
  }

  // A noun of one word, without article, number or name of its own, that stands where a verb does.
  bool is_bare_verb(std::size_t u) const {
    const Unit& unit = sentence_[u];
    const Chunk& chunk = document_.chunks[unit.chunk];
    const NounPhrase& noun = chunk.noun;
    const std::size_t t = chunk.first - first_;
    const bool bare = unit.kind == UnitKind::kNoun && noun.kind == NounKind::kObject && chunk.last == chunk.first + 1 &&
                      noun.determiner == Determiner::kNone && noun.count == 0 && u > 0 && t > 0 && t < nodes_.size();
    if (!bare) return false;
    const Arc arc = nodes_[t].arc;
    const int head = nodes_[t].head;
    const bool of_verb = head >= 0 && is_verb(nodes_[static_cast<std::size_t>(head)].tag);
    const std::string& word = document_.tokens[chunk.first].text;
    const bool third = word.ends_with("s"), acts = is_verb(nodes_[t].tag);
    if (sentence_[u - 1].kind == UnitKind::kRelative) return third && (acts || may_be_verb(word));
    // "… and chimes on the hour", "… and whistles."
    if (unit.joiner == Joiner::kAnd) return third && arc == Arc::kConj && of_verb && (acts || u + 1 == sentence_.size());
    return unit.joiner == Joiner::kComma && noun.entry == nullptr && nodes_[t].tag == Tag::kVBN && may_be_verb(word);
  }

 private:
  // The chunk's word that hangs on a word outside it.
  int top_of(const Chunk& chunk) const {
    for (std::size_t t = chunk.first; t < chunk.last && t - first_ < nodes_.size(); ++t) {
      const int head = nodes_[t - first_].head;
      if (head < 0 || static_cast<std::size_t>(head) + first_ < chunk.first || static_cast<std::size_t>(head) + first_ >= chunk.last)
        return static_cast<int>(t - first_);
    }
    return -1;
  }

  int noun_unit(int at, std::size_t but) const {
    if (at < 0) return -1;
    const int unit = unit_of_[static_cast<std::size_t>(at)];
    return unit >= 0 && static_cast<std::size_t>(unit) != but && sentence_[static_cast<std::size_t>(unit)].kind == UnitKind::kNoun ? unit
                                                                                                                                   : -1;
  }

  std::pair<int, double> listed_with(int top) const {
    const TreeNode& node = nodes_[static_cast<std::size_t>(top)];
    if (node.arc != Arc::kConj && node.arc != Arc::kAppos) return {-1, 0};
    const int noun = noun_unit(node.head, static_cast<std::size_t>(-1));
    return {noun, noun < 0 ? 0 : std::min(1.0, static_cast<double>(std::max(node.margin, 0.0F)))};
  }

  const Document& document_;
  const Sentence& sentence_;
  std::size_t first_ = 0;
  std::vector<TreeNode> nodes_;
  std::vector<int> unit_of_, subject_, object_;
};

SentenceTree::SentenceTree(const Document& document, const Sentence& sentence) {
  if (sentence.empty()) return;
  const TreeWalk walk(document, sentence);
  for (std::size_t u = 0; u < sentence.size(); ++u) {
    const auto [owner, sure] = walk.owner_of(u);
    owner_.push_back(owner);
    sure_.push_back(sure);
    verb_.push_back(walk.is_bare_verb(u));
  }
}

bool pass_verbs(Document& document, const SentenceTree& tree, Sentence& sentence) {
  const std::size_t before = sentence.size();
  Sentence kept;
  for (std::size_t u = 0; u < before; ++u) {
    if (!tree.is_verb(u)) {
      kept.push_back(sentence[u]);
      continue;
    }
    Chunk& chunk = document.chunks[sentence[u].chunk];
    chunk.kind = ChunkKind::kIgnored;
    WordReading& reading = document.readings[chunk.first];
    reading.use = WordReading::Use::kIgnored;
    reading.role = "what it does";
  }
  if (kept.empty() || kept.size() == before) return false;
  sentence = std::move(kept);
  return true;
}

}  // namespace layoutbox::offline
