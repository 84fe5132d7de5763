// Lists of words as bytes.
#include <nlohmann/json.hpp>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string count_bytes(std::size_t size) {
  const auto count = static_cast<std::uint32_t>(size);
  std::string bytes(sizeof count, '\0');
  std::memcpy(bytes.data(), &count, sizeof count);
  return bytes;
}

std::string value_bytes(WordList::Kind kind, std::string_view payload) {
  return std::string(1, static_cast<char>(kind)) + count_bytes(payload.size()) + std::string(payload);
}

std::string packed(const OrderedJson& value) {
  std::string payload;
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) payload += pack_member(key, packed(member));
    return pack_object(payload);
  }
  if (value.is_array()) {
    for (const OrderedJson& element : value) payload += packed(element);
    return value_bytes(WordList::Kind::kArray, payload);
  }
  if (value.is_string()) return value_bytes(WordList::Kind::kText, value.get_ref<const std::string&>());
  const double number = value.is_boolean() ? (value.get<bool>() ? 1 : 0) : value.is_number() ? value.get<double>() : 0;
  payload.resize(sizeof number);
  std::memcpy(payload.data(), &number, sizeof number);
  return value_bytes(WordList::Kind::kNumber, payload);
}

}  // namespace

std::string pack_member(std::string_view key, std::string_view packed) {
  return count_bytes(key.size()) + std::string(key) + std::string(packed);
}

std::string pack_object(std::string_view members) { return value_bytes(WordList::Kind::kObject, members); }

std::string pack_words(std::string_view json) {
  const OrderedJson document = OrderedJson::parse(json, nullptr, false);
  return document.is_object() ? packed(document) : std::string();
}

}  // namespace layoutbox
