#include "layoutbox/plan/offline/people.h"

#include <algorithm>

#include "layoutbox/base/units.h"
#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/english.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/noun_phrase_parts.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/offline/splice.h"
#include "layoutbox/plan/offline/word_sets.h"

namespace layoutbox::offline {
namespace {

using Class = WordClass;

constexpr int kMostPeople = 60;

bool is_word(const Token& token, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), token.text) != words.end();
}

// "six-seater", "8-person": how many; 0 where it says no such thing.
int seats_in(const Lexicon& lexicon, const std::string& attribute) {
  const std::size_t space = attribute.find_first_of("- ");
  if (space == std::string::npos) return 0;
  const std::string number = attribute.substr(0, space), rest = attribute.substr(space + 1);
  if (!one_of(rest, WordSet::kSeatCounts)) return 0;
  const std::vector<Token> tokens = tokenize(number);
  if (tokens.empty()) return 0;
  if (tokens.front().kind == Token::Kind::kNumber) return static_cast<int>(std::clamp(tokens.front().number, 0.0, 1.0 * kMostPeople));
  const Match match = lexicon.find(tokens, 0, Class::kNumber);
  return match.length > 0 ? static_cast<int>(meaning_of(match, Class::kNumber)->value) : 0;
}

class PeopleReader {
 public:
  PeopleReader(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), catalog_(lexicon.catalog()), document_(document) {}

  void run() {
    // What is added has no seats of its own to look for.
    const std::size_t said = document_.mentions.size();
    if (document_.people > 0) add_for_room();
    for (std::size_t m = 0; m < said; ++m) seat_table(static_cast<int>(m));
    for (std::size_t m = 0; m < said; ++m) share_seats(static_cast<int>(m));
    for (std::size_t m = 0; m < said; ++m) share_companions(static_cast<int>(m));
    for (const Link& link : document_.links) share_stands(link);
  }

 private:
  Mention& mention(int m) { return document_.mentions[static_cast<std::size_t>(m)]; }
  const Mention& mention(int m) const { return document_.mentions[static_cast<std::size_t>(m)]; }

  int seats_said(const Mention& table) const {
    if (table.items.empty()) return 0;
    const NounPhrase& noun = document_.items[static_cast<std::size_t>(table.items.front())].noun;
    const bool desk = noun.entry != nullptr && noun.entry->is(Trait::kDesk);
    // "12 double desks for 24 pupils", "five tables for 20 guests": all of them together.
    const int tables = static_cast<int>(table.items.size());
    constexpr int kMostAtOne = 10;
    if (tables > 1 && noun.seats % tables == 0 && noun.seats >= tables && (desk || noun.seats > kMostAtOne)) return noun.seats / tables;
    if (noun.seats > 0) return std::min(noun.seats, kMostPeople);
    if (desk && std::ranges::find(noun.attributes, "double") != noun.attributes.end()) return 2;
    for (const std::string& attribute : noun.attributes) {
      if (const int seats = seats_in(lexicon_, attribute); seats > 0) return seats;
    }
    return 0;
  }

  // Adds so many of a kind, as if "for eight" named them.
  int add(const CatalogEntry& entry, int count, const NounPhrase& by) {
    return bring_in(document_, entry, std::min(count, kMostPeople), by.first, by.last);
  }

  void relate(Link::Kind kind, PhraseSenses senses, int target, int reference) {
    Link link;
    link.kind = kind;
    link.senses = std::move(senses);
    link.targets = {target};
    if (reference >= 0) link.references = {reference};
    link.concluded = true;
    link.first = mention(target).noun.first;
    link.last = mention(target).noun.last;
    document_.links.push_back(std::move(link));
  }

  void seat_at_table(int seats, int table, bool several) {
    if (several)
      relate(Link::Kind::kRelation, {{RelationType::kAround, Direction::kDirect, {}, {}, {}}}, seats, table);
    else
      relate(Link::Kind::kHave, {}, seats, table);
  }

  // Is a mention placed by such a one?
  template <class Predicate>
  bool is_placed_by(int seat, Predicate is_such) const {
    return std::ranges::any_of(document_.links, [&](const Link& link) {
      return contains(link.targets, seat) &&
             std::ranges::any_of(link.references, [&](int reference) { return is_such(mention(reference)); });
    });
  }

  // By what else is named: a desk for its chair.
  bool belongs_elsewhere(int seat, const Mention& table) const {
    return is_placed_by(
        seat, [&](const Mention& other) { return !other.items.empty() && other.items != table.items && is_table(catalog_, other.noun); });
  }

  bool stands_by_a_thing(int seat) const {
    return is_placed_by(seat, [](const Mention& other) { return other.noun.kind == NounKind::kObject && !other.items.empty(); });
  }

  bool at_table(int seat, const Mention& table) const {
    return is_placed_by(seat, [&](const Mention& other) { return other.items == table.items; });
  }

  bool stands_at_counter(int seat) const {
    return is_placed_by(seat, [](const Mention& other) { return other.noun.entry != nullptr && other.noun.entry->is(Trait::kCounter); });
  }

  bool counter_named() const {
    return std::ranges::any_of(document_.items,
                               [](const TextItem& item) { return item.noun.entry != nullptr && item.noun.entry->is(Trait::kCounter); });
  }

  // "a table for six, with chairs": as many; "with a bench": that is all.
  bool seats_named(const Mention& table, int seats) {
    bool named = false;
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const int seat = static_cast<int>(m);
      const NounPhrase noun = mention(seat).noun;
      if (!mention(seat).introduces || noun.kind != NounKind::kObject || !is_seat(catalog_, noun)) continue;
      const bool easy = noun.entry != nullptr && noun.entry->is(Trait::kEasySeat);  // "a lounge chair"
      const bool upright = one_of(noun.head, WordSet::kUprightSeats) && !easy;
      const bool here = at_table(seat, table);
      if (!here && one_of(noun.head, WordSet::kStools) && counter_named()) continue;  // "an island and four stools, a table for six"
      if (!here && (!upright || belongs_elsewhere(seat, table) || one_of(noun.name, {"piano bench", "piano stool", "high chair"})))
        continue;
      constexpr int kOfBench = 3;  // sit on one
      const int all = seats * static_cast<int>(table.items.size());
      if (!here && noun.head == "bench" && !noun.is_plural() && all > kOfBench) continue;
      if (!here && one_of(noun.head, {"stool", "barstool"}) && noun.count == 0 && stands_by_a_thing(seat))
        continue;  // "a bench with stools"
      named = true;
      if (noun.count == 0 && noun.plural && upright && here) grow(seat, seats * static_cast<int>(table.items.size()));
    }
    return named;
  }

  void grow(int m, int count) {
    const TextItem first = document_.items[static_cast<std::size_t>(mention(m).items.front())];
    while (static_cast<int>(mention(m).items.size()) < std::min(count, kMostPeople)) {
      mention(m).items.push_back(static_cast<int>(document_.items.size()));
      document_.items.push_back(first);
    }
  }

  // Two sit side by side at a desk of 1.2 m (DIN EN 1729, desks for two).
  void widen_for_two(int m) {
    for (const int item : mention(m).items) {
      SaidSize& size = document_.items[static_cast<std::size_t>(item)].noun.size;
      if (!size.any()) size.width = 1.2;
    }
  }

  // "a bar along the window, with stools": as many as it takes side by side.
  void line_counter(const Mention& table) {
    const CatalogEntry& entry = *table.noun.entry;
    const std::string room = document_.rooms.empty() || document_.rooms.front().room == nullptr ? "" : document_.rooms.front().room->id;
    const Seating* seating = entry.is(Trait::kCounter) ? Groups::builtin().seating_at(catalog_, entry, room) : nullptr;
    if (seating == nullptr || seating->sizes.empty()) return;
    Size size = entry.size.usual;
    if (const auto& said = table.noun.size.width) size.width = mm_from_m(*said);
    const int seats = seats_at_size(*seating, false, size) * static_cast<int>(table.items.size());
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const NounPhrase& noun = mention(static_cast<int>(m)).noun;
      const bool stools = noun.kind == NounKind::kObject && noun.entry != nullptr && noun.entry->is(Trait::kTableSeat);
      const bool its_own = std::ranges::any_of(document_.links, [&](const Link& link) {
        return link.kind == Link::Kind::kHave && contains(link.targets, static_cast<int>(m)) &&
               std::ranges::any_of(link.references, [&](int reference) { return mention(reference).items == table.items; });
      });
      if (stools && noun.count == 0 && noun.plural && !noun.vague && its_own) grow(static_cast<int>(m), seats);
    }
  }

  void seat_table(int m) {
    const Mention table = mention(m);
    if (!table.introduces || table.noun.kind != NounKind::kObject || table.noun.entry == nullptr || !is_table(catalog_, table.noun)) return;
    const int seats = seats_said(table);
    if (seats == 0) {
      line_counter(table);
      return;
    }
    if (seats == 2 && table.noun.entry->is(Trait::kDesk)) widen_for_two(m);
    if (seats_named(table, seats)) return;
    const CatalogEntry* seat = lexicon_.seat_at(*table.noun.entry);
    if (seat == nullptr || excluded(*seat)) return;
    const bool dines = table.noun.entry->id == "table" && !document_.rooms.empty() && document_.rooms.front().room != nullptr &&
                       one_of(document_.rooms.front().room->id, {"dining_room", "kitchen", "restaurant"});
    const CatalogEntry* dining = dines ? catalog_.find("dining_chair") : nullptr;
    const int all = std::min(seats * static_cast<int>(table.items.size()), kMostPeople);
    seat_at_table(add(dining != nullptr ? *dining : *seat, all, table.noun), m, seats > 1);
  }

  // "two small tables with chairs": two at each of them; "four potter's wheels, stools": one for each.
  void share_seats(int m) {
    const NounPhrase noun = mention(m).noun;
    if (!mention(m).introduces || noun.kind != NounKind::kObject || noun.entry == nullptr || !noun.plural || noun.count != 0) return;
    if (!is_seat(catalog_, noun) || mention(m).items.empty()) return;
    int tables = 0, places = 0;
    for (std::size_t t = 0; t < document_.mentions.size(); ++t) {
      const Mention& table = document_.mentions[t];
      const NounPhrase& host = table.noun;
      if (!table.introduces || host.kind != NounKind::kObject || host.entry == nullptr || table.items.size() < 2) continue;
      const CatalogEntry* seat = lexicon_.seat_at(*host.entry);
      if (at_table(m, table)) {
        const bool one_each = host.entry->is(Trait::kDeskLike) || host.entry->is(Trait::kDesk) || host.entry->is(Trait::kCounter);
        const bool flanks =
            noun.entry->is(Trait::kChair) || noun.head == "bench" ||  // "long tables with benches"
            (one_of(noun.head, {"stool", "barstool"}) && one_of(host.entry->id, {"table", "dining_table", "bistro_table", "bar_table"}));
        const bool at_sides = host.entry->is(Trait::kTable) && host.entry->used_sides.size() > 1 && flanks;
        tables = static_cast<int>(table.items.size()), places = one_each || !at_sides ? 1 : 2;
        break;
      }
      if (seat != nullptr && seat->id == noun.entry->id && host.entry->is(Trait::kDeskLike))
        tables = static_cast<int>(table.items.size()), places = 1;
    }
    if (tables > 0 && static_cast<int>(mention(m).items.size()) < tables * places) grow(m, tables * places);
  }

  // "three chairs and mirrors" of a salon: one for each, where such things have one each.
  void share_companions(int m) {
    const NounPhrase noun = mention(m).noun;
    if (!mention(m).introduces || noun.kind != NounKind::kObject || noun.entry == nullptr || !noun.plural || noun.count != 0) return;
    if (mention(m).items.empty() || noun.first == 0) return;
    const auto before = std::ranges::find_if(document_.mentions, [&](const Mention& other) {
      return other.introduces && other.noun.kind == NounKind::kObject && other.noun.entry != nullptr && other.noun.last + 1 == noun.first;
    });
    const bool joined = before != document_.mentions.end() && is_word(document_.tokens[noun.first - 1], {"and", "with", "&"});
    if (!joined || before->items.size() <= mention(m).items.size()) return;
    const auto goes_with = [&](const Companion& row) {
      return row.each == 1 && catalog_.is_a(before->noun.entry->id, row.of) && catalog_.is_a(noun.entry->id, row.adds);
    };
    if (std::ranges::any_of(Groups::builtin().companions, goes_with)) grow(m, static_cast<int>(before->items.size()));
  }

  // "three cameras on tripods": one for each, where one of them takes no more.
  void share_stands(const Link& link) {
    const auto on = [](const PhraseSense& sense) { return sense.type == RelationType::kOn; };
    if (link.kind != Link::Kind::kRelation || link.targets.size() != 1 || link.references.size() != 1 ||
        std::ranges::none_of(link.senses, on))
      return;
    const int things = static_cast<int>(mention(link.targets[0]).items.size());
    const Mention& stand = mention(link.references[0]);
    const NounPhrase& noun = stand.noun;
    constexpr double kForOne = 0.7;  // metres: a plinth, a tripod
    if (!stand.introduces || stand.items.empty() || noun.kind != NounKind::kObject || noun.entry == nullptr || !noun.plural ||
        noun.count != 0)
      return;
    const Size& size = noun.entry->size.usual;
    const bool small = noun.entry->mount == Mount::kFloor && !is_table(catalog_, noun) && !noun.entry->is(Trait::kShelving) &&
                       std::min(size.width, size.depth) <= kForOne * 1000 + 100 && std::max(size.width, size.depth) <= 1000;
    if (small && things > static_cast<int>(stand.items.size())) grow(link.references[0], things);
  }

  bool excluded(const CatalogEntry& entry) const {
    return std::any_of(document_.excluded.begin(), document_.excluded.end(),
                       [&](const NounPhrase& n) { return n.entry != nullptr && catalog_.is_a(entry.id, n.entry->id); });
  }

  // The first mention of things like that, or -1: any desk for a desk, any bed for a bed.
  int named(const CatalogEntry& kind) const {
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const Mention& one = document_.mentions[m];
      if (!one.introduces || one.noun.kind != NounKind::kObject) continue;
      const CatalogEntry* entry = one.noun.entry;
      const auto both = [&](Trait trait) { return kind.is(trait) && entry != nullptr && entry->is(trait); };
      // Where everybody has a desk, a meeting table is none.
      const bool meeting = kind.is(Trait::kDeskLike) && entry != nullptr && !entry->is(Trait::kDeskLike) && entry->id != "table";
      const bool tables =
          both(Trait::kTable) && !meeting && !one_of(entry->id, {"coffee_table", "side_table", "console_table", "changing_table"});
      // A teacher's desk and a reception desk are none of those that everybody has.
      if (entry != nullptr && entry->is(Trait::kOpenToRoom) && !kind.is(Trait::kOpenToRoom)) continue;
      const bool rows = one.noun.rows > 0 && is_seat(catalog_, one.noun);  // "two rows of recliners" for whom a cinema is
      const bool seats = rows || (kind.is(Trait::kChair) && one_of(one.noun.head, WordSet::kUprightSeats));
      if (both(Trait::kBed) || tables || seats || (entry != nullptr && catalog_.is_a(entry->id, kind.id))) return static_cast<int>(m);
    }
    return -1;
  }

  // "a restaurant for 30, tables for two and four": so many of each that all have a place; whether several kinds are named.
  bool share_tables(int people) {
    std::vector<int> kinds;
    int seats = 0;
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const Mention& table = document_.mentions[m];
      const NounPhrase& noun = table.noun;
      if (!table.introduces || noun.kind != NounKind::kObject || noun.entry == nullptr || !is_table(catalog_, noun)) continue;
      if (!noun.plural || noun.count > 0 || seats_said(table) == 0) continue;
      kinds.push_back(static_cast<int>(m));
      seats += seats_said(table);
    }
    if (kinds.size() < 2) return false;
    for (const int kind : kinds) grow(kind, std::max(1, people / seats));
    share_contents(kinds);
    return true;
  }

  // "to seat eight: a table, chairs": as many as people; whether any are named.
  bool grow_seats(const Lexicon::Set& needs, int people) {
    const int seats = needs.size() > 1 ? named(*needs[1].first) : -1;
    if (seats >= 0 && one_of(mention(seats).noun.head, WordSet::kStools) && stands_at_counter(seats)) return false;
    if (seats >= 0 && mention(seats).noun.plural && mention(seats).noun.count == 0) grow(seats, people);
    return seats >= 0;
  }

  // "computer tables with PCs" for twelve: as many PCs; "desks, each with a chair" where `before` were all of them: as many chairs.
  void grow_contents(int host, const std::vector<int>& before) {
    for (Mention& each : document_.mentions) {
      if (before.size() > 1 && each.items == before) each.items = mention(host).items;
    }
    for (const Link& link : document_.links) {
      const auto is_host = [&](int reference) { return mention(reference).items == mention(host).items; };
      if (link.kind != Link::Kind::kHave || std::ranges::none_of(link.references, is_host)) continue;
      for (const int m : link.targets) {
        const NounPhrase& noun = mention(m).noun;
        const bool carried = noun.kind == NounKind::kObject && mount_of(noun) == Mount::kSurface;
        const bool each = !noun.plural && before.size() > 1 && mention(m).items.size() == before.size();
        if (each || (carried && noun.plural && noun.count == 0)) grow(m, static_cast<int>(mention(host).items.size()));
      }
    }
  }

  // "tables for two and four with tablecloths": each of them has one.
  void share_contents(const std::vector<int>& hosts) {
    int all = 0;
    for (const int host : hosts) all += static_cast<int>(mention(host).items.size());
    for (Link& link : document_.links) {
      if (link.kind != Link::Kind::kHave || !contains(link.references, hosts.back())) continue;
      for (const int m : link.targets) {
        const NounPhrase& noun = mention(m).noun;
        const bool carried = noun.kind == NounKind::kObject && mount_of(noun) == Mount::kSurface;
        if (!carried || !noun.plural || noun.count > 0) continue;
        grow(m, all);
        link.references = hosts;
      }
    }
  }

  void become(int m, const CatalogEntry& entry) {
    const auto to_entry = [&](NounPhrase& noun) { noun.entry = &entry, noun.category = entry.id; };
    to_entry(mention(m).noun);
    for (const int item : mention(m).items) to_entry(document_.items[static_cast<std::size_t>(item)].noun);
  }

  // "an office for three": desks and chairs, where none are named.
  void add_for_room() {
    const auto room = std::find_if(document_.rooms.begin(), document_.rooms.end(), [](const NounPhrase& r) { return r.room != nullptr; });
    if (room == document_.rooms.end() || document_.items.empty()) return;
    const std::string id(document_.young ? lexicon_.young_room(room->room->id) : room->room->id);
    const Lexicon::Set* needs = lexicon_.needs_in(id);
    if (needs == nullptr) return;
    const auto& [main, persons] = needs->front();
    const bool seats_follow = needs->size() > 1;
    const int people = std::min(document_.people, kMostPeople);
    if (share_tables(people)) return;
    int host = named(*main);
    // "an office for twelve with plants between the desks": twelve of them.
    const bool rows = host >= 0 && mention(host).noun.rows > 0 && mention(host).noun.vague;
    if (host >= 0 && persons == 1 && mention(host).noun.plural && (mention(host).noun.count == 0 || rows)) {
      const int at_each = std::max({mention(host).noun.seats, seats_said(mention(host)), 1});  // "tables in groups of four", "double desks"
      const std::vector<int> before = mention(host).items;
      grow(host, (people + at_each - 1) / at_each);
      grow_contents(host, before);
      constexpr int kMostInRow = 12;
      if (rows && people > kMostInRow * mention(host).noun.rows) mention(host).noun.rows = 0;  // as many rows as there is room for
      if (mention(host).noun.entry->id == "seat") become(host, *main);
      if (at_each > 1) return;
      if (mention(host).noun.entry->id == "table") become(host, *main);  // "a classroom for 24 with tables"
    } else if (host >= 0 && (persons > 0 || !seats_follow)) {
      grow_seats(*needs, people);  // "a laboratory for 16 students with four benches, stools"
      return;
    }
    if (host < 0) {
      if (excluded(*main)) return;
      const int count = persons > 0 ? (people + persons - 1) / persons : 1;
      host = add(*main, count, *room);
      constexpr int kLeastInGrid = 6;
      if (persons == 1 && count >= kLeastInGrid)
        relate(Link::Kind::kRelation, {{RelationType::kGrid, Direction::kAlone, {}, {}, {}}}, host, -1);
    }
    if (!seats_follow || grow_seats(*needs, people) || excluded(*(*needs)[1].first)) return;
    seat_at_table(add(*(*needs)[1].first, people, *room), host, persons != 1);
  }

  const Lexicon& lexicon_;
  const Catalog& catalog_;
  Document& document_;
};

// "… three reclining couches": whether what is counted before `at` is a thing.
bool names_thing(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t at) {
  const auto describes = [](const Token& token) {
    return token.kind == Token::Kind::kWord && (word_form(token.text) == WordForm::kAdjective || token.text.ends_with("ing"));
  };
  while (at < tokens.size() && lexicon.find(tokens, at, Class::kObject).length == 0 && describes(tokens[at])) ++at;
  return at < tokens.size() && lexicon.find(tokens, at, Class::kObject).length > 0;
}

// "tables for two and four": "tables for two and tables for four".
void part_tables(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  const std::vector<Token>& tokens = document.tokens;
  std::vector<Splice> splices;
  const auto number = [&](std::size_t i) {
    return i < tokens.size() && (tokens[i].kind == Token::Kind::kNumber || lexicon.is(tokens[i], Class::kNumber));
  };
  for (std::size_t i = 0; i + 4 < tokens.size(); ++i) {
    if (tokens[i].text != "tables" || tokens[i + 1].text != "for" || !number(i + 2) || !is_word(tokens[i + 3], {"and", "or"}) ||
        !number(i + 4))
      continue;
    const std::size_t after = i + 5;
    const bool thing = after < tokens.size() && !tokens[i + 4].ends_sentence &&
                       (lexicon.find(tokens, after, Class::kObject).length > 0 || lexicon.find(tokens, after, Class::kUnit).length > 0);
    if (thing) continue;  // "tables for two and four chairs"
    splices.push_back({i + 4, tokens[i]});
    splices.push_back({i + 4, tokens[i + 1]});
  }
  splice(document, skip, std::move(splices));
}

}  // namespace

void read_seats_said(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  part_tables(lexicon, document, skip);
  std::vector<Token>& tokens = document.tokens;
  const auto drop = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      skip[i] = true;
      document.readings[i].use = WordReading::Use::kUsed;
      document.readings[i].role = "for how many";
    }
  };
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    const bool verb =
        is_word(tokens[i], {"seats", "seat", "seating", "sits", "accommodates", "accommodating", "fits", "sleeps", "sleeping"});
    const bool space = is_word(tokens[i], {"seating", "room", "space", "places", "seats"}) &&
                       is_word(tokens[i - 1], {"with", "offering"}) && tokens[i + 1].text == "for";
    if (!verb && !space) continue;
    std::size_t number = i + 1;
    while (number + 1 < tokens.size() && is_word(tokens[number], {"up", "to", "for", "about", "around", "at", "least"})) ++number;
    const Match digits = lexicon.find(tokens, number, Class::kNumber);
    const std::size_t length = tokens[number].kind == Token::Kind::kNumber ? 1 : digits.length;
    if (length == 0 || number + length > tokens.size() || skip[number]) continue;
    const bool thing = names_thing(lexicon, tokens, number + length);
    const bool measure = number + length < tokens.size() && lexicon.find(tokens, number + length, Class::kUnit).length > 0;
    // "the printer sits to one side of the monitor"
    const bool side = number + length < tokens.size() && lexicon.is(tokens[number + length], Class::kSide);
    if (thing || measure || side) continue;
    std::size_t first = i;
    while (first > 1 &&
           is_word(tokens[first - 1], {"that", "which", "can", "could", "to", "will", "should", "comfortably", "with", "offering"}))
      --first;
    if (space || number > i + 1) {
      drop(first, number - 1);
      tokens[number - 1].text = "for";
      tokens[number - 1].kind = Token::Kind::kWord;
    } else {
      drop(first, i);
      tokens[i].text = "for";
    }
    i = number;
  }
}

void add_for_people(const Lexicon& lexicon, Document& document) { PeopleReader(lexicon, document).run(); }

std::map<std::string, int> needs_of(const Lexicon& lexicon, const std::string& room, int people) {
  std::map<std::string, int> counts;
  const Lexicon::Set* needs = people > 0 ? lexicon.needs_in(room) : nullptr;
  if (needs == nullptr) return counts;
  people = std::min(people, kMostPeople);
  for (const auto& [entry, persons] : *needs) counts[entry->id] = persons > 0 ? (people + persons - 1) / persons : 1;
  return counts;
}

}  // namespace layoutbox::offline
