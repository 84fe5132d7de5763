// Pieces of the catalogue to be furnished in tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "layoutbox/furnish/furnish.h"

namespace layoutbox {

inline const Catalog& catalog() { return Catalog::builtin(); }

inline PlacedObject object_of(const CatalogEntry& entry, const Size& size) {
  PlacedObject object;
  object.id = entry.id + "_1";
  object.category = entry.id;
  object.name = entry.name;
  object.size = size;
  object.mount = entry.mount;
  object.spaces = spaces_at(entry, size);
  return object;
}

inline PlacedObject object_of(std::string_view id) {
  const CatalogEntry* entry = catalog().find(id);
  EXPECT_NE(entry, nullptr) << id;
  return entry == nullptr ? PlacedObject{} : object_of(*entry, entry->size.usual);
}

inline Model furnished(const PlacedObject& object, const FurnishOptions& options = {}) {
  const Result<Model> model = furnish_object(object, catalog(), options);
  EXPECT_TRUE(model) << object.id;
  return model ? *model : Model{};
}

}  // namespace layoutbox
