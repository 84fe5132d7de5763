#include "layoutbox/plan/offline/people.h"

#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/passes/clusters.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/relations/mention_links.h"
#include "layoutbox/plan/relations/seat_builder.h"
#include "layoutbox/plan/relations/table_seats.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

bool is_word(const Token& token, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), token.text) != words.end();
}

class RoomPeople {
 public:
  RoomPeople(const Lexicon& lexicon, Document& document)
      : lexicon_(lexicon), catalog_(lexicon.catalog()), document_(document), builder_(lexicon, document) {}

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
    const bool rows = host >= 0 && vague_rows(host);
    if (host >= 0 && persons == 1 && mention(host).noun.plural && (mention(host).noun.count == 0 || rows)) {
      if (grow_hosts(host, *main, people)) return;
    } else if (host >= 0 && (persons > 0 || !seats_follow)) {
      const bool some = mention(host).noun.plural && mention(host).noun.count == 0;
      if (persons > 1 && some) builder_.grow(host, (people + persons - 1) / persons);  // "a daycare for 20 with small tables"
      grow_seats(*needs, people);  // "a laboratory for 16 students with four benches, stools"
      return;
    }
    if (host < 0) {
      if (builder_.excluded(*main) || seat_at_low_tables(*needs, people)) return;
      if (persons == 1 && seats_follow && seat_in_groups(*needs, people, *room)) return;
      const int count = persons > 0 ? (people + persons - 1) / persons : 1;
      host = builder_.add(*main, count, *room);
      constexpr int kLeastInGrid = 6;
      if (persons == 1 && count >= kLeastInGrid)
        builder_.relate(Link::Kind::kRelation, {{RelationType::kGrid, Direction::kAlone, {}, {}, {}}}, host, -1);
    }
    if (!seats_follow || grow_seats(*needs, people) || builder_.excluded(*(*needs)[1].first)) return;
    builder_.seat_at_table(builder_.add(*(*needs)[1].first, people, *room), host, persons != 1);
  }

 private:
  Mention& mention(int m) { return builder_.mention(m); }

  // As many desks or tables of those that are named as people need; whether several sit at each.
  bool grow_hosts(int host, const CatalogEntry& main, int people) {
    const auto [seats, told_each] = seats_of_each(host);
    // "tables in groups of four", "double desks", "long shared tables"
    const int at_each =
        std::max({mention(host).noun.seats, builder_.seats_said(mention(host)), told_each, is_shared(host, main) ? kAtShared : 1});
    const std::vector<int> before = mention(host).items;
    builder_.grow(host, (people + at_each - 1) / at_each);
    if (told_each > 1) builder_.grow(seats, static_cast<int>(mention(host).items.size()) * told_each);
    grow_contents({host}, before);
    constexpr int kMostInRow = 12;
    if (vague_rows(host) && people > kMostInRow * mention(host).noun.rows)
      mention(host).noun.rows = 0;  // as many rows as there is room for
    if (one_of(mention(host).noun.head, WordSet::kPlainSeats)) become(host, main);
    if (is_shared(host, main)) mention(host).noun.seats = at_each;
    if (at_each == 1 && is_plain_table(*mention(host).noun.entry, main)) become(host, main);  // "a classroom for 24 with tables"
    return at_each > 1;
  }

  // "in rows", of so many as there is room for
  bool vague_rows(int host) const {
    const NounPhrase& noun = document_.mentions[static_cast<std::size_t>(host)].noun;
    return noun.rows > 0 && noun.vague;
  }

  // "for 24 pupils in six groups of four": a table for each group, with the seats round it. False: nobody speaks of groups.
  bool seat_in_groups(const Lexicon::Set& needs, int people, const NounPhrase& room) {
    constexpr int kLeastGroup = 3, kMostGroup = 10;
    const int together = people_together(lexicon_, document_);
    const CatalogEntry* table = catalog_.find("table");
    if (together < kLeastGroup || together > kMostGroup || table == nullptr) return false;
    const int tables = builder_.add(*table, (people + together - 1) / together, room);
    const int seats = grow_seats(needs, people) ? named(*needs[1].first) : builder_.add(*needs[1].first, people, room);
    builder_.seat_at_table(seats, tables, false);
    return true;
  }

  // "a Sunday school for ten: low tables, small chairs": they sit at these, and at no desks besides.
  bool seat_at_low_tables(const Lexicon::Set& needs, int people) {
    constexpr int kAtEach = 5;
    const CatalogEntry* low = catalog_.find("kids_table");
    const int tables = low == nullptr || !needs.front().first->is(Trait::kDeskLike) ? -1 : named(*low);
    if (tables < 0 || !mention(tables).noun.plural) return false;
    if (mention(tables).noun.count == 0) builder_.grow(tables, (people + kAtEach - 1) / kAtEach);
    grow_seats(needs, people);
    return true;
  }

  // "long communal tables": several work at each.
  static constexpr int kAtShared = 8;
  bool is_shared(int host, const CatalogEntry& needed) const {
    const NounPhrase& noun = document_.mentions[static_cast<std::size_t>(host)].noun;
    return noun.head == "table" && noun.entry != nullptr && is_plain_table(*noun.entry, needed) &&
           std::ranges::any_of(noun.attributes, [](const std::string& a) { return a == "shared" || a == "communal"; });
  }

  // A table of no kind, where such tables are needed.
  bool is_plain_table(const CatalogEntry& named, const CatalogEntry& needed) const {
    return named.is(Trait::kTable) && !named.is(Trait::kDeskLike) && catalog_.is_a(needed.id, named.id);
  }

  // The first mention of things like that, rather of several ("a high chair and five chairs"), or -1: any desk for a desk, any bed for a
  // bed.
  int named(const CatalogEntry& kind) const {
    int first = -1;
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const Mention& one = document_.mentions[m];
      if (!one.introduces || one.noun.kind != NounKind::kObject) continue;
      const CatalogEntry* entry = one.noun.entry;
      const auto both = [&](Trait trait) { return kind.is(trait) && entry != nullptr && entry->is(trait); };
      // Where everybody has a desk, a meeting table is none.
      const bool meeting = kind.is(Trait::kDeskLike) && entry != nullptr && !entry->is(Trait::kDeskLike) && !is_plain_table(*entry, kind);
      const bool tables = both(Trait::kTable) && !meeting && !entry->is(Trait::kOccasional);
      // A teacher's desk and a reception desk are none of those that everybody has.
      if (entry != nullptr && entry->is(Trait::kOpenToRoom) && !kind.is(Trait::kOpenToRoom)) continue;
      const bool rows = one.noun.rows > 0 && is_seat(catalog_, one.noun);  // "two rows of recliners" for whom a cinema is
      const bool seats = rows || (kind.is(Trait::kChair) && one_of(one.noun.head, WordSet::kUprightSeats));
      if (both(Trait::kBed) || tables || seats || (entry != nullptr && catalog_.is_a(entry->id, kind.id))) {
        if (one.items.size() > 1 || one.noun.plural) return static_cast<int>(m);
        if (first < 0) first = static_cast<int>(m);
      }
    }
    return first;
  }

  // "tables with six chairs each": these chairs, and how many of them are at one; -1 and 0: nothing is said.
  std::pair<int, int> seats_of_each(int host) const {
    for (const Link& link : document_.links) {
      if (link.kind != Link::Kind::kHave || !contains(link.references, host) || link.targets.size() != 1) continue;
      const Mention& seats = document_.mentions[static_cast<std::size_t>(link.targets.front())];
      const std::size_t tables = document_.mentions[static_cast<std::size_t>(host)].items.size();
      if (is_seat(catalog_, seats.noun) && seats.noun.count > 1 && tables > 0 && seats.items.size() % tables == 0)
        return {link.targets.front(), static_cast<int>(seats.items.size() / tables)};
    }
    return {-1, 0};
  }

  // "a restaurant for 30, tables for two and four": so many of each that all have a place; whether several kinds are named.
  bool share_tables(int people) {
    std::vector<int> kinds;
    int seats = 0;
    for (std::size_t m = 0; m < document_.mentions.size(); ++m) {
      const Mention& table = document_.mentions[m];
      const NounPhrase& noun = table.noun;
      if (!table.introduces || noun.kind != NounKind::kObject || noun.entry == nullptr || !is_table(catalog_, noun)) continue;
      if (!noun.plural || noun.count > 0 || builder_.seats_said(table) == 0) continue;
      kinds.push_back(static_cast<int>(m));
      seats += builder_.seats_said(table);
    }
    if (kinds.size() < 2) return false;
    for (const int kind : kinds) builder_.grow(kind, std::max(1, people / seats));
    grow_contents(kinds, {});
    return true;
  }

  bool stands_at_counter(int seat) const {
    return MentionLinks(document_).is_placed_by(
        seat, [](const Mention& other) { return other.noun.entry != nullptr && other.noun.entry->is(Trait::kCounter); });
  }

  // "to seat eight: a table, chairs": as many as people; whether any are named.
  bool grow_seats(const Lexicon::Set& needs, int people) {
    const int seats = needs.size() > 1 ? named(*needs[1].first) : -1;
    if (seats >= 0 && one_of(mention(seats).noun.head, WordSet::kStools) && stands_at_counter(seats)) return false;
    constexpr int kFew = 2;  // the one chair of a class is its teacher's
    if (seats >= 0 && people > kFew && mention(seats).items.size() == 1 && !mention(seats).noun.plural) return false;
    if (seats >= 0 && mention(seats).noun.plural && mention(seats).noun.count == 0) builder_.grow(seats, people);
    return seats >= 0;
  }

  // "computer tables with PCs" for twelve: as many PCs; "desks, each with a chair" where `before` were all of them: as many chairs;
  // "tables for two and four with tablecloths": each of both kinds has one.
  void grow_contents(const std::vector<int>& hosts, const std::vector<int>& before) {
    const std::vector<int> last = mention(hosts.back()).items;
    for (Mention& each : document_.mentions) {
      if (before.size() > 1 && each.items == before) each.items = last;
    }
    int all = 0;
    for (const int host : hosts) all += static_cast<int>(mention(host).items.size());
    for (Link& link : document_.links) {
      const auto is_last = [&](int reference) { return mention(reference).items == last; };
      const bool has = link.kind == Link::Kind::kHave;  // else "desks, a chair at each"
      if ((!has && link.kind != Link::Kind::kRelation) || std::ranges::none_of(link.references, is_last)) continue;
      for (const int m : link.targets) {
        const NounPhrase& noun = mention(m).noun;
        const bool carried = noun.kind == NounKind::kObject && mount_of(noun) == Mount::kSurface && noun.plural && noun.count == 0;
        const bool each = !noun.plural && before.size() > 1 && mention(m).items.size() == before.size();
        if (!(has && carried) && !each) continue;
        builder_.grow(m, all);
        if (hosts.size() > 1) link.references = hosts;
      }
    }
  }

  void become(int m, const CatalogEntry& entry) {
    const auto to_entry = [&](NounPhrase& noun) { noun.entry = &entry, noun.category = entry.id; };
    to_entry(mention(m).noun);
    for (const int item : mention(m).items) to_entry(document_.items[static_cast<std::size_t>(item)].noun);
  }

  const Lexicon& lexicon_;
  const Catalog& catalog_;
  Document& document_;
  SeatBuilder builder_;
};

// "… three reclining couches": whether what is counted before `at` is a thing.
bool names_thing(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t at) {
  const auto describes = [](const Token& token) {
    return token.kind == Token::Kind::kWord && (word_form(token.text) == WordForm::kAdjective || token.text.ends_with("ing"));
  };
  const auto is_thing = [&](std::size_t i) { return meaning_of(lexicon.find(tokens, i), WordClass::kObject) != nullptr; };
  while (at < tokens.size() && !is_thing(at) && describes(tokens[at])) ++at;
  return at < tokens.size() && is_thing(at);
}

// "tables for two and four": "tables for two and tables for four".
void part_tables(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  const std::vector<Token>& tokens = document.tokens;
  std::vector<Splice> splices;
  const auto number = [&](std::size_t i) {
    return i < tokens.size() && (tokens[i].kind == Token::Kind::kNumber || lexicon.is(tokens[i], WordClass::kNumber));
  };
  for (std::size_t i = 0; i + 4 < tokens.size(); ++i) {
    if (tokens[i].text != "tables" || tokens[i + 1].text != "for" || !number(i + 2) || !is_word(tokens[i + 3], {"and", "or"}) ||
        !number(i + 4))
      continue;
    const std::size_t after = i + 5;
    const bool thing =
        after < tokens.size() && !tokens[i + 4].ends_sentence &&
        (lexicon.find(tokens, after, WordClass::kObject).length > 0 || lexicon.find(tokens, after, WordClass::kUnit).length > 0);
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
    const Match digits = lexicon.find(tokens, number, WordClass::kNumber);
    const std::size_t length = tokens[number].kind == Token::Kind::kNumber ? 1 : digits.length;
    if (length == 0 || number + length > tokens.size() || skip[number]) continue;
    const bool thing = names_thing(lexicon, tokens, number + length);
    const bool measure = number + length < tokens.size() && lexicon.find(tokens, number + length, WordClass::kUnit).length > 0;
    // "the printer sits to one side of the monitor"
    const bool side = number + length < tokens.size() && lexicon.is(tokens[number + length], WordClass::kSide);
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

void add_for_people(const Lexicon& lexicon, Document& document) {
  const std::size_t said = document.mentions.size();  // what is added has no seats of its own to look for
  if (document.people > 0) RoomPeople(lexicon, document).add_for_room();
  seat_tables(lexicon, document, said);
}

std::map<std::string, int> needs_of(const Lexicon& lexicon, const std::string& room, int people) {
  std::map<std::string, int> counts;
  const Lexicon::Set* needs = people > 0 ? lexicon.needs_in(room) : nullptr;
  if (needs == nullptr) return counts;
  people = std::min(people, kMostPeople);
  for (const auto& [entry, persons] : *needs) counts[entry->id] = persons > 0 ? (people + persons - 1) / persons : 1;
  return counts;
}

}  // namespace layoutbox::offline
