#include "layoutbox/plan/edit/world.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::edit {
namespace {

using namespace offline;

std::string last_word(const std::string& name) {
  const std::string plain = name.substr(0, name.find(" of "));
  const std::size_t space = plain.rfind(' ');
  return space == std::string::npos ? plain : plain.substr(space + 1);
}

bool contains(const std::vector<std::string>& all, const std::string& one) { return std::find(all.begin(), all.end(), one) != all.end(); }

// What a name means, read as the planner reads it in a text.
NounPhrase read_name(const Lexicon& lexicon, const PlacedObject& placed) {
  const std::string name = placed.name.empty() ? placed.category : placed.name;
  std::string words;
  for (const std::string& word : words_of(name)) words += (words.empty() ? "" : " ") + word;
  NounPhrase noun;
  const std::vector<Token> tokens = tokenize("the " + words);
  if (auto read = read_noun_phrase(lexicon, tokens, 0, false); read && read->kind == NounKind::kObject) noun = std::move(*read);
  noun.kind = NounKind::kObject;
  if (noun.name.empty()) noun.name = words;
  if (const CatalogEntry* entry = lexicon.catalog().find(placed.category)) {
    noun.exact = noun.exact || noun.entry != entry;
    noun.entry = entry;
  }
  noun.category = placed.category;
  noun.determiner = Determiner::kDefinite;
  noun.first = noun.last = 0;
  noun.attributes = placed.attributes;
  return noun;
}

double volume(const Thing& thing) {
  const Size& size = thing.placed->size;
  return static_cast<double>(size.width) * size.depth * std::max<double>(size.height, 1);
}

double measure_of(const Thing& thing, Pick pick) {
  const Size& size = thing.placed->size;
  switch (pick) {
    case Pick::kLargest: return volume(thing);
    case Pick::kSmallest: return -volume(thing);
    case Pick::kTallest: return size.height;
    case Pick::kShortest: return -size.height;
    case Pick::kWidest: return size.width;
    case Pick::kNarrowest: return -size.width;
    case Pick::kLongest: return std::max(size.width, size.depth);
    case Pick::kLeft: return -thing.placed->position[0];
    case Pick::kRight: return thing.placed->position[0];
    case Pick::kFront: return -thing.placed->position[1];
    case Pick::kBack: return thing.placed->position[1];
    default: return 0;
  }
}

// Words of size tell which of several is meant where nothing has them as attributes.
Pick pick_of_word(const std::string& word) {
  for (const char* large : {"large", "big", "huge", "grand"}) {
    if (word == large) return Pick::kLargest;
  }
  for (const char* small : {"small", "little", "tiny"}) {
    if (word == small) return Pick::kSmallest;
  }
  if (word == "tall" || word == "high") return Pick::kTallest;
  if (word == "short" || word == "low") return Pick::kShortest;
  if (word == "wide") return Pick::kWidest;
  if (word == "narrow") return Pick::kNarrowest;
  return word == "long" ? Pick::kLongest : Pick::kNone;
}

}  // namespace

std::optional<std::array<double, 2>> center_of(const Layout& layout, const Opening& opening) {
  const Wall* wall = layout.find_wall(opening.wall);
  if (wall == nullptr || !opening.offset) return std::nullopt;
  const double dx = wall->end.x - wall->start.x, dy = wall->end.y - wall->start.y, length = std::max(std::hypot(dx, dy), 1.0);
  const double along = (*opening.offset + opening.width / 2.0) / length;
  return std::array<double, 2>{wall->start.x + dx * along, wall->start.y + dy * along};
}

World::World(const Lexicon& lexicon, const Layout& layout) : lexicon_(&lexicon), layout_(&layout) {
  for (const PlacedObject& placed : layout.objects) {
    things_.push_back({placed.id, read_name(lexicon, placed), placed.attributes, &placed, false});
  }
}

int World::add(std::string id, NounPhrase noun, std::vector<std::string> attributes) {
  things_.push_back({std::move(id), std::move(noun), std::move(attributes), nullptr, false});
  return static_cast<int>(things_.size()) - 1;
}

std::string World::new_id(const std::string& category) const {
  for (int number = 1;; ++number) {
    std::string id = category + "_" + std::to_string(number);
    const bool taken = layout_->find_object(id) != nullptr || layout_->find_wall(id) != nullptr || layout_->find_opening(id) != nullptr;
    if (!taken && find(id) < 0) return id;
  }
}

int World::find(std::string_view id) const {
  for (std::size_t i = 0; i < things_.size(); ++i) {
    if (!things_[i].gone && same_name(things_[i].id, id)) return static_cast<int>(i);
  }
  return -1;
}

// 4: the same words, 3: the same kind, 2: a kind of it or its head noun, 1: a word for something more special.
int World::fit(const NounPhrase& wanted, const NounPhrase& item) const {
  const Catalog& catalog = lexicon_->catalog();
  if (wanted.name == item.name) return 4;
  if (wanted.exact && item.exact && wanted.entry != nullptr && wanted.entry == item.entry) return 3;
  if (wanted.exact && wanted.entry != nullptr && item.entry != nullptr && catalog.is_a(item.entry->id, wanted.entry->id)) return 2;
  const bool one_word = wanted.name.find(' ') == std::string::npos;
  if (one_word && (last_word(item.name) == wanted.name || item.name == wanted.name)) return 2;
  if (!one_word && item.name.find(' ') == std::string::npos && last_word(wanted.name) == item.name) return 1;
  // "the kitchen chair" of things that are all called dining chair: by the head noun's kind.
  if (wanted.entry != nullptr && item.entry != nullptr && (wanted.entry == item.entry || catalog.is_a(wanted.entry->id, item.entry->id)))
    return 1;
  return 0;
}

std::vector<int> World::of_kind(const NounPhrase& noun) const {
  if (const int known = find(noun.name); known >= 0) return {known};
  int best = 1;
  std::vector<int> found;
  for (std::size_t i = 0; i < things_.size(); ++i) {
    if (things_[i].gone) continue;
    const int score = fit(noun, things_[i].noun);
    // A word for a kind means all of that kind, whatever they are called: "chairs" are armchairs and office chairs too.
    const int level = score >= 2 && noun.name.find(' ') == std::string::npos ? 2 : score;
    if (level < best || score == 0) continue;
    if (level > best) found.clear();
    best = level;
    found.push_back(static_cast<int>(i));
  }
  // "The chairs" are those that are called chairs, if there are any; "all chairs" means the office chair too.
  if (noun.determiner == Determiner::kBoth || noun.determiner == Determiner::kEach) return found;
  std::vector<int> same;
  for (const int i : found) {
    if (fit(noun, thing(i).noun) == 4) same.push_back(i);
  }
  return same.empty() ? found : same;
}

std::vector<int> World::with_attributes(std::vector<int> found, const NounPhrase& noun) const {
  for (const std::string& attribute : noun.attributes) {
    std::vector<int> having;
    for (const int i : found) {
      const Thing& thing = things_[static_cast<std::size_t>(i)];
      const bool in_name = contains(words_of(thing.placed ? thing.placed->name : thing.noun.name), attribute);
      if (contains(thing.attributes, attribute) || in_name) having.push_back(i);
    }
    if (!having.empty()) {
      found = having;
    } else if (const Pick pick = pick_of_word(attribute); pick != Pick::kNone) {
      found = picked(found, pick, {}, 1);
    } else if (found.size() > 1) {
      return {};  // several, and none is so
    }
  }
  return found;
}

std::vector<int> World::picked(std::vector<int> found, Pick pick, const std::vector<int>& mentioned, std::size_t count) const {
  if (pick == Pick::kNone) return found;
  if (pick == Pick::kOther) {
    std::vector<int> rest;
    for (const int i : found) {
      if (std::find(mentioned.begin(), mentioned.end(), i) == mentioned.end()) rest.push_back(i);
    }
    return rest.empty() ? found : rest;
  }
  std::erase_if(found, [&](int i) { return thing(i).placed == nullptr; });
  if (pick == Pick::kMiddle) {
    std::stable_sort(found.begin(), found.end(), [&](int a, int b) { return thing(a).placed->position[0] < thing(b).placed->position[0]; });
    return found.empty() ? found : std::vector<int>{found[found.size() / 2]};
  }
  std::stable_sort(found.begin(), found.end(), [&](int a, int b) { return measure_of(thing(a), pick) > measure_of(thing(b), pick); });
  if (found.size() > count) found.resize(std::max<std::size_t>(count, 1));
  return found;
}

std::vector<int> World::modified(const std::vector<int>& found, const Modifier& modifier) const {
  // What the layout itself says comes first: what stands on it, and the relations that were asked for.
  std::vector<int> said;
  for (const int i : found) {
    const Thing& thing = things_[static_cast<std::size_t>(i)];
    const auto refers = [&](const std::vector<std::string>& ids) {
      return std::any_of(modifier.things.begin(), modifier.things.end(), [&](int t) { return contains(ids, this->thing(t).id); });
    };
    bool holds = false;
    for (const PhraseSense& sense : modifier.senses) {
      const bool carried = traits_of(sense.type).supports;
      holds = holds || (carried && thing.placed != nullptr && refers({thing.placed->supported_by}));
      for (const PlacedRelation& placed : layout_->relations) {
        if (!modifier.things.empty() && placed.held && placed.relation.type == sense.type && contains(placed.relation.targets, thing.id))
          holds = holds || refers(placed.relation.references);
      }
    }
    if (holds) said.push_back(i);
  }
  if (!said.empty()) return said;
  const auto carries = [](const PhraseSense& s) { return traits_of(s.type).supports; };
  // "the lamp on the desk" where there is none: not the one that is nearest.
  if (!modifier.things.empty() && std::any_of(modifier.senses.begin(), modifier.senses.end(), carries)) return {};
  // Else the side, where it says one; else the nearest.
  double best = kUnknown;
  std::vector<int> nearest;
  for (const int i : found) {
    double far = kUnknown;
    for (const int other : modifier.things) far = std::min(far, distance(i, other));
    if (modifier.things.empty()) far = distance(i, modifier.place);
    if (far >= kUnknown) continue;
    if (far < best - 50) nearest.clear(), best = far;
    if (far <= best + 50) nearest.push_back(i);
  }
  return nearest.empty() ? found : nearest;
}

std::vector<const Opening*> World::openings_of(const NounPhrase& noun) const {
  std::vector<const Opening*> found;
  for (const Opening& opening : layout_->room.openings) {
    const bool window = opening.type == OpeningType::kWindow;
    if (window != (noun.kind == NounKind::kWindow)) continue;
    if (noun.name == opening.id) return {&opening};
    if (!noun.wall_word.empty() && layout_->find_wall(noun.wall_word) != layout_->find_wall(opening.wall)) continue;
    found.push_back(&opening);
  }
  return found;
}

std::string World::names(const std::vector<int>& found) const {
  std::string text;
  for (const int i : found) text += (text.empty() ? "" : ", ") + thing(i).id;
  return text;
}

std::string World::all_names() const {
  constexpr std::size_t kMost = 12;
  std::string text;
  std::size_t told = 0, all = 0;
  for (const Thing& thing : things_) {
    if (thing.gone) continue;
    ++all;
    if (told < kMost) text += (told++ == 0 ? "" : ", ") + thing.id;
  }
  return all > told ? text + ", …" : text;
}

}  // namespace layoutbox::edit
