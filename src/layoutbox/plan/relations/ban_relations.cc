// What is to stay free, and whom nobody turns the back to, as relations of the things that are there.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/passes/bans.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_writer.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

class BanBuilder : public RelationWriter {
 public:
  using RelationWriter::RelationWriter;

  void add(const Ban& ban) {
    switch (ban.kind) {
      case Ban::Kind::kBackTo: return add_back_to(ban);
      case Ban::Kind::kFreeOpening: return add_for_all(ban, R::kNotBlocking, {ban.of});
      case Ban::Kind::kFreeWall: return add_for_all(ban, R::kAwayFromWall, {ban.of});
      case Ban::Kind::kFreeRegion: return add_for_all(ban, R::kKeepClear, {});
      case Ban::Kind::kFreeSide: return add_sides(ban);
    }
  }

 private:
  Relation& add_relation(const Ban& ban, R type, const std::string& target, std::vector<std::string> references, bool hard) {
    Relation& relation = write(type, {target}, std::move(references));
    relation.hard = hard;
    relation.why = ban.words;
    return relation;
  }

  const NounPhrase& noun(std::size_t item) const { return document_.items[item].noun; }

  // What stands on the floor and is in the way there.
  bool stands(std::size_t item) const {
    const CatalogEntry* entry = noun(item).entry;
    if (mount_of(noun(item)) != Mount::kFloor || (entry != nullptr && entry->thin)) return false;
    const std::string& id = scene_.objects[item].id;
    return std::ranges::none_of(scene_.relations, [&](const Relation& r) {
      return (r.type == R::kOn || r.type == R::kIn || r.type == R::kOnWall || r.type == R::kOnCeiling) &&
             std::ranges::find(r.targets, id) != r.targets.end();
    });
  }

  // It is told to be just there: that goes before.
  bool is_placed_there(const Ban& ban, std::size_t item) const {
    const std::string& id = scene_.objects[item].id;
    return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      if (!r.asked() || std::ranges::find(r.targets, id) == r.targets.end()) return false;
      if (ban.kind == Ban::Kind::kFreeRegion)
        return (r.type == R::kCenterOfRoom && ban.region == RoomRegion::kMiddle) ||
               (r.type == R::kInRegion && r.parameters.region == ban.region);
      return std::ranges::any_of(r.references, [&](const std::string& reference) { return reference.starts_with(ban.of); });
    });
  }

  void add_for_all(const Ban& ban, R type, const std::vector<std::string>& references) {
    for (std::size_t i = 0; i < document_.items.size(); ++i) {
      if (!stands(i) || is_placed_there(ban, i)) continue;
      Relation& relation = add_relation(ban, type, scene_.objects[i].id, references, ban.kind != Ban::Kind::kFreeRegion);
      if (type == R::kKeepClear) relation.parameters.region = ban.region;
    }
  }

  bool is_in(R type, const std::string& id, bool as_target) const {
    return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      const std::vector<std::string>& ids = as_target ? r.targets : r.references;
      return r.type == type && std::ranges::find(ids, id) != ids.end();
    });
  }

  // Desks, where there are any, else the seats that are at no table.
  std::vector<std::size_t> lookers() const {
    std::vector<std::size_t> desks, seats;
    for (std::size_t i = 0; i < document_.items.size(); ++i) {
      const CatalogEntry* entry = noun(i).entry;
      const std::string& id = scene_.objects[i].id;
      if (entry == nullptr || !stands(i)) continue;
      if (entry->is(Trait::kDesk)) desks.push_back(i);
      const bool seat = entry->is(Trait::kEasySeat) || entry->is(Trait::kSeat);
      if (seat && !is_in(R::kAround, id, true) && !is_in(R::kSurround, id, true)) seats.push_back(i);
    }
    return desks.empty() ? seats : desks;
  }

  // Who looks at the door does not turn the back to it; of many some have to, so there it is a wish.
  void add_back_to(const Ban& ban) {
    constexpr std::size_t kMostCertain = 2;
    const std::vector<std::size_t> all = lookers();
    for (const std::size_t i : all) add_relation(ban, R::kFacing, scene_.objects[i].id, {ban.of}, all.size() <= kMostCertain);
  }

  // The thing by its name, or what was named last before it.
  void add_sides(const Ban& ban) {
    const std::vector<Token>& tokens = document_.tokens;
    std::optional<std::size_t> meant;
    for (std::size_t i = 0; i < document_.items.size(); ++i) {
      const NounPhrase& thing = noun(i);
      // "it": also a dart board, before which nothing is to stand
      const bool before = ban.sides.size() == 1 && ban.sides.front() == Side::kFront && mount_of(thing) == Mount::kWall;
      const bool named = tokens[thing.first].begin <= ban.first && !thing.is_plural() && thing.count < 2 && (before || stands(i));
      if (ban.of.empty() ? !named : thing.head != ban.of) continue;
      meant = i;
    }
    if (!meant) return;
    for (std::size_t i = 0; i < document_.items.size(); ++i) {
      if (document_.items[i].group != document_.items[*meant].group) continue;
      const std::string& id = scene_.objects[i].id;
      if (is_in(R::kAround, id, false) || is_in(R::kSurround, id, false)) continue;  // its seats are there
      for (const Side side : ban.sides) {
        Relation& relation = add_relation(ban, R::kClearance, id, {}, true);
        relation.parameters.side = side;
        relation.parameters.depth = mm_from_m(ban.depth);
      }
    }
  }
};

}  // namespace

void add_bans(const Lexicon& lexicon, Document& document, SceneGraph& scene) {
  BanBuilder builder(lexicon, document, scene);
  for (const Ban& ban : document.bans) builder.add(ban);
}

}  // namespace layoutbox::offline
