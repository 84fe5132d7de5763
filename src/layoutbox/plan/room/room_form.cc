// The form of a room whose size is not said in full: "long and narrow", "a square room", "a galley kitchen".
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {
namespace {

constexpr std::size_t kAdjectives = 3;  // between the word and the room: "a long dark basement room"

class FormReader {
 public:
  FormReader(const Lexicon& lexicon, const Document& document) : lexicon_(lexicon), tokens_(document.tokens) {}

  std::string read() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const std::string form = form_at(i);
      if (form.empty() || is_measured(i)) continue;
      const std::size_t after = past_adjectives(i);
      // "An L-shaped kitchen": its units stand so, which is read with the room's name.
      const bool letters = form.size() == 1;
      if ((is_room(after) && !letters) || (closes(after) && is_said_of_room(i))) return form;
    }
    return {};
  }

 private:
  // The form that a word says ("narrow": long), "" for others.
  std::string form_at(std::size_t i) const {
    for (const WordList::Member form : word_list("words_room").at("room_forms")) {
      for (const WordList::Member word : form.value) {
        if (stand_at(tokens_, i, words_of(word.value.text()))) return std::string(form.key);
      }
    }
    return {};
  }

  bool is_of(std::size_t i, WordClass word_class) const { return lexicon_.find(tokens_, i, word_class).length > 0; }
  // A dining room table is none.
  bool is_room(std::size_t i) const {
    if (i >= tokens_.size()) return false;
    const Match match = lexicon_.find(tokens_, i);
    return has(match, WordClass::kRoom) || has(match, WordClass::kRoomNoun);
  }
  bool is_word(std::size_t i, std::initializer_list<std::string_view> words) const {
    return i < tokens_.size() && std::ranges::find(words, std::string_view(tokens_[i].text)) != words.end();
  }

  // "3 m long", "20 square metres", "two metres wide".
  bool is_measured(std::size_t i) const {
    return is_of(i, WordClass::kAreaUnit) || (i > 0 && (tokens_[i - 1].kind == Token::Kind::kNumber || is_of(i - 1, WordClass::kUnit))) ||
           is_word(i + 1, {"meter", "meters", "metre", "metres", "foot", "feet", "m", "ft", "wall", "walls", "side", "end"});
  }

  // Past what else is said before a noun: "long, narrow and dark".
  std::size_t past_adjectives(std::size_t i) const {
    std::size_t at = i + 1;
    for (std::size_t words = 0; at < tokens_.size() && words < kAdjectives && !tokens_[at - 1].ends_sentence; ++at) {
      if (is_word(at, {"and", ",", "but", "shaped", "shape", "ish"}) && !closes_list(at)) continue;
      const bool says = !form_at(at).empty() || attribute_of(lexicon_.find(tokens_, at)) != nullptr || is_of(at, WordClass::kSizeWord);
      if (is_room(at) || !says) break;
      ++words;
    }
    return at;
  }

  // "It is long and narrow, with a bed": after the comma comes something else.
  bool closes_list(std::size_t at) const {
    return at + 1 >= tokens_.size() || (form_at(at + 1).empty() && attribute_of(lexicon_.find(tokens_, at + 1)) == nullptr &&
                                        !is_word(at + 1, {"and", "shaped", "shape"}) && !is_room(at + 1));
  }

  bool closes(std::size_t at) const {
    return at >= tokens_.size() || tokens_[at].kind == Token::Kind::kPunctuation || tokens_[at - 1].ends_sentence ||
           is_word(at, {"with", "so", "but", "and", "about", "around", "like", "because", "which", "where", "as"});
  }

  // The noun last spoken of before is the room.
  bool is_said_of_room(std::size_t i) const {
    constexpr std::size_t kLookBack = 200;  // tokens: keeps long texts linear
    bool room = false;
    for (std::size_t at = i > kLookBack ? i - kLookBack : 0; at < i;) {
      const Match match = lexicon_.find(tokens_, at);
      const bool thing =
          has(match, WordClass::kObject) || has(match, WordClass::kDoor) || has(match, WordClass::kWindow) || has(match, WordClass::kWall);
      const bool place = has(match, WordClass::kRoom) || has(match, WordClass::kRoomNoun) || has(match, WordClass::kOutsideRoom);
      if (place || thing) room = place;
      at += std::max<std::size_t>(match.length, 1);
    }
    return room;
  }

  const Lexicon& lexicon_;
  const std::vector<Token>& tokens_;
};

}  // namespace

std::string read_room_form(const Lexicon& lexicon, const Document& document) { return FormReader(lexicon, document).read(); }

}  // namespace layoutbox::offline
