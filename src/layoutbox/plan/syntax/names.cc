#include <array>

#include "layoutbox/plan/syntax/syntax.h"

namespace layoutbox::syntax {
namespace {

constexpr std::array<std::string_view, kTags> kTagNames = {
    "CC", "CD",  "DT",  "EX", "FW",  "IN", "JJ", "JJR", "JJS", "MD",  "NN",  "NNP", "NNPS", "NNS", "PDT", "POS", "PRP", "PRP$",
    "RB", "RBR", "RBS", "RP", "SYM", "TO", "UH", "VB",  "VBD", "VBG", "VBN", "VBP", "VBZ",  "WDT", "WP",  "WP$", "WRB", "PUNCT"};
constexpr std::array<std::string_view, kArcs> kArcNames = {
    "root", "acl",     "acomp",    "advcl", "advmod",   "agent",     "amod",      "appos",  "attr", "aux",       "auxpass", "case",
    "cc",   "ccomp",   "compound", "conj",  "csubj",    "csubjpass", "dative",    "dep",    "det",  "dobj",      "expl",    "intj",
    "mark", "meta",    "neg",      "nmod",  "npadvmod", "nsubj",     "nsubjpass", "nummod", "oprd", "parataxis", "pcomp",   "pobj",
    "poss", "preconj", "predet",   "prep",  "prt",      "punct",     "quantmod",  "relcl",  "xcomp"};

}  // namespace

std::string_view name(Tag tag) { return kTagNames[static_cast<std::size_t>(tag)]; }
std::string_view name(Arc arc) { return kArcNames[static_cast<std::size_t>(arc)]; }

}  // namespace layoutbox::syntax
