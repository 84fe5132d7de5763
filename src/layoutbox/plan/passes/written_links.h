// What well-written texts join by signs and order alone: "a table laid for six: six plates …", "the former", "the latter".
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// A colon behind a piece of furniture and before what such a piece carries becomes "with"; "the former" and "the latter" become the names
// of the two things that were brought in last. REQUIRES: one reading and one mark of `skip` a token; then so it is again.
void read_written_links(const Lexicon& lexicon, Document& document, std::vector<bool>& skip);

}  // namespace layoutbox::offline
