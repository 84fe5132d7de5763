// What is there for each of several: persons and places that are no things ("every student has …", "for each of us three …"), parts, and
// things whose having is not said ("each plinth a bust").
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

namespace {

// "its vise", "their cushions"
bool is_its(const NounPhrase& noun) {
  return noun.kind == NounKind::kObject && noun.determiner == Determiner::kPossessive && !noun.owner && !noun.of;
}

}  // namespace

// How many the noun at k means by "each", where it is a person or a place for one, not a thing; 0: it is a thing, or nobody says.
int UnitReader::shares_of(std::size_t k) const {
  constexpr std::size_t kFarthest = 120;
  const NounPhrase& noun = chunk(k).noun;
  if (noun.determiner != Determiner::kEach || noun.every > 0 || noun.kind == NounKind::kWall || noun.kind == NounKind::kCorner) return 0;
  const NounPhrase& whom = noun.of ? *noun.of : noun;
  const bool member = whom.kind == NounKind::kMember || whom.kind == NounKind::kPronoun;
  const auto is_somebody = [&](const NounPhrase& who) {
    return who.entry == nullptr && (lexicon_.is_person(who.head) || word_form(who.head) == WordForm::kPerson);
  };
  const bool place = one_of(whom.head, WordSet::kWorkplaces) && !whom.exact;
  if (!member && !is_somebody(whom) && !place && whom.kind != NounKind::kAbstract) return 0;
  if (whom.count > 1) return whom.count;
  const std::size_t n = next(k);  // "each of us three"
  const bool us = is(k + 1, ChunkKind::kIgnored) && is(n, ChunkKind::kNoun) && chunk(n).noun.kind == NounKind::kMember;
  if (us && document_.tokens[chunk(n).first - 1].text == "us") return chunk(n).noun.count;
  const auto so_many = [&](std::size_t c) {
    if (!is(c, ChunkKind::kNoun)) return 0;
    const NounPhrase& all = chunk(c).noun;
    const bool named = member ? is_somebody(all) : all.head == whom.head || (is_somebody(all) && is_somebody(whom));
    return named && all.count > 1 ? all.count : 0;
  };
  for (std::size_t c = k; c-- > 0 && c + kFarthest > k;) {
    if (const int count = so_many(c); count > 0) return count;
    if (member && is(c, ChunkKind::kNoun) && chunk(c).noun.kind == NounKind::kObject) return 0;
  }
  for (std::size_t c = k + 1; !member && c < document_.chunks.size() && c < k + kFarthest; ++c) {
    if (const int count = so_many(c); count > 0) return count;
  }
  if (document_.people > 1 && !place) return document_.people;
  constexpr int kSeveral = 2;  // "each guest has a bed", where nobody says how many come
  return !member && is_somebody(whom) ? kSeveral : 0;
}

// "for every place a stool and a mirror": what the sentence brings in from here on is there so many times.
bool UnitReader::shares_by_purpose(std::size_t k) {
  const std::size_t n = next(k);
  if (skipping_ || document_.tokens[chunk(k).last - 1].text != "for" || !is(n, ChunkKind::kNoun)) return false;
  const int shares = shares_of(n);
  if (shares < 2) return false;
  std::size_t last = n;
  const std::size_t more = next(n);  // "each of us three"
  if (is(n + 1, ChunkKind::kIgnored) && is(more, ChunkKind::kNoun) && chunk(more).noun.count == shares &&
      chunk(more).noun.kind == NounKind::kMember)
    last = more;
  open_share(k, last, shares);
  return true;
}

// "every student has a bed", "give each child a cot"
bool UnitReader::shares_by_subject(std::size_t k) {
  if (skipping_ || negated_ || after_place()) return false;
  const int shares = shares_of(k);
  if (shares < 2) return false;
  const std::size_t n = next(k);
  const bool has = is(n, ChunkKind::kHave) || is(n, ChunkKind::kPurpose) || is(n, ChunkKind::kCommand);
  const std::size_t thing = has ? next(n) : n;
  if (!is(thing, ChunkKind::kNoun) || chunk(thing).noun.kind != NounKind::kObject) return false;
  open_share(k, has ? n : k, shares);
  return true;
}

void UnitReader::open_share(std::size_t first, std::size_t last, int shares) {
  for (std::size_t c = first; c <= last; ++c) mark(c, Use::kUsed, "for each");
  add(UnitKind::kOpen, first);
  passed_until_ = last + 1;
  share_ = shares;
}

// "… and one printer for all", "a shared printer".
bool UnitReader::is_for_all(std::size_t k) const {
  const std::size_t last = chunk(k).last;
  if (is_common(chunk(k).noun)) return true;
  if (last + 1 >= document_.tokens.size()) return false;
  if (document_.tokens[last].text == "between") return one_of(document_.tokens[last + 1].text, {"us", "them", "both"});
  if (document_.tokens[last].text != "for") return false;
  return one_of(document_.tokens[last + 1].text, WordSet::kEverybody);
}

// "each plinth a bust", "every desk two monitors": a having that is not said.
void UnitReader::has_unsaid(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const bool placed = units_.size() > 1 && units_[units_.size() - 2].kind == UnitKind::kPlace && units_.back().joiner == Joiner::kNone;
  const bool wall = noun.kind == NounKind::kWall && !noun.wall_word.empty();
  if (placed || !is(k + 1, ChunkKind::kNoun) || (noun.kind != NounKind::kObject && !wall)) return;
  const NounPhrase& thing = chunk(k + 1).noun;
  const bool opening = thing.kind == NounKind::kWindow || thing.kind == NounKind::kDoor;
  const bool anew = thing.determiner == Determiner::kIndefinite || thing.count > 0;
  // "The left wall has a bookshelf, the right wall a painting": the having is not said again
  const bool again = units_.back().joiner != Joiner::kNone && noun.determiner == Determiner::kDefinite && anew &&
                     std::ranges::any_of(units_, [&](const Unit& unit) {
                       return unit.kind == UnitKind::kHave && !unit.unsaid && is_finite(document_.tokens[chunk(unit.chunk).first].text);
                     });
  const bool each = noun.determiner == Determiner::kEach && (thing.determiner == Determiner::kIndefinite || thing.count > 0);
  const bool its = units_.back().joiner != Joiner::kNone && is_its(thing);  // "the desk has its lamp, the bed its nightstand"
  const bool fresh = (thing.kind == NounKind::kObject && (each || its || again)) || (opening && wall && again);
  if (!fresh || (!units_.empty() && units_.back().chunk == k && units_.back().kind == UnitKind::kHave)) return;
  add(UnitKind::kHave, k);
  units_.back().unsaid = true;
}

// "the bench and its vise, the cart and its bins": with it, where nothing is said of the two.
void UnitReader::has_its_own(std::size_t k) {
  if (joiner_ != Joiner::kAnd || clause_ || units_.empty() || units_.back().kind != UnitKind::kNoun || !is_its(chunk(k).noun)) return;
  const std::size_t host = units_.back().chunk, after = next(k);
  const bool reference = units_.size() > 1 && units_[units_.size() - 2].kind == UnitKind::kPlace && units_.back().joiner == Joiner::kNone;
  const bool ends =
      after >= document_.chunks.size() || is(after, ChunkKind::kComma) || is(after, ChunkKind::kAnd) || is(after, ChunkKind::kStop);
  const bool own = one_of(document_.tokens[chunk(k).noun.first].text, {"its", "their"});  // not "a desk and my television"
  if (!own || reference || !ends || chunk(host).noun.kind != NounKind::kObject || is_named_before(k, chunk(k).noun.head)) return;
  joiner_ = Joiner::kNone;
  add(UnitKind::kHave, host);
  units_.back().unsaid = true;
}

}  // namespace layoutbox::offline
