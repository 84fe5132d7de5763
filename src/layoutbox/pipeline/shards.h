// Many rooms packed: tar files of so many rooms each (the form of WebDataset), with a manifest beside each. What a shard holds depends
// on the prompts, their place in the file, seed, options and version alone, never on the machine, the number of jobs or the clock.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "layoutbox/pipeline/batch.h"

namespace layoutbox {

struct ShardOptions {
  std::size_t rooms = 1000;  // in each shard; the last has what is left. REQUIRES: 1…100'000
  // Of all shards those that this machine makes: every `machines`-th, from the `machine`-th on. REQUIRES: 1 <= machine <= machines
  std::size_t machine = 1, machines = 1;
};

// Makes FOLDER/shard-000000.tar and so on: of each room that there is the files that artefacts() marks as packed, named ID.scene.json…;
// beside it shard-000000.jsonl, the manifest, a line a room (failed ones too): id, prompt, seed, state, what holds and what was given up,
// checks, hash, where in the shard it lies; and shard-000000.times.jsonl, which is not part of the promise. A shard appears whole, its
// manifest last. One that is there, whole and of the same lines, options and version is kept; a damaged one is made again. No pictures are
// made. `options.generate.draw` and `pictures` are left out of account. Errors: kIo (the folder cannot be written, another batch is at work
// in it), kUsage (options out of range).
Result<BatchOutcome> run_packed_batch(const std::vector<BatchLine>& lines, const Planner& planner, const Catalog& catalog,
                                      const std::filesystem::path& folder, const BatchOptions& options, const ShardOptions& shards);

}  // namespace layoutbox
