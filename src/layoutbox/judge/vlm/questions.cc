#include "layoutbox/judge/vlm/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "layoutbox/base/random.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::vlm {
namespace {

constexpr std::size_t kDrawn = 4;       // relations that a multi-relation question is drawn from, as in the paper
constexpr std::size_t kMostPairs = 40;  // objects that relations are read from, at most

void replace_all(std::string& text, std::string_view from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
}

std::string words_for(const std::string& id, const Layout& layout) {
  if (const PlacedObject* object = layout.find_object(id)) {
    const auto name_of_thing = [](const PlacedObject& thing) { return thing.name.empty() ? thing.category : thing.name; };
    std::string name = name_of_thing(*object);
    const auto alike = std::count_if(layout.objects.begin(), layout.objects.end(),
                                     [&](const PlacedObject& other) { return name_of_thing(other) == name; });
    std::replace(name.begin(), name.end(), '_', ' ');
    return alike > 1 ? fmt::format("the {} ({})", name, id) : "the " + name;
  }
  if (const Wall* wall = layout.find_wall(id)) {
    for (const char* side : {"left", "right", "back", "front"}) {
      if (layout.find_wall(side) == wall) return fmt::format("the {} wall", side);
    }
    return "the wall " + wall->id;
  }
  if (const Opening* opening = layout.find_opening(id)) return opening->type == OpeningType::kWindow ? "the window" : "the door";
  return id == "room" || id == "floor" || id == "ceiling" ? "the " + id : id;
}

std::string list_in_words(const std::vector<std::string>& ids, const Layout& layout) {
  std::string text;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    text += i == 0 ? "" : i + 1 == ids.size() ? " and " : ", ";
    text += words_for(ids[i], layout);
  }
  return text;
}

std::string nothing_named(RelationType type) {
  const std::string_view name = relation_row(type).name;
  if (name.find("Window") != std::string_view::npos) return "a window";
  if (name.find("Door") != std::string_view::npos) return "a door";
  return name == "corner" ? "the room" : "a wall";
}

// Every relation's verdict, by the verifier.
std::vector<Hop> measured(const Layout& layout, const Catalog& catalog, const std::vector<Relation>& relations) {
  Layout asked = layout;
  asked.relations.clear();
  asked.relaxed.clear();
  asked.gave_way.clear();
  std::vector<Hop> hops;
  for (const Relation& relation : relations) {
    std::string sentence = sentence_of(relation, layout);
    if (sentence.empty()) continue;
    Relation soft = relation;
    soft.hard = false;
    asked.relations.push_back({std::move(soft), true});
    hops.push_back({relation, std::move(sentence), false, {}});
  }
  std::size_t next = 0;
  for (const Check& check : verify(asked, catalog).checks) {
    if (check.name != "relation") continue;
    hops[next].holds = check.passed;
    hops[next].why = check.message.substr(0, check.message.find(" (the layout says"));
    ++next;
  }
  return hops;
}

Relation relation_between(RelationType type, const std::string& target, std::vector<std::string> references) {
  Relation relation;
  relation.id = fmt::format("{} {}", target, relation_row(type).name);
  relation.type = type;
  relation.targets = {target};
  relation.references = std::move(references);
  return relation;
}

// What could be said of a room of which nothing is said.
std::vector<Relation> all_that_could_be_said(const Layout& layout) {
  std::vector<Relation> relations;
  const std::size_t count = std::min(layout.objects.size(), kMostPairs);
  for (std::size_t i = 0; i < count; ++i) {
    const PlacedObject& object = layout.objects[i];
    if (layout.find_object(object.supported_by)) relations.push_back(relation_between(RelationType::kOn, object.id, {object.supported_by}));
    if (object.supported_by == "floor") relations.push_back(relation_between(RelationType::kAgainstWall, object.id, {}));
    for (std::size_t j = 0; j < count; ++j) {
      if (i == j) continue;
      for (const RelationRow& row : relation_table()) {
        if (traits_of(row.type).of_any_two) relations.push_back(relation_between(row.type, object.id, {layout.objects[j].id}));
      }
    }
  }
  return relations;
}

class QuestionDrawer {
 public:
  QuestionDrawer(const Layout& layout, const Catalog& catalog, const QuestionOptions& options)
      : layout_(layout), catalog_(catalog), options_(options), random_(options.seed) {}

  std::vector<RoomQuestion> draw() {
    if (layout_.objects.size() < 2) return {};
    gather();
    add_singles();
    for (int i = 0; i < options_.multis; ++i) add_multi(i + 1);
    return std::move(questions_);
  }

 private:
  // Those asked for first, then others that hold, in an order of chance.
  void gather() {
    std::vector<Relation> own;
    for (const PlacedRelation& placed : layout_.relations) {
      if (placed.relation.asked()) own.push_back(placed.relation);
    }
    std::vector<Hop> asked = measured(layout_, catalog_, own), others = measured(layout_, catalog_, all_that_could_be_said(layout_));
    random_.shuffle(asked);
    random_.shuffle(others);
    for (Hop& hop : asked) (hop.holds ? true_ : false_).push_back(std::move(hop));
    for (Hop& hop : others) (hop.holds ? true_ : false_).push_back(std::move(hop));
  }

  // A hop that does not hold and is as like the given one as can be: the same target, else the same reference.
  const Hop* false_twin(const Hop& hop) {
    const auto rank = [&](const Hop& other) {
      int likeness = other.relation.targets == hop.relation.targets ? 4 : 0;
      likeness += other.relation.references == hop.relation.references ? 2 : 0;
      return likeness + (other.relation.type == hop.relation.type ? 1 : 0) - (used_.contains(other.sentence) ? 8 : 0);
    };
    const auto best = std::max_element(false_.begin(), false_.end(), [&](const Hop& a, const Hop& b) { return rank(a) < rank(b); });
    if (best == false_.end()) return nullptr;
    used_.insert(best->sentence);
    return &*best;
  }

  void add(std::string id, QuestionKind kind, std::vector<Hop> hops) {
    RoomQuestion question;
    question.id = std::move(id);
    question.kind = kind;
    question.truth = std::all_of(hops.begin(), hops.end(), [](const Hop& hop) { return hop.holds; });
    if (hops.size() == 1) {
      question.text = fmt::format("Is it so that {}?", hops[0].sentence);
    } else {
      question.text = "Is all of this so?";
      for (std::size_t i = 0; i < hops.size(); ++i)
        question.text += fmt::format(" ({}) {}{}", i + 1, hops[i].sentence, i + 1 < hops.size() ? ";" : ".");
    }
    question.hops = std::move(hops);
    questions_.push_back(std::move(question));
  }

  void add_singles() {
    const std::size_t count = std::min({static_cast<std::size_t>(std::max(0, options_.singles)), true_.size(), false_.size()});
    for (std::size_t i = 0; i < count; ++i) {
      const Hop* twin = false_twin(true_[i]);
      if (twin == nullptr) return;
      add(fmt::format("s{}", i + 1), QuestionKind::kSingle, {true_[i]});
      add(fmt::format("s{}-false", i + 1), QuestionKind::kSingle, {*twin});
    }
  }

  static bool share_an_object(const Relation& a, const Relation& b) {
    std::set<std::string> ids(a.targets.begin(), a.targets.end());
    ids.insert(a.references.begin(), a.references.end());
    const auto known = [&](const std::string& id) { return ids.contains(id); };
    return std::any_of(b.targets.begin(), b.targets.end(), known) || std::any_of(b.references.begin(), b.references.end(), known);
  }

  // Up to four of those that are drawn, joined by what they share, from the first on.
  static std::vector<Hop> joined_from(const std::vector<Hop>& drawn, std::size_t first) {
    std::vector<Hop> joined;
    for (std::size_t i = 0; i < drawn.size() && joined.size() < kDrawn; ++i) {
      const Hop& hop = drawn[(first + i) % drawn.size()];
      const bool fits = joined.empty() || std::any_of(joined.begin(), joined.end(), [&](const Hop& other) {
                          return other.sentence != hop.sentence && share_an_object(other.relation, hop.relation);
                        });
      if (fits) joined.push_back(hop);
    }
    return joined;
  }

  void add_multi(int number) {
    std::vector<Hop> drawn = true_;
    random_.shuffle(drawn);
    std::vector<Hop> joined;
    for (std::size_t first = 0; first < drawn.size() && joined.size() < 2; ++first) joined = joined_from(drawn, first);
    if (joined.size() < 2) return;
    joined.resize(2 + random_.below(joined.size() - 1));
    const std::size_t changed = random_.below(joined.size());
    const Hop* twin = false_twin(joined[changed]);
    if (twin == nullptr) return;
    add(fmt::format("m{}", number), QuestionKind::kMulti, joined);
    joined[changed] = *twin;
    add(fmt::format("m{}-false", number), QuestionKind::kMulti, std::move(joined));
  }

  const Layout& layout_;
  const Catalog& catalog_;
  const QuestionOptions& options_;
  Random random_;
  std::vector<Hop> true_, false_;
  std::set<std::string> used_;
  std::vector<RoomQuestion> questions_;
};

}  // namespace

std::string_view name_of(QuestionKind kind) { return kind == QuestionKind::kSingle ? "single" : "multi"; }

void measure_in_blend(std::vector<RoomQuestion>& questions, const Layout& layout, const Layout& read_back, const Catalog& catalog) {
  Layout built = layout;
  std::set<std::string> gone;
  for (PlacedObject& object : built.objects) {
    const PlacedObject* found = read_back.find_object(object.id);
    if (found == nullptr) {
      gone.insert(object.id);
      continue;
    }
    object.position = found->position;
    object.size = found->size;
    object.rotation_deg = found->rotation_deg;
  }
  for (RoomQuestion& question : questions) {
    std::vector<Relation> relations;
    for (const Hop& hop : question.hops) relations.push_back(hop.relation);
    const std::vector<Hop> again = measured(built, catalog, relations);
    for (std::size_t i = 0; i < std::min(again.size(), question.hops.size()); ++i) {
      Hop& hop = question.hops[i];
      const auto missing = [&](const std::vector<std::string>& ids) {
        return std::any_of(ids.begin(), ids.end(), [&](const std::string& id) { return gone.contains(id); });
      };
      const bool there = !missing(hop.relation.targets) && !missing(hop.relation.references);
      hop.in_blend = there && again[i].holds;
      hop.why_in_blend = there ? again[i].why : "something of it is not in the .blend";
    }
  }
}

std::string sentence_of(const Relation& relation, const Layout& layout) {
  std::string text(relation_row(relation.type).sentence);
  replace_all(text, "{targets}", list_in_words(relation.targets, layout));
  replace_all(text, "{references}",
              relation.references.empty() ? nothing_named(relation.type) : list_in_words(relation.references, layout));
  const RelationParameters& given = relation.parameters;
  const auto metres = [&](std::string_view name, std::optional<Mm> RelationFigures::*parameter) {
    if (const auto length = in_effect(relation, parameter))
      replace_all(text, fmt::format("{{{}}}", name), format_number(*length / 1000.0) + " m");
  };
  metres("min", &RelationParameters::min);
  metres("max", &RelationParameters::max);
  metres("distance", &RelationParameters::distance);
  if (given.region) replace_all(text, "{region}", std::string(name_of(*given.region)));
  return text.find('{') == std::string::npos ? text : std::string{};
}

std::vector<RoomQuestion> draw_questions(const Layout& layout, const Catalog& catalog, const QuestionOptions& options) {
  return QuestionDrawer(layout, catalog, options).draw();
}

}  // namespace layoutbox::vlm
