// How high things hang.
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/chunks_parts.h"

namespace layoutbox::offline {

// "a shelf at about 1.2 m", "a mirror at a height of 1.5 m", "a hook at 90 cm height", "pictures at eye level": how high it hangs.
bool Chunker::read_hung_at() {
  NounPhrase* hung = tokens_[i_].text == "at" ? may_hang() : nullptr;
  if (hung == nullptr) return false;
  constexpr double kEyes = 1.3;  // metres: the lower edge of what people look at who stand
  std::size_t at = i_ + 1;
  const auto skip = [&](std::initializer_list<std::string_view> words) {
    const bool found = at < tokens_.size() && std::find(words.begin(), words.end(), tokens_[at].text) != words.end();
    at += found ? 1 : 0;
    return found;
  };
  std::optional<double> height;
  if (skip({"eye"})) {
    if (skip({"level", "height"})) height = kEyes;
  } else {
    if (skip({"a"}) && !(skip({"height"}) && skip({"of"}))) return false;
    at += lexicon_.find(tokens_, at, WordClass::kExactly).length;
    if (const auto measure = read_measure(lexicon_, tokens_, at)) {
      height = measure->metres;
      at += measure->length;
      skip({"height", "high", "up"});
    }
  }
  if (!height || (at < tokens_.size() && lexicon_.find_phrase(tokens_, at).length > 0)) return false;  // "at 1 m from the door"
  hung->hangs_at = height;
  add(ChunkKind::kIgnored, at - i_);
  return true;
}

// What was named last, where such things hang on walls, or may.
NounPhrase* Chunker::may_hang() {
  for (std::size_t c = chunks_.size(); c-- > 0 && chunks_[c].kind != ChunkKind::kStop;) {
    if (chunks_[c].kind != ChunkKind::kNoun) continue;
    NounPhrase& noun = chunks_[c].noun;
    const bool hangs = noun.kind == NounKind::kObject && noun.entry != nullptr &&
                       (noun.entry->mount == Mount::kWall || noun.entry->is(Trait::kElseOnWall) || noun.head == "shelf");
    return hangs ? &noun : nullptr;
  }
  return nullptr;
}

}  // namespace layoutbox::offline
