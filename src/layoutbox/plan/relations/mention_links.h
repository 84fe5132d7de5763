// Which links speak of a mention, kept as links are added: asking does not go through the whole text.
#pragma once

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "layoutbox/plan/phrases/document.h"
#include "layoutbox/plan/phrases/reader_words.h"

namespace layoutbox::offline {

class MentionLinks {
 public:
  explicit MentionLinks(const Document& document) : document_(document) { follow(); }

  // Takes in the mentions and links that were added since.
  void follow() {
    of_target_.resize(document_.mentions.size());
    of_reference_.resize(document_.mentions.size());
    for (; mentions_ < document_.mentions.size(); ++mentions_) {
      const std::vector<int>& items = document_.mentions[mentions_].items;
      if (!items.empty()) by_first_item_[items.front()].push_back(static_cast<int>(mentions_));
    }
    for (; links_ < document_.links.size(); ++links_) {
      const Link& link = document_.links[links_];
      for (const int m : link.targets) of_target_[static_cast<std::size_t>(m)].push_back(links_);
      for (const int m : link.references) of_reference_[static_cast<std::size_t>(m)].push_back(links_);
    }
  }

  // Is the mention placed by such a one?
  template <class Predicate>
  bool is_placed_by(int target, Predicate is_such) const {
    return std::ranges::any_of(of_target_[static_cast<std::size_t>(target)], [&](std::size_t l) {
      return std::ranges::any_of(document_.links[l].references,
                                 [&](int reference) { return is_such(document_.mentions[static_cast<std::size_t>(reference)]); });
    });
  }

  // The mentions of the same things, in the order of the text.
  std::vector<int> of_same(const Mention& mention) const {
    std::vector<int> same;
    const auto found = mention.items.empty() ? by_first_item_.end() : by_first_item_.find(mention.items.front());
    if (found == by_first_item_.end()) return same;
    std::ranges::copy_if(found->second, std::back_inserter(same),
                         [&](int m) { return document_.mentions[static_cast<std::size_t>(m)].items == mention.items; });
    return same;
  }

  // What is placed by those things in such links, in the order of the text.
  template <class Predicate>
  std::vector<int> placed_by(const Mention& host, Predicate is_such) const {
    std::vector<int> placed;
    for (const int m : of_same(host)) {
      for (const std::size_t l : of_reference_[static_cast<std::size_t>(m)]) {
        if (is_such(document_.links[l])) placed.insert(placed.end(), document_.links[l].targets.begin(), document_.links[l].targets.end());
      }
    }
    std::ranges::sort(placed);
    placed.erase(std::unique(placed.begin(), placed.end()), placed.end());
    return placed;
  }

  // The mentions that a mention is placed by, as often as it is.
  std::vector<int> hosts_of(int target) const {
    std::vector<int> hosts;
    for (const std::size_t l : of_target_[static_cast<std::size_t>(target)])
      hosts.insert(hosts.end(), document_.links[l].references.begin(), document_.links[l].references.end());
    return hosts;
  }

 private:
  const Document& document_;
  std::size_t mentions_ = 0, links_ = 0;                            // so many are in
  std::vector<std::vector<std::size_t>> of_target_, of_reference_;  // links, by mention
  std::unordered_map<int, std::vector<int>> by_first_item_;         // mentions
};

}  // namespace layoutbox::offline
