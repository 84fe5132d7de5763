#include "layoutbox/catalog/article_columns.h"
#include "layoutbox/catalog/user_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/csv.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/quirks.h"
#include "layoutbox/scene/scene_check.h"

namespace layoutbox {
namespace {

using nlohmann::json;

constexpr std::size_t kMostArticles = 20'000;
constexpr double kLargestMetres = 50;

// An article as it is written: lengths still in its own units.
struct RawArticle {
  Article article;
  std::optional<Length> width, depth, height, length;
  std::string pointer;
};

class CatalogReader {
 public:
  explicit CatalogReader(std::string_view units) : units_(units) {}

  Result<UserCatalog> read(std::string_view text) {
    if (!metres_per_unit(units_))
      return fail(ErrorCode::kUsage, fmt::format("\"{}\" is no unit of length", units_), {}, "give m, cm, mm, ft or in");
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first == std::string_view::npos)
      return fail(ErrorCode::kParse, "the catalogue is empty", {}, "give a JSON list or a CSV table with a header");
    const Status status = text[first] == '{' || text[first] == '[' ? read_json(text) : read_table(text);
    if (!status) return Failure(status.error());
    finish();
    if (!errors_.empty()) return Failure(combined(std::move(errors_)));
    return std::move(catalog_);
  }

 private:
  void add_error(ErrorCode code, std::string message, std::string pointer, std::string hint) {
    constexpr std::size_t kMostErrors = 100;
    if (errors_.size() < kMostErrors) errors_.push_back({code, std::move(message), std::move(pointer), std::move(hint), {}});
  }

  Status read_table(std::string_view text) {
    LAYOUTBOX_ASSIGN(const std::vector<CsvRow> rows, read_csv(text));
    if (rows.empty()) return fail(ErrorCode::kParse, "the catalogue is empty", {}, "give a JSON list or a CSV table with a header");
    std::vector<Header> headers;
    for (const std::string& name : rows[0].fields) {
      headers.push_back(header_of(name));
      if (headers.back().column == Column::kUnknown) note_unknown(name, "line 1");
    }
    for (std::size_t k = 0; k < headers.size(); ++k) {
      for (std::size_t i = 0; i < k; ++i) {
        if (headers[i].column != headers[k].column || !is_one_figure(headers[k].column)) continue;
        return fail(ErrorCode::kSchema,
                    fmt::format("line 1: the columns \"{}\" and \"{}\" say the same", rows[0].fields[i], rows[0].fields[k]), "line 1",
                    "leave one of them out");
      }
    }
    const auto has = [&](Column column) { return std::ranges::any_of(headers, [&](const Header& h) { return h.column == column; }); };
    if (!has(Column::kCategory) && !has(Column::kName)) {
      return fail(ErrorCode::kSchema, "line 1: no column says what the articles are", "line 1", "name one of the columns \"category\"");
    }
    for (std::size_t i = 1; i < rows.size(); ++i) {
      RawArticle& raw = add_article(fmt::format("line {}", rows[i].line));
      for (std::size_t k = 0; k < headers.size(); ++k) {
        if (!rows[i].fields[k].empty()) set(raw, headers[k], rows[i].fields[k], raw.pointer);
      }
    }
    return {};
  }

  Status read_json(std::string_view text) {
    LAYOUTBOX_ASSIGN(json document, parse_json(text));
    drop_nulls(document);
    std::string at;
    const json* list = &document;
    if (document.is_object()) {
      for (const char* key : {"items", "furniture", "catalog", "catalogue", "products", "articles", "entries"}) {
        if (!document.contains(key)) continue;
        list = &document.at(key);
        at = std::string("/") + key;
      }
      if (units_.empty() && document.contains("units") && document["units"].is_string()) units_ = document["units"].get<std::string>();
      if (!metres_per_unit(units_))
        return fail(ErrorCode::kSchema, fmt::format("\"{}\" is no unit of length", units_), "/units", "give m, cm, mm, ft or in");
    }
    if (!list->is_array())
      return fail(ErrorCode::kSchema, "the catalogue is no list of articles", at,
                  "give a list of objects with category, width, depth, height");
    for (std::size_t i = 0; i < list->size(); ++i) {
      const json& item = (*list)[i];
      RawArticle& raw = add_article(fmt::format("{}/{}", at, i));
      if (!item.is_object()) {
        add_error(ErrorCode::kSchema, fmt::format("{} is no object", raw.pointer), raw.pointer,
                  "give an object with category, width, depth, height");
        continue;
      }
      for (const auto& [key, value] : item.items()) set_member(raw, key, value);
    }
    return {};
  }

  void set_member(RawArticle& raw, const std::string& key, const json& value) {
    const Header header = header_of(key);
    const std::string pointer = raw.pointer + "/" + key;
    if (header.column == Column::kUnknown) {
      note_unknown(key, raw.pointer);
    } else if (value.is_object()) {
      for (const auto& [inner, part] : value.items()) {
        if (part.is_primitive()) set(raw, header_of(inner), text_of(part), pointer + "/" + inner);
      }
    } else if (value.is_array() && header.column == Column::kSize && value.size() == 3) {
      set(raw, {Column::kWidth, header.unit}, text_of(value[0]), pointer + "/0");
      set(raw, {Column::kDepth, header.unit}, text_of(value[1]), pointer + "/1");
      set(raw, {Column::kHeight, header.unit}, text_of(value[2]), pointer + "/2");
    } else if (value.is_array()) {
      for (const json& part : value) set(raw, header, text_of(part), pointer);
    } else {
      set(raw, header, text_of(value), pointer);
    }
  }

  static std::string text_of(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

  void note_unknown(const std::string& name, const std::string& pointer) {
    if (unknown_.insert(name).second)
      catalog_.notes.push_back({"ignored", fmt::format("the catalogue's \"{}\" is not read", name), pointer});
  }

  RawArticle& add_article(std::string pointer) {
    raw_.emplace_back();
    raw_.back().pointer = std::move(pointer);
    return raw_.back();
  }

  void set(RawArticle& raw, const Header& header, const std::string& text, const std::string& pointer) {
    Article& article = raw.article;
    switch (header.column) {
      case Column::kId: article.id = text; break;
      case Column::kCategory: article.category = text; break;
      case Column::kName: article.name = text; break;
      case Column::kWidth: set_length(raw.width, header, text, pointer); break;
      case Column::kDepth: set_length(raw.depth, header, text, pointer); break;
      case Column::kHeight: set_length(raw.height, header, text, pointer); break;
      case Column::kLength: set_length(raw.length, header, text, pointer); break;
      case Column::kSize: set_size(raw, header, text, pointer); break;
      case Column::kColor:
      case Column::kStyle: article.attributes.push_back(text); break;
      case Column::kMaterial: article.material = text; break;
      case Column::kMesh: article.mesh = text; break;
      case Column::kMeshFront: article.mesh_front = text; break;
      case Column::kStock: set_stock(article, text, pointer); break;
      case Column::kUnits:
      case Column::kSource:
      case Column::kUnknown: break;
    }
  }

  void set_length(std::optional<Length>& side, const Header& header, const std::string& text, const std::string& pointer) {
    side = length_from(text);
    if (!side)
      return add_error(ErrorCode::kParse, fmt::format("{}: \"{}\" is no length", pointer, text), pointer,
                       "give a number, with or without a unit");
    if (side->unit.empty()) side->unit = header.unit;
  }

  void set_size(RawArticle& raw, const Header& header, const std::string& text, const std::string& pointer) {
    const std::vector<std::string> parts = split_size(text);
    if (parts.size() != 3)
      return add_error(ErrorCode::kParse, fmt::format("{}: \"{}\" is no size", pointer, text), pointer, "write it as 1.6x2.0x0.5");
    set_length(raw.width, header, parts[0], pointer);
    set_length(raw.depth, header, parts[1], pointer);
    set_length(raw.height, header, parts[2], pointer);
    // "160x200x50 cm": the unit behind the last counts for all.
    for (std::optional<Length>* side : {&raw.width, &raw.depth}) {
      if (*side && (*side)->unit.empty() && raw.height) (*side)->unit = raw.height->unit;
    }
  }

  void set_stock(Article& article, const std::string& text, const std::string& pointer) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), article.stock);
    if (error == std::errc{} && article.stock >= 0) return;
    add_error(ErrorCode::kParse, fmt::format("{}: \"{}\" is no number of pieces", pointer, text), pointer, "give a whole number");
  }

  // Metres unless somebody said otherwise, or unless that would make a room full of giants.
  std::string unit_by_size() {
    if (!units_.empty()) return units_;
    std::vector<double> lengths;
    for (const RawArticle& raw : raw_) {
      for (const auto& side : {raw.width, raw.depth, raw.height, raw.length}) {
        if (side && side->unit.empty()) lengths.push_back(side->value);
      }
    }
    if (lengths.empty()) return "m";
    std::ranges::nth_element(lengths, lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2));
    const double median = lengths[lengths.size() / 2];
    const std::string unit = median > 300 ? "mm" : median > 10 ? "cm" : "m";
    if (unit != "m") catalog_.notes.push_back({"guessed", fmt::format("the catalogue names no unit: its lengths look like {}", unit), {}});
    return unit;
  }

  void finish() {
    if (raw_.size() > kMostArticles) {
      return add_error(ErrorCode::kTooLarge, fmt::format("the catalogue has {} articles; at most {} are read", raw_.size(), kMostArticles),
                       {}, "leave some out");
    }
    const std::string unit = unit_by_size();
    std::set<std::string> ids;
    for (RawArticle& raw : raw_) {
      Article& article = raw.article;
      if (article.category.empty()) article.category = article.name;
      if (article.name.empty()) article.name = article.category;
      if (words_of(article.category).empty()) {
        add_error(ErrorCode::kSchema, fmt::format("{}: nothing says what this article is", raw.pointer), raw.pointer, "give it a category");
        continue;
      }
      if (article.id.empty()) {
        for (int n = 1; article.id.empty() || ids.contains(article.id); ++n)
          article.id = fmt::format("{}-{}", snake_case(article.category), n);
        catalog_.notes.push_back(
            {"filled", fmt::format("\"{}\" has no article number: {} is given", article.name, article.id), raw.pointer});
      }
      if (!ids.insert(article.id).second) {
        add_error(ErrorCode::kReference, fmt::format("{}: the article number \"{}\" is used twice", raw.pointer, article.id), raw.pointer,
                  "give each article its own");
      }
      // A length is the depth where there is a width, else the width.
      if (raw.length && !raw.width)
        raw.width = raw.length;
      else if (raw.length && !raw.depth)
        raw.depth = raw.length;
      set_side(article.size.width, raw.width, unit, "width", raw.pointer);
      set_side(article.size.depth, raw.depth, unit, "depth", raw.pointer);
      set_side(article.size.height, raw.height, unit, "height", raw.pointer);
      catalog_.articles.push_back(std::move(article));
    }
    note_grouped();
    if (errors_.empty() && catalog_.articles.empty())
      add_error(ErrorCode::kEmpty, "the catalogue has no articles", {}, "give at least one");
  }

  void set_side(Mm& side, const std::optional<Length>& length, const std::string& unit, std::string_view name, const std::string& pointer) {
    if (!length) return;
    const double per_unit = metres_per_unit(length->unit.empty() ? unit : length->unit).value_or(1);
    const double metres = value_in(*length, per_unit, pointer) * per_unit;
    if (!(metres >= 0.001 && metres <= kLargestMetres)) {
      return add_error(ErrorCode::kGeometry, fmt::format("{}: the {} is {:.6g} m", pointer, name, metres), pointer,
                       fmt::format("give more than 0 and at most {} m; is the unit right?", kLargestMetres));
    }
    side = mm_from_m(metres);
  }

  // Nobody measures furniture in thousandths of a millimetre: in "1.600" mm the sign parts thousands.
  double value_in(const Length& length, double metres_per_unit, const std::string& pointer) {
    constexpr double kMillimetre = 0.001;
    if (!length.grouped || metres_per_unit != kMillimetre) return length.value;
    if (grouped_++ == 0) {
      first_grouped_ = fmt::format("\"{}\" in mm is read as {} mm, its sign parting thousands", length.text, *length.grouped);
      grouped_at_ = pointer;
    }
    return *length.grouped;
  }

  void note_grouped() {
    if (grouped_ == 0) return;
    const std::string others = grouped_ == 1 ? "" : fmt::format(", and so are {} more lengths", grouped_ - 1);
    catalog_.notes.push_back({"warning", first_grouped_ + others + "; write it without the sign to be sure", grouped_at_});
  }

  std::size_t grouped_ = 0;  // lengths such as "1.600" in mm
  std::string first_grouped_, grouped_at_;
  std::string units_;
  std::vector<RawArticle> raw_;
  UserCatalog catalog_;
  std::vector<Error> errors_;
  std::set<std::string> unknown_;
};

}  // namespace

Result<UserCatalog> read_user_catalog(std::string_view text, std::string_view units) {
  try {
    return CatalogReader(units).read(text);
  } catch (const std::exception& error) {
    return fail(ErrorCode::kInternal, fmt::format("the catalogue cannot be read: {}", error.what()));
  }
}

}  // namespace layoutbox
