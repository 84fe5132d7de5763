#include "layoutbox/furnish/gltf_parts.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace layoutbox {
namespace {

double number(const unsigned char* at, const tinygltf::Accessor& accessor) {
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, at, sizeof value);
    const auto wide = static_cast<double>(value);
    if constexpr (std::is_integral_v<T>) {
      if (accessor.normalized) return wide / static_cast<double>(std::numeric_limits<T>::max());
    }
    return wide;
  };
  switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT: return as(float{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return as(std::uint32_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return as(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT: return as(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return as(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_BYTE: return as(std::int8_t{});
    default: return 0;
  }
}

}  // namespace

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix out{};
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t k = 0; k < 4; ++k) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    }
  }
  return out;
}

Matrix matrix_of(const tinygltf::Node& node) {
  Matrix m = kIdentity;
  if (node.matrix.size() == 16) {
    std::copy(node.matrix.begin(), node.matrix.end(), m.begin());
    return m;
  }
  if (node.rotation.size() == 4) {
    const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
    m = {1 - 2 * (y * y + z * z),
         2 * (x * y + z * w),
         2 * (x * z - y * w),
         0,
         2 * (x * y - z * w),
         1 - 2 * (x * x + z * z),
         2 * (y * z + x * w),
         0,
         2 * (x * z + y * w),
         2 * (y * z - x * w),
         1 - 2 * (x * x + y * y),
         0,
         0,
         0,
         0,
         1};
  }
  for (std::size_t c = 0; node.scale.size() == 3 && c < 3; ++c) {
    for (std::size_t r = 0; r < 3; ++r) m[4 * c + r] *= node.scale[c];
  }
  for (std::size_t r = 0; node.translation.size() == 3 && r < 3; ++r) m[12 + r] = node.translation[r];
  return m;
}

Result<std::vector<double>> accessor_numbers(const tinygltf::Model& file, int accessor_number, std::size_t width, std::size_t most) {
  const auto wrong = [] { return fail(ErrorCode::kParse, "its buffers are shorter than it says"); };
  if (accessor_number < 0 || static_cast<std::size_t>(accessor_number) >= file.accessors.size()) return wrong();
  const tinygltf::Accessor& accessor = file.accessors[static_cast<std::size_t>(accessor_number)];
  if (accessor.count > most) return fail(ErrorCode::kTooLarge, "it has too many vertices");
  if (accessor.bufferView < 0) return std::vector<double>(accessor.count * width, 0.0);
  if (static_cast<std::size_t>(accessor.bufferView) >= file.bufferViews.size()) return wrong();
  const tinygltf::BufferView& view = file.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= file.buffers.size()) return wrong();
  const auto& bytes = file.buffers[static_cast<std::size_t>(view.buffer)].data;
  const int each = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
  const int stride = accessor.ByteStride(view);
  if (each <= 0 || stride <= 0) return wrong();
  const auto size = static_cast<std::size_t>(each), step = static_cast<std::size_t>(stride);
  if (view.byteOffset > bytes.size() || accessor.byteOffset > bytes.size()) return wrong();
  const std::size_t first = view.byteOffset + accessor.byteOffset;
  if (accessor.count > 0 && first + step * (accessor.count - 1) + size * width > bytes.size()) return wrong();
  std::vector<double> out(accessor.count * width);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    for (std::size_t k = 0; k < width; ++k) out[i * width + k] = number(&bytes[first + i * step + k * size], accessor);
  }
  return out;
}

}  // namespace layoutbox
