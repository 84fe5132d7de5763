#include <algorithm>

#include "layoutbox/plan/syntax/templates.h"

namespace layoutbox::syntax {
namespace {

struct Near {
  std::uint64_t key, parts, group, coarse;
};

Near near_word(const TaggedSentence& sentence, int place) {
  if (place < 0) return {kBefore, kBefore, kBefore, kBefore};
  if (place >= sentence.size()) return {kAfter, kAfter, kAfter, kAfter};
  const Word& word = sentence.words[static_cast<std::size_t>(place)];
  // A word nobody knows: what it ends in stands for its class.
  const std::uint64_t parts = word.info.bits != 0 ? word.info.parts() + 64U : word.suffix2;
  const std::uint64_t group = word.info.group() != 0 ? word.info.group() + 4096U : word.suffix3;
  const std::uint64_t coarse = word.info.group() != 0 ? word.info.coarse_group() + 8192U : word.suffix3;
  return {word.key, parts, group, coarse};
}

enum TagAtom : Atom {
#include "layoutbox/plan/syntax/tag_atoms.inc"
  kTagAtoms
};

constexpr std::array kTagTemplates = {
#include "layoutbox/plan/syntax/tag_templates.inc"
};

}  // namespace

void tag_features(const TaggedSentence& sentence, int word, Features& features) {
  std::array<std::uint64_t, kTagAtoms> atoms{};
  const Near near[6] = {near_word(sentence, word - 2), near_word(sentence, word - 1), near_word(sentence, word),
                        near_word(sentence, word + 1), near_word(sentence, word + 2), near_word(sentence, word + 3)};
  const Word& here = sentence.words[static_cast<std::size_t>(word)];
  const auto tag = [&](int place) { return place < 0 ? kBefore : sentence.tags[static_cast<std::size_t>(place)] + 16U; };
  atoms[kWm2] = near[0].key, atoms[kWm1] = near[1].key, atoms[kW0] = near[2].key, atoms[kW1] = near[3].key, atoms[kW2] = near[4].key;
  atoms[kPm2] = near[0].parts, atoms[kPm1] = near[1].parts, atoms[kP0] = near[2].parts, atoms[kP1] = near[3].parts;
  atoms[kP2] = near[4].parts, atoms[kP3] = near[5].parts;
  atoms[kGm1] = near[1].group, atoms[kG0] = near[2].group, atoms[kG1] = near[3].group, atoms[kG2] = near[4].group;
  atoms[kCm1] = near[1].coarse, atoms[kC0] = near[2].coarse, atoms[kC1] = near[3].coarse;
  atoms[kTm1] = tag(word - 1), atoms[kTm2] = tag(word - 2), atoms[kTm3] = tag(word - 3);
  atoms[kS2] = here.suffix2, atoms[kS3] = here.suffix3, atoms[kS4] = here.suffix4, atoms[kPre] = here.prefix, atoms[kShape] = here.shape;
  const bool more = word + 1 < sentence.size();
  atoms[kS3n] = more ? sentence.words[static_cast<std::size_t>(word) + 1].suffix3 : kAfter;
  atoms[kS2n] = more ? sentence.words[static_cast<std::size_t>(word) + 1].suffix2 : kAfter;
  atoms[kS3b] = word > 0 ? sentence.words[static_cast<std::size_t>(word) - 1].suffix3 : kBefore;
  atoms[kNounSense] = here.info.noun_sense(), atoms[kVerbSense] = here.info.verb_sense();
  atoms[kFirst] = word == 0 ? 1 : 0;
  std::uint64_t verb = 0, noun = 0, determiner = 0;
  for (int i = word - 1; i >= std::max(0, word - 12); --i) {
    const std::uint8_t before = sentence.tags[static_cast<std::size_t>(i)];
    if (is_finite(before)) verb = 1;
    if (is_noun(before)) noun = 1;
    if (Tag{before} == Tag::kPunct || Tag{before} == Tag::kCC || Tag{before} == Tag::kWDT) {
      verb += 2;
      break;
    }
  }
  for (int i = word + 1; i < std::min(sentence.size(), word + 3); ++i) {
    static const std::uint64_t kWords[] = {word_key("the"), word_key("a"),   word_key("an"),
                                           word_key("its"), word_key("one"), word_key("two")};
    if (determiner == 0 &&
        std::find(std::begin(kWords), std::end(kWords), sentence.words[static_cast<std::size_t>(i)].key) != std::end(kWords))
      determiner = static_cast<std::uint64_t>(i - word);
  }
  atoms[kVerbBefore] = verb, atoms[kNounBefore] = noun, atoms[kAfterNoun] = determiner;
  const auto verbs = [&](int from, int to) {
    return sentence.likely_verbs[static_cast<std::size_t>(to)] > sentence.likely_verbs[static_cast<std::size_t>(from)] ? 1U : 0U;
  };
  atoms[kVerbElsewhere] = verbs(0, word) | verbs(word + 1, sentence.size()) << 1;
  combine(atoms, kTagTemplates, 0x1234567, features);
}

}  // namespace layoutbox::syntax
