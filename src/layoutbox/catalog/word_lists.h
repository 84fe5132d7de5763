// The lists of words (catalog/words_*.json, relation_phrases, colors, materials) as they are read at run time: packed when the program is
// built (cmake/pack_words.cc) and looked at in place, so that nothing is parsed at start.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace layoutbox {

// A text, a number, an array or an object of the lists; a view that lives as long as the program. Objects keep the order of their file.
class WordList {
 public:
  enum class Kind : char { kText = 't', kNumber = 'n', kArray = 'a', kObject = 'o' };
  struct Member;
  class Iterator;

  explicit WordList(const char* at) : at_(at) {}
  bool is_text() const { return kind() == Kind::kText; }
  bool is_object() const { return kind() == Kind::kObject; }
  // REQUIRES: a text.
  std::string_view text() const { return {payload(), size()}; }
  // REQUIRES: a number.
  double number() const {
    double value = 0;
    std::memcpy(&value, payload(), sizeof value);
    return value;
  }

  // The elements of an array or the members of an object, in order.
  Iterator begin() const;
  Iterator end() const;

  bool contains(std::string_view key) const { return find(key) != nullptr; }
  // REQUIRES: an object that has the member.
  WordList at(std::string_view key) const { return WordList(find(key)); }

 private:
  static constexpr std::size_t kCount = sizeof(std::uint32_t), kHead = 1 + kCount;  // of a value: its kind, how many bytes follow
  static std::uint32_t count_at(const char* at) {
    std::uint32_t count = 0;
    std::memcpy(&count, at, kCount);
    return count;
  }
  Kind kind() const { return static_cast<Kind>(*at_); }
  std::size_t size() const { return count_at(at_ + 1); }
  const char* payload() const { return at_ + kHead; }
  const char* end_of() const { return payload() + size(); }
  const char* find(std::string_view key) const;

  const char* at_;
};

struct WordList::Member {
  std::string_view key;  // of objects
  WordList value;
};

class WordList::Iterator {
 public:
  Iterator(const char* at, bool keyed) : at_(at), keyed_(keyed) {}
  bool operator!=(const Iterator& other) const { return at_ != other.at_; }
  Iterator& operator++() {
    at_ = value().end_of();
    return *this;
  }
  Member operator*() const { return {keyed_ ? std::string_view(at_ + kCount, count_at(at_)) : std::string_view{}, value()}; }

 private:
  WordList value() const { return WordList(keyed_ ? at_ + kCount + count_at(at_) : at_); }
  const char* at_;
  bool keyed_;
};

inline WordList::Iterator WordList::begin() const { return {payload(), is_object()}; }
inline WordList::Iterator WordList::end() const { return {end_of(), is_object()}; }
inline const char* WordList::find(std::string_view key) const {
  for (const Member member : *this) {
    if (member.key == key) return member.value.at_;
  }
  return nullptr;
}

// The list of that file: "words_grammar", "colors". REQUIRES: one that cmake/pack_words.cc was given.
WordList word_list(std::string_view file);

// A document of JSON as such bytes; empty where it is no JSON.
std::string pack_words(std::string_view json);

// A pack of several: an object.
std::string pack_member(std::string_view key, std::string_view packed);
std::string pack_object(std::string_view members);

}  // namespace layoutbox
