// The table of sentences_test.txt: what each sentence means, objects and relations; and changes of wording that leave the meaning alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

const Planner& planner() {
  static const std::unique_ptr<Planner> planner = make_offline_planner(Catalog::builtin());
  return *planner;
}

SceneGraph read(const std::string& text) {
  auto plan = planner().plan(text, {});
  EXPECT_TRUE(plan.has_value()) << text;
  return plan ? std::move(plan->scene) : SceneGraph{};
}

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    if (part = trimmed(part); !part.empty()) parts.push_back(part);
  }
  return parts;
}

// "2 nightstand" → 2, nightstand; no number: 0.
std::pair<int, std::string> counted(const std::string& text) {
  std::size_t end = 0;
  while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
  if (end == 0) return {0, text};
  return {std::stoi(text.substr(0, end)), trimmed(text.substr(end))};
}

// By name, by the end of the name ("bed": "twin bed"), or by category.
bool is_called(const SceneObject& object, const std::string& name) {
  std::string category = object.category;
  std::replace(category.begin(), category.end(), '_', ' ');
  const auto ends = [&](const std::string& text) {
    return text == name || (text.size() > name.size() && text.ends_with(name) && (text[text.size() - name.size() - 1] == ' '));
  };
  return ends(object.name) || ends(category);
}

bool names(const SceneGraph& scene, const std::vector<std::string>& ids, const std::string& wanted) {
  return std::any_of(ids.begin(), ids.end(), [&](const std::string& id) {
    if (id == wanted || (wanted == "window" && id.starts_with("window")) || (wanted == "door" && id.starts_with("door"))) return true;
    const SceneObject* object = scene.find_object(id);
    return object != nullptr && is_called(*object, wanted);
  });
}

struct Row {
  int line = 0;
  std::string text, objects, relations;
};

std::vector<Row> rows() {
  std::ifstream file(std::string(LAYOUTBOX_SOURCE_FOLDER) + "/src/layoutbox/plan/offline/sentences_test.txt");
  std::vector<Row> rows;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> parts;
    std::stringstream stream(line);
    for (std::string part; std::getline(stream, part, '|');) parts.push_back(trimmed(part));
    parts.resize(3);
    rows.push_back({number, parts[0], parts[1], parts[2]});
  }
  return rows;
}

std::string summary(const SceneGraph& scene) {
  std::string text;
  for (const SceneObject& object : scene.objects) text += object.id + " (" + object.name + ") ";
  for (const Relation& relation : scene.relations) {
    text += "\n  " + std::string(relation_row(relation.type).name);
    for (const std::string& id : relation.targets) text += " " + id;
    text += " >";
    for (const std::string& id : relation.references) text += " " + id;
  }
  return text;
}

// Every object that is wanted is there in its number, and no other.
void expect_objects(const SceneGraph& scene, const std::string& wanted) {
  if (wanted == "-") {
    EXPECT_TRUE(scene.objects.empty()) << summary(scene);
    return;
  }
  std::set<std::string> left;
  for (const SceneObject& object : scene.objects) left.insert(object.id);
  std::vector<std::pair<int, std::string>> wishes;
  for (const std::string& item : split(wanted, ',')) wishes.push_back(counted(item));
  // Longer names first: "coffee table" before "table".
  std::stable_sort(wishes.begin(), wishes.end(), [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
  for (const auto& [count, name] : wishes) {
    int found = 0;
    for (const SceneObject& object : scene.objects) {
      if (left.contains(object.id) && is_called(object, name)) ++found, left.erase(object.id);
    }
    EXPECT_EQ(found, std::max(count, 1)) << name << " in " << summary(scene);
  }
  EXPECT_TRUE(left.empty()) << "not asked for: " << *left.begin() << " in " << summary(scene);
}

void expect_relations(const SceneGraph& scene, const std::string& wanted) {
  for (std::string item : split(wanted, ';')) {
    const bool absent = item[0] == '!', concluded = item[0] == '~';
    if (absent || concluded) item = item.substr(1);
    const std::size_t space = item.find(' ');
    const std::string type = item.substr(0, space);
    const std::size_t arrow = item.find(" > ");
    const auto [count, target] = counted(trimmed(arrow == std::string::npos ? item.substr(space) : item.substr(space, arrow - space)));
    const std::string reference = arrow == std::string::npos ? "" : trimmed(item.substr(arrow + 3));
    int found = 0;
    for (const Relation& relation : scene.relations) {
      if (relation_row(relation.type).name != type || (concluded ? relation.asked() : relation.origin == Origin::kAssumed)) continue;
      if (!names(scene, relation.targets, target)) continue;
      if (!reference.empty() && !names(scene, relation.references, reference)) continue;
      ++found;
    }
    if (absent)
      EXPECT_EQ(found, 0) << item << " in " << summary(scene);
    else if (count > 0)
      EXPECT_EQ(found, count) << item << " in " << summary(scene);
    else
      EXPECT_GE(found, 1) << item << " in " << summary(scene);
  }
}

TEST(Sentences, EachMeansWhatTheTableSays) {
  const std::vector<Row> table = rows();
  ASSERT_GT(table.size(), 300u);
  for (const Row& row : table) {
    SCOPED_TRACE("line " + std::to_string(row.line) + ": " + row.text);
    const SceneGraph scene = read(row.text);
    expect_objects(scene, row.objects);
    expect_relations(scene, row.relations);
  }
}

// What a scene says, whatever the words were: categories and relations.
std::multiset<std::string> meaning(const SceneGraph& scene) {
  std::multiset<std::string> all;
  for (const SceneObject& object : scene.objects) all.insert(object.category);
  for (const Relation& relation : scene.relations) {
    std::string text(relation_row(relation.type).name);
    const auto add = [&](const std::vector<std::string>& ids) {
      std::multiset<std::string> sorted;
      for (const std::string& id : ids) {
        const SceneObject* object = scene.find_object(id);
        sorted.insert(object != nullptr ? object->category : id);
      }
      for (const std::string& word : sorted) text += " " + word;
      text += " >";
    };
    add(relation.targets);
    add(relation.references);
    all.insert(text);
  }
  return all;
}

struct SameMeaning {
  std::string one, other;
};

TEST(Sentences, OtherWordsForTheSame) {
  const std::vector<SameMeaning> pairs = {
      {"A bedroom with a couch next to the bed.", "A bedroom with a sofa next to the bed."},
      {"A bedroom with a bed and a wardrobe.", "A bedroom with a wardrobe and a bed."},
      {"A table surrounded by four chairs.", "Four chairs surround a table."},
      {"A bed flanked by two nightstands.", "A bed with two nightstands on either side."},
      {"A bed flanked by two nightstands.", "A bed with two bedside tables on either side."},
      {"A bookcase stands against the wall.", "A bookshelf is placed against the wall."},
      {"A grey rug lies in the centre of the room.", "A gray rug lies in the center of the room."},
      {"A room with 3 chairs.", "A room with three chairs."},
      {"A lamp sits on the desk.", "On the desk sits a lamp."},
      {"A lamp sits on the desk.", "A lamp is placed on the desk."},
      {"A desk holds a lamp.", "A desk with a lamp on it."},
      {"A bed against the wall and a desk in the corner.", "A desk in the corner and a bed against the wall."},
      {"A chair near the window.", "Near the window, there is a chair."},
      {"A painting hangs above the bed.", "Above the bed hangs a painting."},
      {"A shelf filled with books.", "A shelf stocked with books."},
      {"A desk against the west wall.", "A desk against the left wall."},
      {"A sofa facing the TV.", "The sofa faces the television."},
      {"Place a bed against the wall.", "A bed is against the wall."},
      {"A bed, a desk and a chair.", "a bed , a desk, and a chair"},
      {"A room with two sofas.", "A room with a pair of sofas."},
      {"Two nightstands flank the bed.", "On either side of the bed is a nightstand."},
      {"A bed flanked by two nightstands.", "A bed with two nightstands, one on each side."},
      {"A bed and a nightstand on each side of it.", "A nightstand stands on each side of a bed."},
      {"A table with six chairs around it.", "Six chairs are placed around a table."},
      {"Two sofas facing each other.", "Two sofas face one another."},
      {"A desk with a computer on it.", "A desk on which a computer stands."},
      {"A desk stands under the window.", "Under the window stands a desk."},
      {"I want a bed in the corner.", "A bed stands in the corner."},
      {"Please put a lamp on the desk.", "There is a lamp on the desk."},
      {"A wardrobe and a dresser, both against the back wall.", "A wardrobe against the back wall and a dresser against the back wall."},
      {"A bed against the north wall and a desk against the east wall.", "A bed against the back wall; a desk against the right wall."},
      {"A settee next to the telly.", "A sofa next to the TV."},
      {"A bedroom w/ a bed & a desk.", "A bedroom with a bed and a desk."},
      {"3 stools in a row.", "A row of three stools."},
      {"A sofa that faces a TV.", "A sofa facing a TV."},
      {"A TV is faced by a sofa.", "A sofa faces a TV."},
      {"A table holding two vases.", "A table on which two vases are placed."},
  };
  for (const auto& [one, other] : pairs) EXPECT_EQ(meaning(read(one)), meaning(read(other))) << one << " / " << other;
}

// A slip of the hand in a small word: letters swapped, doubled or left out.
TEST(Sentences, TypingErrorsInSmallWordsLeaveTheMeaningAlone) {
  const std::vector<std::pair<std::string, std::string>> slips = {
      {" the ", " teh "},        {" with ", " wiht "},     {" and ", " adn "},        {" against ", " agianst "},
      {" between ", " betwen "}, {" corner", " conrer"},   {" next to ", " nextto "}, {" in front of ", " infront of "},
      {" window", " windwo"},    {" beside ", " besdie "}, {" on top", " ontop"}};
  int changed = 0;
  for (const Row& row : rows()) {
    for (const auto& [right, wrong] : slips) {
      std::string slipped = row.text;
      const std::size_t at = slipped.find(right);
      if (at == std::string::npos) continue;
      slipped.replace(at, right.size(), wrong);
      ++changed;
      EXPECT_EQ(meaning(read(row.text)), meaning(read(slipped))) << slipped;
    }
  }
  EXPECT_GT(changed, 100);
}

// Politeness, an adverb or a general wish adds nothing.
TEST(Sentences, FillersLeaveEveryMeaningAlone) {
  for (const Row& row : rows()) {
    if (row.text.find(". ") != std::string::npos) continue;
    const SceneGraph plain = read(row.text),
                     wished = read(row.text + " Position furniture logically with proper spacing and accessibility.");
    EXPECT_EQ(meaning(plain), meaning(wished)) << row.text;
  }
}

// Letters and digits, but for the numbers of a list: "(2) a table".
bool is_of_word(const std::string& text, std::size_t at) {
  const bool listed = at > 0 && at + 1 < text.size() && text[at - 1] == '(' && text[at + 1] == ')';
  return !listed && std::isalnum(static_cast<unsigned char>(text[at]));
}

TEST(Sentences, EveryWordIsAccountedForOnceAndInOrder) {
  for (const Row& row : rows()) {
    const auto plan = planner().plan(row.text, {});
    ASSERT_TRUE(plan.has_value());
    std::size_t at = 0;
    for (const WordReading& reading : plan->readings) {
      EXPECT_GE(reading.begin, at) << row.text;
      EXPECT_GT(reading.end, reading.begin) << row.text;
      for (; at < reading.begin; ++at) EXPECT_FALSE(is_of_word(row.text, at)) << row.text.substr(at);
      at = reading.end;
    }
    EXPECT_LE(at, row.text.size());
    for (; at < row.text.size(); ++at) EXPECT_FALSE(is_of_word(row.text, at)) << row.text.substr(at);
  }
}

}  // namespace
}  // namespace layoutbox
