// The prompts of a batch: JSON Lines, a table, or plain lines of text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/base/units.h"

namespace layoutbox {

// What one line asks for. Options that are absent are those of the whole batch.
struct BatchLine {
  std::size_t line = 1;  // where it begins in the file
  std::string id;        // the folder of its files; safe as a name
  std::string prompt;
  std::optional<Size> room_size;
  std::optional<std::uint64_t> seed;
  std::optional<std::int64_t> effort;
  std::optional<Error> error;  // why it cannot be done; `id` is then only for messages
};

// Reads by what the text looks like: lines of JSON objects {"id", "prompt" or "type", "room", "units", "seed", "effort"}; a table with
// a header that has a column "prompt" (or "text", "description"); else every line is a prompt. Without an id, a prompt gets its
// number, "0001". A broken line, an unknown key, an id that is used twice or that could not be the name of a folder are errors of
// that line alone. Errors: kEmpty (no line at all), kTooLarge (more than a million).
Result<std::vector<BatchLine>> read_batch(std::string_view text);

}  // namespace layoutbox
