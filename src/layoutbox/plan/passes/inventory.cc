#include "layoutbox/plan/passes/inventory.h"

#include <memory>

#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

class InventoryReader {
 public:
  explicit InventoryReader(Document& document) : document_(document), chunks_(document.chunks) {}

  void run() {
    drop_headings();
    const std::size_t first = begin_of_list();
    if (first >= chunks_.size()) return;
    const std::size_t last = end_of_list(first);
    for (std::size_t k = last; last > first && k < chunks_.size(); ++k) {
      if (is_thing(chunks_[k]) && chunks_[k].noun.determiner == Determiner::kNone) mean_listed(chunks_[k].noun, first, last);
    }
  }

 private:
  bool is_inventory(std::size_t token) const { return one_of(document_.tokens[token].text, WordSet::kInventory); }

  // "minimum equipment: four racks, …" says what follows; it is no thing by itself.
  void drop_headings() {
    for (Chunk& chunk : chunks_) {
      const bool heads_list = chunk.last < document_.tokens.size() && document_.tokens[chunk.last].text == ":";
      if (is_thing(chunk) && heads_list && !chunk.noun.exact && is_inventory(chunk.last - 1)) chunk.noun.kind = NounKind::kAbstract;
    }
  }

  // The chunk behind "items:"; past the end where there is no such heading.
  std::size_t begin_of_list() const {
    for (std::size_t k = 0; k < chunks_.size(); ++k) {
      const std::size_t at = chunks_[k].first;
      if (at > 0 && document_.tokens[at].text == ":" && is_inventory(at - 1)) return k + 1;
    }
    return chunks_.size();
  }

  // Where the sentence ends that names things and nothing else; `first` if it says more of them.
  std::size_t end_of_list(std::size_t first) const {
    std::size_t things = 0;
    for (std::size_t k = first; k < chunks_.size(); ++k) {
      const ChunkKind kind = chunks_[k].kind;
      if (kind == ChunkKind::kStop) return things > 1 ? k : first;
      if (kind == ChunkKind::kRelation || kind == ChunkKind::kHave || kind == ChunkKind::kVerb || kind == ChunkKind::kParticiple)
        return first;
      things += is_thing(chunks_[k]) ? 1 : 0;
    }
    return first;
  }

  // "lamp" is the lamp, "2 pillows" two of the four.
  void mean_listed(NounPhrase& noun, std::size_t first, std::size_t last) const {
    for (std::size_t k = first; k < last; ++k) {
      if (!is_thing(chunks_[k]) || chunks_[k].noun.head != noun.head || !chunks_[k].noun.name.ends_with(noun.name)) continue;
      const int listed = chunks_[k].noun.count, said = noun.count;
      noun.determiner = Determiner::kDefinite;
      if (said == 0 || said >= listed) return;
      NounPhrase all = noun;
      all.count = 0, all.plural = true;
      noun.kind = NounKind::kMember;
      noun.determiner = Determiner::kNone;
      noun.of = std::make_shared<NounPhrase>(std::move(all));
      return;
    }
  }

  Document& document_;
  std::vector<Chunk>& chunks_;
};

}  // namespace

void settle_inventory(Document& document) { InventoryReader(document).run(); }

}  // namespace layoutbox::offline
