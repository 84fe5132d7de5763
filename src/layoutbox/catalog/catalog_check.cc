// What the schema of the catalogue cannot say.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/catalog_json.h"

namespace layoutbox {
namespace {

class Checker {
 public:
  explicit Checker(const CatalogData& data) : data_(data) {}

  std::vector<Error> check() {
    for (const CatalogEntry& entry : data_.entries) {
      if (!ids_.insert(entry.id).second) add(ErrorCode::kReference, entry.id, "the id is used twice");
    }
    for (const CatalogEntry& entry : data_.entries) check_entry(entry);
    for (const RoomKind& room : data_.rooms) {
      if (!rooms_.insert(room.id).second) add(ErrorCode::kReference, room.id, "the room's id is used twice");
    }
    for (const CatalogEntry& entry : data_.entries) {
      if (rooms_.empty()) break;
      for (const std::string& room : entry.rooms) {
        if (!rooms_.contains(room)) add(ErrorCode::kReference, entry.id, fmt::format("rooms names \"{}\", which is no room", room));
      }
    }
    for (const RoomKind& room : data_.rooms) {
      for (const auto& item : room.usual) check_name(room.id, "usual", item.first);
      for (const auto& row : room.needs) {
        for (const std::string& id : row) check_name(room.id, "needs", id);
      }
    }
    return std::move(errors_);
  }

 private:
  void check_entry(const CatalogEntry& entry) {
    check_word(entry, entry.id);
    check_word(entry, entry.name);
    for (const std::string& word : entry.synonyms) check_word(entry, word);
    if (!entry.kind_of.empty()) check_name(entry.id, "kindOf", entry.kind_of);
    for (const std::string& id : entry.stands_on) check_name(entry.id, "standsOn", id);
    for (const std::string& id : entry.faces) check_name(entry.id, "faces", id);
    for (const std::string& id : entry.beside) check_name(entry.id, "beside", id);
    check_shape(entry);
    check_range(entry, entry.size);
    for (const SizeVariant& variant : entry.variants) check_range(entry, variant.size);
    for (const SpaceFormula& space : entry.spaces) {
      for (const Size& size : {entry.size.least, entry.size.usual, entry.size.greatest}) check_space(entry, space, size);
    }
    if (entry.thin && entry.size.greatest.height > 30) add(ErrorCode::kGeometry, entry.id, "thin things are at most 0.03 m high");
  }

  void check_word(const CatalogEntry& entry, const std::string& word) {
    const auto [place, inserted] = words_.emplace(key_of(word), entry.id);
    if (!inserted && place->second != entry.id) {
      add(ErrorCode::kReference, entry.id, fmt::format("\"{}\" already means \"{}\"", word, place->second));
    }
  }

  void check_name(const std::string& id, std::string_view member, const std::string& name) {
    if (!ids_.contains(name)) add(ErrorCode::kReference, id, fmt::format("{} names \"{}\", which is no entry", member, name));
  }

  void check_shape(const CatalogEntry& entry) {
    if (data_.families.empty()) return;
    const auto family = data_.families.find(entry.shape.family);
    if (family == data_.families.end()) {
      add(ErrorCode::kReference, entry.id, fmt::format("there is no family of shapes \"{}\"", entry.shape.family));
      return;
    }
    for (const auto& [name, value] : entry.shape.numbers) {
      const auto number = family->second.numbers.find(name);
      if (number == family->second.numbers.end()) {
        add(ErrorCode::kReference, entry.id, fmt::format("shapes of the family \"{}\" have no \"{}\"", family->first, name));
      } else if (value < number->second.least || value > number->second.most) {
        add(ErrorCode::kGeometry, entry.id,
            fmt::format("{} = {} is not within {} to {}", name, value, number->second.least, number->second.most));
      }
    }
    for (const auto& [name, value] : entry.shape.words) check_shape_word(entry, family->second, name, value);
  }

  void check_shape_word(const CatalogEntry& entry, const ShapeFamily& family, const std::string& name, const std::string& value) {
    const auto own = family.words.find(name), common = data_.shape_words.find(name);
    if (own == family.words.end() && common == data_.shape_words.end()) {
      add(ErrorCode::kReference, entry.id, fmt::format("shapes of the family \"{}\" have no word \"{}\"", entry.shape.family, name));
    } else if (const auto& values = (own == family.words.end() ? common : own)->second.values;
               !values.empty() && std::ranges::find(values, value) == values.end()) {
      add(ErrorCode::kReference, entry.id, fmt::format("{} is \"{}\", none of {}", name, value, fmt::join(values, ", ")));
    }
  }

  void check_range(const CatalogEntry& entry, const SizeRange& range) {
    for (const auto side : {&Size::width, &Size::depth, &Size::height}) {
      if (range.least.*side <= 0 || range.least.*side > range.usual.*side || range.usual.*side > range.greatest.*side) {
        add(ErrorCode::kGeometry, entry.id, "a size is not in the order least, usual, greatest");
      }
    }
  }

  void check_space(const CatalogEntry& entry, const SpaceFormula& space, const Size& size) {
    const std::array<double, 3> low{-size.width / 2.0, -size.depth / 2.0, 0}, high{size.width / 2.0, size.depth / 2.0, double(size.height)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double min = space.min[axis].at(size), max = space.max[axis].at(size);
      if (min >= max || min < low[axis] - 0.5 || max > high[axis] + 0.5) {
        add(ErrorCode::kGeometry, entry.id,
            fmt::format("the space \"{}\" spans {:.3f} to {:.3f} m along {} at {:.2f} x {:.2f} x {:.2f} m, outside its box or empty",
                        space.name, min / 1000, max / 1000, "xyz"[axis], size.width / 1000.0, size.depth / 1000.0, size.height / 1000.0));
        return;
      }
    }
  }

  void add(ErrorCode code, const std::string& id, std::string message) {
    errors_.push_back({code, fmt::format("\"{}\": {}", id, message), {}, {}, {}});
  }

  const CatalogData& data_;
  std::set<std::string> ids_, rooms_;
  std::map<std::string, std::string> words_;
  std::vector<Error> errors_;
};

}  // namespace

std::vector<Error> check_catalog_data(const CatalogData& data) { return Checker(data).check(); }

}  // namespace layoutbox
