#include "layoutbox/plan/passes/owners.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/splice.h"
#include "layoutbox/plan/phrases/token_reader.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

class OwnerReader : public TokenReader {
 public:
  OwnerReader(const Lexicon& lexicon, Document& document, std::vector<bool>& skip)
      : TokenReader(lexicon, document.tokens, skip), document_(document) {}

  void run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (skip_[i]) continue;
      if (const std::string_view owner = owner_alone(i); !owner.empty())
        complete(i, owner);
      else if (!mean_persons_own(i) && !mean_other_owner(i) && !mean_both_owners(i))
        note_owned(i);
    }
    mark_contrasts();
    splice(document_, skip_, std::move(splices_));
  }

 private:
  static constexpr std::size_t kReach = 80;  // tokens between two things of one kind that are told apart by their owners

  struct Owned {
    std::string owner, thing;  // "her", "bed"
    std::size_t at = 0;        // of the owner's token
  };

  // "her" of "hers"; "his" where no thing of his follows; empty: no possessive that stands alone.
  std::string_view owner_alone(std::size_t i) const {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kAlone{
        {{"hers", "her"}, {"theirs", "their"}, {"mine", "my"}, {"ours", "our"}, {"yours", "your"}, {"his", "his"}}};
    const auto alone = std::ranges::find(kAlone, tokens_[i].text, &decltype(kAlone)::value_type::first);
    if (alone == kAlone.end() || (i > 0 && lexicon_.is(tokens_[i - 1], WordClass::kIndefinite))) return {};
    if (alone->first != "his") return alone->second;
    if (is(i + 1, {"left", "right", "own"})) return {};  // "at his left hand"
    const bool of = i > 0 && is(i - 1, {"of", "to", "beside", "by", "on", "above", "under", "at", "behind", "opposite", "near"});
    const bool goes_on =
        i + 1 < tokens_.size() && (lexicon_.is(tokens_[i + 1], WordClass::kBe) || lexicon_.is(tokens_[i + 1], WordClass::kPlaceVerb) ||
                                   lexicon_.is(tokens_[i + 1], WordClass::kHave) || lexicon_.is(tokens_[i + 1], WordClass::kHang) ||
                                   lexicon_.find_phrase(tokens_, i + 1).length > 0);
    const bool over = ends(i + 1) || is(i + 1, {"a", "an", "there", "and"});
    return goes_on || (of && over) ? alone->second : std::string_view{};
  }

  // "her bed", "my old desk"
  void note_owned(std::size_t i) {
    if (!is_owner(i)) return;
    const std::optional<NamedThing> thing = thing_named_at(i);
    if (thing && thing->last <= tokens_.size() && singular_of(tokens_[thing->noun].text) == tokens_[thing->noun].text)
      owned_.push_back({tokens_[i].text, tokens_[thing->noun].text, i});
  }

  bool is_owner(std::size_t i) const { return is(i, {"my", "your", "his", "her", "our", "their"}); }

  // The last thing that was named with another owner, or with this one.
  const Owned* last_of(std::string_view owner, std::size_t i, bool another) const {
    for (std::size_t o = owned_.size(); o-- > 0 && owned_[o].at + kReach > i;) {
      if ((owned_[o].owner == owner) != another) return &owned_[o];
    }
    return nullptr;
  }

  // "his": "his bed", after "her bed".
  void complete(std::size_t i, std::string_view owner) {
    // "mine, a milking stool, next to his": the stool
    if (is(i + 1, {","}) && i + 2 < tokens_.size() && lexicon_.is(tokens_[i + 2], WordClass::kIndefinite)) {
      if (const std::optional<NamedThing> thing = thing_named_at(i + 2); thing && ends(thing->last)) return leave_out(i, i + 2);
    }
    const Owned* like = last_of(owner, i, true);
    if (like == nullptr) like = last_of(owner, i, false);
    if (like != nullptr)
      name(i, std::string(owner), like->thing);
    else if (stands_for_one(i))
      tokens_[i].text = i == 0 || tokens_[i - 1].text != "one" ? "one" : "else";  // "one mine, one hers"
  }

  // "…, mine has a lamp": one of what was named. Not "a gold mine", "a friend of mine", "Yours, Ann".
  bool stands_for_one(std::size_t i) const {
    if (i == 0 || ends(i - 1)) return !is(i, {"yours"}) || !(ends(i + 1) || is(i + 1, {"truly", "sincerely", "faithfully", "ever"}));
    return tokens_[i - 1].text.ends_with("ing") || is(i - 1, {"and", "one", "by", "from", "to", "opposite", "beside", "behind", "near",
                                                              "beneath", "between", "with", "than", "above", "below", "under", "against"});
  }

  // "my armchair on one side and the wife's on the other": hers.
  bool mean_persons_own(std::size_t i) {
    if (i == 0 || !tokens_[i].glued || !is(i, {"'s", "is"})) return false;
    const std::string& who = tokens_[i - 1].text;
    const bool person = lexicon_.is_person(who) || word_form(who) == WordForm::kPerson;
    if (!person || !(ends(i + 1) || is(i + 1, {"and"}) || lexicon_.find_phrase(tokens_, i + 1).length > 0)) return false;
    const Owned* like = last_of("their", i, true);
    if (like == nullptr) return false;
    if (i > 1 && (lexicon_.is(tokens_[i - 2], WordClass::kDefinite) || is_owner(i - 2))) leave_out(i - 2, i - 1);
    const std::string thing = like->thing;
    owned_.push_back({"their", thing, i - 1});
    tokens_[i - 1].text = "their";
    tokens_[i].text = thing;
    return true;
  }

  // "hers has a lamp, the other one a clock": his, where there are two.
  bool mean_other_owner(std::size_t i) {
    if (!are(i, {"the", "other"}) || owned_.empty() || owned_.back().at + kReach < i || is_other_side(i)) return false;
    const std::size_t end = i + (is(i + 2, {"one"}) ? 3 : 2);
    const bool alone = ends(end) || is(end, {"a", "an", "there", "and"}) || lexicon_.is(tokens_[end], WordClass::kBe) ||
                       lexicon_.is(tokens_[end], WordClass::kHave) || lexicon_.is(tokens_[end], WordClass::kPlaceVerb);
    if (!alone || !is_told_by_owner(i)) return false;
    const Owned& one = owned_.back();
    const auto other = std::find_if(owned_.rbegin(), owned_.rend(),
                                    [&](const Owned& owned) { return owned.thing == one.thing && owned.owner != one.owner; });
    if (other == owned_.rend()) return false;
    const std::string owner = other->owner, thing = other->thing;
    leave_out(i + 1, end);
    name(i, owner, thing);
    return true;
  }

  // "his chair on one side of the fire, hers on the other": side.
  bool is_other_side(std::size_t i) const {
    constexpr std::size_t kNear = 24;  // tokens
    if (i == 0 || !is(i - 1, {"on", "at", "to"})) return false;
    for (std::size_t at = i; at-- > 0 && at + kNear > i;) {
      if (is(at, {"one"}) && is(at + 1, {"side", "end", "wall"})) return true;
    }
    return false;
  }

  // "Her bed is …, his …, and each has a lamp", "both have": each bed.
  bool mean_both_owners(std::size_t i) {
    if (!is(i, {"each", "both"}) || owned_.size() < 2 || lexicon_.is(tokens_[i - 1], WordClass::kBe)) return false;
    const bool alone =
        i + 1 < tokens_.size() && (lexicon_.is(tokens_[i + 1], WordClass::kHave) || lexicon_.is(tokens_[i + 1], WordClass::kBe) ||
                                   lexicon_.is(tokens_[i + 1], WordClass::kPlaceVerb));
    const Owned &one = owned_[owned_.size() - 2], &other = owned_.back();
    if (!alone || one.thing != other.thing || one.owner == other.owner || one.at + kReach < i) return false;
    tokens_[i].text = "each";
    if (is(i + 1, {"have", "are", "were"})) tokens_[i + 1].text = is(i + 1, {"have"}) ? "has" : "is";
    put_in(i + 1, other.thing);
    return true;
  }

  // Nothing in between that "the other" could go on with: "one", "a second".
  bool is_told_by_owner(std::size_t i) const {
    constexpr std::size_t kNear = 24;  // tokens
    for (std::size_t at = i; at-- > 0 && at + kNear > i;) {
      if (owned_.back().at == at) return true;
      if (is(at, {"one", "two", "both", "each"})) return false;
    }
    return false;
  }

  // The token at i is read as the owner, and the thing is put in after it.
  void name(std::size_t i, std::string owner, std::string thing) {  // copies: both may be of one that is listed
    owned_.push_back({owner, thing, i});
    tokens_[i].text = owner;
    put_in(i + 1, thing);
  }

  void put_in(std::size_t at, const std::string& word) { splices_.push_back({at, word_token(word)}); }

  // "her bed" and "his bed" are two.
  void mark_contrasts() {
    std::map<std::string_view, std::string_view> owner_of;
    std::set<std::string_view> contrasted;
    for (const Owned& one : owned_) {
      if (owner_of.try_emplace(one.thing, one.owner).first->second != one.owner) contrasted.insert(one.thing);
    }
    for (const Owned& one : owned_) tokens_[one.at].contrasted = contrasted.contains(one.thing);
  }

  Document& document_;
  std::vector<Owned> owned_;
  std::vector<Splice> splices_;
};

}  // namespace

void read_owners(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) { OwnerReader(lexicon, document, skip).run(); }

}  // namespace layoutbox::offline
