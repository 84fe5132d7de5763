#include "layoutbox/catalog/pack.h"

#include <cassert>
#include <cstring>
#include <tuple>
#include <type_traits>

namespace layoutbox {
namespace {

// One description of every type serves both ways: `Archive` is a Packer or an Unpacker.
template <class Archive, class T>
void describe(Archive& archive, T& value);

class Packer {
 public:
  static constexpr bool kReads = false;
  void bytes(const void* data, std::size_t size) { out_.append(static_cast<const char*>(data), size); }
  std::uint32_t count(std::size_t size) {
    const auto count = static_cast<std::uint32_t>(size);
    bytes(&count, sizeof count);
    return count;
  }
  void text(const std::string& value) { out_.append(value, 0, count(value.size())); }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

class Unpacker {
 public:
  static constexpr bool kReads = true;
  explicit Unpacker(std::string_view in) : in_(in) {}
  void bytes(void* data, std::size_t size) {
    assert(in_.size() >= size);
    std::memcpy(data, in_.data(), size);
    in_.remove_prefix(size);
  }
  std::uint32_t count(std::size_t) {
    std::uint32_t count = 0;
    bytes(&count, sizeof count);
    return count;
  }
  void text(std::string& value) {
    const std::size_t size = count(0);
    value.assign(in_.substr(0, size));
    in_.remove_prefix(size);
  }

 private:
  std::string_view in_;
};

template <class Archive, class T>
void members(Archive& archive, T&& first) {
  describe(archive, first);
}
template <class Archive, class T, class... Rest>
void members(Archive& archive, T&& first, Rest&&... rest) {
  describe(archive, first);
  members(archive, rest...);
}

// Most of the four factors are 0: a byte says which are not.
template <class Archive, class Formula>
void describe_formula(Archive& archive, Formula& formula) {
  std::array parts{&formula.w, &formula.d, &formula.h, &formula.constant};
  unsigned char mask = 0;
  if constexpr (!Archive::kReads) {
    for (std::size_t i = 0; i < parts.size(); ++i) mask = static_cast<unsigned char>(mask | ((*parts[i] != 0) << i));
  }
  archive.bytes(&mask, 1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if ((mask >> i) & 1) archive.bytes(parts[i], sizeof(double));
  }
}

template <class Archive, class T>
void describe_vector(Archive& archive, std::vector<T>& values) {
  values.resize(archive.count(values.size()));
  for (T& value : values) describe(archive, value);
}
template <class Archive, class T>
void describe_vector(Archive& archive, const std::vector<T>& values) {
  archive.count(values.size());
  for (const T& value : values) describe(archive, value);
}

template <class Archive, class Map>
void describe_map(Archive& archive, Map& map) {
  const std::uint32_t count = archive.count(map.size());
  if constexpr (Archive::kReads) {
    for (std::uint32_t i = 0; i < count; ++i) {
      std::pair<typename Map::key_type, typename Map::mapped_type> item;
      members(archive, item.first, item.second);
      map.insert(map.end(), std::move(item));
    }
  } else {
    for (const auto& [key, value] : map) members(archive, key, value);
  }
}

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsMap : std::false_type {};
template <class K, class V>
struct IsMap<std::map<K, V>> : std::true_type {};

template <class Archive, class T>
void describe(Archive& archive, T& value) {
  using Plain = std::remove_const_t<T>;
  if constexpr (std::is_arithmetic_v<Plain> || std::is_enum_v<Plain> || std::is_same_v<Plain, Traits> || std::is_same_v<Plain, Size> ||
                std::is_same_v<Plain, SizeRange>) {
    archive.bytes(&value, sizeof value);
  } else if constexpr (std::is_same_v<Plain, std::string>) {
    archive.text(value);
  } else if constexpr (IsVector<Plain>::value) {
    describe_vector(archive, value);
  } else if constexpr (IsMap<Plain>::value) {
    describe_map(archive, value);
  } else if constexpr (std::is_same_v<Plain, LinearFormula>) {
    describe_formula(archive, value);
  } else if constexpr (std::is_same_v<Plain, SpaceFormula>) {
    members(archive, value.name, value.min[0], value.min[1], value.min[2], value.max[0], value.max[1], value.max[2], value.carries);
  } else if constexpr (std::is_same_v<Plain, SizeVariant>) {
    members(archive, value.words, value.size, value.spaces);
  } else if constexpr (std::is_same_v<Plain, CatalogEntry>) {
    // All by name, so that a new member that is not packed does not compile; articles are the user's, never packed.
    auto& [id, name, synonyms, kind_of, traits, traits_lacked, size, variants, mount, used_sides, has_front, back_to_wall, thin, lain_on,
           top_carries, clearance, hang_height, spaces, stands_on, faces, beside, rooms, shape, source, article, stock, article_material,
           article_mesh, article_mesh_front, article_attributes] = value;
    static_cast<void>(std::tie(traits_lacked, article, stock, article_material, article_mesh, article_mesh_front, article_attributes));
    members(archive, id, name, synonyms, kind_of, traits, size, variants, mount, used_sides, has_front, back_to_wall, thin, lain_on,
            top_carries, clearance, hang_height, spaces, stands_on, faces, beside, rooms, shape.family, shape.symbol, shape.numbers,
            shape.words, source);
  } else if constexpr (std::is_same_v<Plain, RoomKind>) {
    auto& [id, name, synonyms, usual_size, usual, needs, door] = value;
    members(archive, id, name, synonyms, usual_size, usual, needs, door);
  } else {
    members(archive, value.first, value.second);  // a pair
  }
}

}  // namespace

std::string pack_catalog(const CatalogData& data, const CatalogIndex& index) {
  Packer packer;
  members(packer, data.entries, data.rooms, index.ids, index.words, index.room_words);
  return packer.take();
}

void unpack_catalog(std::string_view bytes, CatalogData& data, CatalogIndex& index) {
  Unpacker unpacker(bytes);
  members(unpacker, data.entries, data.rooms, index.ids, index.words, index.room_words);
}

}  // namespace layoutbox
