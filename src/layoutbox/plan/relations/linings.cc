#include "layoutbox/plan/relations/linings.h"

#include <algorithm>
#include <ranges>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/open_rows.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {
namespace {

class Linings {
 public:
  Linings(const Lexicon& lexicon, const Document& document, const SceneGraph& scene)
      : lexicon_(lexicon), document_(document), scene_(scene) {}

  std::vector<Lining> find() const {
    std::vector<Lining> found;
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const Mention& mention = document_.mentions[m];
      if (!mention.introduces || mention.items.empty() || mention.noun.kind != NounKind::kObject) continue;
      const bool counter = sits_at_counter(mention);
      if (!counter && !lines_walls(static_cast<int>(m)) && !fills_room(mention)) continue;
      Lining& lining = found.emplace_back();
      for (const int item : mention.items) lining.ids.push_back(object(item).id);
      lining.open = counter || is_open(mention.noun);
      lining.one_wall = says_one_wall(static_cast<int>(m));
    }
    return found;
  }

 private:
  const SceneObject& object(int item) const { return scene_.objects[static_cast<std::size_t>(item)]; }

  // "shelves", "shelving": nobody counts them, and they are what stands in rows along a wall.
  bool is_open(const NounPhrase& noun) const {
    const bool stands = noun.entry != nullptr && noun.entry->mount == Mount::kFloor && noun.entry->back_to_wall;
    return stands && noun.entry->is(Trait::kShelving) && noun.count == 0 && (noun.plural || is_uncounted_stuff(noun)) && !noun.size.any();
  }

  bool says_lining(int mention) const {
    return std::ranges::any_of(document_.links, [&](const Link& link) {
      const auto lines = [&](std::size_t at) { return one_of(document_.tokens[at].text, WordSet::kLining); };
      return contains(link.targets, mention) && std::ranges::any_of(std::views::iota(link.first, std::max(link.first, link.last)), lines);
    });
  }

  // "along one wall", "along the wall", not "along every wall" and "along the walls"
  bool says_one_wall(int mention) const {
    return std::ranges::any_of(document_.links, [&](const Link& link) {
      if (!contains(link.targets, mention)) return false;
      bool wall = false, several = false;
      for (std::size_t at = link.first; at < link.last; ++at) {
        wall |= document_.tokens[at].text == "wall";
        several |= says_one_of(document_, at, {"every", "each", "all", "both"});
      }
      return wall && !several;
    });
  }

  bool lines_walls(int at) const {
    const Mention& mention = document_.mentions[static_cast<std::size_t>(at)];
    const bool open = is_open(mention.noun);
    return says_lining(at) && std::ranges::all_of(mention.items, [&](int item) { return is_free_at_walls(object(item).id, open); });
  }

  // Told to be at walls and nowhere else: "shelves line the wall behind the counter" are at that wall; so are ten chairs along the left
  // one.
  bool is_free_at_walls(const std::string& id, bool open) const {
    bool at_wall = false;
    for (const Relation& r : scene_.relations) {
      if (!r.asked() || std::ranges::find(r.targets, id) == r.targets.end()) continue;
      const bool wall = r.type == RelationType::kAgainstWall;
      at_wall |= wall && (open || r.references.empty());
      if (!wall && (traits_of(r.type).beside || r.type == RelationType::kGrid || r.type == RelationType::kOpposite)) return false;
    }
    return at_wall;
  }

  // "a long bar with stools in front": nobody counts them.
  bool sits_at_counter(const Mention& mention) const {
    const NounPhrase& noun = mention.noun;
    if (!noun.plural || noun.count > 0 || noun.vague || !is_seat(lexicon_.catalog(), noun)) return false;
    return std::ranges::all_of(mention.items, [&](int item) { return counter_of(scene_, lexicon_.catalog(), object(item).id) != nullptr; });
  }

  // "a library with bookshelves": of nothing is said where they are, and such rooms are full of them.
  bool fills_room(const Mention& mention) const {
    constexpr int kFull = 3;
    const RoomKind* room = scene_.room.type.empty() ? nullptr : lexicon_.catalog().find_room(scene_.room.type);
    if (room == nullptr || !is_open(mention.noun)) return false;
    const bool usual = std::ranges::any_of(room->usual, [&](const auto& row) {
      const CatalogEntry* entry = lexicon_.catalog().find(row.first);
      return row.second >= kFull && entry != nullptr && entry->is(Trait::kShelving);
    });
    return usual && std::ranges::none_of(mention.items, [&](int item) {
             return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
               return r.asked() && std::ranges::find(r.targets, object(item).id) != r.targets.end();
             });
           });
  }

  const Lexicon& lexicon_;
  const Document& document_;
  const SceneGraph& scene_;
};

}  // namespace

std::vector<Lining> find_linings(const Lexicon& lexicon, const Document& document, const SceneGraph& scene) {
  return Linings(lexicon, document, scene).find();
}

}  // namespace layoutbox::offline
