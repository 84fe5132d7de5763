#include "layoutbox/plan/passes/wants.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/plan/passes/use_rows.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

// "cooking", "washes", "having": what such a verb may be without its ending.
std::vector<std::string> bases_of(const std::string& word) {
  std::vector<std::string> bases = {word};
  const std::size_t length = word.size();
  constexpr std::size_t kShortest = 5;
  if (length >= kShortest && word.ends_with("ing")) {
    const std::string stem = word.substr(0, length - 3);
    bases.push_back(stem);
    bases.push_back(stem + "e");
    if (stem.size() > 2 && stem.back() == stem[stem.size() - 2]) bases.push_back(stem.substr(0, stem.size() - 1));
  }
  if (length > 2 && word.ends_with("s") && !word.ends_with("ss")) bases.push_back(word.substr(0, length - 1));
  if (length > 3 && word.ends_with("es")) bases.push_back(word.substr(0, length - 2));
  if (length > 3 && word.ends_with("ies")) bases.push_back(word.substr(0, length - 3) + "y");
  return bases;
}

class WantReader : public UseRows {
 public:
  WantReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : UseRows(lexicon, document.tokens, skip), document_(document) {}

  void run() {
    constexpr int kMost = 20;  // frames: what a text wants is said in fewer
    int read = 0;
    for (std::size_t i = 0; i < tokens_.size() && read < kMost; ++i) {
      if (skip_[i]) continue;
      const std::optional<Frame> frame = frame_at(i);
      if (!frame) continue;
      const std::size_t end = read_list(*frame);
      if (end == 0) continue;
      ++read;
      i = end - 1;
    }
    std::ranges::stable_sort(words_, {}, &Splice::at);
    splice(document_, skip_, std::move(words_));
  }

 private:
  // Who wants it, from its first word on, and where the first verb stands.
  struct Frame {
    std::size_t first = 0, verb = 0;
    int people = 0;
    std::size_t least = 1;  // things that are done, of which something is known
  };

  // One thing that is done: "wash up", "sit at a desk".
  struct Doing {
    std::size_t first = 0, end = 0;
    std::optional<Use> use;
    std::size_t use_first = 0;
    std::size_t thing = 0;  // where furniture is named from which on all is kept; `end`: none is
  };

  std::optional<Frame> frame_at(std::size_t i) {
    // "a kitchen can work for me: cooking, washing up", "a room for sleeping, drawing": done, one after the other
    const bool led = is(i, {":"}) || (is(i, {"for"}) && i > 0 && is(i - 1, {"work", "room", "space", "place", "good", "right", "fit"}));
    if (led && i + 1 < tokens_.size() && tokens_[i + 1].text.ends_with("ing")) return Frame{i, i + 1, 0, 2};
    // "somewhere to open suitcases, hang clothes, make a coffee"
    if (one_of(tokens_[i].text, WordSet::kSomewhere) && is(i + 1, {"to"}) && !ends(i + 2) && use_of_verb(i + 2, 0))
      return Frame{i, i + 2, 0, 2};
    if (is(i, {"let", "lets"})) return frame_of_doers(i + 1, i);
    const bool opens = begins(i) || (i > 0 && is(i - 1, {",", ";", ":", "and", "but", "because", "so"}));
    if (opens) {
      if (const std::optional<Frame> frame = frame_of_clause(i)) return frame;
      if (!begins(i) && !is(i - 1, {":", ","})) return std::nullopt;
      if (const std::optional<Frame> frame = names_any_furniture() ? std::nullopt : frame_of_doers(i, i)) return frame;
      // "Sleep, cook simple stuff, eat with a guest."
      if (begins(i) && tokens_[i].kind == Token::Kind::kWord && use_of_verb(i, 0)) return Frame{i, i, 0, 3};
      return std::nullopt;
    }
    // "a bathroom where I can bathe two toddlers"
    const bool room = i > 0 && (lexicon_.find(tokens_, i - 1, WordClass::kRoom).length > 0 ||
                                is(i - 1, {"room", "space", "house", "flat"}) || one_of(tokens_[i - 1].text, WordSet::kSomewhere));
    if (!room) return std::nullopt;
    const std::size_t who = is(i, {"where", "that", "which", "so"}) ? i + 1 : i;
    std::optional<Frame> frame = frame_of_clause(who);
    if (frame && frame->first == who) frame->first = i;
    return frame;
  }

  // "Six people sleep, eat and watch the football", "she does make up and studies".
  std::optional<Frame> frame_of_doers(std::size_t at, std::size_t first) {
    constexpr std::size_t kSubject = 3;  // words
    Frame frame{first, 0, 0, 2};
    for (std::size_t who = at; who < at + kSubject && !ends(who); ++who) {
      if (const NumberRead number = read_number(lexicon_, tokens_, who); number.length > 0) frame.people = static_cast<int>(number.value);
      if (!is_doer(who)) continue;
      frame.verb = past_adverbs(who + 1);
      return !ends(frame.verb) && use_of_verb(frame.verb, 0) ? std::optional(frame) : std::nullopt;
    }
    return std::nullopt;
  }

  bool is_doer(std::size_t at) const {
    return is(at,
              {"i", "we", "us", "they", "you", "he", "she", "people", "person", "everyone", "everybody", "someone", "somebody", "who"}) ||
           lexicon_.is_person(tokens_[at].text) || lexicon_.is_person(singular(at));
  }

  // "Two people should be able to …", "I want to …", "she likes to …".
  std::optional<Frame> frame_of_clause(std::size_t first) const {
    constexpr std::size_t kSubject = 9;  // words
    Frame frame{first, 0, 0, 1};
    std::size_t at = first;
    bool person = false;
    for (; at < first + kSubject && !ends(at); ++at) {
      if (wants_at(at) != 0) break;
      if (is(at, {"not", "n't", "never", "no", "nobody", "without", "hardly", "don't", "can't"})) return std::nullopt;
      const std::size_t room =
          std::max<std::size_t>(lexicon_.find(tokens_, at, WordClass::kRoom).length, one_of(tokens_[at].text, WordSet::kSomewhere) ? 1 : 0);
      if (room > 0 || is(at, {"where"})) frame.first = at + room;  // "need a living room where they can climb"
      if (room == 0 && lexicon_.find(tokens_, at, WordClass::kObject).length > 0) return std::nullopt;  // "a table where we can eat"
      if (const NumberRead number = read_number(lexicon_, tokens_, at); number.length > 0) frame.people = static_cast<int>(number.value);
      if (is(at, {"both"})) frame.people = 2;
      person |= is_doer(at) || is(at, {"both"});
    }
    const std::size_t wanting = wants_at(at);
    if (wanting == 0 || (!person && !is(at + 1, {"be"}))) return std::nullopt;  // "Residents should be able to …"
    frame.verb = past_adverbs(at + wanting);
    if (is(frame.verb, {"not", "n't", "never", "no"})) return std::nullopt;
    return ends(frame.verb) ? std::nullopt : std::optional(frame);
  }

  std::string singular(std::size_t at) const {
    const std::string& word = tokens_[at].text;
    return word.ends_with("s") ? word.substr(0, word.size() - 1) : word;
  }

  // The tokens of "should be able to", "want to", "can" there; 0: nobody wants or may anything.
  std::size_t wants_at(std::size_t at) const {
    std::size_t next = at;
    if (is(next, {"would", "'d", "do", "also", "still", "just"})) ++next;
    if (is(next, {"also", "still", "just", "really"})) ++next;
    if (is(next, {"need", "needs", "want", "wants", "like", "likes", "love", "loves", "have", "has", "hope", "wish"}) &&
        is(next + 1, {"to"}))
      return next + 2 - at + able_at(next + 2);
    if (!is(at, {"should", "must", "can", "could", "may", "might", "will", "would"})) return 0;
    next = at + 1;
    if (is(next, {"all", "both", "also", "each", "still"})) ++next;
    return next - at + able_at(next);
  }

  // "be able to"
  std::size_t able_at(std::size_t at) const {
    const std::size_t be = is(at, {"be"}) ? 1 : 0;
    return is(at + be, {"able"}) && is(at + be + 1, {"to"}) ? be + 2 : 0;
  }

  std::size_t past_adverbs(std::size_t at) const {
    constexpr std::size_t kMost = 3;
    for (std::size_t taken = 0; taken < kMost; ++taken) {
      if (!is(at, {"also", "both", "all", "still", "just", "easily", "comfortably", "properly", "to", "then", "even", "sometimes", "now"}))
        break;
      ++at;
    }
    return at;
  }

  bool parts(std::size_t at) const {
    return is(at, {",", ";", "and", "or", "then", "while", "plus", "whilst"}) || (at < tokens_.size() && tokens_[at].text == "-");
  }

  // What the rows say of the doing that begins at `at`, its verb with or without an ending.
  std::optional<Use> use_of_verb(std::size_t at, int people) {
    const std::string written = tokens_[at].text;
    std::optional<Use> best;
    for (const std::string& base : bases_of(written)) {
      tokens_[at].text = base;
      const std::optional<Use> use = to_do(at, people);
      if (use && (!best || use->end > best->end)) best = use;
    }
    tokens_[at].text = written;
    return best;
  }

  Doing doing_at(std::size_t first, int people) {
    Doing doing{first, first, {}, first, first};
    while (doing.end < tokens_.size() && !parts(doing.end) && !is(doing.end, {".", ":", "!", "?", ")", "but"})) {
      ++doing.end;
      if (tokens_[doing.end - 1].ends_sentence) break;
    }
    constexpr std::size_t kBefore = 5;  // words: "the little one sits"
    for (std::size_t at = first; at < std::min(doing.end, first + kBefore) && !doing.use; ++at) {
      if (tokens_[at].kind != Token::Kind::kWord || is_article(at)) continue;
      const bool named = lexicon_.find(tokens_, at, WordClass::kObject).length > 1 || (at > first && is_article(at - 1));
      if (named) continue;  // "the dining table"
      doing.use = use_of_verb(at, people);
      doing.use_first = at;
    }
    if (doing.use) doing.end = std::max(doing.end, doing.use->end);
    doing.thing = furniture_in(doing.use ? doing.use->end : first, doing.end);
    return doing;
  }

  // Where furniture is named with its article or number: "sit at a desk"; `end`: nowhere.
  std::size_t furniture_in(std::size_t first, std::size_t end) const {
    for (std::size_t at = first; at < end; ++at) {
      const bool led = lexicon_.is(tokens_[at], WordClass::kIndefinite) || lexicon_.is(tokens_[at], WordClass::kNumber) ||
                       tokens_[at].kind == Token::Kind::kNumber;
      if (led && names_furniture(at)) return at;
    }
    return end;
  }

  // "I write novels and drink tea; a desk, a lamp": what people do is told by the way then.
  bool names_any_furniture() const {
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
      const Meaning* thing = meaning_of(lexicon_.find(tokens_, at, WordClass::kObject), WordClass::kObject);
      if (thing != nullptr && thing->entry != nullptr && thing->entry->mount == Mount::kFloor && !thing->entry->is(Trait::kPet))
        return true;
    }
    return false;
  }

  bool names_furniture(std::size_t at) const {
    const std::optional<NamedThing> thing = thing_named_at(at);
    return thing && thing->entry != nullptr && thing->entry->mount != Mount::kSurface && !thing->entry->is(Trait::kPet);
  }

  // The list goes on with what is there, or with what is put somewhere.
  bool stops_at(const Doing& doing) const {
    const bool names = is_article(doing.first) && thing_named_at(doing.first).has_value();
    if (doing.use) return names && doing.use_first > doing.first;
    constexpr std::size_t kLooks = 2;  // words: "big round table"
    for (std::size_t at = doing.first; at < std::min(doing.first + kLooks + 1, doing.end); ++at) {
      const Meaning* thing = meaning_of(lexicon_.find(tokens_, at, WordClass::kObject), WordClass::kObject);
      if (thing != nullptr && thing->entry != nullptr && thing->entry->mount != Mount::kSurface) return true;
    }
    if (names || is(doing.first, {"with", "there", "in", "on", "by", "next", "a", "the", "no", "be"})) return true;
    const bool puts =
        is(doing.first, {"put", "place", "have", "keep", "leave", "add", "include", "move", "get", "fit", "set", "hang", "stand"});
    return puts && thing_named_at(doing.first + 1).has_value();
  }

  // Takes what is done, one after the other; where that ends, or 0 where nothing is known of it.
  std::size_t read_list(const Frame& frame) {
    std::vector<Doing> doings;
    std::size_t at = frame.verb, known = 0;
    constexpr std::size_t kMost = 12;
    while (at < tokens_.size() && doings.size() < kMost) {
      const Doing doing = doing_at(past_adverbs(at), frame.people);
      if (doing.end <= doing.first || stops_at(doing)) break;
      known += doing.use ? 1 : 0;
      doings.push_back(doing);
      at = doing.end;
      if (tokens_[at - 1].ends_sentence || !parts(at)) break;
      while (at < tokens_.size() && parts(at) && !tokens_[at].ends_sentence) ++at;
    }
    const bool sure = !doings.empty() && doings.front().use;
    if (known < std::max<std::size_t>(frame.least, sure ? 1 : 2)) return 0;
    if (document_.wanted_room.empty()) document_.wanted_room = here();
    for (const Doing& doing : doings) {
      take(doing);
      if (frame.people > 1 && doing.thing < doing.end) seat(doing.thing, frame.people);
    }
    leave_out_words(frame, doings);
    if (document_.people == 0 && frame.people > 1) document_.people = frame.people;
    return doings.back().end;
  }

  // "let four people play at a table": a table for four.
  void seat(std::size_t at, int people) {
    const std::optional<NamedThing> thing = thing_named_at(at);
    if (!thing || thing->entry == nullptr || !thing->entry->is(Trait::kTable) || thing->entry->is(Trait::kDesk) || is(thing->last, {"for"}))
      return;
    words_.push_back({thing->last, word_token("for")});
    words_.push_back({thing->last, number_token(people)});
  }

  void take(const Doing& doing) {
    if (!doing.use || is_served(*doing.use, doing.use_first)) return;
    const CatalogEntry* entry = entry_of(thing_of(*doing.use, here()));
    if (entry == nullptr || (doing.thing < doing.end && carries_people(*entry))) return;  // "sit at a desk"
    const int people = doing.use->row.contains("each") ? std::max(doing.use->people, 1) : 1;
    const auto known = std::ranges::find(document_.wanted, entry, &Wanted::entry);
    if (known == document_.wanted.end()) document_.wanted.push_back({entry, people});
  }

  // The kind of room that the text names, or that what is done in it says.
  std::string_view here() const {
    std::string_view kind = room();
    for (std::size_t i = 0; kind.empty() && i < tokens_.size(); ++i) {
      const auto [suggested, length] = lexicon_.room_suggested(tokens_, i);
      const bool person = length == 1 && (lexicon_.is_person(singular(i)) || word_form(tokens_[i].text) == WordForm::kPerson);
      if (length > 0 && !person) kind = suggested;  // what one does says more than who
    }
    return kind;
  }

  // One sits, lies or works at it.
  bool carries_people(const CatalogEntry& entry) const {
    return entry.is(Trait::kTable) || entry.is(Trait::kBed) || entry.is(Trait::kSeat) || entry.is(Trait::kEasySeat);
  }

  const CatalogEntry* entry_of(std::string_view words) const {
    std::vector<Token> tokens;
    while (!words.empty()) {
      const std::string_view word = words.substr(0, words.find(' '));
      words.remove_prefix(std::min(words.size(), word.size() + 1));
      tokens.emplace_back().text = word;
      tokens.back().kind = Token::Kind::kWord;
    }
    const Meaning* meaning = meaning_of(lexicon_.find(tokens, 0, WordClass::kObject), WordClass::kObject);
    return meaning == nullptr ? nullptr : meaning->entry;
  }

  // All but the furniture that the doings name.
  void leave_out_words(const Frame& frame, const std::vector<Doing>& doings) {
    std::size_t from = frame.first;
    bool kept = false;
    for (const Doing& doing : doings) {
      if (doing.thing >= doing.end) continue;
      // A comma parts it from what was kept before.
      std::size_t comma = doing.first;
      while (comma > from && !(tokens_[comma - 1].text == ",")) --comma;
      if (kept && comma > from) {
        leave_out(from, comma - 1);
        from = comma;
      }
      leave_out(from, doing.thing);
      const bool joined =
          !kept && from > 0 && !begins(from) && tokens_[from - 1].kind != Token::Kind::kPunctuation && !is(from - 1, {"and"});
      if (joined && doing.thing > from) {  // "a living room where I can watch tv on a sofa"
        Token& comma_before = tokens_[doing.thing - 1];
        comma_before.text = ",";
        comma_before.kind = Token::Kind::kPunctuation;
        skip_[doing.thing - 1] = false;
      }
      from = doing.end;
      kept = true;
    }
    leave_out(from, doings.back().end);
  }

  Document& document_;
  std::vector<Splice> words_;
};

}  // namespace

void read_wants(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { WantReader(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
