#include "layoutbox/plan/offline/furnisher.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/people.h"
#include "layoutbox/plan/offline/room_by_contents.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox::offline {

Furnisher::Furnisher(const Lexicon& lexicon, const Document& document, SceneGraph& scene)
    : lexicon_(lexicon),
      catalog_(lexicon.catalog()),
      document_(document),
      scene_(scene),
      people_(document.people),
      young_(document.young || speaks_of_young(lexicon, document)) {}

void Furnisher::furnish_room() {
  count_people();
  number_objects();
  find_kinds();
  const std::vector<const CatalogEntry*> named = things_within_purposes();
  std::string because = "no furniture is named";
  if (kinds_.empty()) guess_kind(named, because);
  if (kinds_.empty()) return;
  if (scene_.room.type.empty()) scene_.room.type = kinds_.front()->id;
  for (std::size_t k = 0; k < kinds_.size(); ++k) furnish(*kinds_[k], k == 0);
  for (const CatalogEntry* entry : named) add_named(*entry);
  scene_.notes.push_back({"filled", because + ": the usual furniture of a " + kinds_.front()->name + " is taken", "prompt"});
}

bool Furnisher::names_usual() {
  find_kinds();
  if (kinds_.empty()) return true;
  return std::ranges::any_of(scene_.objects, [&](const SceneObject& object) {
    return object.asked() && std::ranges::any_of(kinds_.front()->usual, [&](const auto& usual) {
             return catalog_.is_a(object.category, usual.first) || catalog_.is_a(usual.first, object.category);
           });
  });
}

void Furnisher::add_wanted() {
  number_objects();
  for (const Wanted& wanted : document_.wanted) {
    // Six who sleep have six beds and not the usual ones besides.
    if (wanted.entry->is(Trait::kBed) && wanted.count > 1)
      std::erase_if(scene_.objects, [&](const SceneObject& object) {
        const CatalogEntry* own = catalog_.find(object.category);
        return own != nullptr && own->is(Trait::kBed) && object.origin == Origin::kAssumed;
      });
    const int there = static_cast<int>(
        std::ranges::count_if(scene_.objects, [&](const SceneObject& object) { return catalog_.is_a(object.category, wanted.entry->id); }));
    if (there >= wanted.count || excluded(wanted.entry->id)) continue;
    add(*wanted.entry, wanted.count - there, Origin::kConcluded);
    // Who cooks in a studio needs a sink and a fridge as well.
    const RoomKind* kitchen = wanted.entry->id == "stove" && scene_.room.type != "kitchen" ? catalog_.find_room("kitchen") : nullptr;
    if (kitchen != nullptr) furnish(*kitchen, false);
  }
}

void Furnisher::add_part(std::string_view id) {
  const RoomKind* kind = catalog_.find_room(id);
  if (kind == nullptr) return;
  for (int i = 0; i < kTells && i < static_cast<int>(kind->usual.size()); ++i) {
    const CatalogEntry* entry = catalog_.find(kind->usual[static_cast<std::size_t>(i)].first);
    if (entry == nullptr || is_there(*entry) || excluded(entry->id)) return;
  }
  for (const SceneObject& object : scene_.objects) ++numbers_[object.category];
  furnish(*kind, false);
  scene_.notes.push_back({"filled", "a " + kind->name + " is named and nothing in it: the usual things are taken", "prompt"});
}

void Furnisher::count_people() {
  for (const Chunk& chunk : document_.chunks) {
    if (chunk.kind != ChunkKind::kNoun || chunk.noun.count == 0 || !lexicon_.is_person(chunk.noun.head) || people_ > 0) continue;
    people_ = chunk.noun.count;
    young_ = lexicon_.is_young(chunk.noun.head);
  }
}

void Furnisher::find_kinds() {
  if (!scene_.room.type.empty()) add_kind(catalog_.find_room(scene_.room.type));
  for (std::size_t i = 0; i < document_.tokens.size();) {
    const Match match = lexicon_.find(document_.tokens, i);
    if (const Meaning* room = meaning_of(match, WordClass::kRoom); room != nullptr && !has(match, WordClass::kAbstract) &&
                                                                   !has(match, WordClass::kOutsideRoom) &&
                                                                   !names_opening(i + match.length) && (kinds_.empty() || !names_owner(i)))
      add_kind(room->room);
    i += std::max<std::size_t>(match.length, 1);
  }
}

bool Furnisher::names_owner(std::size_t i) const {
  constexpr std::size_t kLooks = 3;  // "of a small children's"
  for (std::size_t back = 1; back <= std::min(i, kLooks + 2) && !document_.tokens[i - back].ends_sentence; ++back) {
    const std::string& word = document_.tokens[i - back].text;
    if (word == "of") return true;
    if (document_.tokens[i - back].kind != Token::Kind::kWord || lexicon_.find_phrase(document_.tokens, i - back).length > 0) return false;
  }
  return false;
}

bool Furnisher::names_opening(std::size_t i) const {
  if (i >= document_.tokens.size()) return false;
  const Match match = lexicon_.find(document_.tokens, i);
  return has(match, WordClass::kDoor) || has(match, WordClass::kWindow);
}

void Furnisher::add_kind(const RoomKind* kind) {
  constexpr std::size_t kMostKinds = 3;
  if (kind != nullptr && kinds_.size() < kMostKinds && std::find(kinds_.begin(), kinds_.end(), kind) == kinds_.end())
    kinds_.push_back(kind);
}

void Furnisher::guess_kind(const std::vector<const CatalogEntry*>& named, std::string& because) {
  if (!document_.wanted_room.empty()) {
    because = "what one does there says what it is for";
    return add_kind(catalog_.find_room(document_.wanted_room));
  }
  // What one does there says more than who.
  for (const bool person : {false, true}) {
    for (std::size_t i = 0; i < document_.tokens.size(); ++i) {
      const auto [room, length] = lexicon_.room_suggested(document_.tokens, i);
      const std::string& word = document_.tokens[i].text;
      if (length == 0 || person != (length == 1 && (lexicon_.is_person(singular_of(word)) || word_form(word) == WordForm::kPerson)))
        continue;
      because = "\"" + words_between(document_, i, i + length) + "\" says what it is for";
      return add_kind(catalog_.find_room(room));
    }
  }
  for (const CatalogEntry* entry : named) {
    if (entry->rooms.empty()) continue;
    because = "a " + entry->name + " is named";
    return add_kind(catalog_.find_room(entry->rooms.front()));
  }
}

std::vector<const CatalogEntry*> Furnisher::things_within_purposes() const {
  std::vector<const CatalogEntry*> things;
  for (const Chunk& chunk : document_.chunks) {
    const NounPhrase& noun = chunk.noun;
    if (chunk.kind == ChunkKind::kNoun && noun.kind == NounKind::kObject && noun.exact && noun.entry != nullptr &&
        document_.readings[chunk.first].use == WordReading::Use::kIgnored)
      things.push_back(noun.entry);
  }
  return things;
}

bool Furnisher::excluded(const std::string& category) const {
  return std::any_of(document_.excluded.begin(), document_.excluded.end(),
                     [&](const NounPhrase& n) { return n.entry != nullptr && catalog_.is_a(category, n.entry->id); });
}

bool Furnisher::is_asked_for(const CatalogEntry& entry) const {
  return std::ranges::any_of(scene_.objects,
                             [&](const SceneObject& o) { return o.origin != Origin::kAssumed && catalog_.is_a(o.category, entry.id); });
}

bool Furnisher::is_there(const CatalogEntry& entry) const {
  return std::ranges::any_of(scene_.objects, [&](const SceneObject& o) {
    const CatalogEntry* own = catalog_.find(o.category);
    return catalog_.is_a(o.category, entry.id) && (own == nullptr || !entry.is(Trait::kKitchenRun) || own->is(Trait::kKitchenRun));
  });
}

bool Furnisher::is_beside(const CatalogEntry& seat, const std::string& table) const {
  return std::ranges::any_of(seat.beside, [&](const std::string& kind) { return catalog_.is_a(table, kind); });
}

void Furnisher::add(const CatalogEntry& entry, int count, Origin origin) {
  for (int i = 0; i < count; ++i) {
    SceneObject object;
    object.id = entry.id + "_" + std::to_string(++numbers_[entry.id]);
    object.category = entry.id;
    object.name = entry.name;
    object.origin = origin;
    scene_.objects.push_back(std::move(object));
  }
}

void Furnisher::furnish(const RoomKind& named, bool whole) {
  const std::string young(young_ ? lexicon_.young_room(named.id) : std::string_view(named.id));
  const RoomKind* meant = catalog_.find_room(young);
  const RoomKind& kind = meant != nullptr ? *meant : named;
  const std::map<std::string, int> needs = needs_of(lexicon_, kind.id, people_);
  constexpr int kOfPart = 4;
  int taken = 0;
  double floor_left = whole ? floor_for_furniture(kind) : std::numeric_limits<double>::max();
  for (const auto& [category, usual] : kind.usual) {
    const auto needed = needs.find(category);
    const CatalogEntry* entry = catalog_.find(category);
    if (entry == nullptr || excluded(category) || is_asked_for(*entry)) continue;
    if (!whole && (taken >= kOfPart || is_there(*entry))) continue;
    const int count = needed != needs.end() ? needed->second : usual;
    const double floor = entry->mount == Mount::kFloor && !entry->thin ? area_of(entry->size.usual) * count : 0;
    const double with_seats = floor + (entry->is(Trait::kTable) ? seats_floor(kind, *entry) : 0);
    const bool seat_alone = entry->is(Trait::kTableSeat) && std::ranges::none_of(scene_.objects, [&](const SceneObject& object) {
                              return is_beside(*entry, object.category);
                            });
    if (whole && needed == needs.end() && taken >= kTells && (with_seats > floor_left || (seat_alone && floor > 0))) continue;
    floor_left -= floor;
    add(*entry, count);
    ++taken;
  }
}

double Furnisher::seats_floor(const RoomKind& kind, const CatalogEntry& table) const {
  double area = 0;
  for (const auto& [category, count] : kind.usual) {
    const CatalogEntry* seat = catalog_.find(category);
    if (seat == nullptr || !seat->is(Trait::kTableSeat) || !is_beside(*seat, table.id)) continue;
    area += area_of(seat->size.usual) * count;
  }
  return area;
}

void Furnisher::number_objects() {
  for (const SceneObject& object : scene_.objects) numbers_[object.category] = std::max(numbers_[object.category], number_of(object.id));
}

int Furnisher::number_of(std::string_view id) {
  const std::string_view digits = id.substr(std::min(id.size(), id.rfind('_') + 1));
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

double Furnisher::area_of(const Size& size) { return double(size.width) * size.depth; }

double Furnisher::floor_for_furniture(const RoomKind& kind) const {
  constexpr double kCovered = 0.5, kInSmall = 0.32;
  if (!scene_.room.polygon.empty()) return kCovered * static_cast<double>(doubled_area(scene_.room.polygon)) / 2;
  if (scene_.room.area_m2) return kCovered * *scene_.room.area_m2 * 1e6;
  return room_size_factor(scene_.room.size_word) < 1 ? kInSmall * area_of(kind.usual_size) : std::numeric_limits<double>::max();
}

void Furnisher::add_named(const CatalogEntry& entry) {
  if (is_there(entry) || excluded(entry.id)) return;
  const bool host = entry.stands_on.empty() || std::any_of(entry.stands_on.begin(), entry.stands_on.end(), [&](const std::string& id) {
                      const CatalogEntry* kind = catalog_.find(id);
                      return kind != nullptr && is_there(*kind);
                    });
  if (const CatalogEntry* table = catalog_.find("table"); !host && table != nullptr) add(*table, 1);
  add(entry, 1);
}

}  // namespace layoutbox::offline
