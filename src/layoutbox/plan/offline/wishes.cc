#include "layoutbox/plan/offline/wishes.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/people.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/room/kitchen_wall.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox::offline {
namespace {

bool speaks_of_young(const Lexicon& lexicon, const Document& document) {
  return std::ranges::any_of(document.tokens, [&](const Token& token) { return lexicon.is_young(singular_of(token.text)); });
}

class Furnisher {
 public:
  Furnisher(const Lexicon& lexicon, const Document& document, SceneGraph& scene)
      : lexicon_(lexicon),
        catalog_(lexicon.catalog()),
        document_(document),
        scene_(scene),
        people_(document.people),
        young_(document.young || speaks_of_young(lexicon, document)) {}

  void run() {
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

  // Whether anything is asked for that such a room usually has; where no kind of room is known, anything.
  bool names_usual() {
    find_kinds();
    if (kinds_.empty()) return true;
    return std::ranges::any_of(scene_.objects, [&](const SceneObject& object) {
      return object.asked() && std::ranges::any_of(kinds_.front()->usual, [&](const auto& usual) {
               return catalog_.is_a(object.category, usual.first) || catalog_.is_a(usual.first, object.category);
             });
    });
  }

  // What is done there needs them: "I want to cook and to eat".
  void add_wanted() {
    number_objects();
    for (const Wanted& wanted : document_.wanted) {
      // Six who sleep have six beds and not the usual ones besides.
      if (wanted.entry->is(Trait::kBed) && wanted.count > 1)
        std::erase_if(scene_.objects, [&](const SceneObject& object) {
          const CatalogEntry* own = catalog_.find(object.category);
          return own != nullptr && own->is(Trait::kBed) && object.origin == Origin::kAssumed;
        });
      const int there = static_cast<int>(std::ranges::count_if(
          scene_.objects, [&](const SceneObject& object) { return catalog_.is_a(object.category, wanted.entry->id); }));
      if (there >= wanted.count || excluded(wanted.entry->id)) continue;
      add(*wanted.entry, wanted.count - there, Origin::kConcluded);
      // Who cooks in a studio needs a sink and a fridge as well.
      const RoomKind* kitchen = wanted.entry->id == "stove" && scene_.room.type != "kitchen" ? catalog_.find_room("kitchen") : nullptr;
      if (kitchen != nullptr) furnish(*kitchen, false);
    }
  }

  // A part of the room of which nothing is there: "with a kitchen at one end".
  void add_part(std::string_view id) {
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

 private:
  static constexpr int kTells = 3;  // of the usual things: what such a room is told by

  // "for two children": for how many it is.
  void count_people() {
    for (const Chunk& chunk : document_.chunks) {
      if (chunk.kind != ChunkKind::kNoun || chunk.noun.count == 0 || !lexicon_.is_person(chunk.noun.head) || people_ > 0) continue;
      people_ = chunk.noun.count;
      young_ = lexicon_.is_young(chunk.noun.head);
    }
  }

  // The kinds of room that the text names, that of the scene first: "a living room with a kitchen corner".
  void find_kinds() {
    if (!scene_.room.type.empty()) add_kind(catalog_.find_room(scene_.room.type));
    for (std::size_t i = 0; i < document_.tokens.size();) {
      const Match match = lexicon_.find(document_.tokens, i);
      if (const Meaning* room = meaning_of(match, WordClass::kRoom);
          room != nullptr && !has(match, WordClass::kAbstract) && !has(match, WordClass::kOutsideRoom) &&
          !names_opening(i + match.length) && (kinds_.empty() || !names_owner(i)))
        add_kind(room->room);
      i += std::max<std::size_t>(match.length, 1);
    }
  }

  // "the waiting room of a small clinic": that is the whole house.
  bool names_owner(std::size_t i) const {
    constexpr std::size_t kLooks = 3;  // "of a small children's"
    for (std::size_t back = 1; back <= std::min(i, kLooks + 2) && !document_.tokens[i - back].ends_sentence; ++back) {
      const std::string& word = document_.tokens[i - back].text;
      if (word == "of") return true;
      if (document_.tokens[i - back].kind != Token::Kind::kWord || lexicon_.find_phrase(document_.tokens, i - back).length > 0)
        return false;
    }
    return false;
  }

  // "the bathroom door on the back wall": that room is next door.
  bool names_opening(std::size_t i) const {
    if (i >= document_.tokens.size()) return false;
    const Match match = lexicon_.find(document_.tokens, i);
    return has(match, WordClass::kDoor) || has(match, WordClass::kWindow);
  }

  void add_kind(const RoomKind* kind) {
    constexpr std::size_t kMostKinds = 3;
    if (kind != nullptr && kinds_.size() < kMostKinds && std::find(kinds_.begin(), kinds_.end(), kind) == kinds_.end())
      kinds_.push_back(kind);
  }

  // "… to read on rainy days", "… for my grandmother", "… picking up mugs".
  void guess_kind(const std::vector<const CatalogEntry*>& named, std::string& because) {
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

  std::vector<const CatalogEntry*> things_within_purposes() const {
    std::vector<const CatalogEntry*> things;
    for (const Chunk& chunk : document_.chunks) {
      const NounPhrase& noun = chunk.noun;
      if (chunk.kind == ChunkKind::kNoun && noun.kind == NounKind::kObject && noun.exact && noun.entry != nullptr &&
          document_.readings[chunk.first].use == WordReading::Use::kIgnored)
        things.push_back(noun.entry);
    }
    return things;
  }

  bool excluded(const std::string& category) const {
    return std::any_of(document_.excluded.begin(), document_.excluded.end(),
                       [&](const NounPhrase& n) { return n.entry != nullptr && catalog_.is_a(category, n.entry->id); });
  }

  bool is_asked_for(const CatalogEntry& entry) const {
    return std::ranges::any_of(scene_.objects,
                               [&](const SceneObject& o) { return o.origin != Origin::kAssumed && catalog_.is_a(o.category, entry.id); });
  }

  // A breakfast bar is no worktop at the wall.
  bool is_there(const CatalogEntry& entry) const {
    return std::ranges::any_of(scene_.objects, [&](const SceneObject& o) {
      const CatalogEntry* own = catalog_.find(o.category);
      return catalog_.is_a(o.category, entry.id) && (own == nullptr || !entry.is(Trait::kKitchenRun) || own->is(Trait::kKitchenRun));
    });
  }

  // A chair by a bistro table: that is a table.
  bool is_beside(const CatalogEntry& seat, const std::string& table) const {
    return std::ranges::any_of(seat.beside, [&](const std::string& kind) { return catalog_.is_a(table, kind); });
  }

  void add(const CatalogEntry& entry, int count, Origin origin = Origin::kAssumed) {
    for (int i = 0; i < count; ++i) {
      SceneObject object;
      object.id = entry.id + "_" + std::to_string(++numbers_[entry.id]);
      object.category = entry.id;
      object.name = entry.name;
      object.origin = origin;
      scene_.objects.push_back(std::move(object));
    }
  }

  // All that is usual in the room itself, the most important things of a part of it.
  void furnish(const RoomKind& named, bool whole) {
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

  // … of the seats that usually stand by a table of that kind of room.
  double seats_floor(const RoomKind& kind, const CatalogEntry& table) const {
    double area = 0;
    for (const auto& [category, count] : kind.usual) {
      const CatalogEntry* seat = catalog_.find(category);
      if (seat == nullptr || !seat->is(Trait::kTableSeat) || !is_beside(*seat, table.id)) continue;
      area += area_of(seat->size.usual) * count;
    }
    return area;
  }

  void number_objects() {
    for (const SceneObject& object : scene_.objects) numbers_[object.category] = std::max(numbers_[object.category], number_of(object.id));
  }

  // "bed_2": 2
  static int number_of(std::string_view id) {
    const std::string_view digits = id.substr(std::min(id.size(), id.rfind('_') + 1));
    int number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
  }

  static double area_of(const Size& size) { return double(size.width) * size.depth; }

  // How much of the floor its furniture may cover (mm²): in a small kitchen there is no dining table.
  double floor_for_furniture(const RoomKind& kind) const {
    constexpr double kCovered = 0.5, kInSmall = 0.32;
    if (!scene_.room.polygon.empty()) return kCovered * static_cast<double>(doubled_area(scene_.room.polygon)) / 2;
    if (scene_.room.area_m2) return kCovered * *scene_.room.area_m2 * 1e6;
    return room_size_factor(scene_.room.size_word) < 1 ? kInSmall * area_of(kind.usual_size) : std::numeric_limits<double>::max();
  }

  // With what it stands on, where nothing of that is there.
  void add_named(const CatalogEntry& entry) {
    if (is_there(entry) || excluded(entry.id)) return;
    const bool host = entry.stands_on.empty() || std::any_of(entry.stands_on.begin(), entry.stands_on.end(), [&](const std::string& id) {
                        const CatalogEntry* kind = catalog_.find(id);
                        return kind != nullptr && is_there(*kind);
                      });
    if (const CatalogEntry* table = catalog_.find("table"); !host && table != nullptr) add(*table, 1);
    add(entry, 1);
  }

  const Lexicon& lexicon_;
  const Catalog& catalog_;
  const Document& document_;
  SceneGraph& scene_;
  int people_;
  bool young_;
  std::vector<const RoomKind*> kinds_;
  std::map<std::string, int> numbers_;
};

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

}  // namespace

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

namespace {

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
  if (only_wished) Furnisher(lexicon, document, scene).run();
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
