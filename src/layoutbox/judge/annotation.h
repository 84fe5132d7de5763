// What a prompt asks for, as people noted it: the mini-language of SceneEval's annotation tables (docs/judge.md).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox::scoring {

enum class EntryKind { kCount, kObjects, kRoom };  // CNT, OOR, OAR
std::string_view name_of(EntryKind kind);

enum class Quantifier { kEqual, kAtLeast, kMore, kAtMost, kLess };
bool meets(Quantifier quantifier, int found, int wanted);

// One entry: "eq,2,nightstand", "eq,1,near,0,bed,fridge" or "eq,1,corner,bed,room".
struct Entry {
  std::string raw;
  EntryKind kind = EntryKind::kCount;
  Quantifier quantifier = Quantifier::kEqual;
  int count = 1;
  std::string word;                  // the relation's
  std::string anchor;                // category that a relation between objects refers to
  std::vector<std::string> targets;  // categories
  std::string element;               // wall, door, window, floor, ceiling, room or a room's name
};

struct Annotation {
  std::string id, prompt;
  std::vector<Entry> entries;
  std::vector<std::string> categories() const;  // those that counts name, each once
  std::set<std::string> rooms() const;          // names of rooms that relations speak of
};

// Errors: kParse, with the entry.
Result<Entry> parse_entry(std::string_view raw, EntryKind kind);

// A table with the columns ID, Description, ObjCount, OORel, OARel; others are not read. Errors: kParse, kSchema (a column is missing).
Result<std::vector<Annotation>> read_annotations(std::string_view csv);

}  // namespace layoutbox::scoring
