// Relations drawn by chance, and those of them that hold in a planted layout.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/relation_check.h"
#include "synthetic_draft.h"

namespace layoutbox::synthetic {
namespace {

class RelationDrawer {
 public:
  explicit RelationDrawer(Draft& draft) : random_(draft.random), scene_(draft.scene), layout_(draft.layout) {}

  Relation draw(int number) {
    const RelationRow& row = random_.one_of(relation_table());
    Relation relation;
    relation.id = "c" + std::to_string(number);
    relation.type = row.type;
    relation.hard = random_.chance(80);
    const bool group = row.group == RelationGroup::kGroupGroup && row.type != RelationType::kBetween;
    const bool several = group || row.type == RelationType::kGroupAlign || row.type == RelationType::kStacked || random_.chance(10);
    draw_targets(relation, several ? random_.number(2, 4) : 1);
    int references = row.arity == RelationArity::kNone   ? 0
                     : row.arity == RelationArity::kOne  ? 1
                     : row.arity == RelationArity::kMany ? 1
                                                         : random_.number(0, 1);
    if (row.type == RelationType::kBetween || row.type == RelationType::kPairedWith) references = 2;
    for (int i = 0; i < references; ++i) draw_other_reference(relation, row.reference_kinds);
    draw_parameters(relation, row.parameters);
    return relation;
  }

  // Draws relations until enough of them hold in the planted layout, without any slack.
  void read(int wanted) {
    if (scene_.objects.empty()) return;
    VerifyOptions strict;
    strict.relation_slack_m = 0;
    const checks::RoomView view(layout_, Catalog::builtin(), strict);
    Layout drawn = layout_;
    for (int i = 0; i < 60 * wanted; ++i) {
      Relation relation = draw(i);
      if (relation.targets.empty() || (relation.type == RelationType::kReachable && !random_.chance(5))) continue;
      fit_parameters(relation, view);
      drawn.relations.push_back({relation, false});
    }
    const checks::RoomView with_relations(drawn, Catalog::builtin(), strict);
    Report report;
    checks::check_relations(with_relations, report);
    std::vector<int> of_type(relation_table().size(), 0);
    for (std::size_t i = 0; i < drawn.relations.size() && wanted > 0; ++i) {
      const Relation& relation = drawn.relations[i].relation;
      int& used = of_type[static_cast<std::size_t>(relation.type)];
      if (!report.checks[i].passed || used >= 2 || surrounds_host_or_load(relation)) continue;
      ++used, --wanted;
      scene_.relations.push_back(relation);
    }
    keep_those_that_hold();
  }

 private:
  std::string draw_reference(unsigned kinds) {
    for (int attempt = 0; attempt < 8; ++attempt) {
      const unsigned kind = 1u << random_.number(0, 3);
      if (!(kinds & kind)) continue;
      if (kind == kObject && !scene_.objects.empty()) return random_.one_of(scene_.objects).id;
      if (kind == kWall) return random_.one_of(scene_.room.walls).id;
      if (kind == kOpening && !scene_.room.openings.empty()) return random_.one_of(scene_.room.openings).id;
      if (kind == kRoom) return "room";
    }
    return scene_.objects.empty() ? "room" : random_.one_of(scene_.objects).id;
  }

  void draw_targets(Relation& relation, int count) {
    for (int i = 0; i < count && !scene_.objects.empty(); ++i) {
      const std::string& id = random_.one_of(scene_.objects).id;
      if (std::find(relation.targets.begin(), relation.targets.end(), id) == relation.targets.end()) relation.targets.push_back(id);
    }
  }

  void draw_other_reference(Relation& relation, unsigned kinds) {
    for (int attempt = 0; attempt < 8; ++attempt) {
      const std::string id = draw_reference(kinds);
      const auto in = [&](const std::vector<std::string>& ids) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
      if (in(relation.targets) || in(relation.references)) continue;
      relation.references.push_back(id);
      return;
    }
  }

  void draw_parameters(Relation& relation, std::string_view names) {
    RelationParameters& p = relation.parameters;
    const auto reads = [&](std::string_view name) {
      const std::size_t at = names.find(name);
      return at != std::string_view::npos && random_.chance(50);
    };
    if (reads("axis")) p.axis = random_.chance(50) ? Axis::kX : Axis::kY;
    if (reads("max")) p.max = random_.number(1, 30) * 100;
    if (reads("min")) p.min = random_.number(0, p.max ? *p.max / 100 : 20) * 100;
    if (reads("distance")) p.distance = random_.number(0, 15) * 100;
    if (reads("gap")) p.gap = random_.number(0, 5) * 100;
    if (reads("depth")) p.depth = random_.number(3, 9) * 100;
    if (reads("width")) p.width = random_.number(5, 9) * 100;
    if (reads("height")) p.height = random_.number(9, 18) * 100;
    if (reads("side")) p.side = random_.one_of(std::array{Side::kFront, Side::kLeft, Side::kRight, Side::kBack, Side::kLong, Side::kShort});
    if (reads("part")) {
      using enum PartWord;
      p.part =
          random_.one_of(std::array<ThingPart, 9>{kLeft, kRight, kFront, kBack, kCenter, kCorner, kEdge, kEnd, ThingPart{kLeft, kCorner}});
    }
    if (reads("edge")) p.edge = random_.one_of(edges_of(relation.type));
    if (names.find("region") != std::string_view::npos) p.region = static_cast<RoomRegion>(random_.number(0, 8));
    if (reads("columns")) p.columns = random_.number(1, 3);
  }

  // Figures that chance would hardly meet are read from the planted layout.
  void fit_parameters(Relation& relation, const checks::RoomView& view) const {
    const checks::Body* t = view.find_body(relation.targets.front());
    if (relation.type == RelationType::kOnWall) relation.parameters.height = mm_from_m(t->underside());
    if (relation.references.empty()) return;
    const checks::Body* r = view.find_body(relation.references.front());
    if (r == nullptr) return;
    if (relation.type == RelationType::kOffset && relation.parameters.axis) {
      const checks::Vec2d axis = *relation.parameters.axis == Axis::kX ? checks::Vec2d{1, 0} : checks::Vec2d{0, 1};
      relation.parameters.distance =
          std::max(0, mm_from_m(-checks::overlap(checks::extent(t->shape, axis), checks::extent(r->shape, axis))));
    }
    if (relation.type == RelationType::kDistance) {
      const Mm gap = mm_from_m(checks::gap(t->shape, r->shape));
      relation.parameters.min = std::max(0, gap - 200), relation.parameters.max = gap + 100;
    }
    if (relation.type == RelationType::kAbove) relation.parameters.gap.reset();
  }

  // Nobody says of a table that it stands around the cup on it, or of the cup that it stands around the table; the solver looks for a
  // ring outside of what it is around.
  bool surrounds_host_or_load(const Relation& relation) const {
    if ((relation.type != RelationType::kSurround && relation.type != RelationType::kAround) || relation.references.size() != 1)
      return false;
    const auto stands_on = [&](const std::string& load, const std::string& host) {
      const PlacedObject* placed = layout_.find_object(load);
      return placed != nullptr && placed->supported_by == host;
    };
    const std::string& middle = relation.references[0];
    return std::ranges::any_of(relation.targets, [&](const auto& t) { return stands_on(middle, t) || stands_on(t, middle); });
  }

  // What belongs to what depends on the relations themselves: look once more with those that were taken.
  void keep_those_that_hold() {
    VerifyOptions strict;
    strict.relation_slack_m = 0;
    for (bool all = false; !all;) {
      layout_.relations.clear();
      for (const Relation& relation : scene_.relations) layout_.relations.push_back({relation, true});
      Report report;
      checks::check_relations(checks::RoomView(layout_, Catalog::builtin(), strict), report);
      std::size_t i = 0;
      all = std::erase_if(scene_.relations, [&](const Relation&) { return !report.checks[i++].passed; }) == 0;
    }
  }

  Random& random_;
  SceneGraph& scene_;
  Layout& layout_;
};

}  // namespace

Relation draw_relation(Draft& draft, int number) { return RelationDrawer(draft).draw(number); }

void read_relations(Draft& draft, int wanted) { RelationDrawer(draft).read(wanted); }

}  // namespace layoutbox::synthetic
