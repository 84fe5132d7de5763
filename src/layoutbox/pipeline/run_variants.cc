#include "layoutbox/pipeline/run_variants.h"

#include "layoutbox/judge/drawn_room.h"

namespace layoutbox {

Status check_stopped(const std::atomic<bool>* stop) {
  if (stop != nullptr && stop->load()) return fail(ErrorCode::kInterrupted, "stopped", {}, "what was finished is kept");
  return {};
}

Status write_variant_layouts(RunFolder& folder, const RoomSoFar& first, const std::vector<Layout>& more) {
  for (std::size_t k = 1; k <= more.size(); ++k) {
    LAYOUTBOX_CHECK(
        folder.write_artefacts(Stage::kSolve, {first.catalog, first.scene, more[k - 1], first.model, first.report, first.options}, k));
  }
  return {};
}

Status write_variants(RunFolder& folder, const RoomSoFar& first, const std::vector<Layout>& more) {
  const GenerateOptions& options = first.options;
  for (std::size_t k = 1; k <= more.size(); ++k) {
    LAYOUTBOX_CHECK(check_stopped(options.stop));
    const Layout& layout = more[k - 1];
    LAYOUTBOX_ASSIGN(const Model model, furnish(layout, first.catalog, options.furnish));
    const Report report = verify_with_furniture(layout, model, first.catalog, options.verify);
    for (const Stage stage : {Stage::kExport, Stage::kVerify}) {
      LAYOUTBOX_CHECK(folder.write_artefacts(stage, {first.catalog, first.scene, layout, model, report, options}, k));
    }
  }
  return {};
}

}  // namespace layoutbox
