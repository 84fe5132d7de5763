// The class behind read_noun_phrase; its members stand in noun_phrase (what it is called), noun_phrase_open (how it opens),
// noun_phrase_count (how many), noun_phrase_members (which of several), noun_phrase_words (where it ends), noun_phrase_read (its words)
// and noun_phrase_head (what its head is).
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/plan/phrases/noun_phrase.h"

namespace layoutbox::offline {

inline bool has(const Match& match, WordClass word_class) {
  return std::any_of(match.meanings.begin(), match.meanings.end(), [&](const Meaning& m) { return m.word_class == word_class; });
}

inline const Meaning* meaning_of(const Match& match, WordClass word_class) {
  for (const Meaning& meaning : match.meanings) {
    if (meaning.word_class == word_class) return &meaning;
  }
  return nullptr;
}

inline bool is_attribute_class(WordClass c) {
  return c == WordClass::kSizeWord || c == WordClass::kColor || c == WordClass::kMaterial || c == WordClass::kShape ||
         c == WordClass::kStyle || c == WordClass::kQuality;
}

inline const Meaning* attribute_of(const Match& match) {
  for (const Meaning& meaning : match.meanings) {
    if (is_attribute_class(meaning.word_class)) return &meaning;
  }
  return nullptr;
}

std::string text_of(std::span<const Token> tokens, std::size_t first, std::size_t last);

// One word or compound before or at the head.
struct PhrasePart {
  std::size_t first = 0, last = 0;
  WordClass word_class = WordClass::kFiller;  // kObject, an attribute, a place; kFiller: not in the lexicon
  Meaning meaning{WordClass::kFiller, nullptr, nullptr, 0, {}};
  bool plural = false;
};

class NounPhraseReader {
 public:
  NounPhraseReader(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, bool bare)
      : lexicon_(lexicon), tokens_(tokens), i_(at), bare_(bare) {
    phrase_.first = at;
  }

  std::optional<NounPhrase> read() {
    if (!read_determiners()) return std::nullopt;
    if (done_ || read_first_wall()) return finish();
    read_parts();
    return settle();
  }

 private:
  bool more() const { return i_ < tokens_.size(); }
  const Token& token() const { return tokens_[i_]; }
  bool at_word(std::string_view text, std::size_t ahead = 0) const {
    return i_ + ahead < tokens_.size() && tokens_[i_ + ahead].text == text;
  }
  bool hyphenated(std::size_t i) const {
    return i > 0 && i < tokens_.size() && tokens_[i].glued && tokens_[i].kind != Token::Kind::kPunctuation &&
           tokens_[i - 1].kind != Token::Kind::kPunctuation && tokens_[i].begin > tokens_[i - 1].end;
  }

  bool read_first_wall();

  std::optional<NounPhrase> finish() {
    phrase_.last = i_;
    return phrase_;
  }

  // The, a, two, at least three, several, a pair of, both, each, no. False when nothing can follow.
  bool read_determiners();
  // What a word at the opening was; kEnds: the opening is over, kDone: so is the whole phrase.
  enum class Opening { kNothing, kGoesOn, kEnds, kDone };
  Opening read_opening();
  Opening read_bound();
  Opening read_article();
  Opening read_each();
  bool take(WordClass word_class, Determiner determiner);
  bool number_follows(std::size_t length) const;
  bool read_count();
  bool describes(std::size_t at) const;
  bool read_digits();
  void stack_if_heaped();
  bool read_number_word();
  bool is_no_count(const Match& best, bool is_number) const;
  void read_upper_end();
  bool take_size();
  bool says_seats(std::size_t at) const;
  bool read_rows();
  bool read_clusters();
  bool read_subset();
  bool read_pronoun();
  bool name_ends(std::size_t at) const;
  bool read_rest();
  bool read_share();
  void read_every_nth();
  bool read_rank();
  bool read_superlative();
  void read_parts();
  bool is_named() const { return !parts_.empty() || phrase_.determiner != Determiner::kNone || counted_; }
  bool add(WordClass word_class, const Meaning& meaning, std::size_t length, bool plural);
  bool names_on(const Match& match) const;
  bool is_namesake(std::size_t head) const;
  bool names_after_one(const Match& match) const;
  bool ends_what_is_had() const;
  bool read_part();
  bool count_follows() const;
  bool verb_follows() const;
  bool counts_plural(const Match& match) const;
  bool is_verb_in_name(const Match& match) const;
  bool read_compound_adjective(const Match& match);
  bool plural_at(std::size_t i) const;
  bool opens_at(std::size_t i) const;
  Match without_verb(const Match& match) const;
  bool stands_on_table(const Match& match) const;
  Match without_attribute(const Match& match) const;
  bool ends_before(const Match& match) const;
  bool read_listed(const Match& match, bool noun_before);
  bool opens_text(std::size_t after) const;
  std::optional<bool> read_thing(const Match& match, bool noun_before, bool verbal);
  const Meaning* things_of_stuff(const Match& match) const;
  bool counts_unlisted() const;
  std::optional<bool> read_place(const Match& match, bool noun_before, bool verbal);
  bool counts_thing(std::size_t at) const;
  bool read_other(const Match& match, bool noun_before);
  bool read_unlisted();
  bool doubles_noun(std::size_t at) const;
  bool read_ordinal();
  bool goes_on_after_break() const;
  bool noun_after(std::size_t at) const;
  bool names_set() const;
  bool word_may_belong() const;
  bool is_thing(const PhrasePart& part) const;
  bool is_thing_where_named(const PhrasePart& part) const;
  bool has_attribute(WordClass word_class) const;
  bool is_unknown_subject(const PhrasePart& part) const;
  bool is_bodily_described() const;
  bool is_place_name(const PhrasePart& part) const;
  bool comes_from(const PhrasePart& part) const;
  bool is_rare_thing(const PhrasePart& part, std::size_t head) const;
  bool has_telling_head(const PhrasePart& part, std::size_t head) const;
  const CatalogEntry* stall_of(const PhrasePart& part) const;
  const CatalogEntry* cupboard_of(const PhrasePart& part) const;
  bool may_be_thing(const PhrasePart& part, std::size_t head) const;
  bool follows_unknown_word(std::size_t head) const;
  bool is_compound(std::size_t head) const;
  bool is_modeled(std::size_t head) const;
  bool is_thing_by_name(std::size_t head) const;
  void find_head(std::size_t& head);
  NounPhrase settle_member();
  std::optional<NounPhrase> settle_without_head();
  bool ends_in_verb(std::size_t head) const;
  void end_before_doing();
  void mean_thing_before_verb(std::size_t head);
  bool is_nothing(const PhrasePart& part) const;
  bool ends_in_plural_verb(std::size_t head) const;
  bool counts_things(const PhrasePart& part) const;
  bool ends_in_doing(std::size_t head) const;
  bool place_at(std::size_t at) const;
  bool lacks_verb(std::size_t at) const;
  bool is_daylight(const PhrasePart& part, std::size_t head) const;
  bool is_topic() const;
  bool settle_unlisted_room(const PhrasePart& part);
  bool settle_filler(std::size_t head);
  void settle_listed(std::size_t head);
  std::optional<NounPhrase> settle();
  void settle_object(const PhrasePart& head, std::size_t head_index);
  void settle_kind(const PhrasePart& head, std::size_t head_index);
  void join_set(std::size_t& head);
  bool is_described_member() const;
  bool ends_in_can(std::size_t head) const;
  std::size_t drop_thing(std::size_t& head);
  std::size_t drop_own_wall(std::size_t& head);
  const CatalogEntry* pair_of(const PhrasePart& head) const;
  std::string_view settle_pair(const PhrasePart& head);
  std::string_view heap_at(std::size_t at, std::size_t length) const;
  bool is_tied(std::size_t at) const;
  void settle_heap(const PhrasePart& head);
  void count_singly(const PhrasePart& head);
  void settle_vague(const PhrasePart& head);
  void settle_unknown();
  void settle_modeled();
  void settle_place(const PhrasePart& head);
  void read_of();
  void take_attributes(std::size_t until);

  const Lexicon& lexicon_;
  std::span<const Token> tokens_;
  std::size_t i_;
  bool bare_;
  bool done_ = false, counted_ = false;
  bool paired_ = false;      // "a pair of", "two pairs of"
  bool pair_named_ = false;  // it is one thing, a pair
  std::string_view heaped_;  // "a stack of", "two piles of": how they lie, in the singular
  bool shaped_ = false;      // the head is a shape: "a climbing cube"
  NounPhrase phrase_;
  std::vector<PhrasePart> parts_;
};

}  // namespace layoutbox::offline
