#include "layoutbox/plan/passes/ban_places.h"

#include <algorithm>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"

namespace layoutbox::offline {

std::optional<PlaceSaid> BanPlaces::place_at(std::size_t i) const {
  i = past(i, WordSet::kPlaceArticles);
  if (lexicon_.find(tokens_, i, WordClass::kWindow).length > 0 || is(i, {"windows"})) return opening("window", i);
  if (lexicon_.find(tokens_, i, WordClass::kDoor).length > 0 || is(i, {"doors"})) return opening("door", i);
  if (is(i, {"center", "middle"})) return middle(i);
  const Match side = lexicon_.find(tokens_, i, WordClass::kWallWord);
  const Meaning* word = meaning_of(side, WordClass::kWallWord);
  if (word == nullptr || word->word.find(' ') != std::string_view::npos) return std::nullopt;
  const std::size_t at = i + side.length + (is(i + side.length, {"hand"}) ? 1 : 0);
  PlaceSaid place;
  place.last = at + 1;
  if (is(at, {"wall"})) {
    place.ban.kind = Ban::Kind::kFreeWall;
    place.ban.of = word->word;
    return place;
  }
  const auto region = region_from_words(word->word);
  if (!is(at, {"half", "third", "side", "part"}) || !region) return std::nullopt;
  place.ban.region = *region;
  if (!is(place.last, {"of"}) || !is(place.last + 1, {"the"})) return place;
  if (!is(place.last + 2, {"room", "floor"})) return std::nullopt;  // "the left side of the bed"
  place.last += 3;
  return place;
}

std::optional<PlaceSaid> BanPlaces::middle(std::size_t i) const {
  PlaceSaid place;
  place.last = i + 1;
  if (!is(i + 1, {"of"}) || !is(i + 2, {"the", "my", "our"})) return place;
  const std::size_t length = is(i + 3, {"room", "floor", "space"}) ? 1 : lexicon_.find(tokens_, i + 3, WordClass::kRoom).length;
  if (length == 0) return std::nullopt;  // "the middle of the table"
  place.last = i + 3 + length;
  return place;
}

std::optional<PlaceSaid> BanPlaces::opening(std::string_view type, std::size_t i) const {
  PlaceSaid place;
  place.ban.kind = Ban::Kind::kFreeOpening;
  place.ban.of = type;
  const WordClass word = type == "door" ? WordClass::kDoor : WordClass::kWindow;
  place.last = i + std::max<std::size_t>(1, lexicon_.find(tokens_, i, word).length);
  return place;
}

std::vector<Side> BanPlaces::sides_at(std::size_t& i) const {
  i = past(i, WordSet::kSideArticles);
  std::vector<Side> sides;
  if (is(i, {"left"})) sides = {Side::kLeft};
  if (is(i, {"right"})) sides = {Side::kRight};
  if (is(i, {"both", "either"}) || is(i, {"each"})) sides = {Side::kLeft, Side::kRight};
  if (is(i, {"all", "every"})) sides = {Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
  if (is(i, {"three"})) sides = {Side::kFront, Side::kLeft, Side::kRight};
  if (sides.empty()) return sides;
  ++i;
  if (is(i, {"-"})) ++i;
  if (is(i, {"hand"})) ++i;
  if (!is(i, {"side", "sides"})) return {};
  ++i;
  return sides;
}

}  // namespace layoutbox::offline
