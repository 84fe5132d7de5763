#include "layoutbox/plan/syntax/syntax.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>

#include "layoutbox/plan/words/tokens.h"

namespace layoutbox::syntax {
namespace {

// A phrase, and what must be found in it, divided by spaces: "lights/VBZ" (a tag), "on>lamp" (a head; >. none), "nsubj:lamp>stands" (label
// too), words being found from the left; "a2" is the second "a".
struct SyntaxCase {
  const char* text;
  const char* found;
};

void PrintTo(const SyntaxCase& example, std::ostream* out) { *out << example.text; }

struct Parsed {
  std::vector<std::string> words;
  std::vector<TreeNode> nodes;

  int place(std::string word) const {
    int skip = 0;
    if (word.size() > 1 && word.back() >= '2' && word.back() <= '9' && (word[0] < '0' || word[0] > '9')) {
      skip = word.back() - '1';
      word.pop_back();
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == word && skip-- == 0) return static_cast<int>(i);
    }
    ADD_FAILURE() << "no word " << word;
    return 0;
  }
};

Parsed parse_text(std::string_view text) {
  Parsed parsed;
  for (const auto& token : offline::tokenize(text)) parsed.words.push_back(token.text);
  const std::vector<std::string_view> views(parsed.words.begin(), parsed.words.end());
  parsed.nodes = parse(views);
  return parsed;
}

std::string written(const Parsed& parsed) {
  std::string all;
  for (std::size_t i = 0; i < parsed.words.size(); ++i) {
    const TreeNode& node = parsed.nodes[i];
    all += parsed.words[i] + "/" + std::string(name(node.tag)) + ":" + std::string(name(node.arc)) + ">" +
           (node.head < 0 ? "." : parsed.words[static_cast<std::size_t>(node.head)]) + " ";
  }
  return all;
}

bool holds(const Parsed& parsed, const std::string& claim) {
  if (const std::size_t slash = claim.find('/'); slash != std::string::npos) {
    return name(parsed.nodes[static_cast<std::size_t>(parsed.place(claim.substr(0, slash)))].tag) == claim.substr(slash + 1);
  }
  const std::size_t colon = claim.find(':'), arrow = claim.find('>');
  const std::size_t begin = colon == std::string::npos ? 0 : colon + 1;
  const TreeNode& node = parsed.nodes[static_cast<std::size_t>(parsed.place(claim.substr(begin, arrow - begin)))];
  const std::string head = claim.substr(arrow + 1);
  return node.head == (head == "." ? -1 : parsed.place(head)) && (colon == std::string::npos || name(node.arc) == claim.substr(0, colon));
}

std::vector<std::string> split_claims(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

class SyntaxTable : public testing::TestWithParam<SyntaxCase> {};

TEST_P(SyntaxTable, TagsAndHeads) {
  const Parsed parsed = parse_text(GetParam().text);
  for (const std::string& claim : split_claims(GetParam().found)) EXPECT_TRUE(holds(parsed, claim)) << claim;
  if (HasFailure()) std::cout << written(parsed) << '\n';
}

INSTANTIATE_TEST_SUITE_P(
    Phrases, SyntaxTable,
    testing::Values(
        SyntaxCase{"The lamp lights the desk.", "lights/VBZ nsubj:lamp>lights dobj:desk>lights"},
        SyntaxCase{"A light hangs above the table.", "light/NN hangs/VBZ nsubj:light>hangs above>hangs pobj:table>above"},
        SyntaxCase{"Plants line the wall.", "plants/NNS line/VBP dobj:wall>line"},
        SyntaxCase{"A desk faces the window.", "desk/NN faces/VBZ nsubj:desk>faces dobj:window>faces"},
        SyntaxCase{"A bookshelf holding books stands behind the sofa.",
                   "acl:holding>bookshelf dobj:books>holding nsubj:bookshelf>stands behind>stands"},
        SyntaxCase{"A bookshelf filled with books occupies the far wall.",
                   "acl:filled>bookshelf nsubj:bookshelf>occupies dobj:wall>occupies amod:far>wall"},
        SyntaxCase{"There is a lamp on the desk.", "attr:lamp>is expl:there>is pobj:desk>on"},
        SyntaxCase{"On the table a bowl sits next to a jar, and a mug rests beside a tray.",
                   "on>sits nsubj:bowl>sits next>sits to>next pobj:jar>to nsubj:mug>rests conj:rests>sits beside>rests pobj:tray>beside"},
        SyntaxCase{"Place the bed against the left wall and the wardrobe against the right wall.",
                   "place/VB dobj:bed>place against>place conj:wardrobe>place against2>wardrobe wall2>against2"},
        SyntaxCase{"A bedroom with a bed, a desk and a chair.", "bedroom>. pobj:bed>with conj:desk>bed conj:chair>desk"},
        SyntaxCase{"A bed is flanked by two nightstands.",
                   "nsubjpass:bed>flanked agent:by>flanked pobj:nightstands>by nummod:two>nightstands"},
        SyntaxCase{"A table surrounded by four chairs stands in the center of the room.",
                   "acl:surrounded>table pobj:chairs>by nsubj:table>stands in>stands of>center pobj:room>of"},
        SyntaxCase{"To the left of the bed is a nightstand.", "to>is pobj:left>to of>left pobj:bed>of"},
        SyntaxCase{"A mirror hangs on the wall above the dresser.", "nsubj:mirror>hangs on>hangs pobj:wall>on pobj:dresser>above"},
        SyntaxCase{"A table that seats six stands in the corner.",
                   "seats/VBZ relcl:seats>table dobj:six>seats stands/VBZ nsubj:table>stands in>stands"},
        SyntaxCase{"The sofa faces a TV mounted on the wall.", "nsubj:sofa>faces dobj:tv>faces acl:mounted>tv on>mounted"},
        SyntaxCase{"I want a desk next to the window.", "nsubj:i>want dobj:desk>want to>next pobj:window>to"}));

// What people write and nothing was learned from: most of it must be right, and what is not is listed.
TEST(Syntax, Claims) {
  std::ifstream file(LAYOUTBOX_SOURCE_FOLDER "/src/layoutbox/plan/syntax/syntax_claims.txt");
  ASSERT_TRUE(file);
  int right = 0, all = 0;
  std::string line;
  while (std::getline(file, line)) {
    const std::size_t bar = line.find(" | ");
    if (line.starts_with('#') || bar == std::string::npos) continue;
    const Parsed parsed = parse_text(line.substr(0, bar));
    std::string wrong;
    for (const std::string& claim : split_claims(line.substr(bar + 3))) {
      ++all;
      holds(parsed, claim) ? void(++right) : void(wrong += " " + claim);
    }
    if (!wrong.empty()) std::cout << wrong << " in " << written(parsed) << '\n';
  }
  std::cout << right << " of " << all << " claims hold\n";
  EXPECT_GT(right, all * 93 / 100);
}

TEST(Syntax, NothingAndLittle) {
  EXPECT_TRUE(parse({}).empty());
  const std::vector<std::string_view> word = {"bed"};
  const auto nodes = parse(word);
  ASSERT_EQ(nodes.size(), 1U);
  EXPECT_EQ(nodes[0].head, -1);
  EXPECT_EQ(nodes[0].arc, Arc::kRoot);
}

// Heads are words of the sentence, and following them ends.
void expect_forest(const std::vector<TreeNode>& nodes) {
  std::vector<std::size_t> seen(nodes.size(), 0);  // by which walk
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ASSERT_GE(nodes[i].head, -1);
    ASSERT_LT(nodes[i].head, static_cast<int>(nodes.size()));
    std::size_t at = i;
    while (seen[at] == 0) {
      seen[at] = i + 1;
      if (nodes[at].head < 0) break;
      at = static_cast<std::size_t>(nodes[at].head);
      ASSERT_NE(seen[at], i + 1) << "a circle";
    }
  }
}

TEST(Syntax, AnyBytes) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::string> words(random() % 40);
    for (std::string& word : words) {
      word.resize(random() % 12);
      for (char& c : word) c = static_cast<char>(random() % 256);
    }
    const std::vector<std::string_view> views(words.begin(), words.end());
    const auto nodes = parse(views);
    ASSERT_EQ(nodes.size(), words.size());
    expect_forest(nodes);
  }
}

TEST(Syntax, LongTextTakesLinearTime) {
  for (const auto& pattern : {std::vector<std::string_view>{"bed"}, {"a", "lamp", "on"}, {"that", "holds"}, {",", "and"}, {"("}}) {
    std::vector<std::string_view> words;
    const std::size_t size = pattern.size() == 3 ? 100000 : 20000;
    while (words.size() < size) words.insert(words.end(), pattern.begin(), pattern.end());
    const auto begin = std::chrono::steady_clock::now();
    expect_forest(parse(words));
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 10) << pattern[0];
  }
}

TEST(Syntax, SameTreeWhateverTheCase) {
  const std::vector<std::string_view> small = {"a", "lamp", "stands", "on", "the", "desk"},
                                      large = {"A", "LAMP", "Stands", "ON", "the", "Desk"};
  const auto first = parse(small), second = parse(large);
  for (std::size_t i = 0; i < small.size(); ++i) {
    EXPECT_EQ(first[i].head, second[i].head);
    EXPECT_EQ(first[i].tag, second[i].tag);
  }
}

}  // namespace
}  // namespace layoutbox::syntax
