#include "layoutbox/plan/reading/tree.h"

#include <algorithm>
#include <string_view>

#include "layoutbox/plan/syntax/syntax.h"

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
  }
}

}  // namespace layoutbox::offline
