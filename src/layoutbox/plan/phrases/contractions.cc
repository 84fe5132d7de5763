// "the bin's under the sink": which 's is short for "is".
#include <algorithm>

#include "layoutbox/plan/words/tokens.h"

namespace layoutbox::offline {
namespace {

// "the bin's under the sink": before where something is, 's is no possessive. But "the bed's near side", "mum's in-tray".
bool says_where(const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::string_view kPlain[] = {"under", "underneath", "beneath", "against",  "beside", "behind",
                                                "above", "below",      "between", "opposite", "inside", "along"};
  static constexpr std::string_view kWhere[] = {"near", "in", "on", "at", "by", "just", "right", "next", "to"};
  const std::string& word = tokens[at].text;
  if (at + 1 >= tokens.size()) return false;
  const Token& next = tokens[at + 1];
  // "the bed's flanked by two lamps", "the sofa's pushed against the wall"
  static constexpr std::string_view kBehind[] = {"by", "with", "against", "under", "into", "between", "behind", "beside", "beneath"};
  if (word.ends_with("ed") && std::find(std::begin(kBehind), std::end(kBehind), next.text) != std::end(kBehind)) return true;
  if (std::find(std::begin(kPlain), std::end(kPlain), word) != std::end(kPlain)) return !next.glued;
  if (std::find(std::begin(kWhere), std::end(kWhere), word) == std::end(kWhere)) return false;
  static constexpr std::string_view kAfter[] = {"the", "a", "an", "my", "our", "his", "her", "their", "its", "it", "that", "this"};
  const bool place = std::find(std::begin(kAfter), std::end(kAfter), next.text) != std::end(kAfter);
  const bool two_words = (word == "next" && next.text == "to") || ((word == "right" || word == "just") && says_where(tokens, at + 1));
  return !next.glued && (two_words || (place && word != "next" && word != "right" && word != "just"));
}

}  // namespace

void part_contractions(std::vector<Token>& tokens) {
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    static constexpr std::string_view kNobodys[] = {"there", "here", "it", "that", "what", "where", "he", "she"};
    const bool owned = std::find(std::begin(kNobodys), std::end(kNobodys), tokens[i - 1].text) == std::end(kNobodys);
    if (tokens[i].text == "'s" && (!owned || says_where(tokens, i + 1))) tokens[i].text = "is";
  }
}

}  // namespace layoutbox::offline
