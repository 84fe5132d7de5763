#include "layoutbox/plan/passes/inserts.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

class InsertReader {
 public:
  explicit InsertReader(Document& document) : document_(document), chunks_(document.chunks) {}

  void run() {
    for (std::size_t k = 0; k + 1 < chunks_.size(); ++k) {
      read_compound_quality(k);
      read_insert(k);
      read_headed_list(k);
      read_ability(k);
      read_verb_between(k);
      read_quality(k);
      read_degree(k);
      read_own_feet(k);
      read_one_of_named(k);
      read_only(k);
      read_another(k);
      read_perfect(k);
      read_place_has(k);
      read_place_between(k);
      read_share_of_walls(k);
    }
  }

 private:
  bool is(std::size_t k, ChunkKind kind) const { return k < chunks_.size() && chunks_[k].kind == kind; }
  bool is_thing(std::size_t k) const { return k < chunks_.size() && offline::is_thing(chunks_[k]); }
  std::string_view word(std::size_t k) const { return document_.tokens[chunks_[k].first].text; }
  std::string_view last_word(std::size_t k) const { return document_.tokens[chunks_[k].last - 1].text; }

  void pass_over(std::size_t first, std::size_t last, std::string_view role) {
    for (std::size_t k = first; k < last; ++k) {
      chunks_[k].kind = ChunkKind::kIgnored;
      for (std::size_t i = chunks_[k].first; i < chunks_[k].last; ++i) {
        document_.readings[i].use = WordReading::Use::kIgnored;
        document_.readings[i].role = role;
      }
    }
  }

  bool begins_clause(std::size_t k) const {
    while (k > 0 && is(k - 1, ChunkKind::kIgnored)) --k;
    return k == 0 || is(k - 1, ChunkKind::kStop) || is(k - 1, ChunkKind::kAnd) || is(k - 1, ChunkKind::kClause);
  }

  // Names no thing and no place, or is a relative clause that names no new thing.
  bool says_nothing(std::size_t first, std::size_t last) const {
    const bool relative = is(first, ChunkKind::kRelative) || word(first) == "which" || word(first) == "where" || word(first) == "who";
    for (std::size_t k = first; k < last; ++k) {
      if (is(k, ChunkKind::kStop) || is(k, ChunkKind::kHave) || is(k, ChunkKind::kThere) || is(k, ChunkKind::kCommand)) return false;
      if (is_thing(k) && !(relative && chunks_[k].noun.determiner == Determiner::kDefinite)) return false;
      if (!relative && (is(k, ChunkKind::kRelation) || is(k, ChunkKind::kSoft))) return false;
      if (is(k, ChunkKind::kNoun) && chunks_[k].noun.kind == NounKind::kMember) return false;
    }
    return true;
  }

  // "Flour-dusted and warm, …", "a bearskin, moth-eaten, lies …": how something is.
  void read_compound_quality(std::size_t k) {
    if (!is_thing(k)) return;
    const NounPhrase& noun = chunks_[k].noun;
    const Token& last = document_.tokens[noun.last - 1];
    if (noun.exact || noun.entry != nullptr || noun.count != 0 || noun.determiner != Determiner::kNone || !last.glued) return;
    const WordForm form = word_form(last.text);
    const bool participle = last.text.ends_with("ed") || ((form == WordForm::kVerb || form == WordForm::kAdjective) && !noun.plural);
    if (!participle) return;
    const bool inserted = k > 0 && is(k - 1, ChunkKind::kComma) && is(k + 1, ChunkKind::kComma);
    pass_over(inserted ? k - 1 : k, inserted ? k + 2 : k + 1, "how something is");
  }

  // "Behind the chair, humming, is a cabinet", "in the box, always, the cat", "behind the bench, which nobody minds, there is a chair".
  void read_insert(std::size_t k) {
    constexpr std::size_t kLongest = 9;  // chunks
    if (!is(k, ChunkKind::kRelation) || !is(k + 1, ChunkKind::kNoun) || !is(k + 2, ChunkKind::kComma) || !begins_clause(k)) return;
    std::size_t end = k + 3;
    while (end < chunks_.size() && end < k + 3 + kLongest && !is(end, ChunkKind::kComma) && !is(end, ChunkKind::kStop)) ++end;
    if (!is(end, ChunkKind::kComma) || end == k + 3 || !says_nothing(k + 3, end)) return;
    const std::size_t next = end + 1;
    const bool be = is(next, ChunkKind::kVerb) && is_thing(next + 1);
    if (!be && !is(next, ChunkKind::kThere) && !is_thing(next)) return;
    pass_over(k + 2, be || is(next, ChunkKind::kThere) ? end + 1 : end, "by the way");
  }

  // "workbench at the back wall, on the bench: vise, radio": what follows is there, and not what was named before.
  void read_headed_list(std::size_t k) {
    if (!is(k, ChunkKind::kComma) || word(k) != "," || !is(k + 1, ChunkKind::kRelation)) return;
    const bool of_it = last_word(k + 1) == "it" || last_word(k + 1) == "them";
    const bool known = is(k + 2, ChunkKind::kNoun) &&
                       (chunks_[k + 2].noun.determiner == Determiner::kDefinite || chunks_[k + 2].noun.kind == NounKind::kPronoun);
    const std::size_t colon = of_it ? k + 2 : k + 3;
    if ((of_it || known) && is(colon, ChunkKind::kComma) && word(colon) == ":") chunks_[k].kind = ChunkKind::kStop;
  }

  // "a plant that cannot die", "hooks where my youngest can reach": what may be, and no tin.
  void read_ability(std::size_t k) {
    static constexpr std::array<std::string_view, 7> kMay = {"can", "cannot", "could", "will", "would", "might", "may"};
    if (!is(k, ChunkKind::kRelative) && word(k) != "where" && word(k) != "that") return;
    const auto may = [](const Token& token) { return std::ranges::find(kMay, token.text) != kMay.end(); };
    if (is(k, ChunkKind::kNoun) && may(document_.tokens[std::min(chunks_[k].first + 1, chunks_[k].last - 1)])) {  // "that" is no article
      pass_over(k, k + 1, "told by the way");
      return;
    }
    std::size_t end = k + 1;
    bool told = false;
    for (; end < chunks_.size() && !is(end, ChunkKind::kComma) && !is(end, ChunkKind::kStop) && !is(end, ChunkKind::kAnd); ++end) {
      const auto first = document_.tokens.begin() + static_cast<std::ptrdiff_t>(chunks_[end].first);
      const auto last = document_.tokens.begin() + static_cast<std::ptrdiff_t>(chunks_[end].last);
      told |= std::any_of(first, last, may);
      const bool tin = is_thing(end) && last_word(end) == "can";
      if (is(end, ChunkKind::kRelation) || is(end, ChunkKind::kHave) || is(end, ChunkKind::kThere) ||
          (is_thing(end) && chunks_[end].noun.exact && !tin))
        return;
    }
    if (told) pass_over(k, end, "told by the way");
  }

  // "three trunks block the corner", "two curtains screen the bed": between several things and an article stands no noun.
  void read_verb_between(std::size_t k) {
    if (!is_thing(k) || !(chunks_[k].noun.count > 1 || chunks_[k].noun.plural) || !is(k + 2, ChunkKind::kNoun)) return;
    const Chunk &verb = chunks_[k + 1], &whom = chunks_[k + 2];
    const bool bare =
        (is(k + 1, ChunkKind::kIgnored) && is_noun(noun_form(word(k + 1)))) ||
        (is(k + 1, ChunkKind::kNoun) && verb.noun.determiner == Determiner::kNone && verb.noun.count == 0 && !verb.noun.plural);
    const bool close = verb.first == chunks_[k].last && verb.last == verb.first + 1 && whom.first == verb.last;
    if (bare && close && whom.noun.determiner != Determiner::kNone) chunks_[k + 1].kind = ChunkKind::kUnknown;
  }

  // "in sherbet colours", "in a rustic style"; "covered in paper", "wrapped in felt": what it looks like.
  void read_quality(std::size_t k) {
    if (!is(k, ChunkKind::kRelation) || !is(k + 1, ChunkKind::kNoun) || k == 0) return;
    const NounPhrase& noun = chunks_[k + 1].noun;
    const bool shown = chunks_[k].last == chunks_[k].first + 1 && word(k) == "in" && one_of(noun.head, WordSet::kLooks);
    const bool cover = one_of(word(k), WordSet::kCoveredWith);
    const bool stuff = noun.kind == NounKind::kObject && noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural &&
                       noun.name == noun.head && !noun.contents;
    if (shown || (cover && stuff && one_of(last_word(k), {"in", "with", "by"}))) pass_over(k, k + 2, "attribute");
  }

  // "waits on its legs", "stands on its wheels": how it stands, not where.
  void read_own_feet(std::size_t k) {
    if (!is(k, ChunkKind::kRelation) || !is(k + 1, ChunkKind::kNoun) || word(k) != "on" || last_word(k) != "on") return;
    const NounPhrase& noun = chunks_[k + 1].noun;
    const bool feet = one_of(noun.head, WordSet::kFeet);
    if (feet && (noun.determiner == Determiner::kPossessive || noun.count > 0)) pass_over(k, k + 2, "attribute");
  }

  // "two candlesticks, one candlestick to the left of the clock, the other to its right": one of them.
  void read_one_of_named(std::size_t k) {
    if (!is_thing(k) || k == 0 || !is(k - 1, ChunkKind::kComma) || chunks_[k].noun.count != 1 || !is(k + 1, ChunkKind::kRelation)) return;
    bool other = false;
    for (std::size_t n = k + 1; n < chunks_.size() && !is(n, ChunkKind::kStop); ++n)
      other = other ||
              (is(n, ChunkKind::kNoun) && chunks_[n].noun.kind == NounKind::kMember && chunks_[n].noun.determiner == Determiner::kOther);
    for (std::size_t n = k; other && n-- > 0 && !is(n, ChunkKind::kStop);) {
      if (!is_thing(n) || chunks_[n].noun.head != chunks_[k].noun.head || chunks_[n].noun.count < 2) continue;
      chunks_[k].noun.kind = NounKind::kMember;
      return;
    }
  }

  // "muddy to the axle", "kindest to seedlings": how far, or to whom, an adjective holds.
  void read_degree(std::size_t k) {
    if (k == 0 || !is(k, ChunkKind::kRelation) || !is(k + 1, ChunkKind::kNoun) || word(k) != "to" || last_word(k) != "to") return;
    const std::string& before = document_.tokens[chunks_[k].first - 1].text;
    if (is(k - 1, ChunkKind::kNoun) || is(k - 1, ChunkKind::kRelation) || word_form(before) != WordForm::kAdjective) return;
    pass_over(k, k + 2, "attribute");
  }

  // "The only seat is a stool": the stool. "The only thing on it is a flask": on it is a flask.
  void read_only(std::size_t k) {
    if (!is(k, ChunkKind::kNoun) || !begins_clause(k) || chunks_[k].noun.determiner != Determiner::kDefinite) return;
    const bool placed = is(k + 1, ChunkKind::kRelation), by_name = placed && is(k + 2, ChunkKind::kNoun);  // or "on it"
    const std::size_t be = by_name ? k + 3 : placed ? k + 2 : k + 1;
    if (!is(be, ChunkKind::kVerb) || !is(be + 1, ChunkKind::kNoun) || chunks_[be].last != chunks_[be].first + 1) return;
    const NounPhrase& named = chunks_[be + 1].noun;
    if (named.kind != NounKind::kObject || named.determiner != Determiner::kIndefinite || !one_of(word(be), {"is", "was"})) return;
    bool only = false;
    for (std::size_t i = chunks_[k].first; i < chunks_[k].last; ++i)
      only = only || one_of(document_.tokens[i].text, {"only", "sole", "one"});
    if (!only) return;
    pass_over(k, k + 1, "what is said of it");
    pass_over(be, be + 1, placed ? "there" : "what is said of it");
  }

  // "To the left of the bench stands a flag, to the right of the bench another": another flag.
  void read_another(std::size_t k) {
    if (k < 2 || !is(k, ChunkKind::kNoun) || chunks_[k].noun.kind != NounKind::kMember || chunks_[k].noun.subset) return;
    if (chunks_[k].noun.determiner != Determiner::kAnother || !is(k - 1, ChunkKind::kNoun) || !is(k - 2, ChunkKind::kRelation)) return;
    const bool over = is(k + 1, ChunkKind::kStop) || is(k + 1, ChunkKind::kComma) || is(k + 1, ChunkKind::kAnd);
    for (std::size_t n = k - 2; over && n-- > 0 && !is(n, ChunkKind::kStop);) {
      if (!is_thing(n) || (n > 0 && is(n - 1, ChunkKind::kRelation)) || !is_new(chunks_[n].noun)) continue;
      NounPhrase same = chunks_[n].noun;
      same.determiner = Determiner::kAnother;
      same.count = 0;
      same.first = chunks_[k].noun.first, same.last = chunks_[k].noun.last;
      chunks_[k].noun = std::move(same);
      return;
    }
  }

  // "has found its place in the corner": found it.
  void read_perfect(std::size_t k) {
    if (!is(k, ChunkKind::kHave) || !one_of(word(k), {"has", "have", "had"}) || chunks_[k].last != chunks_[k].first + 1) return;
    if (chunks_[k + 1].first == chunks_[k].last && one_of(word(k + 1), {"found", "taken", "earned", "made"}))
      pass_over(k, k + 1, "perfect");
  }

  // "Either side of the window gets a bookshelf", "on the wall has one clock", "on it the cook keeps a kettle": there it is.
  void read_place_has(std::size_t k) {
    if (!is(k, ChunkKind::kRelation) || !begins_clause(k)) return;
    if (stands_alone(k) && is_thing(k + 1) && is_new(chunks_[k + 1].noun)) return;  // "to its left a rack holds": the rack does
    const std::size_t after = is(k + 1, ChunkKind::kNoun) ? k + 2 : k + 1;
    std::size_t has = after;
    while (has < after + 2 && (is(has, ChunkKind::kIgnored) || (is(has, ChunkKind::kNoun) && !is_thing(has)))) ++has;
    if (!is(has, ChunkKind::kHave) || !is_thing(has + 1) || (has == after && after == k + 1)) return;
    if (one_of(word(has), {"has", "have", "gets", "get", "holds", "had", "keeps", "keep", "kept", "stores", "stored"}))
      pass_over(after, has + 1, "there");
  }

  // "four banners hang on the side walls, two on each": how the walls share them.
  void read_share_of_walls(std::size_t k) {
    if (!is(k, ChunkKind::kNoun) || !is(k + 1, ChunkKind::kComma) || !is(k + 2, ChunkKind::kNoun) || !is(k + 3, ChunkKind::kRelation))
      return;
    const NounPhrase &walls = chunks_[k].noun, &share = chunks_[k + 2].noun;
    const bool parts = (walls.kind == NounKind::kWall || walls.kind == NounKind::kCorner) && walls.is_plural();
    if (!parts || share.kind != NounKind::kMember || share.count == 0 || share.of || !is(k + 4, ChunkKind::kNoun)) return;
    const NounPhrase& each = chunks_[k + 4].noun;
    const bool of_each = each.determiner == Determiner::kEach && !each.of && (each.kind == NounKind::kMember || each.kind == walls.kind);
    if (!of_each || !one_of(word(k + 3), {"on", "in", "at", "along", "against", "per"})) return;
    pass_over(k + 1, k + 5, "how many at each");
  }

  // "a desk with a lamp and, next to the desk, the old cabinet": the place is the cabinet's.
  void read_place_between(std::size_t k) {
    if (k < 2 || !is(k, ChunkKind::kRelation) || !is(k + 1, ChunkKind::kNoun) || !is(k + 2, ChunkKind::kComma) || !is_thing(k + 3)) return;
    if (!is(k - 1, ChunkKind::kComma) || !is(k - 2, ChunkKind::kAnd)) return;
    pass_over(k - 1, k, "joins");
    pass_over(k + 2, k + 3, "joins");
  }

  // "to its left", "on the right": a place that needs nothing after it.
  bool stands_alone(std::size_t place) const {
    const PhraseSenses* senses = chunks_[place].phrase.senses;
    return senses != nullptr && has_direction(*senses, Direction::kAlone);
  }

  static bool is_new(const NounPhrase& noun) {
    return noun.determiner == Determiner::kIndefinite || (noun.determiner == Determiner::kNone && noun.count == 1);
  }

  Document& document_;
  std::vector<Chunk>& chunks_;
};

}  // namespace

void settle_inserts(Document& document) { InsertReader(document).run(); }

}  // namespace layoutbox::offline
