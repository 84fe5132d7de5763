// The table of what a run writes: file, after which stage, how it is made. Generate, batch, packs and the check of folders read it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "layoutbox/pipeline/generate.h"

namespace layoutbox {

// What a room is made of so far; what its stage has not reached is empty.
struct RoomSoFar {
  const Catalog& catalog;
  const SceneGraph& scene;
  const Layout& layout;
  const Model& model;
  const Report& report;
  const GenerateOptions& options;
};

enum class Stage { kPlan, kSolve, kExport, kVerify, kDraw, kEnd };

struct Artefact {
  std::string_view file;
  Stage stage;                                    // after which it is written
  Result<std::string> (*make)(const RoomSoFar&);  // null: Blender's, or the run's own record
  bool each_variant = true;                       // each of several layouts has one: "layout-2.json"
  bool packed = false;                            // part of a packed room: its bytes depend on prompt, seed, options and version alone
};

// In the order in which they are written.
std::span<const Artefact> artefacts();

}  // namespace layoutbox
