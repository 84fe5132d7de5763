#include "layoutbox/furnish/decor_style.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "layoutbox/base/words.h"
#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/prompt_words.h"

namespace layoutbox {

std::string lower_case(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr std::size_t kLongestPhrase = 4;  // words of a style

// All styles by their phrases ("art_deco").
const std::map<std::string, RoomStyle, std::less<>>& styles() {
  static const auto all = [] {
    std::map<std::string, RoomStyle, std::less<>> by_phrase;
    for (const auto& [phrases, style] : decor_data().at("styles").items()) {
      const std::string first = phrases.substr(0, phrases.find(' '));
      for (std::size_t at = 0; at < phrases.size();) {
        const std::size_t end = std::min(phrases.find(' ', at), phrases.size());
        by_phrase.emplace(phrases.substr(at, end - at), RoomStyle{style.value("like", first), &style});
        at = end + 1;
      }
    }
    return by_phrase;
  }();
  return all;
}

std::string joined(const Words& words, std::size_t from, std::size_t count, char by) {
  std::string all;
  for (std::size_t i = from; i < std::min(from + count, words.size()); ++i) all += (all.empty() ? "" : std::string(1, by)) + words[i];
  return all;
}

// "Loft bed": how many words from `at` on are a thing's name, though some of them name a style.
std::size_t name_of_thing(const Words& words, std::size_t at) {
  for (const json& name : decor_data().at("no_styles")) {
    if (!name.get_ref<const std::string&>().starts_with(words[at])) continue;
    const Words phrase = words_of(name.get<std::string>());
    const bool here =
        at + phrase.size() <= words.size() && std::equal(phrase.begin(), phrase.end(), words.begin() + static_cast<std::ptrdiff_t>(at));
    if (here) return phrase.size();
  }
  return 0;
}

// Whether a thing's own name follows, before any sign: "a Moroccan brass lantern".
bool is_of_thing(const Words& words, std::size_t after, std::span<const std::string> things) {
  constexpr std::size_t kReach = 3;  // words
  for (std::size_t i = after; i < std::min(words.size(), after + kReach); ++i) {
    if (is_sign(words[i]) || is_room_word(words[i]) || words[i] == "style" || words[i] == "and" || words[i] == "with") return false;
    if (std::ranges::find(things, singular_of(words[i])) != things.end()) return true;
  }
  return false;
}

// "A sofa from the 1930s", "a poster of dinosaurs": whether a thing is named just before.
bool is_after_thing(const Words& words, std::size_t at, std::span<const std::string> things) {
  bool joined = false;
  for (; at > 0 && is_in_list("joins_style_to_thing", words[at - 1]); --at) joined = joined || words[at - 1] != "the";
  return joined && at > 0 && std::ranges::find(things, singular_of(words[at - 1])) != things.end();
}

// "'50s", "1950’s": as decor.json has them.
Words with_plain_apostrophes(Words words) {
  for (std::string& word : words) {
    for (std::size_t at = word.find("’"); at != std::string::npos; at = word.find("’")) word.replace(at, std::string_view("’").size(), "'");
    if (std::ranges::any_of(word, [](unsigned char c) { return std::isdigit(c) != 0; })) std::erase(word, '\'');
  }
  return words;
}

// "1890s", or "1890" where it is no measure; 0 for all else.
int year_at(const Words& words, std::size_t at) {
  const json& eras = decor_data().at("eras");
  const std::string& word = words[at];
  const bool plural = word.ends_with('s');
  const bool digits = word.size() == (plural ? 5U : 4U) && word.find_first_not_of("0123456789") >= 4U;
  if (!digits) return 0;
  const std::string next = at + 1 < words.size() ? words[at + 1] : "";
  const bool measure = lists(eras.at("not_before").get_ref<const std::string&>(), next);
  const bool dated = is_room_word(next) || (at > 0 && lists(eras.at("after").get_ref<const std::string&>(), words[at - 1]));
  return plural || (dated && !measure) ? std::stoi(word) : 0;
}

// The style of the year that is named there.
const RoomStyle* era_at(const Words& words, std::size_t at) {
  const int year = year_at(words, at);
  for (const json& era : decor_data().at("eras").at("of")) {
    if (year >= era.at("from").get<int>() && year <= era.at("until").get<int>()) return &styles().at(era.at("style").get<std::string>());
  }
  return nullptr;
}

// "make it dark": where no style is named, what the room is to feel like.
RoomStyle mood_of(std::string_view text) {
  const std::string lower = lower_case(text) + ".";  // phrases may end a sentence
  for (const auto& [name, mood] : decor_data().at("moods").items()) {
    const bool said = std::ranges::any_of(mood.at("says"),
                                          [&](const json& phrase) { return lower.find(phrase.get<std::string>()) != std::string::npos; });
    if (said) return {name, &mood};
  }
  return {};
}

// What a room is like that is not to be of that style.
RoomStyle instead_of(const std::string& unwanted) {
  for (const auto& [names, other] : decor_data().at("instead_of_styles").items()) {
    if (lists(names, unwanted)) return styles().at(other.get<std::string>());
  }
  return {};
}

// The styles that a text names, as it goes.
class StyleReader {
 public:
  StyleReader(std::string_view text, std::span<const std::string> things)
      : words_(with_plain_apostrophes(words_and_signs(text))), things_(things) {}

  RoomStyle read() {
    for (std::size_t at = 0; at < words_.size();) at += std::max<std::size_t>(1, read_at(at));
    if (wanted_.data == nullptr) wanted_ = weak_;
    return wanted_.data == nullptr && !unwanted_.empty() ? instead_of(unwanted_) : wanted_;
  }

 private:
  // How many words were a style's.
  std::size_t read_at(std::size_t at) {
    if (const std::size_t passed = name_of_thing(words_, at); passed > 0) return passed;
    for (std::size_t n = std::min(kLongestPhrase, words_.size() - at); n > 0; --n) {
      std::string phrase = joined(words_, at, n, '_');
      if (!styles().contains(phrase) && phrase.ends_with("'s")) phrase.resize(phrase.size() - 2);  // "a detective's office"
      const auto found = styles().find(phrase);
      const bool of_people = at > 0 && is_in_list("not_styles_after", words_[at - 1]);  // "in their 60s"
      if (found == styles().end() || of_people) continue;
      take(found->second, at, n);
      return n;
    }
    const RoomStyle* era = era_at(words_, at);
    if (era != nullptr) take(*era, at, 1);
    return era != nullptr ? 1 : 0;
  }

  void take(const RoomStyle& style, std::size_t at, std::size_t length) {
    if (is_banned_at(words_, at)) {
      unwanted_ = style.name;
      return;
    }
    // Said of two things, it is how the room is meant.
    const bool of_thing = is_of_thing(words_, at + length, things_) || is_after_thing(words_, at, things_);
    if (of_thing && (of_things_.insert(style.data).second || style.data->value("of_rooms", false))) return;
    RoomStyle& taken = style.data->value("weak", false) ? weak_ : wanted_;
    if (taken.data == nullptr) taken = style;
  }

  Words words_;
  std::span<const std::string> things_;
  RoomStyle wanted_, weak_;
  std::string unwanted_;
  std::set<const json*> of_things_;
};

}  // namespace

json in_plain_room(json style, bool wet) {
  const json changes = style.value("plain", json::object());
  style.merge_patch(changes);
  if (!wet && style.contains("dry_floors")) style["floors"] = style.at("dry_floors");
  return style;
}

RoomStyle style_of(std::string_view text, std::span<const std::string> things) {
  const RoomStyle style = StyleReader(text, things).read();
  return style.data == nullptr ? mood_of(text) : style;
}

}  // namespace layoutbox
