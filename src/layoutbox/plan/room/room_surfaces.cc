// What walls, floor and ceiling are made of and painted with.
#include <algorithm>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/room/room_reader_parts.h"

namespace layoutbox::offline {

namespace {

bool is_shade(const std::string& word) {
  for (const WordList::Member shade : word_list("words_room").at("shades")) {
    if (shade.value.text() == word) return true;
  }
  return false;
}

// The materials and colours that a wall or a floor is said to have: "dark green", "exposed brick", "stone" of "a stone floor".
std::string finish_of(const Lexicon& lexicon, const Document& document, const NounPhrase& noun) {
  std::string material;
  const auto add = [&](const std::string& words) { material += (material.empty() ? "" : " ") + words; };
  // "soft yellow": what changes the colour goes with it.
  const auto add_shade = [&] {
    for (std::size_t i = noun.first; i + 1 < noun.last && i + 1 < document.tokens.size(); ++i) {
      const std::string& word = document.tokens[i].text;
      if (is_shade(word) && lexicon.find(document.tokens, i, WordClass::kColor).length == 0) return add(word);
    }
  };
  for (std::size_t a = 0; a < noun.attributes.size() && a < noun.attribute_classes.size(); ++a) {
    const bool color = noun.attribute_classes[a] == WordClass::kColor;
    if (color && material.empty()) add_shade();
    if (color || noun.attribute_classes[a] == WordClass::kMaterial) add(noun.attributes[a]);
  }
  // "white stone walls": of stone as well
  const bool colored = !material.empty() && std::ranges::find(noun.attribute_classes, WordClass::kMaterial) == noun.attribute_classes.end();
  for (std::size_t i = noun.first; colored && i < noun.last && i < document.tokens.size(); ++i) {
    const std::size_t length = lexicon.find(document.tokens, i, WordClass::kMaterial).length;
    if (length > 0 && lexicon.find(document.tokens, i, WordClass::kColor).length == 0) add(text_of(document.tokens, i, i + length));
  }
  for (std::size_t i = noun.first; material.empty() && i < noun.last && i < document.tokens.size(); ++i) {
    const Match color = lexicon.find(document.tokens, i, WordClass::kColor), stuff = lexicon.find(document.tokens, i, WordClass::kMaterial);
    if (const std::size_t length = std::max(color.length, stuff.length); length > 0)
      add(text_of(document.tokens, i, std::min(i + length, noun.last)));
  }
  if (material.empty() && noun.kind == NounKind::kFloor) {
    if (noun.name.find("wood") != std::string::npos) material = "wood";  // "hardwood floor": a name of its own
    if (noun.name.find("tatami") != std::string::npos) material = "tatami";
  }
  const auto said = [&](std::string_view word) { return std::ranges::find(noun.attributes, word) != noun.attributes.end(); };
  if (material.empty() && noun.kind == NounKind::kWall) material = said("dark") ? "dark gray" : said("bright") ? "white" : "";
  return material;
}

// "Brick wall, dark green paint": of two that are said of no wall the one that is said of one wall is on the back wall.
void set_walls(Room& room, const std::string& material, bool all, bool& all_before) {
  if (!room.wall_material.empty() && room.wall_material != material && all != all_before) {
    room.wall_looks.emplace_back("back", all ? room.wall_material : material);
    if (all) room.wall_material = material;
  } else {
    room.wall_material = material;
  }
  all_before = all_before || all;
}

}  // namespace

int thing_before_wall(const Document& document, int wall) {
  const NounPhrase& noun = document.mentions[static_cast<std::size_t>(wall)].noun;
  if (noun.kind != NounKind::kWall || !says_one_of(document, noun.last, {"behind"})) return -1;
  const auto thing = std::ranges::find_if(document.mentions, [&](const Mention& m) {
    return m.noun.first == noun.last + 1 && m.noun.kind == NounKind::kObject && !m.items.empty();
  });
  return thing == document.mentions.end() ? -1 : static_cast<int>(thing - document.mentions.begin());
}

std::string single_wall(const Document& document, int wall, const Room& room) {
  const NounPhrase& noun = document.mentions[static_cast<std::size_t>(wall)].noun;
  if (!noun.wall_word.empty()) return noun.wall_word;
  const int thing = thing_before_wall(document, wall);
  if (const std::string own = thing >= 0 ? wall_of_thing(document, thing) : std::string{}; !own.empty()) return own;
  const bool one = noun.determiner == Determiner::kIndefinite || noun.count == 1 || says_one_of(document, noun.first, {"one"}) ||
                   noun.name.find("accent") != std::string::npos || noun.name.find("feature") != std::string::npos;
  if (noun.plural || noun.count > 1 || !noun.wall_relation.empty() || (!one && thing < 0)) return {};
  // Seen best, and with nothing let into it that the text speaks of.
  for (const std::string_view word : {"back", "left", "right"}) {
    if (std::ranges::none_of(room.openings, [&](const Opening& o) { return o.wall == word; })) return std::string(word);
  }
  return "back";
}

void set_surfaces(const Lexicon& lexicon, const Document& document, Room& room) {
  bool all_walls = false;
  for (std::size_t m = 0; m < document.mentions.size(); ++m) {
    const NounPhrase& noun = document.mentions[m].noun;
    if (noun.kind != NounKind::kFloor && noun.kind != NounKind::kWall && noun.kind != NounKind::kCeiling) continue;
    const std::string material = finish_of(lexicon, document, noun);
    if (material.empty()) continue;
    if (noun.name == kWallsAndFloor && room.floor_material.empty()) room.floor_material = material;
    if (noun.kind == NounKind::kCeiling)
      room.ceiling_material = material;
    else if (noun.kind == NounKind::kFloor)
      room.floor_material = material.find("floor") == std::string::npos ? material + " floor" : material;
    else if (const std::string wall = single_wall(document, static_cast<int>(m), room); !wall.empty())
      room.wall_looks.emplace_back(wall, material);
    else if (noun.wall_relation.empty())
      set_walls(room, material, noun.plural, all_walls);
  }
}

}  // namespace layoutbox::offline
