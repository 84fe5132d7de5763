#include "layoutbox/furnish/decor_data.h"

#include <nlohmann/json.hpp>

#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox {

const nlohmann::json& decor_data() {
  static const nlohmann::json all = nlohmann::json::parse(embedded::decor_json);
  return all;
}

bool lists(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const bool begins = at == 0 || words[at - 1] == ' ', ends = at + word.size() == words.size() || words[at + word.size()] == ' ';
    if (begins && ends) return true;
  }
  return false;
}

}  // namespace layoutbox
