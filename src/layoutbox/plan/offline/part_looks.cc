// "A chair with a red seat", "a wardrobe with mirrored doors": what is said of the part that shows is the look of a thing that has none.
// "A rug with stars", "hearts on the duvet": what is printed on cloth is no thing.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

bool is_look_class(WordClass word_class) { return word_class == WordClass::kColor || word_class == WordClass::kMaterial; }

bool has_look(const NounPhrase& noun) { return std::ranges::any_of(noun.attribute_classes, is_look_class); }

void give_look(const NounPhrase& part, NounPhrase& whole) {
  whole.attribute_classes.resize(whole.attributes.size(), WordClass::kQuality);
  for (std::size_t a = 0; a < part.attributes.size() && a < part.attribute_classes.size(); ++a) {
    if (!is_look_class(part.attribute_classes[a])) continue;
    whole.attributes.push_back(part.attributes[a]);
    whole.attribute_classes.push_back(part.attribute_classes[a]);
  }
}

bool is_cloth(const NounPhrase& noun) {
  if (noun.kind == NounKind::kPart) return noun.head == "bedding" || noun.head == "wallpaper" || noun.head == "linen";
  if (noun.kind != NounKind::kObject || noun.entry == nullptr) return false;
  return mount_of(noun) == Mount::kHung || noun.entry->is(Trait::kCurtain) || one_of(noun.head, WordSet::kSoftThings) ||
         (noun.entry->thin && mount_of(noun) == Mount::kFloor);
}

// "stars", "little hearts": several of what cloths are printed with, of which nobody says which or how many.
bool is_print(const NounPhrase& noun) {
  if (noun.kind != NounKind::kObject || noun.determiner != Determiner::kNone || noun.count > 0 || !noun.plural || noun.of) return false;
  for (const WordList::Member word : word_list("words_room").at("finish_words").at("prints")) {
    if (singular_of(word.value.text()) == noun.head) return true;
  }
  return false;
}

class PrintReader {
 public:
  explicit PrintReader(Document& document) : document_(document), chunks_(document.chunks) {}

  void run() {
    for (std::size_t k = 0; k < chunks_.size(); ++k) {
      if (chunks_[k].kind != ChunkKind::kNoun || !is_print(chunks_[k].noun)) continue;
      if (const std::size_t cloth = cloth_before(k); cloth < k) {
        leave_out(cloth + 1, k + 1);
        pass_on_it(k + 1);
      } else if (lies_on_cloth(k)) {
        leave_out(k, k + 1);
        pass_joiner(k);
        leave_out(k + 1, k + 2);
        chunks_[k + 2].noun.determiner = Determiner::kIndefinite;
      }
    }
  }

 private:
  bool says(std::size_t k, std::initializer_list<std::string_view> words) const {
    for (std::size_t i = chunks_[k].first; i < chunks_[k].last; ++i) {
      if (!says_one_of(document_, i, words)) return false;
    }
    return true;
  }

  // "a rug with stars", "a quilt embroidered with moons and stars": the cloth; past the end: there is none.
  std::size_t cloth_before(std::size_t k) const {
    bool with = false;
    for (std::size_t c = k; c-- > 0;) {
      if (chunks_[c].kind == ChunkKind::kNoun && is_cloth(chunks_[c].noun)) return with ? c : chunks_.size();
      const bool joins = chunks_[c].kind == ChunkKind::kAnd || (chunks_[c].kind == ChunkKind::kNoun && is_print(chunks_[c].noun));
      const bool prints = says(c, {"with", "in", "of", "patterned", "printed", "embroidered", "covered", "decorated", "woven", "full",
                                   "dotted", "strewn", "painted", "appliqued", "small", "little"});
      with |= prints;
      if (!joins && !prints && chunks_[c].kind != ChunkKind::kIgnored) break;
    }
    return chunks_.size();
  }

  // "stars on the duvet", "hearts on its curtains"
  bool lies_on_cloth(std::size_t k) const {
    return k + 2 < chunks_.size() && chunks_[k + 1].kind == ChunkKind::kRelation && says(k + 1, {"on", "all", "over", "across"}) &&
           chunks_[k + 2].kind == ChunkKind::kNoun && is_cloth(chunks_[k + 2].noun);
  }

  // "… on it"
  void pass_on_it(std::size_t k) {
    if (k + 1 >= chunks_.size() || chunks_[k].kind != ChunkKind::kRelation || !says(k, {"on", "all", "over"})) return;
    if (chunks_[k + 1].kind == ChunkKind::kNoun && chunks_[k + 1].noun.kind == NounKind::kPronoun) leave_out(k, k + 2);
  }

  // "a bed with stars on the duvet": the duvet is what the bed has.
  void pass_joiner(std::size_t k) {
    if (k > 0 && chunks_[k - 1].kind == ChunkKind::kAnd) chunks_[k - 1].kind = ChunkKind::kIgnored;
  }

  void leave_out(std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      chunks_[c].kind = ChunkKind::kIgnored;
      for (std::size_t i = chunks_[c].first; i < chunks_[c].last; ++i) document_.readings[i].use = WordReading::Use::kIgnored;
    }
  }

  Document& document_;
  std::vector<Chunk>& chunks_;
};

// "A matching oak table, chairs and sideboard": the look of the first is that of all that are listed with it.
void share_matching_looks(std::vector<Chunk>& chunks) {
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    const NounPhrase& first = chunks[k].noun;
    if (chunks[k].kind != ChunkKind::kNoun || first.kind != NounKind::kObject || !has_look(first) ||
        std::ranges::find(first.attributes, "matching") == first.attributes.end())
      continue;
    for (std::size_t c = k + 1; c < chunks.size(); ++c) {
      const bool thing = chunks[c].kind == ChunkKind::kNoun && chunks[c].noun.kind == NounKind::kObject;
      if (thing && !has_look(chunks[c].noun) && chunks[c].noun.determiner == Determiner::kNone) {
        give_look(first, chunks[c].noun);
      } else if (chunks[c].kind != ChunkKind::kAnd && chunks[c].kind != ChunkKind::kComma) {
        break;
      }
    }
  }
}

// "A white wicker loveseat with two matching chairs": the look of what was named before.
void match_looks(std::vector<Chunk>& chunks) {
  const NounPhrase* before = nullptr;
  for (Chunk& chunk : chunks) {
    if (chunk.kind == ChunkKind::kStop) before = nullptr;
    if (chunk.kind != ChunkKind::kNoun || chunk.noun.kind != NounKind::kObject) continue;
    NounPhrase& noun = chunk.noun;
    const bool matches = std::ranges::find(noun.attributes, "matching") != noun.attributes.end();
    if (matches && before != nullptr && !has_look(noun)) give_look(*before, noun);
    if (has_look(noun)) before = &noun;
  }
}

// "A boy's room, blue and orange, with a bed": colors that are things as well.
void pass_color_nouns(Document& document) {
  for (Chunk& chunk : document.chunks) {
    const NounPhrase& noun = chunk.noun;
    const bool bare = chunk.kind == ChunkKind::kNoun && noun.kind == NounKind::kObject && noun.determiner == Determiner::kNone &&
                      noun.count == 0 && !noun.plural && !noun.of && noun.name == noun.head;
    const bool colored = std::ranges::find(noun.attribute_classes, WordClass::kColor) != noun.attribute_classes.end();
    if (!bare || !colored || !word_list("colors").at("colors").contains(noun.head)) continue;
    chunk.kind = ChunkKind::kIgnored;
    for (std::size_t i = chunk.first; i < chunk.last; ++i) document.readings[i].use = WordReading::Use::kIgnored;
  }
}

}  // namespace

void settle_part_looks(Document& document) {
  pass_color_nouns(document);
  PrintReader(document).run();
  share_matching_looks(document.chunks);
  match_looks(document.chunks);
  NounPhrase* whole = nullptr;  // the thing whose parts are listed
  bool listing = false;
  for (Chunk& chunk : document.chunks) {
    const bool noun = chunk.kind == ChunkKind::kNoun;
    if (noun && listing && chunk.noun.kind == NounKind::kPart && whole != nullptr) {
      if (one_of(chunk.noun.head, WordSet::kOutsides) && !has_look(*whole)) give_look(chunk.noun, *whole);
    } else if (noun) {
      whole = chunk.noun.kind == NounKind::kObject ? &chunk.noun : nullptr;
      listing = false;
    } else if (chunk.kind == ChunkKind::kHave) {
      listing = whole != nullptr;
    } else if (chunk.kind != ChunkKind::kAnd && chunk.kind != ChunkKind::kComma && chunk.kind != ChunkKind::kIgnored) {
      whole = nullptr;
    }
  }
}

}  // namespace layoutbox::offline
