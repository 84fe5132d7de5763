// The value every fallible function returns. Nothing in the library throws across its public interface, prints, or ends
// the process: what a user can cause is an Error, what only a programmer can cause is an assertion.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace layoutbox {

// What went wrong, coarse enough to choose an exit status and fine enough to test for.
enum class ErrorCode {
  // The input is wrong (exit status 2).
  kUsage,      // an option or argument that makes no sense
  kParse,      // not JSON, not UTF-8, not CSV
  kSchema,     // the right syntax, but a wrong type, key or range
  kReference,  // an id that names nothing, or one id twice
  kGeometry,   // walls that do not meet, an opening outside its wall, a room of no area
  kEmpty,      // a prompt with nothing in it
  kTooLarge,   // more text, objects or metres than the limits allow
  // The answer is not what was asked (exit status 1).
  kInfeasible,   // proven: no layout exists
  kNotFound,     // no layout found within the limits, and no proof either
  kCheckFailed,  // a check of the verifier failed
  // The surroundings are wrong (exit status 3).
  kNoBlender,
  kRenderFailed,
  kNoSolver,  // the CP-SAT library is missing, broken, or of another version
  kIo,        // a file cannot be read or written, disk full
  kNetwork,
  kInterrupted,  // stopped by the user (exit status 130)
  kInternal,     // a bug here; please report
};

// One failure, for a person and for a program: what, where, what to do.
struct Error {
  ErrorCode code = ErrorCode::kInternal;
  std::string message;         // one sentence: what is wrong, with the values that are
  std::string pointer;         // where: a JSON pointer ("/furniture/3/dims/w"), a file, or empty
  std::string hint;            // what to do about it, or empty
  std::vector<Error> details;  // all single failures where one call found several (validation)
};

template <class T>
using Result = tl::expected<T, Error>;

// A Result that carries no value.
using Status = tl::expected<void, Error>;

using Failure = tl::unexpected<Error>;

inline Failure fail(ErrorCode code, std::string message, std::string pointer = {}, std::string hint = {}) {
  return Failure(Error{code, std::move(message), std::move(pointer), std::move(hint), {}});
}

// The stable name of a code as it stands in JSON output: "schema", "noBlender", …
std::string_view error_code_name(ErrorCode code);

}  // namespace layoutbox

// Passes an Error on to the caller, else yields nothing: LAYOUTBOX_CHECK(write(file));
#define LAYOUTBOX_CHECK(expression) \
  if (auto layoutbox_status = (expression); !layoutbox_status) return ::layoutbox::Failure(std::move(layoutbox_status).error())

#define LAYOUTBOX_CONCAT_(a, b) a##b
#define LAYOUTBOX_CONCAT(a, b) LAYOUTBOX_CONCAT_(a, b)

// Declares `variable` as the value of a Result, or passes its Error on: LAYOUTBOX_ASSIGN(const auto scene, read_scene(text));
#define LAYOUTBOX_ASSIGN(variable, expression) LAYOUTBOX_ASSIGN_(LAYOUTBOX_CONCAT(layoutbox_result_, __LINE__), variable, expression)
#define LAYOUTBOX_ASSIGN_(result, variable, expression)                \
  auto result = (expression);                                          \
  if (!result) return ::layoutbox::Failure(std::move(result).error()); \
  variable = std::move(result).value()
