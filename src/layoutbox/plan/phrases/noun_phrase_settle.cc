// What a noun phrase names, once its head is known: a thing, a member of a group, a part of the room, or nothing of its own.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

// "the left one", "a smaller one"
NounPhrase NounPhraseReader::settle_member() {
  for (const PhrasePart& part : parts_) {
    if (part.word_class != WordClass::kFiller) continue;
    phrase_.attributes.push_back(text_of(tokens_, part.first, part.last));
    phrase_.attribute_classes.push_back(WordClass::kQuality);
  }
  take_attributes(parts_.size());
  phrase_.last = i_;
  return phrase_;
}

bool joins_walls(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  if (at + 1 >= tokens.size() || !lexicon.is(tokens[at], WordClass::kAnd)) return false;
  const Match other = lexicon.find(tokens, at + 1, WordClass::kWallWord);
  const std::size_t wall = at + 1 + other.length;
  return other.length > 0 && wall < tokens.size() && tokens[wall].text == "walls";
}

// "along the north and east walls": the first of them.
bool NounPhraseReader::read_first_wall() {
  const Match one = lexicon_.find(tokens_, i_, WordClass::kWallWord);
  const std::size_t joiner = i_ + one.length;
  if (one.length == 0 || !joins_walls(lexicon_, tokens_, joiner)) return false;
  phrase_.kind = NounKind::kWall;
  phrase_.name = phrase_.head = "wall";
  phrase_.wall_word = meaning_of(one, WordClass::kWallWord)->word;
  i_ = joiner;
  return true;
}

// Nothing but attributes: "each", "the other", "both", "the larger", a count alone.
std::optional<NounPhrase> NounPhraseReader::settle_without_head() {
  // "its twin": another one.
  if (phrase_.determiner == Determiner::kPossessive && i_ > phrase_.first + 1 && tokens_[i_ - 1].text == "twin") {
    phrase_.kind = NounKind::kMember;
    phrase_.determiner = Determiner::kAnother;
    phrase_.head = "twin";
    phrase_.count = 0;
    phrase_.attributes.clear();
    phrase_.attribute_classes.clear();
    return finish();
  }
  const bool member = phrase_.determiner == Determiner::kEach || phrase_.determiner == Determiner::kBoth ||
                      phrase_.determiner == Determiner::kOther || phrase_.determiner == Determiner::kAnother || counted_ ||
                      phrase_.ordinal != 0;
  if (!member || (bare_ && !counted_ && phrase_.determiner == Determiner::kNone)) return std::nullopt;
  if (!parts_.empty()) i_ = parts_.front().first;
  phrase_.kind = NounKind::kMember;
  return finish();
}

// "in Naples", "from Brazil", "on Mill Lane": a name in the middle of a sentence, after what is said of places.
bool NounPhraseReader::is_place_name(const PhrasePart& part) const {
  static constexpr std::string_view kBefore[] = {"in", "from", "near", "at", "to", "of", "like", "outside", "across"};
  static constexpr std::string_view kBeforeSeveral[] = {"on", "by", "off", "around", "for", "with", "de", "is", "was"};
  if (phrase_.first == 0 || tokens_[phrase_.first - 1].capital) return false;
  const auto words = std::span(tokens_).subspan(phrase_.first, part.last - phrase_.first);
  const bool small = std::ranges::any_of(tokens_, [](const Token& t) { return t.kind == Token::Kind::kWord && !t.capital; });
  if (!small || !std::ranges::all_of(words, &Token::capital)) return false;
  const std::string& before = tokens_[phrase_.first - 1].text;
  const auto is_before = [&](const auto& list) { return std::find(std::begin(list), std::end(list), before) != std::end(list); };
  return is_before(kBefore) || (words.size() > 1 && is_before(kBeforeSeveral));
}

// "from Turkey", "from China": a country, though a thing is called so as well.
bool NounPhraseReader::comes_from(const PhrasePart& part) const {
  const bool named = phrase_.determiner != Determiner::kNone || counted_;
  const std::size_t first = phrase_.first;
  if (first > 1 && (tokens_[first - 2].text == "far" || tokens_[first - 2].text == "away")) return false;  // "far from TV"
  return !named && phrase_.first == part.first && phrase_.first > 0 && tokens_[phrase_.first - 1].text == "from" && is_place_name(part);
}

// "with north light", "soft light": what comes in; "a red light", "two lights" and "desk light" are lamps.
bool NounPhraseReader::is_daylight(const PhrasePart& part, std::size_t head) const {
  const bool alone = part.last == part.first + 1 && tokens_[part.first].text == "light";
  if (!alone || head == 0 || counted_ || phrase_.determiner != Determiner::kNone) return false;
  return std::all_of(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(head), [&](const PhrasePart& p) {
    return p.word_class == WordClass::kQuality || p.word_class == WordClass::kWallWord ||
           (p.word_class == WordClass::kFiller && word_form(tokens_[p.last - 1].text) == WordForm::kAdjective);
  });
}

// "a scriptorium with four desks", "bakehouse: …": what the text is about, and no list has, where English calls it a room or a house.
bool NounPhraseReader::settle_unlisted_room(const PhrasePart& part) {
  const bool anew = phrase_.determiner == Determiner::kIndefinite || phrase_.determiner == Determiner::kNone;
  const bool lab = std::ranges::any_of(parts_, [](const PhrasePart& p) { return p.word_class == WordClass::kRoom; });  // "a lab module"
  if (counted_ || part.plural || !anew || lab || !is_topic()) return false;
  std::string_view kinds = english_line(singular_of(tokens_[part.last - 1].text));
  const RoomKind* known = nullptr;
  bool room = false;
  while (!kinds.empty()) {
    const std::string_view kind = kinds.substr(0, kinds.find(' '));
    room = room || one_of(kind, WordSet::kRoomsInEnglish);
    if (known == nullptr && kind != "room") known = lexicon_.catalog().find_room(kind);
    kinds.remove_prefix(std::min(kind.size() + 1, kinds.size()));
  }
  if (!room) return false;
  phrase_.kind = NounKind::kRoom;
  phrase_.entry = nullptr;
  phrase_.category.clear();
  phrase_.room = known;
  return true;
}

// Nothing was named before, and what follows says what is in it or what it is for.
bool NounPhraseReader::is_topic() const {
  for (std::size_t i = 0; i < phrase_.first; ++i) {
    const Match match = lexicon_.find(tokens_, i);
    if (has(match, WordClass::kObject) || has(match, WordClass::kRoom) || has(match, WordClass::kRoomNoun) ||
        lexicon_.find_phrase(tokens_, i).length > 0)
      return false;
  }
  return !more() || token().kind == Token::Kind::kPunctuation || lexicon_.is(token(), WordClass::kHave) ||
         one_of(token().text, {"for", "where", "that", "in"});
}

// A head that no list has; false where it is no noun phrase at all.
bool NounPhraseReader::settle_filler(std::size_t head) {
  const PhrasePart part = parts_[head];
  const std::string& word = tokens_[part.last - 1].text;
  const WordForm form = word_form(word), noun = noun_form(word);
  const bool named = phrase_.determiner != Determiner::kNone || counted_;
  take_attributes(head);
  const bool ends = !more() || token().kind == Token::Kind::kPunctuation || lexicon_.is(token(), WordClass::kAnd) ||
                    lexicon_.find_phrase(tokens_, i_).length > 0;
  const bool listed = !named && part.plural && ends &&  // "hooks on the wall", "with ribbon rolls and …"
                      (head == 0 ? noun == WordForm::kThing : is_compound(head) && (is_noun(noun) && noun != WordForm::kNoun));
  const bool thing = form == WordForm::kThing ||
                     (form == WordForm::kUnknown && (named || part.plural || is_bodily_described() || is_unknown_subject(part))) ||
                     (hyphenated(part.first) && !is_noun(form)) || (form == WordForm::kBody && part.plural && head == 0) ||
                     (named && (is_thing_where_named(part) || is_rare_thing(part, head) || (is_modeled(head) && is_compound(head)))) ||
                     listed || shaped_ || has_telling_head(part, head);
  const bool made = form != WordForm::kAdverb && form != WordForm::kAdjective && named && has_attribute(WordClass::kMaterial);
  // "Calibration rig. A steel table …": a title
  const bool opens = !named && !part.plural && is_topic() && more() && (token().text == "." || token().text == ":");
  const bool place = !named && (is_place_name(part) || (opens && i_ + 1 < tokens_.size()));
  if (!thing && !named && !is_noun(form)) return false;
  settle_object(part, head);
  if (place) {
    phrase_.kind = NounKind::kAbstract;
  } else if (settle_unlisted_room(part)) {
    return true;
  } else if (!thing && (!made || form == WordForm::kPerson)) {
    phrase_.kind = NounKind::kAbstract;
    phrase_.doubted = true;
  }
  return true;
}

// "five freshly rinsed prints": parts elsewhere.
bool NounPhraseReader::counts_things(const PhrasePart& part) const {
  return counted_ && !phrase_.vague && phrase_.count > 1 && part.last == part.first + 1 &&
         noun_form(tokens_[part.first].text) == WordForm::kThing;
}

// "a kitchen … a pantry stands next to the window": a cabinet, where another room was named before. Null: a room.
const CatalogEntry* NounPhraseReader::cupboard_of(const PhrasePart& part) const {
  if (part.last != part.first + 1 || !one_of(singular_of(tokens_[part.first].text), {"pantry", "larder"})) return nullptr;
  if (phrase_.determiner == Determiner::kNone) return nullptr;
  bool room = false;
  for (std::size_t i = 0; i < phrase_.first && !room; ++i)
    room = has(lexicon_.find(tokens_, i), WordClass::kRoom) && singular_of(tokens_[i].text) != singular_of(tokens_[part.first].text);
  return room ? lexicon_.catalog().find("pantry_cabinet") : nullptr;
}

// "two fitting rooms at the back" of a shop: stalls in the room, where the catalogue has such a booth. Null: a room.
const CatalogEntry* NounPhraseReader::stall_of(const PhrasePart& part) const {
  constexpr std::size_t kOpening = 3;  // "a fitting room with …" is what the text is about
  if (part.word_class != WordClass::kRoom || part.first < kOpening) return nullptr;
  const std::string words = text_of(tokens_, part.first, part.last - 1) + (part.last - part.first > 1 ? " " : "") +
                            singular_of(tokens_[part.last - 1].text) + " booth";
  const CatalogEntry* entry = lexicon_.catalog().find_by_words(words);
  const bool called = entry != nullptr && std::ranges::find(entry->synonyms, words) != entry->synonyms.end();
  return called ? entry : cupboard_of(part);
}

// "a palette", "a feng shui piece": what the lists call no thing may be one among things (UnitReader::is_thing_in_company).
bool NounPhraseReader::may_be_thing(const PhrasePart& part, std::size_t head) const {
  const bool alone = part.last == part.first + 1 && head == 0 && noun_form(tokens_[part.first].text) == WordForm::kThing;
  return (alone && !is_collective(singular_of(tokens_[part.first].text))) || follows_unknown_word(head);
}

// "a mizuhiki arrangement", "a feng shui piece": what word like that nobody knows may well be a thing.
bool NounPhraseReader::follows_unknown_word(std::size_t head) const {
  const PhrasePart& before = parts_[head > 0 ? head - 1 : 0];
  return head > 0 && before.word_class == WordClass::kFiller && word_form(tokens_[before.last - 1].text) == WordForm::kUnknown;
}

// A head that stands in the lists of places, rooms and parts.
void NounPhraseReader::settle_listed(std::size_t head) {
  const PhrasePart part = parts_[head];
  const PhrasePart as_thing{part.first, part.last, WordClass::kFiller, {WordClass::kFiller, nullptr, nullptr, 0, {}}, part.plural};
  const bool thing = is_thing_by_name(head);
  take_attributes(head);
  if (thing) return settle_object(as_thing, head);
  if (const CatalogEntry* stall = stall_of(part); stall != nullptr) {
    const PhrasePart booth{part.first, part.last, WordClass::kObject, {WordClass::kObject, stall, nullptr, 0, stall->id}, part.plural};
    return settle_object(booth, head);
  }
  const bool new_here = counted_ || part.plural || phrase_.determiner == Determiner::kIndefinite;
  const bool quality = meaning_of(lexicon_.find(tokens_.first(part.last), part.first), WordClass::kAbstract) != nullptr;  // "light colors"
  const bool leg = one_of(singular_of(tokens_[part.last - 1].text), {"leg", "foot"});  // "hairpin legs" are what a thing stands on
  if (part.word_class == WordClass::kPart && new_here && !quality &&
      (part.meaning.entry != nullptr || (is_compound(head) && !leg) || counts_things(part))) {
    const NounPhrase opened = phrase_;
    settle_object(part.meaning.entry != nullptr ? part : as_thing, head);
    auto object = std::make_shared<NounPhrase>(phrase_);
    object->last = i_;
    phrase_ = opened;
    phrase_.as_object = std::move(object);
  }
  settle_place(part);
  if (phrase_.kind == NounKind::kAbstract && new_here && may_be_thing(part, head)) {
    const bool doubted = follows_unknown_word(head);
    settle_object(as_thing, head);
    phrase_.kind = NounKind::kAbstract;
    phrase_.doubted = doubted;
    return;
  }
  // "bath essentials", "decorative items": things, where something holds them.
  if (phrase_.kind == NounKind::kAbstract && is_collective(phrase_.head)) {
    settle_object(as_thing, head);
    phrase_.kind = NounKind::kAbstract;
    phrase_.collective = true;
  }
}

// "nothing", "everything": no compound begins so.
bool NounPhraseReader::is_nothing(const PhrasePart& part) const {
  const std::string& word = tokens_[part.first].text;
  return part.last == part.first + 1 && (word == "nothing" || word == "everything" || word == "anything" || word == "something");
}

std::optional<NounPhrase> NounPhraseReader::settle() {
  if (done_) return settle_member();
  if (is_described_member()) {  // "four beds, one overturned"
    phrase_.kind = NounKind::kMember;
    return settle_member();
  }
  end_before_doing();
  std::size_t head = 0;
  find_head(head);
  mean_thing_before_verb(head);
  if (head == 0) return settle_without_head();
  if (is_nothing(parts_.front())) head = 1;  // "nothing blocks the window"
  if (ends_in_verb(head) || ends_in_plural_verb(head) || ends_in_doing(head) || ends_in_can(head)) --head;
  join_set(head);
  const std::size_t end = std::max(drop_thing(head), drop_own_wall(head));
  const PhrasePart part = parts_[head - 1];
  i_ = std::max(end, part.last);
  if (part.word_class == WordClass::kFiller) {
    if (!settle_filler(head - 1)) return std::nullopt;
  } else if (part.word_class == WordClass::kObject) {
    take_attributes(head - 1);
    settle_object(part, head - 1);
    if (comes_from(part) || is_daylight(part, head - 1)) phrase_.kind = NounKind::kAbstract;
  } else {
    settle_listed(head - 1);
  }
  if (phrase_.kind == NounKind::kWall && phrase_.wall_word.empty() && more()) {  // "wall east"
    const Match which = lexicon_.find(tokens_, i_, WordClass::kWallWord);
    const std::size_t after = i_ + which.length;
    if (which.length > 0 && (after >= tokens_.size() || tokens_[after].kind == Token::Kind::kPunctuation)) {
      phrase_.wall_word = meaning_of(which, WordClass::kWallWord)->word;
      i_ = after;
    }
  }
  if (count_follows()) {
    if (phrase_.count == 0) phrase_.count = static_cast<int>(std::clamp(tokens_[i_ + 1].number, 0.0, 1000.0));
    i_ += 2;
  }
  read_of();
  if (more() && token().text == "'s") phrase_.owner = true;
  return finish();
}

std::optional<NounPhrase> read_noun_phrase(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, bool bare) {
  if (at >= tokens.size() || tokens[at].kind == Token::Kind::kPunctuation) return std::nullopt;
  return NounPhraseReader(lexicon, tokens, at, bare).read();
}

}  // namespace layoutbox::offline
