#include "layoutbox/plan/passes/terse_lists.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/phrases/token_reader.h"

namespace layoutbox::offline {
namespace {

class TerseLists : public TokenReader {
 public:
  TerseLists(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : TokenReader(lexicon, document.tokens, skip), document_(document) {}

  void run() {
    for (std::size_t i = 0; i < tokens_.size() && !is_set(document_.stop); ++i) {
      if (skip_[i]) continue;
      read_people(i);
      part_ban(i);
      part_subject(i);
      part_from_host(i);
      part_from_pose(i);
      part_result(i);
      read_third_wish(i);
      read_both_halves(i);
      read_side_group(i);
      complete_center(i);
      complete_half(i);
      round_off(i);
    }
    std::ranges::stable_sort(words_, {}, &Splice::at);
    splice(document_, skip_, std::move(words_));
  }

 private:
  bool breaks(std::size_t at) const { return ends(at) || (at > 0 && tokens_[at - 1].ends_sentence); }
  bool opens(std::size_t at) const { return at == 0 || tokens_[at - 1].kind == Token::Kind::kPunctuation; }
  void end_sentence(std::size_t comma) {
    tokens_[comma].text = ";";
    tokens_[comma].ends_sentence = true;
  }

  // "Restaurant, seats 40.": the number comes behind.
  bool read_capacity(std::size_t i) {
    const std::size_t said = is(i + 1, {"for", "of", "about", "around", "up"}) ? i + (is(i + 2, {"to"}) ? 3 : 2) : i + 1;
    const NumberRead number = read_number(lexicon_, tokens_, said);
    if (!opens(i) || !is(i, {"seats", "seating", "capacity"}) || number.length == 0 || number.value < 2 || document_.people > 0)
      return false;
    const std::size_t last = said + number.length;
    if (!breaks(last) && !lexicon_.is_person(singular_of(tokens_[last].text))) return false;
    document_.people = static_cast<int>(number.value);
    leave_out(i, breaks(last) ? last : last + 1);
    return true;
  }

  // "shower in the corner no tub, toilet": what is not wanted begins anew.
  void part_ban(std::size_t i) {
    if (!is(i, {"no"}) || opens(i) || begins(i)) return;
    const std::string& before = tokens_[i - 1].text;
    const bool noun = lexicon_.find(tokens_, i - 1, WordClass::kObject).length > 0 ||
                      lexicon_.find(tokens_, i - 1, WordClass::kRoom).length > 0 || before == "corner" || before == "wall" ||
                      before == "window" || before == "door" || before == "middle";
    if (noun && lexicon_.find(tokens_, i + 1, WordClass::kObject).length > 0) words_.push_back({i, comma_token()});
  }

  // "24 kids.", "there are seven of us", "16 seats total": nothing that is put into the room.
  void read_people(std::size_t i) {
    if (read_capacity(i)) return;
    const std::size_t said = is(i, {"there", "we"}) && is(i + 1, {"are", "is", "will"}) ? (is(i + 2, {"be"}) ? i + 3 : i + 2) : i;
    const NumberRead number = read_number(lexicon_, tokens_, said);
    const std::size_t noun = said + number.length;
    constexpr double kFewest = 2, kMost = 400;
    if (number.length == 0 || !opens(i) || number.value < kFewest || number.value > kMost || noun >= tokens_.size()) return;
    const bool us = is(noun, {"of"}) && is(noun + 1, {"us", "them", "you"});
    const bool seats = is(noun, {"seats", "places", "people"}) &&
                       (is(noun + 1, {"total", "altogether", "overall"}) || (is(noun + 1, {"in"}) && is(noun + 2, {"total", "all"})));
    const std::string person = singular_of(tokens_[noun].text);
    const bool persons = person != tokens_[noun].text && lexicon_.is_person(person) && breaks(noun + 1) && said == i;
    if (!us && !seats && !persons) return;
    if (seats) leave_out(i, noun + (is(noun + 1, {"in"}) ? 3 : 2));
    if (persons && !says_for_whom()) return;
    if (document_.people == 0 && !(us && said == i)) document_.people = static_cast<int>(number.value);
    if (persons) leave_out(i, noun + 1);
  }

  // Where a class, a team or guests are spoken of, people on their own are those.
  bool says_for_whom() const {
    return std::ranges::any_of(tokens_, [](const Token& t) {
      return one_of(t.text, {"classroom", "class", "teach", "school", "daycare", "kindergarten", "office", "lab", "laboratory", "seminar",
                             "restaurant", "cafe", "dinner", "dining", "dine", "boardroom", "conference", "meeting"});
    });
  }

  // "a plant, desk should face the door", "a bed, wardrobe is on the left": only the last thing of the list is told of.
  void part_subject(std::size_t comma) {
    if (!is(comma, {","}) || tokens_[comma].ends_sentence || comma == 0) return;
    const auto thing = thing_named_at(comma + 1);
    if (!thing || breaks(thing->last) || !is(thing->last, {"should", "must", "shall", "needs", "need", "has", "can", "could", "may"}))
      return;
    const bool does = is(thing->last, {"needs", "need", "has"}) ? is(thing->last + 1, {"to"}) : !breaks(thing->last + 1);
    const bool determined = thing->noun > thing->first && is(thing->first, {"which", "that", "all", "both", "each"});
    const auto item = item_before(comma);
    if (does && !determined && item && item->last == comma) end_sentence(comma);
  }

  // What the list's item before the comma begins with.
  std::optional<NamedThing> item_before(std::size_t comma) const {
    std::size_t first = comma;
    while (first > 0 && !opens(first)) --first;
    return thing_named_at(first);
  }

  // "bed, rug, desk with a swivel chair, a beanbag.": what the list ends with is no more the desk's than what it begins with.
  void part_from_host(std::size_t comma) {
    if (!is(comma, {","}) || tokens_[comma].ends_sentence) return;
    const auto item = thing_named_at(comma + 1);
    if (!item || !(breaks(item->last) || tokens_[item->last].ends_sentence)) return;
    if (item->last < tokens_.size() && is(item->last, {","})) return;
    std::size_t with = comma;
    while (with > 0 && !opens(with) && !is(with, {"with"})) --with;
    if (!is(with, {"with"}) || tokens_[with].ends_sentence) return;
    const auto content = thing_named_at(with + 1);
    if (!content || content->last != comma) return;
    if (is_listed_before(with)) end_sentence(comma);
  }

  // "I like groups, so tables in fours": what follows is asked for, and not told by the way.
  void part_result(std::size_t comma) {
    if (!is(comma, {","}) || !is(comma + 1, {"so"}) || is_article(comma + 2) || !thing_named_at(comma + 2)) return;
    end_sentence(comma);
    leave_out(comma + 1, comma + 2);
  }

  // "…, and my wife would love a dressing table": asked for like the rest.
  void read_third_wish(std::size_t i) {
    if (!is(i, {"my", "our", "the"}) || i + 3 >= tokens_.size() || !(opens(i) || is(i - 1, {"and"})) || ends(i + 1)) return;
    if (!lexicon_.is_person(singular_of(tokens_[i + 1].text))) return;
    std::size_t verb = i + 2;
    if (is(verb, {"would", "really", "also"})) ++verb;
    if (is(verb, {"really", "also"})) ++verb;
    if (!is(verb, {"love", "like", "loves", "likes", "wants", "want", "needs", "need"}) || !is_article(verb + 1)) return;
    if (thing_named_at(verb + 1)) leave_out(i, verb + 1);
  }

  // "bed, desk, chair and wardrobe on each side": two of each, the first of them across from one another.
  void read_both_halves(std::size_t on) {
    if (!is(on, {"on"}) || !is(on + 1, {"each", "either", "both"}) || !is(on + 2, {"side", "sides"}) || is(on + 3, {"of"})) return;
    std::vector<NamedThing> things;
    for (std::size_t end = on; end > 0;) {
      std::size_t first = end;
      while (first > 0 && !opens(first) && !is(first - 1, {"and"})) --first;
      const auto thing = thing_named_at(first);
      const bool stands = thing && thing->entry != nullptr && thing->entry->mount == Mount::kFloor;
      if (!stands || thing->last != end || is_article(first) || tokens_[end - 1].text != singular_of(tokens_[end - 1].text)) break;
      things.insert(things.begin(), *thing);
      if (first == 0 || !is(first - 1, {",", "and"})) break;
      end = first - 1;
      if (end > 0 && is(end - 1, {","})) --end;
    }
    constexpr std::size_t kFewest = 3;
    if (things.size() < kFewest) return;
    for (const NamedThing& thing : things) {
      words_.push_back({thing.first, word_token("two")});
      tokens_[thing.last - 1].text += "s";
    }
    for (const std::string_view word : {"on", "opposite", "walls"}) words_.push_back({things.front().last, word_token(word)});
    leave_out(on, on + 3);
  }

  // "to the left a seating area composed of two sofas and a table": these are in that half of the room.
  void read_side_group(std::size_t i) {
    if (!is(i, {"to", "on"}) || !is(i + 1, {"the"}) || !is(i + 2, {"left", "right"}) || !(opens(i) || is(i - 1, {"and"}))) return;
    std::size_t at = i + 3;
    const bool side = is(at, {"side"});
    if (side) ++at;
    if (is(at, {"of"})) return;
    const std::size_t comma = at;
    if (is(at, {","})) ++at;
    if (ends(at) || !lexicon_.is(tokens_[at], WordClass::kIndefinite)) return;
    std::size_t area = at + 1;
    while (area < at + 3 && !ends(area) && !is(area, {"area", "group", "zone", "arrangement", "section", "nook"})) ++area;
    if (!is(area, {"area", "group", "zone", "arrangement", "section", "nook"})) return;
    std::size_t of = area + 1;
    if (is(of, {"composed", "consisting", "comprised", "made", "formed"})) of += is(of + 1, {"up"}) ? 2 : 1;
    if (!is(of, {"with", "of"}) || !is_article(of + 1)) return;
    tokens_[i].text = "in";
    if (side) tokens_[i + 3].text = "half";
    if (!side) words_.push_back({i + 3, word_token("half")});
    leave_out(comma, of + 1);
  }

  // "sofa with its back to the table, sideboard, …": what follows in the list is not behind the sofa as well.
  void part_from_pose(std::size_t comma) {
    constexpr std::size_t kLongest = 14;  // tokens
    if (!is(comma, {","}) || tokens_[comma].ends_sentence || !thing_named_at(comma + 1)) return;
    for (std::size_t with = comma; with-- > 0 && comma - with <= kLongest && !ends(with);) {
      const bool pose = is(with, {"with"}) && is(with + 1, {"its", "their"}) && is(with + 2, {"back", "backs", "front", "fronts"}) &&
                        is(with + 3, {"to", "towards", "toward", "against"});
      if (pose) return end_sentence(comma);
    }
  }

  // Two things or more, with nothing but commas between them, before the one that has something "with" it.
  bool is_listed_before(std::size_t with) const {
    constexpr int kFewest = 2;
    int items = 0;
    for (std::size_t i = with; i-- > 0 && !tokens_[i].ends_sentence;) {
      if (is(i, {"is", "are", "has", "have", "stands", "and"})) return false;
      if (is(i, {","}) && item_before(i)) ++items;
    }
    return items >= kFewest;
  }

  // "steel table center, cart": in the center.
  void complete_center(std::size_t i) {
    if (!is(i, {"center", "middle"}) || i == 0 || tokens_[i - 1].ends_sentence || tokens_[i].ends_sentence) return;
    if (!ends(i + 1) && !is(i + 1, {"of"})) return;
    const Match before = lexicon_.find(tokens_, i - 1, WordClass::kObject);
    if (before.length != 1 || lexicon_.find(tokens_, i - 1).length > 1) return;
    for (const std::string_view word : {"in", "the"}) words_.push_back({i, word_token(word)});
  }

  // "cots on one half; on the other a mat": the half that is left.
  void complete_half(std::size_t i) {
    one_half_ |= is(i, {"one"}) && is(i + 1, {"half"}) && !is(i + 2, {"of"}) && i > 0 && is(i - 1, {"on", "in", "the"});
    if (!is(i, {"on", "in", "at"}) || !is(i + 1, {"the"}) || !is(i + 2, {"other"}) || !opens(i) || !is_article(i + 3) || !one_half_) return;
    tokens_[i].text = "in";
    tokens_[i + 2].text = "right";
    words_.push_back({i + 3, word_token("half")});
  }

  // "a coffee table with no sharp corners": a round one.
  void round_off(std::size_t with) {
    const bool with_no = is(with, {"with"}) && is(with + 1, {"no"});
    if (with == 0 || (!with_no && !is(with, {"without"}))) return;
    const std::size_t sharp = with + (with_no ? 2 : 1);
    if (!is(sharp, {"sharp", "pointy", "hard"}) || !is(sharp + 1, {"corners", "edges", "corner", "edge"})) return;
    const Match thing = lexicon_.find(tokens_, with - 1, WordClass::kObject);
    if (thing.length == 0) return;
    std::size_t first = with - 1;
    while (first > 0 && first - 1 + lexicon_.find(tokens_, first - 1, WordClass::kObject).length == with) --first;
    words_.push_back({first, word_token("round")});
    leave_out(with, sharp + 2);
  }

  Document& document_;
  std::vector<Splice> words_;
  bool one_half_ = false;  // something is on one half
};

}  // namespace

void read_terse_lists(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { TerseLists(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
