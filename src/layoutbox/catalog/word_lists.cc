#include "layoutbox/catalog/word_lists.h"

#include "layoutbox/embedded/word_pack.h"

namespace layoutbox {

WordList word_list(std::string_view file) { return WordList(embedded::word_pack.data()).at(file); }

}  // namespace layoutbox
