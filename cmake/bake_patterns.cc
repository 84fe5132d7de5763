// Run when the program is built: bake_patterns FOLDER NAME… draws the patterns of the glTF textures, a file each. The names are those that
// the build expects: it fails where they are not the rows of the table.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "layoutbox/base/files.h"
#include "layoutbox/export/pattern_draw.h"

int main(int count, char** arguments) {
  if (count < 2) return 2;
  const std::string folder = arguments[1];
  std::vector<std::string> expected(arguments + 2, arguments + count), names = layoutbox::pattern_names();
  std::sort(expected.begin(), expected.end());
  std::sort(names.begin(), names.end());
  if (expected != names) {
    std::fputs("pattern_names in src/layoutbox/CMakeLists.txt are not the rows of the table in export/pattern_draw.cc, which are:\n",
               stderr);
    for (const std::string& name : names) std::fprintf(stderr, "  %s\n", name.c_str());
    return 1;
  }
  for (const std::string& name : names) {
    if (layoutbox::write_file(folder + "/" + name, layoutbox::draw_pattern(name))) continue;
    std::fprintf(stderr, "cannot write %s/%s\n", folder.c_str(), name.c_str());
    return 1;
  }
  return 0;
}
