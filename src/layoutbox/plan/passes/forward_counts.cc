#include "layoutbox/plan/passes/forward_counts.h"

#include <algorithm>

namespace layoutbox::offline {

namespace {

// "table" and "round table", "bed" and "bed"; no "table lamp".
bool is_same(const NounPhrase& one, const NounPhrase& other) {
  const auto ends = [](const std::string& name, const std::string& word) { return name == word || name.ends_with(" " + word); };
  return ends(one.name, other.name) || ends(other.name, one.name);
}

// "… the tables, five of them", "the chairs, two in number": how many, behind the noun at k; 0: not said.
int count_behind(const std::vector<Chunk>& chunks, std::size_t k) {
  if (k + 2 >= chunks.size() || chunks[k + 1].kind != ChunkKind::kComma || chunks[k + 2].kind != ChunkKind::kNoun) return 0;
  const NounPhrase& count = chunks[k + 2].noun;
  return count.kind == NounKind::kMember && count.attributes.empty() && !count.of ? count.count : 0;
}

Mm longest_of(const NounPhrase& noun) { return std::max(noun.entry->size.usual.width, noun.entry->size.usual.depth); }

// So many of it look like many: 0 for what is large.
int many_of(const NounPhrase& noun) {
  constexpr std::pair<Mm, int> kMany[] = {{130, 8}, {350, 6}, {700, 5}};  // up to that long, so many
  for (const auto& [longest, many] : kMany) {
    if (noun.entry != nullptr && longest_of(noun) <= longest) return many;
  }
  return 0;
}

bool has_word(const Lexicon& lexicon, const Document& document, const Chunk& chunk, const char* list) {
  for (std::size_t t = chunk.first; t < chunk.last; ++t) {
    if (lexicon.is_in(list, document.tokens[t].text)) return true;
  }
  return false;
}

// "all over", "all along": "all" and what follows.
bool is_all(const Document& document, std::size_t token, std::string_view next) {
  return token + 1 < document.tokens.size() && document.tokens[token].text == "all" && document.tokens[token + 1].text == next;
}

// "bottles": no number, no article, and small.
bool is_bare(const Chunk& chunk) {
  return is_thing(chunk) && chunk.noun.plural && chunk.noun.count == 0 && chunk.noun.determiner == Determiner::kNone &&
         many_of(chunk.noun) > 0;
}

// What is filled by the noun at k, as in "a shelf full of cans": a part of the room, or one thing large enough that many fit.
bool is_wide_enough(const std::vector<Chunk>& chunks, std::size_t k) {
  constexpr std::int64_t kTimes = 12, kLeast = 80'000;  // as much as one of them; mm²
  if (k < 2) return false;
  std::size_t host = k - 2;
  while (host > 0 && chunks[host].kind != ChunkKind::kNoun) --host;
  const NounPhrase& noun = chunks[host].noun;
  if (chunks[host].kind != ChunkKind::kNoun) return false;
  if (noun.kind == NounKind::kWall || noun.kind == NounKind::kFloor || noun.kind == NounKind::kCeiling || noun.kind == NounKind::kRoom)
    return true;
  if (noun.kind != NounKind::kObject || noun.entry == nullptr || noun.is_plural() || noun.determiner == Determiner::kEach) return false;
  const auto area = [](const Size& size) { return std::int64_t{size.width} * size.depth; };
  const std::int64_t levels = std::max<std::int64_t>(1, std::ssize(noun.entry->spaces));
  const std::int64_t own = area(noun.entry->size.usual);
  return own >= kLeast && own * levels >= kTimes * area(chunks[k].noun.entry->size.usual);
}

// "of all sizes", "in various sizes", behind the noun's first word and before the next thing.
bool says_all_sizes(const Lexicon& lexicon, const Document& document, std::size_t k) {
  constexpr std::size_t kNearby = 5;  // tokens behind it: "ten plants or more, of all sizes"
  const Chunk& chunk = document.chunks[k];
  std::size_t end = std::min(document.tokens.size(), chunk.last + kNearby);
  for (std::size_t next = k + 1; next < document.chunks.size(); ++next) {
    if (is_thing(document.chunks[next])) {
      end = std::min(end, document.chunks[next].first);
      break;
    }
  }
  for (std::size_t t = chunk.first; t + 1 < end && !document.tokens[t].ends_sentence; ++t) {
    const std::string& what = document.tokens[t + 1].text;
    if (lexicon.is_in("assorting", document.tokens[t].text) && (what == "sizes" || what == "size")) return true;
  }
  return false;
}

}  // namespace

namespace {

// "flash art on the walls", "artwork around the walls": more than one piece of what has no plural.
bool is_all_over_walls(const Document& document, std::size_t k) {
  const std::vector<Chunk>& chunks = document.chunks;
  if (k + 2 >= chunks.size() || chunks[k + 1].kind != ChunkKind::kRelation || chunks[k + 2].kind != ChunkKind::kNoun) return false;
  const NounPhrase &noun = chunks[k].noun, &walls = chunks[k + 2].noun;
  const bool mass =
      noun.entry != nullptr && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && noun.entry->mount == Mount::kWall;
  return mass && walls.kind == NounKind::kWall && walls.is_plural() && noun.head.ends_with("art");
}

}  // namespace

void settle_filling_counts(const Lexicon& lexicon, Document& document) {
  constexpr int kOnWalls = 3;
  for (std::size_t k = 0; k < document.chunks.size(); ++k) {
    if (!is_thing(document.chunks[k]) || !is_all_over_walls(document, k)) continue;
    NounPhrase& noun = document.chunks[k].noun;
    noun.count = kOnWalls;
    noun.plural = noun.vague = noun.at_least = true;
  }
  constexpr int kOverhead = 2;  // times as many on a ceiling
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size() && !is_set(document.stop); ++k) {
    NounPhrase& noun = chunks[k].noun;
    if (!is_thing(chunks[k]) || !noun.plural) continue;
    noun.assorted = says_all_sizes(lexicon, document, k);
    const int many = many_of(noun);
    if (!is_bare(chunks[k])) continue;
    const bool over = is_all(document, chunks[k].last, "over"), along = is_all(document, chunks[k].last, "along");
    const bool everywhere = chunks[k].last < document.tokens.size() && document.tokens[chunks[k].last].text == "everywhere";
    const bool strewn = everywhere || (k > 0 && has_word(lexicon, document, chunks[k - 1], "filling"));
    const bool full = k > 0 && has_word(lexicon, document, chunks[k - 1], "full") && is_wide_enough(chunks, k);
    if (!over && !along && !strewn && !full && !noun.assorted) continue;
    const bool ceiling = over && k + 2 < chunks.size() && chunks[k + 2].noun.kind == NounKind::kCeiling;
    // "stocked with glasses and bottles": the next of the list as well, each with half of the many.
    const bool listed = !over && !along && k + 2 < chunks.size() && chunks[k + 1].kind == ChunkKind::kAnd && is_bare(chunks[k + 2]);
    noun.count = ceiling ? kOverhead * many : listed ? many / 2 : many;
    if (listed) {
      chunks[k + 2].noun.count = many / 2;
      chunks[k + 2].noun.vague = chunks[k + 2].noun.at_least = chunks[k + 2].noun.filling = true;
    }
    noun.vague = noun.at_least = noun.filling = true;
    noun.everywhere = everywhere;
    const CatalogEntry* stack = everywhere && noun.exact ? lexicon.catalog().find(noun.entry->id + "_stack") : nullptr;
    if (stack != nullptr) noun.entry = stack, noun.category = stack->id;  // "books everywhere" lie in piles
  }
}

void settle_named_again(Document& document) {
  constexpr std::size_t kBack = 60;  // chunks that are looked at
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 1; k < chunks.size() && !is_set(document.stop); ++k) {
    NounPhrase& noun = chunks[k].noun;
    const bool plain = chunks[k].kind == ChunkKind::kNoun && noun.kind == NounKind::kAbstract && noun.determiner == Determiner::kDefinite &&
                       !noun.head.empty() && !noun.of;
    for (std::size_t before = k; plain && before-- > 0 && before + kBack > k;) {
      const NounPhrase& known = chunks[before].noun;
      if (!is_thing(chunks[before]) || (known.name != noun.head && !known.name.ends_with(" " + noun.head))) continue;
      noun.kind = NounKind::kObject;
      noun.name = noun.head;
      noun.entry = known.entry, noun.exact = known.exact;
      noun.category = known.category;
      break;
    }
  }
}

void settle_forward_names(Document& document) {
  constexpr std::size_t kAhead = 60;  // chunks that are looked at
  std::vector<Chunk>& chunks = document.chunks;
  // "the dining table … a dining table", "the bed … a double bed"
  const auto is_called = [&](std::size_t c, const NounPhrase& noun) {
    const NounPhrase& other = chunks[c].noun;
    return is_thing(chunks[c]) && other.head == noun.head && (noun.name == noun.head || noun.name == other.name);
  };
  for (std::size_t k = 1; k < chunks.size() && !is_set(document.stop); ++k) {
    NounPhrase& known = chunks[k].noun;
    // "the way between bed and door. A double bed …", where articles are left out
    const bool spoken_of = known.determiner == Determiner::kDefinite || known.determiner == Determiner::kNone;
    const bool plain = is_thing(chunks[k]) && spoken_of && known.exact && !known.is_plural() && known.attributes.empty() &&
                       known.count == 0 && known.ordinal == 0 && !known.of;
    if (!plain || chunks[k - 1].kind != ChunkKind::kRelation) continue;
    std::size_t before = 0;
    while (before < k && !is_called(before, known)) ++before;
    std::size_t later = k + 1;
    const auto is_place_by = [&](std::size_t c) { return chunks[c - 1].kind == ChunkKind::kRelation; };  // spoken of once more
    while (later < std::min(chunks.size(), k + kAhead) && (!is_called(later, known) || is_place_by(later))) ++later;
    if (before < k || later >= std::min(chunks.size(), k + kAhead)) continue;
    NounPhrase& named = chunks[later].noun;
    const bool brings = named.determiner == Determiner::kNone || named.determiner == Determiner::kIndefinite;
    if (!brings || named.is_plural() || named.count > 1 || later < 2) continue;
    known.entry = named.entry;
    known.exact = named.exact;
    known.category = named.category;
    known.name = named.name;
    known.attributes = named.attributes;
    known.attribute_classes = named.attribute_classes;
    known.seats = named.seats;
    if (!known.size.any()) known.size = named.size;
    named.determiner = Determiner::kDefinite;
  }
}

// "both sofas have cushions. There are two sofas.", "… between the two rows of desks; there are six desks": those that were spoken of.
void settle_forward_wholes(const Lexicon& lexicon, Document& document) {
  constexpr std::size_t kNearby = 200;  // chunks that are looked at either way
  std::vector<Chunk>& chunks = document.chunks;
  const auto speaks_of = [&](std::size_t c, const NounPhrase& noun) { return is_thing(chunks[c]) && is_same(chunks[c].noun, noun); };
  for (std::size_t k = 0; k < chunks.size() && !is_set(document.stop); ++k) {
    NounPhrase& known = chunks[k].noun;
    const bool rows = known.rows > 0 && lexicon.is(document.tokens[known.first], WordClass::kDefinite);
    const bool all = known.determiner == Determiner::kBoth || (known.determiner == Determiner::kDefinite && known.count > 1);
    if (!is_thing(chunks[k]) || (!rows && !all)) continue;
    std::size_t before = k;
    while (before > 0 && before + kNearby > k && !speaks_of(before - 1, known)) --before;
    if (before > 0 && speaks_of(before - 1, known)) continue;
    for (std::size_t c = k + 2; c < std::min(chunks.size(), k + kNearby); ++c) {
      if (!speaks_of(c, known)) continue;
      NounPhrase& said = chunks[c].noun;
      const bool there = chunks[c - 1].kind == ChunkKind::kThere && said.count > 1 && said.determiner == Determiner::kNone;
      const bool fits = rows ? said.count >= known.rows : known.count == 0 || known.count == said.count;
      if (!there || !fits) break;
      known.count = said.count;
      said.determiner = Determiner::kDefinite;
      break;
    }
  }
}

void settle_bunks(const Lexicon& lexicon, Document& document) {
  const auto says = [&](std::size_t i, std::initializer_list<std::string_view> words) {
    return i < document.tokens.size() && std::ranges::find(words, document.tokens[i].text) != words.end();
  };
  const CatalogEntry* bunk = lexicon.catalog().find("bunk_bed");
  for (Chunk& chunk : document.chunks) {
    NounPhrase& beds = chunk.noun;
    const bool several = is_thing(chunk) && beds.head == "bed" && beds.count > 1 && beds.count % 2 == 0;
    if (!several || bunk == nullptr || !says(chunk.last, {"as", "in"}) || !says(chunk.last + 1, {"bunk", "bunks"})) continue;
    beds.entry = bunk;
    beds.exact = true;
    beds.category = bunk->id;
    beds.name = bunk->name;
    beds.count /= 2;
    const std::size_t end = chunk.last + (says(chunk.last + 2, {"bed", "beds"}) ? 3 : 2);
    for (Chunk& other : document.chunks) {
      if (other.first >= chunk.last && other.last <= end) other.kind = ChunkKind::kIgnored;
    }
  }
}

void settle_forward_counts(Document& document) {
  constexpr std::size_t kNearby = 200;  // chunks that are looked at either way
  std::vector<Chunk>& chunks = document.chunks;
  for (std::size_t k = 0; k < chunks.size() && !is_set(document.stop); ++k) {
    if (!is_thing(chunks[k])) continue;
    NounPhrase& each = chunks[k].noun;
    const bool either = each.determiner == Determiner::kBoth && document.tokens[each.first].text == "either";
    if ((each.determiner != Determiner::kEach && !either) || each.count > 0) continue;
    const auto speaks_of = [&](std::size_t c) { return is_thing(chunks[c]) && is_same(chunks[c].noun, each); };
    bool named = false;
    for (std::size_t c = k; c-- > 0 && c + kNearby > k && !named;) {
      if (!speaks_of(c)) continue;
      named = true;  // "a lamp per bed and a chest at the foot of each bed": as many as those
      if (chunks[c].noun.determiner == Determiner::kEach) each.count = chunks[c].noun.count;
    }
    for (std::size_t c = k + 1; c < chunks.size() && c < k + kNearby && !named; ++c) {
      if (!speaks_of(c) || chunks[c].noun.determiner == Determiner::kEach) continue;
      NounPhrase& all = chunks[c].noun;
      const int behind = all.plural && all.count == 0 ? count_behind(chunks, c) : 0;
      const int count = std::max(all.count, behind);
      if (count > 1) {
        each.count = count;
        if (either) each.determiner = Determiner::kEach;
        all.count = count;
        all.determiner = Determiner::kDefinite;
      }
      break;
    }
  }
}

// The things that end before the chunk at k are listed with no number: "sofas, chairs and lamps" of "…, one of each".
std::vector<NounPhrase*> bare_list_before(std::vector<Chunk>& chunks, std::size_t k) {
  std::vector<NounPhrase*> listed;
  for (std::size_t c = k; c-- > 0;) {
    const ChunkKind kind = chunks[c].kind;
    if (kind == ChunkKind::kComma || kind == ChunkKind::kAnd || kind == ChunkKind::kIgnored) continue;
    const bool place = kind == ChunkKind::kRelation || (c > 0 && chunks[c - 1].kind == ChunkKind::kRelation);  // "… on the table"
    if (place && listed.empty()) continue;
    if (!is_thing(chunks[c]) || chunks[c].noun.count > 0 || chunks[c].noun.determiner != Determiner::kNone) break;
    listed.push_back(&chunks[c].noun);
  }
  return listed;
}

void settle_counts_of_each(const Lexicon& lexicon, Document& document) {
  const std::vector<Token>& tokens = document.tokens;
  for (std::size_t k = 1; k < document.chunks.size() && !is_set(document.stop); ++k) {
    const std::size_t first = document.chunks[k].first;
    const NumberRead number = read_number(lexicon, tokens, first);
    const std::size_t of = first + number.length, end = of + 2;
    if (number.length == 0 || number.value < 1 || !says_one_of(document, of, {"of"}) || !says_one_of(document, of + 1, {"each"})) continue;
    if (end < tokens.size() && tokens[end].kind != Token::Kind::kPunctuation) continue;
    const std::vector<NounPhrase*> listed = bare_list_before(document.chunks, k);
    if (listed.size() < 2) continue;
    for (NounPhrase* thing : listed) {
      thing->count = static_cast<int>(number.value);
      thing->plural = thing->count > 1;
    }
    for (std::size_t c = k; c < document.chunks.size() && document.chunks[c].first < end; ++c)
      document.chunks[c].kind = ChunkKind::kIgnored;
  }
}

}  // namespace layoutbox::offline
