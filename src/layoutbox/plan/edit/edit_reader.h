// Reads commands into steps.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/plan/edit.h"
#include "layoutbox/plan/edit/changes.h"
#include "layoutbox/plan/edit/commands.h"
#include "layoutbox/plan/edit/world.h"

namespace layoutbox::edit {

class EditReader {
 public:
  EditReader(const offline::Lexicon& lexicon, const Layout& layout, std::string_view text)
      : lexicon_(lexicon), world_(lexicon, layout), text_(text) {}
  Result<EditPlan> read();

 private:
  // One command as chunks, with a cursor.
  struct Clause {
    Verb verb = Verb::kNone;
    std::string word, why;
    bool along_wall = false;
    offline::Document document;
    std::vector<PickedAt> picks;
    std::size_t k = 0;                          // the chunk that comes next
    std::vector<int> earlier;                   // what was spoken of before it
    std::vector<int> targets;                   // what it acts on
    std::size_t reserved = 0;                   // so many relation phrases at its end say where things go
    std::size_t subject = 0;                    // the chunk that named the targets last
    const offline::NounPhrase* kind = nullptr;  // what "one" is one of, where it is only coming in
  };
  // What a noun phrase speaks of: things, or a part of the room.
  struct Found {
    std::vector<int> things;
    offline::NounPhrase noun;
    bool each = false;
  };

  Status read_command(const Command& said);
  Status read_add(Clause& clause);
  Status read_place(Clause& clause);
  Status read_remove(Clause& clause);
  Status read_move(Clause& clause, const std::optional<ShiftAt>& shift);
  Status read_swap(Clause& clause);
  Status read_replace(Clause& clause, bool new_first);
  Status read_turn(Clause& clause, std::optional<double> degrees);
  Status read_predicates(Clause& clause, const std::vector<int>& things, const std::vector<std::string>& surfaces, bool& any);
  Status read_make(Clause& clause, const std::optional<EditResize>& resize, std::optional<double> degrees,
                   const std::optional<ShiftAt>& shift);
  static bool is_surface(Verb verb, const offline::NounPhrase& noun);
  Result<std::string> surface_of(const Clause& clause, const offline::NounPhrase& noun) const;
  Status read_rename(Clause& clause);
  // Commands about the room itself, its doors and windows; empty where the clause is about furniture.
  std::optional<Status> read_room_command(Clause& clause, const std::optional<EditResize>& resize, const std::optional<ShiftAt>& shift);
  Status read_room_size(Clause& clause, const std::optional<EditResize>& resize, const std::optional<ShiftAt>& shift);
  Status read_openings(Clause& clause, const std::optional<EditResize>& resize, const std::optional<ShiftAt>& shift);
  Status add_openings(Clause& clause);
  Result<std::vector<std::string>> find_openings(Clause& clause, const offline::NounPhrase& noun);
  Result<EditOpeningPlace> read_opening_place(Clause& clause, const std::vector<std::string>& openings);
  Result<EditOpeningPlace> read_wall_place(Clause& clause, const Wall* own_wall, const offline::PhraseSenses& senses);
  Result<EditShift> read_shift_reference(Clause& clause, EditShift way, const Wall* at_wall);
  Status read_keep(Clause& clause);
  Status read_clear(Clause& clause);
  Status read_copy(Clause& clause);
  // What an edit does not do, and what does it.
  static Failure refusal(const Clause& clause);
  // "make the walls darker": than what, nobody knows here.
  static Status check_shade(const Clause& clause);
  // "turn the sofa", and no more.
  std::optional<double> plain_turn(const Clause& clause);
  // "I do not like the rug": spoken of, and no more.
  Status read_mention(Clause& clause);
  // "where the desk is": what takes whose place; whether it says that.
  Result<bool> read_place_of_other(Clause& clause, const std::vector<int>& things);

  // The clause as a row of chunks.
  void chunk(Clause& clause) const;
  bool more(const Clause& clause) const { return clause.k < clause.document.chunks.size(); }
  const offline::Chunk* peek(const Clause& clause, std::size_t ahead = 0) const;
  void skip(Clause& clause, std::initializer_list<offline::ChunkKind> kinds) const;
  bool take_word(Clause& clause, std::initializer_list<std::string_view> words) const;
  bool noun_next(const Clause& clause) const;

  // Nouns that are in the room: "the desk and the two chairs". `places_follow`: what stands behind them may be their new place.
  Result<std::vector<int>> read_things(Clause& clause, bool places_follow);
  Result<Found> find_things(Clause& clause, const offline::NounPhrase& noun, bool as_target);
  std::vector<int> members(const Clause& clause, const offline::NounPhrase& noun, Pick pick, bool as_target) const;
  std::vector<int> all_things(Clause& clause, const offline::NounPhrase& noun);
  Result<Found> find_reference(Clause& clause, const offline::Chunk& chunk);
  Result<std::vector<int>> narrow(Clause& clause, std::vector<int> found, const offline::NounPhrase& noun, bool as_target);
  static std::size_t relations_ahead(const Clause& clause);
  static std::string words_of(const Clause& clause, const offline::Chunk& chunk);
  std::optional<Modifier> read_modifier(Clause& clause);
  std::vector<int> exceptions(Clause& clause);

  // The clause from the cursor on as the planner's reader takes it: what is in the room is known by its noun, and "to" says which
  // place. `subject`: whom the first place is of; null where all that is named first comes in.
  Result<std::vector<offline::Chunk>> passage(Clause& clause, const std::vector<int>* subject);
  Status know_noun(Clause& clause, offline::Chunk& chunk, const std::vector<int>& subject);
  void lead_to(Clause& clause, std::vector<offline::Chunk>& chunks, std::size_t at, const std::vector<int>& subject) const;
  bool follow_like(Clause& clause, std::vector<offline::Chunk>& chunks, std::size_t k);
  // Reads such a passage: its mentions, links and new items are the clause's.
  Status decode(Clause& clause, std::vector<offline::Chunk> chunks);
  // Places behind the cursor become steps that move `things`, and what is named with a place of its own after them.
  Status read_places(Clause& clause, const std::vector<int>& things, bool& any);
  // The links of the clause as relations; the new things are settled by them.
  Result<std::vector<Relation>> build(Clause& clause);
  // The new items of the clause, in steps: things that are placed by each other come in together.
  Status bring_in_items(Clause& clause);

  SceneObject new_object(const offline::NounPhrase& noun) const;
  int bring_in(const offline::NounPhrase& noun, EditStep& step);
  EditStep& begin(EditKind kind, const Clause& clause, const std::vector<int>& targets = {});
  void remember(const std::vector<int>& things);
  std::vector<std::string> ids(const std::vector<int>& things) const;
  Status rest_understood(const Clause& clause) const;
  Failure not_understood(const Clause& clause, std::string_view words = {}) const;
  std::string_view class_of(std::span<const offline::Token> tokens, std::size_t at) const;

  const offline::Lexicon& lexicon_;
  World world_;
  std::string_view text_;
  EditPlan plan_;
  std::map<std::string, SceneObject> added_;  // by id
  std::vector<std::string> added_openings_;   // ids
  // What "it" may mean before anything is spoken of here: what the text of the edit before spoke of last, else the room.
  void recall();
  EditShift along_wall(EditShift shift, const std::vector<int>& things) const;

  std::vector<int> last_;       // what "it" and "them" mean
  bool recalled_ = false;       // … from the edit before
  bool room_last_ = false;      // "it" is the room
  std::vector<int> mentioned_;  // what "the other" is not
};

}  // namespace layoutbox::edit
