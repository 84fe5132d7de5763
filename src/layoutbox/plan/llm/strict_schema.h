// The forms of schema/scene.schema.json that a language model is given, derived from it: lists and texts bounded, references resolved,
// nothing added, without the members that no model is asked for (x-model).
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace layoutbox::llm {

struct SchemaWanted {
  // False: every member is required, and null allowed where it may be missing: what servers force by `strict`.
  // True: fewer members, and what may be missing may be left out: for models that hold little.
  bool brief = false;
  bool articles = false;    // the user's catalogue has articles, whose numbers are asked for
  std::size_t objects = 0;  // how many the text names; 0: not known
  // Of a brief one: does the text speak of doors or windows, of sizes of things? What it does not speak of, small models make up.
  bool openings = true, sizes = true;
  std::set<std::string> categories;  // the only ones of a brief one; empty: any
};

std::string scene_schema(const SchemaWanted& wanted);

// How many tokens an answer by this schema may need: for about twice what the text names, so that a weak model that repeats itself comes to
// an end.
int answer_tokens(const SchemaWanted& wanted);

// Of a list of changes (RFC 6902) to a scene.
const std::string& patch_schema();

}  // namespace layoutbox::llm
