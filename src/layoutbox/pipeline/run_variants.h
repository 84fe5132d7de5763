// The files of the layouts after the first.
#pragma once

#include <atomic>
#include <vector>

#include "layoutbox/pipeline/artefacts.h"
#include "layoutbox/pipeline/run_folder.h"

namespace layoutbox {

// kInterrupted where `stop` says so.
Status check_stopped(const std::atomic<bool>* stop);

// What solving makes of each, `first` being the room of the first layout.
Status write_variant_layouts(RunFolder& folder, const RoomSoFar& first, const std::vector<Layout>& more);

// Furnishes, exports and verifies each: the same files as the first has, under names of its own.
Status write_variants(RunFolder& folder, const RoomSoFar& first, const std::vector<Layout>& more);

}  // namespace layoutbox
