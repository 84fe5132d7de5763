#include "layoutbox/catalog/size_words.h"

#include <algorithm>
#include <array>

#include "layoutbox/base/words.h"

namespace layoutbox {
namespace {

// Words of size that hold for every kind of thing: which sides they speak of, and in which direction.
struct SizeWord {
  std::string_view word;
  bool width, depth, height, larger;
};
constexpr SizeWord kSizeWords[] = {
    {"large", true, true, true, true},    {"big", true, true, true, true},        {"huge", true, true, true, true},
    {"great", true, true, true, true},    {"massive", true, true, true, true},    {"giant", true, true, true, true},
    {"enormous", true, true, true, true}, {"broad", true, true, false, true},     {"oversized", true, true, true, true},
    {"small", true, true, true, false},   {"little", true, true, true, false},    {"tiny", true, true, true, false},
    {"mini", true, true, true, false},    {"compact", true, true, true, false},   {"wide", true, false, false, true},
    {"long", true, false, false, true},   {"narrow", true, false, false, false},  {"slim", false, true, false, false},
    {"deep", false, true, false, true},   {"shallow", false, true, false, false}, {"tall", false, false, true, true},
    {"high", false, false, true, true},   {"low", false, false, true, false},
};

struct RoomWord {
  std::string_view word;
  double factor;
};
constexpr RoomWord kRoomWords[] = {
    {"tiny", 0.65}, {"small", 0.8},    {"compact", 0.8}, {"cosy", 0.85}, {"cozy", 0.85}, {"narrow", 0.85}, {"medium", 1.0},
    {"large", 1.3}, {"spacious", 1.3}, {"big", 1.3},     {"huge", 1.6},  {"vast", 1.8},  {"open", 1.2},
};

}  // namespace

bool says(const std::vector<std::string>& said, std::string_view phrase) {
  const std::vector<std::string> words = words_of(phrase);
  return !words.empty() && std::search(said.begin(), said.end(), words.begin(), words.end()) != said.end();
}

std::vector<std::string> words_said_of(const SceneObject& object) {
  std::vector<std::string> words;
  for (const std::string& attribute : object.attributes) std::ranges::copy(words_of(attribute), std::back_inserter(words));
  std::ranges::copy(words_of(object.name), std::back_inserter(words));
  std::ranges::copy(words_of(object.category), std::back_inserter(words));
  return words;
}

SizeRange size_by_words(const CatalogEntry& entry, const std::vector<std::string>& said) {
  for (const SizeVariant& variant : entry.variants) {
    if (std::ranges::any_of(variant.words, [&](const std::string& word) { return says(said, word); })) return variant.size;
  }
  SizeRange range = entry.size;
  // Neither as small nor as large as such things can be: the medium one of three.
  if (says(said, "medium") || says(said, "medium-sized") || says(said, "mid-sized")) {
    for (const auto side : kSizeSides) {
      range.least.*side = (range.least.*side + range.usual.*side) / 2 / kGridMm * kGridMm;
      range.greatest.*side = (range.greatest.*side + range.usual.*side) / 2 / kGridMm * kGridMm;
    }
    return range;
  }
  for (const SizeWord& rule : kSizeWords) {
    if (!says(said, rule.word)) continue;
    const bool applies[] = {rule.width, rule.depth, rule.height};
    for (std::size_t i = 0; i < kSizeSides.size(); ++i) {
      const auto side = kSizeSides[i];
      if (!applies[i]) continue;
      const Mm end = rule.larger ? range.greatest.*side : range.least.*side;
      const Mm middle = range.usual.*side + (end - range.usual.*side) * 2 / 3;
      Size& other_end = rule.larger ? range.least : range.greatest;
      other_end.*side = range.usual.*side;
      range.usual.*side = std::clamp(middle / kGridMm * kGridMm, range.least.*side, range.greatest.*side);
    }
    break;
  }
  return range;
}

bool is_size_word(std::string_view word) {
  return std::ranges::any_of(kSizeWords, [&](const SizeWord& rule) { return rule.word == word; });
}

double room_size_factor(std::string_view word) {
  const auto* found = std::ranges::find_if(kRoomWords, [&](const RoomWord& rule) { return same_name(word, rule.word); });
  return found == std::end(kRoomWords) ? 1.0 : found->factor;
}

}  // namespace layoutbox
