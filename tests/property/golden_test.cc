// The examples' layouts, byte for byte: examples/scenes/*.json solved with the default options, each known by a digest of its layout.json.
// A change of the solver that changes them is meant to be looked at. To renew, look at the pictures
//
//     for f in examples/scenes/*.json; do ./layoutbox solve $f -o out/golden/$(basename $f); done
//     $f)…; done
//
// and then write the new digests: LAYOUTBOX_RENEW_GOLDEN=1 build/release/tests/property/property_test --gtest_filter='Golden*'
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

#include "layoutbox/base/files.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = fs::path(LAYOUTBOX_SOURCE_FOLDER) / "examples/scenes";
const fs::path kDigests = fs::path(LAYOUTBOX_SOURCE_FOLDER) / "tests/property/golden_layouts.txt";

// FNV-1a, 64 bits.
std::string digest(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  std::ostringstream out;
  out << std::hex << hash;
  return out.str();
}

std::map<std::string, std::string> known_digests() {
  std::map<std::string, std::string> known;
  std::ifstream file(kDigests);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    known[line.substr(0, line.find(' '))] = line.substr(line.find(' ') + 1);
  }
  return known;
}

// What is read before it is written would differ: freed memory is filled with another byte for each. (A cost once spoke of a thing left
// out.)
TEST(Golden, MemoryThatWasUsedBeforeChangesNothing) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  const auto text = read_file((kScenes / "too-much.json").string());
  ASSERT_TRUE(text) << text.error().message;
  const auto scene = normalize_scene(*read_scene(*text), Catalog::builtin());
  ASSERT_TRUE(scene) << scene.error().message;
  SolveOptions options;
  options.time_limit_s = 600, options.effort = 30;
  std::string first;
  for (const int fill : {0x00, 0x01, 0x55, 0xaa, 0xff}) {
    mallopt(M_PERTURB, fill);
    auto layout = solve(*scene, Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    layout->stats.seconds = 0;
    if (first.empty()) first = write_layout(*layout);
    EXPECT_EQ(write_layout(*layout), first) << "memory filled with " << fill;
  }
  mallopt(M_PERTURB, 0);
}

TEST(Golden, TheExamplesLayoutsAreWhatTheyWere) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  const std::map<std::string, std::string> known = known_digests();
  std::map<std::string, std::string> now;
  for (const auto& entry : fs::directory_iterator(kScenes)) {
    const std::string name = entry.path().stem().string();
    const auto text = read_file(entry.path().string());
    ASSERT_TRUE(text) << text.error().message;
    const auto scene = read_scene(*text);
    ASSERT_TRUE(scene) << scene.error().message;
    const auto normal = normalize_scene(*scene, Catalog::builtin());
    ASSERT_TRUE(normal) << normal.error().message;
    SolveOptions options;
    options.time_limit_s = 600;  // nothing is left to the clock
    auto layout = solve(*normal, Catalog::builtin(), options);
    ASSERT_TRUE(layout) << name << ": " << layout.error().message;
    for (const Check& check : verify(*layout, Catalog::builtin()).checks) {
      EXPECT_TRUE(check.passed || !check.required) << name << ": " << check.subject << ": " << check.message;
    }
    layout->stats.seconds = 0;
    std::ostringstream line;
    line << digest(write_layout(*layout)) << " " << name_of(layout->status) << " score " << std::fixed << std::setprecision(3)
         << layout->score;
    now[name] = line.str();
    if (std::getenv("LAYOUTBOX_RENEW_GOLDEN") != nullptr) continue;
    ASSERT_TRUE(known.contains(name)) << name << " has no digest yet";
    EXPECT_EQ(now[name], known.at(name)) << name << " is laid out in another way than before: look at it, then renew the digest";
  }
  EXPECT_GE(now.size(), 7u);
  if (std::getenv("LAYOUTBOX_RENEW_GOLDEN") == nullptr) return;
  std::ofstream file(kDigests);
  file << "# Digest, status and score of each example's layout; renewed as golden_test.cc says.\n";
  for (const auto& [name, line] : now) file << name << " " << line << "\n";
}

}  // namespace
}  // namespace layoutbox
