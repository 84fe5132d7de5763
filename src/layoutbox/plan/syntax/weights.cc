#include "layoutbox/plan/syntax/weights.h"

#include <algorithm>

#include "layoutbox/embedded/syntax_data.h"

namespace layoutbox::syntax {
namespace {

// The file: "LBSY", the version, a million times the scales of the models; the words: their size in bytes, the number of bits that choose a
// bucket, for each bucket (and the end) where it begins, and the buckets; then for each model the sizes of its lines and its pool, and
// both. Little-endian, no padding. What follows says how they were learned.
constexpr std::string_view kMagic = "LBSY";
constexpr std::uint32_t kVersion = 3;

std::uint32_t read16(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]) | static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + 1])) << 8;
}
std::uint32_t read32(std::string_view bytes, std::size_t at) { return read16(bytes, at) | read16(bytes, at + 2) << 16; }

constexpr std::size_t kWordRecord = 6;  // check (2), what is known (4)

}  // namespace

std::uint64_t word_key(std::string_view word) {
  std::uint64_t key = 0xcbf29ce484222325ULL;
  for (const char c : word) {
    const char small = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    key = (key ^ static_cast<unsigned char>(small)) * 0x100000001b3ULL;
  }
  return scatter(key);
}

Weights::Weights(std::string_view bytes) {
  std::size_t at = kMagic.size() + 4 * (1 + kModels);
  if (bytes.size() < at || !bytes.starts_with(kMagic) || read32(bytes, kMagic.size()) != kVersion) return;
  for (std::size_t i = 0; i < kModels; ++i) scales_[i] = static_cast<float>(read32(bytes, kMagic.size() + 4 * (1 + i))) / 1e6F;
  const auto take = [&](std::size_t size) {
    const std::string_view part = bytes.substr(std::min(at, bytes.size()), size);
    at += size;
    return part;
  };
  if (bytes.size() < at + 8) return;
  const std::uint32_t size = read32(bytes, at);
  word_bits_ = static_cast<int>(read32(bytes, at + 4));
  at += 8;
  words_ = take(size);
  for (Table& table : models_) {
    if (bytes.size() < at + 8) return;
    const std::uint32_t lines = read32(bytes, at), pool = read32(bytes, at + 4);
    at += 8;
    table.lines = take(lines);
    table.pool = take(pool);
  }
}

std::uint32_t Weights::info(std::uint64_t word) const {
  if (word_bits_ == 0) return 0;
  const std::size_t index = word >> (64 - word_bits_), base = 4 * ((std::size_t{1} << word_bits_) + 1);
  const std::size_t end = base + read32(words_, 4 * index + 4);
  for (std::size_t at = base + read32(words_, 4 * index); at < end; at += kWordRecord) {
    if (read16(words_, at) == (word & 0xffff)) return read32(words_, at + 2);
  }
  return 0;
}

const char* Weights::Table::find(std::uint64_t key) const {
  if ((key & 0xffff) == 0) return nullptr;  // what free room looks like
  const char* line = lines.data() + kLine * line_of(key, lines.size() / kLine);
  for (std::size_t i = 0; i < kLineRoom; ++i) {
    if (read16({line, kLine}, 2 * i) == (key & 0xffff)) return line + 2 * kLineRoom + kLineValue * i;
  }
  return nullptr;
}

void Weights::add(WeightTable model, std::span<const std::uint64_t> features, std::span<int> scores) const {
  const Table& table = models_[static_cast<std::size_t>(model)];
  const std::size_t lines = table.lines.size() / kLine;
  if (lines == 0) return;
  for (const std::uint64_t key : features) __builtin_prefetch(table.lines.data() + kLine * line_of(key, lines));
  for (const std::uint64_t key : features) {
    const char* value = table.find(key);
    if (value == nullptr) continue;
    if (model == WeightTable::kStep) {
      for (std::size_t label = 0; label < kLineValue; ++label) scores[label] += static_cast<signed char>(value[label]);
      continue;
    }
    const std::size_t place = read16({value, kLineValue}, 0) | static_cast<std::size_t>(static_cast<unsigned char>(value[2])) << 16;
    const std::size_t end = place + 1 + 2 * static_cast<std::size_t>(static_cast<unsigned char>(table.pool[place]));
    for (std::size_t pair = place + 1; pair < end; pair += 2) {
      scores[static_cast<unsigned char>(table.pool[pair])] += static_cast<signed char>(table.pool[pair + 1]);
    }
  }
}

const Weights& built_in_weights() {
  static const Weights weights(embedded::syntax_bin);
  return weights;
}

}  // namespace layoutbox::syntax
