#include "layoutbox/furnish/prompt_words.h"

#include <cctype>
#include <nlohmann/json.hpp>

#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/palette.h"

namespace layoutbox {

std::vector<std::string> words_and_signs(std::string_view text) {
  std::vector<std::string> words;
  bool open = false;
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    if (std::isalnum(u) != 0 || u >= 128 || c == '\'') {
      if (!open) words.emplace_back();
      words.back() += static_cast<char>(std::tolower(u));
      open = true;
      continue;
    }
    open = false;
    if (std::string_view(",.;:!?\n").find(c) != std::string_view::npos) words.emplace_back(1, c == '\n' ? '.' : c);
  }
  return words;
}

bool is_sign(std::string_view word) { return word.size() == 1 && std::ispunct(static_cast<unsigned char>(word[0])) != 0; }

bool is_in_list(const char* list, std::string_view word) {
  return !word.empty() && lists(decor_data().at(list).get_ref<const std::string&>(), word);
}

bool says_word(std::string_view text, std::string_view phrase) {
  const auto is_letter = [&](std::size_t at) { return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0; };
  for (std::size_t at = text.find(phrase); at != std::string_view::npos; at = text.find(phrase, at + 1)) {
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + phrase.size())) return true;
  }
  return false;
}

bool is_room_word(std::string_view word) { return word.ends_with("room") || is_in_list("room_words", word); }

bool is_banned_at(const std::vector<std::string>& words, std::size_t at) {
  constexpr std::size_t kReach = 5;  // words back
  bool over_another = false;         // "no grey or modern …" reaches over grey, "no grey chairs, modern …" not over chairs
  for (std::size_t back = 1; back <= kReach && back <= at; ++back) {
    const std::string& word = words[at - back];
    if (is_in_list("ban_words", word)) return true;
    const bool joins = word == "or" || word == "nor" || (word == "and" && back == 1);
    over_another = over_another || joins;
    const bool passed = is_in_list("passed_before_looks", word) && !is_room_word(word);
    if (!joins && !passed && !(over_another && is_look_word(word))) return false;
  }
  return false;
}

}  // namespace layoutbox
