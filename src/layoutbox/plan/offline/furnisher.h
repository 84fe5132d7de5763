// Puts what is usual in a kind of room into a scene, and what people want to do there needs. What it adds is marked as assumed or
// concluded.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

class Furnisher {
 public:
  Furnisher(const Lexicon& lexicon, const Document& document, SceneGraph& scene);
  // With what is usual in the kinds of room that the text names or hints at, and what it names within a purpose; a note says why. The scene
  // stays as it is where there is no hint.
  void furnish_room();
  // Whether anything is asked for that such a room usually has; where no kind of room is known, anything.
  bool names_usual();
  // What is done there needs them: "I want to cook and to eat".
  void add_wanted();
  // A part of the room of which nothing is there: "with a kitchen at one end".
  void add_part(std::string_view id);

 private:
  static constexpr int kTells = 3;  // of the usual things: what such a room is told by

  // "for two children": for how many it is.
  void count_people();
  // The kinds of room that the text names, that of the scene first: "a living room with a kitchen corner".
  void find_kinds();
  // "the waiting room of a small clinic": that is the whole house.
  bool names_owner(std::size_t i) const;
  // "the bathroom door on the back wall": that room is next door.
  bool names_opening(std::size_t i) const;
  void add_kind(const RoomKind* kind);
  // "… to read on rainy days", "… for my grandmother", "… picking up mugs".
  void guess_kind(const std::vector<const CatalogEntry*>& named, std::string& because);
  std::vector<const CatalogEntry*> things_within_purposes() const;
  bool excluded(const std::string& category) const;
  bool is_asked_for(const CatalogEntry& entry) const;
  // A breakfast bar is no worktop at the wall.
  bool is_there(const CatalogEntry& entry) const;
  // A chair by a bistro table: that is a table.
  bool is_beside(const CatalogEntry& seat, const std::string& table) const;
  void add(const CatalogEntry& entry, int count, Origin origin = Origin::kAssumed);
  // All that is usual in the room itself, the most important things of a part of it.
  void furnish(const RoomKind& named, bool whole);
  // … of the seats that usually stand by a table of that kind of room.
  double seats_floor(const RoomKind& kind, const CatalogEntry& table) const;
  void number_objects();
  // "bed_2": 2
  static int number_of(std::string_view id);
  static double area_of(const Size& size);
  // How much of the floor its furniture may cover (mm²): in a small kitchen there is no dining table.
  double floor_for_furniture(const RoomKind& kind) const;
  // With what it stands on, where nothing of that is there.
  void add_named(const CatalogEntry& entry);

  const Lexicon& lexicon_;
  const Catalog& catalog_;
  const Document& document_;
  SceneGraph& scene_;
  int people_;
  bool young_;
  std::vector<const RoomKind*> kinds_;
  std::map<std::string, int> numbers_;
};

}  // namespace layoutbox::offline
