// JSON text to a document and back, with the places of errors and with stable, readable bytes.
// Internal to .cc files that work with JSON: nlohmann's types stand here only by name.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "layoutbox/base/result.h"

namespace layoutbox {

// Limits on what is read.
inline constexpr int kDeepestJson = 64;
inline constexpr std::size_t kLongestJson = 64u << 20;

// Strict JSON. Errors: kParse with line and column (broken text, NaN and Infinity, a key given twice, nesting deeper than
// kDeepestJson), kTooLarge.
Result<nlohmann::json> parse_json(std::string_view text);

// Two spaces of indent; an array or object that fits is on one line unless it stands at the top; numbers with at most four decimals
// and no trailing zeros. Ends with a line feed. The same value always gives the same bytes; text that is no UTF-8 is replaced.
std::string format_json(const nlohmann::ordered_json& value);

// An error for programs: {"code", "message", "pointer", "hint"[, "details"]}, as one line.
std::string write_error(const Error& error);

// A number as format_json writes it: 1.6, 0.0005, 3.
std::string format_number(double value);

}  // namespace layoutbox
