// The offline planner: text → tokens → chunks → mentions, items and links → scene.
#include <algorithm>
#include <cctype>
#include <map>

#include "layoutbox/base/utf8.h"
#include "layoutbox/base/words.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/offline/languages.h"
#include "layoutbox/plan/offline/left_out.h"
#include "layoutbox/plan/offline/people.h"
#include "layoutbox/plan/offline/room_by_contents.h"
#include "layoutbox/plan/offline/text_passes.h"
#include "layoutbox/plan/offline/wishes.h"
#include "layoutbox/plan/passes/bans.h"
#include "layoutbox/plan/passes/built_ins.h"
#include "layoutbox/plan/passes/states.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/object_size.h"
#include "layoutbox/plan/planner.h"
#include "layoutbox/plan/relations/amounts.h"
#include "layoutbox/plan/relations/linings.h"
#include "layoutbox/plan/relations/relation_builder.h"
#include "layoutbox/plan/relations/zones.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/plan/room/slopes.h"
#include "layoutbox/plan/words/american_spelling.h"
#include "layoutbox/plan/words/letters.h"
#include "layoutbox/plan/words/spelling.h"

namespace layoutbox {
namespace {

using namespace offline;

class OfflinePlanner final : public Planner {
 public:
  explicit OfflinePlanner(const Catalog& catalog) : lexicon_(catalog) {}

  Result<Plan> plan(std::string_view prompt, const PlanOptions& options) const override {
    if (prompt.size() > options.max_prompt_bytes)
      return fail(ErrorCode::kTooLarge, "the prompt has " + std::to_string(prompt.size()) + " bytes", {},
                  "at most " + std::to_string(options.max_prompt_bytes) + " are read");
    if (!is_utf8(prompt)) return fail(ErrorCode::kParse, "the prompt is not UTF-8 text", {}, "save it as UTF-8");
    Document document;
    document.stop = options.stop;
    document.prompt = std::string(prompt);
    document.tokens = tokenize(prompt);
    end_last_sentence(document);
    if (const auto language = foreign_language(document); language && !translate(*language, document)) {
      return fail(ErrorCode::kEmpty, "the text seems to be " + *language + ", which the offline planner does not read", "prompt",
                  "write it in English, or use a language model: --planner llm");
    }
    correct_spelling(lexicon_, document.tokens, document.stop);
    part_contractions(document.tokens);
    if (is_set(document.stop)) return stopped();
    if (std::none_of(document.tokens.begin(), document.tokens.end(), [](const Token& t) { return t.kind != Token::Kind::kPunctuation; })) {
      return fail(ErrorCode::kEmpty, "there is nothing in the prompt", {},
                  "describe a room: \"A bedroom with a bed and a desk under the window\"");
    }
    for (const Token& token : document.tokens) document.readings.push_back({token.begin, token.end, WordReading::Use::kIgnored, {}});
    std::vector<bool> skip(document.tokens.size(), false);
    const RoomSize size = read_room_size(lexicon_, document, skip);
    if (size.impossible) {
      return fail(ErrorCode::kGeometry, "the text asks for a room with a side of 0 m or of more than 100 m", "prompt",
                  "give a size such as 4 x 3 x 2.5 m");
    }
    document.size_said_at = begins_of(document.readings, skip);
    for (const WordPass& pass : word_passes()) {
      pass.run(lexicon_, document, skip);
      if (is_set(document.stop)) return stopped();
    }
    const std::vector<WordReading> of_size = take_out(document, skip);
    document.chunks = chunk_tokens(lexicon_, document.tokens, document.stop);
    if (is_set(document.stop)) return stopped();
    for (const PhrasePass& pass : phrase_passes()) {
      pass.run(lexicon_, document);
      if (is_set(document.stop)) return stopped();
    }
    read_document(lexicon_, document);
    if (is_set(document.stop)) return stopped();
    settle_states(lexicon_, document);
    find_zones(lexicon_, document);
    settle_built_ins(lexicon_, document);
    add_for_people(lexicon_, document);
    settle_amounts(lexicon_, document);

    Plan plan;
    plan.close = std::move(document.close);
    for (const NounPhrase& noun : document.excluded) {
      if (noun.entry != nullptr) plan.unwanted.push_back(noun.entry->id);
    }
    plan.scene.prompt = document.prompt;
    plan.scene.notes = std::move(document.notes);
    build_objects(document, plan.scene);
    build_room(lexicon_, document, size, plan.scene);
    name_walls_by_openings(lexicon_, document, plan.scene);
    read_room_colors(lexicon_, document, plan.scene.room);
    build_relations(lexicon_, document, plan.scene);
    if (is_set(document.stop)) return stopped();
    add_bans(lexicon_, document, plan.scene);
    name_room_by_contents(lexicon_, document, plan.scene);
    furnish_by_wish(lexicon_, document, plan.scene);
    settle_slopes(lexicon_, document, plan.scene);
    plan.linings = find_linings(lexicon_, document, plan.scene);
    const bool speaks_of_room = !document.rooms.empty() || !plan.scene.room.openings.empty() || size.width > 0 || size.area > 0;
    if (plan.scene.objects.empty() && !speaks_of_room) {
      return fail(ErrorCode::kEmpty, "neither a room nor a piece of furniture was understood", "prompt",
                  "describe a room in English: \"A bedroom with a bed and a desk under the window\"");
    }
    note_unknown(document, plan.scene);
    note_left_out(lexicon_, document, plan.scene);
    for (std::size_t i = 0; i < document.tokens.size(); ++i) {
      const Token& token = document.tokens[i];
      if (token.begin >= token.end || (token.kind == Token::Kind::kPunctuation && !is_lettered(document.prompt, token))) continue;
      if (token.kind == Token::Kind::kPunctuation) document.readings[i].role = "an entry's mark";
      plan.readings.push_back(std::move(document.readings[i]));
    }
    plan.readings.insert(plan.readings.end(), of_size.begin(), of_size.end());
    std::sort(plan.readings.begin(), plan.readings.end(), [](const WordReading& a, const WordReading& b) { return a.begin < b.begin; });
    return plan;
  }

 private:
  static Failure stopped() { return fail(ErrorCode::kInterrupted, "stopped", {}, "what was finished is kept"); }

  // "Item A:"
  static bool is_lettered(std::string_view prompt, const Token& token) {
    return std::ranges::any_of(prompt.substr(token.begin, token.end - token.begin), is_letter);
  }

  // What stops without a full stop reads as if it had one.
  static void end_last_sentence(Document& document) {
    if (document.tokens.empty() || document.tokens.back().kind == Token::Kind::kPunctuation) return;
    Token& stop = document.tokens.emplace_back();
    stop.kind = Token::Kind::kPunctuation;
    stop.text = ".";
    stop.begin = stop.end = document.prompt.size();
    stop.ends_sentence = true;
  }

  static std::vector<std::size_t> begins_of(const std::vector<WordReading>& readings, const std::vector<bool>& marked) {
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      if (marked[i]) begins.push_back(readings[i].begin);
    }
    return begins;
  }

  // Takes the words that said the room's size out of the text: the rest reads as if they were not there.
  static std::vector<WordReading> take_out(Document& document, const std::vector<bool>& taken) {
    std::vector<WordReading> readings;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (taken[i]) {
        if (document.tokens[i].begin < document.tokens[i].end) readings.push_back(std::move(document.readings[i]));  // else put in
        continue;
      }
      if (kept != i) {
        document.tokens[kept] = std::move(document.tokens[i]);
        document.readings[kept] = std::move(document.readings[i]);
      }
      ++kept;
    }
    document.tokens.resize(kept);
    document.readings.resize(kept);
    return readings;
  }

  // "a plough": its name is spelt as the text has it, whatever the lists have.
  static std::string as_spelt(const Document& document, const NounPhrase& noun) {
    std::string name = noun.name;
    for (std::size_t i = noun.first; i < noun.last && i < document.tokens.size(); ++i) {
      const Token& token = document.tokens[i];
      if (token.kind != Token::Kind::kWord || token.begin >= token.end || token.end > document.prompt.size()) continue;
      std::string said = document.prompt.substr(token.begin, token.end - token.begin);
      std::ranges::transform(said, said.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (said == token.text || american_spelling(said) != token.text) continue;
      const std::string listed = singular_of(token.text), spelt = singular_of(said);
      if (const std::size_t at = name.find(listed); at != std::string::npos) name.replace(at, listed.size(), spelt);
    }
    return name;
  }

  void build_objects(Document& document, SceneGraph& scene) const {
    std::map<std::string, int> numbers;
    std::map<int, int> of_group, so_far;
    for (const TextItem& item : document.items) ++of_group[item.group];
    for (const TextItem& item : document.items) {
      constexpr int kCertain = 2;  // of what fills its place: the plural's own
      const int rank = so_far[item.group]++;
      SceneObject object;
      object.category = !item.noun.category.empty() ? item.noun.category : snake_case(item.noun.head);
      object.name = as_spelt(document, item.noun);
      object.attributes = item.noun.attributes;
      object.id = object.category + "_" + std::to_string(++numbers[object.category]);
      object.origin = item.concluded || (item.noun.filling && rank >= kCertain) ? Origin::kConcluded : Origin::kAsked;
      apply_size(lexicon_.catalog(), item.noun, object);
      if (item.noun.assorted) apply_assorted_size(item.noun, rank, of_group[item.group], object);
      for (std::size_t i = item.noun.first; i < item.noun.last && i < document.readings.size(); ++i) {
        if (document.readings[i].role == item.noun.name) document.readings[i].role = "object " + object.id;
      }
      scene.objects.push_back(std::move(object));
    }
    std::vector<std::string> guessed;
    for (const TextItem& item : document.items) {
      if (item.noun.entry != nullptr && item.noun.category == item.noun.entry->id) continue;
      if (std::find(guessed.begin(), guessed.end(), item.noun.name) != guessed.end()) continue;
      guessed.push_back(item.noun.name);
      const std::string place = "prompt:" + std::to_string(document.tokens[item.noun.first].begin) + "-" +
                                std::to_string(document.tokens[item.noun.last - 1].end);
      scene.notes.push_back(unknown_kind_note(item.noun.name, lexicon_.catalog().entry_or_nearest(item.noun.category), place));
    }
  }

  static void note_unknown(const Document& document, SceneGraph& scene) {
    for (std::size_t i = 0; i < document.tokens.size(); ++i) {
      if (document.readings[i].use != WordReading::Use::kNotUnderstood) continue;
      std::size_t last = i + 1;
      while (last < document.tokens.size() && document.readings[last].use == WordReading::Use::kNotUnderstood) ++last;
      scene.notes.push_back({"not-understood", "\"" + words_between(document, i, last) + "\" is not understood",
                             "prompt:" + std::to_string(document.tokens[i].begin) + "-" + std::to_string(document.tokens[last - 1].end)});
      i = last - 1;
    }
  }

  Lexicon lexicon_;
};

}  // namespace

std::unique_ptr<Planner> make_offline_planner(const Catalog& catalog) { return std::make_unique<OfflinePlanner>(catalog); }

}  // namespace layoutbox
