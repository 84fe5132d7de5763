#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/toppled.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {
namespace {

constexpr Mm kLargestObject = 50'000;
constexpr Mm kScreenShelf = 1200;                     // nobody looks at a screen on something higher
constexpr std::string_view kOnWall = "wall-mounted";  // the variant of what hangs on a wall though it usually stands

// True when what stands before the kind's own words is known to be no kind of its own: "queen" bed, "large wooden" desk.
bool only_adjectives(const CatalogEntry& entry, const SceneObject& object, const std::vector<std::string>& before) {
  return std::ranges::all_of(before, [&](const std::string& word) {
    const bool variant = std::ranges::any_of(entry.variants, [&](const SizeVariant& v) {
      return std::ranges::any_of(v.words, [&](const std::string& phrase) {
        const auto words = words_of(phrase);
        return std::ranges::find(words, word) != words.end();
      });
    });
    const bool attribute = std::ranges::any_of(object.attributes, [&](const std::string& a) { return says(words_of(a), word); });
    return variant || is_size_word(word) || attribute;
  });
}

class ObjectNormalizer {
 public:
  ObjectNormalizer(NormalizeContext& context, std::size_t index)
      : context_(context), object_(context.scene.objects[index]), pointer_(fmt::format("/furniture/{}", index)) {}

  void run() {
    settle_category();
    if (const CatalogEntry* article = choose_article(context_, object_)) take_article(context_, object_, *article, pointer_);
    const CatalogEntry& entry = context_.catalog.entry_or_nearest(object_.category);
    if (!object_.mount) settle_mount(entry);
    settle_size(entry);
    if (is_toppled(object_.attributes, *object_.mount) && !object_.fixed && !object_.hint.position) topple(entry);
    if (hangs_flat(entry, *object_.mount) && object_.size->usual.depth > object_.size->usual.height && !object_.fixed) {
      for (Size* one : {&object_.size->least, &object_.size->usual, &object_.size->greatest}) *one = hung_flat(entry, *one);
    }
    if (!object_.used_sides) object_.used_sides = entry.used_sides;
  }

 private:
  void settle_category() {
    if (object_.name.empty()) object_.name = object_.category;
    std::ranges::replace(object_.name, '_', ' ');
    if (object_.category.empty()) object_.category = object_.name;
    if (context_.catalog.find(object_.category) != nullptr) return;
    const std::string written = object_.category;
    object_.category = snake_case(written);
    if (object_.category.empty()) object_.category = "object";
    const CatalogEntry* entry = context_.catalog.find_by_words(written);
    if (entry != nullptr && is_exactly(*entry, written)) {
      object_.category = entry->id;
      return;
    }
    const CatalogEntry& nearest = context_.catalog.entry_or_nearest(object_.category);
    Note note = unknown_kind_note(object_.name, nearest, pointer_ + "/category");
    // Of a scene from a text the planner has said it already, with the place in the text.
    if (std::ranges::find(context_.scene.notes, note.message, &Note::message) == context_.scene.notes.end())
      context_.scene.notes.push_back(std::move(note));
  }

  // The words mean this entry, with nothing before them but what the entry or the object knows as an attribute.
  bool is_exactly(const CatalogEntry& entry, const std::string& written) {
    const std::vector<std::string> words = words_of(written);
    std::size_t begin = 0;
    while (begin + 1 < words.size() && !key_means(entry, std::span(words).subspan(begin))) ++begin;
    const std::vector<std::string> before(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(begin));
    if (entry.article.empty() && !only_adjectives(entry, object_, before)) return false;
    for (const std::string& word : before) {
      if (std::ranges::find(object_.attributes, word) == object_.attributes.end()) object_.attributes.push_back(word);
    }
    return true;
  }

  static bool key_means(const CatalogEntry& entry, std::span<const std::string> words) {
    for (const std::string& key : candidate_keys(words)) {
      if (key == key_of(entry.id) || key == key_of(entry.name)) return true;
      if (std::ranges::any_of(entry.synonyms, [&](const std::string& s) { return key == key_of(s); })) return true;
    }
    return false;
  }

  void settle_size(const CatalogEntry& entry) {
    std::vector<std::string> said = words_said_of(object_);
    if (object_.mount == Mount::kWall && entry.mount != Mount::kWall)
      std::ranges::copy(words_of(kOnWall), std::back_inserter(said));  // flatter than what stands
    SizeRange usual = size_by_words(entry, said);
    // What nobody knows and what stands on another thing is small.
    constexpr Mm kLeast = 50, kUsual = 150, kGreatest = 300;
    if (entry.id == "object" && object_.mount == Mount::kSurface)
      usual = {{kLeast, kLeast, kLeast}, {kUsual, kUsual, kUsual}, {kGreatest, kGreatest, kGreatest}};
    if (!object_.size) {
      object_.size = usual;
      object_.size_source = SizeSource::kCatalog;
      context_.note(
          "filled",
          fmt::format("\"{}\" has no size: {} is taken from the catalogue's \"{}\"", object_.id, text_of(usual.usual), entry.name),
          pointer_ + "/dims");
    } else {
      fill_sides(entry, usual);
    }
    apply_scale();
    check_size();
  }

  // Nobody uses it, and there is no room in or under it.
  void topple(const CatalogEntry& entry) {
    SizeRange& size = *object_.size;
    for (Size* one : {&size.least, &size.usual, &size.greatest}) *one = toppled(entry, *one);
    object_.used_sides = std::vector<Side>{};
    object_.spaces.clear();
    object_.spaces_given = true;
  }

  // Sides of 0 are not known.
  void fill_sides(const CatalogEntry& entry, const SizeRange& usual) {
    SizeRange& size = *object_.size;
    const bool square = entry.size.least.width == entry.size.least.depth && entry.size.usual.width == entry.size.usual.depth &&
                        entry.size.greatest.width == entry.size.greatest.depth;
    bool filled = false;
    for (const auto side : kSizeSides) {
      if (size.greatest.*side != 0 || size.least.*side != 0 || size.usual.*side != 0) {
        if (size.usual.*side == 0)
          size.usual.*side = std::clamp(usual.usual.*side, size.least.*side, std::max(size.least.*side, size.greatest.*side));
        continue;
      }
      const auto other = side == &Size::width ? &Size::depth : &Size::width;
      const SizeRange& from = square && side != &Size::height && size.usual.*other > 0 ? size : usual;
      const auto from_side = &from == &size ? other : side;
      size.least.*side = from.least.*from_side;
      size.usual.*side = from.usual.*from_side;
      size.greatest.*side = from.greatest.*from_side;
      filled = true;
    }
    if (filled) {
      object_.size_source = SizeSource::kInferred;
      context_.note("filled", fmt::format("a part of the size of \"{}\" is missing: {} is inferred", object_.id, text_of(size.usual)),
                    pointer_ + "/dims");
    } else if (object_.size_source == SizeSource::kUnknown) {
      object_.size_source = SizeSource::kUser;
    }
  }

  void apply_scale() {
    if (object_.scale == std::array<double, 3>{1, 1, 1}) return;
    for (std::size_t i = 0; i < kSizeSides.size(); ++i) {
      for (Size* size : {&object_.size->least, &object_.size->usual, &object_.size->greatest}) {
        size->*kSizeSides[i] = static_cast<Mm>(std::lround(std::clamp(size->*kSizeSides[i] * object_.scale[i], -2e6, 2e6)));
      }
    }
    context_.note("converted", fmt::format("the scale of \"{}\" is worked into its size: {}", object_.id, text_of(object_.size->usual)),
                  pointer_ + "/xform/scale");
    object_.scale = {1, 1, 1};
  }

  void check_size() {
    const SizeRange& size = *object_.size;
    constexpr std::string_view kNames[] = {"width", "depth", "height"};
    for (std::size_t i = 0; i < kSizeSides.size(); ++i) {
      const auto side = kSizeSides[i];
      if (size.least.*side <= 0 || size.greatest.*side > kLargestObject) {
        const Mm bad = size.least.*side <= 0 ? size.least.*side : size.greatest.*side;
        context_.error(ErrorCode::kGeometry, fmt::format("the {} of \"{}\" is {}", kNames[i], object_.id, metres_text(bad)),
                       pointer_ + "/dims", fmt::format("give more than 0 and at most {}; is the unit right?", metres_text(kLargestObject)));
      } else if (size.least.*side > size.usual.*side || size.usual.*side > size.greatest.*side) {
        context_.error(ErrorCode::kGeometry,
                       fmt::format("the {} range of \"{}\" is not in the order least, usual, greatest", kNames[i], object_.id),
                       pointer_ + "/dimsRange");
      }
    }
  }

  // As its kind is mounted; a screen that nothing there carries hangs on a wall.
  Mount usual_mount(const CatalogEntry& entry) const {
    if (entry.mount != Mount::kSurface || !entry.is(Trait::kElseOnWall) || object_.hint.position) return entry.mount;
    const bool carried = std::ranges::any_of(context_.scene.objects, [&](const SceneObject& other) {
      const CatalogEntry& kind = context_.catalog.entry_or_nearest(other.category);
      const auto is_usual = [&](const std::string& host) { return context_.catalog.is_a(kind.id, host); };
      return kind.size.usual.height <= kScreenShelf && std::ranges::any_of(entry.stands_on, is_usual);
    });
    if (carried) return entry.mount;
    context_.note("guessed", fmt::format("nothing carries \"{}\": it hangs on a wall", object_.id), pointer_ + "/mount");
    return Mount::kWall;
  }

  // A relation that says where it is mounted beats the habit of its kind.
  void settle_mount(const CatalogEntry& entry) {
    object_.mount = mount_by_relations(entry);
    object_.mount_assumed = !object_.mount;
    if (!object_.mount) object_.mount = usual_mount(entry);
  }

  std::optional<Mount> mount_by_relations(const CatalogEntry& entry) const {
    const SceneGraph& scene = context_.scene;
    for (const Relation& relation : scene.relations) {
      if (std::ranges::find(relation.targets, object_.id) == relation.targets.end()) continue;
      if (relation.type == RelationType::kOnWall && entry.mount != Mount::kHung) return Mount::kWall;
      if (relation.type == RelationType::kOnCeiling) return Mount::kCeiling;
      if (!traits_of(relation.type).supports) continue;
      for (const std::string& reference : relation.references) {
        if (reference == "floor") return Mount::kFloor;
        const SceneObject* below = scene.find_object(reference);
        const bool sill = scene.find_opening(reference) != nullptr;
        const bool carried = sill || (below != nullptr && !context_.catalog.entry_or_nearest(below->category).thin);
        if (carried && entry.mount != Mount::kHung) return Mount::kSurface;
        if (below != nullptr && !carried) return Mount::kFloor;
      }
    }
    return std::nullopt;
  }

  static std::string text_of(const Size& size) {
    return fmt::format("{:.4g} x {:.4g} x {:.4g} m", size.width / 1000.0, size.depth / 1000.0, size.height / 1000.0);
  }

  NormalizeContext& context_;
  SceneObject& object_;
  std::string pointer_;
};

// Empty and repeated ids get new ones; a relation to a repeated id means the first that has it.
void settle_ids(NormalizeContext& context) {
  std::set<std::string> seen{"room", "floor", "ceiling"};
  for (std::size_t i = 0; i < context.scene.objects.size(); ++i) {
    SceneObject& object = context.scene.objects[i];
    if (!object.id.empty() && seen.insert(object.id).second) continue;
    const std::string old = object.id;
    const std::string base = old.empty() ? snake_case(object.category.empty() ? "object" : object.category) : old;
    object.id.clear();
    object.id = unused_id(context.scene, base);
    seen.insert(object.id);
    if (!old.empty())
      context.note("converted", fmt::format("the id \"{}\" is used twice: the later object is \"{}\"", old, object.id),
                   fmt::format("/furniture/{}/id", i));
  }
}

// Several of a kind that hang above one thing are together no wider than it, as far as such things come so small.
void fit_rows_above(NormalizeContext& context) {
  constexpr double kAir = 1.08;                                                   // of their width, with what is between them
  std::map<std::pair<std::string, std::string>, std::vector<SceneObject*>> rows;  // by what they hang above, and kind
  for (const Relation& relation : context.scene.relations) {
    if (relation.type != RelationType::kAbove || relation.references.size() != 1) continue;
    for (SceneObject& object : context.scene.objects) {
      const bool hangs = object.mount == Mount::kWall && object.size_source == SizeSource::kCatalog && object.size;
      if (!hangs || std::ranges::find(relation.targets, object.id) == relation.targets.end()) continue;
      std::vector<SceneObject*>& row = rows[{relation.references[0], object.category}];
      if (std::ranges::find(row, &object) == row.end()) row.push_back(&object);
    }
  }
  for (auto& [key, row] : rows) {
    const SceneObject* below = context.scene.find_object(key.first);
    if (row.size() < 2 || below == nullptr || !below->size) continue;
    const double all = kAir * double(row.size()) * row[0]->size->usual.width, width = below->size->usual.width;
    if (all <= width) continue;
    for (SceneObject* object : row) {
      SizeRange& size = *object->size;
      for (const auto side : {&Size::width, &Size::height})
        size.usual.*side = std::max(size.least.*side, static_cast<Mm>(std::lround(size.usual.*side * width / all)));
    }
  }
}

}  // namespace

Note unknown_kind_note(const std::string& name, const CatalogEntry& kind, std::string pointer) {
  if (kind.id == "object") return {"warning", fmt::format("\"{}\" is not known: it is a plain box", name), std::move(pointer)};
  return {"guessed", fmt::format("\"{}\" is not in the catalogue: sized and drawn like \"{}\"", name, kind.name), std::move(pointer)};
}

void normalize_objects(NormalizeContext& context) {
  settle_ids(context);
  for (std::size_t i = 0; i < context.scene.objects.size(); ++i) ObjectNormalizer(context, i).run();
  fit_rows_above(context);
  if (context.catalog.only_articles()) settle_articles_only(context);
}

}  // namespace layoutbox
