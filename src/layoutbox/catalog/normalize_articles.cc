#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

// Furniture that we choose covers at most this share of the floor, and is at most so many pieces.
constexpr double kMostCoveredByArticles = 0.30;
constexpr std::size_t kMostPieces = 12;

int times_used(const NormalizeContext& context, const CatalogEntry& article) {
  const auto used = context.articles_used.find(article.id);
  return used == context.articles_used.end() ? 0 : used->second;
}

bool has_stock(const NormalizeContext& context, const CatalogEntry& article) {
  return article.stock < 0 || times_used(context, article) < article.stock;
}

// How many words the object and the article share beyond their kind.
int words_shared(const SceneObject& object, const CatalogEntry& article) {
  std::vector<std::string> theirs = words_of(article.name);
  for (const std::string& attribute : article.article_attributes) std::ranges::copy(words_of(attribute), std::back_inserter(theirs));
  std::ranges::copy(words_of(article.article_material), std::back_inserter(theirs));
  std::vector<std::string> ours = words_of(object.name);
  for (const std::string& attribute : object.attributes) std::ranges::copy(words_of(attribute), std::back_inserter(ours));
  return static_cast<int>(
      std::ranges::count_if(ours, [&](const std::string& word) { return std::ranges::find(theirs, word) != theirs.end(); }));
}

bool is_free(const SceneObject& object) { return !object.size || object.size->usual == Size{}; }

double footprint(const SceneObject& object) { return double(object.size->usual.width) * object.size->usual.depth; }

// The floor's area in mm² where the scene or the caller knows it, else that of the room's kind.
double floor_area(const NormalizeContext& context) {
  const Size& given = context.options.room_size;
  if (given.width > 0 && given.depth > 0) return double(given.width) * given.depth;
  const Room& room = context.scene.room;
  if (!room.polygon.empty()) return std::abs(static_cast<double>(doubled_area(room.polygon))) / 2;
  if (room.area_m2) return *room.area_m2 * 1e6;
  const RoomKind* kind = context.catalog.find_room(room.type);
  return kind != nullptr ? double(kind->usual_size.width) * kind->usual_size.depth : 14e6;
}

SceneObject object_of(const NormalizeContext& context, const CatalogEntry& article) {
  SceneObject object;
  object.category = article.kind_of.empty() ? article.id : article.kind_of;
  object.id = unused_id(context.scene, object.category + "_1");
  object.catalog_id = article.article;
  object.origin = Origin::kAssumed;
  return object;
}

// Articles that suit the room, each kind once, until enough of the floor is covered.
void add_selection(NormalizeContext& context) {
  SceneGraph& scene = context.scene;
  const RoomKind* kind = context.catalog.find_room(scene.room.type);
  double covered = 0;
  for (const SceneObject& object : scene.objects) covered += footprint(object);
  const double most = floor_area(context) * kMostCoveredByArticles;
  for (const CatalogEntry& article : context.catalog.entries()) {
    if (article.article.empty() || scene.objects.size() >= kMostPieces || !has_stock(context, article)) continue;
    if (kind != nullptr && !article.rooms.empty() && std::ranges::find(article.rooms, kind->id) == article.rooms.end()) continue;
    const bool there = std::ranges::any_of(scene.objects, [&](const SceneObject& o) { return o.category == article.kind_of; });
    const double area = double(article.size.usual.width) * article.size.usual.depth;
    if (there || (article.mount == Mount::kFloor && covered + area > most)) continue;
    SceneObject object = object_of(context, article);
    const std::string pointer = fmt::format("/furniture/{}", scene.objects.size());
    take_article(context, object, article, pointer);
    object.mount = article.mount;
    object.used_sides = article.used_sides;
    if (article.mount == Mount::kFloor) covered += area;
    context.note("filled", fmt::format("article \"{}\" is chosen from the catalogue as \"{}\"", article.article, object.id), pointer);
    scene.objects.push_back(std::move(object));
  }
}

}  // namespace

const CatalogEntry* choose_article(const NormalizeContext& context, const SceneObject& object) {
  if (!context.catalog.has_articles()) return nullptr;
  const CatalogEntry* named = context.catalog.find(object.category);
  if (named != nullptr && !named->article.empty()) return named;
  const CatalogEntry* best = nullptr;
  int best_shared = 0, best_used = 0;
  for (const CatalogEntry* article : context.catalog.articles_of(object.category)) {
    if (!object.catalog_id.empty() && article->article == object.catalog_id) return article;
    if (!has_stock(context, *article)) continue;
    const int shared = words_shared(object, *article), used = times_used(context, *article);
    if (best != nullptr && (shared < best_shared || (shared == best_shared && used >= best_used))) continue;
    best = article;
    best_shared = shared;
    best_used = used;
  }
  // A size that somebody gave is not changed, unless there is nothing else to place.
  return is_free(object) || context.catalog.only_articles() ? best : nullptr;
}

void take_article(NormalizeContext& context, SceneObject& object, const CatalogEntry& article, const std::string& pointer) {
  if (!is_free(object) && object.size->usual != article.size.usual) {
    context.note("contradiction", fmt::format("the size of \"{}\" is that of article \"{}\"", object.id, article.article),
                 pointer + "/dims");
  }
  object.size = article.size;
  object.size_source = SizeSource::kUser;
  object.catalog_id = article.article;
  if (!article.kind_of.empty()) object.category = article.kind_of;
  if (object.name.empty() || !object.asked()) object.name = article.name;
  if (object.material.empty()) object.material = article.article_material;
  if (object.mesh.empty()) {
    object.mesh = article.article_mesh;
    object.mesh_front = article.article_mesh_front;
  }
  for (const std::string& attribute : article.article_attributes) {
    if (std::ranges::find(object.attributes, attribute) == object.attributes.end()) object.attributes.push_back(attribute);
  }
  ++context.articles_used[article.id];
}

void settle_articles_only(NormalizeContext& context) {
  std::vector<SceneObject>& objects = context.scene.objects;
  const bool all_assumed = std::ranges::all_of(objects, [](const SceneObject& object) { return !object.asked(); });
  std::erase_if(objects, [&](const SceneObject& object) {
    const bool is_article = std::ranges::any_of(context.catalog.articles_of(object.category),
                                                [&](const CatalogEntry* article) { return article->article == object.catalog_id; });
    if (!is_article) {
      context.note(object.asked() ? "contradiction" : "ignored",
                   fmt::format("the catalogue has no {}: \"{}\" is left out", object.name, object.id));
    }
    return !is_article;
  });
  if (all_assumed) add_selection(context);
  if (objects.empty()) {
    context.error(ErrorCode::kEmpty, "the catalogue has nothing of what is asked for", {},
                  "add articles of these kinds, or leave out --catalog-only");
  }
}

}  // namespace layoutbox
