// docs/relations.md says of every relation what the table says: its parameters, its defaults and its sentence.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "layoutbox/scene/relation_table.h"

namespace layoutbox {
namespace {

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

// Rows of the page's tables by the name of their relation: | `name` | parameters | meaning | sentence | example |
std::map<std::string, std::vector<std::string>, std::less<>> rows_of_page() {
  std::map<std::string, std::vector<std::string>, std::less<>> rows;
  std::ifstream page(std::string(LAYOUTBOX_SOURCE_FOLDER) + "/docs/relations.md");
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `")) continue;
    std::vector<std::string> cells;
    for (std::size_t at = 1; at < line.size();) {
      const std::size_t end = std::min(line.find('|', at), line.size());
      cells.push_back(trimmed(line.substr(at, end - at)));
      at = end + 1;
    }
    const std::string name = cells.front().substr(1, cells.front().size() - 2);
    EXPECT_FALSE(rows.contains(name)) << name << " has two rows";
    rows[name] = cells;
  }
  return rows;
}

TEST(RelationsPage, HasEveryRelationWithItsParametersAndSentence) {
  const auto rows = rows_of_page();
  EXPECT_EQ(rows.size(), relation_table().size());
  for (const RelationRow& row : relation_table()) {
    const auto found = rows.find(row.name);
    ASSERT_NE(found, rows.end()) << row.name << " has no row in docs/relations.md";
    ASSERT_EQ(found->second.size(), 5u) << row.name;
    EXPECT_EQ(found->second[1], row.parameters) << row.name;
    EXPECT_FALSE(found->second[2].empty()) << row.name;
    EXPECT_EQ(found->second[3], row.sentence) << row.name;
    EXPECT_FALSE(found->second[4].empty()) << row.name;
  }
}

}  // namespace
}  // namespace layoutbox
