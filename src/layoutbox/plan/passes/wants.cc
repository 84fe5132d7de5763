#include "layoutbox/plan/passes/wants.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/plan/passes/want_frames.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

class WantReader : public WantFrames {
 public:
  WantReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : WantFrames(lexicon, document.tokens, skip), document_(document) {}

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
  // One thing that is done: "wash up", "sit at a desk".
  struct Doing {
    std::size_t first = 0, end = 0;
    std::optional<Use> use;
    std::size_t use_first = 0;
    std::size_t thing = 0;  // where furniture is named from which on all is kept; `end`: none is
  };

  bool parts(std::size_t at) const {
    return is(at, {",", ";", "and", "or", "then", "while", "plus", "whilst"}) || (at < tokens_.size() && tokens_[at].text == "-");
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
