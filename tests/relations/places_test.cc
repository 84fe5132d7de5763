// Every value of `edge`, `region` and `part`, by plain coordinates: the solver puts things there, the verifier says so.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_scene.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::placement {
namespace {

// Solved with the relation held; the verifier agrees.
Layout solved(const SceneGraph& scene, std::string_view said) {
  const auto layout = solve(scene, Catalog::builtin());
  if (!layout) {
    ADD_FAILURE() << said << ": " << layout.error().message;
    return {};
  }
  EXPECT_EQ(layout->status, LayoutStatus::kSolved) << said;
  for (const Check& check : verify(*layout, Catalog::builtin()).checks) {
    EXPECT_TRUE(check.passed || !check.required) << said << ": " << check.message;
  }
  return *layout;
}

struct Span {
  double low, high;
  double middle() const { return (low + high) / 2; }
};

// Along an axis of the room. REQUIRES: turned by quarter turns.
Span span_of(const PlacedObject& o, int axis) {
  const bool turned = static_cast<int>(std::lround(o.rotation_deg / 90)) % 2 != 0;
  if (axis == 2) return {o.position[2], o.position[2] + o.size.height};
  const double length = (axis == 0) != turned ? o.size.width : o.size.depth;
  return {o.position[axis] - length / 2, o.position[axis] + length / 2};
}

double coordinate(const Span& span, Edge edge) {
  using enum Edge;
  if (edge == kCenter) return span.middle();
  return edge == kMin || edge == kLeft || edge == kFront || edge == kBottom ? span.low : span.high;
}

int axis_of(Edge edge) {
  using enum Edge;
  return edge == kFront || edge == kBack ? 1 : edge == kBottom || edge == kTop ? 2 : 0;
}

TEST(Places, AlignByEveryEdge) {
  for (const char* type : {"align", "groupAlign"}) {
    for (const Edge edge : edges_of(find_relation(type)->type)) {
      RelationParameters p;
      p.edge = edge;
      if (edge == Edge::kMin || edge == Edge::kMax || edge == Edge::kCenter) p.axis = Axis::kX;
      const std::string said = std::string(type) + " " + std::string(name_of(edge));
      SceneMaker maker(6000, 5000);
      if (axis_of(edge) == 2) {
        maker.add("mirror").sized(600, 30, 900).relate("onWall", {"mirror_1"}).add("painting").sized(500, 30, 400);
        maker.relate("onWall", {"painting_1"}).relate(type, {"painting_1", "mirror_1"}, {}, p);
      } else {
        maker.add("desk").at(3000, 2500, 0, 0, true).add("bench").relate(type, {"bench_1", "desk_1"}, {}, p);
      }
      const Layout layout = solved(maker.make(), said);
      ASSERT_GE(layout.objects.size(), 2u) << said;
      const int axis = axis_of(edge);
      EXPECT_NEAR(coordinate(span_of(layout.objects[0], axis), edge), coordinate(span_of(layout.objects[1], axis), edge), 5) << said;
    }
  }
}

TEST(Places, EdgeAlignByEveryEdge) {
  for (const Edge edge : edges_of(RelationType::kEdgeAlign)) {
    RelationParameters p;
    p.edge = edge;
    const std::string said = "edgeAlign " + std::string(name_of(edge));
    const Layout layout = solved(SceneMaker(6000, 5000)
                                     .add("desk")
                                     .at(3000, 2500, 0, 0, true)
                                     .add("bench")
                                     .sized(900, 400, 450)
                                     .relate("edgeAlign", {"bench_1"}, {"desk_1"}, p)
                                     .make(),
                                 said);
    ASSERT_EQ(layout.objects.size(), 2u) << said;
    const int axis = axis_of(edge);
    EXPECT_NEAR(coordinate(span_of(layout.objects[0], axis), edge), coordinate(span_of(layout.objects[1], axis), edge), 5) << said;
  }
}

// Where a point is said to be between 0 and 1: in the middle third, or in a half.
void expect_in(RoomRegion region, double x, double y, std::string_view said) {
  if (region == RoomRegion::kMiddle) {
    EXPECT_LE(std::max(std::abs(x - 0.5), std::abs(y - 0.5)), 0.17) << said;
    return;
  }
  if (lies_at(region, Side::kLeft)) {
    EXPECT_LE(x, 0.501) << said;
  }
  if (lies_at(region, Side::kRight)) {
    EXPECT_GE(x, 0.499) << said;
  }
  if (lies_at(region, Side::kFront)) {
    EXPECT_LE(y, 0.501) << said;
  }
  if (lies_at(region, Side::kBack)) {
    EXPECT_GE(y, 0.499) << said;
  }
}

TEST(Places, EveryRegionOfTheRoom) {
  for (std::size_t i = 0; i < region_names().size(); ++i) {
    RelationParameters p;
    p.region = static_cast<RoomRegion>(i);
    const std::string said(name_of(*p.region));
    const Layout inside = solved(SceneMaker(6000, 5000).add("plant").relate("inRegion", {"plant_1"}, {}, p).make(), "inRegion " + said);
    ASSERT_EQ(inside.objects.size(), 1u) << said;
    expect_in(*p.region, inside.objects[0].position[0] / 6000, inside.objects[0].position[1] / 5000, said);

    const Layout clear = solved(SceneMaker(6000, 5000).add("plant").relate("keepClear", {"plant_1"}, {}, p).make(), "keepClear " + said);
    ASSERT_EQ(clear.objects.size(), 1u) << said;
    const auto third_of = [](Span span, double room, bool low, bool high, bool middle) {
      if (middle) return span.high > room / 3 + 5 && span.low < room * 2 / 3 - 5;
      return low ? span.low < room / 3 - 5 : high ? span.high > room * 2 / 3 + 5 : true;
    };
    const bool middle = *p.region == RoomRegion::kMiddle;
    const auto at = [&](Side side) { return lies_at(*p.region, side); };
    EXPECT_FALSE(third_of(span_of(clear.objects[0], 0), 6000, at(Side::kLeft), at(Side::kRight), middle) &&
                 third_of(span_of(clear.objects[0], 1), 5000, at(Side::kFront), at(Side::kBack), middle))
        << "keepClear " << said;
  }
}

TEST(Places, EveryPartOfATop) {
  for (std::size_t i = 0; i < part_words().size(); ++i) {
    const auto word = static_cast<PartWord>(i);
    RelationParameters p;
    p.part = word;
    const std::string said = "on " + p.part.text();
    const Layout layout = solved(SceneMaker(5000, 4000)
                                     .add("desk")
                                     .sized(1600, 800, 740)
                                     .at(2500, 2000, 0, 0, true)
                                     .add("table_lamp")
                                     .relate("on", {"table_lamp_1"}, {"desk_1"}, p)
                                     .make(),
                                 said);
    ASSERT_EQ(layout.objects.size(), 2u) << said;
    const auto& lamp = layout.objects[1].position;
    const double x = (lamp[0] - 2500) / 1600, y = (lamp[1] - 2000) / 800;
    using enum PartWord;
    const bool far_x = std::abs(x) > 0.16, far_y = std::abs(y) > 0.16;
    const bool there = word == kBack     ? y > -0.01
                       : word == kFront  ? y < 0.01
                       : word == kLeft   ? x < 0.01
                       : word == kRight  ? x > -0.01
                       : word == kCenter ? std::max(std::abs(x), std::abs(y)) < 0.17
                       : word == kCorner ? far_x && far_y
                       : word == kEdge   ? far_x || far_y
                       : word == kEnd    ? far_x
                                         : lamp[2] > 735;
    EXPECT_TRUE(there) << said << ": " << x << ", " << y;
  }
}

}  // namespace
}  // namespace layoutbox::placement
