#include "layoutbox/plan/passes/states.h"

#include <algorithm>
#include <string>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/noun_phrase.h"

namespace layoutbox::offline {
namespace {

constexpr std::size_t kStateReach = 6;  // words from a thing to its state

struct StatePhrase {
  std::vector<std::string> words;
  std::string attribute;
};

const std::vector<StatePhrase>& state_phrases() {
  static const std::vector<StatePhrase> kStateRows = [] {
    std::vector<StatePhrase> phrases;
    for (const WordList::Member state : word_list("words_attributes").at("states")) {
      for (const WordList::Member phrase : state.value) phrases.push_back({words_of(phrase.value.text()), std::string(state.key)});
    }
    return phrases;
  }();
  return kStateRows;
}

// The attribute for the state that is said at token `at`; empty where none is.
std::string state_at(const std::vector<Token>& tokens, std::size_t at) {
  for (const StatePhrase& phrase : state_phrases()) {
    const auto is_said = [&](std::size_t k) { return at + k < tokens.size() && tokens[at + k].text == phrase.words[k]; };
    std::size_t same = 0;
    while (same < phrase.words.size() && is_said(same)) ++same;
    if (same == phrase.words.size()) return phrase.attribute;
  }
  return {};
}

struct StateSaid {
  std::string attribute;
  int of_them = 0;  // 0: all
};

// After a thing, up to the next one or the end of the clause; beyond a comma only with a number: "six beds, two of them overturned".
StateSaid state_after(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t from, std::size_t next) {
  int of_them = 0;
  bool parted = false;
  for (std::size_t at = from; at < std::min({tokens.size(), next, from + kStateReach}); ++at) {
    const Token& token = tokens[at];
    if (token.kind == Token::Kind::kPunctuation) {
      if (parted || token.text != ",") return {};
      parted = true;
      continue;
    }
    if (const NumberRead number = read_number(lexicon, tokens, at); number.length > 0) {
      of_them = static_cast<int>(number.value);
      continue;
    }
    if (parted && of_them == 0) return {};
    if (const std::string state = state_at(tokens, at); !state.empty()) return {state, of_them};
  }
  return {};
}

// States that only one kind of thing has, wherever they are said: "a bed with a green duvet and cream pillows, unmade".
void settle_states_of_kinds(const Lexicon& lexicon, Document& document) {
  const Catalog& catalog = lexicon.catalog();
  for (const WordList::Member row : word_list("words_attributes").at("states_of")) {
    const std::string state(row.key), kind(row.value.text());
    const auto said = std::ranges::find(document.tokens, state, &Token::text);
    if (said == document.tokens.end()) continue;
    const std::size_t at = static_cast<std::size_t>(said - document.tokens.begin());
    TextItem* of = nullptr;  // the last one before it, else the first
    for (TextItem& item : document.items) {
      if (item.noun.entry == nullptr || !catalog.is_a(item.noun.entry->id, kind)) continue;
      if (of == nullptr || item.noun.first < at) of = &item;
    }
    if (of != nullptr && std::ranges::find(of->noun.attributes, state) == of->noun.attributes.end()) of->noun.attributes.push_back(state);
  }
}

}  // namespace

void settle_states(const Lexicon& lexicon, Document& document) {
  settle_states_of_kinds(lexicon, document);
  std::vector<const Mention*> things;  // in the order of the text
  for (const Mention& mention : document.mentions) {
    if (!mention.items.empty()) things.push_back(&mention);
  }
  const auto begins = [](const Mention* mention) { return mention->noun.first; };
  std::ranges::stable_sort(things, {}, begins);
  for (const Mention& mention : document.mentions) {
    if (mention.items.empty() || mention.noun.last == 0) continue;
    auto other = std::ranges::lower_bound(things, mention.noun.last, {}, begins);
    const std::size_t reach = mention.noun.last + kStateReach;  // beyond it no state is looked for
    while (other != things.end() && begins(*other) < reach && (*other)->items == mention.items) ++other;
    const std::size_t next = other == things.end() ? document.tokens.size() : begins(*other);
    const StateSaid said = state_after(lexicon, document.tokens, mention.introduces ? mention.noun.last : mention.noun.first, next);
    if (said.attribute.empty()) continue;
    const std::size_t all = mention.items.size();
    const std::size_t some = said.of_them > 0 ? std::min(all, static_cast<std::size_t>(said.of_them)) : all;
    for (std::size_t i = all - some; i < all; ++i) {
      std::vector<std::string>& attributes = document.items[static_cast<std::size_t>(mention.items[i])].noun.attributes;
      if (std::ranges::find(attributes, said.attribute) == attributes.end()) attributes.push_back(said.attribute);
    }
  }
}

}  // namespace layoutbox::offline
