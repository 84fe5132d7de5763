// Places whose reference is not said: "nearby", "on each side", "to its left", "in the center".
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

namespace {

bool of_group_only(const PhraseSenses& senses) {
  return !senses.empty() &&
         std::all_of(senses.begin(), senses.end(), [](const PhraseSense& s) { return relation_row(s.type).arity == RelationArity::kNone; });
}

// Whom a place without its reference is by: "nearby", "in between".
NounPhrase unsaid(const PhraseSenses& senses) {
  NounPhrase them;
  them.kind = NounKind::kPronoun;
  them.plural = says(senses, RelationType::kBetween);
  return them;
}

// "to the left" of "to the right".
bool are_opposed(const PhraseSenses& one, const PhraseSenses& other) {
  using enum RelationType;
  static constexpr std::pair<RelationType, RelationType> kSides[] = {{kLeftOf, kRightOf}, {kInFrontOf, kBehind}, {kAtHeadOf, kAtFootOf}};
  return std::ranges::any_of(kSides, [&](const auto& sides) {
    return (says(one, sides.first) && says(other, sides.second)) || (says(one, sides.second) && says(other, sides.first));
  });
}

}  // namespace

// What the sentence placed something else to the left or right of, where the place at u says left or right.
Referent Decoder::side_host(const State& state, int u, const PhraseSenses& senses) const {
  const auto across = [](const PhraseSenses& all) { return says(all, RelationType::kLeftOf) || says(all, RelationType::kRightOf); };
  const auto along = [](const PhraseSenses& all) { return says(all, RelationType::kInFrontOf) || says(all, RelationType::kBehind); };
  const auto at_end = [](const PhraseSenses& all) { return says(all, RelationType::kAtHeadOf) || says(all, RelationType::kAtFootOf); };
  const bool by_side = across(senses), by_end = at_end(senses);
  if (!by_side && !by_end && !along(senses)) return kNobody;
  const auto sides = [&](const PhraseSenses& all) { return by_side ? across(all) : by_end ? at_end(all) : along(all); };
  bool contrasted = false;
  for (int p = u; p-- > 0;) {
    const UnitReading& place = read_as(state, p);
    // Of another clause, unless that says the other side ("…, whereas a lamp stands to the right"), or after a place that it begins with.
    contrasted = contrasted || unit(p + 1).clause;
    if (contrasted && is(p, UnitKind::kPlace) && !are_opposed(senses, place.alone ? alone_senses(p) : unit(p).direct)) return kNobody;
    if (p + 1 < u && is(p + 1, UnitKind::kPlace) && read_as(state, p + 1).fronted && !read_as(state, p + 1).alone) return kNobody;
    // "a pot to the left of it, a lamp to the right, two chisels in front": of what the last unsaid side was of.
    const bool chained =
        is(p, UnitKind::kPlace) && along(senses) && !follows(u, UnitKind::kNoun) && place.alone && !says_its(u) && across(alone_senses(p));
    if (chained && place.implied != kNobody && place.subject >= 0 && read_as(state, place.subject).role == NounRole::kRoot)
      return place.implied;
    if (!is(p, UnitKind::kPlace) || place.inverse || !(sides(unit(p).direct) || sides(unit(p).alone))) continue;
    const Referent host = place.alone ? place.implied : is(p + 1, UnitKind::kNoun) ? p + 1 : kNobody;
    if (host != kNobody) return host;
  }
  // "A desk stands to the left of the door. On the right is a bench."
  const bool opposed = before_.sided >= 0 && says(senses, before_.left ? RelationType::kRightOf : RelationType::kLeftOf);
  return opposed ? referent_of_mention(before_.sided) : kNobody;
}

// "A bed stands on the left", "… and a wardrobe on the right": of the room. How well that fits; nothing where the place is of a thing.
std::optional<double> Decoder::room_side_score(const State& state, int u) const {
  const PhraseSenses& senses = unit(u).alone;
  const bool left = says(senses, RelationType::kLeftOf), right = says(senses, RelationType::kRightOf);
  if (left == right || says_its(u) || document_.tokens[chunk(u).last - 1].text == "it") return {};
  for (int p = u; p-- > 0 && !unit(p + 1).clause;) {
    if (!is(p, UnitKind::kPlace)) continue;
    const PhraseSenses& other = alone_senses(p);
    const bool of_room = read_as(state, p).alone && read_as(state, p).implied == kNobody;
    if (says(other, left ? RelationType::kRightOf : RelationType::kLeftOf)) return of_room ? weight::kSameSide : weight::kSideOfRoom;
    // "bookshelves in the left half, tables on the right"
    const RoomRegion across = left ? RoomRegion::kRight : RoomRegion::kLeft;
    const bool half = std::ranges::any_of(other, [&](const PhraseSense& s) { return s.region == across; });
    if (half && of_room) return weight::kSameSide;
  }
  // "On the left are two tables. A fridge is near the door, on the right.": the other side of the room
  if (before_.side == (left ? RoomRegion::kRight : RoomRegion::kLeft)) return weight::kSameSide;
  return begins_with_side(u) ? weight::kSideFirst : weight::kSideOfRoom;
}

// "one to the left and one to the right of the mirror": what the other side's reference, which comes later, is.
Referent Decoder::side_ahead(int u, const PhraseSenses& senses) const {
  constexpr int kAhead = 4;
  for (int p = u + 1; p <= u + kAhead && p < static_cast<int>(sentence_.size()) && !unit(p).clause; ++p) {
    if (!is(p, UnitKind::kPlace)) continue;
    if (!are_opposed(senses, unit(p).direct) || !follows(p, UnitKind::kNoun)) return kNobody;
    return speaks_of_others(chunk(p + 1).noun) || is_new_thing(chunk(p + 1).noun) ? kNobody : p + 1;
  }
  return kNobody;
}

// "two armchairs on both sides near the sofa": of what the next place names.
Referent Decoder::sides_ahead(int u, const PhraseSenses& senses) const {
  const bool near = says(senses, RelationType::kEachSideOf) && follows(u, UnitKind::kPlace) && follows(u + 1, UnitKind::kNoun) &&
                    (says(unit(u + 1).direct, RelationType::kNear) || says(unit(u + 1).direct, RelationType::kNextTo));
  return near ? u + 2 : kNobody;
}

// The reference is not said: "nearby", "on each side", "to its left".
void Decoder::alone_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const Unit& place = unit(u);
  const PhraseMatch& phrase = chunk(u).phrase;
  const bool alone = !place.alone.empty();
  const std::string& last = document_.tokens[chunk(u).last - 1].text;
  const bool open_end = last == "of" || last == "to" || last == "from" || last == "with" || last == "by" || last == "at" || last == "on" ||
                        last == "in" || last == "against";
  if (is_own_top(state, u)) {
    add(s, kPass, 0);
    return;
  }
  if (const int doer = doer_of_relative(state, u); doer >= 0) {
    add(s, kAttachAlone, weight::kUsual, u - 1, doer, state.told);
    return;
  }
  const bool up_or_down = says(place.direct, RelationType::kAbove) || says(place.direct, RelationType::kUnder);
  if (!alone && !phrase.possessive && (open_end || place.direct.empty() || !up_or_down)) {
    add(s, kPass, 0);
    return;
  }
  if (state.frontier.empty()) {
    front_alone_actions(s, u, 0);
    return;
  }
  int nearer = 0;
  for (std::size_t level = state.frontier.size(); level-- > 0;) {
    const bool of_relative = state.relative < 0 || state.frontier[level] == state.relative;  // "a mirror that hangs between them"
    if (is_thing(state, state.frontier[level]) && of_relative) alone_of_member(s, u, level, nearer++);
  }
  const bool of_no_thing = place.joiner == Joiner::kNone && speaks_of_no_thing(state);
  if (of_no_thing || actions_.empty() || actions_.back().state != s) add(s, kPass, of_no_thing ? 1.5 : -2);
  if (place.joiner == Joiner::kNone) return;
  // "to its right there is a plant, to its left a table"
  const bool noun_next = follows(u, UnitKind::kNoun) && chunk(u + 1).noun.kind == NounKind::kObject;
  // "on it, from left to right, stand a jar and a mug"
  int verb = is(u + 1, UnitKind::kPlace) && says(unit(u + 1).alone, RelationType::kRow) ? u + 2 : u + 1;
  // "… and opposite it, along the wall, are three lockers", "…, hung a crucifix", "…, a shelf"
  const int next = past_places(verb);
  const bool begins = place.clause || place.joiner == Joiner::kAnd || place.joiner == Joiner::kCommaAnd || goes_on_in_turn(state, u);
  const bool comma_next = is(next, UnitKind::kNoun) && unit(next).joiner == Joiner::kComma && is_new_thing(chunk(next).noun) &&
                          begins;  // "… and, right on top, a raven"
  const bool verb_next = brings_by_verb(next);
  if (noun_next || verb_next || comma_next) front_alone_actions(s, u, 2.5);
}

// What the place at u says without its reference.
const PhraseSenses& Decoder::alone_senses(int u) const { return unit(u).alone.empty() ? unit(u).direct : unit(u).alone; }

bool Decoder::says_its(int u) const {
  const auto first = document_.tokens.begin() + static_cast<std::ptrdiff_t>(chunk(u).first),
             last = document_.tokens.begin() + static_cast<std::ptrdiff_t>(chunk(u).last);
  return std::any_of(first, last, [](const Token& token) { return token.text == "its"; });
}

// "on its left end a toaster, in the middle a bowl": what the place before put a small thing on, where another one follows.
Referent Decoder::carrier_before(const State& state, int u) const {
  const bool small =
      follows(u, UnitKind::kNoun) && chunk(u + 1).noun.kind == NounKind::kObject && mount_of(chunk(u + 1).noun) == Mount::kSurface;
  for (int p = u; small && p-- > 0 && !unit(p + 1).clause;) {
    if (!is(p, UnitKind::kPlace)) continue;
    if (read_as(state, p).alone && says_its(p)) return read_as(state, p).implied;  // "on its left end"
    const bool on = says(unit(p).direct, RelationType::kOn) && follows(p, UnitKind::kNoun) && chunk(p + 1).noun.kind == NounKind::kPart;
    if (!on) return kNobody;
    return read_as(state, p + 1).meant != kNobody ? read_as(state, p + 1).meant : p + 1;
  }
  return kNobody;
}

// It comes before its thing.
void Decoder::front_alone_actions(std::size_t s, int u, double gain) {
  const State& state = states_[s];
  const PhraseSenses& senses = alone_senses(u);
  if (of_group_only(senses)) {
    if (const Referent carrier = carrier_before(state, u); carrier != kNobody && says(senses, RelationType::kCenterOfRoom))
      add(s, kFrontAlone, gain + weight::kPartOfCarrier, -1, -1, carrier);
    add(s, kFrontAlone, gain);
    return;
  }
  NounPhrase them = unsaid(senses);
  const bool named = says_its(u) || document_.tokens[chunk(u).last - 1].text == "it";  // "to its right", "opposite it"
  if (named && !them.plural) them.head = "it";
  if (const Referent host = side_host(state, u, senses); host != kNobody) add(s, kFrontAlone, gain + weight::kSameSide, -1, -1, host);
  for (const Candidate& meant : antecedents(state, kNobody, &senses, &them))
    add(s, kFrontAlone, gain + meant.score, -1, -1, meant.referent, meant.list);
  // "On it stands a fan": on something that was named, whatever desks usually carry.
  add(s, kFrontAlone, gain + (named ? weight::kOfNothing : room_side_score(state, u).value_or(-5)));
}

// "side by side", "shoulder to shoulder", stacks: of the list by itself.
bool Decoder::by_each_other(int u) const {
  const std::string& last = document_.tokens[chunk(u).last - 1].text;
  return (chunk(u).last > chunk(u).first + 1 && last == word(u)) || says(alone_senses(u), RelationType::kStacked);
}

// Of the thing at that level of the frontier; `nearer`: how many things are nearer.
void Decoder::alone_of_member(std::size_t s, int u, std::size_t level, int nearer) {
  const State& state = states_[s];
  const Unit& place = unit(u);
  const PhraseSenses& senses = alone_senses(u);
  const int member = state.frontier[level];
  double gain = attach_score(state, u, static_cast<int>(level), false) + (place.joiner == Joiner::kNone ? weight::kLevelAlone * nearer : 0);
  if (is(u - 1, UnitKind::kVerb) && level > 0 && state.relative < 0) gain -= 3;
  // "a washbasin with a mirror opposite": the washbasin
  const bool held = read_as(state, member).role == NounRole::kContent && is_thing(state, host_of(state, member));
  if (held && says(senses, RelationType::kOpposite) && mount_of(noun_of(state, member)) != Mount::kFloor) gain += weight::kSmallByPlace;
  if (by_each_other(u)) {
    alone_of_list(s, u, level, {kNobody, gain + (several(state, member) ? 1 : 0), false});
    return;
  }
  if (of_group_only(senses)) {
    alone_of_room(s, u, level, gain);
    return;
  }
  NounPhrase whom = unsaid(senses);
  // Said, as part of the phrase.
  if (document_.tokens[chunk(u).last - 1].text == "it" || (says_its(u) && !whom.plural)) whom.head = "it";
  // "a laptop on the right side of the desk and a mug on the left side": of the desk as well.
  // … but what stands on the floor is not to the side of what lies on a thing
  const auto lies_beside = [&](Referent host) { return mount_of(noun_of(state, member)) != Mount::kFloor || !is_carried(state, host); };
  if (const Referent host = side_host(state, u, senses); host != kNobody && !same(state, host, member) && lies_beside(host))
    alone_of_list(s, u, level, {host, gain + weight::kSameSide, false});
  if (const auto room = room_side_score(state, u); room && mount_of(noun_of(state, member)) != Mount::kSurface)
    alone_of_list(s, u, level, {kNobody, gain + *room, false});
  const Referent side = side_ahead(u, senses);
  if (const Referent ahead = side != kNobody ? side : sides_ahead(u, senses); ahead != kNobody)
    alone_of_list(s, u, level, {ahead, gain + weight::kSameSide, false});
  const auto habit = [&](Referent by) { return place.joiner == Joiner::kNone ? habit_score(state, u, member, by, senses) : 0; };
  const int first = state.verb && level == 0 ? state.first_subject : -1;  // "a radio and a clock stand on it": on neither
  // "tables for two, a bar on the right": beside none of so many
  const auto crowd = [&](Referent by) {
    if (!room_side_score(state, u) || mount_of(noun_of(state, member)) != Mount::kFloor || !is_thing(state, by)) return 0.0;
    const NounPhrase& noun = noun_of(state, by);
    return noun.count > 2 || (noun.plural && noun.count == 0) ? 2 * weight::kSmallByPlace : 0.0;
  };
  // "a chapel with statues on both sides": of the room, where nothing is named that has sides
  const bool of_room =
      says(senses, RelationType::kEachSideOf) && several(state, member) && mount_of(noun_of(state, member)) == Mount::kFloor;
  if (of_room && !says_its(u)) alone_of_list(s, u, level, {kNobody, gain + weight::kSidesOfRoom, false});
  for (const Candidate& meant : antecedents(state, member, &senses, &whom, first))
    alone_of_list(s, u, level, {meant.referent, gain + meant.score + habit(meant.referent) + crowd(meant.referent), meant.list});
}

// Of it alone, and of the list that it ends.
void Decoder::alone_of_list(std::size_t s, int u, std::size_t level, const Candidate& meant) {
  const State& state = states_[s];
  const int member = state.frontier[level];
  add(s, kAttachAlone, meant.score, member, state.verb && level == 0 && state.first_subject >= 0 ? state.first_subject : member,
      meant.referent, meant.list);
  const bool mutual = by_each_other(u);
  double shared = 0;
  for (int m = member; m >= 0;) {
    const int former = read_as(state, m).former;
    const double of_each_other = former >= 0 && !several(state, m) && !is_told_by_itself(state, former) ? 1.5 : -10;
    const double more = mutual ? of_each_other : share_score(state, m, u, meant.referent);
    if (more < -5) break;
    shared += shared == 0 ? more : 0.2;
    m = read_as(state, m).former;
    if (meant.referent != kNobody && same(state, m, meant.referent)) break;
    add(s, kAttachAlone, meant.score + shared, member, m, meant.referent, meant.list);
  }
}

// "a rug with a table at its center": of what has the table, not of the room.
bool Decoder::is_at_center_of_host(const State& state, int u, Referent member) const {
  const Referent host = host_of(state, member);
  return says_its(u) && is_thing(state, host) && sense_.carries(noun_of(state, host), noun_of(state, member));
}

// "a bowl on a table at its center": the table is not at its own.
double Decoder::own_center_score(const State& state, int u, int member) const {
  const bool its = says(alone_senses(u), RelationType::kCenterOfRoom) && says_its(u);
  return its && read_as(state, member).role == NounRole::kReference ? weight::kLiesTwice : 0;
}

// "a bed with two nightstands in the middle", "desks with chairs in rows", "tables with chairs and red cloths, placed in two rows": the
// bed, the desks and the tables are.
double Decoder::array_score(const State& state, int u, int member, bool many) const {
  const Referent host = host_of(state, member);
  const bool in_middle = says(alone_senses(u), RelationType::kCenterOfRoom) && unit(u).joiner == Joiner::kNone;
  const bool of_many = several(state, host) || (host >= 0 && chunk(host).noun.determiner == Determiner::kEach);
  const double seats = comes_with(state, member) && (many ? of_many : in_middle) ? weight::kSmallByPlace : 0;
  const bool cloth = many && is_textile(lexicon_.catalog(), noun_of(state, member)) && host != kNobody;
  return seats + (cloth ? 2 * weight::kSmallByPlace : 0);
}

// "in a row", "in the center", "at the back": of the room, or of what has or carries the thing.
void Decoder::alone_of_room(std::size_t s, int u, std::size_t level, double gain) {
  const State& state = states_[s];
  const PhraseSenses& senses = alone_senses(u);
  const int member = state.frontier[level];
  NounPhrase room;
  room.kind = NounKind::kRoom;
  const double fits = sense_.of_place(senses, noun_of(state, member), room);
  const bool many = says(senses, RelationType::kRow) || says(senses, RelationType::kGrid) || says(senses, RelationType::kColumn);
  // "On the desk a blotter in the center", "on it: a cello in the middle": whatever else such things lie on.
  const int front = state.fronted.empty() ? -1 : state.fronted.front();
  const Referent carrier = front < 0 ? kNobody : read_as(state, front).alone ? read_as(state, front).implied : front + 1;
  const bool on_fronted = front >= 0 && is_thing(state, carrier) &&
                          says(read_as(state, front).alone ? alone_senses(front) : unit(front).direct, RelationType::kOn) &&
                          !(noun_of(state, carrier).entry != nullptr && noun_of(state, carrier).entry->thin);
  // "a table with a laptop in the center": of the table; "a counter with a sink in the middle": let into it.
  const Referent host = host_of(state, member);
  const CatalogEntry* entry = noun_of(state, member).entry;
  const bool let_in = entry != nullptr && kind_at(lexicon_.catalog(), entry->id, KinPlace::kSetIn) != nullptr && is_thing(state, host) &&
                      noun_of(state, host).entry != nullptr && noun_of(state, host).entry->is(Trait::kCounter);
  const bool lies = says(senses, RelationType::kCenterOfRoom) &&
                    (mount_of(noun_of(state, member)) == Mount::kSurface || on_fronted || let_in || is_at_center_of_host(state, u, member));
  // "a desk with a chair at the back": behind the desk.
  const bool end = says(senses, RelationType::kInRegion) && mount_of(noun_of(state, member)) == Mount::kFloor && is_thing(state, host) &&
                   unit(u).joiner == Joiner::kNone && std::any_of(senses.begin(), senses.end(), [](const PhraseSense& sense) {
                     return sense.region == RoomRegion::kBack || sense.region == RoomRegion::kFront;
                   });
  // … but "a bar with five stools at the back": the bar is
  const bool seats = end && several(state, member) && comes_with(state, member);
  if (end && !seats) add(s, kAttachAlone, gain + 1.5, member, member, host);
  if (seats) gain += weight::kSmallByPlace;
  // … but "a table with magazines in the middle" stands there itself.
  const bool many_lie = is_thing(state, host) && (several(state, member) || is_textile(lexicon_.catalog(), noun_of(state, member)));
  if (lies && is_thing(state, host)) add(s, kAttachAlone, gain + (many_lie ? -1 : 1), member, member, host);
  if (lies && is_thing(state, host)) gain += weight::kSmallByPlace;
  for (const Candidate& meant : lies&& host == kNobody && state.fronted.empty() ? carriers(state, member) : std::vector<Candidate>{})
    add(s, kAttachAlone, gain + meant.score, member, member, meant.referent);
  if (lies && is_thing(state, carrier)) add(s, kAttachAlone, gain + 1, member, member, carrier);
  gain += own_center_score(state, u, member);
  gain += array_score(state, u, member, many);
  // "a counter with an espresso machine and a pastry display at the back": the counter
  if (says(senses, RelationType::kInRegion) && unit(u).joiner == Joiner::kNone && is_thing(state, host) &&
      mount_of(noun_of(state, host)) == Mount::kFloor && read_as(state, member).former >= 0)
    gain += (mount_of(noun_of(state, member)) == Mount::kSurface ? 2 : 1) * weight::kSmallByPlace;
  // "a counter with a machine and a cake stand at the back": what lies on things is at no end of the room by itself
  const bool lies_nowhere = says(senses, RelationType::kInRegion) && unit(u).joiner == Joiner::kNone && !is_thing(state, host) &&
                            state.fronted.empty() && read_as(state, member).former >= 0 && word(u) != "on" &&
                            mount_of(noun_of(state, member)) == Mount::kSurface;
  if (lies_nowhere) gain += weight::kSmallByPlace;
  const bool several_here = several(state, member);
  alone_of_list(s, u, level, {kNobody, gain + fits + (!many ? 0 : several_here ? 1.0 : -1.0), false});
}

}  // namespace layoutbox::offline
