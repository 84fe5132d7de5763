#include "weights_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

namespace layoutbox::syntax {
namespace {

void put16(std::string& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<char>(value & 0xff));
  bytes.push_back(static_cast<char>(value >> 8 & 0xff));
}
void put32(std::string& bytes, std::uint32_t value) {
  put16(bytes, value & 0xffff);
  put16(bytes, value >> 16);
}

// Records by their keys into buckets of about four; of two that look alike in a bucket the first stays.
std::string bucketed(std::vector<std::pair<std::uint64_t, std::string>> records) {
  int bits = 1;
  while ((std::size_t{4} << bits) < records.size()) ++bits;
  std::stable_sort(records.begin(), records.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string index, data;
  std::size_t next = 0;
  for (std::uint64_t bucket = 0; bucket < std::uint64_t{1} << bits; ++bucket) {
    put32(index, static_cast<std::uint32_t>(data.size()));
    std::vector<std::uint64_t> seen;
    for (; next < records.size() && records[next].first >> (64 - bits) == bucket; ++next) {
      const std::uint64_t check = records[next].first & 0xffff;
      if (std::find(seen.begin(), seen.end(), check) != seen.end()) continue;
      seen.push_back(check);
      put16(data, static_cast<std::uint32_t>(check));
      data += records[next].second;
    }
  }
  put32(index, static_cast<std::uint32_t>(data.size()));
  std::string table;
  put32(table, static_cast<std::uint32_t>(index.size() + data.size()));
  put32(table, static_cast<std::uint32_t>(bits));
  return table + index + data;
}

}  // namespace

std::string word_table(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::pair<std::uint64_t, std::string>> records;
  std::string word;
  std::uint32_t bits = 0;
  while (file >> word >> bits) {
    std::string record;
    put32(record, bits);
    records.emplace_back(word_key(word), record);
  }
  return bucketed(std::move(records));
}

namespace {

// The features with the largest weights, the largest first, and how many whole numbers make 1.
std::vector<std::uint64_t> largest(const Averages& averages, std::size_t keep, float& units) {
  std::vector<std::pair<float, std::uint64_t>> order;
  std::vector<float> sizes;
  for (const auto& [feature, weights] : averages) {
    float most = 0;
    for (const auto& [label, weight] : weights) {
      most = std::max(most, std::abs(weight));
      sizes.push_back(std::abs(weight));
    }
    order.emplace_back(-most, feature);
  }
  std::sort(order.begin(), order.end());
  if (order.size() > keep) order.resize(keep);
  std::sort(sizes.begin(), sizes.end());
  // The very largest are cut, so that the many small ones keep their differences.
  const float top = sizes.empty() ? 1 : std::max(sizes[sizes.size() - 1 - sizes.size() / 5000], 1e-6F);
  units = 127 / top;
  std::vector<std::uint64_t> features;
  for (const auto& [size, feature] : order) features.push_back(feature);
  return features;
}

int whole(float weight, float units) { return static_cast<int>(std::lround(std::clamp(weight * units, -127.0F, 127.0F))); }

}  // namespace

std::string model_table(WeightTable model, const Averages& averages, std::size_t keep, float& units) {
  const auto features = largest(averages, keep, units);
  constexpr std::size_t kUsual = 8;  // features in a line: those that find theirs full are lost, the smallest ones
  const std::size_t count = features.size() / kUsual + 1;
  std::string lines(count * kLine, '\0'), pool;
  std::map<std::string, std::size_t> places;  // many features say the same
  std::vector<std::size_t> used(count);
  for (const std::uint64_t feature : features) {
    const std::size_t line = line_of(feature, count), check = feature & 0xffff, slot = used[line];
    if (slot == kLineRoom || check == 0) continue;
    std::string pairs;
    auto weights = averages.at(feature);
    std::sort(weights.begin(), weights.end());
    std::string value(kLineValue, '\0');
    for (const auto& [label, weight] : weights) {
      if (whole(weight, units) == 0) continue;
      pairs.push_back(static_cast<char>(label));
      pairs.push_back(static_cast<char>(whole(weight, units)));
      if (model == WeightTable::kStep) value[label] = pairs.back();
    }
    if (pairs.empty()) continue;
    if (model != WeightTable::kStep) {
      pairs.insert(pairs.begin(), static_cast<char>(pairs.size() / 2));
      const auto [known, added] = places.emplace(pairs, pool.size());
      if (added) pool += pairs;
      for (std::size_t i = 0; i < kLineValue; ++i) value[i] = static_cast<char>(known->second >> 8 * i & 0xff);
    }
    char* begin = lines.data() + line * kLine;
    begin[2 * slot] = static_cast<char>(check & 0xff);
    begin[2 * slot + 1] = static_cast<char>(check >> 8);
    std::copy(value.begin(), value.end(), begin + 2 * kLineRoom + kLineValue * slot);
    ++used[line];
  }
  std::string table;
  put32(table, static_cast<std::uint32_t>(lines.size()));
  put32(table, static_cast<std::uint32_t>(pool.size()));
  return table + lines + pool;
}

std::string weights_file(const std::string& words, const std::array<std::string, kModels>& models,
                         const std::array<float, kModels>& scales) {
  std::string bytes = "LBSY";
  put32(bytes, 3);
  for (const float scale : scales) put32(bytes, static_cast<std::uint32_t>(std::lround(scale * 1000000)));
  bytes += words;
  for (const std::string& model : models) bytes += model;
  return bytes;
}

}  // namespace layoutbox::syntax
