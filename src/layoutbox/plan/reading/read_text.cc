// The reader: units, then for each sentence the likeliest reading of all its units together, then mentions, items and links.
#include "layoutbox/plan/reading/close_readings.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/scribe.h"

namespace layoutbox::offline {

std::string words_between(const Document& document, std::size_t first, std::size_t last) {
  if (first >= last || last > document.tokens.size()) return {};
  const std::size_t begin = document.tokens[first].begin, end = document.tokens[last - 1].end;
  return document.prompt.substr(begin, end - begin);
}

void read_document(const Lexicon& lexicon, Document& document) {
  std::vector<Sentence> sentences = read_units(lexicon, document);
  Scribe scribe(lexicon, document);
  for (Sentence& sentence : sentences) {
    if (is_set(document.stop)) break;
    SentenceTree tree(document, sentence);
    if (pass_verbs(document, tree, sentence)) tree = SentenceTree(document, sentence);
    const SentenceReading reading = Decoder(lexicon, document, sentence, tree, scribe.so_far()).run();
    scribe.write(sentence, reading);
    note_close_reading(document, sentence, reading);
  }
}

}  // namespace layoutbox::offline
