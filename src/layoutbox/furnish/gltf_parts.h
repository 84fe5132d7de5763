// Parts of reading glTF: transforms of nodes, numbers of accessors.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/furnish/tinygltf_quietly.h"

namespace layoutbox {

using Matrix = std::array<double, 16>;  // columns, as glTF has them

constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix times(const Matrix& a, const Matrix& b);
Matrix matrix_of(const tinygltf::Node& node);

// The numbers of an accessor, `width` to an element, whatever they are stored as. Nothing is set aside before the file is known to hold
// them. Errors: kParse (not there, or beyond its buffer), kTooLarge (more than `most` elements); the message is a clause.
Result<std::vector<double>> accessor_numbers(const tinygltf::Model& file, int accessor, std::size_t width, std::size_t most);

}  // namespace layoutbox
