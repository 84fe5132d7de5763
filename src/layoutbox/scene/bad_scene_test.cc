// Scene files that must not be read: each fault is named, with its place.
#include <gmock/gmock.h>

#include "layoutbox/scene/test_paper_scene.h"

namespace layoutbox {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

// Every single error of a document that must not be read.
std::vector<Error> errors_of_text(const std::string& text) {
  const auto scene = read_scene(text);
  if (scene) {
    ADD_FAILURE() << "was read: " << text;
    return {};
  }
  return scene.error().details.empty() ? std::vector{scene.error()} : scene.error().details;
}
std::vector<Error> errors_of(const json& document) { return errors_of_text(document.dump()); }

std::vector<std::string> pointers(const std::vector<Error>& errors) {
  std::vector<std::string> out;
  for (const Error& error : errors) out.push_back(error.pointer);
  return out;
}

TEST(BadScene, BrokenJsonIsPlaced) {
  const auto broken = errors_of_text("{\n  \"room\": {},\n  \"furniture\": [,]\n}");
  EXPECT_EQ(broken.at(0).code, ErrorCode::kParse);
  EXPECT_THAT(broken[0].message, HasSubstr("line 3, column 17"));
  EXPECT_THAT(errors_of_text("{\"room\": {\"height\": NaN}}").at(0).message, HasSubstr("NaN"));
  EXPECT_THAT(errors_of_text("{\"room\": {\"height\": -Infinity}}").at(0).message, HasSubstr("Infinity"));
  EXPECT_THAT(errors_of_text("{\"room\": {\"height\": 1e999}}").at(0).message, HasSubstr("1e999"));
  EXPECT_THAT(errors_of_text("{\"room\": {}").at(0).hint, HasSubstr("ends too early"));
  EXPECT_THAT(errors_of_text("").at(0).message, HasSubstr("empty"));
  EXPECT_EQ(errors_of_text(std::string("{\"a\": \"\xFF\"}")).at(0).code, ErrorCode::kParse);
}

TEST(BadScene, RepeatedKeysAndDeepNestingAreErrors) {
  const auto twice = errors_of_text("{\"room\": {\"dims\": {\"w\": 1, \"w\": 2}}}");
  EXPECT_THAT(twice.at(0).message, HasSubstr("\"w\" is given twice"));
  EXPECT_EQ(twice[0].pointer, "/room/dims/w");
  EXPECT_THAT(errors_of_text(std::string(100'000, '[')).at(0).message, HasSubstr("deep"));
}

TEST(BadScene, AllErrorsComeAtOnce) {
  json scene = paper_scene();
  scene["furniture"][0]["dims"]["w"] = -1;
  scene["furniture"][1]["categroy"] = "desk";
  scene["room"]["dims"]["w"] = "4";
  scene["constraints"][1]["type"] = "alignn";
  const auto errors = errors_of(scene);
  EXPECT_THAT(pointers(errors),
              UnorderedElementsAre("/furniture/0/dims/w", "/furniture/1/categroy", "/room/dims/w", "/constraints/1/type"));
  for (const Error& error : errors) {
    EXPECT_EQ(error.code, ErrorCode::kSchema) << error.message;
    EXPECT_THAT(error.hint, testing::Not(IsEmpty())) << error.message;
    if (error.pointer == "/furniture/1/categroy") {
      EXPECT_THAT(error.hint, HasSubstr("\"category\""));
    }
    if (error.pointer == "/constraints/1/type") {
      EXPECT_THAT(error.hint, HasSubstr("\"align\""));
    }
    if (error.pointer == "/room/dims/w") {
      EXPECT_THAT(error.message, HasSubstr("a number"));
    }
  }
}

struct BadCase {
  const char* patch;  // merged into the paper's scene (RFC 7396, but null stays null by absence)
  const char* pointer;
  ErrorCode code;
  const char* says;
};

class BadScenes : public testing::TestWithParam<BadCase> {};

TEST_P(BadScenes, AreNamed) {
  json scene = paper_scene();
  scene.merge_patch(json::parse(GetParam().patch));
  const auto errors = errors_of(scene);
  ASSERT_EQ(errors.size(), 1u) << testing::PrintToString(pointers(errors));
  EXPECT_EQ(errors[0].pointer, GetParam().pointer);
  EXPECT_EQ(errors[0].code, GetParam().code) << errors[0].message;
  EXPECT_THAT(errors[0].message + " / " + errors[0].hint, HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    Cases, BadScenes,
    testing::Values(
        BadCase{R"({"room": {"dims": {"w": 0}}})", "/room/dims/w", ErrorCode::kSchema, "above 0"},
        BadCase{R"({"room": {"dims": {"w": 10000}}})", "/room/dims/w", ErrorCode::kSchema, "units"},
        BadCase{R"({"room": {"dims": 7}})", "/room/dims", ErrorCode::kSchema, "an object"},
        BadCase{R"({"room": 7})", "/room", ErrorCode::kSchema, "an object"},
        BadCase{R"({"furniture": {"bed": 1}})", "/furniture", ErrorCode::kSchema, "a list"},
        BadCase{R"({"furnitures": []})", "/furnitures", ErrorCode::kSchema, "did you mean \"furniture\""},
        BadCase{R"({"metadata": {"units": "furlong"}})", "/metadata/units", ErrorCode::kSchema, "cm"},
        BadCase{R"({"constraints": [{"type": "near", "targets": ["bed"], "relativeTo": "dsk"}]})", "/constraints/0/relativeTo",
                ErrorCode::kReference, "did you mean \"desk\""},
        BadCase{R"({"constraints": [{"type": "onCeiling", "targets": ["nobody"]}]})", "/constraints/0/targets/0", ErrorCode::kReference,
                "nobody"},
        BadCase{R"({"constraints": [{"type": "near", "targets": ["bed"]}]})", "/constraints/0", ErrorCode::kSchema, "relativeTo"},
        BadCase{R"({"constraints": [{"type": "near", "targets": ["bed"], "relativeTo": "bed"}]})", "/constraints/0/relativeTo",
                ErrorCode::kReference, "itself"},
        BadCase{R"({"constraints": [{"type": "near", "targets": [], "relativeTo": "bed"}]})", "/constraints/0/targets", ErrorCode::kSchema,
                "at least 1"},
        BadCase{R"({"furniture": [{"id": "a", "category": "bed"}, {"id": "a", "category": "bed"}], "constraints": []})", "/furniture/1",
                ErrorCode::kReference, "twice"},
        BadCase{R"({"furniture": [{"id": "a", "category": "bed", "dims": {"w": 51}}], "constraints": []})", "/furniture/0/dims/w",
                ErrorCode::kSchema, "at most 50"},
        BadCase{R"({"furniture": [{"id": "a"}], "constraints": []})", "/furniture/0", ErrorCode::kSchema, "category"},
        BadCase{R"({"furniture": [{"id": "a", "category": "bed", "fixed": true}], "constraints": []})", "/furniture/0/xform",
                ErrorCode::kSchema, "no place"},
        BadCase{R"({"furniture": [{"id": "a", "category": "bed", "xform": {"scale": [1, -1, 1]}}], "constraints": []})",
                "/furniture/0/xform/scale/1", ErrorCode::kSchema, "above 0"},
        BadCase{R"({"room": {"openings": [{"id": "d", "wallId": "wall1", "offset": 3.5, "w": 0.9}]}})", "/room/openings/0",
                ErrorCode::kGeometry, "4 m long"},
        BadCase{R"({"room": {"openings": [{"id": "d", "wallId": "wall7"}]}})", "/room/openings/0", ErrorCode::kReference, "wall7"},
        BadCase{R"({"room": {"openings": [{"id": "bed"}]}})", "/room/openings/0", ErrorCode::kReference, "twice"},
        BadCase{R"({"room": {"polygon": [[0, 0], [4, 3], [4, 0], [0, 3]], "walls": [], "openings": []}, "constraints": []})",
                "/room/polygon", ErrorCode::kGeometry, "crosses"},
        BadCase{R"({"materials": [{"id": "a", "color": [1, 1]}]})", "/materials/0/color", ErrorCode::kSchema, "3 items"},
        BadCase{R"({"materials": [{"id": "a", "color": [-1, 0, 0]}]})", "/materials/0/color/0", ErrorCode::kSchema, "at least 0"},
        BadCase{R"({"constraints": [{"type": "edgeAlign", "targets": ["bed"], "relativeTo": "desk", "edge": "nonsense"}]})",
                "/constraints/0/edge", ErrorCode::kSchema, "give one of: center, left, right, front, back, bottom, top, min, max"},
        BadCase{R"({"constraints": [{"type": "edgeAlign", "targets": ["bed"], "relativeTo": "desk", "edge": "max"}]})",
                "/constraints/0/edge", ErrorCode::kSchema, "give one of: front, back, left, right, center"},
        BadCase{R"({"constraints": [{"type": "inRegion", "targets": ["bed"], "region": "leftish"}]})", "/constraints/0/region",
                ErrorCode::kSchema, "front left"},
        BadCase{R"({"constraints": [{"type": "inRegion", "targets": ["bed"], "region": "left right"}]})", "/constraints/0/region",
                ErrorCode::kSchema, "\"left right\""},
        BadCase{R"({"constraints": [{"type": "on", "targets": ["bed"], "relativeTo": "floor", "part": "xyz"}]})", "/constraints/0/part",
                ErrorCode::kSchema, "give some of: back, front, left, right, center, corner, edge, end, top"},
        BadCase{R"({"format": "layoutbox/scene@2"})", "/format", ErrorCode::kSchema, "layoutbox/scene@1"}));

TEST(BadScene, AWallThatDoesNotMeetIsNamedWithItsGap) {
  json scene = paper_scene();
  scene["room"]["walls"][1]["end"] = {4, 3.0, 0};
  const auto errors = errors_of(scene);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, ErrorCode::kGeometry);
  EXPECT_EQ(errors[0].pointer, "/room/walls/1");
  EXPECT_THAT(errors[0].message, HasSubstr("0.2 m"));
}

TEST(BadScene, TooManyObjectsAreRefused) {
  json scene = paper_scene();
  scene["constraints"] = json::array();
  scene["furniture"] = json::array();
  for (int i = 0; i < 2001; ++i) scene["furniture"].push_back({{"id", "a" + std::to_string(i)}, {"category", "bed"}});
  const auto errors = errors_of(scene);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, ErrorCode::kTooLarge);
  scene["furniture"].erase(2000);
  EXPECT_TRUE(read_scene(scene.dump()));
}

}  // namespace
}  // namespace layoutbox
