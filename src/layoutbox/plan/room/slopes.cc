#include "layoutbox/plan/room/slopes.h"

#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/token_reader.h"
#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

constexpr std::size_t kSides = 9;  // tokens after the slope in which its side is said
constexpr std::size_t kMostSlopes = 4;
constexpr const char* kSlope = "sloped_ceiling";

class SlopeWords : public TokenReader {
 public:
  using TokenReader::TokenReader;

  void run() {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      read_verb(i);
      read_slope(i);
    }
  }

 private:
  // "The ceiling slopes down on both sides", "the roof comes down low": a sloped ceiling is there.
  void read_verb(std::size_t i) {
    if (!is(i, {"ceiling", "ceilings", "roof", "walls"})) return;
    std::size_t verb = i + 1;
    while (is(verb, {"is", "are", "also", "really", "gently", "that", "which"})) ++verb;
    const bool slopes = is(verb, {"slopes", "slope", "slants", "slant", "sloping", "sloped", "slanted", "slanting"});
    const bool comes = is(verb, {"comes", "come", "drops", "goes"}) && is(verb + 1, {"down"}) && !is(i, {"walls"});
    if (!slopes && !comes) return;
    std::size_t last = verb + 1;
    while (is(last, {"down", "downward", "downwards", "low", "steeply", "away"})) ++last;
    if (i > 0 && is_article(i - 1)) tokens_[i - 1].text = "a";
    tokens_[i].text = "sloped";
    tokens_[i + 1].text = "ceiling";
    tokens_[i + 1].ends_sentence = tokens_[last - 1].ends_sentence;
    if (last > i + 2) leave_out(i + 2, last);
  }

  // "under the slope", "under the roof": the sloped ceiling.
  void read_slope(std::size_t i) {
    if (!is(i, {"under", "beneath", "below", "underneath", "against"}) || !is(i + 1, {"the", "a"})) return;
    std::size_t at = i + 2;
    if (is(at, {"low", "lower", "steep"})) ++at;
    if (!is(at, {"slope", "slant", "roof", "rafters", "slopes", "pitch", "eave"}) || (is(at, {"roof"}) && is(i, {"against"}))) return;
    tokens_[at].text = "eaves";
  }
};

class SlopeSettler {
 public:
  SlopeSettler(const Lexicon& lexicon, const Document& document, SceneGraph& scene)
      : lexicon_(lexicon), document_(document), scene_(scene) {}

  void run() {
    if (wanted_flat()) return;
    add_under_roof();
    const std::vector<std::string> walls = walls_said();
    keep(std::max<std::size_t>(walls.size(), 1), walls);
    drop_places();
    let_in_windows();
  }

 private:
  bool is_slope(const SceneObject& object) const { return object.category == kSlope; }
  bool any() const {
    return std::ranges::any_of(scene_.objects, [&](const SceneObject& o) { return is_slope(o); });
  }
  bool is(std::size_t i, std::initializer_list<std::string_view> words) const { return says_one_of(document_, i, words); }

  bool wanted_flat() const {
    return std::ranges::any_of(document_.excluded, [](const NounPhrase& noun) { return noun.category == kSlope; });
  }

  // "an attic room", "a mansard": its ceiling comes down on two sides, though nobody says so.
  void add_under_roof() {
    if (any() || scene_.room.shape == "round") return;
    for (std::size_t i = 0; i < document_.tokens.size(); ++i) {
      for (const WordList::Member words : word_list("words_room").at("under_roof")) {
        if (!stands_at(i, words.value.text())) continue;
        for (int n = 0; n < 2; ++n) add(Origin::kAssumed);
        scene_.notes.push_back({"filled", "the ceiling of a room under the roof comes down on two sides", "prompt"});
        return;
      }
    }
  }

  bool stands_at(std::size_t i, std::string_view words) const {
    while (!words.empty()) {
      const std::string_view word = words.substr(0, words.find(' '));
      if (i >= document_.tokens.size() || document_.tokens[i++].text != word) return false;
      words.remove_prefix(std::min(words.size(), word.size() + 1));
    }
    return true;
  }

  void add(Origin origin) {
    SceneObject slope;
    slope.category = kSlope;
    slope.name = "sloped ceiling";
    slope.origin = origin;
    for (int n = 1; slope.id.empty() || scene_.find_object(slope.id) != nullptr; ++n)
      slope.id = kSlope + std::string("_") + std::to_string(n);
    scene_.objects.push_back(std::move(slope));
  }

  // Where the text says that the ceiling comes down.
  std::vector<std::string> walls_said() const {
    std::vector<std::string> walls;
    bool plural = false;
    const auto put = [&](const std::string& wall) {
      if (!wall.empty() && std::ranges::find(walls, wall) == walls.end()) walls.push_back(wall);
    };
    for (std::size_t i = 0; i < document_.tokens.size(); ++i) {
      const Match match = lexicon_.find(document_.tokens, i);
      const Meaning* thing = meaning_of(match, WordClass::kObject);
      if (match.length == 0 || thing == nullptr || thing->entry == nullptr || thing->entry->id != kSlope) continue;
      plural |= match.plural || is(i + match.length - 1, {"eaves"});
      for (std::size_t at = i + match.length; at < i + match.length + kSides && at < document_.tokens.size(); ++at) {
        if (document_.tokens[at - 1].ends_sentence || has(lexicon_.find(document_.tokens, at), WordClass::kObject)) break;
        if (is(at, {"both", "either", "two", "each"}) && is(at + 1, {"side", "sides", "end", "ends", "walls"})) put("left"), put("right");
        const Match word = lexicon_.find(document_.tokens, at, WordClass::kWallWord);
        if (const Meaning* wall = word.length > 0 ? meaning_of(word, WordClass::kWallWord) : nullptr) put(first_word(wall->word));
      }
    }
    const auto slopes = std::ranges::count_if(scene_.objects, [&](const SceneObject& o) { return is_slope(o); });
    if (walls.empty() && slopes > 1 && plural) return {"left", "right"};
    if (walls.empty() && slopes > 1 &&
        std::ranges::any_of(scene_.objects, [&](const SceneObject& o) { return is_slope(o) && o.origin == Origin::kAssumed; }))
      return {"left", "right"};
    if (walls.empty() && slopes > 0) return {free_wall()};
    return walls;
  }

  static std::string first_word(std::string_view words) { return std::string(words.substr(0, words.find(' '))); }

  // Seen best, and nothing is let into it that the text speaks of.
  std::string free_wall() const {
    for (const std::string_view word : {"back", "left", "right"}) {
      if (std::ranges::none_of(scene_.room.openings, [&](const Opening& opening) { return opening.wall == word; }))
        return std::string(word);
    }
    return "back";
  }

  static double turn_of(const std::string& wall) { return wall == "left" ? 90 : wall == "front" ? 180 : wall == "right" ? 270 : 0; }

  // As many slopes as walls; what is said of one that there is not any more is said of the first.
  void keep(std::size_t count, const std::vector<std::string>& walls) {
    if (!any() || walls.empty()) return;
    count = std::min(count, kMostSlopes);
    std::vector<std::string> ids;
    while (static_cast<std::size_t>(std::ranges::count_if(scene_.objects, [&](const SceneObject& o) { return is_slope(o); })) < count)
      add(Origin::kConcluded);
    for (SceneObject& object : scene_.objects) {
      if (!is_slope(object)) continue;
      if (ids.size() < count) object.hint.rotation_deg = turn_of(walls[ids.size()]);
      ids.push_back(object.id);
    }
    const std::vector<std::string> gone(ids.begin() + static_cast<std::ptrdiff_t>(std::min(count, ids.size())), ids.end());
    const auto is_gone = [&](const std::string& id) { return std::ranges::find(gone, id) != gone.end(); };
    std::erase_if(scene_.objects, [&](const SceneObject& object) { return is_gone(object.id); });
    for (Relation& relation : scene_.relations) {
      std::erase_if(relation.targets, is_gone);
      std::erase_if(relation.references, is_gone);
      if (relation.references.empty() && relation.type == R::kUnder) relation.references = {ids.front()};
    }
  }

  // A slope is where it is: what it hangs over is under it, and nothing else is said of it.
  void drop_places() {
    const auto names_slope = [&](const std::vector<std::string>& ids) {
      return std::ranges::any_of(ids, [&](const std::string& id) {
        const SceneObject* object = scene_.find_object(id);
        return object != nullptr && is_slope(*object);
      });
    };
    for (Relation& relation : scene_.relations) {
      if (relation.type == R::kAbove && names_slope(relation.targets)) {
        std::swap(relation.targets, relation.references);
        relation.type = R::kUnder;
      }
      // "beds under the slopes": each is under one of them, whichever.
      if (relation.type == R::kUnder && names_slope(relation.references)) relation.references.resize(1);
    }
    std::erase_if(scene_.relations, [&](const Relation& relation) {
      const bool under = relation.type == R::kUnder || relation.type == R::kNotBlocking;
      return relation.targets.empty() || names_slope(relation.targets) || (names_slope(relation.references) && !under);
    });
  }

  // A skylight of a room under the roof is in its slope.
  void let_in_windows() {
    const auto slope = std::ranges::find_if(scene_.objects, [&](const SceneObject& object) { return is_slope(object); });
    if (slope == scene_.objects.end()) return;
    const std::string host = slope->id;
    for (SceneObject& object : scene_.objects) {
      if (object.category != "skylight" && object.category != "slope_window") continue;
      object.category = "slope_window";
      std::erase_if(scene_.relations, [&](const Relation& r) { return std::ranges::find(r.targets, object.id) != r.targets.end(); });
      Relation in;
      in.type = R::kIn;
      in.id = "slope of " + object.id;
      in.targets = {object.id};
      in.references = {host};
      in.origin = Origin::kConcluded;
      in.why = "roof windows are in the slope";
      scene_.relations.push_back(std::move(in));
    }
  }

  const Lexicon& lexicon_;
  const Document& document_;
  SceneGraph& scene_;
};

}  // namespace

void read_slopes(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { SlopeWords(lexicon, document.tokens, skip).run(); }

void settle_slopes(const Lexicon& lexicon, const Document& document, SceneGraph& scene) { SlopeSettler(lexicon, document, scene).run(); }

}  // namespace layoutbox::offline
