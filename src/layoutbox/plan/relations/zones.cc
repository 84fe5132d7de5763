#include "layoutbox/plan/relations/zones.h"

#include <algorithm>
#include <iterator>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"

namespace layoutbox::offline {
namespace {

class ZoneReader {
 public:
  ZoneReader(const Lexicon& lexicon, Document& document) : catalog_(lexicon.catalog()), document_(document) {}

  void run() {
    const std::size_t said = document_.chunks.size();
    for (std::size_t c = 0; c < said; ++c) {
      if (is_named(c) || is_corner_of_thing(c)) read(c);
    }
  }

 private:
  bool is(std::size_t c, ChunkKind kind) const { return c < document_.chunks.size() && document_.chunks[c].kind == kind; }
  const NounPhrase& noun(std::size_t c) const { return document_.chunks[c].noun; }
  bool says(std::size_t c, std::initializer_list<std::string_view> words) const {
    return c < document_.chunks.size() && says_one_of(document_, document_.chunks[c].first, words);
  }

  // "a carpet corner with cushions": the carpet, and what is there with it.
  bool is_corner_of_thing(std::size_t c) const {
    if (!is(c, ChunkKind::kNoun) || noun(c).kind != NounKind::kObject || noun(c).last < noun(c).first + 2) return false;
    return says_one_of(document_, noun(c).last - 1, {"corner", "nook"});
  }

  // A part of the room that has a name of its own: no plain corner, and not the room itself.
  bool is_named(std::size_t c) const {
    if (!is(c, ChunkKind::kNoun)) return false;
    const NounPhrase& zone = noun(c);
    const bool place = zone.kind == NounKind::kCorner || zone.kind == NounKind::kAbstract || zone.kind == NounKind::kRoom;
    if (!place || !is_zone(document_.tokens[zone.last - 1].text) || zone.is_plural() || !zone.wall_word.empty() || zone.of) return false;
    if (is_told_where(c)) return row_of(zone) != nullptr;
    if (document_.rooms.empty() &&
        std::ranges::none_of(document_.items, [&](const TextItem& item) { return item.noun.first < zone.first; }))
      return false;  // "A reading corner for two children.": that is the room
    const bool room = !document_.rooms.empty() && document_.rooms.front().first == zone.first;
    if (room || is_one_of_rooms(c)) return false;
    return row_of(zone) != nullptr || !zone.attributes.empty();
  }

  // "Living area on the left: a sofa, …": no room as a whole is somewhere, and has a list after that.
  bool is_told_where(std::size_t c) const {
    if (!is(c + 1, ChunkKind::kRelation) || (c > 0 && !is(c - 1, ChunkKind::kStop))) return false;
    std::size_t at = c + 2;
    if (is(at, ChunkKind::kNoun)) ++at;
    return is(at, ChunkKind::kComma) && says(at, {":", "-"});
  }

  // "Open-plan kitchen, dining and living area: …"
  bool is_one_of_rooms(std::size_t c) const {
    if (noun(c).kind != NounKind::kRoom || c == 0 || !(is(c - 1, ChunkKind::kAnd) || is(c - 1, ChunkKind::kComma))) return false;
    for (std::size_t before = c; before-- > 0 && !is(before, ChunkKind::kStop);) {
      if (is(before, ChunkKind::kHave) || (is(before, ChunkKind::kNoun) && noun(before).kind == NounKind::kObject)) return false;
    }
    return true;
  }

  const ZoneUse* row_of(const NounPhrase& zone) const {
    const RoomKind* room = document_.rooms.empty() ? nullptr : document_.rooms.front().room;
    for (const ZoneUse& row : Groups::builtin().zones) {
      const bool here = row.rooms.empty() || (room != nullptr && std::ranges::find(row.rooms, room->id) != row.rooms.end());
      if (!here) continue;
      for (std::size_t i = zone.first; i + 1 < zone.last; ++i) {
        if (std::ranges::find(row.said, document_.tokens[i].text) != row.said.end()) return &row;
      }
    }
    return nullptr;
  }

  void read(std::size_t c) {
    Zone zone;
    zone.corner = one_of(noun(c).head, {"corner", "nook"}) || is_corner_of_thing(c);
    if (is_corner_of_thing(c)) add_items(zone, noun(c));
    zone.first = noun(c).first;
    zone.last = noun(c).last;
    std::size_t at = c + 1;
    std::size_t place = 0;
    if (is(at, ChunkKind::kRelation)) {
      const bool part = is(at + 1, ChunkKind::kNoun) && (is_part_of_room(noun(at + 1)) || !noun(at + 1).wall_word.empty());
      if (part || !is(at + 1, ChunkKind::kNoun)) {
        place = at;
        at += part ? 2 : 1;
      }
    }
    const std::size_t before = place == 0 ? place_before(c) : 0;
    // "in the reading corner a rug …", but "cushions in the reading corner, toy shelves along the window"
    const bool fronted = before == 0 && c > 0 && is(c - 1, ChunkKind::kRelation) && !(c > 1 && is(c - 2, ChunkKind::kNoun));
    read_members(zone, at, fronted);
    const ZoneUse* row = row_of(noun(c));
    if (row != nullptr) take_meaning(zone, *row);
    if (zone.items.empty() && row != nullptr && !fronted && is_brought_in(c)) furnish(zone, *row);
    if (zone.items.empty()) return;
    if (before > 0) place = before - 1;
    if (place == 0 && before == 0) take_place_behind(zone);
    const std::optional<RoomRegion> region = place > 0 || before > 0 ? region_at(place) : std::nullopt;
    if (region && std::ranges::any_of(zone.items, [&](int item) { return stands(item); }))
      put_in(zone, place, *region);
    else if (place > 0 && !std::ranges::any_of(zone.items, [&](int item) { return is_placed(item, zone.first); }))
      put(zone, place);
    document_.zones.push_back(std::move(zone));
  }

  // "At the back: a reading area with a rug": where the place stands that the sentence begins with, plus one; 0: it begins otherwise.
  std::size_t place_before(std::size_t c) const {
    std::size_t at = c;
    if (at > 0 && is(at - 1, ChunkKind::kComma)) --at;
    if (at > 1 && is(at - 1, ChunkKind::kNoun) && noun(at - 1).kind == NounKind::kRoom) --at;  // "of the room"
    const bool place = at > 0 && is(at - 1, ChunkKind::kRelation) && (at == 1 || is(at - 2, ChunkKind::kStop));
    return place && region_at(at - 1) ? at : 0;
  }

  // The list after "with", a colon, a bracket or a dash; of what the sentence begins with ("in the reading corner a …") the rest of it.
  void read_members(Zone& zone, std::size_t at, bool fronted) const {
    const bool comma = is(at, ChunkKind::kComma) && says(at, {","}) && is(at + 1, ChunkKind::kHave);
    if (comma) ++at;
    const bool opened = is(at, ChunkKind::kHave) || (is(at, ChunkKind::kComma) && says(at, {":", "(", "-"}));
    if (!opened && !fronted) return;
    const bool all = fronted || !is(at, ChunkKind::kHave);
    bool last = false;
    for (; at < document_.chunks.size(); ++at) {
      switch (document_.chunks[at].kind) {
        case ChunkKind::kStop:
        case ChunkKind::kClause:
        case ChunkKind::kWithout: return;
        case ChunkKind::kComma:
          if (says(at, {")"}) || (last && !all)) return;
          // "a waiting corner with two chairs, three mirrors with seats in front": another item of the room's list
          if (!all && !zone.items.empty() && is(at + 1, ChunkKind::kNoun) && is(at + 2, ChunkKind::kHave)) return;
          break;
        case ChunkKind::kAnd: last = true; break;
        case ChunkKind::kRelation:  // what it is by is no part of it
          if (is(at + 1, ChunkKind::kNoun) && !is_new(noun(at + 1))) ++at;
          break;
        case ChunkKind::kVerb:
          if (!fronted) return;
          break;
        case ChunkKind::kNoun:
          if (is_named(at) || noun(at).kind == NounKind::kRoom) return;
          if (is_new(noun(at))) add_items(zone, noun(at));
          break;
        default: break;
      }
    }
  }

  static bool is_new(const NounPhrase& thing) { return thing.kind == NounKind::kObject && thing.determiner != Determiner::kDefinite; }

  void add_items(Zone& zone, const NounPhrase& thing) const {
    for (std::size_t i = 0; i < document_.items.size(); ++i) {
      if (document_.items[i].noun.first == thing.first) zone.items.push_back(static_cast<int>(i));
    }
  }

  // Listed among what the room has, not what something is for: "creating a reading nook".
  bool is_brought_in(std::size_t c) const {
    if (noun(c).determiner == Determiner::kDefinite) return false;
    if (c == 0) return true;
    const ChunkKind before = document_.chunks[c - 1].kind;
    return before == ChunkKind::kHave || before == ChunkKind::kAnd || before == ChunkKind::kComma || before == ChunkKind::kThere ||
           before == ChunkKind::kCommand || before == ChunkKind::kStop;
  }

  // "a kids' corner with a small table": a table for children.
  void take_meaning(const Zone& zone, const ZoneUse& row) {
    for (const int item : zone.items) {
      NounPhrase& thing = document_.items[static_cast<std::size_t>(item)].noun;
      const auto means =
          std::ranges::find_if(row.means, [&](const auto& m) { return thing.entry != nullptr && thing.entry->id == m.first; });
      const CatalogEntry* entry = means == row.means.end() ? nullptr : catalog_.find(means->second);
      if (entry != nullptr) thing.entry = entry, thing.category = entry->id;
    }
  }

  // What is usual there, where nothing of it is named.
  void furnish(Zone& zone, const ZoneUse& row) {
    const auto is_there = [&](const std::string& kind) {
      const auto alike = [&](const NounPhrase& n) { return n.entry != nullptr && catalog_.is_a(n.entry->id, kind); };
      return std::ranges::any_of(document_.items, [&](const TextItem& item) { return alike(item.noun); }) ||
             std::ranges::any_of(document_.excluded, alike);
    };
    if (std::ranges::any_of(row.unless, is_there)) return;
    for (const auto& [kind, count] : row.has) {
      const CatalogEntry* entry = catalog_.find(kind);
      if (entry != nullptr && !is_there(kind)) add(zone, *entry, count);
    }
  }

  void add(Zone& zone, const CatalogEntry& entry, int count) {
    const int added = bring_in(document_, entry, count, zone.first, zone.last);
    std::ranges::copy(document_.mentions[static_cast<std::size_t>(added)].items, std::back_inserter(zone.items));
  }

  int mention_of(int item) const {
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      if (document_.mentions[m].introduces && contains(document_.mentions[m].items, item)) return static_cast<int>(m);
    }
    return -1;
  }

  // "a seating area with a sofa, an armchair and a low table in the corner by the window": no table is meant that has the corner to itself.
  void take_place_behind(Zone& zone) {
    const int last = mention_of(zone.items.back());
    if (zone.items.size() < 2 || last < 0) return;
    const NounPhrase& thing = document_.mentions[static_cast<std::size_t>(last)].noun;
    const bool seated = thing.entry != nullptr && (thing.entry->is(Trait::kCoffeeTable) || thing.entry->is(Trait::kEasySeat));
    const auto is_place = [&](const Link& link) {
      return link.kind == Link::Kind::kRelation && link.targets == std::vector<int>{last} && link.first >= thing.last &&
             link.references.size() == 1 && is_part_of_room(document_.mentions[static_cast<std::size_t>(link.references[0])].noun);
    };
    for (Link& link : document_.links) {
      if (!seated || !is_place(link)) continue;
      const NounPhrase& part = document_.mentions[static_cast<std::size_t>(link.references[0])].noun;
      link.targets = {mention_of(zone.items.front())};
      zone.corner |= part.kind == NounKind::kCorner && part.wall_word.empty();
    }
    if (zone.corner) {
      std::erase_if(document_.links, [&](const Link& link) {
        const bool own = link.kind == Link::Kind::kRelation && link.targets == std::vector<int>{mention_of(zone.items.front())};
        return own && link.references.size() == 1 && link.first >= thing.last &&
               document_.mentions[static_cast<std::size_t>(link.references[0])].noun.kind == NounKind::kCorner;
      });
    }
  }

  bool is_placed(int item, std::size_t zone) const {
    const int own = mention_of(item);
    return std::ranges::any_of(document_.links, [&](const Link& link) {
      return link.kind == Link::Kind::kRelation && contains(link.targets, own) && !link.references.empty() &&
             is_part_of_room(document_.mentions[static_cast<std::size_t>(link.references.front())].noun) &&
             document_.mentions[static_cast<std::size_t>(link.references.front())].noun.first != zone;
    });
  }

  // "on the west side", "at the back": the half of the room that is meant; empty: another place.
  std::optional<RoomRegion> region_at(std::size_t place) const {
    if (is(place + 1, ChunkKind::kNoun) && (is_part_of_room(noun(place + 1)) || !noun(place + 1).wall_word.empty())) {
      const NounPhrase& side = noun(place + 1);
      return side.kind == NounKind::kWall || side.kind == NounKind::kCorner ? std::nullopt : region_from_words(side.wall_word);
    }
    const PhraseSenses* senses = document_.chunks[place].phrase.senses;
    if (senses == nullptr) return {};
    const auto region = std::ranges::find(*senses, RelationType::kInRegion, &PhraseSense::type);
    if (region != senses->end()) return region->region;
    if (offline::says(*senses, RelationType::kLeftOf)) return RoomRegion::kLeft;
    return offline::says(*senses, RelationType::kRightOf) ? std::optional(RoomRegion::kRight) : std::nullopt;
  }

  // On the floor, and is no rug.
  bool stands(int item) const {
    const CatalogEntry* entry = document_.items[static_cast<std::size_t>(item)].noun.entry;
    return entry != nullptr && entry->mount == Mount::kFloor && !entry->thin;
  }

  // All that stands there and has no place of its own in the room.
  void put_in(const Zone& zone, std::size_t place, RoomRegion region) {
    const bool table = std::ranges::any_of(zone.items, [&](int item) {
      const CatalogEntry* entry = document_.items[static_cast<std::size_t>(item)].noun.entry;
      return entry != nullptr && entry->is(Trait::kTable);
    });
    for (const int item : zone.items) {
      const NounPhrase& thing = document_.items[static_cast<std::size_t>(item)].noun;
      const int target = mention_of(item);
      if (!stands(item) || target < 0 || is_placed(item, zone.first) || (table && thing.entry->is(Trait::kTableSeat))) continue;
      Link link;
      link.senses = {{RelationType::kInRegion, PhraseSense::Direction::kDirect, {}, region, {}}};
      link.targets = {target};
      link.concluded = true;
      link.first = document_.chunks[place].first;
      link.last = document_.chunks[is(place + 1, ChunkKind::kNoun) ? place + 1 : place].last;
      document_.links.push_back(std::move(link));
    }
  }

  // "a reading nook by the window: …": the first of its things stands there.
  void put(const Zone& zone, std::size_t place) {
    const Chunk& phrase = document_.chunks[place];
    const int target = mention_of(zone.items.front());
    if (phrase.phrase.senses == nullptr || target < 0) return;
    Link link;
    link.senses = *phrase.phrase.senses;
    link.targets = {target};
    if (is(place + 1, ChunkKind::kNoun)) {
      Mention part;
      part.noun = noun(place + 1);
      document_.mentions.push_back(std::move(part));
      link.references = {static_cast<int>(document_.mentions.size()) - 1};
    }
    link.concluded = true;
    link.first = phrase.first;
    link.last = document_.chunks[place + 1].last;
    document_.links.push_back(std::move(link));
  }

  const Catalog& catalog_;
  Document& document_;
};

}  // namespace

void find_zones(const Lexicon& lexicon, Document& document) { ZoneReader(lexicon, document).run(); }

}  // namespace layoutbox::offline
