// Which things a noun phrase speaks of: new ones, or what was named before.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

// "large", "larger", "largest" and "big", "bigger": one quality.
bool same_quality(std::string_view one, std::string_view other);

class References {
 public:
  References(const Lexicon& lexicon, Document& document) : lexicon_(lexicon), document_(document) {}

  // Adds the mention that a noun phrase makes. `antecedent` is what "it", "them" and "one" mean here (a mention, or -1);
  // `as_reference`: the phrase is what something else is placed by.
  // `of_known`: "one sofa" may be one of those that were named.
  int mention(const NounPhrase& noun, int antecedent, bool as_reference, bool of_known = false);

  // More items of the mention's kind, until there are `count`.
  void grow(int mention, std::size_t count);

  // The one of a group that the mention means becomes the whole group, where that has `count` of them.
  void mean_one_for_each(int mention, std::size_t count);

  // What the mention brought in belongs to the group of `of`: "the other two".
  void join_group(int mention, int of);

  // True when some of the group were taken by "one", "five" … before, and that many are left.
  bool has_left(int mention, int count) const;
  // True while one of the mention's things was not taken.
  bool has_left_of(int mention) const;
  // The mention that brought in the group.
  int whole_group(int mention) const;

  // The items that the words of a noun phrase may mean.
  std::vector<int> known(const NounPhrase& noun) const;

  // The latest mention of a group of two or more things, or -1.
  int latest_group() const;

 private:
  int add(Mention mention);
  void introduce(Mention& mention, const NounPhrase& noun, int count);
  // What the mention's noun phrase speaks of, by its kind.
  void mean_antecedent(Mention& mention, int antecedent) const;
  void mean_member(Mention& mention, int antecedent);
  void mean_part(Mention& mention, int antecedent);
  void mean_everything(Mention& mention) const;
  void mean_object(Mention& mention, bool as_reference, bool of_known);
  bool is_said_again(const NounPhrase& noun) const;
  void mean_known(Mention& mention);
  void mean_one_of_known(Mention& mention);
  bool carry_their_own(const std::vector<int>& items) const;
  void mean_own_shelf(Mention& mention) const;
  // "the red one", "the smaller one": the latest thing that was called so, or -1.
  int described(const NounPhrase& noun) const;
  std::vector<int> whose_shelf(const NounPhrase& noun) const;
  bool same_kind(const NounPhrase& wanted, const NounPhrase& item) const;
  int fit(const NounPhrase& wanted, const NounPhrase& item) const;
  void general(const NounPhrase& noun, bool as_reference, Mention& mention) const;
  // Those that the words single out by their place among all: "the first two", "the middle one", "every other chair"; all where they
  // do not.
  static std::vector<int> singled_out(const std::vector<int>& all, const NounPhrase& noun);
  std::size_t share_of_each(int group, const NounPhrase& member) const;
  void choose_members(Mention& mention, const NounPhrase& noun, int antecedent);

  const Lexicon& lexicon_;
  Document& document_;
  static constexpr std::size_t kReach = 300;       // items and mentions that are looked back at; keeps long texts linear
  static constexpr std::size_t kMostItems = 1000;  // of one room
  bool full_ = false;
  std::map<int, std::vector<int>> picked_;  // group → items that a "one" has taken
};

}  // namespace layoutbox::offline
