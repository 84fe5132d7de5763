#include "layoutbox/plan/offline/room_by_contents.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

// "I'm 9", "aged 7", "she is ten years old": whose room it is.
bool tells_age_of_child(const Document& document) {
  constexpr double kGrown = 18;
  const std::vector<Token>& tokens = document.tokens;
  const auto says = [&](std::size_t i, std::initializer_list<std::string_view> words) {
    return i < tokens.size() && std::ranges::find(words, tokens[i].text) != words.end();
  };
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    if (tokens[i].kind != Token::Kind::kNumber || tokens[i].number >= kGrown) continue;
    const bool years = says(i + 1, {"year", "years"}) && says(i + 2, {"old"});
    const bool am = i > 1 && says(i - 2, {"i"}) && says(i - 1, {"am", "'m"}) &&
                    (tokens[i].ends_sentence || says(i + 1, {"and", ",", "years", "now", "."}));
    if (years || am || says(i - 1, {"aged"})) return true;
  }
  return false;
}

// What a room of no named kind is, by what stands in it; empty where that says nothing.
std::string kind_by_contents(const Lexicon& lexicon, const Document& document, const SceneGraph& scene) {
  const Catalog& catalog = lexicon.catalog();
  const auto count = [&](const std::vector<std::string>& kinds) {
    return std::ranges::count_if(scene.objects, [&](const SceneObject& object) {
      return std::ranges::any_of(kinds, [&](const std::string& kind) { return catalog.is_a(object.category, kind); });
    });
  };
  const bool young = tells_age_of_child(document) || speaks_of_young(lexicon, document);
  const auto fits = [&](const RoomByContents& row) {
    const auto has = [&](const std::vector<std::string>& kinds) { return count(kinds) >= row.at_least; };
    return (young || !row.young) && std::ranges::all_of(row.has, has) && count(row.without) == 0;
  };
  const std::vector<RoomByContents>& rows = Groups::builtin().contents;
  const auto row = std::ranges::find_if(rows, fits);
  return row == rows.end() ? std::string() : row->room;
}

}  // namespace

bool speaks_of_young(const Lexicon& lexicon, const Document& document) {
  return std::ranges::any_of(document.tokens, [&](const Token& token) { return lexicon.is_young(singular_of(token.text)); });
}

void name_room_by_contents(const Lexicon& lexicon, const Document& document, SceneGraph& scene) {
  const bool named = std::ranges::any_of(document.rooms, [](const NounPhrase& room) { return room.kind == NounKind::kRoom && room.room; });
  if (!scene.room.type.empty() || named) return;
  scene.room.type = kind_by_contents(lexicon, document, scene);
  if (scene.room.type.empty() && !scene.objects.empty()) scene.room.type = document.wanted_room;
  const RoomKind* kind = scene.room.type.empty() ? nullptr : lexicon.catalog().find_room(scene.room.type);
  for (SceneObject& object : scene.objects) {  // what a plain word means in such a room: children sleep in beds for one
    const CatalogEntry* own = kind == nullptr ? nullptr : lexicon.catalog().find(object.category);
    const bool plain = own != nullptr && singular_of(object.name) == own->name;
    if (const CatalogEntry* meant = plain ? lexicon.meant_in(*kind, kind->name, own->name) : nullptr) object.category = meant->id;
  }
}

}  // namespace layoutbox::offline
