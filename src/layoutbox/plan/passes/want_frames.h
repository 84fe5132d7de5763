// Where a text says what somebody wants to do: "we need to", "X should be able to", "where I can", "for sleeping, drawing".
#pragma once

#include <optional>
#include <string>

#include "layoutbox/plan/passes/use_rows.h"

namespace layoutbox::offline {

class WantFrames : public UseRows {
 public:
  using UseRows::UseRows;

 protected:
  // Who wants it, from its first word on, and where the first verb stands.
  struct Frame {
    std::size_t first = 0, verb = 0;
    int people = 0;
    std::size_t least = 1;  // things that are done, of which something is known
  };

  // The frame that opens at token `i`.
  std::optional<Frame> frame_at(std::size_t i);
  // What the rows say of the doing that begins at `at`, its verb with or without an ending.
  std::optional<Use> use_of_verb(std::size_t at, int people);
  std::size_t past_adverbs(std::size_t at) const;
  std::string singular(std::size_t at) const;

 private:
  // "Six people sleep, eat and watch the football", "she does make up and studies".
  std::optional<Frame> frame_of_doers(std::size_t at, std::size_t first);
  bool is_doer(std::size_t at) const;
  // "Two people should be able to …", "I want to …", "she likes to …".
  std::optional<Frame> frame_of_clause(std::size_t first) const;
  // The tokens of "should be able to", "want to", "can" there; 0: nobody wants or may anything.
  std::size_t wants_at(std::size_t at) const;
  // "be able to"
  std::size_t able_at(std::size_t at) const;
  // "I write novels and drink tea; a desk, a lamp": what people do is told by the way then.
  bool names_any_furniture() const;
};

}  // namespace layoutbox::offline
