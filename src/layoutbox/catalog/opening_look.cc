#include "layoutbox/catalog/opening_look.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/word_lists.h"

namespace layoutbox {
namespace {

// A wider door has two leaves, as people build them.
constexpr Mm kWidestLeaf = 1300;

constexpr std::string_view kSizeKeys[] = {"words", "w", "h", "sill", "wall"};
constexpr std::pair<std::string_view, Leaf> kLeaves[] = {{"panelled", Leaf::kPanelled},   {"glazed", Leaf::kGlazed},
                                                         {"sectional", Leaf::kSectional}, {"planks", Leaf::kPlanks},
                                                         {"lattice", Leaf::kLattice},     {"half", Leaf::kHalf}};
constexpr std::pair<std::string_view, OpeningShape> kShapes[] = {{"round", OpeningShape::kRound}, {"arched", OpeningShape::kArched}};

template <class Value, std::size_t n>
Value named(const std::pair<std::string_view, Value> (&table)[n], std::string_view name) {
  const auto* found = std::ranges::find(table, name, &std::pair<std::string_view, Value>::first);
  return found == std::end(table) ? Value{} : found->second;
}

// Rows of that type; passages without a leaf have none.
std::optional<WordList> rows_of(OpeningType type) {
  if (type == OpeningType::kOpen) return std::nullopt;
  return word_list("words_openings").at(name_of(type));
}

// The first phrase of the row that is said; empty: none.
std::string_view phrase_said(const WordList& row, const std::vector<std::string>& words) {
  for (const WordList::Member phrase : row.at("words")) {
    if (says(words, phrase.value.text())) return phrase.value.text();
  }
  return {};
}

// One row holds for what those above it left open.
class OpeningLookReader {
 public:
  explicit OpeningLookReader(OpeningLook& look) : look_(look) {}

  void add(const WordList& row) {
    for (const WordList::Member member : row) {
      const bool first = std::ranges::find(seen_, member.key) == seen_.end();
      if (member.key == "words" || !first) continue;
      seen_.push_back(member.key);
      set(member.key, member.value);
    }
  }

 private:
  void set(std::string_view key, const WordList& value) {
    if (key == "leaf") look_.leaf = named(kLeaves, value.text());
    if (key == "shape") look_.shape = named(kShapes, value.text());
    if (key == "wall") look_.wall = value.text();
    if (key == "pane") look_.pane = value.text();
    if (key == "frame") look_.frame = value.text();
    if (key == "leaves") look_.leaves = static_cast<int>(value.number());
    if (key == "slides") look_.slides = true;
    if (key == "rail") look_.rail = true;
    if (key == "outside") look_.outside = true;
    if (key == "onward") look_.onward = true;
    if (key == "outward") look_.outward = true;
    if (key == "whole") look_.whole = true;
    if (key == "bay") look_.bay = true;
    if (key == "w") look_.width = mm_from_m(value.number());
    if (key == "h") look_.height = mm_from_m(value.number());
    if (key == "sill") look_.sill = mm_from_m(value.number());
  }

  OpeningLook& look_;
  std::vector<std::string_view> seen_;
};

bool changes_more_than_size(const WordList& row) {
  for (const WordList::Member member : row) {
    if (std::ranges::find(kSizeKeys, member.key) == std::end(kSizeKeys)) return true;
  }
  return false;
}

}  // namespace

OpeningLook opening_look(OpeningType type, const std::vector<std::string>& said) {
  OpeningLook look;
  std::vector<std::string> words;
  for (const std::string& one : said) std::ranges::copy(words_of(one), std::back_inserter(words));
  OpeningLookReader reader(look);
  if (const auto rows = rows_of(type); rows && !words.empty()) {
    for (const WordList::Member row : *rows) {
      if (!phrase_said(row.value, words).empty()) reader.add(row.value);
    }
  }
  return look;
}

std::vector<std::string> look_words(OpeningType type, std::string_view text) {
  std::vector<std::string> found;
  const std::vector<std::string> words = words_of(text);
  const auto rows = rows_of(type);
  if (!rows) return found;
  for (const WordList::Member row : *rows) {
    const std::string_view phrase = phrase_said(row.value, words);
    const bool known = std::ranges::any_of(found, [&](const std::string& one) { return says(words_of(one), phrase); });
    if (!phrase.empty() && !known && changes_more_than_size(row.value)) found.emplace_back(phrase);
  }
  return found;
}

bool has_two_leaves(const Opening& opening) {
  const OpeningLook look = look_of(opening);
  return look.leaves == 2 || (look.leaves == 0 && opening.width > kWidestLeaf);
}

}  // namespace layoutbox
