#include "layoutbox/plan/passes/bare_corners.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/splice.h"

namespace layoutbox::offline {
namespace {

// "back right" and "right back" at `at`, with no noun after it that it says which one of.
bool names_corner(const Lexicon& lexicon, const Document& document, std::size_t at) {
  const auto depth = [&](std::size_t i) { return says_one_of(document, i, {"front", "back", "rear", "far", "near"}); };
  const auto side = [&](std::size_t i) { return says_one_of(document, i, {"left", "right"}); };
  const std::vector<Token>& tokens = document.tokens;
  if (!((depth(at) && side(at + 1)) || (side(at) && depth(at + 1))) || tokens[at].ends_sentence) return false;
  const std::size_t next = at + 2;
  if (next >= tokens.size() || tokens[at + 1].ends_sentence || tokens[next].kind == Token::Kind::kPunctuation) return true;
  if (says_one_of(document, next, {"of", "with"}) || lexicon.is(tokens[next], WordClass::kAnd)) return true;
  // "Front right a chest": its place comes first.
  const bool begins = at == 0 || tokens[at - 1].ends_sentence || tokens[at - 1].kind == Token::Kind::kPunctuation;
  if (begins && (lexicon.is(tokens[next], WordClass::kIndefinite) || lexicon.is(tokens[next], WordClass::kNumber))) return true;
  return lexicon.find_phrase(tokens, next).length > 0 && lexicon.find(tokens, next, WordClass::kObject).length == 0;
}

// "Upstage center a throne, a chest downstage left": as who looks at the stage says it, whose right the actor's left is.
void read_stage_words(Document& document, std::vector<bool>& skip) {
  std::vector<Splice> words;
  std::vector<Token>& tokens = document.tokens;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::size_t next = i + 1;
    // "a sideboard stage left": no stage stands there
    if (says_one_of(document, i, {"stage"}) && says_one_of(document, next, {"left", "right"}) && !says_one_of(document, next + 1, {"of"})) {
      const bool led = i > 0 && says_one_of(document, i - 1, {"on", "at", "to", "the"});
      if (!led) words.push_back({i, word_token("on")});
      tokens[i].text = "the";
      tokens[next].text = tokens[next].text == "left" ? "right" : "left";
      words.push_back({next + 1, word_token("side")});
      for (const std::string_view word : {"of", "the", "room"}) words.push_back({next + 1, word_token(word)});
      continue;
    }
    if (skip[i] || !says_one_of(document, i, {"upstage", "downstage"})) continue;
    tokens[i].text = tokens[i].text == "upstage" ? "back" : "front";
    if (says_one_of(document, next, {"left", "right"})) {
      tokens[next].text = tokens[next].text == "left" ? "right" : "left";
      continue;
    }
    if (says_one_of(document, next, {"wall", "corner"})) continue;
    if (says_one_of(document, next, {"center"})) skip[next] = true;
    for (const std::string_view word : {"at", "the"}) words.push_back({i, word_token(word)});
  }
  splice(document, skip, std::move(words));
}

// "left wall", "right side" at `at`, right behind a thing and before a break: terse for "on the left wall".
bool names_bare_wall(const Lexicon& lexicon, const Document& document, std::size_t at) {
  const std::vector<Token>& tokens = document.tokens;
  if (at == 0 || at + 1 >= tokens.size() || tokens[at - 1].ends_sentence || tokens[at].ends_sentence) return false;
  const bool side = says_one_of(document, at, {"left", "right"}) && says_one_of(document, at + 1, {"side"});
  const bool wall = says_one_of(document, at, {"left", "right", "back", "rear", "front", "far", "north", "south", "east", "west"}) &&
                    says_one_of(document, at + 1, {"wall"});
  if (!side && !wall) return false;
  const std::size_t next = at + 2;
  const bool ends = next >= tokens.size() || tokens[at + 1].ends_sentence || tokens[next].kind == Token::Kind::kPunctuation ||
                    lexicon.is(tokens[next], WordClass::kAnd);
  const Match thing = lexicon.find(tokens, at - 1);
  const auto is_thing = [](const Meaning& m) {
    return m.word_class == WordClass::kObject || m.word_class == WordClass::kDoor || m.word_class == WordClass::kWindow;
  };
  return ends && thing.length == 1 && std::ranges::any_of(thing.meanings, is_thing) && lexicon.find_phrase(tokens, at - 1).length == 0;
}

void complete_bare_walls(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Splice> words;
  for (std::size_t i = 1; i + 1 < document.tokens.size(); ++i) {
    if (skip[i] || !names_bare_wall(lexicon, document, i)) continue;
    for (const std::string_view word : {"on", "the"}) words.push_back({i, word_token(word)});
  }
  splice(document, skip, std::move(words));
}

// "on the opposite wall" at `at`, where a clause begins.
bool begins_with_wall(const Document& document, std::size_t at) {
  if (!says_one_of(document, at, {"on", "along", "against", "at"})) return false;
  if (at > 0 && !document.tokens[at - 1].ends_sentence && document.tokens[at - 1].kind != Token::Kind::kPunctuation &&
      !says_one_of(document, at - 1, {"and", "then"}))
    return false;
  return says_one_of(document, at + 1, {"the"}) && says_one_of(document, at + 3, {"wall"}) && !document.tokens[at + 3].ends_sentence;
}

// "on the opposite wall wardrobe, on the right wall desk": the thing stands there, and is no wall desk.
void part_things_from_walls(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Splice> words;
  constexpr std::size_t kPlace = 4;  // "on the right wall"
  for (std::size_t i = 0; i + kPlace < document.tokens.size(); ++i) {
    if (!begins_with_wall(document, i)) continue;
    const Match thing = lexicon.find(document.tokens, i + kPlace, WordClass::kObject);
    const auto stands = [](const Meaning& m) { return m.entry != nullptr && m.entry->mount == Mount::kFloor; };
    if (thing.length == 0 || !std::ranges::any_of(thing.meanings, stands)) continue;
    const std::string& last = document.tokens[i + kPlace + thing.length - 1].text;
    words.push_back({i + kPlace, word_token(last == singular_of(last) ? "a" : "some")});
  }
  splice(document, skip, std::move(words));
}

// "a corner shower", "a corner sofa,": it stands in a corner, where nothing else is said of its place.
void place_corner_pieces(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Splice> words;
  const std::vector<Token>& tokens = document.tokens;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (skip[i] || !says_one_of(document, i, {"corner"}) || tokens[i].ends_sentence) continue;
    const Match whole = lexicon.find(tokens, i, WordClass::kObject);
    const std::size_t end = whole.length > 1 ? i + whole.length : i + 1 + lexicon.find(tokens, i + 1, WordClass::kObject).length;
    const Match thing = whole.length > 1 ? whole : lexicon.find(tokens, i + 1, WordClass::kObject);
    const auto stands = [](const Meaning& m) { return m.entry != nullptr && m.entry->mount == Mount::kFloor && !m.entry->thin; };
    const bool leads = i == 0 || tokens[i - 1].ends_sentence || tokens[i - 1].kind == Token::Kind::kPunctuation ||
                       lexicon.is(tokens[i - 1], WordClass::kIndefinite) || lexicon.is(tokens[i - 1], WordClass::kAnd) ||
                       lexicon.is(tokens[i - 1], WordClass::kSizeWord) || says_one_of(document, i - 1, {"with"});
    const bool over = end >= tokens.size() || tokens[end - 1].ends_sentence || tokens[end].kind == Token::Kind::kPunctuation ||
                      lexicon.is(tokens[end], WordClass::kAnd);
    const bool told = i > 1 && (says_one_of(document, i - 2, {"is", "are"}) || lexicon.is(tokens[i - 2], WordClass::kPlaceVerb));
    if (thing.length == 0 || !std::ranges::any_of(thing.meanings, stands) || !leads || !over) continue;
    if (told) continue;  // "Next to the sofa is a corner table, …"
    skip[i] = whole.length <= 1;
    for (const std::string_view word : {"in", "the", "corner"}) words.push_back({end, word_token(word)});
  }
  splice(document, skip, std::move(words));
}

// "a screen at one end, a sideboard at the other": at the other end.
void complete_other_ends(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Splice> words;
  const std::vector<Token>& tokens = document.tokens;
  bool one = false;  // end, in this sentence
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (says_one_of(document, i, {"at"}) && says_one_of(document, i + 1, {"one"}) && says_one_of(document, i + 2, {"end"})) one = true;
    const bool other = says_one_of(document, i, {"at"}) && says_one_of(document, i + 1, {"the"}) && says_one_of(document, i + 2, {"other"});
    const bool over = i + 3 >= tokens.size() || tokens[i + 2].ends_sentence || tokens[i + 3].kind == Token::Kind::kPunctuation ||
                      lexicon.is(tokens[i + 3], WordClass::kAnd);
    if (one && other && over) words.push_back({i + 3, word_token("end")});
    one = one && !tokens[i].ends_sentence;
  }
  splice(document, skip, std::move(words));
}

// What stands on the floor and is no seat ends right before `at`.
bool follows_furniture(const Lexicon& lexicon, const Document& document, std::size_t at) {
  constexpr std::size_t kLongest = 3;  // words
  for (std::size_t length = kLongest; length > 0; --length) {
    if (length > at) continue;
    std::vector<Token> name(document.tokens.begin() + static_cast<std::ptrdiff_t>(at - length),
                            document.tokens.begin() + static_cast<std::ptrdiff_t>(at));
    name.back().text = singular_of(name.back().text);
    const Match thing = lexicon.find(name, 0, WordClass::kObject);
    if (thing.length != length) continue;
    return std::ranges::any_of(thing.meanings, [](const Meaning& m) {
      return m.entry != nullptr && m.entry->mount == Mount::kFloor && !m.entry->is(Trait::kSeat) && !m.entry->is(Trait::kTableSeat);
    });
  }
  return false;
}

// "two beds down each side", "a mower on the right-hand side": of the room.
void complete_room_sides(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Splice> words;
  std::vector<Token>& tokens = document.tokens;
  const auto over = [&](std::size_t end) {
    return end >= tokens.size() || tokens[end - 1].ends_sentence || tokens[end].kind == Token::Kind::kPunctuation ||
           says_one_of(document, end, {"and", "with"});
  };
  for (std::size_t i = 1; i + 2 < tokens.size(); ++i) {
    if (!says_one_of(document, i, {"down", "along", "on"}) || !follows_furniture(lexicon, document, i)) continue;
    if (says_one_of(document, i, {"down", "along"}) && says_one_of(document, i + 1, {"each"}) && says_one_of(document, i + 2, {"side"}) &&
        over(i + 3)) {
      tokens[i].text = "along";
      words.push_back({i + 3, word_token("wall")});
      continue;
    }
    std::size_t side = i + 3;
    if (says_one_of(document, side, {"-"})) ++side;
    if (says_one_of(document, side, {"hand"})) ++side;
    const bool hand = says_one_of(document, i + 2, {"left-hand", "right-hand"}) || side > i + 3;
    if (!hand || !says_one_of(document, i + 1, {"the"}) || !says_one_of(document, side, {"side"}) || !over(side + 1)) continue;
    for (const std::string_view word : {"of", "the", "room"}) words.push_back({side + 1, word_token(word)});
  }
  splice(document, skip, std::move(words));
}

// How many words before `it` begin a clause that tells of what is beside it: "and in front of it"; 0: none.
std::size_t begins_by(const Document& document, std::size_t it) {
  constexpr std::size_t kLongest = 3;  // "in front of"
  if (!says_one_of(document, it, {"it", "them"}) || document.tokens[it].ends_sentence) return 0;
  if (!says_one_of(document, it - 1, {"of", "to", "beside", "above", "under", "below", "behind", "opposite", "over", "near", "facing"}))
    return 0;
  for (std::size_t length = 1; length <= kLongest && length < it; ++length) {
    const Token& before = document.tokens[it - length - 1];
    if (before.ends_sentence || before.kind == Token::Kind::kPunctuation || before.text == "and") return length;
    if (before.kind != Token::Kind::kWord) return 0;
  }
  return 0;
}

// "a wardrobe and beside it small desk": a small desk.
void part_things_from_it(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Splice> words;
  constexpr std::size_t kMostLooks = 2;
  for (std::size_t i = 2; i + 1 < document.tokens.size(); ++i) {
    if (begins_by(document, i) == 0) continue;
    std::size_t noun = i + 1;
    const auto is_look = [&](std::size_t at) {
      return at < document.tokens.size() &&
             (lexicon.is(document.tokens[at], WordClass::kSizeWord) || lexicon.is(document.tokens[at], WordClass::kColor) ||
              lexicon.is(document.tokens[at], WordClass::kMaterial));
    };
    while (noun < i + 1 + kMostLooks && is_look(noun)) ++noun;
    if (noun < document.tokens.size() && lexicon.is(document.tokens[noun], WordClass::kPlaceVerb)) continue;  // "under it stand two crates"
    const Match thing = noun < document.tokens.size() ? lexicon.find(document.tokens, noun, WordClass::kObject) : Match{};
    if (thing.length == 0) continue;
    const std::string& last = document.tokens[noun + thing.length - 1].text;
    words.push_back({i + 1, word_token(last == singular_of(last) ? "a" : "some")});
  }
  splice(document, skip, std::move(words));
}

}  // namespace

void complete_bare_corners(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  read_stage_words(document, skip);
  complete_bare_walls(lexicon, document, skip);
  part_things_from_walls(lexicon, document, skip);
  part_things_from_it(lexicon, document, skip);
  place_corner_pieces(lexicon, document, skip);
  complete_other_ends(lexicon, document, skip);
  complete_room_sides(lexicon, document, skip);
  std::vector<Splice> words;
  for (std::size_t i = 0; i + 1 < document.tokens.size(); ++i) {
    if (skip[i] || !names_corner(lexicon, document, i)) continue;
    std::vector<Token>& tokens = document.tokens;
    if (says_one_of(document, i, {"left", "right"})) std::swap(tokens[i].text, tokens[i + 1].text);
    const bool first = i == 0;
    const bool article = !first && says_one_of(document, i - 1, {"the"}),
               place = !first && says_one_of(document, i - 1, {"in", "at", "on"});
    const bool verb = !first && lexicon.is(tokens[i - 1], WordClass::kPlaceVerb);  // "to the far right", "faces front left"
    if (verb || (article && (i < 2 || !says_one_of(document, i - 2, {"in", "at", "on"})))) continue;
    if (!article && !place) words.push_back({i, word_token("in")});
    if (!article) words.push_back({i, word_token("the")});
    words.push_back({i + 2, word_token("corner")});
  }
  splice(document, skip, std::move(words));
}

}  // namespace layoutbox::offline
