#include "layoutbox/catalog/catalog.h"

#include <gmock/gmock.h>

#include <array>
#include <string_view>
#include <utility>

#include "layoutbox/base/files.h"
#include "layoutbox/catalog/catalog_json.h"
#include "layoutbox/catalog/pack.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

using testing::HasSubstr;

constexpr const char* kRooms = R"({"rooms": [
  {"id": "bedroom", "name": "bedroom", "synonyms": ["master bedroom"], "size": {"w": 4.0, "d": 3.5, "h": 2.6}, "usual": [["bed", 1]]}
]})";

// Three entries in the form of schema/catalog.schema.json.
constexpr const char* kEntries = R"({"entries": [
  {"id": "desk", "name": "desk", "synonyms": ["writing desk", "work table"],
   "size": {"w": [1.0, 1.2, 1.6], "d": [0.5, 0.6, 0.8], "h": [0.72, 0.75, 0.78]},
   "variants": [{"words": ["large", "executive"], "size": {"w": [1.6, 1.8, 2.0]}}],
   "mount": "floor", "usedSides": ["front"], "backToWall": true, "topCarries": true, "clearance": {"front": 0.75},
   "spaces": [{"name": "knees", "min": ["-w/2+0.05", "-d/2", "0"], "max": ["w/2-0.05", "d/2-0.05", "h-0.07"], "carries": false}],
   "beside": [], "rooms": ["bedroom"], "shape": {"family": "desk", "numbers": {"drawers": 3}, "words": {"material": "oak"}}, "source": "measured"},
  {"id": "bookshelf", "name": "bookshelf", "synonyms": ["bookcase", "set of shelves"],
   "size": {"w": [0.6, 0.8, 1.2], "d": 0.3, "h": [1.5, 1.8, 2.2]},
   "spaces": [{"name": "shelf {i}", "repeat": 5, "min": ["-w/2+0.02", "-d/2", "h*i/5+0.02"], "max": ["w/2-0.02", "d/2-0.02", "h*(i+1)/5"]}],
   "rooms": ["bedroom"], "shape": {"family": "shelf"}},
  {"id": "bed", "name": "bed", "size": {"w": [0.9, 1.6, 1.8], "d": [1.9, 2.0, 2.2], "h": [0.4, 0.5, 1.2]}, "shape": {"family": "bed"}},
  {"id": "bunk_bed", "name": "bunk bed", "kindOf": "bed", "size": {"w": 1.0, "d": 2.0, "h": 1.7}, "shape": {"family": "bed"}}
]})";

Catalog small_catalog() { return Catalog::from_json(kEntries, kRooms).value(); }

TEST(Formula, IsLinearInTheSize) {
  const Size size{1000, 600, 750};
  const auto at = [&](std::string_view text, double index = 0) {
    const auto formula = parse_formula(text, index);
    if (!formula) ADD_FAILURE() << formula.error().message;
    return formula ? formula->at(size) : -1e9;
  };
  EXPECT_DOUBLE_EQ(at("w/2 - 0.02"), 480);
  EXPECT_DOUBLE_EQ(at("-w/2+0.05"), -450);
  EXPECT_DOUBLE_EQ(at("h*(i+1)/5", 2), 450);
  EXPECT_DOUBLE_EQ(at("2*(w - d) + -0.1"), 700);
  EXPECT_DOUBLE_EQ(at(" 0 "), 0);
  EXPECT_DOUBLE_EQ(at("-(w+d)/(1+1)"), -800);
  EXPECT_DOUBLE_EQ(at("0.45"), 450);
}

TEST(Formula, WhatIsNotLinearIsAnErrorWithItsPlace) {
  for (const char* text : {"", "w*d", "1/w", "w/0", "w/(1-1)", "(w", "w)", "w w", "x", "w+", "1e5", "w**2", "--", ")("}) {
    const auto formula = parse_formula(text);
    ASSERT_FALSE(formula) << text;
    EXPECT_EQ(formula.error().code, ErrorCode::kParse);
    EXPECT_THAT(formula.error().message, HasSubstr("at character")) << text;
  }
  EXPECT_FALSE(parse_formula(std::string(5000, '(')));
}

TEST(Catalog, ReadsEveryMember) {
  const Catalog catalog = small_catalog();
  const CatalogEntry& desk = *catalog.find("desk");
  EXPECT_EQ(desk.size, (SizeRange{{1000, 500, 720}, {1200, 600, 750}, {1600, 800, 780}}));
  ASSERT_EQ(desk.variants.size(), 1u);
  EXPECT_EQ(desk.variants[0].size, (SizeRange{{1600, 500, 720}, {1800, 600, 750}, {2000, 800, 780}})) << "what a variant leaves out stays";
  EXPECT_THAT(desk.used_sides, testing::ElementsAre(Side::kFront));
  EXPECT_TRUE(desk.back_to_wall);
  EXPECT_TRUE(desk.top_carries);
  EXPECT_TRUE(desk.has_front);
  EXPECT_EQ(desk.clearance.at(Side::kFront), 750);
  EXPECT_EQ(desk.shape.numbers.at("drawers"), 3);
  EXPECT_EQ(desk.shape.words.at("material"), "oak");
  EXPECT_EQ(catalog.find("bookshelf")->size.least.depth, 300);
  EXPECT_EQ(catalog.rooms()[0].usual_size, (Size{4000, 3500, 2600}));
}

TEST(Catalog, SpacesFollowTheSize) {
  const Catalog catalog = small_catalog();
  const std::vector<Space> shelves = spaces_at(*catalog.find("bookshelf"), {800, 300, 2000});
  ASSERT_EQ(shelves.size(), 5u);
  EXPECT_EQ(shelves[4].name, "shelf 5");
  EXPECT_EQ(shelves[4].min, (std::array<double, 3>{-380, -150, 1620}));
  EXPECT_EQ(shelves[4].max, (std::array<double, 3>{380, 130, 2000}));
  EXPECT_FALSE(spaces_at(*catalog.find("desk"), {1200, 600, 750})[0].carries);
}

TEST(Catalog, FindsByWords) {
  const Catalog catalog = small_catalog();
  const auto id = [&](std::string_view words) {
    const CatalogEntry* entry = catalog.find_by_words(words);
    return entry == nullptr ? std::string("-") : entry->id;
  };
  EXPECT_EQ(id("desk"), "desk");
  EXPECT_EQ(id("Desks"), "desk");
  EXPECT_EQ(id("Writing Desks"), "desk");
  EXPECT_EQ(id("oak bookshelf"), "bookshelf");
  EXPECT_EQ(id("book shelves"), "bookshelf");
  EXPECT_EQ(id("Book-Shelf"), "bookshelf");
  EXPECT_EQ(id("two sets of shelves"), "bookshelf");
  EXPECT_EQ(id("bunk beds"), "bunk_bed") << "the longest ending wins";
  EXPECT_EQ(id("king size bed"), "bed");
  EXPECT_EQ(id("desk lamp"), "-") << "the head noun decides";
  EXPECT_EQ(id(""), "-");
}

TEST(Catalog, FindsByAnotherWordForTheHead) {
  const auto id = [](std::string_view words) { return Catalog::builtin().find_by_words(words)->id; };
  EXPECT_EQ(id("crash trolley"), "medical_cart") << "a crash cart";
  EXPECT_EQ(id("old sleeper settee"), "sofa_bed") << "a sleeper sofa";
  EXPECT_EQ(id("linen cupboard"), id("linen cabinet"));
  EXPECT_EQ(id("three carts"), "cart");
}

// Nouns of all sorts of rooms, and what they are sized and drawn like.
TEST(Catalog, KnowsWhatPeopleCallThings) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 34> kThings = {{
      {"profiling bed", "hospital_bed"},
      {"straw mattress", "straw_mattress"},
      {"riser recliner", "recliner"},
      {"swivel seat", "office_chair"},
      {"fold-down seat", "shower_seat"},
      {"mini kitchen", "play_kitchen"},
      {"kitchenette", "kitchenette"},
      {"larder", "pantry_cabinet"},
      {"belfast sink", "kitchen_sink"},
      {"rabbit hutch", "rabbit_hutch"},
      {"pillar drill", "drill_press"},
      {"barrier posts", "barrier_post"},
      {"low plinth", "plinth"},
      {"label stand", "information_panel"},
      {"box of gloves", "tissue_box"},
      {"dialysis machine", "dialysis_machine"},
      {"walk-on scales", "platform_scale"},
      {"baby scales", "kitchen_scale"},
      {"bunch of grapes", "grapes"},
      {"wooden spoon", "spoon"},
      {"captain's console", "control_console"},
      {"concrete pier", "instrument_pier"},
      {"honey extractor", "honey_extractor"},
      {"tiered flower stand", "flower_stand"},
      {"bouncy castle", "bounce_house"},
      {"rucksack", "backpack"},
      {"lever arch file", "ring_binder"},
      {"printing press", "letterpress"},
      {"conference phone", "telephone"},
      {"sandpit", "sandbox"},
      {"fruit machine", "slot_machine"},
      {"banker's lamp", "bankers_lamp"},
      {"piglet", "pig"},
      {"bow", "archery_bow"},
  }};
  for (const auto& [called, id] : kThings) EXPECT_EQ(Catalog::builtin().entry_or_nearest(called).id, id) << called;
}

TEST(Catalog, KnowsKinds) {
  const Catalog catalog = small_catalog();
  EXPECT_TRUE(catalog.is_a("bunk_bed", "bed"));
  EXPECT_TRUE(catalog.is_a("bed", "bed"));
  EXPECT_FALSE(catalog.is_a("bed", "bunk_bed"));
  EXPECT_FALSE(catalog.is_a("spaceship", "bed"));
}

TEST(Catalog, HasSomethingForEveryCategory) {
  const Catalog catalog = small_catalog();
  EXPECT_EQ(catalog.entry_or_nearest("standing_desk").id, "desk");
  EXPECT_EQ(catalog.entry_or_nearest("daybeds").id, "bed");
  EXPECT_EQ(catalog.entry_or_nearest("spaceship").id, "object");
  EXPECT_EQ(catalog.entry_or_nearest("").id, "object");
}

TEST(Catalog, FindsRoomsInPhrases) {
  const Catalog catalog = small_catalog();
  ASSERT_NE(catalog.find_room("a cosy master bedroom in the attic"), nullptr);
  EXPECT_EQ(catalog.find_room("Bedrooms")->id, "bedroom");
  EXPECT_EQ(catalog.find_room("bed_room")->id, "bedroom");
  EXPECT_EQ(catalog.find_room("garage"), nullptr);
}

TEST(Catalog, SaysWhatIsWrongWithItsData) {
  const auto error = [](const std::string& entries) {
    const auto catalog = Catalog::from_json("{\"entries\": [" + entries + "]}", kRooms);
    return catalog ? Error{} : catalog.error();
  };
  const std::string shape = R"("shape": {"family": "box"})", size = R"("size": {"w": 1, "d": 1, "h": 1}, )";
  const std::string bed = R"({"id": "bed", "name": "bed", )" + size + shape + "}";
  EXPECT_EQ(error(bed).message, "");
  EXPECT_THAT(error(bed + "," + bed).message, HasSubstr("twice"));
  EXPECT_THAT(error(bed + R"(, {"id": "cot", "name": "cot", "synonyms": ["beds", "bed"], )" + size + shape + "}").message,
              HasSubstr("already means"));
  EXPECT_THAT(error(bed + R"(, {"id": "cot", "name": "cot", "kindOf": "sofa", )" + size + shape + "}").message, HasSubstr("no entry"));
  EXPECT_THAT(error(R"({"id": "bed", "name": "bed", "size": {"w": [2, 1, 3], "d": 1, "h": 1}, )" + shape + "}").message,
              HasSubstr("order"));
  EXPECT_THAT(error(R"({"id": "bed", "name": "bed", "spaces": [{"name": "s", "min": ["0", "0", "0"], "max": ["w", "d/2", "h"]}], )" + size +
                    shape + "}")
                  .message,
              HasSubstr("outside its box"));
  EXPECT_THAT(error(R"({"id": "bed", "name": "bed", "spaces": [{"name": "s", "min": ["0", "0", "0"], "max": ["w*h", "d", "h"]}], )" + size +
                    shape + "}")
                  .message,
              HasSubstr("w*h"));
  EXPECT_THAT(error(R"({"id": "bed", "nmae": "bed", )" + size + shape + "}").details,
              testing::Contains(testing::Field(&Error::hint, "did you mean \"name\"?")));
  EXPECT_EQ(Catalog::from_json("{", kRooms).error().code, ErrorCode::kParse);
}

TEST(Catalog, IsPackedWithoutLoss) {
  CatalogData data;
  ASSERT_TRUE(read_catalog_data(kEntries, data));
  ASSERT_TRUE(read_catalog_data(kRooms, data));
  const std::string packed = pack_catalog(data, index_of(data.entries, data.rooms));
  CatalogData again;
  CatalogIndex index;
  unpack_catalog(packed, again, index);
  EXPECT_EQ(pack_catalog(again, index), packed);
  ASSERT_EQ(again.entries.size(), data.entries.size());
  const CatalogEntry &desk = again.entries[0], &written = data.entries[0];
  EXPECT_EQ(desk.size, written.size);
  EXPECT_EQ(desk.variants.at(0).words, written.variants.at(0).words);
  EXPECT_EQ(desk.clearance, written.clearance);
  EXPECT_EQ(desk.shape.words, written.shape.words);
  EXPECT_EQ(desk.spaces.at(0).min[0].at({1000, 600, 700}), written.spaces.at(0).min[0].at({1000, 600, 700}));
  EXPECT_EQ(desk.spaces.at(0).carries, false);
  EXPECT_EQ(again.rooms.at(0).usual, data.rooms.at(0).usual);
}

// The data in catalog/ itself; the build has checked it (cmake/pack_catalog.cc).
TEST(BuiltinCatalog, IsLargeEnough) {
  EXPECT_GE(Catalog::builtin().entries().size(), 80u);
  EXPECT_GE(Catalog::builtin().rooms().size(), 8u);
}

TEST(BuiltinCatalog, PageNamesEveryTrait) {
  const auto page = read_file(LAYOUTBOX_SOURCE_FOLDER "/docs/catalog.md");
  ASSERT_TRUE(page);
  for (const TraitRow& row : trait_table()) {
    EXPECT_THAT(*page, HasSubstr("| `" + std::string(row.name) + "` | " + std::string(row.meaning) + " |"));
    const auto has = [&](const CatalogEntry& entry) { return entry.is(row.trait); };
    EXPECT_TRUE(std::ranges::any_of(Catalog::builtin().entries(), has)) << row.name << " is nothing's";
  }
}

TEST(BuiltinCatalog, FindsEveryEntryByItsWords) {
  const Catalog& catalog = Catalog::builtin();
  for (const CatalogEntry& entry : catalog.entries()) {
    EXPECT_EQ(catalog.find_by_words(entry.name), &entry) << entry.name;
    EXPECT_EQ(catalog.find_by_words(entry.id), &entry) << entry.id;
    for (const std::string& word : entry.synonyms) EXPECT_EQ(catalog.find_by_words(word), &entry) << word;
    const bool hisses = entry.name.ends_with('s') || entry.name.ends_with('x') || entry.name.ends_with("ch") || entry.name.ends_with("sh");
    const std::string plural = entry.name + (hisses ? "es" : "s");
    EXPECT_EQ(catalog.find_by_words(plural), &entry) << plural;
  }
}

}  // namespace
}  // namespace layoutbox
