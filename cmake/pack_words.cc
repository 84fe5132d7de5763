// Run when the program is built: pack_words OUTPUT catalog/words_*.json …: packs the lists of words for word_list().
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "layoutbox/catalog/word_lists.h"

int main(int count, char** arguments) {
  std::string members;
  for (int i = 2; i < count; ++i) {
    std::ifstream file(arguments[i], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string packed = layoutbox::pack_words(text);
    if (packed.empty()) {
      std::fprintf(stderr, "%s: no JSON object\n", arguments[i]);
      return 1;
    }
    members += layoutbox::pack_member(std::filesystem::path(arguments[i]).stem().string(), packed);
  }
  if (count < 3) return 1;
  std::ofstream out(arguments[1], std::ios::binary);
  out << layoutbox::pack_object(members);
  return out.flush() ? 0 : 1;
}
