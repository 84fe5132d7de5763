#include "layoutbox/pipeline/artefacts.h"

#include <algorithm>
#include <array>

#include "layoutbox/export/export.h"
#include "layoutbox/pipeline/variants.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

using ArtefactText = Result<std::string>;

ArtefactText scene_json(const RoomSoFar& room) { return write_scene(room.scene); }
ArtefactText layout_json(const RoomSoFar& room) { return write_layout(room.layout); }
ArtefactText floor_plan(const RoomSoFar& room) { return write_floor_plan_svg(room.layout, room.catalog); }
ArtefactText glb(const RoomSoFar& room) { return write_glb(room.model, room.layout); }
ArtefactText blender_script(const RoomSoFar& room) {
  return write_blender_script(room.model, room.layout, room.catalog, room.options.render);
}
ArtefactText report_json(const RoomSoFar& room) { return write_report(room.report); }

constexpr std::array kArtefacts{
    Artefact{"scene.json", Stage::kPlan, scene_json, false, true},
    Artefact{"layout.json", Stage::kSolve, layout_json, true, true},
    Artefact{"floorplan.svg", Stage::kExport, floor_plan, true, true},
    Artefact{"scene.glb", Stage::kExport, glb, true, true},
    Artefact{"blender.py", Stage::kExport, blender_script},
    Artefact{"report.json", Stage::kVerify, report_json, true, true},
    Artefact{"scene.blend", Stage::kDraw, nullptr},
    Artefact{"scene.png", Stage::kDraw, nullptr},
    Artefact{"scene-top.png", Stage::kDraw, nullptr},
    Artefact{"scene-front.png", Stage::kDraw, nullptr},
    Artefact{"scene-eye.png", Stage::kDraw, nullptr},
    Artefact{"scene-door.png", Stage::kDraw, nullptr},
    Artefact{"scene-overlay.png", Stage::kDraw, nullptr},
    Artefact{"scene-turntable.gif", Stage::kDraw, nullptr},
    Artefact{"scene-turntable.mp4", Stage::kDraw, nullptr},
    Artefact{"mask.png", Stage::kDraw, nullptr},
    Artefact{"mask.json", Stage::kDraw, nullptr},
    Artefact{"run.json", Stage::kEnd, nullptr, false},
};

}  // namespace

std::span<const Artefact> artefacts() { return kArtefacts; }

bool is_output_name(std::string_view name) {
  return is_variant_name(name) || std::ranges::any_of(artefacts(), [name](const Artefact& one) { return one.file == name; });
}

}  // namespace layoutbox
