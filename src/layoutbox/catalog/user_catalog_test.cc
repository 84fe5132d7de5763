#include "layoutbox/catalog/user_catalog.h"

#include <gmock/gmock.h>

#include "layoutbox/catalog/csv.h"
#include "layoutbox/catalog/normalize.h"

namespace layoutbox {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

UserCatalog read(std::string_view text, std::string_view units = {}) {
  auto catalog = read_user_catalog(text, units);
  if (!catalog) ADD_FAILURE() << catalog.error().message;
  return catalog.value_or(UserCatalog{});
}

TEST(Csv, ReadsWhatSpreadsheetsWrite) {
  const auto rows = read_csv("\xEF\xBB\xBFid;name\r\n1;\"a \"\"b\"\"; c\"\r\n\r\n 2 ;\"two\nlines\"\n3;last");
  ASSERT_TRUE(rows) << rows.error().message;
  ASSERT_EQ(rows->size(), 4u);
  EXPECT_THAT((*rows)[1].fields, ElementsAre("1", "a \"b\"; c"));
  EXPECT_THAT((*rows)[2].fields, ElementsAre("2", "two\nlines"));
  EXPECT_EQ((*rows)[2].line, 4u);
  EXPECT_THAT((*rows)[3].fields, ElementsAre("3", "last"));
  EXPECT_EQ((*rows)[3].line, 6u);
}

TEST(Csv, BrokenLinesAreAllNamed) {
  const auto rows = read_csv("a,b\n1,2,3\n4,5\n6\n\"7\"x,8\n");
  ASSERT_FALSE(rows);
  EXPECT_EQ(rows.error().code, ErrorCode::kParse);
  ASSERT_EQ(rows.error().details.size(), 3u);
  EXPECT_THAT(rows.error().details[0].message, HasSubstr("line 2: 3 fields"));
  EXPECT_THAT(rows.error().details[1].message, HasSubstr("line 4"));
  EXPECT_THAT(rows.error().details[2].message, HasSubstr("line 5"));
  EXPECT_THAT(read_csv("a,b\n1,\"2\n").error().message, HasSubstr("line 2: a quote"));
}

TEST(UserCatalog, ReadsCsvWithManyNames) {
  const UserCatalog catalog =
      read("SKU,Type,Width (cm),Length (cm),Height (cm),Colour,Stock,Rating\nB1,bed,160,200,50,blue,2,5\nD1,Desk,140,,,,,\n");
  ASSERT_EQ(catalog.articles.size(), 2u);
  EXPECT_EQ(catalog.articles[0].id, "B1");
  EXPECT_EQ(catalog.articles[0].size, (Size{1600, 2000, 500}));
  EXPECT_EQ(catalog.articles[0].stock, 2);
  EXPECT_THAT(catalog.articles[0].attributes, ElementsAre("blue"));
  EXPECT_EQ(catalog.articles[1].size, (Size{1400, 0, 0}));
  EXPECT_EQ(catalog.articles[1].stock, -1);
  EXPECT_THAT(catalog.notes, Contains(Field(&Note::message, HasSubstr("Rating"))));
}

TEST(UserCatalog, ReadsJsonInManyForms) {
  const Size size{1600, 2000, 500};
  for (const char* text : {R"([{"id": "B1", "category": "bed", "width": 1.6, "depth": 2.0, "height": 0.5}])",
                           R"({"items": [{"sku": "B1", "type": "bed", "dims": {"w": 1.6, "l": 2.0, "h": 0.5, "source": "catalog"}}]})",
                           R"({"units": "cm", "furniture": [{"catalogId": "B1", "name": "bed", "dimensions": [160, 200, 50]}]})",
                           R"([{"id": "B1", "category": "bed", "size": "160 x 200 x 50 cm", "mesh": null}])",
                           R"([{"id": "B1", "category": "bed", "width": "1600 mm", "depth": "2m", "height": "50cm"}])"}) {
    const UserCatalog catalog = read(text);
    ASSERT_EQ(catalog.articles.size(), 1u) << text;
    EXPECT_EQ(catalog.articles[0].id, "B1") << text;
    EXPECT_EQ(catalog.articles[0].size, size) << text;
  }
  EXPECT_EQ(read(R"([{"category": "bed", "width": 63, "depth": 79, "height": 20}])", "in").articles[0].size.width, 1600);
}

TEST(UserCatalog, UnitsAreGuessedOnlyWhereMetresCannotBe) {
  const UserCatalog in_cm = read("category,width,depth,height\nbed,160,200,50\ndesk,120,60,75\n");
  EXPECT_EQ(in_cm.articles[0].size.width, 1600);
  EXPECT_THAT(in_cm.notes, Contains(Field(&Note::code, "guessed")));
  EXPECT_EQ(read("category,width,depth,height\nbed,1600,2000,500\n").articles[0].size.width, 1600);
  EXPECT_EQ(read("category,width,depth,height\nbed,\"1,6\",2,0.5\n").articles[0].size.width, 1600);
}

TEST(UserCatalog, WhatIsWrongIsNamed) {
  const auto error = [](std::string_view text) {
    const auto catalog = read_user_catalog(text);
    EXPECT_FALSE(catalog) << text;
    return catalog ? Error{} : catalog.error();
  };
  EXPECT_EQ(error("").code, ErrorCode::kParse);
  EXPECT_EQ(error("[").code, ErrorCode::kParse);
  EXPECT_EQ(error("[]").code, ErrorCode::kEmpty);
  EXPECT_EQ(error("category,width\n").code, ErrorCode::kEmpty);
  EXPECT_EQ(error("[1]").pointer, "/0");
  EXPECT_EQ(error("{\"a\": 1}").code, ErrorCode::kSchema);
  EXPECT_THAT(error("width,depth\n1,2\n").hint, HasSubstr("category"));
  EXPECT_THAT(error("category,width\nbed,wide\n").message, HasSubstr("line 2: \"wide\""));
  EXPECT_THAT(error("category,width\nbed,-1\n").message, HasSubstr("-1 m"));
  EXPECT_EQ(error(R"([{"category": "bed", "width": 0}])").code, ErrorCode::kGeometry);
  EXPECT_EQ(error("id,category\nA,bed\nA,desk\n").code, ErrorCode::kReference);
  EXPECT_EQ(error("category,width\nbed,1\n,2\nbed,x\n").details.size(), 2u);
  EXPECT_THAT(error("category,width,depth,height,width (cm)\nbed,1,2,3,4\n").message, HasSubstr("\"width\" and \"width (cm)\""));
  EXPECT_EQ(read_user_catalog("category\nbed\n", "furlong").error().code, ErrorCode::kUsage);
}

TEST(UserCatalog, SizesUnlikeAllOfTheirKindAreWarnedOf) {
  const auto notes = [](std::string_view csv) {
    UserCatalog user = read(csv);
    with_articles(Catalog::builtin(), user, CatalogMerge::kAdd);
    return user.notes;
  };
  const auto warns = Contains(testing::AllOf(Field(&Note::code, "warning"), Field(&Note::message, HasSubstr("read as 2 mm wide"))));
  EXPECT_THAT(notes("id,category,width (mm),depth (mm)\nB1,bed,1.6,2000\n"), warns);
  EXPECT_THAT(notes("id,category,width (mm),depth (mm)\nB1,bed,1600,2000\n"), testing::Not(warns));
}

// "1.600" mm is no bed of two millimetres, and a note says what was read.
TEST(UserCatalog, ThousandsOfMillimetresMayBeParted) {
  const auto size = [](std::string_view csv) { return read(csv).articles.at(0).size; };
  EXPECT_EQ(size("category,width (mm),depth (mm),height (mm)\nbed,1.600,2.050,500\n"), (Size{1600, 2050, 500}));
  EXPECT_EQ(size("category,width (mm),depth,height\nbed,\"1,600\",2.000,0.500\n"), (Size{1600, 2000, 500})) << "only what is in mm";
  EXPECT_EQ(size("category,width,depth,height\nbed,1.600,2.000,0.500\n"), (Size{1600, 2000, 500})) << "metres";
  EXPECT_EQ(size("category,width (cm),depth (mm),height (mm)\nbed,160.5,2000.5,500\n").width, 1605);
  EXPECT_EQ(size(R"([{"category": "bed", "width": "1.600 mm", "depth": "2.000mm", "height": "50 cm"}])"), (Size{1600, 2000, 500}));
  const UserCatalog user = read("id,category,width (mm),depth (mm)\nB1,bed,1.600,2.050\nB2,bed,1.800,2000\n");
  EXPECT_THAT(user.notes, Contains(testing::AllOf(Field(&Note::code, "warning"), Field(&Note::pointer, "line 2"),
                                                  Field(&Note::message, HasSubstr("\"1.600\" in mm is read as 1600 mm")),
                                                  Field(&Note::message, HasSubstr("2 more lengths")))));
  EXPECT_THAT(read("id,category,width (mm)\nB1,bed,1600\n").notes, testing::Not(Contains(Field(&Note::code, "warning"))));
}

class Articles : public testing::Test {
 protected:
  static SceneObject object(std::string id, std::string category, std::string name = {}) {
    SceneObject out;
    out.id = std::move(id);
    out.category = std::move(category);
    out.name = std::move(name);
    return out;
  }

  static SceneGraph normalized(SceneGraph scene, std::string_view csv, CatalogMerge merge) {
    UserCatalog user = read(csv);
    const Catalog catalog = with_articles(Catalog::builtin(), user, merge);
    auto result = normalize_scene(std::move(scene), catalog);
    if (!result) ADD_FAILURE() << result.error().message;
    return result.value_or(SceneGraph{});
  }
};

TEST_F(Articles, GiveTheirExactSize) {
  SceneGraph scene;
  scene.objects = {object("bed_1", "bed"), object("desk_1", "desk"), object("wardrobe_1", "wardrobe")};
  scene = normalized(scene, "id,category,width,depth,height\nB1,bed,1.57,2.03,0.61\nD1,desk,1.37,,\n", CatalogMerge::kAdd);
  EXPECT_EQ(scene.objects[0].catalog_id, "B1");
  EXPECT_EQ(scene.objects[0].category, "bed");
  const Size bed{1570, 2030, 610};
  EXPECT_EQ(scene.objects[0].size, (SizeRange{bed, bed, bed}));
  EXPECT_EQ(scene.objects[1].size->least.width, 1370);
  EXPECT_EQ(scene.objects[1].size->least, scene.objects[1].size->greatest);
  EXPECT_GT(scene.objects[1].size->least.depth, 0) << "what the article lacks is inferred";
  EXPECT_EQ(scene.objects[2].catalog_id, "") << "our own sizes fill in";
}

TEST_F(Articles, AreChosenByWordsAndTakeTurns) {
  const char* csv =
      "id,category,name,color,width,depth,height,stock\nC1,chair,oak chair,,0.45,0.5,0.9,1\nC2,chair,steel chair,red,0.5,0.5,0.8,\n";
  SceneGraph scene;
  scene.objects = {object("a", "chair", "red chair"), object("b", "chair"), object("c", "chair"), object("d", "chair")};
  scene = normalized(scene, csv, CatalogMerge::kAdd);
  EXPECT_EQ(scene.objects[0].catalog_id, "C2");
  EXPECT_EQ(scene.objects[1].catalog_id, "C1");
  EXPECT_EQ(scene.objects[2].catalog_id, "C2") << "there is only one C1";
  EXPECT_EQ(scene.objects[3].catalog_id, "C2");
}

TEST_F(Articles, OutOfStockAreNotUsed) {
  SceneGraph scene;
  scene.objects = {object("a", "chair")};
  scene = normalized(scene, "id,category,width,depth,height,stock\nC1,chair,0.45,0.5,0.9,0\nC2,chair,0.5,0.5,0.8,1\n", CatalogMerge::kAdd);
  EXPECT_EQ(scene.objects[0].catalog_id, "C2");
}

TEST_F(Articles, SizesOfTheSceneAreKept) {
  SceneGraph scene;
  scene.objects = {object("bed_1", "bed")};
  const Size size{1400, 2000, 500};
  scene.objects[0].size = SizeRange{size, size, size};
  scene = normalized(scene, "id,category,width,depth,height\nB1,bed,1.57,2.03,0.61\n", CatalogMerge::kAdd);
  EXPECT_EQ(scene.objects[0].size->usual, size);
  EXPECT_EQ(scene.objects[0].catalog_id, "");
}

TEST_F(Articles, AreNamedByTheirNumber) {
  SceneGraph scene;
  scene.objects = {object("x", "the Malm 160")};
  scene = normalized(scene, "id,category,width,depth,height\nMALM-160,bed,1.6,2,0.6\nB2,bed,1.4,2,0.6\n", CatalogMerge::kAdd);
  EXPECT_EQ(scene.objects[0].catalog_id, "MALM-160");
  EXPECT_EQ(scene.objects[0].category, "bed");
}

TEST_F(Articles, AloneLeaveOutWhatTheyLack) {
  SceneGraph scene;
  scene.objects = {object("bed_1", "bed"), object("desk_1", "desk")};
  Relation relation;
  relation.id = "c1";
  relation.type = RelationType::kNextTo;
  relation.targets = {"desk_1"};
  relation.references = {"bed_1"};
  scene.relations = {relation};
  scene = normalized(scene, "category,width,depth,height\nbed,1.6,2,0.6\nsofa,2,0.9,0.8\n", CatalogMerge::kOnly);
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].category, "bed");
  EXPECT_THAT(scene.relations, IsEmpty());
  EXPECT_THAT(scene.notes, Contains(Field(&Note::message, HasSubstr("desk_1"))));
}

TEST_F(Articles, FillARoomWithAFittingSelection) {
  SceneGraph scene;
  scene.room.type = "bedroom";
  scene.room.polygon = {{0, 0}, {3000, 0}, {3000, 3000}, {0, 3000}};
  scene = normalized(scene,
                     "id,category,width,depth,height\nB1,bed,1.6,2,0.6\nB2,bed,1.4,2,0.6\nW1,wardrobe,3,0.6,2\nN1,nightstand,0.4,0.4,0.5\n",
                     CatalogMerge::kOnly);
  std::vector<std::string> numbers;
  for (const SceneObject& item : scene.objects) numbers.push_back(item.catalog_id);
  EXPECT_THAT(numbers, Contains("N1"));
  EXPECT_THAT(numbers, testing::Not(testing::AllOf(Contains("B1"), Contains("W1")))) << "they would cover too much of the floor";
  for (const SceneObject& item : scene.objects) EXPECT_FALSE(item.asked());
}

TEST_F(Articles, OfUnknownKindsAreDrawnLikeSomethingKnown) {
  SceneGraph scene;
  scene.objects = {object("x", "zorblax")};
  scene = normalized(scene, "id,category,width,depth,height\nZ1,zorblax,1,1,1\n", CatalogMerge::kOnly);
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].category, "zorblax");
  EXPECT_EQ(scene.objects[0].size->usual, (Size{1000, 1000, 1000}));
}

}  // namespace
}  // namespace layoutbox
