// What the parser learned, read in place: which words are of which kind, and the weights of features (docs/syntax.md has the format).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace layoutbox::syntax {

// Models in the order of the file.
enum class WeightTable : std::uint8_t { kTag, kStep, kLabel };
inline constexpr int kModels = 3;

// Scatters the bits of a key, so that its upper bits choose a bucket and its lower ones tell it from others.
constexpr std::uint64_t scatter(std::uint64_t key) {
  key ^= key >> 33;
  key *= 0xff51afd7ed558ccdULL;
  key ^= key >> 33;
  key *= 0xc4ceb9fe1a85ec53ULL;
  return key ^ (key >> 33);
}

// A word's key, letters in lower case.
std::uint64_t word_key(std::string_view word);

class Weights {
 public:
  // Bytes as syntax_train writes them; they must outlive this. Anything else gives weights that know nothing.
  explicit Weights(std::string_view bytes);

  // What is known of a word (bits as in words.h), 0 where nothing is.
  std::uint32_t info(std::uint64_t word) const;

  // Adds the weights of all features to the scores of a model's classes.
  void add(WeightTable model, std::span<const std::uint64_t> features, std::span<int> scores) const;

  // One over what a usual margin is, for a model's scores.
  float scale(WeightTable model) const { return scales_[static_cast<std::size_t>(model)]; }

 private:
  // Three bytes for a feature: the steps' weights themselves; for tags and labels a place in the pool, where pairs of class and weight are.
  struct Table {
    std::string_view lines, pool;
    const char* find(std::uint64_t key) const;
  };
  std::string_view words_;
  int word_bits_ = 0;  // of a key choose a bucket
  std::array<Table, kModels> models_;
  std::array<float, kModels> scales_{};
};

// How features are looked up, each in one cache line: lines of 64 bytes have room for twelve, first their checks (16 bits), then three
// bytes each.
inline constexpr std::size_t kLine = 64, kLineRoom = 12, kLineValue = 3;
constexpr std::size_t line_of(std::uint64_t key, std::size_t lines) { return static_cast<std::size_t>((key >> 32) * lines >> 32); }

// The weights in the program.
const Weights& built_in_weights();

}  // namespace layoutbox::syntax
