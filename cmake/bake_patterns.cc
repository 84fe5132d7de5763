// Run when the program is built: bake_patterns FOLDER. Draws the patterns of the glTF textures, a file each; without FOLDER it lists them.
#include <cstdio>

#include "layoutbox/base/files.h"
#include "layoutbox/export/pattern_draw.h"

int main(int count, char** arguments) {
  for (const std::string& name : layoutbox::pattern_names()) {
    if (count < 2) {
      std::puts(name.c_str());
    } else if (!layoutbox::write_file(std::string(arguments[1]) + "/" + name, layoutbox::draw_pattern(name))) {
      std::fprintf(stderr, "cannot write %s/%s\n", arguments[1], name.c_str());
      return 1;
    }
  }
  return 0;
}
