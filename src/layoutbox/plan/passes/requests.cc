#include "layoutbox/plan/passes/requests.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/token_reader.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

class RequestReader : public TokenReader {
 public:
  using TokenReader::TokenReader;

  void run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (skip_[i]) continue;
      read_possible(i);
      read_must_be(i);
      read_spot(i);
      read_looked_for(i);
      read_nothing_but(i);
      read_weight(i);
      read_whose(i);
      read_not_but(i);
      read_not_so(i);
      read_stranded(i);
      read_left(i);
      read_is_where(i);
      read_back(i);
      read_there(i);
      read_position(i);
      read_said_by(i);
      read_neither(i);
      read_both(i);
      read_elided(i);
      read_one_floor(i);
      read_asked_place(i);
      if (is(i, {"apiece"})) tokens_[i].text = "each";
      if (are(i, {"as", "to"}) && is_article(i + 2) && begins(i)) tokens_[i + 1].text = "for";  // "As to the lamp, leave it …"
    }
  }

 private:
  bool is_place(std::size_t at) const { return at < tokens_.size() && lexicon_.find_phrase(tokens_, at).length > 0; }

  // "On top of it? A jar of biscuits.": the answer goes on with the place.
  void read_asked_place(std::size_t i) {
    constexpr std::size_t kMostWords = 6;
    if (!is(i, {"?"}) || i + 1 >= tokens_.size()) return;
    std::size_t first = i;
    while (first > 0 && first + kMostWords > i && !tokens_[first - 1].ends_sentence) --first;
    if (first > 0 && !tokens_[first - 1].ends_sentence) return;
    const std::size_t place = lexicon_.find_phrase(tokens_, first).length;
    if (place == 0 || first + place > i) return;
    for (std::size_t at = first + place; at < i; ++at) {
      if (lexicon_.is(tokens_[at], WordClass::kBe) || lexicon_.is(tokens_[at], WordClass::kVerb)) return;
    }
    tokens_[i].text = ":";
    tokens_[i].ends_sentence = false;
  }

  // "Would it be possible for the TV to sit on the cabinet, and for the console to be in it?": the TV sits there.
  void read_possible(std::size_t i) {
    constexpr std::size_t kName = 8, kSentence = 40;  // tokens
    const bool may = is(i, {"would", "could", "might"}) && are(i + 1, {"it", "be", "possible"});
    const bool is_it = is(i, {"is"}) && are(i + 1, {"it", "possible"});
    if (!may && !is_it) return;
    std::size_t at = i + (may ? 4 : 3);
    leave_out(i, at);
    for (const std::size_t last = std::min(tokens_.size(), at + kSentence); at < last && !tokens_[at].ends_sentence; ++at) {
      if (!is(at, {"for"}) || !is_article(at + 1)) continue;
      std::size_t to = at + 2;
      while (to < last && to < at + kName && !is(to, {"to"}) && !ends(to)) ++to;
      if (!is(to, {"to"})) continue;
      leave_out(at, at + 1);
      leave_out(to, to + 1);
      at = to;
    }
  }

  // "It must be one table against the wall": there is one.
  void read_must_be(std::size_t i) {
    if (!is(i, {"it"}) || !is(i + 1, {"must", "should", "shall"}) || !is(i + 2, {"be"}) || !is_article(i + 3)) return;
    tokens_[i].text = "there";
    leave_out(i + 1, i + 2);
    tokens_[i + 2].text = "is";
  }

  // "Find a spot for the plant by the window", "make room beside the printer for a plant": put it there.
  void read_spot(std::size_t i) {
    constexpr std::size_t kReach = 12;  // tokens
    if (!is(i, {"find", "make", "leave", "reserve", "save", "keep", "have"})) return;
    std::size_t spot = i + 1;
    while (is(spot, {"a", "an", "some", "enough", "good", "nice", "suitable", "the"})) ++spot;
    if (!is(spot, WordSet::kHomes)) return;
    if (is(spot + 1, {"for"}) && is_article(spot + 2)) {
      const std::optional<NamedThing> thing = thing_named_at(spot + 2);
      if (thing && thing->entry != nullptr && thing->entry->is(Trait::kPersonalAid)) return;  // it only has to pass there
      tokens_[i].text = "put";
      leave_out(i + 1, spot + 2);
      return;
    }
    if (!is_place(spot + 1)) return;
    std::size_t on = spot + 1;
    while (on < tokens_.size() && on < spot + kReach && !tokens_[on].ends_sentence && !(is(on, {"for"}) && is_article(on + 1))) ++on;
    if (!is(on, {"for"})) return;
    leave_out(i, spot + 1);
    if (tokens_[on - 1].text == ",") leave_out(on - 1, on);
    tokens_[on].text = "put";
  }

  // "The bottle you're looking for is in the crate"
  void read_looked_for(std::size_t i) {
    const std::size_t at = is(i, {"that", "which"}) ? i + 1 : i;
    if (i == 0 || !is(at, {"you", "we", "i"}) || !is(at + 1, {"are", "am", "were"}) || !is(at + 2, {"looking", "searching"})) return;
    if (is(at + 3, {"for"})) leave_out(i, at + 4);
  }

  // "contains nothing but a suitcase", "its top bare except for a radio"
  void read_nothing_but(std::size_t i) {
    const auto past_except = [&](std::size_t at) {
      if (is(at, {"except", "but", "save"})) return at + (is(at + 1, {"for"}) ? 2 : 1);
      return are(at, {"apart", "from"}) || are(at, {"other", "than"}) ? at + 2 : at;
    };
    const bool nothing = is(i, {"nothing"}), bare = is(i, {"bare", "empty", "clear"});
    const std::size_t past = past_except(i + 1);
    if ((!nothing && !bare) || past == i + 1 || !is_article(past) || i == 0) return;
    if (nothing && !lexicon_.is(tokens_[i - 1], WordClass::kHave) && lexicon_.find_phrase(tokens_, i - 1).length == 0) return;
    if (bare) tokens_[i].text = "with";
    leave_out(bare ? i + 1 : i, past);
  }

  // "bears the weight of four jars"
  void read_weight(std::size_t i) {
    if (i > 0 && are(i, {"the", "weight", "of"}) && is(i - 1, {"bears", "bear", "bearing", "takes", "carries", "supports", "supporting"}))
      leave_out(i, i + 3);
  }

  // "a bench on whose seat a box has been left": on which
  void read_whose(std::size_t i) {
    if (!is(i, {"whose"}) || !is(i + 1, {"seat", "top", "surface", "lid", "tabletop", "shelf", "shelves", "cushion"}) || !is_article(i + 2))
      return;
    if (i == 0 || lexicon_.find_phrase(tokens_, i - 1).length == 0) return;
    tokens_[i].text = "which";
    leave_out(i + 1, i + 2);
  }

  // "not on the table but on the stool": on the stool
  void read_not_but(std::size_t i) {
    constexpr std::size_t kReach = 8;  // tokens
    if (!is(i, {"not"}) || !is_place(i + 1)) return;
    for (std::size_t but = i + 2; but < tokens_.size() && but < i + kReach && !tokens_[but].ends_sentence; ++but) {
      if (!is(but, {"but"}) || !is_place(but + 1)) continue;
      leave_out(i, but + 1);
      if (i > 0 && tokens_[i - 1].text == ",") leave_out(i - 1, i);
      return;
    }
  }

  // "three desks, not in a row please", "a bed, not against the wall": away from it
  void read_not_so(std::size_t i) {
    if (i == 0 || !is(i, {"not"})) return;
    if (is(i + 1, {"against"})) {
      tokens_[i].text = "away";
      tokens_[i + 1].text = "from";
      if (tokens_[i - 1].text == ",") leave_out(i - 1, i);
    } else if (is(i + 1, {"in"}) && is(i + 2, {"a", "one"})) {
      const std::size_t form = is(i + 3, {"straight", "single", "long", "neat"}) ? i + 4 : i + 3;
      if (is(form, {"row", "line", "file", "circle", "grid"})) leave_out(i, form + 1);
    }
  }

  // "The stool that the plant stands on is next to the window": with the plant on it
  void read_stranded(std::size_t i) {
    constexpr std::size_t kName = 4;  // words of what stands there
    if (i == 0 || !is(i, {"that", "which"}) || !is_article(i + 1) || !lexicon_.is(tokens_[i + 1], WordClass::kDefinite)) return;
    std::size_t verb = i + 2;
    while (verb < i + 2 + kName && !ends(verb) &&
           !is(verb, {"stands", "stand", "sits", "sit", "lies", "lie", "rests", "rest", "hangs", "hang"}))
      ++verb;
    if (ends(verb) || verb == i + 2 || verb >= i + 2 + kName || !is(verb + 1, {"on", "in", "under", "above", "upon", "beside"})) return;
    if (is_article(verb + 2) || verb + 2 >= tokens_.size()) return;
    tokens_[i].text = "with";
    std::swap(tokens_[verb].text, tokens_[verb + 1].text);
    tokens_[verb + 1].text = "it";
  }

  // "Somebody left a bucket in front of the cabinet": put it there.
  void read_left(std::size_t i) {
    if (i == 0 || !is(i, {"left"}) || !is_article(i + 1) || lexicon_.is(tokens_[i + 1], WordClass::kPossessive)) return;
    const bool who = lexicon_.is(tokens_[i - 1], WordClass::kDoer) ||
                     is(i - 1, {"somebody", "someone", "has", "have", "had", "who", "he", "she", "they", "we", "i"});
    if (!who) return;
    tokens_[i].text = "put";
    if (is(i - 1, {"somebody", "someone"})) leave_out(i - 1, i);
  }

  // "Far from the bed is where the desk ought to be": the desk
  void read_is_where(std::size_t i) {
    constexpr std::size_t kName = 8;  // tokens
    if (!is(i, {"is", "are"}) || !is(i + 1, {"where"}) || !is_article(i + 2)) return;
    std::size_t verb = i + 3;
    while (verb < i + kName && !ends(verb) &&
           !is(verb, {"ought", "should", "must", "has", "goes", "stands", "belongs", "lives", "sits", "is", "shall"}))
      ++verb;
    std::size_t end = verb;
    while (is(end, {"ought", "should", "must", "has", "goes", "stands", "belongs", "lives", "sits", "is", "shall", "to", "be", "stand",
                    "go", "sit"}))
      ++end;
    if (end == verb || !ends(end)) return;
    leave_out(i, i + 2);
    leave_out(verb, end);
    if (tokens_[i - 1].text == ",") leave_out(i - 1, i);
  }

  // "The sofa's back is against the wall": the sofa is.
  void read_back(std::size_t i) {
    if (i == 0 || !is(i, {"'s"}) || !is(i + 1, {"back"}) || !is(i + 2, {"is", "are", "against", "pressed", "to", "touches", "faces"}))
      return;
    leave_out(i, i + 2);
    if (is(i + 2, {"touches", "faces"})) tokens_[i + 2].text = "against";
  }

  // "squeezed in there, right next to a plant": where that is follows.
  void read_there(std::size_t i) {
    if (is(i, {"in", "over", "up", "out"}) && is(i + 1, {"there"}) && (ends(i + 2) || is_place(i + 2))) {
      leave_out(i, i + 2);
      if (is(i + 2, {","}) && is_place(i + 3)) leave_out(i + 2, i + 3);
    }
  }

  // "Item: bookcase. Position: adjacent to desk": the labels of a form
  void read_position(std::size_t i) {
    if (!is(i + 1, {":"}) || (i > 0 && !tokens_[i - 1].ends_sentence)) return;
    if (is(i, {"item", "object", "thing", "piece"})) leave_out(i, i + 2);
    if (!is(i, {"position", "location", "where", "placement", "place"}) || !is_place(i + 2)) return;
    leave_out(i, i + 2);
    if (i > 0) {
      tokens_[i - 1].text = ",";
      tokens_[i - 1].ends_sentence = false;
    }
  }

  // "Mum says the plants must stand under the window", "my wife insists that …": what is said.
  void read_said_by(std::size_t i) {
    constexpr std::size_t kWho = 4;  // words
    if (!begins(i)) return;
    bool person = false;
    for (std::size_t at = i; at < i + kWho && !ends(at); ++at) {
      if (is(at, {"says", "said", "thinks", "insists", "reckons", "suggests"}) && person && at > i) {
        if (is_article(at + 1) || is(at + 1, {"that"})) leave_out(i, at + (is(at + 1, {"that"}) ? 2 : 1));
        return;
      }
      person = person || lexicon_.is_person(tokens_[at].text) || lexicon_.is(tokens_[at], WordClass::kDoer) ||
               word_form(tokens_[at].text) == WordForm::kPerson;
    }
  }

  // "…, all on one floor", "everything is on the same level": of the house.
  void read_one_floor(std::size_t i) {
    std::size_t at = i;
    if (is(at, {"all", "both", "everything"})) ++at;
    if (is(at, {"is", "are"})) ++at;
    if (!is(at, {"on"})) return;
    ++at;
    if (is(at, {"the"})) ++at;
    if (is(at, {"one", "same", "single"}) && is(at + 1, {"floor", "level", "storey", "story"}) && !is(at + 2, {"of"})) leave_out(i, at + 2);
  }

  // "Neither the sofa nor the cabinet may block the window": both are there.
  void read_neither(std::size_t i) {
    constexpr std::size_t kReach = 12;  // tokens
    if (!is(i, {"neither"}) || !is_article(i + 1)) return;
    std::size_t nor = i + 2;
    while (nor < i + kReach && !ends(nor) && !is(nor, {"nor"})) ++nor;
    std::size_t may = nor;
    while (may < nor + kReach && !ends(may) && !is(may, {"may", "should", "must", "can", "shall", "will", "is", "are"})) ++may;
    if (!is(nor, {"nor"}) || ends(may)) return;
    std::size_t end = may;
    while (!ends(end) && !is(end, {"but"})) ++end;
    leave_out(i, i + 1);
    leave_out(may, end);
    tokens_[nor].text = "and";
  }

  // "Both a sign and a panel are mounted there": two that are listed; but "above both a shelf".
  void read_both(std::size_t i) {
    constexpr std::size_t kReach = 12;  // tokens
    if (!is(i, {"both"}) || !is_article(i + 1)) return;
    if (i > 0 && !tokens_[i - 1].ends_sentence && tokens_[i - 1].kind == Token::Kind::kWord &&
        !lexicon_.is(tokens_[i - 1], WordClass::kHave) && !is(i - 1, {"is", "are"}))
      return;
    for (std::size_t at = i + 2; at < i + kReach && !ends(at) && tokens_[at].kind != Token::Kind::kPunctuation; ++at) {
      if (is(at, {"and"})) return leave_out(i, i + 1);
    }
  }

  // "My father's chair stands by the window, my mother's by the bookcase": another one.
  void read_elided(std::size_t i) {
    if (i == 0 || !lexicon_.is(tokens_[i], WordClass::kPossessive) || !is(i + 2, {"'s"}) || !is_place(i + 3)) return;
    if (tokens_[i - 1].text != "," && !is(i - 1, {"and"})) return;
    tokens_[i].text = "another";
    tokens_[i + 1].text = "one";
    leave_out(i + 2, i + 3);
  }
};

}  // namespace

void read_requests(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  RequestReader(lexicon, document.tokens, skip).run();
}

}  // namespace layoutbox::offline
