// Where another reading was nearly as likely: in words, for people.
#include "layoutbox/plan/reading/close_readings.h"

#include <algorithm>

namespace layoutbox::offline {
namespace {

class Describer {
 public:
  Describer(const Document& document, const Sentence& sentence) : document_(document), sentence_(sentence) {}

  // What the unit says in that reading, as a sentence goes on that begins with its words; empty where it says nothing.
  std::string what(const std::vector<UnitReading>& units, int u) const {
    const UnitReading& own = units[index(u)];
    switch (unit(u).kind) {
      case UnitKind::kPlace:
      case UnitKind::kHave: return place(units, u, own);
      case UnitKind::kNoun: return noun(units, u, own);
      default: return {};
    }
  }

  // The unit's words, those of the noun that goes with a place included.
  std::pair<std::size_t, std::size_t> bytes(const std::vector<UnitReading>& units, int u) const {
    std::size_t last = chunk(u).last;
    const bool of_place = unit(u).kind != UnitKind::kNoun && u + 1 < static_cast<int>(sentence_.size());
    if (of_place && unit(u + 1).kind == UnitKind::kNoun && units[index(u + 1)].predicate == u) last = chunk(u + 1).last;
    return {document_.tokens[chunk(u).first].begin, document_.tokens[last - 1].end};
  }

 private:
  static std::size_t index(int u) { return static_cast<std::size_t>(u); }
  const Unit& unit(int u) const { return sentence_[index(u)]; }
  const Chunk& chunk(int u) const { return document_.chunks[unit(u).chunk]; }
  static std::string quoted(const std::string& words) { return "“" + words + "”"; }

  std::string name(Referent referent) const {
    if (is_mention(referent)) {
      const NounPhrase& noun = document_.mentions[index(mention_of(referent))].noun;
      return quoted(noun.last > noun.first ? words_between(document_, noun.first, noun.last) : noun.name);
    }
    return quoted(words_between(document_, chunk(referent).first, chunk(referent).last));
  }
  // The list that ends with `last`, from `first`.
  std::string names(const std::vector<UnitReading>& units, Referent last, int first) const {
    std::string all = name(last);
    for (int u = last; u >= 0 && u != first && first >= 0;) {
      u = units[index(u)].former;
      if (u >= 0) all = name(u) + " and " + all;
    }
    return all;
  }
  std::string place(const std::vector<UnitReading>& units, int /*u*/, const UnitReading& own) const {
    if (own.of_room) return "is said of the room";
    if (own.subject == kNobody) return {};
    std::string text = "is said of " + names(units, own.subject, own.first_subject);
    if (own.alone && own.implied != kNobody) text += ", by " + name(own.implied);
    return text;
  }
  std::string noun(const std::vector<UnitReading>& units, int u, const UnitReading& own) const {
    if (own.meant != kNobody && chunk(u).noun.kind != NounKind::kObject)
      return "means " + name(own.meant) + (own.whole_list ? " with what is listed with it" : "");
    const Referent of = own.predicate >= 0 ? units[index(own.predicate)].subject : kNobody;
    switch (own.role) {
      case NounRole::kRoot: return "stands for itself";
      case NounRole::kContent: return of == kNobody ? std::string() : "belongs to " + name(of);
      case NounRole::kReference: return own.predicate < 0 ? std::string() : "is what " + name(own.predicate) + " speaks of";
      default: return {};
    }
  }

  const Document& document_;
  const Sentence& sentence_;
};

}  // namespace

void note_close_reading(Document& document, const Sentence& sentence, const SentenceReading& reading) {
  const Describer describer(document, sentence);
  for (const std::vector<UnitReading>& other : reading.close) {
    for (int u = 0; u < static_cast<int>(sentence.size()); ++u) {
      std::string taken = describer.what(reading.units, u), instead = describer.what(other, u);
      if (taken.empty() || instead.empty() || taken == instead) continue;
      const auto [begin, end] = describer.bytes(reading.units, u);
      document.close.push_back({begin, end, std::move(taken), std::move(instead)});
      return;
    }
  }
}

}  // namespace layoutbox::offline
