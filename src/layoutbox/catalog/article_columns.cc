#include "layoutbox/catalog/article_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "layoutbox/base/words.h"
#include "layoutbox/scene/quirks.h"

namespace layoutbox {
namespace {

struct ColumnNames {
  Column column;
  std::string_view names;  // keys between spaces
};
constexpr ColumnNames kColumns[] = {
    {Column::kId,
     " id sku article articleid articlenumber articleno itemid itemno itemnumber code productid productcode catalogid ref reference number "
     "no "},
    {Column::kCategory, " category categories type kind class furniture furnituretype itemtype producttype group "},
    {Column::kName, " name title product productname description label model item "},
    {Column::kWidth, " width w wide breadth sizex "},
    {Column::kDepth, " depth d deep sizey "},
    {Column::kHeight, " height h high tall sizez "},
    {Column::kLength, " length l len long "},
    {Column::kSize, " dims dim dimensions dimension size sizes measurements measures wxdxh wdh boundingbox "},
    {Column::kColor, " color colour colors colours finish "},
    {Column::kMaterial, " material materials matoverride "},
    {Column::kStyle, " style styles attributes tags features "},
    {Column::kStock, " stock quantity qty count available instock pieces "},
    {Column::kMesh, " mesh model3d file glb gltf obj meshfile path "},
    {Column::kMeshFront, " meshfront front facing "},
    {Column::kUnits, " units unit lengthunit "},
    {Column::kSource, " source price cost currency url link image brand supplier vendor weight "},
};

}  // namespace

bool is_one_figure(Column column) { return (column >= Column::kWidth && column <= Column::kSize) || column == Column::kStock; }

Header header_of(std::string_view written) {
  Header header;
  std::string key;
  std::vector<std::string> words = words_of(written);
  for (const std::string& word : words) {
    const bool is_unit = words.size() > 1 && metres_per_unit(word) && word != "in";
    if (is_unit || (word == "in" && words.size() > 1 && word == words.back()))
      header.unit = word;
    else if (word != "in")
      key += word;
  }
  for (const ColumnNames& names : kColumns) {
    if (names.names.find(" " + key + " ") != std::string_view::npos && !key.empty()) header.column = names.column;
  }
  return header;
}

std::optional<Length> length_from(std::string text) {
  Length length;
  length.text = text;
  if (std::ranges::count(text, ',') == 1 && text.find('.') == std::string::npos) std::ranges::replace(text, ',', '.');
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length.value);
  if (error != std::errc{} || !std::isfinite(length.value)) return std::nullopt;
  for (const char* c = end; c != text.data() + text.size(); ++c) {
    if (*c != ' ') length.unit += *c;
  }
  if (!metres_per_unit(length.unit)) return std::nullopt;
  const std::string_view number(text.data(), static_cast<std::size_t>(end - text.data()));
  const std::size_t sign = number.find('.');
  if (sign > 0 && sign <= 3 && number.size() == sign + 4 && number[0] != '0' && number[0] != '-') {
    length.grouped = std::round(length.value * 1000);
  }
  return length;
}

std::vector<std::string> split_size(std::string_view text) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with("×")) {
      parts.emplace_back();
      i += std::string_view("×").size() - 1;
    } else if (text[i] == 'x' || text[i] == 'X' || text[i] == '*') {
      parts.emplace_back();
    } else if (text[i] != ' ' || !parts.back().empty()) {
      parts.back() += text[i];
    }
  }
  return parts;
}

}  // namespace layoutbox
