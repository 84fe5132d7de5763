#include "layoutbox/furnish/room_look.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/palette.h"
#include "layoutbox/furnish/prompt_words.h"
#include "layoutbox/furnish/room_colors.h"

namespace layoutbox {
namespace {

using Words = std::vector<std::string>;

// "Dark blue and oak": a row of looks from `at` on.
struct LookRun {
  std::vector<SurfaceWish> looks;
  std::size_t end = 0;
};

LookRun run_at(const Words& words, std::size_t at) {
  LookRun run{{}, at};
  std::string said;
  std::size_t ends_before_last = at;
  const auto close = [&](std::size_t end) {
    if (said.empty()) return;
    ends_before_last = run.end;
    run.looks.push_back(read_wish(said));
    run.end = end;
    said.clear();
  };
  std::size_t i = at;
  for (; i < words.size(); ++i) {
    if (is_look_word(words[i])) {
      said += (said.empty() ? "" : " ") + words[i];
    } else if (words[i] == "and" || words[i] == "&" || words[i] == "or" ||
               (words[i] == "," && i + 1 < words.size() && is_look_word(words[i + 1]))) {
      close(i);
      if (run.looks.empty()) break;
    } else {
      break;
    }
  }
  close(i);
  // "Everything white and brass taps": the last one is the taps'.
  const bool of_thing = i < words.size() && !is_sign(words[i]) && !is_in_list("after_looks", words[i]) && !is_room_word(words[i]);
  if (of_thing && run.end == i && !run.looks.empty()) {
    run.looks.pop_back();
    run.end = ends_before_last;
  }
  std::erase_if(run.looks, [](const SurfaceWish& wish) { return !wish.color && wish.materials.empty(); });
  return run;
}

void take(RoomLook& look, const LookRun& run) {
  for (const SurfaceWish& wish : run.looks) {
    const auto wood = std::ranges::find(wish.materials, "wood", &NamedSurface::kind);
    if (wood != wish.materials.end()) {
      look.woods.push_back((*wood)->surface.name);
    } else if (wish.color) {
      look.colors.push_back(*wish.color);
    } else if (const auto metal = std::ranges::find(wish.materials, "metal", &NamedSurface::kind); metal != wish.materials.end()) {
      look.metal = (*metal)->surface.name;
    }
  }
}

class RoomLookReader {
 public:
  explicit RoomLookReader(std::string_view prompt) : words_(words_and_signs(prompt)) {}

  RoomLook read() {
    take_bans();
    ColorScheme scheme = room_scheme(text());
    look_.colors = std::move(scheme.colors);
    look_.woods = std::move(scheme.woods);
    look_.metal = std::move(scheme.metal);
    const bool colors_said = !look_.colors.empty();
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (is_in_list("all_words", words_[i])) read_at_all(i, colors_said);
      if (words_[i] == "in" && (is_of_room(i) || (i > 0 && is_in_list("in_after", words_[i - 1])))) read_run(i + 1, colors_said);
      if (words_[i] == "of" && i > 0 && is_in_list("shade_words", words_[i - 1])) read_run(i + 1, colors_said);
    }
    return std::move(look_);
  }

 private:
  std::string text() const {
    std::string all;
    for (const std::string& word : words_) all += (all.empty() || is_sign(word) ? "" : " ") + word;
    return all;
  }

  // "Nothing beige", "no grey please", "nothing is black": what is left is what is wanted.
  void take_bans() {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (!is_in_list("ban_words", words_[i])) continue;
      std::size_t at = i + 1;
      while (at < words_.size() && is_in_list("passed_before_looks", words_[at])) ++at;
      const LookRun run = run_at(words_, at);
      if (run.looks.empty()) continue;
      for (const SurfaceWish& wish : run.looks) {
        if (wish.color) look_.unwanted.push_back(*wish.color);
        for (const NamedSurface* stuff : wish.materials) look_.unwanted_stuffs.push_back(stuff->surface.name);
      }
      words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(i), words_.begin() + static_cast<std::ptrdiff_t>(run.end));
    }
  }

  // "In pink and gold" of a room: nothing that it would have is named before, in the first sentence.
  bool is_of_room(std::size_t at) const {
    constexpr std::size_t kOpening = 8;  // words
    if (at == 0 || at > kOpening) return false;
    return std::none_of(words_.begin(), words_.begin() + static_cast<std::ptrdiff_t>(at),
                        [](const std::string& word) { return is_sign(word) || word == "with" || word == "has" || word == "have"; });
  }

  void read_run(std::size_t at, bool colors_said) { add(run_at(words_, at), colors_said); }

  // Once each: "all in oak" is found by "all" and by "in".
  void add(const LookRun& run, bool colors_said) {
    RoomLook said;
    take(said, run);
    for (const std::string& wood : said.woods) {
      if (std::ranges::find(look_.woods, wood) == look_.woods.end()) look_.woods.push_back(wood);
    }
    if (look_.metal.empty()) look_.metal = said.metal;
    for (const Color& color : said.colors) {
      if (!colors_said && std::ranges::find(look_.colors, color) == look_.colors.end()) look_.colors.push_back(color);
    }
  }

  // "Everything in the study is …", "the furniture should be …": where the look begins; the end of the text where there is none.
  std::size_t after_is(std::size_t i) const {
    const auto from = words_.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const auto passed = [](const std::string& word) { return is_in_list("passed_before_looks", word) || is_room_word(word); };
    const auto found = std::find_if_not(from, words_.end(), [&](const std::string& word) { return passed(word) && !is_look_word(word); });
    return static_cast<std::size_t>(found - words_.begin());
  }

  // "All in dark blue and oak", "everything in the study is mahogany", "pale wood throughout", "black everything".
  void read_at_all(std::size_t i, bool colors_said) {
    const bool before = i > 0 && is_look_word(words_[i - 1]);
    std::size_t from = i;
    while (before && from > 0 && (is_look_word(words_[from - 1]) || words_[from - 1] == "and")) --from;
    if (before && words_[from] == "and") ++from;
    if (!before) {
      from = i + 1;
      if (words_[i] != "all") from = after_is(i);
      if (from < words_.size() && words_[from] == "in") ++from;
    }
    LookRun run = run_at(words_, from);
    // "All white walls" is said of the walls.
    if (before) run = run_at(Words(words_.begin() + static_cast<std::ptrdiff_t>(from), words_.begin() + static_cast<std::ptrdiff_t>(i)), 0);
    if (run.looks.empty()) return;
    look_.all = true;
    add(run, colors_said);
  }

  Words words_;
  RoomLook look_;
};

}  // namespace

RoomLook room_look(std::string_view prompt) { return RoomLookReader(prompt).read(); }

bool is_much_like(const Color& a, const Color& b) {
  constexpr double kAlike = 0.2;
  return std::hypot(a.r - b.r, a.g - b.g, a.b - b.b) < kAlike;
}

}  // namespace layoutbox
