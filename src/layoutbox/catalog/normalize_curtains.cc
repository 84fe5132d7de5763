// Curtains are as wide as their windows: one of them covers a window, several share it. One by a bed is as long as that.
#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

constexpr Mm kBeyondFrame = 150;  // of a window on either side, as curtain makers advise
constexpr Mm kBeyondBed = 100;    // of a bed at either end

// The length of what a curtain from the ceiling hangs beside; 0: nothing.
Mm length_beside(const NormalizeContext& context, const SceneObject& curtain) {
  for (const Relation& r : context.scene.relations) {
    if (r.type != RelationType::kNextTo || !names(r.targets, curtain.id) || r.references.size() != 1) continue;
    const SceneObject* host = context.scene.find_object(r.references[0]);
    if (host != nullptr && host->size) return std::max(host->size->usual.width, host->size->usual.depth);
  }
  return 0;
}

// A mirror that several are to look into is as wide as they sit.
void widen_mirrors(NormalizeContext& context) {
  constexpr Mm kPlace = 1050;
  for (SceneObject& mirror : context.scene.objects) {
    if (!context.catalog.entry_or_nearest(mirror.category).is(Trait::kMirror) || mirror.mount != Mount::kWall || !mirror.size ||
        mirror.size_source != SizeSource::kCatalog)
      continue;
    Mm seats = 0;
    for (const Relation& r : context.scene.relations) {
      if (r.type == RelationType::kFacing && names(r.references, mirror.id)) seats += static_cast<Mm>(r.targets.size());
    }
    if (seats < 2) continue;
    SizeRange& size = *mirror.size;
    size.usual.width = std::max(size.usual.width, seats * kPlace);
    size.greatest.width = std::max(size.greatest.width, size.usual.width);
    context.note("filled", fmt::format("\"{}\" is {} wide, for those who look into it", mirror.id, metres_text(size.usual.width)));
  }
}

// The window that the curtain is told to be at; -1: any.
int window_told(const SceneGraph& scene, const std::vector<const Opening*>& windows, const std::string& curtain) {
  for (const Relation& r : scene.relations) {
    if (r.type != RelationType::kNextTo || !names(r.targets, curtain) || r.references.size() != 1) continue;
    const auto at = std::ranges::find(windows, r.references[0], [](const Opening* o) { return o->id; });
    if (at != windows.end()) return static_cast<int>(at - windows.begin());
  }
  return -1;
}

// Where nothing says that it hangs elsewhere (on a wall, beside a bath), a window is missed: who says that there is none forgets the
// curtains, or the window.
void note_curtains_without_window(NormalizeContext& context, const std::vector<SceneObject*>& curtains) {
  for (const SceneObject* curtain : curtains) {
    const bool usual_elsewhere = !context.catalog.entry_or_nearest(curtain->category).beside.empty();
    const bool told = std::ranges::any_of(context.scene.relations, [&](const Relation& r) { return names(r.targets, curtain->id); });
    if (usual_elsewhere || told || curtain->hint.position) continue;
    std::string message =
        fmt::format("the room has no window for \"{}\": it hangs on a wall; ask for a window, name the wall, or leave it out", curtain->id);
    if (std::ranges::find(context.scene.notes, message, &Note::message) != context.scene.notes.end()) continue;  // of an earlier time
    context.note("contradiction", std::move(message), fmt::format("/furniture/{}", curtain - context.scene.objects.data()));
  }
}

}  // namespace

void hang_curtains_at_windows(NormalizeContext& context) {
  using enum RelationType;
  SceneGraph& scene = context.scene;
  const auto is_curtain = [&](const std::string& id) {
    const SceneObject* object = scene.find_object(id);
    if (object == nullptr) return false;
    const CatalogEntry& entry = context.catalog.entry_or_nearest(object->category);
    return entry.mount == Mount::kWall && entry.is(Trait::kCurtain);
  };
  const auto is_window = [](const std::string& id) { return id.starts_with(name_of(OpeningType::kWindow)); };
  for (Relation& r : scene.relations) {
    const bool placed = r.type == kOn || r.type == kAbove || r.type == kInFrontOf || r.type == kNear;
    if (!placed || r.references.empty() || !std::ranges::all_of(r.targets, is_curtain) || !std::ranges::all_of(r.references, is_window))
      continue;
    r.type = kNextTo, r.parameters = {};
  }
}

void normalize_curtains(NormalizeContext& context) {
  std::vector<const Opening*> windows;
  for (const Opening& opening : context.scene.room.openings) {
    if (opening.type == OpeningType::kWindow) windows.push_back(&opening);
  }
  for (SceneObject& object : context.scene.objects) {
    const CatalogEntry& entry = context.catalog.entry_or_nearest(object.category);
    if (!entry.is(Trait::kCurtain) || entry.mount != Mount::kCeiling || !object.size || object.size_source != SizeSource::kCatalog)
      continue;
    const Mm length = length_beside(context, object);
    SizeRange& size = *object.size;
    if (length > 0) size.usual.width = std::clamp(length + 2 * kBeyondBed, size.least.width, size.greatest.width);
  }
  widen_mirrors(context);
  std::vector<SceneObject*> curtains;
  for (SceneObject& object : context.scene.objects) {
    const CatalogEntry& entry = context.catalog.entry_or_nearest(object.category);
    if (entry.is(Trait::kCurtain) && entry.mount == Mount::kWall && object.size) curtains.push_back(&object);
  }
  if (windows.empty()) return note_curtains_without_window(context, curtains);
  std::vector<std::size_t> window_of;
  for (std::size_t i = 0; i < curtains.size(); ++i) {
    const int told = window_told(context.scene, windows, curtains[i]->id);
    window_of.push_back(told >= 0 ? static_cast<std::size_t>(told) : i % windows.size());
  }
  for (std::size_t i = 0; i < curtains.size(); ++i) {
    SceneObject& curtain = *curtains[i];
    if (curtain.size_source != SizeSource::kCatalog || !curtain.catalog_id.empty()) continue;
    const auto sharing = static_cast<Mm>(std::ranges::count(window_of, window_of[i]));
    const Mm width = (windows[window_of[i]]->width + 2 * kBeyondFrame) / sharing;
    SizeRange& size = *curtain.size;
    size.usual.width = std::min(width, size.greatest.width);
    size.least.width = std::min(size.least.width, size.usual.width);
    context.note("filled", fmt::format("\"{}\" is {} wide, for its window", curtain.id, metres_text(size.usual.width)));
  }
}

}  // namespace layoutbox
