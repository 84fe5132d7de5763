#include "layoutbox/plan/syntax/weights.h"

#include "layoutbox/embedded/syntax_data.h"

namespace layoutbox::syntax {
namespace {

// The file: "LBSY", the version, a million times the scales of the models; then four tables: words, tags, labels, each its size in bytes,
// the number of bits that choose a bucket, for each bucket (and the end) where it begins, and the buckets' records; last the steps, their
// size in bytes and lines. Little-endian, no padding.
constexpr std::string_view kMagic = "LBSY";
constexpr std::uint32_t kVersion = 2;

std::uint32_t read16(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]) | static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + 1])) << 8;
}
std::uint32_t read32(std::string_view bytes, std::size_t at) { return read16(bytes, at) | read16(bytes, at + 2) << 16; }

constexpr std::size_t kRecord = 3;      // check (2), how many pairs of class and weight
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
  for (Table* table : {&words_, models_.data(), &models_[static_cast<std::size_t>(Model::kLabel)]}) {
    if (bytes.size() < at + 8) return;
    const std::size_t size = read32(bytes, at);
    const int bits = static_cast<int>(read32(bytes, at + 4));
    at += 8;
    if (bytes.size() < at + size || bits < 1 || bits > 24) return;
    *table = {bytes.substr(at, size), bits};
    at += size;
  }
  if (bytes.size() < at + 4 || bytes.size() < at + 4 + read32(bytes, at)) return;
  lines_ = bytes.substr(at + 4, read32(bytes, at));
}

std::string_view Weights::Table::bucket(std::uint64_t key) const {
  if (bits == 0) return {};
  const std::size_t index = key >> (64 - bits);
  const std::size_t base = 4 * ((std::size_t{1} << bits) + 1);
  const std::size_t begin = base + read32(bytes, 4 * index), end = base + read32(bytes, 4 * index + 4);
  return bytes.substr(begin, end - begin);
}

std::uint32_t Weights::info(std::uint64_t word) const {
  const std::string_view bucket = words_.bucket(word);
  for (std::size_t at = 0; at + kWordRecord <= bucket.size(); at += kWordRecord) {
    if (read16(bucket, at) == (word & 0xffff)) return read32(bucket, at + 2);
  }
  return 0;
}

void Weights::add(Model model, std::span<const std::uint64_t> features, std::span<int> scores) const {
  if (model == Model::kStep) return add_steps(features, scores);
  const Table& table = models_[static_cast<std::size_t>(model)];
  for (const std::uint64_t key : features) {
    const std::string_view bucket = table.bucket(key);
    for (std::size_t at = 0; at + kRecord <= bucket.size();) {
      const std::size_t pairs = static_cast<unsigned char>(bucket[at + 2]);
      if (read16(bucket, at) == (key & 0xffff)) {
        for (std::size_t pair = at + kRecord; pair < at + kRecord + 2 * pairs; pair += 2) {
          scores[static_cast<unsigned char>(bucket[pair])] += static_cast<signed char>(bucket[pair + 1]);
        }
        break;
      }
      at += kRecord + 2 * pairs;
    }
  }
}

void Weights::add_steps(std::span<const std::uint64_t> features, std::span<int> scores) const {
  const std::size_t lines = lines_.size() / kLine;
  if (lines == 0) return;
  for (const std::uint64_t key : features) __builtin_prefetch(lines_.data() + kLine * line_of(key, lines));
  for (const std::uint64_t key : features) {
    const std::string_view line = lines_.substr(kLine * line_of(key, lines), kLine);
    for (std::size_t i = 0; i < kLineRoom; ++i) {
      if (read16(line, 2 * i) != (key & 0xffff)) continue;
      const std::size_t at = 2 * kLineRoom + kLineLabels * i;
      for (std::size_t label = 0; label < kLineLabels; ++label) scores[label] += static_cast<signed char>(line[at + label]);
      break;
    }
  }
}

const Weights& built_in_weights() {
  static const Weights weights(embedded::syntax_bin);
  return weights;
}

}  // namespace layoutbox::syntax
