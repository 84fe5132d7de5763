#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "layoutbox/verify/test_room.h"

namespace layoutbox::checks {
namespace {

// What is wrong with a report against schema/report.schema.json; empty when nothing is.
std::string schema_errors(const std::string& report) {
  std::ifstream file(std::string(LAYOUTBOX_SOURCE_FOLDER) + "/schema/report.schema.json");
  const nlohmann::json schema_document = nlohmann::json::parse(file), document = nlohmann::json::parse(report);
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_document), schema);
  valijson::ValidationResults results;
  valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
  std::ostringstream text;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& part : error.context) text << part;
    text << ": " << error.description << '\n';
  }
  return text.str();
}

TEST(ReportSchema, FitsReportsOfEveryKindOfFault) {
  TestRoom room;
  room.door("door1", "wall1", 1).door("door2", "wall9", 1).window("window1", "wall3", 2);
  room.add("bed", "bed", {1.6, 2, 0.5}, {1, 1.2}).used({Side::kFront}).add("desk", "desk", {1.2, 0.6, 0.75}, {0.5, 1.2, 0.2, 30});
  for (const RelationRow& row : relation_table())
    room.relation(row.type, {"bed"}, {"desk"}).relation(row.type, {"desk"}, {"wall2"}).relation(row.type, {"desk"}, {"window1"});
  EXPECT_EQ(schema_errors(write_report(room.judge())), "");
  room.layout.room.polygon.clear();
  EXPECT_EQ(schema_errors(write_report(room.judge())), "");
  EXPECT_EQ(schema_errors(write_report(verify(Layout{}, Catalog::builtin()))), "");
}

TEST(ReportSchema, RefusesWhatIsNoReport) {
  nlohmann::json report = nlohmann::json::parse(write_report(TestRoom().judge()));
  report["metrics"]["support"] = 1.5;
  EXPECT_NE(schema_errors(report.dump()), "");
  report = nlohmann::json::parse(write_report(TestRoom().judge()));
  report["checks"][0].erase("message");
  EXPECT_NE(schema_errors(report.dump()), "");
}

}  // namespace
}  // namespace layoutbox::checks
