#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/units.h"
#include "layoutbox/base/words.h"
#include "layoutbox/plan/llm/mend.h"
#include "layoutbox/plan/llm/mend_text.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

constexpr double kFarTooLarge = 2.5;  // times the greatest of the catalogue

class ObjectMender {
 public:
  ObjectMender(json& scene, const Catalog& catalog, Notes& notes) : scene_(scene), catalog_(catalog), notes_(notes) {}

  // Ids as they were written, and as they are now.
  const std::map<std::string, std::string>& renamed() const { return renamed_; }

  void run() {
    json& furniture = scene_["furniture"];
    for (std::size_t i = 0; i < furniture.size();) {
      if (furniture[i].is_string()) furniture[i] = json{{"category", furniture[i]}};  // ["bed", "desk"]
      if (furniture[i].is_object() && !is_nothing_special(furniture[i])) {
        ++i;
        continue;
      }
      note(notes_, "something that is no piece of furniture is left out", fmt::format("/furniture/{}", i));
      furniture.erase(i);
    }
    for (std::size_t i = 0; i < furniture.size(); ++i) mend(furniture[i], fmt::format("/furniture/{}", i));
  }

 private:
  // A "furniture_3" that is no kind of thing: small models fill lists with such.
  static bool is_nothing_special(const json& object) {
    static const std::set<std::string> general = {"furniture", "furnitures", "object", "thing", "item", "category", "piece", "unknown"};
    const auto is_general = [](const std::string& text) { return text.empty() || general.contains(without_number(snake_case(text))); };
    return !text_of(object, "category").empty() && is_general(text_of(object, "category")) && is_general(text_of(object, "name"));
  }

  void mend(json& object, const std::string& at) {
    settle_category(object, at);
    settle_id(object, at);
    for (const char* key : {"name", "catalogId", "matOverride"}) clean_text(object, key, at, notes_);
    if (object.contains("attributes") && object["attributes"].is_array()) {
      for (json& attribute : object["attributes"]) {
        if (attribute.is_string()) attribute = clean_name(attribute.get<std::string>());
      }
    }
    for (const char* key : {"mesh", "meshFront", "fixed", "spaces"}) {  // a model names no files and nails nothing down
      if (object.erase(key) > 0) note(notes_, fmt::format("\"{}\" is left out: no model decides that", key), at);
    }
    drop_impossible_size(object, at);
  }

  void settle_category(json& object, const std::string& at) {
    std::string category = text_of(object, "category");
    if (category.empty()) {
      category = text_of(object, "name");
      if (category.empty()) category = without_number(text_of(object, "id"));
      if (category.empty()) return;
      note(notes_, fmt::format("no category is given: taken for \"{}\"", clean_name(category)), at);
    }
    std::string cleaned = snake_case(clean_name(category));
    if (catalog_.find(category) != nullptr) cleaned = category;
    const std::string without = without_number(cleaned);  // "desk_2"
    if (catalog_.find_by_words(cleaned) == nullptr && catalog_.find_by_words(without) != nullptr) cleaned = without;
    // What is not in the catalogue but nearly.
    if (const CatalogEntry* entry = catalog_.find(cleaned) != nullptr ? nullptr : catalog_.find_by_words(cleaned); entry != nullptr) {
      note(notes_, fmt::format("the category \"{}\" is read as {}", clean_name(category), entry->id), at);
      if (text_of(object, "name").empty()) object["name"] = clean_name(category);
      cleaned = entry->id;
    }
    if (cleaned.empty()) {
      object.erase("category");
      return;
    }
    object["category"] = cleaned;
  }

  static std::string without_number(std::string id) {
    while (!id.empty() && (std::isdigit(static_cast<unsigned char>(id.back())) != 0 || id.back() == '_' || id.back() == '-')) id.pop_back();
    return id;
  }

  void settle_id(json& object, const std::string& at) {
    const std::string written = text_of(object, "id");
    std::string id = clean_id(written);
    if (id.empty()) id = unused(text_of(object, "category").empty() ? "object" : text_of(object, "category"));
    if (ids_.contains(key_of(id))) {
      const std::string other = unused(without_number(id).empty() ? id : without_number(id));
      note(notes_, fmt::format("the id \"{}\" is used twice: the second is now {}", id, other), at);
      id = other;
    } else if (id != written) {
      if (!written.empty()) renamed_[written] = id;
      note(notes_, fmt::format("the id is now {}", id), at);
    }
    ids_.insert(key_of(id));
    object["id"] = id;
  }

  std::string unused(const std::string& stem) const {
    for (int number = 1;; ++number) {
      std::string id = fmt::format("{}_{}", stem, number);
      const bool later =
          std::ranges::any_of(scene_["furniture"], [&](const json& other) { return other.is_object() && text_of(other, "id") == id; });
      if (!ids_.contains(key_of(id)) && !later) return id;
    }
  }

  // A lamp of 4 x 2 x 3 m was copied from the room.
  void drop_impossible_size(json& object, const std::string& at) {
    const auto dims = object.find("dims");
    if (dims == object.end() || !dims->is_object()) return;
    const CatalogEntry& entry = catalog_.entry_or_nearest(text_of(object, "category"));
    if (catalog_.find_by_words(text_of(object, "category")) == nullptr) return;  // of an unknown thing nothing is known
    const std::pair<const char*, Mm> greatest[] = {{"w", std::max(entry.size.greatest.width, entry.size.greatest.depth)},
                                                   {"d", std::max(entry.size.greatest.width, entry.size.greatest.depth)},
                                                   {"h", entry.size.greatest.height}};
    for (const auto& [key, most] : greatest) {
      if (!dims->contains(key) || !(*dims)[key].is_number()) continue;
      const double metres = (*dims)[key].get<double>();
      if (metres <= kFarTooLarge * m_from_mm(most)) continue;
      note(notes_,
           fmt::format("{:g} m is no size of a {} (at most {:g} m): the catalogue's size is taken", metres, entry.name, m_from_mm(most)),
           at + "/dims");
      object.erase("dims");
      return;
    }
  }

  json& scene_;
  const Catalog& catalog_;
  Notes& notes_;
  std::set<std::string> ids_;  // keys of those settled
  std::map<std::string, std::string> renamed_;
};

void replace_names(json& value, const std::map<std::string, std::string>& renamed) {
  if (value.is_array()) {
    for (json& item : value) replace_names(item, renamed);
  } else if (value.is_string()) {
    if (const auto found = renamed.find(value.get<std::string>()); found != renamed.end()) value = found->second;
  }
}

// Small models write the same thing, and the same word, until a list is full. A few that are alike in all, the id included, may be meant to
// be as many; more are one.
void drop_repeats(json& furniture, Notes& notes) {
  constexpr int kMostAlike = 4;
  constexpr std::size_t kMostWords = 1000;
  std::map<std::string, int> alike;
  for (const json& object : furniture) ++alike[object.dump(-1, ' ', false, json::error_handler_t::replace)];
  json kept = json::array();
  for (json& object : furniture) {
    int& count = alike[object.dump(-1, ' ', false, json::error_handler_t::replace)];
    if (count == 0) continue;  // one of many that was taken before
    if (count > kMostAlike) count = 0;
    kept.push_back(std::move(object));
  }
  if (const std::size_t repeats = furniture.size() - kept.size(); repeats > 0) {
    note(notes, fmt::format("things that were written several times, alike in all, are taken once: {} left out", repeats), "/furniture");
  }
  furniture = std::move(kept);
  for (json& object : furniture) {
    if (!object.is_object() || !object.contains("attributes") || !object["attributes"].is_array()) continue;
    if (object["attributes"].size() > kMostWords) continue;  // too many to be looked through
    json words = json::array();
    for (json& word : object["attributes"]) {
      if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(std::move(word));
    }
    object["attributes"] = std::move(words);
  }
}

}  // namespace

void mend_objects(json& scene, const Catalog& catalog, Notes& notes) {
  if (!scene.is_object()) return;
  if (!scene.contains("furniture") || !scene["furniture"].is_array()) return;
  drop_repeats(scene["furniture"], notes);
  ObjectMender mender(scene, catalog, notes);
  mender.run();
  if (scene.contains("constraints") && scene["constraints"].is_array()) {
    for (json& relation : scene["constraints"]) {
      if (!relation.is_object()) continue;
      for (const char* key : {"targets", "relativeTo"}) {
        if (relation.contains(key)) replace_names(relation[key], mender.renamed());
      }
      clean_text(relation, "why", "/constraints", notes);
    }
  }
}

}  // namespace layoutbox::llm
