// A map from texts to values that is quick to fill: the texts stand one after the other, the values too, and a table of places finds them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace layoutbox::offline {

template <class Value>
class TextMap {
 public:
  explicit TextMap(std::size_t expected = 0) {
    nodes_.reserve(expected);
    std::size_t size = 16;
    while (size < expected * 2) size *= 2;
    slots_.assign(size, 0);
  }

  const Value* find(std::string_view text) const {
    const std::uint32_t place = slots_[slot_of(text)];
    return place == 0 ? nullptr : &nodes_[place - 1].second;
  }
  bool contains(std::string_view text) const { return find(text) != nullptr; }
  // The value of the text; a new one where it has none.
  Value& operator[](std::string_view text) { return nodes_[place_of(text)].second; }
  // The place of the text among all(), in the order in which they came.
  std::size_t place_of(std::string_view text) {
    std::size_t slot = slot_of(text);
    if (slots_[slot] != 0) return slots_[slot] - 1;
    if ((nodes_.size() + 1) * 2 > slots_.size()) {
      grow();
      slot = slot_of(text);
    }
    nodes_.emplace_back(Text{static_cast<std::uint32_t>(letters_.size()), static_cast<std::uint32_t>(text.size())}, Value{});
    letters_.append(text);
    slots_[slot] = static_cast<std::uint32_t>(nodes_.size());
    return nodes_.size() - 1;
  }
  Value& at_place(std::size_t place) { return nodes_[place].second; }
  std::size_t size() const { return nodes_.size(); }

 private:
  struct Text {
    std::uint32_t begin = 0, length = 0;  // of letters_
  };

  static std::size_t hash_of(std::string_view text) {
    std::uint64_t hash = 1469598103934665603ULL;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
  // Where the text is, or would be.
  std::size_t slot_of(std::string_view text) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash_of(text) & mask;
    while (slots_[slot] != 0) {
      const Text& there = nodes_[slots_[slot] - 1].first;
      if (std::string_view(letters_).substr(there.begin, there.length) == text) break;
      slot = (slot + 1) & mask;
    }
    return slot;
  }
  void grow() {
    slots_.assign(slots_.size() * 2, 0);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const Text& text = nodes_[n].first;
      slots_[slot_of(std::string_view(letters_).substr(text.begin, text.length))] = static_cast<std::uint32_t>(n + 1);
    }
  }

  std::string letters_;
  std::vector<std::pair<Text, Value>> nodes_;
  std::vector<std::uint32_t> slots_;  // a place and one more; 0: nothing
};

}  // namespace layoutbox::offline
