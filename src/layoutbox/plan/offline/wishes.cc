#include "layoutbox/plan/offline/wishes.h"

#include <algorithm>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/furnisher.h"
#include "layoutbox/plan/room/kitchen_wall.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

// "a spot to brew beer", "somewhere to rehearse with my quartet": all that is named belongs to what one does there.
bool only_says_what_for(const Lexicon& lexicon, const Document& document) {
  static constexpr std::string_view kFor[] = {"to", "where", "for"};
  constexpr std::size_t kOpening = 6;
  const auto is_any = [&](std::size_t i, const auto& words) {
    return std::find(std::begin(words), std::end(words), document.tokens[i].text) != std::end(words);
  };
  std::size_t at = 0;
  while (at < std::min(kOpening, document.tokens.size()) && !is_any(at, kFor)) ++at;
  if (at == 0 || at >= std::min(kOpening, document.tokens.size())) return false;
  bool opens = false, suggested = false;
  for (std::size_t i = 0; i < at; ++i) opens |= one_of(document.tokens[i].text, WordSet::kSomewhere);
  for (std::size_t i = at; i < document.tokens.size(); ++i) suggested |= lexicon.room_suggested(document.tokens, i).second > 0;
  // "a room for sleep. The bed is near the door", "a room for my grandfather: recliner, TV": what is said after it is asked for.
  static constexpr std::string_view kAfter[] = {":", ",", "with", "-", "(", "including"};
  std::size_t end = at;
  while (end < document.tokens.size() && !document.tokens[end].ends_sentence && !is_any(end, kAfter)) ++end;
  return opens && suggested && std::all_of(document.items.begin(), document.items.end(), [&](const TextItem& item) {
           return item.noun.first > at && item.noun.first <= end && item.noun.determiner != Determiner::kIndefinite && item.noun.count == 0;
         });
}

// The kitchen that came with the room, from object `first` on, stands at the wall that it is said to be at.
void place_kitchen(const Lexicon& lexicon, const Document& document, SceneGraph& scene, std::size_t first) {
  const std::string wall = wall_of_kitchen(document);
  for (std::size_t i = first; i < scene.objects.size() && !wall.empty(); ++i) {
    const CatalogEntry* entry = lexicon.catalog().find(scene.objects[i].category);
    if (entry == nullptr || !entry->back_to_wall) continue;
    Relation at;
    at.id = "kitchen_" + std::to_string(i);
    at.type = RelationType::kAgainstWall;
    at.targets = {scene.objects[i].id};
    at.references = {wall};
    at.hard = false;
    at.origin = Origin::kConcluded;
    at.why = "the kitchen is at that wall";
    scene.relations.push_back(std::move(at));
  }
}

// "a bedroom without furniture": it stays empty, unless the text asks to furnish it.
bool wants_no_furniture(const Document& document) {
  const std::vector<std::string>& furnish = Groups::builtin().to_furnish;
  const auto asks = [&](const Token& token) { return std::ranges::find(furnish, token.text) != furnish.end(); };
  if (std::ranges::any_of(document.tokens, asks)) return false;
  return std::ranges::any_of(document.tokens, [](const Token& token) { return token.text == "unfurnished"; }) ||
         std::ranges::any_of(document.excluded, [](const NounPhrase& noun) { return one_of(noun.head, WordSet::kAllFurniture); });
}

}  // namespace

void furnish_by_wish(const Lexicon& lexicon, const Document& document, SceneGraph& scene) {
  if (!scene.objects.empty() && only_says_what_for(lexicon, document)) {
    scene.objects.clear();
    scene.relations.clear();
  }
  if (scene.objects.empty() && wants_no_furniture(document)) return;
  const bool only_wished = scene.objects.empty() || (!document.wanted.empty() && !Furnisher(lexicon, document, scene).names_usual());
  if (only_wished) Furnisher(lexicon, document, scene).furnish_room();
  Furnisher(lexicon, document, scene).add_wanted();
  if (only_wished) return;
  // "Open plan flat. Kitchen at one end, …": a kitchen of which nothing is named.
  const bool kitchen = std::ranges::any_of(document.rooms, [](const NounPhrase& room) {
    const bool known = room.determiner != Determiner::kNone && room.determiner != Determiner::kIndefinite;  // "tea is in the kitchen"
    return room.room != nullptr && room.room->id == "kitchen" && !known;
  });
  const bool has_run = std::ranges::any_of(scene.objects, [&](const SceneObject& object) {
    const CatalogEntry* entry = lexicon.catalog().find(object.category);
    return entry != nullptr && entry->is(Trait::kKitchenRun);
  });
  const bool a_part = document.rooms.size() > 1 && !has_run && !wall_of_kitchen(document).empty();
  if (!kitchen || (scene.room.type == "kitchen" && !a_part)) return;
  const std::size_t named = scene.objects.size();
  Furnisher(lexicon, document, scene).add_part("kitchen");
  place_kitchen(lexicon, document, scene, named);
}

}  // namespace layoutbox::offline
