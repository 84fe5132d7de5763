#include "layoutbox/plan/relations/table_seats.h"

#include <algorithm>
#include <map>
#include <optional>

#include "layoutbox/base/units.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/mention_links.h"
#include "layoutbox/plan/relations/seat_builder.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

class TableSeats {
 public:
  TableSeats(const Lexicon& lexicon, Document& document)
      : catalog_(lexicon.catalog()), document_(document), builder_(lexicon, document), links_(document) {
    if (!document.rooms.empty() && document.rooms.front().room != nullptr) room_ = document.rooms.front().room->id;
    counter_named_ = std::ranges::any_of(
        document.items, [](const TextItem& item) { return item.noun.entry != nullptr && item.noun.entry->is(Trait::kCounter); });
    for (std::size_t m = 0; m < document.mentions.size(); ++m) look_for_loose(static_cast<int>(m));
  }

  void run(std::size_t said) {
    for (std::size_t m = 0; m < said; ++m) seat_table(static_cast<int>(m));
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) look_for_desk(static_cast<int>(m));
    for (std::size_t m = 0; m < said; ++m) share_seats(static_cast<int>(m));
    for (std::size_t m = 0; m < said; ++m) share_companions(static_cast<int>(m));
    for (const Link& link : document_.links) share_stands(link), spread(link);
    for (std::size_t m = 0; m < said; ++m) spread_cloths(static_cast<int>(m));
    for (std::size_t m = 0; m < said; ++m) gather_loose(static_cast<int>(m));
  }

 private:
  static constexpr auto kAnyLink = [](const Link&) { return true; };

  Mention& mention(int m) { return document_.mentions[static_cast<std::size_t>(m)]; }
  const Mention& mention(int m) const { return document_.mentions[static_cast<std::size_t>(m)]; }

  static bool names_things(const Mention& mention) { return mention.introduces && mention.noun.kind == NounKind::kObject; }
  bool names_seat(const Mention& mention) const { return names_things(mention) && is_seat(catalog_, mention.noun); }
  static bool is_stool(const NounPhrase& noun) { return one_of(noun.head, WordSet::kStools); }

  // What a small child sits on comes besides the seats that are told.
  static bool is_high_chair(const NounPhrase& noun) { return noun.name == "high chair"; }

  bool is_upright(const NounPhrase& noun) const {
    const bool easy = noun.entry != nullptr && noun.entry->is(Trait::kEasySeat);  // "a lounge chair"
    return one_of(noun.head, WordSet::kUprightSeats) && !easy;
  }

  // "a bench with stools"
  bool stands_by_a_thing(int seat) const {
    return links_.is_placed_by(seat, [](const Mention& other) { return other.noun.kind == NounKind::kObject && !other.items.empty(); });
  }
  bool is_told_elsewhere(int seat) const {
    const NounPhrase& noun = mention(seat).noun;
    return is_stool(noun) && noun.count == 0 && stands_by_a_thing(seat);
  }

  // A seat that may be any table's: none is named that it stands at.
  void look_for_loose(int seat) {
    const NounPhrase& noun = mention(seat).noun;
    if (!names_seat(mention(seat)) || !is_upright(noun) || one_of(noun.name, {"piano bench", "piano stool"}) || is_high_chair(noun)) return;
    if (one_of(noun.head, WordSet::kStools) && counter_named_) return;  // "an island and four stools, a table for six"
    const auto at_a_table = [&](const Mention& other) { return !other.items.empty() && is_table(catalog_, other.noun); };
    if (is_told_elsewhere(seat) || links_.is_placed_by(seat, at_a_table)) return;
    const bool bench = noun.head == "bench" && !noun.is_plural();
    (bench ? loose_bench_ : loose_seat_) = true;
    if (noun.plural && noun.count == 0) uncounted_ = seat;
  }

  // "a table for six, with chairs": as many; "with a bench": that is all; "with a bench and chairs": half of them on the bench.
  // "a long table for eight, chairs": as many of those that stand by themselves as all such tables are for.
  bool seats_named(const Mention& table, int seats) {
    constexpr int kOfBench = 3;  // sit on one
    const int all = seats * static_cast<int>(table.items.size());
    if (uncounted_ >= 0) builder_.grow(uncounted_, std::min(uncounted_seats_ += all, kMostPeople));
    bool named = loose_seat_ || (loose_bench_ && all <= kOfBench);
    const std::vector<int> placed = links_.placed_by(table, kAnyLink);
    const bool bench =
        std::ranges::any_of(placed, [&](int seat) { return names_seat(mention(seat)) && mention(seat).noun.head == "bench"; });
    for (const int seat : placed) {
      const NounPhrase& noun = mention(seat).noun;
      if (!names_seat(mention(seat)) || is_high_chair(noun)) continue;
      named = true;
      if (noun.count == 0 && noun.plural && is_upright(noun)) builder_.grow(seat, bench && noun.head != "bench" ? all - all / 2 : all);
    }
    return named;
  }

  // Two sit side by side.
  void widen_for_two(int m) {
    for (const int item : mention(m).items) {
      SaidSize& size = document_.items[static_cast<std::size_t>(item)].noun.size;
      if (!size.any()) size.width = m_from_mm(measures().desk_for_two);
    }
  }

  // "a bar along the window, with stools": as many as it takes side by side.
  void line_counter(const Mention& table) {
    const CatalogEntry& entry = *table.noun.entry;
    const Seating* seating = entry.is(Trait::kCounter) ? seating_at(entry) : nullptr;
    if (seating == nullptr || seating->sizes.empty()) return;
    Size size = entry.size.usual;
    if (const auto& said = table.noun.size.width) size.width = mm_from_m(*said);
    const int seats = seats_at_size(*seating, false, size) * static_cast<int>(table.items.size());
    for (const int m : links_.placed_by(table, [](const Link& link) { return link.kind == Link::Kind::kHave; })) {
      const NounPhrase& noun = mention(m).noun;
      const bool stools = noun.kind == NounKind::kObject && noun.entry != nullptr && noun.entry->is(Trait::kTableSeat);
      if (stools && noun.count == 0 && noun.plural && !noun.vague) builder_.grow(m, seats);
    }
  }

  const Seating* seating_at(const CatalogEntry& table) {
    const auto [found, is_new] = seatings_.try_emplace(&table, nullptr);
    if (is_new) found->second = Groups::builtin().seating_at(catalog_, table, room_);
    return found->second;
  }

  // What one sits on at such a table; null: nobody sits there.
  const CatalogEntry* seat_at(const CatalogEntry& table) {
    const Seating* seating = seating_at(table);
    return seating == nullptr ? nullptr : catalog_.find(seating->seat);
  }

  void seat_table(int m) {
    if (!names_things(mention(m)) || mention(m).noun.entry == nullptr || !is_table(catalog_, mention(m).noun)) return;
    const Mention table = mention(m);
    int seats = builder_.seats_said(table);
    // "with its back to the dining table, … a dining table for six": told of it later
    const std::vector<int> told = seats == 0 && table.items.size() == 1 ? links_.of_same(table) : std::vector<int>{};
    for (const int same : told) seats = std::max(seats, std::min(mention(same).noun.seats, kMostPeople));
    if (seats == 0) {
      line_counter(table);
      return;
    }
    if (seats == 2 && table.noun.entry->is(Trait::kDesk)) widen_for_two(m);
    if (seats_named(table, seats)) return;
    const CatalogEntry* seat = seat_at(*table.noun.entry);
    if (seat == nullptr || builder_.excluded(*seat)) return;
    const int all = std::min(seats * static_cast<int>(table.items.size()), kMostPeople);
    builder_.seat_at_table(builder_.add(*seat, all, table.noun), m, seats > 1);
    links_.follow();
  }

  // Several that seats may be shared out to.
  static bool is_shared_host(const Mention& host) { return names_things(host) && host.noun.entry != nullptr && host.items.size() > 1; }

  void look_for_desk(int m) {
    if (!is_shared_host(mention(m)) || !mention(m).noun.entry->is(Trait::kDeskLike)) return;
    if (const CatalogEntry* seat = seat_at(*mention(m).noun.entry)) desk_of_[seat] = m;
  }

  // The first of the tables that they stand at.
  std::optional<int> host_of(int seats) const {
    std::optional<int> first;
    for (const int by : links_.hosts_of(seats)) {
      for (const int host : links_.of_same(mention(by))) {
        if (is_shared_host(mention(host)) && host < first.value_or(host + 1)) first = host;
      }
    }
    return first;
  }

  bool is_for_several(const CatalogEntry& table) {
    const Seating* seating = seating_at(table);
    return seating != nullptr && !seating->seat.empty() && seats_at_size(*seating, false, table.size.usual) > 1;
  }

  // How many stand at each of those tables.
  int places_at(const NounPhrase& host, const NounPhrase& seat) {
    const bool one_each = host.entry->is(Trait::kDeskLike) || host.entry->is(Trait::kDesk) || host.entry->is(Trait::kCounter);
    const bool flanks = seat.entry->is(Trait::kChair) || seat.head == "bench" ||  // "long tables with benches"
                        (is_stool(seat) && is_for_several(*host.entry));
    const bool at_sides = host.entry->is(Trait::kTable) && host.entry->used_sides.size() > 1 && flanks;
    return one_each || !at_sides ? 1 : 2;
  }

  // "two small tables with chairs": two at each of them; "four potter's wheels, stools": one for each.
  void share_seats(int m) {
    const NounPhrase& noun = mention(m).noun;
    if (!names_seat(mention(m)) || noun.entry == nullptr || !noun.plural || noun.count != 0 || mention(m).items.empty()) return;
    std::optional<int> host = host_of(m);
    const int places = host ? places_at(mention(*host).noun, noun) : 1;
    if (const auto desk = desk_of_.find(noun.entry); !host && desk != desk_of_.end()) host = desk->second;
    if (host) builder_.grow(m, static_cast<int>(mention(*host).items.size()) * places);
  }

  // "three chairs and mirrors" of a salon: one for each, where such things have one each.
  void share_companions(int m) {
    const NounPhrase noun = mention(m).noun;
    if (m == 0 || !names_things(mention(m)) || noun.entry == nullptr || !noun.plural || noun.count != 0 || mention(m).items.empty() ||
        noun.first == 0)
      return;
    const Mention& before = mention(m - 1);
    const bool joined = names_things(before) && before.noun.entry != nullptr && before.noun.last + 1 == noun.first &&
                        one_of(document_.tokens[noun.first - 1].text, {"and", "with", "&"});
    if (!joined || before.items.size() <= mention(m).items.size()) return;
    const auto goes_with = [&](const Companion& row) {
      return row.each == 1 && catalog_.is_a(before.noun.entry->id, row.of) && catalog_.is_a(noun.entry->id, row.adds);
    };
    if (std::ranges::any_of(Groups::builtin().companions, goes_with)) builder_.grow(m, static_cast<int>(before.items.size()));
  }

  std::vector<int> seats_at(const Mention& table) const {
    std::vector<int> placed = links_.placed_by(table, kAnyLink);
    std::erase_if(placed, [&](int m) { return !names_seat(mention(m)); });
    return placed;
  }

  // "a round table, four microphones, four swivel chairs": at the one table that is named, where each would need a desk of its own;
  // "two long tables with lamps, wooden chairs": as many as they take.
  void gather_loose(int seats) {
    const NounPhrase& noun = mention(seats).noun;
    constexpr std::size_t kGroup = 3;
    const bool uncounted = noun.plural && noun.count == 0;
    if (!names_seat(mention(seats)) || noun.entry == nullptr || !noun.entry->is(Trait::kChair) || !links_.hosts_of(seats).empty()) return;
    if (!uncounted && mention(seats).items.size() < kGroup) return;
    std::optional<int> table;
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const Mention& other = document_.mentions[m];
      // not the cash desk of a salon with three chairs
      const bool such = names_things(other) && other.noun.entry != nullptr && is_table(catalog_, other.noun) &&
                        is_for_several(*other.noun.entry) && !other.noun.entry->is(Trait::kOpenToRoom);
      if (!such) continue;
      if (table) return;
      table = static_cast<int>(m);
    }
    if (!table || !seats_at(mention(*table)).empty()) return;
    if (uncounted) {
      constexpr int kMostAtOne = 6;
      const Mention& at = mention(*table);
      const int each = std::min(seats_at_size(*seating_at(*at.noun.entry), false, at.noun.entry->size.usual), kMostAtOne);
      builder_.grow(seats, each * static_cast<int>(at.items.size()));
    }
    builder_.seat_at_table(seats, *table, true);
    links_.follow();
  }

  // "three cameras on tripods": one for each, where one of them takes no more.
  void share_stands(const Link& link) {
    const auto on = [](const PhraseSense& sense) { return sense.type == RelationType::kOn; };
    const bool single = link.kind == Link::Kind::kRelation && link.targets.size() == 1 && link.references.size() == 1;
    if (single) share_pictures(link);
    if (!single || std::ranges::none_of(link.senses, on)) return;
    const int things = static_cast<int>(mention(link.targets[0]).items.size());
    const Mention& stand = mention(link.references[0]);
    const NounPhrase& noun = stand.noun;
    if (!stand.introduces || stand.items.empty() || noun.kind != NounKind::kObject || noun.entry == nullptr || !noun.plural ||
        noun.count != 0)
      return;
    const Size& size = noun.entry->size.usual;
    const bool small = noun.entry->mount == Mount::kFloor && !is_table(catalog_, noun) && !noun.entry->is(Trait::kShelving) &&
                       std::min(size.width, size.depth) <= measures().stand_for_one + 100 && std::max(size.width, size.depth) <= 1000;
    if (small && things > static_cast<int>(stand.items.size())) builder_.grow(link.references[0], things);
  }

  bool is_uncounted(const Mention& things) const {
    return names_things(things) && things.noun.entry != nullptr && things.noun.plural && things.noun.count == 0 &&
           things.noun.determiner == Determiner::kNone && !things.noun.vague && !things.items.empty();
  }

  // "three tables with six chairs each, green lamps on the tables": one on each.
  void spread(const Link& link) {
    constexpr std::size_t kMost = 24;
    const auto on = [](const PhraseSense& sense) { return sense.type == RelationType::kOn; };
    if (link.kind != Link::Kind::kRelation || link.targets.size() != 1 || link.references.size() != 1) return;
    const Mention& things = mention(link.targets[0]);
    const std::size_t hosts = mention(link.references[0]).items.size();
    if (std::ranges::none_of(link.senses, on) || !is_uncounted(things) || things.noun.entry->mount != Mount::kSurface) return;
    if (hosts > things.items.size() && hosts <= kMost) builder_.grow(link.targets[0], static_cast<int>(hosts));
  }

  // "ten tables, red checked cloths": one on each.
  void spread_cloths(int m) {
    if (!is_uncounted(mention(m)) || !catalog_.is_a(mention(m).noun.entry->id, "tablecloth") || !links_.hosts_of(m).empty()) return;
    std::size_t tables = 0;
    for (const Mention& other : document_.mentions) {
      const bool such = names_things(other) && other.noun.entry != nullptr && is_table(catalog_, other.noun) &&
                        !other.noun.entry->is(Trait::kCounter) && !other.noun.entry->is(Trait::kDesk);
      if (such) tables += other.items.size();
    }
    if (tables > mention(m).items.size()) builder_.grow(m, static_cast<int>(tables));
  }

  // "a row of tables under framed pictures": one over each.
  void share_pictures(const Link& link) {
    const auto under = [](const PhraseSense& sense) { return sense.type == RelationType::kUnder; };
    const Mention& over = mention(link.references[0]);
    const Mention& below = mention(link.targets[0]);
    if (std::ranges::none_of(link.senses, under) || !names_things(over) || !names_things(below) || over.noun.entry == nullptr) return;
    const bool uncounted = over.noun.plural && over.noun.count == 0 && over.noun.determiner == Determiner::kNone;
    if (uncounted && over.noun.entry->mount == Mount::kWall && below.items.size() > over.items.size())
      builder_.grow(link.references[0], static_cast<int>(below.items.size()));
  }

  const Catalog& catalog_;
  Document& document_;
  SeatBuilder builder_;
  MentionLinks links_;
  std::string room_;
  bool counter_named_ = false;
  bool loose_seat_ = false, loose_bench_ = false;
  int uncounted_ = -1;                                      // the last of the loose seats of which nobody says how many
  int uncounted_seats_ = 0;                                 // and how many those tables have
  std::map<const CatalogEntry*, const Seating*> seatings_;  // by table, as they were asked for
  std::map<const CatalogEntry*, int> desk_of_;              // by seat, the last of the desks that such seats stand at
};

}  // namespace

void seat_tables(const Lexicon& lexicon, Document& document, std::size_t said) { TableSeats(lexicon, document).run(said); }

}  // namespace layoutbox::offline
