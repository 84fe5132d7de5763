// Trucks, trains, planes and boats that are on or in furniture, on a rug, or in a room for children: they are toys (`toy_senses` in
// words_room.json).
#include <algorithm>
#include <string_view>
#include <vector>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/offline/people.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

namespace {

bool has_word(const WordList& words, std::string_view word) {
  for (const WordList::Member one : words) {
    if (one.value.text() == word) return true;
  }
  return false;
}

class ToyReader {
 public:
  ToyReader(const Lexicon& lexicon, Document& document)
      : catalog_(lexicon.catalog()), document_(document), chunks_(document.chunks), senses_(word_list("words_room").at("toy_senses")) {
    const auto room = std::ranges::find_if(chunks_, [](const Chunk& chunk) {
      return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kRoom && chunk.noun.room != nullptr;
    });
    if (room == chunks_.end()) return;
    childs_room_ = has_word(senses_.at("rooms"), room->noun.room->id);
    works_ = has_word(senses_.at("not_in"), room->noun.room->id);
  }

  void run() {
    for (std::size_t k = 0; k < chunks_.size(); ++k) {
      const std::string_view toy = toy_of(k);
      if (toy.empty() || !(is_childs(k) || is_kept(k))) continue;
      NounPhrase& noun = chunks_[k].noun;
      noun.kind = NounKind::kObject;
      noun.entry = catalog_.find(toy);
      noun.category = toy;
      noun.exact = true;
      noun.doubted = false;
    }
  }

 private:
  bool is(std::size_t k, ChunkKind kind) const { return k < chunks_.size() && chunks_[k].kind == kind; }
  bool is_noun(std::size_t k) const { return is(k, ChunkKind::kNoun); }

  // The toy that the chunk's word may be; empty: none, or one by name.
  std::string_view toy_of(std::size_t k) const {
    if (!is_noun(k)) return {};
    const NounPhrase& noun = chunks_[k].noun;
    if (noun.kind != NounKind::kObject && noun.kind != NounKind::kAbstract) return {};
    if (noun.last <= noun.first || (noun.entry != nullptr && noun.exact && mount_of(noun) == Mount::kSurface)) return {};
    const std::string &said = document_.tokens[noun.last - 1].text, word = singular_of(said);
    for (const WordList::Member kind : senses_.at("toys")) {
      if (has_word(kind.value, word) || has_word(kind.value, said) || has_word(kind.value, noun.name)) return kind.key;
    }
    return {};
  }

  // In a child's room, where it is named as a thing, is one of a list or a place is said of it: no train that passes the window.
  bool is_childs(std::size_t k) const {
    const auto parts = [&](std::size_t at) { return is(at, ChunkKind::kAnd) || is(at, ChunkKind::kComma) || is(at, ChunkKind::kStop); };
    const bool listed = k > 0 && (parts(k - 1) || is(k - 1, ChunkKind::kHave)) && (k + 1 >= chunks_.size() || parts(k + 1));
    return childs_room_ && (chunks_[k].noun.kind == NounKind::kObject || listed || is(past_verb(k + 1), ChunkKind::kRelation));
  }

  std::size_t past_verb(std::size_t k) const {
    while (is(k, ChunkKind::kIgnored) || is(k, ChunkKind::kVerb) || is(k, ChunkKind::kParticiple)) ++k;
    return k;
  }

  // Furniture that small things are on, in or under, or a rug; no lift and no rack for the real one.
  bool is_furniture(std::size_t k) const {
    if (!is_noun(k) || chunks_[k].noun.kind != NounKind::kObject || chunks_[k].noun.entry == nullptr) return false;
    const NounPhrase& noun = chunks_[k].noun;
    if (has_word(senses_.at("not_on"), noun.head)) return false;
    const bool rug = noun.entry->thin || is_storage(noun);
    return is_table(catalog_, noun) || is_seat(catalog_, noun) || noun.entry->is(Trait::kBed) || (rug && !works_);
  }

  static bool holds(const Chunk& place, Direction direction) {
    if (place.kind != ChunkKind::kRelation || place.phrase.senses == nullptr) return false;
    return std::ranges::any_of(*place.phrase.senses, [&](const PhraseSense& sense) {
      return sense.direction == direction && (traits_of(sense.type).rests || sense.type == RelationType::kUnder);
    });
  }

  // Before what is listed: "a truck", of "two planes, a boat and a truck".
  std::size_t first_of_list(std::size_t k) const {
    while (k >= 2 && (is(k - 1, ChunkKind::kAnd) || is(k - 1, ChunkKind::kComma)) && is_noun(k - 2)) k -= 2;
    return k;
  }

  // "a truck on the rug", "under the bed is a train", "a shelf with two planes".
  bool is_kept(std::size_t k) const {
    std::size_t place = past_verb(k + 1);
    for (std::size_t more = place; is(more, ChunkKind::kAnd) && is_noun(more + 1) && is(more + 2, ChunkKind::kVerb);)
      place = more = past_verb(more + 2);  // "a truck and a doll are on the rug"
    if (place < chunks_.size() && holds(chunks_[place], Direction::kDirect) && is_furniture(place + 1)) return true;
    std::size_t before = first_of_list(k);
    while (before > 0 && (is(before - 1, ChunkKind::kIgnored) || is(before - 1, ChunkKind::kVerb) || is(before - 1, ChunkKind::kThere)))
      --before;
    if (before < 2) return false;
    const Chunk& last = chunks_[before - 1];
    if (is_furniture(before - 1)) return holds(chunks_[before - 2], Direction::kDirect);
    return (last.kind == ChunkKind::kHave || holds(last, Direction::kInverse)) && is_furniture(before - 2);
  }

  const Catalog& catalog_;
  Document& document_;
  std::vector<Chunk>& chunks_;
  WordList senses_;
  bool childs_room_ = false, works_ = false;
};

}  // namespace

void settle_toys(const Lexicon& lexicon, Document& document) { ToyReader(lexicon, document).run(); }

}  // namespace layoutbox::offline
