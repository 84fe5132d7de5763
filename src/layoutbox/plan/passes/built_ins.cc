#include "layoutbox/plan/passes/built_ins.h"

#include <algorithm>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox::offline {
namespace {

class BuiltInReader {
 public:
  BuiltInReader(const Lexicon& lexicon, Document& document) : catalog_(lexicon.catalog()), document_(document) {}

  void run() {
    for (const WordList::Member row : word_list("words_kinds").at("built_of")) {
      for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
        const Mention& mention = document_.mentions[m];
        const bool one =
            mention.introduces && mention.items.size() == 1 && mention.noun.entry != nullptr && mention.noun.entry->id == row.key;
        if (one && names_part(row.value)) return take_apart(static_cast<int>(m), row.value);
      }
    }
  }

 private:
  // The first mention of a thing of these kinds; −1: none.
  int named(const WordList& kinds) const {
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const Mention& mention = document_.mentions[m];
      if (!mention.introduces || mention.items.empty() || mention.noun.entry == nullptr) continue;
      for (const WordList::Member kind : kinds) {
        if (catalog_.is_a(mention.noun.entry->id, kind.value.text())) return static_cast<int>(m);
      }
    }
    return -1;
  }

  bool names_part(const WordList& row) const {
    for (const WordList::Member part : row.at("parts")) {
      if (named(part.value) >= 0) return true;
    }
    return false;
  }

  void take_apart(int host, const WordList& row) {
    const CatalogEntry* plain = catalog_.find(row.at("as").text());
    if (plain == nullptr) return;
    become(host, *plain);
    for (const WordList::Member part : row.at("parts")) {
      int thing = named(part.value);
      if (thing < 0) {
        const CatalogEntry* entry = catalog_.find(part.key);
        if (entry == nullptr) continue;
        const NounPhrase noun = document_.mentions[static_cast<std::size_t>(host)].noun;
        thing = bring_in(document_, *entry, 1, noun.first, noun.last);
      } else if (is_linked(thing)) {
        continue;
      }
      Link has;
      has.kind = Link::Kind::kHave;
      has.targets = {thing};
      has.references = {host};
      has.concluded = true;
      has.first = document_.mentions[static_cast<std::size_t>(thing)].noun.first;
      has.last = document_.mentions[static_cast<std::size_t>(thing)].noun.last;
      document_.links.push_back(std::move(has));
    }
  }

  bool is_linked(int thing) const {
    return std::ranges::any_of(document_.links,
                               [&](const Link& link) { return std::ranges::find(link.targets, thing) != link.targets.end(); });
  }

  void become(int m, const CatalogEntry& entry) {
    const auto to_entry = [&](NounPhrase& noun) { noun.entry = &entry, noun.category = entry.id; };
    Mention& mention = document_.mentions[static_cast<std::size_t>(m)];
    to_entry(mention.noun);
    for (const int item : mention.items) to_entry(document_.items[static_cast<std::size_t>(item)].noun);
  }

  const Catalog& catalog_;
  Document& document_;
};

bool is_kind(const Chunk& chunk, std::string_view kind) {
  return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kObject && chunk.noun.entry != nullptr &&
         chunk.noun.entry->id == kind;
}

}  // namespace

void settle_namesakes(Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k + 2 < chunks.size(); ++k) {
    NounPhrase& whole = chunks[k].noun;
    Chunk& part = chunks[k + 2];
    if (chunks[k].kind != ChunkKind::kNoun || chunks[k + 1].kind != ChunkKind::kHave || part.kind != ChunkKind::kNoun) continue;
    if (whole.entry == nullptr || part.noun.entry == nullptr || !whole.exact || !part.noun.exact) continue;
    // "a vanity with a double sink" is a double vanity.
    const bool special = part.noun.entry->name.ends_with(" " + whole.head);
    const bool same = whole.entry == part.noun.entry || special;
    // "a table with a side table": by the word that the text has, whatever is read instead.
    const Token& last = document.tokens[part.noun.last - 1];
    const bool namesake = std::string_view(document.prompt).substr(last.begin, last.end - last.begin) == whole.head;
    if (!same || namesake || whole.is_plural() || part.noun.is_plural() || part.noun.count > 1) continue;
    if (special) whole.entry = part.noun.entry, whole.category = part.noun.entry->id;
    whole.attributes.insert(whole.attributes.end(), part.noun.attributes.begin(), part.noun.attributes.end());
    whole.attribute_classes.insert(whole.attribute_classes.end(), part.noun.attribute_classes.begin(), part.noun.attribute_classes.end());
    chunks[k + 1].kind = part.kind = ChunkKind::kIgnored;
  }
}

void settle_glosses(Document& document) {
  std::vector<Chunk>& chunks = document.chunks;
  const auto says = [&](std::size_t k, std::string_view text) {
    return chunks[k].kind == ChunkKind::kComma && document.tokens[chunks[k].first].text == text;
  };
  const auto is_object = [&](std::size_t k) { return chunks[k].kind == ChunkKind::kNoun && chunks[k].noun.kind == NounKind::kObject; };
  for (std::size_t k = 0; k + 3 < chunks.size(); ++k) {
    if (!is_object(k) || !says(k + 1, "(") || !is_object(k + 2) || !says(k + 3, ")")) continue;
    NounPhrase &noun = chunks[k].noun, &gloss = chunks[k + 2].noun;
    if (gloss.determiner != Determiner::kNone || gloss.count > 1 || gloss.is_plural() != noun.is_plural()) continue;
    const bool known = noun.exact && noun.entry != nullptr, told = gloss.exact && gloss.entry != nullptr;
    const bool special = known && told && gloss.entry->kind_of == noun.entry->id;
    if (known && told && noun.entry != gloss.entry && noun.entry->kind_of != gloss.entry->id && !special) continue;
    if (told && (special || !known)) {
      noun.entry = gloss.entry, noun.category = gloss.category, noun.head = gloss.head, noun.exact = true;
    }
    for (std::size_t i = k + 1; i < k + 4; ++i) chunks[i].kind = ChunkKind::kIgnored;
  }
}

void settle_worktops(Document& document) {
  const auto is_units = [](const Chunk& chunk) { return is_kind(chunk, "base_cabinet"); };
  if (std::ranges::none_of(document.chunks, is_units)) return;
  const auto names_top = [](const Chunk& chunk) {
    const std::string& head = chunk.noun.head;
    return is_kind(chunk, "counter") && (head == "worktop" || head == "countertop");
  };
  const auto spoken_of = std::ranges::count_if(document.chunks, names_top);
  for (std::size_t k = 0; k < document.chunks.size() && spoken_of == 1; ++k) {
    Chunk& chunk = document.chunks[k];
    const bool placed = (k > 0 && document.chunks[k - 1].kind == ChunkKind::kRelation) ||
                        (k + 1 < document.chunks.size() && document.chunks[k + 1].kind == ChunkKind::kRelation);
    if (!names_top(chunk) || placed || chunk.noun.size.any() || chunk.noun.determiner == Determiner::kDefinite) continue;
    chunk.kind = ChunkKind::kIgnored;
    for (std::size_t i = chunk.first; i < chunk.last; ++i) {
      document.readings[i].use = WordReading::Use::kUsed;
      document.readings[i].role = "look of the units";
    }
  }
}

void settle_built_ins(const Lexicon& lexicon, Document& document) { BuiltInReader(lexicon, document).run(); }

}  // namespace layoutbox::offline
