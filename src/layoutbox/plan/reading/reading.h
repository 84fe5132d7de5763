// What a sentence was decided to say: for each of its units what it is for, and whom it speaks of.
#pragma once

#include <vector>

#include "layoutbox/plan/reading/units.h"

namespace layoutbox::offline {

// Who is spoken of: a unit of this sentence, a mention of the document, or nobody. Units are 0 and more, mentions −2 and less.
using Referent = int;
inline constexpr Referent kNobody = -1;
inline Referent referent_of_mention(int mention) { return -2 - mention; }
inline int mention_of(Referent referent) { return -2 - referent; }
inline bool is_mention(Referent referent) { return referent <= -2; }

enum class NounRole {
  kUnread,
  kRoot,       // a thing that the clause itself speaks of
  kReference,  // what something is placed by
  kContent,    // what something has, or what an inverse place places: "flanked by two lamps"
  kMember,     // speaks of a thing or group before it: "one", "each", "both", "it"
};

// Of each unit; for a noun the first part, for a place, having or verb the second.
struct UnitReading {
  NounRole role = NounRole::kUnread;
  int predicate = -1;         // the unit that it is a reference or a content of
  int former = -1;            // the member before it in its list
  Referent meant = kNobody;   // whom a pronoun or a member speaks of
  bool whole_list = false;    // … with all that is listed with it
  bool placed = false;        // something was said of where it is
  bool many = false;          // one on each side: several
  bool opens_clause = false;  // the first root of a clause

  Referent subject = kNobody;  // who is placed; of having and inverse places the host
  int first_subject = -1;      // the list's first member that shares it
  bool inverse = false;        // the host comes first: "flanked by"
  bool alone = false;          // the reference is not said
  bool fronted = false;        // "on the desk stands a lamp": the subject comes later
  bool of_room = false;        // of having: the room has it
  bool imperative = false;     // of a verb: a command
  bool after_verb = false;     // a verb or participle stands before the place
  Referent implied = kNobody;
  bool implied_list = false;
};

struct SentenceReading {
  std::vector<UnitReading> units;
  std::vector<int> roots;  // the things that the clauses speak of
  double score = 0;
  std::vector<std::vector<UnitReading>> close;  // other readings that were nearly as likely, the likeliest first
};

// What earlier sentences leave behind; mentions of the document.
struct TextSoFar {
  int opening = -1;                       // the door or window that the sentence before spoke of, and of no thing
  int topic = -1;                         // what the sentence before spoke of
  int fronted = -1;                       // … what it placed things by, these named later
  std::vector<int> roots;                 // … the things that it spoke of
  int first = 0;                          // … its first mention
  std::vector<int> listed;                // the last things that a sentence listed
  int again = -1;                         // … which of these it placed a thing by afterwards
  int sided = -1;                         // … what something stands left or right of
  bool left = false;                      // … left
  RoomRegion side = RoomRegion::kMiddle;  // … the side of the room that it placed something at; the middle: none
};

}  // namespace layoutbox::offline
