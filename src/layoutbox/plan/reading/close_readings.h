// Where another reading was nearly as likely.
#pragma once

#include "layoutbox/plan/reading/reading.h"

namespace layoutbox::offline {

// Notes in the document the first of the sentence's words that the next best reading takes in another way, if one was close.
void note_close_reading(Document& document, const Sentence& sentence, const SentenceReading& reading);

}  // namespace layoutbox::offline
