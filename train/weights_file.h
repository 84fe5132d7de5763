// Writes the file that Weights reads.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "layoutbox/plan/syntax/weights.h"

namespace layoutbox::syntax {

using Averages = std::unordered_map<std::uint64_t, std::vector<std::pair<std::uint8_t, float>>>;

// The table of words from lines "word bits".
std::string word_table(const std::string& path);

// A model's table: at most `keep` features, those with the largest weights, in whole numbers from -127 to 127. Sets how many of them
// make 1.
std::string model_table(WeightTable model, const Averages& averages, std::size_t keep, float& units);

// The whole file. `scales`: one over a usual margin in the models' whole numbers.
std::string weights_file(const std::string& words, const std::array<std::string, kModels>& models,
                         const std::array<float, kModels>& scales);

}  // namespace layoutbox::syntax
