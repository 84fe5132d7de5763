// "A chair with a red seat", "a wardrobe with mirrored doors": what is said of the part that shows is the look of a thing that has none.
#include <algorithm>

#include "layoutbox/plan/offline/room_reader.h"
#include "layoutbox/plan/offline/word_sets.h"

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

}  // namespace

void settle_part_looks(Document& document) {
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
