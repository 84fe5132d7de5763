// What a word of several senses means by the words beside it: "bare boards" are a floor, a board with keys has hooks, a dragon's scales
// weigh nothing (`word_senses` in words_room.json).
#include <algorithm>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/offline/people.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"

namespace layoutbox::offline {

namespace {

struct WordSense {
  std::vector<std::string_view> of;      // words, in the singular
  std::vector<std::string_view> before;  // one of these stands right before it
  std::vector<std::string_view> at;      // one of these is a few words off, with no sign between
  std::vector<std::string_view> by;      // one of these is in its sentence
  std::vector<std::string_view> rooms;   // and the room is one of these, by its kind
  std::vector<std::string_view> had_by;  // it is what one of these has: "a low table with cushions"; ids
  std::string_view is;                   // the catalogue's id, a word that is like one, "floor", or "part"
};

std::vector<std::string_view> texts_at(const WordList& row, std::string_view key) {
  std::vector<std::string_view> texts;
  if (!row.contains(key)) return texts;
  for (const WordList::Member word : row.at(key)) texts.push_back(word.value.text());
  return texts;
}

const std::vector<WordSense>& word_senses() {
  static const std::vector<WordSense> kSenses = [] {
    std::vector<WordSense> senses;
    for (const WordList::Member row : word_list("words_room").at("word_senses"))
      senses.push_back({texts_at(row.value, "of"), texts_at(row.value, "before"), texts_at(row.value, "at"), texts_at(row.value, "by"),
                        texts_at(row.value, "rooms"), texts_at(row.value, "had_by"), row.value.at("is").text()});
    return senses;
  }();
  return kSenses;
}

bool has(const std::vector<std::string_view>& words, std::string_view word) { return std::ranges::find(words, word) != words.end(); }

class WordSenseReader {
 public:
  WordSenseReader(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), document_(document), tokens_(document.tokens) {
    const auto room = std::ranges::find_if(document.chunks, [](const Chunk& chunk) {
      return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kRoom && chunk.noun.room != nullptr;
    });
    if (room != document.chunks.end()) room_ = room->noun.room->id;
  }

  void run() {
    for (Chunk& chunk : document_.chunks) {
      if (chunk.kind != ChunkKind::kNoun || !is_plain(chunk.noun) || refers_back(chunk)) continue;
      if (const WordSense* sense = sense_of(chunk)) mean(chunk, *sense);
    }
  }

 private:
  // No other word tells its kind: "notice board" is one by name.
  static bool is_plain(const NounPhrase& noun) {
    if (noun.head.empty() || noun.last == 0) return false;
    if (noun.kind != NounKind::kObject && noun.kind != NounKind::kAbstract) return false;
    if (noun.entry == nullptr || !noun.exact || noun.name == noun.head) return true;
    return noun.entry->name == noun.head && (noun.name.ends_with(noun.head) || noun.name.starts_with(noun.head + " of "));
  }

  // "… a chessboard and a clock next to the board": what was named, not too long before.
  bool refers_back(const Chunk& chunk) const {
    constexpr std::ptrdiff_t kBack = 200;  // chunks
    const Chunk* const first = std::max(std::as_const(document_.chunks).data(), &chunk - std::min(kBack, &chunk - document_.chunks.data()));
    const std::string& head = chunk.noun.head;
    return chunk.noun.determiner == Determiner::kDefinite && std::any_of(first, &chunk, [&](const Chunk& before) {
             return before.kind == ChunkKind::kNoun && before.noun.kind == NounKind::kObject && before.noun.name.ends_with(head);
           });
  }

  // The token that is the head: the last one, or the one before "of".
  std::size_t head_of(const NounPhrase& noun) const {
    for (std::size_t i = noun.first; i < noun.last; ++i) {
      if (i + 1 < noun.last && tokens_[i + 1].text == "of") return i;
    }
    return noun.last - 1;
  }

  bool is_said(const std::vector<std::string_view>& words, std::size_t i) const {
    return has(words, tokens_[i].text) || has(words, singular_of(tokens_[i].text));
  }

  bool is_beside(const WordSense& sense, std::size_t head) const {
    constexpr std::size_t kAt = 5, kSentence = 120;  // tokens; what never ends is no sentence
    if (!sense.before.empty() && head > 0 && is_said(sense.before, head - 1)) return true;
    bool close = true;
    for (std::size_t i = head; i-- > 0 && head - i < kSentence && !tokens_[i].ends_sentence;) {
      close = close && head - i <= kAt && tokens_[i].kind != Token::Kind::kPunctuation;
      if ((close && is_said(sense.at, i)) || is_said(sense.by, i)) return true;
    }
    close = true;
    for (std::size_t i = head + 1; i < tokens_.size() && i - head < kSentence && !tokens_[i].ends_sentence; ++i) {
      close = close && i - head <= kAt && tokens_[i].kind != Token::Kind::kPunctuation;
      if ((close && is_said(sense.at, i)) || is_said(sense.by, i)) return true;
    }
    return false;
  }

  // What has the chunk: "a low table with cushions"; empty: nothing.
  std::string_view owner_of(const Chunk& chunk) const {
    const Chunk *const first = document_.chunks.data(), *at = &chunk;
    if (at == first || (--at)->kind != ChunkKind::kHave) return {};
    // "a low table at the center with cushions"
    while (at != first && ((--at)->kind == ChunkKind::kRelation || (at->kind == ChunkKind::kNoun && at->noun.kind != NounKind::kObject))) {
    }
    return at->kind != ChunkKind::kNoun || at->noun.entry == nullptr ? std::string_view{} : at->noun.entry->id;
  }

  const WordSense* sense_of(const Chunk& chunk) const {
    const NounPhrase& noun = chunk.noun;
    const std::size_t head = head_of(noun);
    const std::string word = singular_of(tokens_[head].text);
    for (const WordSense& sense : word_senses()) {
      if (!has(sense.of, word) && !has(sense.of, tokens_[head].text)) continue;
      if (!sense.rooms.empty() && !has(sense.rooms, room_)) continue;
      // "a bar of soap" is soap
      const bool portion = head + 1 < noun.last && noun.entry != nullptr && noun.exact && noun.entry->name != word;
      if (!portion && (is_beside(sense, head) || has(sense.had_by, owner_of(chunk)))) return &sense;
    }
    return nullptr;
  }

  void mean(Chunk& chunk, const WordSense& sense) {
    NounPhrase& noun = chunk.noun;
    if (sense.is == "part") {
      chunk.kind = ChunkKind::kIgnored;
      for (std::size_t i = chunk.first; i < chunk.last; ++i) document_.readings[i].use = WordReading::Use::kIgnored;
      return;
    }
    if (sense.is == "floor") {
      noun.attributes.emplace_back("wood");
      noun.attribute_classes.resize(noun.attributes.size() - 1, WordClass::kQuality);
      noun.attribute_classes.push_back(WordClass::kMaterial);
      noun.kind = NounKind::kFloor;
      noun.name = noun.head = "floor";
      noun.entry = nullptr;
      noun.category.clear();
      noun.exact = noun.plural = false;
      noun.count = 0;
      return;
    }
    const CatalogEntry* entry = lexicon_.catalog().find(sense.is);
    if (entry == noun.entry && entry != nullptr) return;
    noun.kind = NounKind::kObject;
    if (entry == nullptr) {  // a word that is like one of the catalogue's
      noun.entry = kin_of(lexicon_.catalog(), std::string(sense.is));
      noun.name = noun.head = sense.is;
      noun.category = snake_case(sense.is);
      noun.exact = false;
      return;
    }
    noun.entry = entry;
    noun.category = entry->id;
    noun.exact = true;
  }

  const Lexicon& lexicon_;
  Document& document_;
  const std::vector<Token>& tokens_;
  std::string_view room_;
};

}  // namespace

void settle_word_senses(const Lexicon& lexicon, Document& document) { WordSenseReader(lexicon, document).run(); }

}  // namespace layoutbox::offline
