#include "layoutbox/plan/passes/uses.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/passes/use_rows.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"

namespace layoutbox::offline {
namespace {

class UseReader : public UseRows {
 public:
  using UseRows::UseRows;

  void run() {
    constexpr int kMost = 40;  // nobody wants more: looking for what the whole text names stays cheap
    int written = 0;
    for (std::size_t i = 0; i < tokens_.size() && written < kMost; ++i) {
      if (skip_[i] || tokens_[i].kind != Token::Kind::kWord) continue;
      const std::size_t place = place_at(i);
      if (place == 0 || !is_wanted(i)) continue;
      auto use = use_at(i + place);
      if (!use) use = kept_anywhere(i, i + place);
      const std::size_t thing = end_of_thing(i, i + place);
      if (use && thing <= use->end) {
        write(i, *use);
        ++written;
      } else if (thing > 0) {
        leave_out(i, i + place + 1 + (is(i + place, {"to"}) ? keeping(i + place + 1) : 0));
        ++written;
      }
    }
  }

 private:
  // "a place for my record player": the record player, where no row says what such a thing has its place on. Where its words end; 0: no
  // such thing.
  std::size_t end_of_thing(std::size_t first, std::size_t at) const {
    for (std::size_t i = first; i < at; ++i) {
      if (is(i, {"storage"})) return 0;
    }
    // not "a nightstand provides space for a phone"
    const bool opens = first == 0 || tokens_[first - 1].kind != Token::Kind::kWord || tokens_[first - 1].ends_sentence ||
                       is(first - 1, {"and", "with", "plus", "need", "want", "needs", "wants", "also"});
    // "somewhere to put a mirror"
    const std::size_t put = is(at, {"to"}) ? keeping(at + 1) : 0;
    const std::size_t article = at + 1 + put;
    if (!opens || !(is(at, {"for"}) || put > 0) || !is_article(article)) return 0;
    const Match thing = lexicon_.find(tokens_, article + 1, WordClass::kObject);
    const Meaning* meaning = meaning_of(thing, WordClass::kObject);
    const Mount mount = meaning != nullptr && meaning->entry != nullptr ? meaning->entry->mount : Mount::kCeiling;
    const bool stands = mount != Mount::kCeiling && !meaning->entry->is(Trait::kTableSeat) && !meaning->entry->is(Trait::kPersonalAid) &&
                        (mount == Mount::kFloor || mount == Mount::kWall || (mount == Mount::kSurface && put == 0));
    return stands ? article + 1 + thing.length : 0;
  }

  // The tokens of "somewhere", "a place", "some space", "storage" that begin there; 0: none.
  std::size_t place_at(std::size_t i) const {
    const std::size_t article = is(i, {"a", "an", "some", "enough", "another", "plenty", "lots", "more"}) ? 1 : 0;
    const bool kind = article > 0 && is(i + 1, {"kind", "sort"}) && is(i + 2, {"of"});  // "some kind of storage"
    const std::size_t of = kind ? 2 : article > 0 && is(i + 1, {"of", "more"}) ? 1 : 0;
    for (const std::string_view list : {"places", "stores"}) {
      for (const WordList::Member member : words_.at(list)) {
        const std::size_t length = matched(member.value.text(), i + article + of);
        const bool next = length > 0 && is(i + article + of + length, {"to", "for", "where", "i", "we", "you", "she", "he", "they", "the"});
        if (next) return article + of + length;
      }
    }
    return 0;
  }

  // Something that is asked for, and no place at which something else is or what a thing is for.
  bool is_wanted(std::size_t i) const {
    if (i == 0 || tokens_[i - 1].ends_sentence) return true;
    return !is(i - 1, {"in",   "at",   "by", "near", "from", "into", "of", "as",  "its",  "the",    "no",     "to",
                       "this", "that", "my", "our",  "so",   "is",   "on", "any", "same", "living", "dining", "walk"});
  }

  // "somewhere for the old dog to lie down"
  bool is_pet(std::size_t at) const {
    const Meaning* meaning = meaning_of(lexicon_.find(tokens_, at, WordClass::kObject), WordClass::kObject);
    return meaning != nullptr && meaning->entry != nullptr && meaning->entry->is(Trait::kPet);
  }

  // What is said from `at` on, behind the place.
  std::optional<Use> use_at(std::size_t at) const {
    if (is(at, {"to"})) return to_do(at + 1, 0);
    if (is(at, {"for"})) {
      constexpr std::size_t kWho = 5;  // tokens
      int people = 0;
      bool pets = false;
      for (std::size_t to = at + 1; to <= at + kWho && !ends(to); ++to) {
        if (is(to, {"to"})) return pets ? longest("pets", to + 1, 0) : to_do(to + 1, people);
        pets |= is_pet(to);
        if (const NumberRead number = read_number(lexicon_, tokens_, to); number.length > 0) people = static_cast<int>(number.value);
        if (tokens_[to].text.ends_with('s')) people = std::max(people, 2);  // "for friends to sit"
      }
      return longest("for", at + 1, 0);
    }
    // "somewhere I can sit", "a place where the kids can draw"
    std::size_t may = at;
    while (may < at + 4 && !ends(may) && !is_may(may)) ++may;
    return is_may(may) ? to_do(may + 1, 0) : std::nullopt;
  }

  // "storage for her diapers": of what no row says where it is kept, a cabinet.
  std::optional<Use> kept_anywhere(std::size_t i, std::size_t at) const {
    bool stores = false;
    for (std::size_t word = i; word < at; ++word) stores |= is(word, {"storage"});
    if (!stores || !is(at, {"for"})) return std::nullopt;
    constexpr std::size_t kName = 5;  // tokens of what is kept
    std::size_t end = at + 1;
    while (end <= at + kName && !ends(end) && (end == at + 1 || !is(end, {"and", "with", "by", "near", "in", "on", "next", "under"})))
      ++end;
    return end > at + 1 ? std::optional(Use{words_.at("rest"), end, 0}) : std::nullopt;
  }

  bool is_may(std::size_t at) const {
    if (at >= tokens_.size()) return false;
    for (const WordList::Member word : words_.at("may")) {
      if (tokens_[at].text == word.value.text()) return true;
    }
    return false;
  }

  // A wish of which no thing is named says what kind of room it is (`wishes`).
  bool names_others(std::size_t i, std::size_t end) const {
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
      if (at >= i && at < end) continue;
      if (!skip_[at] && names_thing(at)) return true;
    }
    return false;
  }

  bool names_thing(std::size_t at) const {
    if (lexicon_.find(tokens_, at, WordClass::kObject).length > 0) return true;
    Token single = tokens_[at];
    single.text = singular_of(single.text);
    return lexicon_.find({&single, 1}, 0, WordClass::kObject).length > 0;
  }

  // "an office … somewhere to nap": what no such room has of itself.
  bool is_extra(const Use& use) const {
    const std::string_view here = room();
    if (here.empty() || !use.row.contains("rooms")) return false;
    for (const WordList::Member kind : use.row.at("rooms")) {
      if (kind.key == here) return true;
    }
    return false;
  }

  void write(std::size_t i, const Use& use) {
    if (!names_others(i, use.end) && !is_extra(use)) return;
    std::size_t at = i;
    const bool served = is_served(use, i);
    // "for her toys and books": one thing for each, where the words suffice.
    if (is(use.end, {"and"}) && (!is(i + 1, {"to"}) || keeping(i + 2) > 0)) {
      const auto more = longest("for", use.end + 1, 0);
      if (more && !is_served(*more, i)) {
        if (!served) at = put_thing(at, use, more->end);
        if (at + 1 < more->end && !served) put(at++, "and");
        at = put_thing(at, *more, more->end);
        return leave_out(at, more->end);
      }
    }
    if (served) return;
    at = put_thing(at, use, use.end);
    const std::size_t end = end_of_doing(use.end);
    if (at < end) leave_out(at, end);
  }

  // "two armchairs" from `at` on and before `end`: behind it.
  std::size_t put_thing(std::size_t at, const Use& use, std::size_t end) {
    std::string_view thing = thing_of(use, room());
    const auto words = static_cast<std::size_t>(std::ranges::count(thing, ' ') + 1);
    if (at + words > end) return at;
    if (at + words < end) put(at++, use.people > 1 && use.row.contains("each") ? "two" : "a");
    while (!thing.empty() && at < end) {
      const std::string_view word = thing.substr(0, thing.find(' '));
      thing.remove_prefix(std::min(thing.size(), word.size() + 1));
      put(at++, word);
    }
    return at;
  }

  // "somewhere to sit while changing shoes": behind what goes on there meanwhile.
  std::size_t end_of_doing(std::size_t end) const {
    const bool more = is(end, {"and"}) && !is_article(end + 1) && place_at(end + 1) == 0 &&
                      lexicon_.find(tokens_, end + 1, WordClass::kObject).length == 0;
    if (!more && !is(end, {"while", "when", "whenever", "after", "before", "during", "comfortably", "properly", "quietly", "too"}))
      return end;
    std::size_t at = end + 1;
    while (at < tokens_.size() && !ends(at) && !is(at, {"with", "by", "near", "under", "and", "in"})) ++at;
    return at;
  }

  void put(std::size_t at, std::string_view word) {
    tokens_[at].text = word;
    tokens_[at].kind = Token::Kind::kWord;
  }
};

}  // namespace

void read_uses(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { UseReader(lexicon, document.tokens, skip).run(); }

}  // namespace layoutbox::offline
