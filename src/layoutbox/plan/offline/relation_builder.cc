#include "layoutbox/plan/offline/relation_builder.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/plan/offline/knowledge.h"

namespace layoutbox::offline {
namespace {

using R = RelationType;
using Direction = PhraseSense::Direction;

bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool speaks_of_group(R type) {
  return type == R::kAround || type == R::kSurround || type == R::kEachSideOf || type == R::kRow || type == R::kGrid ||
         type == R::kColumn || type == R::kEvenlySpaced || type == R::kSymmetricAbout || type == R::kStacked || type == R::kCenterOfRoom ||
         type == R::kPairedWith || type == R::kGroupAlign;
}

bool places(R type) { return type != R::kFacing && type != R::kParallel && type != R::kPerpendicular && type != R::kSameOrientation; }

bool is_beside(R type) {
  return type == R::kNextTo || type == R::kNear || type == R::kLeftOf || type == R::kRightOf || type == R::kBehind ||
         type == R::kInFrontOf || type == R::kEachSideOf || type == R::kBetween || type == R::kCorner || type == R::kAgainstWall ||
         type == R::kCenterOfRoom || type == R::kAtFootOf || type == R::kDistance || type == R::kAround || type == R::kOpposite;
}

class Builder {
 public:
  Builder(const Lexicon& lexicon, Document& document, SceneGraph& scene)
      : catalog_(lexicon.catalog()), document_(document), scene_(scene) {}

  void run() {
    for (const Link& link : document_.links) {
      if (link.kind == Link::Kind::kRelation) add_relations(link);
    }
    for (const Link& link : document_.links) {
      if (link.kind == Link::Kind::kHave) add_contents(link);
    }
    for (const Link& link : document_.links) {
      if (link.kind == Link::Kind::kHang) add_hanging(link);
    }
    add_mounts_said();
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) settle_mount(i);
    add_habits();
    note_contradictions();
  }

 private:
  const Mention& mention(int m) const { return document_.mentions[static_cast<std::size_t>(m)]; }
  const std::string& id(int item) const { return scene_.objects[static_cast<std::size_t>(item)].id; }
  const NounPhrase& noun_of_item(int item) const { return document_.items[static_cast<std::size_t>(item)].noun; }

  void add(const Link& link, R type, std::vector<std::string> targets, std::vector<std::string> references, const PhraseSense& sense = {}) {
    if (targets.empty()) return;
    // Nothing stands by itself.
    std::erase_if(references, [&](const std::string& r) { return std::find(targets.begin(), targets.end(), r) != targets.end(); });
    if (references.empty() && relation_row(type).arity != RelationArity::kNone && relation_row(type).arity != RelationArity::kOptional)
      return;
    for (Relation& known : scene_.relations) {
      if (known.type != type || known.targets != targets || known.references != references) continue;
      if (type == R::kRow && link.distance) known.parameters.gap = mm_from_m(*link.distance);
      return;
    }
    Relation relation;
    relation.id = "c" + std::to_string(scene_.relations.size() + 1);
    relation.type = type;
    relation.targets = std::move(targets);
    relation.references = std::move(references);
    relation.parameters.part = sense.part;
    relation.parameters.region = sense.region;
    relation.parameters.side = sense.side;
    relation.hard = !link.soft;
    relation.why = words_between(document_, link.first, link.last);
    // "along a wall" is looser than "against" it.
    const std::string& first_word = document_.tokens[link.first].text;
    if (type == R::kAgainstWall && (first_word == "along" || first_word.starts_with("lin"))) relation.parameters.gap = 300;
    if (link.distance && type == R::kRow) relation.parameters.gap = mm_from_m(*link.distance);
    if (link.distance && type == R::kDistance) {
      const Mm distance = mm_from_m(*link.distance);
      if (!link.at_most) relation.parameters.min = distance;
      if (!link.at_least) relation.parameters.max = distance;
    }
    for (std::size_t i = link.first; i < link.last; ++i) {
      if (document_.readings[i].role == "relation" || document_.readings[i].role == "has")
        document_.readings[i].role = "relation " + relation.id;
    }
    scene_.relations.push_back(std::move(relation));
  }

  std::vector<std::string> ids(const std::vector<int>& items) const {
    std::vector<std::string> all;
    for (const int item : items) {
      if (std::find(all.begin(), all.end(), id(item)) == all.end()) all.push_back(id(item));
    }
    return all;
  }

  std::vector<int> items_of(const std::vector<int>& mentions) const {
    std::vector<int> all;
    for (const int m : mentions) {
      for (const int item : mention(m).items) {
        if (std::find(all.begin(), all.end(), item) == all.end()) all.push_back(item);
      }
    }
    return all;
  }

  // What relativeTo says for a reference that is a part of the room.
  std::vector<std::string> room_reference(const NounPhrase& noun, R type) const {
    const auto words = [&] {
      std::vector<std::string> all;
      std::string rest = noun.wall_word;
      while (!rest.empty()) {
        const std::size_t space = rest.find(' ');
        all.push_back(rest.substr(0, space));
        rest = space == std::string::npos ? "" : rest.substr(space + 1);
      }
      return all;
    };
    switch (noun.kind) {
      case NounKind::kWall: {
        auto all = words();
        if (all.size() > 1) all.resize(1);
        if (all.empty() && noun.wall_relation.empty() && relation_row(type).arity != RelationArity::kOptional) all = {"back"};
        return all;
      }
      case NounKind::kCorner: {
        auto all = words();
        // "the far corner" is the viewer's word for a back corner, which one is free.
        return all;
      }
      case NounKind::kDoor:
        return relation_row(type).arity == RelationArity::kOptional ? std::vector<std::string>{}
                                                                    : std::vector<std::string>{opening_id("door")};
      case NounKind::kWindow:
        return relation_row(type).arity == RelationArity::kOptional ? std::vector<std::string>{}
                                                                    : std::vector<std::string>{opening_id("window")};
      case NounKind::kFloor: return {"floor"};
      default:
        return relation_row(type).arity == RelationArity::kNone || relation_row(type).arity == RelationArity::kOptional
                   ? std::vector<std::string>{}
                   : std::vector<std::string>{"room"};
    }
  }

  // A door or window that has an id of its own, else the word, which normalisation gives to the default one.
  std::string opening_id(std::string_view type) const {
    for (const Opening& opening : scene_.room.openings) {
      if (name_of(opening.type) == type) return opening.id;
    }
    return std::string(type);
  }

  void add_relations(const Link& link) {
    const std::vector<int> targets = items_of(link.targets);
    if (targets.empty()) return;
    if (link.references.empty()) {
      for (const PhraseSense& sense : link.senses) {
        const RelationArity arity = relation_row(sense.type).arity;
        if (arity == RelationArity::kNone || (arity == RelationArity::kOptional && sense.type == R::kOnCeiling)) {
          if (speaks_of_group(sense.type))
            add_group(link, sense, targets, {}, nullptr);
          else
            for (const int target : targets) add(link, sense.type, {id(target)}, {}, sense);
          return;
        }
      }
      return;
    }
    if (std::any_of(link.senses.begin(), link.senses.end(), [](const PhraseSense& s) { return s.type == R::kBetween; }) &&
        (link.references.size() > 1 || mention(link.references.front()).items.size() > 1)) {
      add_between(link, targets);
      return;
    }
    for (const int reference : link.references) add_relations_to(link, targets, mention(reference));
  }

  void add_relations_to(const Link& link, const std::vector<int>& targets, const Mention& reference_mention) {
    const Mention* place = reference_mention.items.empty() ? &reference_mention : nullptr;
    const std::vector<int>& reference_items = reference_mention.items;
    const NounPhrase& reference = reference_mention.noun;
    // Targets of different kinds may read the phrase differently ("a rug and a lamp in the corner").
    for (const int m : link.targets) {
      const Mention& target = mention(m);
      if (target.items.empty()) continue;
      const auto sense = choose_sense(catalog_, link.senses, Direction::kDirect, target.noun, reference);
      if (!sense) {
        if (reference.kind != NounKind::kRoom && reference.kind != NounKind::kAbstract) {
          scene_.notes.push_back(
              {"not-understood",
               "\"" + words_between(document_, link.first, link.last) + "\" says nothing of where \"" + target.noun.name + "\" is",
               place_of(link)});
        }
        continue;
      }
      if (speaks_of_group(sense->type)) {
        if (m == link.targets.front()) add_group(link, *sense, targets, reference_items, place);
      } else {
        add_single(link, *sense, target, reference_items, place);
      }
      if (link.distance && sense->type != R::kDistance && !reference_items.empty()) {
        for (const int item : target.items) add(link, R::kDistance, {id(item)}, {id(reference_items.front())});
      }
    }
  }

  std::string place_of(const Link& link) const {
    if (link.first >= link.last) return "prompt";
    return "prompt:" + std::to_string(document_.tokens[link.first].begin) + "-" + std::to_string(document_.tokens[link.last - 1].end);
  }

  void add_between(const Link& link, const std::vector<int>& targets) {
    std::vector<std::string> references;
    for (const int m : link.references) {
      if (!mention(m).items.empty()) {
        for (const int item : mention(m).items) references.push_back(id(item));
      } else if (mention(m).noun.kind == NounKind::kDoor || mention(m).noun.kind == NounKind::kWindow) {
        references.push_back(opening_id(mention(m).noun.kind == NounKind::kDoor ? "door" : "window"));
      } else if (mention(m).noun.kind == NounKind::kWall) {
        references.push_back(mention(m).noun.wall_word.empty() ? "back" : mention(m).noun.wall_word);
      }
    }
    if (references.size() < 2) return;
    for (const int target : targets) add(link, R::kBetween, {id(target)}, references);
  }

  void add_group(const Link& link, PhraseSense sense, const std::vector<int>& targets, const std::vector<int>& references,
                 const Mention* place) {
    if (sense.type == R::kCenterOfRoom) {
      // What lies flat shares the middle with what stands there.
      std::vector<int> flat, standing;
      for (const int target : targets)
        (noun_of_item(target).entry != nullptr && noun_of_item(target).entry->thin ? flat : standing).push_back(target);
      if (!flat.empty()) add(link, sense.type, ids(flat), {}, sense);
      if (!standing.empty()) add(link, sense.type, ids(standing), {}, sense);
      if (flat.size() == 1 && standing.size() == 1) add(link, R::kUnder, ids(flat), ids(standing));
      return;
    }
    if (sense.type == R::kAround && !references.empty()) {
      // In a ring where nothing has sides; spread over the sides of a table.
      const NounPhrase& host = noun_of_item(references.front());
      const bool round = std::any_of(host.attributes.begin(), host.attributes.end(),
                                     [](const std::string& a) { return a == "round" || a == "circular" || a == "oval"; });
      if ((round || !is_table(catalog_, host)) && targets.size() >= 3) sense.type = R::kSurround;
    }
    if (references.empty()) {
      add(link, sense.type, ids(targets), place != nullptr ? room_reference(place->noun, sense.type) : std::vector<std::string>{}, sense);
      return;
    }
    const std::size_t hosts = relation_row(sense.type).arity == RelationArity::kNone ? 1 : references.size();
    // Several hosts share the targets out.
    for (std::size_t h = 0; h < hosts; ++h) {
      std::vector<int> share;
      for (std::size_t t = h; t < targets.size(); t += hosts) share.push_back(targets[t]);
      if (share.empty()) continue;
      const std::vector<std::string> host =
          relation_row(sense.type).arity == RelationArity::kNone ? std::vector<std::string>{} : std::vector<std::string>{id(references[h])};
      if (sense.type == R::kEachSideOf && share.size() == 1) {
        add(link, R::kNextTo, ids(share), host);
      } else {
        add(link, sense.type, ids(share), host, sense);
      }
    }
  }

  void add_single(const Link& link, PhraseSense sense, const Mention& target, const std::vector<int>& references, const Mention* place) {
    const auto place_kind = place != nullptr ? place->noun.kind : NounKind::kObject;
    if (references.empty() && place != nullptr) {
      if (place_kind == NounKind::kFloor) {
        for (const int item : target.items) {
          if (mount_of(noun_of_item(item)) == Mount::kSurface) add(link, R::kOn, {id(item)}, {"floor"});
        }
        return;
      }
      if (place_kind == NounKind::kRoom && (sense.type == R::kIn || sense.type == R::kOn || sense.type == R::kInside)) return;
      if (sense.type == R::kCorner) {
        add_corners(link, target, place->noun);
        return;
      }
      for (const int item : target.items) {
        add(link, sense.type, {id(item)}, room_reference(place->noun, sense.type), sense);
        if (sense.type == R::kOpposite) add_across(link, item, room_reference(place->noun, sense.type));
      }
      return;
    }
    if (references.empty()) return;
    // "on the left side of the desk" is on the desk for what stands on desks, beside it for the rest.
    if (sense.type == R::kLeftOf || sense.type == R::kRightOf) {
      const NounPhrase& host = noun_of_item(references.front());
      const std::string words = words_between(document_, link.first, link.last);
      const bool side_of = words.find("side") != std::string::npos || words.find("on the ") != std::string::npos;
      const bool lies = one_of(host.head, {"bed", "sofa", "couch", "loveseat", "armchair"});
      const bool carries = !lies && may_carry(catalog_, host, target.noun);
      if (side_of && carries && mount_of(target.noun) == Mount::kSurface && mount_of(host) != Mount::kSurface) {
        sense.part = sense.type == R::kLeftOf ? "left" : "right";
        sense.type = R::kOn;
      }
    }
    if (sense.type == R::kOn || sense.type == R::kIn) {
      const NounPhrase& host = noun_of_item(references.front());
      if (sense.type == R::kIn && !has_inside(host)) sense.type = R::kOn;
    }
    if (sense.type == R::kNextTo && target.items.size() == 2 && references.size() == 1 && link.references.size() == 1 &&
        flanks(target.noun, noun_of_item(references.front()))) {
      add(link, R::kEachSideOf, ids(target.items), {id(references.front())});
      return;
    }
    // A seat "at" a table is used there.
    if (sense.type == R::kNextTo && references.size() == 1 && is_seat(catalog_, target.noun) &&
        is_table(catalog_, noun_of_item(references.front())) && document_.tokens[link.first].text == "at") {
      if (target.items.size() > 1) {
        add_group(link, {R::kAround, Direction::kDirect, {}, {}, {}}, target.items, references, nullptr);
      } else {
        add(link, R::kInFrontOf, {id(target.items.front())}, {id(references.front())});
        add(link, R::kFacing, {id(target.items.front())}, {id(references.front())});
      }
      return;
    }
    if (sense.type == R::kUnder && mount_of(target.noun) == Mount::kFloor && references.size() == 1 && target.items.size() == 1) {
      // What stands under a thing on the wall: the wall's thing is above it.
      const Mount above = mount_of(noun_of_item(references.front()));
      if (above == Mount::kWall || above == Mount::kCeiling) {
        add(link, R::kAbove, {id(references.front())}, {id(target.items.front())});
        return;
      }
    }
    if (link.implied && (sense.type == R::kNear || sense.type == R::kNextTo || sense.type == R::kOpposite) &&
        mount_of(target.noun) == Mount::kFloor && !references.empty()) {
      for (const Relation& r : scene_.relations) {
        const bool carried = (r.type == R::kOn || r.type == R::kIn) && !r.targets.empty() && r.targets.front() == id(references.front()) &&
                             !r.references.empty();
        if (!carried) continue;
        const std::string host = r.references.front();
        for (const int item : target.items) add(link, sense.type, {id(item)}, {host}, sense);
        return;
      }
    }
    const std::size_t n = target.items.size(), m = references.size();
    const bool all = sense.type == R::kInFrontOf || sense.type == R::kOpposite;
    for (std::size_t t = 0; t < n; ++t) {
      const int item = target.items[t];
      if (m == 1) {
        add(link, sense.type, {id(item)}, {id(references.front())}, sense);
        if (sense.type == R::kOpposite) add_across(link, item, {id(references.front())});
        add_look(link, sense.type, item, references.front());
      } else if (n > 1 || !all) {
        // As many as there are references: one for each; more: shared out; fewer: the first.
        const std::size_t r = n >= m ? t * m / n : t;
        add(link, sense.type, {id(item)}, {id(references[n > 1 ? r : 0])}, sense);
        add_look(link, sense.type, item, references[n > 1 ? r : 0]);
      } else {
        for (const int reference : references) {
          add(link, sense.type, {id(item)}, {id(reference)}, sense);
          if (sense.type == R::kOpposite) add_across(link, item, {id(reference)});
        }
        add_look(link, sense.type, item, references.front());
      }
    }
  }

  // Two of a kind that stand by beds (sofas …) "beside" one stand on either side of it.
  bool flanks(const NounPhrase& thing, const NounPhrase& host) const {
    if (thing.entry == nullptr || host.entry == nullptr) return false;
    if (!one_of(host.head, {"bed", "sofa", "couch", "loveseat", "daybed"})) return false;
    return std::any_of(thing.entry->beside.begin(), thing.entry->beside.end(),
                       [&](const std::string& kind) { return catalog_.is_a(host.entry->id, kind); });
  }

  // What one sees into: things that it has are in it; on others they stand on top.
  bool holds_inside(const NounPhrase& host) const {
    static constexpr std::string_view kClosed[] = {"cabinet",  "sideboard", "dresser", "cupboard",         "credenza", "buffet",
                                                   "drawers",  "desk",      "table",   "counter",          "vanity",   "nightstand",
                                                   "island",   "hutch",     "commode", "chest of drawers", "stand",    "console",
                                                   "wardrobe", "bench",     "bed",     "washstand",        "ladder"};
    if (std::find(std::begin(kClosed), std::end(kClosed), host.head) != std::end(kClosed)) return false;
    return is_storage(host) && has_inside(host);
  }

  bool has_inside(const NounPhrase& host) const {
    if (host.entry == nullptr) return is_storage(host);
    return std::any_of(host.entry->spaces.begin(), host.entry->spaces.end(), [](const SpaceFormula& s) { return s.carries; });
  }

  // Who is in front of a desk or a screen looks at it; a screen in front of a bed looks at the bed.
  void add_look(const Link& link, R type, int item, int reference) {
    const NounPhrase &thing = noun_of_item(item), &other = noun_of_item(reference);
    const auto screen = [](const NounPhrase& n) {
      return one_of(n.head, {"tv", "television", "screen", "monitor"}) || n.name.find("tv ") != std::string::npos ||
             n.name.find("media") != std::string::npos;
    };
    const bool seat = is_seat(catalog_, thing);
    if (type == R::kInFrontOf && ((seat && (is_table(catalog_, other) || screen(other))) || screen(thing)))
      add(link, R::kFacing, {id(item)}, {id(reference)});
    if (type == R::kAlongSide && seat) add(link, R::kFacing, {id(item)}, {id(reference)});
  }

  // "across from" is a gap as well, which holds even where the two cannot look at each other.
  void add_across(const Link& link, int item, const std::vector<std::string>& reference) {
    Link gap = link;
    gap.distance.reset();
    const std::size_t known = scene_.relations.size();
    add(gap, R::kDistance, {id(item)}, reference);
    if (scene_.relations.size() == known) return;
    scene_.relations.back().parameters.min = mm_from_m(relation_default(R::kOpposite, "min").value_or(1.5));
    scene_.relations.back().parameters.max = mm_from_m(relation_default(R::kOpposite, "max").value_or(4));
  }

  void add_corners(const Link& link, const Mention& target, const NounPhrase& corner) {
    static const std::vector<std::vector<std::string>> kCorners = {
        {"left", "back"}, {"right", "back"}, {"left", "front"}, {"right", "front"}};
    const bool every = corner.determiner == Determiner::kEach || corner.determiner == Determiner::kBoth || corner.count == 4;
    for (std::size_t t = 0; t < target.items.size(); ++t) {
      const auto references = every && target.items.size() > 1 ? kCorners[t % kCorners.size()] : room_reference(corner, R::kCorner);
      add(link, R::kCorner, {id(target.items[t])}, references);
    }
  }

  bool is_placed(int item) const {
    return std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      return places(r.type) && std::find(r.targets.begin(), r.targets.end(), id(item)) != r.targets.end();
    });
  }

  bool is_related(int item, int other) const {
    return std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      const auto names = [&](const std::vector<std::string>& all, int i) { return std::find(all.begin(), all.end(), id(i)) != all.end(); };
      return places(r.type) &&
             ((names(r.targets, item) && names(r.references, other)) || (names(r.targets, other) && names(r.references, item)));
    });
  }

  // What a thing has: on it, in it, at it, by it, as the two allow.
  void add_contents(const Link& link) {
    const std::vector<int> all_hosts = items_of(link.references);
    if (all_hosts.empty()) return;
    for (const int m : link.targets) {
      const Mention& target = mention(m);
      if (target.items.empty()) continue;
      // "a desk and chair equipped with a monitor": the one that can carry it.
      std::vector<int> hosts = all_hosts;
      if (link.references.size() > 1 && std::any_of(hosts.begin(), hosts.end(), [&](int h) {
            return !is_seat(catalog_, noun_of_item(h)) && may_carry(catalog_, noun_of_item(h), target.noun);
          })) {
        std::erase_if(hosts,
                      [&](int h) { return is_seat(catalog_, noun_of_item(h)) || !may_carry(catalog_, noun_of_item(h), target.noun); });
      }
      if (link.weak && is_placed(target.items.front())) continue;
      if (is_related(target.items.front(), hosts.front())) continue;
      const NounPhrase &host = noun_of_item(hosts.front()), &thing = target.noun;
      const auto each = [&](R type) {
        for (std::size_t t = 0; t < target.items.size(); ++t) {
          const std::size_t h = hosts.size() <= target.items.size() ? t * hosts.size() / target.items.size() : 0;
          add(link, type, {id(target.items[t])}, {id(hosts[h])});
        }
      };
      const bool table = is_table(catalog_, host), seat = is_seat(catalog_, thing);
      const Mount mount = mount_of(thing);
      if (thing.entry != nullptr && thing.entry->thin && mount == Mount::kFloor) {
        each(R::kUnder);
      } else if (table && seat) {
        if (target.items.size() > hosts.size()) {
          add_group(link, {R::kAround, Direction::kDirect, {}, {}, {}}, target.items, hosts, nullptr);
        } else {
          // A school desk looks away from who sits at it.
          const bool behind = host.entry != nullptr && host.entry->used_sides == std::vector<Side>{Side::kBack};
          for (std::size_t t = 0; t < target.items.size(); ++t) {
            const std::string& desk = id(hosts[std::min(t, hosts.size() - 1)]);
            add(link, behind ? R::kTuckedUnder : R::kInFrontOf, {id(target.items[t])}, {desk});
            if (!behind) add(link, R::kFacing, {id(target.items[t])}, {desk});
          }
        }
      } else if ((may_carry(catalog_, host, thing) || (link.holding && shows(link))) && !(mount == Mount::kWall && !link.holding)) {
        each(holds_inside(host) ? R::kIn : R::kOn);
      } else if (mount == Mount::kWall || mount == Mount::kCeiling) {
        if (!link.after_comma && mount_of(host) == Mount::kFloor) each(R::kAbove);
      } else if (mount == Mount::kSurface && link.holding) {
        each(R::kOn);
      } else if (mount_of(host) == Mount::kWall && mount == Mount::kFloor && target.items.size() == 1) {
        add(link, R::kAbove, {id(hosts.front())}, {id(target.items.front())});
      } else if (!is_placed(target.items.front()) &&
                 (!link.after_comma ||
                  one_of(document_.tokens[link.first].text, {"accompanied", "joined", "paired", "complemented", "coupled"}))) {
        const bool pair = target.items.size() == 2 && hosts.size() == 1;
        if (pair)
          add(link, R::kEachSideOf, ids(target.items), {id(hosts.front())});
        else
          each(R::kNextTo);
      }
    }
  }

  // "holding", "displaying": the host carries it, whatever it is.
  bool shows(const Link& link) const {
    return one_of(document_.tokens[link.first].text,
                  {"holding", "holds", "hold", "displaying", "displays", "display", "showcasing", "showcases"});
  }

  void add_hanging(const Link& link) {
    for (const int item : items_of(link.targets)) {
      const bool said = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
        const bool hangs = r.type == R::kOnWall || r.type == R::kOnCeiling || r.type == R::kOn || r.type == R::kIn ||
                           r.type == R::kAgainstWall || r.type == R::kCenteredOnWall;
        return hangs && std::find(r.targets.begin(), r.targets.end(), id(item)) != r.targets.end();
      });
      if (said) continue;
      const NounPhrase& noun = noun_of_item(item);
      const bool ceiling = mount_of(noun) == Mount::kCeiling || (is_lamp(catalog_, noun) && mount_of(noun) != Mount::kWall);
      add(link, ceiling ? R::kOnCeiling : R::kOnWall, {id(item)}, {});
    }
  }

  // "a wall-mounted TV", "a floating shelf".
  void add_mounts_said() {
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      const NounPhrase& noun = document_.items[i].noun;
      const std::string words = " " + noun.name + " ";
      const auto said = [&](std::string_view word) {
        return std::find(noun.attributes.begin(), noun.attributes.end(), word) != noun.attributes.end() ||
               words.find(" " + std::string(word) + " ") != std::string::npos;
      };
      const bool wall =
                     said("wall-mounted") || said("wall mounted") || (said("floating") && !is_seat(catalog_, noun) && noun.head != "bed"),
                 ceiling = said("ceiling-mounted");
      if (!wall && !ceiling) continue;
      Link link;
      link.targets = {};
      link.first = noun.first;
      link.last = noun.last;
      const bool known = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
        return (r.type == R::kOnWall || r.type == R::kOnCeiling) &&
               std::find(r.targets.begin(), r.targets.end(), scene_.objects[i].id) != r.targets.end();
      });
      if (!known) add(link, wall ? R::kOnWall : R::kOnCeiling, {scene_.objects[i].id}, {});
    }
  }

  // Rows of desks that face a board look its way; only those before it look straight at it.
  void face_as_group() {
    for (const Relation& grid : scene_.relations) {
      if (grid.type != R::kGrid || grid.targets.size() < 2) continue;
      const std::size_t n = grid.targets.size();
      const std::size_t columns =
          static_cast<std::size_t>(grid.parameters.columns.value_or(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(n))))));
      const std::string& middle = grid.targets[(columns - 1) / 2];
      for (Relation& facing : scene_.relations) {
        if (facing.type != R::kFacing || facing.targets.size() != 1) continue;
        const auto at = std::find(grid.targets.begin(), grid.targets.end(), facing.targets[0]) - grid.targets.begin();
        const std::size_t column = static_cast<std::size_t>(at) % columns;
        if (static_cast<std::size_t>(at) == n || column == (columns - 1) / 2 || column == columns / 2) continue;
        facing.type = R::kSameOrientation;
        facing.references = {middle};
      }
    }
  }

  // What a reader takes for granted; soft, and marked as ours.
  void add_habits() {
    face_as_group();
    const std::size_t said = scene_.relations.size();
    for (std::size_t r = 0; r < said; ++r) {
      const Relation relation = scene_.relations[r];
      if (relation.targets.size() != 1 || relation.references.size() != 1) continue;
      const SceneObject *target = scene_.find_object(relation.targets.front()),
                        *reference = scene_.find_object(relation.references.front());
      if (target == nullptr || reference == nullptr) continue;
      const NounPhrase &thing = noun_of_object(*target), &other = noun_of_object(*reference);
      if (relation.type == R::kInFrontOf && is_seat(catalog_, thing) && is_table(catalog_, other) &&
          !one_of(thing.head, {"sofa", "couch", "loveseat"}) && !scene_.relations[r].parameters.max)
        scene_.relations[r].parameters.max = 400;
      // One thing in front of another stands in the middle of it.
      const auto alone = std::count_if(scene_.relations.begin(), scene_.relations.end(),
                                       [&](const Relation& o) { return o.type == R::kInFrontOf && o.references == relation.references; });
      if (relation.type == R::kInFrontOf && alone == 1) {
        Relation habit;
        habit.id = "c" + std::to_string(scene_.relations.size() + 1);
        habit.type = R::kCenteredOn;
        habit.targets = relation.targets;
        habit.references = relation.references;
        habit.hard = false;
        habit.assumed = true;
        habit.weight = 80;
        habit.why = "what is in front of something is in front of its middle";
        scene_.relations.push_back(std::move(habit));
      }
    }
    // "on either side of the sofa, near it": as far as near things are.
    for (Relation& sides : scene_.relations) {
      if (sides.type != R::kEachSideOf || sides.parameters.max) continue;
      const bool near = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
        return r.type == R::kNear && r.references == sides.references &&
               std::find(sides.targets.begin(), sides.targets.end(), r.targets.front()) != sides.targets.end();
      });
      if (near) sides.parameters.max = 1500;
    }
    // A plain table that one dines at.
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      SceneObject& object = scene_.objects[i];
      if (object.category != "table" || catalog_.find("dining_table") == nullptr) continue;
      const bool chairs = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
        return (r.type == R::kAround || r.type == R::kSurround) && !r.references.empty() && r.references.front() == object.id &&
               r.targets.front().starts_with("dining_chair");
      });
      if (chairs || (scene_.room.type == "dining_room" && document_.items[i].noun.attributes.empty() && is_only_table(i)))
        object.category = "dining_table";
    }
  }

  bool is_only_table(std::size_t index) const {
    return std::count_if(document_.items.begin(), document_.items.end(), [&](const Item& item) { return is_table(catalog_, item.noun); }) ==
               1 &&
           index < document_.items.size();
  }

  const NounPhrase& noun_of_object(const SceneObject& object) const {
    return document_.items[static_cast<std::size_t>(&object - scene_.objects.data())].noun;
  }

  // How a thing is held where the relations say otherwise than its kind.
  void settle_mount(std::size_t index) {
    SceneObject& object = scene_.objects[index];
    const NounPhrase& noun = document_.items[index].noun;
    bool wall = false, ceiling = false, supported = false, beside = false;
    std::string neighbour_support;
    for (const Relation& relation : scene_.relations) {
      if (std::find(relation.targets.begin(), relation.targets.end(), object.id) == relation.targets.end()) continue;
      wall |= relation.type == R::kOnWall;
      ceiling |= relation.type == R::kOnCeiling;
      supported |= relation.type == R::kOn || relation.type == R::kIn || relation.type == R::kStacked;
      if (!is_beside(relation.type)) continue;
      beside = true;
      for (const std::string& reference : relation.references) {
        for (const Relation& other : scene_.relations) {
          const bool carries = (other.type == R::kOn || other.type == R::kIn) &&
                               std::find(other.targets.begin(), other.targets.end(), reference) != other.targets.end() &&
                               !other.references.empty();
          if (carries && relation.type != R::kCorner && relation.type != R::kAgainstWall) neighbour_support = other.references.front();
        }
      }
    }
    const auto specialise = [&](std::initializer_list<const char*> kinds) {
      for (const char* kind : kinds) {
        const CatalogEntry* entry = catalog_.find(kind);
        if (entry == nullptr || !noun.exact) continue;
        object.category = entry->id;
        return;
      }
    };
    if (ceiling) {
      object.mount = Mount::kCeiling;
      if (is_lamp(catalog_, noun) && mount_of(noun) != Mount::kCeiling) specialise({"pendant_lamp", "pendant_light", "ceiling_lamp"});
      return;
    }
    if (wall) {
      object.mount = Mount::kWall;
      const CatalogEntry* on_wall = mount_of(noun) != Mount::kWall && noun.exact ? catalog_.find("wall_" + noun.entry->id) : nullptr;
      if (on_wall != nullptr) {
        object.category = on_wall->id;
        // A board has a top and no inside.
        const bool inside = std::any_of(on_wall->spaces.begin(), on_wall->spaces.end(), [](const SpaceFormula& s) { return s.carries; });
        for (Relation& relation : scene_.relations) {
          if (!inside && relation.type == R::kIn && !relation.references.empty() && relation.references.front() == object.id)
            relation.type = R::kOn;
        }
      }
      if (is_lamp(catalog_, noun) && mount_of(noun) != Mount::kWall) specialise({"wall_lamp", "sconce"});
      return;
    }
    if (supported && mount_of(noun) == Mount::kFloor && is_carried(object.id)) {
      // A plant on a shelf is a small one.
      object.mount = Mount::kSurface;
      if (noun.exact && catalog_.find("small_" + noun.entry->id) != nullptr) object.category = "small_" + noun.entry->id;
      return;
    }
    if (supported || mount_of(noun) != Mount::kSurface || !beside) return;
    if (!neighbour_support.empty() && neighbour_support != "floor") {
      Link link;  // "a mouse next to the keyboard" stands on the same desk
      link.first = noun.first;
      link.last = noun.last;
      const SceneObject* support = scene_.find_object(neighbour_support);
      if (support != nullptr && support->id != object.id) {
        add(link, R::kOn, {object.id}, {neighbour_support});
        scene_.relations.back().assumed = true;
        return;
      }
    }
    object.mount = Mount::kFloor;
    if (is_lamp(catalog_, noun) && one_of(noun.name, {"lamp", "light"})) specialise({"floor_lamp"});
  }

  // On or in a thing other than a rug.
  bool is_carried(const std::string& object) const {
    return std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      if ((r.type != R::kOn && r.type != R::kIn) || std::find(r.targets.begin(), r.targets.end(), object) == r.targets.end() ||
          r.references.empty())
        return false;
      for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
        if (scene_.objects[i].id == r.references.front())
          return document_.items[i].noun.entry == nullptr || !document_.items[i].noun.entry->thin;
      }
      return false;
    });
  }

  void note_contradictions() {
    for (const SceneObject& object : scene_.objects) {
      const Relation *wall = nullptr, *middle = nullptr;
      for (const Relation& relation : scene_.relations) {
        if (std::find(relation.targets.begin(), relation.targets.end(), object.id) == relation.targets.end()) continue;
        const bool at_wall = relation.type == R::kAgainstWall || relation.type == R::kCorner || relation.type == R::kCenteredOnWall;
        if (at_wall && wall != nullptr && relation.type == R::kAgainstWall && wall->type == R::kAgainstWall &&
            !relation.references.empty() && !wall->references.empty() && relation.references != wall->references &&
            !opposite_ok(relation, *wall)) {
          scene_.notes.push_back(
              {"contradiction", "\"" + object.name + "\" cannot be \"" + wall->why + "\" and \"" + relation.why + "\"", "prompt"});
        }
        if (at_wall) wall = &relation;
        if (relation.type == R::kCenterOfRoom) middle = &relation;
      }
      if (wall != nullptr && middle != nullptr) {
        scene_.notes.push_back(
            {"contradiction", "\"" + object.name + "\" cannot be \"" + wall->why + "\" and \"" + middle->why + "\"", "prompt"});
      }
    }
  }

  // Two neighbouring walls make a corner.
  static bool opposite_ok(const Relation& a, const Relation& b) {
    const auto side = [](const std::string& w) { return w == "left" || w == "right"; };
    return side(a.references.front()) != side(b.references.front());
  }

  const Catalog& catalog_;
  Document& document_;
  SceneGraph& scene_;
};

}  // namespace

void build_relations(const Lexicon& lexicon, Document& document, SceneGraph& scene) { Builder(lexicon, document, scene).run(); }

}  // namespace layoutbox::offline
