// Groups and what belongs together: both, all, each, sets, the other side, contents that a purpose names.
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader.h"
#include "layoutbox/plan/offline/reader_words.h"

namespace layoutbox::offline {

// "a shelf for controllers and headsets", "the room offers a fireplace and two sofas": what a verb of purpose names is there.
bool DocumentReader::names_contents(std::size_t k) const {
  if (skipping_ || chain_.empty() || k == 0 || joiner_ != Joiner::kNone) return false;
  const std::size_t n = next(k);
  if (!is(n, ChunkKind::kNoun) || !is(previous(k), ChunkKind::kNoun)) return false;
  const std::string& word = document_.tokens[chunk(k).first].text;
  const NounPhrase &host = noun_of(chain_.back()), &thing = chunk(n).noun;
  if (word == "for") {
    static constexpr std::string_view kOpen[] = {"shelf",     "rack",     "basket",    "bin",   "box",  "crate",
                                                 "bookshelf", "bookcase", "organizer", "cubby", "chest"};
    return is_thing(chain_.back()) && std::find(std::begin(kOpen), std::end(kOpen), host.head) != std::end(kOpen) &&
           !is(next(n), ChunkKind::kRelation) && thing.kind == NounKind::kObject && thing.exact && thing.plural &&
           thing.determiner == Determiner::kNone && thing.count == 0 && mount_of(thing) == Mount::kSurface;
  }
  static constexpr std::string_view kShows[] = {"offers", "offer", "provides", "provide", "offering", "providing", "enjoys"};
  const bool room = host.kind == NounKind::kRoom || host.kind == NounKind::kOutsideRoom;
  return room &&
         (thing.kind == NounKind::kObject || thing.as_object != nullptr || thing.kind == NounKind::kWindow ||
          thing.kind == NounKind::kDoor) &&
         std::find(std::begin(kShows), std::end(kShows), word) != std::end(kShows);
}

// "a table for six": a size, after which the list goes on.
bool DocumentReader::passes_count(std::size_t k) {
  const std::size_t n = next(k);
  // "For the bedroom I imagine …": which room.
  if (!skipping_ && (k == 0 || is(k - 1, ChunkKind::kStop)) && document_.tokens[chunk(k).first].text == "for" && is(n, ChunkKind::kNoun) &&
      chunk(n).noun.kind == NounKind::kRoom) {
    mark(k, WordReading::Use::kIgnored, "which room");
    mark(n, WordReading::Use::kUsed, "room");
    document_.rooms.push_back(chunk(n).noun);
    passed_until_ = n + 1;
    return true;
  }
  if (skipping_ || !is(n, ChunkKind::kNoun) || chunk(n).noun.count == 0 || document_.tokens[chunk(k).first].text != "for") return false;
  const NounPhrase& noun = chunk(n).noun;
  const bool persons = noun.kind == NounKind::kMember || lexicon_.is_person(noun.head);
  const bool room = chain_.empty() || noun_of(chain_.back()).kind == NounKind::kRoom;
  if (!persons || (!room && !is_table(lexicon_.catalog(), noun_of(chain_.back())))) return false;
  if (room) {
    document_.people = noun.count;
    document_.young = lexicon_.is_young(noun.head);
  } else {
    seat_so_many(chain_.back(), noun.count);
  }
  mark(k, WordReading::Use::kUsed, "for how many");
  mark(n, WordReading::Use::kUsed, "for how many");
  passed_over_ = n;
  return true;
}

// "a table for six" has six seats; "desks for 24 students" are 24, "tables for forty guests" ten.
void DocumentReader::seat_so_many(int tables, int people) {
  constexpr int kAtATable = 4;
  const NounPhrase& noun = noun_of(tables);
  int seats = people;
  if (noun.count == 0 && noun.plural && mention_at(tables).introduces) {
    const bool desks = noun.entry != nullptr && noun.entry->is(Trait::kDesk);
    seats = desks ? 1 : kAtATable;
    references_.grow(tables, static_cast<std::size_t>((people + seats - 1) / seats));
  }
  for (const int item : mention_at(tables).items) document_.items[static_cast<std::size_t>(item)].noun.seats = seats;
}

// "not under the window": a place where it is not says nothing of where it is.
bool DocumentReader::denies_place(std::size_t k) {
  const std::string& word = document_.tokens[chunk(k).last - 1].text;
  const std::size_t r = next(k), n = next(r);
  if ((word != "not" && word != "never") || !is(r, ChunkKind::kRelation) || !is(n, ChunkKind::kNoun)) return false;
  if (chunk(n).noun.determiner != Determiner::kDefinite && chunk(n).noun.kind == NounKind::kObject) return false;
  mark(r, WordReading::Use::kIgnored, "not there");
  mark(n, WordReading::Use::kIgnored, "not there");
  passed_until_ = n + 1;
  return true;
}

// "nothing else, except a lamp", "no chairs except one": it is there.
bool DocumentReader::excepts_from_nothing(std::size_t k) const {
  const std::string& word = document_.tokens[chunk(k).first].text;
  if (word != "except" && word != "excepting") return false;
  for (std::size_t i = chunk(k).first; i-- > 0 && !document_.tokens[i].ends_sentence;) {
    const std::string& before = document_.tokens[i].text;
    if (before == "nothing" || before == "no" || before == "empty" || before == "without" || before == "nobody") return true;
  }
  return false;
}

// "a dresser that doubles as a changing table next to it": what it is used as is no thing; what follows is said of it.
bool DocumentReader::passes_role(std::size_t k) {
  const std::size_t n = next(k);
  if (document_.tokens[chunk(k).last - 1].text != "as" || !is(n, ChunkKind::kNoun) || chunk(n).noun.kind != NounKind::kObject) return false;
  if (skipping_ && (k == 0 || !is(k - 1, ChunkKind::kPurpose))) return false;
  if (is(next(n), ChunkKind::kAnd) || (chunk(k).first > 0 && document_.tokens[chunk(k).first - 1].text == "such")) return false;
  mark(k, WordReading::Use::kIgnored, "purpose");
  mark(n, WordReading::Use::kIgnored, "purpose");
  passed_over_ = n;
  skipping_ = false;
  return true;
}

// "A, B and C, all against the wall", "both stand in the corner": what follows speaks of the things before.
bool DocumentReader::take_all(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  if (noun.determiner != Determiner::kBoth || noun.of || expects_reference_ || expects_content_) return false;
  const std::size_t n = next(k);
  const bool has = is(n, ChunkKind::kHave);
  if (!is(n, ChunkKind::kRelation) && !is(n, ChunkKind::kParticiple) && !is(n, ChunkKind::kVerb) && !has) return false;
  const std::vector<int>& roots = roots_.empty() ? former_roots_ : roots_;
  std::vector<int> things;
  for (const int root : roots) {
    if (is_thing(root) && noun_of(root).kind == NounKind::kObject) things.push_back(root);
  }
  const bool all = document_.tokens[chunk(k).first].text == "all";
  if (!all && !things.empty() && mention_at(things.back()).items.size() == 2) things = {things.back()};
  if (things.size() == 1) {
    // "a wardrobe next to a dresser, both …": the other one is what it was placed by.
    for (std::size_t c = chain_.size(); c-- > 0 && mention_at(things.front()).items.size() < 2 && things.size() < 2;) {
      if (is_thing(chain_[c]) && mention_at(chain_[c]).items != mention_at(things.front()).items) things.push_back(chain_[c]);
    }
  }
  // "the crib is between the wardrobe and the dresser; all three …": also what it was placed by
  if (noun.count > 0) {
    std::size_t items = 0;
    for (const int thing : things) items += mention_at(thing).items.size();
    for (std::size_t m = document_.mentions.size(), looked = 0; m-- > 0 && looked < 8 && items < static_cast<std::size_t>(noun.count);
         ++looked) {
      const int mention = static_cast<int>(m);
      if (!is_thing(mention) || !document_.mentions[m].introduces || contains(things, mention)) continue;
      things.push_back(mention);
      items += document_.mentions[m].items.size();
    }
  }
  if (!all && things.size() > 2) things.erase(things.begin(), things.end() - 2);
  if (things.empty()) return false;
  mark(k, WordReading::Use::kUsed, "reference");
  if (has) {  // every single one has it
    Mention all_of_them = mention_at(things.front());
    for (const int thing : things) {
      for (const int item : mention_at(thing).items) {
        if (!contains(all_of_them.items, item)) all_of_them.items.push_back(item);
      }
    }
    all_of_them.introduces = false;
    all_of_them.distributes = true;
    document_.mentions.push_back(std::move(all_of_them));
    things = {static_cast<int>(document_.mentions.size()) - 1};
    roots_ = things;
    root_joiners_.assign(1, joiner_);
    root_modified_.assign(1, false);
    clause_start_ = 0;
  }
  if (roots_.empty()) {
    roots_ = things;
    root_joiners_.assign(things.size(), Joiner::kAnd);
    root_modified_.assign(things.size(), false);
  }
  subject_ = things;
  chain_ = {things.front()};
  frames_.clear();
  reference_link_ = -1;
  after_verb_ = true;
  joiner_ = Joiner::kNone;
  return true;
}

// "six square tables, four chairs each": what was listed last belongs to every one of those before it.
bool DocumentReader::each_has_those(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  const std::size_t after = next(k), n = roots_.size();
  if (noun.kind != NounKind::kMember || noun.determiner != Determiner::kEach || noun.count != 0 || expects_reference_ || expects_content_ ||
      joiner_ != Joiner::kNone || n < 2 || root_joiners_.back() == Joiner::kNone || !is(previous(k), ChunkKind::kNoun) ||
      is(after, ChunkKind::kHave) || is(after, ChunkKind::kRelation) || is(after, ChunkKind::kParticiple) || is(after, ChunkKind::kVerb))
    return false;
  const int host = roots_[n - 2], content = roots_.back();
  if (!is_thing(host) || !is_thing(content) || mention_at(host).items.size() < 2 || !mention_at(content).introduces ||
      root_modified_.back())
    return false;
  references_.grow(content, mention_at(content).items.size() * mention_at(host).items.size());
  Link link;
  link.kind = Link::Kind::kHave;
  link.weak = true;
  link.targets = {content};
  link.references = {host};
  link.first = chunk(previous(k)).first;
  link.last = chunk(k).last;
  add_link(std::move(link));
  root_modified_.back() = true;
  mark(k, WordReading::Use::kUsed, "reference");
  return true;
}

// "a dining set for six": a table and six chairs around it.
bool DocumentReader::read_set(std::size_t k) {
  const NounPhrase& noun = chunk(k).noun;
  if (expects_reference_ || noun.determiner == Determiner::kDefinite) return false;
  std::string words = noun.name;  // with its article: the name is that of no object
  const Lexicon::Set* set = lexicon_.set_of(words);
  for (std::size_t space = 0; set == nullptr && (space = words.find(' ')) != std::string::npos;) {
    words = words.substr(space + 1);
    set = lexicon_.set_of(words);
  }
  if (set == nullptr) return false;
  const auto member = [&](const CatalogEntry& entry, int count) {
    NounPhrase one = noun;
    one.kind = NounKind::kObject;
    one.entry = &entry;
    one.exact = true;
    one.name = one.head = entry.name;
    one.head = one.head.substr(one.head.rfind(' ') + 1);
    one.category = entry.id;
    one.count = count;
    one.plural = count > 1;
    one.collective = false;
    return references_.mention(one, -1, false);
  };
  mark(k, WordReading::Use::kUsed, set->front().first->name);
  const int host = member(*set->front().first, noun.count > 0 ? noun.count : set->front().second);
  // "for six", "with four chairs": how many sit at it.
  std::size_t n = next(k);
  const bool seats_said = is(n, ChunkKind::kHave) && is(next(n), ChunkKind::kNoun) && is_seat(lexicon_.catalog(), chunk(next(n)).noun);
  int seats = 0;
  if (is(n, ChunkKind::kPurpose) && is(next(n), ChunkKind::kNoun)) seats = chunk(next(n)).noun.count;
  read_place(k, host);
  for (std::size_t m = 1; m < set->size() && !seats_said; ++m) {
    const bool chairs = is_table(lexicon_.catalog(), noun_of(host));
    const int others = member(*(*set)[m].first, chairs && seats > 0 ? seats : (*set)[m].second);
    if (!chairs) continue;
    Link link;
    link.senses = {{RelationType::kAround, Direction::kDirect, {}, {}, {}}};
    link.targets = {others};
    link.references = {host};
    link.first = chunk(k).first;
    link.last = chunk(k).last;
    add_link(std::move(link));
  }
  return true;
}

// "two tables, one on each side of the bed": the two, not one of them.
bool DocumentReader::whole_group(std::size_t k, const NounPhrase& noun, int group) const {
  if (noun.count == 0 || noun.subset || group < 0 || expects_reference_) return false;
  const std::size_t n = next(k);
  if (!is(n, ChunkKind::kRelation) || !chunk(n).phrase.each) return false;
  const PhraseSenses& senses = *chunk(n).phrase.senses;
  const std::size_t sides = says(senses, RelationType::kEachSideOf) || says(senses, RelationType::kAlongSide) ? 2 : 0;
  return document_.mentions[static_cast<std::size_t>(group)].items.size() == sides * static_cast<std::size_t>(noun.count);
}

// "a lamp on one side of the sofa and a plant on the other": one on either side. False when no first side waits.
bool DocumentReader::other_side(std::size_t k, const std::vector<int>& targets) {
  if (one_side_link_ < 0 || (targets.empty() && chunk(k).noun.determiner != Determiner::kOther)) return false;
  Link& link = link_at(one_side_link_);
  if (link.targets.empty() || link.references.empty()) {
    // "a fireplace with a chair on one side": by the fireplace.
    if (link.targets.empty()) return false;
  }
  std::vector<int> more = targets;
  if (more.empty() && reference_link_ >= 0) {
    // The link that was opened for "on" is not needed.
    for (std::size_t c = chain_.size(); c-- > 0 && more.empty();) {
      if (is_thing(chain_[c]) && !contains(link.targets, chain_[c]) && !contains(link.references, chain_[c])) more = {chain_[c]};
    }
    if (more.empty()) return false;
    link_at(reference_link_).senses = {};
    expects_reference_ = false;
    reference_link_ = -1;
  }
  link.targets.insert(link.targets.end(), more.begin(), more.end());
  link.senses = {{RelationType::kEachSideOf, Direction::kDirect, {}, {}, {}}};
  link.one_side = false;
  one_side_link_ = -1;
  return true;
}

}  // namespace layoutbox::offline
