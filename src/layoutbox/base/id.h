// Numbers that count different things are of different types: the third constraint is not the third item.
#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace layoutbox {

// `Number` is wide enough for as many as there may be.
template <typename Tag, typename Number = int>
class Id {
 public:
  constexpr Id() = default;  // of nothing
  constexpr explicit Id(int number) : number_(static_cast<Number>(number)) {}
  constexpr explicit Id(std::size_t index) : number_(static_cast<Number>(index)) {}

  constexpr bool exists() const { return number_ >= 0; }
  constexpr int number() const { return number_; }  // −1: of nothing
  // REQUIRES: exists().
  constexpr std::size_t index() const { return static_cast<std::size_t>(number_); }

  friend constexpr auto operator<=>(const Id&, const Id&) = default;

 private:
  Number number_ = -1;
};

// Counts up through ids.
template <typename Key>
class IdRange {
 public:
  class Iterator {
   public:
    using value_type = Key;
    using difference_type = std::ptrdiff_t;
    constexpr Iterator() = default;
    constexpr explicit Iterator(int number) : number_(number) {}
    constexpr Key operator*() const { return Key(number_); }
    constexpr Iterator& operator++() { return ++number_, *this; }
    constexpr Iterator operator++(int) { return Iterator(number_++); }
    friend constexpr bool operator==(const Iterator&, const Iterator&) = default;

   private:
    int number_ = 0;
  };

  constexpr explicit IdRange(std::size_t count) : end_(static_cast<int>(count)) {}
  constexpr IdRange(std::size_t first, std::size_t end) : begin_(static_cast<int>(first)), end_(static_cast<int>(end)) {}
  constexpr Iterator begin() const { return Iterator(begin_); }
  constexpr Iterator end() const { return Iterator(end_); }

 private:
  int begin_ = 0, end_ = 0;
};

// The ids before that one. REQUIRES: it exists.
template <typename Key>
constexpr IdRange<Key> ids_before(Key end) {
  return IdRange<Key>(end.index());
}

// A list that is asked by such ids, and by nothing else.
template <typename Key, typename T>
class ById {
 public:
  ById() = default;
  explicit ById(std::size_t count, const T& value = {}) : list_(count, value) {}

  T& operator[](Key id) { return list_[id.index()]; }
  const T& operator[](Key id) const { return list_[id.index()]; }

  std::size_t size() const { return list_.size(); }
  bool empty() const { return list_.empty(); }
  bool has(Key id) const { return id.exists() && id.index() < list_.size(); }
  IdRange<Key> ids() const { return IdRange<Key>(list_.size()); }
  IdRange<Key> ids_after(Key id) const { return IdRange<Key>(id.index() + 1, list_.size()); }
  auto begin() { return list_.begin(); }
  auto end() { return list_.end(); }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  T& back() { return list_.back(); }
  void reserve(std::size_t count) { list_.reserve(count); }
  void resize(std::size_t count) { list_.resize(count); }
  std::span<const T> list() const { return list_; }
  // The one after it, after the last the first. REQUIRES: has(id).
  Key next(Key id) const { return Key((id.index() + 1) % list_.size()); }

  void clear() { list_.clear(); }
  void assign(std::size_t count, const T& value) { list_.assign(count, value); }
  T& emplace_back() { return list_.emplace_back(); }
  // The id that it has then.
  Key push_back(T value) {
    list_.push_back(std::move(value));
    return Key(list_.size() - 1);
  }
  // Of one of the list's own elements.
  Key id_of(const T& element) const { return Key(static_cast<std::size_t>(&element - list_.data())); }

  friend bool operator==(const ById&, const ById&) = default;

 private:
  std::vector<T> list_;
};

}  // namespace layoutbox
