// What is in the room, and which of it words speak of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox::edit {

// How far apart things are of which one has no place.
inline constexpr double kUnknown = 1e9;

struct Thing {
  std::string id;
  offline::NounPhrase noun;              // its name, as the planner reads it
  std::vector<std::string> attributes;   // in the scene's words
  const PlacedObject* placed = nullptr;  // where it is; null for what is only coming in
  bool gone = false;                     // removed by an earlier command
};

// Which of several: "the largest", "the left", "the other".
enum class Pick {
  kNone,
  kLargest,
  kSmallest,
  kTallest,
  kShortest,
  kWidest,
  kNarrowest,
  kLongest,
  kLeft,
  kRight,
  kFront,
  kBack,
  kMiddle,
  kOther
};

// "… next to the bed", "… in the corner", "… on the desk": what tells one of several by its place.
struct Modifier {
  offline::PhraseSenses senses;
  std::vector<int> things;    // what it refers to
  offline::NounPhrase place;  // … or the part of the room
};

class World {
 public:
  World(const offline::Lexicon& lexicon, const Layout& layout);

  const Layout& layout() const { return *layout_; }
  std::vector<Thing>& things() { return things_; }
  const std::vector<Thing>& things() const { return things_; }
  const Thing& thing(int index) const { return things_[static_cast<std::size_t>(index)]; }
  int add(std::string id, offline::NounPhrase noun, std::vector<std::string> attributes);
  std::string new_id(const std::string& category) const;

  // What has that id, or -1.
  int find(std::string_view id) const;
  // What is of that kind, the best fitting only, whatever its attributes.
  std::vector<int> of_kind(const offline::NounPhrase& noun) const;
  // Those of `found` that have the attributes of `noun`, as far as any of them has.
  std::vector<int> with_attributes(std::vector<int> found, const offline::NounPhrase& noun) const;
  std::vector<int> picked(std::vector<int> found, Pick pick, const std::vector<int>& mentioned, std::size_t count) const;
  // Those that stand as the modifier says; all of them where it tells nothing.
  std::vector<int> modified(const std::vector<int>& found, const Modifier& modifier) const;

  // How far apart two things are, centre to centre; and a thing and a part of the room (1e9 where that is not known).
  double distance(int a, int b) const;
  double distance(int thing, const offline::NounPhrase& place) const;
  // The wall that a thing stands nearest to, or null.
  const Wall* wall_of(int thing) const;
  // "another corner", "the opposite corner": which one, as "back left"; empty where a noun says no such thing or the thing has no place.
  std::string other_corner(int thing, const offline::NounPhrase& corner) const;
  // The openings that a noun speaks of, "the left window": all of the kind where it says no more.
  std::vector<const Opening*> openings_of(const offline::NounPhrase& noun) const;

  // "bed (bed_1), desk (desk_1)": what there is, for messages.
  std::string names(const std::vector<int>& found) const;
  std::string all_names() const;

 private:
  int fit(const offline::NounPhrase& wanted, const offline::NounPhrase& item) const;

  const offline::Lexicon* lexicon_;
  const Layout* layout_;
  std::vector<Thing> things_;
};

// The centre of an opening, in millimetres.
std::optional<std::array<double, 2>> center_of(const Layout& layout, const Opening& opening);

}  // namespace layoutbox::edit
