// Who sits at the tables that are named: seats for as many as they are for, and as many of those that are named as there are tables.
#pragma once

#include <cstddef>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// Of the first `said` mentions, which the words brought in.
void seat_tables(const Lexicon& lexicon, Document& document, std::size_t said);

}  // namespace layoutbox::offline
