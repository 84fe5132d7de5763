#include "layoutbox/catalog/dressing.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox {
namespace {

using NameList = std::vector<std::string>;

NameList names_in(const nlohmann::json& value, const char* key) { return value.value(key, NameList{}); }

Mm length_in(const nlohmann::json& value, const char* key) { return mm_from_m(value.value(key, 0.0)); }

using Sets = std::map<std::string, NameList>;

// Names, of which one may stand for a set of them.
NameList names_in(const nlohmann::json& value, const char* key, const Sets& sets) {
  NameList names;
  for (const std::string& name : names_in(value, key)) {
    const auto set = sets.find(name);
    if (set == sets.end()) {
      names.push_back(name);
    } else {
      std::ranges::copy(set->second, std::back_inserter(names));
    }
  }
  return names;
}

// Each kind's grade: of how many kinds of things a text may speak so that it comes.
std::map<std::string, int> grades_in(const nlohmann::json& data) {
  std::map<std::string, int> few;
  for (const auto& grade : data.at("grades")) {
    for (const std::string& kind : names_in(grade, "adds")) few[kind] = grade.at("few").get<int>();
  }
  return few;
}

Dressings read_dressings() {
  const auto data = nlohmann::json::parse(embedded::dress_json);
  const auto sets = data.at("sets").get<Sets>();
  const auto grades = grades_in(data);
  Dressings dressings;
  for (const auto& row : data.at("rows")) {
    Dressing dressing;
    dressing.place = row.at("place").get<std::string>();
    dressing.adds = row.at("adds").get<std::string>();
    dressing.words = names_in(row, "words");
    dressing.of = names_in(row, "of");
    dressing.rooms = names_in(row, "rooms", sets);
    dressing.unless = names_in(row, "unless");
    dressing.unspoken = names_in(row, "unspoken");
    dressing.with = names_in(row, "with");
    dressing.said = names_in(row, "said", sets);
    dressing.unsaid = names_in(row, "unsaid", sets);
    dressing.lifted = names_in(row, "lifted");
    dressing.most = row.value("most", 1);
    dressing.size = {length_in(row, "w"), length_in(row, "d"), length_in(row, "h")};
    dressing.stretch = length_in(row, "stretch");
    dressing.before = length_in(row, "before");
    dressing.area_m2 = row.value("area", 0.0);
    if (const auto grade = grades.find(dressing.adds); grade != grades.end()) dressing.few = grade->second;
    dressings.rows.push_back(std::move(dressing));
  }
  dressings.dressed = names_in(data, "dressed");
  dressings.rehung = names_in(data, "rehung");
  for (const auto& theme : data.at("themes")) {
    dressings.themes.push_back(
        {names_in(theme, "said", sets), names_in(theme, "rooms", sets), names_in(theme, "without", sets), names_in(theme, "places")});
  }
  for (const auto& form : data.at("kitchenForms")) {
    dressings.kitchen_forms.push_back({form.at("form").get<std::string>(), names_in(form, "words")});
  }
  return dressings;
}

}  // namespace

const Dressings& Dressings::builtin() {
  static const Dressings dressings = read_dressings();
  return dressings;
}

}  // namespace layoutbox
