// The class behind chunk_tokens; its members stand in chunks, chunk_asides, chunk_deeds, chunk_entry, chunk_grammar, chunk_parting and
// chunk_sizes.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/plan/phrases/chunks.h"

namespace layoutbox::offline {

class Chunker {
 public:
  Chunker(const Lexicon& lexicon, std::span<const Token> tokens, StopFlag stop) : lexicon_(lexicon), tokens_(tokens), stop_(stop) {}

  std::vector<Chunk> run() {
    while (i_ < tokens_.size() && !is_set(stop_)) {
      if (tokens_[i_].kind == Token::Kind::kPunctuation) {
        entering_ = entering_ && !tokens_[i_].ends_sentence;
        add(tokens_[i_].ends_sentence ? ChunkKind::kStop : ChunkKind::kComma, 1);
      } else {
        read();
      }
    }
    return std::move(chunks_);
  }

 private:
  Chunk& add(ChunkKind kind, std::size_t length) {
    Chunk chunk;
    chunk.kind = kind;
    chunk.first = i_;
    i_ += length;
    chunk.last = i_;
    if (kind != ChunkKind::kIgnored && kind != ChunkKind::kSoft) telling_ = chunks_.size();
    chunks_.push_back(std::move(chunk));
    return chunks_.back();
  }

  // Of the last chunk that says something; a stop where there is none.
  ChunkKind previous() const { return telling_ < chunks_.size() ? chunks_[telling_].kind : ChunkKind::kStop; }
  std::size_t length_of(WordClass word_class) const { return lexicon_.find(tokens_, i_, word_class).length; }

  bool opens_noun(const Token& token) const;
  // A command or statement may begin here, so that a bare word is its verb and not a noun.
  bool clause_begins() const;
  void read();
  bool read_there(std::size_t without);
  PhraseMatch phrase_here() const;
  bool noun_follows() const;
  bool names_thing_at(std::size_t at) const;
  bool is_verb_before_article(const NounPhrase& noun) const;
  bool thing_next(std::size_t at) const;
  bool opens_question() const;
  bool read_whose();
  bool read_owned_side();
  bool says_enough() const;
  bool read_infinitive();
  // What a thing looks like (chunk_looks).
  std::size_t look_begins() const;
  bool read_look();
  // What somebody does (chunk_deeds).
  bool follows_doer() const;
  std::size_t doer_length() const;
  bool follows_first_place() const;
  bool is_particle_verb(std::size_t verb) const;
  bool is_about_number() const;
  bool is_all_around() const;
  bool read_wishing();
  bool is_for_whom(std::size_t at) const;
  bool owns_furniture(std::size_t verb) const;
  bool is_helping(std::size_t at) const;
  bool says_how_much(std::size_t at) const;
  bool read_helped_wish(std::size_t verb);
  bool read_finding();
  bool read_trailing_bound();
  bool is_loose_particle() const;
  bool read_such_as();
  // Who or what comes in (chunk_entry).
  std::size_t past_inside(std::size_t at) const;
  bool read_where_in();
  void add_opening(NounKind kind, std::size_t end);
  bool read_entering();
  bool read_flush();
  std::string wall_at_hand(std::string_view hand, std::size_t at) const;
  static void mean_hand(Chunk& place);
  bool read_leave_out();
  bool read_that_may();
  bool read_doing();
  bool read_manner();
  bool may_tell_how(std::size_t at) const;
  bool is_placing(std::size_t at) const;
  bool brings_in(std::size_t at) const;
  bool is_deed(std::size_t at) const;
  // Places by the way they are built (chunk_grammar).
  bool is_verb_of(std::string_view list, std::size_t at) const;
  std::size_t past_particles(std::size_t at) const;
  std::size_t length_of_looking() const;
  std::size_t length_of_view() const;
  std::size_t length_of_particle() const;
  bool read_past();
  // What stands between two things (chunk_parting).
  bool parts_from() const;
  NounPhrase mean_parted() const;
  bool read_parted();
  bool hangs_from_which() const;
  bool read_built_place();
  // A place of so many tokens that says what the listed words say; false where they are not listed.
  bool add_said_as(std::string_view words, std::size_t length);
  std::optional<Measure> read_stride(std::size_t at) const;
  bool read_steps();
  bool read_having_by();
  bool read_noun(bool bare);
  bool read_inverted_verb();
  void add_phrase(const PhraseMatch& phrase);
  // Verbs, joining words and relation phrases; the longest wins, and of equals the first of this order.
  bool read_words(const PhraseMatch& phrase, std::size_t without);
  struct Choice {
    ChunkKind kind;
    std::size_t length;
  };
  bool is_picture() const;
  std::size_t set_after_noun() const;
  bool is_shape_said_after() const;
  std::size_t bears_thing() const;
  Choice longest(const PhraseMatch& phrase, std::size_t without) const;
  bool is_longer_noun(const Choice& best) const;
  bool is_thing_held(const Choice& best) const;
  bool is_known_thing(const Choice& best) const;
  bool is_longer_thing(const Choice& best, const NounPhrase& noun) const;
  // "is", "are placed", "is also gently mounted": the verb with its participle; 0 if there is none.
  std::size_t be_length() const;
  // "50 cm from the wall", "1 m to the left of", "at least 2 m away from".
  bool read_hung_at();
  NounPhrase* may_hang();
  bool read_distance();
  bool takes_no_distance(std::size_t at, const Measure& measure, const PhraseMatch& phrase) const;
  bool read_kept_free(std::size_t at, double metres);
  // Where the length of a gap begins; `led`: after "with", "leaving"; `said`: as "a gap of".
  struct Gap {
    std::size_t at;
    bool led;
    bool said;
  };
  Gap gap_here() const;
  bool says_gap(std::size_t at) const;
  std::size_t gap_ends(std::size_t at) const;
  bool is_one_unit(std::size_t at) const;
  std::optional<Measure> read_unit(std::size_t at) const;
  // "in three rows", "in rows of four", "in two rows of six".
  bool read_rows();
  // A size by itself: "120 cm wide", "2 m by 1 m", "(1.6 x 2.0 m)".
  double bare_unit(const std::vector<double>& values) const;
  bool read_size_chunk();
  bool read_lettered_size();
  bool follows_of() const;
  bool read_bare_length();
  bool read_length_from() { return !follows_of() && read_distance(); }
  bool is_thing_as_verb(const Match& match) const;
  void read_small_word();
  const Lexicon& lexicon_;
  std::span<const Token> tokens_;
  StopFlag stop_;
  std::size_t i_ = 0;
  std::size_t telling_ = static_cast<std::size_t>(-1);
  bool entering_ = false;  // "as you enter" was said in this sentence
  std::vector<Chunk> chunks_;
};

}  // namespace layoutbox::offline
