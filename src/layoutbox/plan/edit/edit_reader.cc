#include "layoutbox/plan/edit/edit_reader.h"

#include <algorithm>
#include <utility>

#include "layoutbox/plan/edit/edit_reader_parts.h"
#include "layoutbox/plan/edit/plain_words.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder.h"

namespace layoutbox::edit {

using namespace offline;

Failure EditReader::not_understood(const Clause& clause, std::string_view words) const {
  const std::string what =
      words.empty() || words == clause.why ? "\"" + clause.why + "\"" : "\"" + std::string(words) + "\" in \"" + clause.why + "\"";
  return fail(ErrorCode::kParse, what + " is not understood as a change of the room", "text", kWhatToSay);
}

const Chunk* EditReader::peek(const Clause& clause, std::size_t ahead) const {
  return clause.k + ahead < clause.document.chunks.size() ? &clause.document.chunks[clause.k + ahead] : nullptr;
}

void EditReader::skip(Clause& clause, std::initializer_list<ChunkKind> kinds) const {
  while (more(clause) && std::find(kinds.begin(), kinds.end(), peek(clause)->kind) != kinds.end()) ++clause.k;
}

// Takes the next chunk where it is one of these words.
bool EditReader::take_word(Clause& clause, std::initializer_list<std::string_view> words) const {
  if (!more(clause)) return false;
  const Chunk& next = *peek(clause);
  const std::string text = words_of(clause, next);
  if (std::find(words.begin(), words.end(), text) == words.end()) return false;
  ++clause.k;
  return true;
}

bool EditReader::noun_next(const Clause& clause) const { return more(clause) && peek(clause)->kind == ChunkKind::kNoun; }

std::vector<std::string> EditReader::ids(const std::vector<int>& things) const {
  std::vector<std::string> all;
  for (const int i : things) all.push_back(world_.thing(i).id);
  return all;
}

void EditReader::remember(const std::vector<int>& things) {
  last_ = things;
  mentioned_.insert(mentioned_.end(), things.begin(), things.end());
}

EditStep& EditReader::begin(EditKind kind, const Clause& clause, const std::vector<int>& targets) {
  EditStep step;
  step.kind = kind;
  step.targets = ids(targets);
  step.why = clause.why;
  plan_.steps.push_back(std::move(step));
  return plan_.steps.back();
}

void EditReader::chunk(Clause& clause) const {
  Document& document = clause.document;
  document.readings.clear();
  for (const Token& token : document.tokens) document.readings.push_back({token.begin, token.end, WordReading::Use::kIgnored, {}});
  document.chunks = chunk_tokens(lexicon_, document.tokens);
  // "bed_1", "window2": a thing by its id.
  for (Chunk& chunk : document.chunks) {
    const Opening* opening = chunk.last == chunk.first + 1 ? world_.layout().find_opening(document.tokens[chunk.first].text) : nullptr;
    if (opening != nullptr) {
      chunk.kind = ChunkKind::kNoun;
      chunk.noun = NounPhrase{};
      chunk.noun.kind = opening->type == OpeningType::kWindow ? NounKind::kWindow : NounKind::kDoor;
      chunk.noun.name = chunk.noun.head = opening->id;
      chunk.noun.determiner = Determiner::kDefinite;
      chunk.noun.first = chunk.first, chunk.noun.last = chunk.last;
      continue;
    }
    // "make the table round": no place without a noun.
    const bool noun_follows = &chunk != &document.chunks.back() && (&chunk + 1)->kind == ChunkKind::kNoun;
    if (chunk.kind == ChunkKind::kRelation && chunk.last == chunk.first + 1 && !noun_follows &&
        lexicon_.is(document.tokens[chunk.first], WordClass::kShape))
      chunk.kind = ChunkKind::kAttribute;
    if (chunk.kind == ChunkKind::kNoun || chunk.last != chunk.first + 1) continue;
    const std::string& word = document.tokens[chunk.first].text;
    if (word.find('_') == std::string::npos && word != "everything") continue;
    if (word != "everything" && world_.find(word) < 0) continue;
    chunk.kind = ChunkKind::kNoun;
    chunk.noun = NounPhrase{};
    chunk.noun.name = chunk.noun.head = word;
    chunk.noun.determiner = Determiner::kDefinite;
    chunk.noun.first = chunk.first, chunk.noun.last = chunk.last;
  }
}

Status EditReader::read_command(const Command& said) {
  const Command command = in_plain_words(lexicon_, world_, said);
  Clause clause;
  clause.verb = command.verb;
  clause.word = command.word;
  clause.along_wall = command.along_wall;
  clause.why = std::string(text_.substr(command.begin, command.end - command.begin));
  clause.document.prompt = std::string(text_);
  clause.earlier = last_;
  Tokens tokens = command.tokens;
  drop_properties(tokens, command);
  if (clause.verb == Verb::kRename) name_after_as(tokens);
  if (clause.word == "tuck") tuck_under(tokens);
  clause.picks = take_picks(tokens);
  std::optional<double> degrees;
  std::optional<ShiftAt> shift;
  std::optional<EditResize> resize;
  const bool of_ceiling = std::any_of(tokens.begin(), tokens.end(), [](const Token& token) { return token.text == "ceiling"; });
  if (clause.verb == Verb::kTurn) {
    degrees = take_turn(tokens, true);
    if (!degrees) say_facing(tokens);
  } else if (clause.verb == Verb::kMove || clause.verb == Verb::kPlace) {
    if (of_ceiling) resize = take_resize(lexicon_, tokens, clause.word, true);  // "lower the ceiling to 2.4 m"
    if (!resize) shift = take_shift(lexicon_, tokens, clause.word);
  } else if (clause.verb == Verb::kMake || clause.verb == Verb::kNone || clause.verb == Verb::kResize) {
    resize = take_resize(lexicon_, tokens, clause.verb == Verb::kResize ? clause.word : "", false);
    if (!resize) degrees = take_turn(tokens, false);
    if (!resize && !degrees) shift = take_shift(lexicon_, tokens, "");
  }
  if (clause.verb == Verb::kRecolor || clause.verb == Verb::kMake || clause.word == "i") drop_to_before_color(lexicon_, tokens);
  clause.document.tokens = std::move(tokens);
  for (const Thing& thing : world_.things()) clause.document.items.push_back({thing.noun, clause.document.groups++});
  chunk(clause);
  if (clause.verb >= Verb::kUndo) return refusal(clause);
  LAYOUTBOX_CHECK(check_shade(clause));
  if (clause.verb == Verb::kTurn && !degrees) degrees = plain_turn(clause);
  if (const auto room = read_room_command(clause, resize, shift)) return *room;
  switch (clause.verb) {
    case Verb::kAdd: return read_add(clause);
    case Verb::kPlace: return shift ? read_move(clause, shift) : read_place(clause);
    case Verb::kRemove: return read_remove(clause);
    case Verb::kMove: return read_move(clause, shift);
    case Verb::kSwap: return read_swap(clause);
    case Verb::kReplace: return read_replace(clause, false);
    case Verb::kSubstitute: return read_replace(clause, true);
    case Verb::kTurn: return degrees ? read_turn(clause, degrees) : read_make(clause, std::nullopt, std::nullopt, std::nullopt);
    case Verb::kRename: return read_rename(clause);
    case Verb::kKeep: return read_keep(clause);
    case Verb::kMention: return read_mention(clause);
    case Verb::kClear: return read_clear(clause);
    case Verb::kCopy: return read_copy(clause);
    case Verb::kUndo:
    case Verb::kRedo:
    case Verb::kRearrange:
    case Verb::kAfresh: return refusal(clause);
    case Verb::kMake:
    case Verb::kRecolor:
    case Verb::kResize:
    case Verb::kNone: return read_make(clause, resize, degrees, shift);
  }
  return not_understood(clause);
}

Result<EditPlan> EditReader::read() {
  std::vector<Token> tokens = tokenize(text_);
  // "bed_1" comes in three pieces.
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    while (i + 2 < tokens.size() && tokens[i + 1].text == "_" && tokens[i + 1].glued && tokens[i + 2].glued) {
      tokens[i].text += "_" + tokens[i + 2].text;
      tokens[i].end = tokens[i + 2].end;
      tokens[i].kind = Token::Kind::kWord;
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 1, tokens.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    }
  }
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {  // and "window1" in two
    if (!tokens[i + 1].glued || world_.layout().find_opening(tokens[i].text + tokens[i + 1].text) == nullptr) continue;
    tokens[i].text += tokens[i + 1].text;
    tokens[i].end = tokens[i + 1].end;
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  recall();
  const std::vector<Command> commands = split_commands(tokens);
  if (commands.empty()) return fail(ErrorCode::kEmpty, "there is nothing in the text", "text", kWhatToSay);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    // "Take the vase off the sideboard and put it on the table" takes nothing away.
    const bool taken_up = commands[i].word == "take" && i + 1 < commands.size() && !commands[i + 1].tokens.empty() &&
                          (commands[i + 1].verb == Verb::kPlace || commands[i + 1].verb == Verb::kMove) &&
                          (commands[i + 1].tokens[0].text == "it" || commands[i + 1].tokens[0].text == "them");
    const std::size_t steps = plan_.steps.size();
    LAYOUTBOX_CHECK(read_command(commands[i]));
    if (!taken_up) continue;
    for (const int thing : last_) world_.things()[static_cast<std::size_t>(thing)].gone = false;
    plan_.steps.resize(steps);
  }
  return std::move(plan_);
}

}  // namespace layoutbox::edit

namespace layoutbox {

std::string_view name_of(EditKind kind) {
  switch (kind) {
    case EditKind::kAdd: return "add";
    case EditKind::kRemove: return "remove";
    case EditKind::kMove: return "move";
    case EditKind::kShift: return "shift";
    case EditKind::kSwap: return "swap";
    case EditKind::kReplace: return "replace";
    case EditKind::kTurn: return "turn";
    case EditKind::kResize: return "resize";
    case EditKind::kRecolor: return "recolor";
    case EditKind::kRename: return "rename";
    case EditKind::kKeep: return "keep";
  }
  return "move";
}

Result<EditPlan> plan_edit(std::string_view text, const Layout& layout, const Catalog& catalog) {
  if (text.size() > 100'000) return fail(ErrorCode::kTooLarge, "the text has more than 100000 bytes", "text");
  const offline::Lexicon lexicon(catalog);
  return edit::EditReader(lexicon, layout, text).read();
}

}  // namespace layoutbox
