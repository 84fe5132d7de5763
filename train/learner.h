// An averaged perceptron over sparse features.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace layoutbox::syntax {

// An open table from features to their weights, which lie together in a pool.
class Learner {
 public:
  Learner() : slots_(std::size_t{1} << 16) {}

  void add(std::span<const std::uint64_t> features, std::span<float> scores) const {
    for (const std::uint64_t feature : features) {
      const Slot& slot = slots_[find(feature)];
      for (std::uint32_t i = slot.begin; i < slot.begin + slot.count; ++i) scores[now_[i].label] += now_[i].weight;
    }
  }

  // Moves the weights towards one answer and away from another.
  void update(std::span<const std::uint64_t> features, int right, int wrong) {
    for (const std::uint64_t feature : features) {
      change(feature, right, 1);
      change(feature, wrong, -1);
    }
  }

  // One tick of the clock is one decision: averages are over decisions.
  void tick() { ++clock_; }

  void set(std::uint64_t feature, int label, float weight) { change(feature, label, weight); }

  std::unordered_map<std::uint64_t, std::vector<std::pair<std::uint8_t, float>>> averaged() const {
    std::unordered_map<std::uint64_t, std::vector<std::pair<std::uint8_t, float>>> result;
    for (const Slot& slot : slots_) {
      if (slot.room == 0) continue;
      auto& to = result[slot.key];
      for (std::uint32_t i = slot.begin; i < slot.begin + slot.count; ++i) {
        const double sum = past_[i].sum + static_cast<double>(now_[i].weight) * static_cast<double>(clock_ - past_[i].since);
        to.emplace_back(static_cast<std::uint8_t>(now_[i].label), static_cast<float>(sum / static_cast<double>(clock_)));
      }
    }
    return result;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t begin = 0;
    std::uint16_t count = 0, room = 0;  // room 0: free
  };
  struct Now {
    std::uint32_t label;
    float weight;
  };
  struct Past {
    double sum;  // of all values so far
    std::int64_t since;
  };

  std::size_t find(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = (key >> 20) & mask;
    while (slots_[at].room != 0 && slots_[at].key != key) at = (at + 1) & mask;
    return at;
  }

  void grow() {
    std::vector<Slot> old(slots_.size() * 2);
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.room != 0) slots_[find(slot.key)] = slot;
    }
  }

  void change(std::uint64_t feature, int label, float by) {
    std::size_t at = find(feature);
    if (slots_[at].room == 0) {
      if (++used_ * 2 > slots_.size()) {
        grow();
        at = find(feature);
      }
      slots_[at].key = feature;
      move(slots_[at], 2);
    }
    Slot& slot = slots_[at];
    for (std::uint32_t i = slot.begin; i < slot.begin + slot.count; ++i) {
      if (now_[i].label != static_cast<std::uint32_t>(label)) continue;
      past_[i].sum += static_cast<double>(now_[i].weight) * static_cast<double>(clock_ - past_[i].since);
      past_[i].since = clock_;
      now_[i].weight += by;
      return;
    }
    if (slot.count == slot.room) move(slot, static_cast<std::uint16_t>(slot.room * 2));
    now_[slot.begin + slot.count] = {static_cast<std::uint32_t>(label), by};
    past_[slot.begin + slot.count] = {0, clock_};
    ++slot.count;
  }

  // Gives a slot more room, at the end of the pool.
  void move(Slot& slot, std::uint16_t room) {
    const auto begin = static_cast<std::uint32_t>(now_.size());
    now_.resize(now_.size() + room);
    past_.resize(past_.size() + room);
    for (std::uint32_t i = 0; i < slot.count; ++i) {
      now_[begin + i] = now_[slot.begin + i];
      past_[begin + i] = past_[slot.begin + i];
    }
    slot.begin = begin;
    slot.room = room;
  }

  std::vector<Slot> slots_;
  std::vector<Now> now_;
  std::vector<Past> past_;
  std::size_t used_ = 0;
  std::int64_t clock_ = 1;
};

}  // namespace layoutbox::syntax
